"""The head: shape basis and cameras of the face photos together, then DFFD (method §8)."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId, mm_from_m
from cloner.generic.head_controls import load_head_controls
from cloner.geometry.contour_match import match
from cloner.geometry.iris import sample_iris
from cloner.geometry.skinning import joint_transforms
from cloner.records.bodies import Phenotype
from cloner.records.heads import HeadFit
from cloner.records.photos import Person, PhotoSet
from cloner.records.points import FacePoints, Proposals
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import SilhouetteSet
from cloner.records.views import Camera
from cloner.stages.head_evidence import Front, Log, Model, Params, Side, focal_px, make_model, read_front, read_side
from cloner.stages.head_fit import (
    Fitted,
    add_relief,
    fit_basis,
    outline_vertices,
    profile_candidates,
    scaled,
    seat_parts,
    start_front,
    start_side,
)
from cloner.stages.head_skull import fit_skull

Array = NDArray[np.float64]

#: Radius of the human iris, metres; varies by under 5 % among adults (Gharaee et al. 2014: 11.8 mm diameter).
IRIS_RADIUS_M = 0.0059
#: Colour used when no photo shows the irises, sRGB levels.
BROWN = np.array([92.0, 64.0, 45.0])
#: Names that front and side photos both propose.
SHARED = ("nasion", "nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom")


def run(
    *,
    photos: PhotoSet,
    proposals: Proposals,
    face_points: FacePoints,
    silhouettes: SilhouetteSet,
    phenotype: Phenotype,
    person: Person,
    tick: Callable[[float], None],
    rng: np.random.Generator,
) -> StageResult:
    """Give the fitted head.

    Residuals: "front points" px and percent of the inter-ocular distance (finished head against the net's points and
    against the named proposals), "profile" mm, "height disagreement" mm of points both photos show, "head size"
    percent against the phenotype's own head, "relief" mm.
    """
    params, log = Params(), Log()
    model = make_model(phenotype)
    front = read_front(model, proposals, face_points, params)
    side = read_side(model, proposals, silhouettes, face_points, params)
    _warn(front, side, proposals, log)
    coefficients, fitted = _fit(model, front, side, _sizes(photos, phenotype, front, side, params, log), params, tick)
    tick(0.6)
    drifts = coefficients[len(model.basis_m) :]
    controls = load_head_controls()
    fitted, moved = add_relief(model, fitted, front, side, drifts, controls, params)
    tick(0.8)
    masks = _masks(fitted, front, proposals)
    skull, factors = fit_skull(model, fitted.head_m, controls, masks)
    fitted = Fitted(skull, fitted.front, fitted.side)
    if masks:
        log.residuals.append(Residual("skull height under the hair", 100.0 * (factors[0] - 1.0), "percent"))
    scale = head_scale(model, fitted, front, proposals, phenotype, params)
    pivot = model.joints_m[model.generic.joint("skullbase")]
    fitted = scaled(fitted, scale, pivot)
    head = seat_parts(model, fitted.head_m, scale)
    fitted = Fitted(head, fitted.front, fitted.side)
    log.residuals.append(Residual("head size against the phenotype", 100.0 * (scale - 1.0), "percent"))
    log.residuals.append(Residual("relief", mm_from_m(float(np.linalg.norm(moved, axis=1).mean())), "mm"))
    _report_front(model, fitted, front, face_points, log)
    _report_side(model, fitted, side, face_points, log)
    value = HeadFit(
        head,
        _cameras(model, fitted, front, side, phenotype),
        controls.names,
        pivot + scale * (_controls_before(model, controls.controls_m, phenotype) + moved - pivot),
        _iris(photos, model, fitted, front),
        IRIS_RADIUS_M,
        "" if side is None else ("right" if side.facing > 0 else "left"),
    )
    return StageResult({"head": value}, tuple(log.residuals), tuple(log.warnings))


def _fit(model: Model, front: Front | None, side: Side | None, sizes: dict[str, tuple[int, int, float]],
         params: Params, tick: Callable[[float], None]) -> tuple[Array, Fitted]:  # fmt: skip
    """Return coefficients and head: the front photo first, then both together."""
    first = None if front is None else start_front(model, front, sizes["front"], params)
    coefficients, fitted, _ = fit_basis(model, front, None, (first, None), params)
    tick(0.3)
    if side is None:
        return coefficients, fitted
    tried = [
        fit_basis(model, front, side, (fitted.front, beside), params, coefficients)
        for beside in start_side(model, fitted.head_m, side, sizes["side"], params)
    ]
    coefficients, fitted, _ = min(tried, key=lambda t: t[2])
    return coefficients, fitted


def _masks(fitted: Fitted, front: Front | None, proposals: Proposals) -> list[tuple[Camera, NDArray[np.uint8]]]:
    """Return the cameras and masks of the face photos."""
    out = []
    if fitted.front is not None and front is not None and front.view is ViewId.FACE_FRONT:
        out.append((fitted.front, proposals.views[front.view].mask))
    if fitted.side is not None:
        out.append((fitted.side, proposals.views[ViewId.FACE_SIDE].mask))
    return out


def _controls_before(model: Model, controls_m: Array, phenotype: Phenotype) -> Array:
    """Return the controls of the mean head at the phenotype's stature."""
    middle = model.generic.vertices_m[model.generic.feature("nasion")].astype(np.float64)
    return np.asarray(controls_m - middle + model.vertices_m[model.generic.feature("nasion")])


