"""Hands get nails and creases where they belong, and keep what photos show."""

from types import SimpleNamespace

import numpy as np
import pytest

from cloner.body.feet import close_toes
from cloner.generic.load import load_generic
from cloner.generic.surfaces import surface_normals
from cloner.paint.details.hand_detail import fingers
from cloner.paint.details.hands import UNDER, finish_hands, finish_soles, foot_texels, hand_texels
from cloner.records.bodies import BodyMesh

GENERIC = load_generic()
SIZE = 1024
SKIN = np.array([190, 150, 130], np.uint8)


def finished(rgb: np.ndarray, *, shown: float, bare: float = 1.0) -> np.ndarray:
    kinds = SimpleNamespace(bare=np.full(len(GENERIC.vertices_m), bare))
    return finish_hands(rgb, np.full(len(GENERIC.vertices_m), shown), kinds)


@pytest.fixture(scope="module")
def plain() -> np.ndarray:
    return np.tile(SKIN, (SIZE, SIZE, 1))


def test_every_finger_has_a_nail_on_its_back_and_creases_inside() -> None:
    atlas, gains, nails, _, left = hand_texels(SIZE)
    points = atlas.interpolate(GENERIC.vertices_m).astype(float)
    normals = atlas.interpolate(surface_normals(GENERIC.vertices_m.astype(float)))
    wrist, index, little = (GENERIC.joints_m[GENERIC.joint(f"l_{name}")] for name in ("wrist", "index1", "pinky1"))
    palm = np.cross(little - wrist, index - wrist)
    for number, finger in enumerate(fingers()):
        near = left & (np.linalg.norm(points - finger.bones_m[3], axis=1) < 0.025) & (nails > 0.5)
        assert near.sum() >= 12, "texels"
        if number:  # a thumb's nail looks aside
            assert np.quantile(normals[near] @ palm, 0.9) < 0.0
    assert gains[nails < 0.01].min() < -0.1, "creases are drawn"
    assert gains.max() < 0.4, "no nail glows"
    assert nails[left].sum() == pytest.approx(nails[~left].sum(), rel=0.05), "both hands"
    assert nails.mean() < 0.08, "a nail is no finger"


def test_a_blot_that_no_photo_shows_goes_and_one_that_a_photo_shows_stays(plain: np.ndarray) -> None:
    atlas, _, nails, beyond, _ = hand_texels(SIZE)
    spot = atlas.texel[np.flatnonzero((beyond == 1.0) & (nails == 0.0))[:240]]
    rgb = plain.copy()
    rgb.reshape(-1, 3)[spot] = (110, 60, 140)
    far = {shown: np.abs(finished(rgb, shown=shown).reshape(-1, 3)[spot].astype(float) - SKIN).mean()
           for shown in (0.0, 1.0)}  # fmt: skip
    assert far[0.0] < 25.0, "levels from the skin"
    assert far[1.0] > 35.0, "a shown mark is still a mark"


def test_gloves_and_the_rest_of_the_atlas_stay_as_they_are(plain: np.ndarray) -> None:
    assert (finished(plain, shown=1.0, bare=0.0) == plain).all()
    out = finished(plain, shown=1.0)
    own = np.zeros(SIZE * SIZE, bool)
    own[hand_texels(SIZE)[0].texel] = True
    assert (out.reshape(-1, 3)[~own] == SKIN).all()
    assert np.median(np.abs(out.reshape(-1, 3)[own].astype(int) - SKIN)) <= 4, "most skin keeps its colour"


def _down(points: np.ndarray) -> np.ndarray:
    """Return how far the surface faces up in every texel of the feet, -1..1."""
    return foot_texels(SIZE).interpolate(surface_normals(points)[:, 1])


def test_a_toes_colour_does_not_run_on_to_the_sole(plain: np.ndarray) -> None:
    points = GENERIC.vertices_m.astype(float)
    atlas, up = foot_texels(SIZE), _down(points)
    rgb = plain.copy()
    rgb.reshape(-1, 3)[atlas.texel] = (40, 40, 40)
    spot, upper = atlas.texel[np.flatnonzero(up < UNDER[1])[:200]], atlas.texel[up > UNDER[0]]
    rgb.reshape(-1, 3)[np.concatenate([spot, upper])] = (230, 230, 230)
    out = finish_soles(rgb, points).reshape(-1, 3)
    assert np.abs(out[spot].astype(int) - 40).max() < 15, "levels"
    assert (out[upper] == 230).all(), "the shoe keeps its colour"


def test_the_undersides_of_toes_are_no_soles_on_a_shoes_tip(plain: np.ndarray) -> None:
    bare = BodyMesh(GENERIC.vertices_m.astype(float), GENERIC.joints_m.astype(float))
    shod = close_toes(bare).vertices_m
    atlas = foot_texels(SIZE)
    front = (_down(bare.vertices_m) < UNDER[1]) & (_down(shod) > UNDER[0])
    assert front.sum() > 30, "texels that hang under toes and lie before a shoe"
    rgb = plain.copy()
    rgb.reshape(-1, 3)[atlas.texel] = (40, 40, 40)
    rgb.reshape(-1, 3)[atlas.texel[front]] = (230, 230, 230)
    assert (finish_soles(rgb, shod).reshape(-1, 3)[atlas.texel[front]] == 230).all()


def test_trousers_painted_on_to_fingertips_go(plain: np.ndarray) -> None:
    atlas, _, nails, beyond, _ = hand_texels(SIZE)
    tips = np.zeros(len(GENERIC.vertices_m))
    for side in "lr":
        for name in ("index", "middle", "ring"):
            joint = GENERIC.joint(f"{side}_{name}3")
            tips[(GENERIC.skin_joints[:, 0] == joint) & (GENERIC.vertex_part == 0)] = 1.0
    rgb, dark = plain.copy(), np.flatnonzero((atlas.interpolate(tips) == 1.0) & (beyond == 1.0) & (nails == 0.0))
    rgb.reshape(-1, 3)[atlas.texel[dark]] = (40, 40, 60)
    out = finish_hands(rgb, np.ones(len(GENERIC.vertices_m)), SimpleNamespace(bare=1.0 - tips)).reshape(-1, 3)
    assert len(dark) > 500, "texels"
    assert np.abs(out[atlas.texel[dark]].astype(float) - SKIN).mean() < 25.0, "levels, though a photo showed them well"
