"""Stage: head and body joined (paper §4).

The head takes the place the body gives it; the neck belongs to the body. The
generic human's skin is one mesh, so the two meet by a smooth blend over the neck
and the loop stays closed. Soles are set flat on the floor.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from typing import Final

import numpy as np

from cloner.body.head_pose import fit_head_poses
from cloner.body.head_pose_evidence import NECK
from cloner.body.head_pose_matches import match_face_skin
from cloner.body.outlined import OutlinedPhoto, mask_outline_field, outlined_photos
from cloner.calibration.loader import calibrated
from cloner.detectors.face.face_net import load_face_net
from cloner.easing import smoothstep
from cloner.frames import ViewId, mm_from_m
from cloner.generic.face_grids import eyeball
from cloner.generic.features import named_features
from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.toes import smooth_shoe_tips
from cloner.hair.volumes.agreement import hair_fields
from cloner.head.jaw import jaw_opening_rad, jaw_rotations, with_open_jaw
from cloner.head.modes import load_head_modes
from cloner.head.targets import face_targets
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh, FineBody, Phenotype, PosedView
from cloner.records.clones import Joined
from cloner.records.heads import HeadFit
from cloner.records.photos import PhotoSet
from cloner.records.points import BodyPoints
from cloner.records.proposals import Proposals
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import SilhouetteSet
from cloner.records.views import Camera
from cloner.stages.fine import Params as FineParams
from cloner.stages.fine import neck_settling_weights, settle_on_outlines
from cloner.stages.points import points_for_fit

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.join")


TREAD_M = _CALIBRATED.number("tread_m", "m")
LIFTED = _CALIBRATED.number("lifted", "share")
NECK_REACH_MM = _CALIBRATED.pair("neck_reach_mm", "mm")


def blend_head(generic: GenericHuman, body: BodyMesh, head: HeadFit) -> Array:
    """Return vertices (V, 3): the head's on the head, the body's below, blended over the neck."""
    vertices = body.vertices_m.copy()
    share = generic.head_blend[generic.head_vertices].astype(np.float64)[:, None]
    place = generic.head_vertices
    vertices[place] = share * head.vertices_m + (1.0 - share) * vertices[place]
    return vertices


def flat_soles(generic: GenericHuman, vertices_m: Array, sole_m: float) -> Array:
    """Return the vertices with flat soles at ``-sole_m`` and nothing below; a toe spring is kept."""
    flat = vertices_m.copy()
    flat[:, 1] = np.maximum(flat[:, 1], -sole_m)
    treads = generic.region("sole") & (flat[:, 1] < -sole_m + TREAD_M)
    flat[treads, 1] = -sole_m
    return flat


def neck_shares(generic: GenericHuman) -> Array:
    """Return the weight (94,) with which each joint moves with the head: the neck's partly, those above fully."""
    shares, skull = np.zeros(len(generic.joint_names)), generic.joint("skullbase")
    for name in NECK:
        carried = generic.carried_by(name)
        shares[generic.joint(name)] = carried @ generic.head_blend / carried.sum()
    above = {skull}
    for row, parent in enumerate(generic.joint_parents):
        if int(parent) in above:
            above.add(row)
    shares[list(above)] = 1.0
    return shares


def to_stature(generic: GenericHuman, mesh: BodyMesh, stature_m: float) -> tuple[BodyMesh, float]:
    """Return the person with the skull's top exactly at the stature, and the head's vertical shift, metres.

    No photo shows the skull under hair, but its height is known. What lacks is shared by the head's place, whose lift
    the neck takes up, and by the vault above the eyes, which is stretched more the higher.
    """
    vertices, joints = mesh.vertices_m.copy(), mesh.joints_m.copy()
    top, eyes = vertices[generic.feature("head_top"), 1], vertices[generic.feature("glabella"), 1]
    share = smoothstep(vertices[:, 1] - eyes, 0.0, max(float(top - eyes), 1e-3)) * (generic.head_blend > 0)
    lift = LIFTED * float(stature_m - top)
    vertices[:, 1] += lift * generic.head_blend + share * (stature_m - top - lift)
    joints[:, 1] += lift * neck_shares(generic)
    return BodyMesh(vertices, joints), lift


def fit_neck(mesh: BodyMesh, photos: dict[ViewId, OutlinedPhoto], poses: dict[ViewId, PosedView]) -> Array:
    """Return the vertices with the neck settled on the photos' outlines."""
    carried_photos = tuple(OutlinedPhoto(poses[view], photo.field) for view, photo in photos.items())
    if not carried_photos:
        return mesh.vertices_m
    for reach_mm in NECK_REACH_MM:
        mesh = settle_on_outlines(mesh, carried_photos, reach_mm, FineParams(), neck_settling_weights())
    return mesh.vertices_m


