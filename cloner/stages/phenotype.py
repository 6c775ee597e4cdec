"""The nearest generic human, and the pose and camera of every body photo.

Method §7 "Beyond": shape coefficients, one pose a photo and the perspective
cameras are solved together, first to the joints, then to the outlines too, before
the paper's skeleton, rough and fine steps begin.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId, m_from_mm, mm_from_m
from cloner.generic.load import GENERIC_STATURE_M, GenericHuman, load_generic
from cloner.geometry.contours import OutlineField, outline_field
from cloner.geometry.poses import FREEDOMS, pose_matrix, prior_spread, standing_pose
from cloner.geometry.posing import Chosen, moved_camera
from cloner.geometry.rims import rim_vertices, vertex_normals
from cloner.records.bodies import Phenotype, PosedView
from cloner.records.photos import Person
from cloner.records.points import HAIR, BodyPoints, Proposals, ViewPoints
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import SilhouetteSet
from cloner.records.views import Camera, View, ViewSet

Array = NDArray[np.float64]
Tick = Callable[[float], None]

CAMERA_FREEDOMS = 6



@dataclass(frozen=True, slots=True)
class Params:
    """Weights of the evidence, as spreads (all measured on the sample visitors unless said).

    Attributes
    ----------
    joint_mm, outline_point_mm, corrected_mm : float
        Trust in net joints, proposed outline points and an operator's points.
    outline_mm : float
        Trust in one independent piece of outline.
    outline_piece_mm : float
        Length of outline that counts as independent evidence.
    hair_mm, hair_spread_mm, sole_spread_m : float
        Usual hair above the skull, its spread, and the trust in a photo's lowest outline (taste).
    shoe_sole_m, bare_sole_m : tuple of float
        Least and greatest height of soles below the foot, shod and barefoot.
    floor_mm : float
        How far heels and toes of both feet may stand off one level floor.
    camera_degrees, camera_share : tuple
        Prior spread of the first camera: pitch, heading, roll; shift x, y, distance share.
    shapes : tuple of int
        Number of shape coefficients in the successive rounds.
    height_px : int
        Photo height at which outlines are compared.
    """

    joint_mm: float = 30.0
    outline_point_mm: float = 40.0
    corrected_mm: float = 4.0
    outline_mm: float = 15.0
    outline_piece_mm: float = 25.0
    hair_mm: float = 12.0
    hair_spread_mm: float = 8.0
    floor_mm: float = 4.0
    shoe_sole_m: tuple[float, float] = (0.014, 0.034)
    bare_sole_m: tuple[float, float] = (0.0, 0.003)
    sole_spread_m: float = 0.0025
    camera_degrees: tuple[float, float, float] = (0.8, 3.0, 2.0)
    camera_share: tuple[float, float, float] = (0.1, 0.1, 0.15)
    shapes: tuple[int, ...] = (6, 12, 24, 30, 30)
    turns_per_round: int = 3
    height_px: int = 640


@dataclass(frozen=True, slots=True, eq=False)
class _Evidence:
    """What one photo says, with the first camera."""

    view: View
    points: ViewPoints
    field: OutlineField
    mm_per_px: float
    top_px: Array
    bottom_px: Array
    barefoot: bool


@dataclass(frozen=True, slots=True, eq=False)
class _State:
    """The unknowns: shape (C,), and per view camera motion (6,) and pose (D,)."""

    shape: Array
    motions: dict[ViewId, Array]
    poses: dict[ViewId, Array]


def choose(generic: GenericHuman, vertices: NDArray[np.int64], stature_m: float, coefficients: int) -> Chosen:
    """Return the linear model of some vertices at a stature."""
    scale = stature_m / GENERIC_STATURE_M
    return Chosen(
        scale * generic.vertices_m[vertices].astype(np.float64),
        scale * generic.shape_basis[:coefficients, vertices].astype(np.float64).reshape(coefficients, -1),
        scale * generic.joints_m.astype(np.float64),
        scale * generic.joint_basis[:coefficients].astype(np.float64).reshape(coefficients, -1),
        np.asarray(generic.joint_parents, dtype=np.int32),
        np.asarray(generic.skin_joints[vertices], dtype=np.int32),
        generic.skin_weights[vertices].astype(np.float64),
        pose_matrix(generic.joint_names),
    )


def _evidence(view: View, points: ViewPoints, silhouettes: SilhouetteSet, proposals: Proposals, params: Params) -> _Evidence:
    outline = silhouettes.views[view.view]
    middle = np.array([0.0, 0.9, 0.0])
    mm_per_px = mm_from_m(view.camera.metres_per_pixel(middle))
    reduction = max(view.camera.height_px / params.height_px, 1.0)
    field = outline_field(
        outline.contours_px,
        outline.mask,
        proposals.views[view.view].labels == HAIR,
        step_px=2.0 * reduction,
        reduction=reduction,
    )
    rows = np.flatnonzero(outline.mask.any(axis=1))
    top = np.array([np.flatnonzero(outline.mask[rows[0]]).mean(), rows[0] - 0.5])
    bottom = np.array([np.flatnonzero(outline.mask[rows[-1]]).mean(), rows[-1] + 0.5])
    return _Evidence(view, points, field, mm_per_px, top, bottom, proposals.views[view.view].barefoot)


class _PointTerm:
    """Named points of one photo against joints and feature vertices of the model."""

    def __init__(self, generic: GenericHuman, evidence: _Evidence, stature_m: float, params: Params, count: int, sole_m: float) -> None:
        points = evidence.points
        self.sole_m = sole_m
        joint_rows = [k for k, name in enumerate(points.names) if name in generic.joint_names]
        feature_rows = [
            k
            for k, name in enumerate(points.names)
            if name in generic.feature_names and (points.corrected[k] or name not in ("head_top", "sole_left", "sole_right"))
        ]
        self.joints = np.array([generic.joint(points.names[k]) for k in joint_rows], dtype=int)
        soles = sole_vertices(generic)
        self.soles = len(soles)
        named = [generic.feature(points.names[k]) for k in feature_rows]
        vertices = np.array([*named, generic.feature("head_top"), *soles], dtype=np.int64)
        self.model = longer_by_shoes(choose(generic, vertices, stature_m, count), self.soles)
        rows = joint_rows + feature_rows
        spread = np.where(np.arange(len(rows)) < len(joint_rows), params.joint_mm, params.outline_point_mm)
        spread = np.where(points.corrected[rows], params.corrected_mm, spread / np.maximum(points.confidence[rows], 1e-3))
        self.weight = evidence.mm_per_px / spread
        self.target_px = points.points_px[rows]
        self.evidence, self.params = evidence, params
        lowest = [points.get(name) for name in ("sole_left", "sole_right")]
        both = evidence.view.view is not ViewId.BODY_SIDE
        feet = [float(point[1]) + 0.5 for point in lowest if point is not None and both]
        self.bottoms_px = np.array(feet if len(feet) == 2 else [evidence.bottom_px[1]])

    def __call__(self, shape: Array, camera: Camera, pose: Array) -> Array:
        vertices, joints = self.model.posed(shape, pose)
        projected = camera.project(np.vstack([joints[self.joints], vertices]))
        named = (projected[: len(self.weight)] - self.target_px) * self.weight[:, None]
        soft = np.linalg.norm(named, axis=1, keepdims=True)
        named = named / np.sqrt(1.0 + (soft / 2.0) ** 2)
        mm, params = self.evidence.mm_per_px, self.params
        soles = projected[-self.soles :, 1].reshape(2, -1).max(axis=1)
        top = (projected[-self.soles - 1, 1] - self.evidence.top_px[1]) * mm - params.hair_mm
        bottom = (self.bottoms_px - soles if len(self.bottoms_px) == 2 else self.bottoms_px - soles.max()) * mm
        bottom = (bottom - mm_from_m(self.sole_m)) / mm_from_m(params.sole_spread_m)
        ends = [top / params.hair_spread_mm, *bottom]
        height_m = vertices[-self.soles :, 1]
        floor = mm_from_m(1.0) * (height_m - height_m.mean()) / params.floor_mm
        return np.concatenate([named.ravel(), ends, floor])


class _OutlineTerm:
    """The outline of one photo against the rim of the model, matched anew every turn."""

    def __init__(self, generic: GenericHuman, evidence: _Evidence, state: _State, stature_m: float, params: Params, reach_mm: float) -> None:
        view = evidence.view.view
        vertices, joints = generic.shape(state.shape, stature_m)
        body = slice(0, int((generic.vertex_part == 0).sum()))
        whole = choose(generic, np.arange(body.stop), stature_m, len(state.shape))
        posed, _ = whole.posed(state.shape, state.poses[view])
        camera = moved(evidence.view.camera, state.motions[view], stature_m)
        reduction = evidence.field.reduction
        triangles = generic.triangles()[0]
        triangles = triangles[(triangles < body.stop).all(axis=1)]
        size = evidence.field.distance.shape
        pixels = camera.project(posed)
        rim, _ = rim_vertices((pixels + 0.5) / reduction - 0.5, posed, triangles, camera.position_m, (size[0], size[1]), 2.5)
        normals = vertex_normals(posed, triangles)[rim] @ camera.camera_from_model[:3, :3].T
        flat = normals[:, :2] / np.maximum(np.linalg.norm(normals[:, :2], axis=1, keepdims=True), 1e-9)
        reach_px = reach_mm / evidence.mm_per_px
        nearest, distance = evidence.field.nearest_rim(pixels[rim], flat, reach_px)
        loose = _loose(generic)
        keep = (distance < reach_px) & (loose[rim[nearest]] > 0) & ~evidence.field.veiled
        feet = _feet(generic)
        keep &= ~(feet[rim[nearest]] & (np.abs(evidence.field.normals[:, 1]) > 0.5))
        used, inverse = np.unique(rim[nearest[keep]], return_inverse=True)
        self.model = choose(generic, np.concatenate([used, rim]), stature_m, len(state.shape))
        self.pick = inverse
        self.sample_px = evidence.field.samples_px[keep]
        self.normal = evidence.field.normals[keep]
        pieces = evidence.field.step_px * evidence.mm_per_px / params.outline_piece_mm
        self.weight = evidence.mm_per_px / params.outline_mm * np.sqrt(min(pieces, 1.0)) * loose[used][inverse]
        self.rim_count = len(rim)
        spacing = np.sqrt(len(evidence.field.samples_px) * pieces / max(len(rim), 1))
        self.rim_weight = 0.5 * evidence.mm_per_px / params.outline_mm * min(spacing, 1.0)
        self.one_sided = (loose[rim] == 0) | feet[rim] | evidence.field.is_veiled(pixels[rim])
        self.field, self.soft = evidence.field, reach_mm / 2.0 / params.outline_mm

    def __call__(self, shape: Array, camera: Camera, pose: Array) -> Array:
        pixels = camera.project(self.model.posed(shape, pose)[0])
        towards = np.einsum("ka,ka->k", pixels[: len(pixels) - self.rim_count][self.pick] - self.sample_px, self.normal)
        beyond = self.field.signed_distance(pixels[len(pixels) - self.rim_count :])
        beyond = np.where(self.one_sided, np.maximum(beyond, 0.0), beyond)
        towards, beyond = towards * self.weight, beyond * self.rim_weight
        towards = towards / np.sqrt(1.0 + (towards / self.soft) ** 2)
        return np.concatenate([towards, beyond / np.sqrt(1.0 + (beyond / self.soft) ** 2)])


def _loose(generic: GenericHuman) -> Array:
    """Return (V,) trust in each vertex's outline: none under hair, little in shoes and at the fingers."""
    trust = np.ones(len(generic.vertices_m))
    for name, value in (("hand", 0.3), ("foot", 0.3)):
        for side in ("left", "right"):
            trust[generic.vertex_segment == generic.segment_names.index(f"{side}_{name}")] = value
    trust[generic.region("scalp")] = 0.0
    return trust