def _warn(front: Front | None, side: Side | None, proposals: Proposals, log: Log) -> None:
    if front is None:
        log.warnings.append("no photo shows the face from the front: the head is the generic one of this build")
    elif front.view is ViewId.BODY_FRONT:
        log.warnings.append("no usable front photo of the face: the face comes from the small one in the body photo")
    if side is None:
        missing = ViewId.FACE_SIDE not in proposals.views
        why = "there is no side photo of the face" if missing else "no profile was found in the side photo of the face"
        log.warnings.append(f"{why}: depths of the face are those of a usual face of this shape")


def _sizes(photos: PhotoSet, phenotype: Phenotype, front: Front | None, side: Side | None, params: Params, log: Log
           ) -> dict[str, tuple[int, int, float]]:  # fmt: skip
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


def body_camera(model: Model, phenotype: Phenotype) -> Camera | None:
    """Return body_front's camera relative to the rest head, which the body's pose carries along."""
    posed = phenotype.views.get(ViewId.BODY_FRONT)
    if posed is None:
        return None
    transforms = joint_transforms(model.joints_m, model.generic.joint_parents.astype(np.int32), posed.rotations)
    skull = transforms[model.generic.joint("skullbase")]
    camera = posed.camera
    return Camera(camera.width_px, camera.height_px, camera.focal_px, camera.camera_from_model @ skull,
                  camera.pixels_per_m)  # fmt: skip


def head_scale(
    model: Model, fitted: Fitted, front: Front | None, proposals: Proposals, phenotype: Phenotype, params: Params
) -> float:
    """Return the head's size as a factor: the face in the body photo against the phenotype's own head.

    The face photos alone tell no size. The body photo does, through its camera, but its face is small; both guesses
    are weighted by their errors.
    """
    camera, proposal = body_camera(model, phenotype), proposals.views.get(ViewId.BODY_FRONT)
    if front is None or camera is None or proposal is None or proposal.face_presence < params.presence:
        return 1.0
    seen = camera.project(model.net.places.at(model.whole(fitted.head_m)))
    weight = 1.0 / (model.net.sigma_m**2 + params.net_floor_m**2)
    weight = weight / weight.sum()
    wanted = proposal.face_px - weight @ proposal.face_px
    have = seen - weight @ seen
    turned = (weight * (np.conj(have @ [1, 1j]) * (wanted @ [1, 1j]))).sum()
    factor = abs(turned) / max(float(weight @ (have**2).sum(axis=1)), 1e-12)
    certain = params.own_scale**2 / (params.own_scale**2 + params.body_scale**2)
    limit = np.log1p(params.scale_limit)
    return float(np.exp(np.clip(certain * np.log(max(factor, 1e-3)), -limit, limit)))


