"""The commands ``cloner scene make`` and ``light``: from a plan to a folder with a room, its light and its probes."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path
from typing import Final

import numpy as np

from cloner.crowd.staged.rooms import Probes
from cloner.errors import ClonerError
from cloner.exporters.shared.files import png_bytes, write_bytes
from cloner.motion.face.sound import wav_bytes
from cloner.pipeline import Progress, no_progress
from cloner.project.atomic import safe_output
from cloner.scenes.building.charts import make_charts
from cloner.scenes.building.gltf import make_meshes, room_glb, to_bytes
from cloner.scenes.building.photos import read_plan_photos, read_stored_photos, rectified_files
from cloner.scenes.building.pieces import from_plan
from cloner.scenes.building.reading import read_plan
from cloner.scenes.building.solids import Room, build_room
from cloner.scenes.building.x3d import room_x3d
from cloner.scenes.lighting.echoes import EAR_M, RATE_HZ, impulse_response
from cloner.scenes.lighting.light import light_room
from cloner.scenes.lighting.probes import make_probes
from cloner.untrusted import UnsuitableFile, read_untrusted

PLAN_FILE, ROOM_FILE, LIGHT_FILE, PROBES_FILE = "plan.toml", "room.glb", "light.png", "probes.npz"
#: What the page asks for: in colours all light but the sun's own, in alpha how much of the sun is there.
PARTS_FILE: Final = "parts.png"
#: What is brighter than all but this share of the texels may be cut off: the ceiling above a lamp.
CUT_OFF: Final = 0.002
#: A map of the largest floor at 4 cm, and its probes, are smaller.
LARGEST_LIGHT_BYTES: Final = 200_000_000
#: Where a room's echoes lie; four seconds have 180 kB.
SOUND_FOLDER, LARGEST_SOUND_BYTES = "sound", 1_000_000
_ARRAYS: Final = {"low": 1, "heights": 1, "step": 0, "light": 5, "sun": 3, "brightest": 0}


def make_folder(source: str, out: Path) -> list[str]:
    """Write a plan's room into a folder; return a report.

    Raises
    ------
    ClonerError
        If the plan or the folder is no good.
    """
    plan, text = read_plan(source)
    photos = read_plan_photos(plan, Path(source).parent)
    room = build_room(plan, photos)
    safe_output(out)
    data = room_glb(room)
    write_bytes(out / PLAN_FILE, text.encode("utf-8"))
    write_bytes(out / ROOM_FILE, data)
    for name, picture in rectified_files(plan, photos).items():
        write_bytes(out / name, picture)
    triangles = sum(len(one.triangles) for one in make_meshes(*make_charts(room), room.looks))
    floor = sum((one.high[0] - one.low[0]) * (one.high[1] - one.low[1]) for one in plan.floors)
    return [
        f"{plan.name}: {floor:.0f} m2 of floor, {triangles} triangles, {len(data) / 1e3:.0f} kB",
        str(out / ROOM_FILE),
    ]


def light_folder(folder: Path, progress: Progress = no_progress) -> list[str]:
    """Compute light maps and probes of a folder's room; return a report."""
    room = read_built_room(folder)
    lit = light_room(room, progress=progress)
    probes = make_probes(room, lit, progress)
    soft = np.maximum(lit.map - lit.sun * (room.plan.sun.light if room.plan.sun else (0.0,) * 3), 0.0)
    brightest = max(float(np.quantile(soft.max(axis=2), 1.0 - CUT_OFF)), 1e-3)
    parts = np.dstack([to_bytes(soft.astype(np.float32), brightest), np.rint(lit.sun * 255.0).astype(np.uint8)])
    stream = io.BytesIO()
    np.savez_compressed(
        stream, low=probes.low, heights=probes.heights, step=np.array(probes.step), light=probes.light, sun=probes.sun,
        brightest=np.array(brightest),
    )  # fmt: skip
    write_bytes(folder / LIGHT_FILE, png_bytes(to_bytes(lit.map)))
    write_bytes(folder / PARTS_FILE, png_bytes(parts))
    write_bytes(folder / PROBES_FILE, stream.getvalue())
    write_bytes(folder / ROOM_FILE, room_glb(room, lit.map))
    for name, data in room_x3d(room, LIGHT_FILE).items():
        write_bytes(folder / name, data)
    return [
        f"light map {lit.size[0]} x {lit.size[1]} texels, {probes.sun.size} probes",
        str(folder / ROOM_FILE), str(folder / "room.x3d"), str(folder / PROBES_FILE),
    ]  # fmt: skip


