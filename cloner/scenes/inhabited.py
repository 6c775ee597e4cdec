"""The command ``cloner scene build``: a lit room, a scenario and a pack of clones become one page."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from cloner.acting.written import RoomParts, bake_file, thing_names
from cloner.behaviour.trajectories import Trajectories
from cloner.crowd.packs.files import encode_webp, pack_arrays
from cloner.crowd.packs.reading import read_facts, read_stock
from cloner.crowd.staged.footing import Acted
from cloner.crowd.staged.rooms import ECHO_FILE, LIGHT_FILE, LOOKS_FILE, ROOM_FILE, SUN_FILE, Probes
from cloner.errors import ClonerError
from cloner.pipeline import Progress, no_progress
from cloner.scenes.building.charts import make_charts
from cloner.scenes.building.gltf import make_meshes
from cloner.scenes.building.looks import texture_sheet
from cloner.scenes.building.pieces import block_quads
from cloner.scenes.building.plan import Block, Plan
from cloner.scenes.building.solids import Panel, Room
from cloner.scenes.building.walkable import make_walkable
from cloner.scenes.films.staged import add_statues
from cloner.scenes.lighting.direct import sun_direction
from cloner.scenes.written import read_built_room, read_light, read_room_sound

#: How the page's textures are kept: taste, no blocks at arm's length.
LOOK_QUALITY: Final = 88
#: When a statue awakens of which nothing is told, seconds.
NEVER_S: Final = 1e5


def build_folder(
    folder: Path, walk: Path, pack: Path, out: Path, *, seconds: float, seed: int, progress: Progress = no_progress
) -> list[str]:
    """Write a pack whose clones act in a lit room; return a report.

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
    room = read_built_room(folder)
    things = scenario_blocks(room.plan, walk)
    parts = room_parts(room, *read_light(folder), folder.name, things if "statues" in read_facts(pack) else ())
    parts = add_sound(parts, read_room_sound(folder, room))
    return bake_file(walk, pack, out, seconds=seconds, seed=seed, room=parts, progress=progress)


def scenario_blocks(plan: Plan, walk: Path) -> tuple[Block, ...]:
    """Return the blocks of a plan that stand for a scenario's things."""
    names = thing_names(walk)
    return tuple(one for one in plan.blocks if one.name in names and not one.pillar)


def room_parts(
    room: Room, light: bytes, brightest: float, probes: Probes, where: str, statues: Sequence[Block] = ()
) -> RoomParts:
    """Return a room as files of a pack.

    Parameters
    ----------
    room : Room
    light : bytes
        The map's PNG file, in which white stands for ``brightest``.
    brightest, probes, where
        As of :func:`cloner.scenes.written.read_light`, and what to call it.
    statues : sequence of Block
        Blocks in whose stead clones in stone stand; their shadows stay.
    """
    charts, size = make_charts(room)
    try:
        with Image.open(io.BytesIO(light), formats=["PNG"]) as image:
            if image.size != size:
                raise ValueError("another room's")
            pixels = np.asarray(image.convert("RGBA"))
    except (OSError, ValueError) as error:
        raise ClonerError("the light map is not this room's", "Make it with cloner scene light", where) from error
    boxes = np.array([block_quads(one)[1][0] for one in statues]).reshape(-1, 2, 3)
    meshes = make_meshes(tuple(one for one in charts if not _within(one.panel, boxes)), size, room.looks)
    corners = [
        np.column_stack([one.places, one.uv, one.light_uv, np.full(len(one.places), k)])[one.triangles.ravel()]
        for k, one in enumerate(meshes)
    ]
    walkable, ground_low, ground_step = make_walkable(room)
    arrays: dict[str, NDArray[Any]] = {
        "corners": np.concatenate(corners).astype(np.float32), "probes": probes.light, "sun": probes.sun,
        "walkable": walkable,
    }  # fmt: skip
    data, layout = pack_arrays(arrays)
    sheet = texture_sheet([room.looks[one.look] for one in meshes])
    sun = room.plan.sun
    facts = {
        "name": room.plan.name, "arrays": layout, "low": probes.low.tolist(), "heights": probes.heights.tolist(),
        "step": probes.step, "shape": list(probes.sun.shape), "brightest": brightest,
        "ground_low": list(ground_low), "ground_step": ground_step,
        "sky_light": list(room.plan.sky.light), "ground": room.looks[room.plan.floors[-1].look].albedo.tolist(),
        "sun_way": sun_direction(sun).tolist() if sun else [0.0, 1.0, 0.0],
        "sun_light": list(sun.light) if sun else [0.0] * 3,
    }  # fmt: skip
    files = {
        ROOM_FILE: data,
        LOOKS_FILE: encode_webp(sheet, LOOK_QUALITY),
        LIGHT_FILE: encode_webp(pixels[..., :3], None),
        SUN_FILE: encode_webp(pixels[..., 3], None),
    }
    stand = partial(_with_statues, room.plan, {one.name: one for one in statues}) if statues else None
    return RoomParts(files, facts, page_views(room.plan), stand)


def add_sound(parts: RoomParts, sound: tuple[bytes, list[float]] | None) -> RoomParts:
    """Return a room with its echo and the area where it applies."""
    if sound is None:
        return parts
    return replace(parts, files={**parts.files, ECHO_FILE: sound[0]}, facts={**parts.facts, "echo": sound[1]})


def _within(panel: Panel, boxes: NDArray[np.float64]) -> bool:
    """Return whether a panel is a face of one of (B, 2, 3) boxes."""
    ends = np.stack([panel.corner, panel.corner + panel.along * panel.size[0] + panel.up * panel.size[1]])
    return any(bool(((ends >= box[0] - 1e-6) & (ends <= box[1] + 1e-6)).all()) for box in boxes)


def _with_statues(
    plan: Plan, blocks: Mapping[str, Block], walk: Trajectories, acted: Acted, facts: dict[str, Any], pack: Path,
    seconds: float,
) -> tuple[Acted, Mapping[str, Any]]:  # fmt: skip
    """Return the actions with a clone in stone for each thing, facing the middle of the floor."""
    floor = max(plan.floors, key=lambda one: (one.high[0] - one.low[0]) * (one.high[1] - one.low[1]))
    rows = []
    for name, block in blocks.items():
        away = [(low + high) / 2.0 - at for low, high, at in zip(floor.low, floor.high, block.at, strict=True)]
        along = abs(away[0]) * (floor.high[1] - floor.low[1]) < abs(away[1]) * (floor.high[0] - floor.low[0])
        heading = np.arctan2(0.0, -away[1]) if along else np.arctan2(away[0], 0.0)
        wakes = next((when for when, what in walk.told if what == f"{name} awakens"), NEVER_S)
        rows.append((block.at[0], -block.at[1], block.low, float(heading), wakes))
    staged, staging = add_statues(acted, read_stock(pack, facts), rows, seconds)
    return staged, {**staging, "things": list(blocks)}


def page_views(plan: Plan) -> dict[str, list[list[float]]]:
    """Return the cameras of the page's views: inside the largest floor, and in front of the door."""
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
