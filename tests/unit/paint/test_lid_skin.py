"""Painted lashes leave the upper lid; skin, brows and the lower lid stay as the photo shows them."""

import numpy as np
import pytest

from cloner.generic.face_grids import eye_grid
from cloner.generic.load import load_generic
from cloner.paint.details.lid_skin import _lid_charts, clean_lids
from kit.clones import toy_clone

SIZE = 1024
SKIN, DARK = (210, 160, 140), (40, 30, 28)


@pytest.fixture(scope="module")
def generic():
    return load_generic()


@pytest.fixture(scope="module")
def vertices():
    return toy_clone(1.7, hair=False).vertices_m


def texels(generic, rows):
    """Return the (N, 2) column and row of vertices in the atlas."""
    triangles, corners = generic.triangles()
    place = np.zeros((len(generic.vertices_m), 2), np.int64)
    place[triangles] = np.floor(generic.uv[corners] * SIZE)
    return place[rows]


def test_dark_strands_above_the_eye_become_skin(generic, vertices):
    rgb = np.full((SIZE, SIZE, 3), SKIN, np.uint8)
    grid = eye_grid("left")
    strands = [texels(generic, grid.rings[grid.margin + 3 : grid.margin + 8, column]) for column in (1, 3, 5, 24, 26)]
    for strand in strands:
        rgb[strand[:, 1], strand[:, 0]] = DARK
    cleaned = clean_lids(generic, rgb, vertices)
    for strand in strands:
        assert np.abs(cleaned[strand[1:-1, 1], strand[1:-1, 0]].astype(int) - SKIN).max() < 30
    margin = texels(generic, grid.ring(0)[grid.upper])
    assert cleaned[margin[:, 1], margin[:, 0]].mean() < 0.85 * np.mean(SKIN), "the lash line stays dark"


def test_all_but_the_upper_lids_stays_as_it_was(generic, vertices):
    rgb = np.random.default_rng(2).integers(0, 255, (SIZE, SIZE, 3)).astype(np.uint8)
    cleaned = clean_lids(generic, rgb, vertices)
    changed = np.argwhere((cleaned != rgb).any(axis=2))[:, ::-1]
    for side in ("left", "right"):
        grid = eye_grid(side)
        away = grid.rings[grid.margin + 4 :, grid.lower]
        # the corners' columns fade into the lower lid
        inner = away[:, 2:-2]
        places = texels(generic, inner.ravel())
        assert (cleaned[places[:, 1], places[:, 0]] == rgb[places[:, 1], places[:, 0]]).all()
    lids = np.concatenate([texels(generic, eye_grid(side).rings.ravel()) for side in ("left", "right")])
    distance = np.abs(changed[:, None] - lids[None]).max(axis=2).min(axis=1)
    assert distance.max() < SIZE / 40, "only around the eyes"


@pytest.mark.parametrize("side", ["left", "right"])
def test_lids_are_worked_on_in_a_small_part_of_the_atlas(generic, vertices, side):
    charts, _ = _lid_charts(generic, side, SIZE, vertices)
    assert sum(chart.ring.size for chart in charts) < 0.02 * SIZE**2, "texels; a box around both charts took a fifth"
    assert charts[0].seen().any(), "the chart outside comes first: the lid's inside takes its colour"
