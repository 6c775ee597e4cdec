"""Shape model of heads and error model of the face net.

The generic's face targets are one artist's family; the way from its mean face to the canonical face of the face net,
which is nearer to scanned people, and smooth random bends of the DFFD control points widen it. Half of what is expected
comes from it, half from a scan-based family, told in the same parameters (``learn_head_shapes.py``).
"""

from __future__ import annotations

import functools
import importlib.resources
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from cloner.calibration.loader import calibrated
from cloner.detectors.face.face_net import load_face_net
from cloner.generic.head_controls import load_head_controls
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.meshes.alignment import similarity_alignment
from cloner.head.ears import ear_modes
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.modes")

REACH_M = _CALIBRATED.number("reach_m", "m")
BEND_M = _CALIBRATED.number("bend_m", "m")
ALIKE = _CALIBRATED.number("alike", "factor")
#: Bends kept along each axis; they hold nine tenths of the variance.
BENDS = 20
CANONICAL_M = _CALIBRATED.number("canonical_m", "m")
RIM_M = _CALIBRATED.number("rim_m", "m")
TOWARDS = _CALIBRATED.number("towards", "factor")
TOWARDS_SPREAD = _CALIBRATED.number("towards_spread", "factor")


@dataclass(frozen=True, slots=True, eq=False)
class HeadModes:
    """Shape modes of heads at 1.70 m stature, and errors of the face net that depend on them.

    Attributes
    ----------
    mean_m : (H, 3) float64
        What is expected of everybody, on ``generic.head_vertices``, metres.
    basis_m : (E, H, 3) float64
        Directions in which heads differ, metres per standard deviation.
    bias_m : (468, 2) float64
        Mean errors of the net's points, right and down in the picture, metres.
    turn_m : (2, 468, 2) float64
        What a head that nods and turns adds to the errors, metres a radian: the net draws every face as if it looked
        more straight at the camera than it does.
    skew_m : (E, 468, 2) float64
        What each coefficient adds to the errors.
    drift_m : (M, 468, 2), alone_m : (468,) float64
        Joint errors that the shape does not tell, and each point's own.
    """

    mean_m: Array
    basis_m: Array
    bias_m: Array
    turn_m: Array
    skew_m: Array
    drift_m: Array
    alone_m: Array

    def errors_m(self, coefficients: Array, camera: Camera) -> Array:
        """Return the expected errors (468, 2) of the net's points for a shape and a camera, metres."""
        return self.seen_errors_m(camera) + np.tensordot(coefficients, self.skew_m[: len(coefficients)], axes=1)

    def seen_errors_m(self, camera: Camera) -> Array:
        """Return the part of the expected errors (468, 2) that does not depend on the shape, metres."""
        return self.bias_m + self.turn_errors_m(camera.camera_from_model[:3, :3])

    def turn_errors_m(self, camera_from_head: Array) -> Array:
        """Return the part of the expected errors (468, 2) that depends on the head's rotation (3, 3), metres."""
        return np.asarray(np.tensordot(_nod_and_turn(camera_from_head), self.turn_m, axes=1))

    def frontal_errors_m(self, face_px: Array, places_m: Array, camera: Camera) -> Array:
        """Return the errors (468, 2) that the net would make on a frontal photo of this face, metres, from one photo.

        Parameters
        ----------
        face_px : (468, 2)
            The net's points in that photo.
        places_m : (468, 3)
            Where they truly are.
        camera : Camera
            Of that photo, before the head as it rests.
        """
        metres = camera.metres_per_pixel(places_m.mean(axis=0))
        made = (face_px - camera.project(places_m)) * metres
        return np.asarray(made - self.turn_errors_m(camera.camera_from_model[:3, :3]))


def nod_and_turn(camera: Camera) -> Array:
    """Return pitch and yaw (2,) of the head at rest before a camera, radians; 0 is a frontal view."""
    return _nod_and_turn(camera.camera_from_model[:3, :3])


def _nod_and_turn(camera_from_head: Array) -> Array:
    seen = camera_from_head @ np.diag([1.0, -1.0, -1.0])
    return np.asarray(Rotation.from_matrix(seen).as_rotvec()[:2], dtype=np.float64)


def _kernel(first: Array, second: Array) -> Array:
    squared = ((first[:, None] - second[None]) ** 2).sum(axis=2)
    return np.asarray(np.exp(-0.5 * squared / REACH_M**2))


def canonical_displacements(generic: GenericHuman) -> Array:
    """Return the displacements of the movable controls (K, 3) from the generic's mean face to the canonical face,
    metres.
    """
    place = importlib.resources.files("cloner_models") / "nets" / "canonical_face.npz"
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        canonical = archive["vertices_cm"].astype(np.float64)
    places = load_face_net().places.at(generic.vertices_m.astype(np.float64))
    scale, rotation, shift = similarity_alignment(canonical, places)
    way = scale * canonical @ rotation.T + shift - places
    way = (way + way[_mirrored_points(places)] * [-1.0, 1.0, 1.0]) / 2.0
    controls = load_head_controls()
    movable = controls.controls_m[controls.movable]
    spread = np.sqrt((way**2).mean())
    # The net's outermost points lie on the picture's outline of a face, wherever that is: no place of the skin.
    doubt = CANONICAL_M * np.where(np.abs(places[:, 0]) > RIM_M, 10.0, 1.0)
    noise = np.diag((doubt / spread) ** 2)
    return np.asarray(_kernel(movable, places) @ np.linalg.solve(_kernel(places, places) + noise, way))


