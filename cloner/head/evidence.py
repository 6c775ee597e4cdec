"""Observations of the face photos for the head fit."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.face.profile import front_contour, outline
from cloner.detectors.propagation import propagate_to_net
from cloner.frames import ViewId, focal_px_from_35mm
from cloner.geometry.outlines.contour_match import contour_normals
from cloner.head.ears import PointObservations, ear_observations, inner_observations
from cloner.head.model import HeadModel
from cloner.head.nose import CorrelatedPoints, nose_observations
from cloner.head.outline import Outline, mask_outline
from cloner.head.skin_matches import SkinMatches
from cloner.records.arrays import Array
from cloner.records.labels import Label, labels_at
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import FacePoints, ViewPoints
from cloner.records.proposals import Proposals
from cloner.records.results import Residual
from cloner.records.silhouettes import SilhouetteSet

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.evidence")

SKIN_DEPTH = _CALIBRATED.number("skin_depth", "share")
#: Whose outline is the face's own; no beard's, no cap's, no lock's.
OWN_OUTLINE = (Label.FACE_SKIN, Label.BODY_SKIN, Label.EYES, Label.MOUTH)
#: What hides the skin below a net point, which the net then draws on what hides it.
HIDING = (Label.BEARD, Label.HAIR)


@dataclass(frozen=True, slots=True)
class Params:
    """Standard deviations and sizes.

    Its numbers: ``cloner/calibration/head.toml``, ``[evidence.*]``.

    Attributes
    ----------
    looks : int
        How often the side photo is searched, from an ever better fit.
    """

    focal_35mm: float = _CALIBRATED.number("focal_35mm", "mm")
    distance_m: float = _CALIBRATED.number("distance_m", "m")
    distance_sigma: float = _CALIBRATED.number("distance_sigma", "share")
    presence: float = _CALIBRATED.number("presence", "score")
    net_floor_m: float = _CALIBRATED.number("net_floor_m", "m")
    drift: float = _CALIBRATED.number("drift", "factor")
    together: float = _CALIBRATED.number("together", "factor")
    hidden_net: float = _CALIBRATED.number("hidden_net", "factor")
    loose_net: float = _CALIBRATED.number("loose_net", "factor")
    named_m: float = _CALIBRATED.number("named_m", "m")
    corrected_m: float = _CALIBRATED.number("corrected_m", "m")
    loose_named: float = _CALIBRATED.number("loose_named", "factor")
    contour_m: float = _CALIBRATED.number("contour_m", "m")
    flank_m: float = _CALIBRATED.number("flank_m", "m")
    looks: int = 3
    taught: float = _CALIBRATED.number("taught", "share")
    yaw: float = _CALIBRATED.number("yaw", "rad")
    tip: float = _CALIBRATED.number("tip", "rad")
    relief_m: float = _CALIBRATED.number("relief_m", "m")
    bend_m: float = _CALIBRATED.number("bend_m", "m")
    limit_m: float = _CALIBRATED.number("limit_m", "m")
    body_scale: float = _CALIBRATED.number("body_scale", "share")
    own_scale: float = _CALIBRATED.number("own_scale", "share")
    scale_limit: float = _CALIBRATED.number("scale_limit", "share")


@dataclass(frozen=True, slots=True, eq=False)
class FrontEvidence:
    """Observations of the front photo: points of the face net, points that an operator corrected, ears, outline and
    nose. ``hidden`` (468,) marks net points on a beard or on hair.
    """

    view: ViewId
    net_px: Array
    hidden: NDArray[np.bool_]
    vertices: NDArray[np.int64]
    points_px: Array
    ears: PointObservations
    outline: Outline | None = None
    inside: tuple[CorrelatedPoints, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class SideEvidence:
    """Observations of the side photo: named points with their sigmas (m), the contour with its normals; +1 looks to
    image right.

    ``matches`` are skin points inside the outline, matched with the front photo,
    ``outline`` the whole person's. Of the named points those inside the outline find the first camera; in the fit
    ``ears`` and ``inside`` stand for them.
    """

    facing: int
    names: tuple[str, ...]
    vertices: NDArray[np.int64]
    points_px: Array
    sigma_m: Array
    contour_px: Array
    normals_px: Array
    ears: PointObservations
    inside: PointObservations
    matches: SkinMatches | None = None
    outline: Outline | None = None


@dataclass(slots=True)
class FitLog:
    """Residuals and warnings, collected during the fit."""

    residuals: list[Residual] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)


def front_evidence(
    model: HeadModel, photos: PhotoSet, proposals: Proposals, points: FacePoints, params: Params
) -> FrontEvidence | None:
    """Return the observations of the best front photo: the face photo, else the face in the body photo."""
    for view in (ViewId.FACE_FRONT, ViewId.BODY_FRONT):
        proposal = proposals.views.get(view)
        if proposal is None or proposal.face_presence < params.presence:
            continue
        named = points.views.get(view)
        net_px, vertices, fixed = np.array(proposal.face_px), np.zeros(0, dtype=np.int64), np.zeros((0, 2))
        if named is not None and named.corrected.any():
            vertices, fixed = _corrected_points(model, named)
            net_px = net_px + params.taught * (propagate_to_net(net_px, named) - net_px)
        edge = mask_outline(proposal) if view is ViewId.FACE_FRONT else None
        inside: tuple[CorrelatedPoints, ...] = ()
        if view is ViewId.FACE_FRONT and named is not None:
            inside = nose_observations(photos.photos[view], proposal, named)
        hidden = np.isin(_labels_at(proposal.labels, net_px), HIDING)
        ears = ear_observations(model.generic, named, params.corrected_m)
        return FrontEvidence(view, net_px, hidden, vertices, fixed, ears, edge, inside)
    return None


def _labels_at(labels: NDArray[np.uint8], places_px: Array) -> NDArray[np.uint8]:
    """Return the labels (N,) of pixels, that of the nearest pixel for points outside the photo."""
    return labels_at(labels, np.clip(places_px, 0.0, np.array(labels.shape[::-1]) - 1.0))


def _corrected_points(model: HeadModel, named: ViewPoints) -> tuple[NDArray[np.int64], Array]:
    """Return vertices and pixels of an operator's points that the generic head has."""
    known = [k for k, n in enumerate(named.names) if named.corrected[k] and n in model.generic.feature_names]
    vertices = np.array([model.generic.feature(named.names[k]) for k in known], dtype=np.int64)
    return vertices, np.array(named.points_px[known]).reshape(-1, 2)


