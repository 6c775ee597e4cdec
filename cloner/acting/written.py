"""The command ``cloner crowd bake``: trajectories or a scenario, and a pack, become a pack whose page plays them."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.acting.blocks import obstacle_blocks
from cloner.acting.going_on import Continuation, make_continuation, with_guest
from cloner.acting.tracks import make_feet
from cloner.behaviour.feet import Motions, compute_footings
from cloner.behaviour.language import parse_scenario, read_scenario, scenario_text
from cloner.behaviour.trajectories import MAGIC, Trajectories, read_trajectories
from cloner.behaviour.walking import RATE_HZ
from cloner.behaviour.world import make_world
from cloner.behaviour.written import recorded
from cloner.crowd.drawing.player import ACTED_FILE, BODY_FILE, player_page
from cloner.crowd.packs.files import MARK, digest, pack_arrays, pack_folder
from cloner.crowd.packs.reading import read_casting, read_checked, read_facts, read_stock
from cloner.crowd.staged.footing import COLUMNS, Acted, touching_points
from cloner.crowd.staged.scene import ACTED, IDLE, WALK, Casting, Mulberry32, random_look, random_scale
from cloner.errors import ClonerError
from cloner.pipeline import Progress, no_progress
from cloner.untrusted import open_untrusted

#: A thousand take .4 ms of a page's frame (`docs/behaviour.md`); taste.
MOST_PEOPLE: Final = 5_000


@dataclass(frozen=True, slots=True)
class RoomParts:
    """A lit room for a pack: files by name, what ``crowd.json`` says of it, and where the page's eye stands in it.

    ``statues`` adds those that stand in the room to what is acted, and tells how they are staged.
    """

    files: Mapping[str, bytes]
    facts: Mapping[str, Any]
    views: Mapping[str, Any]
    statues: Callable[..., tuple[Acted, Mapping[str, Any]]] | None = None


@dataclass(frozen=True, slots=True)
class SpokenParts:
    """Speech of a pack: files by name, and their entry in ``crowd.json``."""

    files: Mapping[str, bytes]
    facts: Mapping[str, Any]


def bake_file(
    source: Path, pack: Path, out: Path, *, seconds: float = 60.0, seed: int = 0, room: RoomParts | None = None,
    progress: Progress = no_progress,
) -> list[str]:  # fmt: skip
    """Write a pack whose clones act out a file of trajectories, or a scenario; return a report.

    Parameters
    ----------
    source : Path
        What ``cloner crowd run`` wrote, or a scenario's text, which is run first.
    pack : Path
        What ``cloner crowd --feelings`` wrote.
    out : Path
        The new pack's folder.
    seconds, seed
        Of the run, for a scenario.
    room : RoomParts or None
        What stands around them, instead of plain blocks.

    Raises
    ------
    ClonerError
        If a file is unfit, there are too many people, or the disk refuses.
    """
    if out.resolve() == pack.resolve():
        raise ClonerError("the pack would be replaced by what is made of it", "Choose another --out folder", out.name)
    facts = read_facts(pack)
    walk, text = _simulate(source, seconds, seed, progress)
    if len(walk.groups) > MOST_PEOPLE:
        raise ClonerError(f"{len(walk.groups)} people are too many", f"Give at most {MOST_PEOPLE}", source.name)
    acted, lines = act_out(walk, pack, facts, progress)
    scenario = make_continuation(text, seed, acted, facts["people"][0]["clips"]) if text else None
    if room:
        acted = replace(acted, blocks=acted.blocks[:0])
    seconds = (len(walk.place) - 1) / RATE_HZ
    views = room.views if room else overview_cameras(walk.place.min(axis=(0, 1)), walk.place.max(axis=(0, 1)))
    staging = None
    if room and room.statues and "statues" in facts:
        acted, staging = room.statues(walk, acted, facts, pack, seconds)
    size = write_acted(pack, facts, out, acted, seconds, views, room, staging, scenario)
    many = int(walk.present.any(axis=0).sum())
    spent = max(many, 1) * max(seconds, 1.0 / RATE_HZ)
    lines.append(
        f"{many} people, {seconds:g} s, {len(acted.footings)} footings, "
        f"{size / 1e3:.0f} kB: {size / spent:.0f} bytes a person and second"
    )
    return [*lines, str(out / "player.html")]


def write_acted(
    pack: Path, facts: dict[str, Any], out: Path, acted: Acted, seconds: float, views: Mapping[str, Any],
    room: RoomParts | None = None, staging: Mapping[str, Any] | None = None, scenario: Continuation | None = None,
    spoken: SpokenParts | None = None,
) -> int:  # fmt: skip
    """Write a pack whose clones act into a folder of its own; return the bytes of the actions.

    Parameters
    ----------
    pack, facts
        Where the clones come from, and what is told there.
    out : Path
    acted : Acted
    seconds : how long
    views : eye and target of the page's views
    room, staging
        What stands around them, and how it is staged; see :mod:`cloner.crowd.staged.staging`.
    scenario : Continuation, optional
        By which it can go on for ever, in the page or served.
    spoken : SpokenParts, optional
        What they say.
    """
    arrays: dict[str, NDArray[Any]] = {
        "footings": acted.footings, "starts": acted.starts, "people": acted.people, "touches": acted.touches,
        "clips": acted.clips, "blocks": acted.blocks,
    }  # fmt: skip
    data, layout = pack_arrays(arrays)
    kept = {name: own for name, own in facts["files"].items() if name.startswith("people/") or name == BODY_FILE}
    files = {ACTED_FILE: data, **(room.files if room else {}), **(spoken.files if spoken else {}),
             **(scenario.files if scenario else {})}  # fmt: skip
    made = {key: value for key, value in facts.items() if key not in ("room", "staging", "scenario", "spoken")} | {
        "scene": ACTED, "people_count": len(acted.people),
        "files": kept | {name: digest(own) for name, own in files.items()},
        "acted": {"seconds": seconds, "people": len(acted.people), "arrays": layout, "views": dict(views)},
    }  # fmt: skip
    if scenario:
        made["scenario"] = scenario.facts
    if room:
        made["room"] = room.facts
    if staging:
        made["staging"] = staging
    if spoken:
        made["spoken"] = spoken.facts
    with pack_folder(out) as folder:
        for name in kept:
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes(read_checked(pack, name, facts))
        for name, own in files.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes(own)
        page = player_page(folder, made)
        made["player"] = {"sha256": digest(page), "bytes": len(page)}
        (folder / "player.html").write_bytes(page)
        (folder / MARK).write_text(json.dumps(made, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    return len(data)


def overview_cameras(low: NDArray[Any], high: NDArray[Any]) -> dict[str, list[list[float]]]:
    """Return the cameras of the page's three views of the people between two corners of the plan."""
    x, z, wide = (low[0] + high[0]) / 2.0, -(low[1] + high[1]) / 2.0, max(float((high - low).max()), 4.0)
    front = -float(low[1])
    views = {
        "overview": ((x, 0.3 * wide, front + 0.12 * wide), (x, 0.0, z + 0.1 * wide)),
        "near": ((x + 1.0, 1.7, z + 6.0), (x, 1.1, z)),
        "street": ((x, 1.7, front + 4.0), (x, 1.3, z)),
    }
    return {name: [[round(float(one), 3) for one in place] for place in pair] for name, pair in views.items()}


