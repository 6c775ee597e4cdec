"""Shape, poses and cameras of all body photos in one damped Gauss-Newton solution with exact derivatives.

Unknowns: footwear and shape; the person's usual pose; the cameras' usual height; and of
each photo its camera's stand and its own pose. Photos of one person share what they
can: poses and camera heights differ from the usual ones by a heavy-tailed spread, so
photos that agree teach each other, and one that differs is let go.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.body.evidence import Params, PhotoEvidence
from cloner.body.model import WORN, BodyFamily, project_points
from cloner.body.terms import EvidenceTerm, GroundTerm, OutlineTerm, PointTerm, block_names
from cloner.fit.evidence import Residuals, agreement_residuals
from cloner.fit.problem import ParameterBlock, Problem, Values
from cloner.frames import ViewId
from cloner.geometry.articulation.poses import FREEDOMS, SIGMAS, mirrored_freedoms, standing_pose
from cloner.geometry.cameras.stands import (
    AZIMUTH,
    FACING,
    HEIGHT,
    PITCH,
    ROLL,
    STAND_NAMES,
    camera_from_stand,
    stand_from_camera,
)
from cloner.records.arrays import Array
from cloner.records.views import Camera

Tick = Callable[[float], None]
Terms = dict[ViewId, list[EvidenceTerm]]

#: The person's usual pose and the cameras' usual height.
USUAL_POSE, USUAL_HEIGHT = "usual pose", "usual height"
#: Spreads from which on a photo that differs from the others, or a side from the other, is let go.
LOOSE: Final = 2.0
#: Nominal direction of the camera around the person for each side that a photo shows, radians.
NOMINAL = {"front": 0.0, "back": math.pi, "left": math.pi / 2, "right": -math.pi / 2}


@dataclass(frozen=True, slots=True, eq=False)
class BodyState:
    """The solution: footwear and shape (C,); camera parameters (6,) and pose (D,) of each photo."""

    shape: Array
    stands: dict[ViewId, Array]
    poses: dict[ViewId, Array]

    def camera(self, evidence: PhotoEvidence) -> Camera:
        """Return the camera of one photo."""
        return camera_from_stand(self.stands[evidence.view.view], evidence.view.camera)


def wrapped_angle(angle: float) -> float:
    """Return an angle in -π..π."""
    return (angle + math.pi) % (2.0 * math.pi) - math.pi


def _camera_block(seen: PhotoEvidence, start: Array, params: Params) -> ParameterBlock:
    """Return the parameter block of a photo's camera: a prior on its height and angles, none on its distance."""
    mean, sigma = np.zeros(len(STAND_NAMES)), np.full(len(STAND_NAMES), np.inf)
    mean[AZIMUTH] = start[AZIMUTH] - wrapped_angle(start[AZIMUTH] - NOMINAL[seen.view.side_shown])
    rows = [AZIMUTH, FACING, PITCH, ROLL]
    sigma[rows] = np.radians([params.azimuth_degrees, params.facing_degrees, params.pitch_degrees, params.roll_degrees])
    return ParameterBlock(start, mean, sigma, max_step=params.max_step)


def _problem(values: Values, evidence: dict[ViewId, PhotoEvidence], mean: Array, params: Params) -> Problem:
    """Return the parameter blocks with their priors."""
    blocks = {"shape": ParameterBlock(values["shape"], sigma=1.0, max_sigmas=params.max_sigmas)}
    blocks[USUAL_POSE] = ParameterBlock(values[USUAL_POSE], mean, SIGMAS, max_step=params.max_step)
    blocks[USUAL_HEIGHT] = ParameterBlock(values[USUAL_HEIGHT], *params.height_m, max_step=params.max_step)
    for view, seen in evidence.items():
        _, stand, pose = block_names(view)
        blocks[stand] = _camera_block(seen, values[stand], params)
        blocks[pose] = ParameterBlock(values[pose], max_step=params.max_step)
    return Problem(blocks)


