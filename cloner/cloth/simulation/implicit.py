"""The source's integrator: implicit Euler over first-order elements, accurate; `solver` is the fast one.

``(M + h D + h² K) dv = M (v' - v) + h f`` in every round of a step, forces at its end, by conjugate gradients.
What meets skin or itself is put right afterwards in place and speed, as the source does.

References
----------
D. Baraff, A. Witkin, Large Steps in Cloth Simulation, SIGGRAPH 1998; P. Volino, N. Magnenat-Thalmann, Implementing Fast
Cloth Simulation with Collision Response, CGI 2000 (constraints corrected in position and speed).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from cloner.cloth.drafting.cut import Cloth
from cloner.cloth.simulation.core.host import ClothEngine
from cloner.cloth.simulation.elements import Elements, make_elements
from cloner.cloth.simulation.fabrics import Fabric
from cloner.cloth.simulation.forces import VISCOUS_S, Slips, bending_forces, membrane_forces, no_slips
from cloner.cloth.simulation.solver import FASTEST_M_S, REACH_M, THICK_M, LoopTarget, Sheet, State, strains
from cloner.cloth.simulation.wearer import Skin
from cloner.records.arrays import Array

Ints = NDArray[np.int64]

#: Steps a frame, and into how many parts of a frame they are halved where one adds more than ``JUMP`` to a thread's
#: strain (Baraff and Witkin 1998, section 6: such steps are taken back); two and four steps alone tore a skirt.
STEPS, FINEST, JUMP = 2, 32, 0.05
#: Conjugate gradients stop at this share of the right side, or after so many rounds.
EXACT: Final = 1e-3
MOST_ROUNDS: Final = 120
#: Rounds of Newton's method a step: one alone draws out what turns, by half the square of its angle.
ROUNDS: Final = 2
#: Stiffness of skin that is met, of the cloth's own at that vertex.
FIRM: Final = 5.0
#: Times that vertices too near are moved apart a step.
APART_ROUNDS: Final = 6


@dataclass(frozen=True, slots=True, eq=False)
class System:
    """The matrix's sparsity: 3 x 3 blocks of vertices that share a triangle or a hinge.

    Attributes
    ----------
    starts : (N + 1,) int32, columns : (K,) int32
        Rows of blocks.
    own : (N,) int64
        Blocks on the diagonal.
    summed : (K, 9 T) sparse
        Adds the triangles' blocks up.
    bending_n_m : (K,) float64
        Bending's stiffness, its friction's too, the same along x, y and z.
    back : (N, R) sparse
        Bending's rows, transposed.
    elements : Elements
    """

    starts: NDArray[np.int32]
    columns: NDArray[np.int32]
    own: Ints
    summed: sparse.csr_matrix
    bending_n_m: Array
    back: sparse.csr_matrix
    elements: Elements


def make_system(cloth: Cloth, fabric: Fabric) -> System:
    """Return a garment's elements and the sparsity of their matrix."""
    made, count = make_elements(cloth, fabric), cloth.count
    stiff = made.bends_n_m.copy()
    stiff[: len(made.hinges)] += made.slip_n / made.slip_m
    back = made.bends.T.tocsr()
    bent = (back @ sparse.diags(stiff) @ made.bends).tocoo()
    faces = (made.faces[:, :, None] * count + made.faces[:, None, :]).ravel()
    bending = bent.row.astype(np.int64) * count + bent.col
    own = np.arange(count, dtype=np.int64) * (count + 1)
    keys = np.unique(np.concatenate([faces, bending, own]))
    starts = np.searchsorted(keys // count, np.arange(count + 1))
    summed = sparse.csr_matrix(
        (np.ones(len(faces)), (np.searchsorted(keys, faces), np.arange(len(faces)))), (len(keys), len(faces))
    )
    added = np.bincount(np.searchsorted(keys, bending), np.asarray(bent.data, np.float64), len(keys)).astype(np.float64)
    columns = (keys % count).astype(np.int32)
    return System(starts.astype(np.int32), columns, np.searchsorted(keys, own), summed, added, back, made)


def step(
    sheet: Sheet,
    core: ClothEngine,
    system: System,
    state: State,
    skin_now: Skin,
    held_m: tuple[Array, Array],
    seconds: float,
    wind_m_s: Array,
    lead: LoopTarget | None = None,
) -> State:
    """Return the state a frame later, like `solver.step` but by elements, in as many steps as needed."""
    frame = _Frame(core, held_m, seconds, wind_m_s, lead)
    core.meet(skin_now)
    done, size = 0, FINEST // STEPS
    while done < FINEST:
        tried = _moved(sheet, system, state, frame, done / FINEST, (done + size) / FINEST, given_up=size == 1)
        if tried is None:
            size //= 2
            continue
        state, done = tried, done + size
        if size < FINEST // STEPS and done % (2 * size) == 0:
            size *= 2
    return state


@dataclass(frozen=True, slots=True, eq=False)
class _Frame:
    """What acts in a frame: the engine with its skin, held positions early and late, seconds, wind, and target."""

    core: ClothEngine
    held_m: tuple[Array, Array]
    seconds: float
    wind_m_s: Array
    lead: LoopTarget | None


def _moved(
    sheet: Sheet, system: System, state: State, frame: _Frame, early: float, late: float, *, given_up: bool
) -> State | None:
    """Return the state after one step from one share of a frame to another, or None if it stretched cloth too far."""
    before, h = state.places_m, (late - early) * frame.seconds
    held = (1.0 - late) * frame.held_m[0] + late * frame.held_m[1]
    core, now = frame.core, frame.core.arrays
    now["place"][:], now["before"][:], now["velocity"][:] = before, before, state.speeds_m_s
    core.call("findPlanes", early, REACH_M)
    core.call("findPairs", h)
    core.call("blow", *(float(speed) for speed in frame.wind_m_s), sheet.fabric.air)
    outside = sheet.mass_kg[:, None] * now["thrust"]
    under = np.flatnonzero(now["near"])
    normals, early_m, late_m = (now[f"plane_{name}"][under] for name in ("normal", "early", "late"))
    base = early_m + late * (late_m - early_m)
    slips, speeds = state.slips or no_slips(system.elements), np.zeros_like(before)
    speeds[sheet.held] = (held - before[sheet.held]) / h
    for _ in range(ROUNDS):
        over = np.einsum("ij,ij->i", (before + h * speeds)[under] - base, normals) - THICK_M
        met = np.flatnonzero(over < 0.0)
        touch = _Contacts(under[met], normals[met], -over[met] / h)
        lag = sheet.mass_kg[:, None] * (state.speeds_m_s - speeds)
        more, drawn = _newton_step(sheet, system, before, speeds, slips, h * outside + lag, h, touch)
        speeds += more
    fast = np.linalg.norm(speeds, axis=1)
    speeds *= np.minimum(1.0, FASTEST_M_S / np.maximum(fast, 1e-9))[:, None]
    places = before + h * speeds
    places[sheet.held] = held
    if not given_up and float((strains(sheet, places) - strains(sheet, before)).max()) > JUMP:
        return None
    if frame.lead is not None:
        lead = frame.lead
        gone = 1.0 - (1.0 - lead.share) ** (late - early)
        places += gone * ((1.0 - late) * lead.early_m + late * lead.late_m - places)
    now["place"][:] = places
    core.call("findGuards", h)
    for _ in range(APART_ROUNDS):
        core.call("keepApart")
        core.call("keepGap")
    core.call("keepOut", THICK_M, sheet.fabric.friction, late, late - early)
    places = np.array(now["place"])
    return State(places, (places - before) / h, drawn)


@dataclass(frozen=True, slots=True, eq=False)
class _Contacts:
    """Vertices (K,) that a step would move into the skin, its normals (K, 3), and the speed out of it (K,), m/s."""

    rows: Ints
    normals: Array
    out_m_s: Array


def _newton_step(
    sheet: Sheet, system: System, before: Array, speeds: Array, slips: Slips, thrust: Array, h: float, touch: _Contacts
) -> tuple[Array, Slips]:
    """Return the change of a step's speeds (N, 3) by one Newton iteration, m/s, and friction's new anchors.

    ``thrust`` (N, 3), kg m/s, is what acts from outside and what the speeds lack.
    """
    made, places = system.elements, before + h * speeds
    drawn, bent = (
        membrane_forces(made, places, speeds, slips.strain, h),
        bending_forces(made, places, speeds, slips.bent_m),
    )
    thrust = thrust - h * (system.back @ bent.turn_n)
    for axis in range(3):
        thrust[:, axis] += h * np.bincount(made.faces.ravel(), drawn.push_n[:, :, axis].ravel(), len(places))
    data = np.asarray(system.summed @ drawn.blocks.reshape(-1, 9)).reshape(-1, 3, 3)
    diagonal = np.einsum("kaa->ka", data)  # a view
    diagonal += (h * (h + VISCOUS_S) * system.bending_n_m)[:, None]
    diagonal[system.own] += sheet.mass_kg[:, None]
    met = system.own[touch.rows]
    firm = FIRM * np.einsum("kaa->k", data[met])
    data[met] += firm[:, None, None] * touch.normals[:, :, None] * touch.normals[:, None, :]
    thrust[touch.rows] += (firm * touch.out_m_s)[:, None] * touch.normals
    return _solved(system, data, thrust, sheet.held), Slips(drawn.held, bent.held_m)


def _solved(system: System, data: Array, right: Array, held: Ints) -> Array:
    """Return (N, 3) changes of speed, 0 for held vertices; conjugate gradients."""
    count = len(right)
    matrix = sparse.bsr_matrix((data, system.columns, system.starts), shape=(3 * count, 3 * count))
    right[held] = 0.0
    before = np.linalg.inv(data[system.own])
    before[held] = 0.0
    gained = np.zeros_like(right)
    left = right
    ready = np.einsum("nab,nb->na", before, left)
    way, size = ready, float((left * ready).sum())
    limit = EXACT**2 * size
    for _ in range(MOST_ROUNDS):
        if size <= limit:
            break
        pull = (matrix @ way.ravel()).reshape(-1, 3)
        pull[held] = 0.0
        far = size / float((way * pull).sum())
        gained += far * way
        left = left - far * pull
        ready = np.einsum("nab,nb->na", before, left)
        size, last = float((left * ready).sum()), size
        way = ready + size / last * way
    return gained
