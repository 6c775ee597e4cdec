"""Skin bent locally at corrected outline points, so that the clone's outline passes through them.

The last step of the body, after all that is fitted to whole photos: a corrected point moves the skin around it, about a
hand's breadth far, and nothing else.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.editing.outline_constraints import (
    OutlineConstraint,
    Params,
    PosedPhoto,
    make_constraint,
    nearest_contour_points,
    posed_photo,
)
from cloner.editing.places import distance_from, free_skin, generic_metric, half_girth_m, opposite_feature
from cloner.editing.targets import PointConstraint
from cloner.frames import ViewId, m_from_mm, mm_from_m
from cloner.generic.load import GENERIC_STATURE_M, load_generic
from cloner.geometry.articulation.skin_bends import EdgePoint, bump, least_norm_step
from cloner.geometry.cameras.motions import projection_derivatives
from cloner.geometry.outlines.contour_search import outermost_point
from cloner.geometry.outlines.silhouette import triangle_normals
from cloner.records.arrays import Array
from cloner.records.bodies import PosedView
from cloner.records.points import ObeyedPoint

#: What each number is and where it comes from: ``cloner/calibration/editing.toml``.
_CALIBRATED: Final = calibrated("editing.skin")


ANSWERS = _CALIBRATED.number("answers", "factor")
EASE = _CALIBRATED.number("ease", "factor")


@dataclass(frozen=True, slots=True, eq=False)
class _Handle:
    """A handle of one constraint: its place, the edges watched around it (N, 2), the bump's vertices and heights."""

    claim: int
    place: EdgePoint
    edges: NDArray[np.int64]
    patch: NDArray[np.int64]
    height: Array

    def height_at(self, place: EdgePoint) -> float:
        """Return the bump's height at any place."""
        return float(_Bend(self.patch, self.height[:, None], np.zeros((1, 3))).of(place)[0])


@dataclass(frozen=True, slots=True, eq=False)
class _Bend:
    """Vertices (N,), bumps of K handles there (N, K), and each handle's displacement (K, 3), metres in rest pose."""

    vertices: NDArray[np.int64]
    bumps: Array
    raised_m: Array

    @property
    def shift_m(self) -> Array:
        """Return the displacements (N, 3) of the vertices."""
        return np.asarray(self.bumps @ self.raised_m)

    def bent(self, vertices_m: Array) -> Array:
        """Return the (V, 3) rest vertices, bent."""
        bent = vertices_m.copy()
        bent[self.vertices] += self.shift_m
        return bent

    def of(self, place: EdgePoint) -> Array:
        """Return (K,) the bumps' heights at a place."""
        rows = np.minimum(np.searchsorted(self.vertices, [place.first, place.second]), len(self.vertices) - 1)
        inside = (self.vertices[rows] == [place.first, place.second]) * np.array([1.0 - place.share, place.share])
        return np.asarray(inside @ self.bumps[rows])


@dataclass(frozen=True, slots=True, eq=False)
class _Work:
    """The problem: the unbent vertices (V, 3) in rest pose, the constraints, and the photos."""

    vertices_m: Array
    stature_m: float
    claims: tuple[OutlineConstraint, ...]
    scenes: Mapping[ViewId, PosedPhoto]
    params: Params

    def bent_pixels(self, bend: _Bend) -> dict[ViewId, Array]:
        """Return the projected (V, 2) vertices of the bent body in every photo."""
        out = {}
        for view, seen in self.scenes.items():
            moved = np.einsum("vab,vb->va", seen.blended[bend.vertices, :, :3], bend.shift_m)
            out[view] = seen.pixels.copy()
            out[view][bend.vertices] = seen.camera.project(seen.posed_m[bend.vertices] + moved)
        return out


def obey_skin(
    vertices_m: Array,
    joints_m: Array,
    views: Mapping[ViewId, PosedView],
    targets: list[PointConstraint],
    stature_m: float,
) -> tuple[Array, list[ObeyedPoint]]:
    """Return the vertices bent so that the outline passes through all corrected points, and how well it does.

    Parameters
    ----------
    vertices_m : (V, 3) rest pose
    joints_m : (94, 3)
    views : mapping
        Camera and pose of every body photo.
    targets : list of Wish
    stature_m : float
        Scales reaches that are measured on the generic skin.
    """
    params = Params()
    scenes = {view: posed_photo(vertices_m, joints_m, views[view]) for view in {target.view for target in targets}}
    claims, refused = [], {}
    for k, (target, found) in enumerate(zip(targets, nearest_contour_points(targets, scenes, params), strict=True)):
        claim = None if found is None else make_constraint(target, found, scenes[target.view], params)
        if claim is None or claim.gap_mm > params.most_mm:
            refused[k] = _rejected_outcome(target, claim)
        else:
            claims.append(claim)
    if not claims:
        return vertices_m, [refused[k] for k in range(len(targets))]
    work = _Work(vertices_m, stature_m, tuple(claims), scenes, params)
    bend = _solve(work)
    outcomes = iter(_outcomes(work, bend))
    return bend.bent(vertices_m), [refused[k] if k in refused else next(outcomes) for k in range(len(targets))]


