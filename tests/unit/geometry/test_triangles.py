"""Areas and edges of two triangles of a square and of one that stands on it."""

import numpy as np

from cloner.geometry.meshes.triangles import areas, edges_of, paired_edges

POINTS = np.array([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]])
TRIANGLES = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4]])


def test_areas_are_the_same_flat_and_in_space() -> None:
    assert areas(POINTS, TRIANGLES).tolist() == [2.0, 2.0, 3.0]
    assert areas(POINTS[:, :2], TRIANGLES[:2, ::-1]).tolist() == [2.0, 2.0], "either way round"


def test_every_edge_is_told_once_with_its_triangles() -> None:
    edges, owners = edges_of(TRIANGLES)
    assert edges.tolist() == [[0, 1], [0, 2], [0, 3], [0, 4], [1, 2], [2, 3], [3, 4]]
    assert owners.tolist() == [1, 2, 2, 1, 1, 1, 1]
    shared, beside, opposite = paired_edges(TRIANGLES)
    assert shared.tolist() == [[0, 2], [0, 3]]
    assert np.sort(beside, axis=1).tolist() == [[0, 1], [1, 2]]
    for corners, both in zip(opposite, beside, strict=True):
        assert not set(corners) & set.intersection(*(set(TRIANGLES[row]) for row in both)), "off the shared edge"
        assert all(corner in TRIANGLES[row] for corner, row in zip(corners, both, strict=True))
