"""Steps of the head fit: cameras, shape coefficients, relief and size."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.face.profile import lay_profile
from cloner.fit.cameras import resect
from cloner.fit.shapes import Evidence, ShapeFit, fit_shape, misfit
from cloner.geometry.cameras.viewpoints import facing_camera
from cloner.geometry.outlines.contour_match import foremost, match
from cloner.head.ears import INSIDE, Spots
from cloner.head.evidence import Front, Params, Side
from cloner.head.inside import Together
from cloner.head.jaw import FRONT, PHOTOS, RARITY, SIDE
from cloner.head.model import Model
from cloner.head.rim import HAIR_M, rim_evidence
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
class Fitted:
    """Head vertices (H, 3) in the rest frame and the cameras of front and side evidence."""

    head_m: Array
    front: Camera | None
    side: Camera | None


def start_front(model: Model, front: Front, size: tuple[int, int, float], params: Params) -> Camera:
    """Return a first front camera from the generic head; ``size`` is width, height and focal length in px."""
    width, height, focal = size
    places = model.net.places.at(model.vertices_m)
    first = facing_camera(places, front.net_px, azimuth=0.0, focal_px=focal, width_px=width, height_px=height)
    sigma = _net_sigma(model, params) * focal / first.to_camera(places)[:, 2].mean()
    return resect(places, front.net_px, first, sigma_px=sigma)


def start_side(model: Model, head: Array, side: Side, size: tuple[int, int, float]) -> list[Camera]:
    """Return first side cameras, to be tried all: from the named points, and from the head's own profile.

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
    vertices = outline_vertices(whole, profile_candidates(model), first, side.facing)
    tip = whole[model.generic.feature("nose_tip")]
    nose_px = side.points_px[side.names.index("nose_tip")]
    flat = (whole[vertices] - tip)[:, [2, 1]]
    size_px = 1.0 / first.metres_per_pixel(tip)
    px_from_m, error = lay_profile(side.contour_px, flat, nose_px, size=size_px, facing=side.facing)
    if error > LAID_M:
        return [named]
    laid = flat @ px_from_m[:, :2].T + px_from_m[:, 2]
    return [named, resect(whole[vertices], laid, first, sigma_px=1.0, rotation_sigma=tight, iterations=40)]


def _net_sigma(model: Model, params: Params) -> Array:
    return np.sqrt(model.net.sigma_m**2 + params.net_floor_m**2)


def profile_candidates(model: Model) -> NDArray[np.int64]:
    """Return face vertices near the middle that can form the side outline, brow to chin."""
    v, generic = model.vertices_m, model.generic
    low = v[generic.feature("chin_bottom"), 1] - 0.004
    high = v[generic.feature("glabella"), 1] + FOREHEAD_M
    inside = generic.region("mouth_interior")
    wanted = (np.abs(v[:, 0]) < 0.025) & (v[:, 1] > low) & (v[:, 1] < high) & ~inside
    wanted &= generic.skin & (model.row >= 0)
    wanted &= v[:, 2] > v[generic.feature("eye_outer_L"), 2] - 0.01
    return np.flatnonzero(wanted)


def outline_vertices(whole: Array, candidates: NDArray[np.int64], camera: Camera, facing: int) -> NDArray[np.int64]:
    """Return the candidates that lie foremost at their level of the side photo, levels beginning at two heights."""
    step = LEVEL_M / camera.metres_per_pixel(whole[candidates].mean(axis=0))
    seen = camera.project(whole[candidates])
    found = [foremost(seen + [0.0, begin * step], facing, step_px=step) for begin in (0.0, 0.5)]
    return candidates[np.unique(np.concatenate(found))]


def net_errors_m(model: Model, front: Front, params: Params) -> Array:
    """Return (468,) each net point's own error, metres."""
    own = np.hypot(model.modes.alone_m, params.net_floor_m)
    return np.asarray(np.where(front.hidden, params.hidden_net, 1.0) * own)


