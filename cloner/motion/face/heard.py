"""Mouth shapes from speech sound: a small net over spectral band energies.

Twenty-four bands on the scale of hearing, every hundredth second, against the speech's own mean; eleven moments from
.09 s before to .09 s after tell the net which of the fifteen shapes a mouth makes. It was taught on synthetic voices of
four languages whose phonemes are known (generic_models/build/visemes.py); one voice, never taught, judges.

References
----------
S. Davis, P. Mermelstein 1980 (bands on the scale of hearing).
"""

from __future__ import annotations

import functools
import importlib.resources
from typing import Final

import numpy as np

from cloner.records.arrays import Array

FILE: Final = "visemes.npz"
#: Samples a second; bands of the spectrum and their range, Hz: usual in recognising speech, not tried against others.
RATE_HZ: Final = 16_000
SIZE, STEP, SPECTRUM = 400, 160, 512  # samples: 25 ms, 10 ms
BANDS: Final = 24
RANGE_HZ: Final = (80.0, 7600.0)
#: Moments around a frame that tell its shape, hundredths of a second.
AROUND: Final = (-9, -6, -4, -2, -1, 0, 1, 2, 4, 6, 9)
#: Quieter bands than this share of the loud frames' whole power are silence.
FLOOR: Final = 1e-5
LOUD: Final = 0.02


def heard_visemes(sound: Array) -> Array:
    """Return (F, 15) shares of the mouth shapes, one row a hundredth second, of `RATE_HZ` samples a second."""
    net = _net()
    hidden = np.maximum(around(bands(sound)) @ net["hidden"] + net["hidden_bias"], 0.0)
    score = hidden @ net["out"] + net["out_bias"]
    share = np.exp(score - score.max(axis=1, keepdims=True))
    return np.asarray(share / share.sum(axis=1, keepdims=True))


def bands(sound: Array) -> Array:
    """Return (F, BANDS) the logarithms of the bands' power against the loud frames' mean."""
    count = max((len(sound) - SIZE) // STEP + 1, 1)
    padded = np.pad(sound, (0, max(SIZE + (count - 1) * STEP - len(sound), 0)))
    frames = np.lib.stride_tricks.sliding_window_view(padded, SIZE)[::STEP][:count] * np.hanning(SIZE)
    power = np.abs(np.fft.rfft(frames, SPECTRUM)) ** 2 @ _filters().T
    whole = power.sum(axis=1)
    top = max(float(np.percentile(whole, 95)), 1e-12)
    logs = np.log(power / top + FLOOR)
    return np.asarray(logs - logs[whole > LOUD * top].mean(axis=0))


def around(rows: Array) -> Array:
    """Return (F, BANDS * 11) every frame with those around it; the ends repeat."""
    places = np.clip(np.arange(len(rows))[:, None] + np.array(AROUND), 0, len(rows) - 1)
    return np.asarray(rows[places].reshape(len(rows), -1))


@functools.cache
def _filters() -> Array:
    """Return (BANDS, SPECTRUM / 2 + 1) triangles that overlap by half, evenly on the scale of hearing."""
    hertz = np.linspace(0.0, RATE_HZ / 2, SPECTRUM // 2 + 1)
    mel, (low, high) = _mel(hertz), _mel(np.array(RANGE_HZ))
    edges = np.linspace(low, high, BANDS + 2)
    rising = (mel - edges[:-2, None]) / (edges[1:-1] - edges[:-2])[:, None]
    falling = (edges[2:, None] - mel) / (edges[2:] - edges[1:-1])[:, None]
    return np.asarray(np.clip(np.minimum(rising, falling), 0.0, None))


def _mel(hertz: Array) -> Array:
    return np.asarray(2595.0 * np.log10(1.0 + hertz / 700.0))


@functools.cache
def _net() -> dict[str, Array]:
    place = importlib.resources.files("cloner_models") / FILE
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        return {name: archive[name].astype(np.float64) for name in ("hidden", "hidden_bias", "out", "out_bias")}
