"""The smooth step and the half wave: how something fades in or out without a kink."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray


def smoothstep(values: Any, low: float = 0.0, high: float = 1.0) -> NDArray[Any]:
    """Return 0 where values are at or below ``low``, 1 at or above ``high``, and ``3 s² - 2 s³`` of their way between.

    Parameters
    ----------
    values : array_like of float, any shape
    low, high : float
        In the unit of ``values``; ``low < high``.

    Returns
    -------
    ndarray
        Of the shape of ``values``; float32 stays float32.
    """
    share = np.clip((values - low) / (high - low), 0.0, 1.0)
    return np.asarray(share * share * (3.0 - 2.0 * share))


def half_wave(share: Any) -> NDArray[Any]:
    """Return 0 at 0, 1 at 1, and half a wave of a cosine between; ``share`` of any shape, 0..1."""
    return np.asarray(0.5 - 0.5 * np.cos(np.pi * share))
