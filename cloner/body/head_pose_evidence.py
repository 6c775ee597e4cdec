"""Evidence of one photo for small rotations of neck and skull base."""

from __future__ import annotations

import functools
from dataclasses import dataclass, field, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.body.outlined import OutlinedPhoto, posed_silhouette
from cloner.calibration.loader import calibrated
from cloner.detectors.face.face_net import load_face_net
from cloner.frames import m_from_mm, mm_from_m
from cloner.generic.load import load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.head.modes import load_head_modes
from cloner.head.silhouette import HAIR_M, hair_thickness_basis
from cloner.head.skin_matches import SkinMatches
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh, PosedView
from cloner.records.points import ViewPoints

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.head_pose_evidence")


#: Joints that carry the head, in two groups that may counter each other.
NECK, SKULL = ("vc7", "vc5", "vc3"), ("skullbase",)
#: Features of the head that body photos show.
HEAD_POINTS = ("nose_tip", "ear_outer_L", "ear_outer_R", "pupil_L", "pupil_R")
#: Numbers of the hair's thickness: everywhere, more on top, more behind, more at the sides.
HAIR = len(HAIR_M)
_INDEPENDENT = _CALIBRATED.number("independent", "pieces")
_WRONG = _CALIBRATED.number("wrong", "sigmas")


@dataclass(frozen=True, slots=True)
class Params:
    """Standard deviations of the evidence.

    Its numbers: ``cloner/calibration/body.toml``, ``[head_pose_evidence.*]``.

    Attributes
    ----------
    thickness_mm : tuple of four (mean, spread) of the numbers of the hair's thickness.
    iterations, looks_at : int
        Gauss-Newton steps (six find no better heads on eight painted people), and before which of them skin is looked
        up: nearer to the truth than the phenotype's head, whose skin lies beyond the search.
    """

    point_mm: float = _CALIBRATED.number("point_mm", "mm")
    outline_mm: float = _CALIBRATED.number("outline_mm", "mm")
    face_mm: float = _CALIBRATED.number("face_mm", "mm")
    hair_mm: float = _CALIBRATED.number("hair_mm", "mm")
    thickness_mm: tuple[tuple[float, float], ...] = tuple((mm_from_m(a), mm_from_m(b)) for a, b in HAIR_M)
    neck_deg: float = _CALIBRATED.number("neck_deg", "deg")
    head_deg: float = _CALIBRATED.number("head_deg", "deg")
    nod_deg: float = _CALIBRATED.number("nod_deg", "deg")
    spot_mm: float = _CALIBRATED.number("spot_mm", "mm")
    iterations: int = 5
    looks_at: int = 2


@dataclass(frozen=True, slots=True, eq=False)
class RestHead:
    """The head at rest and the basis of its hair's thickness.

    Attributes
    ----------
    mesh : BodyMesh
    on_head, on_cap : (V,) bool
        Skin of the head, and of it the scalp above the ears, where hair follows the skull.
    hair : (V, 4) float64
        How much each number of the hair's thickness counts at a vertex.
    pivot_m : (3,) float64
        Middle of the face, about which face photos nod.
    """

    mesh: BodyMesh
    on_head: NDArray[np.bool_]
    on_cap: NDArray[np.bool_]
    hair: Array
    pivot_m: Array

    @classmethod
    def of(cls, mesh: BodyMesh) -> RestHead:
        """Return the head of a person."""
        generic = load_generic()
        normals = vertex_normals(mesh.vertices_m, body_triangles())
        ears = generic.region("ear_left") | generic.region("ear_right")
        above = mesh.vertices_m[:, 1] > mesh.vertices_m[ears, 1].mean()
        on_head = (generic.head_blend > 0.9) & generic.skin
        pivot = load_face_net().places.at(mesh.vertices_m).mean(axis=0)
        return cls(mesh, on_head, generic.region("scalp") & above & ~ears, hair_thickness_basis(normals), pivot)


