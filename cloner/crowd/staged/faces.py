"""Speech in a film and the facial motion of the speakers; ``faces.js`` plays the same."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

#: Rows of weights a second, as of every clip of a face.
RATE_HZ: Final = 30.0
#: Shaders know so many faces at a time that move; a choir of more is refused.
MOST_AT_ONCE: Final = 8
#: Speeches of a film: bounds what a hostile one can make us hold.
MOST_SAID: Final = 1_000


@dataclass(frozen=True, slots=True)
class Utterance:
    """One utterance: who, start in seconds, the first row of weights, the number of rows, the sound's file or ""."""

    who: int
    when: float
    first: int
    frames: int
    sound: str


@dataclass(frozen=True, slots=True, eq=False)
class SpeechTrack:
    """All speech: (F, K) weights of `cloner.crowd.clones.faces.TARGETS`, padded, and who says which rows."""

    weights: NDArray[np.float32]
    said: Sequence[Utterance]

    def faces(self, now: float) -> tuple[list[int], NDArray[np.float32]]:
        """Return who speaks at a time, and the (n, K) weights of those faces."""
        who: list[int] = []
        rows: list[NDArray[np.float32]] = []
        for one in self.said:
            at = (now - one.when) * RATE_HZ
            if not 0.0 <= at <= one.frames - 1 or one.who in who or len(who) == MOST_AT_ONCE:
                continue
            row = min(int(at), max(one.frames - 2, 0))
            first, last = self.weights[one.first + row], self.weights[one.first + min(row + 1, one.frames - 1)]
            who.append(one.who)
            rows.append(first + (last - first) * np.float32(at - row))
        return who, np.array(rows, np.float32).reshape(len(who), self.weights.shape[1])


def faces_values(who: Sequence[int], weights: NDArray[np.float32]) -> dict[str, Any]:
    """Return the uniforms of :meth:`SpeechTrack.faces`."""
    speaks, mouths = np.full(MOST_AT_ONCE, -1), np.zeros((MOST_AT_ONCE, weights.shape[1]), np.float32)
    speaks[: len(who)], mouths[: len(who)] = who, weights
    return {"speakers": len(who), "speaks": tuple(speaks.tolist()),
            "mouths": [tuple(one) for one in mouths.reshape(-1, 4).tolist()]}  # fmt: skip
