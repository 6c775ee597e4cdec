"""OpenCV's rasteriser against our own: the same pixels, the same depths, no holes."""

import numpy as np

from cloner.geometry.meshes.rasters import fragments, nearest_depth, rasterise


def _bumpy(side=24, size=60.0):
    """Return a grid of triangles that fills a square, its inner corners moved a little, and depths."""
    rng = np.random.default_rng(3)
    points = np.stack(np.meshgrid(np.linspace(0, size, side), np.linspace(0, size, side)), -1)
    points[1:-1, 1:-1] += rng.uniform(-1.0, 1.0, (side - 2, side - 2, 2))
    k = np.arange(side * side).reshape(side, side)
    a, b, c, d = (part.ravel() for part in (k[:-1, :-1], k[:-1, 1:], k[1:, 1:], k[1:, :-1]))
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]).astype(np.int32)
    return points.reshape(-1, 2), rng.uniform(1.0, 2.0, side * side), triangles


def test_each_pixel_knows_the_triangle_that_covers_it_and_its_place_there():
    points, _, triangles = _bumpy()
    pixel, triangle, weights = rasterise(points + 2.3, triangles, 70, 66)
    known = {(p, t): w for part in fragments(points + 2.3, triangles, 70, 66) for p, t, w in zip(*part, strict=True)}
    assert len(np.unique(pixel)) == len(pixel) == len({p for p, _ in known})
    pairs = list(zip(pixel, triangle, weights, strict=True))
    far = [np.abs(known[p, t] - w).max() for p, t, w in pairs if (p, t) in known]
    assert len(far) > 0.99 * len(pairs)  # on an edge either neighbour may have the pixel
    assert max(far) < 1e-3


def test_the_nearest_surface_is_that_of_the_plain_search():
    points, depth, triangles = _bumpy()
    both, deep = np.concatenate([points, points[::-1] * 0.9 + 9.4]), np.concatenate([depth, depth])
    faces = np.concatenate([triangles, triangles + len(points)])
    wanted = np.zeros(80 * 64, np.float32)
    for pixel, triangle, weights in fragments(both, faces, 64, 80):
        np.maximum.at(wanted, pixel, ((1.0 / deep)[faces[triangle]] * weights).sum(axis=1).astype(np.float32))
    found = 1.0 / nearest_depth(both, deep, faces, 64, 80).ravel()
    inner = (wanted > 0.0) & (found > 0.0)
    assert inner.sum() > 0.95 * (wanted > 0.0).sum()  # borders may round either way
    assert np.quantile(np.abs(found - wanted)[inner], 0.999) < 1e-4


def test_pixels_on_edges_are_covered_once_and_never_lost():
    side = np.arange(0.0, 65.0, 8.0)
    points = np.stack(np.meshgrid(side, side), -1).reshape(-1, 2)
    k = np.arange(81).reshape(9, 9)
    a, b, c, d = (part.ravel() for part in (k[:-1, :-1], k[:-1, 1:], k[1:, 1:], k[1:, :-1]))
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]).astype(np.int32)
    inside = np.zeros(65 * 65, bool)
    inside[rasterise(points, triangles, 65, 65)[0]] = True
    assert inside.reshape(65, 65)[1:64, 1:64].all()
    depth = nearest_depth(points, np.full(81, 2.0), triangles, 65, 65)
    assert np.abs(depth[1:64, 1:64] - 2.0).max() < 1e-5


def test_what_stands_behind_the_camera_or_beside_the_picture_is_not_drawn():
    points, triangles = np.array([[-50.0, 1], [-10, 1], [-20, 9]]), np.array([[0, 1, 2]], np.int32)
    assert rasterise(points, triangles, 8, 8)[0].size == 0
    assert np.isinf(nearest_depth(points + 30.0, np.array([-1.0, 2.0, 2.0]), triangles, 40, 40)).all()
