"""Lips meet for every p, b and m, by phonemes and by sound; words are spoken where espeak-ng is installed."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.io import wavfile

from cloner.errors import ClonerError
from cloner.generic.face_grids import lip_gaps_m, mouth_grid
from cloner.head.targets import face_targets
from cloner.motion.face import espeak, speech
from cloner.motion.face.talk import spoken_visemes
from kit.clones import toy_clone
from kit.lips import MIDLINE_M, closed

SPEECH = Path(__file__).resolve().parents[2] / "kit" / "speech"
needs_espeak = pytest.mark.skipif(
    not espeak.has_espeak(), reason="espeak-ng is not here; run: apt-get install espeak-ng"
)


@pytest.fixture(scope="module")
def clone():
    return toy_clone(1.70)


@pytest.mark.parametrize("path", sorted(SPEECH.glob("*.txt")), ids=lambda path: path.stem)
def test_lips_meet_for_the_phonemes_of_known_speech(clone, path: Path) -> None:
    phonemes = speech.read_phonemes(path)
    assert np.mean(closed(clone, spoken_visemes(path), phonemes)) >= 0.95
    assert np.mean(closed(clone, spoken_visemes(path.with_suffix(".wav")), phonemes)) >= 0.8, "by sound"


@pytest.mark.parametrize(
    ("phoneme", "viseme"),
    [("ʃ", "CH"), ("tʃ", "CH"), ("yː", "U"), ("øː", "O"), ("ɔø", "O"), ("θ", "TH"), ("ʁ", "RR"), ("aɪ", "aa"),
     ("pf", "FF"), ("AA1", "aa"), ("b", "PP"), ("sil", "sil")],
)  # fmt: skip
def test_the_alphabet_of_phonetics_is_understood(phoneme: str, viseme: str) -> None:
    assert speech.viseme_of(phoneme) == viseme


def test_every_phoneme_leads_at_its_middle() -> None:
    phonemes = [("h", 0.06), ("ə", 0.05), ("l", 0.05), ("oʊ", 0.2), ("b", 0.05), ("m", 0.09), ("iː", 0.1), ("z", 0.1)]
    shares, start = speech.phoneme_visemes(phonemes), 0.0
    for phoneme, length in phonemes:
        row = shares[round((start + length / 2.0) / speech.STEP_S - 0.5)]
        assert speech.VISEMES[row.argmax()] == speech.viseme_of(phoneme)
        start += length


@needs_espeak
@pytest.mark.parametrize(
    ("voice", "text"),
    [("en-us", "My mum may buy a big blue map before summer."), ("de", "Oma backt Brot und kocht Suppe mit Bohnen.")],
)
def test_written_words_are_spoken_and_lips_meet_by_their_sound_too(
    clone, tmp_path: Path, voice: str, text: str
) -> None:
    rate, sound, phonemes = espeak.spoken(text, voice)
    assert sum(length for _, length in phonemes) == pytest.approx(len(sound) / rate, abs=0.01)
    words = tmp_path / f"say.{voice}.txt"
    words.write_text(text)
    assert np.mean(closed(clone, spoken_visemes(words), phonemes)) >= 0.95
    wavfile.write(tmp_path / "say.wav", rate, sound)
    assert np.mean(closed(clone, spoken_visemes(tmp_path / "say.wav"), phonemes)) >= 0.8


def test_words_without_espeak_are_refused_in_words(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr(espeak.ctypes.util, "find_library", lambda name: None)
    path = tmp_path / "say.txt"
    path.write_text("Hello there, how are you?")
    with pytest.raises(ClonerError) as caught:
        spoken_visemes(path)
    assert "espeak-ng" in caught.value.message


def test_an_open_mouth_is_an_oval_and_a_tongue_passes_between_the_lips(clone) -> None:
    """Half way to a corner an ellipse stands 87 % as open as in the middle, a V 50 %; a tongue needs 5 mm."""
    grid, rest = mouth_grid(), clone.vertices_m
    names, index, delta, start = face_targets(rest)

    def shape(name: str) -> np.ndarray:
        moved, k = rest.copy(), names.index(name)
        rows = slice(int(start[k]), int(start[k + 1]))
        moved[index[rows]] += delta[rows]
        return moved

    for name in ("jawOpen", "viseme_O", "mouthFunnel"):
        moved = shape(name)[grid.rings]
        gap, aside = lip_gaps_m(grid, moved), np.abs(moved[grid.margin, :, 0])
        half = aside.max() / 2.0
        order = np.argsort(aside[grid.upper])
        at_half = np.interp(half, aside[grid.upper][order], gap[grid.upper][order])
        assert at_half > 0.7 * gap.max(), name
    out = shape("tongueOut")
    gap = lip_gaps_m(grid, out[grid.rings])[np.abs(rest[grid.ring(0), 0]) < MIDLINE_M]
    assert gap.max() > 0.005
