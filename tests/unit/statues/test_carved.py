"""A clone in stone: one material all over, its relief kept, its rig alive."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pygltflib
import pytest

from cloner.bodies.undressed import undressed_clone
from cloner.crowd.clones.cast import make_crowd_clone
from cloner.crowd.clones.groups import WORN
from cloner.crowd.clones.levels import body_levels
from cloner.errors import ClonerError
from cloner.exporters.gltf.gltf import build, export
from cloner.generic.charts import generic_atlas
from cloner.generic.load import load_generic
from cloner.motion.limbs.rig import centre_joints
from cloner.paint.details.parts import fit_sphere
from cloner.project.clone_file import load_clone, save_clone
from cloner.records.clones import Clone
from cloner.statues.carved import statue_of
from cloner.statues.eyes import DRILLED
from cloner.statues.materials import MATERIALS
from cloner.statues.noise import MaterialBlock
from cloner.statues.relief import detail, hollows
from kit.clones import RED_LEFT_HAND
from kit.crowds import dressed_toy


@pytest.fixture(scope="module")
def person() -> Clone:
    return dressed_toy(1.7)


@pytest.fixture(scope="module", params=tuple(MATERIALS))
def statue(request, person: Clone) -> tuple[str, Clone]:
    return request.param, statue_of(person, request.param)


def _texels(part: str, size: int) -> np.ndarray:
    """Rows and columns of a part's texels."""
    generic = load_generic()
    atlas = generic_atlas(generic, size)
    own = generic.vertex_part[atlas.triangles[:, 0]] == generic.part_names.index(part)
    return np.stack(np.divmod(atlas.texel[atlas.rows_of(own)], size))


def test_nothing_painted_is_left(statue) -> None:
    name, clone = statue
    rgb = clone.atlas.rgb.astype(float)
    skin = rgb[tuple(_texels("body", len(rgb)))]
    usual = np.median(skin, axis=0)
    assert np.abs(skin - RED_LEFT_HAND).max(axis=1).min() > 25.0  # no texel of the red hand
    tinge = np.log((skin[:, [0, 2]] + 20.0) / (skin[:, 1:2] + 20.0))
    own = np.log((usual[[0, 2]] + 20.0) / (usual[1] + 20.0))
    far = 0.8 if name == "bronze" else 0.3  # patina is green, the bronze below brown
    assert np.abs(tinge - own).max() < far
    shell = clone.shells[0].rgba
    assert set(np.unique(shell[..., 3])) <= {0, 255}
    hair = shell[shell[..., 3] > 0][:, :3].mean(axis=0)
    assert np.abs(np.log(hair / usual)).max() < 0.45  # brown hair is stone too


def test_eyes_are_of_the_same_block(statue) -> None:
    _, clone = statue
    rgb = clone.atlas.rgb.astype(float)
    usual = np.median(rgb[tuple(_texels("body", len(rgb)))], axis=0)
    for side in ("left", "right"):
        eye = rgb[tuple(_texels(f"eye_{side}", len(rgb)))]
        assert np.abs(np.log(np.median(eye, axis=0) / usual)).max() < 0.45  # no white, no coloured iris
        assert eye.sum(axis=1).min() < 0.5 * usual.sum()  # the drilled pupil is dark
    teeth = rgb[tuple(_texels("teeth_upper", len(rgb)))]
    assert teeth.mean() < 0.5 * usual.mean()


def test_the_same_clone_gives_the_same_statue(person: Clone) -> None:
    first, second = (statue_of(person, "stone") for _ in range(2))
    assert np.array_equal(first.atlas.rgb, second.atlas.rgb)
    assert np.array_equal(first.shells[0].rgba, second.shells[0].rgba)
    assert np.array_equal(first.atlas.shine, second.atlas.shine)