@functools.cache
def _angle_basis() -> Array:
    """Return the (282, 6) matrix from neck and head angles to stacked rotation vectors."""
    generic = load_generic()
    matrix = np.zeros((len(generic.joint_names) * 3, 6))
    for axis in range(3):
        for name in NECK:
            matrix[generic.joint(name) * 3 + axis, axis] = 1.0 / len(NECK)
        for name in SKULL:
            matrix[generic.joint(name) * 3 + axis, [axis, 3 + axis]] = -1.0 / len(SKULL), 1.0 / len(SKULL)
    return matrix


def turn_head(posed: PosedView, angles: Array, pivot_m: Array) -> PosedView:
    """Return a photo's pose with neck and skull base rotated, or a face photo's camera for a head that nods."""
    if not posed.view.is_face:
        rotations = posed.rotations + (_angle_basis() @ angles).reshape(-1, 3)
        return replace(posed, rotations=rotations)
    cosine, sine = np.cos(angles[0]), np.sin(angles[0])
    nod = np.array([[1.0, 0.0, 0.0], [0.0, cosine, -sine], [0.0, sine, cosine]])
    matrix, camera = posed.camera.camera_from_model.copy(), posed.camera
    matrix[:3, 3] += matrix[:3, :3] @ (pivot_m - nod @ pivot_m)
    matrix[:3, :3] = matrix[:3, :3] @ nod
    return replace(posed, camera=replace(camera, camera_from_model=matrix))


def posed_vertices(mesh: BodyMesh, rows: NDArray[np.int64], posed: PosedView) -> tuple[Array, Array]:
    """Return some vertices (N, 3) in a photo's pose, and the joints' transforms (94, 4, 4)."""
    generic = load_generic()
    transforms = joint_transforms(mesh.joints_m, generic.joint_parents, posed.rotations)
    weights = generic.skin_weights[rows].astype(np.float64)
    return linear_blend_skinning(mesh.vertices_m[rows], transforms, generic.skin_joints[rows], weights), transforms