def sound_folder(folder: Path, progress: Progress = no_progress) -> list[str]:
    """Compute the acoustics of a folder's room in the middle of each floor, as WAV files; return a report.

    Raises
    ------
    ClonerError
        If there is no room, or a file cannot be written.
    """
    room = read_built_room(folder)
    lines = []
    for number, floor in enumerate(room.plan.floors, start=1):
        middle = ((floor.low[0] + floor.high[0]) / 2.0, (floor.low[1] + floor.high[1]) / 2.0)
        echo = impulse_response(room, from_plan(*middle, EAR_M))
        name = f"floor_{number}.wav"
        write_bytes(folder / SOUND_FOLDER / name, wav_bytes(echo.samples, RATE_HZ))
        lines.append(f"{name}: at {middle[0]:g}, {middle[1]:g}: falls by 60 dB in {echo.rings_s:.2f} s")
        progress("sound", number / len(room.plan.floors))
    return [*lines, str(folder / SOUND_FOLDER)]


def read_room_sound(folder: Path, room: Room) -> tuple[bytes, list[float]] | None:
    """Return the acoustics of the largest floor of a folder's room, and its bounds (x, z, x, z); None
    if not computed.
    """
    areas = [(one.high[0] - one.low[0]) * (one.high[1] - one.low[1]) for one in room.plan.floors]
    largest = int(np.argmax(areas))
    floor = room.plan.floors[largest]
    try:
        data = read_untrusted(folder / SOUND_FOLDER / f"floor_{largest + 1}.wav", LARGEST_SOUND_BYTES)
    except (OSError, UnsuitableFile):
        return None
    return data, [floor.low[0], -floor.high[1], floor.high[0], -floor.low[1]]


def read_built_room(folder: Path) -> Room:
    """Return the room of a folder that ``cloner scene make`` wrote.

    Raises
    ------
    ClonerError
        If there is none, or it is damaged.
    """
    if not (folder / PLAN_FILE).is_file():
        raise ClonerError("there is no room", "Make it with cloner scene make", folder.name)
    plan = read_plan(folder / PLAN_FILE)[0]
    return build_room(plan, read_stored_photos(plan, folder))


def read_light(folder: Path) -> tuple[bytes, float, Probes]:
    """Return the output of ``cloner scene light``: the page's light map as a file, its scale, and the probes.

    Raises
    ------
    ClonerError
        If there are none, or they are damaged.
    """
    try:
        picture = read_untrusted(folder / PARTS_FILE, LARGEST_LIGHT_BYTES)
        data = read_untrusted(folder / PROBES_FILE, LARGEST_LIGHT_BYTES)
        with np.load(io.BytesIO(data), allow_pickle=False) as held:
            found = {name: np.asarray(held[name], np.float64) for name in _ARRAYS}
        light, sun = found["light"], found["sun"]
        fits = all(found[name].ndim == axes and np.isfinite(found[name]).all() for name, axes in _ARRAYS.items())
        if not (
            fits
            and light.shape == (*sun.shape, 3, 4)
            and len(found["heights"]) == sun.shape[0]
            and sun.size
            and found["brightest"] > 0.0
        ):
            raise ValueError("probes of odd shapes")
    except (OSError, UnsuitableFile, ValueError, KeyError, EOFError, zipfile.BadZipFile) as error:
        raise ClonerError("the room has no light", "Make it with cloner scene light", folder.name) from error
    step = float(found["step"])
    probes = Probes(found["low"], found["heights"], step, light.astype(np.float32), sun.astype(np.float32))
    return picture, float(found["brightest"]), probes
