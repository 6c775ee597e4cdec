"""Details of a hand that no body photo shows: nails and creases, as gains of its skin colour.

Nails lie where the generic human's mesh has them; flexion creases lie at its joints; the three great lines of the palm
are drawn in the palm's plane. All is told for the left hand and mirrored.

References
----------
Palm: Kimura & Kitagawa 1986, "Embryological development of human palmar, plantar, and digital flexion creases".
"""

from __future__ import annotations

import functools
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.spatial import cKDTree

from cloner.easing import smoothstep
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.meshes.triangles import edges_of
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array

#: Where the crease at a finger's root lies between its first two joints: the web. The thumb's lie in the palm's lines.
ROOTS: Final = {"thumb": None, "index": 0.32, "middle": 0.30, "ring": 0.36, "pinky": 0.50}
#: The great lines in the palm's plane, across to the thumb and along from the wrist, in lengths from the wrist to the
#: middle knuckle: heart, head and life (anatomy by eye).
LINES: Final = (
    ((-0.405, 0.742), (-0.284, 0.803), (-0.133, 0.826), (0.02, 0.841), (0.10, 0.875), (0.14, 0.93)),
    ((0.284, 0.80), (0.15, 0.75), (-0.02, 0.69), (-0.21, 0.625), (-0.32, 0.587)),
    ((0.284, 0.81), (0.19, 0.757), (0.106, 0.625), (0.068, 0.49), (0.083, 0.34), (0.13, 0.246)),
)
#: Logarithmic gains of red, green and blue; taste, after photographs of hands under soft light.
CREASE: Final = np.array([-0.09, -0.15, -0.15])
WRINKLE: Final = np.array([-0.04, -0.07, -0.07])
PAD: Final = np.array([0.03, -0.02, -0.02])
PLATE: Final = np.array([0.06, 0.05, 0.12])
LUNULA: Final = np.array([0.05, 0.07, 0.09])
FREE_EDGE: Final = np.array([0.08, 0.14, 0.20])
FOLD: Final = np.array([-0.09, -0.15, -0.15])
#: Half widths of creases and wrinkles, metres: what 2,048 texels a side still hold.
CREASE_M, WRINKLE_M = 0.0010, 0.0007
#: Half a finger's breadth, metres; skin beyond twice that is no finger's.
BREADTH_M: Final = 0.010
#: A nail's fold begins where the skin is this hollow, in its deepest part's.
FOLD_FROM: Final = 0.5
#: A nail is so wide, in its finger's width (of the generic human's nails), and ends so far before the fingertip.
NAIL_WIDTH, NAIL_END = 0.65, 0.94


@dataclass(frozen=True, slots=True, eq=False)
class Finger:
    """A finger of the generic human's left hand.

    Attributes
    ----------
    bones_m : (4, 3)
        Its three joints and its tip, metres.
    back : (3,)
        Unit direction that the nail faces.
    root : float or None
        Place of the crease at its root between the first two joints; None for the thumb.
    nail_m : (3,)
        Where the nail begins and the finger ends, from the last joint, and half the nail's width, metres.
    """

    bones_m: Array
    back: Array
    root: float | None
    nail_m: Array


def hand_gains(points_m: Array, normals: Array) -> tuple[Array, Array]:
    """Return log gains (N, 3) of skin, and the share of nail (N,), 0..1.

    Parameters
    ----------
    points_m : (N, 3), normals : (N, 3)
        On the generic human's left hand, metres, and unit.
    """
    gains, nails = _palm(points_m, normals), np.zeros(len(points_m))
    away = np.stack([_bone_distance_m(points_m, finger.bones_m) for finger in fingers()])
    for number, finger in enumerate(fingers()):
        own = np.flatnonzero((away.argmin(axis=0) == number) & (away[number] < 2.0 * BREADTH_M))
        matted, nail = _nail(finger, points_m[own], normals[own])
        gains[own] += nail + _creases(finger, points_m[own], normals[own]) * (1.0 - matted[:, None])
        nails[own] = np.maximum(nails[own], matted)
    return gains, nails


