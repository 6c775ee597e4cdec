"""Loose garments for random people: skirts, open coats and shoulder bags around a naked body in its rest pose.

Each garment is a surface of its own that hangs clear of the legs. It is carried
by the pelvis and both thighs, as cloth is, and not by the nearest skin.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

import numpy as np
import trimesh
from numpy.typing import NDArray
from scipy.sparse import coo_matrix, csr_matrix
from scipy.spatial import ConvexHull

from cloner.easing import smoothstep
from cloner.generic.load import GenericHuman
from cloner.geometry.articulation.skinning import blend_transforms, joint_transforms
from cloner.geometry.charts.tubes import convex_hull_radii, ring_angles, tube_mesh, tube_points

Array = NDArray[np.float64]
Kind = Literal["short skirt", "long skirt", "coat", "bag"]

COLUMNS, RINGS = 144, 72
EASE_M: Final = 0.006
#: Share of hip to ankle where each garment ends.
HEM: Final = {"short skirt": (0.30, 0.50), "long skirt": (0.68, 0.92), "coat": (0.40, 0.70)}
#: How far a garment widens, metres a metre of length, on every side.
FLARE: Final = {"short skirt": (0.15, 0.50), "long skirt": (0.10, 0.35), "coat": (0.06, 0.18)}
#: Half of a coat's opening in front, degrees.
OPENING_DEG: Final = (12.0, 28.0)


@dataclass(frozen=True, slots=True, eq=False)
class Garment:
    """A surface around a naked body at rest.

    Attributes
    ----------
    kind : str
    vertices_m : (N, 3) float64
    triangles : (T, 3) int64
    colours : (N, 3) float64, sRGB 0..1
    carry : (N, V) sparse
        Shares of the coarse body vertices whose motion each vertex follows.
    hem : float
        Where it ends, share of hip to ankle.
    """

    kind: Kind
    vertices_m: Array
    triangles: NDArray[np.int64]
    colours: Array
    carry: csr_matrix
    hem: float


def make_garment(
    generic: GenericHuman,
    vertices_m: Array,
    joints_m: Array,
    kind: Kind,
    rng: np.random.Generator,
    *,
    ease_m: float = EASE_M,
) -> Garment:
    """Return a random garment for a naked body in rest pose; ``ease_m`` is what it needs for clothes below it."""
    if kind == "bag":
        return _bag(generic, vertices_m, joints_m, rng)
    hem = float(rng.uniform(*HEM[kind]))
    flare, folds = rng.uniform(*FLARE[kind]), rng.uniform(0.0, 0.014)
    hip, ankle = (float(joints_m[generic.joint(name), 1]) for name in ("l_hip", "l_ankle"))
    waist = float(vertices_m[generic.feature("waist_front"), 1])
    top = float(joints_m[generic.joint("vt3"), 1]) if kind == "coat" else waist - rng.uniform(0.0, 0.04)
    heights = np.linspace(top, hip + hem * (ankle - hip), RINGS)
    centres, radii = body_rings(generic, vertices_m, heights)
    radii = radii + ease_m + (0.0 if kind != "coat" else 0.012)
    drop = (heights[0] - heights[-1]) / (RINGS - 1)
    below = heights < (hip + 0.05 if kind != "coat" else waist)
    for k in range(1, RINGS):
        if below[k]:  # cloth hangs: it never turns in again
            radii[k] = np.maximum(radii[k], radii[k - 1] + flare * drop)
    share = np.clip((heights[0] - heights) / (heights[0] - heights[-1]), 0.0, 1.0)[:, None]
    angles = ring_angles(COLUMNS)
    waves = np.cos(rng.integers(9, 16) * angles + rng.uniform(0, 6.3)) + 0.5 * np.cos(23 * angles + rng.uniform(0, 6.3))
    radii = radii + folds * share**1.5 * (1.0 + waves)
    tube = tube_mesh(tube_points(centres, np.repeat(heights[:, None], COLUMNS, 1), radii), 1024)
    triangles = tube.triangles.astype(np.int64)
    if kind == "coat":
        half = np.radians(rng.uniform(*OPENING_DEG))
        shut = np.abs(angles[tube.column]) > half
        triangles = triangles[shut[triangles].all(axis=1)]
    colours = _cloth(tube.vertices_m, angles[tube.column], rng)
    carry = hanging(generic, vertices_m, joints_m, tube.vertices_m)
    return Garment(kind, tube.vertices_m, triangles, colours, carry, hem)


def body_rings(generic: GenericHuman, vertices_m: Array, heights_m: Array) -> tuple[Array, Array]:
    """Return the axis (K, 2) and the (K, COLUMNS) radii of the hull of trunk and legs at each height, metres."""
    names = ("torso", "pelvis", "left_thigh", "right_thigh", "left_calf", "right_calf")
    rows = np.isin(generic.vertex_segment, [generic.segment_names.index(name) for name in names])
    points = vertices_m[rows & (generic.vertex_part == 0)]
    angles = ring_angles(COLUMNS)
    centres, radii = np.zeros((len(heights_m), 2)), np.zeros((len(heights_m), len(angles)))
    for k, height in enumerate(heights_m):
        away = np.abs(points[:, 1] - height)
        near = points[away < max(0.015, np.partition(away, 24)[24])][:, [0, 2]]
        centres[k] = (near.min(axis=0) + near.max(axis=0)) / 2.0
        radii[k] = convex_hull_radii(near, centres[k], angles)
    return centres, radii


def hanging(generic: GenericHuman, vertices_m: Array, joints_m: Array, points_m: Array) -> csr_matrix:
    """Return (N, V) shares: pelvis above the hips, below them more and more the thighs, left and right blended."""
    weights = np.zeros((len(vertices_m), len(joints_m)))
    np.put_along_axis(weights, generic.skin_joints.astype(int), generic.skin_weights.astype(float), axis=1)
    sure = {
        name: int(np.argmax(weights[:, generic.joint(name)] - 0.01 * np.abs(vertices_m[:, 0])))
        for name in ("l_hip", "r_hip", "sacroiliac", "vl5", "vt6")
    }
    hip, waist = (float(joints_m[generic.joint(name), 1]) for name in ("l_hip", "vl3"))
    chest = float(joints_m[generic.joint("vt6"), 1])
    legs = 0.92 * smoothstep((hip + 0.06 - points_m[:, 1]) / 0.28)
    left = smoothstep(0.5 + points_m[:, 0] / 0.24)
    trunk = smoothstep((points_m[:, 1] - hip) / (waist - hip))
    upper = smoothstep((points_m[:, 1] - waist) / (chest - waist))
    shares = {
        "l_hip": legs * left,
        "r_hip": legs * (1.0 - left),
        "sacroiliac": (1.0 - legs) * (1.0 - trunk),
        "vl5": (1.0 - legs) * trunk * (1.0 - upper),
        "vt6": (1.0 - legs) * trunk * upper,
    }
    rows = np.tile(np.arange(len(points_m)), len(shares))
    columns = np.concatenate([np.full(len(points_m), sure[name]) for name in shares])
    table = coo_matrix((np.concatenate(list(shares.values())), (rows, columns)), (len(points_m), len(vertices_m)))
    return csr_matrix(table)


def posed_garment(generic: GenericHuman, joints_m: Array, garment: Garment, rotations: Array) -> Array:
    """Return the (N, 3) vertices of a garment whose wearer poses."""
    transforms = joint_transforms(joints_m, generic.joint_parents.astype(np.int32), rotations)
    skin = blend_transforms(transforms, generic.skin_joints, generic.skin_weights.astype(np.float64))
    blended = (garment.carry @ skin.reshape(len(skin), 12)).reshape(-1, 3, 4)
    return np.asarray(np.einsum("vab,vb->va", blended[..., :3], garment.vertices_m) + blended[..., 3])


def _bag(generic: GenericHuman, vertices_m: Array, joints_m: Array, rng: np.random.Generator) -> Garment:
    """Return a bag at one hip and the strap over the other shoulder."""
    side = 1.0 if rng.random() < 0.5 else -1.0
    hip = joints_m[generic.joint("l_hip"), 1]
    size = np.array([rng.uniform(0.08, 0.13), rng.uniform(0.22, 0.32), rng.uniform(0.26, 0.36)])
    middle = hip - rng.uniform(-0.02, 0.06)
    _, radii = body_rings(generic, vertices_m, np.linspace(middle - size[1] / 2, middle + size[1] / 2, 7))
    angles = ring_angles(COLUMNS)
    reach = float(radii[:, np.abs(np.sin(angles) * side - 1.0) < 0.05].max()) + 0.012
    box = trimesh.creation.box(extents=size).subdivide().subdivide().subdivide().subdivide()
    box.apply_translation([side * (reach + size[0] / 2), middle, 0.0])
    vertices, triangles = np.asarray(box.vertices), np.asarray(box.faces, np.int64)
    strap = _strap(generic, vertices_m, joints_m, side, np.array([side * (reach + 0.01), middle + size[1] / 2, 0.0]))
    colour = np.clip(rng.uniform(0.1, 0.7) + rng.normal(0, 0.1, 3), 0.02, 0.95)
    everything = np.vstack([vertices, strap[0]])
    faces = np.vstack([triangles, strap[1] + len(vertices)])
    colours = np.tile(colour, (len(everything), 1)) * np.where(np.abs(vertices_y(everything, middle)) < 0.01, 0.6, 1.0)
    carry = hanging(generic, vertices_m, joints_m, np.vstack([vertices * [1, 0, 1] + [0, hip + 0.06, 0], strap[0]]))
    return Garment("bag", everything, faces, colours, carry, 0.0)


def vertices_y(points_m: Array, height_m: float) -> Array:
    """Return (N, 1) heights above a level: a seam is painted there."""
    return np.asarray(points_m[:, 1:2] - height_m)


def _strap(
    generic: GenericHuman, vertices_m: Array, joints_m: Array, side: float, low_m: Array
) -> tuple[Array, NDArray[np.int64]]:
    """Return a ribbon around the trunk's slanting section, from the bag to the other shoulder."""
    shoulder = joints_m[generic.joint("r_sternoclavicular" if side > 0 else "l_sternoclavicular")]
    far = np.array([-side * 0.07, shoulder[1] + 0.10, shoulder[2] - 0.02])
    along = (far - low_m) / np.linalg.norm(far - low_m)
    normal = np.cross(along, [0.0, 0.0, 1.0])
    rows = np.isin(generic.vertex_segment, [generic.segment_names.index(name) for name in ("torso", "pelvis")])
    near = vertices_m[rows & (np.abs((vertices_m - low_m) @ normal) < 0.02)]
    flat = np.column_stack([(near - low_m) @ along, near[:, 2] - low_m[2]])
    flat = np.vstack([flat, [[0.0, 0.0]]])
    loop = flat[ConvexHull(flat).vertices]
    loop = loop + 0.006 * (loop - loop.mean(axis=0)) / np.linalg.norm(loop - loop.mean(axis=0), axis=1, keepdims=True)
    centre = low_m + loop[:, :1] * along + loop[:, 1:] * [0.0, 0.0, 1.0]
    vertices = np.vstack([centre - 0.018 * normal, centre + 0.018 * normal])
    count = len(loop)
    first = np.arange(count)
    after = (first + 1) % count
    triangles = np.vstack(
        [np.stack([first, after, first + count], 1), np.stack([after, after + count, first + count], 1)]
    )
    return vertices, triangles.astype(np.int64)


def _cloth(points_m: Array, angles: Array, rng: np.random.Generator) -> Array:
    """Return (N, 3) colours: plain with a border at the hem, or striped, or in checks."""
    base = np.clip(rng.uniform(0.1, 0.85) + rng.normal(0.0, 0.15, 3), 0.03, 0.97)
    other = np.clip(base + rng.choice([-1.0, 1.0]) * rng.uniform(0.15, 0.35), 0.03, 0.97)
    width = rng.uniform(0.03, 0.07)
    rows, columns = np.sin(points_m[:, 1] / width * np.pi) > 0.3, np.sin(angles * rng.integers(12, 24)) > 0.0
    border = points_m[:, 1] < points_m[:, 1].min() + 0.04
    chosen = {"plain": border, "stripes": rows, "checks": rows ^ columns}[
        str(rng.choice(["plain", "stripes", "checks"]))
    ]
    shade = 1.0 + 0.05 * np.cos(13 * angles)
    return np.clip(np.where(chosen[:, None], other, base) * shade[:, None], 0.0, 1.0)
