"""Parts inside the head: eyeballs of anatomical size behind the lids, lips in contact, teeth and tongue."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.generic.face_grids import Grid, eye_grid, eyeball, lashes, mouth_grid
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.cameras.motions import projection_derivatives
from cloner.geometry.meshes.alignment import similarity_alignment
from cloner.geometry.meshes.eyeballs import BALL_M, Eyeball, eyeball_points
from cloner.head import lids, lips, tongue
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.parts")

PUPIL_UP_M = _CALIBRATED.number("pupil_up_m", "m")
IRIS_REACH_M = _CALIBRATED.number("iris_reach_m", "m")
#: Angle of the generic ball's iris rim from its gaze, radians (cage.py's ring).
RIM_ANGLE = float(np.radians(23.0))
LASH_LENGTH = _CALIBRATED.pair("lash_length", "share")
TEETH_SHOW_M = _CALIBRATED.number("teeth_show_m", "m")
OVERBITE_M = _CALIBRATED.number("overbite_m", "m")
BEHIND_LIPS_M = _CALIBRATED.number("behind_lips_m", "m")
BEHIND_UPPER_M = _CALIBRATED.number("behind_upper_m", "m")
NARROWER = _CALIBRATED.table("narrower", "factor")


@dataclass(frozen=True, slots=True, eq=False)
class EyeObservation:
    """Irises and lids as the front photo shows them.

    Attributes
    ----------
    camera : Camera
    irises_px : (2, 2)
        Centres of the left and the right iris; zeros where nobody looked.
    """

    camera: Camera
    irises_px: Array


def place_eyes_and_mouth(before_m: Array, fitted_m: Array, sight: EyeObservation | None) -> Array:
    """Return the vertices (V, 3) with lids on eyeballs of anatomical size, lips in contact, teeth and tongue placed.

    Lips meet, whatever the photo shows: what it paints on them is looked up where it has them
    (``paint/lookups/sources.py``).

    Parameters
    ----------
    before_m, fitted_m : (V, 3) metres
        Any person of the generic family, and the fitted skin, whose eyeballs, teeth and lashes may lie anywhere.
    sight : Sight, optional
    """
    generic, out = load_generic(), fitted_m.copy()
    for number, side in enumerate(("left", "right")):
        iris = None if sight is None or not sight.irises_px.any() else (sight.camera, sight.irises_px[number])
        _place_eye(generic, out, side, iris)
    grid = mouth_grid()
    out[grid.rings] = lips.seal_lips(grid, lips.uncross_lips(grid, lips.close_lips(grid, out[grid.rings])))
    _place_mouth(generic, before_m, out)
    return out


def _place_eye(generic: GenericHuman, out: Array, side: str, iris: tuple[Camera, Array] | None) -> None:
    """Fit one eye's lids to an eyeball of anatomical size, and move its lashes along, in place."""
    grid = eye_grid(side)
    before = out[grid.rings]
    middle = _pupil_between_lids(grid, before[grid.margin])
    ball = Eyeball(np.append(middle, lids.eyeball_depth(grid, before, middle)))
    if iris is not None:
        middle = middle + np.clip(_shift_to_pixel(ball, *iris), -IRIS_REACH_M, IRIS_REACH_M)
        ball = Eyeball(np.append(middle, lids.eyeball_depth(grid, before, middle)))
    rows = generic.part(f"eye_{side}")
    rest = generic.vertices_m.astype(np.float64)
    out[rows] = ball.centre + eyeball_points(rest[rows] - eyeball(rest, side).centre, RIM_ANGLE)
    out[grid.rings] = lids.lids_on_eyeball(grid, before, ball)
    _place_lashes(generic, out, side)


def _pupil_between_lids(grid: Grid, margin: Array) -> Array:
    """Return the frontal position (2,) of the pupil as the lids alone suggest it."""
    aside = margin[grid.corners, 0].mean()
    edges = [margin[lid][np.abs(margin[lid, 0] - aside).argsort()[:3], 1].mean() for lid in (grid.upper, grid.lower)]
    return np.array([aside, np.mean(edges) + PUPIL_UP_M])


def _shift_to_pixel(ball: Eyeball, camera: Camera, iris_px: Array) -> Array:
    """Return the shift (2,) of an eyeball to the left and up, metres, that brings its pupil to a pixel."""
    pupil = ball.centre + np.array([0.0, 0.0, BALL_M])
    seen, by_point, _ = projection_derivatives(camera, pupil[None])
    return np.asarray(np.linalg.solve(by_point[0, :, :2], iris_px - seen[0]))


def _place_lashes(generic: GenericHuman, out: Array, side: str) -> None:
    """Put one eye's lashes, shortened, on the lid margins, in place."""
    grid, own = eye_grid(side), lashes(side)
    rest = generic.vertices_m.astype(np.float64)
    for upper, length in zip((True, False), LASH_LENGTH, strict=True):
        rows = own.vertices[own.upper == upper]
        root = grid.ring(1)[own.column[own.upper == upper]]
        out[rows] = out[root] + length * (rest[rows] - rest[root])


def _place_mouth(generic: GenericHuman, before: Array, out: Array) -> None:
    """Scale teeth and tongue with the mouth and put them behind the lips, in place."""
    grid = mouth_grid()
    mouth = np.flatnonzero(generic.region("mouth_interior"))
    stomion = before[generic.feature("stomion"), 1]
    meeting = float(out[grid.ring(-1)[grid.upper], 1].mean())
    inside = out[grid.ring(-3)]
    front = float(inside[np.abs(inside[:, 0]).argsort()[:6], 2].min()) - BEHIND_LIPS_M
    upper_edge = meeting - TEETH_SHOW_M
    for parts, near, edge, depth in (
        (("teeth_upper",), before[mouth, 1] > stomion - 0.004, upper_edge, front),
        (
            ("teeth_lower", "tongue"),
            before[mouth, 1] < stomion + 0.004,
            upper_edge + OVERBITE_M,
            front - BEHIND_UPPER_M,
        ),
    ):
        factor, rotation, _ = similarity_alignment(before[mouth[near]], out[mouth[near]])
        size = factor * np.array([NARROWER[parts[0]], 1.0, 1.0])
        own = size * before[generic.part(parts[0])] @ rotation.T
        biting = own[:, 1].min() if parts[0] == "teeth_upper" else own[:, 1].max()
        middle = out[mouth[near], 0].mean()
        shift = np.array([middle - own[:, 0].mean(), edge - biting, depth - own[:, 2].max()])
        for part in parts:
            out[generic.part(part)] = size * before[generic.part(part)] @ rotation.T + shift
    out[generic.part("tongue")] = tongue.rounded_tip(out[generic.part("tongue")])
