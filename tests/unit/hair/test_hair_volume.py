"""Hair's field is no thicker than the hair, also over ears that were pressed flat and folded."""

from types import SimpleNamespace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.hair.volumes.cap import FACE_PHOTO, Scalp
from cloner.hair.volumes.grid import attached_to
from cloner.hair.volumes.hanging import LYING_MM, hanging_mm, has_side_view
from cloner.hair.volumes.rows import ROUND_MM, agreed_mm
from cloner.hair.volumes.volume import (
    TAIL_DOUBT_MM,
    cap_mm,
    lying_hair_mm,
    near_lying_hair,
    near_skin,
    overhang_mm,
    tail_mm,
)

SIDE_MM, THICK_MM, FOLD_M = 4.0, 20.0, 0.01
WIDE = (-0.08, 0.08)  # a head's sides
DEEP = (-0.12, 0.12)


def _folded_sheet():
    """Return a level scalp whose middle triangles lie upside down, as those of an ear pressed flat do."""
    row, column = np.mgrid[-10:11, -10:11]
    points = SIDE_MM / 1000 * np.stack([column, row, np.zeros_like(row)], axis=-1).reshape(-1, 3)
    first = (np.arange(20)[:, None] * 21 + np.arange(20)).ravel()
    halves = [np.stack([first, first + 1, first + 22], 1), np.stack([first, first + 22, first + 21], 1)]
    triangles = np.concatenate(halves).astype(np.int32)
    folded = np.linalg.norm(points[triangles].mean(axis=1), axis=1) < FOLD_M
    triangles[folded] = triangles[folded][:, ::-1]
    up, one = np.tile([0.0, 0.0, 1.0], (len(points), 1)), np.ones(len(points))
    return Scalp(points, up, np.zeros(3), triangles, one[None], one, one, THICK_MM * one)


def test_no_hair_stands_off_a_folded_ear_farther_than_it_is_thick():
    points = np.random.default_rng(4).uniform([-0.03, -0.03, 0.002], [0.03, 0.03, 0.06], (20_000, 3))
    hair, height_mm = near_skin(_folded_sheet(), points).cap_mm < 0.0, 1000.0 * points[:, 2]
    assert not hair[height_mm > THICK_MM + SIDE_MM * np.sqrt(2.0)].any()
    beside = np.linalg.norm(points[:, :2], axis=1) > 2.0 * FOLD_M
    assert np.array_equal(hair[beside], (height_mm < THICK_MM)[beside])


def test_what_the_front_photo_shows_as_room_is_no_tail_and_what_it_cannot_see_may_be():
    """A strand in the head's middle: 30 mm over the crown the front photo shows the room, behind the head nothing."""
    points = np.array([[0.0, 1.73, 0.0], [0.0, 1.55, -0.12]])
    judged = np.array([True, False])
    front = SimpleNamespace(
        posed=SimpleNamespace(view=ViewId.FACE_FRONT),
        evidence=lambda at: (np.where(at[:, 1] > 1.7, -30.0, 5.0), judged[: len(at)]),
    )
    strand = SimpleNamespace(inside_mm=lambda at: np.full(len(at), 8.0, np.float32))
    over, behind = tail_mm([front], strand, points)
    assert over == -30.0 + TAIL_DOUBT_MM
    assert behind == 8.0


def _slab(view, axis, half_mm, judged=True):
    """Return a photo that shows hair as a band of some half width along an axis, 1 mm a pixel."""
    camera = SimpleNamespace(project=lambda at: np.stack([200.0 + 1000.0 * at[:, axis], np.full(len(at), 2.0)], axis=1))
    return SimpleNamespace(
        posed=SimpleNamespace(view=view, camera=camera),
        flip_m=None,
        hair=np.tile(np.abs(np.arange(401) - 200.0) <= half_mm, (5, 1)),
        seen_at=lambda at: (at, camera.project(at)),
        pixel_mm=lambda at: 1.0,
        evidence=lambda at, _=None: (
            (half_mm - 1000.0 * np.abs(at[:, axis])).astype(np.float32),
            np.full(len(at), judged),
        ),
    )


def test_hair_between_front_and_side_is_round_and_no_box():
    views = [_slab(ViewId.FACE_FRONT, 0, 100.0), _slab(ViewId.BODY_SIDE, 2, 100.0)]
    points = np.array([[0.0, 0.0, 0.0], [0.095, 0.0, 0.095], [0.095, 0.0, 0.0], [0.11, 0.0, 0.0]])
    inside, sides = agreed_mm(views, points, DEEP)
    # Corner: 5.5 mm inside either band's last pixel, 64.5 mm within the round edge's centre: 70 - sqrt(2) 64.5.
    assert np.allclose(inside, [ROUND_MM, ROUND_MM - np.sqrt(2.0) * (ROUND_MM - 5.5), 5.0, -10.0], atol=1e-3)
    assert np.array_equal(sides, [2, 2, 2, 2])


