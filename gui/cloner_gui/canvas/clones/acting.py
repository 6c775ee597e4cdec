"""A clone for display: posed, with a facial expression, and in one display mode."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.generic.layers import Layer, clone_layers
from cloner.generic.surfaces import load_surfaces
from cloner.motion.face.expressions import EXPRESSIONS, Beat, Envelope, play
from cloner.motion.face.speech import phoneme_visemes
from cloner.motion.face.talk import talk
from cloner.motion.limbs.body import body_of
from cloner.motion.moves.gait import idle, walk
from cloner.motion.moves.wave import wave
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.motions import Motion

Image = NDArray[np.uint8]

#: Ways of looking at a clone.
MODES: Final = ("textured", "shaded", "wire", "gaps")
#: How a body is shown while it grows: as the outline of a drawn figure, never bare.
OUTLINE: Final = "outline"
#: What a clone can be seen doing.
MOTIONS: Final = ("stand", "walk", "idle", "blink", "smile", "talk", "wave")
#: Gap between clone and photo outline that is painted fully red, mm: a finger's breadth, where people begin to see it.
GAP_SHOWN_MM: Final = 15.0
_GREY: Final = (0.78, 0.77, 0.75)
_HAIR_GREY: Final = (0.52, 0.50, 0.48)
_BLINK: Final = {"eyeBlinkLeft": 1.0, "eyeBlinkRight": 1.0}
#: "Hello, nice to meet you", phonemes with their seconds.
_HELLO: Final = tuple(
    (sound, 0.11 if len(sound) > 1 and sound[-1].isdigit() else 0.075)
    for sound in "HH AH0 L OW1 SIL N AY1 S SIL T UW1 SIL M IY1 T SIL Y UW1 SIL SIL SIL SIL".split()
)


def find_motion(kind: str, clone: Clone) -> Motion | None:
    """Return a clone's motion of one of `MOTIONS`; None for standing still.

    Raises
    ------
    ValueError
        If the kind is not known.
    """
    if kind not in MOTIONS:
        raise ValueError(f"{kind!r} is no motion; known are {', '.join(MOTIONS)}")
    made: Mapping[str, Callable[[Clone], Motion]] = {
        "walk": lambda one: walk(body_of(one)),
        "idle": lambda one: idle(body_of(one)),
        "blink": lambda one: _with_face(one, _BLINK, Envelope(0.10, 0.05, 0.15), (0.4, 1.6, 1.95)),
        "smile": lambda one: _with_face(one, EXPRESSIONS["joy"], Envelope(0.5, 1.4, 0.7), (0.2,)),
        "wave": lambda one: wave(body_of(one)),
        "talk": lambda one: talk(body_of(one), "hello", phoneme_visemes(_HELLO)),
    }
    return made[kind](clone) if kind in made else None


def _with_face(clone: Clone, weights: Mapping[str, float], envelope: Envelope, starts_s: tuple[float, ...]) -> Motion:
    """Return the clone standing idly while an expression comes and goes."""
    standing = idle(body_of(clone))
    shown = play([Beat(start, weights, envelope) for start in starts_s], standing.times_s % 3.0)
    return replace(standing, weights=shown)


def motion_seconds(motion: Motion) -> float:
    """Return a motion's duration."""
    return float(motion.times_s[-1])


def pose_at(clone: Clone, motion: Motion | None, seconds: float) -> tuple[Clone, Array | None, Array]:
    """Return the clone with the face at a time, its joints' rotations (94, 3), and its root's position, (3,) m."""
    if motion is None:
        return clone, None, np.zeros(3)
    frame = int(np.searchsorted(motion.times_s, seconds % motion_seconds(motion)))
    weights = {name: float(values[frame]) for name, values in motion.weights.items()}
    return with_face(clone, weights), motion.rotations[frame], motion.root_m[frame]


def with_face(clone: Clone, weights: Mapping[str, float]) -> Clone:
    """Return the clone with weighted morph targets; unknown targets are ignored."""
    vertices = clone.vertices_m.copy()
    for number, name in enumerate(clone.morph_names):
        weight = weights.get(name, 0.0)
        if weight > 1e-3:
            rows = slice(int(clone.morph_start[number]), int(clone.morph_start[number + 1]))
            vertices[clone.morph_index[rows]] += weight * clone.morph_delta_m[rows]
    moved = vertices - clone.vertices_m
    shells = tuple(
        replace(shell, vertices_m=shell.vertices_m + moved[shell.rides]) if len(shell.rides) else shell
        for shell in clone.shells
    )
    return replace(clone, vertices_m=vertices, shells=shells)


def display_meshes(clone: Clone, rotations: Array | None, mode: str, gaps_mm: Array | None) -> list[Layer]:
    """Return a posed clone's meshes for one of `MODES`.

    Parameters
    ----------
    gaps_mm : (V,) or None
        Distances that "gaps" paints, mm; NaN where none is known.
    """
    layers = clone_layers(clone, rotations)
    if mode == "textured":
        return layers
    skins, count = load_surfaces(), len(load_surfaces())
    bare = [layer for layer, surface in zip(layers, skins, strict=False) if surface.rgba is None]
    if mode == "gaps":
        values = np.full(len(clone.vertices_m), np.nan) if gaps_mm is None else gaps_mm
        places = [surface.vertex for surface in skins if surface.rgba is None]
        return [_painted(layer, values[rows]) for layer, rows in zip(bare, places, strict=True)]
    loose = [replace(layer, texture=None, colour=_HAIR_GREY) for layer in layers[count:]]
    return [replace(layer, texture=None, colour=_GREY) for layer in bare] + loose


def _painted(layer: Layer, gaps_mm: Array) -> Layer:
    """Return a mesh painted from blue (no gap) over white and yellow to red; grey where nothing is known."""
    ramp = _ramp()
    share = np.clip(gaps_mm / GAP_SHOWN_MM, 0.0, 1.0)
    last = ramp.shape[1] - 1
    column = np.where(np.isnan(share), last, share * (last - 2))
    uv = np.column_stack([(column + 0.5) / ramp.shape[1], np.full(len(column), 0.5)])
    return replace(layer, uv=uv, texture=ramp)


def _ramp() -> Image:
    """Return the (4, 128, 3) colours of gaps; the last column is the grey of the unknown."""
    places, colours = zip(*GAP_COLOURS, strict=True)
    row = np.stack([np.interp(np.linspace(0.0, 1.0, 127), places, channel) for channel in zip(*colours, strict=True)])
    ramp = np.vstack([row.T, [150.0, 150.0, 150.0]]).round().astype(np.uint8)
    return np.ascontiguousarray(np.tile(ramp[None], (4, 1, 1)))


#: Share of `GAP_SHOWN_MM` and sRGB colour; blue to red through pale yellow also for those who confuse red and green.
GAP_COLOURS: Final = (
    (0.0, (49, 84, 165)),
    (0.2, (116, 173, 209)),
    (0.4, (224, 236, 218)),
    (0.6, (254, 205, 110)),
    (0.8, (240, 110, 60)),
    (1.0, (165, 10, 35)),
)
