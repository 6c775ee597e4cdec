"""A score for the face, written by hand: expressions on independent tracks.

The tutorial's hierarchy from the top down: a score has tracks (head, eyes, brows, mouth, emotion), a track has beats, a
beat is a static expression with attack, sustain and decay, an expression is weights of the mesh's targets. TOML::

    [[emotion]]
    expression = "joy"
    start = 0.5
    attack = 0.4
    sustain = 2.0
    decay = 0.6
    strength = 0.8

    [[head]]
    expression = "nod"
    start = 1.2

References
----------
Tutorial "Inhabited Virtual Heritage", Eurographics 2001, facial animation.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final

import numpy as np

from cloner.errors import ClonerError
from cloner.motion.face.expressions import EXPRESSIONS, Beat, Envelope, play
from cloner.records.arrays import Array
from cloner.untrusted import read_untrusted_text

FACE_TRACKS: Final = ("eyes", "brows", "mouth", "emotion")
HEAD: Final = "head"
#: Longest score, seconds (taste).
LONGEST_S: Final = 600.0
LARGEST_BYTES: Final = 10_000_000  # taste: a thousand times what a person types
#: Small expressions beside the six of the standard; taste. Any target's own name is one too.
GESTURES: Final[Mapping[str, Mapping[str, float]]] = MappingProxyType({
    "blink": {"eyeBlinkLeft": 1.0, "eyeBlinkRight": 1.0},
    "wink": {"eyeBlinkLeft": 1.0, "cheekSquintLeft": 0.5},
    "brows_up": {"browInnerUp": 0.8, "browOuterUpLeft": 0.7, "browOuterUpRight": 0.7},
    "frown": {"browDownLeft": 0.8, "browDownRight": 0.8},
    "smile": {"mouthSmileLeft": 0.7, "mouthSmileRight": 0.7},
    "look_left": {"eyeLookOutLeft": 0.8, "eyeLookInRight": 0.8},
    "look_right": {"eyeLookInLeft": 0.8, "eyeLookOutRight": 0.8},
    "look_up": {"eyeLookUpLeft": 0.7, "eyeLookUpRight": 0.7},
    "look_down": {"eyeLookDownLeft": 0.7, "eyeLookDownRight": 0.7},
})  # fmt: skip
#: Turns of the head: model axis (0 nods, 1 turns, 2 tilts), radians, and swings a beat (0: it stays); taste.
HEAD_TURNS: Final[Mapping[str, tuple[int, float, int]]] = MappingProxyType({
    "nod": (0, 0.16, 2), "shake": (1, 0.20, 2), "tilt": (2, 0.14, 0), "turn_left": (1, 0.35, 0),
    "turn_right": (1, -0.35, 0), "bow": (0, 0.30, 0),
})  # fmt: skip
QUICK: Final = Envelope(0.08, 0.03, 0.13)
_QUICK_ONES: Final = ("blink", "wink")
_TIMES: Final = ("attack", "sustain", "decay")


@dataclass(frozen=True, slots=True)
class HeadBeat:
    """A movement of the head: which of `HEAD_TURNS`, when, and how strong."""

    turn: str
    start_s: float
    envelope: Envelope
    strength: float

    def angles(self, times_s: Array) -> tuple[int, Array]:
        """Return the axis and the angles (F,) at some times, radians."""
        axis, most, swings = HEAD_TURNS[self.turn]
        since = times_s - self.start_s
        length = self.envelope.attack_s + self.envelope.sustain_s + self.envelope.decay_s
        swing = np.sin(2.0 * np.pi * swings * np.clip(since / max(length, 1e-6), 0.0, 1.0)) if swings else 1.0
        return axis, np.asarray(self.strength * most * self.envelope.strength(since) * swing)


@dataclass(frozen=True, slots=True)
class Score:
    """All beats of a face and a head.

    Attributes
    ----------
    tracks : mapping of str to sequence of Beat
        One a name of `FACE_TRACKS`.
    head : sequence of HeadBeat
    """

    tracks: Mapping[str, Sequence[Beat]]
    head: Sequence[HeadBeat]

    def duration_s(self) -> float:
        """Return when the last beat has gone, seconds."""
        spans = [(beat.start_s, beat.envelope) for beat in self.head]
        spans += [(beat.start_s, beat.envelope) for track in self.tracks.values() for beat in track]
        return max((at + own.attack_s + own.sustain_s + own.decay_s for at, own in spans), default=0.0)

    def weights(self, times_s: Array) -> dict[str, dict[str, Array]]:
        """Return the weights (F,) of every track's targets."""
        return {name: play(beats, times_s) for name, beats in self.tracks.items()}

    def head_angles(self, times_s: Array) -> Array:
        """Return (F, 3) turns of the head about the model's axes, radians."""
        angles = np.zeros((len(times_s), 3))
        for beat in self.head:
            axis, own = beat.angles(times_s)
            angles[:, axis] += own
        return angles


