"""The commands ``cloner crowd check``, ``run`` and ``guide``."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Final

import numpy as np

from cloner.behaviour.guiding import HOST, RequestQueue, guided_steps, serve_guides
from cloner.behaviour.language import read_scenario
from cloner.behaviour.loop import digest, run
from cloner.behaviour.model import Scenario
from cloner.behaviour.plan import Plan
from cloner.behaviour.trajectories import Recorder, Trajectories, pack
from cloner.behaviour.walking import RATE_HZ
from cloner.behaviour.world import World, make_world
from cloner.errors import ClonerError
from cloner.exporters.shared.files import png_bytes, write_bytes
from cloner.pipeline import Progress, no_progress
from cloner.project.atomic import safe_output
from cloner.vision.photographs.films import FORMATS, write_film

#: Longer than an opening day.
LONGEST_S: Final = 86_400.0


def check_file(path: Path) -> list[str]:
    """Return the contents of a scenario, line by line.

    Raises
    ------
    ClonerError
        If it cannot be run: what it says, or a point that cannot be reached.
    """
    scenario = read_scenario(path)
    world = make_world(scenario)
    _check_reachable(world, path.name)
    floor = float((world.ground.clear > 0.0).sum()) * 0.04
    points = ", ".join(f"{one.name}{f' ({one.act})' if one.act else ''}" for one in scenario.points) or "none"
    lines = [
        f"{floor:.0f} m2 of floor, {len(scenario.obstacles)} obstacles; {scenario.people() / floor:.2f} people a m2"
    ]
    lines.append(f"points: {points}")
    if scenario.things:
        lines.append(f"things: {', '.join(one.name for one in scenario.things)}")
    for group in scenario.groups:
        kind = "people, each alone" if group.alone else "people"
        lines.append(f"{group.name}: {group.people} {kind}, {group.feelings.percent:g} % {group.feelings.emotion}")
    lines.append(f"{len(scenario.rules)} rules")
    return lines


def _check_reachable(world: World, where: str) -> None:
    """Refuse a scenario in which somebody cannot reach a requested place."""
    row, column = world.ground.cells(world.bodies.place)
    names = [one.name for one in world.places]
    asked = {names.index(point) for group in world.scenario.groups for point in group.visits}
    asked |= {names.index(act.what) for rule in world.scenario.rules for act in rule.actions if act.what in names}
    for number in sorted(asked):
        place = world.places[number]
        distance = world.distances(number)
        shut = np.flatnonzero(~np.isfinite(distance[row, column]))
        if len(shut):
            name = world.scenario.groups[int(world.people.home[shut[0]])].name
            raise ClonerError(f"{name} cannot reach {place.name}", "Open a way, at least half a metre wide", where)


def run_file(
    path: Path, out: Path, *, seconds: float, seed: int = 0, picture: Path | None = None, film: Path | None = None,
    progress: Progress = no_progress,
) -> list[str]:  # fmt: skip
    """Run a scenario, write trajectories and, if requested, a final still or a film; return a report.

    Raises
    ------
    ClonerError
        If the scenario, a number or a file is unfit.
    """
    if film is not None and film.suffix.lower() not in FORMATS:
        raise ClonerError(f"no film is written as {film.suffix or 'this'}", f"Give {', '.join(FORMATS)}", film.name)
    if picture is not None and picture.suffix.lower() != ".png":
        raise ClonerError("the picture is a PNG", "Give --picture a name that ends with .png", picture.name)
    for one in (picture, film):
        if one is not None:
            safe_output(one)
    world = _ready(path, out, seconds, seed)
    walk = recorded(world, seconds, progress)
    data = pack(walk)
    write_bytes(out, data)
    draw_files(world.scenario, walk, picture, film)
    spent = len(walk.place) / RATE_HZ * len(walk.groups)
    lines = [f"{when:.1f} s: {text}" for when, text in walk.told]
    lines.append(
        f"{len(walk.groups)} people, {seconds:g} s, {len(data) / 1e3:.0f} kB: "
        f"{len(data) / spent:.1f} bytes a person and second"
    )
    lines.append(f"digest {digest(world)} after {world.steps} steps with seed {seed}")
    return [*lines, *(str(one) for one in (out, picture, film) if one is not None)]


def guide_file(
    path: Path, out: Path, *, seconds: float, seed: int = 0, port: int = 0, report: Callable[[str], None],
) -> list[str]:  # fmt: skip
    """Run a scenario in real time while other programs guide it, and write trajectories; return a report.

    ``report`` gets the address and the token before the first step.

    Raises
    ------
    ClonerError
        As :func:`run_file`, and if no guide can be let in.
    """
    world = _ready(path, out, seconds, seed)
    desk, recorder = RequestQueue(), Recorder()
    recorder.record(world)
    with serve_guides(desk, port) as found:
        report(f"ws://{HOST}:{found}")
        report(f"token {desk.token}")
        for now in guided_steps(world, desk, seconds):
            recorder.record(now)
    walk = recorder.trajectories(world)
    write_bytes(out, pack(walk))
    lines = [f"{when:.1f} s: {text}" for when, text in walk.told]
    return [*lines, f"{len(walk.groups)} people, {world.time_s:g} s", str(out)]


def _ready(path: Path, out: Path, seconds: float, seed: int) -> World:
    """Return the world of a file at its beginning, its ways and the output checked."""
    if not (math.isfinite(seconds) and 0.0 < seconds <= LONGEST_S):
        raise ClonerError(f"{seconds:g} seconds cannot be run", "Give more than 0 and at most a day", "--seconds")
    safe_output(out)
    world = make_world(read_scenario(path), seed)
    _check_reachable(world, path.name)
    return world


def recorded(world: World, seconds: float, progress: Progress = no_progress) -> Trajectories:
    """Return the trajectories of a world over some seconds."""
    recorder = Recorder()
    recorder.record(world)
    for now in run(world, seconds):
        recorder.record(now)
        if now.steps % 100 == 0:
            progress("walking", min(now.time_s / seconds, 1.0))
    return recorder.trajectories(world)


def draw_files(scenario: Scenario, walk: Trajectories, picture: Path | None, film: Path | None) -> None:
    """Write the last moment as a picture and everything as a film, if requested."""
    plan = Plan(scenario)
    if picture is not None:
        write_bytes(picture, png_bytes(plan.draw(walk, len(walk.place) - 1)))
    if film is not None:
        try:
            film.parent.mkdir(parents=True, exist_ok=True)
            write_film(plan.film(walk), RATE_HZ, film)
        except OSError as error:
            raise ClonerError(
                "the film cannot be written", "Choose another folder or free some space", film.name
            ) from error
