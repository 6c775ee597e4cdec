"""Hair that no photo shows: the seen colour goes on, and strands are as rough as the seen ones."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from skimage.measure import marching_cubes

from cloner.geometry.charts.atlas import map_atlas
from cloner.geometry.charts.unwrapping import unwrap
from cloner.geometry.meshes.graphs import surface_graph
from cloner.hair.shells.strands import curliness, grow_strands, roughness, strand_noise

BROWN = np.array([110.0, 80.0, 60.0])
ROUGH = np.array([12.0, 10.0, 8.0])


@pytest.fixture(scope="module")
def ball():
    """Return a head of hair of 9 cm radius, its atlas and graph, and strands where only the front half was seen."""
    grid = np.stack(np.meshgrid(*[np.arange(24.0) - 11.5] * 3, indexing="ij"), axis=-1)
    points, faces, _, _ = marching_cubes(9.0 - np.linalg.norm(grid, axis=-1), 0.0, gradient_direction="ascent")
    vertices, triangles = (points - 11.5).astype(float) * 0.01, faces.astype(np.int32)
    charts = unwrap(vertices, triangles, 256)
    atlas = map_atlas(charts.uv, charts.triangles, triangles, 256)
    graph = surface_graph(vertices, triangles)
    claim = np.clip(vertices[:, 2] / 0.09, 0.0, 1.0)
    seen = np.where(claim[:, None] > 0.2, BROWN, 230.0)  # at its edge the photo shows the wall
    return vertices, atlas, claim, grow_strands(atlas, vertices, graph, seen, claim, ROUGH)


def test_the_back_has_the_hair_s_colour_and_roughness_and_not_the_wall_s(ball):
    vertices, atlas, _, strands = ball
    back = strands.rgb[atlas.interpolate(vertices)[:, 2] < -0.03]
    assert np.abs(back.mean(axis=0) - BROWN).max() < 10.0
    assert np.all(np.abs(back.std(axis=0) / ROUGH - 1.0) < 0.5)


def test_what_photos_show_squarely_stays_theirs(ball):
    vertices, _, claim, strands = ball
    assert np.all(strands.claim[claim > 0.8] < 0.2)
    assert np.all(strands.claim[vertices[:, 2] < -0.03] > 0.6)


def test_without_a_gap_nothing_is_made_up(ball):
    vertices, atlas, _, _ = ball
    graph = surface_graph(vertices, atlas.triangles)
    whole = grow_strands(atlas, vertices, graph, np.tile(BROWN, (len(vertices), 1)), np.ones(len(vertices)), ROUGH)
    assert not whole.claim.any()


def test_strands_run_down_the_head():
    side = np.radians(np.linspace(60.0, 120.0, 400))
    level = 0.09 * np.column_stack([np.sin(side), np.zeros(400), np.cos(side)])
    down = 0.09 * np.column_stack([np.zeros(400), np.cos(side), -np.sin(side)])
    assert np.abs(np.diff(strand_noise(level))).mean() > 2.0 * np.abs(np.diff(strand_noise(down))).mean()


def test_smooth_hair_has_no_roughness_and_striped_hair_has():
    hair = np.zeros((120, 120), bool)
    hair[10:110, 10:110] = True
    plain = np.full((120, 120, 3), 90, np.uint8)
    striped = plain.copy()
    striped[:, ::2] += 40
    assert roughness(plain, hair).max() < 1.0
    assert np.allclose(roughness(striped, hair), 20.0, atol=2.0)


def test_curls_run_every_way_and_strands_one_way():
    hair = np.zeros((200, 200), bool)
    hair[20:180, 20:180] = True
    rng = np.random.default_rng(3)
    strands = cv2.GaussianBlur(rng.uniform(0.0, 255.0, (200, 200)).astype(np.float32), (0, 0), 1.5, sigmaY=25.0)
    curls = cv2.GaussianBlur(rng.uniform(0.0, 255.0, (200, 200)).astype(np.float32), (0, 0), 1.5)
    told = []
    for grey in (strands, curls):
        levels = 128.0 + 40.0 * (grey - grey.mean()) / grey.std()
        told.append(curliness(np.repeat(np.clip(levels, 0, 255).astype(np.uint8)[..., None], 3, axis=2), hair))
    assert told == [0.0, 1.0]
    assert curliness(np.full((200, 200, 3), 90, np.uint8), hair) == 0.0
    assert curliness(np.full((200, 200, 3), 90, np.uint8), ~hair & hair) == 0.0


def test_curls_are_as_long_as_wide():
    side = np.radians(np.linspace(60.0, 120.0, 400))
    level = 0.09 * np.column_stack([np.sin(side), np.zeros(400), np.cos(side)])
    down = 0.09 * np.column_stack([np.zeros(400), np.cos(side), -np.sin(side)])
    around, below = (np.abs(np.diff(strand_noise(line, 1.0))).mean() for line in (level, down))
    assert around == pytest.approx(below, rel=0.35)
