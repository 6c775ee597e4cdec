"""Draw a finished clone from its file."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Final

from PIL import Image

from cloner.errors import ClonerError
from cloner.project.clone_file import load_clone
from cloner.render import render, standard_camera

CLONE_FILE: Final = "clone.npz"
LARGEST_PX: Final = 4096  # the renderer draws at twice this size


def draw_file(clone_path: Path, view: str, out: Path, size: str = "800x1200") -> None:
    """Draw a clone as the named view sees it into a PNG file.

    Parameters
    ----------
    clone_path : Path
        ``clone.npz`` or the folder that holds it.
    view : str
        As :func:`cloner.render.standard_camera` knows it.
    out : Path
    size : str
        "WIDTHxHEIGHT" in pixels.

    Raises
    ------
    ClonerError
        If there is no clone, the view or size is unknown, or ``out`` cannot be written.
    """
    width, height = _size(size)
    path = clone_path / CLONE_FILE if clone_path.is_dir() else clone_path
    if not path.is_file():
        raise ClonerError("there is no clone", "Give a result's folder or its clone.npz", clone_path.name)
    clone = load_clone(path)
    try:
        camera = standard_camera(clone, view, width, height)
    except ValueError as error:
        raise ClonerError(str(error), "Choose one of those", "--view") from error
    picture = Image.fromarray(render(clone, camera, shading="soft"))
    temporary = out.with_name(f".{out.name}.partial-{os.getpid()}")
    try:
        picture.save(temporary, format="PNG")
        temporary.replace(out)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise ClonerError("the picture cannot be written", "Choose another --out file", out.name) from error


def _size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"(\d+)[x×](\d+)", text.strip().lower())
    width, height = (int(part) for part in match.groups()) if match else (0, 0)
    if not (16 <= width <= LARGEST_PX and 16 <= height <= LARGEST_PX):
        message = f"{text!r} is no size from 16x16 to {LARGEST_PX}x{LARGEST_PX}"
        raise ClonerError(message, "Write it like 800x1200", "--size")
    return width, height