def _cameras(model: Model, fitted: Fitted, front: Front | None, side: Side | None, phenotype: Phenotype
             ) -> dict[ViewId, Camera]:  # fmt: skip
    out: dict[ViewId, Camera] = {}
    body = body_camera(model, phenotype)
    if body is not None:
        out[ViewId.BODY_FRONT] = body
    if front is not None and fitted.front is not None and front.view is ViewId.FACE_FRONT:
        out[ViewId.FACE_FRONT] = fitted.front
    if side is not None and fitted.side is not None:
        out[ViewId.FACE_SIDE] = fitted.side
    return out


def _iris(photos: PhotoSet, model: Model, fitted: Fitted, front: Front | None) -> Array:
    """Return the iris colour of the front photo, or brown."""
    if front is None or fitted.front is None:
        return BROWN
    whole = model.whole(fitted.head_m)
    pupils = [model.generic.feature(f"pupil_{side}") for side in "LR"]
    metres = fitted.front.metres_per_pixel(whole[pupils[0]])
    rules = [model.net.rules[model.net.names.index(f"pupil_{side}")] for side in "LR"]
    colour = sample_iris(photos.photos[front.view].rgb, np.stack(rules) @ front.net_px, IRIS_RADIUS_M / metres)
    return BROWN if colour is None else colour


def _report_front(model: Model, fitted: Fitted, front: Front | None, points: FacePoints, log: Log) -> None:
    if front is None or fitted.front is None:
        return
    whole = model.whole(fitted.head_m)
    eyes = fitted.front.project(whole[[model.generic.feature(f"pupil_{side}") for side in "LR"]])
    distance = max(float(np.linalg.norm(eyes[0] - eyes[1])), 1e-6)
    error = np.linalg.norm(fitted.front.project(model.net.places.at(whole)) - front.net_px, axis=1)
    view = str(front.view)
    log.residuals.append(Residual("front net points", float(error.mean()), "px", view))
    log.residuals.append(Residual("front net points", 100.0 * float(error.mean()) / distance, "percent", view))
    named = points.views.get(front.view)
    known = [] if named is None else [
        k for k, n in enumerate(named.names) if n in model.generic.feature_names and not n.startswith("ear")
    ]  # fmt: skip
    if named is not None and known:
        vertices = [model.generic.feature(named.names[k]) for k in known]
        error = np.linalg.norm(fitted.front.project(whole[vertices]) - named.points_px[known], axis=1)
        error = 100.0 * error / distance
        log.residuals.append(Residual("front named points", float(error.mean()), "percent", view))
        log.residuals.append(Residual("front named points, worst", float(error.max()), "percent", view))


def _report_side(model: Model, fitted: Fitted, side: Side | None, points: FacePoints, log: Log) -> None:
    if side is None or fitted.side is None:
        return
    whole = model.whole(fitted.head_m)
    vertices = outline_vertices(whole, profile_candidates(model), fitted.side, side.facing)
    metres = fitted.side.metres_per_pixel(whole[model.generic.feature("nasion")])
    seen = fitted.side.project(whole[vertices])
    kept, target, normal = match(seen, side.contour_px, side.normals_px, gate_px=0.015 / metres)
    error = np.abs(((seen[kept] - target) * normal).sum(axis=1)) * metres
    view = str(ViewId.FACE_SIDE)
    log.residuals.append(Residual("profile", mm_from_m(float(error.mean())) if len(kept) else 0.0, "mm", view))
    front = points.views.get(ViewId.FACE_FRONT)
    if front is None or fitted.front is None:
        return
    heights = []
    for name in SHARED:
        from_front, from_side = front.get(name), dict(zip(side.names, side.points_px, strict=True)).get(name)
        if from_front is not None and from_side is not None:
            near = whole[[model.generic.feature(name)]]
            pair = [c.back_project(p[None], near)[0, 1] for c, p in
                    ((fitted.front, from_front), (fitted.side, from_side))]  # fmt: skip
            heights.append(abs(pair[0] - pair[1]))
    if heights:
        log.residuals.append(Residual("height disagreement", mm_from_m(float(np.mean(heights))), "mm", view))
