"""What the body photos say about shape, pose and camera: points, outlines, soles.

Each term is a residual in units of its own spread, a function of shape
coefficients, camera and pose vector (see ``phenotype.py`` for the solution).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId, m_from_mm, mm_from_m
from cloner.generic.load import GENERIC_STATURE_M, GenericHuman, load_generic
from cloner.geometry.contours import OutlineField, outline_field
from cloner.geometry.poses import pose_matrix
from cloner.geometry.posing import Chosen
from cloner.geometry.rims import rim_vertices, vertex_normals
from cloner.records.points import HAIR, Proposal, ViewPoints
from cloner.records.silhouettes import Silhouette
from cloner.records.views import Camera, View
from cloner.stages.outlined import body_triangles
from cloner.stages.points import ENDS

Array = NDArray[np.float64]

#: Share of the figure's height beside loose clothing in which points on the outline are not believed.
CLOTH_MARGIN = 0.01


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
    most_step, most_sigmas : float
        Longest step of a camera or joint angle (radians, metres), and largest shape coefficient.
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
    most_step: float = 0.35
    most_sigmas: float = 3.5


@dataclass(frozen=True, slots=True, eq=False)
class Evidence:
    """What one photo says, with the first camera."""

    view: View
    points: ViewPoints
    field: OutlineField
    mm_per_px: float
    top_px: Array
    bottom_px: Array
    barefoot: bool


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


def gather_evidence(
    view: View, points: ViewPoints, outline: Silhouette, proposal: Proposal, params: Params
) -> Evidence:
    """Return what one photo says, prepared for fitting."""
    middle = np.array([0.0, 0.9, 0.0])
    mm_per_px = mm_from_m(view.camera.metres_per_pixel(middle))
    reduction = max(view.camera.height_px / params.height_px, 1.0)
    field = outline_field(
        outline.contours_px,
        outline.mask,
        proposal.labels == HAIR,
        cloth=outline.loose_mask(),
        step_px=2.0 * reduction,
        reduction=reduction,
    )
    top, bottom = ends_px(points, outline)
    return Evidence(view, off_cloth(points, outline), field, mm_per_px, top, bottom, proposal.barefoot)


def ends_px(points: ViewPoints, outline: Silhouette) -> tuple[Array, Array]:
    """Return the highest and the lowest point of the person, (2,) px each: an operator's, else the outline's."""
    rows = np.flatnonzero(outline.mask.any(axis=1))
    top = np.array([np.flatnonzero(outline.mask[rows[0]]).mean(), rows[0] - 0.5])
    bottom = np.array([np.flatnonzero(outline.mask[rows[-1]]).mean(), rows[-1] + 0.5])
    placed = {n: p for n, p, fixed in zip(points.names, points.points_px, points.corrected, strict=True) if fixed}
    soles = [placed[name] for name in ENDS[1:] if name in placed]
    if ENDS[0] in placed:
        top = placed[ENDS[0]] - [0.0, 0.5]
    if soles:
        bottom = max(soles, key=lambda sole: float(sole[1])) + [0.0, 0.5]
    return top, bottom


def off_cloth(points: ViewPoints, outline: Silhouette) -> ViewPoints:
    """Return the points without trust in those proposed on the outline of loose clothing: no body is there."""
    joints = np.isin(points.names, load_generic().joint_names)
    margin = CLOTH_MARGIN * float(np.count_nonzero(outline.mask.any(axis=1)))
    on_cloth = np.zeros(len(points.names), dtype=bool)
    for region in outline.loose:
        on_cloth |= region.covers(points.points_px, margin_px=margin)
    return replace(points, confidence=np.where(on_cloth & ~joints & ~points.corrected, 0.0, points.confidence))


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
    """Return the model with its last ``soles`` vertices spread to a flat shoe: 15 mm at the toe, 8 mm at the heel."""
    mean = model.mean_m.copy()
    foot = mean[-soles:, 2]
    share = (foot - foot.min()) / max(float(np.ptp(foot)), 1e-6)
    mean[-soles:, 1] = 0.0
    mean[-soles:, 2] += m_from_mm(-8.0) + share * m_from_mm(23.0)
    return replace(model, mean_m=mean)


class PointTerm:
    """Named points of one photo against joints and feature vertices of the model.

    Proposed points saturate at two spreads, corrected ones never: a correction wins.
    Head top and soles count with the usual hair and the soles' height, and both
    feet stand flat on one level floor.
    """

    def __init__(
        self,
        generic: GenericHuman,
        evidence: Evidence,
        stature_m: float,
        params: Params,
        *,
        count: int,
        sole_m: float,
    ) -> None:
        points = evidence.points
        self.sole_m = sole_m
        joint_rows = [k for k, name in enumerate(points.names) if name in generic.joint_names]
        feature_rows = [k for k, name in enumerate(points.names) if name in generic.feature_names and name not in ENDS]
        self.joints = np.array([generic.joint(points.names[k]) for k in joint_rows], dtype=int)
        soles = sole_vertices(generic)
        self.soles = len(soles)
        named = [generic.feature(points.names[k]) for k in feature_rows]
        vertices = np.array([*named, generic.feature("head_top"), *soles], dtype=np.int64)
        self.model = longer_by_shoes(choose(generic, vertices, stature_m, count), self.soles)
        rows = joint_rows + feature_rows
        spread = np.where(np.arange(len(rows)) < len(joint_rows), params.joint_mm, params.outline_point_mm)
        spread = spread / np.maximum(points.confidence[rows], 1e-3)
        self.corrected = points.corrected[rows]
        spread = np.where(self.corrected, params.corrected_mm, spread)
        self.weight = evidence.mm_per_px / spread
        self.target_px = points.points_px[rows]
        self.evidence, self.params = evidence, params
        lowest = [points.get(name) for name in ENDS[1:]]
        both = evidence.view.view is not ViewId.BODY_SIDE
        feet = [float(point[1]) + 0.5 for point in lowest if point is not None and both]
        self.bottoms_px = np.array(feet if len(feet) == 2 else [evidence.bottom_px[1]])

    def __call__(self, shape: Array, camera: Camera, pose: Array) -> Array:
        """Return the residual, in spreads."""
        vertices, joints = self.model.posed(shape, pose)
        projected = camera.project(np.vstack([joints[self.joints], vertices]))
        named = (projected[: len(self.weight)] - self.target_px) * self.weight[:, None]
        far = np.where(self.corrected, 0.0, np.linalg.norm(named, axis=1) / 2.0)
        named = named / np.sqrt(1.0 + far[:, None] ** 2)
        mm, params = self.evidence.mm_per_px, self.params
        soles = projected[-self.soles :, 1].reshape(2, -1).max(axis=1)
        top = (projected[-self.soles - 1, 1] - self.evidence.top_px[1]) * mm - params.hair_mm
        bottom = (self.bottoms_px - soles if len(self.bottoms_px) == 2 else self.bottoms_px - soles.max()) * mm
        bottom = (bottom - mm_from_m(self.sole_m)) / mm_from_m(params.sole_spread_m)
        ends = [top / params.hair_spread_mm, *bottom]
        height_m = vertices[-self.soles :, 1]
        floor = mm_from_m(1.0) * (height_m - height_m.mean()) / params.floor_mm
        return np.concatenate([named.ravel(), ends, floor])


def outline_trust(generic: GenericHuman) -> Array:
    """Return (V,) trust in each vertex's outline: none under hair, little in shoes and at the fingers."""
    trust = np.ones(len(generic.vertices_m))
    for name, value in (("hand", 0.3), ("foot", 0.3)):
        for side in ("left", "right"):
            trust[generic.vertex_segment == generic.segment_names.index(f"{side}_{name}")] = value
    trust[generic.region("scalp")] = 0.0
    return trust


