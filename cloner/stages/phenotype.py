"""The nearest generic human, and the pose and camera of every body photo.

Method §7 "Beyond": shape coefficients, one pose a photo and the perspective
cameras are solved together, first to the joints, then to the outlines too, before
the paper's skeleton, rough and fine steps begin.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId, mm_from_m
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.poses import FREEDOMS, pose_matrix, prior_spread, standing_pose
from cloner.geometry.posing import moved_camera
from cloner.records.bodies import Phenotype, PosedView
from cloner.records.photos import Person
from cloner.records.points import BodyPoints, Proposals
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import SilhouetteSet
from cloner.records.views import Camera, ViewSet
from cloner.stages.phenotype_evidence import (
    Evidence,
    OutlineTerm,
    Params,
    PointTerm,
    choose,
    gather_evidence,
    longer_by_shoes,
    sole_vertices,
)
from cloner.stages.points import for_fitting
from cloner.stages.portrait import portrait_shape

Array = NDArray[np.float64]
Tick = Callable[[float], None]
Term = Callable[[Array, Camera, Array], Array]

CAMERA_FREEDOMS = 6
#: Farthest matched outline in the successive rounds, mm; the first round has points only.
REACH_MM = (0.0, 120.0, 80.0, 60.0, 45.0)
#: Finite-difference steps: coefficients, camera turn (rad) and shift (m), pose (rad).
STEPS = (0.02, 1e-3, 1e-3, 2e-3)


@dataclass(frozen=True, slots=True, eq=False)
class State:
    """The unknowns: shape (C,), and per view camera motion (6,) and pose (D,)."""

    shape: Array
    motions: dict[ViewId, Array]
    poses: dict[ViewId, Array]

    def camera(self, evidence: Evidence, stature_m: float) -> Camera:
        """Return the moved camera of one photo."""
        return moved(evidence.view.camera, self.motions[evidence.view.view], stature_m)


def moved(camera: Camera, motion: Array, stature_m: float) -> Camera:
    """Return the camera after a motion about the person's middle."""
    matrix = moved_camera(camera.camera_from_model, motion, np.array([0.0, 0.53 * stature_m, 0.0]))
    return Camera(camera.width_px, camera.height_px, camera.focal_px, matrix, camera.pixels_per_m)


def _prior(evidence: Evidence, motion: Array, pose: Array, mean: Array, params: Params) -> Array:
    depth = float(evidence.view.camera.to_camera(np.array([[0.0, 0.9, 0.0]]))[0, 2])
    turn = motion[:3] / np.deg2rad(params.camera_degrees)
    shift = motion[3:] / (np.array(params.camera_share) * depth)
    return np.concatenate([turn, shift, (pose - mean) / prior_spread(evidence.view.view is ViewId.BODY_SIDE)])


def _linearised(residual: Callable[[Array], Array], base: Array, steps: Array) -> tuple[Array, Array]:
    """Return a residual's value and its Jacobian by finite differences."""
    value = residual(base)
    jacobian = np.empty((len(value), len(base)))
    for column, step in enumerate(steps):
        shifted = base.copy()
        shifted[column] += step
        jacobian[:, column] = (residual(shifted) - value) / step
    return value, jacobian


def _turn(
    state: State,
    evidence: dict[ViewId, Evidence],
    terms: dict[ViewId, list[Term]],
    mean: Array,
    stature_m: float,
    params: Params,
) -> State:
    """Return the state after one damped Gauss-Newton step over all unknowns."""
    shapes = len(state.shape)
    per_view = CAMERA_FREEDOMS + len(FREEDOMS)
    normal, right = np.zeros((shapes + per_view * len(evidence),) * 2), np.zeros(shapes + per_view * len(evidence))
    normal[:shapes, :shapes] += np.eye(shapes)
    right[:shapes] -= state.shape
    steps = np.repeat(STEPS, (shapes, 3, 3, len(FREEDOMS)))
    for place, (view, seen) in enumerate(evidence.items()):

        def residual(x: Array, view: ViewId = view, seen: Evidence = seen) -> Array:
            shape, motion, pose = np.split(x, [shapes, shapes + CAMERA_FREEDOMS])
            camera = moved(seen.view.camera, motion, stature_m)
            parts = [term(shape, camera, pose) for term in terms[view]]
            return np.concatenate([*parts, _prior(seen, motion, pose, mean, params)])

        base = np.concatenate([state.shape, state.motions[view], state.poses[view]])
        value, jacobian = _linearised(residual, base, steps)
        columns = np.concatenate([np.arange(shapes), shapes + place * per_view + np.arange(per_view)])
        normal[np.ix_(columns, columns)] += jacobian.T @ jacobian
        right[columns] -= jacobian.T @ value
    step = np.linalg.solve(normal + 1e-3 * np.diag(np.diag(normal)), right)
    blocks = np.clip(step[shapes:], -params.most_step, params.most_step).reshape(len(evidence), per_view)
    return State(
        np.clip(state.shape + step[:shapes], -params.most_sigmas, params.most_sigmas),
        {view: state.motions[view] + block[:CAMERA_FREEDOMS] for view, block in zip(evidence, blocks, strict=True)},
        {view: state.poses[view] + block[CAMERA_FREEDOMS:] for view, block in zip(evidence, blocks, strict=True)},
    )


