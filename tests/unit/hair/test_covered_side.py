"""A side photo of the face without a profile stands where the body's side photo says."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.hair.volumes.covered_side import align_heads, covered_side_views, level_camera
from cloner.records.labels import Label
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from tests.kit import painted, people, studio

LONG = ((30, 20), (70, 8), (110, 22), (122, 70), (112, 150), (40, 158), (18, 90))
TAIL = ((60, 20), (90, 8), (118, 30), (112, 60), (70, 70), (30, 150), (-40, 160), (20, 60))


def shown(size, scale, shift, turn=0.0, *, body=False, hair=LONG):
    """Return a proposal that shows a head with hair, drawn larger and shifted."""
    hair = np.array(hair, np.float64)
    face = np.array([[112, 60], [126, 80], [118, 96], [112, 110]], np.float64)
    trunk = np.array([[20, 140], [120, 140], [130, 420], [10, 420]], np.float64)
    linear = scale * np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])

    def filled(*shapes):
        picture = np.zeros(size[::-1], np.uint8)
        for shape in shapes:
            cv2.fillPoly(picture, [np.rint(shape @ linear.T + shift).astype(np.int32)], 1)
        return picture > 0

    person = filled(hair, face, trunk)
    labels = np.where(filled(hair), Label.HAIR, np.where(person, Label.UPPER_CLOTHES, 0)).astype(np.uint8)
    view = ViewId.BODY_SIDE if body else ViewId.FACE_SIDE
    return replace(studio.empty_proposal(view, person), labels=labels), np.column_stack([linear, shift])


def test_the_head_of_a_portrait_is_laid_on_that_of_the_whole_figure():
    near, near_from = shown((600, 700), 3.1, (40.0, 60.0), 0.05)
    far, far_from = shown((500, 900), 1.2, (170.0, 40.0), body=True)
    laid = align_heads(near, far)
    assert laid is not None
    points = np.array([[30.0, 20.0], [70.0, 8.0], [122.0, 70.0], [70.0, 120.0]])
    in_near = points @ near_from[:, :2].T + near_from[:, 2]
    wanted = points @ far_from[:, :2].T + far_from[:, 2]
    assert np.linalg.norm(in_near @ laid[:, :2].T + laid[:, 2] - wanted, axis=1).max() < 4.0


def test_without_hair_nothing_is_laid():
    near, _ = shown((600, 700), 3.1, (40.0, 60.0))
    far, _ = shown((500, 900), 1.2, (170.0, 40.0), body=True)
    assert align_heads(replace(near, labels=np.zeros_like(near.labels)), far) is None
    assert align_heads(near, replace(far, mask=np.zeros_like(far.mask))) is None


@pytest.mark.parametrize("mirrored", [False, True])
def test_another_head_and_the_other_side_of_a_head_are_not_laid(mirrored):
    near, _ = shown((600, 700), 2.4, (160.0, 60.0), hair=TAIL)
    far, _ = shown((500, 900), 1.2, (170.0, 40.0), body=True, hair=TAIL if mirrored else LONG)
    if mirrored:
        near = replace(near, mask=near.mask[:, ::-1].copy(), labels=near.labels[:, ::-1].copy())
    assert align_heads(near, far) is None


def test_a_similarity_between_two_level_photos_gives_the_camera_back():
    generic = load_generic()
    head = generic.vertices_m[generic.segment("head")].astype(np.float64)
    far = studio.camera(90.0, size_px=(800, 1200), height_m=1.1, aim_m=1.1)
    level_m = float(head[:, 1].mean())
    true = studio.camera(90.0, size_px=(700, 900), distance_m=1.2, height_m=level_m, aim_m=level_m)
    middle = head.mean(axis=0)
    before, after = (camera.project(np.stack([middle, middle + (0.0, 0.1, 0.0)])) for camera in (true, far))
    scale = np.linalg.norm(after[1] - after[0]) / np.linalg.norm(before[1] - before[0])
    laid = np.column_stack([scale * np.eye(2), after[0] - scale * before[0]])
    near = studio.empty_proposal(ViewId.FACE_SIDE, np.ones((900, 700), bool))
    found = level_camera(far, laid, middle, near, true.focal_px)
    assert np.abs(found.project(head) - true.project(head)).max() < 0.02 * 900


@pytest.mark.parametrize("missing", ["placed", "no side photo"])
def test_a_photo_that_a_profile_placed_or_that_is_missing_gives_no_covered_view(missing):
    person = people.known_person(3)
    views = painted.BODY if missing == "no side photo" else (*painted.BODY, ViewId.FACE_SIDE)
    fit = painted.joined(person, {view: people.known_pose(k) for k, view in enumerate(views)})
    proposals = Proposals({view: studio.empty_proposal(view, np.ones((40, 30), bool)) for view in views})
    assert covered_side_views(load_generic(), fit, proposals, SilhouetteSet({}), 900.0) == []


def test_a_photo_left_out_for_its_hair_gives_its_hair_where_the_head_is():
    generic, person = load_generic(), people.known_person(3)
    fit = painted.joined(person, {view: people.known_pose(k) for k, view in enumerate(painted.BODY)})
    level_m = float(person.vertices_m[generic.segment("head"), 1].mean())
    aside_deg = studio.AZIMUTH_DEG[ViewId.BODY_SIDE]
    true = studio.camera(aside_deg, size_px=(700, 900), distance_m=1.3, height_m=level_m, aim_m=level_m - 0.03)
    skin, scalp = people.skin_triangles(), generic.region("scalp")

    def seen(view, vertices_m, camera):
        mask, hair = (studio.silhouette(vertices_m, faces, camera) for faces in (skin, skin[scalp[skin].all(axis=1)]))
        labels = np.where(hair, Label.HAIR, np.where(mask, Label.UPPER_CLOTHES, 0)).astype(np.uint8)
        return replace(studio.empty_proposal(view, mask), labels=labels)

    side = fit.views[ViewId.BODY_SIDE]
    far = seen(ViewId.BODY_SIDE, person.posed(side.rotations)[0], side.camera)
    near = seen(ViewId.FACE_SIDE, person.vertices_m, true)
    proposals = Proposals({ViewId.BODY_SIDE: far}, {ViewId.FACE_SIDE: "a reason"}, {ViewId.FACE_SIDE: near})
    straight, mirrored = covered_side_views(generic, fit, proposals, SilhouetteSet({}), true.focal_px)
    head = person.vertices_m[generic.segment("head")]
    away = np.linalg.norm(straight.posed.camera.project(head) - true.project(head), axis=1)
    assert away.mean() * 1000.0 * true.metres_per_pixel(head.mean(axis=0)) < 12.0
    shown = near.labels == Label.HAIR
    assert straight.hair.sum() > 0.5 * shown.sum()
    assert not (straight.hair & ~shown).any()
    assert (straight.flip_m is None, mirrored.flip_m is None) == (True, False)
