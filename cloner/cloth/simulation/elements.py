"""Cloth as first-order finite elements with stress curves of warp, weft and shear, and bending between them.

A triangle's strain is Green's, along the warp, the weft and between both; its stress follows Kawabata's curves, with
Poisson's coupling, viscosity, and the friction of its threads: the way back lies below the way there, so that what was
folded keeps a crease (hysteresis, plasticity). Across every inner edge a linear bending vector resists.

References
----------
P. Volino, N. Magnenat-Thalmann, F. Faure, A Simple Approach to Nonlinear Tensile Stiffness for Accurate Cloth
Simulation, ACM TOG 28(4), 2009 (elements); P. Volino, N. Magnenat-Thalmann, Simple Linear Bending Stiffness in Particle
Systems, SCA 2006; E. Miguel et al., Modeling and Estimation of Internal Friction in Cloth, SIGGRAPH Asia 2013 (slips);
S. Kawabata, The Standardization and Analysis of Hand Evaluation, 1980 (curves).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from cloner.cloth.drafting.cut import Cloth, hinges_of
from cloner.cloth.simulation.fabrics import BENDING_N_M, FULL_N_M, LOOP_N, LOOP_N_M, SHEARING_N_M, Fabric
from cloner.records.arrays import Array

Ints = NDArray[np.int64]

#: Share of the tensile stiffness with which cloth resists being pushed together in its plane: it buckles (taste).
PUSHED: Final = 0.1
#: Woven cloth's Poisson coefficient is .1 to .3 at small strains (typical of plain weaves in textile literature).
POISSON: Final = 0.15
#: Curvature in which the friction of threads builds up, 1/m: Kawabata's loops, 250 / m wide, turn within a tenth.
SLIP_CURVED_M: Final = 20.0
#: Share of bending that hinges carry by themselves; the rest is of all three round a triangle (see `_bending`).
HINGES: Final = 0.75
#: Angles at which 2HG and 2HG5 are read.
HG_RAD, HG5_RAD = np.radians(0.5), np.radians(5.0)


@dataclass(frozen=True, slots=True, eq=False)
class Elements:
    """Triangles and hinges ready for forces.

    Attributes
    ----------
    faces : (T, 3) int64
    along : (T, 2, 3) float64, 1/m
        Weights of a triangle's corners that give how its weft and its warp lie in space.
    area_m2 : (T,) float64
    hinges : (I, 4) int64
        Two tips and the two ends of every inner edge.
    bends : (R, N) sparse
        Give the bending vectors, metres, zero where flat: of the hinges, then sums of three round a triangle.
    bends_n_m : (R,) float64
        Force of a bending vector, N/m.
    slip_n, slip_m : (I,) float64
        Force at which a hinge's friction slips, newtons, and the way in which it builds up, metres.
    fabric : Fabric
    """

    faces: Ints
    along: Array
    area_m2: Array
    hinges: Ints
    bends: sparse.csr_matrix
    bends_n_m: Array
    slip_n: Array
    slip_m: Array
    fabric: Fabric


@dataclass(frozen=True, slots=True, eq=False)
class Strain:
    """Strain of all triangles.

    Attributes
    ----------
    weft, warp : (T, 3) float64
        Unit lengths of both as they lie in space.
    strain : (T, 3) float64
        Of weft, warp and shearing.
    """

    weft: Array
    warp: Array
    strain: Array


def make_elements(cloth: Cloth, fabric: Fabric) -> Elements:
    """Return a garment's elements."""
    corner = cloth.flat_m[cloth.triangles]
    one, other = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
    cross = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    ahead = np.roll(corner, -1, axis=1) - np.roll(corner, 1, axis=1)  # the opposite side's
    along = np.stack([ahead[:, :, 1], -ahead[:, :, 0]], axis=1) * (-1.0 / cross)[:, None, None]
    area_m2 = np.abs(cross) / 2.0
    return Elements(cloth.faces, along, area_m2, *_bending(cloth, area_m2, fabric), fabric)


def _bending(cloth: Cloth, area_m2: Array, fabric: Fabric) -> tuple[Ints, sparse.csr_matrix, Array, Array, Array]:
    """Return hinges, the rows that give bending vectors, their stiffness, and friction's force and travel.

    A hinge's vector over half its heights' product is the curvature across it less a third of that along it, q. In a
    hexagonal grid B A (3/4 sum q² + 1/4 (sum q)²) / 2 a triangle is a plate's energy without Poisson's coupling.
    """
    found = hinges_of(cloth)
    heights, lean, owners = found.heights_m, (found.weft[0] + found.weft[1]) / 2.0, found.triangles
    hinges, rows = np.concatenate([found.tips, found.edges], axis=1), np.arange(len(found.edges))
    first, second = heights[::-1] / heights.sum(axis=0)
    middle = first * (found.feet_m[0] / found.lengths_m[0]) + second * (found.feet_m[1] / found.lengths_m[1])
    weights = np.stack([first, second, middle - 1.0, -middle], axis=1)
    bent = sparse.csr_matrix((weights.ravel(), (np.repeat(rows, 4), hinges.ravel())), (len(hinges), cloth.count))
    curved = 2.0 / (heights[0] * heights[1])
    # A triangle at a border has fewer hinges, which stand for all of it.
    inner = np.bincount(owners.ravel(), minlength=len(area_m2))
    shared = area_m2 * 3.0 / np.maximum(inner, 1)
    all_m2, area = (each[owners].sum(axis=1) for each in (shared, np.where(inner == 3, HINGES, 1.0) * shared))
    whole = np.flatnonzero(inner == 3)
    at = np.searchsorted(whole, owners).clip(max=max(len(whole) - 1, 0))
    is_whole = inner[owners] == 3
    added = [sparse.csr_matrix((curved[k], (at[k, side], rows[k])), (len(whole), len(hinges)))
             for side in (0, 1) for k in [np.flatnonzero(is_whole[:, side])]]  # fmt: skip
    round_m = (added[0] + added[1]) @ bent
    warp, weft = (value * BENDING_N_M for value in fabric.bending)
    mean = (warp + weft) / 2.0
    stiff = _directed(lean, *((value - (1.0 - HINGES) * mean) / HINGES for value in (warp, weft)))
    slip = _directed(lean, *(value / 2.0 * LOOP_N for value in fabric.bending_hysteresis))
    force = np.concatenate([curved**2 * area * stiff, (1.0 - HINGES) * mean * area_m2[whole]])
    return hinges, sparse.vstack([bent, round_m]).tocsr(), force, curved * all_m2 * slip, SLIP_CURVED_M / curved


