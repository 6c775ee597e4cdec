"""Facial expressions with time envelopes on independent tracks, mixed within limits.

The tutorial's hierarchy: mesh, static expressions, and tracks on which expressions come and go.

References
----------
Tutorial "Inhabited Virtual Heritage", Eurographics 2001, facial animation (attack, sustain, decay; emotion, head, eyes,
brows, mouth). ISO/IEC 14496-2, FAP 2 (six expressions).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

import numpy as np

from cloner.easing import half_wave
from cloner.records.arrays import Array

#: The six expressions of MPEG-4 as weights of the face's targets; taste, after the standard's wording.
EXPRESSIONS: Final[Mapping[str, Mapping[str, float]]] = MappingProxyType({
    "joy": {"mouthSmileLeft": 0.8, "mouthSmileRight": 0.8, "cheekSquintLeft": 0.5, "cheekSquintRight": 0.5},
    "sadness": {"browInnerUp": 0.8, "mouthFrownLeft": 0.7, "mouthFrownRight": 0.7, "eyeSquintLeft": 0.25,
                "eyeSquintRight": 0.25},
    "anger": {"browDownLeft": 0.9, "browDownRight": 0.9, "eyeWideLeft": 0.3, "eyeWideRight": 0.3, "mouthPressLeft": 0.6,
              "mouthPressRight": 0.6, "noseSneerLeft": 0.3, "noseSneerRight": 0.3},
    "fear": {"browInnerUp": 0.9, "browOuterUpLeft": 0.4, "browOuterUpRight": 0.4, "eyeWideLeft": 0.8,
             "eyeWideRight": 0.8, "mouthStretchLeft": 0.4, "mouthStretchRight": 0.4, "jawOpen": 0.1},
    "disgust": {"noseSneerLeft": 0.8, "noseSneerRight": 0.8, "browDownLeft": 0.4, "browDownRight": 0.4,
                "mouthUpperUpLeft": 0.4, "mouthUpperUpRight": 0.4},
    "surprise": {"browInnerUp": 0.9, "browOuterUpLeft": 0.8, "browOuterUpRight": 0.8, "eyeWideLeft": 0.6,
                 "eyeWideRight": 0.6, "jawOpen": 0.35},
})  # fmt: skip
#: Targets of the mouth, which speech needs for itself.
MOUTH: Final = ("mouth", "jaw", "tongue", "viseme_", "cheekPuff")
#: What speech leaves of an emotion's mouth while it is loud; taste.
MOUTH_LEFT: Final = 0.35


@dataclass(frozen=True, slots=True)
class Envelope:
    """How an expression comes, stays and goes, seconds; each part is a smooth half wave."""

    attack_s: float = 0.25
    sustain_s: float = 1.0
    decay_s: float = 0.5

    def strength(self, since_s: Array) -> Array:
        """Return (F,) strengths 0..1 at times after the beginning, seconds."""
        rising = np.clip(since_s / max(self.attack_s, 1e-6), 0.0, 1.0)
        falling = np.clip((since_s - self.attack_s - self.sustain_s) / max(self.decay_s, 1e-6), 0.0, 1.0)
        return np.asarray(half_wave(rising) * (1.0 - half_wave(falling)))


@dataclass(frozen=True, slots=True)
class Beat:
    """One expression at one instant of a track.

    Attributes
    ----------
    start_s : float
    weights : mapping of str to float
        Targets at full strength, for example one of `EXPRESSIONS`.
    envelope : Envelope
    strength : float, 0..1
    """

    start_s: float
    weights: Mapping[str, float]
    envelope: Envelope = Envelope()
    strength: float = 1.0


def play(beats: Iterable[Beat], times_s: Array) -> dict[str, Array]:
    """Return the weights (F,) of one track's targets; where its beats overlap the stronger one counts."""
    found: dict[str, Array] = {}
    for beat in beats:
        strength = beat.strength * beat.envelope.strength(times_s - beat.start_s)
        for name, weight in beat.weights.items():
            found[name] = np.maximum(found.get(name, np.zeros(len(times_s))), weight * strength)
    return found


def mixed(tracks: Mapping[str, Mapping[str, Array]]) -> dict[str, Array]:
    """Return the weights of all tracks together, each between 0 and 1.

    Shares of one target add as chances do, 1 - (1-a)(1-b): two half smiles are no grin and a half. While the track
    "mouth" is active, the emotion leaves it most of the mouth.
    """
    speaking = tracks.get("mouth", {})
    spoken = [values for name, values in speaking.items() if name != "viseme_sil"]
    loud = np.clip(np.sum(spoken, axis=0), 0.0, 1.0) if spoken else None
    free: dict[str, Array] = {}
    for track, weights in tracks.items():
        for name, values in weights.items():
            own = np.clip(values, 0.0, 1.0)
            if track == "emotion" and loud is not None and name.startswith(MOUTH):
                own = own * (1.0 - (1.0 - MOUTH_LEFT) * loud)
            free[name] = free.get(name, np.ones(len(own))) * (1.0 - own)
    return {name: 1.0 - rest for name, rest in free.items()}