def _mirrored_points(places: Array) -> NDArray[np.int64]:
    return np.asarray(np.linalg.norm((places * [-1.0, 1.0, 1.0])[:, None] - places[None], axis=2).argmin(axis=1))


def smooth_bends(controls_m: Array) -> Array:
    """Return smooth random displacements of the controls (3 * BENDS, K, 3), metres per sigma, nearly symmetric."""
    own, across = _kernel(controls_m, controls_m), _kernel(controls_m, controls_m * [-1.0, 1.0, 1.0])
    out = np.zeros((3, BENDS, len(controls_m), 3))
    for axis in range(3):
        sign = -1.0 if axis == 0 else 1.0
        values, vectors = np.linalg.eigh(own + sign * ALIKE * across)
        best = np.argsort(values)[::-1][:BENDS]
        out[axis, :, :, axis] = BEND_M / np.sqrt(1.0 + ALIKE) * (vectors[:, best] * np.sqrt(values[best])).T
    return out.reshape(-1, len(controls_m), 3)


def parameter_displacements() -> Array:
    """Return the head displacements (P, H, 3) of each parameter, metres (200 MB: for learning only)."""
    return displacements_of(np.eye(len(load_generic().face_basis) + 3 * len(load_head_controls().names)))


def displacements_of(parameters: Array) -> Array:
    """Return head displacements (N, H, 3) for parameters (N, P): face shapes, then x, y, z of each control.

    Controls fade out towards the neck's base, where the head is joined to the body; eyeballs move whole.
    """
    generic, controls = load_generic(), load_head_controls()
    shapes, count = len(generic.face_basis), len(controls.names)
    moves = parameters[:, shapes:].reshape(len(parameters), count, 3).transpose(1, 0, 2)
    carried = (controls.weights[:, :count] @ moves.reshape(count, -1)).reshape(-1, len(parameters), 3)
    fields = carried.transpose(1, 0, 2) * generic.head_blend[generic.head_vertices].astype(np.float64)[:, None]
    for part in ("eye_left", "eye_right"):
        eye = np.flatnonzero(np.isin(generic.head_vertices, generic.part(part)))
        fields[:, eye] = fields[:, eye].mean(axis=1, keepdims=True)
    return np.asarray(fields + np.tensordot(parameters[:, :shapes], generic.face_basis.astype(np.float64), axes=1))


def family_parameters() -> tuple[Array, Array]:
    """Return mean (P,) and directions (D, P) of the generic's own family with smooth bends, one of the two families
    mixed.

    The generic's face targets, half the way to the canonical face of the face net, and smooth random bends.
    """
    generic, controls = load_generic(), load_head_controls()
    shapes, movable = len(generic.face_basis), np.flatnonzero(controls.movable)
    bends = smooth_bends(controls.controls_m[movable])
    moves = np.zeros((1 + len(bends), len(controls.names), 3))
    moves[0, movable], moves[1:, movable] = canonical_displacements(generic), bends
    flat = moves.reshape(len(moves), -1)
    mean = np.r_[np.zeros(shapes), TOWARDS * flat[0]]
    flat[0] *= TOWARDS_SPREAD
    directions = np.zeros((shapes + len(flat), shapes + flat.shape[1]))
    directions[:shapes, :shapes], directions[shapes:, shapes:] = np.eye(shapes), flat
    return mean, directions


def bent_shapes() -> tuple[Array, Array]:
    """Return the mean (H, 3) and directions (E, H, 3) by which painted people differ from the generic's face shapes."""
    mean, directions = family_parameters()
    beyond = displacements_of(directions[len(load_generic().face_basis) :])
    return displacements_of(mean[None])[0], np.concatenate([beyond, ear_modes(load_generic())])


@functools.cache
def head_shapes() -> tuple[Array, Array]:
    """Return the mean displacement (H, 3) and the shape modes (E, H, 3) of heads, those of the ears last.

    Made once a process; the parameters come from ``learn_head_shapes.py``.
    """
    place = importlib.resources.files("cloner_models") / "head_shapes.npz"
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        mean, directions = (archive[name].astype(np.float64) for name in ("mean", "directions"))
    moved = displacements_of(np.vstack([mean, directions]))
    return moved[0], np.concatenate([moved[1:], ear_modes(load_generic())])


@functools.cache
def load_head_modes() -> HeadModes:
    """Return the shape modes and the net's error model (made by ``calibrate_head_net.py``)."""
    head_net = importlib.resources.files("cloner_models") / "head_net.npz"
    with head_net.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        data = {name: archive[name].astype(np.float64) for name in archive.files}
    names = ("bias_m", "turn_m", "skew_m", "drift_m", "alone_m")
    return HeadModes(*head_shapes(), *(data[name] for name in names))
