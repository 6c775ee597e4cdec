"""Other people's programs: each opens a file of ours and gives a picture of what it shows."""

from __future__ import annotations

import base64
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from kit.browser import CHROMIUM, browser

HERE = Path(__file__).parent
MODULES = Path(os.environ.get("CLONER_NODE_MODULES", "/tmp/cloner-node"))
NODE = MODULES / "node_modules"
X_ITE = NODE / "x_ite" / "dist"
SIZE = (420, 640)
#: How far into its second the walk is, seconds.
AT_S = 0.1

#: The decoder of packed files that three.js ships, for node alone.
HAS_DECODER = shutil.which("node") is not None and (NODE / "three").is_dir()
HAS_THREE = CHROMIUM is not None and all((NODE / name).is_dir() for name in ("three", "@pixiv/three-vrm", "esbuild"))
HAS_X_ITE = CHROMIUM is not None and X_ITE.is_dir()
#: A Python that has Blender as a module (bpy from the package index), in stead of the program.
BLENDER_PYTHON = os.environ.get("CLONER_BLENDER_PYTHON", "")
HAS_BLENDER = bool(BLENDER_PYTHON) or shutil.which("blender") is not None
GODOT = shutil.which("godot3-server")
HAS_ASSIMP = shutil.which("assimp") is not None
#: A Python that has readers which the product does not need: assimp-py and open3d from the package index.
FOREIGN_PYTHON = os.environ.get("CLONER_READERS_PYTHON", sys.executable)
HAS_VIEW3DSCENE = shutil.which("view3dscene") is not None and shutil.which("xvfb-run") is not None

#: The background of our own worlds, sRGB: there it is the file's, before it the program's.
SKY = np.array([224, 227, 230])
#: A screen in memory, and an end for programs that hang there.
SCREEN = ("timeout", "120", "xvfb-run", "-a", "-s", "-screen 0 1024x1024x24")

Picture = tuple[np.ndarray, dict[str, Any]]


def three(path: Path) -> Picture:
    """Show a .glb, .vrm or flat .wrl with three.js in Chromium."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        entry, script = MODULES / f"show_three_{os.getpid()}.mjs", Path(scratch) / "show.js"
        shutil.copy(HERE / "show_three.mjs", entry)
        try:
            subprocess.run(
                [NODE / ".bin" / "esbuild", entry, "--bundle", "--format=esm", f"--outfile={script}",
                 "--log-level=error"], check=True,
            )  # fmt: skip
        finally:
            entry.unlink()
        page_file = path.with_name(f"{path.stem}_three.html")
        asked = f'{{kind: "{path.suffix[1:]}", at: {AT_S}, pictures: "{path.parent.as_uri()}/"}}'
        page_file.write_text(
            '<!doctype html><meta charset="utf-8"><style>body{margin:0}canvas{display:block}</style><body>'
            f'<script type="text/plain" id="file">{base64.b64encode(path.read_bytes()).decode()}</script>'
            f'<script>window.asked = {asked}</script><script type="module">{script.read_text()}</script></body>'
        )
        with browser(Path(scratch) / "profile", "--allow-file-access-from-files") as page:
            page.open(page_file, *SIZE)
            page.wait_for("window.result")
            told = page.value("window.result")
            picture = page.picture()
        page_file.unlink()
    return picture, told


def x_ite(path: Path) -> Picture:
    """Show a .wrl or .x3d with X_ITE in Chromium; tells how many pixels its walk changes."""
    for name in ("x_ite.min.js", "x_ite.css"):
        shutil.copy(X_ITE / name, path.parent)
    shutil.copytree(X_ITE / "assets", path.parent / "assets", dirs_exist_ok=True)
    page_file = path.with_name(f"{path.stem}_x_ite.html")
    width, height = SIZE
    page_file.write_text(
        '<!doctype html><meta charset="utf-8"><link rel="stylesheet" href="x_ite.css"><style>body{margin:0}'
        f'x3d-canvas{{width:{width}px;height:{height}px}}</style><script defer src="x_ite.min.js"></script>'
        f'<body><x3d-canvas src="{path.name}"></x3d-canvas></body>'
    )
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        with browser(Path(scratch) / "profile", "--allow-file-access-from-files") as page:
            page.open(page_file, *SIZE)
            end, first = time.monotonic() + 60, np.zeros((height, width, 3), int)
            while time.monotonic() < end and np.abs(first[2, 2] - SKY).max() > 3:
                time.sleep(0.5)
                first = page.picture().astype(int)
            time.sleep(2.0)  # pictures come after the shapes
            first = page.picture().astype(int)
            time.sleep(0.4)
            second = page.picture()
            changed = int((np.abs(first - second).max(axis=2) > 24).sum())
            told = {"changed_px": changed, "complaints": page.complaints()}
    return second, told


def blender(path: Path) -> Picture:
    """Import a file into Blender, the program or the module, and draw it with Cycles."""
    program = ["blender", "-b", "--factory-startup", "-noaudio", "-P"] if not BLENDER_PYTHON else [BLENDER_PYTHON]
    with tempfile.TemporaryDirectory() as scratch:
        out = Path(scratch) / "out.png"
        done = subprocess.run(
            [*program, HERE / "show_blender.py", "--", path, out,
             *map(str, SIZE), str(AT_S)], capture_output=True, text=True, timeout=300, check=False,
        )  # fmt: skip
        seen = re.search(r"SEEN (.*)", done.stdout)
        if seen is None or not out.is_file():
            return np.zeros((*SIZE[::-1], 3), np.uint8), {"error": (done.stderr + done.stdout)[-1500:]}
        told = {key: float(value) for key, value in (part.split("=") for part in seen[1].split())}
        return np.asarray(Image.open(out).convert("RGB")), told


def view3dscene(path: Path, at_s: float = AT_S) -> Picture:
    """Draw a file with view3dscene on a screen in memory, some seconds into its motion; tells its warnings."""
    with tempfile.TemporaryDirectory() as scratch:
        out = Path(scratch) / "out.png"
        done = subprocess.run(
            [*SCREEN, "view3dscene", "--geometry", f"{SIZE[0]}x{SIZE[1]}", "--screenshot", str(at_s), out, path],
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        told = {"warnings": [line for line in (done.stderr + done.stdout).splitlines() if "arning" in line]}
        if not out.is_file():
            return np.zeros((*SIZE[::-1], 3), np.uint8), told | {"error": done.stderr[-1500:]}
        return np.asarray(Image.open(out).convert("RGB")), told


def view3dscene_without_prototypes(path: Path, at_s: float = AT_S) -> Picture:
    """Draw a .wrl with view3dscene's own H-Anim 1.1 nodes instead of the file's prototypes.

    It visits what hangs on a prototype twice, so that every joint below a joint doubles its time: hours for a file
    whose joints are nested 27 deep.
    """
    native = path.with_stem(f"{path.stem}_native")
    native.write_text(re.sub(r"^PROTO .*?^\}$", "", path.read_text(), flags=re.M | re.S))
    return view3dscene(native, at_s)


def person(picture: np.ndarray) -> np.ndarray:
    """Return the (H, W) pixels that differ from the picture's corner."""
    return np.asarray(np.abs(picture.astype(int) - picture[2, 2].astype(int)).max(axis=2) > 24)


