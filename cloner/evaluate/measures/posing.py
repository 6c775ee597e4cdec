"""A clone brought into the truth's pose and frame: rotations and a rigid motion, never a scale."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares
from scipy.spatial import cKDTree

from cloner.evaluate.measures.rulers import fit_similarity, transform_points
from cloner.generic.load import GenericHuman
from cloner.geometry.articulation.poses import SIGMAS, pose_matrix
from cloner.geometry.articulation.skinning import (
    blend_transforms,
    joint_transforms,
    linear_blend_skinning,
    posed_joints,
    rotation_matrices,
)
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.views import Camera

#: The truth's joint names and ours; rig centres both.
JOINTS: Final = {
    f"{name}_{side}": f"{side.lower()}_{name}"
    for name in ("shoulder", "elbow", "wrist", "hip", "knee", "ankle")
    for side in "LR"
}
#: Feature points of the face that must lie where the truth's do (rulers).
LANDMARKS: Final = (
    *("nasion", "nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom", "chin_front", "chin_bottom"),
    *(f"{name}_{side}" for name in ("eye_inner", "eye_outer", "ala", "mouth_corner") for side in "LR"),
    *(f"{name}_{side}" for name in ("ear_top", "ear_lobe") for side in "LR"),
)
#: Surface points of the trunk and head that steady the joints when a whole body is laid on the truth.
BODY_MARKS: Final = (
    *(f"{name}_{side}" for name in ("acromion", "neck_base") for side in "LR"),
    *("crotch", "nape", "vertex_top", "chin_bottom"),
)
_SIDES: Final = ("left", "right")
#: How far a joint of another skeleton may lie from ours and still agree, metres; taste.
_JOINT_SIGMA_M: Final = 0.01
#: The same for a mark of trunk or head on the skin. Joints alone leave the spine free: measured on random people, a
#: lean of the trunk against head and legs cost up to 5 mm of surface and 0.06 of the held-out silhouette.
_MARK_SIGMA_M: Final = 0.015
#: The same for a face landmark about the middle of all; they only tell where the head looks.
_LANDMARK_SIGMA_M: Final = 0.03
#: How far the directions of hands and feet may differ, radians; taste.
_TIP_SIGMA: Final = 0.05
#: The truth's pose may be far from rest, so the prior only keeps unseen twists still; taste.
_PRIOR_WEIGHT: Final = 0.1


@dataclass(frozen=True, slots=True, eq=False)
class PosedClone:
    """A clone after skinning and a rigid motion; any frame, metres."""

    vertices_m: Array
    joints_m: Array
    features_m: Mapping[str, Array]

    def moved(self, transform: Array) -> PosedClone:
        """Return the same body moved by a (4, 4) rigid transform."""
        return PosedClone(
            transform_points(transform, self.vertices_m),
            transform_points(transform, self.joints_m),
            {name: transform_points(transform, point[None])[0] for name, point in self.features_m.items()},
        )


def pose_clone(clone: Clone, generic: GenericHuman, rotations: Array) -> PosedClone:
    """Return the clone's skin, joints and feature points under joint rotations.

    Parameters
    ----------
    clone : Clone
    generic : GenericHuman
    rotations : (94, 3) float64, rotation vectors in model axes, radians
    """
    transforms = joint_transforms(clone.joints_m, _parents(generic), rotations)
    skin_joints, skin_weights = generic.skin_joints.astype(np.int32), generic.skin_weights.astype(np.float64)
    vertices = linear_blend_skinning(clone.vertices_m, transforms, skin_joints, skin_weights)
    joints = posed_joints(transforms, clone.joints_m)
    names = list(clone.features_m)
    if not names:
        return PosedClone(vertices, joints, {})
    rest = np.array([clone.features_m[name] for name in names])
    _, near = cKDTree(clone.vertices_m).query(rest)
    blended = blend_transforms(transforms, skin_joints[near], skin_weights[near])
    features = np.einsum("nab,nb->na", blended[:, :, :3], rest) + blended[:, :, 3]
    return PosedClone(vertices, joints, dict(zip(names, features, strict=True)))


def _parents(generic: GenericHuman) -> NDArray[np.int32]:
    return generic.joint_parents.astype(np.int32)


def joints_by_truth_name(posed: PosedClone, generic: GenericHuman) -> dict[str, Array]:
    """Return the main joints of a posed clone under the truth's names."""
    return {name: posed.joints_m[generic.joint(ours)] for name, ours in JOINTS.items()}


