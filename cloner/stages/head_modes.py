"""Shapes that a face may have beyond the generic's own family, and what they do to the face net's points.

The generic's face targets are one artist's family. Two things are added, so that faces from outside are not bent into
it: the way from the generic's mean face to the canonical face of the face net, which is nearer to scanned people (on
a scan-based head without any photo 2.2 -> 1.9 mm), and smooth random bends of the DFFD control points.
"""

from __future__ import annotations

import functools
import importlib.resources
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.detectors.face_net import load_face_net
from cloner.generic.head_controls import load_head_controls
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.dffd import deform
from cloner.geometry.sockets import similarity

Array = NDArray[np.float64]

#: Reach of one bend and its size along each axis, metres.
REACH_M, BEND_M = 0.022, 0.0012
#: How alike the two halves of a face bend.
ALIKE = 0.85
#: Bends kept along each axis; they hold nine tenths of the variance.
BENDS = 20
#: The canonical face's points are believed to this, metres; its scale is not.
CANONICAL_M = 0.0015
#: Points farther than this from the middle are the outline of a face in a picture, metres.
RIM_M = 0.055
#: How far on the way to the canonical face a face is expected, and the spread; 0 and 1 are the two mean faces.
TOWARDS, TOWARDS_SPREAD = 0.5, 0.5
#: Weight of a coefficient when a bend is laid on the family's basis, to tell how the net sees it.
LAID_M = 0.0003


@dataclass(frozen=True, slots=True, eq=False)
class HeadModes:
    """What is added to the generic head's family, at 1.70 m stature.

    Attributes
    ----------
    mean_m : (H, 3) float64
        What is expected of everybody, on ``generic.head_vertices``, metres.
    basis_m : (E, H, 3) float64
        Further directions, metres per standard deviation.
    bias_m : (468, 2) float64
        Mean errors of the net's points, right and down in the picture, metres.
    skew_m : (F + E, 468, 2) float64
        What each coefficient, the family's first, adds to the errors.
    drift_m : (M, 468, 2), alone_m : (468,) float64
        Joint errors that the shape does not tell, and each point's own.
    """

    mean_m: Array
    basis_m: Array
    bias_m: Array
    skew_m: Array
    drift_m: Array
    alone_m: Array

    def family_errors_m(self, coefficients: Array) -> Array:
        """Return the errors (468, 2), metres, that the net makes of a face of the generic's own family."""
        own = self.skew_m[: len(coefficients)]
        at_mean = self.bias_m - TOWARDS / TOWARDS_SPREAD * self.skew_m[len(coefficients)]
        return np.asarray(at_mean + np.tensordot(coefficients, own, axes=1))


def _kernel(first: Array, second: Array) -> Array:
    squared = ((first[:, None] - second[None]) ** 2).sum(axis=2)
    return np.asarray(np.exp(-0.5 * squared / REACH_M**2))


def canonical_way(generic: GenericHuman) -> Array:
    """Return how the movable controls (K, 3) move from the generic's mean face to the canonical one, metres."""
    place = importlib.resources.files("cloner_models") / "nets" / "canonical_face.npz"
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        canonical = archive["vertices_cm"].astype(np.float64)
    places = load_face_net().places.at(generic.vertices_m.astype(np.float64))
    scale, rotation, shift = similarity(canonical, places)
    way = scale * canonical @ rotation.T + shift - places
    way = (way + way[_twins(places)] * [-1.0, 1.0, 1.0]) / 2.0
    controls = load_head_controls()
    movable = controls.controls_m[controls.movable]
    spread = np.sqrt((way**2).mean())
    # The net's outermost points lie on the picture's outline of a face, wherever that is: no place of the skin.
    doubt = CANONICAL_M * np.where(np.abs(places[:, 0]) > RIM_M, 10.0, 1.0)
    noise = np.diag((doubt / spread) ** 2)
    return np.asarray(_kernel(movable, places) @ np.linalg.solve(_kernel(places, places) + noise, way))


def _twins(places: Array) -> NDArray[np.int64]:
    return np.asarray(np.linalg.norm((places * [-1.0, 1.0, 1.0])[:, None] - places[None], axis=2).argmin(axis=1))


def smooth_bends(controls_m: Array) -> Array:
    """Return (3 * BENDS, K, 3) random bends of the controls, metres per standard deviation, nearly symmetric."""
    own, across = _kernel(controls_m, controls_m), _kernel(controls_m, controls_m * [-1.0, 1.0, 1.0])
    out = np.zeros((3, BENDS, len(controls_m), 3))
    for axis in range(3):
        sign = -1.0 if axis == 0 else 1.0
        values, vectors = np.linalg.eigh(own + sign * ALIKE * across)
        best = np.argsort(values)[::-1][:BENDS]
        out[axis, :, :, axis] = BEND_M / np.sqrt(1.0 + ALIKE) * (vectors[:, best] * np.sqrt(values[best])).T
    return out.reshape(-1, len(controls_m), 3)


@functools.cache
def load_head_modes() -> HeadModes:
    """Return the modes, made once per process (0.2 s)."""
    generic, controls = load_generic(), load_head_controls()
    movable = np.flatnonzero(controls.movable)
    moves = np.concatenate([canonical_way(generic)[None], smooth_bends(controls.controls_m[movable])])
    carried = controls.weights[:, movable]
    fields = np.stack([deform(carried, move) for move in moves])
    head_net = importlib.resources.files("cloner_models") / "head_net.npz"
    with head_net.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        data = {name: archive[name].astype(np.float64) for name in archive.files}
    for eye in (
        np.flatnonzero(np.isin(generic.head_vertices, generic.part(f"eye_{side}"))) for side in ("left", "right")
    ):
        fields[:, eye] = fields[:, eye].mean(axis=1, keepdims=True)  # eyeballs move whole
    way = fields[0].copy()
    fields[0] *= TOWARDS_SPREAD
    on_family = _on_family(generic, np.concatenate([way[None], fields]))
    skew = np.concatenate([data["skew_m"], np.tensordot(on_family[1:], data["skew_m"], axes=1)])
    bias = data["bias_m"] + TOWARDS * np.tensordot(on_family[0], data["skew_m"], axes=1)
    return HeadModes(TOWARDS * way, fields, bias, skew, data["drift_m"], data["alone_m"])


def _on_family(generic: GenericHuman, fields: Array) -> Array:
    """Return the family's coefficients (E, F) nearest to displacements (E, H, 3) of the face."""
    face = generic.region("face")[generic.head_vertices]
    basis = generic.face_basis[:, face].astype(np.float64).reshape(len(generic.face_basis), -1)
    normal = basis @ basis.T + face.sum() * LAID_M**2 * np.eye(len(basis))
    return np.asarray(np.linalg.solve(normal, basis @ fields[:, face].reshape(len(fields), -1).T).T)
