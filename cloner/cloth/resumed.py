"""Checkpoints of a simulation, so that an interrupted one can continue."""

from __future__ import annotations

import hashlib
import io
from pathlib import Path
from typing import Any, Final

import numpy as np

import cloner
from cloner.cloth.simulation.forces import Slips
from cloner.cloth.simulation.moving import WornGarment
from cloner.cloth.simulation.solver import State
from cloner.exporters.shared.files import write_bytes
from cloner.project.archives import BROKEN, open_archive
from cloner.records.arrays import Array

#: No simulation's frames take more: three hundred of twenty thousand vertices are a tenth of it.
MOST_BYTES: Final = 2 << 30


def checkpoint_path(out: Path, number: int) -> Path:
    """Return the path of the ``number``-th garment's checkpoint while ``out`` is made: hidden, beside it."""
    return out.with_name(f".{out.name}.{number}.frames")


def simulation_digest(worn: WornGarment, cycles: int) -> str:
    """Return a digest of everything that determines a simulation."""
    digest = hashlib.sha256(repr((cloner.__version__, cycles, worn.system is None, worn.sheet.fabric)).encode())
    below = () if worn.under is None else (worn.under.put_m, worn.under.loop_m)
    sheet = worn.sheet
    cloth = (worn.start.places_m, sheet.rest_m, sheet.mass_kg, sheet.held)
    for values in (*cloth, worn.colliders_in(0).skin_m, *below, worn.root_m, worn.rotations):
        digest.update(np.ascontiguousarray(values).tobytes())
    return digest.hexdigest()


def write_checkpoint(path: Path, key: str, stamp: str, frames_m: list[Array], state: State) -> None:
    """Write frames (F, N, 3) and the state after the last of them; readable by their owner alone.

    The clone's ``stamp`` stands in it as in every output, so that what is left of a visitor is found.

    Raises
    ------
    ClonerError
        If they cannot be written.
    """
    arrays: dict[str, Any] = {"key": np.array(key), "frames_m": np.array(frames_m), "speeds_m_s": state.speeds_m_s}
    arrays["stamp"] = np.frombuffer(stamp.encode(), np.uint8)
    if state.slips is not None:
        arrays |= {"strain": state.slips.strain, "bent_m": state.slips.bent_m}
    data = io.BytesIO()
    np.savez(data, **arrays)
    write_bytes(path, data.getvalue())


def read_checkpoint(path: Path, key: str) -> tuple[list[Array], State] | None:
    """Return the frames of the same simulation and the state after them; None if there are none."""
    try:
        with open_archive(path, MOST_BYTES) as archive:
            if str(archive["key"]) != key:
                return None
            frames, speeds = archive["frames_m"], archive["speeds_m_s"]
            slips = Slips(archive["strain"], archive["bent_m"]) if "strain" in archive else None
    except BROKEN:  # none, or cut off
        return None
    if frames.ndim != 3 or not len(frames) or frames[0].shape != speeds.shape:
        return None
    return list(frames), State(frames[-1], speeds, slips)