def truth_from_points(found: Mapping[str, Array], truth: Mapping[str, Array]) -> Array:
    """Return the rigid (4, 4) motion that lays common named points on the truth's.

    Raises
    ------
    ValueError
        If fewer than three names are common.
    """
    names = [name for name in found if name in truth]
    if len(names) < 3:
        raise ValueError(f"only {len(names)} common points: {names}")
    source = np.array([found[name] for name in names])
    return fit_similarity(source, np.array([truth[name] for name in names]), scale=False)


def truth_from_body(
    posed: PosedClone, generic: GenericHuman, joints: Mapping[str, Array], marks: Mapping[str, Array]
) -> Array:
    """Return the rigid (4, 4) motion that lays a posed body on the truth's joints and trunk marks."""
    found = {**joints_by_truth_name(posed, generic), **_only(BODY_MARKS, posed.features_m)}
    return truth_from_points(found, {**joints, **_only(BODY_MARKS, marks)})


def pose_like_truth(
    clone: Clone, generic: GenericHuman, joints_m: Mapping[str, Array], marks_m: Mapping[str, Array], start: Array
) -> tuple[PosedClone, Array, Array]:
    """Return a clone in a truth's pose, aligned by its joints without scaling; that pose, and the (4, 4) rigid motion.

    ``start`` (94, 3) is the pose from which the truth's is sought.
    """
    rotations = fit_rotations(clone, generic, joints_m, marks_m, start)
    posed = pose_clone(clone, generic, rotations)
    truth_from_clone = truth_from_body(posed, generic, joints_m, marks_m)
    return posed.moved(truth_from_clone), rotations, truth_from_clone


def _only(names: tuple[str, ...], points: Mapping[str, Array]) -> dict[str, Array]:
    return {name: points[name] for name in names if name in points}


def landmarks(points: Mapping[str, Array]) -> dict[str, Array]:
    """Return the face landmarks among named points."""
    return _only(LANDMARKS, points)


def fit_rotations(
    clone: Clone,
    generic: GenericHuman,
    truth_joints: Mapping[str, Array],
    truth_marks: Mapping[str, Array],
    start: Array,
) -> Array:
    """Return the rotations (94, 3) whose joints, moved rigidly, are closest to the truth's.

    Parameters
    ----------
    clone : Clone
    generic : GenericHuman
    truth_joints, truth_marks : mapping of str to (3,) float64, truth frame, metres
        Limbs follow the joints, the spine the marks of trunk and head; the face's
        marks count only for where the head looks.
    start : (94, 3) float64
        Rotations to begin from, for example the pose of the front photo.
    """
    spread = pose_matrix(generic.joint_names)
    rows, skull = [generic.joint(JOINTS[name]) for name in JOINTS], generic.joint("skullbase")
    parents, rest = _parents(generic), clone.joints_m
    marks = [name for name in landmarks(clone.features_m) if name in truth_marks]
    face = _centred(np.array([clone.features_m[name] for name in marks]).reshape(-1, 3))
    face_goal = _centred(np.array([truth_marks[name] for name in marks]).reshape(-1, 3))
    tips = [*_feet(clone, generic, truth_marks), *_hands(clone, generic, truth_joints, truth_marks)]
    trunk, on_skin = _trunk(clone, generic, truth_marks)
    goal = np.array([*(truth_joints[name] for name in JOINTS), *(truth_marks[name] for name in trunk)])
    sigma = np.repeat([_JOINT_SIGMA_M, _MARK_SIGMA_M], [len(rows), len(trunk)])[:, None]

    def rotations(pose: Array) -> Array:
        return np.asarray(start + (spread @ pose).reshape(-1, 3))

    def residual(values: Array) -> Array:
        transforms = joint_transforms(rest, parents, rotations(values[6:]))
        limbs = transforms[rows]
        joints = posed_joints(limbs, rest[rows])
        turn = rotation_matrices(values[None, :3])[0].T
        found = np.vstack([joints, on_skin(transforms)]) - joints.mean(axis=0)
        away = (found @ turn + values[3:6] - goal) / sigma
        looking = (face @ transforms[skull, :3, :3].T @ turn - face_goal) / _LANDMARK_SIGMA_M
        pointing = [(turn.T @ transforms[joint, :3, :3] @ own - goal) / _TIP_SIGMA for joint, own, goal in tips]
        return np.concatenate([away.ravel(), looking.ravel(), *pointing, _PRIOR_WEIGHT * values[6:] / SIGMAS])

    first = np.concatenate([np.zeros(3), goal[: len(rows)].mean(axis=0), np.zeros(len(SIGMAS))])
    best = least_squares(residual, first, method="trf", max_nfev=25)
    return rotations(best.x[6:])