#: The face of somebody whose score is empty.
SILENT: Final = Score({}, ())


def emotion_score(name: str, duration_s: float) -> Score:
    """Return the score of one emotion that comes with a speech and goes with it.

    Raises
    ------
    ClonerError
        If the emotion is none of the six.
    """
    if name not in EXPRESSIONS:
        raise ClonerError(f"the emotion {name!r} is not known", f"Use one of {', '.join(EXPRESSIONS)}", "--emotion")
    ease = min(0.6, duration_s / 3.0)
    return Score({"emotion": (Beat(0.0, EXPRESSIONS[name], Envelope(ease, duration_s - 2.0 * ease, ease)),)}, ())


def read_score(path: Path, targets: Sequence[str]) -> Score:
    """Return the score in a TOML file.

    Parameters
    ----------
    path : Path
    targets : sequence of str
        Names of the clone's morph targets; each is an expression of its own.

    Raises
    ------
    ClonerError
        If the file is missing, no TOML, or names what is not known.
    """
    text = read_untrusted_text(path, "the score", "Give a .toml file", LARGEST_BYTES)
    try:
        tracks = tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # endless numbers and brackets are no TOMLDecodeError
        raise ClonerError(f"the score is no TOML: {error}", "Write tables like [[emotion]]", path.name) from error
    found: dict[str, list[Beat]] = {}
    head: list[HeadBeat] = []
    for track, rows in tracks.items():
        if track not in (*FACE_TRACKS, HEAD) or not isinstance(rows, list):
            hint = f"The tracks are {', '.join((*FACE_TRACKS, HEAD))}, each written as [[{FACE_TRACKS[0]}]]"
            raise ClonerError(f"the track {track!r} is not known", hint, path.name)
        for row in rows:
            try:
                beat = _beat(track, row, targets)
            except (TypeError, AttributeError, ValueError, OverflowError) as error:
                hint = "Write expression, start, attack, sustain, decay (seconds) and strength (0 to 1)"
                raise ClonerError(f"a beat of the track {track!r} is broken: {error}", hint, path.name) from error
            head.append(beat) if isinstance(beat, HeadBeat) else found.setdefault(track, []).append(beat)
    return Score({name: tuple(beats) for name, beats in found.items()}, tuple(head))


def _beat(track: str, row: Mapping[str, Any], targets: Sequence[str]) -> Beat | HeadBeat:
    """Return one beat of a track.

    Raises
    ------
    ValueError
        If something in it is unknown or out of range.
    """
    unknown = set(row) - {"expression", "start", "strength", *_TIMES}
    if unknown:
        raise ValueError(f"{', '.join(sorted(unknown))} is not expected")
    name = str(row.get("expression", ""))
    usual = QUICK if name in _QUICK_ONES else Envelope()
    standing = (usual.attack_s, usual.sustain_s, usual.decay_s)
    times = [float(row.get(key, own)) for key, own in zip(_TIMES, standing, strict=True)]
    start, strength = float(row.get("start", 0.0)), float(row.get("strength", 1.0))
    if not all(0.0 <= value <= LONGEST_S for value in (start, *times)) or not 0.0 <= strength <= 1.0:
        raise ValueError(f"times lie between 0 and {LONGEST_S:.0f} s, strengths between 0 and 1")
    if track == HEAD:
        if name not in HEAD_TURNS:
            raise ValueError(f"{name!r} is none of {', '.join(HEAD_TURNS)}")
        return HeadBeat(name, start, Envelope(*times), strength)
    known = {**EXPRESSIONS, **GESTURES, **{target: {target: 1.0} for target in targets}}
    if name not in known:
        raise ValueError(f"{name!r} is none of {', '.join((*EXPRESSIONS, *GESTURES))} and no target of the face")
    return Beat(start, known[name], Envelope(*times), strength)
