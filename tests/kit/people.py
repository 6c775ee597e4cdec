"""Known bodies: random members of the generic family, and people from outside it."""

from dataclasses import dataclass

import numpy as np
import trimesh

from cloner.generic.load import load_generic
from cloner.geometry.articulation.poses import SIGMAS, pose_matrix, standing_pose
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning

SOLE_M = 0.022
HAIR_M = 0.012
_FRONT = (
    "neck_base", "shoulder_end", "armpit", "waist", "hip",
    *(f"{joint}_{side}" for joint in ("elbow", "wrist", "knee", "ankle") for side in ("outer", "inner")),
)  # fmt: skip
_SIDE = ("neck_front", "neck_back", "chest_front", "back", "belly_front", "waist_back")
_SIDE_PAIRED = (
    "buttock", "thigh_front", "thigh_back", "knee_front", "knee_back", "ankle_front", "ankle_back", "toe", "heel",
)  # fmt: skip
_JOINTS = tuple(f"{s}_{name}" for name in ("shoulder", "elbow", "wrist", "hip", "knee", "ankle") for s in "lr")


@dataclass(frozen=True)
class KnownPerson:
    """A member of the generic family whose every length is known.

    ``vertices_m`` and ``joints_m`` are the rest pose with naked soles on y = 0.
    """

    name: str
    stature_m: float
    coefficients: np.ndarray
    vertices_m: np.ndarray
    joints_m: np.ndarray

    def posed(self, rotations):
        """Return vertices and joints under (94, 3) joint rotations."""
        generic = load_generic()
        moved = joint_transforms(self.joints_m, generic.joint_parents, rotations)
        vertices = linear_blend_skinning(self.vertices_m, moved, generic.skin_joints, generic.skin_weights)
        return vertices, np.einsum("jab,jb->ja", moved[:, :3, :3], self.joints_m) + moved[:, :3, 3]


def known_person(seed, *, stature_m=1.70, spread=1.0, coefficients=12):
    """Return a random member of the generic family."""
    generic = load_generic()
    values = np.random.default_rng(seed).normal(scale=spread, size=coefficients)
    vertices, joints = generic.shape(values, stature_m)
    return KnownPerson(f"person {seed}", stature_m, values, np.asarray(vertices), np.asarray(joints))


def known_pose(seed, *, spread=0.25):
    """Return (94, 3) rotations of a person who stands with arms a little apart."""
    generic = load_generic()
    pose = standing_pose(generic.joint_names, np.asarray(generic.joints_m, dtype=np.float64))
    pose = pose + spread * SIGMAS * np.random.default_rng(seed).normal(size=len(SIGMAS))
    return (pose_matrix(generic.joint_names) @ pose).reshape(-1, 3)


def skin_triangles():
    """Return the (T, 3) triangles of the generic human's skin."""
    generic = load_generic()
    triangles, _ = generic.triangles()
    body = generic.vertex_part == generic.part_names.index("body")
    return triangles[body[triangles].all(axis=1)]


def with_shoes_and_hair(vertices_m):
    """Return vertices and triangles of the posed body with soles below and hair above, as photos show people."""
    generic = load_generic()
    triangles = skin_triangles()
    meshes = [(vertices_m, triangles)]
    for side in ("left", "right"):
        foot = vertices_m[generic.vertex_segment == generic.segment_names.index(f"{side}_foot")]
        low = foot[foot[:, 1] < foot[:, 1].min() + 0.05]
        meshes.append(_hull(np.vstack([low, low - [0.0, SOLE_M, 0.0]])))
    head = vertices_m[generic.vertex_segment == generic.segment_names.index("head")]
    top = head[head[:, 1] > head[:, 1].max() - 0.06]
    meshes.append(_hull(np.vstack([top, top + [0.0, HAIR_M, 0.0]])))
    starts = np.cumsum([0, *(len(points) for points, _ in meshes)])
    return (
        np.vstack([points for points, _ in meshes]),
        np.vstack([rows + start for (_, rows), start in zip(meshes, starts[:-1], strict=True)]),
    )


def _hull(points):
    hull = trimesh.convex.convex_hull(points)
    return np.asarray(hull.vertices), np.asarray(hull.faces)


def point_names(view):
    """Return the names of the feature points that the body stages take in a view."""
    if view == "body_side":
        return (*_SIDE, *(f"{name}_right" for name in _SIDE_PAIRED))
    return ("crotch", *(f"{name}_{side}" for name in _FRONT for side in ("left", "right")))


def exact_points(vertices_m, joints_m, view, seen_by):
    """Return name -> (2,) pixels of joints and features, without head top and soles."""
    generic = load_generic()
    names = [name for name in point_names(view) if name in generic.feature_names]
    pixels = seen_by.project(np.array([vertices_m[generic.feature(name)] for name in names]))
    joints = seen_by.project(np.array([joints_m[generic.joint(name)] for name in _JOINTS]))
    return dict(zip((*names, *_JOINTS), np.vstack([pixels, joints]), strict=True))
