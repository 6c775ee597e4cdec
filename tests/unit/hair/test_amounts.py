"""A photo that lost its hair, or whose camera stands wrong, is found by what the other photos show above the ears."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.hair.volumes.amounts import FEWEST, area_above_ears_mm2, inconsistent_views
from cloner.hair.volumes.pictures import distances_px
from cloner.hair.volumes.views import HairView
from kit import studio

SIZE = 400
ROW, COLUMN = np.mgrid[:SIZE, :SIZE]
NAMES = (ViewId.BODY_FRONT, ViewId.BODY_SIDE, ViewId.BODY_BACK, ViewId.FACE_FRONT, ViewId.FACE_SIDE)
EARS = np.zeros(3)


def view(name, wide_mm, high_mm, flip_m=None):
    """Return a photo of a head that is an ellipse's upper half above the ears, a millimetre a pixel."""
    person = ((COLUMN - 199.5) / (0.5 * wide_mm)) ** 2 + ((ROW - 199.5) / high_mm) ** 2 < 1.0
    camera = studio.orthographic(0.0, pixels_per_m=1000.0, aim_m=0.0, size_px=(SIZE, SIZE))
    hanger = SimpleNamespace(joints=np.zeros(4, int), shares=lambda points: (np.ones(len(points)), *np.zeros((2, 1))))
    posed = SimpleNamespace(view=name, camera=camera)
    still = np.tile(np.eye(4), (94, 1, 1))
    return HairView(posed, still, hanger, None, *distances_px(person, person), np.zeros_like(person), flip_m)


def test_what_stands_above_the_ears_is_measured_in_square_millimetres():
    assert area_above_ears_mm2(view(NAMES[0], 160.0, 120.0), EARS) == pytest.approx(
        0.5 * np.pi * 80.0 * 120.0, rel=0.02
    )


def test_sides_are_deeper_than_fronts_are_wide_and_nods_differ():
    heads = [(150, 110), (210, 100), (150, 120), (160, 112), (200, 108)]
    views = [view(name, *size) for name, size in zip(NAMES, heads, strict=True)]
    assert inconsistent_views(views, EARS) == {}


@pytest.mark.parametrize(("size", "share"), [((110, 50), 0.3), ((300, 160), 2.7)])
@pytest.mark.parametrize("place", [0, 4])
def test_a_photo_with_far_less_or_more_is_named_with_its_share(size, share, place):
    heads = [(150, 115)] * len(NAMES)
    heads[place] = size
    views = [view(name, *each) for name, each in zip(NAMES, heads, strict=True)]
    found = inconsistent_views([*views, view(NAMES[4], *heads[4], flip_m=0.0)], EARS)
    assert set(found) == {NAMES[place]}
    assert found[NAMES[place]] == pytest.approx(share, rel=0.15)


def test_photos_without_hair_say_nothing():
    views = [view(name, 150.0, 115.0) for name in NAMES]
    bald = [replace(one, hair=np.zeros_like(one.hair), outline_px=np.full_like(one.outline_px, -1e3)) for one in views]
    assert inconsistent_views(bald, EARS) == {}
    assert inconsistent_views([*views[:3], *bald[3:]], EARS) == {}


def test_of_two_photos_nobody_knows_which_is_wrong():
    views = [view(NAMES[0], 150.0, 115.0), view(NAMES[1], 100.0, 40.0)]
    assert len(views) < FEWEST
    assert inconsistent_views(views, EARS) == {}
