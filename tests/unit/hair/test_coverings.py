"""A headscarf whose labels change within the cloth is one thing again, a hood is worn; hair and other clothes stay."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.hair.clothing import coverings
from cloner.hair.clothing.coverings import head_covering, merge_covering_labels
from cloner.hair.volumes.pictures import distances_px
from cloner.hair.volumes.views import HairView
from cloner.records.labels import Label
from cloner.records.proposals import Proposals

SIZE = 200
SCALP = np.zeros((SIZE, SIZE), bool)
SCALP[30:80, 70:130] = True
SCARF = np.zeros((SIZE, SIZE), bool)
SCARF[25:130, 60:140] = True
FACE = np.zeros((SIZE, SIZE), bool)
FACE[60:110, 80:120] = True
TOP = np.zeros((SIZE, SIZE), bool)
TOP[130:, 40:160] = True
GREEN, SKIN, GREY, WALL = (70, 160, 110), (210, 170, 150), (80, 75, 85), (140, 100, 90)


def picture():
    """Return a photo (H, W, 3) of a face in a green scarf over a grey top, its folds half as light."""
    rgb = np.full((SIZE, SIZE, 3), WALL, np.uint8)
    rgb[TOP], rgb[SCARF] = GREY, GREEN
    rgb[SCARF & (np.arange(SIZE) % 40 < 12)[None, :]] = (52, 120, 82)
    rgb[FACE] = SKIN
    return rgb


def labelled(*, scarf=Label.ACCESSORY):
    """Return labels that call the scarf hair on its left, clothes below the chin and skin at its top."""
    labels = np.zeros((SIZE, SIZE), np.uint8)
    labels[TOP], labels[SCARF] = Label.UPPER_CLOTHES, scarf
    if scarf == Label.ACCESSORY:
        labels[25:130, 60:75] = Label.HAIR
        labels[100:130, 60:140] = Label.UPPER_CLOTHES
        labels[25:35, 90:110] = Label.FACE_SKIN
    labels[FACE] = Label.FACE_SKIN
    return labels


def test_the_cloth_is_found_whole_and_ends_at_face_and_top():
    found = head_covering(picture(), labelled(), SCALP) | (labelled() == Label.HAIR)
    wanted = SCARF & ~FACE
    assert (found & wanted).sum() > 0.97 * wanted.sum()
    assert (found & ~wanted).sum() < 0.02 * wanted.sum()


def test_stripes_are_one_cloth_and_glasses_none_of_it():
    """Half of a scarf is told to be clothes; its stripes are lighter and darker than the top."""
    rgb, labels = picture(), labelled()
    labels[25:35, 90:110] = Label.ACCESSORY
    labels[SCARF & ~FACE & (np.arange(SIZE) >= 110)[None, :]] = Label.UPPER_CLOTHES
    rgb[SCARF & ~FACE & (np.arange(SIZE) % 30 < 12)[:, None]] = (120, 40, 30)
    lens = np.zeros_like(FACE)
    lens[70:90, 80:100] = lens[75:80, 75:120] = True
    labels[lens], rgb[lens] = Label.ACCESSORY, (120, 40, 30)
    found, wanted = head_covering(rgb, labels, SCALP) | (labels == Label.HAIR), SCARF & ~FACE
    assert (found & wanted).sum() > 0.97 * wanted.sum()
    assert (found & ~wanted).sum() < 0.02 * wanted.sum()


@pytest.mark.parametrize("scarf", [Label.ACCESSORY, Label.HAIR, Label.UPPER_CLOTHES])
def test_only_what_is_worn_becomes_whole(scarf, monkeypatch):
    """Hair stays what its labels say; a hood has a volume as hair has, down to the neck, where it is the garment's."""
    monkeypatch.setattr(coverings, "visible_scalp", lambda *_: SCALP)
    monkeypatch.setattr(HairView, "to_view", lambda self, points: points)
    labels = labelled(scarf=scarf)
    hair = (labels == Label.HAIR) | (labels == Label.ACCESSORY)
    far = np.zeros((SIZE, SIZE), np.float32)
    posed = SimpleNamespace(
        view=ViewId.FACE_FRONT, camera=SimpleNamespace(project=lambda at: np.array([[100.0, 120.0]]))
    )
    view = HairView(posed, np.eye(4)[None], None, far, *distances_px(hair, labels > 0), labels == Label.UPPER_CLOTHES)
    proposals = Proposals({ViewId.FACE_FRONT: SimpleNamespace(view=ViewId.FACE_FRONT, labels=labels)})
    photos = {ViewId.FACE_FRONT: SimpleNamespace(rgb=picture())}
    nothing = np.zeros((0, 3))
    scalp = nothing, nothing, np.zeros((0, 3), np.int32)
    (seen,), hood = merge_covering_labels([view], photos, proposals, *scalp, np.zeros(3))
    assert hood == (scarf == Label.UPPER_CLOTHES)
    if scarf == Label.ACCESSORY:
        assert (seen.hair & SCARF & ~FACE).sum() > 0.97 * (SCARF & ~FACE).sum()
        assert not (seen.clothed & seen.hair).any()
    elif scarf == Label.UPPER_CLOTHES:
        hood = SCARF & ~FACE & (np.arange(SIZE) < 120)[:, None]
        assert (seen.hair ^ hood).sum() < 0.01 * hood.sum()
        assert seen.clothed[120:].any()
        assert not (seen.clothed & seen.hair).any()
    else:
        assert seen is view


