"""MPEG-4 facial animation: the 68 parameters, this face's units, and files of them.

A parameter moves one feature point in one direction, in units of the face's own proportions. Which targets of the clone
do that is found from the targets themselves: how far each moves each feature point is measured on this face, and a
frame's weights are those that come nearest to all points that the frame names.

References
----------
ISO/IEC 14496-2 (Visual), annex C: FAP definitions, FAPU, feature points.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner.generic.morphs import target_offsets
from cloner.motion.face.fap_faces import FULL, LIDS, expression_weights, frame_weights, viseme_weights
from cloner.records.arrays import Array, freeze
from cloner.records.clones import Clone
from cloner.untrusted import read_untrusted_text

#: Number of MPEG-4's facial animation parameters.
COUNT: Final = 68
_LEFT, _RIGHT, _UP, _DOWN, _AHEAD = (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1)
#: Parameter -> unit, direction of a positive value, feature point. Turns of eyes and head are not in it.
MOVES: Final[Mapping[int, tuple[str, tuple[int, int, int], str]]] = {
    3: ("MNS", _DOWN, "2.1"), 4: ("MNS", _DOWN, "2.2"), 5: ("MNS", _UP, "2.3"), 6: ("MW", _LEFT, "2.4"),
    7: ("MW", _RIGHT, "2.5"), 8: ("MNS", _DOWN, "2.6"), 9: ("MNS", _DOWN, "2.7"), 10: ("MNS", _UP, "2.8"),
    11: ("MNS", _UP, "2.9"), 12: ("MNS", _UP, "2.4"), 13: ("MNS", _UP, "2.5"), 14: ("MNS", _AHEAD, "2.1"),
    15: ("MW", _RIGHT, "2.1"), 16: ("MNS", _AHEAD, "2.3"), 17: ("MNS", _AHEAD, "2.2"), 18: ("MNS", _UP, "2.10"),
    19: ("IRISD", _DOWN, "3.1"), 20: ("IRISD", _DOWN, "3.2"), 21: ("IRISD", _UP, "3.3"), 22: ("IRISD", _UP, "3.4"),
    31: ("ENS", _UP, "4.1"), 32: ("ENS", _UP, "4.2"), 33: ("ENS", _UP, "4.3"), 34: ("ENS", _UP, "4.4"),
    35: ("ENS", _UP, "4.5"), 36: ("ENS", _UP, "4.6"), 37: ("ES", _RIGHT, "4.1"), 38: ("ES", _LEFT, "4.2"),
    39: ("ES", _LEFT, "5.1"), 40: ("ES", _RIGHT, "5.2"), 41: ("ENS", _UP, "5.3"), 42: ("ENS", _UP, "5.4"),
    43: ("MW", _RIGHT, "6.1"), 44: ("MNS", _UP, "6.1"), 45: ("MW", _AHEAD, "6.1"), 46: ("MNS", _UP, "6.2"),
    51: ("MNS", _DOWN, "8.1"), 52: ("MNS", _UP, "8.2"), 53: ("MW", _LEFT, "8.3"), 54: ("MW", _RIGHT, "8.4"),
    55: ("MNS", _DOWN, "8.5"), 56: ("MNS", _DOWN, "8.6"), 57: ("MNS", _UP, "8.7"), 58: ("MNS", _UP, "8.8"),
    59: ("MNS", _UP, "8.3"), 60: ("MNS", _UP, "8.4"), 61: ("ENS", _LEFT, "9.1"), 62: ("ENS", _RIGHT, "9.2"),
    63: ("ENS", _UP, "9.3"), 64: ("ENS", _RIGHT, "9.3"), 65: ("ENS", _UP, "10.1"), 66: ("ENS", _UP, "10.2"),
    67: ("ENS", _LEFT, "10.3"), 68: ("ENS", _RIGHT, "10.4"),
}  # fmt: skip
#: Parameter -> joint and axis of a turn in units of 1e-5 radians; a negative axis turns the other way.
TURNS: Final[Mapping[int, tuple[str, tuple[int, int, int]]]] = {
    23: ("l_eyeball_joint", (0, 1, 0)), 24: ("r_eyeball_joint", (0, 1, 0)), 25: ("l_eyeball_joint", (1, 0, 0)),
    26: ("r_eyeball_joint", (1, 0, 0)), 48: ("skullbase", (1, 0, 0)), 49: ("skullbase", (0, 1, 0)),
    50: ("skullbase", (0, 0, 1)),
}  # fmt: skip
ANGLE_UNIT: Final = 1e-5
#: How many numbers the two compound parameters have in a frame, by how many both have together: some writers leave out
#: the last ones, which say that a frame defines a shape for later ones.
COMPOUND: Final[Mapping[tuple[bool, bool, int], tuple[int, int]]] = {
    (True, False, 3): (3, 0), (True, False, 4): (4, 0), (False, True, 4): (0, 4), (False, True, 5): (0, 5),
    (False, True, 6): (0, 6), (True, True, 7): (3, 4), (True, True, 8): (4, 4), (True, True, 9): (3, 6),
    (True, True, 10): (4, 6),
}  # fmt: skip
LARGEST_BYTES: Final = 50_000_000


@dataclass(frozen=True, slots=True, eq=False)
class FapStream:
    """Facial animation parameters over time.

    Attributes
    ----------
    frames_per_s : float
    values : (F, 68) float64
        In the parameters' own units; column k is parameter k + 1.
    given : (F, 68) bool
        Which of them a frame names.
    viseme : (F, 3) float64
        Of FAP 1: first and second viseme, 0 to 14, and how much the first one counts, 0 to 63.
    expression : (F, 4) float64
        Of FAP 2: two expressions, 0 to 6, each with its intensity, 0 to 63.
    """

    frames_per_s: float
    values: Array
    given: NDArray[np.bool_]
    viseme: Array = field(default_factory=lambda: np.zeros((0, 3)))
    expression: Array = field(default_factory=lambda: np.zeros((0, 4)))

    def __post_init__(self) -> None:
        count = len(self.values)
        for name, width in (("viseme", 3), ("expression", 4)):
            if not len(getattr(self, name)):
                object.__setattr__(self, name, np.zeros((count, width)))
        freeze(
            self,
            values=(np.float64, (None, COUNT)),
            given=(np.bool_, (count, COUNT)),
            viseme=(np.float64, (count, 3)),
            expression=(np.float64, (count, 4)),
        )


def face_units(clone: Clone) -> dict[str, float]:
    """Return the face's FAPU: one unit of every kind, metres (distances of the neutral face over 1024)."""
    point = dict(zip(load_generic().fdp_names, clone.vertices_m[load_generic().fdp_vertices], strict=True))
    middle = (point["3.5"] + point["3.6"])[1] / 2.0
    distances = {
        "IRISD": np.mean([point["3.1"][1] - point["3.3"][1], point["3.2"][1] - point["3.4"][1]]),
        "ES": point["3.5"][0] - point["3.6"][0],
        "ENS": middle - point["9.15"][1],
        "MNS": point["9.15"][1] - point["2.2"][1],
        "MW": point["8.3"][0] - point["8.4"][0],
    }
    return {name: float(distance) / 1024.0 for name, distance in distances.items()}


