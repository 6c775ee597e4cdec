"""Other people's programs show the person: upright, not blank, and moving where the format has a motion."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from cloner.exporters.gltf.gltf_eyes import with_flat_irises
from cloner.exporters.table import EXPORTERS
from kit import readers
from kit.clones import toy_clone
from kit.readers import Picture, person

pytestmark = pytest.mark.slow
STATURE_M = 1.64

THREE = pytest.mark.skipif(
    not readers.HAS_THREE, reason="three, three-vrm, esbuild or Chromium is not here; run: npm install three esbuild"
)
BLENDER = pytest.mark.skipif(
    not readers.HAS_BLENDER,
    reason="Blender is not here (CI leaves out its 500 MB); run: apt-get install blender, or set CLONER_BLENDER_PYTHON",
)
GODOT = pytest.mark.skipif(readers.GODOT is None, reason="Godot is not here; run: apt-get install godot3-server")
VIEW3DSCENE = pytest.mark.skipif(
    not readers.HAS_VIEW3DSCENE, reason="view3dscene is not here; run: sudo apt-get install -y view3dscene xvfb"
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    made = tmp_path_factory.mktemp("readers")
    for name in ("glb", "small", "mixamo", "flat", "wrl", "hanim", "x3d"):
        EXPORTERS.get(name)(toy_clone(STATURE_M), made)
    return made


def upright(picture: np.ndarray) -> None:
    seen = np.argwhere(person(picture))
    assert len(seen) > 0.02 * picture.shape[0] * picture.shape[1], "the picture is blank"
    assert np.ptp(seen[:, 0]) > 1.3 * np.ptp(seen[:, 1]), "not upright"


@pytest.mark.parametrize(
    ("reader", "file", "moves"),
    [
        pytest.param(readers.three, "clone_small.glb", True, marks=THREE),
        pytest.param(readers.three, "clone_mixamo.glb", True, marks=THREE),
        pytest.param(readers.three, "clone_flat.wrl", False, marks=THREE),
        pytest.param(readers.blender, "clone.glb", True, marks=BLENDER),
    ],
)
def test_the_person_stands_in_metres_and_walks(
    reader: Callable[[Path], Picture], file: str, moves: bool, folder: Path
) -> None:
    picture, told = reader(folder / file)
    assert told.get("error") is None
    assert told["height_m"] == pytest.approx(STATURE_M + 0.01, abs=0.05)
    assert (told["moved_m"] > 0.05) == moves
    assert told.get("bones", 94) == 94
    assert told.get("shapes", 68) >= 68, "67 targets and the rest; correctives behind them"
    upright(picture)


@VIEW3DSCENE
def test_view3dscene_draws_the_skin_without_a_warning(folder: Path) -> None:
    picture, told = readers.view3dscene(folder / "clone.x3d")
    assert told.get("error") is None
    assert told["warnings"] == []
    upright(picture)


@VIEW3DSCENE
def test_view3dscene_opens_the_default_world_as_it_is_and_it_walks(folder: Path) -> None:
    first, told = readers.view3dscene(folder / "clone.wrl", 0.1)
    second, _ = readers.view3dscene(folder / "clone.wrl", 0.35)
    assert told.get("error") is None
    assert told["warnings"] == []
    upright(first)
    changed = np.abs(first.astype(int) - second.astype(int)).max(axis=2) > 24
    assert changed.sum() > 0.1 * person(first).sum(), "it stands still"


@VIEW3DSCENE
def test_view3dscene_s_own_h_anim_nodes_take_our_joints_and_walk(folder: Path) -> None:
    """A foreign declaration of Humanoid, Joint, Segment, Site and Displacer knows every field that the file uses."""
    first, told = readers.view3dscene_without_prototypes(folder / "clone_hanim.wrl", 0.1)
    second, _ = readers.view3dscene_without_prototypes(folder / "clone_hanim.wrl", 0.35)
    assert told.get("error") is None
    assert told["warnings"] == []
    upright(first)
    changed = np.abs(first.astype(int) - second.astype(int)).max(axis=2) > 24
    assert changed.sum() > 0.1 * person(first).sum(), "it stands still"


@GODOT
def test_godot_moves_faces_as_far_as_they_move(folder: Path) -> None:
    """Godot 3 takes a sparse accessor without a view for the first view of the file; faces flew metres away."""
    clone = with_flat_irises(toy_clone(STATURE_M))  # a pupil behind the ball's front moves less
    told = readers.godot(folder / "clone.glb")
    assert told.get("error") is None
    assert (told["joints"], told["clips"]) == (94, 2)
    assert told["high"] - told["low"] == pytest.approx(STATURE_M + 0.01, abs=0.05)
    for number, name in enumerate(clone.morph_names):
        rows = slice(int(clone.morph_start[number]), int(clone.morph_start[number + 1]))
        most_mm = 1000.0 * np.linalg.norm(clone.morph_delta_m[rows], axis=1).max(initial=0.0)
        assert told["moves_mm"][name] == pytest.approx(most_mm, abs=0.1), name
