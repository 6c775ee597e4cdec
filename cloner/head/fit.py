"""Steps of the head fit: cameras, shape coefficients, relief and size."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix

from cloner.detectors.profile import lay_profile
from cloner.generic.head_controls import HeadControls
from cloner.geometry.contour_match import foremost, match
from cloner.geometry.dffd import deform
from cloner.geometry.relief import Leftover, solve_relief
from cloner.geometry.resection import facing_camera, resect
from cloner.geometry.shape_fit import Evidence, ShapeFit, fit_shape, misfit
from cloner.geometry.surface import SurfacePoints
from cloner.head.ears import INSIDE, Spots
from cloner.head.evidence import Front, Model, Params, Side
from cloner.head.inside import Together
from cloner.head.jaw import FRONT, PHOTOS, RARITY, SIDE
from cloner.head.rim import HAIR_M, rim_evidence
from cloner.records.views import Camera

Array = NDArray[np.float64]

#: Iterations of the joint fit; the profile's curve joins after the named points have found the pose.
ITERATIONS, CURVE_FROM = 12, 4
#: A contour point farther than this from the model's profile is none of its; shrinks over the iterations, metres.
GATES_M = (0.015, 0.006)
#: Height of the levels of which each gives its foremost vertex to the outline. Rows of the generic's vertices lie up to
#: 5 mm apart: in finer levels vertices inside the face stand for its outline (true shape and camera of 11 random heads
#: against their photos' outlines: 1.4 mm rms at 3 mm, 0.3 at 6).
LEVEL_M = 0.006
#: The forehead is followed up to this over the glabella, where no hair covers it, metres.
FOREHEAD_M = 0.045
#: An operator's point keeps its weight until the head is so many of its expected errors off it. With a proposed
#: point's 1.5 to 2 the first dragged ones of a side photo were doubted most where they had most to tell.
PLACED_OUTLIER: Final = 8.0
#: A profile laid on the contour with a larger trimmed mean distance is not trusted, metres.
LAID_M = 0.004


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
    return resect(places, front.net_px, first, sigma_px=sigma).camera


def start_side(model: Model, head: Array, side: Side, size: tuple[int, int, float], params: Params) -> list[Camera]:
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
    named = resect(points, side.points_px, first, sigma_px=sigma, turn_sigma=tight, outlier=1.5, iterations=40).camera
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
    return [named, resect(whole[vertices], laid, first, sigma_px=1.0, turn_sigma=tight, iterations=40).camera]


def _net_sigma(model: Model, params: Params) -> Array:
    return np.sqrt(model.net.sigma_m**2 + params.net_floor_m**2)


def profile_candidates(model: Model) -> NDArray[np.int64]:
    """Return face vertices near the middle that can form the side outline, brow to chin."""
    v, generic = model.vertices_m, model.generic
    low = v[generic.feature("chin_bottom"), 1] - 0.004
    high = v[generic.feature("glabella"), 1] + FOREHEAD_M
    inside = generic.region("mouth_interior")
    wanted = (np.abs(v[:, 0]) < 0.025) & (v[:, 1] > low) & (v[:, 1] < high) & ~inside
    wanted &= (generic.vertex_part == generic.part_names.index("body")) & (model.row >= 0)
    wanted &= v[:, 2] > v[generic.feature("eye_outer_L"), 2] - 0.01
    return np.flatnonzero(wanted)


def outline_vertices(whole: Array, candidates: NDArray[np.int64], camera: Camera, facing: int) -> NDArray[np.int64]:
    """Return the candidates that lie foremost at their level of the side photo, levels beginning at two heights."""
    step = LEVEL_M / camera.metres_per_pixel(whole[candidates].mean(axis=0))
    seen = camera.project(whole[candidates])
    found = [foremost(seen + [0.0, begin * step], facing, step_px=step) for begin in (0.0, 0.5)]
    return candidates[np.unique(np.concatenate(found))]


def _net_errors_m(model: Model, front: Front, params: Params) -> Array:
    """Return (468,) each net point's own error, metres."""
    own = np.hypot(model.modes.alone_m, params.net_floor_m)
    return np.asarray(np.where(front.hidden, params.hidden_net, 1.0) * own)


