"""The rulers of docs/method on heads, fast enough for many heads and steps: surface, landmarks, identification."""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from head_people import WITHIN_M
from numpy.typing import NDArray

from cloner.evaluate.figures.skins import EARS, in_face, skin_triangles
from cloner.evaluate.measures.posing import LANDMARKS
from cloner.evaluate.measures.rulers import (
    Surface,
    align_by_nearest,
    fit_similarity,
    inverse_transform,
    transform_points,
)
from cloner.evaluate.measures.surfaces import PointSurface, TriangleSurface, sample_surface, visible_from_outside
from cloner.evaluate.truths.truth import TruthSurface
from cloner.generic.load import GenericHuman, load_generic

Array = NDArray[np.float64]

#: Points asked either way; measured: the mean moves by 0.02 mm against 8,000.
ASKED: Final = 1500
#: Turns of the alignment; measured: the mean moves by less than 0.01 mm against 40.
TURNS: Final = 15
#: Discs of the clone that steer the alignment; measured: as triangles do, to 0.01 mm, in a fifth of the time.
DISCS: Final = 20_000
#: Spacing that identification needs: 600 points a head.
SEARCHED: Final = 600


@dataclass(frozen=True, slots=True, eq=False)
class Ruler:
    """What is measured against: points of the true face, its surface, and its named marks (metres)."""

    points: Array
    surface: Surface
    marks: Mapping[str, Array]


def ruler(truth: TruthSurface) -> Ruler:
    """Return the ruler of one truth: what docs/method calls the face, where an outside viewer sees it."""
    bare = truth.kind == "bare"
    firm = bare | (truth.kind == "organ")
    asked = bare & in_told_face(truth.points_m, truth.marks_m)
    seen = visible_from_outside(truth.points_m[asked], truth.normals[asked], truth.points_m[firm])
    points, normals = truth.points_m[asked][seen], truth.normals[asked][seen]
    surface: Surface = PointSurface(points, normals, radius=0.006)
    if len(truth.bare_m):
        surface = TriangleSurface(truth.bare_m, truth.bare_triangles)
    few = np.random.default_rng(0).choice(len(points), size=min(ASKED, len(points)), replace=False)
    return Ruler(points[few], surface, truth.marks_m)


def in_told_face(points: Array, marks: Mapping[str, Array]) -> NDArray[np.bool_]:
    """Return which points lie in the face; foreign heads have not all the marks of the ears."""
    return in_face(points, marks, [name for name in EARS if name in marks])


@functools.cache
def shown_skin() -> NDArray[np.int32]:
    """Return the skin triangles near the generic's face that a viewer outside sees."""
    generic = load_generic()
    vertices, skin = generic.vertices_m.astype(np.float64), skin_triangles(generic)
    tip = vertices[generic.feature("nose_tip")]
    skin = skin[(np.linalg.norm(vertices - tip, axis=1) < WITHIN_M)[skin].all(axis=1)]
    organs = vertices[generic.vertex_part != generic.part_names.index("body")]
    points, _, _ = sample_surface(vertices, skin, 60_000, rng=np.random.default_rng(0))
    corners = vertices[skin]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-12)
    seen = visible_from_outside(corners.mean(axis=1), across, np.vstack([points, organs]))
    return np.asarray(skin[seen], dtype=np.int32)


def score(vertices: Array, measure: Ruler, generic: GenericHuman) -> dict[str, float]:
    """Return the errors of a head (V, 3) in any rigid place, mm; ``size`` is its scale error in percent."""
    _, own, true = _marks(vertices, measure, generic)
    placed, out = _placed(vertices, own, true)
    skin = shown_skin()
    surface = TriangleSurface(placed, skin)
    samples, directions, _ = sample_surface(placed, skin, DISCS, rng=np.random.default_rng(0))
    discs = PointSurface(samples, directions, radius=0.003)
    samples = samples[: 2 * ASKED]
    for scale, name in ((True, "similarity"), (False, "rigid")):
        transform = align_by_nearest(measure.points, discs, scale=scale, turns=TURNS)
        factor = float(np.cbrt(np.linalg.det(transform[:3, :3])))
        _, to_clone, _ = surface.closest(transform_points(inverse_transform(transform), measure.points))
        moved = transform_points(transform, samples)
        _, to_truth, _ = measure.surface.closest(moved[in_told_face(moved, measure.marks)])
        out[f"{name}_mm"] = 500.0 * float(factor * to_clone.mean() + to_truth.mean())
        out[f"{name}_p95_mm"] = 500.0 * float(np.quantile(factor * to_clone, 0.95) + np.quantile(to_truth, 0.95))
    out["size_percent"] = 100.0 * (
        1.0 / float(np.cbrt(np.linalg.det(fit_similarity(own, true, scale=True)[:3, :3]))) - 1
    )
    return out