def target_moves(clone: Clone, names: tuple[str, ...]) -> Array:
    """Return (68, N): by how many of its units each parameter's point moves when a target of the face is full on."""
    generic, units = load_generic(), face_units(clone)
    vertex = dict(zip(generic.fdp_names, generic.fdp_vertices.tolist(), strict=True))
    moves = np.zeros((COUNT, len(names)))
    for name, offsets in target_offsets(clone):
        if name not in names:
            continue
        for number, (unit, direction, point) in MOVES.items():
            own = offsets[vertex[point]].astype(np.float64)
            moves[number - 1, names.index(name)] = own @ np.array(direction) / units[unit]
    # The unit of lids is their distance over 1024, and a blink takes away all of it: what its points tell is stretched.
    for upper, lower, side in LIDS:
        if f"eyeBlink{side}" in names:
            blink = moves[[upper - 1, lower - 1], names.index(f"eyeBlink{side}")].sum()
            moves[[upper - 1, lower - 1]] *= FULL / max(float(blink), 1.0)
    return moves


def weights_of(clone: Clone, stream: FapStream) -> dict[str, Array]:
    """Return the weights 0..1 (F,) of the face's targets that play a stream on this clone."""
    names = tuple(name for name in load_generic().arkit_names if name in clone.morph_names)
    moves = target_moves(clone, names)
    weights = np.zeros((len(stream.values), len(names)))
    for row, (values, given) in enumerate(zip(stream.values, stream.given, strict=True)):
        weights[row] = frame_weights(moves, names, np.where(given, values, 0.0), given)
    found = {name: weights[:, column] for column, name in enumerate(names) if weights[:, column].any()}
    for own in (viseme_weights(stream.viseme), expression_weights(stream.expression)):
        for name, values in own.items():
            if name in clone.morph_names:
                found[name] = 1.0 - (1.0 - found.get(name, np.zeros(len(values)))) * (1.0 - values)
    return found


