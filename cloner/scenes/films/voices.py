"""What is said in a film: files beside it become faces that move, sounds of the page, and what the film's ear hears."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.io import wavfile
from scipy.signal import oaconvolve, resample_poly

from cloner.acting.written import SpokenParts
from cloner.crowd.clones.faces import TARGETS, WEIGHTS
from cloner.crowd.drawing.player import SPOKEN_FILE
from cloner.crowd.packs.files import packed
from cloner.crowd.staged.faces import MOST_AT_ONCE, MOST_SAID, Said
from cloner.crowd.staged.faces import RATE_HZ as FACES_HZ
from cloner.errors import ClonerError
from cloner.motion.face.sound import wav_bytes
from cloner.motion.face.talk import Speech, face_weights, speech_in
from cloner.records.arrays import Array
from cloner.scenes.films.sequence import Sequence as Film

#: Samples a second of what is heard, and how much of the room's echo, as in ``sound.js``.
RATE_HZ: Final = 48_000
WET, WET_ELSEWHERE = 0.9, 0.15
#: Browsers scale impulse responses to this share of a root mean square of 1 at 44.1 kHz (Web Audio, ConvolverNode).
ECHO_RMS, ECHO_HZ = 0.00125, 44_100.0
#: How often places of ear and mouths are asked, a second; nobody walks half a metre meanwhile.
ASKED_HZ: Final = 25.0

#: Where the ear is at a time, which way is right, and where somebody's head is: (3,) each, metres.
Ear = Callable[[float, int], tuple[Array, Array, Array]]


@dataclass(frozen=True, slots=True, eq=False)
class Voices:
    """All that is said: by whom and when, and each one's sound (N,) of `RATE_HZ`, -1..1."""

    said: tuple[Said, ...]
    sounds: tuple[Array, ...]


def voices_of(film: Film, folder: Path) -> tuple[SpokenParts, Voices] | None:
    """Return what is said in a film whose files lie in a folder, for its pack and for its ear; None without any.

    Raises
    ------
    ClonerError
        If a file cannot be read, or too many speak at a time.
    """
    if not film.speeches:
        return None
    speeches = {name: speech_in(folder / name) for _, _, name in film.speeches}
    rows = {name: _rows(speech) for name, speech in speeches.items()}
    files = {name: f"speech/{number}.wav" for number, name in enumerate(speeches) if len(speeches[name].sound)}
    first = dict(zip(rows, np.cumsum([0, *(len(one) for one in rows.values())]).tolist(), strict=False))
    said = tuple(
        Said(who, when, first[name], len(rows[name]), files.get(name, ""))
        for when, actors, name in sorted(film.speeches, key=lambda one: one[0])
        for who in actors
    )
    _check_at_once(film, said)
    data, told = packed({"weights": np.concatenate(list(rows.values()))})
    kept = {SPOKEN_FILE: data} | {
        file: wav_bytes(speeches[name].sound, speeches[name].rate_hz) for name, file in files.items()
    }
    sounds = {file: _at_rate(speeches[name].sound, speeches[name].rate_hz) for name, file in files.items()}
    heard = tuple(sounds.get(one.sound, np.zeros(0)) for one in said)
    return SpokenParts(kept, {"arrays": told, "said": [asdict(one) for one in said]}), Voices(said, heard)


def _rows(speech: Speech) -> NDArray[np.float32]:
    """Return (F, WEIGHTS) weights of the face of who says it."""
    _, weights = face_weights(speech.shares)
    out = np.zeros((len(next(iter(weights.values()))), WEIGHTS), np.float32)
    for name, values in weights.items():
        if name in TARGETS:
            out[:, TARGETS.index(name)] = values
    return out


def _check_at_once(film: Film, said: Sequence[Said]) -> None:
    if len(said) > MOST_SAID:
        raise ClonerError(f"{len(said)} speeches are too many", f"Let at most {MOST_SAID} be said", "the film")
    ends = [one.when + (one.frames - 1) / FACES_HZ for one in said]
    for one in said:
        speak = [other for other, end in zip(said, ends, strict=True) if other.when <= one.when < end]
        if len(speak) > MOST_AT_ONCE:
            message = f"{len(speak)} speak at {one.when:g} s"
            raise ClonerError(message, f"Let at most {MOST_AT_ONCE} speak at a time", "the film")
        if sum(other.who == one.who for other in speak) > 1:
            message = f"{film.actors[one.who].name} is still speaking at {one.when:g} s"
            raise ClonerError(message, "Let one speech end before the next begins", "the film")


def _at_rate(sound: Array, rate_hz: int) -> Array:
    """Return sound of any rate as one of `RATE_HZ`."""
    divisor = int(np.gcd(rate_hz, RATE_HZ))
    return np.asarray(resample_poly(sound, RATE_HZ // divisor, rate_hz // divisor))


def heard(
    voices: Voices, seconds: float, ear: Ear, echo: tuple[bytes, Sequence[float]] | None = None
) -> NDArray[np.float32]:
    """Return (N, 2) what a film's ear hears, left and right, of `RATE_HZ`; no sample is beyond -1..1.

    Parameters
    ----------
    voices : Voices
    seconds : how long the film is
    ear : callable
        See `Ear`.
    echo : a WAV file's bytes and the borders (x, z, x, z) of where the room has that echo
    """
    count = round(seconds * RATE_HZ)
    out, dry = np.zeros((count, 2), np.float32), np.zeros(count, np.float32)
    for one, sound in zip(voices.said, voices.sounds, strict=True):
        begin = round(one.when * RATE_HZ)
        own = sound[: max(count - begin, 0)]
        if not len(own):
            continue
        times = np.arange(len(own)) / RATE_HZ
        asked = np.arange(0.0, times[-1] + 1.0 / ASKED_HZ, 1.0 / ASKED_HZ)
        places = [ear(min(one.when + t, seconds), one.who) for t in asked]
        away = np.array([head - at for at, _, head in places])
        far = np.maximum(np.linalg.norm(away, axis=1), 1.0)  # as panners of pages: all of it within a metre
        side = np.array([way @ right for way, (_, right, _) in zip(away, places, strict=True)]) / far
        loud, pan = np.interp(times, asked, 1.0 / far), np.interp(times, asked, side)
        turn = (pan + 1.0) * np.pi / 4.0  # equal power
        part = slice(begin, begin + len(own))
        out[part] += (loud * own)[:, None] * np.column_stack([np.cos(turn), np.sin(turn)])
        wet = 0.0 if echo is None else np.array([_wet(at, echo[1]) for at, _, _ in places])
        dry[part] += np.interp(times, asked, np.broadcast_to(wet, len(asked))) * loud * own
    if echo is not None:
        rate, ring = wavfile.read(io.BytesIO(echo[0]))
        ring = _at_rate(ring.astype(np.float64), rate)
        ring *= ECHO_RMS * ECHO_HZ / RATE_HZ / max(float(np.sqrt((ring**2).mean())), 1e-12)
        out += oaconvolve(dry, ring.astype(np.float32))[:count, None]
    return np.asarray(out / np.float32(max(float(np.abs(out).max(initial=0.0)), 1.0)))


def _wet(at: Array, borders: Sequence[float]) -> float:
    x0, z0, x1, z1 = borders
    return WET if x0 <= at[0] <= x1 and z0 <= at[2] <= z1 else WET * WET_ELSEWHERE
