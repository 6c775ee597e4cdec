"""Photos on clones and on meshes from elsewhere, by files."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image

from cloner.errors import ClonerError
from cloner.exporters.shared.obj_files import read_obj, wrapped
from cloner.geometry.cameras.viewpoints import framing_camera
from cloner.picture import load_clone_at
from cloner.project.results import is_result, read_manifest
from cloner.render import render_mesh
from cloner.statues.markers import known_points, read_markers
from cloner.statues.photographed import photo_folder
from kit.clones import toy_clone
from kit.crowds import dressed_toy, saved
from unit.statues.test_photo_fit import MARKED


@pytest.fixture(scope="module")
def egg(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path, Path]:
    """A mesh, a photo of a taller one of its kind in red, and markers on both."""
    folder = tmp_path_factory.mktemp("egg")
    ball = trimesh.creation.icosphere(subdivisions=3)
    (folder / "ball.obj").write_text(trimesh.exchange.obj.export_obj(ball, include_normals=False), encoding="utf-8")
    mesh = read_obj(folder / "ball.obj")
    tall = mesh.vertices_m * [1.0, 1.25, 1.0]
    camera = framing_camera(tall, 0.0, 300, 400)
    picture = render_mesh(tall, mesh.triangles, camera, colour=(0.8, 0.1, 0.1), shading="photo", background=(0, 0, 255))
    Image.fromarray(picture).save(folder / "egg.png")
    front = np.flatnonzero(mesh.vertices_m[:, 2] > 0.3)[::7]
    told = [
        {"at": int(row), "px": px.round(3).tolist()} for row, px in zip(front, camera.project(tall[front]), strict=True)
    ]
    (folder / "markers.json").write_text(json.dumps({"format": 1, "markers": told}), encoding="utf-8")
    return folder / "ball.obj", folder / "egg.png", folder / "markers.json"


def test_a_mesh_from_elsewhere_is_bent_and_painted_all_round(egg, tmp_path: Path) -> None:
    mesh, photo, markers = egg
    folder, lines = photo_folder(photo, markers, tmp_path, "egg", onto=mesh, formats=(), texture_size=512)
    assert is_result(folder)
    assert "met exactly" in lines[0]
    made = trimesh.load(folder / "egg.obj", process=False)
    high, wide, _ = (float(np.ptp(made.vertices[:, k])) for k in (1, 0, 2))
    assert 1.1 < high / wide < 1.4  # taller now, as in the photo
    rgb = np.asarray(made.visual.material.image.convert("RGB")).astype(float)
    column, row = np.clip((made.visual.uv * [1, -1] + [0, 1]) * 511, 0, 511).astype(int).T
    colours = rgb[row, column]
    assert (colours[:, 0] > 150).all()  # red all round
    assert (colours[:, 2] < 120).all()  # and nothing of the blue behind it


def test_a_texture_is_wrapped_without_a_tear() -> None:
    ball = trimesh.creation.icosphere(subdivisions=3)
    uv, triangles = wrapped(np.asarray(ball.vertices), np.asarray(ball.faces, np.int32))
    across = np.ptp(uv[triangles][..., 0], axis=1)
    caps = np.abs(np.asarray(ball.vertices)[ball.faces][..., 1]).max(axis=1) > 0.95
    assert across[~caps].max() < 0.25
    assert uv.min() >= 0.0
    assert uv.max() <= 1.0


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("", "no surface"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "flat"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 9\n", "not there"),
        ("v 0 0 zero\n", "none of OBJ's"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 99999999999999999999\n", "none of OBJ's"),
        ("v 0 0 nan\nv 1 0 0\nv 0 1 1\nf 1 2 3\n", "no numbers"),
        ("v 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n", "no surface"),
    ],
)
def test_a_bad_mesh_is_refused_in_a_sentence(tmp_path: Path, text: str, word: str) -> None:
    (tmp_path / "bad.obj").write_text(text, encoding="utf-8")
    with pytest.raises(ClonerError, match=word):
        read_obj(tmp_path / "bad.obj")


def test_corners_may_count_from_the_end_and_polygons_are_cut(tmp_path: Path) -> None:
    (tmp_path / "box.obj").write_text(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 .5\nf -4/1 -3/2 -2/3 -1/4\n", encoding="utf-8"
    )
    mesh = read_obj(tmp_path / "box.obj")
    assert mesh.triangles.tolist() == [[0, 1, 2], [0, 2, 3]]
    assert mesh.uv_triangles.tolist() == [[0, 1, 2], [0, 2, 3]]
    assert mesh.uv[3].tolist() == [0.0, 0.5]
    assert mesh.uv[0].tolist() == [0.0, 1.0]  # v downwards


@pytest.fixture(scope="module")
def portrait(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    folder = tmp_path_factory.mktemp("portrait")
    clone, points = toy_clone(hair=False), known_points()
    head = clone.vertices_m[clone.vertices_m[:, 1] > 1.5]
    camera = framing_camera(head, 0.0, 300, 400)
    from cloner.render import render

    Image.fromarray(render(clone, camera)).save(folder / "statue.png")
    told = [{"at": name, "px": camera.project(clone.vertices_m[[points[name]]])[0].tolist()} for name in MARKED]
    (folder / "markers.json").write_text(json.dumps({"format": 1, "markers": told}), encoding="utf-8")
    return folder / "statue.png", folder / "markers.json"


def test_a_clone_gets_the_photo_and_may_be_cut_in_stone(portrait, tmp_path: Path) -> None:
    photo, markers = portrait
    folder, _ = photo_folder(photo, markers, tmp_path, "soldier", material="clay", formats=("glb",), texture_size=512)
    assert is_result(folder)
    clone = load_clone_at(folder)
    assert clone.atlas.shine.size
    assert not clone.consent  # nobody wrote that the photo may be shown
    manifest = read_manifest(folder)
    assert manifest is not None
    assert set(manifest.inputs) == {"photo"}


def test_consent_is_that_of_photo_and_clone(portrait, tmp_path: Path) -> None:
    photo, markers = portrait
    (photo.parent / "person.toml").write_text('consent = "a statue"\n', encoding="utf-8")
    ada = saved(tmp_path / "ada", dressed_toy())
    bea = saved(tmp_path / "bea", dressed_toy(consent=False))
    for onto, shown in ((ada, True), (bea, False), (None, True)):
        name = f"on-{onto.name if onto else 'nobody'}"
        folder, _ = photo_folder(photo, markers, tmp_path, name, onto=onto, formats=(), texture_size=512)
        assert load_clone_at(folder).consent is shown


@pytest.mark.parametrize(
    "text",
    [
        "", "[]", "{}", '{"format": 1}', '{"format": 2, "markers": []}', '{"format": 1, "markers": [{"at": 1}]}',
        '{"format": 1, "markers": [{"at": -1, "px": [1, 2]}]}',
        '{"format": 1, "markers": [{"at": true, "px": [1, 2]}]}',
        '{"format": 1, "markers": [{"at": 1, "px": [1, "2"]}]}', '{"format": 1, "markers": [{"at": 1, "px": [1]}]}',
        '{"format": 1, "markers": [{"at": 1, "px": [NaN, 1]}]}',
        '{"format": 1, "markers": [{"at": 1, "px": [1e9, 1]}]}',
    ],
)  # fmt: skip
def test_bad_markers_are_refused_in_a_sentence(tmp_path: Path, text: str) -> None:
    (tmp_path / "markers.json").write_text(text, encoding="utf-8")
    with pytest.raises(ClonerError):
        read_markers(tmp_path / "markers.json")


def test_names_are_those_of_clones(tmp_path: Path) -> None:
    (tmp_path / "m.json").write_text('{"format": 1, "markers": [{"at": "nose_tip", "px": [1, 2]}]}', encoding="utf-8")
    told = read_markers(tmp_path / "m.json")
    assert told.vertices(named=True).tolist() == [known_points()["nose_tip"]]
    with pytest.raises(ClonerError, match="nose_tip"):
        told.vertices(named=False)


def test_nothing_is_left_of_what_was_refused(egg, tmp_path: Path) -> None:
    mesh, photo, markers = egg
    with pytest.raises(ClonerError):
        photo_folder(photo, markers, tmp_path, "x", onto=mesh, material="clay", formats=(), texture_size=512)
    with pytest.raises(ClonerError):
        photo_folder(photo, markers, tmp_path, "x", formats=("doc",), texture_size=512)
    assert not list(tmp_path.iterdir())
