"""A film's lines compiled to footings of clones and keys of light and cameras."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, Final

import numpy as np

from cloner.acting.tracks import Track, footings_on_tracks, make_feet
from cloner.crowd.clones.stock import CrowdArrays
from cloner.crowd.staged.footing import COLUMNS, Acted, touching_points
from cloner.crowd.staged.scene import IDLE, PERSON_TEXELS, WALK, Mulberry32
from cloner.crowd.staged.staging import HEAD_MIDDLE, PLAIN
from cloner.errors import ClonerError
from cloner.pipeline import Progress, no_progress
from cloner.records.arrays import Array
from cloner.scenes.films.sequence import Actor, Key
from cloner.scenes.films.sequence import Sequence as Film

STEP_S: Final = 0.1  # as in files of trajectories (behaviour/trajectories.py)
#: A head that lies on the ground has its middle so high, metres, and leans by so much of a turn; taste.
LIES_M, LEANS = 0.095, 0.21
#: While a head is given: when it leaves the ground, when it is before the giver's face, when over the neck; shares.
TAKEN, LIFTED, OVER = 0.40, 0.66, 0.86
#: It is held so far before the giver, metres, and comes down on the neck from so far above.
HELD_M, ABOVE_M = 0.44, 0.10


def compile_film(
    film: Film, stock: CrowdArrays, people: Sequence[Mapping[str, Any]], progress: Progress = no_progress
) -> tuple[Acted, dict[str, Any]]:
    """Return the actions of a pack's clones in a film, and the staging.

    Parameters
    ----------
    film : Film
    stock : Stock
        Of :func:`cloner.crowd.packs.reading.read_stock`.
    people : rows of ``people`` in ``crowd.json``

    Raises
    ------
    ClonerError
        If the pack lacks a clone, the walks of feelings, or statues that the film wants.
    """
    names = [clip["name"] for clip in people[0]["clips"]]
    if any(one.stone for one in film.actors) and stock.stones is None:
        hint = "Make it with cloner crowd --statues stone"
        raise ClonerError("nobody in the pack can be a statue", hint, "the film")
    missing = sorted({order.word for order in film.orders if order.kind == "does"} - {*names, "stand"})
    if missing:
        hint = "Make it with cloner crowd --feelings"
        raise ClonerError(f"nobody in the pack knows how to {missing[0]}", hint, "the film")
    clones = _clones(film.actors, [str(row["id"]) for row in people])
    touches = np.stack(
        [touching_points(own, stock.body, row["clips"]) for own, row in zip(stock.numbers, people, strict=True)]
    )
    clips = np.array([[[c["frames"], c["seconds"]] for c in row["clips"]] for row in people], np.float32)
    speeds = np.array([[c["speed_m_s"] for c in row["clips"]] for row in people])
    statures = [float(row["stature_m"]) for row in people]
    dice = Mulberry32(1)
    tracks: list[Track] = []
    heads = [k for k, one in enumerate(film.actors) if one.head_at is not None]
    rows = np.zeros((len(film.actors) + len(heads), PERSON_TEXELS, 4), np.float32)
    for who, actor in enumerate(film.actors):
        clone = clones[who]
        track = _track(film, who, actor, names, speeds[clone], tracks)
        tracks.append(track)
        rows[who, 1], rows[who, 2, :3], rows[who, 3] = (0.0, dice.roll(), clone, 1.0), clone, -1.0
    feet = make_feet(touches, clips, rows[: len(film.actors)], people[0]["clips"])
    found = footings_on_tracks(tracks, feet, progress)
    for k, body in enumerate(heads):
        rows[len(film.actors) + k] = rows[body]
        found.append(found[body][:1].copy())
        found[-1][0, 1] = film.seconds + 1.0
    starts = np.cumsum([0, *map(len, found)]).astype(np.uint32)
    acted = Acted(np.concatenate(found).reshape(-1, COLUMNS), starts, rows, touches, clips)
    middles = [HEAD_MIDDLE * statures[clones[one]] for one in range(len(film.actors))]
    return acted, _staging(film, tracks, heads, middles)


def _clones(actors: Sequence[Actor], known: Sequence[str]) -> list[int]:
    """Return each actor's clone; actors without a given clone take random ones in turn."""
    dice, found = Mulberry32(7), []
    order: list[int] = []
    for actor in actors:
        if actor.clone:
            if actor.clone not in known:
                hint = f"The pack has {', '.join(known[:8])}"
                raise ClonerError(f"no clone is named {actor.clone}", hint, f"actor {actor.name}")
            found.append(known.index(actor.clone))
            continue
        if not order:
            order = [k for _, k in sorted((dice.roll(), k) for k in range(len(known)))]
        found.append(order.pop())
    return found


