"""Normals of a glTF turn with the face's targets: the light follows a smile."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.exporters.gltf.gltf import build
from cloner.exporters.gltf.gltf_eyes import creased_eyes
from cloner.exporters.gltf.gltf_targets import SMALLEST_TURN, normal_turns
from cloner.generic.load import load_generic
from cloner.generic.morphs import target_offsets
from cloner.generic.surfaces import load_surfaces, surface_normals
from cloner.motion.limbs.rig import centre_joints
from kit.clones import toy_clone


@pytest.fixture(scope="module")
def clone():
    return centre_joints(toy_clone(1.64))


@pytest.fixture(scope="module")
def gltf(clone):
    return build(clone, corrects=True, shades=True)


def degrees(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    unit = one / np.linalg.norm(one, axis=1, keepdims=True)
    return np.degrees(np.arccos(np.clip(np.einsum("ij,ij->i", unit, other), -1.0, 1.0)))


@pytest.mark.parametrize("name", ["mouthSmileLeft", "jawOpen", "cheekPuff", "eyeLookUpLeft"])
def test_a_target_s_normals_are_those_of_the_moved_surface(clone, name: str) -> None:
    generic, rest = load_generic(), surface_normals(clone.vertices_m)
    rows, difference = normal_turns(clone)[clone.morph_names.index(name)]
    offsets = next(own.copy() for target, own in target_offsets(clone) if target == name)
    truth = surface_normals(clone.vertices_m + offsets[:-1])
    told = rest.copy()
    told[rows] += difference
    teeth = np.isin(generic.vertex_part, [generic.part_names.index(f"teeth_{jaw}") for jaw in ("upper", "lower")])
    lit = ~teeth
    assert degrees(told[lit], truth[lit]).max() < np.degrees(SMALLEST_TURN) + 0.2
    assert degrees(rest[lit], truth[lit]).max() > 10.0, "the target does turn normals"
    assert not teeth[rows].any()


def test_the_file_stores_them_where_they_turn_and_nowhere_else(clone, gltf) -> None:
    names = gltf.meshes[0].extras["targetNames"]
    turns = dict(zip(clone.morph_names, normal_turns(clone), strict=True))
    for surface, primitive in zip(load_surfaces(), gltf.meshes[0].primitives, strict=False):
        assert all(set(target) == {"POSITION", "NORMAL"} for target in primitive.targets), "readers want all or none"
        for name, target in zip(names, primitive.targets, strict=True):
            stored = gltf.accessors[target["NORMAL"]].sparse.count
            vertex = creased_eyes()[0].vertex if surface.name == "eyes" else surface.vertex
            turned = int(np.isin(vertex, turns[name][0]).sum()) if name in turns else 0
            assert stored == max(turned, 1), "one row of zeros where nothing turns: some readers want it"


def test_correctives_and_small_files_keep_their_normals(clone, gltf) -> None:
    names = gltf.meshes[0].extras["targetNames"]
    bent = [target["NORMAL"] for name, target in zip(names, gltf.meshes[0].primitives[0].targets, strict=True)
            if name.startswith("corrective_")]  # fmt: skip
    assert len(bent) > 40
    assert len(set(bent)) == 1
    plain = build(clone, corrects=True)
    assert all(set(target) == {"POSITION"} for one in plain.meshes[0].primitives for target in one.targets)
