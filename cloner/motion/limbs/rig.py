"""A skeleton with joints in the middle of the person's own limbs.

The fit places joints by net points and outlines; slices then move the skin, and wide sleeves or trousers do not lie
about the joints evenly. The last step before anything moves: elbows, wrists and knees go to the middle of the ring of
skin that bends around them; shoulders and ankles, whose rings would cut chest and heel, lie by the axis of their limb
as they do in the generic human.

References
----------
"Beyond": the paper ends with the fitted skeleton. Middle of a polygon by the areas of its triangles.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.caching import cached_per_object
from cloner.generic.load import GENERIC_STATURE_M, GenericHuman, load_generic
from cloner.geometry.meshes.triangles import edges_of
from cloner.motion.limbs.body import SIDES
from cloner.records.arrays import Array
from cloner.records.clones import Clone

#: A bending joint with the joints before and after it.
RINGED: Final = {
    "elbow": ("shoulder", "elbow", "wrist"),
    "wrist": ("elbow", "wrist", "middle1"),
    "knee": ("hip", "knee", "ankle"),
}
#: A joint at the end of a limb, the limb's ends, and shares of its length at which two rings give its axis: below the
#: armpit, above the heel.
BY_AXIS: Final = {"shoulder": ("shoulder", "elbow", 0.4, 0.65), "ankle": ("knee", "ankle", 0.7, 0.9)}
#: Along its limb only the knee goes with its ring: thighs and calves of the two samples' six sets are then 4 mm off
#: instead of 11, in wide trousers 5 instead of 20. Sleeves slide: with their rings forearms become 5 mm worse.
FOLLOWS_ALONG: Final = ("knee",)
#: A ring lies within this reach of its joint, metres: an arm's or leg's half breadth, not the other limb.
REACH_M: Final = 0.13
#: No joint goes farther than this, metres; taste: half a wide trouser leg.
MOST_M: Final = 0.03


@dataclass(frozen=True, slots=True, eq=False)
class Ring:
    """The section of a limb of the generic human by a plane: points on its edges, in order.

    Attributes
    ----------
    edges : (N, 2) int64, vertices
    share : (N,) float64
        A point lies at ``(1 - share) * first + share * second``.
    """

    edges: NDArray[np.int64]
    share: Array

    def points(self, vertices_m: Array) -> Array:
        """Return (N, 3) points of the ring on a body, metres."""
        first, second = vertices_m[self.edges[:, 0]], vertices_m[self.edges[:, 1]]
        return np.asarray(first + self.share[:, None] * (second - first))


def middle(points_m: Array) -> Array:
    """Return the centroid (3,) of the area that a ring of points (N, 3) encloses, metres."""
    centre = points_m.mean(axis=0)
    after = np.roll(points_m, -1, axis=0)
    faces = np.cross(points_m - centre, after - centre)
    normal = faces.sum(axis=0)
    area = faces @ (normal / np.linalg.norm(normal))
    return np.asarray(((points_m + after + centre) / 3.0 * area[:, None]).sum(axis=0) / area.sum())


def joint_ring(side: str, name: str) -> Ring:
    """Return the ring of skin around a joint of `RINGED`, across the middle of its two bones' directions."""
    generic = load_generic()
    before, own, after = (generic.joints_m[generic.joint(f"{side}_{joint}")] for joint in RINGED[name])
    return _cut(side, tuple(own.tolist()), tuple((_unit(own - before) + _unit(after - own)).tolist()))


def limb_ring(side: str, first: str, last: str, share: float) -> Ring:
    """Return the ring of skin around the limb between two joints at a share of its length."""
    generic = load_generic()
    start, end = (generic.joints_m[generic.joint(f"{side}_{joint}")] for joint in (first, last))
    return _cut(side, tuple((start + share * (end - start)).tolist()), tuple((end - start).tolist()))


@functools.cache
def _cut(side: str, place: tuple[float, ...], across: tuple[float, ...]) -> Ring:
    """Return the ring in which the plane through ``place``, normal to ``across``, cuts the generic human nearby."""
    generic = load_generic()
    vertices = generic.vertices_m.astype(np.float64)
    origin, normal = np.array(place), _unit(np.array(across))
    near = (np.linalg.norm(vertices - origin, axis=1) < REACH_M) & (generic.vertex_part == 0)
    near &= vertices[:, 0] * (1.0 if side == "l" else -1.0) > 0.0
    triangles, _ = generic.triangles()
    edges = edges_of(triangles)[0]
    edges = edges[near[edges].all(axis=1)]
    height = (vertices - origin) @ normal
    first, second = height[edges[:, 0]], height[edges[:, 1]]
    cut = (first > 0.0) != (second > 0.0)
    ring = Ring(edges[cut], first[cut] / (first[cut] - second[cut]))
    points = ring.points(vertices)
    away = points - points.mean(axis=0)
    right = _unit(np.cross(normal, np.eye(3)[np.abs(normal).argmin()]))
    order = np.argsort(np.arctan2(away @ np.cross(normal, right), away @ right))
    return Ring(ring.edges[order], ring.share[order])


def _unit(vector: Array) -> Array:
    return np.asarray(vector / np.linalg.norm(vector))


@cached_per_object
def centre_joints(clone: Clone) -> Clone:
    """Return the clone with shoulders, elbows, wrists, knees and ankles in the middle of its own limbs.

    The rest pose stays as it is; every other joint stays in its place.
    """
    generic = load_generic()
    joints = clone.joints_m.copy()
    for side in SIDES:
        for name in (*BY_AXIS, *RINGED, *RINGED):  # twice: what is across a limb changes with its other joints
            joint = generic.joint(f"{side}_{name}")
            find = _to_axis if name in BY_AXIS else _to_ring
            shift = joints[joint] + find(generic, replace(clone, joints_m=joints), side, name) - clone.joints_m[joint]
            far = float(np.linalg.norm(shift))
            joints[joint] = clone.joints_m[joint] + shift * min(1.0, MOST_M / max(far, 1e-9))
    return replace(clone, joints_m=joints)


def _to_ring(generic: GenericHuman, clone: Clone, side: str, name: str) -> Array:
    """Return the vector (3,) from a joint to its ring's centroid, metres; across the limb only where sleeves slide."""
    before, own, after = (clone.joints_m[generic.joint(f"{side}_{joint}")] for joint in RINGED[name])
    away = middle(joint_ring(side, name).points(clone.vertices_m)) - own
    along = _unit(_unit(own - before) + _unit(after - own))
    return np.asarray(away if name in FOLLOWS_ALONG else away - away @ along * along)


def _to_axis(generic: GenericHuman, clone: Clone, side: str, name: str) -> Array:
    """Return the vector (3,) from a joint to its position beside the limb's axis in the generic human, metres."""
    joint = generic.joint(f"{side}_{name}")
    usual = _off_axis(generic.vertices_m.astype(np.float64), generic.joints_m[joint].astype(np.float64), side, name)
    own = _off_axis(clone.vertices_m, clone.joints_m[joint], side, name)
    return np.asarray(own - usual * (clone.stature_m / GENERIC_STATURE_M))


def _off_axis(vertices_m: Array, joint_m: Array, side: str, name: str) -> Array:
    """Return the vector (3,) from a joint perpendicular to its limb's axis, metres."""
    first, last, *shares = BY_AXIS[name]
    upper, lower = (middle(limb_ring(side, first, last, float(share)).points(vertices_m)) for share in shares)
    along = _unit(lower - upper)
    away = upper - joint_m
    return np.asarray(away - away @ along * along)
