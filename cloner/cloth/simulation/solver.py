"""Position-based dynamics with small steps: stretch and shear threads, skip threads for bending.

A piece is a network of threads: an edge's stiffness is that of warp, weft and shearing by its direction in the plane of
its piece; across every inner edge a thread that skips it resists bending (the source's structural, diagonal and
interleaving springs). A frame is `core/engine.ts`'s, in WebAssembly: a fifth of the time that NumPy took, the same bits
everywhere.

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
from cloner.cloth.simulation.core.host import ClothEngine
from cloner.cloth.simulation.fabrics import Fabric
from cloner.cloth.simulation.forces import Slips
from cloner.cloth.simulation.threads import DistanceConstraints, Spacing, colour_constraints, make_spacing
from cloner.cloth.simulation.wearer import Skin
from cloner.records.arrays import Array

Ints = NDArray[np.int64]

#: Cloth rests this far from the skin, metres: thicker than the cloth, so that triangles' middles stay out as well.
THICK_M: Final = 0.006
#: Skin farther than this cannot be reached between two searches, metres.
REACH_M: Final = 0.08
#: No point of cloth moves faster, m/s: what would is a fault of the start.
FASTEST_M_S: Final = 12.0
#: No thread stays longer than this: fabrics stiffen (KES curves rise steeply towards EM).
LONGEST: Final = 1.03
#: Share of its speed that cloth keeps a second by itself: threads rub.
KEPT: Final = 0.25


@dataclass(frozen=True, slots=True, eq=False)
class Sheet:
    """A garment ready for simulation.

    Attributes
    ----------
    faces : (T, 3) int64
    mass_kg : (N,) float64
    area_m2 : (T,) float64
    stretch, bend : DistanceConstraints
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
    stretch: DistanceConstraints
    bend: DistanceConstraints
    edges: Ints
    rest_m: Array
    held: Ints
    anchor: Ints
    leash_m: Array
    spacing: Spacing
    fabric: Fabric


@dataclass(frozen=True, slots=True, eq=False)
class State:
    """Positions (N, 3) metres and velocities (N, 3) m/s; for elements also the anchors of friction."""

    places_m: Array
    speeds_m_s: Array
    slips: Slips | None = None


def make_sheet(cloth: Cloth, fabric: Fabric, held: Ints) -> Sheet:
    """Return a garment of a fabric, ready for simulation."""
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
        colour_constraints(ends, rest, 1.0 / stiff, cloth.count),
        colour_constraints(bends, flat_m, 1.0 / bending, cloth.count),
        ends,
        rest,
        held,
        *_tethers(cloth, held),
        make_spacing(ends, rest, bends, flat_m, cloth.count),
        fabric,
    )


def _tethers(cloth: Cloth, held: Ints) -> tuple[Ints, Array]:
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
class LoopTarget:
    """Position and velocity that cloth is pulled to, to close a loop.

    Attributes
    ----------
    early_m, late_m : (N, 3) float64
        Places at a frame's beginning and end.
    share : float
        Of the way there that is gone.
    """

    early_m: Array
    late_m: Array
    share: float


def make_engine(sheet: Sheet, skin_points: int) -> ClothEngine:
    """Return an engine for a garment that collides with some number of skin points."""
    stretch, bend, count = sheet.stretch, sheet.bend, len(sheet.mass_kg)
    core = ClothEngine(
        vertices=count, triangles=len(sheet.faces), stretches=len(stretch.ends), bends=len(bend.ends),
        helds=len(sheet.held), neighbours=len(sheet.spacing.neighbours), skins=skin_points,
    )  # fmt: skip
    hung = np.isfinite(sheet.leash_m)
    data = {
        "free": 1.0 / sheet.mass_kg, "faces": sheet.faces, "held": sheet.held,
        "stretch_ends": stretch.ends, "stretch_rest": stretch.rest_m, "stretch_gives": stretch.compliance,
        "bend_ends": bend.ends, "bend_rest": bend.rest_m, "bend_gives": bend.compliance,
        "anchor": np.where(hung, sheet.anchor, -1), "leash": np.where(hung, sheet.leash_m, 0.0),
        "radius": sheet.spacing.radius_m, "next_first": sheet.spacing.first, "next": sheet.spacing.neighbours,
    }  # fmt: skip
    for name, values in data.items():
        core.arrays[name][:] = values
    core.arrays["free"][sheet.held] = 0.0
    core.call("ready")
    return core


def step(
    core: ClothEngine,
    fabric: Fabric,
    state: State,
    skin_now: Skin,
    held_m: tuple[Array, Array],
    seconds: float,
    substeps: int,
    wind_m_s: Array,
    lead: LoopTarget | None = None,
    fastest_m_s: float = FASTEST_M_S,
) -> State:
    """Return the state a frame later.

    Parameters
    ----------
    core : ClothEngine
        The garment's (`make_engine`).
    fabric : Fabric
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
    lead : LoopTarget or None
    fastest_m_s : float
    """
    now = core.arrays
    core.meet(skin_now)
    now["place"][:], now["velocity"][:] = state.places_m, state.speeds_m_s
    now["held_early"][:], now["held_late"][:] = held_m
    led = 0.0
    if lead is not None:
        now["lead_early"][:], now["lead_late"][:] = lead.early_m, lead.late_m
        led = 1.0 - (1.0 - lead.share) ** (1.0 / substeps)
    core.call(
        "frame", seconds, substeps, THICK_M, REACH_M, fastest_m_s, LONGEST, fabric.friction,
        KEPT ** (seconds / substeps), *(float(speed) for speed in wind_m_s), fabric.air, led,
    )  # fmt: skip
    return State(np.array(now["place"]), np.array(now["velocity"]))


def strains(sheet: Sheet, places_m: Array) -> Array:
    """Return the strain (E,) of every thread."""
    away = places_m[sheet.edges[:, 1]] - places_m[sheet.edges[:, 0]]
    return np.asarray(np.linalg.norm(away, axis=1) / sheet.rest_m - 1.0)
