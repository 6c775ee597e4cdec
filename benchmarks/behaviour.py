"""Measure the walkers of ``cloner/behaviour``, write ``docs/behaviour_benchmark.md``: python benchmarks/behaviour.py.

Speed and density beside Weidmann, flow through doors, a corner, two streams against each other, distances of middles,
agent-steps a CPU second, digests of positions, and the museum of the sample scenario emptied in twenty seeds.
Nothing is read but the sample: no data set of pedestrians is shipped, Weidmann's three constants suffice.
"""

from __future__ import annotations

import argparse
import hashlib
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from cloner.behaviour import dice, fields
from cloner.behaviour.ground import BODY_M, Ground, box, ground_of
from cloner.behaviour.language import read_text
from cloner.behaviour.loop import digest, run
from cloner.behaviour.walking import GIVEN, STEP_S, Bodies, bodies_on, walk
from cloner.behaviour.world import world_of

PAGE = Path(__file__).resolve().parents[1] / "docs" / "behaviour_benchmark.md"
SAMPLE = Path(__file__).resolve().parents[1] / "samples" / "museum.crowd"
FREE, SPREAD = 1.34, 0.26  # m/s, Weidmann 1993
WARM_S = 10.0
TOO_NEAR_M = 0.30


def weidmann(density: float) -> float:
    """Return the mean speed at a density, m/s."""
    return float(FREE * (1.0 - np.exp(-1.913 * (1.0 / density - 1.0 / 5.4))))


def own_speeds(seed: int, count: int) -> np.ndarray:
    return np.clip(FREE + SPREAD * dice.normal(seed, 2, np.arange(count)), 0.6, 2.1)


def bodies_at(ground: Ground, place: np.ndarray, speed: np.ndarray, **others: float) -> Bodies:
    """Return people who walk as they are told, or, with a place to go to, into its region."""
    bodies = bodies_on(ground, place, **others)
    bodies.wants[:], bodies.goal[:] = speed, 0 if others.get("places") else GIVEN
    return bodies


def wrapped(dx: np.ndarray, period_m: float) -> np.ndarray:
    """Return differences along x in a world that repeats, the shorter way round."""
    return dx - period_m * np.floor(dx / period_m + 0.5)


