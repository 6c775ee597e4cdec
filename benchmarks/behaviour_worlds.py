"""The worlds of the pedestrian tests, ring, door, corner, streams, hall; ``benchmarks/behaviour.py`` tells of them."""

from __future__ import annotations

import hashlib
import shutil
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from cloner.behaviour import dice
from cloner.behaviour.ground import Ground, make_ground, rectangle
from cloner.behaviour.language import parse_scenario
from cloner.behaviour.loop import digest, step
from cloner.behaviour.walking import GIVEN, STEP_S, Bodies, make_bodies, walk
from cloner.behaviour.world import World, make_world

FREE, SPREAD = 1.34, 0.26  # m/s, Weidmann 1993
WARM_S = 10.0
TOO_NEAR_M = 0.30


def own_speeds(seed: int, count: int) -> np.ndarray:
    return np.clip(FREE + SPREAD * dice.normal(seed, 2, np.arange(count)), 0.6, 2.1)


def bodies_at(ground: Ground, place: np.ndarray, speed: np.ndarray, **others: float) -> Bodies:
    """Return people who walk as they are told, or, with a place to go to, into its region."""
    bodies = make_bodies(ground, place, **others)
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


def ring(density: float, seed: int, middles: Middles, seconds: float = 30.0) -> tuple[float, float, float]:
    """Return mean speed, share of people at 90 % of their own speed, and CPU seconds, in a corridor of 60 x 4 m."""
    length, wide = 60.0, 4.0
    ground = make_ground([rectangle((length / 2, wide / 2), (length + 16.0, wide))])
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
    bodies.lead(place, ground.region(goal))


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
    ground = make_ground(
        [rectangle((5.0, 5.0), (10.0, 10.0)), rectangle((10.1, 5.0), (0.4, wide)), rectangle((13.2, 5.0), (6.0, 10.0))]
    )
    bodies = bodies_at(ground, lattice(seed, 160, (2.0, 0.5), (9.0, 9.5)), own_speeds(seed, 160), places=1)
    times = through(ground, rectangle((15.2, 5.0), (1.8, 9.0)), bodies, lambda p: p[:, 0] > 10.2, middles, 300.0)
    return 100.0 / (times[129] - times[29]) / wide if len(times) >= 130 else 0.0


def corner(seed: int) -> tuple[int, float]:
    """Return how many of twenty people came round a corner of a 2 m corridor, and the least distance to a wall."""
    ground = make_ground([rectangle((6.0, 1.0), (12.0, 2.0)), rectangle((11.0, 6.0), (2.0, 12.0))])
    bodies = bodies_at(ground, lattice(seed, 20, (0.3, 0.3), (6.0, 1.7)), own_speeds(seed, 20), places=1)
    least = [np.inf]

    def done(place: np.ndarray) -> np.ndarray:
        for wall in ground.walls:
            along = wall[2:] - wall[:2]
            share = np.clip((place - wall[:2]) @ along / (along @ along), 0.0, 1.0)[:, None]
            away = np.linalg.norm(place - wall[:2] - share * along, axis=1)
            least[0] = min(least[0], float(away[bodies.present].min(initial=np.inf)))
        return place[:, 1] > 11.0

    return len(through(ground, rectangle((11.0, 11.5), (1.8, 0.8)), bodies, done, Middles(), 60.0)), least[0]


def streams(seed: int, middles: Middles, density: float = 1.0) -> tuple[float, float]:
    """Return the mean speed along the own way in the last ten of 60 s, and how far lanes have formed, -1..1."""
    length, wide = 30.0, 4.0
    ground = make_ground([rectangle((length / 2, wide / 2), (length + 16.0, wide))])
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


def hall(count: int) -> tuple[Bodies, Ground]:
    """Return people in a hall, .25 a square metre, with a pillar each 10 m and four sides to go to."""
    length = float(np.sqrt(count / 0.25))
    posts = np.arange(5.0, length, 10.0)
    ground = make_ground(
        [rectangle((length / 2, length / 2), (length, length))],
        [rectangle((x, y), (1, 1)) for x in posts for y in posts],
    )
    mid, far = length / 2, length - 1.5
    goals = [rectangle((mid, 1.5), (length - 4, 2)), rectangle((mid, far), (length - 4, 2)),
             rectangle((1.5, mid), (2, length - 4)), rectangle((far, mid), (2, length - 4))]  # fmt: skip
    who = np.arange(count * 2)
    place = np.stack([1 + dice.uniform(1, 1, who) * (length - 2), 1 + dice.uniform(1, 2, who) * (length - 2)], axis=1)
    bodies = bodies_at(ground, place[ground.is_free(place)][:count], own_speeds(1, count), places=4)
    for number, one in enumerate(goals):
        lead(bodies, ground, number, one)
    bodies.goal[:] = np.arange(count) % 4
    return bodies, ground


def to_and_fro(bodies: Bodies, steps: int) -> tuple[float, str]:
    """Return agent-steps a CPU second and the digest of places; who has come to a side goes to the one across."""
    begun = time.process_time()
    for _ in range(steps):
        walk(bodies)
        there = (bodies.way == 0.0).all(axis=1)
        bodies.goal[there] ^= 1
    rate = len(bodies.place) * steps / (time.process_time() - begun)
    return rate, hashlib.sha256(bodies.place.tobytes()).hexdigest()[:16]


def scenario(count: int) -> World:
    """Return a scenario in the same hall, minds too: all to a side and back again."""
    side = int(np.sqrt(count / 0.25))
    far, mid, wide = side - 2, side / 2, side - 6
    posts = "".join(
        f"obstacle post{x}_{y} at {x}, {y} size 1 x 1\n" for x in range(5, side, 10) for y in range(5, side, 10)
    )
    text = (
        f"floor 0, 0 to {side}, {side}\n{posts}"
        f"point south at {mid}, 2 region {wide} x 2\npoint north at {mid}, {far} region {wide} x 2\n"
        f"point west at 2, {mid} region 2 x {wide}\npoint east at {far}, {mid} region 2 x {wide}\n"
    )
    for number, ways in enumerate(("south > north", "north > south", "west > east", "east > west")):
        text += f"crowd {count // 4} crowd{number}: visits {ways} again, adapts to space\n"
    return make_world(parse_scenario(text), 1)


def whole(count: int, steps: int) -> float:
    """Return agent-steps a CPU second of a scenario."""
    world = scenario(count)
    step(world)  # ways and spots are found
    begun = time.process_time()
    for _ in range(steps):
        step(world)
    return count * steps / (time.process_time() - begun)


def elsewhere(steps: int) -> tuple[str, dict[str, tuple[float, str]]]:
    """Return the digest of a scenario of 1,000 people here, and of node and Chromium milliseconds a step and digest."""
    sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))
    from kit.browser import CHROMIUM, browser
    from kit.engine_log import in_node, kept_places, log_of, page

    world = scenario(1000)
    log, found = log_of(world, steps, steps), {}
    for _ in range(steps):
        step(world)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        hosts = {"node": in_node(log, folder)} if shutil.which("node") else {}
        (folder / "engine.html").write_text(page(log), encoding="utf-8")
        if CHROMIUM:
            with browser(folder / "profile") as shown:
                shown.open(folder / "engine.html")
                shown.wait_for("typeof LOG === 'object'")
                hosts["Chromium"] = shown.value("play(LOG)")
        for host, told in hosts.items():
            found[host] = told["mean_ms"], hashlib.sha256(kept_places(told)[-1]).hexdigest()[:16]
    return digest(world), found
