"""Faces move by MPEG-4 parameters, by expressions over time, and by speech."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.io import wavfile
from scipy.signal import lfilter

from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner.motion.face import faps, speech
from cloner.motion.face import sound as sound_file
from cloner.motion.face.expressions import EXPRESSIONS, Beat, Envelope, mixed, play
from cloner.motion.face.score import SILENT, emotion_score, read_score
from cloner.motion.face.talk import scored, spoken_visemes, talk
from cloner.motion.limbs.body import body_of
from kit.clones import toy_clone

SPEECH = Path(__file__).resolve().parents[2] / "kit" / "speech"
RATE = sound_file.RATE_HZ


@pytest.fixture(scope="module")
def clone():
    return toy_clone(1.70)


def voiced(formants: tuple[float, ...], seconds: float = 0.4, pitch_hz: float = 120.0) -> np.ndarray:
    """A vowel by source and filter: pulses through resonances of the given places."""
    signal = np.zeros(int(seconds * RATE))
    signal[:: int(RATE / pitch_hz)] = 1.0
    signal = lfilter([1.0], np.convolve([1.0, -0.97], [1.0, -0.97]), signal)  # the glottis: 12 dB less an octave
    for hertz, width in zip(formants, (80.0, 100.0, 140.0, 200.0), strict=False):
        radius = np.exp(-np.pi * width / RATE)
        signal = lfilter([1.0], [1.0, -2.0 * radius * np.cos(2.0 * np.pi * hertz / RATE), radius**2], signal)
    signal = np.diff(signal, prepend=0.0)
    return signal / np.abs(signal).max()


@pytest.mark.parametrize(
    ("viseme", "formants"),
    [("aa", (750.0, 1230.0, 2500.0, 3500.0)), ("I", (300.0, 2350.0, 3000.0, 3600.0)),
     ("U", (340.0, 900.0, 2300.0, 3400.0)), ("E", (560.0, 1900.0, 2600.0, 3500.0)),
     ("O", (560.0, 880.0, 2450.0, 3400.0))],
)  # fmt: skip
@pytest.mark.parametrize("pitch_hz", [110.0, 210.0])
def test_vowels_made_of_known_resonances_are_told(viseme, formants, pitch_hz) -> None:
    frames = sound_file.frame_features(voiced(formants, pitch_hz=pitch_hz))
    shares = sound_file.sound_visemes(frames)[5:-5]
    assert speech.VISEMES[shares.mean(axis=0).argmax()] == viseme
    assert np.median(frames.pitch_hz[5:-5]) == pytest.approx(pitch_hz, rel=0.03)


def test_hiss_silence_and_closures_are_told() -> None:
    rng = np.random.default_rng(1)
    vowel = voiced((750.0, 1230.0, 2500.0, 3500.0))
    noise = rng.normal(size=int(0.3 * RATE))
    sharp = np.diff(np.diff(noise, prepend=0.0), prepend=0.0)
    quiet = np.zeros(int(0.5 * RATE))
    sound = np.concatenate([quiet, vowel, np.zeros(int(0.08 * RATE)), vowel, 0.4 * sharp / np.abs(sharp).max(), quiet])
    shares = sound_file.sound_visemes(sound_file.frame_features(sound))
    named = [speech.VISEMES[row] for row in shares.argmax(axis=1)]
    assert named[10] == named[-10] == "sil"
    assert named[int((0.5 + 0.2) * 100)] == "aa"
    assert named[int((0.9 + 0.04) * 100)] == "PP"
    assert named[int((0.9 + 0.08 + 0.4 + 0.15) * 100)] in ("SS", "CH")
    assert shares.sum(axis=1) == pytest.approx(1.0)


def test_phonemes_become_mouth_shapes_in_their_time() -> None:
    shares = speech.phoneme_visemes([("M", 0.1), ("AA1", 0.3), ("SIL", 0.1)])
    times, weights = speech.mouth_weights(shares, 30.0)
    assert times[-1] == pytest.approx(0.5)
    assert weights["viseme_aa"].argmax() in range(6, 11)
    assert weights["viseme_PP"][:4].max() > 0.5
    assert all(values[0] == values[-1] == 0.0 for values in weights.values())
    with pytest.raises(ClonerError) as caught:
        speech.phoneme_visemes([("XX", 0.1)])
    assert "ARPAbet" in caught.value.hint


def test_a_spoken_file_moves_mouth_and_lids_but_not_the_feet(clone, tmp_path: Path) -> None:
    path = tmp_path / "hello.wav"
    sound = np.concatenate([voiced((750.0, 1230.0, 2500.0, 3500.0), 1.0), np.zeros(4000)])
    wavfile.write(path, RATE, (20000 * sound).astype(np.int16))
    body = body_of(clone)
    motion = talk(body, "hello", spoken_visemes(path))
    assert motion.name == "hello"
    assert motion.weights["viseme_aa"].max() > 0.35
    spoken = {name: values[15] for name, values in motion.weights.items() if name.startswith("viseme_")}
    assert max(spoken, key=spoken.get) == "viseme_aa"
    assert motion.weights["eyeBlinkLeft"].max() > 0.8
    assert np.ptp(body.places(motion)[:, body.joint("l_ankle")], axis=0).max() < 1e-3


@pytest.mark.parametrize("content", [b"", b"RIFF1234WAVEfmt ", b"no sound"])
def test_broken_sounds_are_refused_in_words(content, tmp_path: Path) -> None:
    path = tmp_path / "broken.wav"
    path.write_bytes(content)
    with pytest.raises(ClonerError) as caught:
        sound_file.read_sound(path)
    assert caught.value.where == "broken.wav"


def test_units_of_the_face_are_its_own_proportions(clone) -> None:
    units = faps.face_units(clone)
    point = dict(zip(load_generic().fdp_names, clone.vertices_m[load_generic().fdp_vertices], strict=True))
    assert units["ES"] * 1024 == pytest.approx(point["3.5"][0] - point["3.6"][0])
    assert 0.050 < units["ES"] * 1024 < 0.075
    assert all(0.002 < unit * 1024 < 0.09 for unit in units.values())


@pytest.mark.parametrize(
    "wanted",
    [{"eyeBlinkLeft": 1.0}, {"jawOpen": 0.6}, {"mouthSmileLeft": 0.7, "mouthSmileRight": 0.7}, {"browInnerUp": 0.8}],
)
def test_weights_become_parameters_and_come_back_as_the_same_face(clone, wanted) -> None:
    """The face that the parameters play has every feature point where the weights have it, within 2.5 mm at worst."""
    stream = faps.stream_of(clone, {name: np.array([0.0, value]) for name, value in wanted.items()}, 25.0)
    back = faps.weights_of(clone, stream)
    before, after = shifted(clone, wanted), shifted(clone, {name: values[1] for name, values in back.items()})
    points = load_generic().fdp_vertices
    assert np.linalg.norm(before[points] - after[points], axis=1).max() < 0.0025
    assert np.linalg.norm(before[points] - after[points], axis=1).mean() < 0.0003
    assert max(np.linalg.norm(before[points], axis=1)) > 0.003
    assert all(values[0] == 0.0 for values in back.values())


def shifted(clone, weights) -> np.ndarray:
    offset = np.zeros((len(clone.vertices_m), 3))
    for name, weight in weights.items():
        k = clone.morph_names.index(name)
        rows = slice(int(clone.morph_start[k]), int(clone.morph_start[k + 1]))
        offset[clone.morph_index[rows]] += weight * clone.morph_delta_m[rows]
    return offset


def test_fap_files_come_back_and_broken_ones_are_refused(clone, tmp_path: Path) -> None:
    stream = faps.stream_of(clone, {"jawOpen": np.array([0.0, 0.5, 1.0])}, 25.0)
    path = tmp_path / "jaw.fap"
    path.write_text(faps.fap_text(stream, "jaw"))
    back = faps.read_fap(path)
    assert back.frames_per_s == 25.0
    assert (back.values == np.where(stream.given, stream.values, 0.0)).all()
    assert (back.given == stream.given).all()
    path.write_text(path.read_text().replace("0 0 0", "0 0", 1))
    with pytest.raises(ClonerError):
        faps.read_fap(path)


def test_positive_head_and_eye_turns_go_the_standards_way() -> None:
    values, given = np.zeros((1, 68)), np.zeros((1, 68), dtype=bool)
    for number in (48, 49, 50, 23):
        values[0, number - 1], given[0, number - 1] = 20_000.0, True
    names = tuple(load_generic().joint_names)
    rotations = faps.rotations_of(faps.FapStream(25.0, values, given), names)[0]
    assert rotations[names.index("skullbase")].tolist() == pytest.approx([0.2, 0.2, 0.2]), "down, left, right"
    assert rotations[names.index("l_eyeball_joint"), 1] == pytest.approx(0.2), "to the left"


def test_envelopes_rise_stay_and_fall() -> None:
    times = np.linspace(0.0, 3.0, 301)
    strength = Envelope(0.5, 1.0, 0.5).strength(times - 0.5)
    assert strength[times < 0.5].max() == 0.0
    assert strength[(times > 1.0) & (times < 2.0)].min() == pytest.approx(1.0)
    assert strength[times > 2.5].max() == pytest.approx(0.0)
    assert (np.diff(strength[times < 1.0]) >= 0.0).all()


def test_tracks_mix_without_sums_above_one_and_speech_keeps_its_mouth(clone) -> None:
    times = np.linspace(0.0, 1.0, 31)
    joy = play([Beat(-1.0, EXPRESSIONS["joy"], Envelope(0.1, 9.0, 0.1))], times)
    loud = {"viseme_aa": np.ones(31)}
    alone, spoken = mixed({"emotion": joy}), mixed({"emotion": joy, "mouth": loud})
    assert alone["mouthSmileLeft"].max() == pytest.approx(0.8)
    assert spoken["mouthSmileLeft"].max() < 0.35
    assert spoken["cheekSquintLeft"].max() == pytest.approx(0.5)
    twice = mixed({"emotion": joy, "brows": joy})
    assert all(values.max() <= 1.0 for values in twice.values())
    assert twice["mouthSmileLeft"].max() == pytest.approx(1 - 0.2**2)
    assert set(name for row in EXPRESSIONS.values() for name in row) <= set(clone.morph_names)


def score_of(tmp_path: Path, text: str, targets=("jawOpen",)):
    path = tmp_path / "face.toml"
    path.write_text(text)
    return read_score(path, targets)


JOY_AND_NOD = """
[[emotion]]
expression = "joy"
start = 0.5
attack = 0.4
sustain = 1.0
decay = 0.6

