"""Verification of a pack, and its contents."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

import numpy as np
from scipy.spatial import cKDTree

from cloner.crowd.packs.files import digest
from cloner.crowd.packs.reading import (
    LARGEST_FILE_BYTES,
    read_acted,
    read_casting,
    read_checked,
    read_facts,
    read_stock,
)
from cloner.crowd.staged.scene import ACTED, SCENES, Scene, looks_shown, make_scene, places_at
from cloner.errors import ClonerError
from cloner.untrusted import read_untrusted

COUNTED: Final = 1000  # people of whom looks and neighbours are counted
TIMES_S: Final = (0.0, 3.7, 11.1, 29.3)  # any moments
#: Bytes.
MIB: Final = 1 << 20


def check_pack(pack: Path) -> list[str]:
    """Return a pack's contents, line by line, after checking every file.

    Raises
    ------
    ClonerError
        If anything is missing, damaged or does not fit.
    """
    facts = read_facts(pack)
    size = 0
    for name in facts["files"]:
        size += len(read_checked(pack, name, facts))
    try:
        page = read_untrusted(pack / "player.html", LARGEST_FILE_BYTES)
    except OSError as error:
        raise ClonerError("the player is missing", "Make the crowd again with cloner crowd", "player.html") from error
    if digest(page) != facts["player"]["sha256"]:
        raise ClonerError("the player is damaged", "Make the crowd again with cloner crowd", "player.html")
    people = facts["people"]
    lines = [f"{len(people)} clones: {', '.join(row['id'] for row in people)}"]
    lines.append(f"{(size + len(page)) / len(people) / MIB:.2f} MiB a clone, with the player")
    memory = gpu_bytes(pack, facts)
    lines.append(f"{sum(memory.values()) / MIB:.0f} MiB of textures on the card: " + ", ".join(
        f"{name} {value / MIB:.1f}" for name, value in memory.items()
    ) + f"; in blocks, with --compressed, {compressed_gpu_bytes(memory) / MIB:.0f} MiB")  # fmt: skip
    for name in SCENES:
        made = make_scene(name, COUNTED, read_casting(facts))
        near = min(closest_repeat_m(made, now) for now in TIMES_S)
        lines.append(
            f"{name}: {looks_shown(made)} looks among {len(made.rows)} people, nearest same clone {near:.2f} m"
        )
    if "acted" in facts:
        acted = read_acted(pack, facts)
        seconds = float(facts["acted"]["seconds"])
        lines.append(f"{ACTED}: {len(acted.people)} people act {seconds:g} s in {len(acted.footings)} footings")
    return lines


def closest_repeat_m(made: Scene, now: float) -> float:
    """Return the least distance between two appearances of one clone, metres; those that fade at a lane's end do not
    count.
    """
    at = places_at(made, now)[:, ::2]
    clones = made.rows[:, 1, 2].astype(int)
    lane = made.rows[:, 0, 0] == 1.0
    shown = ~lane | (np.abs(at[:, 1]) < made.lane_m / 2.0 - 2.0)
    nearest = np.inf
    for clone in np.unique(clones):
        own = at[(clones == clone) & shown]
        if len(own) > 1:
            nearest = min(nearest, float(cKDTree(own).query(own, k=2)[0][:, 1].min()))
    return nearest


def compressed_gpu_bytes(memory: dict[str, int]) -> float:
    """Return the bytes of :func:`gpu_bytes` with block-compressed colours (``web/blocks.js``) and separate codes."""
    shares = {"impostors' colours": 1 / 4, "atlases": 1 / 8 + 3 / 16, "hair": 1 / 4}
    return sum(value * shares.get(name, 1.0) for name, value in memory.items())


def gpu_bytes(pack: Path, facts: dict[str, Any]) -> dict[str, int]:
    """Return the bytes of each texture in the player's memory, mipmaps included."""
    held = read_stock(pack, facts)
    if held.colours is None or held.shapes is None or held.tiles is None:
        raise ValueError("a pack has impostors")
    return {
        "impostors' colours": held.colours.nbytes * 4 // 3,
        "impostors' shapes": held.shapes.nbytes,
        "atlases": held.atlases.nbytes * 4 // 3,
        "hair": held.shells.nbytes * 4 // 3,
        **({"statues": held.stones.nbytes * 16 // 9} if held.stones is not None else {}),
        "vertices": sum(n.vertices.nbytes + n.loose.nbytes + n.corners.nbytes for n in held.numbers),
        "bones": sum(n.bones.nbytes for n in held.numbers),
        "tables": held.table.nbytes + held.tiles.nbytes,
    }
