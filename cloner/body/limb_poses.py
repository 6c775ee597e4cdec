"""Poses of limbs, hands and feet in every photo, and sizes of hands and feet, fitted with the person's own body.

The phenotype's poses were found with nobody's body. Once slices made it the
person's, limbs turn a little until the body lies on each photo's outline, while joints
stay where the photo shows them under the clothes: by outlines alone wide trousers and
shoes drag ankles along. Hands and feet, which no slice may push, get one size for all
photos and a direction for each (method §7, issue 4 "hands and feet oriented and sized from the photos"). Fingers
curl, all knuckles of a hand alike: those of people who hang their arms are never
straight. The cameras give a little too; the skin settles afterwards, on the cameras
found here.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.body.observed_joints import OUTLIER, ObservedJoints
from cloner.body.outlined import OutlinedPhoto, posed_silhouette
from cloner.calibration.loader import calibrated
from cloner.fit.evidence import Residuals, point_residuals
from cloner.fit.problem import ParameterBlock, Problem, Values
from cloner.frames import ViewId, m_from_mm
from cloner.generic.load import load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.articulation.fingers import FINGERS, knuckles
from cloner.geometry.articulation.joint_jacobians import compose_rotations, is_below, rotation_jacobian, subtree_weights
from cloner.geometry.articulation.skinning import joint_transforms, posed_joints, rotation_axes
from cloner.geometry.cameras.motions import motion_jacobian, moved_camera, projection_derivatives
from cloner.geometry.meshes.vectors import unit
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh, PosedView

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.limb_poses")

#: Rest vertices of a body whose hands and feet have given sizes.
Sizer = Callable[[Array], BodyMesh]


@dataclass(frozen=True, slots=True)
class Params:
    """Standard deviations of outlines and poses.

    Its numbers: ``cloner/calibration/body.toml``, ``[limb_poses.*]``.
    """

    limb_degrees: float = _CALIBRATED.number("limb_degrees", "deg")
    tip_degrees: float = _CALIBRATED.number("tip_degrees", "deg")
    curl_degrees: tuple[float, float] = _CALIBRATED.pair("curl_degrees", "deg")
    camera_degrees: tuple[float, float, float] = _CALIBRATED.triple("camera_degrees", "deg")
    camera_mm: tuple[float, float, float] = _CALIBRATED.triple("camera_mm", "mm")
    max_step: float = _CALIBRATED.number("max_step", "m, rad")
    outline_mm: float = _CALIBRATED.number("outline_mm", "mm")
    piece_mm: float = _CALIBRATED.number("piece_mm", "mm")
    reach_mm: tuple[float, ...] = _CALIBRATED.triple("reach_mm", "mm")


#: Joints that turn: limbs about all axes, knees about their hinge alone.
LIMBS = (("shoulder", (0, 1, 2)), ("elbow", (0, 1, 2)), ("hip", (0, 1, 2)), ("knee", (0,)))
TIPS = (("wrist", (0, 1, 2)), ("ankle", (0, 1, 2)))


@functools.cache
def _joint_rotations() -> tuple[tuple[int, tuple[int, ...], Array, bool], ...]:
    """Return joint, axes, skinning weights (V,) and whether it is a hand or foot, for every joint that rotates."""
    generic = load_generic()
    joints, weights = generic.skin_joints, generic.skin_weights.astype(np.float64)
    rows = []
    for name, axes in (*LIMBS, *TIPS):
        for side in "lr":
            joint = generic.joint(f"{side}_{name}")
            share = subtree_weights(generic.joint_parents, joint, joints, weights)
            rows.append((joint, axes, share, (name, axes) in TIPS))
    return tuple(rows)


@functools.cache
def _finger_curls() -> tuple[tuple[tuple[int, Array, Array], ...], ...]:
    """Return for each hand joint the axis (3,) at rest and skinning weights (V,) of all knuckles that curl together."""
    generic = load_generic()
    joints, weights = generic.skin_joints, generic.skin_weights.astype(np.float64)
    hands = []
    for side in "lr":
        rows = []
        for finger in FINGERS:
            bones, axis = knuckles(generic, side, finger)
            rows += [(bone, axis, subtree_weights(generic.joint_parents, bone, joints, weights)) for bone in bones]
        hands.append(tuple(rows))
    return tuple(hands)


def prior_angles(params: Params) -> tuple[Array, Array]:
    """Return mean and sigma of every angle, (A,) radians each; the last six are the camera's."""
    degrees = [
        params.tip_degrees if tip else params.limb_degrees for _, axes, _, tip in _joint_rotations() for _ in axes
    ]
    curl, curl_spread = np.deg2rad(params.curl_degrees)
    hands = len(_finger_curls())
    sigma = np.concatenate(
        [
            np.deg2rad(degrees), np.full(hands, curl_spread), np.deg2rad(params.camera_degrees),
            [m_from_mm(x) for x in params.camera_mm],
        ]
    )  # fmt: skip
    usual = np.zeros(len(sigma))
    usual[len(degrees) : len(degrees) + hands] = curl
    return usual, sigma


