"""Footings: contacts of feet over time, so that playback never slides a foot.

A footing is the time in which one foot carries: a step, half a step to begin or to end walking, a turn on the spot, or
standing. In between two frames the body moves just so that the point of the sole that touches keeps its place: that
holds for turned bodies, for steps of any length (a walk blended with standing) and at any speed. ``web/footing.js``
does the same, number for number.

References
----------
M. Gleicher, Motion path editing, 2001 (what slides when captured walks are bent); the rest is ours.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.crowd.clones.cast import skin_vertices
from cloner.crowd.clones.clips import WALK_FRAMES
from cloner.crowd.clones.levels import BodyLevels
from cloner.crowd.clones.stock import BONE_FULL, BONE_REACH_M, BOX_MIN_M, BOX_STEP_M, CloneArrays
from cloner.crowd.staged.scene import IDLE
from cloner.easing import smoothstep
from cloner.generic.load import load_generic
from cloner.records.arrays import Array

#: Columns of a footing: seconds from, until; clip; frame of the idle that it is blended with, or -1 less the walk that
#: it goes over from; first and last frame; shares of the clip there (the rest is the idle); where the body is at first,
#: metres; headings at first and last, radians. Who stands has instead, from the fourth on: clip blended from (-1:
#: none); phase of the own at first; -1 less the frame blended from; x and z where the body was in that one. Last: as
#: which walk one feels.
FROM, UNTIL, CLIP, OTHER, FIRST, LAST, SHARE, SHARE_LAST, X, Z, HEADING, HEADING_LAST, FEELS = range(13)
COLUMNS: Final = 13
#: A face goes over from one feeling to another in this time, seconds; taste.
FEELS_S: Final = 0.6
#: Frames of a walk: the left foot carries from `LEFT` on, the right one from `RIGHT` on; each shares the ground
#: with the other until `ALONE` frames later, and again from `SHARED` on. `MIDDLE` frames later it stands flat below.
LEFT, RIGHT, ALONE, SHARED, MIDDLE = 3, 27, 2, 21, 11
#: Who begins or ends to walk, or turns on the spot, lifts a foot or puts it down in so many parts of a footing; a
#: turn has so many in all.
LIFT_PARTS, TURN_PARTS = 8, 28
#: What people do who stand begins and ends in this time, seconds; taste.
BLEND_S: Final = 0.4
#: Kind of path in a row of people: by footings, see ``common.glsl``; and gone.
BY_FOOTINGS, GONE = 3.0, 4.0
#: Whose row holds a second frame: its clip times this and the frame, whole in a float.
CLIP_STEP: Final = 1024.0


@dataclass(frozen=True, slots=True, eq=False)
class Acted:
    """A scenario's people.

    Attributes
    ----------
    footings : (F, COLUMNS) float32, each person's one after another in time
    starts : (N + 1,) uint32, each person's first footing, and how many there are
    people : (N, PERSON_TEXELS, 4) float32, rows whose path and pace are filled in
    touches : (C, K, WALK_FRAMES, 6) float32
        For each clone and walk, x and z of the point of the carrying sole that touches from a frame to the next: in the
        one, in the next, in the idle; model frame, metres. Of other clips the first two numbers say where the feet are
        less where they are in the idle.
    clips : (C, K, 2) float32, frames and seconds of each clone's clips
    blocks : (3 T, 6) float32, corners and normals of what stands in the way, metres
    """

    footings: NDArray[np.float32]
    starts: NDArray[np.uint32]
    people: NDArray[np.float32]
    touches: NDArray[np.float32]
    clips: NDArray[np.float32]
    blocks: NDArray[np.float32] = field(default_factory=lambda: np.zeros((0, 6), np.float32))


@dataclass(frozen=True, slots=True, eq=False)
class FootingParts:
    """A footing in equal parts: (n + 1,) frames, shares, headings and (n + 1, 2) positions of the body."""

    frames: Array
    shares: Array
    headings: Array
    places: Array


def is_in_range(acted: Acted, clips: Sequence[int]) -> bool:
    """Return whether all numbers are in range, for clones with so many clips each."""
    own, rows, starts = acted.footings, acted.people, acted.starts.astype(np.int64)
    lists = (acted.footings, acted.people, acted.touches, acted.clips, acted.blocks)
    if not all(np.isfinite(one).all() for one in lists) or len(set(clips)) != 1:
        return False
    kinds = clips[0]
    stands = own[:, LAST] < 0.0
    clones = rows[:, 1, 2]
    frames = acted.clips[..., 0]
    return bool(
        len(acted.blocks) % 3 == 0
        and acted.clips.shape == (len(clips), kinds, 2)
        and acted.touches.shape == (len(clips), kinds, WALK_FRAMES, 6)
        and len(starts) == len(rows) + 1
        and starts[0] == 0
        and starts[-1] == len(own)
        and (np.diff(starts) >= 0).all()
        and ((clones >= 0) & (clones < len(clips)) & (clones == np.floor(clones))).all()
        and (own[:, UNTIL] > own[:, FROM]).all()
        and ((own[:, [CLIP, FEELS]] >= 0) & (own[:, [CLIP, FEELS]] < kinds)).all()
        and (own[stands, OTHER] < kinds).all()
        and ((frames >= 1) & (frames < CLIP_STEP)).all()
        and (acted.clips[..., 1] > 0.0).all()
        and (-1.0 - own[stands, LAST] < CLIP_STEP).all()
        and ((own[~stands, OTHER] >= -kinds) & (own[~stands, OTHER] < CLIP_STEP)).all()
        and ((own[~stands, FIRST] >= 0) & (own[~stands, LAST] >= own[~stands, FIRST])).all()
        and (own[~stands, LAST] <= 2 * WALK_FRAMES).all()
    )


def split_footing(row: NDArray[Any], touches: NDArray[Any], scale: float) -> FootingParts:
    """Return a walking footing in its parts.

    Parameters
    ----------
    row : (COLUMNS,)
    touches : (K, WALK_FRAMES, 6) of the clone
    scale : of the person
    """
    first, last = round(float(row[FIRST])), round(float(row[LAST]))
    base = LEFT if first < RIGHT else RIGHT
    up = smoothstep(np.arange(LIFT_PARTS + 1) / LIFT_PARTS)
    if first == last:  # a foot is lifted, the body turns, the foot is put down
        held = TURN_PARTS - 2 * LIFT_PARTS
        frames = np.full(TURN_PARTS + 1, float(first))
        shares = np.concatenate([up, np.ones(held - 1), up[::-1]])
        turned = smoothstep((np.arange(TURN_PARTS + 1) - LIFT_PARTS) / held)
    else:
        frames = np.arange(first, last + 1, dtype=np.float64)
        low, high = max(first, base + ALONE), min(last, base + SHARED)
        turned = smoothstep((frames - low) / (high - low))
        shares = row[SHARE] + (row[SHARE_LAST] - float(row[SHARE])) * turned
        if row[SHARE] == 0.0:  # it is lifted before it goes ahead
            frames, turned = (np.concatenate([np.full(LIFT_PARTS, one[0]), one]) for one in (frames, turned))
            shares = row[SHARE_LAST] * np.concatenate([up, np.ones(last - first)])
        elif row[SHARE_LAST] == 0.0:  # and put down beside the other
            frames, turned = (np.concatenate([one, np.full(LIFT_PARTS, one[-1])]) for one in (frames, turned))
            shares = row[SHARE] * np.concatenate([np.ones(last - first), up[::-1]])
    before_it = -1 - round(float(row[OTHER]))
    if before_it >= 0:
        shares = turned
    headings = row[HEADING] + (row[HEADING_LAST] - float(row[HEADING])) * turned
    count = len(frames) - 1
    at = np.mod(frames[:-1].astype(int), WALK_FRAMES)
    own = touches[int(row[CLIP]), at].astype(np.float64) * scale
    goes_on = (np.diff(frames) > 0.0)[:, None]
    one, two, rest, rest_two = own[:, 0:2], np.where(goes_on, own[:, 2:4], own[:, 0:2]), own[:, 4:6], own[:, 4:6]
    if before_it >= 0:
        walk = touches[before_it, at].astype(np.float64) * scale
        rest, rest_two = walk[:, 0:2], walk[:, 2:4]
    before = rotate_by_heading(headings[:-1], rest + (one - rest) * shares[:-1, None])
    after = rotate_by_heading(headings[1:], rest_two + (two - rest_two) * shares[1:, None])
    places = np.zeros((count + 1, 2))
    places[0] = row[X], row[Z]
    places[1:] = places[0] + np.cumsum(before - after, axis=0)
    return FootingParts(frames, shares, headings, places)


def rotate_by_heading(headings: Any, points: Array) -> Array:
    """Return (n, 2) x and z of points of bodies with (n,) headings."""
    c, s = np.cos(headings), np.sin(headings)
    return np.stack([c * points[:, 0] + s * points[:, 1], c * points[:, 1] - s * points[:, 0]], axis=1)


def people_at(acted: Acted, times: float | Array) -> NDArray[np.float32]:
    """Return everybody's rows at a time, or each at their own, (N, 5, 4) float32, as ``footing.js`` does."""
    rows = acted.people.copy()
    for who, now in enumerate(np.broadcast_to(times, len(rows)).tolist()):
        own = acted.footings[acted.starts[who] : acted.starts[who + 1]]
        k = int(np.searchsorted(own[:, FROM], now, side="right")) - 1
        if k < 0 or now >= float(own[k, UNTIL]):  # a float32 would be compared as one
            rows[who, 0, 0] = GONE
            continue
        _fill(rows[who], own[k].astype(np.float64), acted, now)
    return rows


