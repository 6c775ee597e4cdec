"""Steps of the head fit: cameras, shape coefficients, DFFD relief and size."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.face.profile import align_profile
from cloner.fit.cameras import resect
from cloner.fit.shapes import Evidence, ShapeFit, fit_shape, misfit
from cloner.geometry.cameras.viewpoints import facing_camera
from cloner.geometry.outlines.contour_match import foremost, match_contour
from cloner.head.ears import INSIDE, PointObservations
from cloner.head.evidence import FrontEvidence, Params, SideEvidence
from cloner.head.jaw import FRONT, PHOTOS, RARITY, SIDE
from cloner.head.model import HeadModel
from cloner.head.nose import CorrelatedPoints
from cloner.head.silhouette import HAIR_M, silhouette_evidence
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.fit")
#: Iterations of the joint fit; the profile's curve joins after the named points have found the pose.
ITERATIONS, CURVE_FROM = 12, 4
GATES_M = _CALIBRATED.pair("gates_m", "m")
LEVEL_M = _CALIBRATED.number("level_m", "m")
FOREHEAD_M = _CALIBRATED.number("forehead_m", "m")
LAID_M = _CALIBRATED.number("laid_m", "m")
PLACED_OUTLIER: Final = _CALIBRATED.number("placed_outlier", "sigmas")


@dataclass(frozen=True, slots=True, eq=False)
class FittedHead:
    """Vertices (H, 3) of the head at rest, and the cameras of the front and the side photo."""

    head_m: Array
    front: Camera | None
    side: Camera | None


def initial_front_camera(
    model: HeadModel, front: FrontEvidence, size: tuple[int, int, float], params: Params
) -> Camera:
    """Return an initial front camera for the generic head; ``size`` is width, height and focal length in px."""
    width, height, focal = size
    places = model.net.places.at(model.vertices_m)
    first = facing_camera(places, front.net_px, azimuth=0.0, focal_px=focal, width_px=width, height_px=height)
    sigma = _net_sigma(model, params) * focal / first.to_camera(places)[:, 2].mean()
    return resect(places, front.net_px, first, sigma_px=sigma)


def initial_side_cameras(
    model: HeadModel, head: Array, side: SideEvidence, size: tuple[int, int, float]
) -> list[Camera]:
    """Return initial side cameras, all of which are tried: from the named points, and from the head's own profile.

    The head (H, 3) is best one already fitted to the front photo, which knows the heights of nose, lips and chin: its
    profile laid on the contour is not misled by proposed points at wrong heights, nor the points by a leaking outline.
    """
    width, height, focal = size
    points = head[model.row[side.vertices]]
    azimuth = -side.facing * np.pi / 2.0
    first = facing_camera(points, side.points_px, azimuth=azimuth, focal_px=focal, width_px=width, height_px=height)
    sigma = side.sigma_m * focal / first.to_camera(points)[:, 2].mean()
    tight = np.array([0.02, 0.02, 0.3])
    named = resect(points, side.points_px, first, sigma_px=sigma, rotation_sigma=tight, outlier=1.5, iterations=40)
    if len(side.contour_px) == 0 or "nose_tip" not in side.names:  # no found point is certain to be there
        return [named]
    whole = model.whole(head)
    vertices = silhouette_vertices(whole, profile_candidates(model), first, side.facing)
    tip = whole[model.generic.feature("nose_tip")]
    nose_px = side.points_px[side.names.index("nose_tip")]
    flat = (whole[vertices] - tip)[:, [2, 1]]
    size_px = 1.0 / first.metres_per_pixel(tip)
    px_from_m, error = align_profile(side.contour_px, flat, nose_px, size=size_px, facing=side.facing)
    if error > LAID_M:
        return [named]
    laid = flat @ px_from_m[:, :2].T + px_from_m[:, 2]
    return [named, resect(whole[vertices], laid, first, sigma_px=1.0, rotation_sigma=tight, iterations=40)]


def _net_sigma(model: HeadModel, params: Params) -> Array:
    return np.sqrt(model.net.sigma_m**2 + params.net_floor_m**2)


def profile_candidates(model: HeadModel) -> NDArray[np.int64]:
    """Return face vertices near the median plane that can form the profile, from brow to chin."""
    v, generic = model.vertices_m, model.generic
    low = v[generic.feature("chin_bottom"), 1] - 0.004
    high = v[generic.feature("glabella"), 1] + FOREHEAD_M
    inside = generic.region("mouth_interior")
    wanted = (np.abs(v[:, 0]) < 0.025) & (v[:, 1] > low) & (v[:, 1] < high) & ~inside
    wanted &= generic.skin & (model.row >= 0)
    wanted &= v[:, 2] > v[generic.feature("eye_outer_L"), 2] - 0.01
    return np.flatnonzero(wanted)


def silhouette_vertices(whole: Array, candidates: NDArray[np.int64], camera: Camera, facing: int) -> NDArray[np.int64]:
    """Return the foremost candidates at each level of the side photo, with levels at two offsets."""
    step = LEVEL_M / camera.metres_per_pixel(whole[candidates].mean(axis=0))
    seen = camera.project(whole[candidates])
    found = [foremost(seen + [0.0, begin * step], facing, step_px=step) for begin in (0.0, 0.5)]
    return candidates[np.unique(np.concatenate(found))]


def net_sigmas_m(model: HeadModel, front: FrontEvidence, params: Params) -> Array:
    """Return the standard deviation (468,) of each net point's independent error, metres."""
    own = np.hypot(model.modes.alone_m, params.net_floor_m)
    return np.asarray(np.where(front.hidden, params.hidden_net, 1.0) * own)