def _front_evidence(
    model: Model, net: tuple[Array, Array], front: Front, camera: Camera, params: Params
) -> list[Evidence]:
    """Return what a front photo tells; ``net`` are base and basis of the net's points on the model."""
    metres = camera.metres_per_pixel(model.vertices_m[model.generic.feature("nasion")])
    base, basis = net
    sigma = params.together * net_errors_m(model, front, params) / metres
    drift = np.concatenate([params.drift * model.modes.drift_m / metres, np.zeros((len(HAIR_M), len(base), 2))])
    skew = np.zeros((len(basis), len(base), 2))
    skew[: len(model.modes.skew_m)] = model.modes.skew_m / metres
    target = front.net_px - model.modes.seen_errors_m(camera) / metres
    out = [Evidence(0, base, basis, target, sigma, common_error_px=drift, shape_error_px=skew)]
    if len(front.vertices):
        base, basis = model.vertex_places(front.vertices)
        sigma = np.full(len(front.vertices), params.corrected_m / metres)
        out.append(Evidence(0, base, basis, front.points_px, sigma, outlier=PLACED_OUTLIER))
    return out + _by_trust(model, front.ears, 0, metres, params) + [_together(model, one) for one in front.inside]


def _together(model: Model, group: Together) -> Evidence:
    base, basis = model.vertex_places(group.vertices)
    return Evidence(0, base, basis, group.points_px, np.ones(len(base)), outlier=2.0, whiten=group.whiten)


def _by_trust(
    model: Model, spots: Spots, index: int, metres: float, params: Params, *, outlier: float = 2.0
) -> list[Evidence]:
    """Return proposed points, which may be beside their places altogether, and placed ones, which are not."""
    found = []
    placed = spots.sigma_m <= params.corrected_m
    for rows, beyond in ((~placed, outlier), (placed, PLACED_OUTLIER)):
        if rows.any():
            base, basis = model.vertex_places(spots.vertices[rows])
            sigma = spots.sigma_m[rows] / metres
            found.append(Evidence(index, base, basis, spots.points_px[rows], sigma, outlier=beyond))
    return found


def _side_evidence(model: Model, side: Side, fit: ShapeFit, iteration: int, index: int, params: Params,
                   candidates: NDArray[np.int64], *, curve: bool) -> list[Evidence]:  # fmt: skip
    camera = fit.cameras[index]
    metres = camera.metres_per_pixel(model.vertices_m[model.generic.feature("nasion")])
    named = np.array([not name.startswith(("ear", *INSIDE)) for name in side.names])
    loose = np.where(side.sigma_m[named] > params.corrected_m, params.loose_named if curve else 1.0, 1.0)
    spots = Spots(side.vertices[named], side.points_px[named], loose * side.sigma_m[named])
    out = _by_trust(model, spots, index, metres, params, outlier=1.5)
    for spots in (side.ears, side.inside):
        out += _by_trust(model, spots, index, metres, params)
    if curve:
        whole = model.whole(model.head(fit.coefficients[: len(model.basis_m)]))
        vertices = outline_vertices(whole, candidates, camera, side.facing)
        gate = GATES_M[0 if iteration < ITERATIONS - 4 else 1] / metres
        kept, target, normal = match(camera.project(whole[vertices]), side.contour_px, side.normals_px, gate_px=gate)
        base, basis = model.vertex_places(vertices[kept])
        sigma = np.full(len(kept), 1.5 * params.contour_m / metres)
        out.append(Evidence(index, base, basis, target, sigma, normal_px=normal))
    if side.flank is not None and len(side.flank.vertices):
        base, basis = model.vertex_places(side.flank.vertices)
        sigma = np.full(len(base), params.flank_m / metres)
        out.append(Evidence(index, base, basis, side.flank.points_px, sigma, outlier=2.0))
    return out