def _solve(work: _Work) -> _Bend:
    """Return the bend that meets all constraints together, as far as skin does not fold.

    Pressed in at one place, the body may show other skin there - the other breast, the other leg - which then becomes
    a handle too.
    """
    handles = [_handle(work, k, claim.place) for k, claim in enumerate(work.claims)]
    for _ in range(work.params.rounds):
        bend = _least_damped(work, handles)
        pixels = work.bent_pixels(bend)
        new = []
        for k, claim in enumerate(work.claims):
            seen = outermost_point(claim.edges, pixels[claim.target.view], claim.target.target_px, claim.outward)
            own = [handle for handle in handles if handle.claim == k]
            if seen and seen[1] > 2.0 * work.params.near_px and max(h.height_at(seen[0]) for h in own) < ANSWERS:
                new.append(_handle(work, k, seen[0]))
        if not new:
            break
        handles += new
    return bend


def _handle(work: _Work, number: int, place: EdgePoint) -> _Handle:
    """Return the handle of a constraint at a place of its outline."""
    claim = work.claims[number]
    seen = work.scenes[claim.target.view]
    to_rest = np.linalg.inv(place.at(seen.blended)[:, :3])
    ray = to_rest @ (place.at(seen.posed_m) - seen.eye_m)
    ray /= np.linalg.norm(ray)
    normal = to_rest @ (claim.outward @ seen.camera.camera_from_model[:2, :3])
    normal -= (normal @ ray) * ray
    normal /= np.linalg.norm(normal)
    along_m = distance_from(place) * work.stature_m / GENERIC_STATURE_M
    axes = np.stack([normal, ray, np.cross(normal, ray)])
    patch, height = bump(work.vertices_m, along_m, place, axes, _reach_m(work, claim))
    free = free_skin()
    height = height * free[patch] / float(place.at(free))
    answers = np.zeros(len(free), dtype=bool)
    answers[patch] = height >= ANSWERS
    return _Handle(number, place, claim.edges[answers[claim.edges].any(axis=1)], patch, height)


def _reach_m(work: _Work, claim: OutlineConstraint) -> Array:
    """Return a bend's radius across the outline, along the line of sight, and along the outline, (3,) metres."""
    params, name, scale = work.params, claim.target.name, work.stature_m / GENERIC_STATURE_M
    least = params.gentle * claim.gap_mm
    along = float(np.clip(params.reach_per_mm * claim.gap_mm, params.least_reach_mm, params.most_reach_mm))
    along = max(along, least)
    across, radius = along, params.usual_radius_mm * scale
    if opposite_feature(name):
        generic = load_generic()
        ends = work.vertices_m[[generic.feature(name), generic.feature(opposite_feature(name))]]
        across = max(min(along, params.across * mm_from_m(float(np.linalg.norm(ends[1] - ends[0])))), 0.8 * least)
        radius = mm_from_m(half_girth_m(name)) / np.pi * scale
    sight = params.depth * along
    if claim.inward:
        sight = max(sight, params.dimple * float(np.sqrt(claim.gap_mm * radius)))
    return np.array([m_from_mm(across), m_from_mm(sight), m_from_mm(along)])


def _least_damped(work: _Work, handles: list[_Handle]) -> _Bend:
    """Return the bend with the least damping that keeps the skin from folding; contradicting constraints fold it."""
    vertices = np.unique(np.concatenate([handle.patch for handle in handles]))
    bumps = np.zeros((len(vertices), len(handles)))
    for k, handle in enumerate(handles):
        bumps[np.searchsorted(vertices, handle.patch), k] = handle.height
    flat = _Bend(vertices, bumps, np.zeros((len(handles), 3)))
    for damping in work.params.damping:
        bend = _newton_steps(work, handles, flat, damping)
        if not _folds(work, bend):
            return bend
    return flat