def _front_evidence(
    model: HeadModel, net: tuple[Array, Array], front: FrontEvidence, camera: Camera, params: Params
) -> list[Evidence]:
    """Return the evidence of a front photo; ``net`` are base and basis of the net's points on the model."""
    metres = camera.metres_per_pixel(model.vertices_m[model.generic.feature("nasion")])
    base, basis = net
    sigma = params.together * net_sigmas_m(model, front, params) / metres
    drift = np.concatenate([params.drift * model.modes.drift_m / metres, np.zeros((len(HAIR_M), len(base), 2))])
    skew = np.zeros((len(basis), len(base), 2))
    skew[: len(model.modes.skew_m)] = model.modes.skew_m / metres
    target = front.net_px - model.modes.seen_errors_m(camera) / metres
    out = [Evidence(0, base, basis, target, sigma, common_error_px=drift, shape_error_px=skew)]
    if len(front.vertices):
        base, basis = model.vertex_places(front.vertices)
        sigma = np.full(len(front.vertices), params.corrected_m / metres)
        out.append(Evidence(0, base, basis, front.points_px, sigma, outlier=PLACED_OUTLIER))
    return (
        out
        + _point_evidence(model, front.ears, 0, metres, params)
        + [_correlated_evidence(model, one) for one in front.inside]
    )


def _correlated_evidence(model: HeadModel, group: CorrelatedPoints) -> Evidence:
    base, basis = model.vertex_places(group.vertices)
    return Evidence(0, base, basis, group.points_px, np.ones(len(base)), outlier=2.0, whiten=group.whiten)


def _point_evidence(
    model: HeadModel, spots: PointObservations, index: int, metres: float, params: Params, *, outlier: float = 2.0
) -> list[Evidence]:
    """Return the evidence of detected points, which may be outliers, and of points that an operator placed, which are
    not.
    """
    found = []
    placed = spots.sigma_m <= params.corrected_m
    for rows, beyond in ((~placed, outlier), (placed, PLACED_OUTLIER)):
        if rows.any():
            base, basis = model.vertex_places(spots.vertices[rows])
            sigma = spots.sigma_m[rows] / metres
            found.append(Evidence(index, base, basis, spots.points_px[rows], sigma, outlier=beyond))
    return found


def _side_evidence(model: HeadModel, side: SideEvidence, fit: ShapeFit, iteration: int, index: int, params: Params,
                   candidates: NDArray[np.int64], *, curve: bool) -> list[Evidence]:  # fmt: skip
    camera = fit.cameras[index]
    metres = camera.metres_per_pixel(model.vertices_m[model.generic.feature("nasion")])
    named = np.array([not name.startswith(("ear", *INSIDE)) for name in side.names])
    loose = np.where(side.sigma_m[named] > params.corrected_m, params.loose_named if curve else 1.0, 1.0)
    spots = PointObservations(side.vertices[named], side.points_px[named], loose * side.sigma_m[named])
    out = _point_evidence(model, spots, index, metres, params, outlier=1.5)
    for spots in (side.ears, side.inside):
        out += _point_evidence(model, spots, index, metres, params)
    if curve:
        whole = model.whole(model.head(fit.coefficients[: len(model.basis_m)]))
        vertices = silhouette_vertices(whole, candidates, camera, side.facing)
        gate = GATES_M[0 if iteration < ITERATIONS - 4 else 1] / metres
        kept, target, normal = match_contour(
            camera.project(whole[vertices]), side.contour_px, side.normals_px, gate_px=gate
        )
        base, basis = model.vertex_places(vertices[kept])
        sigma = np.full(len(kept), 1.5 * params.contour_m / metres)
        out.append(Evidence(index, base, basis, target, sigma, normal_px=normal))
    if side.matches is not None and len(side.matches.vertices):
        base, basis = model.vertex_places(side.matches.vertices)
        sigma = np.full(len(base), params.flank_m / metres)
        out.append(Evidence(index, base, basis, side.matches.points_px, sigma, outlier=2.0))
    return out


