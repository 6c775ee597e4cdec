"""Acoustics of a room: impulse responses by ray tracing against the surfaces that are lit.

Rays leave a place evenly, lose what each surface takes, and go on diffusely (Lambert). From wherever they hit, part of
their energy comes straight to the ear if it is seen ("diffuse rain"). The energy of each millisecond shapes noise: what
early reflections do to a tone is not kept, how long and how evenly a room rings is. One band, about 1 kHz.

References: Heinz 1993, Binaural room simulation based on an image source model with addition of statistical methods to
include the diffuse sound scattering of walls (diffuse rain); Schroeder 1965 (backward integration); Eyring 1930.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array
from cloner.scenes.building.solids import Room
from cloner.scenes.lighting.rays import RayQuads, sphere_directions

SPEED_M_S: Final = 343.0  # of sound, at 20 degrees
RATE_HZ: Final = 22_050  # half of a compact disc's: steps and murmur hold nothing above
RAYS: Final = 1_500  # taste: a count
#: Rays end when so little of their energy is left, or after so long, seconds.
LEFT, LONGEST_S = 1e-6, 4.0
#: The ear's height, and how far before the speaker it is, metres: steps and voices at arm's length.
EAR_M, APART_M = 1.6, 1.0
STEP_S: Final = 1e-3
#: What surfaces take at 1 kHz, 0..1: of the order that usual tables have, from memory.
TAKES: Final = {
    "flags": 0.02, "cobbles": 0.04, "plaster": 0.05, "stone": 0.03, "timber": 0.09, "marble": 0.02, "earth": 0.35,
    "white": 0.05,
}  # fmt: skip
#: Nobody hears from a photo what a wall is made of: taste.
PHOTOS_TAKE_AS: Final = "plaster"
_SEED: Final = 17


@dataclass(frozen=True, slots=True, eq=False)
class Echo:
    """An impulse response: (n,) samples at RATE_HZ, at most 1, and the reverberation time (60 dB), seconds."""

    samples: Array
    rings_s: float


def impulse_response(room: Room, place: Array, rays: int = RAYS) -> Echo:
    """Return the impulse response of a clap at arm's length at a point (3,), metres, in the frame of rooms."""
    energy = energies(room, place + (APART_M, 0.0, 0.0), place, rays)
    return Echo(_shaped_noise(energy), reverberation_s(energy))


def energies(room: Room, source: Array, ear: Array, rays: int = RAYS) -> Array:
    """Return the energy (n,) received per millisecond, share of the emitted energy, per square metre."""
    stops, rng = RayQuads(room.stops), np.random.default_rng(_SEED)
    takes = np.array([TAKES.get(one.look, TAKES[PHOTOS_TAKE_AS]) for one in room.stops])
    out = np.zeros(round(LONGEST_S / STEP_S))
    straight = float(np.linalg.norm(ear - source))
    if stops.visible_from(ear, source[None])[0]:
        out[_slot(straight)] += 1.0 / (4.0 * np.pi * straight**2)
    at, directions = np.repeat(source[None], rays, axis=0), sphere_directions(rays)
    left, far = np.full(rays, 1.0 / rays), np.zeros(rays)
    while len(at):
        quad, away = _hits(stops, at, directions)
        there = quad >= 0
        at, directions, quad, left, far = (
            at[there],
            directions[there],
            quad[there],
            left[there],
            far[there] + away[there],
        )
        at = at + directions * away[there, None]
        left = left * (1.0 - takes[quad])
        normal = stops.normal[quad]
        at = at + normal * 1e-4
        to = ear - at
        reach = np.linalg.norm(to, axis=1)
        cosine = np.maximum((to * normal).sum(axis=1) / np.maximum(reach, 1e-9), 0.0)
        seen = np.flatnonzero(cosine > 0.0)
        seen = seen[stops.visible_from(ear, at[seen])] if len(seen) else seen
        slots = ((far[seen] + reach[seen]) / SPEED_M_S / STEP_S).astype(int)
        short = slots < len(out)
        np.add.at(out, slots[short], (left * cosine / (np.pi * np.maximum(reach, 0.3) ** 2))[seen][short])
        directions = _scattered(normal, rng)
        on = (left > LEFT / rays) & (far < LONGEST_S * SPEED_M_S)
        at, directions, left, far = at[on], directions[on], left[on], far[on]
    return out


def _slot(far_m: float) -> int:
    return int(far_m / SPEED_M_S / STEP_S)


def _hits(stops: RayQuads, at: Array, directions: Array) -> tuple[NDArray[np.int64], Array]:
    """Return the first hit of each ray, -1 for none, and its distance, metres."""
    falls = directions @ stops.normal.T
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        away = ((stops.corner * stops.normal).sum(axis=1) - at @ stops.normal.T) / falls
        a = at @ stops.along.T + away * (directions @ stops.along.T) - (stops.corner * stops.along).sum(axis=1)
        b = at @ stops.up.T + away * (directions @ stops.up.T) - (stops.corner * stops.up).sum(axis=1)
        hit = (falls < -1e-9) & (away > 1e-5) & (np.abs(a - 0.5) <= 0.50001) & (np.abs(b - 0.5) <= 0.50001)
    away = np.where(hit, away, np.inf)
    nearest = away.argmin(axis=1)
    far = away[np.arange(len(at)), nearest]
    return np.where(np.isfinite(far), nearest, -1), np.where(np.isfinite(far), far, 0.0)


def _scattered(normal: Array, rng: np.random.Generator) -> Array:
    """Return (N, 3) directions off surfaces, distributed by their cosine."""
    directions = rng.normal(size=normal.shape)
    directions /= np.maximum(np.linalg.norm(directions, axis=1, keepdims=True), 1e-9)
    directions = directions + normal
    return np.asarray(directions / np.maximum(np.linalg.norm(directions, axis=1, keepdims=True), 1e-9))


def reverberation_s(energy: Array) -> float:
    """Return the time in which sound falls by 60 dB, seconds, extrapolated from the fall between -5 and -25 dB."""
    left = np.cumsum(energy[::-1])[::-1]
    level = 10.0 * np.log10(np.maximum(left / max(float(left[0]), 1e-30), 1e-12))
    part = np.flatnonzero((level <= -5.0) & (level >= -25.0))
    if len(part) < 3:
        return 0.0
    slope = np.polyfit(part * STEP_S, level[part], 1)[0]
    return float(-60.0 / slope) if slope < 0.0 else 0.0


def _shaped_noise(energy: Array) -> Array:
    """Return noise with each millisecond's energy; the loudest sample is 1."""
    each = round(RATE_HZ * STEP_S)
    last = int(np.flatnonzero(energy > energy.max(initial=0.0) * 1e-7)[-1]) + 1 if energy.any() else 1
    noise = np.random.default_rng(_SEED).normal(size=last * each)
    samples = noise * np.repeat(np.sqrt(energy[:last] / each), each)
    first = int(energy.argmax()) * each
    samples[first : first + each] = 0.0
    samples[first] = np.sqrt(energy.max(initial=0.0))  # what comes straight is no noise
    return np.asarray(samples / max(float(np.abs(samples).max()), 1e-30))
