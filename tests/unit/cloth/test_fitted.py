"""Clothes in the form of MakeHuman's community, of the test's own numbers, fitted by their rows."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from cloner.bodies.made import clone_of_measures
from cloner.bodies.telling import BodySpecification
from cloner.cloth.fitted import ALL, CLEAR_M, SKIN, base_mesh_m, fit_folder, fitted_shell, read_mhclo
from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.project.clone_file import load_clone, save_clone
from cloner.records.clones import Clone

#: Pairs of vertices that spans are measured between (x, y, z), and their spans on the generic human.
SPANS = ((5399, 11998), (791, 881), (962, 5320))


@pytest.fixture(scope="module")
def eva() -> Clone:
    return clone_of_measures(BodySpecification("f", 1.72, {"bust_girth": 980.0, "waist_girth": 800.0}), 512)


@pytest.fixture
def vest(tmp_path: Path) -> Path:
    return written(tmp_path)


def written(folder: Path, material: str = "vest.mhmat", spans: float = 1.0) -> Path:
    """Write a vest that lies 1 cm off the generic human's trunk: each vertex beside one of the skin and two more."""
    generic = load_generic()
    triangles, _ = generic.triangles()
    trunk = generic.segment("torso") & generic.skin
    faces = triangles[trunk[triangles].all(axis=1) & (triangles < SKIN).all(axis=1)]
    used = np.unique(faces)
    faces = np.searchsorted(used, faces)
    beside = {int(row): triangles[(triangles == row).any(axis=1)][0] for row in used}
    out = 0.01 * vertex_normals(generic.vertices_m.astype(np.float64), triangles.astype(np.int32))
    lines = ["# a vest", "name vest", "obj_file vest.obj", f"material {material}"]
    for name, axis, (one, other) in zip("xyz", range(3), SPANS, strict=True):
        length = 10.0 * abs(generic.vertices_m[one, axis] - generic.vertices_m[other, axis]) * spans
        lines.append(f"{name}_scale {one} {other} {length:.6f}")
    lines.append("verts 0")
    for row in used:
        three = [int(row), *(int(each) for each in beside[int(row)] if each != row)][:3]
        off = 10.0 * out[row]
        lines.append(f"{three[0]} {three[1]} {three[2]} 1.0 0.0 0.0 {off[0]:.6f} {off[1]:.6f} {off[2]:.6f}")
    head, body = lines[: lines.index("verts 0") + 1], lines[lines.index("verts 0") + 1 :]
    (folder / "vest.mhclo").write_text("\n".join([*head, *body, "delete_verts", "1 - 5"]) + "\n")
    (folder / "vest.mhmat").write_text("name vest\ndiffuseTexture vest.png\n")
    Image.new("RGB", (64, 64), (200, 30, 40)).save(folder / "vest.png")
    places = ["v 0 0 0", *(f"v {k} {k % 7} 1" for k in range(1, len(used)))]
    shown = [f"f {' '.join(f'{corner + 1}/1' for corner in face)}" for face in faces]
    (folder / "vest.obj").write_text("\n".join([*places, "vt 0.25 0.75", *shown]) + "\n")
    return folder / "vest.mhclo"


def test_a_garment_lies_on_another_body_as_its_rows_say(vest: Path, eva: Clone) -> None:
    shell = fitted_shell(eva, read_mhclo(vest))
    used = np.unique(read_mhclo(vest).rows[:, 0])
    away = np.linalg.norm(shell.vertices_m - eva.vertices_m[used], axis=1)
    assert np.median(away) == pytest.approx(0.01, abs=0.003)
    assert away.min() > 0.5 * CLEAR_M
    assert away.max() < 0.04
    generic = load_generic()
    assert shell.skin_weights.sum(axis=1) == pytest.approx(1.0)
    first = shell.skin_joints[:, 0]
    assert (first == generic.skin_joints[used, generic.skin_weights[used].argmax(axis=1)]).mean() > 0.95
    assert shell.uv[0] == pytest.approx([0.25, 0.25])
    assert shell.rgba[0, 0].tolist() == [200, 30, 40, 255]


def test_offsets_grow_with_the_body(tmp_path: Path, eva: Clone) -> None:
    """Spans told half as long: offsets are twice as long."""
    shell = fitted_shell(eva, read_mhclo(written(tmp_path, spans=0.5)))
    used = np.unique(read_mhclo(tmp_path / "vest.mhclo").rows[:, 0])
    assert np.median(np.linalg.norm(shell.vertices_m - eva.vertices_m[used], axis=1)) == pytest.approx(0.02, abs=0.005)


def test_helpers_lie_about_the_body(eva: Clone) -> None:
    base = base_mesh_m(eva)
    assert base.shape == (ALL, 3)
    assert base[:SKIN].tolist() == eva.vertices_m[:SKIN].tolist()
    low, high = eva.vertices_m.min(axis=0) - 0.3, eva.vertices_m.max(axis=0) + 0.3
    assert ((base[SKIN:] > low) & (base[SKIN:] < high)).all()


def test_the_result_wears_one_garment_and_then_another(vest: Path, eva: Clone, tmp_path: Path) -> None:
    (tmp_path / "eva").mkdir()
    save_clone(eva, tmp_path / "eva" / "clone.npz")
    fit_folder(tmp_path / "eva", vest, tmp_path / "once", formats=("glb",))
    fit_folder(tmp_path / "once", vest, tmp_path / "twice", formats=())
    once, twice = (load_clone(tmp_path / name / "clone.npz") for name in ("once", "twice"))
    (one,), (both,) = ([shell for shell in clone.shells if shell.kind == "cloth"] for clone in (once, twice))
    assert len(both.vertices_m) == 2 * len(one.vertices_m)
    assert both.uv[0, 0] == pytest.approx(one.uv[0, 0] / 2.0)
    assert both.uv[-1, 0] == pytest.approx(0.5 + one.uv[-1, 0] / 2.0)
    assert (tmp_path / "once" / "clone.glb").is_file()
    with pytest.raises(ClonerError, match="result's folder"):
        fit_folder(tmp_path / "eva", vest, tmp_path / "film.webp", formats=())


def test_what_is_no_garment_is_refused_in_one_sentence(vest: Path, tmp_path: Path) -> None:
    text = vest.read_text()
    cases = (
        (text.replace("obj_file vest.obj", "obj_file ../vest.obj"), "no garment of MakeHuman's"),
        (text.replace("obj_file vest.obj", "obj_file none.obj"), "does not lie beside"),
        (text.replace("x_scale", "q_scale"), "no garment of MakeHuman's"),
        (text.replace("verts 0\n", "verts 0\n19158 0 0 1 0 0 0 0 0\n"), "no garment of MakeHuman's"),
        (text.replace("verts 0\n", "verts 0\n1 2\n"), "no garment of MakeHuman's"),
        (text.replace("verts 0\n", "verts 0\n7\n"), "rows and its mesh"),
        ("", "no garment of MakeHuman's"),
    )
    for told, words in cases:
        vest.write_text(told)
        with pytest.raises(ClonerError, match=words):
            read_mhclo(vest)


def test_without_a_picture_it_is_grey(tmp_path: Path, eva: Clone) -> None:
    garment = read_mhclo(written(tmp_path, material="none.mhmat"))
    assert garment.rgba[0, 0, 3] == 255
    assert len(set(garment.rgba[..., :3].reshape(-1, 3).max(axis=0).tolist())) <= 2
    assert fitted_shell(replace(eva), garment).kind == "cloth"