def deviation_from_profile(camera: Camera, facing: int) -> Array:
    """Return (3,) how far a camera is rotated from an exact profile view, radians about its own axes; pitch does not
    count.
    """
    across = camera.camera_from_model[:3, 0]
    return np.array([-facing * across[1], facing * across[0], 0.0])


def predicted_net_errors_m(model: HeadModel, coefficients: Array, camera: Camera, params: Params) -> Array:
    """Return the errors (468, 2) of the net's points, metres, as fitted shape, pose and common errors predict them."""
    modes, shapes = model.modes, len(model.basis_m)
    by_shape = modes.errors_m(coefficients[: len(modes.basis_m)], camera)
    return np.asarray(
        by_shape
        + params.drift * np.tensordot(coefficients[shapes : shapes + len(modes.drift_m)], modes.drift_m, axes=1)
    )


def fit_head(
    model: HeadModel,
    front: FrontEvidence | None,
    side: SideEvidence | None,
    cameras: tuple[Camera | None, Camera | None],
    params: Params,
    start: Array | None = None,
    *,
    zoom_sigma: float = 0.0,
    iterations: int = ITERATIONS,
) -> tuple[Array, FittedHead, float]:
    """Return the coefficients (F + M,), the fitted head and the misfit, from the evidence of both photos.

    The last M coefficients are the net's joint errors in this photo, the two before them how far front and side photo
    show the jaw open. ``start`` holds first coefficients; ``zoom_sigma`` is the expected relative error of the cameras'
    focal length.
    """
    present = tuple(c for c in cameras if c is not None)
    shapes, drifts = len(model.basis_m), len(model.modes.drift_m) + len(HAIR_M)
    if not present:
        return np.zeros(shapes + drifts), FittedHead(model.head(np.zeros(shapes)), None, None), 0.0
    side_index = len(present) - 1
    rotation_sigma = np.full((len(present), 3), np.inf)
    if side is not None:
        rotation_sigma[side_index] = [params.tip, params.yaw, np.inf]
    candidates = profile_candidates(model)
    outlines = [one.outline for one in (front, side) if one is not None]
    before_front, before_side = model.in_photo(FRONT), model.in_photo(SIDE)
    net = before_front.places(model.net.places)
    seen = [who for who, one in ((before_front, front), (before_side, side)) if one is not None]
    lower, decay_rate = _jaw_priors(shapes, shapes + drifts)

    def gather(fit: ShapeFit, iteration: int) -> list[Evidence]:
        found: list[Evidence] = []
        if front is not None:
            found += _front_evidence(before_front, net, front, fit.cameras[0], params)
        if side is not None:
            # After a fit to the front the profile lies well already; alone, the named points must find the pose first.
            found += _side_evidence(before_side, side, fit, iteration, side_index, params, candidates,
                                    curve=front is not None or iteration >= CURVE_FROM)  # fmt: skip
        # Alone, a side photo's named points must find the pose first.
        if front is not None:
            found += silhouette_evidence(seen, fit.coefficients, fit.cameras, outlines, len(model.modes.drift_m))
        return found

    turned = np.zeros((len(present), 3))
    if side is not None:
        turned[side_index] = deviation_from_profile(present[side_index], side.facing)
    begin = ShapeFit(np.zeros(shapes + drifts) if start is None else start, present, turned)
    fit = fit_shape(begin, gather, lower=lower, decay_rate=decay_rate, rotation_sigma=rotation_sigma,
                    zoom_sigma=zoom_sigma, iterations=iterations)  # fmt: skip
    cost = misfit(fit, gather(fit, CURVE_FROM), rotation_sigma)
    front_camera = fit.cameras[0] if front is not None else None
    side_camera = fit.cameras[side_index] if side is not None else None
    return fit.coefficients, FittedHead(model.head(fit.coefficients[:shapes]), front_camera, side_camera), cost


def _jaw_priors(shapes: int, unknowns: int) -> tuple[Array, Array]:
    """Return the lower bounds (X,) and decay rates (X,) of all unknowns: a jaw is mostly closed, and never beyond."""
    lower, decay_rate = np.full(unknowns, -np.inf), np.zeros(unknowns)
    jaws = slice(shapes - len(PHOTOS), shapes)
    lower[jaws], decay_rate[jaws] = 0.0, RARITY
    return lower, decay_rate


def scaled_about(fitted: FittedHead, scale: float, pivot: Array) -> FittedHead:
    """Return the head scaled about a point, with cameras moved away so that it projects as before."""

    def farther(camera: Camera | None) -> Camera | None:
        if camera is None:
            return None
        pose = np.array(camera.camera_from_model)
        pose[:3, 3] = scale * pose[:3, 3] + (scale - 1.0) * (pose[:3, :3] @ pivot)
        return replace(camera, camera_from_model=pose)

    return FittedHead(pivot + scale * (fitted.head_m - pivot), farther(fitted.front), farther(fitted.side))