@functools.cache
def fingers() -> tuple[Finger, ...]:
    """Return the fingers of the generic human's left hand, thumb first."""
    generic = load_generic()
    vertices = generic.vertices_m.astype(np.float64)
    triangles, _ = generic.triangles()
    normals = vertex_normals(vertices, triangles.astype(np.int32))
    hollow = _concavity(vertices, normals, edges_of(triangles)[0])
    return tuple(_finger(generic, vertices, normals, hollow, name) for name in ROOTS)


def _finger(generic: GenericHuman, vertices: Array, normals: Array, hollow: Array, name: str) -> Finger:
    joints = [generic.joint(f"l_{name}{number}") for number in (1, 2, 3)]
    first, second, last = generic.joints_m[joints].astype(np.float64)
    along = (last - second) / np.linalg.norm(last - second)
    heaviest = np.take_along_axis(generic.skin_joints, generic.skin_weights.argmax(axis=1)[:, None], axis=1)[:, 0]
    own = np.flatnonzero((heaviest == joints[2]) & ((vertices - last) @ along > 0.0))
    place, turned = (vertices[own] - last) @ along, normals[own] - (normals[own] @ along)[:, None] * along
    back = turned.sum(axis=0) / np.linalg.norm(turned.sum(axis=0))  # most of a fingertip's vertices shape the nail
    behind = turned @ back > 0.5
    deep = behind & (hollow[own] > FOLD_FROM * hollow[own[behind]].max())
    half = np.abs((vertices[own] - last) @ np.cross(along, back)).max()
    begins = place[deep].min()
    bones = np.stack([first, second, last, last + place.max() * along])
    return Finger(bones, back, ROOTS[name], np.array([begins, place.max(), NAIL_WIDTH * half]))


def _concavity(vertices: Array, normals: Array, edges: NDArray[np.int64]) -> Array:
    """Return the mean slope (V,) by which neighbours stand above each vertex: positive in folds."""
    way = vertices[edges[:, 1]] - vertices[edges[:, 0]]
    way /= np.maximum(np.linalg.norm(way, axis=1), 1e-9)[:, None]
    ends = np.concatenate([edges[:, 0], edges[:, 1]])
    slope = np.concatenate([(normals[edges[:, 0]] * way).sum(axis=1), -(normals[edges[:, 1]] * way).sum(axis=1)])
    count = np.bincount(ends, minlength=len(vertices))
    return np.asarray(np.bincount(ends, slope, minlength=len(vertices)) / np.maximum(count, 1))


def _bone_distance_m(points_m: Array, bones_m: Array) -> Array:
    """Return distances (N,) to a chain of bones, metres."""
    nearest = np.full(len(points_m), np.inf)
    for start, end in pairwise(bones_m):
        way, spokes = end - start, points_m - start
        share = np.clip(spokes @ way / (way @ way), 0.0, 1.0)
        spokes -= share[:, None] * way
        nearest = np.minimum(nearest, np.einsum("na,na->n", spokes, spokes))
    return np.asarray(np.sqrt(nearest))


def _nail(finger: Finger, points_m: Array, normals: Array) -> tuple[Array, Array]:
    """Return the share of nail (N,), and gains (N, 3) of the nail and the fold around it."""
    last, tip = finger.bones_m[2:]
    along = (tip - last) / np.linalg.norm(tip - last)
    begins, ends, half = finger.nail_m
    share = ((points_m - last) @ along - begins) / (ends - begins)
    aside = (points_m - last) @ np.cross(along, finger.back) / half
    round_ = (aside**4 + (2.0 * share / NAIL_END - 1.0) ** 4) ** 0.25
    behind = smoothstep(normals @ finger.back, 0.0, 0.4)
    matted = behind * (1.0 - smoothstep(round_, 0.88, 1.04))
    fold = behind * np.exp(-(((round_ - 1.08) / 0.10) ** 2)) * (share < 0.85)
    moon = (1.0 - smoothstep(share + 0.12 * aside**2, 0.16, 0.30))[:, None] * LUNULA
    edge = smoothstep(share + 0.05 * aside**2, 0.82, 0.90)[:, None] * FREE_EDGE
    return matted, matted[:, None] * (PLATE + moon + edge) + fold[:, None] * FOLD