def lift_camera(camera: Camera, up_m: float) -> Camera:
    """Return the camera that sees a shifted head as it saw the head before."""
    matrix = camera.camera_from_model.copy()
    matrix[:3, 3] -= matrix[:3, 1] * up_m
    return replace(camera, camera_from_model=matrix)


def face_photos_for_neck(head: HeadFit, proposals: Proposals, risen_m: float) -> dict[ViewId, OutlinedPhoto]:
    """Return the face photos with outlines for the shifted head."""
    photos = {}
    for view, camera in head.cameras.items():
        if view.is_face and view in proposals.views:
            rotations = jaw_rotations(load_generic(), head.jaws_rad.get(view, 0.0))
            posed = PosedView(view, lift_camera(camera, risen_m), rotations)
            photos[view] = OutlinedPhoto(posed, mask_outline_field(proposals.views[view]))
    return photos


def face_errors_m(mesh: BodyMesh, near: Mapping[ViewId, OutlinedPhoto], proposals: Proposals) -> Array:
    """Return the face net's errors (468, 2) on this person, metres, from the front photo of the face."""
    modes, view = load_head_modes(), ViewId.FACE_FRONT
    if view not in near or proposals.views[view].face_presence <= 0.0:
        return modes.bias_m
    generic, posed = load_generic(), near[view].posed
    shown = with_open_jaw(generic, mesh.vertices_m, mesh.joints_m, jaw_opening_rad(generic, posed.rotations))
    places = load_face_net().places.at(shown)
    return modes.frontal_errors_m(proposals.views[view].face_px, places, posed.camera)


def eye_joints(generic: GenericHuman, joints_m: Array, vertices_m: Array) -> Array:
    """Return the joints with those of the eyes at the eyeballs' centres, about which they rotate."""
    out = joints_m.copy()
    for side in ("left", "right"):
        out[generic.joint(f"{side[0]}_eyeball_joint")] = eyeball(vertices_m, side).centre
    return out


def run(
    *,
    photos: PhotoSet,
    proposals: Proposals,
    body_points: BodyPoints,
    silhouettes: SilhouetteSet,
    body: FineBody,
    head: HeadFit,
    phenotype: Phenotype,
    tick: Callable[[float], None],
) -> StageResult:
    """Produce the joined person, standing on the floor.

    Residual: the distance between the head's and the body's own neck where they
    are blended, before blending.
    """
    generic = load_generic()
    border = generic.head_vertices[
        (generic.head_blend[generic.head_vertices] > 0.2) & (generic.head_blend[generic.head_vertices] < 0.8)
    ]
    place = np.searchsorted(generic.head_vertices, border)
    apart = np.linalg.norm(head.vertices_m[place] - body.mesh.vertices_m[border], axis=1)
    vertices = smooth_shoe_tips(flat_soles(generic, blend_head(generic, body.mesh, head), phenotype.sole_m))
    mesh, risen = to_stature(generic, BodyMesh(vertices, body.mesh.joints_m), phenotype.stature_m)
    outlined = outlined_photos(phenotype, silhouettes, proposals, body.views)
    seen = {view: points_for_fit(points) for view, points in body_points.views.items()}
    faces = {view: proposals.views[view].face_px for view in outlined if proposals.views[view].face_presence > 0.0}
    near = face_photos_for_neck(head, proposals, risen)
    lines = hair_fields(proposals, silhouettes, {**outlined, **near})
    poses = fit_head_poses(
        mesh,
        {**outlined, **near},
        seen,
        faces,
        face_errors_m(mesh, near, proposals),
        lines,
        partial(match_face_skin, mesh, photos),
    )
    lift = np.array([0.0, phenotype.sole_m, 0.0])
    vertices, joints = fit_neck(mesh, outlined, poses) + lift, mesh.joints_m + lift
    views = {
        view: PosedView(view, lift_camera(posed.camera, phenotype.sole_m), posed.rotations)
        for view, posed in poses.items()
    }
    names, index, delta, start = face_targets(vertices)
    value = Joined(
        vertices, eye_joints(generic, joints, vertices), views, names, index, delta, start,
        named_features(generic, vertices), phenotype.stature_m, phenotype.sole_m,
    )  # fmt: skip
    residuals = [
        Residual("head against neck before blending", mm_from_m(float(apart.mean())) if len(apart) else 0.0, "mm")
    ]
    return StageResult({"joined": value}, tuple(residuals))
