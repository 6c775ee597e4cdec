"""Shape, poses and cameras of all body photos in one damped Gauss-Newton solution with exact derivatives.

Unknowns: footwear and shape; the person's usual pose; the cameras' usual height; and of
each photo its camera's stand and its own pose. Photos of one person share what they
can: poses and camera heights differ from the usual ones by a heavy-tailed spread, so
photos that agree teach each other, and one that differs is let go.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cloner.body.evidence import Evidence, Params
from cloner.body.model import OWN, WORN, Family, draw
from cloner.body.terms import GroundTerm, OutlineTerm, PointTerm, Term
from cloner.frames import ViewId
from cloner.geometry.articulation.poses import FREEDOMS, SIGMAS, mirrored_freedoms, standing_pose
from cloner.geometry.cameras.tripods import AZIMUTH, FACING, HEIGHT, PITCH, ROLL, STAND_NAMES, placed_camera, stand_of
from cloner.records.arrays import Array
from cloner.records.views import Camera

Tick = Callable[[float], None]

#: Nominal direction of the camera around the person for each side that a photo shows, radians.
NOMINAL = {"front": 0.0, "back": math.pi, "left": math.pi / 2, "right": -math.pi / 2}


@dataclass(frozen=True, slots=True, eq=False)
class State:
    """The unknowns: footwear and shape (C,), usual pose (D,) and camera height; per view stand (6,) and pose (D,)."""

    shape: Array
    usual_pose: Array
    usual_height_m: float
    stands: dict[ViewId, Array]
    poses: dict[ViewId, Array]

    def camera(self, evidence: Evidence) -> Camera:
        """Return the camera of one photo."""
        return placed_camera(self.stands[evidence.view.view], evidence.view.camera)


class _Normal:
    """Normal equations under construction."""

    def __init__(self, size: int) -> None:
        self.matrix, self.right = np.zeros((size, size)), np.zeros(size)

    def add(self, columns: NDArray[np.integer], value: Array, jacobian: Array) -> None:
        """Add residuals with derivatives by some of the unknowns."""
        self.matrix[np.ix_(columns, columns)] += jacobian.T @ jacobian
        self.right[columns] -= jacobian.T @ value

    def pull(self, columns: NDArray[np.integer], away: Array, spread: Array | float) -> None:
        """Add a normal prior: unknowns that are ``away`` from where they should be."""
        weight = 1.0 / np.broadcast_to(np.asarray(spread, dtype=np.float64), away.shape) ** 2
        self.matrix[columns, columns] += weight
        self.right[columns] -= weight * away

    def tie(
        self,
        first: NDArray[np.integer],
        second: NDArray[np.integer],
        apart: Array,
        spread: Array | float,
        sign: Array | float = 1.0,
    ) -> None:
        """Add heavy-tailed ties (Cauchy, two spreads): pairs of unknowns that usually agree but for a ``sign``."""
        spread = np.broadcast_to(np.asarray(spread, dtype=np.float64), apart.shape)
        weight = 1.0 / spread**2 / (1.0 + (apart / (2.0 * spread)) ** 2)
        self.matrix[first, first] += weight
        self.matrix[second, second] += weight
        self.matrix[first, second] -= weight * sign
        self.matrix[second, first] -= weight * sign
        self.right[first] -= weight * apart
        self.right[second] += weight * sign * apart


def wrapped(angle: float) -> float:
    """Return an angle in -π..π."""
    return (angle + math.pi) % (2.0 * math.pi) - math.pi


def _priors(normal: _Normal, state: State, evidence: dict[ViewId, Evidence], mean: Array, params: Params) -> None:
    """Add what is likely of any person, any photographer and any two photos of one person."""
    shapes, poses = len(state.shape), len(FREEDOMS)
    normal.pull(np.arange(shapes), state.shape, 1.0)
    usual = shapes + np.arange(poses)
    normal.pull(usual, state.usual_pose - mean, SIGMAS)
    height = np.array([shapes + poses])
    normal.pull(height, np.array([state.usual_height_m - params.height_m[0]]), params.height_m[1])
    for place, (view, seen) in enumerate(evidence.items()):
        start = shapes + poses + 1 + place * OWN
        stand = state.stands[view]
        turned = wrapped(stand[AZIMUTH] - NOMINAL[seen.view.side_shown])
        for row, away, degrees in (
            (AZIMUTH, turned, params.azimuth_degrees),
            (FACING, stand[FACING], params.facing_degrees),
            (PITCH, stand[PITCH], params.pitch_degrees),
            (ROLL, stand[ROLL], params.roll_degrees),
        ):
            normal.pull(np.array([start + row]), np.array([away]), math.radians(degrees))
        apart = np.array([stand[HEIGHT] - state.usual_height_m])
        normal.tie(np.array([start + HEIGHT]), height, apart, params.same_height_m)
        own = start + len(STAND_NAMES) + np.arange(poses)
        normal.tie(own, usual, state.poses[view] - state.usual_pose, params.same_pose * SIGMAS)
        left, right, sign = mirrored_freedoms()
        away = state.poses[view][left] - sign * state.poses[view][right]
        normal.tie(own[left], own[right], away, params.same_sides * SIGMAS[left], sign)


def _turn(
    state: State, evidence: dict[ViewId, Evidence], terms: dict[ViewId, list[Term]], mean: Array, params: Params
) -> State:
    """Return the state after one damped Gauss-Newton step over all unknowns."""
    shapes, poses = len(state.shape), len(FREEDOMS)
    shared = shapes + poses + 1
    normal = _Normal(shared + OWN * len(evidence))
    _priors(normal, state, evidence, mean, params)
    for place, (view, seen) in enumerate(evidence.items()):
        columns = np.concatenate([np.arange(shapes), shared + place * OWN + np.arange(OWN)])
        for term in terms[view]:
            drawn = draw(term.model, state.shape, state.stands[view], state.poses[view], seen.view.camera)
            normal.add(columns, *term.rows(drawn))
    step = np.linalg.solve(normal.matrix + 1e-3 * np.diag(np.diag(normal.matrix)), normal.right)
    step[shapes:] = np.clip(step[shapes:], -params.most_step, params.most_step)
    own = step[shared:].reshape(len(evidence), OWN)
    cut = len(STAND_NAMES)
    return State(
        np.clip(state.shape + step[:shapes], -params.most_sigmas, params.most_sigmas),
        state.usual_pose + step[shapes : shapes + poses],
        state.usual_height_m + float(step[shared - 1]),
        {view: state.stands[view] + block[:cut] for view, block in zip(evidence, own, strict=True)},
        {view: state.poses[view] + block[cut:] for view, block in zip(evidence, own, strict=True)},
    )


def first_state(body: Family, evidence: dict[ViewId, Evidence], params: Params) -> State:
    """Return the mean person standing in front of the first cameras."""
    generic = body.generic
    mean = standing_pose(generic.joint_names, generic.joints_m.astype(np.float64))
    return State(
        np.zeros(WORN + params.shapes[0]),
        mean,
        params.height_m[0],
        {view: stand_of(seen.view.camera) for view, seen in evidence.items()},
        {view: mean.copy() for view in evidence},
    )


def solve(body: Family, evidence: dict[ViewId, Evidence], params: Params, tick: Tick) -> State:
    """Return shape, cameras and poses that explain all photos."""
    state = first_state(body, evidence, params)
    mean = state.usual_pose
    for number, count in enumerate(params.shapes):
        shape = np.pad(state.shape, (0, WORN + count - len(state.shape)))
        state = replace(state, shape=shape)
        reach, fade = params.reach_mm[number], params.fade[min(number, 1)]
        terms = {
            view: gathered(body, seen, state, params, reach_mm=reach, fade=fade) for view, seen in evidence.items()
        }
        for turn in range(params.turns_per_round):
            state = _turn(state, evidence, terms, mean, params)
            tick((number + (turn + 1) / params.turns_per_round) / len(params.shapes))
    return state


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
