"""Girths against shapes whose perimeter is known, and against the generic human."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measures import (
    TRUTH_GIRTHS,
    girth_mm,
    girths_mm,
    slice_points,
)

UP = np.array([0.0, 1.0, 0.0])


def cylinder(radius_m: float) -> tuple[np.ndarray, np.ndarray]:
    mesh = trimesh.creation.cylinder(radius=radius_m, height=1.0, sections=256)
    turned = mesh.vertices[:, [0, 2, 1]]  # along y
    return np.asarray(turned, dtype=np.float64), np.asarray(mesh.faces, dtype=np.int32)


def test_a_cylinder_has_its_circumference() -> None:
    vertices_m, triangles = cylinder(0.15)
    expected = 2 * np.pi * 150.0
    assert girth_mm(vertices_m, triangles, np.zeros(3), UP) == pytest.approx(expected, rel=1e-3)
    # an inclined plane cuts an ellipse: longer, never shorter
    assert girth_mm(vertices_m, triangles, np.zeros(3), np.array([0.0, 1.0, 0.5])) > expected * 1.02


def test_the_tape_bridges_hollows() -> None:
    vertices_m, triangles = cylinder(0.1)
    aside = np.array([0.15, 0.0, 0.0])
    pair = np.concatenate([vertices_m - aside, vertices_m + aside])
    both = np.concatenate([triangles, triangles + len(vertices_m)]).astype(np.int32)
    assert girth_mm(pair, both, np.zeros(3), UP) == pytest.approx(2 * np.pi * 100 + 2 * 300, rel=1e-3)


def test_a_plane_that_misses_gives_nothing() -> None:
    vertices_m, triangles = cylinder(0.1)
    assert girth_mm(vertices_m, triangles, np.array([0.0, 2.0, 0.0]), UP) == 0.0
    assert len(slice_points(vertices_m, triangles, np.array([0.0, 2.0, 0.0]), UP)) == 0


def test_girths_of_the_generic_human_are_human_and_scale_with_it() -> None:
    generic = load_generic()
    rules = load_tape_rules()
    small, large = (girths_mm(*generic.shape(np.zeros(0), stature_m), rules) for stature_m in (1.5, 1.8))
    assert tuple(small) == tuple(TRUTH_GIRTHS)
    for name in TRUTH_GIRTHS:
        assert large[name] == pytest.approx(small[name] * 1.2, rel=0.01), name
    bounds = {
        "neck": (280, 450),
        "chest": (750, 1100),
        "waist": (600, 1050),
        "hip": (800, 1150),
        "thigh": (400, 700),
        "calf": (280, 450),
        "upper_arm": (200, 400),
    }
    for name, (low, high) in bounds.items():
        assert low < large[name] < high, name
    assert large["waist_min"] <= large["waist"]
    assert large["upper_arm"] < large["calf"] < large["thigh"] < large["hip"]
