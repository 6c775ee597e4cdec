"""Doors, a corner and a corridor by our walkers and by JuPedSim's, the same floors, people and speeds.

    python benchmarks/behaviour_beside.py ENVIRONMENT/bin/python [--seeds 5]

ENVIRONMENT has ``pip install jupedsim`` and nothing of Cloner. Writes the section *Beside JuPedSim* of
``docs/behaviour_benchmark.md``.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import time
from pathlib import Path
from typing import Any

import numpy as np
from behaviour import PAGE, kept
from behaviour_worlds import Middles, bodies_at, lattice, own_speeds, through

from cloner.behaviour.ground import BODY_M, make_ground, rectangle

ORACLE = Path(__file__).with_name("behaviour_oracle.py")
WIDTHS = (0.75, 1.0, 1.5, 2.0, 3.0)
TITLE = "Beside JuPedSim"
LONGEST_S = 200.0


def rooms(seeds: int) -> list[dict[str, Any]]:
    """Return each world: floors, goal and exit as boxes (middle, size), places (N, 2) in m, own speeds (N,) in m/s."""
    found: list[dict[str, Any]] = []
    for seed in range(1, seeds + 1):
        people, own = lattice(seed, 160, (2.0, 0.5), (9.0, 9.5)), own_speeds(seed, 160)
        found += [
            {"name": f"door {wide}", "wide": wide, "places": people, "speeds": own, "goal": ((15.2, 5.0), (1.8, 9.0)),
             "exit": ((10.25, 5.0), (0.1, wide)),
             "floor": [((5.0, 5.0), (10.0, 10.0)), ((10.1, 5.0), (0.4, wide)), ((13.2, 5.0), (6.0, 10.0))]}
            for wide in WIDTHS
        ]  # fmt: skip
        found.append({"name": "corner", "wide": 2.0, "places": lattice(seed, 20, (0.3, 0.3), (6.0, 1.7)),
                      "speeds": own_speeds(seed, 20), "goal": ((11.0, 11.5), (1.8, 0.8)),
                      "exit": ((11.0, 11.5), (2.0, 1.0)),
                      "floor": [((6.0, 1.0), (12.0, 2.0)), ((11.0, 6.0), (2.0, 12.0))]})  # fmt: skip
        found.append({"name": "corridor", "wide": 4.0, "places": lattice(seed, 120, (0.5, 0.3), (30.0, 3.7)),
                      "speeds": own_speeds(seed, 120), "goal": ((59.0, 2.0), (1.8, 3.8)),
                      "exit": ((59.0, 2.0), (2.0, 4.0)),
                      "floor": [((30.0, 2.0), (60.0, 4.0))]})  # fmt: skip
    return found


def told(times: list[float], room: dict[str, Any], refused: int) -> float:
    """Return persons a metre and second through a door from the 30th to the 130th, else when the last was out, s."""
    if room["name"].startswith("door"):
        return 100.0 / (times[129] - times[29]) / room["wide"] if len(times) >= 130 else 0.0
    return times[-1] if len(times) + refused == len(room["places"]) else float("nan")


def ours(room: dict[str, Any]) -> tuple[list[float], float]:
    """Return when each was out, and CPU seconds."""
    ground = make_ground([rectangle(*one) for one in room["floor"]])
    bodies = bodies_at(ground, room["places"], room["speeds"], places=1)
    middle, size = (np.array(one) for one in room["exit"])
    axis = 1 if room["name"] == "corner" else 0
    line = middle[axis] - size[axis] / 2.0  # who is past it, is out: steps may be longer than an exit
    begun = time.process_time()
    times = through(ground, rectangle(*room["goal"]), bodies, lambda p: p[:, axis] > line, Middles(), LONGEST_S)
    return times, time.process_time() - begun


def theirs(python: Path, worlds: list[dict[str, Any]]) -> dict[str, list[dict[str, Any]]]:
    """Return what each of JuPedSim's models found in the same worlds."""
    asked = [{"floor": [rectangle(*one).tolist() for one in room["floor"]], "goal": rectangle(*room["exit"]).tolist(),
              "places": room["places"].tolist(), "speeds": room["speeds"].tolist(), "radius": BODY_M,
              "longest_s": LONGEST_S} for room in worlds]  # fmt: skip
    done = subprocess.run([python, ORACLE], input=json.dumps(asked), capture_output=True, text=True, check=True)
    return dict(json.loads(done.stdout))


def main() -> None:
    """Walk, write the section."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("python", type=Path)
    parser.add_argument("--seeds", type=int, default=5)
    asked = parser.parse_args()
    worlds = rooms(asked.seeds)
    found = {"ours": [(*ours(room), 0) for room in worlds]}
    oracle = theirs(asked.python, worlds)
    found |= {name: [(one["times"], one["cpu_s"], one["refused"]) for one in rows] for name, rows in oracle.items()}
    names = list(dict.fromkeys(room["name"] for room in worlds))
    lines = [
        f"The same floors, people, speeds and radius of {BODY_M} m, mean of {asked.seeds} seeds; JuPedSim 1.4.2 with "
        "its own parameters otherwise, in an environment of its own. Doors: persons a metre and second (bar 1.3-2.0; "
        f"0: fewer than 130 of 160 were out in {LONGEST_S:.0f} s); corner "
        "(20 people) and corridor (120 people on its first 30 m of 60 x 4 m): seconds until the last has come.", "",
        f"| | {' | '.join(found)} |", "| --- |" + " --- |" * len(found),
    ]  # fmt: skip
    for name in names:
        row = []
        for rows in found.values():
            pairs = zip(rows, worlds, strict=True)
            own = [told(times, room, refused) for (times, _, refused), room in pairs if room["name"] == name]
            row.append(f"{np.mean(own):.2f}" if name.startswith("door") else f"{np.mean(own):.1f} s")
        lines.append(f"| {name} | {' | '.join(row)} |")
    lines.append(
        "| CPU s of all | " + " | ".join(f"{sum(spent for _, spent, _ in rows):.1f}" for rows in found.values()) + " |"
    )
    refused = max(sum(one["refused"] for one in rows) for rows in oracle.values())
    entered = sum(len(room["places"]) for room in worlds)
    lines += ["", f"JuPedSim refuses who begins nearer to others or to walls than it likes: {refused} of {entered}."]
    print("\n".join(lines))
    text = PAGE.read_text(encoding="utf-8").rstrip() + "\n"
    if TITLE in kept(PAGE):
        begin = text.index(f"## {TITLE}")
        end = text.find("\n## ", begin)
        text = text[:begin].rstrip() + "\n" + ("" if end < 0 else text[end:])
    PAGE.write_text(text.rstrip() + f"\n\n## {TITLE}\n\n" + "\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
