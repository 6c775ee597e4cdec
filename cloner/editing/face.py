"""Immediate preview of moved face points: the head bent by DFFD until the head is fitted anew.

The next whole run fits shape, cameras and relief of the head to all face points together; this preview lays the moved
points' vertices where they were dragged, through the cameras of the last run, and lets the face around follow.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.fit import evidence
from cloner.fit.problem import ParameterBlock, Problem, Values
from cloner.frames import ViewId, mm_from_m
from cloner.generic.features import named_features
from cloner.generic.head_controls import load_head_controls
from cloner.generic.load import load_generic
from cloner.geometry.cameras.motions import projection_derivatives
from cloner.geometry.deformation.dffd import deform
from cloner.records.arrays import Array
from cloner.records.clones import Joined
from cloner.records.points import FacePoints, ObeyedPoint
from cloner.records.views import Camera

#: What each number is and where it comes from: ``cloner/calibration/editing.toml``.
_CALIBRATED: Final = calibrated("editing.face")


REACH_M = _CALIBRATED.number("reach_m", "m")
USUAL_M = _CALIBRATED.number("usual_m", "m")
EXACT_PX = _CALIBRATED.number("exact_px", "px")
#: Steps; perspective alone bends what is solved.
ITERATIONS = 3


@functools.cache
def _control_covariance() -> Array:
    """Return the correlation (K, K) between the displacements of control points; zero for fixed ones."""
    controls = load_head_controls()
    apart = np.linalg.norm(controls.controls_m[:, None] - controls.controls_m[None], axis=2)
    free = controls.movable.astype(np.float64)
    return np.asarray(np.exp(-0.5 * (apart / REACH_M) ** 2) * free[:, None] * free[None])


@dataclass(frozen=True, slots=True, eq=False)
class _Moved:
    """A moved point: photo, name, vertex, and its new position, (2,) px."""

    view: ViewId
    name: str
    vertex: int
    camera: Camera
    target_px: Array

    def gap_px(self, vertices_m: Array) -> Array:
        """Return the remaining distance (2,) of the vertex from its target in the photo."""
        return np.asarray(self.target_px - self.camera.project(vertices_m[self.vertex][None])[0])


def preview_face(joined: Joined, before: FacePoints, after: FacePoints) -> tuple[Joined, tuple[ObeyedPoint, ...]]:
    """Return the person with the face bent to the points that were moved since the last run.

    Parameters
    ----------
    joined : Joined
        Of the last run.
    before, after : FacePoints
        The face photos' points of the last run, and now; points not moved since do nothing.
    """
    generic, controls = load_generic(), load_head_controls()
    moved = _moved(joined, before, after)
    if not moved:
        return joined, ()
    weights = controls.weights[:, : len(controls.names)]
    shape, vertices = joined.vertices_m.copy(), np.unique([one.vertex for one in moved])
    own = np.asarray(weights[np.searchsorted(generic.head_vertices, vertices)].todense(), dtype=np.float64)
    reached = _control_covariance() @ own.T
    # neighbours stay two
    root = np.asarray(np.linalg.cholesky(own @ reached + 1e-6 * np.eye(len(vertices))), dtype=np.float64)
    shift = reached @ np.asarray(np.linalg.solve(root.T, _control_pulls(shape[vertices], vertices, root, moved)))
    shape[generic.head_vertices] += deform(weights, shift)
    outcomes = tuple(_outcome(one, joined.vertices_m, shape) for one in moved)
    return replace(joined, vertices_m=shape, features_m=named_features(generic, shape)), outcomes


def _control_pulls(places_m: Array, vertices: NDArray[np.int64], root: Array, moved: list[_Moved]) -> Array:
    """Return the most likely pulls (N, 3), with ``root`` (N, N) from pulls to the vertices' displacements, metres."""

    def linearise(values: Values, iteration: int) -> Iterator[evidence.Residuals]:
        now = places_m + root @ values["pulls"].reshape(-1, 3)
        for one in moved:
            row = np.searchsorted(vertices, one.vertex)
            seen, by_point, _ = projection_derivatives(one.camera, now[row][None])
            jacobian = np.einsum("nia,v->niva", by_point, root[row]).reshape(1, 2, -1)
            yield evidence.point_residuals(("pulls",), seen - one.target_px, jacobian, EXACT_PX)

    problem = Problem({"pulls": ParameterBlock(np.zeros(places_m.size), sigma=USUAL_M)})
    return problem.solve(linearise, iterations=ITERATIONS).values["pulls"].reshape(-1, 3)


def _moved(joined: Joined, before: FacePoints, after: FacePoints) -> list[_Moved]:
    """Return the corrected points of the face photos that were moved since the last run."""
    generic = load_generic()
    out = []
    for view, points in after.views.items():
        if not view.is_face or view not in joined.views:
            continue
        old = before.views.get(view)
        for name, place, fixed in zip(points.names, points.points_px, points.corrected, strict=True):
            was = None if old is None or not fixed else old.get(name)
            if not fixed or (was is not None and np.array_equal(was, place)) or name not in generic.feature_names:
                continue
            vertex = generic.feature(name)
            if generic.head_blend[vertex] > 0.5:
                out.append(_Moved(view, name, vertex, joined.views[view].camera, place))
    return out


def _outcome(one: _Moved, before_m: Array, after_m: Array) -> ObeyedPoint:
    """Return the outcome for a moved point."""
    away = float(np.linalg.norm(one.gap_px(after_m)))
    moved_mm = mm_from_m(float(np.linalg.norm(after_m[one.vertex] - before_m[one.vertex])))
    note = "" if away <= 1.0 else f"the face does not follow it, so the clone stays {away:.0f} px off it"
    return ObeyedPoint(one.view, one.name, "face", float(np.linalg.norm(one.gap_px(before_m))), away, moved_mm, note)
