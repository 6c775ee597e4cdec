"""A corrected point is obeyed: the clone's outline or joint lies there, neighbours follow, nothing else moves.

The outline is judged by the filled picture of the person, not by the solver's own lines.
"""

import functools
from dataclasses import replace

import cv2
import numpy as np
import pytest
from scipy.spatial import cKDTree

from cloner.editing.face import preview_face
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.outlines.silhouette import triangle_normals
from cloner.records.bodies import PosedView
from cloner.records.points import PointSet, ViewPoints
from cloner.stages.obeyed import bend_silhouettes, obey, warnings_of
from kit import fitted, people, studio

FRONT, SIDE, BACK = ViewId.BODY_FRONT, ViewId.BODY_SIDE, ViewId.BODY_BACK
#: Farther than this from the place on the skin, nothing moves: at most 120 mm along the outline for these drags, and
#: along the line of sight what keeps a dent from showing its rim.
SUPPORT_MM = 230.0


def outline_distance_px(person, view, point_px):
    """Return the distance of a pixel from the border of the person's filled picture, by a picture 8 times as fine."""
    fine = 8.0
    corner = np.round(point_px) - 32.0
    pixels = (fitted.seen(person, view) - corner + 0.5) * fine - 0.5
    near = people.skin_triangles()
    near = near[(np.abs(pixels[near] - 256.0) < 2500.0).all(axis=(1, 2))]
    picture = np.zeros((512, 512), np.uint8)
    for triangle in np.round(pixels[near] * 16).astype(np.int32):
        cv2.fillConvexPoly(picture, triangle, 255, cv2.LINE_8, 4)
    edges, _ = cv2.findContours(picture, cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
    if not edges:
        return float("inf")
    line = np.concatenate(edges)[:, 0].astype(np.float64)
    line = line[((line > 0) & (line < 511)).all(axis=1)]
    place = (point_px - corner + 0.5) * fine - 0.5
    return float(np.linalg.norm(line - place, axis=1).min()) / fine if len(line) else float("inf")


def outline_place(view, name):
    """Return the place of the person's own outline nearest to a proposed point, and the outward normal, px."""
    _, points, outlines = fitted.fitted_person()
    line = np.concatenate(outlines.views[view].contours_px)
    at = int(np.argmin(np.linalg.norm(line - points.views[view].get(name), axis=1)))
    along = line[(at + 6) % len(line)] - line[at - 6]
    normal = np.array([along[1], -along[0]]) / np.linalg.norm(along)
    probe = np.round(line[at] + 4.0 * normal).astype(int)
    return line[at], -normal if outlines.views[view].mask[probe[1], probe[0]] else normal


def corrected(*moves):
    """Return body points in which some, given as (view, name, place), were placed by an operator."""
    _, points, _ = fitted.fitted_person()
    views = dict(points.views)
    for view, name, place in moves:
        old = views[view]
        names = old.names if name in old.names else (*old.names, name)
        grown = len(names) - len(old.names)
        positions = np.vstack([old.points_px, np.zeros((grown, 2))])
        confidence, fixed = np.append(old.confidence, np.ones(grown)), np.append(old.corrected, np.zeros(grown, bool))
        row = names.index(name)
        positions[row], confidence[row], fixed[row] = place, 1.0, True
        views[view] = ViewPoints(view, names, positions, confidence, fixed, points.views[view])
    return PointSet(views)


@functools.cache
def dragged(view, name, by_px):
    """Return the place a point was dragged to, outward by so many pixels, and the person before and after."""
    person, _, outlines = fitted.fitted_person()
    start, outward = outline_place(view, name)
    place = start + by_px * outward
    after, told = obey(person, corrected((view, name, place)), outlines)
    return place, person, after, told


def no_triangle_turns_over(before, after):
    triangles = people.skin_triangles()
    old, new = triangle_normals(before.vertices_m, triangles), triangle_normals(after.vertices_m, triangles)
    big = np.linalg.norm(old, axis=1) > 8e-6  # 4 mm2: smaller ones lie in nose, lips and nails
    cosine = (
        np.einsum("ta,ta->t", old, new) / np.linalg.norm(old, axis=1) / np.maximum(np.linalg.norm(new, axis=1), 1e-12)
    )
    return bool((cosine[big] > 0.0).all())


DRAGS = [
    (view, name, by)
    for view, name in (
        (FRONT, "waist_left"), (FRONT, "knee_outer_left"), (FRONT, "shoulder_end_right"), (SIDE, "chest_front"),
        (BACK, "knee_inner_right"), (FRONT, "neck_base_left"),
    )
    for by in (-30.0, -10.0, 10.0, 30.0)
    if name != "neck_base_left" or abs(by) < 20.0
]  # fmt: skip


@pytest.mark.parametrize(("view", "name", "by_px"), DRAGS)
def test_the_outline_passes_through_a_dragged_point_and_nothing_else_moves(view, name, by_px):
    place, before, after, told = dragged(view, name, by_px)
    assert outline_distance_px(before, view, place) > 0.6 * abs(by_px), "the point was off the outline"
    assert outline_distance_px(after, view, place) <= 1.0, name
    assert [(one.name, one.kind, one.note) for one in told] == [(name, "outline", "")]
    moved_mm = 1000.0 * np.linalg.norm(after.vertices_m - before.vertices_m, axis=1)
    most = before.vertices_m[moved_mm > 0.95 * moved_mm.max()]  # a ridge, as where an outline runs along a chest
    away_mm = 1000.0 * cKDTree(most).query(before.vertices_m)[0]
    assert moved_mm[away_mm > SUPPORT_MM].max() <= 2.0
    assert np.array_equal(after.joints_m, before.joints_m)
    assert no_triangle_turns_over(before, after)


@pytest.mark.parametrize(("view", "name", "by_px"), [drag for drag in DRAGS if drag[0] is not SIDE])
def test_the_other_side_of_the_body_stays(view, name, by_px):
    _, before, after, _ = dragged(view, name, by_px)
    moved_mm = 1000.0 * np.linalg.norm(after.vertices_m - before.vertices_m, axis=1)
    left = name.endswith("left")
    across = before.vertices_m[:, 0] < -0.06 if left else before.vertices_m[:, 0] > 0.06
    assert moved_mm.max() > 0.8 * abs(by_px), "1 px is 1.2 mm here"
    assert moved_mm[across].max() <= 2.0


@pytest.mark.parametrize("by_px", [-30.0, 30.0])
def test_neighbours_move_smoothly(by_px):
    _, before, after, _ = dragged(FRONT, "waist_left", by_px)
    triangles = people.skin_triangles()
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    shift = after.vertices_m - before.vertices_m
    length = np.linalg.norm(before.vertices_m[edges[:, 0]] - before.vertices_m[edges[:, 1]], axis=1)
    slope = np.linalg.norm(shift[edges[:, 0]] - shift[edges[:, 1]], axis=1) / np.maximum(length, 1e-3)
    assert slope.max() < 0.8, "a bend of 33 mm over 120 mm slopes by 0.5 at most, and a little more with a narrow side"


def test_several_points_are_obeyed_together():
    person, _, outlines = fitted.fitted_person()
    wanted = []
    for view, name, by_px in ((FRONT, "waist_left", 12.0), (FRONT, "waist_right", -9.0), (SIDE, "belly_front", 10.0),
                              (FRONT, "hip_left", -8.0), (BACK, "waist_left", 12.0)):  # fmt: skip
        start, outward = outline_place(view, name)
        wanted.append((view, name, start + by_px * outward))
    after, told = obey(person, corrected(*wanted), outlines)
    assert all(one.after_px <= 1.0 for one in told), [(one.name, one.after_px) for one in told]
    for view, name, place in wanted:
        assert outline_distance_px(after, view, place) <= 1.0, name
    assert no_triangle_turns_over(person, after)


@pytest.mark.parametrize(
    ("view", "name", "by_px"),
    [
        (FRONT, "l_knee", (12.0, 8.0)),
        (SIDE, "r_elbow", (-15.0, 5.0)),
        (BACK, "r_hip", (9.0, -4.0)),
        (FRONT, "l_ankle", (6.0, -8.0)),
    ],
)
def test_a_dragged_joint_is_met_by_the_pose_of_that_photo_and_the_skin_at_rest_stays(view, name, by_px):
    person, _, outlines = fitted.fitted_person()
    place = fitted.joint_px(person, view, name) + by_px
    after, told = obey(person, corrected((view, name, place)), outlines)
    assert np.linalg.norm(fitted.joint_px(after, view, name) - place) <= 1.0
    assert np.array_equal(after.vertices_m, person.vertices_m)
    shift_mm = 1000.0 * np.linalg.norm(after.joints_m - person.joints_m, axis=1)
    row = load_generic().joint(name)
    assert shift_mm[row] <= 20.0
    assert not np.delete(shift_mm, row).any(), "only the joint itself may move in its limb"
    for other in person.views:
        same = np.array_equal(after.views[other].rotations, person.views[other].rotations)
        assert same or other is view
    assert told[0].kind == "pose"
    assert told[0].note == ""


def test_photos_that_disagree_are_named_and_the_body_keeps_between():
    person, _, outlines = fitted.fitted_person()
    moves = []
    for view, by_px in ((FRONT, 30.0), (BACK, -30.0)):
        start, outward = outline_place(view, "waist_left")
        moves.append((view, "waist_left", start + by_px * outward))
    after, told = obey(person, corrected(*moves), outlines)
    warnings = warnings_of(told)
    assert len(warnings) >= 1
    assert any("body_front" in text and "waist_left" in text and "contradicts" in text for text in warnings), warnings
    assert no_triangle_turns_over(person, after)
    assert 1000.0 * np.linalg.norm(after.vertices_m - person.vertices_m, axis=1).max() < 45.0


def test_a_point_far_off_the_body_is_left_out_with_a_warning():
    person, _, outlines = fitted.fitted_person()
    start, outward = outline_place(FRONT, "waist_left")
    after, told = obey(person, corrected((FRONT, "waist_left", start + 200.0 * outward)), outlines)
    assert np.array_equal(after.vertices_m, person.vertices_m)
    (warning,) = warnings_of(told)
    assert warning.startswith("body_front: the corrected point waist_left")
    assert "cm off the body" in warning


def test_head_top_and_soles_move_no_skin():
    person, points, outlines = fitted.fitted_person()
    moves = [(FRONT, name, points.views[FRONT].get(name) + [0.0, 5.0]) for name in ("head_top", "sole_left")]
    after, told = obey(person, corrected(*moves), outlines)
    assert np.array_equal(after.vertices_m, person.vertices_m)
    assert {one.kind for one in told} == {"scale"}
    assert warnings_of(told) == ()


def test_without_corrections_the_person_is_the_same_object():
    person, points, outlines = fitted.fitted_person()
    after, told = obey(person, points, outlines)
    assert after is person
    assert told == ()


@pytest.mark.parametrize(("name", "lift_px", "out_px"), [("waist_left", 45.0, 18.0), ("knee_outer_right", -70.0, -7.0)])
def test_an_outline_point_without_a_name_bends_the_skin_that_makes_the_outline_there(name, lift_px, out_px):
    person, points, outlines = fitted.fitted_person()
    line = np.concatenate(outlines.views[FRONT].contours_px)
    feature = points.views[FRONT].get(name)
    start = line[np.argmin(np.linalg.norm(line - feature - [0.0, lift_px], axis=1))]
    side = np.sign(feature[0] - person.views[FRONT].camera.centre_px[0])
    place = start + [side * out_px, 0.0]
    anchored = corrected((FRONT, "outline_1", place))
    bent, told = obey(person, anchored, outlines)
    assert outline_distance_px(bent, FRONT, place) < 0.5
    assert [(one.kind, one.note) for one in told] == [("outline", "")]
    shift = 1000.0 * np.linalg.norm(bent.vertices_m - person.vertices_m, axis=1)
    centre = person.vertices_m[np.argmax(shift)]
    assert shift[1000.0 * np.linalg.norm(person.vertices_m - centre, axis=1) > SUPPORT_MM].max() == 0.0
    assert (
        np.linalg.norm(
            np.concatenate(bend_silhouettes(outlines, anchored, told).views[FRONT].contours_px) - place, axis=1
        ).min()
        < 0.1
    )


def test_the_outline_is_bent_through_the_point_too():
    person, _, outlines = fitted.fitted_person()
    start, outward = outline_place(FRONT, "waist_left")
    place = start + 20.0 * outward
    points = corrected((FRONT, "waist_left", place))
    _, told = obey(person, points, outlines)
    bent = bend_silhouettes(outlines, points, told)
    assert bent.views[SIDE] is outlines.views[SIDE]
    line = np.concatenate(bent.views[FRONT].contours_px)
    assert np.linalg.norm(line - place, axis=1).min() < 0.1
    grown = bent.views[FRONT].mask & ~outlines.views[FRONT].mask
    assert 300 < grown.sum() < 4000, "a bump of 20 px, some 100 px long"
    assert not (outlines.views[FRONT].mask & ~bent.views[FRONT].mask).any()
    rows, columns = np.nonzero(grown)
    assert np.hypot(columns - start[0], rows - start[1]).max() < 80.0


def test_a_dragged_face_point_is_shown_at_once_and_the_face_around_follows():
    person, _, _ = fitted.fitted_person()
    eye, far = person.features_m["eye_outer_L"], person.features_m["mouth_corner_R"]
    camera = studio.camera(0.0, distance_m=1.2, height_m=eye[1], aim_m=eye[1], size_px=(1200, 1600))
    close = ViewId.FACE_FRONT
    person = replace(person, views={**person.views, close: PosedView(close, camera, np.zeros((94, 3)))})
    start = camera.project(np.array([eye, far]))
    before = ViewPoints(close, ("eye_outer_L", "mouth_corner_R"), start, np.ones(2), np.zeros(2, bool))
    dragged_px = start + [[9.0, -4.0], [0.0, 0.0]]
    after = ViewPoints(close, before.names, dragged_px, np.ones(2), np.array([True, False]), before)
    bent, told = preview_face(person, PointSet({close: before}), PointSet({close: after}))
    generic = load_generic()
    seen = camera.project(bent.vertices_m[[generic.feature("eye_outer_L"), generic.feature("mouth_corner_R")]])
    assert np.linalg.norm(seen[0] - dragged_px[0]) <= 1.0
    assert np.linalg.norm(seen[1] - start[1]) < 0.5, "the mouth stays"
    moved_mm = 1000.0 * np.linalg.norm(bent.vertices_m - person.vertices_m, axis=1)
    beside = np.linalg.norm(person.vertices_m - eye, axis=1) > 0.06
    assert moved_mm[beside].max() <= 2.0
    assert [one.kind for one in told] == ["face"]
    again, nothing = preview_face(person, PointSet({close: after}), PointSet({close: after}))
    assert again is person, "what the last run has fitted already is not bent again"
    assert nothing == ()
