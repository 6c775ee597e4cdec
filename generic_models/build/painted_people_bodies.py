"""Random people: naked bodies of the generic family, a little outside it, and the poses they stand in."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from cloner.generic.load import GenericHuman
from cloner.generic.tape import load_tape_rules
from cloner.geometry.articulation.poses import FREEDOMS, pose_matrix, standing_pose
from cloner.geometry.articulation.skinning import joint_transforms
from cloner.geometry.measurement.measures import girths_mm
from cloner.geometry.outlines.silhouette import vertex_normals

Array = NDArray[np.float64]

#: Statures of women and men: mean and spread, metres; wider than a population's, so that rare ones are met.
STATURES_M: Final = ((1.64, 0.085), (1.76, 0.085))
STATURE_LIMITS_M: Final = (1.45, 1.95)
#: Root mean square of the smooth bumps that no shape coefficient can make, metres.
BUMPS_M: Final = 0.0025
#: Spread of the face's coefficients: a little under the population's, so that the face net still finds it.
FACE_SPREAD: Final = 0.7
#: Greatest jitter of every freedom about the standing pose, degrees (issue 4: limbs +-8); 3 where not named.
JITTER_DEG: Final = {
    "shoulder_x": 8.0, "shoulder_y": 5.0, "shoulder_z": 8.0, "clavicle_raise": 3.0,
    "elbow_x": 8.0, "elbow_y": 5.0, "elbow_z": 8.0, "wrist_x": 8.0, "wrist_y": 8.0, "wrist_z": 8.0,
    "hip_x": 2.5, "hip_y": 5.0, "hip_z": 5.0, "knee_bend": 4.0, "neck_x": 6.0, "neck_y": 6.0, "neck_z": 4.0,
}  # fmt: skip
#: Jitter of joints that the clone's poses cannot turn, degrees.
STRANGE_DEG: Final = 0.7


@dataclass(frozen=True, slots=True, eq=False)
class RandomBody:
    """A naked person in the generic's rest pose, soles on y = 0; metres, model frame.

    Attributes
    ----------
    stature_m : float
    coefficients : (C,) float64
        All shape coefficients of the generic family; the bumps are on top.
    vertices_m : (V, 3) float64
    joints_m : (94, 3) float64
    phenotype : mapping of str to float
        Named phenotype by the generic's regression.
    """

    stature_m: float
    coefficients: Array
    vertices_m: Array
    joints_m: Array
    phenotype: Mapping[str, float]


def random_body(generic: GenericHuman, rng: np.random.Generator) -> RandomBody:
    """Return a random naked person; stature, shape, face and bumps are independent draws."""
    coefficients = rng.normal(size=len(generic.shape_basis))
    guess = generic.phenotype_mean + generic.phenotype_from_shape @ coefficients
    phenotype = {name: float(value) for name, value in zip(generic.phenotype_names, guess, strict=True)}
    middle, spread = STATURES_M[int(phenotype["sex"] > 0.5)]
    stature = float(np.clip(rng.normal(middle, spread), *STATURE_LIMITS_M))
    vertices, joints = generic.shape(coefficients, stature)
    if len(generic.face_basis):
        face = np.tensordot(FACE_SPREAD * rng.normal(size=len(generic.face_basis)), generic.face_basis, axes=1)
        vertices[generic.head_vertices] += face
    vertices = vertices + bumps(generic, vertices, rng)
    # the face's own shape moves the skull's top by up to 10 mm, and what the visitor tells must be true
    scale = stature / float(vertices[generic.part("body"), 1].max())
    vertices, joints = scale * vertices, scale * joints
    return RandomBody(stature, coefficients, vertices, joints, phenotype)


def naked_girths_mm(body: RandomBody) -> dict[str, float]:
    """Return the naked girths in the rest pose, as the product's tape lies."""
    return girths_mm(body.vertices_m, body.joints_m, load_tape_rules())


def bumps(generic: GenericHuman, vertices_m: Array, rng: np.random.Generator) -> Array:
    """Return (V, 3) smooth displacements along the normals, none on head, hands and feet; metres."""
    triangles, _ = generic.triangles()
    body = np.where(generic.vertex_part == generic.part_names.index("body"), 1.0, 0.0)
    for name in ("head", "left_hand", "right_hand", "left_foot", "right_foot"):
        body -= generic.segment_weights[:, generic.segment_names.index(name)]
    height = BUMPS_M * waves(vertices_m, (0.12, 0.40), 24, rng)
    return np.asarray((np.clip(body, 0.0, 1.0) * height)[:, None] * vertex_normals(vertices_m, triangles))