def _front_evidence(model: Model, front: Front, camera: Camera, params: Params) -> list[Evidence]:
    metres = camera.metres_per_pixel(model.vertices_m[model.generic.feature("nasion")])
    base, basis = model.places(model.net.places)
    sigma = params.together * _net_errors_m(model, front, params) / metres
    drift = np.concatenate([params.drift * model.modes.drift_m / metres, np.zeros((len(HAIR_M), len(base), 2))])
    skew = np.zeros((len(basis), len(base), 2))
    skew[: len(model.modes.skew_m)] = model.modes.skew_m / metres
    target = front.net_px - model.modes.seen_errors_m(camera) / metres
    out = [Evidence(0, base, basis, target, sigma, drift_px=drift, skew_px=skew)]
    if len(front.vertices):
        base, basis = model.vertex_places(front.vertices)
        sigma = np.full(len(front.vertices), params.corrected_m / metres)
        out.append(Evidence(0, base, basis, front.points_px, sigma, outlier=PLACED_OUTLIER))
    return out + _spot_evidence(model, front.ears, 0, metres, params) + [_together(model, one) for one in front.inside]


def _together(model: Model, group: Together) -> Evidence:
    base, basis = model.vertex_places(group.vertices)
    return Evidence(0, base, basis, group.points_px, np.ones(len(base)), outlier=2.0, whiten=group.whiten)


def _spot_evidence(model: Model, spots: Spots, index: int, metres: float, params: Params) -> list[Evidence]:
    return _by_trust(model, spots, index, metres, params.corrected_m, outlier=2.0)


def _by_trust(
    model: Model, spots: Spots, index: int, metres: float, corrected_m: float, *, outlier: float
) -> list[Evidence]:
    """Return proposed points, which may be beside their places altogether, and placed ones, which are not."""
    found = []
    placed = spots.sigma_m <= corrected_m
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
    out = _by_trust(model, spots, index, metres, params.corrected_m, outlier=1.5)
    for spots in (side.ears, side.inside):
        out += _spot_evidence(model, spots, index, metres, params)
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
    turn_sigma = np.full((len(present), 3), np.inf)
    if side is not None:
        turn_sigma[side_index] = [params.tip, params.yaw, np.inf]
    candidates = profile_candidates(model)
    outlines = [one.outline for one in (front, side) if one is not None]
    before_front, before_side = model.in_photo(FRONT), model.in_photo(SIDE)
    seen = [who for who, one in ((before_front, front), (before_side, side)) if one is not None]
    at_least, rarity = np.full(shapes + drifts, -np.inf), np.zeros(shapes + drifts)
    at_least[shapes - len(PHOTOS) : shapes] = 0.0  # a jaw does not close beyond shut
    rarity[shapes - len(PHOTOS) : shapes] = RARITY

    def gather(fit: ShapeFit, iteration: int) -> list[Evidence]:
        found: list[Evidence] = []
        if front is not None:
            found += _front_evidence(before_front, front, fit.cameras[0], params)
        if side is not None:
            # After a fit to the front the profile lies well already; alone, the named points must find the pose first.
            found += _side_evidence(before_side, side, fit, iteration, side_index, params, candidates,
                                    curve=front is not None or iteration >= CURVE_FROM)  # fmt: skip
        # Alone, a side photo's named points must find the pose first.
        if front is not None:
            found += rim_evidence(seen, fit.coefficients, fit.cameras, outlines, len(model.modes.drift_m))
        return found

    begin = ShapeFit(np.zeros(shapes + drifts) if start is None else start, present, np.zeros((len(present), 3)))
    fit = fit_shape(
        begin,
        gather,
        at_least=at_least,
        rarity=rarity,
        turn_sigma=turn_sigma,
        zoom_sigma=zoom_sigma,
        iterations=iterations,
    )
    front_camera = fit.cameras[0] if front is not None else None
    side_camera = fit.cameras[side_index] if side is not None else None
    cost = misfit(fit, gather(fit, CURVE_FROM), turn_sigma)
    return fit.coefficients, Fitted(model.head(fit.coefficients[:shapes]), front_camera, side_camera), cost


def _rows(weights: csr_matrix, model: Model, surface: SurfacePoints, movable: NDArray[np.bool_]) -> csr_matrix:
    """Return the (N, K) weights of surface points on the movable controls."""
    rows = model.row[surface.corners]
    point = np.repeat(np.arange(len(rows)), 3)
    place = csr_matrix((surface.weights.ravel(), (point, rows.ravel())), shape=(len(rows), weights.shape[0]))
    return csr_matrix((place @ weights)[:, np.flatnonzero(movable)])


