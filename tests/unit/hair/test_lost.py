"""Hair before a wall of its colour: the photo from the opposite side tells that it is there."""

from types import SimpleNamespace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.hair.volumes.lost import restore_lost_hair
from cloner.hair.volumes.pictures import distances_px
from cloner.hair.volumes.views import HairView

SIZE = 100
#: All hair, and the half of it that one photo lost.
HAIR, LOST = (np.zeros((SIZE, SIZE), bool) for _ in range(2))
HAIR[20:80, 20:80] = True
LOST[20:80, 50:80] = True
BROWN, PINK = (120, 70, 40), (230, 80, 160)


class _Camera:
    """Photo pixels are millimetres of a plane; nothing is mirrored."""

    width_px = height_px = SIZE

    def project(self, points_m: np.ndarray) -> np.ndarray:
        return points_m[:, :2] * 1e3

    def back_project(self, pixels: np.ndarray, near_m: np.ndarray) -> np.ndarray:
        return np.column_stack([pixels / 1e3, near_m[:, 2]])


@pytest.fixture(autouse=True)
def _still(monkeypatch):
    monkeypatch.setattr(HairView, "to_view", lambda self, points: points)
    monkeypatch.setattr(HairView, "to_rest", lambda self, points: points)
    monkeypatch.setattr(HairView, "pixel_mm", lambda self, points: 1.0)


def _seen(view: ViewId, hair: np.ndarray) -> HairView:
    nothing = np.zeros((SIZE, SIZE), bool)
    posed = SimpleNamespace(view=view, camera=_Camera())
    return HairView(posed, np.eye(4)[None], None, np.zeros((SIZE, SIZE)), *distances_px(hair, hair), nothing)


def _photo(wall: tuple[int, int, int]) -> SimpleNamespace:
    rgb = np.tile(np.array(wall, np.uint8), (SIZE, SIZE, 1))
    rgb[HAIR] = BROWN
    return SimpleNamespace(rgb=rgb)


def _hair(front: np.ndarray, back: np.ndarray, wall: tuple[int, int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Return the hair of both photos; the back's wall is given, the front's pink."""
    photos = {ViewId.BODY_FRONT: _photo(PINK), ViewId.BODY_BACK: _photo(wall)}
    views = [_seen(ViewId.BODY_FRONT, front), _seen(ViewId.BODY_BACK, back)]
    found = restore_lost_hair(views, photos, np.zeros(3))
    return found[0].hair, found[1].hair


def test_a_wall_like_hair_is_hair_where_the_opposite_photo_has_the_person():
    front, back = _hair(HAIR, HAIR & ~LOST, BROWN)
    assert np.array_equal(front, HAIR)
    inner = np.zeros_like(HAIR)
    inner[32:68, 20:68] = True  # well inside the other's outline
    assert back[inner].all()
    assert not back[~HAIR].any()


def test_a_wall_of_another_colour_is_believed():
    photos = {ViewId.BODY_FRONT: _photo(PINK), ViewId.BODY_BACK: _photo(PINK)}
    photos[ViewId.BODY_BACK].rgb[LOST] = PINK
    views = [_seen(ViewId.BODY_FRONT, HAIR), _seen(ViewId.BODY_BACK, HAIR & ~LOST)]
    assert restore_lost_hair(views, photos, np.zeros(3))[1] is views[1]


def test_what_hangs_on_no_hair_stays_lost():
    sleeve = np.zeros_like(HAIR)
    sleeve[20:80, 56:80] = True
    front = (HAIR & ~LOST) | sleeve
    photos = {ViewId.BODY_FRONT: _photo(PINK), ViewId.BODY_BACK: _photo(PINK)}
    views = [_seen(ViewId.BODY_FRONT, front), _seen(ViewId.BODY_BACK, HAIR & ~LOST)]
    assert restore_lost_hair(views, photos, np.zeros(3))[1] is views[1]


def test_side_photos_and_photos_alone_say_nothing():
    views = [_seen(ViewId.BODY_SIDE, HAIR), _seen(ViewId.BODY_BACK, HAIR & ~LOST)]
    photos = {ViewId.BODY_SIDE: _photo(PINK), ViewId.BODY_BACK: _photo(BROWN)}
    assert restore_lost_hair(views, photos, np.zeros(3))[1] is views[1]
