"""Texels of the room's colour are found, the person's own are not."""

from dataclasses import replace

import numpy as np
import pytest

from cloner.evaluate.figures.leaks import background_texels
from cloner.evaluate.truths.truth import TruthView
from cloner.frames import ViewId
from cloner.generic.charts import generic_atlas
from cloner.generic.load import load_generic
from cloner.records.clones import TextureAtlas
from cloner.render import render, render_mask
from kit.clones import toy_clone

WALL = (40, 190, 60)


def _count(clone, truth):
    return background_texels(clone, load_generic(), {ViewId.BODY_FRONT: truth})[ViewId.BODY_FRONT]


@pytest.fixture(scope="module")
def photographed():
    """Return the toy clone and the truth of a photo of it before a green wall."""
    clone = toy_clone(hair=False)
    seen = clone.views[ViewId.BODY_FRONT]
    photo = render(clone, seen.camera, seen.rotations, background=WALL)
    mask = render_mask(clone, seen.camera, seen.rotations)
    return clone, TruthView(ViewId.BODY_FRONT, seen.camera, {}, {}, {}, mask, photo)


def _painted(clone, colour, rows):
    rgb = clone.atlas.rgb.copy()
    rgb[rows] = colour
    return replace(clone, atlas=TextureAtlas(rgb, clone.atlas.coverage))


def test_the_person_itself_has_no_texel_of_the_wall(photographed):
    clone, truth = photographed
    assert _count(clone, truth) == 0


def test_texels_of_the_wall_are_counted_near_the_outline_only(photographed):
    clone, truth = photographed
    green = _painted(clone, (44, 186, 62), np.s_[:])
    count = _count(green, truth)
    charts = generic_atlas(load_generic(), len(green.atlas.rgb)).texel.size
    assert 0.01 * charts < count < 0.5 * charts
    red = _painted(clone, (180, 30, 120), np.s_[:])
    assert _count(red, truth) == 0


def test_a_wall_of_the_persons_own_colour_tells_nothing(photographed):
    clone, truth = photographed
    shirt = np.array([60, 90, 160], np.uint8)
    before = replace(truth, photo=np.where(truth.mask[..., None], truth.photo, shirt))
    assert _count(clone, before) == 0  # the shirt is the person's there
    blue = _painted(clone, shirt, np.s_[:])
    assert _count(blue, before) > 1000  # shoes and face are not