def _outline_term(
    generic: GenericHuman, seen: Evidence, state: State, stature_m: float, params: Params, reach_mm: float
) -> OutlineTerm:
    return OutlineTerm(
        generic,
        seen,
        params,
        shape=state.shape,
        camera=state.camera(seen, stature_m),
        pose=state.poses[seen.view.view],
        stature_m=stature_m,
        reach_mm=reach_mm,
    )


def solve(
    generic: GenericHuman, evidence: dict[ViewId, Evidence], stature_m: float, params: Params, tick: Tick
) -> tuple[State, float]:
    """Return shape, camera motions and poses that explain all photos, and the soles' height, metres."""
    mean = standing_pose(generic.joint_names, generic.joints_m.astype(np.float64))
    state = State(
        np.zeros(params.shapes[0]),
        {view: np.zeros(CAMERA_FREEDOMS) for view in evidence},
        {view: mean.copy() for view in evidence},
    )
    bare = np.mean([seen.barefoot for seen in evidence.values()]) > 0.5
    limits = params.bare_sole_m if bare else params.shoe_sole_m
    sole = float(np.mean(limits))
    for number, count in enumerate(params.shapes):
        if number > 1:
            sole = sole_height(generic, state, evidence, stature_m, limits)
        state = State(np.pad(state.shape, (0, count - len(state.shape))), state.motions, state.poses)
        points = {
            view: PointTerm(generic, seen, stature_m, params, count=count, sole_m=sole)
            for view, seen in evidence.items()
        }
        for turn in range(params.turns_per_round):
            terms: dict[ViewId, list[Term]] = {view: [points[view]] for view in evidence}
            if number > 0:
                for view, seen in evidence.items():
                    terms[view].append(_outline_term(generic, seen, state, stature_m, params, REACH_MM[number]))
            state = _turn(state, evidence, terms, mean, stature_m, params)
            tick((number + (turn + 1) / params.turns_per_round) / len(params.shapes))
    return state, sole_height(generic, state, evidence, stature_m, limits)


def beyond_ends(
    generic: GenericHuman, state: State, evidence: dict[ViewId, Evidence], stature_m: float
) -> dict[ViewId, tuple[float, float]]:
    """Return per photo how far the outline reaches above the skull and below the naked soles, metres."""
    soles = sole_vertices(generic)
    vertices = np.concatenate([[generic.feature("head_top")], soles])
    model = longer_by_shoes(choose(generic, vertices, stature_m, len(state.shape)), len(soles))
    reach = {}
    for view, seen in evidence.items():
        points, _ = model.posed(state.shape, state.poses[view])
        camera = state.camera(seen, stature_m)
        rows = camera.project(points)[:, 1]
        lowest = 1 + int(np.argmax(rows[1:]))
        above = (rows[0] - seen.top_px[1]) * camera.metres_per_pixel(points[0])
        below = (seen.bottom_px[1] - rows[lowest]) * camera.metres_per_pixel(points[lowest])
        reach[view] = (float(above), float(below))
    return reach


def sole_height(
    generic: GenericHuman,
    state: State,
    evidence: dict[ViewId, Evidence],
    stature_m: float,
    limits_m: tuple[float, float],
) -> float:
    """Return how far the outlines lie below the naked soles, metres: median of the photos, within limits."""
    below = [reach[1] for reach in beyond_ends(generic, state, evidence, stature_m).values()]
    return float(np.clip(np.median(below), *limits_m))


def run(
    *,
    proposals: Proposals,
    body_points: BodyPoints,
    silhouettes: SilhouetteSet,
    views: ViewSet,
    person: Person,
    tick: Tick,
    rng: np.random.Generator,
) -> StageResult:
    """Give the phenotype-closest generic human with a camera and a pose for every body photo.

    Residuals: the rim's distance from each outline; and how far the photos' body
    heights, brought to one scale by the stature, still differ (method §1).
    """
    params, generic = Params(), load_generic()
    evidence = {
        view: gather_evidence(
            seen, for_fitting(body_points.views[view]), silhouettes.views[view], proposals.views[view], params
        )
        for view, seen in views.views.items()
    }
    if not evidence:
        guess = portrait_shape(generic, proposals)
        return StageResult({"phenotype": Phenotype(guess, person.stature_m, 0.0, {}, _attributes(generic, guess))})
    state, sole = solve(generic, evidence, person.stature_m, params, tick)
    matrix = pose_matrix(generic.joint_names)
    posed, residuals = {}, []
    for view, seen in evidence.items():
        camera, pose = state.camera(seen, person.stature_m), state.poses[view]
        posed[view] = PosedView(view, camera, (matrix @ pose).reshape(-1, 3))
        term = _outline_term(generic, seen, state, person.stature_m, params, REACH_MM[-1])
        gap = term.gap_mm(state.shape, camera, pose, seen.mm_per_px)
        residuals.append(Residual("outline gap", gap, "mm", view.value))
    heights = [sum(reach) for reach in beyond_ends(generic, state, evidence, person.stature_m).values()]
    residuals.append(Residual("height normalisation", mm_from_m(float(np.ptp(heights)) / 2.0), "mm"))
    value = Phenotype(state.shape, person.stature_m, sole, posed, _attributes(generic, state.shape))
    return StageResult({"phenotype": value}, tuple(residuals))


def _attributes(generic: GenericHuman, coefficients: Array) -> dict[str, float]:
    """Return the named phenotype by linear regression from the coefficients."""
    values = generic.phenotype_mean + generic.phenotype_from_shape[:, : len(coefficients)] @ coefficients
    return {name: float(value) for name, value in zip(generic.phenotype_names, values, strict=True)}
