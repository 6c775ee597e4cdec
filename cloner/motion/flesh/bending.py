"""Limbs bent by known angles at one joint, and the volume around that joint, which skinning loses or gains."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from cloner.generic.load import GENERIC_STATURE_M, load_generic
from cloner.geometry.meshes.triangles import triangle_sides
from cloner.motion.limbs import turns
from cloner.motion.limbs.body import FOOT, Body, below
from cloner.motion.limbs.twist import shared_twist
from cloner.motion.moves.gait import X, Z, aim_limb
from cloner.records.arrays import Array

Ints = NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class JointBend:
    """One way in which a joint bends.

    Attributes
    ----------
    joint : str
        Without its side.
    way : str
        "raised" and "spread" go aside, all others forward or back.
    degrees : tuple of float
        Angles over the joint's range; 0 is a limb that hangs straight down (shoulder, hip) or is straight.
    """

    joint: str
    way: str
    degrees: tuple[float, ...]


#: Collarbones rise by this much under level arms, radians (taste, of 0, 8, 12, 14 and 20 degrees; that they rise with
#: an arm: Inman et al. 1944); arms that rise alone leave the collar standing in steps beside the neck.
CLAVICLE_RAD: Final = np.radians(12.0)
#: Below this they stay (the setting phase: Inman et al. 1944).
SETTING_RAD: Final = np.radians(30.0)
#: Ranges of healthy adults (Norkin and White 2016, table of the American Academy of Orthopaedic Surgeons), rounded.
BENDS: Final = (
    JointBend("shoulder", "raised", (0, 30, 60, 90, 120, 150)),
    JointBend("shoulder", "forward", (0, 45, 90, 135)),
    JointBend("elbow", "bent", (0, 30, 60, 90, 120, 140)),
    JointBend("hip", "forward", (-20, 0, 30, 60, 90, 110)),
    JointBend("hip", "spread", (0, 20, 40)),
    JointBend("knee", "bent", (0, 30, 60, 90, 120, 135)),
)
#: Joints whose flesh is kept.
FLESHED: Final = ("shoulder", "elbow", "hip", "knee")
#: How far around a joint its flesh counts, metres for somebody of 1.70 m, and the segments it lies in.
_REACH: Final = {
    "shoulder": (0.15, ("torso", "upper_arm")), "elbow": (0.10, ("upper_arm", "forearm")),
    "hip": (0.18, ("torso", "pelvis", "thigh")), "knee": (0.13, ("thigh", "calf")),
}  # fmt: skip


def bent_rotations(body: Body, side: str, bend: JointBend, degrees: Sequence[float]) -> Array:
    """Return rotation vectors (F, 94, 3) of one limb bent by F angles, all others at rest, radians."""
    angle, sign = np.radians(np.asarray(degrees, dtype=np.float64)), 1.0 if side == "l" else -1.0
    still = np.zeros(len(angle))
    world = np.tile(np.eye(3), (len(angle), len(body.names), 1, 1))
    forward, aside = turns.rotations_about(X, -angle), turns.rotations_about(Z, sign * angle)
    if bend.joint in ("shoulder", "elbow"):
        hanging = turns.rotations_about(Z, still + body.arm_aside(side))
        swing = {"raised": aside, "forward": forward}.get(bend.way, hanging)
        rise = _rise(angle if bend.joint == "shoulder" else still) - _rise(_aside(body, side))
        for name in ("sternoclavicular", "acromioclavicular"):
            world[:, body.joint(f"{side}_{name}")] = turns.rotations_about(Z, sign * rise)
        aim_limb(body, world, side, "shoulder", swing)
        aim_limb(body, world, side, "elbow", swing @ forward if bend.joint == "elbow" else swing)
        world[:, below(body, body.joint(f"{side}_wrist"))] = world[:, [body.joint(f"{side}_elbow")]]
    else:
        thigh = {"forward": forward, "spread": aside}.get(bend.way, turns.rotations_about(X, still))
        aim_limb(body, world, side, "hip", thigh)
        aim_limb(body, world, side, "knee", turns.rotations_about(X, angle) if bend.joint == "knee" else thigh)
        for name in (*FOOT, "metatarsal"):
            world[:, body.joint(f"{side}_{name}")] = world[:, body.joint(f"{side}_knee")]
    return shared_twist(body, turns.local_from_world(world, body.parents))


def _rise(raised: Array) -> Array:
    """Return the rise of collarbones under arms raised by angles (F,), radians."""
    return np.asarray(CLAVICLE_RAD * np.clip((raised - SETTING_RAD) / (0.5 * np.pi - SETTING_RAD), 0.0, 2.0))


def _aside(body: Body, side: str) -> Array:
    """Return (1,) the angle of the upper arm from straight down at rest, radians."""
    arm = body.joints_m[body.joint(f"{side}_elbow")] - body.joints_m[body.joint(f"{side}_shoulder")]
    return np.asarray(np.arccos(np.clip(-arm[1:2] / np.linalg.norm(arm), -1.0, 1.0)))


@dataclass(frozen=True, slots=True, eq=False)
class Flesh:
    """The skin around a joint, one component, and its rims.

    Attributes
    ----------
    rows : (N,) int64
        Its vertices.
    triangles : (T, 3) int64, places in ``rows``
    rim : (E, 2) int64, places in ``rows``
        Sides that only one triangle has, as that triangle goes along them.
    hole : (E,) int64
        Which hole each of them goes around.
    """

    rows: Ints
    triangles: Ints
    rim: Ints
    hole: Ints

    def volume(self, points_m: Array) -> float:
        """Return the volume of points (N, 3), with every hole closed by a fan around its middle, m3."""
        own = np.ascontiguousarray((points_m - points_m.mean(axis=0)).T)
        first, second = own[:, self.rim[:, 1]], own[:, self.rim[:, 0]]
        count = 2.0 * np.bincount(self.hole)
        middles = np.stack([np.bincount(self.hole, axis) / count for axis in first + second])
        inside = _products(*(own[:, self.triangles[:, k]] for k in range(3)))
        return (inside + _products(middles[:, self.hole], first, second)) / 6.0


def _products(a: Array, b: Array, c: Array) -> float:
    """Return the sum of the triple products of (3, N) vectors; a third of the time of numpy's cross."""
    return float(
        a[0] @ (b[1] * c[2] - b[2] * c[1]) + a[1] @ (b[2] * c[0] - b[0] * c[2]) + a[2] @ (b[0] * c[1] - b[1] * c[0])
    )


