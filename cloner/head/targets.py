"""Morph targets of this face: deformation transfer from the generic human, then contact of lids and lips.

Skin takes the generic's displacements through local affine maps. Where moving parts touch, nothing is left to chance:
lids are solved along the eyeball, lips meet where they should, teeth and tongue move with the jaw, eyeballs turn.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.calibration.loader import calibrated
from cloner.generic.face_grids import eye_grid, eyeball, lashes, mouth_grid
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.meshes.alignment import similarity_alignment
from cloner.geometry.meshes.eyeballs import Eyeball
from cloner.geometry.meshes.local_maps import LocalMaps, local_maps
from cloner.head import lids, lips, tongue
from cloner.records.arrays import Array

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.targets")

Targets = tuple[tuple[str, ...], NDArray[np.int32], NDArray[np.float32], NDArray[np.int32]]

REACH_M = _CALIBRATED.number("reach_m", "m")
#: Local maps over the head (taste: more changes nothing).
ANCHORS = 250
SMALLEST_M = _CALIBRATED.number("smallest_m", "m")
#: Targets in which the lips touch.
CLOSED = ("viseme_sil", "viseme_PP", "mouthPressLeft", "mouthPressRight", "mouthRollLower", "mouthRollUpper")
WIDE_M = _CALIBRATED.number("wide_m", "m")
FLAT = _CALIBRATED.number("flat", "share")
TONGUE_OPENS = _CALIBRATED.number("tongue_opens", "share")
STILL = _CALIBRATED.number("still", "share")
FADE_M = _CALIBRATED.number("fade_m", "m")
SIDES = ("left", "right")


@functools.cache
def _head_maps() -> tuple[NDArray[np.int64], LocalMaps]:
    """Return the head's skin vertices and the solver of their local affine maps."""
    generic = load_generic()
    head = generic.head_vertices
    rows = head[generic.skin[head]].astype(np.int64)
    return rows, local_maps(generic.vertices_m[rows].astype(np.float64), reach_m=REACH_M, anchors=ANCHORS)


@functools.cache
def _target_share() -> Array:
    """Return the share (S,) of a target's displacement at the head's skin vertices."""
    generic, (rows, _) = load_generic(), _head_maps()
    still = generic.region("ear_left") | generic.region("ear_right") | generic.region("scalp")
    away, _ = cKDTree(generic.vertices_m[still]).query(generic.vertices_m[rows], distance_upper_bound=FADE_M)
    return np.asarray(STILL + (1.0 - STILL) * np.minimum(away / FADE_M, 1.0))


