"""Storage of a clone's cloth motion: ``cloth.npz`` beside ``clone.npz``."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Final

import numpy as np

from cloner.errors import ClonerError
from cloner.exporters.shared.files import write_bytes
from cloner.generic.load import load_generic
from cloner.project.archives import BROKEN, open_archive
from cloner.records.clones import Clone
from cloner.records.flows import Flow

FLOW_FILE: Final = "cloth.npz"
#: Five garments of 10,000 points over two seconds.
LARGEST_BYTES: Final = 100_000_000
_FIELDS: Final = ("frames_m", "root_m", "rotations", "hidden")
_AGAIN: Final = "Dress the clone again with this version of Cloner"


def save_flow(flow: Flow, path: Path) -> None:
    """Write how cloth flows as one .npz.

    Raises
    ------
    ClonerError
        If the file cannot be written.
    """
    stream = io.BytesIO()
    np.savez_compressed(stream, allow_pickle=False, **{name: getattr(flow, name) for name in _FIELDS})
    write_bytes(path, stream.getvalue())


def load_flow(folder: Path, clone: Clone) -> Flow | None:
    """Return the cloth motion of a result's clone, None if it wears nothing simulated.

    Raises
    ------
    ClonerError
        If the file is broken, or is another clone's.
    """
    path = folder / FLOW_FILE
    if not path.is_file():
        return None
    try:
        with open_archive(path, LARGEST_BYTES) as archive:
            flow = Flow(**{name: archive[name] for name in _FIELDS})
    except BROKEN as error:
        raise ClonerError("the file is no readable cloth", _AGAIN, path.name) from error
    worn = [shell for shell in clone.shells if shell.kind == "cloth"]
    finite = all(np.isfinite(getattr(flow, name)).all() for name in _FIELDS[:3])
    fits = len(worn) == 1 and flow.frames_m.shape[1] == len(worn[0].vertices_m)
    joints, skin = len(load_generic().joint_parents), len(load_generic().vertices_m)
    if not (fits and finite and flow.rotations.shape[1] == joints and len(flow.hidden) == skin):
        raise ClonerError("the cloth is another clone's", _AGAIN, path.name)
    return flow