def _trunk(
    clone: Clone, generic: GenericHuman, truth_marks: Mapping[str, Array]
) -> tuple[list[str], Callable[[Array], Array]]:
    """Return the common marks of trunk and head, and their places on the skin under joint transforms."""
    names = [name for name in _only(BODY_MARKS, clone.features_m) if name in truth_marks]
    rest = np.array([clone.features_m[name] for name in names]).reshape(-1, 3)
    vertices = np.array([generic.feature(name) for name in names], dtype=np.int64)
    joints, weights = generic.skin_joints[vertices].astype(np.int32), generic.skin_weights[vertices].astype(np.float64)
    return names, lambda transforms: linear_blend_skinning(rest, transforms, joints, weights)


def hand_vertices(generic: GenericHuman) -> dict[str, int]:
    """Return the vertices whose places tell how a hand is turned, by the truth's names: knuckles."""
    marks = {}
    for side in "LR":
        for finger in ("index", "pinky"):
            joint = generic.joints_m[generic.joint(f"{side.lower()}_{finger}1")]
            away = np.linalg.norm(generic.vertices_m - joint, axis=1)
            marks[f"knuckle_{finger}_{side}"] = int(away.argmin())
    return marks


def turning_marks(generic: GenericHuman, body_m: Array) -> dict[str, Array]:
    """Return the marks (3,) that tell how hands and feet are turned, of a naked body's vertices, metres.

    Parameters
    ----------
    body_m : (V, 3)
        Numbered as the generic human's; no more are needed than the skin's.
    """
    rows = hand_vertices(generic)
    rows |= {f"{part}_{side}": generic.feature(f"{part}_{side}") for part in ("toe", "heel") for side in _SIDES}
    return {name: body_m[row] for name, row in rows.items()}


def _hands(
    clone: Clone, generic: GenericHuman, truth_joints: Mapping[str, Array], truth_marks: Mapping[str, Array]
) -> list[tuple[int, Array, Array]]:
    """Return wrist joint, the clone's and the truth's direction, along each palm and across it, where known.

    No joint tells how a hand is turned: without its marks it kept the turn of the front
    photo's fit, and a true body lost 0.010 of the held-out overlap at its hands alone.
    Directions are the palm's: fingers curl in every photo in another way, and a palm that
    followed their tips lost 0.007.
    """
    own = {name: clone.vertices_m[vertex] for name, vertex in hand_vertices(generic).items()}
    found = []
    for side in "LR":
        wrist = generic.joint(f"{side.lower()}_wrist")
        index, pinky = f"knuckle_index_{side}", f"knuckle_pinky_{side}"
        if index not in truth_marks or pinky not in truth_marks:
            continue
        along = (own[index] + own[pinky]) / 2.0 - clone.joints_m[wrist]
        true_along = (truth_marks[index] + truth_marks[pinky]) / 2.0 - truth_joints[f"wrist_{side}"]
        found.append((wrist, _unit(along), _unit(true_along)))
        found.append((wrist, _unit(own[index] - own[pinky]), _unit(truth_marks[index] - truth_marks[pinky])))
    return found


def _feet(clone: Clone, generic: GenericHuman, truth_marks: Mapping[str, Array]) -> list[tuple[int, Array, Array]]:
    """Return ankle joint, the clone's and the truth's direction from heel to toe and upwards, where all are known.

    Toe and heel of the truth are the naked foot's where it has them, the same points as
    the clone's; a shoe's own marks point up to 8 degrees away from the shoe. Everybody
    stands with flat soles, but the joints let a foot roll over.
    """
    found, up = [], np.array([0.0, 1.0, 0.0])
    for side, name in zip("LR", _SIDES, strict=True):
        own = [clone.features_m.get(f"{part}_{name}") for part in ("toe", "heel")]
        true = [truth_marks.get(f"{part}_{name}", truth_marks.get(f"shoe_{part}_{side}")) for part in ("toe", "heel")]
        if own[0] is not None and own[1] is not None and true[0] is not None and true[1] is not None:
            ankle = generic.joint(f"{side.lower()}_ankle")
            found.append((ankle, _level(own[0] - own[1]), _level(true[0] - true[1])))
            found.append((ankle, up, up))
    return found


def _level(vector: Array) -> Array:
    """Return a level unit vector: shoes and bare feet slope differently."""
    return _unit(vector * np.array([1.0, 0.0, 1.0]))


def _unit(vector: Array) -> Array:
    return np.asarray(vector / max(float(np.linalg.norm(vector)), 1e-9))


def _centred(points: Array) -> Array:
    return np.asarray(points - points.mean(axis=0)) if len(points) else points


def moved_camera(camera: Camera, target_from_source: Array) -> Camera:
    """Return the camera that sees ``source`` as the old one sees its moved copy in ``target``."""
    return replace(camera, camera_from_model=camera.camera_from_model @ target_from_source)
