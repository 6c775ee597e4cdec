"""Loose clothing meets the body's cloth in one colour where it leaves it."""

import numpy as np
import pytest

from cloner.geometry.charts.tubes import tube_mesh
from cloner.paint.composing.shell_light import match_light_of_body
from cloner.records.heads import Shell
from cloner.records.labels import SURFACES

ANGLES = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
CLOTH = np.array([120.0, 80.0, 60.0])


def ring(radius, height):
    return np.stack([radius * np.sin(ANGLES), np.full(24, height), radius * np.cos(ANGLES)], axis=1)


def skirt(colour_of):
    """Return a cone from the waist at 1 m down to .4 m; its colour by the angle around it."""
    tube = tube_mesh(np.stack([ring(0.12 + 0.1 * step, 1.0 - 0.6 * step) for step in np.linspace(0, 1, 12)]), 128)
    count = len(tube.vertices_m)
    rgba = np.full((128, 128, 4), 255, np.uint8)
    column, row = np.clip((tube.uv * 128).astype(int), 0, 127).T
    middle = np.zeros((128, 128), int)
    texels = np.stack(np.indices((128, 128))[::-1], axis=-1).reshape(-1, 2)
    middle[:] = np.argmin(((texels[:, None] - np.stack([column, row], 1)[None]) ** 2).sum(axis=2), axis=1).reshape(
        128, 128
    )
    rgba[..., :3] = colour_of(tube.vertices_m)[middle]
    joints, weights = np.zeros((count, 4), np.int32), np.tile([1.0, 0.0, 0.0, 0.0], (count, 1))
    return Shell(tube.vertices_m, tube.triangles.astype(np.int32), tube.uv, joints, weights, rgba, "cloth")


def body(kind):
    """Return vertices around the waist, what is worn there, and the shares of its surfaces."""
    places = np.vstack([ring(0.115, height) for height in np.linspace(0.9, 1.1, 9)])
    surfaces = np.zeros((len(places), len(SURFACES)))
    surfaces[:, SURFACES.index(kind)] = 1.0
    return places, np.tile(CLOTH, (len(places), 1)), surfaces


def shown(shell):
    column, row = np.clip((shell.uv * 128).astype(int), 0, 127).T
    return shell.rgba[row, column, :3].astype(float)


def test_a_back_that_was_darker_is_as_light_as_the_body_above():
    dark = skirt(lambda at: CLOTH * (0.85 + 0.15 * at[:, 2:] / np.hypot(at[:, :1], at[:, 2:])))
    lit = match_light_of_body(dark, *body("upper_clothes"))
    assert np.abs(shown(lit) - CLOTH).mean() < 0.3 * np.abs(shown(dark) - CLOTH).mean()


@pytest.mark.parametrize(("colour", "kind"), [((30.0, 90.0, 160.0), "upper_clothes"), (0.7 * CLOTH, "skin")])
def test_what_is_no_part_of_the_garment_above_keeps_its_colour(colour, kind):
    own = skirt(lambda places: np.tile(colour, (len(places), 1)))
    lit = match_light_of_body(own, *body(kind))
    assert np.abs(lit.rgba.astype(int) - own.rgba).max() <= 4