def feelings_at(acted: Acted, times: float | Array) -> NDArray[np.float32]:
    """Return (N, 2) each person's feeling at a time and how strongly the face shows it, as ``footing.js`` does."""
    felt = np.zeros((len(acted.people), 2), np.float32)
    for who, now in enumerate(np.broadcast_to(times, len(felt)).tolist()):
        own = acted.footings[acted.starts[who] : acted.starts[who + 1]]
        k = int(np.searchsorted(own[:, FROM], now, side="right")) - 1
        if k < 0:
            continue
        before, since = own[max(k - 1, 0), FEELS], (now - float(own[k, FROM])) / FEELS_S
        share = abs(2.0 * min(since, 1.0) - 1.0) if before != own[k, FEELS] else 1.0
        felt[who] = before if since < 0.5 else own[k, FEELS], share
    return felt


def _fill(row: NDArray[np.float32], footing: Array, acted: Acted, now: float) -> None:
    clone, scale, clip = int(row[1, 2]), float(row[1, 3]), int(footing[CLIP])
    length, seconds = acted.clips[clone, clip].astype(np.float64)
    since, rest = now - footing[FROM], footing[UNTIL] - now
    if footing[LAST] < 0.0:
        at = np.mod(footing[FIRST] + since / seconds, 1.0) * length
        frame = min(int(at), int(length) - 1)
        share = at - frame
        shown, x, z = (clip, frame, clip, (frame + 1) % length, share), footing[X], footing[Z]
        if footing[OTHER] >= 0.0 and since < BLEND_S:
            share = 1.0 - float(smoothstep(since / BLEND_S))
            shown = (clip, frame, int(footing[OTHER]), -1.0 - footing[LAST], share)
            x, z = x + (footing[SHARE] - x) * share, z + (footing[SHARE_LAST] - z) * share
        _put(row, (x, z, footing[HEADING]), *shown)
        return
    own = split_footing(footing, acted.touches[clone], scale)
    count = len(own.frames) - 1
    at = since / (since + rest) * count
    k = min(int(at), count - 1)
    frame = own.frames[k] % length
    if own.shares[k] >= 1.0 and own.shares[k + 1] >= 1.0:  # a whole walk: smooth between its frames
        share = at - k
        place = own.places[k] + (own.places[k + 1] - own.places[k]) * share
        heading = own.headings[k] + (own.headings[k + 1] - own.headings[k]) * share
        share = share if own.frames[k + 1] > own.frames[k] else 0.0
        _put(row, (*place, heading), clip, frame, clip, (frame + 1) % length, share)
    else:
        rest = (IDLE, footing[OTHER]) if footing[OTHER] >= 0.0 else (-1.0 - footing[OTHER], frame)
        _put(row, (*own.places[k], own.headings[k]), clip, frame, rest[0], rest[1], 1.0 - own.shares[k])