def test_a_line_of_the_photo_is_carved_where_it_was_and_nowhere_else(person: Clone) -> None:
    size = len(person.atlas.rgb)
    row, column = (int(x) for x in np.median(_texels("body", size), axis=1))
    lined = person.atlas.rgb.copy()
    plain = lined.copy()
    plain[row - 60 : row + 60, column - 60 : column + 60] = (180, 150, 130)
    lined[:] = plain
    lined[row - 1 : row + 2, column - 30 : column + 30] = (60, 50, 45)
    with_line, without = (
        statue_of(replace(person, atlas=replace(person.atlas, rgb=rgb)), "marble").atlas.rgb.astype(float)
        for rgb in (lined, plain)
    )
    changed = np.abs(with_line - without).max(axis=2)
    assert changed[row - 2 : row + 3, column - 25 : column + 25].mean() > 6.0
    away = np.ones_like(changed, dtype=bool)
    away[row - 45 : row + 46, column - 75 : column + 76] = False
    assert changed[away].max() <= 1.0  # a level: the tail of what counts as tone


def test_pupils_are_drilled_and_turn_with_the_ball(person: Clone) -> None:
    generic, clone = load_generic(), statue_of(person, "stone")
    rows = generic.part("eye_left")
    centre, _ = fit_sphere(person.vertices_m[rows])
    pole = rows[np.argmax(person.vertices_m[rows, 2])]
    deep = np.linalg.norm(clone.vertices_m[pole] - centre) / np.linalg.norm(person.vertices_m[pole] - centre)
    assert deep == pytest.approx(1.0 - DRILLED)
    number = clone.morph_names.index("eyeLookOutLeft")
    own = slice(clone.morph_start[number], clone.morph_start[number + 1])
    index, before, after = clone.morph_index[own], person.morph_delta_m[own], clone.morph_delta_m[own]
    assert after[index == pole] == pytest.approx(deep * before[index == pole], rel=1e-3)
    back = rows[np.argmin(person.vertices_m[rows, 2])]
    assert np.array_equal(clone.vertices_m[back], person.vertices_m[back])


def test_lashes_are_gone_into_the_ball(person: Clone) -> None:
    generic, clone = load_generic(), statue_of(person, "stone")
    for side in ("left", "right"):
        centre, radius = fit_sphere(person.vertices_m[generic.part(f"eye_{side}")])
        lashes = clone.vertices_m[generic.part(f"lashes_{side}")]
        assert np.linalg.norm(lashes - centre, axis=1).max() < 0.1 * radius
        assert np.ptp(lashes, axis=0).max() > 0.0  # no triangle without area
    body = generic.part("body")
    assert np.array_equal(clone.vertices_m[body], person.vertices_m[body])


def test_bronze_is_metal_with_patina_in_gltf_and_stone_is_not(person: Clone, tmp_path) -> None:
    for name, most in (("bronze", 255), ("stone", 0)):
        clone = statue_of(person, name)
        assert clone.atlas.shine[..., 2].max() == most
        gltf = build(centre_joints(clone))
        looks = {material.name: material.pbrMetallicRoughness for material in gltf.materials}
        for part in ("body", "eyes", "mouth"):
            assert looks[part].metallicRoughnessTexture is not None
            assert (looks[part].metallicFactor, looks[part].roughnessFactor) == (1.0, 1.0)
        assert looks["hair"].metallicFactor == pytest.approx(most / 255.0)
    (path,) = export(statue_of(person, "bronze"), tmp_path)
    assert pygltflib.GLTF2().load_binary(str(path)).animations
    shine = statue_of(person, "bronze").atlas.shine[..., 2]
    assert 0.02 < (shine < 60).mean() < 0.6  # patina somewhere, not everywhere


def test_shine_outlives_the_file(person: Clone, tmp_path) -> None:
    clone = statue_of(person, "bronze")
    save_clone(clone, tmp_path / "clone.npz")
    again = load_clone(tmp_path / "clone.npz")
    assert np.array_equal(again.atlas.shine, clone.atlas.shine)
    save_clone(person, tmp_path / "person.npz")
    assert load_clone(tmp_path / "person.npz").atlas.shine.size == 0


