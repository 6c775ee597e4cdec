"""A clone that joins a running scene: its files in a pack's formats.

A newcomer is seen from near or small, never as an impostor: baking those takes longer than anybody waits (16 s of two
busy cores; the rest 4 s).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.crowd.clones import stock
from cloner.crowd.clones.cast import make_crowd_clone
from cloner.crowd.clones.levels import BodyLevels, read_budgets
from cloner.crowd.clones.people import Found, load_person
from cloner.crowd.packs.files import encode_webp, pack_arrays, shell_bytes
from cloner.crowd.packs.pack import ATLAS_QUALITY
from cloner.crowd.staged.footing import touching_points
from cloner.crowd.staged.scene import IDLE
from cloner.errors import ClonerError
from cloner.project.clone_file import CLONE_FILE
from cloner.project.flow_file import load_flow
from cloner.project.results import RESULT_MARK

#: A folder and when the clone in it was made.
Mark = tuple[Path, float]

_GENERIC: Final = re.compile(r"generic ([0-9a-f]+)")


@dataclass(frozen=True, slots=True, eq=False)
class Newcomer:
    """A clone that can join: files by name, its description for the page, touches (K, 48, 6) and clips (K, 2)."""

    files: Mapping[str, bytes]
    row: Mapping[str, Any]
    touches: NDArray[np.float32]
    clips: NDArray[np.float32]


def make_newcomer(found: Found, facts: Mapping[str, Any], body: BodyLevels) -> Newcomer:
    """Return a finished clone prepared for a pack that acts.

    Raises
    ------
    ClonerError
        If it cannot be read, may not be shown, or does not fit the pack's clones.
    """
    own = facts["people"][0]
    match = _GENERIC.search(str(own["stamp"]))
    clone, _ = load_person(found, match.group(1) if match else "")
    budgets = read_budgets(facts["numbers"]["loose"])
    names = tuple(str(one["name"]) for one in own["clips"])
    cast = make_crowd_clone(
        "newcomer", clone, body, poses=int(facts["impostors"]["poses"]), feelings=len(names) > IDLE + 2,
        flow=load_flow(found.folder, clone), faces="faces" in facts, budgets=budgets,
    )  # fmt: skip
    if tuple(one.name for one in cast.clips) != names:
        hint = "Make the pack again with cloner crowd --feelings, without --walk, and the scene of it"
        raise ClonerError("the scene's clones walk as newcomers cannot", hint, found.identifier)
    numbers = stock.clone_arrays(cast, budgets)
    texels = float(facts["switch"]["texels_per_m"])
    clips = [{"frames": len(one.frames), "speed_m_s": one.speed_m_s} for one in cast.clips]
    touches = touching_points(numbers, body, clips)
    lengths = np.array([[len(one.frames), one.seconds] for one in cast.clips], np.float32)
    arrays: dict[str, NDArray[Any]] = {
        "vertices": numbers.vertices, "loose": numbers.loose, "corners": numbers.corners, "bones": numbers.bones,
        "table": stock.table_row(cast, stock.sets_without_impostors(cast), texels, int(own["views"]), 0),
        "tiles": np.zeros((2, 4), np.float32), "touches": touches, "clips": lengths,
    }  # fmt: skip
    if cast.face is not None:
        arrays["moves"] = cast.face
    data, layout = pack_arrays(arrays)
    files = {
        "numbers.bin": data,
        "atlas.webp": encode_webp(cast.atlas, ATLAS_QUALITY),
        "codes.webp": encode_webp(cast.marks, None),
        "shell.webp": shell_bytes(cast.shell),
    }
    row = {"arrays": layout, "stature_m": round(cast.stature_m, 4)}
    return Newcomer(files, row, touches, lengths)


def finished_in(folder: Path) -> tuple[Path, ...]:
    """Return the finished clones in a folder of results, the latest first."""
    found = []
    for path in folder.glob(f"*/{CLONE_FILE}"):
        made = creation_time(path.parent)
        if made is not None and (path.parent / RESULT_MARK).is_file() and not path.parent.name.startswith("."):
            found.append((made, path.parent))
    return tuple(one for _, one in sorted(found, reverse=True))


def result_finder(clones: Path | Callable[[], tuple[Path, ...]]) -> Callable[[], tuple[Path, ...]]:
    """Return a function that lists the clones that may be shown in a folder of results, the latest first.

    Raises
    ------
    ClonerError
        If there is no such folder.
    """
    if not isinstance(clones, Path):
        return clones
    if not clones.is_dir():
        raise ClonerError("there is no such folder", "Give the folder of results, or the event's", clones.name)
    return partial(finished_in, clones)


def latest_clones(clones: Callable[[], tuple[Path, ...]], most: int) -> list[Mark]:
    """Return the latest clones that are to take part: folders and creation times."""
    made = [(folder, creation_time(folder)) for folder in clones()]
    return [(folder, when) for folder, when in made if when is not None][:most]


def creation_time(folder: Path) -> float | None:
    """Return when the clone in a folder was made, None if there is none."""
    try:
        return (folder / CLONE_FILE).stat().st_mtime
    except OSError:
        return None
