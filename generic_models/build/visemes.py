"""Teach the net that hears mouth shapes, and write ``visemes.npz``.

    python generic_models/build/visemes.py --sentences 900 --text FILE... --out generic_models/cloner_models

Needs espeak-ng and flite (Debian) and scikit-learn, for building only. Random words of the given texts (English first,
then any of German, French, Turkish as FILE:de, FILE:fr, FILE:tr) are spoken by voices of both programs, whose phonemes
and times they tell themselves; microphones are varied by tilt and noise, and every sentence is heard a second time,
faster and higher or slower and lower, as from a smaller or larger head. The voice "rms" of flite is never taught: it
judges. What the programs speak is their output and under no licence of theirs.
"""

from __future__ import annotations

import argparse
import random
import re
import subprocess
import tempfile
from pathlib import Path
from typing import Final

import numpy as np
from scipy.io import wavfile
from scipy.signal import resample_poly

from cloner.motion.face.espeak import spoken
from cloner.motion.face.heard import RATE_HZ, around, bands
from cloner.motion.face.speech import VISEMES, viseme_of

VARIANTS: Final = ("", "", "+m1", "+m2", "+m3", "+m4", "+m5", "+m6", "+m7", "+f1", "+f2", "+f3", "+f4", "+klatt")
FLITE: Final = ("awb", "kal16", "slt")
FLITE_SHARE: Final = 0.4
ENGLISH: Final = ("en", "en-us", "en-gb-x-rp", "en-gb-scotland")
HIDDEN, ROUNDS = 192, 20
#: The second hearing of a sentence is so many per cent as long; people's vocal tracts differ by as much.
WARPS: Final = (86, 114)
FLITE_NAMES: Final = {"pau": "SIL", "ax": "ə"}


def words_of(texts: list[str]) -> dict[str, list[str]]:
    """Return the words of every language."""
    found: dict[str, list[str]] = {}
    for entry in texts:
        file, _, language = entry.partition(":")
        words = re.findall(r"[^\W\d_]{3,12}", re.sub(r"<[^>]*>", " ", Path(file).read_text(errors="ignore")).lower())
        found.setdefault(language or "en", []).extend(sorted(set(words)))
    return found


def sentence(words: list[str]) -> str:
    """Return six to eleven random words."""
    return " ".join(random.choices(words, k=random.randint(6, 11))) + "."


def by_flite(voice: str, text: str) -> tuple[int, np.ndarray, list[tuple[str, float]]]:
    """Return what flite speaks, as `spoken` does for espeak-ng."""
    with tempfile.NamedTemporaryFile(suffix=".wav") as file:
        told = subprocess.run(["flite", "-voice", voice, "-t", text, "-psdur", "-o", file.name],
                              capture_output=True, text=True, check=True).stdout  # fmt: skip
        rate, sound = wavfile.read(file.name)
    ends = [(name, float(end)) for name, end in (entry.rsplit(":", 1) for entry in told.split())]
    starts = [0.0, *(end for _, end in ends)]
    return rate, sound, [(FLITE_NAMES.get(n, n.upper()), end - s) for (n, end), s in zip(ends, starts, strict=False)]


def said(words: dict[str, list[str]]) -> tuple[np.ndarray, list[tuple[str, float]]]:
    """Return one spoken sentence, `RATE_HZ` samples a second, and its phonemes with their seconds."""
    if random.random() < FLITE_SHARE:
        rate, sound, phonemes = by_flite(random.choice(FLITE), sentence(words["en"]))
    else:
        language = random.choice([key for key in words for _ in range(3 if key in ("en", "de") else 1)])
        voice = (random.choice(ENGLISH) if language == "en" else language) + random.choice(VARIANTS)
        rate, sound, phonemes = spoken(sentence(words[language]), voice, random.randint(115, 190))
    divisor = int(np.gcd(rate, RATE_HZ))
    return resample_poly(sound / 32768.0, RATE_HZ // divisor, rate // divisor), phonemes


def example(sound: np.ndarray, phonemes: list[tuple[str, float]], per_cent: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the inputs (F, 264) and the shapes' numbers (F,) of a sentence heard so long."""
    heard = resample_poly(sound, per_cent, 100)
    heard[1:] += random.uniform(-0.5, 0.5) * heard[:-1]
    heard += random.choice([0.0, 0.0005, 0.002, 0.006]) * np.random.default_rng(len(heard)).normal(size=len(heard))
    rows = bands(heard)
    ends = 0.01 * per_cent * np.cumsum([seconds for _, seconds in phonemes])
    shapes = np.array([VISEMES.index(viseme_of(name)) for name, _ in phonemes])
    middles = 0.0125 + 0.01 * np.arange(len(rows))
    return around(rows).astype(np.float32), shapes[np.minimum(np.searchsorted(ends, middles), len(shapes) - 1)]


def main() -> None:
    """Speak, teach and write."""
    from sklearn.neural_network import MLPClassifier

    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sentences", type=int, default=1000)
    parser.add_argument("--text", nargs="+", required=True)
    parser.add_argument("--out", type=Path, required=True)
    asked = parser.parse_args()
    random.seed(0)
    words, rows = words_of(asked.text), []
    while len(rows) < 2 * asked.sentences:
        try:
            sound, phonemes = said(words)
            rows += [example(sound, phonemes, per_cent) for per_cent in (100, random.randint(*WARPS))]
        except Exception as error:  # noqa: BLE001 - a word that a voice cannot say
            print("left out:", error)
    inputs, shapes = (np.concatenate(part) for part in zip(*rows, strict=True))
    lips = np.flatnonzero((shapes == VISEMES.index("PP")) | (shapes == VISEMES.index("FF")))
    chosen = np.concatenate([np.arange(len(shapes)), lips])  # lips that meet count twice
    mean, spread = inputs.mean(axis=0), inputs.std(axis=0) + 1e-3
    net = MLPClassifier((HIDDEN,), batch_size=1024, max_iter=ROUNDS, learning_rate_init=2e-3, alpha=1e-5,
                        random_state=0, verbose=True)  # fmt: skip
    net.fit((inputs[chosen] - mean) / spread, shapes[chosen])
    first, second = net.coefs_
    np.savez_compressed(
        asked.out / "visemes.npz",
        hidden=(first / spread[:, None]).astype(np.float16),
        hidden_bias=(net.intercepts_[0] - (mean / spread) @ first).astype(np.float32),
        out=second.astype(np.float16),
        out_bias=net.intercepts_[1].astype(np.float32),
    )


if __name__ == "__main__":
    main()