def _feet(generic: GenericHuman) -> NDArray[np.bool_]:
    """Return (V,) whether a vertex belongs to a foot, whose sole and instep a shoe hides."""
    rows = [generic.segment_names.index(f"{side}_foot") for side in ("left", "right")]
    return np.isin(generic.vertex_segment, rows)


def moved(camera: Camera, motion: Array, stature_m: float) -> Camera:
    """Return the camera after a motion about the person's middle."""
    matrix = moved_camera(camera.camera_from_model, motion, np.array([0.0, 0.53 * stature_m, 0.0]))
    return Camera(camera.width_px, camera.height_px, camera.focal_px, matrix, camera.pixels_per_m)


def _prior(evidence: _Evidence, motion: Array, pose: Array, mean: Array, params: Params) -> Array:
    depth = float(evidence.view.camera.to_camera(np.array([[0.0, 0.9, 0.0]]))[0, 2])
    turn = motion[:3] / np.deg2rad(params.camera_degrees)
    shift = motion[3:] / (np.array(params.camera_share) * depth)
    return np.concatenate([turn, shift, (pose - mean) / prior_spread(evidence.view.view is ViewId.BODY_SIDE)])


def _turn(
    state: _State, evidence: dict[ViewId, _Evidence], terms: dict[ViewId, list[Callable[[Array, Camera, Array], Array]]], mean: Array, stature_m: float, params: Params
) -> _State:
    """Return the state after one damped Gauss-Newton step over all unknowns."""
    shapes = len(state.shape)
    per_view = CAMERA_FREEDOMS + len(FREEDOMS)
    unknowns = shapes + per_view * len(evidence)
    normal, right = np.zeros((unknowns, unknowns)), np.zeros(unknowns)
    shape_rows = slice(0, shapes)
    normal[shape_rows, shape_rows] += np.eye(shapes)
    right[shape_rows] -= state.shape
    for place, (view, seen) in enumerate(evidence.items()):
        base = np.concatenate([state.shape, state.motions[view], state.poses[view]])

        def residual(x: Array, view: ViewId = view, seen: _Evidence = seen) -> Array:
            shape, motion, pose = np.split(x, [shapes, shapes + CAMERA_FREEDOMS])
            camera = moved(seen.view.camera, motion, stature_m)
            parts = [term(shape, camera, pose) for term in terms[view]]
            return np.concatenate([*parts, _prior(seen, motion, pose, mean, params)])

        value = residual(base)
        steps = np.concatenate([np.full(shapes, 0.02), np.full(3, 1e-3), np.full(3, 1e-3), np.full(len(FREEDOMS), 2e-3)])
        jacobian = np.empty((len(value), len(base)))
        for column, step in enumerate(steps):
            shifted = base.copy()
            shifted[column] += step
            jacobian[:, column] = (residual(shifted) - value) / step
        columns = np.concatenate([np.arange(shapes), shapes + place * per_view + np.arange(per_view)])
        normal[np.ix_(columns, columns)] += jacobian.T @ jacobian
        right[columns] -= jacobian.T @ value
    step = np.linalg.solve(normal + 1e-3 * np.diag(np.diag(normal)), right)
    shape = np.clip(state.shape + step[:shapes], -3.5, 3.5)
    blocks = {view: step[shapes + k * per_view : shapes + (k + 1) * per_view] for k, view in enumerate(evidence)}
    limit = 0.35
    motions = {v: state.motions[v] + np.clip(b[:CAMERA_FREEDOMS], -limit, limit) for v, b in blocks.items()}
    poses = {v: state.poses[v] + np.clip(b[CAMERA_FREEDOMS:], -limit, limit) for v, b in blocks.items()}
    return _State(shape, motions, poses)


