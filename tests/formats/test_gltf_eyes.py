"""Eyes of a GLB: irises lie flat behind the ball's front, turn with the ball, and reflect light as a round cornea."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.exporters.gltf.gltf import build
from cloner.exporters.gltf.gltf_eyes import creased_eyes, fronts, with_flat_irises
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_surfaces
from kit.clones import toy_clone

CORNEA_M, IRIS_M = 0.0077, 0.0059


@pytest.fixture(scope="module")
def clone():
    return toy_clone(1.70, hair=False)


def values(gltf, number: int) -> np.ndarray:
    accessor = gltf.accessors[number]
    kind, width = {5126: np.float32, 5123: np.uint16}[accessor.componentType], {"VEC3": 3, "SCALAR": 1}[accessor.type]
    start = gltf.bufferViews[accessor.bufferView].byteOffset
    return np.frombuffer(gltf.binary_blob(), kind, accessor.count * width, start).reshape(-1, width).astype(float)


def test_irises_are_flat_and_whites_are_round(clone) -> None:
    generic, flat = load_generic(), with_flat_irises(clone)
    for side, eye in zip(("l", "r"), fronts(), strict=True):
        ball = clone.vertices_m[eye.ball]
        rim = clone.vertices_m[eye.front[eye.rim], 2]
        assert np.ptp(flat.vertices_m[eye.front, 2]) < 1e-4, "as flat as its rim"
        assert flat.vertices_m[eye.front, 2].mean() == pytest.approx(rim.mean(), abs=1e-5)
        assert ball[:, 2].max() - rim.mean() > 0.001, "a millimetre and more behind the ball's front"
        away = np.linalg.norm(flat.vertices_m[eye.front, :2] - clone.vertices_m[eye.front, :2], axis=1)
        assert away.max() < 2e-4, "seen from ahead nothing moves"
        others = np.setdiff1d(eye.ball, eye.front)
        assert (flat.vertices_m[others] == clone.vertices_m[others]).all()
        assert generic.joint_names.index(f"{side}_eyeball_joint") >= 0
    skin = generic.vertex_part == 0
    assert (flat.vertices_m[skin] == clone.vertices_m[skin]).all()


@pytest.mark.parametrize("name", ["eyeLookOutLeft", "eyeLookUpRight"])
def test_irises_turn_with_their_balls(clone, name: str) -> None:
    """A turned disc is flat and as large, its middle on the turned ball's axis."""
    flat, number = with_flat_irises(clone), clone.morph_names.index(name)
    rows = slice(int(clone.morph_start[number]), int(clone.morph_start[number + 1]))
    eye = fronts()[0 if name.endswith("Left") else 1]
    shapes = []
    for one in (clone, flat):
        points = one.vertices_m.copy()
        points[one.morph_index[rows]] += one.morph_delta_m[rows]
        shapes.append(points)
    round_one, flat_one = shapes
    disc = flat_one[eye.front]
    off = np.linalg.svd(disc - disc.mean(axis=0), full_matrices=False)[1]
    assert off[2] < 0.02 * off[1], "flat"
    rim = round_one[eye.front[eye.rim]].mean(axis=0)
    front = eye.front[np.argmax(clone.vertices_m[eye.front, 2])]
    ahead = round_one[front] - rim
    assert np.linalg.norm(ahead[:2]) > 1e-4, "the target turns the ball"
    assert np.linalg.norm(flat_one[front] - rim) < 2e-4


def test_highlights_are_those_of_a_cornea(clone) -> None:
    gltf = build(clone, moves=lambda _: ())
    eyes = gltf.meshes[0].primitives[1]
    assert gltf.materials[eyes.material].name == "eyes"
    surface, iris = creased_eyes()
    normals, points = (values(gltf, number) for number in (eyes.attributes.NORMAL, eyes.attributes.POSITION))
    assert len(points) == len(surface.vertex)
    for eye in fronts():
        own = iris & np.isin(surface.vertex, eye.front)
        middle, _, radius = eye.frame(clone.vertices_m)
        aside = np.linalg.norm(points[own, :2] - middle[:2], axis=1) / radius * IRIS_M
        assert np.degrees(np.arccos(normals[own, 2])) == pytest.approx(np.degrees(np.arcsin(aside / CORNEA_M)), abs=1.0)
    assert np.degrees(np.arccos(normals[iris, 2])).max() == pytest.approx(50.0, abs=1.5)


def test_the_white_keeps_its_own_normals_at_the_rim_and_lists_of_triangles_stay_true(clone) -> None:
    plain = next(surface for surface in load_surfaces() if surface.name == "eyes")
    surface, iris = creased_eyes()
    assert (surface.vertex[: len(plain.vertex)] == plain.vertex).all()
    assert (surface.vertex[surface.triangles] == plain.vertex[plain.triangles]).all()
    assert not iris[surface.triangles].any(axis=1).all()
    mixed = iris[surface.triangles].any(axis=1) & ~iris[surface.triangles].all(axis=1)
    assert not mixed.any(), "no triangle is half iris and half white"


def test_a_statue_keeps_its_carved_pupils(clone) -> None:
    stone = replace(clone, atlas=replace(clone.atlas, shine=np.full((*clone.atlas.rgb.shape[:2], 3), 128, np.uint8)))
    gltf = build(stone, moves=lambda _: ())
    eyes = gltf.meshes[0].primitives[1]
    plain = next(surface for surface in load_surfaces() if surface.name == "eyes")
    assert values(gltf, eyes.attributes.POSITION) == pytest.approx(clone.vertices_m[plain.vertex], abs=1e-6)