def _put(
    row: NDArray[np.float32],
    there: tuple[float, ...],
    clip: float,
    frame: float,
    other: float,
    second: float,
    share: float,
) -> None:
    """Fill in x, z and heading, and two frames of which the second has a share of at most a half."""
    if share > 0.5:
        clip, frame, other, second, share = other, second, clip, frame, 1.0 - share
    row[0] = (BY_FOOTINGS, *there)
    row[1, :2] = frame, share
    row[2, 3] = clip
    row[4, 0] = other * CLIP_STEP + second


def touching_points(numbers: CloneArrays, body: BodyLevels, clips: Sequence[Mapping[str, Any]]) -> NDArray[np.float32]:
    """Return (K, WALK_FRAMES, 6) the touching points of a clone's walks; see :class:`Acted`.

    Parameters
    ----------
    numbers : Numbers
    body : BodyLevels
    clips : rows of the clone's clips in ``crowd.json``
    """
    table = np.zeros((len(clips), WALK_FRAMES, 6), np.float32)
    starts = np.cumsum([0, *(clip["frames"] for clip in clips)])
    soles = [sole_places(numbers, body, side) for side in ("left", "right")]
    for k, clip in enumerate(clips):
        if clip["speed_m_s"] <= 0.0 or clip["frames"] != WALK_FRAMES:
            both = np.concatenate(soles, axis=1).mean(axis=1)
            table[k, :, :2] = (both[starts[k]] - both[starts[IDLE]])[::2]
            continue
        for frame in range(WALK_FRAMES):
            sole = soles[0 if LEFT <= frame < RIGHT else 1]
            one, two = sole[starts[k] + frame], sole[starts[k] + (frame + 1) % WALK_FRAMES]
            point = int(np.argmin(one[:, 1]))
            still = sole[starts[IDLE], point]
            table[k, frame] = [*one[point, ::2], *two[point, ::2], *still[::2]]
    return table


def sole_places(numbers: CloneArrays, body: BodyLevels, side: str) -> Array:
    """Return (F, n, 3) the points of a sole in all frames of a clone's clips, model frame, metres."""
    generic = load_generic()
    sole = np.flatnonzero(generic.region("sole") & generic.region(f"foot_{side}"))
    rows = np.flatnonzero(np.isin(body.vertex, sole))
    rest = np.array(BOX_MIN_M) + numbers.vertices[rows, :3].astype(np.float64) * BOX_STEP_M
    frames = numbers.bones.astype(np.float64) / BONE_FULL * (1.0, 1.0, 1.0, BONE_REACH_M)
    return np.stack([skin_vertices(rest, body.joints[rows], body.weights[rows], frame) for frame in frames])
