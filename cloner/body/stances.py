"""Limbs, hands and feet turned and sized to every photo's outline, with the person's own body.

The phenotype's poses were found with nobody's body. Once slices made it the
person's, limbs turn a little until the body lies on each photo's outline, and hands
and feet, which no slice may push, get one size for all photos and a direction for
each (method §7, issue 4 "hands and feet oriented and sized from the photos"). The
cameras give a little too; the skin settles afterwards, on the cameras found here.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.body.outlined import Outlined, Seen, see
from cloner.calibration.loader import calibrated
from cloner.frames import ViewId, m_from_mm
from cloner.generic.load import load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.articulation.posing import moved_camera
from cloner.geometry.articulation.skinning import joint_transforms
from cloner.geometry.articulation.turning import carried_share, pixel_slope, turned_motion, turned_rotation
from cloner.geometry.meshes.vectors import unit
from cloner.geometry.outlines.rims import vertex_normals
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh, PosedView

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.stances")

#: Rest vertices of a body whose hands and feet have given sizes.
Sizer = Callable[[Array], BodyMesh]


@dataclass(frozen=True, slots=True)
class Params:
    """Trust in outlines against the poses found before.

    Its numbers: ``cloner/calibration/body.toml``, ``[stances.*]``.
    """

    limb_degrees: float = _CALIBRATED.number("limb_degrees", "deg")
    tip_degrees: float = _CALIBRATED.number("tip_degrees", "deg")
    camera_degrees: tuple[float, float, float] = _CALIBRATED.triple("camera_degrees", "deg")
    camera_mm: tuple[float, float, float] = _CALIBRATED.triple("camera_mm", "mm")
    outline_mm: float = _CALIBRATED.number("outline_mm", "mm")
    piece_mm: float = _CALIBRATED.number("piece_mm", "mm")
    reach_mm: tuple[float, ...] = _CALIBRATED.triple("reach_mm", "mm")


#: Joints that turn: limbs about all axes, knees about their hinge alone.
LIMBS = (("shoulder", (0, 1, 2)), ("elbow", (0, 1, 2)), ("hip", (0, 1, 2)), ("knee", (0,)))
TIPS = (("wrist", (0, 1, 2)), ("ankle", (0, 1, 2)))


@functools.cache
def _turns() -> tuple[tuple[int, tuple[int, ...], Array, bool], ...]:
    """Return joint, axes, carried share (V,) and whether it is a hand or foot, for every joint that turns."""
    generic = load_generic()
    joints, weights = generic.skin_joints, generic.skin_weights.astype(np.float64)
    rows = []
    for name, axes in (*LIMBS, *TIPS):
        for side in "lr":
            joint = generic.joint(f"{side}_{name}")
            share = carried_share(generic.joint_parents, joint, joints, weights)
            rows.append((joint, axes, share, (name, axes) in TIPS))
    return tuple(rows)


def angle_spread(params: Params) -> Array:
    """Return the (A,) usual turn of every angle, radians."""
    degrees = [params.tip_degrees if tip else params.limb_degrees for _, axes, _, tip in _turns() for _ in axes]
    return np.concatenate(
        [np.deg2rad(degrees), np.deg2rad(params.camera_degrees), [m_from_mm(x) for x in params.camera_mm]]
    )


def _motion(mesh: BodyMesh, photo: Outlined, seen: Seen, vertices: NDArray[np.int64]) -> Array:
    """Return (N, 3, A) motion of posed vertices per radian of every angle."""
    generic = load_generic()
    transforms = joint_transforms(mesh.joints_m, generic.joint_parents, photo.posed.rotations)
    posed = seen.posed_m[vertices]
    blocks = []
    for joint, axes, share, _ in _turns():
        pivot = transforms[joint, :3, :3] @ mesh.joints_m[joint] + transforms[joint, :3, 3]
        frame = transforms[generic.joint_parents[joint], :3, :3].T
        blocks.append(turned_motion(posed, pivot, frame[list(axes)], share[vertices]))
    camera = photo.posed.camera.camera_from_model[:3, :3]
    blocks.append(turned_motion(posed, _middle(mesh), camera, np.ones(len(posed))))
    blocks.append(np.broadcast_to(camera.T, (len(posed), 3, 3)))
    return np.concatenate(blocks, axis=2)


def _middle(mesh: BodyMesh) -> Array:
    """Return the point about which a photo's camera turns, (3,) metres."""
    return np.asarray(mesh.joints_m[load_generic().joint("HumanoidRoot")])


