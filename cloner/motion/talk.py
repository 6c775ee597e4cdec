"""A clone that speaks: the mouth follows the speech, eyes blink, head and brows stress it."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from cloner.motion import turns
from cloner.motion.body import Body
from cloner.motion.expressions import Beat, Envelope, mixed, play
from cloner.motion.gait import idle
from cloner.motion.speech import (
    frame_features,
    mouth_weights,
    phoneme_visemes,
    read_phonemes,
    read_wav,
    sound_visemes,
)
from cloner.records.motions import Motion

Array = NDArray[np.float64]

FRAMES_PER_S: Final = 30.0
BLINK: Final = {"eyeBlinkLeft": 1.0, "eyeBlinkRight": 1.0}
_BLINK_ENVELOPE: Final = Envelope(0.08, 0.03, 0.13)
BLINK_EVERY_S: Final = 3.4  # taste; people blink 15 to 20 times a minute
NOD: Final = 0.035  # radians of nodding at the loudest; taste


def talk(body: Body, path: Path) -> Motion:
    """Return the motion of a clone that says what a .wav file or a list of phonemes holds.

    Raises
    ------
    ClonerError
        If the file cannot be read.
    """
    if path.suffix.lower() == ".wav":
        return speak(body, path.stem, sound_visemes(frame_features(read_wav(path))))
    return speak(body, path.stem, phoneme_visemes(read_phonemes(path)))


def speak(body: Body, name: str, shares: Array) -> Motion:
    """Return the motion of a clone whose mouth takes (F, 15) shares of the mouth's shapes, see ``speech``."""
    times, mouth = mouth_weights(shares, FRAMES_PER_S)
    blinks = [Beat(at, BLINK, _BLINK_ENVELOPE) for at in np.arange(0.9, times[-1], BLINK_EVERY_S)]
    loud = gaussian_filter1d(np.clip(sum(mouth.values()), 0.0, 1.0), 0.15 * FRAMES_PER_S)
    brows = {"browInnerUp": 0.25 * loud, "browOuterUpLeft": 0.15 * loud, "browOuterUpRight": 0.15 * loud}
    weights = mixed({"mouth": mouth, "eyes": play(blinks, times), "brows": brows})
    standing = idle(body)
    rows = np.arange(len(times)) % (len(standing.times_s) - 1)
    rotations = standing.rotations[rows].copy()
    for joint, axis, angle in (
        ("skullbase", 0, NOD * loud),
        ("vc4", 1, 0.03 * np.sin(2.0 * np.pi * times / 4.3) * loud),
    ):
        own = body.joint(joint)
        rotations[:, own] = turns.vectors(turns.matrices(rotations[:, own]) @ turns.about(axis, angle))
    return Motion(name, times, standing.root_m[rows], rotations, weights)
