"""How feet stand in a pack that acts: python benchmarks/footings.py PACK WALK (with tests/ on PYTHONPATH).

PACK is what ``cloner crowd --feelings`` wrote, WALK what ``cloner crowd run`` wrote. First each clone walks each
feeling's walk on straight and bent ways, faster and slower than its own; then the walk is baked and every ninth person
is measured. Slides are the strict ruler's (`cloner.motion.moves.slide`), millimetres a step, mean / worst; how far
bodies are from where the trajectories have them, metres.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import numpy as np

from cloner.acting.tracks import Track, footings_on_tracks
from cloner.acting.written import act_out
from cloner.behaviour.feet import Feet
from cloner.behaviour.trajectories import Trajectories, read_trajectories
from cloner.behaviour.walking import RATE_HZ
from cloner.crowd.packs.reading import read_facts, read_stock
from cloner.crowd.staged.footing import BY_FOOTINGS, Acted, people_at, touching_points
from cloner.crowd.staged.scene import IDLE
from kit.feet import Soles

#: Share of the walk's own speed, and radians a second.
WAYS = ((1.0, 0.0), (1.0, 0.5), (1.0, 1.5), (0.6, 0.0), (0.6, 1.5), (0.3, 0.0), (1.3, 0.0))
SECONDS = 12.0
EVERY = 9


def ways(pack: Path) -> list[str]:
    """Return the table of single clones."""
    facts = read_facts(pack)
    held, soles = read_stock(pack, facts), Soles(pack)
    people = facts["people"]
    touches = np.stack(
        [touching_points(n, held.body, row["clips"]) for n, row in zip(held.numbers, people, strict=True)]
    )
    clips = np.array([[[c["frames"], c["seconds"]] for c in row["clips"]] for row in people], np.float32)
    heads = [f"{share:g} of its speed, {turn:g} rad/s" for share, turn in WAYS]
    lines = [f"| clone | walk | {' | '.join(heads)} |", f"| --- | --- {'| --- ' * len(WAYS)}|"]
    for clone, row in enumerate(people):
        for kind, clip in enumerate(row["clips"]):
            if not clip["speed_m_s"]:
                continue
            cells = []
            for share, turn in WAYS:
                times = np.arange(0.0, SECONDS, 1.0 / RATE_HZ)
                heading, step = turn * times, share * clip["speed_m_s"] / RATE_HZ
                place = np.cumsum(step * np.stack([np.sin(heading), np.cos(heading)], axis=1), axis=0)
                every = np.ones(len(times), np.int64)
                track = Track(times, place, heading, every * IDLE, every * kind)
                feet = Feet(touches, clips, np.array([clone]), np.ones(1), np.zeros(1), {}, {})
                (own,) = footings_on_tracks([track], feet)
                person = np.zeros((1, 5, 4), np.float32)
                person[0, 1] = 0.0, 0.0, clone, 1.0
                slid = soles.slides_mm(
                    Acted(own, np.array([0, len(own)], np.uint32), person, touches, clips), 0, 3.0, SECONDS - 1.0
                )
                cells.append(f"{slid.mean():.1f} / {slid.max():.1f}")
            lines.append(f"| {row['id']} | {clip['name']} | {' | '.join(cells)} |")
    return lines


def among_others(pack: Path, walk: Trajectories) -> list[str]:
    """Return what is to say of a whole scenario."""
    begun = time.perf_counter()
    acted, _ = act_out(walk, pack, read_facts(pack))
    spent, soles, end = time.perf_counter() - begun, Soles(pack), (len(walk.place) - 1) / RATE_HZ
    slid = np.concatenate([soles.slides_mm(acted, who, 0.0, end) for who in range(0, len(walk.groups), EVERY)])
    off = []
    for frame in range(0, len(walk.place) - 1, 5):
        rows = people_at(acted, frame / RATE_HZ)
        here = walk.present[frame] & (rows[:, 0, 0] == BY_FOOTINGS)
        want = np.column_stack([walk.place[frame, :, 0], -walk.place[frame, :, 1]])
        off.append(np.linalg.norm(rows[here, 0, 1:3] - want[here], axis=1))
    away = np.concatenate(off)
    return [
        f"{len(walk.groups)} people, {end:g} s: {len(acted.footings)} footings in {spent:.1f} s",
        f"slides of {len(slid)} steps: mean {slid.mean():.1f}, median {np.median(slid):.1f}, "
        f"nine in ten below {np.percentile(slid, 90):.1f} mm",
        f"bodies off their trajectories: mean {away.mean():.2f}, "
        f"nineteen in twenty below {np.percentile(away, 95):.2f} m",
    ]


if __name__ == "__main__":
    place, told = (Path(one) for one in sys.argv[1:3])
    sys.stdout.write("\n".join([*ways(place), "", *among_others(place, read_trajectories(told))]) + "\n")