def side_evidence(
    model: HeadModel, proposals: Proposals, silhouettes: SilhouetteSet, points: FacePoints, params: Params
) -> SideEvidence | None:
    """Return the observations of the side photo, None without a usable profile."""
    named = points.views.get(ViewId.FACE_SIDE)
    if named is None or "nose_tip" not in named.names:
        return None
    named = _without_beard_points(named, proposals.views[ViewId.FACE_SIDE].labels)
    known = [k for k, n in enumerate(named.names) if n in model.generic.feature_names and named.confidence[k] > 0.05]
    if len(known) < 4:
        return None
    silhouette = silhouettes.views.get(ViewId.FACE_SIDE)
    mask = proposals.views[ViewId.FACE_SIDE].mask
    if silhouette is not None:
        mask = np.where(silhouette.mask, np.uint8(255), np.uint8(0))
    contour = outline(mask)
    if len(contour) < 50:
        return None
    tip = named.points_px[named.names.index("nose_tip")]
    near = contour[np.abs(contour[:, 1] - tip[1]) < 0.1 * np.ptp(contour[:, 1])]
    facing = 1 if tip[0] > near[:, 0].mean() else -1
    spread = params.named_m / np.sqrt(np.maximum(named.confidence[known], 0.05))
    sigma = np.where(named.corrected[known], params.corrected_m, spread)
    vertices = np.array([model.generic.feature(named.names[k]) for k in known], dtype=np.int64)
    # Nose tip to chin is two thirds of glabella to chin; the rest allows for a chin proposed too high.
    low = tip[1] + 0.95 * np.ptp(named.points_px[known, 1])
    normals = contour_normals(contour)
    front = front_contour(np.hstack([contour, normals]), facing, low)
    front = _face_skin_outline(front, proposals.views[ViewId.FACE_SIDE].labels, float(tip[1]))
    return SideEvidence(
        facing, tuple(named.names[k] for k in known), vertices, np.array(named.points_px[known]), sigma,
        front[:, :2], front[:, 2:], ear_observations(model.generic, named, params.corrected_m),
        inner_observations(model.generic, named, params.corrected_m),
        outline=mask_outline(proposals.views[ViewId.FACE_SIDE]),
    )  # fmt: skip


def _without_beard_points(named: ViewPoints, labels: NDArray[np.uint8]) -> ViewPoints:
    """Return a profile's points without those on a beard, which hides mouth and chin."""
    bearded = (_labels_at(labels, named.points_px) == Label.BEARD) & ~named.corrected
    kept = [k for k, name in enumerate(named.names) if not bearded[k] or name == "nose_tip"]
    return replace(
        named,
        names=tuple(named.names[k] for k in kept),
        points_px=named.points_px[kept],
        confidence=named.confidence[kept],
        corrected=named.corrected[kept],
    )


def _face_skin_outline(front: Array, labels: NDArray[np.uint8], tip_row: float) -> Array:
    """Return the part of the outline (N, 4) that face skin makes: no beard, no cap, no hair over the face."""
    if not labels.any():
        return front
    inward = SKIN_DEPTH * np.ptp(front[:, 1])
    inside, row = _labels_at(labels, front[:, :2] - inward * front[:, 2:]), front[:, 1]
    hair = (inside == Label.HAIR) & (row < tip_row)
    lowest = float(row[hair].max()) if hair.any() else -np.inf
    return np.asarray(front[np.isin(inside, OWN_OUTLINE) & (row > lowest + inward)])


def focal_px(photo: Photo, params: Params, log: FitLog) -> float:
    """Return the photo's focal length, px, from EXIF or the documented default."""
    known = photo.focal_35mm is not None and photo.focal_35mm > 0
    if not known:
        log.warnings.append(f"{photo.view}: no focal length in the photo; {params.focal_35mm:.0f} mm is assumed")
    focal = photo.focal_35mm if known and photo.focal_35mm is not None else params.focal_35mm
    return focal_px_from_35mm(focal, photo.width_px, photo.height_px)
