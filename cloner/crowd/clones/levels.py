"""Levels of detail: lists of the generic human's own vertices, for every clone, and a chain for each loose shell.

References
----------
meshoptimizer's simplifier keeps original vertices; ``generic_models/build/build_crowd_levels.py`` made the lists.
"""

from __future__ import annotations

import functools
import importlib.resources
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.crowd.clones.fewer import simplify
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_surfaces
from cloner.records.arrays import Array

Index = NDArray[np.int32]

SURFACES: Final = ("body", "eyes")
#: Teeth and tongue: at the finest level of those who speak, all of it.
MOUTH: Final = "mouth"
#: Triangles of the loose shells at each level; below 500 hair tears (measured). Where simulated cloth flows, its folds
#: need more: with the others' a long skirt of 7,700 has .987, .979, .956 and .948 of SSIM, with these .992 to .980.
LOOSE: Final = (4_000, 2_700, 1_000, 500)
FLOWING: Final = (5_000, 4_000, 2_500, 1_500)
LEVELS: Final = len(LOOSE)


@dataclass(frozen=True, slots=True, eq=False)
class BodyLevels:
    """The body and eyes of all clones at all levels.

    Attributes
    ----------
    vertex : (V,) int32
        The generic human's vertex of every wedge; those of coarser levels come first.
    uv : (V, 2) float64, v downwards
    joints : (V, 4) int64, weights : (V, 4) float64, rows sum to one
    triangles : (T, 3) int32 of each level, wedges
    counts : wedges of each level; its triangles use the first so many
    groups : first generic triangle of each wedge triangle is not needed by anybody: see ``cloner.crowd.clones.groups``
    """

    vertex: Index
    uv: Array
    joints: NDArray[np.int64]
    weights: Array
    triangles: tuple[Index, ...]
    counts: tuple[int, ...]


def read_budgets(data: Any) -> tuple[int, ...]:
    """Return the loose shells' triangles per level in a pack's description.

    Raises
    ------
    ValueError
        If no pack has them.
    """
    for budgets in (LOOSE, FLOWING):
        if data == list(budgets):
            return budgets
    raise ValueError("levels that no pack has")


@functools.cache
def body_levels(*, full: bool = False, mouth: bool = False) -> BodyLevels:
    """Return the shipped levels.

    Parameters
    ----------
    full : bool
        Put a level 0 with every triangle of body and eyes before them, to compare with.
    mouth : bool
        Level 0 has teeth and tongue, for those who speak; its wedges are the last ones.
    """
    surfaces = {surface.name: surface for surface in load_surfaces()}
    found = [surfaces[name] for name in (*SURFACES, *((MOUTH,) if mouth else ()))]
    start = np.cumsum([0, *(len(surface.vertex) for surface in found)])
    lists = _shipped()
    levels = [
        np.concatenate([lists[f"{name}_{level}"] + start[k] for k, name in enumerate(SURFACES)])
        for level in range(LEVELS)
    ]
    if mouth:
        levels[0] = np.concatenate([levels[0], surfaces[MOUTH].triangles + start[len(SURFACES)]])
    if full:
        levels.insert(0, np.concatenate([one.triangles + start[k] for k, one in enumerate(found)]))
    order, counts = vertex_order(levels)
    place = np.full(int(start[-1]), -1, np.int32)
    place[order] = np.arange(len(order), dtype=np.int32)
    vertex = np.concatenate([surface.vertex for surface in found])[order]
    generic = load_generic()
    weights = np.maximum(generic.skin_weights[vertex].astype(np.float64), 0.0)
    return BodyLevels(
        vertex,
        np.concatenate([surface.uv for surface in found])[order],
        generic.skin_joints[vertex].astype(np.int64),
        weights / weights.sum(axis=1, keepdims=True),
        tuple(place[triangles] for triangles in levels),
        counts,
    )


def surface_levels() -> dict[str, tuple[Index, ...]]:
    """Return (T, 3) triangles of each level of body and eyes, in the wedges of their surfaces."""
    lists = _shipped()
    return {name: tuple(lists[f"{name}_{level}"].reshape(-1, 3) for level in range(LEVELS)) for name in SURFACES}


def _shipped() -> dict[str, Index]:
    place = importlib.resources.files("cloner.crowd") / "data" / "levels.npz"
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        return {name: archive[name] for name in archive.files}


def vertex_order(levels: Sequence[Index]) -> tuple[NDArray[np.int64], tuple[int, ...]]:
    """Return an order of the vertices in which every level uses the first ones, and how many.

    Parameters
    ----------
    levels : sequence of (T, 3) vertices of triangles, the finest first

    Returns
    -------
    order : (N,) int64, vertices that any level uses, those of coarser levels first
    counts : tuple of int, a level each
    """
    order: list[int] = []
    counts = []
    seen: set[int] = set()
    for triangles in reversed(levels):
        new = [int(one) for one in np.unique(triangles) if int(one) not in seen]
        seen.update(new)
        order += new
        counts.append(len(order))
    return np.array(order, np.int64), tuple(reversed(counts))


@dataclass(frozen=True, slots=True, eq=False)
class LooseShells:
    """All loose shells of a person as one mesh.

    Attributes
    ----------
    vertices_m : (N, 3) float64, rest pose
    uv : (N, 2) float64 in the shells' common picture
    joints : (N, 4) int64, weights : (N, 4) float64
    normals : (N, 3) float64
    cloth : (N,) bool
        Hangs as cloth; else hair.
    triangles : (T, 3) int32 of each level
    """

    vertices_m: Array
    uv: Array
    joints: NDArray[np.int64]
    weights: Array
    normals: Array
    cloth: NDArray[np.bool_]
    triangles: tuple[Index, ...]


def shell_levels(
    vertices_m: Array, triangles: Index, budgets: Sequence[int] = LOOSE, moved_m: Sequence[Array] = ()
) -> tuple[Index, ...]:
    """Return (T, 3) triangles of each level of loose shells, of their own vertices; never more than the budgets.

    Borders between charts hold the same places twice: places are welded first.

    Parameters
    ----------
    vertices_m : (V, 3) float64
        At rest.
    triangles : (T, 3) int32
    budgets : sequence of int
    moved_m : sequence of (V, 3) float64
        The same vertices in poses that they must look well in, too.
    """
    _, first, weld = np.unique(np.round(vertices_m, 7), axis=0, return_index=True, return_inverse=True)
    weld = weld.reshape(-1).astype(np.int64)
    places = np.stack([one[first] for one in (vertices_m, *moved_m)]).astype(np.float64)
    found = []
    for budget in budgets:
        if len(triangles) <= budget:
            found.append(np.asarray(triangles, np.int32))
            continue
        found.append(simplify(places, weld, triangles, budget))
    return tuple(found)