def _directed(lean: Array, warp: float, weft: float) -> Array:
    """Return (I,) a hinge's share of the bending along warp and weft; exact for a hexagonal grid's three directions."""
    turned = 2.0 * lean - 1.0
    share = 0.5 + 1.5 * turned - turned**3
    return np.asarray(np.maximum(share * weft + (1.0 - share) * warp, 0.1 * min(warp, weft)))


def compute_strain(made: Elements, places_m: Array) -> Strain:
    """Return the strain of all triangles."""
    weft, warp = np.einsum("tdk,tka->dta", made.along, places_m[made.faces])
    strain = np.stack(
        [
            ((weft**2).sum(axis=1) - 1.0) / 2.0,
            ((warp**2).sum(axis=1) - 1.0) / 2.0,
            (weft * warp).sum(axis=1),
        ],
        axis=1,
    )
    return Strain(weft, warp, strain)


def stresses(fabric: Fabric, strain: Array) -> tuple[Array, Array, Array]:
    """Return stress (T, 3) by the curves' middles, their slopes and the half widths of their
    hysteresis loops, all N/m.
    """
    stress, slope, half = np.empty_like(strain), np.empty_like(strain), np.empty_like(strain)
    for axis, row in ((0, 1), (1, 0)):  # weft's numbers stand second
        full, linear, back = fabric.extension[row], fabric.linearity[row], fabric.resilience[row]
        rise, bend = 2.0 / linear - 1.0, (1.0 - back) / (1.0 + back)
        share = strain[:, axis] / full
        there, soft = np.maximum(share, 0.0), PUSHED * FULL_N_M / full
        top = np.minimum(there, 1.0)  # beyond EM the curve goes on straight
        loaded = FULL_N_M * (top**rise + rise * (there - top))
        steep = FULL_N_M / full * rise * top ** (rise - 1.0)
        stress[:, axis] = np.where(share > 0.0, loaded / (1.0 + bend), soft * strain[:, axis])
        slope[:, axis] = np.where(share > 0.0, np.maximum(steep / (1.0 + bend), soft), soft)
        half[:, axis] = bend / (1.0 + bend) * loaded
    rigid = SHEARING_N_M * sum(fabric.shearing) / 2.0
    stress[:, 2], slope[:, 2] = rigid * strain[:, 2], rigid
    low, high = (sum(pair) / 4.0 * LOOP_N_M for pair in (fabric.shearing_hysteresis, fabric.shearing_hysteresis_5))
    far = np.clip((np.abs(strain[:, 2]) - HG_RAD) / (HG5_RAD - HG_RAD), 0.0, 1.0)
    half[:, 2] = low + far * (high - low)
    stress[:, :2] += _coupling(fabric) * strain[:, 1::-1]
    return stress, slope, half


def _coupling(fabric: Fabric) -> float:
    """Return the stress along one direction for strain along the other, N/m: narrower where it is drawn long."""
    return POISSON * PUSHED * FULL_N_M * 2.0 / sum(fabric.extension)


def energy_j(made: Elements, places_m: Array) -> float:
    """Return the elastic energy at positions (N, 3), joules: extension, shearing and bending, without friction's."""
    fabric, strain = made.fabric, compute_strain(made, places_m).strain
    density = _coupling(fabric) * strain[:, 0] * strain[:, 1]
    density += SHEARING_N_M * sum(fabric.shearing) / 4.0 * strain[:, 2] ** 2
    for axis, row in ((0, 1), (1, 0)):
        full, back = fabric.extension[row], fabric.resilience[row]
        rise, share = 2.0 / fabric.linearity[row] - 1.0, strain[:, axis] / full
        there = np.maximum(share, 0.0)
        top = np.minimum(there, 1.0)
        beyond = there - top
        work = top ** (rise + 1.0) / (rise + 1.0) + beyond + rise * beyond**2 / 2.0
        pushed = PUSHED * FULL_N_M / full * np.minimum(strain[:, axis], 0.0) ** 2 / 2.0
        density += FULL_N_M * full * work * (1.0 + back) / 2.0 + pushed
    bent = (made.bends_n_m * ((made.bends @ places_m) ** 2).sum(axis=1)).sum() / 2.0
    return float((made.area_m2 * density).sum() + bent)
