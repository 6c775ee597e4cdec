"""Trajectories at 10 Hz in one file: positions to 2 mm, heading to 1.4 degrees, postures and emotions.

Places are second differences of int16, so that whoever walks evenly costs nothing; low and high bytes lie apart and are
deflated. Measured on other walkers (walkers §2): 10.2 bytes a person and second with gzip, 1 mm by a spline.
"""

from __future__ import annotations

import json
import struct
import zlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.behaviour.model import XY
from cloner.behaviour.walking import RATE_HZ, STEP_S
from cloner.behaviour.world import World
from cloner.errors import ClonerError
from cloner.records.arrays import Array
from cloner.untrusted import UnsuitableFile, read_untrusted

MAGIC: Final = b"CLNRWLK1"
#: Files hold `RATE_HZ` places a second, in such metres: 10.2 bytes a person and second, 1 mm off (walkers §2).
UNIT_M: Final = 0.002
STEPS: Final = round(1.0 / RATE_HZ / STEP_S)
#: An hour of 20,000 people is less.
LARGEST_BYTES: Final = 2_000_000_000
MOST_VALUES: Final = 400_000_000
#: More corners of obstacles than a plan has, and places farther away, metres; they bound what a hostile file can ask.
MOST_CORNERS: Final = 5_000
FARTHEST_M: Final = 1e6
_AGAIN: Final = "Write it again with cloner crowd run"


@dataclass(frozen=True, slots=True, eq=False)
class Trajectories:
    """What people did: (f, n) per frame and person; ``place`` (f, n, 2) m, ``facing`` (f, n, 2) unit vectors.

    ``posture``, ``emotion`` are places in the lists ``acts`` and ``emotions``; ``gaze`` in ``things``, -1 for none; who
    is not ``present`` stands where he left; ``walks`` are the emotions' styles; ``obstacles`` corners, m.
    ``groups`` (n,) names the scenario's group of each. Frame k is at k / 10 s.
    """

    place: Array
    facing: Array
    present: NDArray[np.bool_]
    posture: NDArray[np.uint8]
    emotion: NDArray[np.uint8]
    gaze: NDArray[np.int8]
    groups: tuple[str, ...]
    acts: tuple[str, ...]
    emotions: tuple[str, ...]
    things: tuple[str, ...]
    told: tuple[tuple[float, str], ...]
    seed: int
    walks: tuple[str, ...] = ()
    obstacles: tuple[tuple[XY, ...], ...] = ()
    things_at: tuple[XY, ...] = ()


class Recorder:
    """Records frames of a world at the file's rate."""

    def __init__(self) -> None:
        self._frames: list[tuple[NDArray[Any], ...]] = []

    def record(self, world: World) -> None:
        """Record the present state; call it after each step, and once before the first."""
        if world.steps % STEPS == 0:
            people, bodies = world.people, world.bodies
            self._frames.append(
                (
                    bodies.place.copy(),
                    world.bodies.facing.copy(),
                    bodies.present.copy(),
                    people.posture.astype(np.uint8),
                    people.emotion.astype(np.uint8),
                    people.gaze.astype(np.int8),
                )
            )

    def trajectories(self, world: World) -> Trajectories:
        """Return all frames."""
        scenario = world.scenario
        place, facing, present, posture, emotion, gaze = (np.stack(one) for one in zip(*self._frames, strict=True))
        return Trajectories(
            place, facing, present, posture, emotion, gaze,
            groups=tuple(str(scenario.groups[home].name) for home in world.people.home),
            acts=tuple(map(str, world.acts)),
            emotions=tuple(str(one.name) for one in scenario.emotions),
            things=tuple(str(one.name) for one in scenario.things),
            told=tuple(world.told),
            seed=world.seed,
            walks=tuple(str(one.walk) for one in scenario.emotions),
            obstacles=tuple(one.corners for one in scenario.obstacles),
            things_at=tuple(one.at for one in scenario.things),
        )  # fmt: skip


def pack(walk: Trajectories) -> bytes:
    """Return trajectories as a file's bytes."""
    place = np.rint(walk.place / UNIT_M).astype(np.int32).transpose(1, 2, 0)  # person, axis, time
    turn = np.arctan2(walk.facing[..., 1], walk.facing[..., 0]) * (128.0 / np.pi)
    facing = np.rint(turn).astype(np.int32).astype(np.uint8).T
    head = {
        "frames": len(walk.place), "rate_hz": RATE_HZ, "unit_m": UNIT_M, "seed": walk.seed, "groups": list(walk.groups),
        "acts": list(walk.acts), "emotions": list(walk.emotions), "things": list(walk.things), "told": list(walk.told),
        "walks": list(walk.walks), "obstacles": walk.obstacles, "things_at": walk.things_at,
    }  # fmt: skip
    second = _differences(place)
    zigzag = ((second << 1) ^ (second >> 31)).astype(np.uint32)
    planes = [((zigzag >> shift) & 255).astype(np.uint8).tobytes() for shift in (0, 8, 16, 24)]
    planes.append(np.diff(facing, axis=1, prepend=np.zeros((len(facing), 1), np.uint8)).tobytes())
    for column in (walk.posture, walk.emotion, walk.gaze.astype(np.uint8), walk.present.astype(np.uint8)):
        planes.append(
            np.diff(column.T, axis=1, prepend=np.zeros((column.shape[1], 1), np.uint8)).astype(np.uint8).tobytes()
        )
    text = json.dumps(head).encode()
    return MAGIC + struct.pack("<I", len(text)) + text + zlib.compress(b"".join(planes), 9)