def _rows(
    mesh: BodyMesh, grown: Array, photo: Outlined, reach_mm: float, params: Params
) -> tuple[Array, Array, Array, Array]:
    """Return slopes by size (K, S) and by angle (K, A), wanted changes (K,) and weights, in spreads, of one photo."""
    seen = see(mesh, photo)
    rim = np.flatnonzero(seen.body.on_rim)
    camera = photo.posed.camera
    normals = np.einsum("vab,vb->va", seen.blended[:, :, :3], vertex_normals(mesh.vertices_m, body_triangles()))[rim]
    flat = (normals @ camera.camera_from_model[:3, :3].T)[:, :2]
    flat = unit(flat)
    reach_px = reach_mm / seen.mm_per_px
    nearest, distance = photo.field.nearest_rim(seen.body.pixels[rim], flat, reach_px)
    keep = (distance < reach_px) & ~photo.field.veiled
    vertex, normal = rim[nearest[keep]], photo.field.normals[keep]
    wanted = np.einsum("ka,ka->k", photo.field.samples_px[keep] - seen.body.pixels[vertex], normal)
    used, place = np.unique(vertex, return_inverse=True)
    across = np.einsum("ka,kab->kb", normal, pixel_slope(camera, seen.posed_m[used])[place])
    by_angle = np.einsum("kb,kba->ka", across, _motion(mesh, photo, seen, used)[place])
    by_size = np.einsum("kb,kbs->ks", across, np.einsum("vab,vbs->vas", seen.blended[used, :, :3], grown[used])[place])
    pieces = photo.field.step_px * seen.mm_per_px / params.piece_mm
    weight = seen.mm_per_px / params.outline_mm * np.sqrt(min(pieces, 1.0)) * (1.0 - distance[keep] / reach_px)
    return by_size, by_angle, wanted, weight


def fit_stances(
    sizer: Sizer,
    size: tuple[Array, Array],
    photos: dict[ViewId, Outlined],
    params: Params,
) -> tuple[BodyMesh, dict[ViewId, Outlined]]:
    """Return the body with hands and feet sized, and the photos with limbs turned to them.

    Parameters
    ----------
    sizer : callable
        Gives the body for a vector of sizes.
    size : (S,) usual sizes and (S,) their spread
    photos : the body photos
    """
    mean, spread = size
    angle = angle_spread(params)
    count, turns = len(mean), len(angle)
    values, turned = mean.copy(), {view: np.zeros(turns) for view in photos}
    for reach in params.reach_mm:
        mesh, grown = _grown(sizer, values)
        normal = np.diag(np.concatenate([1.0 / spread**2, *(1.0 / angle**2 for _ in photos)]))
        right = np.concatenate([(mean - values) / spread**2, *(-turned[view] / angle**2 for view in photos)])
        for number, photo in enumerate(photos.values()):
            by_size, by_angle, wanted, weight = _rows(mesh, grown, photo, reach, params)
            rows = np.hstack([by_size, by_angle]) * weight[:, None]
            columns = np.r_[np.arange(count), count + number * turns + np.arange(turns)]
            # no BLAS: its threads wait for each other longer than this product takes
            normal[np.ix_(columns, columns)] += np.einsum("ka,kb->ab", rows, rows)
            right[columns] += np.einsum("ka,k->a", rows, weight * wanted)
        step = np.linalg.solve(normal, right)
        values = np.clip(values + step[:count], mean - 3.0 * spread, mean + 3.0 * spread)
        for number, (view, photo) in enumerate(photos.items()):
            change = np.clip(step[count + number * turns :][:turns], -0.2, 0.2)
            turned[view] = turned[view] + change
            photos = {**photos, view: Outlined(turned_pose(photo.posed, change, _middle(mesh)), photo.field)}
    return sizer(values), photos


def _grown(sizer: Sizer, values: Array) -> tuple[BodyMesh, Array]:
    """Return the body and (V, 3, S) how its rest vertices move with each size."""
    mesh, step = sizer(values), m_from_mm(1.0)
    grown = np.zeros((*mesh.vertices_m.shape, len(values)))
    for place, axis in enumerate(np.eye(len(values))):
        grown[:, :, place] = (sizer(values + step * axis).vertices_m - mesh.vertices_m) / step
    return mesh, grown


def turned_pose(posed: PosedView, angles: Array, middle_m: Array) -> PosedView:
    """Return the pose after every joint turned by its angles, in its parent's axes, and the camera by the last six."""
    rotations = posed.rotations.copy()
    start = 0
    for joint, axes, _, _ in _turns():
        turn = np.zeros(3)
        turn[list(axes)] = angles[start : start + len(axes)]
        rotations[joint] = turned_rotation(rotations[joint], turn)
        start += len(axes)
    matrix = moved_camera(posed.camera.camera_from_model, angles[start:], middle_m)
    return replace(posed, camera=replace(posed.camera, camera_from_model=matrix), rotations=rotations)