def waves(points_m: Array, lengths_m: tuple[float, float], count: int, rng: np.random.Generator) -> Array:
    """Return (N,) smooth noise of unit variance at (N, 3) points: waves of random direction, length and phase."""
    direction = rng.normal(size=(count, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    length = np.exp(rng.uniform(np.log(lengths_m[0]), np.log(lengths_m[1]), size=count))
    phase = rng.uniform(0.0, 2.0 * np.pi, size=count)
    turns = (2.0 * np.pi * direction / length[:, None]).T.astype(np.float32)
    angles = np.asarray(points_m, dtype=np.float32) @ turns + phase.astype(np.float32)  # noise needs no precision
    return np.asarray(np.sqrt(2.0 / count) * np.cos(angles).sum(axis=1), dtype=np.float64)


def random_rotations(generic: GenericHuman, joints_m: Array, rng: np.random.Generator) -> Array:
    """Return (94, 3) rotation vectors of a person who stands with arms apart and both feet flat on one floor."""
    pose = standing_pose(generic.joint_names, joints_m)
    reach = np.radians(
        [JITTER_DEG.get(freedom.name.removeprefix("l_").removeprefix("r_"), 3.0) for freedom in FREEDOMS]
    )
    pose = pose + rng.uniform(-1.0, 1.0, len(reach)) * reach
    for place, freedom in enumerate(FREEDOMS):
        if freedom.name.endswith("knee_bend"):
            pose[place] = abs(pose[place])  # knees do not bend forwards
    rotations = (pose_matrix(generic.joint_names) @ pose).reshape(-1, 3)
    spine = [row for row, name in enumerate(generic.joint_names) if name[:2] in ("vl", "vt", "vc")]
    rotations[spine] += np.radians(STRANGE_DEG) * rng.normal(size=(len(spine), 3))
    toes_deg = rng.uniform(0.0, 12.0, 2)
    return _both_feet_down(generic, joints_m, rotations, {"l": toes_deg[0], "r": -toes_deg[1]})


def posed_joints(generic: GenericHuman, joints_m: Array, rotations: Array) -> tuple[Array, Array]:
    """Return (94, 4, 4) posed-from-rest transforms and the (94, 3) posed joints."""
    transforms = joint_transforms(joints_m, generic.joint_parents.astype(np.int32), rotations)
    return transforms, np.einsum("jab,jb->ja", transforms[:, :3, :3], joints_m) + transforms[:, :3, 3]


def _both_feet_down(generic: GenericHuman, joints_m: Array, rotations: Array, toes_deg: Mapping[str, float]) -> Array:
    """Return the rotations with the longer leg's knee bent until both ankles are level, and both feet flat."""
    rotations = _feet_flat(generic, joints_m, rotations, toes_deg)
    drop = _ankle_heights(generic, joints_m, rotations)
    low = "l" if drop["l"] < drop["r"] else "r"
    hip, knee = generic.joint(f"{low}_hip"), generic.joint(f"{low}_knee")
    least, most = 0.0, np.radians(50.0)
    for _ in range(20):
        bend = (least + most) / 2.0
        trial = rotations.copy()
        trial[hip, 0] -= bend / 2.0
        trial[knee, 0] += bend
        heights = _ankle_heights(generic, joints_m, trial)
        lifted = heights[low] >= heights["r" if low == "l" else "l"]
        least, most = (least, bend) if lifted else (bend, most)
    return _feet_flat(generic, joints_m, trial, toes_deg)


def _ankle_heights(generic: GenericHuman, joints_m: Array, rotations: Array) -> dict[str, float]:
    _, posed = posed_joints(generic, joints_m, rotations)
    # naked ankles differ a little in height: what must be level is the floor below them
    return {side: float(posed[row, 1] - joints_m[row, 1]) for side in "lr" for row in [generic.joint(f"{side}_ankle")]}


def _feet_flat(generic: GenericHuman, joints_m: Array, rotations: Array, toes_deg: Mapping[str, float]) -> Array:
    """Return the rotations with ankles that undo what the legs did, but for toes that point out."""
    transforms, _ = posed_joints(generic, joints_m, rotations)
    flat = rotations.copy()
    for side, degrees in toes_deg.items():
        ankle = generic.joint(f"{side}_ankle")
        leg = Rotation.from_matrix(transforms[generic.joint_parents[ankle], :3, :3])
        flat[ankle] = (leg.inv() * Rotation.from_euler("y", degrees, degrees=True)).as_rotvec()
    return flat
