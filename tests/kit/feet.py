"""How far feet of people who act a scenario go over the ground while they touch it, by the strict ruler."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from cloner.crowd.packs.reading import read_facts, read_stock
from cloner.crowd.staged.footing import BY_FOOTINGS, CLIP_STEP, Acted, people_at, rotate_by_heading, sole_places
from cloner.motion.moves.slide import RULER_HZ, foot_slides_m
from cloner.records.motions import Motion


class Soles:
    """Soles of a pack's clones in all frames of their clips."""

    def __init__(self, pack: Path) -> None:
        facts = read_facts(pack)
        held = read_stock(pack, facts)
        self.starts = [np.cumsum([0, *(clip["frames"] for clip in row["clips"])]) for row in facts["people"]]
        self.points = [[sole_places(one, held.body, side) for side in ("left", "right")] for one in held.numbers]

    def shown(self, row: np.ndarray, side: int) -> np.ndarray:
        """(n, 3) a sole of a person whose row is shown, as ``person.vert`` places it."""
        clone, scale, share = int(row[1, 2]), row[1, 3], row[1, 1]
        other, second = divmod(int(row[4, 0]), int(CLIP_STEP))
        first = self.points[clone][side][self.starts[clone][int(row[2, 3])] + int(row[1, 0])]
        blended = self.points[clone][side][self.starts[clone][other] + second]
        own = (first + (blended - first) * share) * scale
        flat = rotate_by_heading(np.full(len(own), float(row[0, 3])), own[:, ::2])
        return np.column_stack([flat[:, 0] + row[0, 1], own[:, 1], flat[:, 1] + row[0, 2]])

    def slides_mm(self, acted: Acted, who: int, begin_s: float, end_s: float) -> np.ndarray:
        """(S,) each step of either foot of a person, millimetres."""
        first, last = acted.starts[who : who + 2]
        one = Acted(acted.footings[first:last], np.array([0, last - first], np.uint32), acted.people[who : who + 1],
                    acted.touches, acted.clips)  # fmt: skip
        times = np.arange(begin_s, end_s, 1.0 / RULER_HZ)
        rows = [row for row in (people_at(one, now)[0] for now in times) if row[0, 0] == BY_FOOTINGS]
        still = Motion("seen", np.arange(len(rows)) / RULER_HZ, np.zeros((len(rows), 3)), np.zeros((len(rows), 1, 3)))
        feet = (np.stack([self.shown(row, side) for row in rows]) for side in (0, 1))
        return 1000.0 * np.concatenate([foot_slides_m(points, still) for points in feet])