def thing_names(source: Path) -> tuple[str, ...]:
    """Return the names of the things in a file of trajectories or a scenario.

    Raises
    ------
    ClonerError
        As :func:`bake_file`.
    """
    if _holds_trajectories(source):
        return read_trajectories(source).things
    return tuple(str(one.name) for one in read_scenario(source).things)


def _holds_trajectories(source: Path) -> bool:
    try:
        with open_untrusted(source) as stream:
            return stream.read(len(MAGIC)) == MAGIC
    except OSError as error:
        hint = "Give what cloner crowd run wrote, or a scenario"
        raise ClonerError("there is nothing to bake", hint, source.name) from error


def _simulate(source: Path, seconds: float, seed: int, progress: Progress) -> tuple[Trajectories, str]:
    """Return the trajectories of a file, or those of a scenario that is run, and its text."""
    if _holds_trajectories(source):
        return read_trajectories(source), ""
    if not 0.0 < seconds <= 3600.0:
        raise ClonerError(f"{seconds:g} seconds cannot be baked", "Give more than 0 and at most an hour", "--seconds")
    text = with_guest(scenario_text(source), source.name)
    walk = recorded(make_world(parse_scenario(text, source.name), seed), seconds, progress)
    return walk, text


def act_out(
    walk: Trajectories, pack: Path, facts: dict[str, Any], progress: Progress = no_progress
) -> tuple[Acted, list[str]]:
    """Return trajectories as footings of a pack's clones, and a report."""
    held = read_stock(pack, facts)
    people = facts["people"]
    names = [clip["name"] for clip in people[0]["clips"]]
    if any([clip["name"] for clip in row["clips"]] != names for row in people) or names[:2] != ["walk", "idle"]:
        raise ClonerError("the pack's clones do not have the same walks", "Make it again with cloner crowd", pack.name)
    try:
        touches = np.stack(
            [touching_points(own, held.body, row["clips"]) for own, row in zip(held.numbers, people, strict=True)]
        )
    except (ValueError, LookupError) as error:
        hint = "Make it again with cloner crowd"
        raise ClonerError("the pack's frames do not fit what it says of them", hint, pack.name) from error
    clips = np.array([[[c["frames"], c["seconds"]] for c in row["clips"]] for row in people], np.float32)
    rows = _people(len(walk.groups), read_casting(facts))
    feet = make_feet(touches, clips, rows, people[0]["clips"])
    acts = np.array([feet.still.get(one, IDLE) for one in walk.acts])
    walks = np.array([feet.walks.get(one, WALK) for one in walk.walks])
    done = Motions(walk.place, walk.facing, walk.present, acts[walk.posture], walks[walk.emotion])
    found = compute_footings(done, feet, progress)
    starts = np.cumsum([0, *map(len, found)])
    missing = sorted({one for one in walk.walks if one != "regular" and f"walk_{one}" not in names})
    lines = [f"the pack has no walk of who is {', '.join(missing)}: make it with --feelings"] if missing else []
    footings, blocks = np.concatenate(found).reshape(-1, COLUMNS), obstacle_blocks(walk.obstacles, walk.things_at)
    return Acted(footings, starts.astype(np.uint32), rows, touches, clips, blocks), lines


def _people(count: int, casting: Casting) -> NDArray[np.float32]:
    """Return the rows of people by clone, size, phase and look; neighbours in number are different clones."""
    dice = Mulberry32(1)
    rows = np.zeros((count, 5, 4), np.float32)
    order: Sequence[int] = []
    for who in range(count):
        if who % casting.clones == 0:
            order = [k for _, k in sorted((dice.roll(), k) for k in range(casting.clones))]
        clone = order[who % casting.clones]
        scale, phase = random_scale(dice), dice.roll()
        donors, dyes = random_look(clone, casting, dice)
        rows[who, 1], rows[who, 2, :3], rows[who, 3] = (0.0, phase, clone, scale), donors, dyes
    return rows
