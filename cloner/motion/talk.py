"""A clone that speaks: the mouth follows the speech, eyes blink, head and brows stress it, a score adds the rest."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from cloner.motion import turns
from cloner.motion.body import Body
from cloner.motion.expressions import Beat, mixed, play
from cloner.motion.gait import idle
from cloner.motion.score import GESTURES, QUICK, SILENT, Score
from cloner.motion.speech import (
    frame_features,
    mouth_weights,
    phoneme_visemes,
    read_phonemes,
    read_wav,
    smoothed,
    sound_visemes,
)
from cloner.records.motions import Motion

Array = NDArray[np.float64]

FRAMES_PER_S: Final = 30.0
BLINK_EVERY_S: Final = 3.4  # taste; people blink 15 to 20 times a minute
NOD: Final = 0.035  # radians of nodding at the loudest; taste
TURN: Final = 0.03


def spoken_visemes(path: Path) -> Array:
    """Return (F, 15) shares of the mouth shapes of a .wav file or a list of phonemes, one row a hundredth second.

    Raises
    ------
    ClonerError
        If the file cannot be read.
    """
    if path.suffix.lower() == ".wav":
        return smoothed(sound_visemes(frame_features(read_wav(path))))
    return phoneme_visemes(read_phonemes(path))


def talk(body: Body, name: str, shares: Array, score: Score = SILENT) -> Motion:
    """Return the motion of a clone that speaks.

    Parameters
    ----------
    body : Body
    name : str
    shares : (F, 15)
        As :func:`spoken_visemes` gives them.
    score : Score
        What else the face does meanwhile; eyes that have a track of their own do not blink by themselves.
    """
    times, mouth = mouth_weights(shares, FRAMES_PER_S)
    loud = gaussian_filter1d(np.clip(sum(mouth.values()), 0.0, 1.0), 0.15 * FRAMES_PER_S)
    tracks = {"eyes": _blinks(times), "brows": _stress(loud)} | score.weights(times)
    tracks["mouth"] = mouth | tracks.get("mouth", {})
    angles = score.head_angles(times)
    angles[:, 0] += NOD * loud
    angles[:, 1] += TURN * np.sin(2.0 * np.pi * times / 4.3) * loud
    return _standing(body, name, times, angles, mixed(tracks))


def scored(body: Body, name: str, score: Score) -> Motion:
    """Return the motion of a clone that stands and plays a score."""
    times = np.arange(round(max(score.duration_s(), 1.0 / FRAMES_PER_S) * FRAMES_PER_S) + 1) / FRAMES_PER_S
    tracks = {"eyes": _blinks(times)} | score.weights(times)
    return _standing(body, name, times, score.head_angles(times), mixed(tracks))


def _blinks(times_s: Array) -> dict[str, Array]:
    return play([Beat(at, GESTURES["blink"], QUICK) for at in np.arange(0.9, times_s[-1], BLINK_EVERY_S)], times_s)


def _stress(loud: Array) -> dict[str, Array]:
    return {"browInnerUp": 0.25 * loud, "browOuterUpLeft": 0.15 * loud, "browOuterUpRight": 0.15 * loud}


def _standing(body: Body, name: str, times_s: Array, head: Array, weights: Mapping[str, Array]) -> Motion:
    """Return the motion of somebody who stands with a moving head (F, 3), half of it in the neck, and face."""
    rest = idle(body)
    rows = np.arange(len(times_s)) % (len(rest.times_s) - 1)
    rotations = rest.rotations[rows].copy()
    for joint in ("skullbase", "vc4"):
        own = body.joint(joint)
        rotations[:, own] = turns.vectors(turns.matrices(rotations[:, own]) @ turns.matrices(0.5 * head))
    return Motion(name, times_s, rest.root_m[rows], rotations, dict(weights))
