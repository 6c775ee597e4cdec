"""Evidence of a body photo about shape, pose and camera: outline, points of the pose net, points of an operator."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.detectors.body.body_points import ENDS
from cloner.frames import mm_from_m
from cloner.generic.body_net import NetPoints, net_points
from cloner.geometry.outlines.contours import OutlineField, outline_field
from cloner.records.labels import Label
from cloner.records.points import ViewPoints
from cloner.records.proposals import Proposal
from cloner.records.silhouettes import Silhouette
from cloner.records.views import View

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.evidence")


@dataclass(frozen=True, slots=True)
class Params:
    """Standard deviations of the evidence.

    Its numbers: ``cloner/calibration/body.toml``, ``[evidence.*]``.

    Attributes
    ----------
    shapes : tuple of int
        Number of shape coefficients in the successive rounds.
    iterations_per_round : int
        Gauss-Newton steps a round.
    height_px : int
        Photo height at which outlines are compared.
    """

    joint_mm: float = _CALIBRATED.number("joint_mm", "mm")
    corrected_mm: float = _CALIBRATED.number("corrected_mm", "mm")
    outline_mm: float = _CALIBRATED.number("outline_mm", "mm")
    outline_piece_mm: float = _CALIBRATED.number("outline_piece_mm", "mm")
    floor_mm: float = _CALIBRATED.number("floor_mm", "mm")
    height_m: tuple[float, float] = _CALIBRATED.pair("height_m", "m")
    same_height_m: float = _CALIBRATED.number("same_height_m", "m")
    azimuth_degrees: float = _CALIBRATED.number("azimuth_degrees", "deg")
    facing_degrees: float = _CALIBRATED.number("facing_degrees", "deg")
    pitch_degrees: float = _CALIBRATED.number("pitch_degrees", "deg")
    roll_degrees: float = _CALIBRATED.number("roll_degrees", "deg")
    same_pose: float = _CALIBRATED.number("same_pose", "factor")
    same_sides: float = _CALIBRATED.number("same_sides", "factor")
    shapes: tuple[int, ...] = (6, 12, 24, 30, 30)
    reach_mm: tuple[float, ...] = _CALIBRATED.numbers("reach_mm", "mm")
    iterations_per_round: int = 3
    fade: tuple[float, float] = _CALIBRATED.pair("fade", "sigmas")
    height_px: int = 640
    max_step: float = _CALIBRATED.number("max_step", "m, rad")
    damping: float = _CALIBRATED.number("damping", "share")
    max_sigmas: float = _CALIBRATED.number("max_sigmas", "sigmas")


@dataclass(frozen=True, slots=True, eq=False)
class PhotoEvidence:
    """Evidence of one photo, with an initial camera.

    Attributes
    ----------
    view : View
    points : ViewPoints
        The contour's proposals and an operator's points.
    net : NetPoints
        The pose net's points, calibrated.
    field : OutlineField
    mm_per_px : float
    top_px : float
        Row of the person's highest point.
    hair_mm : tuple of float
        How far that is above the skull, and its spread.
    soles_px : mapping of str to float
        Rows of soles that an operator placed, by "left" and "right".
    barefoot : bool
    """

    view: View
    points: ViewPoints
    net: NetPoints
    field: OutlineField
    mm_per_px: float
    top_px: float
    hair_mm: tuple[float, float]
    soles_px: Mapping[str, float]
    barefoot: bool


def gather_evidence(
    view: View,
    points: ViewPoints,
    outline: Silhouette,
    proposal: Proposal,
    hair_mm: tuple[float, float],
    params: Params,
) -> PhotoEvidence:
    """Return the evidence of one photo, prepared for the fit."""
    mm_per_px = mm_from_m(view.camera.metres_per_pixel(np.array([0.0, 0.9, 0.0])))
    reduction = max(view.camera.height_px / params.height_px, 1.0)
    field = outline_field(
        outline.contours_px,
        outline.mask,
        proposal.labels == Label.HAIR,
        cloth=outline.loose_mask(),
        step_px=2.0 * reduction,
        reduction=reduction,
    )
    placed = {n: p for n, p, fixed in zip(points.names, points.points_px, points.corrected, strict=True) if fixed}
    top = outline.top_px if ENDS[0] not in placed else float(placed[ENDS[0]][1]) - 0.5
    soles = {name.removeprefix("sole_"): float(placed[name][1]) + 0.5 for name in ENDS[1:] if name in placed}
    net = net_points(proposal, view.side_shown, without=tuple(placed))
    return PhotoEvidence(view, points, net, field, mm_per_px, top, hair_mm, soles, proposal.barefoot)