@dataclass(frozen=True, slots=True, eq=False)
class HeadEvidence:
    """Evidence of one photo about the head, prepared for small rotations.

    Attributes
    ----------
    photo : Outlined
        In the pose before any turn.
    chosen : (N,) int64
        Vertices that the evidence needs: the rim (R), named points (P), then corners of the face net's places.
    bare, cap : (R,) bool
        Rim vertices whose outline is the skin's, and whose outline is the hair's over the scalp.
    mm_per_px : float
    points_px, trust : (P, 2), (P, 1)
        Named points, and one over their spread, per px.
    face_px : (468, 2) or (0, 2)
    face_errors_m : (468, 2)
    corners : (468, 3) int64
        Rows of ``chosen``.
    """

    photo: OutlinedPhoto
    head: RestHead
    chosen: NDArray[np.int64]
    bare: NDArray[np.bool_]
    cap: NDArray[np.bool_]
    mm_per_px: float
    points_px: Array
    trust: Array
    face_px: Array
    face_errors_m: Array
    corners: NDArray[np.int64]
    params: Params = field(default_factory=Params)

    def residual(self, angles: Array, hair_mm: Array) -> Array:
        """Return the residuals of outline, points and face, sigmas, for angles and hair thickness (4,)."""
        generic, mesh = load_generic(), self.head.mesh
        posed = turn_head(self.photo.posed, angles, self.head.pivot_m)
        places, transforms = posed_vertices(mesh, self.chosen, posed)
        pixels, rim = posed.camera.project(places), len(self.bare)
        named = (pixels[rim : rim + len(self.points_px)] - self.points_px) * self.trust
        named = _WRONG * np.tanh(named / _WRONG)
        within = load_face_net().places.weights[: len(self.face_px), :, None]
        away = (within * pixels[self.corners]).sum(axis=1) - self.face_px
        if len(away):
            seen = posed.camera.camera_from_model[:3, :3] @ transforms[generic.joint(SKULL[0]), :3, :3]
            away = away + (self.face_errors_m + load_head_modes().turn_errors_m(seen)) / m_from_mm(self.mm_per_px)
        face = away * self.mm_per_px / self.params.face_mm / np.sqrt(max(len(away) / _INDEPENDENT, 1.0))
        return np.concatenate([self._gaps(pixels[:rim], hair_mm), named.ravel(), face.ravel()])

    def _gaps(self, pixels: Array, hair_mm: Array) -> Array:
        """Return the signed distance of silhouette vertices (R, 2) px from the expected outline, sigmas."""
        gap = self.photo.field.signed_distance(pixels) * self.mm_per_px
        over = gap + self.head.hair[self.chosen[: len(gap)]] @ hair_mm
        away = np.where(self.bare, gap, np.maximum(gap, 0.0)) / self.params.outline_mm
        away = np.where(self.cap, over / self.params.hair_mm, away)
        return np.asarray(_WRONG * np.tanh(away / _WRONG) / np.sqrt(max(len(gap) / _INDEPENDENT, 1.0)))

    def thickness_mm(self) -> Array:
        """Return the distance (N,) of the photo's outline from the bare skull where hair makes it."""
        rim = self.chosen[: len(self.bare)][self.cap]
        pixels = self.photo.posed.camera.project(posed_vertices(self.head.mesh, rim, self.photo.posed)[0])
        return -self.photo.field.signed_distance(pixels) * self.mm_per_px

    def linear(self, angles: Array, hair_mm: Array) -> tuple[Array, Array]:
        """Return the residuals (R,) and their Jacobian (R, angles + 4)."""
        value = self.residual(angles, hair_mm)
        columns = [(self.residual(angles + 1e-3 * one, hair_mm) - value) / 1e-3 for one in np.eye(len(angles))]
        columns += [(self.residual(angles, hair_mm + 0.1 * one) - value) / 0.1 for one in np.eye(HAIR)]
        return value, np.stack(columns, axis=1)


def head_evidence(
    head: RestHead,
    photo: OutlinedPhoto,
    angles: Array,
    points: ViewPoints | None,
    face_px: Array,
    face_errors_m: Array,
    spots: SkinMatches,
    params: Params,
) -> HeadEvidence:
    """Return a photo's evidence for the head as it is posed now."""
    generic, net = load_generic(), load_face_net()
    seen = posed_silhouette(
        head.mesh, OutlinedPhoto(turn_head(photo.posed, angles, head.pivot_m), photo.field), head.on_head
    )
    rim = np.flatnonzero(seen.body.on_rim & head.on_head)
    veiled = photo.field.is_veiled(seen.body.pixels[rim])
    silent = points is None or len(face_px) > 0  # the face net's points are ten times as good
    rows = [] if silent or points is None else [k for k, name in enumerate(points.names) if name in HEAD_POINTS]
    marks = np.array([generic.feature(points.names[k]) for k in rows] if points else [], dtype=np.int64)
    used, corners = np.unique(net.places.corners[: len(face_px)], return_inverse=True)
    pixels = points.points_px[rows] if points else np.zeros((0, 2))
    trust = points.confidence[rows, None] / params.point_mm if points else np.zeros((0, 1))
    marks = np.concatenate([marks, spots.vertices])
    pixels = np.concatenate([pixels, spots.points_px])
    trust = np.concatenate([trust, np.full((len(spots.vertices), 1), 1.0 / params.spot_mm)])
    return HeadEvidence(
        photo,
        head,
        np.concatenate([rim, marks, used.astype(np.int64)]),
        ~veiled,
        veiled & head.on_cap[rim],
        seen.mm_per_px,
        pixels,
        trust * seen.mm_per_px,
        face_px,
        face_errors_m,
        corners.reshape(-1, 3).astype(np.int64) + len(rim) + len(marks),
        params,
    )
