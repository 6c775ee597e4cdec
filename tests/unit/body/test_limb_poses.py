"""Limbs turned by known angles, and hands and feet of known size, are found again from outlines."""

from dataclasses import replace

import numpy as np
import pytest

from cloner.body import limb_poses
from cloner.body.hands import scale_hands
from cloner.body.observed_joints import ObservedJoints
from cloner.body.outlined import outlined_photos, posed_silhouette
from cloner.frames import BODY_VIEWS
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import joint_transforms, posed_joints
from cloner.records.bodies import BodyMesh, Phenotype, PosedView
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from kit import people, studio

#: Front and back photos see every limb.
TURNED = {"l_shoulder": (2, 2.0), "r_elbow": (2, -2.0), "l_wrist": (2, 8.0), "r_ankle": (1, 8.0), "l_hip": (2, 1.5)}


@pytest.fixture(scope="module")
def body():
    person = people.known_person(31)
    return BodyMesh(person.vertices_m, person.joints_m)


def photographed(body, true_rotations, believed_rotations):
    """Return three exact outlines of a body in one pose that is believed to be another."""
    person = people.KnownPerson("known", 1.70, np.zeros(1), body.vertices_m, body.joints_m)
    posed, _ = person.posed(true_rotations)
    outlines, proposals, views = {}, {}, {}
    for view in BODY_VIEWS:
        camera = studio.camera(studio.AZIMUTH_DEG[view])
        mask = studio.silhouette(posed, people.skin_triangles(), camera)
        outlines[view], proposals[view] = studio.silhouette_record(view, mask), studio.empty_proposal(view, mask)
        views[view] = PosedView(view, camera, believed_rotations)
    return outlined_photos(Phenotype(np.zeros(1), 1.70, 0.0, views, {}), SilhouetteSet(outlines), Proposals(proposals))


def unsized(body):
    """Return a sizer that knows one hand size, and its prior."""
    return lambda size: scale_hands(body, size), (np.ones(2), np.array([0.05, 0.06]))


def away_px(body, photo, true_rotations):
    """Return the mean distance of the body's vertices from their true pixels."""
    person = people.KnownPerson("known", 1.70, np.zeros(1), body.vertices_m, body.joints_m)
    true = photo.posed.camera.project(person.posed(true_rotations)[0])
    skin = load_generic().part("body")
    return float(np.linalg.norm(posed_silhouette(body, photo).body.pixels[skin] - true[skin], axis=1).mean())


def test_turned_limbs_are_found_and_the_rest_stays(body):
    generic = load_generic()
    believed = people.known_pose(1, spread=0.0)
    true = believed.copy()
    for name, (axis, degrees) in TURNED.items():
        true[generic.joint(name), axis] += np.deg2rad(degrees)
    photos = photographed(body, true, believed)
    sizer, size = unsized(body)
    _, found = limb_poses.fit_limb_poses(sizer, size, photos, {}, limb_poses.Params())
    for view in ("body_front", "body_back"):
        before, after = (away_px(body, p[view], true) for p in (photos, found))
        assert before > 3.0, "the turns are seen"
        assert after < 0.5 * before, f"{view}: {before:.1f} -> {after:.1f} px"
    free = {f"{side}_{name}" for name, _ in (*limb_poses.LIMBS, *limb_poses.TIPS) for side in "lr"}
    free |= {f"{side}_{finger}{k}" for finger in limb_poses.FINGERS for side in "lr" for k in (1, 2, 3)}
    kept = [row for row, name in enumerate(generic.joint_names) if name not in free]
    for view, photo in found.items():
        assert np.array_equal(photo.posed.rotations[kept], believed[kept]), view
        moved = photo.posed.camera.position_m - photos[view].posed.camera.position_m
        assert np.linalg.norm(moved) < 0.03, f"{view}: the camera was right"


def test_a_body_that_is_right_stays(body):
    pose = people.known_pose(1, spread=0.0)
    photos = photographed(body, pose, pose)
    sizer, size = unsized(body)
    mesh, found = limb_poses.fit_limb_poses(sizer, size, photos, {}, limb_poses.Params())
    # outlines are half a pixel large on every side
    assert np.abs(mesh.vertices_m - body.vertices_m).max() < 0.006
    for view, photo in found.items():
        assert away_px(mesh, photo, pose) < 1.5, view


def test_a_longer_hand_is_found(body):
    pose = people.known_pose(1, spread=0.0)
    true = scale_hands(body, np.array([1.1, 1.0]))
    photos = photographed(true, pose, pose)
    sizer, size = unsized(body)
    mesh, _ = limb_poses.fit_limb_poses(sizer, size, photos, {}, limb_poses.Params())
    generic = load_generic()
    tip, wrist = generic.feature("fingertip_left"), generic.joint("l_wrist")

    def length_mm(one):
        return 1000 * float(np.linalg.norm(one.vertices_m[tip] - one.joints_m[wrist]))

    assert length_mm(true) - length_mm(body) > 12.0
    assert length_mm(mesh) == pytest.approx(length_mm(true), abs=5.0)


