"""Rooms as X3D: two textures on two sets of coordinates, and a browser of others that multiplies them."""

from __future__ import annotations

import os
import shutil
import time
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from cloner.scenes.building.charts import make_charts
from cloner.scenes.building.gltf import make_meshes
from cloner.scenes.building.reading import read_plan
from cloner.scenes.building.solids import build_room
from cloner.scenes.building.x3d import room_x3d
from kit import readers
from kit.browser import CHROMIUM, browser

X_ITE = Path(os.environ.get("CLONER_NODE_MODULES", "/tmp/cloner-node")) / "node_modules" / "x_ite" / "dist"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The museum under even light."""
    out = tmp_path_factory.mktemp("x3d")
    room = build_room(read_plan("museum")[0])
    wide, tall = make_charts(room)[1]
    Image.fromarray(np.full((tall, wide, 3), 128, np.uint8)).save(out / "light.png")
    for name, data in room_x3d(room, "light.png").items():
        (out / name).parent.mkdir(exist_ok=True)
        (out / name).write_bytes(data)
    return out


def test_every_face_has_both_coordinates(folder: Path) -> None:
    root = ET.parse(folder / "room.x3d").getroot()
    room = build_room(read_plan("museum")[0])
    meshes = {one.look: one for one in make_meshes(*make_charts(room), room.looks)}
    shapes = list(root.iter("Shape"))
    assert len(shapes) == len(meshes)
    for shape in shapes:
        pictures = [one.get("url", "").strip('"') for one in shape.iter("ImageTexture")]
        assert pictures[1] == "light.png"
        assert all((folder / one).is_file() for one in pictures)
        mesh = meshes[Path(pictures[0]).stem]
        sets = [one.get("point", "").split(",") for one in shape.iter("TextureCoordinate")]
        assert [len(one) for one in sets] == [len(mesh.places)] * 2
        light = np.array([[float(part) for part in one.split()] for one in sets[1]])
        assert light[:, 1] == pytest.approx(1.0 - mesh.light_uv[:, 1], abs=1e-4)
        faces = next(iter(shape.iter("IndexedFaceSet"))).get("coordIndex", "").split("-1")
        assert len([one for one in faces if one.strip()]) == len(mesh.triangles)


@pytest.mark.skipif(not readers.HAS_ASSIMP, reason="assimp is not here; run: sudo apt-get install -y assimp-utils")
def test_assimp_reads_it(folder: Path) -> None:
    seen = readers.assimp(folder / "room.x3d")
    assert [seen[f"{end}_x"] for end in ("minimum", "maximum")] == pytest.approx([-4.0, 16.0])
    assert [seen[f"{end}_z"] for end in ("minimum", "maximum")] == pytest.approx([-30.4, 9.0])


@pytest.mark.skipif(
    CHROMIUM is None or not X_ITE.is_dir(), reason="X_ITE or Chromium is not here; run: npm install x_ite"
)
@pytest.mark.slow
def test_x_ite_multiplies_base_and_light(folder: Path, tmp_path: Path) -> None:
    for name in ("x_ite.min.js", "x_ite.css"):
        shutil.copy(X_ITE / name, folder)
    shutil.copytree(X_ITE / "assets", folder / "assets", dirs_exist_ok=True)
    (folder / "page.html").write_text(
        '<!doctype html><meta charset="utf-8"><link rel="stylesheet" href="x_ite.css"><style>body{margin:0}'
        'x3d-canvas{width:320px;height:200px}</style><script defer src="x_ite.min.js"></script>'
        '<body><x3d-canvas src="room.x3d"></x3d-canvas></body>'
    )
    shown = {}
    for level in (128, 48):
        with Image.open(folder / "light.png") as image:
            size = image.size
        Image.new("RGB", size, (level,) * 3).save(folder / "light.png")
        with browser(tmp_path / f"profile-{level}", "--allow-file-access-from-files") as page:
            page.open(folder / "page.html", 320, 200)
            end, before, mean = time.monotonic() + 60, 255.0, 0.0
            # white while it loads, then texture after texture comes
            while time.monotonic() < end and not (15.0 < mean < 180.0 and abs(mean - before) < 0.1):
                time.sleep(2.0)
                before, mean = mean, float(page.picture()[120:].mean())
            shown[level] = mean
            assert not page.complaints()
    assert shown[48] == pytest.approx(shown[128] * 48 / 128, rel=0.12)
