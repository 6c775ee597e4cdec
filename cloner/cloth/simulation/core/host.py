"""The cloth engine in Python, with its arrays in NumPy (`cloner.webassembly.instances`)."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import numpy as np

from cloner.cloth.simulation.wearer import Skin
from cloner.errors import ClonerError
from cloner.records.arrays import Array
from cloner.webassembly.instances import LARGEST_BYTES, Instance, bytes_of, shapes_for

MODULE: Final = Path(__file__).with_name("engine.wasm")
#: How many there are of everything, in the order of `counts()` (core/memory.ts).
COUNTS: Final = ("vertices", "triangles", "stretches", "bends", "helds", "neighbours", "skins")
#: The arrays that the module lends, in the order of `lend`: name, type, shape. Ends of lists have one row more.
ARRAYS: Final[tuple[tuple[str, str, tuple[str | int, ...]], ...]] = (
    ("place", "<f8", ("vertices", 3)), ("before", "<f8", ("vertices", 3)), ("velocity", "<f8", ("vertices", 3)),
    ("thrust", "<f8", ("vertices", 3)), ("free", "<f8", ("vertices",)), ("faces", "<i4", ("triangles", 3)),
    ("stretch_ends", "<i4", ("stretches", 2)), ("stretch_rest", "<f8", ("stretches",)),
    ("stretch_gives", "<f8", ("stretches",)),
    ("bend_ends", "<i4", ("bends", 2)), ("bend_rest", "<f8", ("bends",)), ("bend_gives", "<f8", ("bends",)),
    ("held", "<i4", ("helds",)), ("held_early", "<f8", ("helds", 3)), ("held_late", "<f8", ("helds", 3)),
    ("anchor", "<i4", ("vertices",)), ("leash", "<f8", ("vertices",)), ("radius", "<f8", ("vertices",)),
    ("next_first", "<i4", ("vertices+",)), ("next", "<i4", ("neighbours",)),
    ("skin_early", "<f8", ("skins", 3)), ("skin_late", "<f8", ("skins", 3)), ("skin_normal", "<f8", ("skins", 3)),
    ("lead_early", "<f8", ("vertices", 3)), ("lead_late", "<f8", ("vertices", 3)),
    ("plane_early", "<f8", ("vertices", 3)), ("plane_late", "<f8", ("vertices", 3)),
    ("plane_normal", "<f8", ("vertices", 3)), ("near", "|b1", ("vertices",)),
)  # fmt: skip


class ClothEngine(Instance):
    """One instance of the module: one garment, or only points that are pushed by skin.

    Parameters
    ----------
    **counts : int
        How many there are of what `COUNTS` names; none of what is not told.

    Raises
    ------
    ClonerError
        If there is not memory enough.
    """

    def __init__(self, **counts: int) -> None:
        known = {name: counts.get(name, 0) for name in COUNTS}
        known["vertices+"] = known["vertices"] + 1
        shapes = shapes_for(ARRAYS, known)
        missing = ClonerError("there is not memory enough for the cloth", "Make its triangles larger", "cloth")
        if 2 * bytes_of(shapes) > LARGEST_BYTES:  # the module's own arrays and pairs take less than what it lends
            raise missing
        super().__init__(MODULE, [known[name] for name in COUNTS], shapes, (), missing)

    def meet(self, skin: Skin) -> None:
        """Set the skin at a frame's beginning and end."""
        arrays = self.arrays
        arrays["skin_early"][:], arrays["skin_late"][:], arrays["skin_normal"][:] = (
            skin.early_m,
            skin.late_m,
            skin.normals,
        )


def push_out_of_skin(places_m: Array, skin: Skin, clear_m: float, deep_m: float, times: int = 1) -> Array:
    """Return points (N, 3) pushed out until they have a distance from the tangent planes of the skin under them,
    metres.

    Points farther than ``deep_m`` from all skin, in it or not, stay.
    """
    core = ClothEngine(vertices=len(places_m), skins=len(skin.late_m))
    core.meet(skin)
    core.arrays["place"][:] = places_m
    for _ in range(times):
        core.call("findPlanes", 1.0, deep_m)
        core.call("keepOut", clear_m, 0.0, 1.0, 0.0)
    return np.array(core.arrays["place"])
