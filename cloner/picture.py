"""Pictures of a finished clone from its file, still or turning."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from PIL.PngImagePlugin import PngInfo

from cloner.errors import ClonerError
from cloner.geometry.cameras.viewpoints import framing_cameras
from cloner.project.atomic import atomic_file, safe_output
from cloner.project.clone_file import CLONE_FILE, load_clone
from cloner.records.clones import Clone
from cloner.render import clone_layers, draw, render, standard_camera
from cloner.vision.photographs.films import FORMATS, write_film

LARGEST_PX: Final = 4096  # the renderer draws at twice this size
TURNTABLE: Final = "turntable"
TURN_FRAMES: Final = 72  # taste: 5 degrees a picture
TURN_SECONDS: Final = 6.0  # taste
#: Grey behind people (taste).
_BACKDROP: Final = (226, 228, 230)

Pixels = NDArray[np.uint8]


def draw_file(clone_path: Path, view: str, out: Path, size: str = "800x1200") -> None:
    """Draw a clone as the named view sees it into a PNG file, or turning into a film.

    Parameters
    ----------
    clone_path : Path
        ``clone.npz`` or the folder that holds it.
    view : str
        As :func:`cloner.render.standard_camera` knows it, or "turntable".
    out : Path
        A turntable's suffix says the format: .gif, .webp or .mp4.
    size : str
        "WIDTHxHEIGHT" in pixels.

    Raises
    ------
    ClonerError
        If there is no clone, the view, size or film's format is unknown, or ``out`` exists or cannot be written.
    """
    width, height = _size(size)
    if view == TURNTABLE and out.suffix.lower() not in FORMATS:
        raise ClonerError("a turntable is a film", f"Give --out one of {', '.join(FORMATS)}", out.name)
    safe_output(out)
    clone = load_clone_at(clone_path)
    with atomic_file(out) as temporary:
        if view == TURNTABLE:
            write_film(turntable(clone, width, height), TURN_FRAMES / TURN_SECONDS, temporary)
        else:
            text = PngInfo()
            text.add_text("Software", clone.stamp)  # as every other output: what made it, and of which photos
            Image.fromarray(_still(clone, view, width, height)).save(temporary, format="PNG", pnginfo=text)


def load_clone_at(path: Path) -> Clone:
    """Return the clone in ``clone.npz`` or in the folder that holds it.

    Raises
    ------
    ClonerError
        If there is none.
    """
    return load_clone(clone_file(path))


def clone_file(path: Path) -> Path:
    """Return the ``clone.npz`` in a result's folder, or the file itself.

    Raises
    ------
    ClonerError
        If there is none.
    """
    file = path / CLONE_FILE if path.is_dir() else path
    if not file.is_file():
        raise ClonerError("there is no clone", "Give a result's folder or its clone.npz", path.name)
    return file


def folder_name(path: Path) -> str:
    """Return the name of the folder of a clone, given as that folder or as its ``clone.npz``."""
    return (path if path.is_dir() else path.parent).resolve().name


def _still(clone: Clone, view: str, width_px: int, height_px: int) -> Pixels:
    try:
        camera = standard_camera(clone, view, width_px, height_px)
    except ValueError as error:
        raise ClonerError(f"{error}, {TURNTABLE}", "Choose one of those", "--view") from error
    return render(clone, camera, shading="soft")


def turntable(clone: Clone, width_px: int, height_px: int, frames: int = TURN_FRAMES) -> Iterator[Pixels]:
    """Yield the pictures (height_px, width_px, 3) of the clone turning once about the vertical, from the front on."""
    layers = clone_layers(clone)
    points = np.vstack([layer.vertices_m for layer in layers])
    for camera in framing_cameras(
        points, np.linspace(0.0, 360.0, frames, endpoint=False).tolist(), width_px, height_px
    ):
        yield draw(layers, camera, shading="soft", background=_BACKDROP)


def _size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"(\d+)[x×](\d+)", text.strip().lower())
    width, height = (int(part) for part in match.groups()) if match else (0, 0)
    if not (16 <= width <= LARGEST_PX and 16 <= height <= LARGEST_PX):
        message = f"{text!r} is no size from 16x16 to {LARGEST_PX}x{LARGEST_PX}"
        raise ClonerError(message, "Write it like 800x1200", "--size")
    return width, height