def test_a_large_photo_that_takes_a_hood_for_a_scarf_is_outvoted():
    small, large = np.full((10, 10), Label.UPPER_CLOTHES, np.uint8), np.full((90, 90), Label.ACCESSORY, np.uint8)
    views = (ViewId.BODY_FRONT, ViewId.BODY_BACK, ViewId.FACE_SIDE)
    labels = dict(zip(views, (small, small, large), strict=True))
    places = {view: np.ones_like(own, bool) for view, own in labels.items()}
    assert coverings.is_hood(labels, places)
    assert not coverings.is_hood(labels | {ViewId.BODY_BACK: large[:10, :10]}, places)


@pytest.mark.parametrize(("below", "photos", "hood"), [(TOP, 2, True), (TOP, 1, False), (TOP & ~TOP, 3, False)])
def test_cloth_that_goes_on_as_a_garment_in_most_photos_is_a_hood(below, photos, hood):
    """A hood that labels take for hair and scarves shows by its colour that it is the garment's."""
    labels = labelled()
    views = (ViewId.BODY_FRONT, ViewId.BODY_BACK, ViewId.FACE_SIDE)
    cloth = {view: SCARF | (below if k < photos else TOP & ~TOP) for k, view in enumerate(views)}
    assert coverings.goes_on_below(cloth, dict.fromkeys(views, labels), dict.fromkeys(views, 130.0)) == hood


@pytest.mark.parametrize("thing", [Label.ACCESSORY, Label.UPPER_CLOTHES])
def test_glasses_and_a_patch_on_a_bald_head_are_no_covering(thing, monkeypatch):
    monkeypatch.setattr(coverings, "visible_scalp", lambda *_: SCALP)
    labels = labelled(scarf=Label.FACE_SKIN)
    labels[72:76, 70:130] = thing
    view = SimpleNamespace(posed=SimpleNamespace(view=ViewId.FACE_FRONT), flip_m=None)
    proposals = Proposals({ViewId.FACE_FRONT: SimpleNamespace(view=ViewId.FACE_FRONT, labels=labels)})
    scalp = np.zeros((0, 3)), np.zeros((0, 3)), np.zeros((0, 3), np.int32)
    views = [view]
    assert merge_covering_labels(views, {}, proposals, *scalp, np.zeros(3))[0] is views
