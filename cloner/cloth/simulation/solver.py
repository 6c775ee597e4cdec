"""Cloth in motion: position-based dynamics with small steps, threads for stretch and shear, skip threads for bending.

A piece is a network of threads: an edge's stiffness is that of warp, weft and shearing by its direction in the plane of
its piece; across every inner edge a thread that skips it resists bending (the source's structural, diagonal and
interleaving springs). Threads that share no vertex are solved at once.

References
----------
T.-Y. Kim, N. Chentanez, M. Müller, Long Range Attachments, SCA 2012;
M. Macklin, M. Müller, N. Chentanez, XPBD, MIG 2016; M. Macklin et al., Small Steps in Physics Simulation, SCA 2019.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.cloth.drafting.cut import Cloth, hinges_of
from cloner.cloth.simulation.contact import Spacing, keep_apart, pairs_of, spacing_of
from cloner.cloth.simulation.fabrics import Fabric
from cloner.cloth.simulation.forces import Slips
from cloner.cloth.simulation.threads import Threads, grouped, limits, pull, springs
from cloner.cloth.simulation.wearer import Planes, Skin, planes_under
from cloner.records.arrays import Array

Ints = NDArray[np.int64]

#: Gravity and the density of air at 20 degrees.
GRAVITY_M_S2: Final = 9.81
AIR_KG_M3: Final = 1.2
#: Drag of a plate across the wind (textbook: 1.2 to 2).
DRAG: Final = 1.3
#: Cloth rests this far from the skin, metres: thicker than the cloth, so that triangles' middles stay out as well.
THICK_M: Final = 0.006
#: Skin farther than this cannot be reached between two searches, metres.
REACH_M: Final = 0.08
#: No point of cloth moves faster, m/s: what would is a fault of the start.
FASTEST_M_S: Final = 12.0
#: Cloth may hang this much longer than it is.
LEASH: Final = 1.01
#: Threads resist bending in one of so many small steps, and are kept from growing.
SELDOM, OFTEN = 4, 2
#: Times a frame that cloth looks for what it may meet. With 2 a skirt passed through itself in 7 frames of 168, with 4
#: in none.
SEARCHES: Final = 4
#: Share of its speed that cloth keeps a second by itself: threads rub.
KEPT: Final = 0.25


@dataclass(frozen=True, slots=True, eq=False)
class Sheet:
    """A garment ready to move.

    Attributes
    ----------
    faces : (T, 3) int64
    mass_kg : (N,) float64
    area_m2 : (T,) float64
    stretch, bend : Threads
    edges : (E, 2) int64, rest_m : (E,) float64
    held : (P,) int64
        Vertices that the body holds.
    anchor : (N,) int64, leash_m : (N,) float64
        The held vertex nearest to each in the plane of its piece, and how far: cloth cannot hang lower.
    spacing : Spacing
    fabric : Fabric
    """

    faces: Ints
    mass_kg: Array
    area_m2: Array
    stretch: Threads
    bend: Threads
    edges: Ints
    rest_m: Array
    held: Ints
    anchor: Ints
    leash_m: Array
    spacing: Spacing
    fabric: Fabric


@dataclass(frozen=True, slots=True, eq=False)
class State:
    """Places (N, 3) metres and speeds (N, 3) m/s; of elements also where their friction holds."""

    places_m: Array
    speeds_m_s: Array
    slips: Slips | None = None


def sheet_of(cloth: Cloth, fabric: Fabric, held: Ints) -> Sheet:
    """Return a garment of a fabric ready to move."""
    faces, flat = cloth.faces, cloth.flat_m
    corner = flat[cloth.triangles]
    one, other = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
    area = np.abs(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]) / 2.0
    mass = np.bincount(faces.ravel(), np.repeat(area / 3.0, 3), cloth.count) * fabric.weight_kg_m2
    ends, rest, along = _edges(cloth)
    warp, weft, shear = fabric.stretch_n_m()
    down, across = along[:, 1] ** 2, along[:, 0] ** 2
    stiff = warp * down**2 + weft * across**2 + 4.0 * shear * down * across
    # A skip thread as long as two triangles are high: stiffness of a bent beam of that length, no finite elements.
    hinges = hinges_of(cloth)
    bends, width = hinges.tips, hinges.heights_m.sum(axis=0)
    flat_m = np.hypot(width, hinges.feet_m[0] - hinges.feet_m[1])
    bending = np.asarray(fabric.bend_n_m() * 4.0 / np.maximum(width, 1e-6) ** 2, dtype=np.float64)
    return Sheet(
        faces,
        np.asarray(mass, np.float64),
        np.asarray(area, np.float64),
        grouped(ends, rest, 1.0 / stiff, cloth.count),
        grouped(bends, flat_m, 1.0 / bending, cloth.count),
        ends,
        rest,
        held,
        *_leashes(cloth, held),
        spacing_of(ends, rest, bends, flat_m, cloth.count),
        fabric,
    )


def _leashes(cloth: Cloth, held: Ints) -> tuple[Ints, Array]:
    """Return every vertex's nearest held one in the plane of its own piece, and the distance."""
    anchor, leash = np.zeros(cloth.count, dtype=np.int64), np.full(cloth.count, np.inf)
    is_held = np.zeros(cloth.count, dtype=bool)
    is_held[held] = True
    for number in range(int(cloth.segment.max()) + 1):
        own = np.flatnonzero(cloth.segment == number)
        ends = own[is_held[cloth.vertex[own]]]
        if not len(ends):
            continue
        away, near = cKDTree(cloth.flat_m[ends]).query(cloth.flat_m[own])
        rows = cloth.vertex[own]
        nearer = away < leash[rows]
        leash[rows[nearer]] = away[nearer]
        anchor[rows[nearer]] = cloth.vertex[ends[near[nearer]]]
    return anchor, leash


