"""Hair's soft edge is soft between the texels too: beside a chart lies what lies at its border."""

import numpy as np

from cloner.geometry.charts.atlas import map_atlas
from cloner.hair.shells.edge import FADE_MM, soften_edge

SIZE = 64


def test_texels_beside_a_chart_are_as_clear_as_its_border():
    """Opaque ones were sampled along triangles' edges: dashes on the forehead."""
    uv = np.array([[0.2, 0.2], [0.8, 0.2], [0.8, 0.8], [0.2, 0.8]])
    triangles = np.array([[0, 1, 2], [0, 2, 3]], np.int32)
    atlas = map_atlas(uv, triangles, triangles, SIZE)
    rgba = np.full((SIZE, SIZE, 4), (90, 70, 60, 255), np.uint8)
    bare, deep = FADE_MM[0] - 5.0, FADE_MM[1] + 5.0
    alpha = soften_edge(rgba, atlas, np.array([bare, deep, deep, bare]))[..., 3]
    left, right = int(0.2 * SIZE) - 2, int(0.8 * SIZE) + 2
    assert not atlas.covered()[SIZE // 2, [left, right]].any()
    assert alpha[SIZE // 2, left] == 0
    assert alpha[SIZE // 2, right] == 255
