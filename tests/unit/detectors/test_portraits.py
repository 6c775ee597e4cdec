"""A head at 90 degrees that fills the picture is a person, and a close photo, whatever the pose detector sees in it."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.detectors.nets import people as nets
from cloner.detectors.nets.litert import detect_pose
from cloner.detectors.nets.people import detect_people, padded_pose
from cloner.detectors.nets.portraits import is_cut_below
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.records.photos import Photo, PhotoSet
from cloner.records.proposals import Proposals
from cloner.records.views import Camera
from cloner.stages.figures import NobodySeen
from cloner.stages.photo_checks import check_photos
from cloner.stages.proposals import propose
from kit import painted, people
from kit.visitors import photo

SKIN, HAIR, WALL = (150.0, 110.0, 90.0), (40.0, 28.0, 22.0), (120, 150, 190)


def profile(facing):
    """Return a plain painted head seen from the side (600, 450, 3) and where its nose tip is, px."""
    generic = load_generic()
    vertices, triangles = generic.vertices_m.astype(float), people.skin_triangles()
    tip = vertices[generic.feature("nose_tip")]
    over = vertices[:, 1] - tip[1]
    hair = (over > 0.1) | ((over > 0.02) & (vertices[:, 2] < tip[2] - 0.06))
    colours = np.where(hair[:, None], HAIR, SKIN)
    pose = np.eye(4)
    pose[:3, :3] = [[0, 0, facing], [0, -1, 0], [facing, 0, 0]]
    pose[:3, 3] = np.array([0, 0, 1.2]) - pose[:3, :3] @ (tip * [0, 1, 1] - [0, 0.02, 0.1])
    camera = Camera(450, 600, 1500.0, pose)
    a, b, c = vertices[triangles].transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True) + 1e-12
    lit = 0.55 + 0.45 * np.clip(normals @ [-0.8 * facing, 0.4, 0.45], 0.0, 1.0)
    picture = painted.draw(vertices, triangles, colours[triangles].mean(axis=1) * lit[:, None], camera, background=WALL)
    return picture, camera.project(tip[None])[0]


@pytest.mark.parametrize("facing", [1, -1])
def test_a_profile_that_fills_the_picture_is_a_face_side_photo(facing):
    picture, tip_px = profile(facing)
    assert len(detect_people(picture)) == 1
    seen = Photo(ViewId.FACE_SIDE, picture, None, "", "face_side.png")
    proposal = propose(seen)
    check_photos(Proposals({ViewId.FACE_SIDE: proposal}), PhotoSet({ViewId.FACE_SIDE: seen}))
    assert np.hypot(*(proposal.pose_px[0] - tip_px)) < 30, "the nose is hinted within a tenth of the head"
    ears = proposal.pose_px[[7, 8], 0].mean()
    assert np.sign(proposal.pose_px[0, 0] - ears) == facing


def cut_at_the_crown(facing):
    """Return a painted profile whose head is cut a finger's breadth below its crown, and where its nose tip is, px."""
    picture, tip_px = profile(facing)
    wall = np.abs(picture.astype(int) - WALL).sum(axis=2) < 60
    top = int(np.flatnonzero(~wall.all(axis=1))[0]) + 12
    return np.ascontiguousarray(picture[top:]), tip_px - [0, top]


def test_a_head_that_is_cut_above_is_seen_with_room():
    picture, tip_px = cut_at_the_crown(1)
    pose = padded_pose(picture)
    assert pose is not None
    assert np.hypot(*(pose.points_px[0] - tip_px)) < 30, "the nose is hinted within a tenth of the head"
    assert pose.mask.shape == picture.shape[:2]
    person = np.abs(picture.astype(int) - WALL).sum(axis=2) > 60
    inside = pose.mask > 0.5
    assert (inside & person).sum() > 0.85 * (inside | person).sum()


def test_room_finds_nobody_on_a_wall_nor_below_a_free_crown():
    assert padded_pose(np.full((600, 450, 3), WALL, np.uint8)) is None
    assert padded_pose(profile(1)[0]) is None


@pytest.mark.parametrize("view", [ViewId.FACE_SIDE, ViewId.FACE_FRONT])
def test_side_photos_alone_are_given_room_where_nobody_is_seen(monkeypatch, view):
    picture, tip_px = cut_at_the_crown(-1)
    seen = Photo(view, picture, None, "", "face.png")

    def blind(rgb):
        return [] if rgb.shape == picture.shape else detect_people(rgb)

    monkeypatch.setattr(nets, "detect_people", blind)
    if view is ViewId.FACE_FRONT:
        with pytest.raises(NobodySeen):
            propose(seen)
        return
    assert np.hypot(*(propose(seen).pose_px[0] - tip_px)) < 30


def test_a_whole_body_stays_one():
    rgb = photo("anna", "plain", "body_side").rgb
    pose = detect_pose(rgb)
    assert pose is not None
    assert pose.points_px[[27, 28], 1].max() < rgb.shape[0]


def test_feet_on_the_floor_are_no_cut():
    person = np.zeros((256, 256))
    person[20:254, 110:140] = 1.0
    assert not is_cut_below(person)
    person[100:, 60:190] = 1.0
    assert is_cut_below(person)