def _newton_steps(work: _Work, handles: list[_Handle], flat: _Bend, damping: float) -> _Bend:
    """Return the bend after Newton's steps; every handle is one equation along the outline's normal.

    Undamped, each step is the smallest that serves, and skin that is pressed in is only ever pressed further, as else
    two spots that make the outline in turn would never come to rest. Damped, the whole bend is kept small.
    """
    bend = flat
    inward = np.array([work.claims[handle.claim].inward for handle in handles])
    for _ in range(work.params.turns):
        matrix, wanted = _equations(work, handles, bend)
        if np.where(inward, -wanted, np.abs(wanted)).max() < work.params.near_px:
            break
        start = bend.raised_m.ravel() if damping == 0.0 else np.zeros(matrix.shape[1])
        wanted = wanted + matrix @ (bend.raised_m.ravel() - start)
        raised = start + least_norm_step(matrix, wanted, inward, max(damping, EASE))
        bend = replace(bend, raised_m=np.asarray(raised, dtype=np.float64).reshape(-1, 3))
    return bend


def _equations(work: _Work, handles: list[_Handle], bend: _Bend) -> tuple[Array, Array]:
    """Return the Jacobian (K, 3 K) of the outlines' moves by the handles', px per metre, and the targets (K,)."""
    pixels = work.bent_pixels(bend)
    rows, wanted = [], []
    for handle in handles:
        claim = work.claims[handle.claim]
        shown, target = pixels[claim.target.view], claim.target.target_px
        seen = outermost_point(handle.edges, shown, target, claim.outward)
        place, beyond = seen or (handle.place, float((handle.place.at(shown) - target) @ claim.outward))
        slope = _pixel_slope(place, claim.outward, work.scenes[claim.target.view])
        rows.append(np.outer(bend.of(place), slope).ravel())
        wanted.append(-beyond)
    return np.array(rows), np.array(wanted)


def _pixel_slope(place: EdgePoint, normal: Array, seen: PosedPhoto) -> Array:
    """Return the derivative (3,), px along ``normal`` per metre, of a place's projection by its move in rest pose."""
    by_point = projection_derivatives(seen.camera, place.at(seen.posed_m)[None])[1][0]
    return np.asarray(normal @ by_point @ place.at(seen.blended)[:, :3])


def _folds(work: _Work, bend: _Bend) -> bool:
    """Return whether a triangle flips or degenerates."""
    metric, params = generic_metric(), work.params
    moves = np.zeros(len(work.vertices_m), dtype=bool)
    moves[bend.vertices] = True
    rows = np.flatnonzero(moves[metric.triangles].any(axis=1))
    touched, own = metric.triangles[rows], 2.0 * metric.area_m2[rows]
    before = triangle_normals(work.vertices_m, touched)
    after = triangle_normals(bend.bent(work.vertices_m), touched)
    size = np.einsum("ta,ta->t", before, before)
    turned = np.einsum("ta,ta->t", before, after) < 0.05 * size
    least = np.maximum(params.least_area * own, 2.0 * m_from_mm(m_from_mm(params.least_area_mm2)))
    return bool((turned & (size > least**2)).any())


def _rejected_outcome(target: PointConstraint, claim: OutlineConstraint | None) -> ObeyedPoint:
    """Return the outcome for a point that the skin cannot follow."""
    if claim is None:
        note = "no outline of the clone is seen there, so the point was left out"
        return ObeyedPoint(target.view, target.name, "outline", 0.0, 0.0, 0.0, note)
    note = f"the point lies {claim.gap_mm / 10.0:.0f} cm off the body, so it was left out: drag it back to the outline"
    return ObeyedPoint(target.view, target.name, "outline", claim.gap_px, claim.gap_px, 0.0, note)


def _outcomes(work: _Work, bend: _Bend) -> list[ObeyedPoint]:
    """Return the outcomes of all constraints."""
    pixels, after_px = work.bent_pixels(bend), []
    for claim in work.claims:
        shown = outermost_point(claim.edges, pixels[claim.target.view], claim.target.target_px, claim.outward)
        after_px.append(claim.gap_px if shown is None else abs(shown[1]))
    out = []
    for k, claim in enumerate(work.claims):
        target = claim.target
        moved_mm = mm_from_m(float(np.linalg.norm(bend.of(claim.place) @ bend.raised_m)))
        others = [work.claims[j].target for j in range(len(work.claims)) if j != k and after_px[j] > 1.0]
        note = _is_separated(after_px[k], others) if after_px[k] > 1.0 else ""
        out.append(ObeyedPoint(target.view, target.name, "outline", claim.gap_px, after_px[k], moved_mm, note))
    return out


def _is_separated(after_px: float, others: list[PointConstraint]) -> str:
    if not others:
        return f"the skin would fold, so the clone stays {after_px:.0f} px off it"
    named = " and ".join(f"{other.name} of {other.view}" for other in others)
    return f"it contradicts {named}, so the clone stays {after_px:.0f} px off it"
