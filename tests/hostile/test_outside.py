"""Files of others: pipes are not waited for, promises not believed, damage is told, nothing is overwritten."""

from __future__ import annotations

import contextlib
import io
import json
import os
import struct
import subprocess
import sys
import zipfile
import zlib
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image, features

from cloner import animating, cloning, picture
from cloner.cloning import clone_folder, stamp_options
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project.clone_file import load_clone, save_clone
from cloner.project.results import file_digest
from cloner.project.stamps import input_stamp, why_not_current
from cloner.untrusted import UnsuitableFile, read_untrusted
from cloner.vision.photographs.pictures import read_picture
from hostile.cases_photos import JPEG
from kit.clones import toy_clone
from stages.test_head import fit, photographed, true_person


def test_only_ordinary_files_of_a_known_size_are_read(tmp_path: Path) -> None:
    (tmp_path / "ten").write_bytes(bytes(10))
    os.mkfifo(tmp_path / "pipe")
    assert read_untrusted(tmp_path / "ten", 10) == bytes(10)
    with pytest.raises(UnsuitableFile, match="larger"):
        read_untrusted(tmp_path / "ten", 9)
    for path in (tmp_path / "pipe", tmp_path, Path("/dev/zero"), Path("/dev/null")):
        with pytest.raises(UnsuitableFile, match="ordinary"):
            read_untrusted(path, 10)
    with pytest.raises(UnsuitableFile, match="called"):
        read_untrusted(Path("a\0b"), 10)


@pytest.mark.parametrize("suffix", [".bvh", ".amc", ".wav", ".txt", ".fap", ".toml"])
@pytest.mark.parametrize("kind", ["pipe", "device", "folder"])
def test_animate_waits_for_no_pipe_and_reads_no_device(tmp_path: Path, suffix: str, kind: str) -> None:
    save_clone(toy_clone(), tmp_path / "clone.npz")
    source = tmp_path / f"walk{suffix}"
    (tmp_path / "walk.asf").write_text("")
    if kind == "pipe":
        os.mkfifo(source)
    elif kind == "device":
        source.symlink_to("/dev/zero")
    else:
        source.mkdir()
    with pytest.raises(ClonerError, match=r"cannot be read|no ordinary file"):
        animating.animate_file(tmp_path / "clone.npz", [source], tmp_path / "out.glb")
    if kind != "folder":
        (tmp_path / "clone.npz").unlink()
        source.rename(tmp_path / "clone.npz")
        with pytest.raises(ClonerError):
            picture.load_clone_at(tmp_path / "clone.npz")


