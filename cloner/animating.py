"""Put captured motions on a finished clone."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from cloner.errors import ClonerError
from cloner.exporters.gltf import export
from cloner.motion.body import body_of
from cloner.motion.bvh import read_bvh
from cloner.motion.cycle import walk_cycle
from cloner.motion.retarget import retarget
from cloner.picture import clone_of


def animate_file(clone_path: Path, captures: Sequence[Path], out: Path, *, cycles: bool = False) -> None:
    """Write a clone with captured motions as a binary glTF file.

    Parameters
    ----------
    clone_path : Path
        ``clone.npz`` or the folder that holds it.
    captures : sequence of Path
        BVH files; each becomes an animation with the file's name.
    out : Path
        Ends with .glb.
    cycles : bool
        Cut every capture down to two steps of walking on the spot, closed into a circle.

    Raises
    ------
    ClonerError
        If there is no clone, a capture cannot be read or laid on, or ``out`` cannot be written.
    """
    if out.suffix.lower() != ".glb":
        raise ClonerError("animations are written as glTF", "Give --out a name that ends with .glb", out.name)
    clone = clone_of(clone_path)
    body = body_of(clone)
    motions = [retarget(read_bvh(path), body, name=path.stem) for path in captures]
    if cycles:
        motions = [walk_cycle(body, motion) for motion in motions]
    export(clone, out.parent, name=out.stem, motions=motions)
