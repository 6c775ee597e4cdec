"""Facial motion of a crowd: targets of speech and four emotions, on the wedges that these move."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.crowd.clones.levels import BodyLevels
from cloner.generic.load import load_generic
from cloner.generic.morphs import target_offsets
from cloner.motion.face.expressions import EXPRESSIONS
from cloner.motion.face.speech import VISEMES
from cloner.records.clones import Clone

#: Mouth shapes, and what :func:`cloner.motion.face.talk.face_weights` moves beside them.
TARGETS: Final = (
    *(f"viseme_{name}" for name in VISEMES if name != "sil"),
    "eyeBlinkLeft", "eyeBlinkRight", "browInnerUp", "browOuterUpLeft", "browOuterUpRight",
)  # fmt: skip
#: Shaders read weights by fours: so many a face, the last ones of nothing.
WEIGHTS: Final = 20
#: What is seen on the face of who walks so (`cloner.motion.moves.styles`): expressions by strength; calm and regular
#: faces stay as they were photographed. One target each, behind the others.
FEELINGS: Final[Mapping[str, Mapping[str, float]]] = MappingProxyType({
    "walk_sad": {"sadness": 1.0}, "walk_happy": {"joy": 0.7}, "walk_explosive": {"joy": 1.0, "surprise": 0.25},
    "walk_afraid": {"fear": 1.0},
})  # fmt: skip
#: What a whole number stands for: the farthest target, a blink, moves by 16 mm, 16 bits reach 33.
STEP_M: Final = 1e-6


@functools.cache
def _face_vertices() -> NDArray[np.int64]:
    """Return the generic human's vertices that speech or any feeling moves."""
    generic = load_generic()
    found = []
    for names, start, index in (
        (generic.arkit_names, generic.arkit_start, generic.arkit_index),
        (generic.viseme_names, generic.viseme_start, generic.viseme_index),
    ):
        found += [
            index[start[k] : start[k + 1]] for k, name in enumerate(names) if name in {*TARGETS, *_feeling_weights()}
        ]
    return np.unique(np.concatenate(found)).astype(np.int64)


def face_wedges(body: BodyLevels) -> NDArray[np.int64]:
    """Return (N,) the wedges that faces move."""
    return np.flatnonzero(np.isin(body.vertex, _face_vertices()))


def face_rows(body: BodyLevels) -> NDArray[np.uint16]:
    """Return (V,) each wedge's number among those that faces move, from 1; 0 for the others."""
    wedges, rows = face_wedges(body), np.zeros(len(body.vertex), np.uint16)
    rows[wedges] = np.arange(1, len(wedges) + 1)
    return rows


def face_offsets(clone: Clone, body: BodyLevels) -> NDArray[np.int16]:
    """Return (WEIGHTS + feelings, N, 3) the offset of each wedge of :func:`face_wedges` by target, in `STEP_M`."""
    vertices, shown = body.vertex[face_wedges(body)], _feeling_weights()
    out = np.zeros((WEIGHTS + len(FEELINGS), len(vertices), 3))
    for name, offsets in target_offsets(clone):
        if name in TARGETS:
            out[TARGETS.index(name)] = offsets[vertices]
        for feeling, share in enumerate(shown.get(name, ())):
            out[WEIGHTS + feeling] += share * offsets[vertices]
    return np.clip(np.round(out / STEP_M), -32767, 32767).astype(np.int16)


@functools.cache
def _feeling_weights() -> Mapping[str, tuple[float, ...]]:
    """Return each feeling's weights of the targets that any of them uses."""
    names = {name for parts in FEELINGS.values() for part in parts for name in EXPRESSIONS[part]}
    return {
        name: tuple(
            sum(share * EXPRESSIONS[part].get(name, 0.0) for part, share in parts.items())
            for parts in FEELINGS.values()
        )
        for name in names
    }