def _angle_jacobian(
    transforms: Array, pivots_m: Array, places_m: Array, shares: Iterable[Array], angles: Array
) -> Array:
    """Return the derivatives (N, 3, A) of posed points by every limb's angle, already rotated by ``angles``.

    ``pivots_m`` are the posed joints; ``shares`` (N,) are the skinning weights of each point for every rotating joint.
    """
    parents = load_generic().joint_parents
    blocks, start = [], 0
    for (joint, axes, _, _), share in zip(_joint_rotations(), shares, strict=True):
        turn = np.zeros(3)
        turn[list(axes)] = angles[start : start + len(axes)]
        frame = transforms[parents[joint], :3, :3] @ rotation_axes(turn)
        blocks.append(rotation_jacobian(places_m, pivots_m[joint], frame.T[list(axes)], share))
        start += len(axes)
    return np.concatenate(blocks, axis=2)


def vertex_jacobian(
    mesh: BodyMesh, posed: PosedView, places_m: Array, vertices: NDArray[np.int64], angles: Array
) -> Array:
    """Return the derivatives (N, 3, A) of posed vertices by every joint's angle, already rotated by ``angles``."""
    parents, places = load_generic().joint_parents, places_m[vertices]
    transforms = joint_transforms(mesh.joints_m, parents, posed.rotations)
    pivots = posed_joints(transforms, mesh.joints_m)
    shares = (share[vertices] for _, _, share, _ in _joint_rotations())
    blocks = [_angle_jacobian(transforms, pivots, places, shares, angles)]
    for hand in _finger_curls():
        moved = np.zeros((len(vertices), 3, 1))
        for joint, axis, share in hand:
            turned = transforms[parents[joint], :3, :3] @ axis
            moved += rotation_jacobian(places, pivots[joint], turned[None], share[vertices])
        blocks.append(moved)
    return np.concatenate(blocks, axis=2)


def _joint_residuals(
    mesh: BodyMesh, photo: OutlinedPhoto, observed: ObservedJoints, values: Array, pivot: Array
) -> Residuals:
    """Return the residuals of observed joints in one photo by its angles and camera (A), given in ``values``."""
    parents = load_generic().joint_parents
    transforms = joint_transforms(mesh.joints_m, parents, photo.posed.rotations)
    pivots = posed_joints(transforms, mesh.joints_m)
    places = pivots[observed.joints]
    shares = (is_below(parents, joint)[observed.joints].astype(np.float64) for joint, *_ in _joint_rotations())
    by_limbs = _angle_jacobian(transforms, pivots, places, shares, values)
    by_curls = np.zeros((len(places), 2, len(_finger_curls())))  # no finger is among them
    pixels, by_points, by_step = projection_derivatives(photo.posed.camera, places)
    jacobian = np.concatenate([by_points @ by_limbs, by_curls, by_step @ motion_jacobian(values[-6:], pivot)], axis=2)
    return point_residuals((photo.view,), pixels - observed.places_px, jacobian, observed.sigma_px, outlier=OUTLIER)


def _middle(mesh: BodyMesh) -> Array:
    """Return the centre of rotation of a photo's camera, (3,) metres."""
    return np.asarray(mesh.joints_m[load_generic().joint("HumanoidRoot")])


