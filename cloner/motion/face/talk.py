"""A speaking clone: mouth from speech, blinks, head and brow movements on stress, and a score."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
from scipy.ndimage import gaussian_filter1d

from cloner.motion.face.espeak import spoken
from cloner.motion.face.expressions import Beat, mixed, play
from cloner.motion.face.heard import heard_visemes
from cloner.motion.face.score import GESTURES, QUICK, SILENT, Score
from cloner.motion.face.sound import FRAME_S, RATE_HZ, frame_features, read_sound, resampled, sound_visemes
from cloner.motion.face.speech import LARGEST_BYTES, STEP_S, mouth_weights, phoneme_visemes, read_phonemes, smoothed
from cloner.motion.limbs import turns
from cloner.motion.limbs.body import Body
from cloner.motion.moves.gait import idle
from cloner.records.arrays import Array
from cloner.records.motions import Motion
from cloner.untrusted import read_untrusted_text

#: Frames a second of every clip.
FRAMES_PER_S: Final = 30.0
#: How much formants and hiss count beside the net. It hears bands against their own mean, so nothing in a vowel that is
#: held; with .3 lips meet for 91 to 100 % of p, b, m (.2: 89 to 98), with .4 fewer vowels lead on every voice.
BY_FORMANTS: Final = 0.3
#: How far the middle of what is listened to lies behind the middle of a row, rows: 12.5 ms after its start, not 5.
LATE: Final = (0.5 * FRAME_S - 0.5 * STEP_S) / STEP_S
BLINK_EVERY_S: Final = 3.4  # taste; people blink 15 to 20 times a minute
NOD: Final = 0.035  # radians of nodding at the loudest; taste
TURN: Final = 0.03


@dataclass(frozen=True, slots=True, eq=False)
class Speech:
    """What somebody says.

    Attributes
    ----------
    shares : (F, 15) of the mouth shapes, one row a hundredth second
    rate_hz : int
    sound : (N,) -1..1 at that rate; of none, where only phonemes are told
    """

    shares: Array
    rate_hz: int
    sound: Array


def speech_in(path: Path) -> Speech:
    """Return the speech in a .wav file, phonemes or words.

    A .txt file holds phonemes, one a line with its seconds, or else words for espeak-ng; its language stands between
    two dots of the file's name, "hello.de.txt".

    Raises
    ------
    ClonerError
        If the file cannot be read.
    """
    if path.suffix.lower() == ".wav":
        rate, sound = read_sound(path)
        return Speech(_heard(resampled(rate, sound)), rate, sound / np.abs(sound).max())
    words = _words_in(path)
    if words is None:
        return Speech(phoneme_visemes(read_phonemes(path)), RATE_HZ, np.zeros(0))
    language = path.suffixes[-2][1:] if len(path.suffixes) > 1 else "en-us"
    rate, samples, phonemes = spoken(words, language)
    return Speech(phoneme_visemes(phonemes), rate, samples / max(float(np.abs(samples).max()), 1.0))


def spoken_visemes(path: Path) -> Array:
    """Return (F, 15) shares of the mouth shapes of :func:`speech_in`."""
    return speech_in(path).shares


def _heard(sound: Array) -> Array:
    """Return (F, 15) shares of what a net hears and what formants, hiss and silence tell.

    The net knows voices like those it was taught with; linear prediction knows any voice, less surely.
    """
    net, plain = heard_visemes(sound), sound_visemes(frame_features(sound))
    count = min(len(net), len(plain))
    heard = (1.0 - BY_FORMANTS) * net[:count] + BY_FORMANTS * plain[:count]
    # a row tells of the middle of the sound that was listened to, three quarters of a row after its own
    before = heard[np.maximum(np.arange(count) - 1, 0)]
    return smoothed(LATE * before + (1.0 - LATE) * heard)


def _words_in(path: Path) -> str | None:
    """Return the words of a text, None where its first line is a name with a number: a phoneme and its seconds.

    Raises
    ------
    ClonerError
        If the file cannot be read.
    """
    text = read_untrusted_text(path, "the text", "Give a text file", LARGEST_BYTES).strip()
    if not text:
        return None  # the reader of phonemes says so
    first = next(line.split() for line in text.splitlines() if line.strip())
    phonemes = len(first) == 2 and re.fullmatch(r"[+-]?(\d+\.?\d*|\.\d+|nan|inf)", first[1])
    return None if phonemes else text


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
    times, mouth, tracks, loud = _speaking(shares)
    tracks |= score.weights(times)
    tracks["mouth"] = mouth | tracks.get("mouth", {})
    angles = score.head_angles(times)
    angles[:, 0] += NOD * loud
    angles[:, 1] += TURN * np.sin(2.0 * np.pi * times / 4.3) * loud
    return _standing(body, name, times, angles, mixed(tracks))


def face_weights(shares: Array) -> tuple[Array, dict[str, Array]]:
    """Return times (F,), seconds, and weights of the targets of a face that speaks and does nothing else.

    Parameters
    ----------
    shares : (F, 15)
        As :func:`spoken_visemes` gives them.
    """
    times, mouth, tracks, _ = _speaking(shares)
    return times, mixed(tracks | {"mouth": mouth})


def _speaking(shares: Array) -> tuple[Array, dict[str, Array], dict[str, dict[str, Array]], Array]:
    """Return times, the mouth, the tracks of eyes and brows, and how loud it is; (F,) each."""
    times, mouth = mouth_weights(shares, FRAMES_PER_S)
    loud = gaussian_filter1d(np.clip(sum(mouth.values()), 0.0, 1.0), 0.15 * FRAMES_PER_S)
    return times, mouth, {"eyes": _blinks(times), "brows": _stress(loud)}, loud


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