def off_profile(camera: Camera, facing: int) -> Array:
    """Return (3,) how far a camera is turned from an exact profile, radians in its own axes: sideways and about the
    vertical. A nod is none.
    """
    across = camera.camera_from_model[:3, 0]
    return np.array([-facing * across[1], facing * across[0], 0.0])


def net_errors(model: Model, coefficients: Array, camera: Camera, params: Params) -> Array:
    """Return the errors (468, 2), metres, that the net's points make: by a face's shape and turn, and in this photo."""
    modes, shapes = model.modes, len(model.basis_m)
    by_shape = modes.errors_m(coefficients[: len(modes.basis_m)], camera)
    return np.asarray(
        by_shape
        + params.drift * np.tensordot(coefficients[shapes : shapes + len(modes.drift_m)], modes.drift_m, axes=1)
    )


def fit_basis(model: Model, front: Front | None, side: Side | None, cameras: tuple[Camera | None, Camera | None],
              params: Params, start: Array | None = None, *, zoom_sigma: float = 0.0,
              iterations: int = ITERATIONS) -> tuple[Array, Fitted, float]:  # fmt: skip
    """Return the coefficients (F + M,), the fitted head, and its misfit, from all evidence together.

    The last M coefficients are the net's joint errors in this photo, the two before them how far front and side photo
    show the jaw open. ``start`` holds first coefficients; ``zoom_sigma`` is the expected relative error of the cameras'
    focal length.
    """
    present = tuple(c for c in cameras if c is not None)
    shapes, drifts = len(model.basis_m), len(model.modes.drift_m) + len(HAIR_M)
    if not present:
        return np.zeros(shapes + drifts), Fitted(model.head(np.zeros(shapes)), None, None), 0.0
    side_index = len(present) - 1
    rotation_sigma = np.full((len(present), 3), np.inf)
    if side is not None:
        rotation_sigma[side_index] = [params.tip, params.yaw, np.inf]
    candidates = profile_candidates(model)
    outlines = [one.outline for one in (front, side) if one is not None]
    before_front, before_side = model.in_photo(FRONT), model.in_photo(SIDE)
    net = before_front.places(model.net.places)
    seen = [who for who, one in ((before_front, front), (before_side, side)) if one is not None]
    at_least, rarity = np.full(shapes + drifts, -np.inf), np.zeros(shapes + drifts)
    at_least[shapes - len(PHOTOS) : shapes] = 0.0  # a jaw does not close beyond shut
    rarity[shapes - len(PHOTOS) : shapes] = RARITY

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
            found += rim_evidence(seen, fit.coefficients, fit.cameras, outlines, len(model.modes.drift_m))
        return found

    turned = np.zeros((len(present), 3))
    if side is not None:
        turned[side_index] = off_profile(present[side_index], side.facing)
    begin = ShapeFit(np.zeros(shapes + drifts) if start is None else start, present, turned)
    fit = fit_shape(
        begin,
        gather,
        lower=at_least,
        decay_rate=rarity,
        rotation_sigma=rotation_sigma,
        zoom_sigma=zoom_sigma,
        iterations=iterations,
    )
    front_camera = fit.cameras[0] if front is not None else None
    side_camera = fit.cameras[side_index] if side is not None else None
    cost = misfit(fit, gather(fit, CURVE_FROM), rotation_sigma)
    return fit.coefficients, Fitted(model.head(fit.coefficients[:shapes]), front_camera, side_camera), cost


def scaled(fitted: Fitted, scale: float, pivot: Array) -> Fitted:
    """Return the head scaled about a point, seen alike by its cameras from farther away."""

    def farther(camera: Camera | None) -> Camera | None:
        if camera is None:
            return None
        pose = np.array(camera.camera_from_model)
        pose[:3, 3] = scale * pose[:3, 3] + (scale - 1.0) * (pose[:3, :3] @ pivot)
        return replace(camera, camera_from_model=pose)

    return Fitted(pivot + scale * (fitted.head_m - pivot), farther(fitted.front), farther(fitted.side))