def test_two_photos_of_one_side_are_heard_together():
    """The body photo ends its hair 20 mm before this place, the face photo 20 mm behind it."""
    views = [_slab(ViewId.BODY_SIDE, 2, 80.0), _slab(ViewId.FACE_SIDE, 2, 120.0)]
    inside, sides = agreed_mm(views, np.array([[0.0, 0.0, 0.1]]), DEEP)
    assert np.allclose(inside, (-20.0 + FACE_PHOTO * 20.0) / (1.0 + FACE_PHOTO), atol=1e-3)
    assert sides[0] == 1


def test_a_photo_that_cannot_judge_is_not_heard():
    views = [_slab(ViewId.BODY_SIDE, 2, 80.0, judged=False), _slab(ViewId.BODY_BACK, 0, 30.0)]
    inside, sides = agreed_mm(views, np.array([[0.01, 0.0, 0.5]]), DEEP)
    assert np.allclose(inside, 20.0, atol=1e-3)
    assert sides[0] == 1


def test_hair_that_no_side_photo_shows_is_as_deep_as_usual():
    """Front and back photos see the same ends: together they made a slab of hair as deep as the grid."""
    views = [_slab(ViewId.BODY_FRONT, 0, 100.0), _slab(ViewId.BODY_BACK, 0, 100.0)]
    points = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 0.08], [0.0, 0.0, 0.2]])
    inside, sides = agreed_mm(views, points, DEEP)
    # Half as deep as 1.25 times the half width that counts, 70 mm.
    assert np.allclose(inside, [ROUND_MM, 7.5, -112.5], atol=1e-3)
    assert np.array_equal(sides, [2, 2, 2])
    told = agreed_mm([*views, _slab(ViewId.BODY_SIDE, 2, 250.0)], points, DEEP)[0]
    assert told[2] > 0.0


def test_hair_hangs_from_hair():
    """Of three locks one hangs from the head's hair, one from nothing, one is a speck that hangs."""
    shape = (30, 12, 12)
    grown, hanging = np.full(shape, -9.0, np.float32), np.full(shape, -9.0, np.float32)
    grown[:8] = 5.0
    hanging[8:18, :9, :9] = 5.0  # 810 voxels of 4 mm: 52 ml
    hanging[20:, :9, :9] = 5.0
    hanging[8:10, 11, 11] = 5.0
    rows = np.arange(grown.size)
    held = attached_to(grown.ravel(), hanging.ravel(), rows, shape).reshape(shape)
    assert held[8:18, :9, :9].all()
    assert held.sum() == 10 * 9 * 9


def test_a_photo_of_the_back_takes_nothing_from_the_width_that_the_front_photo_shows():
    """Both tell the same two ends of hair's plan: heard as two they rounded it twice, and 20 mm of an afro went."""
    seen = [_slab(ViewId.BODY_FRONT, 0, 100.0), _slab(ViewId.BODY_SIDE, 2, 100.0)]
    points = np.array([[x / 1000.0, 0.0, 0.0] for x in (60.0, 85.0, 95.0)])
    twice = [*seen, _slab(ViewId.BODY_BACK, 0, 100.0)]
    np.testing.assert_allclose(agreed_mm(twice, points, DEEP)[0], agreed_mm(seen, points, DEEP)[0], atol=1.0)
    assert agreed_mm(twice, points, DEEP)[0][1] > 10.0


def test_hair_that_a_photo_shows_on_the_back_lies_on_it_as_a_film():
    """A level back, seen from above; its left half is hair: over the skin it is as thick as a lock, right none."""
    row, column = np.mgrid[-10:11, -10:11]
    back = 0.01 * np.stack([column, row, np.zeros_like(row)], axis=-1).reshape(-1, 3)
    body = back, np.tile([0.0, 0.0, 1.0], (len(back), 1))
    line_px = np.tile(100.0 - np.arange(201.0, dtype=np.float32), (201, 1))  # 1 mm a pixel
    camera = SimpleNamespace(project=lambda at: 100.0 + 1000.0 * at[:, :2])
    seen = SimpleNamespace(
        posed=SimpleNamespace(camera=camera), line_px=line_px, to_view=lambda at: at, pixel_mm=lambda at: 1.0
    )
    points = np.array([[x, 0.0, z] for x in (-0.05, 0.05) for z in (-0.002, 0.5e-3 * LYING_MM, 1.5e-3 * LYING_MM)])
    field = cap_mm([seen], near_lying_hair(body, np.ones((1, len(back))), points))
    assert np.array_equal(field > 0.0, [True, True, False, False, False, False])
    np.testing.assert_allclose(field[1:3], [0.5 * LYING_MM, -0.5 * LYING_MM], atol=0.1)


