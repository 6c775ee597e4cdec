"""A head turned by a known angle in one photo shows its hairline elsewhere than another photo does."""

from dataclasses import replace

import numpy as np
import pytest

from cloner.body import head_pose
from cloner.body.head_pose_evidence import NECK, SKULL
from cloner.body.outlined import OutlinedPhoto, mask_outline_field
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.hair.volumes import agreement as hair_agreement
from cloner.records.bodies import BodyMesh, PosedView
from cloner.records.labels import Label
from cloner.records.points import ViewPoints
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from kit import people, studio

FACE, SIDE = ViewId.FACE_SIDE, ViewId.BODY_SIDE
CLOSE = {"distance_m": 1.3, "height_m": 1.55, "aim_m": 1.5, "size_px": (1200, 1600), "focal_35mm": 75}


def painted_hair(person, rotations, camera, mask):
    """Return labels with hair as paint on the scalp's triangles that face the camera."""
    generic, triangles = load_generic(), people.skin_triangles()
    posed, _ = person.posed(rotations)
    facing = np.einsum("vk,vk->v", vertex_normals(posed, triangles), camera.position_m - posed) > 0.0
    ears = generic.region("ear_left") | generic.region("ear_right")
    hairy = triangles[(generic.region("scalp") & facing & ~ears)[triangles].all(axis=1)]
    return np.where(studio.silhouette(posed, hairy, camera) & mask, Label.HAIR, 0).astype(np.uint8)


def photographed(person, true, believed):
    """Return photos believed to be in one pose, and hairlines as the true poses show them."""
    photos, proposals, outlines = {}, {}, {}
    for view, rotations in true.items():
        camera = studio.camera(studio.AZIMUTH_DEG[SIDE.value], **(CLOSE if view.is_face else {}))
        mask = studio.silhouette(person.posed(rotations)[0], people.skin_triangles(), camera)
        labels = painted_hair(person, rotations, camera, mask)
        proposals[view] = replace(studio.empty_proposal(view, mask), labels=labels)
        outlines[view] = studio.silhouette_record(view, mask)
        photos[view] = OutlinedPhoto(PosedView(view, camera, believed), mask_outline_field(proposals[view]))
    return photos, hair_agreement.hair_fields(Proposals(proposals), SilhouetteSet(outlines), photos)


def yaw_deg(pose):
    """Return how far neck and skull together turn aside."""
    generic = load_generic()
    rows = [generic.joint(name) for name in (*NECK, *SKULL)]
    return float(np.degrees(pose[rows, 1].sum()))


@pytest.mark.parametrize("turned_deg", [-8.0, 8.0])
def test_hairlines_tell_the_turn_of_a_head_seen_from_aside(turned_deg):
    person, believed = people.known_person(51), people.known_pose(1, spread=0.0)
    true = {FACE: believed, SIDE: believed.copy()}
    true[SIDE][load_generic().joint("skullbase"), 1] += np.deg2rad(turned_deg)
    photos, lines = photographed(person, true, believed)
    silent = {view: ViewPoints(view, (), np.zeros((0, 2)), np.zeros(0), np.zeros(0, bool)) for view in photos}
    mesh, no_errors = BodyMesh(person.vertices_m, person.joints_m), np.zeros((468, 2))
    found = head_pose.fit_head_poses(mesh, photos, silent, {}, no_errors, lines, lambda poses: {})
    lack = abs(yaw_deg(found[SIDE].rotations) - yaw_deg(true[SIDE]))
    # a head's usual turn is 4 degrees: the prior keeps some of two such spreads back
    assert lack < 0.5 * abs(turned_deg), f"{lack:.1f} degrees are missing"


def test_one_photo_alone_agrees_with_itself():
    person, pose = people.known_person(51), people.known_pose(1, spread=0.0)
    photos, lines = photographed(person, {SIDE: pose}, pose)
    turned = {SIDE: lambda angles: photos[SIDE].posed}
    mesh = BodyMesh(person.vertices_m, person.joints_m)
    assert not list(hair_agreement.hairline_residuals(mesh, lines, turned, {SIDE: np.zeros(6)}))