def _clip(names: Sequence[str], name: str, otherwise: int) -> int:
    return names.index(name) if name in names else otherwise


def _track(film: Film, who: int, actor: Actor, names: Sequence[str], speeds: Array, before: Sequence[Track]) -> Track:
    """Return a person's position, heading and act, ten times a second; later actors are visible from their start."""
    count = int(np.ceil(film.seconds / STEP_S)) + 2
    places, headings = np.zeros((count, 2)), np.zeros(count)
    acts, walks = np.full(count, IDLE), np.full(count, WALK)
    orders = sorted((one for one in film.orders if who in one.actors), key=lambda one: one.when)
    at, heading, goal = np.array([actor.at[0], -actor.at[1]]), _heading(actor.facing_deg), None
    walk, act, until, speed, faces = WALK, IDLE, 0.0, 0.0, -1
    for k in range(count):
        now = k * STEP_S
        while orders and orders[0].when <= now + 1e-9:
            order = orders.pop(0)
            if order.kind == "does":
                act, until = _clip(names, order.word, IDLE), now + order.seconds
            elif order.kind == "feels":
                walk = _clip(names, f"walk_{order.word}", WALK)
            elif order.kind == "turns":
                faces = order.who
                if faces < 0:
                    heading = _heading_to(at, np.array([order.to[0], -order.to[1]]), heading)
            else:
                goal = np.array([order.to[0], -order.to[1]]) + (at if order.kind.endswith("by") else 0.0)
                walk, faces = _clip(names, f"walk_{order.word}", WALK), -1
                speed = speeds[_clip(names, "run", walk) if order.kind.startswith("runs") else walk]
        if goal is not None:
            left = goal - at
            far = float(np.hypot(*left))
            heading = _heading_to(at, goal, heading)
            at = at + left * min(speed * STEP_S / max(far, 1e-9), 1.0)
            goal = None if far <= speed * STEP_S else goal
        elif faces >= 0:
            other = film.actors[faces].at if faces >= len(before) else None
            seen = np.array([other[0], -other[1]]) if other else before[faces].places_m[min(k, count - 1)]
            heading = _heading_to(at, seen, heading)
        places[k], headings[k], walks[k] = at, heading, walk
        acts[k] = act if now < until else IDLE
    return Track(np.arange(count, dtype=np.float64) * STEP_S, places, headings, acts, walks)


def _heading(facing_deg: float) -> float:
    turn = np.radians(facing_deg)
    return float(np.arctan2(np.sin(turn), -np.cos(turn)))


def _heading_to(at: Array, goal: Array, otherwise: float) -> float:
    away = goal - at
    return float(np.arctan2(away[0], away[1])) if np.hypot(*away) > 0.05 else otherwise


def _staging(film: Film, tracks: Sequence[Track], heads: Sequence[int], middles: Sequence[float]) -> dict[str, Any]:
    """Return the keys of :mod:`cloner.crowd.staged.staging`."""
    keys = sorted(film.keys, key=lambda one: one.when)
    data: dict[str, Any] = {name: list(value) for name, value in PLAIN.items()}
    for name in ("light", "stars", "stops", "lantern"):
        data[name] = _line([one for one in keys if one.kind == name], tuple(PLAIN[name][0][1:]))
    data["lantern"] = [[t, x, h, -y, *light] for t, x, y, h, *light in data["lantern"]]
    curtain = [one for one in keys if one.kind == "curtain"]
    data["curtain"] = _line(curtain, (0.0 if curtain and curtain[0].values[0] else 1.0,))
    data["captions"] = [[first, last, text] for first, last, text in film.captions]
    data["shots"] = _shots(keys)
    for who, actor in enumerate(film.actors):
        own = [one for one in keys if who in one.actors]
        stone, up = ([one for one in own if one.kind == name] for name in ("stone", "up"))
        if actor.stone or stone:
            data["stone"].append([who, _line(stone, (1.0 if actor.stone else 0.0,))])
        if actor.up or up:
            data["up"].append([who, _line(up, (actor.up,))])
        wakes = next((one.when for one in stone if not one.values[0]), film.seconds)
        if actor.stone:
            data["wakes"].append([who, wakes])
        hardens = next(
            (one.when + one.seconds for one in stone if one.values[0] and one.when > wakes * actor.stone), None
        )
        if hardens is not None:
            data["hardens"].append([who, hardens])
    data["heads"] = [_head(film, k, body, tracks, middles) for k, body in enumerate(heads)]
    return data