@pytest.mark.parametrize(("view", "bounded"), [(ViewId.BODY_BACK, True), (ViewId.FACE_SIDE, False)])
def test_hair_that_lies_on_shoulders_is_no_wider_than_a_photo_of_the_back_shows_it(view, bounded):
    """A level skin that one photo calls hair; another shows hair within 40 mm of its middle, and nothing hides it."""
    row, column = np.mgrid[-10:11, -10:11]
    skin = 0.01 * np.stack([column, row, np.zeros_like(row)], axis=-1).reshape(-1, 3)
    votes = np.stack([np.ones(len(skin)), np.zeros(len(skin))])
    camera = SimpleNamespace(project=lambda at: 100.0 + 1000.0 * at[:, :2])

    def photo(of):
        return SimpleNamespace(
            posed=SimpleNamespace(view=of, camera=camera),
            line_px=np.full((201, 201), 100.0, np.float32),
            to_view=lambda at: at,
            pixel_mm=lambda at: 1.0,
            evidence=lambda at: (40.0 - 1000.0 * np.abs(at[:, 0]), at[:, 2] > 0.0),
        )

    points = np.array([[x, 0.0, z] for x in (0.0, 0.08) for z in (-0.002, 0.5e-3 * LYING_MM)])
    field = lying_hair_mm(
        [photo(ViewId.FACE_SIDE), photo(view)],
        near_lying_hair((skin, np.tile([0.0, 0.0, 1.0], (441, 1))), votes, points),
    )
    assert np.array_equal(field > 0.0, [True, True, not bounded, not bounded])


@pytest.mark.parametrize(("longer", "kept"), [(False, False), (True, True)])
def test_a_front_photo_alone_lets_hair_stand_before_a_temple_only_if_it_goes_on_below_the_ears(longer, kept):
    """A crop's temples had flaps 25 mm thick: from the front they hide behind the hairline, aside they stand out."""
    front = _slab(ViewId.FACE_FRONT, 0, 100.0)
    ears_m = 1.6

    def evidence(at, _):
        hair = (at[:, 0] > 0.05) & (longer | (at[:, 1] > ears_m))
        return np.where(hair, 20.0, -20.0).astype(np.float32), np.ones(len(at), bool)

    front.evidence = evidence
    temple = np.array([[0.07, 1.65, 0.05]])
    field = hanging_mm([front], temple, np.array([15.0], np.float32), DEEP, WIDE, ears_m)
    assert (field[0] > 0.0) == kept
    assert has_side_view([front, _slab(ViewId.BODY_SIDE, 2, 100.0)])
    assert not has_side_view([front, _slab(ViewId.BODY_BACK, 0, 100.0)])


def test_hair_stands_out_over_its_line_only_where_a_photo_from_aside_ends_it():
    head = _folded_sheet()
    above = head.points_m + (0.0, 0.0, 0.01)
    front, aside = _slab(ViewId.FACE_FRONT, 0, 100.0), _slab(ViewId.BODY_SIDE, 1, 100.0)
    assert overhang_mm([front, aside], head, above).max() > 0.0
    assert overhang_mm([front], head, above).max() < 0.0


def test_long_hair_of_a_front_photo_alone_falls_beside_the_head_s_middle_however_wide_it_stands_off():
    """Wide curtains of hair had holes beside the ears: on the skin they drape 25 mm thick and no more."""
    front, wide_m = _slab(ViewId.FACE_FRONT, 0, 150.0), np.array([[0.12, 1.62, 0.0], [0.12, 1.62, 0.08]])
    ears_m, off_mm = 1.6, np.array([40.0, 40.0], np.float32)
    beside, before = hanging_mm([front], wide_m, off_mm, DEEP, WIDE, ears_m)
    assert beside > 0.0 > before
    high = wide_m + (0.0, 0.1, 0.0)
    assert (hanging_mm([front], high, off_mm, DEEP, WIDE, ears_m) < 0.0).all()  # there it would stand as horns


@pytest.mark.parametrize("from_m", [0.06, 0.1])
@pytest.mark.parametrize("longer", [False, True])
def test_hair_that_a_front_photo_shows_on_both_sides_of_the_neck_falls_behind_it(longer, from_m):
    """Behind long curtains the nape was bare."""
    front, ears_m = _slab(ViewId.FACE_FRONT, 0, 150.0), 1.6

    def evidence(at, _):
        hair = (np.abs(at[:, 0]) > from_m) & (longer | (at[:, 1] > ears_m))
        return np.where(hair, 20.0, -20.0).astype(np.float32), np.abs(at[:, 0]) > 0.06

    front.evidence = evidence
    nape, throat = np.array([[0.01, 1.55, -0.09]]), np.array([[0.01, 1.55, 0.09]])
    off_mm = np.array([12.0], np.float32)
    assert (hanging_mm([front], nape, off_mm, DEEP, WIDE, ears_m)[0] > 0.0) == longer
    assert hanging_mm([front], throat, off_mm, DEEP, WIDE, ears_m)[0] < 0.0


def test_hair_that_only_a_side_photo_shows_is_no_wider_than_the_head():
    """A tail behind the shoulders, of which no back photo told, was a slab as wide as they are."""
    aside = _slab(ViewId.FACE_SIDE, 2, 100.0)
    behind = np.array([[x, 1.5, 0.0] for x in (0.0, 0.07, 0.12)])
    field = hanging_mm([aside], behind, np.full(3, 5.0, np.float32), DEEP, WIDE, 1.6)
    assert list(field > 0.0) == [True, True, False]
