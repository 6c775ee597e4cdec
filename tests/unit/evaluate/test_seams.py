"""A collar on the border of head and body is no seam; a jump of the skin's colour there is one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cloner.evaluate.figures.seams import seam_ratios
from cloner.frames import ViewId
from cloner.generic.charts import generic_atlas
from cloner.generic.load import load_generic
from cloner.records.clones import TextureAtlas
from cloner.records.regions import REGIONS
from cloner.render import render
from kit.clones import toy_clone

SIZE = 1024
SKIN, CLOTH = (200, 150, 130), (40, 60, 120)


def painted(below):
    """Return a clone, noisy skin above the border of head and body, ``below`` beneath; and what is beneath."""
    generic = load_generic()
    triangles = generic.triangles()[0]
    beneath = ~(generic.head_blend > 0.5)[triangles].any(axis=1)
    atlas = generic_atlas(generic, SIZE)
    rgb = np.tile(np.array(SKIN, np.uint8), (SIZE * SIZE, 1))
    rgb[atlas.texel[beneath[atlas.triangle]]] = below
    noisy = rgb + np.random.default_rng(2).normal(0.0, 3.0, rgb.shape)
    texels = np.clip(noisy, 0, 255).astype(np.uint8).reshape(SIZE, SIZE, 3)
    clone = replace(toy_clone(1.70), atlas=TextureAtlas(texels, np.full((SIZE, SIZE), 255, np.uint8)))
    return clone, beneath


def labelled(clone, beneath, name):
    labels = np.where(beneath, REGIONS.index(name), REGIONS.index("skin")).astype(np.uint8)
    return replace(clone, triangle_regions=labels)


def test_a_collar_is_no_seam():
    clone, beneath = painted(CLOTH)
    found = seam_ratios(labelled(clone, beneath, "upper_clothes"), load_generic())["head_body"]
    assert found is None or found < 1.6
    assert seam_ratios(replace(clone, triangle_regions=np.zeros(0, np.uint8)), load_generic())["head_body"] > 3.0


def test_a_jump_of_the_skin_is_a_seam():
    clone, beneath = painted((150, 105, 90))
    assert seam_ratios(labelled(clone, beneath, "skin"), load_generic())["head_body"] > 2.0


def test_what_the_photos_show_is_no_seam():
    clone, beneath = painted((150, 105, 90))
    shaded = labelled(clone, beneath, "skin")  # a shade on the neck, and the same texture on a person without it
    plain = labelled(*painted(SKIN), "skin")
    photos = {view: render(shaded, seen.camera, seen.rotations) for view, seen in clone.views.items()}
    assert set(photos) == {ViewId.BODY_FRONT, ViewId.BODY_SIDE}
    true, washed = (seam_ratios(who, load_generic(), photos)["head_body"] for who in (shaded, plain))
    assert 0.4 < true < 1.3  # the photos are coarser than the atlas
    assert washed < 0.6 * true
    unshaded = {view: render(plain, seen.camera, seen.rotations) for view, seen in clone.views.items()}
    assert seam_ratios(shaded, load_generic(), unshaded)["head_body"] > 1.3 / 0.55
