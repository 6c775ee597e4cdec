"""Clay: a sphere, an egg, half a head pushed about, mirrored and merged."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

from cloner.errors import ClonerError
from cloner.geometry.cameras.viewpoints import framing_camera
from cloner.render import render_mesh
from cloner.statues.clay_heads import (
    Clay,
    egg,
    halved,
    lifted,
    mesh_of_clay,
    mirrored,
    moved,
    region,
    smoothed,
    sphere,
)  # fmt: skip
from cloner.statues.photo_fit import fit_photo


def _solid(clay: Clay) -> trimesh.Trimesh:
    return trimesh.Trimesh(clay.vertices_m, clay.triangles, process=False)


def _head() -> Clay:
    half = halved(egg(sphere(0.1)))
    half = moved(half, region(half, (0.0, -0.005, 0.1), 0.035), (0.0, 0.0, 0.022))  # nose
    half = lifted(half, region(half, (0.035, 0.022, 0.08), 0.028), -0.01)  # eye
    half = moved(half, region(half, (0.0, -0.09, 0.06), 0.05), (0.0, -0.012, 0.018))  # chin
    return smoothed(half, np.full(len(half.vertices_m), 0.5))


def test_a_sphere_is_closed_and_has_the_volume_of_one() -> None:
    ball = _solid(sphere(0.1))
    assert ball.is_watertight
    assert ball.volume == pytest.approx(4.0 / 3.0 * np.pi * 0.1**3, rel=0.01)
    assert np.linalg.norm(ball.vertices, axis=1) == pytest.approx(0.1)


def test_an_egg_has_a_head_s_size_and_is_narrower_below() -> None:
    clay = egg(sphere(0.1))
    width, height, depth = np.ptp(clay.vertices_m, axis=0)
    assert (width, height, depth) == pytest.approx((0.144, 0.218, 0.19), abs=0.006)
    wide = [np.ptp(clay.vertices_m[np.abs(clay.vertices_m[:, 1] - y) < 0.006, 0]) for y in (0.08, -0.08)]
    assert wide[1] < 0.9 * wide[0]


def test_halving_and_mirroring_give_the_whole_again() -> None:
    whole = egg(sphere(0.1))
    half = halved(whole)
    assert half.vertices_m[:, 0].min() == 0.0
    assert len(half.triangles) == len(whole.triangles) // 2
    again = _solid(mirrored(half))
    assert again.is_watertight
    assert again.volume == pytest.approx(_solid(whole).volume, rel=1e-9)
    assert len(again.vertices) == len(whole.vertices_m)


def test_a_head_of_half_a_head_is_closed_and_even_on_both_sides() -> None:
    half = _head()
    head = mirrored(half)
    solid = _solid(head)
    assert solid.is_watertight
    assert solid.is_winding_consistent
    assert solid.volume > 0.0
    count = len(half.vertices_m)
    rest = head.vertices_m[count:]
    assert np.array_equal(rest * (-1, 1, 1), half.vertices_m[half.vertices_m[:, 0] != 0.0])
    assert head.vertices_m[:, 2].max() > egg(sphere(0.1)).vertices_m[:, 2].max() + 0.008  # it has a nose


def test_a_region_falls_off_along_the_surface() -> None:
    clay = sphere(0.1)
    share = region(clay, (0.0, 0.0, 0.2), 0.05)
    top = int(share.argmax())
    assert share[top] == 1.0
    assert clay.vertices_m[top, 2] > 0.099
    away = 0.1 * np.arccos(np.clip(clay.vertices_m @ clay.vertices_m[top] / 0.01, -1.0, 1.0))
    assert share[away > 0.0501].max() == 0.0
    assert share[away < 0.02].min() > 0.5
    out = lifted(clay, share, 0.01)
    assert np.linalg.norm(out.vertices_m[top]) == pytest.approx(0.11, abs=1e-4)
    assert np.array_equal(out.vertices_m[share == 0.0], clay.vertices_m[share == 0.0])


def test_what_is_no_half_is_not_mirrored() -> None:
    whole = sphere(0.1)
    with pytest.raises(ClonerError, match="no half"):
        mirrored(whole)
    half = halved(whole)
    with pytest.raises(ClonerError, match="no half"):
        mirrored(Clay(half.vertices_m + [0.01, 0.0, 0.0], half.triangles))
    with pytest.raises(ClonerError, match="no half"):
        mirrored(moved(half, region(half, (0.02, 0.0, 0.1), 0.03), (-0.05, 0.0, 0.0)))
    turned = whole.vertices_m[:, [2, 1, 0]] + [0.003, 0.0, 0.0]
    with pytest.raises(ClonerError, match="no edge"):
        halved(Clay(turned, whole.triangles))


@pytest.mark.parametrize("wrong", [(0.0, 9, 8), (np.nan, 9, 8), (0.1, 2, 8), (0.1, 9, 7)])
def test_what_is_no_sphere_is_refused(wrong) -> None:
    with pytest.raises(ClonerError):
        sphere(*wrong)


def test_a_photo_is_laid_on_clay() -> None:
    head = mirrored(_head())
    taller = head.vertices_m * [1.0, 1.1, 1.0]
    camera = framing_camera(taller, 0.0, 300, 400)
    photo = render_mesh(taller, head.triangles, camera, colour=(0.2, 0.6, 0.2), background=(255, 0, 0), shading="photo")
    front = np.flatnonzero(head.vertices_m[:, 2] > 0.04)[::37]
    found = fit_photo(mesh_of_clay(head), front, camera.project(taller[front]), photo, size=256)
    assert found.fit.height == pytest.approx(1.1, abs=0.04)
    assert found.laid.rgb[..., 1].min() > 100
    assert found.laid.rgb[..., 0].max() < 110  # none of the red behind it