def add_relief(model: Model, fitted: Fitted, front: Front | None, side: Side | None, coefficients: Array,
               controls: HeadControls, params: Params) -> tuple[Fitted, Array]:  # fmt: skip
    """Return the head after DFFD of what the basis left over, and all controls' displacements (K, 3).

    What the fit (its ``coefficients``) took for errors of the net is no shape: it is not followed.
    """
    left: list[Leftover] = []
    if front is not None and fitted.front is not None:
        whole = model.whole_in_photo(FRONT, coefficients)
        net_error_m = net_errors(model, coefficients, fitted.front, params)
        left += _front_leftovers(model, whole, fitted.front, front, net_error_m, controls, params)
    if side is not None and fitted.side is not None:
        whole = model.whole_in_photo(SIDE, coefficients)
        left += _side_leftovers(model, whole, fitted.side, side, controls, params)
    moved = np.zeros((len(controls.names), 3))
    if left:
        moved[controls.movable] = solve_relief(
            controls.controls_m[controls.movable], left,
            size_m=params.relief_m, bend_m=params.bend_m, limit_m=params.limit_m,
        )  # fmt: skip
    return replace(fitted, head_m=fitted.head_m + deform(controls.weights, moved)), moved


def _front_leftovers(model: Model, whole: Array, camera: Camera, front: Front, net_error_m: Array,
                     controls: HeadControls, params: Params) -> list[Leftover]:  # fmt: skip
    metres = camera.metres_per_pixel(whole[model.generic.feature("nasion")])
    weights = _rows(controls.weights, model, model.net.places, controls.movable)
    sigma = params.loose_net * _net_errors_m(model, front, params) / metres
    target = front.net_px - net_error_m / metres
    out = [Leftover(camera, model.net.places.at(whole), weights, target, sigma)]
    if len(front.vertices):
        rows = csr_matrix(controls.weights[model.row[front.vertices]][:, np.flatnonzero(controls.movable)])
        sigma = np.full(len(front.vertices), 0.3 * params.corrected_m / metres)
        out.append(Leftover(camera, whole[front.vertices], rows, front.points_px, sigma))
    return out


def _side_leftovers(model: Model, whole: Array, camera: Camera, side: Side, controls: HeadControls,
                    params: Params) -> list[Leftover]:  # fmt: skip
    metres = camera.metres_per_pixel(whole[model.generic.feature("nasion")])
    movable = np.flatnonzero(controls.movable)
    vertices = outline_vertices(whole, profile_candidates(model), camera, side.facing)
    gate = GATES_M[1] / metres
    kept, target, normal = match(camera.project(whole[vertices]), side.contour_px, side.normals_px, gate_px=gate)
    rows = csr_matrix(controls.weights[model.row[vertices[kept]]][:, movable])
    sigma = np.full(len(kept), 0.5 * params.contour_m / metres)
    out = [Leftover(camera, whole[vertices[kept]], rows, target, sigma, normal)]
    if side.flank is not None and len(side.flank.vertices):
        rows = csr_matrix(controls.weights[model.row[side.flank.vertices]][:, movable])
        sigma = np.full(rows.shape[0], params.loose_net * params.flank_m / metres)
        out.append(Leftover(camera, whole[side.flank.vertices], rows, side.flank.points_px, sigma))
    fixed = side.sigma_m <= params.corrected_m
    if fixed.any():
        rows = csr_matrix(controls.weights[model.row[side.vertices[fixed]]][:, movable])
        sigma = np.full(int(fixed.sum()), 0.3 * params.corrected_m / metres)
        out.append(Leftover(camera, whole[side.vertices[fixed]], rows, side.points_px[fixed], sigma))
    return out


def scaled(fitted: Fitted, scale: float, pivot: Array) -> Fitted:
    """Return the head scaled about a point, seen alike by its cameras from farther away."""

    def farther(camera: Camera | None) -> Camera | None:
        if camera is None:
            return None
        pose = np.array(camera.camera_from_model)
        pose[:3, 3] = scale * pose[:3, 3] + (scale - 1.0) * (pose[:3, :3] @ pivot)
        return replace(camera, camera_from_model=pose)

    return Fitted(pivot + scale * (fitted.head_m - pivot), farther(fitted.front), farther(fitted.side))
