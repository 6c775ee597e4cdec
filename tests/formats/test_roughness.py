"""Skin, cloth and shoes shine each in their way in a glTF file."""

from __future__ import annotations

import io
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from cloner.exporters.gltf.gltf import build
from cloner.exporters.shared.roughness import ROUGHNESS, SIZE, mouth_light
from cloner.generic.load import load_generic
from cloner.records.regions import REGIONS
from kit.clones import toy_clone


@pytest.fixture(scope="module")
def dressed():
    """A clone in a shirt: its trunk is cloth, all else skin."""
    generic = load_generic()
    clone = toy_clone(1.70)
    triangles = generic.triangles()[0]
    trunk = generic.vertex_segment[triangles[:, 0]] == generic.segment_names.index("torso")
    labels = np.where(trunk, REGIONS.index("upper_clothes"), REGIONS.index("skin")).astype(np.uint8)
    return replace(clone, triangle_regions=labels), trunk


def test_cloth_is_rougher_than_skin_where_the_body_shows_it(dressed):
    clone, trunk = dressed
    generic, gltf = load_generic(), build(clone)
    material = next(material for material in gltf.materials if material.name == "body")
    look = material.pbrMetallicRoughness
    assert (look.roughnessFactor, look.metallicFactor) == (1.0, 0.0)
    image = gltf.images[gltf.textures[look.metallicRoughnessTexture.index].source]
    view = gltf.bufferViews[image.bufferView]
    start = view.byteOffset or 0
    texels = np.asarray(Image.open(io.BytesIO(gltf.binary_blob()[start : start + view.byteLength])))
    middle = generic.uv[generic.triangles()[1]].mean(axis=1)
    column, row = np.floor(middle * SIZE).astype(int).T
    found = texels[row, column, 1] / 255.0
    face = generic.region("face")[generic.triangles()[0]].all(axis=1)
    lips = generic.region("lips")[generic.triangles()[0]].any(axis=1)
    assert abs(np.median(found[trunk]) - ROUGHNESS["upper_clothes"]) < 0.01
    assert abs(np.median(found[face & ~lips]) - ROUGHNESS["skin"]) < 0.01
    assert np.median(found[generic.region("lips")[generic.triangles()[0]].all(axis=1)]) < ROUGHNESS["skin"] - 0.1


def test_without_regions_one_roughness_must_do():
    gltf = build(replace(toy_clone(1.70), triangle_regions=np.zeros(0, np.uint8)))
    look = next(material for material in gltf.materials if material.name == "body").pbrMetallicRoughness
    assert look.metallicRoughnessTexture is None
    assert 0.5 < look.roughnessFactor < 1.0


def test_only_the_mouth_is_dark_and_deeper_is_darker():
    generic = load_generic()
    triangles, uv_triangles = generic.triangles()
    column, row = np.floor(generic.uv[uv_triangles].mean(axis=1) * SIZE).astype(int).clip(0, SIZE - 1).T
    light = mouth_light()[row, column] / 255.0
    parts = generic.vertex_part[triangles[:, 0]]
    body = parts == generic.part_names.index("body")
    inside = body & generic.region("mouth_interior")[triangles].all(axis=1)
    outside = body & ~generic.region("mouth_interior")[triangles].any(axis=1)
    assert (light[outside] > 0.99).mean() > 0.999, "photographs show their own shade"
    behind = generic.vertices_m[generic.feature("stomion"), 2] - generic.vertices_m[triangles, 2].mean(axis=1)
    shares = [np.median(light[inside & (behind > low) & (behind < low + 0.01)]) for low in (0.0, 0.015, 0.03, 0.05)]
    assert shares == sorted(shares, reverse=True)
    assert shares[0] > 0.7
    assert shares[-1] < 0.2
    tongue = np.flatnonzero(parts == generic.part_names.index("tongue"))
    tongue = tongue[np.argsort(behind[tongue])]
    assert light[tongue[:100]].mean() > light[tongue[-100:]].mean() + 0.2, "its tip stands in more light than its root"


def test_skin_and_teeth_read_that_light_and_statues_have_none(dressed):
    clone, _ = dressed
    gltf = build(clone)
    body, mouth, eyes = (next(one for one in gltf.materials if one.name == name) for name in ("body", "mouth", "eyes"))
    rough = body.pbrMetallicRoughness.metallicRoughnessTexture.index
    assert body.occlusionTexture.index == mouth.occlusionTexture.index == rough
    assert eyes.occlusionTexture is None
    shine = np.full((8, 8, 3), 128, np.uint8)
    stone = build(replace(clone, atlas=replace(clone.atlas, shine=shine)))
    assert all(one.occlusionTexture is None for one in stone.materials)
