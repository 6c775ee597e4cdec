"""The command ``cloner scene build``: a lit room, what people do in it, and a pack of clones become one page."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from cloner.acting.written import RoomParts, bake_file
from cloner.crowd.files import packed, webp
from cloner.crowd.rooms import LIGHT_FILE, LOOKS_FILE, ROOM_FILE, SUN_FILE, Probes
from cloner.errors import ClonerError
from cloner.pipeline import Progress, quiet
from cloner.scenes import looks
from cloner.scenes.charts import charts_of
from cloner.scenes.direct import sun_way
from cloner.scenes.gltf import meshes_of
from cloner.scenes.plan import Plan
from cloner.scenes.solids import Room
from cloner.scenes.written import light_in, room_in

#: How the page's textures are kept: taste, no blocks at arm's length.
LOOK_QUALITY: Final = 88


def build_folder(
    folder: Path, walk: Path, pack: Path, out: Path, *, seconds: float, seed: int, progress: Progress = quiet
) -> list[str]:
    """Write a pack whose clones act in a lit room; return what to say of it.

    Parameters
    ----------
    folder : Path
        What ``cloner scene light`` wrote.
    walk, pack, out, seconds, seed
        As of :func:`cloner.acting.written.bake_file`.

    Raises
    ------
    ClonerError
        If the room is not lit, or what :func:`~cloner.acting.written.bake_file` refuses.
    """
    room = room_in(folder)
    parts = room_parts(room, *light_in(folder), folder.name)
    return bake_file(walk, pack, out, seconds=seconds, seed=seed, room=parts, progress=progress)


def room_parts(room: Room, light: bytes, brightest: float, probes: Probes, where: str) -> RoomParts:
    """Return a room as files of a pack; ``light`` is the map's PNG file, in which white stands for ``brightest``."""
    charts, size = charts_of(room)
    try:
        with Image.open(io.BytesIO(light), formats=["PNG"]) as image:
            if image.size != size:
                raise ValueError("another room's")
            pixels = np.asarray(image.convert("RGBA"))
    except (OSError, ValueError) as error:
        raise ClonerError("the light map is not this room's", "Make it with cloner scene light", where) from error
    meshes = meshes_of(charts, size)
    corners = [
        np.column_stack([one.places, one.uv, one.light_uv, np.full(len(one.places), k)])[one.triangles.ravel()]
        for k, one in enumerate(meshes)
    ]
    arrays: dict[str, NDArray[Any]] = {
        "corners": np.concatenate(corners).astype(np.float32), "probes": probes.light, "sun": probes.sun,
    }  # fmt: skip
    data, told = packed(arrays)
    sheet = np.concatenate([looks.texture(one.look) for one in meshes])
    sun = room.plan.sun
    facts = {
        "name": room.plan.name, "arrays": told, "low": probes.low.tolist(), "heights": probes.heights.tolist(),
        "step": probes.step, "shape": list(probes.sun.shape), "brightest": brightest,
        "sky_light": list(room.plan.sky.light), "ground": looks.albedo(room.plan.floors[-1].look).tolist(),
        "sun_way": sun_way(sun).tolist() if sun else [0.0, 1.0, 0.0],
        "sun_light": list(sun.light) if sun else [0.0] * 3,
    }  # fmt: skip
    files = {ROOM_FILE: data, LOOKS_FILE: webp(sheet, LOOK_QUALITY), LIGHT_FILE: webp(pixels[..., :3], None),
             SUN_FILE: webp(pixels[..., 3], None)}  # fmt: skip
    return RoomParts(files, facts, views_in(room.plan))


def views_in(plan: Plan) -> dict[str, list[list[float]]]:
    """Return where the eye stands and looks in the page's views: inside the largest floor, and before the door."""
    floor = max(plan.floors, key=lambda one: (one.high[0] - one.low[0]) * (one.high[1] - one.low[1]))
    (x0, y0), (x1, y1) = floor.low, floor.high
    x, wide, deep = (x0 + x1) / 2.0, x1 - x0, y1 - y0
    top = min((one.at for one in plan.ceilings), default=6.0)
    front = min(one.low[1] for one in plan.floors)
    views = {
        "overview": ((x, 0.7 * top, -y0 - 0.04 * deep), (x, 0.15 * top, -y0 - 0.55 * deep)),
        "near": ((x + 0.2 * wide, 1.65, -y0 - 0.3 * deep), (x - 0.15 * wide, 1.2, -y0 - 0.55 * deep)),
        "street": ((x + 0.2 * wide, 1.7, -front - 0.5), (x, 1.6, -y0)),
    }
    return {name: [[round(float(one), 3) for one in place] for place in pair] for name, pair in views.items()}
