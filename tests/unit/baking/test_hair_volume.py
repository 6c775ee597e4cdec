"""Hair's field is no thicker than the hair, also over ears that were pressed flat and folded."""

from types import SimpleNamespace

import numpy as np

from cloner.baking.hair_cap import Scalp
from cloner.baking.hair_volume import TAIL_DOUBT_MM, near_skin, tail_mm
from cloner.frames import ViewId

SIDE_MM, THICK_MM, FOLD_M = 4.0, 20.0, 0.01


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
    return Scalp(points, up, triangles, one[None], one, one, THICK_MM * one)


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
