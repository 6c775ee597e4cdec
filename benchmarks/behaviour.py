"""Measure the walkers of ``cloner/behaviour``, write ``docs/behaviour_benchmark.md``: python benchmarks/behaviour.py.

Speed and density beside Weidmann, flow through doors, a corner, two streams against each other, distances of middles,
agent-steps a CPU second, digests of positions, and the museum of the sample scenario emptied in twenty seeds.
Nothing is read but the sample: no data set of pedestrians is shipped, Weidmann's three constants suffice.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from behaviour_worlds import (
    FREE,
    Middles,
    bodies_at,
    corner,
    door,
    elsewhere,
    hall,
    ring,
    streams,
    to_and_fro,
    whole,
)

from cloner.behaviour.ground import BODY_M, make_ground, rectangle
from cloner.behaviour.language import parse_scenario
from cloner.behaviour.loop import digest, run
from cloner.behaviour.walking import STEP_S, walk
from cloner.behaviour.world import make_world

PAGE = Path(__file__).resolve().parents[1] / "docs" / "behaviour_benchmark.md"
SAMPLE = Path(__file__).resolve().parents[1] / "samples" / "museum.crowd"


def weidmann(density: float) -> float:
    """Return the mean speed at a density, m/s."""
    return float(FREE * (1.0 - np.exp(-1.913 * (1.0 / density - 1.0 / 5.4))))


@dataclass
class Told:
    """Lines of the page."""

    lines: list[str] = field(default_factory=list)

    def say(self, *lines: str) -> None:
        for line in lines:
            print(line, flush=True)
            self.lines.append(line)


def speeds(told: Told, seeds: int) -> Iterator[Middles]:
    """Say speed at each density."""
    told.say(
        "",
        "## Speed and density",
        "",
        f"A corridor of 60 x 4 m whose ends are one, own speeds N(1.34, .26) m/s; mean of {seeds} seeds.",
        "",
        "| a square metre | m/s | Weidmann | off | at 90 % of their own | middles nearer than .30 m |",
        "| --- | --- | --- | --- | --- | --- |",
    )
    for density in (0.25, 0.5, 1.0, 1.5, 2.0, 3.0):
        middles = Middles()
        found = np.mean([ring(density, seed, middles)[:2] for seed in range(1, seeds + 1)], axis=0)
        want = weidmann(density)
        told.say(
            f"| {density} | {found[0]:.2f} | {want:.2f} | {100 * (found[0] / want - 1):+.0f} % | "
            f"{100 * found[1]:.0f} % | "
            f"{100 * middles.near / max(middles.pairs, 1):.2f} % (least {middles.least:.2f} m) |"
        )
        yield middles


def doors(told: Told, seeds: int) -> Iterator[Middles]:
    """Say the flow through each door."""
    told.say(
        "",
        "## Doors",
        "",
        f"160 people leave a room of 10 x 10 m; mean of {seeds} seeds. Bar 1.3-2.0 a metre and second.",
        "",
        "| door m | persons/(m s) | persons/s | middles nearer than .30 m |",
        "| --- | --- | --- | --- |",
    )
    for wide in (0.75, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0):
        middles = Middles()
        flow = float(np.mean([door(wide, seed, middles) for seed in range(1, seeds + 1)]))
        told.say(f"| {wide} | {flow:.2f} | {flow * wide:.2f} | {100 * middles.near / max(middles.pairs, 1):.2f} % |")
        yield middles


def two_streams(told: Told, seeds: int) -> Iterator[Middles]:
    """Say whether streams against each other get on."""
    middles = Middles()
    found = [streams(seed, middles) for seed in range(1, seeds + 1)]
    stuck = sum(one < 0.1 for one, _ in found)
    told.say(
        "",
        "## Two streams",
        "",
        f"120 people in 30 x 4 m, half each way, {seeds} seeds, after 50 s: {stuck} deadlocks (below .1 m/s), "
        f"speed along the own way {np.mean([a for a, _ in found]):.2f} m/s (least {min(a for a, _ in found):.2f}); "
        f"neighbours "
        f"before and behind go the same way: {np.mean([b for _, b in found]):+.2f} (0 mixed, 1 lanes). "
        f"Middles nearer than .30 m: "
        f"{100 * middles.near / middles.pairs:.3f} % of {middles.pairs} pairs, least {middles.least:.2f} m.",
    )
    yield middles


def corners(told: Told, seeds: int) -> Iterator[Middles]:
    """Say whether a corner is kept, and how long a straight corridor takes."""
    found = [corner(seed) for seed in range(1, seeds + 1)]
    told.say(
        "",
        "## Corner and corridor",
        "",
        f"20 people round a corner of a 2 m corridor, {seeds} seeds: {sum(n for n, _ in found)} of {20 * seeds} "
        f"came, least distance of a middle to a wall {min(one for _, one in found):.3f} m (a body has {BODY_M} m).",
    )
    ground = make_ground([rectangle((25.0, 1.0), (50.0, 2.0))])
    one = bodies_at(ground, np.array([[1.0, 1.0]]), np.array([1.33]))
    one.way[:, 0] = 1.0
    steps = 0
    while one.place[0, 0] < 41.0:
        walk(one)
        steps += 1
    told.say(f"One at 1.33 m/s needs {steps * STEP_S:.1f} s for 40 m (bar 26-34).")
    yield Middles()


def engine(told: Told, seeds: int) -> Iterator[Middles]:
    """Say how fast it is, and the digests."""
    told.say("", "## Speed of the engine", "", "One core, wasmtime, machine shared with other work.", "")
    for count, steps in ((1000, 200), (5000, 60)):
        rate, places = to_and_fro(hall(count)[0], steps)
        told.say(f"- {count} people, .25 a square metre, pillars: {rate / 1e3:.0f}k agent-steps a CPU second, "
                 f"{rate * STEP_S / count:.1f} x real time; places after {steps} steps `{places}`")  # fmt: skip
        rate = whole(count, steps)
        told.say(
            f"- {count} people of a scenario, minds too: {rate / 1e3:.0f}k, {rate * STEP_S / count:.1f} x real time"
        )
    here, found = elsewhere(2000)
    for host, (mean_ms, places) in found.items():
        same = "the same places" if places == here else "OTHER PLACES"
        told.say(
            f"- {host}, 1000 people of a scenario, minds too: {mean_ms:.2f} ms a step, mean of 2000, {same} as "
            f"Python (`{here}`)"
        )
    yield Middles()


def museum(told: Told, seeds: int) -> Iterator[Middles]:
    """Say how the sample scenario empties; the statue awakes after 10 s instead of 60, so that it takes less time."""
    text = SAMPLE.read_text(encoding="utf-8").replace("at 60 s", "at 10 s")
    took, happy, digests = [], [], []
    for seed in range(1, seeds + 1):
        world = make_world(parse_scenario(text), seed)
        names = [one.name for one in world.scenario.emotions]
        alone = world.people.home == 0
        happy.append(100.0 * float((world.people.emotion[alone] == names.index("happy")).mean()))
        for _ in run(world, 70.0):
            if world.time_s > 10.0 and (world.bodies.place[:, 1] < 0.0).all():
                break
        took.append(world.time_s - 10.0 if (world.bodies.place[:, 1] < 0.0).all() else np.inf)
        digests.append(digest(world))
    told.say(
        "",
        "## Museum",
        "",
        f"`samples/museum.crowd`, 100 people, {seeds} seeds: happy {min(happy):.0f}-{max(happy):.0f} % of visitors; "
        f"after the "
        f"statue awoke the last is out through 2.4 m after {min(took):.1f}-{max(took):.1f} s "
        f"({sum(one <= 40.0 for one in took)} of {seeds} "
        f"within 40 s). Digest of seed 1: `{digests[0]}`.",
    )
    yield Middles()


PARTS = {
    "speeds": speeds,
    "doors": doors,
    "corner": corners,
    "streams": two_streams,
    "engine": engine,
    "museum": museum,
}
HEADS = ("Speed and density", "Doors", "Corner and corridor", "Two streams", "Speed of the engine", "Museum")
SEEDS = {"speeds": 20, "doors": 20, "corner": 20, "streams": 20, "engine": 1, "museum": 20}


def kept(page: Path) -> dict[str, str]:
    """Return the sections of the page as it is."""
    text = page.read_text(encoding="utf-8") if page.is_file() else ""
    parts = text.split("\n## ")[1:]
    return {part.partition("\n")[0]: part.partition("\n")[2].strip() for part in parts}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", choices=PARTS, action="append", help="measure this part; the page keeps the others")
    parser.add_argument("--seeds", type=int, default=0, help="instead of each part's own number")
    parser.add_argument("--page", type=Path, default=PAGE)
    asked = parser.parse_args()
    sections = kept(asked.page)
    for (name, part), head in zip(PARTS.items(), HEADS, strict=True):
        if asked.only and name not in asked.only:
            continue
        told = Told()
        for _ in part(told, asked.seeds or SEEDS[name]):
            pass
        sections[head] = "\n".join(told.lines).strip().partition("\n")[2].strip()
    lines = [
        "# Behaviour",
        "",
        "Written by `benchmarks/behaviour.py`; the walkers of `cloner/behaviour`, one core.",
        "",
    ]
    for head in HEADS:
        if head in sections:
            lines += [f"## {head}", "", sections[head], ""]
    asked.page.write_text("\n".join(lines), encoding="utf-8")


if __name__ == "__main__":
    main()