def lattice(seed: int, count: int, low: tuple[float, float], high: tuple[float, float]) -> np.ndarray:
    """Return shaken places in a box."""
    w, h = high[0] - low[0], high[1] - low[1]
    rows = max(1, round(float(np.sqrt(count * h / w))))
    cols = int(np.ceil(count / rows))
    k = np.arange(count)
    x = low[0] + (k // rows + 0.5 + 0.4 * (dice.uniform(seed, 1, k) - 0.5)) * w / cols
    y = low[1] + (k % rows + 0.5 + 0.4 * (dice.uniform(seed, 3, k) - 0.5)) * h / rows
    return np.stack([x, y], axis=1)


@dataclass
class Middles:
    """Counts pairs of which each is the other's near one, and those whose middles are too near."""

    pairs: int = 0
    near: int = 0
    least: float = np.inf

    def look(self, bodies: Bodies, period_m: float = 0.0) -> None:
        place = bodies.place[bodies.present]
        dx = place[:, None, 0] - place[None, :, 0]
        dy = place[:, None, 1] - place[None, :, 1]
        dx = wrapped(dx, period_m) if period_m else dx
        away = np.sqrt(dx * dx + dy * dy)[np.triu_indices(len(place), 1)]
        away = away[away < 1.0]  # far pairs would only make the share look better
        self.pairs += len(away)
        self.near += int((away < TOO_NEAR_M).sum())
        self.least = min(self.least, float(away.min(initial=np.inf)))


@dataclass
class Told:
    """Lines of the page."""

    lines: list[str] = field(default_factory=list)

    def say(self, *lines: str) -> None:
        for line in lines:
            print(line, flush=True)
            self.lines.append(line)


def ring(density: float, seed: int, middles: Middles, seconds: float = 30.0) -> tuple[float, float, float]:
    """Return mean speed, share of people at 90 % of their own speed, and CPU seconds, in a corridor of 60 x 4 m."""
    length, wide = 60.0, 4.0
    ground = ground_of([box((length / 2, wide / 2), (length + 16.0, wide))])
    count = round(density * length * wide)
    speed = own_speeds(seed, count)
    bodies = bodies_at(ground, lattice(seed, count, (0.0, 0.3), (length, wide - 0.3)), speed, period_m=length)
    bodies.way[:, 0] = 1.0
    bodies.velocity[:, 0] = speed / 2
    went = np.zeros(count)
    begun, steps = time.process_time(), int(seconds / STEP_S)
    for k in range(steps):
        before = bodies.place[:, 0].copy()
        walk(bodies)
        if k * STEP_S >= WARM_S:
            went += wrapped(bodies.place[:, 0] - before, length)
        if k % 40 == 0:
            middles.look(bodies, length)
    spent = time.process_time() - begun
    mean = went / (seconds - WARM_S)
    return float(mean.mean()), float((mean > 0.9 * speed).mean()), spent


def lead(bodies: Bodies, ground: Ground, place: int, goal: np.ndarray) -> None:
    ways = fields.directions(ground, fields.distances(ground, goal))
    bodies.lead(place, ways, fields.region_cells(ground, goal))


def through(
    ground: Ground, goal: np.ndarray, bodies: Bodies, done: Callable[[np.ndarray], np.ndarray], middles: Middles,
    longest_s: float,
) -> list[float]:  # fmt: skip
    """Return when each person was done; who is, leaves the world."""
    lead(bodies, ground, 0, goal)
    times: list[float] = []
    for k in range(int(longest_s / STEP_S)):
        walk(bodies)
        gone = bodies.present & done(bodies.place)
        times += [(k + 1) * STEP_S] * int(gone.sum())
        bodies.present &= ~gone
        if k % 20 == 0 and bodies.present.sum() > 1:
            middles.look(bodies)
        if not bodies.present.any():
            break
    return times


def door(wide: float, seed: int, middles: Middles) -> float:
    """Return the flow through a door, persons a metre and second, from the 30th to the 130th of 160 people."""
    ground = ground_of([box((5.0, 5.0), (10.0, 10.0)), box((10.1, 5.0), (0.4, wide)), box((13.2, 5.0), (6.0, 10.0))])
    bodies = bodies_at(ground, lattice(seed, 160, (2.0, 0.5), (9.0, 9.5)), own_speeds(seed, 160), places=1)
    times = through(ground, box((15.2, 5.0), (1.8, 9.0)), bodies, lambda p: p[:, 0] > 10.2, middles, 300.0)
    return 100.0 / (times[129] - times[29]) / wide if len(times) >= 130 else 0.0


def corner(seed: int) -> tuple[int, float]:
    """Return how many of twenty people came round a corner of a 2 m corridor, and the least distance to a wall."""
    ground = ground_of([box((6.0, 1.0), (12.0, 2.0)), box((11.0, 6.0), (2.0, 12.0))])
    bodies = bodies_at(ground, lattice(seed, 20, (0.3, 0.3), (6.0, 1.7)), own_speeds(seed, 20), places=1)
    least = [np.inf]

    def done(place: np.ndarray) -> np.ndarray:
        for wall in ground.walls:
            along = wall[2:] - wall[:2]
            share = np.clip((place - wall[:2]) @ along / (along @ along), 0.0, 1.0)[:, None]
            away = np.linalg.norm(place - wall[:2] - share * along, axis=1)
            least[0] = min(least[0], float(away[bodies.present].min(initial=np.inf)))
        return place[:, 1] > 11.0

    return len(through(ground, box((11.0, 11.5), (1.8, 0.8)), bodies, done, Middles(), 60.0)), least[0]


def streams(seed: int, middles: Middles, density: float = 1.0) -> tuple[float, float]:
    """Return the mean speed along the own way in the last ten of 60 s, and how far lanes have formed, -1..1."""
    length, wide = 30.0, 4.0
    ground = ground_of([box((length / 2, wide / 2), (length + 16.0, wide))])
    count = round(density * length * wide)
    speed = own_speeds(seed, count)
    bodies = bodies_at(ground, lattice(seed, count, (0.0, 0.3), (length, wide - 0.3)), speed, period_m=length)
    sign = np.where(dice.uniform(seed, 9, np.arange(count)) < 0.5, 1.0, -1.0)
    bodies.way[:, 0] = sign
    went = 0.0
    for k in range(int(60.0 / STEP_S)):
        before = bodies.place[:, 0].copy()
        walk(bodies)
        if k * STEP_S >= 50.0:
            went += float((wrapped(bodies.place[:, 0] - before, length) * sign).mean())
        if k % 40 == 0:
            middles.look(bodies, length)
    dx = wrapped(bodies.place[:, None, 0] - bodies.place[None, :, 0], length)
    near = (np.abs(dx) < 2.0) & (np.abs(bodies.place[:, None, 1] - bodies.place[None, :, 1]) < 0.35)
    np.fill_diagonal(near, False)
    return went / 10.0, float((sign[:, None] * sign[None, :])[near].mean())


def hall(count: int, steps: int) -> tuple[float, str]:
    """Return agent-steps a CPU second and the digest of places, at .25 a square metre with a pillar each 10 m."""
    length = float(np.sqrt(count / 0.25))
    posts = np.arange(5.0, length, 10.0)
    ground = ground_of(
        [box((length / 2, length / 2), (length, length))], [box((x, y), (1, 1)) for x in posts for y in posts]
    )
    mid, far = length / 2, length - 1.5
    goals = [box((mid, 1.5), (length - 4, 2)), box((mid, far), (length - 4, 2)),
             box((1.5, mid), (2, length - 4)), box((far, mid), (2, length - 4))]  # fmt: skip
    who = np.arange(count * 2)
    place = np.stack([1 + dice.uniform(1, 1, who) * (length - 2), 1 + dice.uniform(1, 2, who) * (length - 2)], axis=1)
    bodies = bodies_at(ground, place[ground.stands(place)][:count], own_speeds(1, count), places=4)
    for number, one in enumerate(goals):
        lead(bodies, ground, number, one)
    bodies.goal[:] = np.arange(count) % 4
    begun = time.process_time()
    for _ in range(steps):
        walk(bodies)
        there = (bodies.way == 0.0).all(axis=1)
        bodies.goal[there] ^= 1
    return count * steps / (time.process_time() - begun), hashlib.sha256(bodies.place.tobytes()).hexdigest()[:16]


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
    ground = ground_of([box((25.0, 1.0), (50.0, 2.0))])
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
        rate, digest = hall(count, steps)
        told.say(f"- {count} people, .25 a square metre, pillars: {rate / 1e3:.0f}k agent-steps a CPU second, "
                 f"{rate * STEP_S / count:.1f} x real time; places after {steps} steps `{digest}`")  # fmt: skip
    yield Middles()


def museum(told: Told, seeds: int) -> Iterator[Middles]:
    """Say how the sample scenario empties; the statue awakes after 10 s instead of 60, so that it takes less time."""
    text = SAMPLE.read_text(encoding="utf-8").replace("at 60 s", "at 10 s")
    took, happy, digests = [], [], []
    for seed in range(1, seeds + 1):
        world = world_of(read_text(text), seed)
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
SEEDS = {"speeds": 3, "doors": 2, "corner": 5, "streams": 20, "engine": 1, "museum": 20}


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