def rotations_of(stream: FapStream, joint_names: tuple[str, ...]) -> Array:
    """Return (F, J, 3) rotation vectors of eyes and head, radians."""
    rotations = np.zeros((len(stream.values), len(joint_names), 3))
    for number, (joint, axis) in TURNS.items():
        angle = np.where(stream.given[:, number - 1], stream.values[:, number - 1], 0.0) * ANGLE_UNIT
        rotations[:, joint_names.index(joint)] += angle[:, None] * np.array(axis)
    return rotations


def stream_of(clone: Clone, weights: Mapping[str, Array], frames_per_s: float) -> FapStream:
    """Return the parameters that weights (F,) of the clone's targets stand for on this face."""
    names = tuple(name for name in weights if name in clone.morph_names)
    rows = np.column_stack([weights[name] for name in names])
    values = np.rint(rows @ target_moves(clone, names).T)
    return FapStream(frames_per_s, values, np.broadcast_to(np.abs(values).max(axis=0) > 0.0, values.shape))


def fap_text(stream: FapStream, name: str) -> str:
    """Return a stream as an ASCII FAP file (version 2.1): a mask and a line of values a frame."""
    lines = [f"2.1 {''.join(name.split()) or 'face'} {stream.frames_per_s:g} {len(stream.values)}"]
    for number, (values, given) in enumerate(zip(stream.values, stream.given, strict=True)):
        lines.append(" ".join("1" if one else "0" for one in given))
        lines.append(" ".join([str(number), *(f"{value:.0f}" for value in values[given])]))
    return "\n".join(lines) + "\n"


def read_fap(path: Path) -> FapStream:
    """Return the stream in an ASCII FAP file.

    Raises
    ------
    ClonerError
        If the file is missing, too large or no FAP file.
    """
    text = read_untrusted_text(path, "the FAP file", "Give a .fap file", LARGEST_BYTES, errors="replace")
    lines = [line for line in text.splitlines() if line.strip()]
    try:
        return _parsed(lines)
    except (ValueError, IndexError, OverflowError) as error:
        raise ClonerError(f"the FAP file is broken: {error}", "Write it again", path.name) from error


def _parsed(lines: list[str]) -> FapStream:
    head = lines[0].split()
    if len(head) < 4 or head[0] not in ("2.0", "2.1"):
        raise ValueError("the first line is not that of a FAP file")
    frames_per_s, count = float(head[2]), int(head[3])
    if not (0.0 < frames_per_s <= 1000.0 and 0 < count <= 10_000_000) or len(lines) < 1 + 2 * count:
        raise ValueError(f"{count} frames are promised")
    values, given = np.zeros((count, COUNT)), np.zeros((count, COUNT), dtype=bool)
    viseme, expression = np.zeros((count, 3)), np.zeros((count, 4))
    for number in range(count):
        mask = np.array(lines[1 + 2 * number].split(), dtype=int)
        row = np.array(lines[2 + 2 * number].split(), dtype=float)[1:]
        single = int((mask[2:] != 0).sum())
        has = (bool(mask[0]), bool(mask[1])) if len(mask) == COUNT else (False, False)
        first, second = COMPOUND.get((*has, len(row) - single), (0, 0))
        if len(mask) != COUNT or len(row) != first + second + single:
            raise ValueError(f"frame {number} has {len(mask)} marks and {len(row)} values")
        viseme[number] = row[:3] if first else 0.0
        expression[number] = row[first : first + 4] if second else 0.0
        given[number, 2:] = mask[2:] != 0
        values[number, given[number]] = row[first + second :]
    return FapStream(frames_per_s, values, given, viseme, expression)
