"""Stage: the head, by shape basis and cameras of the face photos together, then DFFD (method §8)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.frames import ViewId, mm_from_m
from cloner.generic.head_controls import load_head_controls
from cloner.geometry.charts.iris import sample_iris
from cloner.geometry.meshes.eyeballs import IRIS_M
from cloner.head.evidence import FitLog, FrontEvidence, Params, SideEvidence, focal_px, front_evidence, side_evidence
from cloner.head.fit import (
    FittedHead,
    fit_head,
    initial_front_camera,
    initial_side_cameras,
    scaled_about,
)
from cloner.head.jaw import FRONT, PHOTOS, SIDE
from cloner.head.model import HeadModel, make_head_model
from cloner.head.parts import EyeObservation, place_eyes_and_mouth
from cloner.head.relief import add_relief
from cloner.head.report import height_disagreement_m, report_front, report_side, warn_missing
from cloner.head.size import body_camera, head_scale
from cloner.head.skin_matches import match_front_to_side
from cloner.head.skull import fit_skull
from cloner.records.arrays import Array
from cloner.records.bodies import Phenotype
from cloner.records.heads import HeadFit
from cloner.records.photos import PhotoSet
from cloner.records.points import FacePoints
from cloner.records.proposals import Proposals
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import SilhouetteSet
from cloner.records.views import Camera

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.head")


BROWN = np.array(_CALIBRATED.triple("brown", "grey"))
#: Both photos' heights of the same points may differ so much on the average.
APART_MM: Final = _CALIBRATED.number("apart_mm", "mm")
#: Iterations after each look into the side photo.
LOOK_TURNS = 6


@dataclass(frozen=True, slots=True, eq=False)
class ShapedHead:
    """The head after the basis, after DFFD, the controls' displacements (K, 3), the side evidence used, and the jaws'
    openings (2,) in front and side photo, radians.
    """

    basis: FittedHead
    relief: FittedHead
    moved: Array
    side: SideEvidence | None
    jaws_rad: Array


def run(
    *,
    photos: PhotoSet,
    proposals: Proposals,
    face_points: FacePoints,
    silhouettes: SilhouetteSet,
    phenotype: Phenotype,
    tick: Callable[[float], None],
) -> StageResult:
    """Produce the fitted head.

    Residuals: "front points" px and percent of the inter-ocular distance (finished head against the net's points and
    against the named proposals), "profile" mm, "height disagreement" mm of points both photos show, "head size"
    percent against the phenotype's own head, "relief" mm.
    """
    params, log = Params(), FitLog()
    model = make_head_model(phenotype)
    front = front_evidence(model, photos, proposals, face_points, params)
    side = side_evidence(model, proposals, silhouettes, face_points, params)
    shaped = shape_head(model, photos, phenotype, (front, side), params, log, tick)
    apart = height_disagreement_m(model, shaped.relief, shaped.side, face_points, shaped.jaws_rad)
    if apart is not None and mm_from_m(apart) > APART_MM:  # the profile was laid on something else
        log = FitLog()
        shaped = shape_head(model, photos, phenotype, (front, None), params, log, tick)
    fitted, side, moved = shaped.relief, shaped.side, shaped.moved
    warn_missing(front, side, proposals, log)
    controls = load_head_controls()
    tick(0.8)
    masks = _masks(fitted, front, proposals)
    skull, factors = fit_skull(model, fitted.head_m, controls, masks)
    fitted = FittedHead(skull, fitted.front, fitted.side)
    if masks:
        log.residuals.append(Residual("skull height under the hair", 100.0 * (factors[0] - 1.0), "percent"))
    scale = head_scale(model, fitted, shaped.jaws_rad[FRONT], front, proposals, phenotype, params)
    pivot = model.joints_m[model.generic.joint("skullbase")]
    fitted = scaled_about(fitted, scale, pivot)
    jaws = shaped.jaws_rad
    whole = place_eyes_and_mouth(
        model.vertices_m, model.whole(fitted.head_m), _eye_observation(fitted, front, proposals)
    )
    head = whole[model.generic.head_vertices]
    fitted = FittedHead(head, fitted.front, fitted.side)
    log.residuals.append(Residual("head size against the phenotype", 100.0 * (scale - 1.0), "percent"))
    log.residuals.append(Residual("relief", mm_from_m(float(np.linalg.norm(moved, axis=1).mean())), "mm"))
    report_front(model, fitted, front, face_points, jaws, log)
    report_side(model, fitted, side, face_points, jaws, log)
    value = HeadFit(
        head,
        _cameras(model, fitted, front, side, phenotype),
        _iris(photos, proposals, model, fitted, front),
        IRIS_M,
        "" if side is None else ("right" if side.facing > 0 else "left"),
        {view: float(jaw) for view, jaw in zip(PHOTOS, jaws, strict=True)},
    )
    return StageResult({"head": value}, tuple(log.residuals), tuple(log.warnings))


def shape_head(
    model: HeadModel,
    photos: PhotoSet,
    phenotype: Phenotype,
    evidence: tuple[FrontEvidence | None, SideEvidence | None],
    params: Params,
    log: FitLog,
    tick: Callable[[float], None],
) -> ShapedHead:
    """Return the head's shape, step by step, in the phenotype's own size."""
    front, side = evidence
    sizes = _sizes(photos, phenotype, front, side, params, log)
    zoom_sigma = params.distance_sigma if front is not None and _focal_is_unknown(photos, front) else 0.0
    coefficients, fitted = _fit(model, front, side, sizes, params, tick, zoom_sigma)
    if front is not None and side is not None and front.view is ViewId.FACE_FRONT:
        coefficients, fitted, side = _fit_with_matches(
            model, photos, front, side, coefficients, fitted, zoom_sigma, params
        )
    tick(0.6)
    relief, moved = add_relief(model, fitted, front, side, coefficients, load_head_controls(), params)
    return ShapedHead(fitted, relief, moved, side, model.jaws_rad(coefficients))


def _focal_is_unknown(photos: PhotoSet, front: FrontEvidence) -> bool:
    """Return whether nothing tells the focal length of the front photo."""
    return front.view is ViewId.FACE_FRONT and not photos.photos[front.view].focal_35mm


def _fit(
    model: HeadModel,
    front: FrontEvidence | None,
    side: SideEvidence | None,
    sizes: dict[str, tuple[int, int, float]],
    params: Params,
    tick: Callable[[float], None],
    zoom_sigma: float,
) -> tuple[Array, FittedHead]:
    """Return coefficients and head: first of the front photo, then of both together.

    With ``zoom_sigma`` the focal lengths are unknown: they start where the face is as far away as people stand.
    """
    first = None if front is None else initial_front_camera(model, front, sizes["front"], params)
    if front is not None and first is not None and zoom_sigma > 0.0:
        depth = float(first.to_camera(model.net.places.at(model.vertices_m))[:, 2].mean())
        sizes = {k: (w, h, f * params.distance_m / depth) for k, (w, h, f) in sizes.items()}
        first = initial_front_camera(model, front, sizes["front"], params)
    coefficients, fitted, _ = fit_head(model, front, None, (first, None), params)
    tick(0.3)
    if side is None:
        return coefficients, fitted
    tried = [
        fit_head(model, front, side, (fitted.front, beside), params, coefficients, zoom_sigma=zoom_sigma)
        for beside in initial_side_cameras(model, fitted.head_m, side, sizes["side"])
    ]
    coefficients, fitted, _ = min(tried, key=lambda t: t[2])
    return coefficients, fitted


def _fit_with_matches(
    model: HeadModel,
    photos: PhotoSet,
    front: FrontEvidence,
    side: SideEvidence,
    coefficients: Array,
    fitted: FittedHead,
    zoom_sigma: float,
    params: Params,
) -> tuple[Array, FittedHead, SideEvidence]:
    """Return the fit after matching front skin in the side photo, and that evidence."""
    pictures = (photos.photos[ViewId.FACE_FRONT].rgb, photos.photos[ViewId.FACE_SIDE].rgb)
    for _ in range(params.looks):
        if fitted.front is None or fitted.side is None:
            break
        cameras, shown = (fitted.front, fitted.side), 1 if side.facing > 0 else 0
        wholes = model.whole_in_photo(FRONT, coefficients), model.whole_in_photo(SIDE, coefficients)
        matches = match_front_to_side(model.generic, wholes, cameras, pictures, side=shown)
        side = replace(side, matches=matches)
        coefficients, fitted, _ = fit_head(
            model, front, side, cameras, params, coefficients, zoom_sigma=zoom_sigma, iterations=LOOK_TURNS
        )
    return coefficients, fitted, side


def _masks(
    fitted: FittedHead, front: FrontEvidence | None, proposals: Proposals
) -> list[tuple[Camera, NDArray[np.uint8]]]:
    """Return the cameras and masks of the face photos."""
    out = []
    if fitted.front is not None and front is not None and front.view is ViewId.FACE_FRONT:
        out.append((fitted.front, proposals.views[front.view].mask))
    if fitted.side is not None:
        out.append((fitted.side, proposals.views[ViewId.FACE_SIDE].mask))
    return out


def _sizes(
    photos: PhotoSet,
    phenotype: Phenotype,
    front: FrontEvidence | None,
    side: SideEvidence | None,
    params: Params,
    log: FitLog,
) -> dict[str, tuple[int, int, float]]:
    """Return width, height and focal length of the photos used."""
    out: dict[str, tuple[int, int, float]] = {}
    for key, view in (("front", None if front is None else front.view), ("side", ViewId.FACE_SIDE if side else None)):
        if view is None:
            continue
        photo = photos.photos[view]
        known = phenotype.views.get(view)
        focal = known.camera.focal_px if view.is_body and known is not None else focal_px(photo, params, log)
        out[key] = (photo.width_px, photo.height_px, focal)
    return out


def _cameras(
    model: HeadModel, fitted: FittedHead, front: FrontEvidence | None, side: SideEvidence | None, phenotype: Phenotype
) -> dict[ViewId, Camera]:
    out: dict[ViewId, Camera] = {}
    body = body_camera(model, phenotype)
    if body is not None:
        out[ViewId.BODY_FRONT] = body
    if front is not None and fitted.front is not None and front.view is ViewId.FACE_FRONT:
        out[ViewId.FACE_FRONT] = fitted.front
    if side is not None and fitted.side is not None:
        out[ViewId.FACE_SIDE] = fitted.side
    return out


def _eye_observation(fitted: FittedHead, front: FrontEvidence | None, proposals: Proposals) -> EyeObservation | None:
    """Return the eyes in the face's front photo."""
    if front is None or fitted.front is None or front.view is not ViewId.FACE_FRONT:
        return None
    proposal = proposals.views[front.view]
    return EyeObservation(fitted.front, proposal.irises_px)


def _iris(
    photos: PhotoSet, proposals: Proposals, model: HeadModel, fitted: FittedHead, front: FrontEvidence | None
) -> Array:
    """Return the iris colour of the front photo, brown by default."""
    if front is None or fitted.front is None:
        return BROWN
    whole = model.whole(fitted.head_m)
    pupils = [model.generic.feature(f"pupil_{side}") for side in "LR"]
    metres = fitted.front.metres_per_pixel(whole[pupils[0]])
    proposal = proposals.views[front.view]
    centres = proposal.irises_px
    if not centres.any():
        rules = [model.net.rules[model.net.names.index(f"pupil_{side}")] for side in "LR"]
        centres = np.stack(rules) @ front.net_px
    colour = sample_iris(photos.photos[front.view].rgb, proposal.labels, centres, IRIS_M / metres)
    return BROWN if colour is None else colour
