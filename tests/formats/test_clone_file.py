"""clone.npz gives back the very same clone."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project.clone_file import load_clone, save_clone
from cloner.records.bodies import PosedView
from cloner.records.terms import Terms
from cloner.records.views import Camera
from kit.clones import toy_clone
from kit.compare_clones import snapshot


def test_a_clone_comes_back_bit_for_bit(tmp_path):
    clone = toy_clone(1.6180339887)
    flat = Camera(300, 401, 0.0, np.eye(4), pixels_per_m=1.0 / 3.0)
    views = dict(clone.views) | {ViewId.FACE_SIDE: PosedView(ViewId.FACE_SIDE, flat, np.full((94, 3), 0.1))}
    clone = replace(clone, views=views, sole_m=0.1 + 0.2, measures_mm={"chest_girth": 0.1 + 0.2}, consent=True)
    clone = replace(clone, terms=Terms("Zoë", "Fair", "event"))
    before = snapshot(clone)
    save_clone(clone, tmp_path / "clone.npz")
    assert snapshot(clone) == before
    back = load_clone(tmp_path / "clone.npz")
    assert snapshot(back) == before
    assert (back.measures_mm, back.consent) == (clone.measures_mm, True)
    assert back.terms == Terms("Zoë", "Fair", "event")
    assert [path.name for path in tmp_path.iterdir()] == ["clone.npz"]


def test_a_clone_without_hair_views_or_morphs_comes_back(tmp_path):
    empty = np.zeros(0, np.int32)
    clone = replace(
        toy_clone(hair=False), views={}, features_m={}, morph_names=(), morph_index=empty,
        morph_delta_m=np.zeros((0, 3)), morph_start=[0],
    )  # fmt: skip
    save_clone(clone, tmp_path / "clone.npz")
    assert snapshot(load_clone(tmp_path / "clone.npz")) == snapshot(clone)


@pytest.mark.parametrize("damage", ["cut", "text", "other npz", "missing"])
def test_a_file_that_is_no_clone_is_an_operator_s_error(damage, tmp_path):
    path = tmp_path / "clone.npz"
    save_clone(toy_clone(hair=False), path)
    if damage == "cut":
        path.write_bytes(path.read_bytes()[:5000])
    elif damage == "text":
        path.write_text("not a clone")
    elif damage == "other npz":
        np.savez(path, vertices=np.zeros(3))
    else:
        path.unlink()
    with pytest.raises(ClonerError) as caught:
        load_clone(path)
    assert caught.value.where == "clone.npz"
    assert "clone" in caught.value.hint.lower()


def test_a_newer_file_says_so(tmp_path, monkeypatch):
    monkeypatch.setattr("cloner.project.clone_file.VERSION", 2)
    save_clone(toy_clone(hair=False), tmp_path / "clone.npz")
    monkeypatch.setattr("cloner.project.clone_file.VERSION", 1)
    with pytest.raises(ClonerError, match="newer"):
        load_clone(tmp_path / "clone.npz")