def test_a_hand_scales_about_its_wrist_with_its_joints(body):
    generic = load_generic()
    moved = scale_hands(body, np.array([1.1, 1.1]))
    wrist = body.joints_m[generic.joint("l_wrist")]
    own = generic.segment_weights[:, generic.segment_names.index("left_hand")] > 0.999
    np.testing.assert_allclose(moved.vertices_m[own] - wrist, 1.1 * (body.vertices_m[own] - wrist), atol=1e-6)
    finger = generic.joint("l_index2")
    np.testing.assert_allclose(moved.joints_m[finger] - wrist, 1.1 * (body.joints_m[finger] - wrist), atol=1e-12)
    legs = body.vertices_m[:, 1] < 0.6
    assert np.array_equal(moved.vertices_m[legs], body.vertices_m[legs])


@pytest.mark.parametrize("already", [0.0, 0.4])
def test_turns_follow_the_parents_axes(body, already):
    """The first-order motion of an ankle's turn is the difference that a small turn makes, turned already or not."""
    generic = load_generic()
    pose = people.known_pose(2, spread=0.3)
    photo = photographed(body, pose, pose)["body_front"]
    foot = np.flatnonzero(generic.segment_weights[:, generic.segment_names.index("left_foot")] > 0.999)[:20]
    angles = np.zeros(limb_poses.prior_angles(limb_poses.Params())[0].size)
    angles[-14:-11] = already  # the left ankle's; the right one's, the hands' curls and the camera's come after
    small = np.zeros(len(angles))
    small[-14:-11] = [1e-4, -2e-4, 3e-4]
    there = limb_poses.turned_pose(photo.posed, angles, np.zeros(3))
    person = people.KnownPerson("known", 1.70, np.zeros(1), body.vertices_m, body.joints_m)
    places = person.posed(there.rotations)[0]
    motion = limb_poses.vertex_jacobian(body, there, places, foot, angles)
    beyond, before = (
        person.posed(limb_poses.turned_pose(photo.posed, angles + way * small, np.zeros(3)).rotations)[0][foot]
        for way in (1.0, -1.0)
    )
    np.testing.assert_allclose(motion @ small[:-6], (beyond - before) / 2.0, atol=2e-8)


def test_curled_fingers_are_found(body):
    generic = load_generic()
    believed = people.known_pose(1, spread=0.0)
    photos = photographed(body, believed, believed)
    curled = np.zeros(limb_poses.prior_angles(limb_poses.Params())[0].size)
    curled[-8:-6] = np.deg2rad([25.0, 0.0])
    true = limb_poses.turned_pose(photos["body_front"].posed, curled, np.zeros(3)).rotations
    photos = photographed(body, true, believed)
    sizer, size = unsized(body)
    _, found = limb_poses.fit_limb_poses(sizer, size, photos, {}, limb_poses.Params())
    bent = {
        side: np.rad2deg(np.linalg.norm(found["body_front"].posed.rotations[generic.joint(f"{side}_middle2")]))
        for side in "lr"
    }
    assert 14.0 < bent["l"] < 30.0, "expected are 8, shown 25"
    assert bent["r"] < 10.0


def seen(body, pose, view, names, off_px=0.0, sigma_px=5.0):
    """Return joints of a body in a pose where a photo shows them, moved to the right by some pixels."""
    generic = load_generic()
    rows = np.array([generic.joint(name) for name in names])
    transforms = joint_transforms(body.joints_m, generic.joint_parents, pose)
    places = studio.camera(studio.AZIMUTH_DEG[view]).project(posed_joints(transforms, body.joints_m)[rows])
    return ObservedJoints(rows, places + [off_px, 0.0], np.full(len(rows), sigma_px))


def test_joints_tell_how_their_pixels_move_with_angles_and_camera(body):
    pose = people.known_pose(2, spread=0.3)
    photo = photographed(body, pose, pose)["body_front"]
    told = seen(body, pose, "body_front", ("l_elbow", "r_knee", "l_ankle"))
    usual, _ = limb_poses.prior_angles(limb_poses.Params())
    at = np.random.default_rng(0).normal(scale=0.05, size=len(usual))
    middle = body.joints_m[load_generic().joint("HumanoidRoot")]
    pivot = photo.posed.camera.to_camera(middle[None])[0]

    def rows(values):
        moved = replace(photo, posed=limb_poses.turned_pose(photo.posed, values, middle))
        return limb_poses._joint_residuals(body, moved, told, values, pivot)

    step = 1e-5
    for column in np.flatnonzero(np.abs(rows(at).jacobian).max(axis=0) > 0.0):
        way = step * np.eye(len(at))[column]
        difference = (rows(at + way).value - rows(at - way).value) / (2.0 * step)
        # exact for angles; the camera's turn is linear about where it is
        np.testing.assert_allclose(rows(at).jacobian[:, column], difference, rtol=2e-3, atol=2e-2)


def test_joints_that_are_seen_pull_limbs_that_outlines_leave(body):
    pose = people.known_pose(1, spread=0.0)
    photos = photographed(body, pose, pose)
    sizer, size = unsized(body)
    ankle = load_generic().joint("l_ankle")

    def ankle_px(joints):
        mesh, found = limb_poses.fit_limb_poses(sizer, size, photos, joints, limb_poses.Params())
        return float(posed_silhouette(mesh, found["body_front"]).body.joints_px[ankle, 0])

    away = ankle_px({"body_front": seen(body, pose, "body_front", ("l_ankle",), 4.0, 1.0)})
    assert ankle_px({}) + 0.5 < away < ankle_px({}) + 4.0
