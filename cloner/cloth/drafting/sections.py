"""Cross sections of a clone at rest: trunk, legs and arms, each a convex hull as a tape measure lies."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measures import UP, slice_points
from cloner.geometry.meshes.vectors import arc_lengths, places_along, unit
from cloner.records.arrays import Array
from cloner.records.clones import Clone

#: Places on a section's hull, half a degree apart.
SAMPLES: Final = 720
#: Slices are taken every centimetre.
STEP_M: Final = 0.01


def convex_ring(points: Array) -> Array:
    """Return (S + 1, 2) the convex hull of (N, 2) points, evenly sampled from above its middle to the right; closed."""
    hull = points[ConvexHull(points).vertices]
    centre = (hull.min(axis=0) + hull.max(axis=0)) / 2.0
    away = hull - centre
    hull = hull[np.argsort(np.arctan2(away[:, 0], away[:, 1]))]
    closed = np.vstack([hull, hull[:1]])
    run = arc_lengths(closed)
    even = np.linspace(0.0, run[-1], SAMPLES + 1)
    fine = places_along(closed, run, even)
    front = int(np.argmin(np.abs(np.arctan2(fine[:-1, 0] - centre[0], fine[:-1, 1] - centre[1]))))
    fine = np.roll(fine[:-1], -front, axis=0)
    return np.vstack([fine, fine[:1]])


def girth_of(ring: Array) -> float:
    """Return the length of a closed ring, metres."""
    return float(np.linalg.norm(np.diff(ring, axis=0), axis=1).sum())


def offset_ring(ring: Array, by_m: float) -> Array:
    """Return a convex ring moved outward by ``by_m``."""
    centre = (ring.min(axis=0) + ring.max(axis=0)) / 2.0
    along = np.roll(ring[:-1], -1, axis=0) - np.roll(ring[:-1], 1, axis=0)
    normal = np.column_stack([-along[:, 1], along[:, 0]])
    normal *= np.sign(np.einsum("ij,ij->i", normal, ring[:-1] - centre))[:, None]
    out = ring[:-1] + by_m * unit(normal, 1e-12)
    return np.vstack([out, out[:1]])


@dataclass(frozen=True, slots=True, eq=False)
class SliceFrame:
    """The frame of a part's slices: planes perpendicular to ``up`` from ``origin_m`` on.

    Attributes
    ----------
    origin_m : (3,) float64
    ahead, left, up : (3,) float64, unit
        Rings begin at ``ahead`` and go round by ``left``.
    triangles : (T, 3) int32
    """

    origin_m: Array
    ahead: Array
    left: Array
    up: Array
    triangles: NDArray[np.int32]


@dataclass(frozen=True, slots=True, eq=False)
class Sections:
    """A clone's cross sections, cached.

    Attributes
    ----------
    clone : Clone
    waist_m : float
        Height of the natural waist.
    frames : mapping of str to SliceFrame
        "trunk" (all but the arms), "left_leg", "right_leg", "left_arm", "right_arm".
    """

    clone: Clone
    waist_m: float
    frames: dict[str, SliceFrame]
    _kept: dict[tuple[str, int], Array] = field(default_factory=dict)

    @property
    def stature_m(self) -> float:
        """The clone's stature."""
        return self.clone.stature_m

    def place(self, name: str) -> Array:
        """Return (3,) a named point of the generic human on the clone; "armpit_left" is the tape's."""
        points = load_tape_rules().points
        generic = load_generic()
        row = points[name] if name in points else generic.feature(name)
        return np.asarray(self.clone.vertices_m[row])

    def ring(self, part: str, at_m: float) -> Array:
        """Return the (S + 1, 2) hull around a part at a position along its frame's ``up``, clamped to
        the part's ends.
        """
        step = round(at_m / STEP_M)
        key = (part, step)
        if key not in self._kept:
            self._kept[key] = self._cut(part, step)
        return self._kept[key]

    def girth(self, part: str, at_m: float) -> float:
        """Return the girth of a part, metres."""
        return girth_of(self.ring(part, at_m))

    def arm_length_m(self, side: str) -> float:
        """Return the distance from shoulder to wrist."""
        generic = load_generic()
        ends = [self.clone.joints_m[generic.joint(f"{side[0]}_{name}")] for name in ("shoulder", "elbow", "wrist")]
        return float(np.linalg.norm(np.diff(ends, axis=0), axis=1).sum())

    def _cut(self, part: str, step: int) -> Array:
        frame = self.frames[part]
        for off in sorted(range(-60, 61), key=abs):  # the nearest slice that is one
            at = frame.origin_m + (step + off) * STEP_M * frame.up
            points = slice_points(self.clone.vertices_m, frame.triangles, at, frame.up) - frame.origin_m
            if len(points) >= 8:
                return convex_ring(np.column_stack([points @ frame.left, points @ frame.ahead]))
        raise ValueError(f"{part} has no slice near {step}")


def sections(clone: Clone) -> Sections:
    """Return the sections of a clone at rest."""
    generic, rules = load_generic(), load_tape_rules()
    waist = float(clone.vertices_m[list(rules.level_vertices["natural_waist"]), 1].mean())
    ahead, left = np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0])
    frames = {"trunk": SliceFrame(np.zeros(3), ahead, left, UP, rules.torso)}
    for side in ("left", "right"):
        leg, upper, fore = rules.limbs(side)
        frames[f"{side}_leg"] = SliceFrame(np.zeros(3), ahead, left, UP, leg)
        shoulder, wrist = (clone.joints_m[generic.joint(f"{side[0]}_{name}")] for name in ("shoulder", "wrist"))
        up = (shoulder - wrist) / np.linalg.norm(shoulder - wrist)
        top = UP - (UP @ up) * up
        top /= np.linalg.norm(top)
        frames[f"{side}_arm"] = SliceFrame(shoulder, top, np.cross(up, top), up, np.concatenate([upper, fore]))
    return Sections(clone, waist, frames)
