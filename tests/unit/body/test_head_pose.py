"""A head turned by a known angle is found again, under hair too, where only its outline shows."""

import functools
from dataclasses import replace

import numpy as np
import pytest

from cloner.body import head_pose
from cloner.body.head_pose_evidence import NECK, SKULL, RestHead, turn_head
from cloner.body.head_pose_matches import match_face_skin, visible_points
from cloner.body.outlined import outlined_photos
from cloner.detectors.face.face_net import load_face_net
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import rotation_matrices
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.head.modes import load_head_modes
from cloner.head.skin_matches import SkinMatches
from cloner.records.bodies import BodyMesh, Phenotype, PosedView
from cloner.records.labels import Label
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import ViewPoints
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from kit import people, studio

FRONT, SIDE, BACK, NEAR = ViewId.BODY_FRONT, ViewId.BODY_SIDE, ViewId.BODY_BACK, ViewId.FACE_SIDE
NAMES = ("nose_tip", "ear_outer_R")
#: A net without errors on faces that look straight at the camera.
STRAIGHT = np.zeros((468, 2))


def nothing(poses):
    """Return that nothing was looked up."""
    return {}


def hairy(person, thick_m):
    """Return vertices with hair of one thickness over the scalp above the ears, and which of them are hair."""
    generic = load_generic()
    ears = generic.region("ear_left") | generic.region("ear_right")
    cap = generic.region("scalp") & (person.vertices_m[:, 1] > person.vertices_m[ears, 1].mean()) & ~ears
    out = person.vertices_m.copy()
    out[cap] += thick_m * vertex_normals(person.vertices_m, people.skin_triangles())[cap]
    return out, cap


def photographed(person, true, believed, thick_m=0.0):
    """Return photos of a person in the true poses (rotations a view), believed to be others, and the exact points.

    A front photo has the face net's points.
    """
    generic, triangles = load_generic(), people.skin_triangles()
    dressed, cap = hairy(person, thick_m)
    poses, outlines, proposals, points, faces = {}, {}, {}, {}, {}
    for view, rotations in true.items():
        camera = studio.camera(studio.AZIMUTH_DEG[view.value])
        naked, _ = person.posed(rotations)
        worn, _ = replace(person, vertices_m=dressed).posed(rotations)
        mask = studio.silhouette(worn, triangles, camera)
        poses[view] = PosedView(view, camera, believed)
        outlines[view] = studio.silhouette_record(view, mask)
        labels = np.zeros(mask.shape, np.uint8)
        if thick_m > 0.0:
            labels[studio.silhouette(worn, triangles[cap[triangles].all(axis=1)], camera) & mask] = Label.HAIR
        proposals[view] = replace(studio.empty_proposal(view, mask), labels=labels)
        seen = NAMES if view is SIDE else ()
        pixels = camera.project(naked[[generic.feature(name) for name in seen]]) if seen else np.zeros((0, 2))
        points[view] = ViewPoints(view, seen, pixels, np.ones(len(seen)), np.zeros(len(seen), bool))
        if view is FRONT:
            faces[view] = drawn(camera, naked, rotations)
    photos = outlined_photos(
        Phenotype(np.zeros(1), 1.70, 0.0, poses, {}), SilhouetteSet(outlines), Proposals(proposals)
    )
    return photos, points, faces


def drawn(camera, naked, rotations):
    """Return the face net's points (468, 2): it draws a nodding head as if it looked more straight at the camera."""
    places = load_face_net().places.at(naked)
    turn = rotation_matrices(rotations).reshape(-1, 3, 3)
    head = functools.reduce(np.matmul, (turn[row] for row in reversed(ancestors("skullbase"))))
    errors = load_head_modes().turn_errors_m(camera.camera_from_model[:3, :3] @ head)
    return camera.project(places) + errors / camera.metres_per_pixel(places.mean(axis=0))


def ancestors(name):
    """Return a joint's row and those of the joints that carry it."""
    generic = load_generic()
    rows = [generic.joint(name)]
    while generic.joint_parents[rows[-1]] >= 0:
        rows.append(int(generic.joint_parents[rows[-1]]))
    return rows


def off_px(person, posed, true, names):
    """Return how far features lie from their places in the photo, px."""
    generic = load_generic()
    rows = [generic.feature(name) for name in names]
    found, expected = (person.posed(rotations)[0][rows] for rotations in (posed.rotations, true))
    return float(np.linalg.norm(posed.camera.project(found) - posed.camera.project(expected), axis=1).mean())


def nodded(pose, degrees):
    true = pose.copy()
    true[load_generic().joint("skullbase"), 0] += np.deg2rad(degrees)
    return true


@pytest.mark.parametrize("nod_degrees", [-8.0, 8.0])
def test_a_nod_is_found_from_the_side(nod_degrees):
    generic = load_generic()
    person, believed = people.known_person(51), people.known_pose(1, spread=0.0)
    true = nodded(believed, nod_degrees)
    photos, points, faces = photographed(person, {SIDE: true}, believed)
    found = head_pose.fit_head_poses(
        BodyMesh(person.vertices_m, person.joints_m), photos, points, faces, STRAIGHT, {}, nothing
    )[SIDE]
    before, after = (off_px(person, posed, true, ["nose_tip"]) for posed in (photos[SIDE].posed, found))
    assert before > 12.0, "the nod moves the nose"
    # two usual spreads of a head's turn (4 degrees): the prior keeps a quarter back
    assert after < 0.3 * before, f"nose {before:.1f} -> {after:.1f} px"
    other = np.setdiff1d(np.arange(94), [generic.joint(name) for name in (*NECK, *SKULL)])
    assert np.array_equal(found.rotations[other], believed[other]), "only the neck and the skull turn"