@functools.cache
def flesh(side: str, joint: str) -> Flesh:
    """Return the skin around a joint, the same for every clone."""
    generic = load_generic()
    reach, segments = _REACH[joint]
    own = [s if s in ("torso", "pelvis") else f"{'left' if side == 'l' else 'right'}_{s}" for s in segments]
    inside = generic.segment(*own)
    inside &= generic.skin
    away = np.linalg.norm(generic.vertices_m - generic.joints_m[generic.joint(f"{side}_{joint}")], axis=1)
    inside &= away < reach * GENERIC_STATURE_M / 1.70
    triangles = np.asarray(generic.triangles()[0], dtype=np.int64)
    triangles = triangles[inside[triangles].all(axis=1)]
    piece = _pieces(triangles)[triangles[:, 0]]
    triangles = triangles[piece == np.bincount(piece).argmax()]
    rows, places = np.unique(triangles, return_inverse=True)
    places = np.asarray(places.reshape(-1, 3), dtype=np.int64)
    edges = triangle_sides(places)
    rim = edges[~np.isin(edges @ [1, len(rows)], edges @ [len(rows), 1])]
    _, hole = np.unique(_pieces(rim)[rim[:, 0]], return_inverse=True)
    return Flesh(rows, places, rim, np.asarray(hole.reshape(-1), dtype=np.int64))


def _pieces(corners: Ints) -> Ints:
    """Return the connected piece of every vertex that sides (E, 2) or triangles (T, 3) name."""
    size = int(corners.max()) + 1
    first = np.tile(corners[:, 0], corners.shape[1] - 1)
    graph = coo_matrix((np.ones(len(first)), (first, corners[:, 1:].T.ravel())), shape=(size, size))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int64)
