"""Texels of the room's colour are found, the person's own are not."""

from dataclasses import replace

import numpy as np
import pytest

from cloner.evaluate.leaks import background_texels, person_colours
from cloner.evaluate.truth import TruthView
from cloner.frames import ViewId
from cloner.generic.charts import generic_atlas
from cloner.generic.load import load_generic
from cloner.records.clones import TextureAtlas
from cloner.render import render, render_mask
from kit.clones import toy_clone

WALL = (40, 190, 60)


@pytest.fixture(scope="module")
def photographed():
    """Return the toy clone, its front view, and the truth of a photo of it before a green wall."""
    clone = toy_clone(hair=False)
    seen = clone.views[ViewId.BODY_FRONT]
    photo = render(clone, seen.camera, seen.rotations, background=WALL)
    mask = render_mask(clone, seen.camera, seen.rotations)
    return clone, seen, TruthView(ViewId.BODY_FRONT, seen.camera, {}, {}, {}, mask, photo)


def _painted(clone, colour, rows):
    rgb = clone.atlas.rgb.copy()
    rgb[rows] = colour
    return replace(clone, atlas=TextureAtlas(rgb, clone.atlas.coverage))


def test_the_person_itself_has_no_texel_of_the_wall(photographed):
    clone, seen, truth = photographed
    assert background_texels(clone, load_generic(), seen, truth, person_colours([truth])) == 0


def test_texels_of_the_wall_are_counted_near_the_outline_only(photographed):
    clone, seen, truth = photographed
    person = person_colours([truth])
    green = _painted(clone, (44, 186, 62), np.s_[:])
    count = background_texels(green, load_generic(), seen, truth, person)
    charts = generic_atlas(load_generic(), len(green.atlas.rgb)).texel.size
    assert 0.01 * charts < count < 0.5 * charts
    red = _painted(clone, (180, 30, 120), np.s_[:])
    assert background_texels(red, load_generic(), seen, truth, person) == 0


def test_a_wall_of_the_persons_own_colour_tells_nothing(photographed):
    clone, seen, truth = photographed
    shirt = np.array([60, 90, 160], np.uint8)
    before = replace(truth, photo=np.where(truth.mask[..., None], truth.photo, shirt))
    tree = person_colours([before])
    assert background_texels(clone, load_generic(), seen, before, tree) == 0  # the shirt is the person's there
    blue = _painted(clone, shirt, np.s_[:])
    assert background_texels(blue, load_generic(), seen, before, tree) > 1000  # shoes and face are not