def test_a_head_that_is_right_stays():
    person, pose = people.known_person(51), people.known_pose(1, spread=0.0)
    photos, points, faces = photographed(person, {SIDE: pose}, pose)
    found = head_pose.fit_head_poses(
        BodyMesh(person.vertices_m, person.joints_m), photos, points, faces, STRAIGHT, {}, nothing
    )[SIDE]
    assert off_px(person, found, pose, ["nose_tip"]) < 3.0


@pytest.mark.parametrize("thick_m", [0.012, 0.02, 0.07])  # the last an afro
def test_under_thick_hair_front_and_side_hold_the_head_in_the_photo_of_the_back(thick_m):
    person, believed = people.known_person(51), people.known_pose(1, spread=0.0)
    true = {FRONT: nodded(believed, 5.0), SIDE: nodded(believed, -4.0), BACK: believed.copy()}
    true[BACK][load_generic().joint("vc5"), 2] += np.deg2rad(7.0)  # the head leans to one side by 1.2 cm
    photos, points, faces = photographed(person, true, believed, thick_m)
    found = head_pose.fit_head_poses(
        BodyMesh(person.vertices_m, person.joints_m), photos, points, faces, STRAIGHT, {}, nothing
    )
    crown = ["head_top", "ear_outer_L", "ear_outer_R"]
    before = {view: off_px(person, photos[view].posed, true[view], crown) for view in photos}
    after = {view: off_px(person, found[view], true[view], crown) for view in photos}
    assert before[BACK] > 9.0
    assert after[BACK] < 0.5 * before[BACK], f"{before} -> {after} px"
    assert after[FRONT] < 4.0, f"{before} -> {after} px"
    assert after[SIDE] < 8.0, f"{before} -> {after} px"


def test_a_face_photo_nods_about_the_face():
    person = people.known_person(51)
    head = RestHead.of(BodyMesh(person.vertices_m, person.joints_m))
    posed = PosedView(ViewId.FACE_FRONT, studio.camera(0.0), np.zeros((94, 3)))
    found = turn_head(posed, np.array([0.1]), head.pivot_m)
    ends = [view.camera.project(head.pivot_m[None])[0] for view in (posed, found)]
    np.testing.assert_allclose(ends[1], ends[0], atol=1e-6)
    top = person.vertices_m[[load_generic().feature("head_top")]]
    moved = found.camera.project(top)[0] - posed.camera.project(top)[0]
    assert abs(moved[0]) < 1.0
    assert abs(moved[1]) > 5.0


def test_a_net_that_draws_a_face_awry_does_not_nod_it():
    person, pose = people.known_person(51), people.known_pose(1, spread=0.0)
    photos, points, faces = photographed(person, {FRONT: pose, SIDE: pose}, pose)
    high = load_face_net().places.at(person.vertices_m)[:, 1]
    awry = np.column_stack([np.zeros(468), 0.15 * (high - high.mean())])  # the whole face drawn flatter
    camera = photos[FRONT].posed.camera
    made = {FRONT: faces[FRONT] + awry / camera.metres_per_pixel(person.vertices_m.mean(axis=0))}
    mesh = BodyMesh(person.vertices_m, person.joints_m)
    known, unknown = (
        head_pose.fit_head_poses(mesh, photos, points, made, errors, {}, nothing)[FRONT] for errors in (awry, STRAIGHT)
    )
    names = ["head_top", "nose_tip", "chin_bottom"]
    assert off_px(person, known, pose, names) < 0.7 * off_px(person, unknown, pose, names)


@pytest.mark.parametrize("turn_degrees", [-9.0, 9.0])
def test_skin_looked_up_beside_the_head_tells_its_turn(turn_degrees):
    generic = load_generic()
    person, believed = people.known_person(51), people.known_pose(1, spread=0.0)
    true = believed.copy()
    true[generic.joint("skullbase"), 1] += np.deg2rad(turn_degrees)
    photos, points, faces = photographed(person, {SIDE: true}, believed)
    marks = np.array([generic.feature(name) for name in ("ear_outer_L", "eye_outer_L", "mouth_corner_L")])
    shown = photos[SIDE].posed.camera.project(person.posed(true)[0][marks])

    def look(poses):
        return {SIDE: SkinMatches(marks, shown, np.ones(len(marks)))}

    mesh = BodyMesh(person.vertices_m, person.joints_m)
    blind, seeing = (
        head_pose.fit_head_poses(mesh, photos, points, faces, STRAIGHT, {}, found)[SIDE] for found in (nothing, look)
    )
    ear = ["ear_outer_L"]
    assert off_px(person, seeing, true, ear) < 0.4 * off_px(person, blind, true, ear)


def test_only_photos_of_the_same_side_are_looked_into():
    person, pose = people.known_person(51), people.known_pose(1, spread=0.0)
    pictures = PhotoSet({view: Photo(view, np.zeros((40, 30, 3), np.uint8), None, "", "") for view in (SIDE, NEAR)})
    poses = {SIDE: PosedView(SIDE, studio.camera(90.0), pose), NEAR: PosedView(NEAR, studio.camera(-90.0), pose)}
    assert match_face_skin(BodyMesh(person.vertices_m, person.joints_m), pictures, poses) == {}
    names = visible_points(np.array([1.0, 0.0, 0.1]))
    assert "ear_outer_L" in names
    assert not any(name.endswith("_R") for name in names)