def _line(keys: Sequence[Key], begin: tuple[float, ...]) -> list[list[float]]:
    """Return keys that hold between changes; a change that begins during another starts from its end value."""
    rows, held = [[0.0, *begin]], list(begin)
    for one in keys:
        rows += [[max(one.when, rows[-1][0]), *held], [max(one.when + one.seconds, rows[-1][0]), *one.values]]
        held = list(one.values)
    return rows


def _shots(keys: Sequence[Key]) -> list[list[list[float]]]:
    """Return the keys of each cut: time, eye, target, followed person or -1, field of view."""
    shots: list[list[list[float]]] = []
    for one in keys:
        if one.kind not in ("camera", "moves"):
            continue
        x, y, up, look_x, look_y, look_up, lens = one.values
        row = [x, up, -y, look_x, look_up, -look_y, float(one.who), lens]
        if one.kind == "camera":
            shots.append([[one.when, *row]])
        else:
            held = shots[-1][-1][1:]
            begin = max(one.when, shots[-1][-1][0])
            shots[-1] += [[begin, *held], [max(one.when + one.seconds, begin), *row]]
    return shots


def _head(film: Film, k: int, body: int, tracks: Sequence[Track], middles: Sequence[float]) -> dict[str, Any]:
    """Return a head's path: x, height, z, heading, lean; from the ground over the holder's hands to its neck."""
    actor = film.actors[body]
    x, y = actor.head_at or (0.0, 0.0)
    ground = [x, LIES_M, -y, _heading(actor.facing_deg) + 0.9, LEANS]
    data: dict[str, Any] = {
        "who": len(film.actors) + k,
        "of": body,
        "path": [[0.0, *ground]],
        "until": film.seconds + 9.0,
    }
    given = next((one for one in film.heads if one[2] == body), None)
    if given is None:
        return data
    when, giver, _, seconds = given
    track = tracks[giver]
    row = track.row(when + LIFTED * seconds)
    heading, own = track.headings[row], _heading(actor.facing_deg)
    ahead = np.array([np.sin(heading), np.cos(heading)])
    held = track.places_m[row] + HELD_M * ahead
    neck = tracks[body].places_m[tracks[body].row(when + seconds)]
    over, up = middles[body] + ABOVE_M, middles[giver] - 0.16
    turn = heading + (np.angle(np.exp(1j * (own - heading))))
    data["path"] += [
        [when + TAKEN * seconds, *ground],
        [when + LIFTED * seconds, held[0], up, held[1], turn, 0.0],
        [when + OVER * seconds, neck[0], over + actor.up, neck[1], own, 0.0],
        [when + seconds, neck[0], middles[body] + actor.up, neck[1], own, 0.0],
    ]
    data["until"] = when + seconds
    return data


def add_statues(
    acted: Acted, stock: CrowdArrays, statues: Sequence[tuple[float, float, float, float, float]], seconds: float
) -> tuple[Acted, dict[str, Any]]:
    """Return the actions with statues added on things of a room, and the staging.

    Parameters
    ----------
    acted : Acted
    stock : Stock
        Of a pack with statues.
    statues : sequence of (x, z, height, heading, seconds until it awakens)
        Metres, in the page's frame; radians.
    seconds : how long is acted
    """
    rows, footings, starts = [acted.people], [acted.footings], acted.starts.tolist()
    data: dict[str, Any] = {name: list(value) for name, value in PLAIN.items()}
    for k, (x, z, up, heading, told_s) in enumerate(statues):
        wakes = min(told_s, seconds)  # who never does is seen as at the end
        clone, who = k % len(stock.numbers), len(acted.people) + k
        row = np.zeros((1, PERSON_TEXELS, 4), np.float32)
        row[0, 1], row[0, 2, :3], row[0, 3] = (0.0, 0.37, clone, 1.0), clone, -1.0
        rows.append(row)
        footings.append(
            np.array([[0.0, seconds + 1.0, IDLE, -1.0, 0.37, -1.0, x, z, x, z, heading, heading, WALK]], np.float32)
        )
        starts.append(starts[-1] + 1)
        data["stone"].append([who, [[0.0, 1.0], [told_s, 1.0], [told_s + AWAKENS_S, 0.0]]])
        data["up"].append([who, [[0.0, up]]])
        data["wakes"].append([who, wakes])
    both = replace(
        acted, people=np.concatenate(rows), footings=np.concatenate(footings), starts=np.array(starts, np.uint32)
    )
    return both, data


#: A statue of a scenario comes alive in this time, seconds; taste.
AWAKENS_S: Final = 4.0