def _outline_residuals(
    mesh: BodyMesh, grown: Array, photo: OutlinedPhoto, values: Array, pivot: Array, reach_mm: float, params: Params
) -> Residuals:
    """Return the residuals of a photo's outline by sizes (S) and by its angles and camera (A), given in ``values``."""
    seen = posed_silhouette(mesh, photo)
    rim = np.flatnonzero(seen.body.on_rim)
    camera = photo.posed.camera
    normals = np.einsum("vab,vb->va", seen.blended[:, :, :3], vertex_normals(mesh.vertices_m, body_triangles()))[rim]
    flat = unit((normals @ camera.camera_from_model[:3, :3].T)[:, :2])
    reach_px = reach_mm / seen.mm_per_px
    nearest, distance = photo.field.nearest_rim(seen.body.pixels[rim], flat, reach_px)
    keep = (distance < reach_px) & ~photo.field.veiled
    used, place = np.unique(rim[nearest[keep]], return_inverse=True)
    pixels, by_points, by_step = projection_derivatives(camera, seen.posed_m[used])
    by_size = by_points @ (seen.blended[used, :, :3] @ grown[used])
    by_angle = by_points @ vertex_jacobian(mesh, photo.posed, seen.posed_m, used, values)
    jacobian = np.concatenate([by_size, by_angle, by_step @ motion_jacobian(values[-6:], pivot)], axis=2)
    pieces = photo.field.step_px * seen.mm_per_px / params.piece_mm
    sigma_px = params.outline_mm / seen.mm_per_px / np.sqrt(min(pieces, 1.0)) / (1.0 - distance[keep] / reach_px)
    away = (pixels[place] - photo.field.samples_px[keep], jacobian[place])
    return point_residuals(("sizes", photo.view), *away, sigma_px, normal=photo.field.normals[keep])


def fit_limb_poses(
    sizer: Sizer,
    size: tuple[Array, Array],
    photos: dict[ViewId, OutlinedPhoto],
    joints: Mapping[ViewId, ObservedJoints],
    params: Params,
) -> tuple[BodyMesh, dict[ViewId, OutlinedPhoto]]:
    """Return the body with scaled hands and feet, and the photos with fitted limb poses.

    Parameters
    ----------
    sizer : callable
        Gives the body for a vector of sizes.
    size : (S,) usual sizes and (S,) their spread
    photos : the body photos
    joints : those that they show under the clothes, where somebody looked for them
    """
    mean, sigma = size
    usual, differs = prior_angles(params)
    blocks = {"sizes": ParameterBlock(mean, mean, sigma, max_sigmas=3.0)}
    blocks |= {view.value: ParameterBlock(usual, usual, differs, max_step=params.max_step) for view in photos}
    middle = _middle(sizer(mean))
    pivots = {view: photo.posed.camera.to_camera(middle[None])[0] for view, photo in photos.items()}

    def stood(values: Values) -> dict[ViewId, OutlinedPhoto]:
        poses = {view: turned_pose(photo.posed, values[view], middle) for view, photo in photos.items()}
        return {view: OutlinedPhoto(posed, photos[view].field) for view, posed in poses.items()}

    def linearise(values: Values, iteration: int) -> list[Residuals]:
        mesh, grown = _with_sizes(sizer, values["sizes"])
        rows = []
        for view, photo in stood(values).items():
            rows.append(
                _outline_residuals(mesh, grown, photo, values[view], pivots[view], params.reach_mm[iteration], params)
            )
            if view in joints:
                rows.append(_joint_residuals(mesh, photo, joints[view], values[view], pivots[view]))
        return rows

    found = Problem(blocks).solve(linearise, iterations=len(params.reach_mm)).values
    return sizer(found["sizes"]), stood(found)


def _with_sizes(sizer: Sizer, values: Array) -> tuple[BodyMesh, Array]:
    """Return the body for some sizes, and the derivatives (V, 3, S) of its vertices at rest."""
    mesh, step = sizer(values), m_from_mm(1.0)
    grown = np.zeros((*mesh.vertices_m.shape, len(values)))
    for place, axis in enumerate(np.eye(len(values))):
        grown[:, :, place] = (sizer(values + step * axis).vertices_m - mesh.vertices_m) / step
    return mesh, grown


def turned_pose(posed: PosedView, angles: Array, middle_m: Array) -> PosedView:
    """Return the pose with every joint rotated by its angles in its parent's axes, fingers curled, the camera moved."""
    rotations = posed.rotations.copy()
    start = 0
    for joint, axes, _, _ in _joint_rotations():
        turn = np.zeros(3)
        turn[list(axes)] = angles[start : start + len(axes)]
        rotations[joint] = compose_rotations(rotations[joint], turn)
        start += len(axes)
    for hand, curl in zip(_finger_curls(), angles[start:-6], strict=True):
        for joint, axis, _ in hand:
            rotations[joint] = compose_rotations(rotations[joint], curl * axis)
    camera = moved_camera(posed.camera, angles[-6:], posed.camera.to_camera(middle_m[None])[0])
    return replace(posed, camera=camera, rotations=rotations)