class _PersonalTargets:
    """A face at rest, to which the generic targets are transferred."""

    def __init__(self, vertices_m: Array) -> None:
        self.generic, self.rest_m = load_generic(), vertices_m
        self.skin, solver = _head_maps()
        self.maps = solver.maps(vertices_m[self.skin])
        self.balls = {side: eyeball(vertices_m, side) for side in SIDES}
        self.mean_m = self.generic.vertices_m.astype(np.float64)

    def target(self, name: str, raw: Array, jaw_open: Array) -> Array:
        """Return a target's displacements (V, 3); ``raw`` are the generic's, ``jaw_open`` this face's for jawOpen."""
        out = np.zeros_like(raw)
        out[self.skin] = np.einsum("vab,vb->va", self.maps, raw[self.skin]) * _target_share()[:, None]
        self._move_mouth(out, raw)
        for side in SIDES:
            self._move_eye(name, out, raw, side)
        self._move_lips(name, out, jaw_open)
        return out

    def tongue_out(self, jaw_open: Array) -> Array:
        """Return the displacements (V, 3) of the tongue put out, with the jaw as far open as it needs."""
        generic, grid, out = self.generic, mouth_grid(), TONGUE_OPENS * jaw_open
        rows, teeth, shape = generic.part("tongue"), generic.part("teeth_lower"), self.rest_m + out
        put_out = tongue.extended_tongue(self.rest_m[rows], shape[rows], shape[grid.rings], grid, shape[teeth])
        out[rows] = put_out - self.rest_m[rows]
        return out

    def _move_mouth(self, out: Array, raw: Array) -> None:
        """Move the lower teeth, and the tongue with them, in place."""
        teeth, tongue_rows = self.generic.part("teeth_lower"), self.generic.part("tongue")
        size, turn, shift = similarity_alignment(self.mean_m[teeth], self.rest_m[teeth])
        _, jaw_turn, jaw_shift = similarity_alignment(self.mean_m[teeth], self.mean_m[teeth] + raw[teeth])
        sinks = max(0.0, -float(raw[teeth, 1].mean()))
        for rows in (teeth, tongue_rows):
            generic_place = (self.rest_m[rows] - shift) @ turn / size
            rigid = generic_place @ jaw_turn.T + jaw_shift - generic_place
            out[rows] = size * rigid @ turn.T
        own = raw[tongue_rows] - (self.mean_m[tongue_rows] @ jaw_turn.T + jaw_shift - self.mean_m[tongue_rows])
        own = size * own @ turn.T
        place = self.rest_m[tongue_rows]
        own[:, 1] -= FLAT * min(sinks / WIDE_M, 1.0) * np.maximum(place[:, 1] - place[:, 1].min(), 0.0)
        out[tongue_rows] += own

    def _move_eye(self, name: str, out: Array, raw: Array, side: str) -> None:
        """Rotate the eyeball and fit the lids to it, in place."""
        grid, ball = eye_grid(side), self.balls[side]
        rows, rest = self.generic.part(f"eye_{side}"), self.rest_m[grid.rings]
        up = 0.0
        if raw[rows].any():
            _, turn, _ = similarity_alignment(self.mean_m[rows], self.mean_m[rows] + raw[rows])
            out[rows] = (self.rest_m[rows] - ball.centre) @ (turn.T - np.eye(3))
            up = float(np.arcsin(np.clip(turn[1, 2], -1.0, 1.0)))
        if name == f"eyeBlink{side.title()}":
            moved = lids.closed_lids(grid, rest, ball)
        elif abs(up) > 0.01:
            moved = lids.lids_following_gaze(grid, rest, ball, up)
        elif np.abs(out[grid.rings]).max() < SMALLEST_M:
            return
        else:
            moved = lids.keep_on_eyeball(grid, rest, rest + out[grid.rings], ball)
        out[grid.rings] = moved - rest
        self._move_lashes(out, side, ball)

    def _move_lashes(self, out: Array, side: str, ball: Eyeball) -> None:
        """Move the lashes with the lid margins that they grow from, in place."""
        grid, own = eye_grid(side), lashes(side)
        root = grid.ring(1)[own.column]
        margin = grid.ring(0)[own.column]
        before = ball.unrolled(self.rest_m[margin])[1]
        angle = ball.unrolled(self.rest_m[margin] + out[margin])[1] - before
        spoke = self.rest_m[own.vertices] - self.rest_m[root]
        up = np.cos(angle) * spoke[:, 1] + np.sin(angle) * spoke[:, 2]
        ahead = np.cos(angle) * spoke[:, 2] - np.sin(angle) * spoke[:, 1]
        out[own.vertices] = out[root] + np.stack([np.zeros(len(up)), up - spoke[:, 1], ahead - spoke[:, 2]], axis=1)

    def _move_lips(self, name: str, out: Array, jaw_open: Array) -> None:
        """Bring the lips into contact where they should touch and remove crossings, in place."""
        grid = mouth_grid()
        rest = self.rest_m[grid.rings]
        if name == "mouthClose":  # by definition it closes the lips of a jaw that is as far open
            rest = rest + jaw_open[grid.rings]
        elif np.abs(out[grid.rings]).max() < SMALLEST_M:
            return
        moved = rest + out[grid.rings]
        if name != "mouthClose" and name not in CLOSED:
            moved = lips.round_lips(grid, rest, moved, lips.ROUND.get(name, 1.0))
        for part in ("teeth_upper", "teeth_lower"):
            rows = self.generic.part(part)
            moved = lips.keep_before_teeth(grid, moved, self.rest_m[rows] + out[rows])
        if name == "mouthClose" or name in CLOSED:
            moved = lips.seal_lips(grid, lips.uncross_lips(grid, lips.close_lips(grid, moved)))
        out[grid.rings] = lips.uncross_lips(grid, moved) - rest


def face_targets(vertices_m: Array) -> Targets:
    """Return names, vertex indices, displacements and offsets of a person's face targets, at rest (V, 3) metres."""
    face, names = _PersonalTargets(vertices_m), []
    index, delta, start = [], [], [0]
    for name, offsets in _targets(face):
        rows = np.flatnonzero(np.linalg.norm(offsets, axis=1) > SMALLEST_M)
        names.append(name)
        index.append(rows)
        delta.append(offsets[rows])
        start.append(start[-1] + len(rows))
    return (
        tuple(names),
        np.concatenate(index).astype(np.int32),
        np.concatenate(delta).astype(np.float32),
        np.array(start, dtype=np.int32),
    )


def _targets(face: _PersonalTargets) -> Iterator[tuple[str, Array]]:
    generic = face.generic
    jaw_open = face.target("jawOpen", _generic_target(generic, "jawOpen"), np.zeros_like(face.rest_m))
    for name in (*generic.arkit_names, *generic.viseme_names):
        if name == "tongueOut":
            yield name, face.tongue_out(jaw_open)
        else:
            yield name, face.target(name, _generic_target(generic, name), jaw_open)


def _generic_target(generic: GenericHuman, name: str) -> Array:
    """Return the generic human's displacements (V, 3) for a target."""
    out = np.zeros((len(generic.vertices_m), 3))
    rows, offsets = generic.face_unit(name)
    out[rows] = offsets
    return out
