"""Visemes: names, mapping from phonemes, and coarticulation.

What is heard in a sound instead: ``cloner.motion.face.sound``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Final

import numpy as np
from scipy.ndimage import gaussian_filter1d

from cloner.errors import ClonerError
from cloner.motion.moves.contact import runs
from cloner.records.arrays import Array
from cloner.untrusted import read_untrusted_text

#: From one row of mouth shapes to the next, seconds.
STEP_S: Final = 0.01
#: Longest speech, seconds (taste).
LONGEST_S: Final = 600.0
LARGEST_BYTES: Final = 10_000_000  # of a list of phonemes
VISEMES: Final = ("sil", "PP", "FF", "TH", "DD", "kk", "CH", "SS", "nn", "RR", "aa", "E", "I", "O", "U")
_HEARD_S: Final = 0.015  # what a net hears from one hundredth second to the next is evened over this time
_MUST_MEET: Final = 2.0
#: From one phoneme's shape to the next a mouth goes within this time of their border, seconds, or middle to middle.
_GLIDE_S: Final = 0.08
#: Lips stay shut for a p, b or m from this long before its middle to this long after, seconds, so that 30 pictures a
#: second show it, and lower lip and teeth meet for an f or v; they come and go within `_SHUTS_S`.
_SHUT_S: Final = MappingProxyType({"PP": 0.03, "FF": 0.015})
_SHUTS_S: Final = 0.04
#: Consonants that leave the lips free take so much of the rounding of a vowel beside them; taste.
_ROUNDED: Final = 0.35
_FREE: Final = ("TH", "DD", "kk", "CH", "SS", "nn", "RR")
#: ARPAbet phonemes by mouth shape.
_PHONEMES: Final[Mapping[str, str]] = MappingProxyType({
    "sil": "SIL SP", "PP": "P B M", "FF": "F V", "TH": "TH DH", "DD": "T D", "kk": "K G NG HH", "CH": "CH JH SH ZH",
    "SS": "S Z", "nn": "N L", "RR": "R ER", "aa": "AA AE AH AY AW", "E": "EH EY", "I": "IH IY Y", "O": "OW AO OY",
    "U": "UW UH W",
})  # fmt: skip
_VISEME_OF: Final = {phoneme: viseme for viseme, row in _PHONEMES.items() for phoneme in row.split()}
#: The alphabet of phonetics (IPA), without length and stress; what has two letters goes before its first letter.
_IPA: Final[Mapping[str, str]] = MappingProxyType({
    "PP": "p b m ɱ", "FF": "f v pf ʋ", "TH": "θ ð", "DD": "t d ɾ ʈ ɖ", "kk": "k ɡ g ŋ x ç h ɦ ɣ χ ʔ q c ɟ",
    "CH": "tʃ dʒ ʃ ʒ tɕ ɕ", "SS": "s z ts dz", "nn": "n l ɫ ɲ ʎ ɬ", "RR": "r ɹ ɻ ʁ ʀ ɚ ɝ ɜ", "aa": "a ɑ æ ʌ ɐ ä",
    "E": "e ɛ ə ɘ", "I": "i ɪ ᵻ j ɨ ɯ", "O": "o ɔ ɒ ø œ ɵ ɤ", "U": "u ʊ w y ʏ ʉ ɥ",
})  # fmt: skip
_IPA_OF: Final = {phoneme: viseme for viseme, row in _IPA.items() for phoneme in row.split()}


def viseme_of(phoneme: str) -> str:
    """Return the mouth shape of a phoneme, in ARPAbet or in the alphabet of phonetics (IPA).

    Raises
    ------
    ClonerError
        If the phoneme is not known.
    """
    found = _VISEME_OF.get(phoneme.rstrip("012").upper())
    for letters in (phoneme[:2], phoneme[:1]):
        found = found or _IPA_OF.get(letters)
    if found is None:
        hint = f"Use IPA or ARPAbet: {' '.join(_VISEME_OF)}"
        raise ClonerError(f"the phoneme {phoneme!r} is not known", hint, "phonemes")
    return found


def phoneme_visemes(phonemes: Sequence[tuple[str, float]]) -> Array:
    """Return (F, 15) shares of the mouth shapes of phonemes with their lengths in seconds; each leads at its middle.

    Raises
    ------
    ClonerError
        If a phoneme is not known or a length is not between 0 and 10 seconds.
    """
    shapes: list[int] = []
    for phoneme, seconds in phonemes:
        shapes.append(VISEMES.index(viseme_of(phoneme)))
        if not 0.0 < seconds <= 10.0:
            raise ClonerError(f"{phoneme} lasts {seconds} s", "Give lengths between 0 and 10 seconds", "phonemes")
    if not shapes:
        raise ClonerError("there is no phoneme", 'Write lines like "AA1 0.12"', "phonemes")
    lengths = np.array([seconds for _, seconds in phonemes])
    if lengths.sum() > LONGEST_S:
        raise ClonerError(f"they last longer than {LONGEST_S / 60:.0f} minutes", "Cut them", "phonemes")
    return _glided(shapes, lengths)


def _glided(shapes: Sequence[int], lengths: Array) -> Array:
    """Return (F, 15) shares that go from every shape to the next in a half wave about their border."""
    ends = np.cumsum(lengths)
    times = (np.arange(max(round(float(ends[-1]) / STEP_S), 1)) + 0.5) * STEP_S
    shares = np.zeros((len(times), len(VISEMES)))
    half = np.minimum(lengths / 2.0, _GLIDE_S)
    rising = np.ones_like(times)
    for number, shape in enumerate(shapes):
        falling = np.ones_like(times)
        if number + 1 < len(shapes):
            first, last = ends[number] - half[number], ends[number] + half[number + 1]
            place = np.clip((times - first) / (last - first), 0.0, 1.0)
            falling = 0.5 + 0.5 * np.cos(np.pi * place)
        own = rising * falling
        beside = [shapes[near] for near in (number - 1, number + 1) if 0 <= near < len(shapes)]
        rounds = [near for near in beside if VISEMES[near] in ("O", "U")]
        if rounds and VISEMES[shape] in _FREE:
            shares[:, rounds[-1]] += _ROUNDED * own
            own = (1.0 - _ROUNDED) * own
        shares[:, shape] += own
        rising = 1.0 - falling
    return np.asarray(shares / shares.sum(axis=1, keepdims=True))


def read_phonemes(path: Path) -> list[tuple[str, float]]:
    """Return the phonemes of a text file: one a line with its length in seconds, "AA1 0.12".

    Raises
    ------
    ClonerError
        If the file is missing or a line is not that.
    """
    text = read_untrusted_text(path, "the phonemes", "Give a text file", LARGEST_BYTES)
    try:
        lines = [line.split() for line in text.splitlines() if line.strip()]
        return [(line[0], float(line[1])) for line in lines]
    except (ValueError, IndexError) as error:
        raise ClonerError(
            "a line holds no phoneme with its seconds", 'Write lines like "AA1 0.12"', path.name
        ) from error


def mouth_weights(shares: Array, frames_per_s: float) -> tuple[Array, dict[str, Array]]:
    """Return times (F,), seconds, and the weights of the viseme targets: lips that meet do so wholly and in time."""
    shut = _shut(shares)
    duration = len(shares) * STEP_S
    times = np.arange(round(duration * frames_per_s) + 1) / frames_per_s
    own = (np.arange(len(shares)) + 0.5) * STEP_S
    weights = {
        f"viseme_{name}": np.interp(times, own, shut[:, column]) for column, name in enumerate(VISEMES) if column > 0
    }
    for values in weights.values():
        values[[0, -1]] = 0.0  # a mouth begins and ends at rest
    return times, weights


def _shut(shares: Array) -> Array:
    """Return the shares with every closure whole: at its middle nothing else moves the lips."""
    out, times = shares.copy(), (np.arange(len(shares)) + 0.5) * STEP_S
    leads = shares.argmax(axis=1)
    for name, half in _SHUT_S.items():
        column = VISEMES.index(name)
        closed = np.zeros(len(shares))
        for first, last in runs(leads == column):
            away = np.abs(times - (times[first] + times[last]) / 2.0)
            closed = np.maximum(closed, np.clip((half + _SHUTS_S - away) / _SHUTS_S, 0.0, 1.0))
        out *= 1.0 - closed[:, None]
        out[:, column] = np.maximum(out[:, column] + closed, closed)
    return np.asarray(np.clip(out, 0.0, 1.0))


def smoothed(shares: Array) -> Array:
    """Return shares that were heard, as smooth as mouths move; lips that may meet count double: they must not gape."""
    weighed = shares * np.where(np.isin(VISEMES, list(_SHUT_S)), _MUST_MEET, 1.0)
    weighed /= weighed.sum(axis=1, keepdims=True)
    return np.asarray(gaussian_filter1d(weighed, _HEARD_S / STEP_S, axis=0, mode="nearest"))
