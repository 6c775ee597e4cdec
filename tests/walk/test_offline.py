"""The whole product on a machine without a network: nothing is sought, nothing private comes out, bytes repeat."""

from __future__ import annotations

import json
import shutil
import stat
from dataclasses import dataclass
from pathlib import Path

import pytest
from PIL import ExifTags, Image, PngImagePlugin

from kit.offline import namespace, run_apart

pytestmark = pytest.mark.slow

CLI = "from cloner.cli import main; main()"
WINDOW = """
import sys
from pathlib import Path
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
app = QApplication(sys.argv[:1])
QTimer.singleShot(3000, app.closeAllWindows)
from cloner_gui.app import run_app
sys.exit(run_app(Path(sys.argv[1])))
"""
NAME = "Zacharias Geheimnis"
SECRETS = (b"SERIAL-4711", b"SECRETPLACE", b"Secret Photographer", b"HIDDEN-COMMENT", NAME.encode())


@dataclass(frozen=True)
class Walk:
    """What the walk left: its folders, what was said, and what was heard of a network."""

    root: Path
    said: dict[str, str]
    heard: str

    @property
    def single(self) -> Path:
        return self.root / "single" / "tagged"


def tagged_photo(source: Path, path: Path) -> None:
    """Save a small copy of a photo with place, serial numbers, author, comment and thumbnail."""
    exif = Image.Exif()
    exif[ExifTags.Base.Make], exif[ExifTags.Base.Artist] = "Camera", "Secret Photographer"
    exif[ExifTags.Base.FocalLengthIn35mmFilm] = 50
    inner = exif.get_ifd(ExifTags.IFD.Exif)
    inner[ExifTags.Base.BodySerialNumber] = inner[ExifTags.Base.LensSerialNumber] = "SERIAL-4711"
    gps = exif.get_ifd(ExifTags.IFD.GPSInfo)
    gps[ExifTags.GPS.GPSLatitude], gps[ExifTags.GPS.GPSLatitudeRef] = (48.0, 12.0, 30.0), "N"
    gps[ExifTags.GPS.GPSMapDatum] = "SECRETPLACE"
    with Image.open(source) as image:
        image.resize((600, 900)).save(path, exif=exif, comment=b"HIDDEN-COMMENT", xmp=b"<x>SERIAL-4711</x>", quality=92)
    assert all(secret in path.read_bytes() for secret in SECRETS[:4]), "the photo is not tagged: the test shows nothing"


@pytest.fixture(scope="module")
def walk(tmp_path_factory: pytest.TempPathFactory, samples: Path) -> Walk:
    root = tmp_path_factory.mktemp("offline")
    heard, photos = root / "heard.txt", root / "photos" / "tagged"
    photos.mkdir(parents=True)
    tagged_photo(samples / "anna" / "plain" / "body_front.jpg", photos / "body_front.jpg")
    (photos / "person.toml").write_text(f'name = "{NAME}"\nheight_cm = 158\nconsent = "cloning, 2026-11-21"\n')
    (root / "photos" / "broken").mkdir()
    (root / "photos" / "broken" / "body_front.jpg").write_bytes(b"")
    (root / "mama.txt").write_text("M 0.1\nAA1 0.2\n")
    options = ("--size", 512, "--format", "glb,wrl,x3d,obj")
    single, batch, clone = root / "single", root / "batch", root / "single" / "tagged"
    steps = {
        "clone": ("--verbose", "clone", photos, "--out", single, *options),
        "batch": ("--verbose", "batch", root / "photos", "--out", batch, "--workers", 2, *options),
        "render": ("render", clone, "--out", root / "front.png", "--size", "120x180"),
        "animate": ("animate", clone, root / "mama.txt", "--out", root / "talk.glb"),
        "list": ("list", "--photos", root / "photos", "--out", single),
        "doctor": ("doctor",),
    }
    said = {}
    for name, arguments in steps.items():
        done = run_apart(CLI, *arguments, heard=heard)
        assert done.returncode == (name == "batch"), f"{name}: {done.stderr[-2000:]}"  # one of the batch is broken
        said[name] = done.stderr
    visitor = root / "event" / "tagged"
    shutil.copytree(photos, visitor)
    done = run_apart(WINDOW, visitor, heard=heard)
    assert done.returncode == 0, done.stderr[-2000:]
    return Walk(root, said, heard.read_text() if heard.exists() else "")


def test_nobody_seeks_a_network(walk: Walk) -> None:
    assert walk.heard == ""
    if not namespace():
        pytest.skip("this machine allows no namespace without a network: only Python's own sockets were watched")


def test_the_guard_hears(tmp_path: Path) -> None:
    code = "import socket; s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM); s.connect(('192.0.2.1', 9))"
    done = run_apart(code, heard=tmp_path / "heard.txt")
    assert "192.0.2.1" in (tmp_path / "heard.txt").read_text()
    if namespace():
        assert "Network is unreachable" in done.stderr


def test_no_place_serial_or_author_reaches_the_outputs(walk: Walk) -> None:
    for path in (
        *walk.single.rglob("*"),
        *(walk.root / "batch").rglob("*"),
        walk.root / "front.png",
        walk.root / "talk.glb",
    ):
        if path.is_file():
            content = path.read_bytes()
            for secret in SECRETS[:4]:
                assert secret not in content, path
            if path.suffix in (".jpg", ".png"):
                with Image.open(path) as image:
                    assert not image.getexif(), path
                    assert isinstance(image, PngImagePlugin.PngImageFile) or "comment" not in image.info, path


def test_the_name_is_in_report_and_clone_alone_and_never_in_the_log(walk: Walk) -> None:
    told = {path.name for path in walk.single.rglob("*") if path.is_file() and NAME.encode() in path.read_bytes()}
    assert told == {"clone.npz", "report.json", "report.html", "viewer.html"}, "the clone names whom a VRM is of"
    for name, text in walk.said.items():
        assert NAME not in text, name
        assert str(walk.root) not in text, f"{name} tells where the folders lie"
    assert "tagged: " in walk.said["clone"], "the log names visitors by identifier"


def test_what_is_written_is_the_owners_alone(walk: Walk) -> None:
    written = [walk.root / "single", walk.root / "batch", walk.root / "front.png", walk.root / "talk.glb"]
    for path in [inner for top in written for inner in (top, *top.rglob("*"))]:
        assert stat.S_IMODE(path.stat().st_mode) == (0o700 if path.is_dir() else 0o600), path


def test_one_process_and_two_workers_give_the_same_bytes(walk: Walk) -> None:
    again = walk.root / "batch" / "tagged"
    files = sorted(path.relative_to(walk.single) for path in walk.single.rglob("*") if path.is_file())
    assert len(files) > 10
    for file in files:
        if not file.name.startswith("report."):  # they hold times
            assert (walk.single / file).read_bytes() == (again / file).read_bytes(), file
    rows = json.loads((walk.root / "batch" / "batch.json").read_text())["rows"]
    assert [(row["identifier"], row["status"]) for row in rows] == [("broken", "failed"), ("tagged", "cloned")]
