"""A beard moves with the jaw in whatever a clone is written as."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pygltflib
import pytest

from cloner.errors import ClonerError
from cloner.exporters.gltf import gltf
from cloner.exporters.vrml.vrml_segments import skin_meshes
from cloner.generic.load import load_generic
from cloner.project.clone_file import load_clone, save_clone
from kit.beards import bearded_clone


def jaw_offsets(clone):
    """Return (V, 3) how the jaw's opening moves the skin, metres."""
    number = clone.morph_names.index("jawOpen")
    rows = slice(int(clone.morph_start[number]), int(clone.morph_start[number + 1]))
    offsets = np.zeros_like(clone.vertices_m)
    offsets[clone.morph_index[rows]] = clone.morph_delta_m[rows]
    return offsets


def test_glb_opens_the_beard_with_the_jaw(tmp_path):
    clone = bearded_clone()
    (path,) = gltf.export(clone, tmp_path)
    read = pygltflib.GLTF2().load(str(path))
    body = next(mesh for mesh in read.meshes if mesh.name == "Body")
    beard = body.primitives[-1]
    assert read.materials[beard.material].name == "beard"
    assert [mesh.name for mesh in read.meshes] == ["Body", "Hair"]
    names = body.extras["targetNames"]
    assert len(beard.targets) == len(names)
    moved = read.accessors[beard.targets[names.index("jawOpen")]["POSITION"]]
    wanted = jaw_offsets(clone)[clone.shells[-1].rides]
    # the chin goes down by centimetres; the accessor tells the box of its offsets, a sparse one with zero in it
    assert np.allclose(moved.min, np.minimum(wanted.min(axis=0), 0.0), atol=1e-5)
    assert np.allclose(moved.max, np.maximum(wanted.max(axis=0), 0.0), atol=1e-5)
    assert wanted[:, 1].max() < -0.01


def test_every_other_format_reads_the_skin_that_carries_it():
    clone = bearded_clone()
    beard = skin_meshes(clone, load_generic(), "clone")[-1]
    assert np.array_equal(beard.vertex, clone.shells[-1].rides)


def test_the_clone_s_file_keeps_what_it_rides_on(tmp_path):
    clone = bearded_clone()
    save_clone(clone, tmp_path / "clone.npz")
    back = load_clone(tmp_path / "clone.npz")
    assert [shell.kind for shell in back.shells] == ["hair", "beard"]
    assert len(back.shells[0].rides) == 0
    assert np.array_equal(back.shells[1].rides, clone.shells[1].rides)


def test_a_beard_that_rides_on_nothing_there_is_is_refused(tmp_path):
    clone = bearded_clone()
    wrong = replace(clone.shells[1], rides=clone.shells[1].rides + len(clone.vertices_m))
    save_clone(replace(clone, shells=(clone.shells[0], wrong)), tmp_path / "clone.npz")
    with pytest.raises(ClonerError, match="not a readable clone"):
        load_clone(tmp_path / "clone.npz")
