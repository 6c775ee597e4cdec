"""The crowd engine in Python, with its arrays in NumPy (`cloner.webassembly.instances`)."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Final

from cloner.errors import ClonerError
from cloner.webassembly.instances import LARGEST_BYTES, Instance, Shape, bytes_of, shapes_for

MODULE: Final = Path(__file__).with_name("engine.wasm")
#: How many there are of everything, in the order of `counts()` (core/memory.ts; minds and feet have theirs).
COUNTS: Final = (
    "people", "rows", "cols", "walls", "reach", "places", "homes", "bands", "visits", "memory", "things", "emotions",
    "likes", "idle_acts", "rules", "actions", "events", "spots", "lattice", "looks", "clips", "frames", "acts",
)  # fmt: skip
#: The arrays that the module lends, in the order of `lend`: name, type, shape. Ends of lists have one row more.
ARRAYS: Final[tuple[tuple[str, str, tuple[str | int, ...]], ...]] = (
    ("place", "<f8", ("people", 2)), ("velocity", "<f8", ("people", 2)), ("way", "<f8", ("people", 2)),
    ("wants", "<f8", ("people",)), ("own_speed", "<f8", ("people",)), ("radius", "<f8", ("people",)),
    ("target", "<f8", ("people", 2)), ("facing", "<f8", ("people", 2)), ("look", "<f8", ("people", 2)),
    ("goal", "<i4", ("people",)), ("present", "|b1", ("people",)), ("avoids", "|b1", ("people",)),
    ("spotted", "|b1", ("people",)), ("settled", "|b1", ("people",)), ("direct", "|b1", ("people",)),
    ("wanders", "|b1", ("people",)), ("looks", "|b1", ("people",)), ("slow", "<i4", ("people",)),
    ("others", "<i4", ("people", 16)),
    ("band", "<i4", ("people",)), ("home", "<i4", ("people",)), ("emotion", "<i4", ("people",)),
    ("value", "<f8", ("people",)), ("vigour", "<f8", ("people",)), ("domination", "<f8", ("people",)),
    ("visited", "<i4", ("people",)), ("phase", "<i4", ("people",)), ("until", "<f8", ("people",)),
    ("leaving", "|b1", ("people",)), ("posture", "<i4", ("people",)), ("gaze", "<i4", ("people",)),
    ("idle", "<i4", ("people",)), ("orders", "<f8", (5, 4, "people")), ("ends", "<f8", (5, 4, "people")),
    ("band_home", "<i4", ("bands",)), ("leader", "<i4", ("bands",)), ("follows", "<i4", ("bands",)),
    ("follows_until", "<f8", ("bands",)), ("at_times", "|b1", ("bands",)), ("visit_count", "<i4", ("bands",)),
    ("visits", "<i4", ("bands", "visits")), ("knows", "|b1", ("bands", "places")),
    ("memory_count", "<i4", ("bands",)), ("memory_time", "<f8", ("bands", "memory")),
    ("memory_name", "<i4", ("bands", "memory")),
    ("home_flags", "<i4", ("homes",)), ("home_leads", "<i4", ("homes",)), ("home_memory", "<i4", ("homes",)),
    ("likes_first", "<i4", ("homes+",)), ("likes", "<i4", ("likes",)),
    ("thing_place", "<f8", ("things", 2)), ("awake", "|b1", ("things",)),
    ("speed", "<f8", ("emotions",)), ("idle_first", "<i4", ("emotions+",)), ("idle_acts", "<i4", ("idle_acts",)),
    ("place_middle", "<f8", ("places", 2)), ("place_low", "<f8", ("places", 2)), ("place_high", "<f8", ("places", 2)),
    ("place_counter", "<f8", ("places", 2)), ("place_seconds", "<f8", ("places",)), ("place_act", "<i4", ("places",)),
    ("place_holds", "<i4", ("places",)), ("place_look", "<i4", ("places",)),
    ("spot_first", "<i4", ("places+",)), ("spots", "<f8", ("spots", 2)), ("spots_nearest", "<i4", ("spots",)),
    ("lattice_first", "<i4", ("places+",)), ("lattice_wide", "<i4", ("places",)),
    ("lattice_low", "<f8", ("places", 2)), ("lattice", "<i4", ("lattice",)),
    ("rule_rows", "<i4", ("rules", 8)), ("rule_seconds", "<f8", ("rules",)),
    ("action_rows", "<i4", ("actions", 5)), ("action_seconds", "<f8", ("actions",)),
    ("told", "<f8", ("told", 4)), ("numbers", "<i4", (4,)),
    ("touches", "<f4", ("looks", "clips", 48, 6)), ("clips", "<f4", ("looks", "clips", 2)),
    ("look_of", "<i4", ("walkers",)), ("scale", "<f8", ("walkers",)), ("start_phase", "<f8", ("walkers",)),
    ("act_clip", "<i4", ("acts",)), ("walk_clip", "<i4", ("emotions",)),
    ("footings", "<f4", ("footings", 14)), ("foot_numbers", "<i4", (2,)), ("last_seen", "<i4", ("walkers",)),
    ("clock", "<f8", ("walkers",)),
    ("clear", "<f8", ("rows", "cols")), ("distance", "<f8", ("rows", "cols")),
    ("near", "<i4", ("rows", "cols", "reach")), ("walls", "<f8", ("walls", 4)),
    ("fields", "<f8", ("places", "rows", "cols", 2)), ("regions", "|b1", ("places", "rows", "cols")),
)  # fmt: skip
#: What the module does not lend takes so many bytes a cell, a person, a person's frame.
_CELL_BYTES, _PERSON_BYTES, _FRAME_BYTES = 292, 460, 32


class CrowdEngine(Instance):
    """One instance of the module: one world.

    Parameters
    ----------
    counts : mapping
        How many there are of what `COUNTS` names; none of what is not told.
    low : (2,) metres
        The raster's corner.
    period_m : float
        > 0: the world repeats along x.
    seed : int

    Attributes
    ----------
    arrays : dict
        `ARRAYS` by name, in the engine's own memory.
    begun : dict
        What it was made with, as JSON can hold it.

    Raises
    ------
    ClonerError
        If there is not memory enough.
    """

    def __init__(
        self, counts: Mapping[str, int], low: tuple[float, float], *, period_m: float = 0.0, seed: int = 0
    ) -> None:
        counted = [int(counts.get(name, 0)) for name in COUNTS]
        self.begun = {"counts": counted, "low": list(low), "period_m": period_m, "seed": str(seed)}
        shapes = array_shapes(counts)
        cells = counts["rows"] * counts["cols"]
        frames = counts.get("frames", 0) * counts["people"] * _FRAME_BYTES
        if bytes_of(shapes) + frames + cells * _CELL_BYTES + counts["people"] * _PERSON_BYTES > LARGEST_BYTES:
            raise ClonerError(
                "the floor is too large for so many points", "Make it smaller, or take points away", "floor"
            )
        seed = (seed + (1 << 63)) % (1 << 64) - (1 << 63)  # as the signed number that passes
        missing = ClonerError("there is not memory enough for the crowd", "Close other programs", "crowd")
        super().__init__(MODULE, counted, shapes, (*low, period_m, seed), missing)

    def memory(self) -> bytes:
        """Return the whole state: another host with the same counts and ground can continue from it."""
        return self.read(self.call("keep"))


def array_shapes(counts: Mapping[str, int]) -> dict[str, Shape]:
    """Return type and shape of each of `ARRAYS` for the given counts."""
    known = {name: counts.get(name, 0) for name in COUNTS}
    known |= {f"{name}+": known[name] + 1 for name in ("homes", "emotions", "places")}
    known["told"] = 4 * known["people"] + 1024
    known["walkers"] = known["people"] if known["looks"] else 0
    known["footings"] = 32 * known["people"] + 1024 if known["looks"] else 0
    return shapes_for(ARRAYS, known)