def png_of_zeros(width: int, height: int) -> bytes:
    """Return a small PNG that promises a large picture."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head_bytes = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    parts = ((b"IHDR", head_bytes), (b"IDAT", zlib.compress(bytes(100))), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunk(*part) for part in parts)


def test_a_clone_of_many_large_pictures_is_refused_before_one_is_decoded(tmp_path: Path) -> None:
    path = tmp_path / "clone.npz"
    save_clone(toy_clone(), path)
    with np.load(path) as archive:
        arrays = {name: archive[name] for name in archive.files}
    bomb = np.frombuffer(png_of_zeros(8192, 8192), dtype=np.uint8)
    shell = {name: array for name, array in arrays.items() if name.startswith("shell_0_")}
    for number in range(60):
        arrays |= {name.replace("shell_0_", f"shell_{number}_"): array for name, array in shell.items()}
        arrays[f"shell_{number}_rgba_png"] = bomb
    facts = json.loads(arrays["facts_json"].tobytes()) | {"shells": 60, "shell_kinds": ["hair"] * 60}
    arrays["facts_json"] = np.frombuffer(json.dumps(facts).encode(), dtype=np.uint8)
    np.savez(path, **arrays)
    code = "import resource, sys; from pathlib import Path; from cloner.project.clone_file import load_clone\n"
    code += "from cloner.errors import ClonerError\n"
    code += "before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\n"
    code += "try:\n    load_clone(Path(sys.argv[1]))\nexcept ClonerError as error:\n    print(error)\n"
    code += "print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)"
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run([sys.executable, "-c", code, str(path)], env=environment, capture_output=True, text=True,
                          check=True)  # fmt: skip
    told, grown_kib = done.stdout.strip().splitlines()
    assert "not a readable clone" in told
    assert int(grown_kib) < 150_000


def test_an_archive_that_unpacks_to_more_than_any_clone_is_refused(tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "clone.npz", "w", zipfile.ZIP_DEFLATED) as archive:
        for number in range(30):
            stream = io.BytesIO()
            np.save(stream, np.zeros(10_000_000, np.uint8))
            archive.writestr(f"a{number}.npy", stream.getvalue())
    assert (tmp_path / "clone.npz").stat().st_size < 1_000_000
    with pytest.raises(ClonerError, match="not a readable clone"):
        load_clone(tmp_path / "clone.npz")


CUT_HEADER = "{'descr': '|u1', 'fortran_order': False, 'shape': (1,"


@pytest.mark.parametrize("header", [CUT_HEADER, "'''", "((((", "\\\n x", "1" * 5000])
def test_broken_headers_of_arrays_have_a_sentence(tmp_path: Path, header: str) -> None:
    text = header.encode()
    array = b"\x93NUMPY\x01\x00" + struct.pack("<H", len(text)) + text + b"\x00"
    with zipfile.ZipFile(tmp_path / "clone.npz", "w") as archive:
        archive.writestr("facts_json.npy", array)
    with pytest.raises(ClonerError, match="not a readable clone"):
        load_clone(tmp_path / "clone.npz")


def noise(kind: str, **options: Any) -> bytes:
    pixels = np.random.default_rng(1).integers(0, 255, (120, 90, 3), dtype=np.uint8)
    stream = io.BytesIO()
    Image.fromarray(pixels).save(stream, kind, **options)
    return stream.getvalue()


@pytest.mark.parametrize("kind", ["AVIF", "PNG", "WEBP", "TIFF", "JPEG"])
def test_damaged_photos_have_a_sentence_or_are_read(tmp_path: Path, kind: str) -> None:
    if kind == "AVIF" and not features.check("avif"):
        pytest.skip("this pillow has no AVIF")
    whole, path = noise(kind), tmp_path / "body_front.jpg"
    rng = np.random.default_rng(2)
    for _ in range(150):
        data = bytearray(whole)
        for at in rng.integers(0, len(data), rng.integers(1, 12)):
            data[at] = rng.integers(0, 256)
        path.write_bytes(data[: rng.integers(len(data) // 2, len(data) + 1)])
        with contextlib.suppress(ClonerError):
            read_picture(path)


@pytest.mark.parametrize("level", [0, 6])
def test_a_png_with_damaged_rows_is_never_taken(tmp_path: Path, level: int) -> None:
    data = bytearray(noise("PNG", compress_level=level))
    at = data.index(b"IDAT") + len(data) // 2
    data[at : at + 2000] = bytes(2000)
    (tmp_path / "body_front.png").write_bytes(data)
    with pytest.raises(ClonerError, match="damaged"):
        read_picture(tmp_path / "body_front.png")


@pytest.mark.parametrize("name", ["photo.jpg", "clone.npz", "link.glb"])
def test_neither_render_nor_animate_overwrites_anything(tmp_path: Path, name: str) -> None:
    save_clone(toy_clone(), tmp_path / "clone.npz")
    (tmp_path / "photo.jpg").write_bytes(JPEG)
    (tmp_path / "link.glb").symlink_to("photo.jpg")
    (tmp_path / "hello.txt").write_text("AA1 0.2\n")
    (tmp_path / "o_hello.fap").write_text("precious")
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    with pytest.raises(ClonerError, match="exists"):
        picture.draw_file(tmp_path / "clone.npz", "front", tmp_path / name, "64x64")
    for out in ("link.glb", "o.glb"):
        with pytest.raises(ClonerError, match="exists"):
            animating.animate_file(tmp_path / "clone.npz", [tmp_path / "hello.txt"], tmp_path / out)
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


def test_the_stamp_tells_of_the_photo_that_was_decoded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A photo replaced while its clone is made: the result is not current, and is made again."""
    photo = tmp_path / "anna" / "body_front.png"
    photo.parent.mkdir()
    Image.new("RGB", (80, 120), (1, 2, 3)).save(photo)
    first = file_digest(photo)

    def replaced_meanwhile(*_: Any, **__: Any) -> tuple[dict[str, Any], list[Any]]:
        Image.new("RGB", (80, 120), (9, 9, 9)).save(photo)
        return {"clone": toy_clone(), "agreements": {}}, []

    monkeypatch.setattr(cloning, "clone_photos", replaced_meanwhile)
    monkeypatch.setattr(cloning, "_write_clone", lambda values, formats, folder, progress: None)
    monkeypatch.setattr(cloning, "build_report", lambda *_: {"warnings": []})
    monkeypatch.setattr(cloning, "write_page", lambda *_: None)
    outcome = clone_folder(photo.parent, tmp_path / "out")
    assert outcome.report["stamp"]["photos"] == {"body_front": first}
    told = input_stamp(photo.parent, stamp_options())
    assert why_not_current(outcome.folder, told) == "photos changed since"


def test_a_file_beside_the_photos_that_changes_while_it_is_read_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "body_front.jpg").write_bytes(JPEG)
    (tmp_path / "person.toml").write_text("height_cm = 170\n")
    read = cloning.read_consent

    def changed(folder: Path) -> str:
        (tmp_path / "person.toml").write_text("height_cm = 180\n")
        return read(folder)

    monkeypatch.setattr(cloning, "read_consent", changed)
    with pytest.raises(ClonerError, match="changed while"):
        clone_folder(tmp_path, tmp_path / "out")


@pytest.mark.slow
@pytest.mark.parametrize("doubtful", ["nose_tip", "glabella", "chin_front", "all but four"])
def test_a_face_side_photo_needs_no_point(doubtful: str) -> None:
    """A surveillance frame showed no nose tip; the head fit looked for it all the same."""
    photos, proposals, points = photographed(true_person(1))
    side = points.views[ViewId.FACE_SIDE]
    keep = ("subnasale", "lip_top", "stomion", "chin_front")
    gone = [name not in keep if doubtful == "all but four" else name == doubtful for name in side.names]
    confidence = np.where(gone, 0.01, side.confidence)
    points = replace(points, views={**points.views, ViewId.FACE_SIDE: replace(side, confidence=confidence)})
    fitted = fit(photos, proposals, points).values["head"]
    assert np.isfinite(fitted.vertices_m).all()
