"""Rasterised triangles, the atlas, distances along a surface."""

import numpy as np

from cloner.generic.charts import generic_atlas
from cloner.generic.load import load_generic
from cloner.geometry.charts.atlas import map_atlas
from cloner.geometry.charts.partition import blend_weights, partition_surface
from cloner.geometry.charts.unwrapping import unwrap
from cloner.geometry.meshes.graphs import surface_graph
from cloner.geometry.meshes.rasters import fragments, nearest_depth

SQUARE = np.array([[0, 1, 2], [0, 2, 3]], np.int32)


def test_every_texel_of_a_square_is_found_once_and_knows_its_place():
    uv = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    atlas = map_atlas(uv, SQUARE, SQUARE, 64)
    assert np.array_equal(np.sort(atlas.texel), np.arange(64 * 64))
    place = atlas.interpolate(uv)
    row, column = np.divmod(atlas.texel, 64)
    assert np.abs(place - (np.column_stack([column, row]) + 0.5) / 64).max() < 1e-5


def test_the_generic_atlas_finds_each_texel_where_its_uv_says():
    generic = load_generic()
    atlas = generic_atlas(generic, 256)
    assert np.unique(atlas.texel).size == atlas.texel.size
    assert 0.4 < atlas.texel.size / 256**2 < 1.0
    _, uv_triangles = generic.triangles()
    corner = generic.uv[uv_triangles[atlas.triangle]]
    place = np.einsum("nkc,nk->nc", corner, atlas.barycentric)
    row, column = np.divmod(atlas.texel, 256)
    assert np.abs(place - (np.column_stack([column, row]) + 0.5) / 256).max() < 1e-4


def test_the_nearer_of_two_surfaces_wins_and_depth_is_exact_in_perspective():
    points = np.array([[2.0, 2], [60, 2], [60, 60], [2, 60]] * 2)
    far = np.full(4, 3.0)
    slanted = np.array([1.0, 2.0, 2.0, 1.0])  # 1/depth is affine over the picture
    depth = nearest_depth(points, np.concatenate([far, slanted]), np.vstack([SQUARE, SQUARE + 4]), 64, 64)
    assert np.isinf(depth[0, 0])
    assert abs(1.0 / depth[30, 31] - (1.0 + (31 - 2) / 58 * -0.5)) < 1e-5


def _strip(count=41, step=0.005):
    x = np.arange(count) * step
    vertices = np.concatenate([np.column_stack([x, np.full(count, y), 0 * x]) for y in (0.0, step)])
    k = np.arange(count - 1)
    lower = np.column_stack([k, k + 1, k + count])
    return vertices, np.vstack([lower, np.column_stack([k + 1, k + count + 1, k + count])]).astype(np.int32)


def test_shares_are_half_at_the_border_and_whole_beyond_the_band():
    vertices, triangles = _strip()
    graph = surface_graph(vertices, triangles)
    left = vertices[:, 0] < 0.1
    scores = np.stack([np.where(left, 1.0, 0.4), np.where(left, 0.4, 1.0)])
    owner = partition_surface(scores, graph, smoothing=0)
    assert np.array_equal(owner == 0, left)
    shares = blend_weights(owner, 2, graph, np.full(len(vertices), 0.02))
    assert np.abs(shares.sum(axis=0) - 1.0).max() < 1e-9
    assert np.all(shares[0, vertices[:, 0] < 0.07] == 1.0)
    assert np.all(shares[0, vertices[:, 0] > 0.13] == 0.0)
    at_border = np.abs(vertices[:, 0] - 0.0975) < 0.003
    assert np.all(np.abs(shares[0, at_border] - 0.5) < 0.15)


def test_a_crumb_goes_to_the_photo_around_it_that_shows_it_or_to_none():
    vertices, triangles = _strip(121)
    graph = surface_graph(vertices, triangles)
    x = vertices[:, 0]
    crumb, end = np.abs(x - 0.2) < 0.02, x > 0.45
    scores = np.stack([np.where(end, 0.3, 0.6), np.where(crumb | end, 0.8, 0.0)])
    owner = partition_surface(scores, graph, smoothing=0)
    assert (owner[~end] == 0).all()  # the crumb too
    assert (owner[end] == 1).all()  # as large as a sleeve
    scores[0, crumb] = 0.0
    assert (partition_surface(scores, graph, smoothing=0)[crumb] == -1).all()


def test_fill_is_harmonic_between_known_ends():
    vertices, triangles = _strip()
    graph = surface_graph(vertices, triangles)
    ends = (vertices[:, 0] < 0.001) | (vertices[:, 0] > 0.199)
    filled = graph.fill(vertices[:, :1] * 100, np.where(ends, 1e3, 0.0), 1.0)[:, 0]
    assert np.abs(filled - vertices[:, 0] * 100).max() < 0.5


def test_charts_of_a_ball_do_not_overlap_and_keep_every_triangle():
    import trimesh

    ball = trimesh.creation.icosphere(subdivisions=3, radius=0.1)
    charts = unwrap(np.asarray(ball.vertices), ball.faces.astype(np.int32), 256)
    assert np.array_equal(charts.vertex[charts.triangles], ball.faces)
    assert charts.uv.min() >= 0.0
    assert charts.uv.max() <= 1.0
    edge = charts.uv[charts.triangles]
    first, second = edge[:, 1] - edge[:, 0], edge[:, 2] - edge[:, 0]
    area = 0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]).sum()
    covered = map_atlas(charts.uv, charts.triangles, ball.faces.astype(np.int32), 512).texel.size / 512**2
    assert abs(area - covered) / area < 0.02  # overlapping charts would cover less than their area


def test_charts_of_a_folded_sheet_do_not_overlap():
    width, rise = 0.05, 0.004  # three leaves that face one way, closer to each other than hair is thick
    rows = np.array([[0.0, 0.0], [0.1, 0.0], [0.0, rise], [0.1, 2 * rise], [0.0, 3 * rise]])  # a zigzag from the side
    points = np.array([[x, y, z] for x, z in rows for y in (0.0, width)])
    triangles = np.array([t for k in (0, 2, 4, 6) for t in ((k, k + 2, k + 1), (k + 2, k + 3, k + 1))], np.int32)
    triangles[[0, 1, 4, 5]] = triangles[[0, 1, 4, 5]][:, ::-1]  # every leaf faces up, as leaves of hair do
    charts = unwrap(points, triangles, 256)
    owners = np.zeros(1024 * 1024)
    for pixel, _, weights in fragments(charts.uv * 1024 - 0.5, charts.triangles, 1024, 1024):
        np.add.at(owners, pixel[weights.min(axis=1) > 1e-3], 1)
    assert owners.max() == 1
    assert np.array_equal(charts.vertex[charts.triangles], triangles)
