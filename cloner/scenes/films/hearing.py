"""Spatial sound of a film: distance, direction and the room's echo at the camera."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.io import wavfile
from scipy.signal import oaconvolve, resample_poly

from cloner.records.arrays import Array

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
class Source:
    """A sound (N,) at `RATE_HZ`, -1..1, its start, and its source: a person's head, or a position (3,) if given."""

    when: float
    who: int
    sound: Array
    place: Array | None = None


def resample(sound: Array, rate_hz: int) -> Array:
    """Return a sound of any rate at `RATE_HZ`."""
    divisor = int(np.gcd(rate_hz, RATE_HZ))
    return np.asarray(resample_poly(sound, RATE_HZ // divisor, rate_hz // divisor))


def mix_stereo(
    sources: Sequence[Source], seconds: float, ear: Ear, echo: tuple[bytes, Sequence[float]] | None = None
) -> NDArray[np.float32]:
    """Return the stereo sound (N, 2) at the film's camera at `RATE_HZ`; no sample exceeds -1..1.

    Parameters
    ----------
    sources : sequence of Source
    seconds : how long the film is
    ear : callable
        See `Ear`.
    echo : a WAV file's bytes and the borders (x, z, x, z) of where the room has that echo
    """
    count = round(seconds * RATE_HZ)
    out, dry = np.zeros((count, 2), np.float32), np.zeros(count, np.float32)
    for one in sources:
        begin = round(one.when * RATE_HZ)
        own = one.sound[: max(count - begin, 0)]
        if not len(own):
            continue
        times = np.arange(len(own)) / RATE_HZ
        last = times[-1] if one.place is None else 0.0
        asked = np.arange(0.0, last + 1.0 / ASKED_HZ, 1.0 / ASKED_HZ)
        places = [ear(min(one.when + t, seconds), one.who) for t in asked]
        away = np.array([(head if one.place is None else one.place) - at for at, _, head in places])
        far = np.maximum(np.linalg.norm(away, axis=1), 1.0)  # as panners of pages: all of it within a metre
        side = np.array([way @ right for way, (_, right, _) in zip(away, places, strict=True)]) / far
        loud, pan = np.interp(times, asked, 1.0 / far), np.interp(times, asked, side)
        turn = (pan + 1.0) * np.pi / 4.0  # equal power
        part = slice(begin, begin + len(own))
        out[part] += (loud * own)[:, None] * np.column_stack([np.cos(turn), np.sin(turn)])
        wet = 0.0 if echo is None else np.array([_reverberated(at, echo[1]) for at, _, _ in places])
        dry[part] += np.interp(times, asked, np.broadcast_to(wet, len(asked))) * loud * own
    if echo is not None:
        rate, ring = wavfile.read(io.BytesIO(echo[0]))
        ring = resample(ring.astype(np.float64), rate)
        ring *= ECHO_RMS * ECHO_HZ / RATE_HZ / max(float(np.sqrt((ring**2).mean())), 1e-12)
        out += oaconvolve(dry, ring.astype(np.float32))[:count, None]
    return np.asarray(out / np.float32(max(float(np.abs(out).max(initial=0.0)), 1.0)))


def _reverberated(at: Array, borders: Sequence[float]) -> float:
    """Return whether the room's echo applies at a position."""
    x0, z0, x1, z1 = borders
    return WET if x0 <= at[0] <= x1 and z0 <= at[2] <= z1 else WET * WET_ELSEWHERE