def _creases(finger: Finger, points_m: Array, normals: Array) -> Array:
    """Return gains (N, 3) of a finger's inner creases, of its wrinkles over the joints, and of its pad."""
    first, second, last, tip = finger.bones_m
    inside, behind = smoothstep(-(normals @ finger.back), 0.0, 0.5), smoothstep(normals @ finger.back, 0.2, 0.6)
    gains = (inside * smoothstep((points_m - last) @ (tip - last) / ((tip - last) ** 2).sum(), 0.1, 0.5))[:, None] * PAD
    joints: list[tuple[Array, Array, Array, tuple[float, ...], tuple[float, ...]]] = [
        (last, tip, last, (0.0,), (-0.0010, 0.0011))
    ]
    if finger.root is not None:
        joints.append((first, second, first + finger.root * (second - first), (0.0,), ()))
        joints.append((second, last, second, (-0.0013, 0.0013), (-0.0025, -0.0004, 0.0018)))
    for start, end, place, creases, wrinkles in joints:
        along = (end - start) / np.linalg.norm(end - start)
        across = (points_m - place) @ np.cross(along, finger.back)
        level = (points_m - place) @ along + 0.0005 * np.sin(across / 0.0021)
        for where in creases:
            gains += (inside * np.exp(-(((level - where) / CREASE_M) ** 2)))[:, None] * CREASE
        for where in wrinkles:
            bowed = level - where * (1.0 - (across / (1.3 * BREADTH_M)) ** 2)  # over a knuckle they open like a lens
            gains += (behind * np.exp(-((bowed / WRINKLE_M) ** 2)))[:, None] * WRINKLE
    return np.asarray(gains)


def _palm(points_m: Array, normals: Array) -> Array:
    """Return gains (N, 3) of the palm's creases."""
    generic = load_generic()
    wrist, index, middle, little = (
        generic.joints_m[generic.joint(f"l_{name}")].astype(np.float64)
        for name in ("wrist", "index1", "middle1", "pinky1")
    )
    facing = np.cross(little - wrist, index - wrist)
    facing /= np.linalg.norm(facing)
    along = middle - wrist - (middle - wrist) @ facing * facing
    length = float(np.linalg.norm(along))
    flat = (points_m - wrist) @ np.stack([np.cross(facing, along / length), along / length]).T
    inside, gains = smoothstep(normals @ facing, 0.1, 0.5), np.zeros((len(points_m), 3))
    for line in LINES:
        knots = np.array(line) * length
        places = CubicSpline(np.arange(len(knots)), knots)(np.linspace(0, len(knots) - 1, 120))
        reach = 4.0 * CREASE_M
        near = np.flatnonzero((inside > 0.0) & _within(flat, places.min(axis=0) - reach, places.max(axis=0) + reach))
        distance, nearest = cKDTree(places).query(flat[near], distance_upper_bound=reach)
        share = np.minimum(nearest, 119) / 119.0
        fading = np.clip(1.6 - 1.2 * share, 0.0, 1.0) * smoothstep(share, 0.0, 0.06)  # lines run out on the palm
        gains[near] += (inside[near] * fading * np.exp(-((distance / CREASE_M) ** 2)))[:, None] * CREASE
    return gains


def _within(points: Array, low: Array, high: Array) -> NDArray[np.bool_]:
    """Return which of (N, 2) points lie in a box."""
    return np.asarray(((points >= low) & (points <= high)).all(axis=1))