def solve(
    generic: GenericHuman, evidence: dict[ViewId, _Evidence], stature_m: float, params: Params, tick: Tick
) -> tuple[_State, float]:
    """Return shape, camera motions and poses that explain all photos, and the soles' height, metres."""
    mean = standing_pose(generic.joint_names, generic.joints_m.astype(np.float64))
    state = _State(
        np.zeros(params.shapes[0]),
        {view: np.zeros(CAMERA_FREEDOMS) for view in evidence},
        {view: mean.copy() for view in evidence},
    )
    bare = np.mean([seen.barefoot for seen in evidence.values()]) > 0.5
    limits = params.bare_sole_m if bare else params.shoe_sole_m
    sole = float(np.mean(limits))
    for number, count in enumerate(params.shapes):
        if number > 1:
            sole = sole_height(generic, state, evidence, stature_m, limits)
        state = _State(np.pad(state.shape, (0, count - len(state.shape))), state.motions, state.poses)
        points = {view: _PointTerm(generic, seen, stature_m, params, count, sole) for view, seen in evidence.items()}
        reach_mm = (0.0, 120.0, 80.0, 60.0, 45.0)[min(number, 4)]
        for turn in range(params.turns_per_round):
            terms: dict[ViewId, list[Callable[[Array, Camera, Array], Array]]] = {v: [points[v]] for v in evidence}
            if number > 0:
                for view, seen in evidence.items():
                    terms[view].append(_OutlineTerm(generic, seen, state, stature_m, params, reach_mm))
            state = _turn(state, evidence, terms, mean, stature_m, params)
            tick((number + (turn + 1) / params.turns_per_round) / len(params.shapes))
    return state, sole_height(generic, state, evidence, stature_m, limits)


