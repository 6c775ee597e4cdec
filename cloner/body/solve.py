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

from cloner.body.evidence import Evidence, Params
from cloner.body.model import WORN, Family, draw
from cloner.body.terms import GroundTerm, OutlineTerm, PointTerm, Term, unknowns
from cloner.fit.evidence import Residuals, agreement_residuals
from cloner.fit.problem import ParameterBlock, Problem, Values
from cloner.frames import ViewId
from cloner.geometry.articulation.poses import FREEDOMS, SIGMAS, mirrored_freedoms, standing_pose
from cloner.geometry.cameras.tripods import AZIMUTH, FACING, HEIGHT, PITCH, ROLL, STAND_NAMES, placed_camera, stand_of
from cloner.records.arrays import Array
from cloner.records.views import Camera

Tick = Callable[[float], None]
Terms = dict[ViewId, list[Term]]

#: The person's usual pose and the cameras' usual height.
USUAL_POSE, USUAL_HEIGHT = "usual pose", "usual height"
#: Spreads from which on a photo that differs from the others, or a side from the other, is let go.
LOOSE: Final = 2.0
#: Nominal direction of the camera around the person for each side that a photo shows, radians.
NOMINAL = {"front": 0.0, "back": math.pi, "left": math.pi / 2, "right": -math.pi / 2}


@dataclass(frozen=True, slots=True, eq=False)
class State:
    """What is found: footwear and shape (C,); per view the camera's stand (6,) and the pose (D,)."""

    shape: Array
    stands: dict[ViewId, Array]
    poses: dict[ViewId, Array]

    def camera(self, evidence: Evidence) -> Camera:
        """Return the camera of one photo."""
        return placed_camera(self.stands[evidence.view.view], evidence.view.camera)


def wrapped(angle: float) -> float:
    """Return an angle in -π..π."""
    return (angle + math.pi) % (2.0 * math.pi) - math.pi


def _stand(seen: Evidence, start: Array, params: Params) -> ParameterBlock:
    """Return a photo's camera as unknowns; its height is tied to the usual one, its distance left to the evidence."""
    mean, sigma = np.zeros(len(STAND_NAMES)), np.full(len(STAND_NAMES), np.inf)
    mean[AZIMUTH] = start[AZIMUTH] - wrapped(start[AZIMUTH] - NOMINAL[seen.view.side_shown])
    rows = [AZIMUTH, FACING, PITCH, ROLL]
    sigma[rows] = np.radians([params.azimuth_degrees, params.facing_degrees, params.pitch_degrees, params.roll_degrees])
    return ParameterBlock(start, mean, sigma, max_step=params.max_step)


def _problem(values: Values, evidence: dict[ViewId, Evidence], mean: Array, params: Params) -> Problem:
    """Return the unknowns, and what is likely of any person and any photographer."""
    blocks = {"shape": ParameterBlock(values["shape"], sigma=1.0, max_sigmas=params.max_sigmas)}
    blocks[USUAL_POSE] = ParameterBlock(values[USUAL_POSE], mean, SIGMAS, max_step=params.max_step)
    blocks[USUAL_HEIGHT] = ParameterBlock(values[USUAL_HEIGHT], *params.height_m, max_step=params.max_step)
    for view, seen in evidence.items():
        _, stand, pose = unknowns(view)
        blocks[stand] = _stand(seen, values[stand], params)
        blocks[pose] = ParameterBlock(values[pose], max_step=params.max_step)
    return Problem(blocks)


def _alike(values: Values, view: ViewId, params: Params) -> Iterator[Residuals]:
    """Yield what is likely of any two photos of one person, and of a person's two sides."""
    _, stand, pose = unknowns(view)
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
    apart, spread = values[pose][left] - sign * values[pose][right], params.same_sides * SIGMAS[left]
    yield agreement_residuals(
        (pose,), apart, every[left] - np.reshape(sign, (-1, 1)) * every[right], spread, outlier=LOOSE
    )


def solve(body: Family, evidence: dict[ViewId, Evidence], params: Params, tick: Tick) -> State:
    """Return shape, cameras and poses that explain all photos."""
    generic = body.generic
    mean = standing_pose(generic.joint_names, generic.joints_m.astype(np.float64))
    values = {"shape": np.zeros(0), USUAL_POSE: mean, USUAL_HEIGHT: np.array(params.height_m[:1])}
    for view, seen in evidence.items():
        _, stand, pose = unknowns(view)
        values |= {stand: stand_of(seen.view.camera), pose: mean}
    for number, count in enumerate(params.shapes):
        values["shape"] = np.pad(values["shape"], (0, WORN + count - len(values["shape"])))
        reach, fade, state = params.reach_mm[number], params.fade[min(number, 1)], _state(values, evidence)
        terms = {
            view: gathered(body, seen, state, params, reach_mm=reach, fade=fade) for view, seen in evidence.items()
        }

        def linearise(now: Values, iteration: int, number: int = number, terms: Terms = terms) -> Iterator[Residuals]:
            tick((number + iteration / params.iterations_per_round) / len(params.shapes))
            for view, seen in evidence.items():
                yield from _alike(now, view, params)
                shape, stand, pose = (now[name] for name in unknowns(view))
                for term in terms[view]:
                    yield term.residuals(draw(term.model, shape, stand, pose, seen.view.camera))

        problem = _problem(values, evidence, mean, params)
        values = problem.solve(linearise, iterations=params.iterations_per_round, damping=params.damping).values
    return _state(values, evidence)


def _state(values: Values, views: Iterable[ViewId]) -> State:
    """Return the values by photo."""
    own = {view: unknowns(view)[1:] for view in views}
    stands, poses = ({view: values[names[kind]] for view, names in own.items()} for kind in range(2))
    return State(values["shape"], stands, poses)


def gathered(body: Family, seen: Evidence, state: State, params: Params, *, reach_mm: float, fade: float) -> list[Term]:
    """Return the terms of one photo; the outline counts from the second round on."""
    modes = len(state.shape)
    terms: list[Term] = [
        PointTerm(body, seen, params, modes=modes, fade=fade),
        GroundTerm(body, seen, params, modes=modes),
    ]
    if reach_mm > 0.0:
        terms.append(outline_term(body, seen, state, params, reach_mm))
    return terms


def outline_term(body: Family, seen: Evidence, state: State, params: Params, reach_mm: float) -> OutlineTerm:
    """Return the outline's term for the present state of one photo."""
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
