"""Forces of finite elements: a step's forces, matrix blocks, and internal friction.

Friction is a spring beside the curve that holds until it slips and is then drawn along: loops of loading lie as wide as
Kawabata prints them, and cloth that was folded keeps a crease.

References
----------
E. Miguel et al., Modeling and Estimation of Internal Friction in Cloth, SIGGRAPH Asia 2013; P. Volino, N.
Magnenat-Thalmann, F. Faure, ACM TOG 28(4), 2009 (forces and stiffness of a triangle).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.cloth.simulation.elements import Elements, Strain, compute_strain, stresses
from cloner.cloth.simulation.fabrics import FULL_N_M
from cloner.records.arrays import Array

#: Stress that a rate of strain gives, of the stiffness, seconds: KES measures no speeds (taste).
VISCOUS_S: Final = 0.004
#: Strain and shearing (radians) in which the threads' friction builds up: a tenth of what Kawabata's loops go through.
SLIP_STRAIN: Final = 0.002
SLIP_SHEAR: Final = 0.0087
#: Least slope of the curves in the matrix where cloth is drawn, of a straight line's to EM: the curves begin flat, and
#: a step that saw only that drew triangles to twice their length.
STRAIGHT: Final = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Slips:
    """Anchors of the threads' friction: strains (T, 3) of weft, warp, shearing; bending (I,), metres."""

    strain: Array
    bent_m: Array


def no_slips(made: Elements) -> Slips:
    """Return the anchors of cloth that was never stretched or bent."""
    return Slips(np.zeros((len(made.faces), 3)), np.zeros(len(made.hinges)))


@dataclass(frozen=True, slots=True, eq=False)
class MembraneForces:
    """Forces (T, 3, 3) on corners, newtons; blocks (T, 3, 3, 3, 3) of the matrix, kg; friction's anchors (T, 3)."""

    push_n: Array
    blocks: Array
    held: Array


def membrane_forces(made: Elements, places: Array, speeds: Array, slipped: Array, h: float) -> MembraneForces:
    """Return forces of the triangles at the end of a step of ``h`` seconds; ``slipped`` (T, 3) are
    friction's anchors.
    """
    now = compute_strain(made, places)
    stress, slope, half = stresses(made.fabric, now.strain)
    reach = np.array([SLIP_STRAIN, SLIP_STRAIN, SLIP_SHEAR])
    drawn = now.strain - slipped
    kept = np.clip(drawn, -reach, reach)
    stress += half * kept / reach
    slope += np.where(drawn == kept, half / reach, 0.0)
    grown = _gradients(made, now)
    rate = np.einsum("tcka,tka->tc", grown, speeds[made.faces])
    soon = now.strain[:, :2] > 0.0
    slope[:, :2] = np.maximum(slope[:, :2], soon * STRAIGHT * FULL_N_M / np.array(made.fabric.extension[::-1]))
    spread = _geometric_stiffness(made, stress)
    push = -np.einsum("tc,tcka->tka", made.area_m2[:, None] * (stress + VISCOUS_S * slope * rate), grown)
    stiff = h * (h + VISCOUS_S) * made.area_m2[:, None] * slope
    flat = grown.reshape(len(grown), 3, 9)
    blocks = (flat.transpose(0, 2, 1) @ (stiff[:, :, None] * flat)).reshape(-1, 3, 3, 3, 3).transpose(0, 1, 3, 2, 4)
    return MembraneForces(push, blocks + h * h * spread[:, :, :, None, None] * np.eye(3), now.strain - kept)


@dataclass(frozen=True, slots=True, eq=False)
class BendingForces:
    """Forces (R, 3) of the rows of bending, newtons, and friction's anchors (I,), metres."""

    turn_n: Array
    held_m: Array


def bending_forces(made: Elements, places: Array, speeds: Array, slipped_m: Array) -> BendingForces:
    """Return forces of the hinges at the end of a step; friction acts along a hinge's own normal."""
    hinges, bent, normal = len(made.hinges), made.bends @ places, _normals(made, places)
    away = np.einsum("ia,ia->i", bent[:hinges], normal)
    kept = np.clip(away - slipped_m, -made.slip_m, made.slip_m)
    turn = made.bends_n_m[:, None] * (bent + VISCOUS_S * (made.bends @ speeds))
    turn[:hinges] += (made.slip_n / made.slip_m * kept)[:, None] * normal
    return BendingForces(turn, away - kept)


def _gradients(made: Elements, now: Strain) -> Array:
    """Return the derivatives (T, 3, 3, 3) of weft, warp and shear strain by each corner's position, 1/m."""
    weft, warp = made.along[:, 0, :, None], made.along[:, 1, :, None]
    across, down = now.weft[:, None, :], now.warp[:, None, :]
    return np.stack([weft * across, warp * down, weft * down + warp * across], axis=1)


def _geometric_stiffness(made: Elements, stress: Array) -> Array:
    """Return (T, 3, 3) the stiffness of stress under rotation, N/m: tension only, so that it stays positive."""
    mean, apart = (stress[:, 0] + stress[:, 1]) / 2.0, (stress[:, 0] - stress[:, 1]) / 2.0
    radius = np.maximum(np.hypot(apart, stress[:, 2]), 1e-12)
    high, low = np.maximum(mean + radius, 0.0), np.maximum(mean - radius, 0.0)
    middle, half = (high + low) / 2.0, (high - low) / 2.0 / radius
    drawn = np.empty((len(stress), 2, 2))
    drawn[:, 0, 0], drawn[:, 1, 1] = middle + half * apart, middle - half * apart
    drawn[:, 0, 1] = drawn[:, 1, 0] = half * stress[:, 2]
    return np.asarray(np.einsum("t,tdi,tde,tej->tij", made.area_m2, made.along, drawn, made.along, optimize=True))


def _normals(made: Elements, places: Array) -> Array:
    """Return (I, 3) unit normals of hinges."""
    first, second, start, end = (places[made.hinges[:, k]] for k in range(4))
    across = np.cross(end - start, first - second)
    return np.asarray(across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-12))
