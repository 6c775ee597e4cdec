"""Random numbers by seed, purpose and person, independent of the order of requests.

SplitMix64 (Steele, Lea, Flood 2014) used as a hash of a counter: 64-bit integers only, so a page's core gives the same.
"""

from __future__ import annotations

import zlib
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array

Indices = NDArray[np.int64]

#: Steps and mixing of SplitMix64 (Steele, Lea, Flood 2014): 2^64 over the golden ratio, in 64 bits.
_GOLDEN: Final = 0x9E3779B97F4A7C15
_MASK: Final = (1 << 64) - 1


def purpose_number(name: str, count: int = 0) -> int:
    """Return the number of a purpose, such as "split", and of how often it occurred."""
    return (zlib.crc32(name.encode("utf-8")) << 32) ^ count


def _mixed(z: NDArray[np.uint64]) -> NDArray[np.uint64]:
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return np.asarray(z ^ (z >> np.uint64(31)))


def uniform(seed: int, what: int, who: Indices) -> Array:
    """Return one number in 0..1 per person, (n,): equal for equal seed, purpose and person."""
    start = np.array([(seed * _GOLDEN) & _MASK, what & _MASK], np.uint64)
    base = _mixed(_mixed(start[:1]) + start[1:])
    z = _mixed(_mixed(base + who.astype(np.uint64) * np.uint64(_GOLDEN)))
    return np.asarray((z >> np.uint64(11)).astype(np.float64) * 2.0**-53)


def normal(seed: int, what: int, who: Indices) -> Array:
    """Return numbers of mean 0 and standard deviation 1, (n,): the sum of twelve uniform ones, so at most six."""
    total = np.zeros(len(who))
    for k in range(12):
        total = total + uniform(seed, what + (k + 1) * 0x1000003, who)
    return total - 6.0


def shuffled(seed: int, what: int, who: Indices) -> Indices:
    """Return the people in a random order, (n,)."""
    return who[np.argsort(uniform(seed, what, who), kind="stable")]