def test_a_crowd_dyes_no_statue(person: Clone) -> None:
    clone = statue_of(person, "clay")
    cast = make_crowd_clone("clay", centre_joints(clone), body_levels(), poses=8)
    assert not set(cast.looks) & set(WORN)


def test_a_statue_may_be_cut_anew_but_not_undressed(person: Clone) -> None:
    stone = statue_of(person, "stone")
    bronze = statue_of(stone, "bronze")
    assert np.array_equal(bronze.vertices_m, stone.vertices_m)  # pupils are not drilled twice
    assert bronze.atlas.shine[..., 2].max() == 255
    with pytest.raises(ClonerError, match="statue"):
        undressed_clone(stone, "f")


def test_an_unknown_material_is_refused(person: Clone) -> None:
    with pytest.raises(ClonerError, match="jade"):
        statue_of(person, "jade")


def test_hollows_tell_dents_from_ridges() -> None:
    steps = np.linspace(-0.1, 0.1, 61)
    x, z = (each.ravel() for each in np.meshgrid(steps, steps))
    y = -0.02 * np.exp(-((x + 0.05) ** 2 + z**2) / 2e-4) + 0.02 * np.exp(-((x - 0.05) ** 2 + z**2) / 2e-4)
    row = np.arange(61 * 61).reshape(61, 61)
    a, b, c, d = (each.ravel() for each in (row[:-1, :-1], row[:-1, 1:], row[1:, 1:], row[1:, :-1]))
    triangles = np.concatenate([np.stack([a, c, b], 1), np.stack([a, d, c], 1)]).astype(np.int32)
    found = hollows(np.stack([x, y, z], 1), triangles).reshape(61, 61)
    assert found[30, 15] > 0.5
    assert found[30, 45] < -0.5
    assert abs(found[8, 30]) < 0.05


def test_detail_is_blind_to_tone() -> None:
    ramp = np.tile(np.linspace(60, 200, 512)[None, :, None], (512, 1, 3)).astype(np.uint8)
    assert np.abs(detail(ramp, np.ones((512, 512), bool))[60:-60, 60:-60]).max() < 0.08
    lined = cv2.line(ramp.copy(), (200, 256), (300, 256), (20, 20, 20), 2)
    assert detail(lined, np.ones((512, 512), bool))[256, 250] < -0.5


def test_blocks_are_even_and_pores_whole() -> None:
    places = np.random.default_rng(3).uniform(-1.0, 2.0, (60_000, 3))
    values = MaterialBlock(1).waves(places, (0.004, 0.05))
    assert values.mean() == pytest.approx(0.0, abs=0.05)
    assert values.std() == pytest.approx(1.0, abs=0.05)
    assert not np.allclose(values, MaterialBlock(2).waves(places, (0.004, 0.05)))
    pores = MaterialBlock(1).pores(places, 0.01, 0.4)
    assert 0.005 < (pores > 0.0).mean() < 0.05
    steps = np.linspace(0.0, 1.0, 200_001)[:, None] * [0.3, 0.2, 0.1] + [0.1, 0.2, 0.3]
    along = MaterialBlock(1).pores(steps, 0.01, 1.0)
    assert np.abs(np.diff(along)).max() < 0.01  # none is cut off at its cell's side


def test_glasses_are_cut_too_and_single_hairs_are_not(person: Clone) -> None:
    hair = person.shells[0]
    wide = replace(hair, kind="glasses", rgba=np.ascontiguousarray(hair.rgba[: len(hair.rgba) // 2]))
    flat = replace(wide, uv=hair.uv * (1.0, 0.5))
    worn = replace(person, shells=(hair, flat, replace(hair, kind="frizz")))
    cut = statue_of(worn, "stone")
    assert [shell.kind for shell in cut.shells] == ["hair", "glasses"]
    glasses = cut.shells[1]
    assert glasses.rgba.shape[0] == glasses.rgba.shape[1] == flat.rgba.shape[1]
    np.testing.assert_allclose(glasses.uv[:, 1] * len(glasses.rgba), flat.uv[:, 1] * len(flat.rgba), atol=1e-6)
