"""pyrender as the second opinion: another program's rasteriser and camera must show the same person as ours."""

from __future__ import annotations

import numpy as np
import pytest

import cloner.render
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.generic.layers import Layer, clone_layers
from cloner.geometry.cameras.viewpoints import look_at
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.records.views import Camera
from cloner.render import coverage, draw
from kit.clones import toy_clone
from kit.scripts import script

pytestmark = pytest.mark.gl
#: Aside, above and tilted, so that no axis may be confused with another.
PLACES = ((0.0, 1.1, 3.0), (2.2, 1.7, 1.4), (-1.5, 0.5, -2.0))


@pytest.fixture(scope="module")
def pictures():
    """Return the builder of painted people, which draws by pyrender."""
    try:
        cloner.render.require_gl()
    except ClonerError:
        pytest.skip("no EGL on this machine")
    return script("painted_people_pictures")


@pytest.mark.parametrize("place", PLACES)
def test_two_programs_show_the_same_person(place, pictures):
    camera = Camera(300, 420, 430.0, look_at(np.array(place), np.array([0.1, 0.9, 0.0])))
    clone = toy_clone(hair=False)
    skin = clone_layers(clone, clone.views[ViewId.BODY_FRONT].rotations)
    theirs = pictures.rendered(*_whole(skin), camera)[..., 3]
    ours = coverage([_opaque(layer) for layer in skin], camera)
    assert 8_000 < (ours > 0.5).sum() < 60_000
    both, either = ((ours > 0.5) & (theirs > 0.5)).sum(), ((ours > 0.5) | (theirs > 0.5)).sum()
    assert both / either > 0.98, "one pixel of this outline is 8 % of the person"
    apart = _middle(ours) - _middle(theirs)
    assert np.abs(apart).max() < 0.1, "pixels' centres are half a pixel from their corners: nobody confuses them"


@pytest.mark.parametrize("place", PLACES)
def test_the_nearer_surface_is_the_nearer_one_in_both(place, pictures):
    """Two plates cross each other; where each is before the other is seen alike."""
    camera = Camera(300, 420, 430.0, look_at(np.array(place), np.array([0.1, 0.9, 0.0])))
    square = np.array([[-0.5, -0.5, 0.0], [0.5, -0.5, 0.0], [0.5, 0.5, 0.0], [-0.5, 0.5, 0.0]]) + [0.0, 0.9, 0.0]
    turned = (square - [0.0, 0.9, 0.0]) @ np.array([[0.3, 0.0, 0.95], [0.0, 1.0, 0.0], [-0.95, 0.0, 0.3]]) + [
        0.0,
        0.9,
        0.0,
    ]
    faces = np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32)
    red, blue = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)
    layers = [
        Layer(matted, vertex_normals(matted, faces), faces, colour=colour, two_sided=True)
        for matted, colour in ((square, red), (turned, blue))
    ]
    ours = draw(layers, camera, background=(0, 255, 0)).astype(float)
    points, corners = np.vstack([square, turned]), np.vstack([faces, faces + 4])
    theirs = pictures.rendered(points, corners, np.repeat([red, blue], 4, axis=0), camera)
    own, other = ours[..., 0] > ours[..., 2], theirs[..., 0] > theirs[..., 2]
    seen = theirs[..., 3] > 0.99
    assert 1_000 < own[seen].sum() < seen.sum() - 1_000
    assert (own[seen] == other[seen]).mean() > 0.99


def _middle(covered):
    """Return the middle (row, column) of what is covered."""
    return np.array([(np.indices(covered.shape)[k] * covered).sum() / covered.sum() for k in (0, 1)])


def _whole(layers):
    """Return all layers as one mesh of white vertices."""
    starts = np.cumsum([0, *(len(layer.vertices_m) for layer in layers)])
    triangles = np.vstack([layer.triangles + start for layer, start in zip(layers, starts[:-1], strict=True)])
    points = np.vstack([layer.vertices_m for layer in layers])
    return points, triangles.astype(np.uint32), np.ones((len(points), 3))


def _opaque(layer):
    """Return a layer without its texture: pyrender draws no lashes' holes here either."""
    return Layer(layer.vertices_m, layer.normals, layer.triangles, colour=(1.0, 1.0, 1.0))