def run(
    *,
    proposals: Proposals,
    body_points: BodyPoints,
    silhouettes: SilhouetteSet,
    views: ViewSet,
    person: Person,
    tick: Tick,
    rng: object,
) -> StageResult:
    """Give the phenotype-closest generic human with a camera and a pose for every body photo."""
    params, generic = Params(), load_generic()
    evidence = {v: _evidence(view, body_points.views[v], silhouettes, proposals, params) for v, view in views.views.items()}
    if not evidence:
        coefficients = np.zeros(1)
        return StageResult({"phenotype": Phenotype(coefficients, person.stature_m, 0.0, {}, _attributes(generic, coefficients))})
    state, sole = solve(generic, evidence, person.stature_m, params, tick)
    matrix = pose_matrix(generic.joint_names)
    posed = {
        view: PosedView(view, moved(seen.view.camera, state.motions[view], person.stature_m), (matrix @ state.poses[view]).reshape(-1, 3))
        for view, seen in evidence.items()
    }
    residuals = []
    for view, seen in evidence.items():
        term = _OutlineTerm(generic, seen, state, person.stature_m, params, 60.0)
        gap = term.field.signed_distance(posed[view].camera.project(term.model.posed(state.shape, state.poses[view])[0])[-term.rim_count :])
        residuals.append(Residual("outline gap", float(np.abs(gap[~term.one_sided]).mean()) * seen.mm_per_px, "mm", view.value))
    value = Phenotype(state.shape, person.stature_m, sole, posed, _attributes(generic, state.shape))
    return StageResult({"phenotype": value}, tuple(residuals))


