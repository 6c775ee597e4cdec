"""The nets find the visitors, tell left from right, and nobody where nobody is."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from skimage import data

from cloner.detectors.nets import litert
from cloner.detectors.nets.litert import detect_face, detect_pose
from cloner.detectors.nets.people import detect_people, pose_in_mask
from cloner.detectors.nets.placing import has_face, is_within, overlap_enough, same_body, same_crop
from cloner.detectors.nets.results import POSE_NAMES, Box
from cloner.vision.photographs.crops import Crop
from kit.visitors import NAMES, overlap, photo, truth_mask, visitor_folder

MESH_MARKS = {"mouth_corner_R": 61, "mouth_corner_L": 291, "eye_outer_R": 33, "eye_outer_L": 263}
JOINTS = ("shoulder", "elbow", "wrist", "hip", "knee", "ankle")


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("view", ["body_front", "body_back"])
def test_joints_lie_near_the_rig_and_on_their_own_side(name: str, view: str) -> None:
    pose = detect_pose(photo(name, "plain", view).rgb)
    assert pose is not None
    truth = json.loads((visitor_folder(name) / "truth.json").read_text())
    camera = truth["cameras"][view]
    world_to_camera = np.array(camera["world_to_camera"])
    for joint in JOINTS:
        for side in "lr":
            joint_m = truth["joints_3d_m"][f"{joint}_{side.upper()}"]
            seen = world_to_camera[:3] @ [*joint_m, 1.0]
            true_px = camera["fx"] * seen[:2] / seen[2] + [camera["cx"], camera["cy"]]
            error = np.hypot(*(pose.points_px[POSE_NAMES.index(f"{joint}_{side}")] - true_px))
            # 886 px a metre here; hips differ by definition, see docs/method/parts.md
            assert error < 75, f"{name} {view} {joint}_{side} {error:.0f} px"


@pytest.mark.parametrize(("name", "near"), [("anna", "r"), ("boris", "l")])
def test_side_photo_near_knee_is_seen_better(name: str, near: str) -> None:
    pose = detect_pose(photo(name, "handheld", "body_side").rgb)
    assert pose is not None
    seen = {s: pose.visibility[POSE_NAMES.index(f"knee_{s}")] for s in "lr"}
    assert seen[near] > max(v for s, v in seen.items() if s != near)


@pytest.mark.parametrize(
    ("set_name", "view", "least"),
    [("plain", "body_front", 0.97), ("handheld", "body_back", 0.965), ("booth", "face_side", 0.97)],
)
def test_raw_mask_overlaps_the_person(set_name: str, view: str, least: float) -> None:
    pose = detect_pose(photo("anna", set_name, view).rgb)
    assert pose is not None
    assert pose.mask.dtype == np.float32
    assert overlap(pose.mask > 0.5, truth_mask("anna", set_name, view)) > least


def eye_gap_px(points: np.ndarray) -> float:
    return float(np.hypot(*(points[263] - points[33])))


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("view", ["face_front", "body_front"])
def test_face_mesh_finds_the_mouth_corners(name: str, view: str) -> None:
    face = detect_face(photo(name, "plain", view).rgb)
    assert face is not None
    assert face.presence > 0.9
    assert abs(face.turn_deg) < 6
    truth = json.loads((visitor_folder(name) / "truth.json").read_text())
    camera = truth["cameras"][view]
    points = truth["points_3d_m"]
    for key, index in MESH_MARKS.items():
        seen = np.array(camera["world_to_camera"])[:3] @ [*points[key], 1.0]
        true_px = camera["fx"] * seen[:2] / seen[2] + [camera["cx"], camera["cy"]]
        error = np.hypot(*(face.points_px[index] - true_px)) / eye_gap_px(face.points_px)
        assert error < 0.09, f"{name} {view} {key} {error:.3f} of the eye gap"


def test_what_is_no_face_does_not_hide_a_smaller_one(monkeypatch: pytest.MonkeyPatch) -> None:
    rgb = photo("anna", "plain", "body_front").rgb
    faces, hips = litert.find_faces, np.array([[320.0, 700.0], [380.0, 700.0], [350.0, 730.0]])
    no_face = Box("face", 250.0, 600.0, 450.0, 800.0, 0.7, hips)
    monkeypatch.setattr(litert, "find_faces", lambda rgb, least: [*faces(rgb, least), no_face])
    found = detect_face(rgb)
    assert found is not None
    assert overlap_enough(found.box, faces(rgb, 0.3)[0], 0.3)


def test_backs_and_empty_pictures_have_no_face() -> None:
    assert detect_face(photo("boris", "plain", "body_back").rgb) is None
    grey = np.full((600, 400, 3), 120, np.uint8)
    assert detect_face(grey) is None
    assert detect_pose(grey) is None
    assert detect_people(grey) == []
    noise = np.random.default_rng(0).integers(0, 255, (900, 600, 3)).astype(np.uint8)
    assert detect_people(noise) == []
    assert detect_people(np.ascontiguousarray(data.coffee())) == []


@pytest.mark.parametrize("view", ["body_front", "body_side"])
def test_somebody_in_a_mask_is_found_without_a_detector(view: str) -> None:
    rgb, inside = photo("anna", "plain", view).rgb, truth_mask("anna", "plain", view)
    seen, usual = pose_in_mask(rgb, inside), detect_pose(rgb)
    assert seen is not None
    assert usual is not None
    height = np.ptp(np.flatnonzero(inside.any(axis=1)))
    assert np.median(np.hypot(*(seen.points_px - usual.points_px).T)) < 0.01 * height
    assert pose_in_mask(np.full_like(rgb, 120), inside) is None


@pytest.mark.parametrize("view", ["body_front", "body_side", "body_back", "face_front"])
def test_two_people_are_two(view: str) -> None:
    both = [photo(n, "plain", view).rgb for n in NAMES]
    assert [len(detect_people(rgb)) for rgb in both] == [1, 1]
    assert len(detect_people(np.hstack(both))) == 2


def test_a_poster_is_nobody() -> None:
    rgb = photo("anna", "booth", "body_front").rgb.copy()
    poster = photo("boris", "plain", "face_front").rgb[::7, ::7]
    rgb[60 : 60 + poster.shape[0], 900 : 900 + poster.shape[1]] = poster
    assert len(detect_people(rgb)) == 1


def test_astronaut_is_one_person_facing_us() -> None:
    rgb = np.ascontiguousarray(data.astronaut())
    face = detect_face(rgb)
    assert len(detect_people(rgb)) == 1
    assert face is not None
    assert np.hypot(*(face.points_px[1] - (218, 122))) < 12  # nose tip, read off by eye
    assert face.points_px[33, 0] < face.points_px[263, 0]  # her right eye is on the left


def test_same_photo_same_answer() -> None:
    rgb = photo("anna", "booth", "face_front").rgb
    first, second = detect_pose(rgb), detect_pose(rgb)
    assert first is not None
    assert second is not None
    np.testing.assert_array_equal(first.points_px, second.points_px)
    np.testing.assert_array_equal(first.mask, second.mask)


def body(left: float, nose_x: float) -> Box:
    """A body 600 px wide and 1400 high whose shoulders lie 80 px from its nose."""
    points = np.array([[left + 300, 900], [left + 300, 100], [nose_x, 280], [nose_x, 200]], dtype=np.float64)
    return Box("person", left, 50.0, left + 600, 1450.0, 0.6, points)


def test_one_body_with_the_nose_taken_for_the_nape_is_one() -> None:
    assert same_body(body(100, 300), body(150, 480))


def test_a_head_whose_shoulders_were_taken_for_its_chin_is_no_second_person():
    portrait, confused = body(100, 300), body(180, 360)
    confused.keypoints_px[2] = confused.keypoints_px[3] + (0.0, 20.0)
    assert same_body(portrait, confused)
    assert same_body(confused, portrait)


def test_a_skirt_that_looks_like_somebody_lies_in_its_wearer() -> None:
    wearer, skirt = body(100, 300), replace(body(250, 400), right_px=600.0, top_px=700.0)
    assert is_within(skirt, wearer)
    assert not is_within(wearer, skirt)
    assert not is_within(replace(skirt, right_px=800.0), wearer)  # a third of it beside
    assert not is_within(wearer, wearer)
    face = Box("face", 370.0, 160.0, 430.0, 240.0, 0.9, np.zeros((6, 2)))
    assert has_face(skirt, [face])
    assert not has_face(wearer, [face])


def test_a_couple_in_an_embrace_is_two() -> None:
    assert not same_body(body(100, 400), body(280, 580))


@pytest.mark.parametrize(
    ("other", "same"),
    [
        (Crop(635.0, 925.0, 1640.0, 1640.0, 0.05), True),  # another tile's find of the same person
        (Crop(700.0, 925.0, 1700.0, 1700.0), False),  # hips 10 cm away
        (Crop(607.0, 1010.0, 1300.0, 1300.0), False),  # a child before
    ],
)
def test_crops_of_one_person_are_looked_at_once(other: Crop, same: bool) -> None:
    assert same_crop(Crop(607.0, 919.0, 1748.0, 1748.0), other) == same
