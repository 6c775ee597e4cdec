"""Whether the lips of a talking clone meet for what is said."""

from __future__ import annotations

import numpy as np

from cloner.generic.face_grids import lip_gaps_m, mouth_grid
from cloner.generic.morphs import target_offsets
from cloner.motion.face import speech
from cloner.motion.face.limits import limited
from cloner.motion.face.talk import talk
from cloner.motion.limbs.body import body_of
from cloner.records.clones import Clone

MARGIN_S, MIDLINE_M, CLOSED_M = 0.02, 0.006, 0.001


def closed(clone: Clone, shares: np.ndarray, phonemes: list[tuple[str, float]]) -> list[bool]:
    """For every p, b and m: is the smallest gap of the inner lips' midline, 20 ms around it, below a millimetre?"""
    motion = talk(body_of(clone), "x", shares)
    weights = limited(clone, motion.weights)
    grid = mouth_grid()
    moves = {name: offsets[grid.rings].astype(float) for name, offsets in target_offsets(clone) if name in weights}
    rest, found, start = clone.vertices_m[grid.rings], [], 0.0
    middle = np.abs(rest[grid.margin][:, 0]) < MIDLINE_M
    for phoneme, length in phonemes:
        end = start + length
        if speech.viseme_of(phoneme) == "PP":
            frames = np.flatnonzero((motion.times_s >= start - MARGIN_S) & (motion.times_s <= end + MARGIN_S))
            gaps = []
            for frame in frames:
                shape = rest + sum(values[frame] * moves[name] for name, values in weights.items() if name in moves)
                gaps.append(lip_gaps_m(grid, shape)[middle].max())
            found.append(min(gaps) < CLOSED_M)
        start = end
    return found
