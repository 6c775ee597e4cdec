"""Clothes on a scalp: a hood stays, a patch in one photo becomes the hair that the others show."""

import dataclasses
from types import SimpleNamespace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.hair.clothing import hoods
from cloner.hair.volumes.pictures import distances_px
from cloner.hair.volumes.views import HairView
from cloner.records.labels import Label

SIZE = 60
SCALP = np.zeros((SIZE, SIZE), bool)
SCALP[10:30, 15:45] = True


def _photo(view: ViewId, clothed: np.ndarray) -> HairView:
    person = np.zeros((SIZE, SIZE), bool)
    person[8:58, 10:50] = True
    hair = SCALP & ~clothed
    below = np.zeros_like(person)
    below[40:58, 10:50] = True
    far = np.zeros((SIZE, SIZE), np.float32)
    posed = SimpleNamespace(view=view)
    return HairView(posed, np.eye(4)[None], None, far, *distances_px(hair, person), (clothed & SCALP) | below)


@pytest.fixture(autouse=True)
def scalp(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(hoods, "visible_scalp", lambda *_: SCALP)


def _cleaned(*clothed: np.ndarray) -> list[HairView]:
    views = [_photo(view, own) for view, own in zip((ViewId.BODY_FRONT, ViewId.BODY_BACK), clothed, strict=True)]
    nothing = np.zeros((0, 3))
    return hoods.relabel_single_hoods(views, nothing, nothing, np.zeros((0, 3), np.int32))


def test_a_patch_of_clothes_on_a_crown_becomes_hair():
    patch = np.zeros((SIZE, SIZE), bool)
    patch[12:24, 22:38] = True
    front, back = _cleaned(np.zeros_like(patch), patch)
    assert np.array_equal(back.hair, SCALP)
    assert np.array_equal(back.hair_px, front.hair_px)


def test_a_hood_in_both_photos_stays():
    front, back = _cleaned(SCALP, SCALP)
    assert not front.hair.any()
    assert not back.hair.any()


def test_clothes_beside_the_scalp_stay_clothes():
    patch = np.zeros((SIZE, SIZE), bool)
    patch[12:24, 22:38] = True
    _, back = _cleaned(np.zeros_like(patch), patch)
    assert not back.hair[40:58].any()


def test_a_neck_below_a_high_hairline_stays_skin():
    """It is one piece with the back below, which lies on no scalp."""
    neck = np.zeros((SIZE, SIZE), bool)
    neck[24:40, 25:35] = True
    front, back = (_photo(view, neck) for view in (ViewId.BODY_FRONT, ViewId.BODY_BACK))
    whole = back.clothed | neck
    views = [front, dataclasses.replace(back, clothed=whole)]
    nothing = np.zeros((0, 3))
    found = hoods.relabel_single_hoods(views, nothing, nothing, np.zeros((0, 3), np.int32))[1]
    assert np.array_equal(found.hair, SCALP & ~neck)


def test_a_hood_is_the_clothes_on_the_head_down_to_the_neck():
    labels = np.zeros((SIZE, SIZE), np.uint8)
    labels[8:58, 10:50] = Label.UPPER_CLOTHES
    labels[14:34, 20:40] = Label.FACE_SKIN
    labels[5:12, 52:58] = Label.UPPER_CLOTHES  # a raised hand's sleeve
    labels[22, 18:42] = Label.ACCESSORY  # glasses, their arms in the hood
    labels[10:20, 12:18] = Label.ACCESSORY  # a part of the hood that looks like a scarf
    labels[24:30, 10:16] = Label.HAIR  # and one that looks like hair
    alike = np.zeros_like(labels, bool)
    alike[30:34, 8:14] = True  # and one that labels lose
    found = hoods.hood_pixels(labels, alike, SCALP, 35.2)
    wanted = np.isin(labels, (Label.UPPER_CLOTHES, Label.ACCESSORY, Label.HAIR)) | alike
    wanted[22, 18:42] = False
    wanted[36:] = False
    wanted[:, 52:] = False
    assert np.array_equal(found, wanted)
    assert not hoods.hood_pixels(labels, alike, SCALP, 0.0).any()