def on_feet(generic: GenericHuman) -> NDArray[np.bool_]:
    """Return (V,) whether a vertex belongs to a foot, whose sole and instep a shoe hides."""
    rows = [generic.segment_names.index(f"{side}_foot") for side in ("left", "right")]
    return np.isin(generic.vertex_segment, rows)


class OutlineTerm:
    """The outline of one photo against the rim of the model, matched anew every turn."""

    def __init__(
        self,
        generic: GenericHuman,
        evidence: Evidence,
        params: Params,
        *,
        shape: Array,
        camera: Camera,
        pose: Array,
        stature_m: float,
        reach_mm: float,
    ) -> None:
        triangles = body_triangles()
        skin = np.arange(int(triangles.max()) + 1)
        posed, _ = choose(generic, skin, stature_m, len(shape)).posed(shape, pose)
        pixels = camera.project(posed)
        reduction, (height, width) = evidence.field.reduction, evidence.field.distance.shape
        small = (pixels + 0.5) / reduction - 0.5
        rim, _ = rim_vertices(small, posed, triangles, camera.position_m, (height, width), 2.5)
        normals = vertex_normals(posed, triangles)[rim] @ camera.camera_from_model[:3, :3].T
        flat = normals[:, :2] / np.maximum(np.linalg.norm(normals[:, :2], axis=1, keepdims=True), 1e-9)
        reach_px = reach_mm / evidence.mm_per_px
        nearest, distance = evidence.field.nearest_rim(pixels[rim], flat, reach_px)
        loose = outline_trust(generic)
        keep = (distance < reach_px) & (loose[rim[nearest]] > 0) & ~evidence.field.veiled
        feet = on_feet(generic)
        keep &= ~(feet[rim[nearest]] & (np.abs(evidence.field.normals[:, 1]) > 0.5))
        used, inverse = np.unique(rim[nearest[keep]], return_inverse=True)
        self.model = choose(generic, np.concatenate([used, rim]), stature_m, len(shape))
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

    def gap_mm(self, shape: Array, camera: Camera, pose: Array, mm_per_px: float) -> float:
        """Return the rim's mean distance from the outline where neither hair nor shoes make it, mm."""
        rim = camera.project(self.model.posed(shape, pose)[0])[-self.rim_count :]
        return float(np.abs(self.field.signed_distance(rim)[~self.one_sided]).mean()) * mm_per_px

    def __call__(self, shape: Array, camera: Camera, pose: Array) -> Array:
        """Return the residual, in spreads: photo to model, then model to photo."""
        pixels = camera.project(self.model.posed(shape, pose)[0])
        towards = np.einsum("ka,ka->k", pixels[: len(pixels) - self.rim_count][self.pick] - self.sample_px, self.normal)
        beyond = self.field.signed_distance(pixels[len(pixels) - self.rim_count :])
        beyond = np.where(self.one_sided, np.maximum(beyond, 0.0), beyond)
        towards, beyond = towards * self.weight, beyond * self.rim_weight
        towards = towards / np.sqrt(1.0 + (towards / self.soft) ** 2)
        return np.concatenate([towards, beyond / np.sqrt(1.0 + (beyond / self.soft) ** 2)])