def _edges(cloth: Cloth) -> tuple[Ints, Array, Array]:
    """Return edges (E, 2), rest lengths and their directions in their piece's plane; a seam's count once."""
    sides = np.concatenate([cloth.triangles[:, [0, 1]], cloth.triangles[:, [1, 2]], cloth.triangles[:, [2, 0]]])
    away = cloth.flat_m[sides[:, 1]] - cloth.flat_m[sides[:, 0]]
    ends = np.sort(cloth.vertex[sides], axis=1)
    key = ends[:, 0] * cloth.count + ends[:, 1]
    _, first = np.unique(key, return_index=True)
    length = np.linalg.norm(away[first], axis=1)
    return ends[first], length, away[first] / length[:, None]


@dataclass(frozen=True, slots=True, eq=False)
class Lead:
    """Where cloth is led: places (N, 3) at a frame's beginning and end, and the share of the way that is gone."""

    early_m: Array
    late_m: Array
    share: float


def step(
    sheet: Sheet,
    state: State,
    skin_now: Skin,
    held_m: tuple[Array, Array],
    seconds: float,
    substeps: int,
    wind_m_s: Array,
    lead: Lead | None = None,
) -> State:
    """Return the state a frame later.

    Parameters
    ----------
    sheet : Sheet
    state : State
    skin_now : Skin
        The body at the frame's beginning and end.
    held_m : (P, 3) and (P, 3)
        Where the held vertices are then.
    seconds : float
        Length of the frame.
    substeps : int
    wind_m_s : (3,)
        Speed of the air.
    lead : Lead or None
    """
    places, speeds, h = state.places_m.copy(), state.speeds_m_s.copy(), seconds / substeps
    free = 1.0 / sheet.mass_kg
    free[sheet.held] = 0.0
    kept = KEPT**h
    stretch, bend, longest = springs(sheet.stretch, free, h), springs(sheet.bend, free, h), limits(sheet.stretch, free)
    tree, quarter = skin_now.tree, max(1, substeps // SEARCHES)
    for number in range(substeps):
        if number % quarter == 0:
            planes = planes_under(skin_now, tree, places, REACH_M)
            pairs = pairs_of(sheet.spacing, places, speeds, quarter * h)
            thrust = air(sheet, places, speeds, wind_m_s) * free[:, None]
            thrust[:, 1] -= GRAVITY_M_S2
        before = places.copy()
        speeds += h * thrust
        _slow_down(speeds)
        places += h * speeds
        share = (number + 1) / substeps
        places[sheet.held] = (1.0 - share) * held_m[0] + share * held_m[1]
        if lead is not None:
            gone = 1.0 - (1.0 - lead.share) ** (1.0 / substeps)
            places += gone * ((1.0 - share) * lead.early_m + share * lead.late_m - places)
        if number % SELDOM == 0:
            pull(bend, places)
        leash(sheet, places)
        pull(stretch, places)
        if number % OFTEN == 0:
            pull(longest, places, slack=True)
        keep_apart(pairs, places, free)
        keep_out(planes, places, before, sheet.fabric.friction, share, 1.0 / substeps)
        speeds = (places - before) * (kept / h)
    return State(places, speeds)


def leash(sheet: Sheet, places: Array) -> None:
    """Draw back what went farther from the ring than its cloth is long (Kim, Chentanez, Müller 2012)."""
    if not len(sheet.held):
        return
    away = places - places[sheet.anchor]
    length2, longest = np.einsum("ij,ij->i", away, away), LEASH * sheet.leash_m
    rows = np.flatnonzero(length2 > longest**2)
    share = longest[rows] / np.sqrt(length2[rows])
    places[rows] -= (1.0 - share)[:, None] * away[rows]


def _slow_down(speeds: Array) -> None:
    """Let nothing move faster than `FASTEST_M_S`."""
    speed2 = np.einsum("ij,ij->i", speeds, speeds)
    rows = np.flatnonzero(speed2 > FASTEST_M_S**2)
    speeds[rows] *= (FASTEST_M_S / np.sqrt(speed2[rows]))[:, None]


def keep_out(planes: Planes, places: Array, before: Array, friction: float, share: float, step_share: float) -> None:
    """Push points out of the skin; what slides is held by as much as it was pushed, times the friction."""
    base = planes.early_m + share * (planes.late_m - planes.early_m)
    own = places[planes.rows]
    deep = THICK_M - np.einsum("ij,ij->i", own - base, planes.normals)
    touching = deep > 0.0
    rows, normals, pushed = planes.rows[touching], planes.normals[touching], deep[touching]
    moved = own[touching] - before[rows] - step_share * (planes.late_m - planes.early_m)[touching]
    slid = moved - np.einsum("ij,ij->i", moved, normals)[:, None] * normals
    far = np.maximum(np.linalg.norm(slid, axis=1), 1e-12)
    hold = np.minimum(1.0, friction * pushed / far)
    places[rows] = own[touching] + pushed[:, None] * normals - hold[:, None] * slid


def air(sheet: Sheet, places: Array, speeds: Array, wind_m_s: Array) -> Array:
    """Return (N, 3) the air's force on each vertex, newtons: what meets a triangle straight on."""
    corner = places[sheet.faces]
    across = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    length = np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-12)
    normal = across / length
    against = np.einsum("ij,ij->i", wind_m_s - speeds[sheet.faces].mean(axis=1), normal)
    size = 0.5 * AIR_KG_M3 * DRAG * sheet.fabric.air * against * np.abs(against) * length[:, 0] / 2.0
    each = (size / 3.0)[:, None] * normal
    rows = sheet.faces.ravel()
    return np.stack([np.bincount(rows, np.repeat(each[:, axis], 3), len(places)) for axis in range(3)], axis=1)


def strains(sheet: Sheet, places_m: Array) -> Array:
    """Return (E,) how much longer every thread is than at rest, as a share."""
    away = places_m[sheet.edges[:, 1]] - places_m[sheet.edges[:, 0]]
    return np.asarray(np.linalg.norm(away, axis=1) / sheet.rest_m - 1.0)