def _agreement_terms(values: Values, view: ViewId, params: Params) -> Iterator[Residuals]:
    """Yield residuals between each photo and the person's mean pose and camera height, and between left and right."""
    _, stand, pose = block_names(view)
    level = np.eye(len(STAND_NAMES))[HEIGHT : HEIGHT + 1]
    apart = values[stand][HEIGHT] - values[USUAL_HEIGHT]
    yield agreement_residuals(
        (stand, USUAL_HEIGHT), apart, np.append(level, [[-1.0]], axis=1), params.same_height_m, outlier=LOOSE
    )
    every, (left, right, sign) = np.eye(len(FREEDOMS)), mirrored_freedoms()
    apart = values[pose] - values[USUAL_POSE]
    yield agreement_residuals(
        (pose, USUAL_POSE), apart, np.hstack([every, -every]), params.same_pose * SIGMAS, outlier=LOOSE
    )
    apart, sigma = values[pose][left] - sign * values[pose][right], params.same_sides * SIGMAS[left]
    yield agreement_residuals(
        (pose,), apart, every[left] - np.reshape(sign, (-1, 1)) * every[right], sigma, outlier=LOOSE
    )


def solve(body: BodyFamily, evidence: dict[ViewId, PhotoEvidence], params: Params, tick: Tick) -> BodyState:
    """Return the most likely shape, cameras and poses given all photos."""
    generic = body.generic
    mean = standing_pose(generic.joint_names, generic.joints_m.astype(np.float64))
    values = {"shape": np.zeros(0), USUAL_POSE: mean, USUAL_HEIGHT: np.array(params.height_m[:1])}
    for view, seen in evidence.items():
        _, stand, pose = block_names(view)
        values |= {stand: stand_from_camera(seen.view.camera), pose: mean}
    for number, count in enumerate(params.shapes):
        values["shape"] = np.pad(values["shape"], (0, WORN + count - len(values["shape"])))
        reach, fade, state = params.reach_mm[number], params.fade[min(number, 1)], _state(values, evidence)
        terms = {
            view: photo_terms(body, seen, state, params, reach_mm=reach, fade=fade) for view, seen in evidence.items()
        }

        def linearise(now: Values, iteration: int, number: int = number, terms: Terms = terms) -> Iterator[Residuals]:
            tick((number + iteration / params.iterations_per_round) / len(params.shapes))
            for view, seen in evidence.items():
                yield from _agreement_terms(now, view, params)
                shape, stand, pose = (now[name] for name in block_names(view))
                for term in terms[view]:
                    yield term.residuals(project_points(term.model, shape, stand, pose, seen.view.camera))

        problem = _problem(values, evidence, mean, params)
        values = problem.solve(linearise, iterations=params.iterations_per_round, damping=params.damping).values
    return _state(values, evidence)


def _state(values: Values, views: Iterable[ViewId]) -> BodyState:
    """Return the values as a state by photo."""
    own = {view: block_names(view)[1:] for view in views}
    stands, poses = ({view: values[names[kind]] for view, names in own.items()} for kind in range(2))
    return BodyState(values["shape"], stands, poses)


def photo_terms(
    body: BodyFamily, seen: PhotoEvidence, state: BodyState, params: Params, *, reach_mm: float, fade: float
) -> list[EvidenceTerm]:
    """Return the evidence terms of one photo; the outline counts from the second round on."""
    modes = len(state.shape)
    terms: list[EvidenceTerm] = [
        PointTerm(body, seen, params, modes=modes, fade=fade),
        GroundTerm(body, seen, params, modes=modes),
    ]
    if reach_mm > 0.0:
        terms.append(outline_term(body, seen, state, params, reach_mm))
    return terms


def outline_term(
    body: BodyFamily, seen: PhotoEvidence, state: BodyState, params: Params, reach_mm: float
) -> OutlineTerm:
    """Return the outline term of one photo at the present state."""
    view = seen.view.view
    return OutlineTerm(
        body,
        seen,
        params,
        shape=state.shape,
        stand=state.stands[view],
        pose=state.poses[view],
        reach_mm=reach_mm,
    )
