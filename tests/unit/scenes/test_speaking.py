"""What is said in films: by which files, heard from where, kept in which bytes; and how feelings come and go."""

from __future__ import annotations

import struct
from pathlib import Path

import cv2
import numpy as np
import pytest
from scipy.io import wavfile

from cloner.crowd.clones.faces import TARGETS
from cloner.crowd.staged.faces import MOST_AT_ONCE, SpeechTrack, Utterance
from cloner.crowd.staged.footing import COLUMNS, FEELS, FROM, LAST, UNTIL, Acted, feelings_at
from cloner.errors import ClonerError
from cloner.scenes.films.hearing import RATE_HZ, Source, mix_stereo
from cloner.scenes.films.sequence import parse_sequence
from cloner.scenes.films.voices import read_voices
from cloner.vision.photographs.films import write_film

BEGIN = """film "Talk" for 4 s, 64 x 48, 4 frames a second
actor ada is ada at 1, 4
rows choir of 3 x 3 from 0, 8 to 2, 12
rows pair of 2 x 1 from 4, 8 to 6, 8
at 0 s: camera at 1, 0, 1.5 looks at ada
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "mama.txt").write_text("M 0.2\nAA 0.2\nM 0.2\nAA 0.2\n")
    tone = np.sin(np.arange(16_000) * 2.0 * np.pi * 220.0 / 16_000)
    wavfile.write(tmp_path / "tone.wav", 16_000, (8_000 * tone).astype(np.int16))
    return tmp_path


def test_lips_meet_when_phonemes_say_so_and_a_sound_is_kept(folder: Path) -> None:
    parts, voices = read_voices(
        parse_sequence(BEGIN + 'at 1 s: ada says "mama.txt"\nat 2 s: pair says "tone.wav"\n', "a"), folder
    ) or pytest.fail("nobody speaks")
    assert [one.when for one in voices.said] == [1.0, 2.0, 2.0]
    assert sorted(parts.files) == ["speech/1.wav", "spoken.bin"], "phonemes make no sound"
    assert len(voices.sounds[1]) == RATE_HZ


def test_a_mouth_is_between_two_rows_and_still_before_and_after() -> None:
    weights = np.zeros((3, 20), np.float32)
    weights[1, TARGETS.index("viseme_aa")] = 1.0
    spoken = SpeechTrack(weights, (Utterance(4, 1.0, 0, 3, ""),))
    assert spoken.faces(0.99)[0] == spoken.faces(1.08)[0] == []
    who, rows = spoken.faces(1.0 + 0.5 / 30.0)
    assert who == [4]
    assert rows[0, TARGETS.index("viseme_aa")] == pytest.approx(0.5, abs=1e-5)


def test_too_many_at_a_time_or_one_twice_is_told(folder: Path) -> None:
    nine = parse_sequence(BEGIN + 'at 1 s: choir says "mama.txt"\n', "a")
    with pytest.raises(ClonerError, match=rf"9 speak at 1 s\. Let at most {MOST_AT_ONCE} speak"):
        read_voices(nine, folder)
    with pytest.raises(ClonerError, match=r"ada is still speaking at 1\.5 s"):
        read_voices(parse_sequence(BEGIN + 'at 1 s: ada says "mama.txt"\nat 1.5 s: ada says "tone.wav"\n', "a"), folder)
    with pytest.raises(ClonerError, match=r"none\.wav"):
        read_voices(parse_sequence(BEGIN + 'at 1 s: ada says "none.wav"\n', "a"), folder)
    assert read_voices(parse_sequence(BEGIN, "a"), folder) is None


def test_who_is_on_the_right_is_heard_there_and_louder_when_near() -> None:
    tone = np.sin(np.arange(RATE_HZ) * 0.05)

    def energy(head: tuple[float, float, float]) -> np.ndarray:
        out = mix_stereo(
            [Source(0.5, 0, tone)], 2.0, lambda *_: (np.zeros(3), np.array([1.0, 0.0, 0.0]), np.array(head))
        )
        assert not out[: RATE_HZ // 2].any()
        assert not out[RATE_HZ // 2 + RATE_HZ :].any()
        return np.asarray((out**2).sum(axis=0))

    right, ahead, far = energy((2.0, 0.0, 0.0)), energy((0.0, 0.0, -2.0)), energy((0.0, 0.0, -4.0))
    assert right[0] < 1e-6 * right[1]
    assert ahead[0] == pytest.approx(ahead[1])
    assert ahead.sum() == pytest.approx(4.0 * far.sum(), rel=1e-3), "by the square of how far"


def test_a_room_rings_after_the_voice_where_it_has_an_echo() -> None:
    import io

    stream, ring = io.BytesIO(), np.zeros(22_050, np.int16)
    ring[11_025] = 30_000
    wavfile.write(stream, 22_050, ring)
    said = [Source(0.0, 0, np.sin(np.arange(4_800) * 0.05))]
    ear = lambda *_: (np.zeros(3), np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, -2.0]))  # noqa: E731
    inside, outside = (mix_stereo(said, 2.0, ear, (stream.getvalue(), box)) for box in ((-5, -5, 5, 5), (8, 8, 9, 9)))
    late = slice(round(0.49 * RATE_HZ), round(0.62 * RATE_HZ))
    assert np.abs(inside[late]).max() == pytest.approx(np.abs(outside[late]).max() / 0.15, rel=1e-3)
    assert np.abs(outside[late]).max() > 1e-3


def test_a_film_keeps_its_sound_sample_for_sample(tmp_path: Path) -> None:
    sound = np.random.default_rng(1).uniform(-1.0, 1.0, (round(2.4 * RATE_HZ), 2))
    shown = [np.full((48, 64, 3), 10 * k, np.uint8) for k in range(10)]
    write_film(iter(shown), 4.0, tmp_path / "a.mp4", "told", sound, RATE_HZ)
    film = cv2.VideoCapture(str(tmp_path / "a.mp4"))
    assert film.get(cv2.CAP_PROP_FRAME_COUNT) == 10
    assert film.read()[1].mean() == pytest.approx(0.0, abs=3.0)
    data = (tmp_path / "a.mp4").read_bytes()
    track = data.index(b"sowt")
    table = data.index(b"co64", track)
    count = struct.unpack_from(">I", data, table + 8)[0]
    firsts = struct.unpack_from(f">{count}Q", data, table + 12)
    kept = b"".join(data[first : first + 4 * RATE_HZ] for first in firsts)[: 4 * len(sound)]
    assert count == 3
    assert np.array_equal(np.frombuffer(kept, "<i2").reshape(-1, 2), np.rint(sound * 32767.0))
    assert data.endswith(b"told")


def test_a_face_goes_over_from_one_feeling_to_another() -> None:
    footings = np.zeros((2, COLUMNS), np.float32)
    footings[:, [FROM, UNTIL, LAST, FEELS]] = [[0.0, 2.0, -1.0, 3.0], [2.0, 4.0, -1.0, 5.0]]
    acted = Acted(
        footings, np.array([0, 2], np.uint32), np.zeros((1, 5, 4), np.float32),
        np.zeros((1, 6, 48, 6), np.float32), np.ones((1, 6, 2), np.float32),
    )  # fmt: skip
    found = {now: feelings_at(acted, now)[0].tolist() for now in (0.1, 1.9, 2.0, 2.15, 2.29, 2.31, 2.45, 2.6, 3.9)}
    assert [clip for clip, _ in found.values()] == [3, 3, 3, 3, 3, 5, 5, 5, 5]
    shares = [share for _, share in found.values()]
    assert shares == pytest.approx([1.0, 1.0, 1.0, 0.5, 0.1 / 3.0, 0.1 / 3.0, 0.5, 1.0, 1.0], abs=1e-5)