[[head]]
expression = "turn_left"
start = 1.0

[[eyes]]
expression = "blink"
start = 2.0
"""


def test_a_score_plays_its_tracks_each_in_its_own_time(clone, tmp_path: Path) -> None:
    body = body_of(clone)
    motion = scored(body, "face", score_of(tmp_path, JOY_AND_NOD))
    at = {second: int(np.abs(motion.times_s - second).argmin()) for second in (0.4, 1.2, 2.1, 2.5)}
    smile, lids = motion.weights["mouthSmileLeft"], motion.weights["eyeBlinkLeft"]
    assert smile[at[0.4]] == 0.0
    assert smile[at[1.2]] == pytest.approx(EXPRESSIONS["joy"]["mouthSmileLeft"])
    assert smile[at[2.5]] == pytest.approx(0.0, abs=1e-6)
    assert lids[at[2.1]] > 0.9
    assert lids[at[1.2]] == 0.0, "eyes with a track of their own blink when it says so"
    ahead = body.world(motion)[:, body.joint("skullbase"), :, 2]
    assert ahead[at[1.2], 0] - ahead[at[0.4], 0] > 0.15, "the head turns to the person's left"


def test_a_speech_in_a_mood_smiles_between_the_words_and_speaks_clearly(clone, tmp_path: Path) -> None:
    body = body_of(clone)
    shares = speech.phoneme_visemes([("SIL", 1.0), ("M", 0.15), ("AA1", 0.3), ("SIL", 1.5)])
    plain, glad = (talk(body, "x", shares, score) for score in (SILENT, emotion_score("joy", 2.95)))
    assert np.abs(glad.weights["viseme_PP"] - plain.weights["viseme_PP"]).max() < 1e-9
    smile = glad.weights["mouthSmileLeft"]
    assert smile[int(0.9 * 30)] > 0.7
    assert smile[int(1.15 * 30)] < 0.45, "speech has the mouth first"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[[emotion]\nexpression=", "no TOML"),
        ("[[ears]]\nexpression = 'joy'", "ears"),
        ("[[emotion]]\nexpression = 'glee'", "glee"),
        ("[[head]]\nexpression = 'joy'", "joy"),
        ("[[emotion]]\nexpression = 'joy'\nstart = nan", "0 and 600 s"),
        ("[[emotion]]\nexpression = 'joy'\nstart = 'soon'", "soon"),
        ("[[emotion]]\nexpression = 'joy'\nspeed = 2", "speed"),
        ("emotion = 3", "emotion"),
        ("emotion = [3]", "emotion"),
    ],
)
def test_broken_scores_are_refused_in_words(text: str, words: str, tmp_path: Path) -> None:
    with pytest.raises(ClonerError) as caught:
        score_of(tmp_path, text)
    assert words in caught.value.message
    assert caught.value.where == "face.toml"


@pytest.mark.parametrize("path", sorted(SPEECH.glob("*.wav")), ids=lambda path: path.stem)
def test_mouths_keep_the_time_of_known_phonemes(path: Path) -> None:
    """Shapes lead, or are half as strong as the leading one, within 60 ms of their phoneme's middle."""
    phonemes = speech.read_phonemes(path.with_suffix(".txt"))
    for source, least in ((path.with_suffix(".txt"), 0.85), (path, 0.6)):
        times, weights = speech.mouth_weights(spoken_visemes(source), 30.0)
        mouth = np.column_stack([weights.get(f"viseme_{name}", np.zeros(len(times))) for name in speech.VISEMES])
        mouth[:, 0] = np.clip(1.0 - mouth.sum(axis=1), 0.0, 1.0)
        middles = np.cumsum([length for _, length in phonemes]) - [length / 2.0 for _, length in phonemes]
        good = 0
        for middle, (phoneme, _) in zip(middles, phonemes, strict=True):
            near = mouth[np.abs(times - middle) <= 0.06]
            own = near[:, speech.VISEMES.index(speech.viseme_of(phoneme))]
            good += bool((own >= 0.5 * near.max(axis=1)).any())
        assert good / len(phonemes) >= least, source.name
