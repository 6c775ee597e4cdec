"""A clone without its clothes is the body under them in its own skin, decent, and belongs to the same visitor."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from cloner.bodies.bare import bare_skin, worn_skin
from cloner.bodies.made import clone_of_measures
from cloner.bodies.telling import BodySpecification
from cloner.bodies.undressed import undress_folder, undressed_clone
from cloner.errors import Cancelled, ClonerError
from cloner.generic.charts import generic_atlas
from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measuring import measures_mm
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.picture import load_clone_at
from cloner.project.clone_file import save_clone
from cloner.records.clones import Clone, TextureAtlas
from cloner.records.heads import Shell
from cloner.records.regions import REGIONS

SKIN = np.array([200.0, 150.0, 125.0])
GREEN = np.array([20.0, 160.0, 60.0])
SOLE_M = 0.02


@pytest.fixture(scope="module")
def naked() -> Clone:
    return clone_of_measures(BodySpecification("m", 1.78, {"waist_girth": 860.0}), 512)


@pytest.fixture(scope="module")
def dressed(naked: Clone) -> Clone:
    """Return the same man in a green coat 3 cm off his trunk, arms and thighs, 6 cm at one hip, and shoes."""
    generic = load_generic()
    triangles, _ = generic.triangles()
    segment = np.array(generic.segment_names)[generic.vertex_segment]
    body = (generic.vertex_part == generic.part_names.index("body")) & (generic.head_blend < 0.02)
    under = body & np.isin(
        segment, ["torso", "pelvis", "left_upper_arm", "right_upper_arm", "left_thigh", "right_thigh"]
    )
    shod = body & np.isin(segment, ["left_foot", "right_foot"])
    normals = vertex_normals(naked.vertices_m, triangles.astype(np.int32))
    bump = 0.03 * np.exp(-((naked.vertices_m - naked.vertices_m[generic.feature("buttock_left")]) ** 2).sum(1) / 0.005)
    vertices = naked.vertices_m + (np.where(under, 0.03, 0.0) + under * bump)[:, None] * normals
    vertices += [0.0, SOLE_M, 0.0]
    regions = np.full(len(triangles), REGIONS.index("skin"))
    regions[under[triangles].all(axis=1)] = REGIONS.index("upper_clothes")
    regions[shod[triangles].all(axis=1)] = REGIONS.index("shoes")
    scalp = generic.region("scalp")[triangles].all(axis=1)
    regions[scalp] = REGIONS.index("hair")
    atlas = generic_atlas(generic, 512)
    rgb = np.tile(SKIN.astype(np.uint8), (512, 512, 1))
    covered = np.isin(regions, [REGIONS.index("upper_clothes"), REGIONS.index("shoes")])
    rgb.reshape(-1, 3)[atlas.texel[covered[atlas.triangle]]] = GREEN.astype(np.uint8)
    grainy = rgb.astype(np.int64) + np.random.default_rng(1).integers(-4, 5, rgb.shape)
    empty = np.zeros((2, 2, 4), np.uint8)
    joints, weights = np.zeros((3, 4), np.int32), np.tile([1.0, 0, 0, 0], (3, 1))
    skirt = Shell(vertices[:3], np.array([[0, 1, 2]], np.int32), np.zeros((3, 2)), joints, weights, empty, kind="cloth")
    hair = replace(skirt, vertices_m=vertices[generic.feature("head_top")] + 0.01 * np.eye(3), kind="hair")
    return replace(
        naked, vertices_m=vertices, joints_m=naked.joints_m + [0.0, SOLE_M, 0.0], sole_m=SOLE_M, consent=True,
        atlas=TextureAtlas(np.clip(grainy, 0, 255).astype(np.uint8), np.full((512, 512), 255, np.uint8)),
        triangle_regions=regions.astype(np.uint8), shells=(skirt, hair),
    )  # fmt: skip


@pytest.fixture(scope="module")
def bare(dressed: Clone) -> Clone:
    return undressed_clone(dressed, "m")


def test_bare_skin_is_what_is_neither_worn_nor_at_a_hem(dressed: Clone) -> None:
    generic, bare = load_generic(), bare_skin(dressed)
    for name in ("fingertip_left", "nose_tip", "calf_right"):
        assert bare[generic.feature(name)]
    assert not (bare & worn_skin(generic, dressed)).any()
    assert not bare[generic.feature("waist_front")]


def test_the_body_is_the_one_that_was_dressed(naked: Clone, dressed: Clone, bare: Clone) -> None:
    generic = load_generic()
    found = measures_mm(bare.vertices_m, bare.joints_m, load_tape_rules(), 0.0)
    for key in ("bust_girth", "waist_girth", "hip_girth", "thigh_girth", "upper_arm_girth"):
        assert found[key] == pytest.approx(naked.measures_mm[key], abs=3.0)
    under = worn_skin(generic, dressed) & (generic.head_blend < 0.02)
    normals = vertex_normals(naked.vertices_m, generic.triangles()[0].astype(np.int32))
    off = np.einsum("ij,ij->i", bare.vertices_m - naked.vertices_m, normals)[under]
    assert np.median(np.abs(off)) < 0.008  # it stood 3 cm off
    seat = generic.feature("buttock_left")
    assert abs(float(off[np.flatnonzero(under).tolist().index(seat)])) < 0.02  # the bump of 6 cm is gone


def test_head_and_hands_stay_and_the_feet_are_bare(naked: Clone, dressed: Clone, bare: Clone) -> None:
    generic = load_generic()
    for name in ("nose_tip", "head_top", "fingertip_left"):
        row = generic.feature(name)
        assert bare.vertices_m[row] == pytest.approx(dressed.vertices_m[row] - [0.0, SOLE_M, 0.0], abs=1e-9)
    assert bare.sole_m == 0.0
    assert bare.vertices_m[:, 1].min() == pytest.approx(0.0, abs=1e-9)
    assert [shell.kind for shell in bare.shells] == ["hair"]
    assert bare.shells[0].vertices_m == pytest.approx(dressed.shells[1].vertices_m - [0.0, SOLE_M, 0.0], abs=1e-3)
    assert bare.measures_mm == dressed.measures_mm


def test_skin_is_the_person_s_own_and_what_must_be_is_covered(bare: Clone) -> None:
    generic = load_generic()
    atlas = generic_atlas(generic, 512)
    rgb = bare.atlas.rgb.reshape(-1, 3)[atlas.texel].astype(np.float64)
    triangles, _ = generic.triangles()
    body = generic.vertex_part[triangles[:, 0]] == generic.part_names.index("body")
    skin = (bare.triangle_regions == REGIONS.index("skin")) & body
    shown = rgb[skin[atlas.triangle]]
    assert np.abs(np.median(shown, axis=0) - SKIN).max() < 4.0
    assert (shown[:, 1] - shown[:, 0] > 20.0).mean() < 0.001  # nothing of the green coat
    crotch = (triangles == generic.feature("crotch")).any(axis=1)
    assert set(bare.triangle_regions[crotch]) == {REGIONS.index("lower_clothes")}
    assert bare.atlas.coverage.reshape(-1)[atlas.texel[crotch[atlas.triangle]]].max() == 0
    spread = rgb[(triangles == generic.feature("waist_front")).any(axis=1)[atlas.triangle]].std(axis=0)
    assert 0.5 < spread.mean() < 8.0  # grain, as the skin it was taken from has 2.6 levels


def test_nobody_is_undressed_who_did_not_agree(dressed: Clone) -> None:
    for changed, names in (
        (replace(dressed, consent=False), "consent"), (replace(dressed, stature_m=1.2), "child"),
        (replace(dressed, measures_mm={}), "no measures"),
        (replace(dressed, triangle_regions=np.zeros(0, np.uint8)), "clothes from its skin"),
    ):  # fmt: skip
        with pytest.raises(ClonerError, match=names):
            undressed_clone(changed, "m")


def test_the_result_belongs_to_the_same_visitor(dressed: Clone, tmp_path: Path) -> None:
    source = tmp_path / "tom"
    source.mkdir()
    save_clone(dressed, source / "clone.npz")
    told = {"format": 3, "source": "tom", "outputs": {}, "stamp": {"photos": {"body_front": "a" * 64}}}
    (source / "report.json").write_text(json.dumps(told))

    def stop(step: str, fraction: float) -> None:
        if step == "export":
            raise Cancelled

    def undress(progress: Callable[[str, float], None]) -> Path:
        return undress_folder(source, tmp_path / "out", "", formats=(), progress=progress)

    with pytest.raises(Cancelled):
        undress(stop)
    assert not (tmp_path / "out" / "tom-undressed").exists()
    folder = undress(lambda step, fraction: None)
    manifest = json.loads((folder / "report.json").read_text())
    assert manifest["stamp"]["photos"] == {"body_front": "a" * 64}
    assert manifest["kind"] == "undressed"
    assert load_clone_at(folder).sole_m == 0.0