def _marks(vertices: Array, measure: Ruler, generic: GenericHuman) -> tuple[list[str], Array, Array]:
    """Return the landmarks that the ruler has: names, places (N, 3) on the head and true ones."""
    names = [n for n in LANDMARKS if n in measure.marks]
    return names, vertices[[generic.feature(n) for n in names]], np.array([measure.marks[n] for n in names])


def _placed(vertices: Array, own: Array, true: Array) -> tuple[Array, dict[str, float]]:
    """Return the head (V, 3) moved rigidly to the true landmarks, and how far its own lie off there, mm."""
    rigid, sized = (fit_similarity(own, true, scale=scale) for scale in (False, True))
    away, free = (1e3 * np.linalg.norm(transform_points(transform, own) - true, axis=1) for transform in (rigid, sized))
    return transform_points(rigid, vertices), {
        "landmarks_mean_mm": float(away.mean()),
        "landmarks_worst_mm": float(away.max()),
        "landmarks_free_mm": float(free.mean()),
    }


def worst_landmark(vertices: Array, measure: Ruler, generic: GenericHuman) -> dict[str, float]:
    """Return the distance of every landmark after rigid alignment on all, mm."""
    names, own, true = _marks(vertices, measure, generic)
    away = np.linalg.norm(transform_points(fit_similarity(own, true, scale=False), own) - true, axis=1)
    return {name: 1e3 * float(value) for name, value in zip(names, away, strict=True)}


def identified(clones: Sequence[Array], rulers: Sequence[Ruler], generic: GenericHuman) -> dict[str, list[int]]:
    """Return per clone the rank of its own truth among all, by face surface (scale free) and by landmarks."""
    marks = [n for n in LANDMARKS if all(n in r.marks for r in rulers)]
    rows = [generic.feature(n) for n in marks]
    ranks: dict[str, list[int]] = {"surface": [], "landmarks": []}
    for index, vertices in enumerate(clones):
        points, normals, _ = sample_surface(vertices, shown_skin(), 12_000, rng=np.random.default_rng(0))
        by_surface, by_marks = [], []
        for other in rulers:
            true = np.array([other.marks[n] for n in marks])
            first = fit_similarity(vertices[rows], true, scale=True)
            by_marks.append(np.linalg.norm(transform_points(first, vertices[rows]) - true, axis=1).mean())
            discs = PointSurface(transform_points(first, points), normals @ _turn(first).T, radius=0.003)
            found = align_by_nearest(other.points[:SEARCHED], discs, scale=True, turns=8)
            by_surface.append(
                discs.closest(transform_points(inverse_transform(found), other.points[:SEARCHED]))[1].mean()
            )
        ranks["surface"].append(_rank(by_surface, index))
        ranks["landmarks"].append(_rank(by_marks, index))
    return ranks


def _turn(transform: Array) -> Array:
    return np.asarray(transform[:3, :3] / np.cbrt(np.linalg.det(transform[:3, :3])))


def _rank(distances: Sequence[float], own: int) -> int:
    """Return 1 for the nearest."""
    return 1 + int((np.array(distances) < distances[own]).sum())


def other_person(vertices: Array, measure: Ruler, generic: GenericHuman) -> dict[str, float]:
    """Return the errors of somebody else's head; the true points alone are asked, which is enough for a baseline."""
    _, own, true = _marks(vertices, measure, generic)
    placed, out = _placed(vertices, own, true)
    surface = TriangleSurface(placed, shown_skin())
    samples, directions, _ = sample_surface(placed, shown_skin(), DISCS, rng=np.random.default_rng(0))
    discs = PointSurface(samples, directions, radius=0.003)
    for scale, name in ((True, "similarity"), (False, "rigid")):
        found = align_by_nearest(measure.points, discs, scale=scale, turns=TURNS)
        factor = float(np.cbrt(np.linalg.det(found[:3, :3])))
        out[f"{name}_mm"] = (
            1e3 * factor * float(surface.closest(transform_points(inverse_transform(found), measure.points))[1].mean())
        )
    return out
