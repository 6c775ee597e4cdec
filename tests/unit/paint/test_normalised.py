"""Photos are brought together where they take over from each other."""

import numpy as np

from cloner.geometry.meshes.graphs import surface_graph
from cloner.paint.lookups.normalised import border_gains, normalised_colours


def _strip(count):
    """Return vertices and triangles of a ribbon two vertices wide."""
    rows = np.arange(count)
    vertices = np.stack([np.repeat(rows * 0.01, 2), np.tile([0.0, 0.01], count), np.zeros(2 * count)], axis=1)
    corner = 2 * rows[:-1]
    upper, lower = np.stack([corner, corner + 1, corner + 2], 1), np.stack([corner + 1, corner + 3, corner + 2], 1)
    return vertices, np.concatenate([upper, lower]).astype(np.int32)


def test_what_is_burnt_out_moves_to_what_is_not():
    vertices, triangles = _strip(60)
    graph = surface_graph(vertices, triangles)
    along = vertices[:, 0] / vertices[-1, 0]
    skin = np.array([190.0, 140.0, 110.0])
    colours = np.stack([np.tile(skin * 1.25, (120, 1)), np.tile(skin, (120, 1))])  # the first in hard light
    claim = np.stack([1.0 - along, along])
    trust = np.stack([np.full(120, 0.05), np.ones(120)])
    found = normalised_colours(colours, border_gains(colours, claim, trust, graph))
    middle = np.abs(along - 0.5) < 0.02
    assert np.abs(found[0, middle] - skin).max() < 12  # 28-48 before
    assert np.abs(found[1, middle] - skin).max() < 4
    assert np.abs(found[0, along < 0.05] - colours[0, along < 0.05]).max() < 24  # far away it keeps half its light


def test_different_things_are_not_brought_together():
    vertices, triangles = _strip(40)
    graph = surface_graph(vertices, triangles)
    colours = np.stack([np.tile([60.0, 80.0, 160.0], (80, 1)), np.tile([190.0, 140.0, 110.0], (80, 1))])
    gains = border_gains(colours, np.ones((2, 80)), np.ones((2, 80)), graph)
    assert np.abs(gains).max() < 0.03