def assimp(path: Path) -> dict[str, float]:
    """Return what Assimp's own command tells of a file: counts of its parts and the corners of its box, metres."""
    done = subprocess.run(["assimp", "info", path], capture_output=True, text=True, timeout=120, check=False)
    text = done.stdout
    told = {key.lower(): float(value) for key, value in re.findall(r"^(\w+):\s+(\d+)$", text, flags=re.M)}
    for word in ("Minimum", "Maximum"):
        if found := re.search(rf"{word} point\s+\(([^)]*)\)", text):
            told |= {f"{word.lower()}_{axis}": float(v) for axis, v in zip("xyz", found[1].split(), strict=True)}
    return told


def foreign(program: str, path: Path) -> dict[str, Any]:
    """Return what a Python reader finds in a file (see count_foreign.py), or its complaint."""
    done = subprocess.run([FOREIGN_PYTHON, HERE / "count_foreign.py", program, path],
                          capture_output=True, text=True, timeout=120, check=False)  # fmt: skip
    seen = re.search(r"^SEEN (.*)$", done.stdout, flags=re.M)
    if seen is None:
        return {"error": (done.stderr.strip() or "no answer").splitlines()[-1]}
    return dict(json.loads(seen[1]))


def godot(path: Path) -> dict[str, Any]:
    """Return what Godot's importer makes of a .glb; its editor does not end by itself, so it is ended once it did."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        folder = Path(scratch)
        (folder / "project.godot").write_text('config_version=4\n[application]\nconfig/name="read"\n')
        shutil.copy(HERE / "count_godot.gd", folder)
        shutil.copy(path, folder)
        editor = subprocess.Popen([str(GODOT), "--path", scratch, "--editor", "--quit"],
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)  # fmt: skip
        end = time.monotonic() + 120
        while time.monotonic() < end and not list(folder.glob(".import/*.md5")) and editor.poll() is None:
            time.sleep(0.5)
        editor.terminate()
        try:
            editor.wait(10)
        except subprocess.TimeoutExpired:
            editor.kill()
        done = subprocess.run([str(GODOT), "--path", scratch, "-s", "count_godot.gd"], capture_output=True, text=True,
                              timeout=120, check=False, env={**os.environ, "ASKED": path.name})  # fmt: skip
    seen = re.search(r"^SEEN (.*)$", done.stdout, flags=re.M)
    return dict(json.loads(seen[1])) if seen else {"error": (done.stderr.strip() or "no answer").splitlines()[-1]}


def has_foreign(program: str) -> bool:
    """Return whether a Python reader can be imported there."""
    done = subprocess.run([FOREIGN_PYTHON, "-c", f"import {program}"], capture_output=True, check=False)
    return done.returncode == 0
