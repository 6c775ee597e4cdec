"""Contents for a visitor's phone: a picture, an interactive clone, a short film, and the GLB file."""

from __future__ import annotations

import math
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from cloner.booth.worker import Progress
from cloner.errors import ClonerError
from cloner.project.atomic import atomic_path, remove
from cloner.project.clone_file import CLONE_FILE, load_clone
from cloner.records.clones import Clone

FOLDER: Final = "phone"
SIDES: Final = 24  # pictures of a whole turn: 15 degrees each still look like turning
SIZE_PX: Final = (480, 720)  # a telephone's width at double density, and small enough for a booth's radio
#: Width and height of the parcel's large picture, px, and its grey (taste).
LARGE_PX: Final = (1080, 1620)
FILM_MS: Final = 110  # for each side: a turn in less than three seconds
_BACKGROUND: Final = (236, 238, 241)
FILES: Final = {
    "picture.jpg": "image/jpeg",
    "film.webp": "image/webp",
    "clone.glb": "model/gltf-binary",
    **{f"side_{number:02d}.jpg": "image/jpeg" for number in range(SIDES)},
}


def pack(visitor: Path, result: Path, progress: Progress) -> Path:
    """Make the files for a visitor's phone, and return their folder.

    Parameters
    ----------
    visitor, result : Path
        The visitor's folder, and that of the finished clone.
    progress : callable
        May raise Cancelled; an older parcel stays then.

    Raises
    ------
    ClonerError
        If there is no clone, or it cannot be drawn or written.
    """
    clone = load_clone(result / CLONE_FILE)
    place = visitor / FOLDER
    try:
        with atomic_path(place) as room:
            remove(room)
            room.mkdir()
            _fill(room, clone, result, progress)
            remove(place)
    except OSError as error:
        raise ClonerError("it cannot be written there", "Check the folder and its space", visitor.name) from error
    return place


def _fill(room: Path, clone: Clone, result: Path, progress: Progress) -> None:
    """Draw and write the parcel's files into a folder."""
    # drawing and scipy: the window knows the parcel's files from its start, and draws one only where a page is served
    from cloner.exporters.table import EXPORTERS
    from cloner.generic.framing import standard_camera
    from cloner.generic.layers import clone_layers
    from cloner.render import draw

    layers = clone_layers(clone, None)
    sides = []
    for number in range(SIDES):
        progress("previews", number / (SIDES + 2))
        camera = standard_camera(clone, "front", *SIZE_PX)
        turned = replace(camera, camera_from_model=camera.camera_from_model @ _turn(2.0 * math.pi * number / SIDES))
        sides.append(Image.fromarray(draw(layers, turned, background=_BACKGROUND, supersample=2)))
        sides[-1].save(room / f"side_{number:02d}.jpg", quality=82)
    sides[0].save(
        room / "film.webp", save_all=True, append_images=sides[1:], duration=FILM_MS, loop=0, quality=75, method=2
    )
    large = draw(layers, standard_camera(clone, "front", *LARGE_PX), background=_BACKGROUND, supersample=2)
    Image.fromarray(large).save(room / "picture.jpg", quality=90)
    progress("export", SIDES / (SIDES + 2))
    ready = result / "clone.glb"
    if ready.is_file():
        shutil.copyfile(ready, room / "clone.glb")
    else:
        EXPORTERS.get("glb")(clone, room)


def is_packed(visitor: Path, result: Path) -> bool:
    """Return whether these files exist and are not older than the clone."""
    last, made = visitor / FOLDER / "clone.glb", result / CLONE_FILE
    return last.is_file() and made.is_file() and last.stat().st_mtime >= made.stat().st_mtime


def _turn(angle: float) -> NDArray[np.float64]:
    """Return the rotation about the vertical axis by an angle."""
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.array([[cosine, 0, sine, 0], [0, 1, 0, 0], [-sine, 0, cosine, 0], [0, 0, 0, 1.0]])