def sole_vertices(generic: GenericHuman) -> NDArray[np.int64]:
    """Return (2 N,) vertices spread over both soles, the left foot's first."""
    chosen = []
    for side in ("left", "right"):
        own = np.flatnonzero(generic.region("sole") & generic.region(f"foot_{side}"))
        own = own[generic.vertices_m[own, 1] < 0.006]
        along = generic.vertices_m[own, 2]
        places = np.linspace(along.min(), along.max(), 8)
        chosen.append([own[np.argmin(np.abs(along - place))] for place in places])
    return np.array(chosen).ravel()


def longer_by_shoes(model: Chosen, soles: int) -> Chosen:
    """Return the model with its last ``soles`` vertices spread to a shoe's length, 15 mm at the toe, 8 mm at the heel."""
    mean = model.mean_m.copy()
    foot = mean[-soles:, 2]
    share = (foot - foot.min()) / max(float(np.ptp(foot)), 1e-6)
    mean[-soles:, 2] += m_from_mm(-8.0) + share * m_from_mm(23.0)
    return replace(model, mean_m=mean)


def sole_height(
    generic: GenericHuman,
    state: _State,
    evidence: dict[ViewId, _Evidence],
    stature_m: float,
    limits_m: tuple[float, float],
) -> float:
    """Return how far the photos' lowest outline lies below the naked soles, metres, median of the photos, in limits."""
    heights = []
    soles = sole_vertices(generic)
    model = longer_by_shoes(choose(generic, soles, stature_m, len(state.shape)), len(soles))
    for view, seen in evidence.items():
        feet, _ = model.posed(state.shape, state.poses[view])
        camera = moved(seen.view.camera, state.motions[view], stature_m)
        pixels = camera.project(feet)
        lowest = int(np.argmax(pixels[:, 1]))
        heights.append((seen.bottom_px[1] - pixels[lowest, 1]) * camera.metres_per_pixel(feet[lowest]))
    return float(np.clip(np.median(heights), *limits_m))


def _attributes(generic: GenericHuman, coefficients: Array) -> dict[str, float]:
    """Return the named phenotype by linear regression from the coefficients."""
    values = generic.phenotype_mean + generic.phenotype_from_shape[:, : len(coefficients)] @ coefficients
    return {name: float(value) for name, value in zip(generic.phenotype_names, values, strict=True)}