def _differences(place: NDArray[np.int32]) -> NDArray[np.int32]:
    """Return first value, first difference, then second differences, along the last axis."""
    found = place.copy()
    found[..., 1:] -= place[..., :-1]
    first = found.copy()
    found[..., 2:] -= first[..., 1:-1]
    return found


def _sums(found: NDArray[np.int32]) -> NDArray[np.int32]:
    """Undo :func:`_differences`."""
    first = found.copy()
    first[..., 1:] = np.cumsum(found[..., 1:], axis=-1, dtype=np.int32)
    return np.cumsum(first, axis=-1, dtype=np.int32)


def unpack(data: bytes) -> Trajectories:
    """Return the trajectories of :func:`pack`'s bytes.

    Raises
    ------
    ValueError
        If the bytes are not those of a file of trajectories.
    """
    if data[: len(MAGIC)] != MAGIC or len(data) < len(MAGIC) + 4:
        raise ValueError("it does not begin like one")
    start = len(MAGIC) + 4
    (length,) = struct.unpack("<I", data[len(MAGIC) : start])
    try:
        head = json.loads(data[start : start + length])
        frames, people = int(head["frames"]), len(head["groups"])
        groups, acts, emotions, things = (
            tuple(map(str, head[one])) for one in ("groups", "acts", "emotions", "things")
        )
        walks = tuple(map(str, head.get("walks", emotions)))  # files of before had none, nor what follows
        obstacles = tuple(tuple(map(_place, one)) for one in head.get("obstacles", ()))
        things_at = tuple(map(_place, head.get("things_at", ())))
        if any(len(one) < 3 for one in obstacles) or sum(map(len, obstacles)) + len(things_at) > MOST_CORNERS:
            raise ValueError("no obstacles")
        messages = tuple((float(when), str(what)) for when, what in head["told"])
        seed = int(head["seed"])
    except (KeyError, TypeError, ValueError, OverflowError, RecursionError) as error:
        raise ValueError("its head cannot be read") from error
    size = frames * people
    if not (0 < frames and 0 < people and size <= MOST_VALUES):
        raise ValueError("it tells of nobody, or of too many")
    try:
        raw = zlib.decompressobj().decompress(data[start + length :], size * 13 + 1)
    except zlib.error as error:
        raise ValueError("it is damaged") from error
    if len(raw) != size * 13:
        raise ValueError("it is damaged")
    flat = np.frombuffer(raw, np.uint8)
    zigzag = np.zeros(2 * size, np.uint32)
    for k in range(4):
        zigzag |= flat[2 * size * k : 2 * size * (k + 1)].astype(np.uint32) << np.uint32(8 * k)
    second = ((zigzag >> np.uint32(1)).astype(np.int32) ^ -(zigzag & np.uint32(1)).astype(np.int32)).reshape(
        people, 2, frames
    )
    place = _sums(second).transpose(2, 0, 1) * UNIT_M
    rows = np.cumsum(flat[8 * size :].reshape(5, people, frames), axis=2, dtype=np.uint8).transpose(0, 2, 1)
    angle = rows[0].astype(np.int8) * (np.pi / 128.0)
    facing = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    gaze = rows[3].astype(np.int8)
    if rows[1].max() >= len(acts) or rows[2].max() >= min(len(emotions), len(walks)):
        raise ValueError("it tells of acts or emotions that it does not name")
    return Trajectories(
        np.asarray(place), facing, rows[4] != 0, rows[1], rows[2], gaze, groups, acts, emotions, things, messages, seed,
        walks, obstacles, things_at,
    )  # fmt: skip


def _place(data: Any) -> XY:
    """Return a place of the plan.

    Raises
    ------
    ValueError
        If it is none.
    """
    x, y = (float(one) for one in data)
    if not (abs(x) < FARTHEST_M and abs(y) < FARTHEST_M):
        raise ValueError("no place")
    return x, y


def read_trajectories(path: Path) -> Trajectories:
    """Return the trajectories of a file.

    Raises
    ------
    ClonerError
        If it is none, or damaged.
    """
    try:
        return unpack(read_untrusted(path, LARGEST_BYTES))
    except UnsuitableFile as error:
        raise ClonerError(f"the trajectories cannot be read: {error.strerror}", _AGAIN, path.name) from error
    except (OSError, ValueError) as error:
        raise ClonerError(f"these are no trajectories: {error}", _AGAIN, path.name) from error
