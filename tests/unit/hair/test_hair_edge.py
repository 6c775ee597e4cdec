"""Hair's soft edge is soft between the texels too: beside a chart lies what lies at its border."""

import numpy as np
import trimesh

from cloner.geometry.charts.atlas import map_atlas
from cloner.hair.shells.edge import FADE_MM, soften_edge
from cloner.hair.shells.shell import without_scraps

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


def test_scraps_beside_the_hair_are_dropped_and_two_locks_kept():
    whole = trimesh.creation.icosphere(subdivisions=3, radius=0.1)
    lock, scrap = (trimesh.creation.icosphere(subdivisions=2, radius=radius) for radius in (0.03, 0.01))
    points = np.concatenate([whole.vertices, lock.vertices + 0.3, scrap.vertices - 0.3])
    starts = np.cumsum([0, len(whole.vertices), len(lock.vertices)])
    triangles = np.concatenate(
        [one.faces + start for one, start in zip((whole, lock, scrap), starts, strict=True)]
    ).astype(np.int32)
    kept = without_scraps(points, triangles)
    assert np.array_equal(kept, triangles[: len(whole.faces) + len(lock.faces)])
    assert without_scraps(points, triangles[:0]).shape == (0, 3)
