"""Whoever is forgotten is gone, or what stays is named: under other names, in links, packs, copies and rests."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import zipfile
from dataclasses import replace
from pathlib import Path

import pytest
from PIL import Image

from cloner.errors import ClonerError
from cloner.exporters.gltf import gltf
from cloner.personal_data.holdings import find_holding, holdings, table
from cloner.personal_data.privacy import export_data, forget
from cloner.project.atomic import recover, result_folder
from cloner.project.claims import claim
from cloner.project.manifest import find_visitors
from cloner.project.results import file_digest, place_digest
from cloner.project.stamps import output_digests, photos_token
from kit.clones import toy_clone


def photo(path: Path, shade: int) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    Image.new("RGB", (80, 120), (shade, 7, 9)).save(path)
    return path


def cloned(photos: Path, out: Path, identifier: str) -> Path:
    """Leave a result as cloning does."""
    digests = {path.stem: file_digest(path) for path in sorted(photos.glob("*.jpg"))}
    with result_folder(out, identifier, photos) as folder:
        (folder / "clone.npz").write_bytes(f"clone of {identifier}".encode())
        (folder / "report.html").write_text(f"<h1>{identifier}</h1>")
        told = {"format": 3, "stamp": {"photos": digests}, "source": place_digest(photos)}
        told["outputs"] = output_digests(folder, ["clone.npz", "report.html"])
        (folder / "report.json").write_text(json.dumps(told))
    return out / identifier


@pytest.fixture
def places(tmp_path: Path) -> tuple[Path, Path]:
    root, out = tmp_path / "photos", tmp_path / "out"
    for number, name in enumerate(("anna", "boris")):
        photo(root / name / "body_front.jpg", number)
        cloned(root / name, out, name)
    return root, out


def forgotten(name: str, places: tuple[Path, Path]) -> tuple[str, ...]:
    return forget(find_holding(name, holdings(*places)), *places)


def test_a_clone_of_another_name_takes_its_photos_along(places: tuple[Path, Path]) -> None:
    root, out = places
    shutil.rmtree(out / "anna")
    cloned(root / "anna", out, "visitor-17")
    (one,) = [one for one in holdings(root, out) if "visitor-17" in one.names]
    assert (one.identifier, one.photos, one.results) == ("anna", (root / "anna",), (out / "visitor-17",))
    assert forgotten("visitor-17", places) == ()
    assert not (root / "anna").exists()
    assert not (out / "visitor-17").exists()
    assert (root / "boris").exists()
    assert (out / "boris").exists()


def test_a_folder_used_for_one_visitor_after_the_other_belongs_to_the_last(tmp_path: Path) -> None:
    root, out = tmp_path / "photos", tmp_path / "out"
    photo(root / "current" / "body_front.jpg", 1)
    cloned(root / "current", out, "anna")
    photo(root / "current" / "body_front.jpg", 2)
    cloned(root / "current", out, "boris")
    forgotten("anna", (root, out))
    assert (root / "current" / "body_front.jpg").is_file()
    assert (out / "boris").is_dir()
    assert not (out / "anna").exists()


def killed(out: Path, identifier: str) -> None:
    code = "import os, signal, sys; from pathlib import Path; from cloner.project.atomic import result_folder\n"
    code += "from cloner.project.claims import claim\nout, name = Path(sys.argv[1]), sys.argv[2]\n"
    code += "with claim(out, name), result_folder(out, name) as inside:\n"
    code += "    (inside / 'face.jpg').write_text('x'); os.kill(os.getpid(), signal.SIGKILL)"
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run([sys.executable, "-c", code, str(out), identifier], env=environment, check=False)
    assert done.returncode == -signal.SIGKILL


def test_what_a_killed_run_left_is_listed_and_forgotten(places: tuple[Path, Path]) -> None:
    root, out = places
    killed(out, "zoe")
    killed(out, "anna")
    assert "zoe" in table(holdings(root, out))
    assert forgotten("zoe", places) == ()
    assert forgotten("anna", places) == ()
    assert not [path.name for path in out.iterdir() if "zoe" in path.name or "anna" in path.name]


def test_rests_of_others_are_swept_and_running_ones_never(places: tuple[Path, Path]) -> None:
    out = places[1]
    killed(out, "zoe")
    with claim(out, "carl"), result_folder(out, "carl") as inside:
        (inside / "report.json").write_text("{}")
        assert not [path for path in out.iterdir() if path.name.startswith(".zoe.partial")], "the next run sweeps"
        assert recover(out) == ()
        assert inside.is_dir()
    assert (out / "carl").is_dir()


def test_a_folder_that_only_looks_like_a_rest_is_left(places: tuple[Path, Path]) -> None:
    out = places[1]
    mine = photo(out / ".anna.partial-1-holiday" / "beach.jpg", 3)
    recover(out)
    assert mine.is_file()


def test_a_linked_result_is_no_result(places: tuple[Path, Path], tmp_path: Path) -> None:
    root, out = places
    secret = tmp_path / "elsewhere"
    cloned(root / "boris", secret, "zoe")
    (out / "zoe").symlink_to(secret / "zoe")
    assert "zoe" not in {one.identifier for one in holdings(root, out)}
    shutil.rmtree(out / "anna")
    (out / "anna").symlink_to(secret / "zoe")
    path = export_data(find_holding("anna", holdings(root, out)), tmp_path / "anna.zip")
    assert zipfile.ZipFile(path).namelist() == ["anna/photos/body_front.jpg"]
    forgotten("boris", places)
    assert (secret / "zoe" / "clone.npz").is_file()
    assert not (root / "boris").exists()


def test_logs_that_are_links_or_pipes_are_left_alone(places: tuple[Path, Path], tmp_path: Path) -> None:
    root = places[0]
    outside = tmp_path / "system.log"
    outside.write_text("INFO anna: 3 s\n")
    (root / "a.log").symlink_to(outside)
    os.mkfifo(root / "b.log")
    (root / "c.log").write_text("INFO anna: 3 s\nINFO boris: 4 s\n")
    assert forgotten("anna", places) == ("a.log",), "a link to a text that tells is named"
    assert outside.read_text() == "INFO anna: 3 s\n"
    assert (root / "c.log").read_text() == "INFO boris: 4 s\n"
    assert not (root / "anna").exists()


def test_two_folders_of_one_identifier_are_both_shown(tmp_path: Path) -> None:
    root, out = tmp_path / "photos", tmp_path / "out"
    photo(root / "a b" / "body_front.jpg", 1)
    photo(root / "a-b" / "body_front.jpg", 2)
    cloned(root / "a b", out, "a-b")
    held = holdings(root, out)
    assert [one.identifier for one in held] == ["a b", "a-b"]
    assert [one.results for one in held] == [(out / "a-b",), ()]
    with pytest.raises(ClonerError, match="both be called a-b"):
        find_visitors(root)
    with pytest.raises(ClonerError, match="another visitor"):
        cloned(root / "a-b", out, "a-b")
    forgotten("a b", (root, out))
    assert (root / "a-b" / "body_front.jpg").is_file()


def test_a_result_with_somebodys_own_files_is_deleted_but_for_those(places: tuple[Path, Path]) -> None:
    out = places[1]
    (out / "anna" / "thesis.odt").write_text("precious")
    assert forgotten("anna", places) == ("anna/thesis.odt (no part of a result)",)
    assert [path.name for path in (out / "anna").iterdir()] == ["thesis.odt"]


def test_the_root_itself_may_be_a_visitors_folder(tmp_path: Path) -> None:
    root = tmp_path / "anna"
    photo(root / "body_front.jpg", 1)
    cloned(root, root / "out", "anna")
    photo(tmp_path / "boris" / "body_front.jpg", 2)
    cloned(tmp_path / "boris", root / "out", "boris")
    assert forgotten("anna", (root, root / "out")) == ()
    assert not (root / "body_front.jpg").exists()
    assert (root / "out" / "boris" / "clone.npz").is_file()


def copies(root: Path, out: Path, token: str) -> dict[str, str]:
    """Put traces of anna everywhere and return the files that must be named, each with its reason."""
    picture, result = root / "anna" / "body_front.jpg", out / "anna"
    (out / "best").mkdir()
    shutil.copy(picture, out / "best" / "renamed.bin")
    shutil.copy(picture, root / "deep.jpg")
    hidden, deep = out / ".cache" / "x", root / "1" / "2" / "3" / "4" / "5"
    for folder in (hidden, deep):
        folder.mkdir(parents=True)
        shutil.copy(picture, folder / "body_front.jpg")
    shutil.copy(result / "clone.npz", out / "best" / "copied.npz")
    shutil.copy(result / "report.html", out / "best" / "page")
    (written,) = gltf.export(replace(toy_clone(hair=False), stamp=f"Cloner, photos {token}"), out / "best")
    written.rename(out / "best" / "walk.glb")
    with zipfile.ZipFile(out / "best" / "pack.zip", "w", zipfile.ZIP_DEFLATED) as pack:
        pack.write(picture, "1.jpg")
    with zipfile.ZipFile(out / "best" / "pack2.zip", "w", zipfile.ZIP_DEFLATED) as pack:
        pack.write(out / "best" / "walk.glb", "w.glb")
    (out / "anna_turning.gif").write_bytes(b"GIF")
    (out / "note.json").write_text(json.dumps({"who": "Ann\u00e9 O'Neil"}))
    (out / "note.html").write_text("<p>Ann\u00e9 O&#x27;Neil</p>")
    (out / "link").symlink_to(elsewhere := root.parent / "elsewhere")
    elsewhere.mkdir()
    shutil.copy(picture, elsewhere / "7.jpg")
    return {
        "best/renamed.bin": "a renamed photo", "deep.jpg": "a photo of no view", ".cache/x/body_front.jpg": "hidden",
        "1/2/3/4/5/body_front.jpg": "deeper than visitors are sought", "best/copied.npz": "a copied clone",
        "best/page": "a copied page", "best/walk.glb": "made of the clone", "best/pack.zip": "a pack of photos",
        "best/pack2.zip": "a pack of what was made", "anna_turning.gif": "called after her",
        "note.json": "her name, escaped for JSON", "note.html": "her name, escaped for HTML", "link/7.jpg": "linked",
    }  # fmt: skip


def test_every_copy_is_named(places: tuple[Path, Path]) -> None:
    root, out = places
    (root / "anna" / "person.toml").write_text('name = "Ann\u00e9 O\'Neil"\nheight_cm = 170\n', encoding="utf-8")
    (root / "boris" / "person.toml").write_text("height_cm = 170\n")
    token = photos_token([file_digest(root / "anna" / "body_front.jpg")])
    wanted = copies(root, out, token)
    told = forgotten("anna", places)
    missed = {file: why for file, why in wanted.items() if file not in told}
    assert not missed
    assert set(told) == set(wanted), "nobody else is named"
    assert (out / "boris" / "clone.npz").is_file()


def test_what_cannot_be_deleted_is_named_and_ends_with_one(places: tuple[Path, Path]) -> None:
    root, out = places
    root.chmod(0o500)  # nothing can be renamed or deleted in it
    no_privileges = ["setpriv", "--bounding-set=-all", "--inh-caps=-all"] if os.getuid() == 0 else []
    code = "from cloner.cli import main; main()"
    done = subprocess.run(
        [*no_privileges, sys.executable, "-c", code, "forget", "anna", "--photos", str(root), "--out", str(out)],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    root.chmod(0o700)
    assert done.returncode == 1, done.stderr
    assert "anna (cannot be deleted: Permission denied)" in done.stderr
    assert "anna: not all is gone" in done.stdout
    assert not (out / "anna").exists(), "what can be deleted is"
