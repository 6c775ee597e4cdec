"""Residuals of the phenotype's fit: points, outlines, the floor.

A term knows its points of the model and returns, for a linearisation of them,
residuals in units of their own spread and exact derivatives. Robust residuals are
weighted by what they are now (iterated reweighting), so a wrong point fades.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from cloner.body.evidence import Params, PhotoEvidence
from cloner.body.model import BodyFamily, ProjectedPoints
from cloner.detectors.body.body_points import ENDS
from cloner.fit.evidence import Residuals, cauchy_weights, point_residuals
from cloner.frames import ViewId, mm_from_m
from cloner.generic.load import GenericHuman
from cloner.generic.surfaces import body_triangles
from cloner.geometry.articulation.posing import PointModel
from cloner.geometry.cameras.stands import camera_from_stand
from cloner.geometry.meshes.vectors import unit
from cloner.geometry.outlines.silhouette import silhouette_vertices, vertex_normals
from cloner.records.arrays import Array


def block_names(view: ViewId) -> tuple[str, str, str]:
    """Return the parameter blocks that a photo's points depend on: shape, and its own camera and pose."""
    return "shape", f"stand {view}", f"pose {view}"


class EvidenceTerm(Protocol):
    """A kind of evidence."""

    model: PointModel

    def residuals(self, drawn: ProjectedPoints) -> Residuals:
        """Return the residuals and their Jacobian for projected points."""


def sole_vertices(generic: GenericHuman) -> NDArray[np.int64]:
    """Return vertices (2 N,) spread over both soles, the left foot's first."""
    chosen = []
    for side in ("left", "right"):
        own = np.flatnonzero(generic.region("sole") & generic.region(f"foot_{side}"))
        own = own[generic.vertices_m[own, 1] < 0.006]
        along = generic.vertices_m[own, 2]
        places = np.linspace(along.min(), along.max(), 8)
        chosen.append([own[np.argmin(np.abs(along - place))] for place in places])
    return np.array(chosen).ravel()


class PointTerm:
    """Named points of one photo against joints and features of the model; corrected points keep their weight.

    The pose net's points are expected where the net was calibrated to put them. A
    proposal farther away than ``fade`` sigmas loses its weight: one wrong point
    cannot drag a limb.
    """

    def __init__(self, body: BodyFamily, evidence: PhotoEvidence, params: Params, *, modes: int, fade: float) -> None:
        generic, net = body.generic, evidence.net
        own = _own_points(generic, evidence, params)
        bases = [*(base for base, *_ in own), *net.bases]
        offsets = np.vstack([np.zeros((len(own), 3)), body.stature_m * net.offset])
        targets = np.vstack([*(target for _, target, *_ in own), net.points_px])
        sigmas = np.append([sigma for *_, sigma, _ in own], mm_from_m(body.stature_m) * net.sigma)
        fixed = np.append([fixed for *_, fixed in own], np.zeros(len(net.bases), dtype=bool))
        is_joint = np.array([base in generic.joint_names for base in bases], dtype=bool)
        order = np.argsort(is_joint, kind="stable")  # the model's points are vertices first, then joints
        features = [generic.feature(bases[k]) for k in order if not is_joint[k]]
        joints = [generic.joint(bases[k]) for k in order if is_joint[k]]
        model = body.points(np.array(features, dtype=np.int64), np.array(joints, dtype=np.int64), modes=modes)
        self.model = replace(model, mean_m=model.mean_m + offsets[order])
        self.of, self.target_px = block_names(evidence.view.view), targets[order]
        self.outlier = np.where(fixed[order].astype(bool), np.inf, fade)
        self.sigma_px = sigmas[order] / evidence.mm_per_px

    def residuals(self, drawn: ProjectedPoints) -> Residuals:
        """Return the residuals (2 N,) and their Jacobian."""
        return point_residuals(
            self.of, drawn.pixels - self.target_px, drawn.by_pixels, self.sigma_px, outlier=self.outlier
        )


def _own_points(generic: GenericHuman, evidence: PhotoEvidence, params: Params) -> list[tuple[str, Array, float, bool]]:
    """Return base, pixel (1, 2), sigma in mm and whether it is corrected, of the points that are not the net's.

    Proposed points on the outline are left out: the outline itself says more (measured: no difference with or without).
    """
    points, has_net_bases = evidence.points, len(evidence.net.bases) > 0
    own = []
    for name, pixel, sure, fixed in zip(
        points.names, points.points_px, points.confidence, points.corrected, strict=True
    ):
        joint = name in generic.joint_names
        if fixed and (joint or name in generic.feature_names) and name not in ENDS:
            own.append((name, pixel[None], params.corrected_mm, True))
        elif joint and not has_net_bases:
            own.append((name, pixel[None], params.joint_mm / max(float(sure), 1e-3), False))
    return own


class GroundTerm:
    """Both feet on one level floor, hair at its expected height above the skull, placed soles kept."""

    def __init__(self, body: BodyFamily, evidence: PhotoEvidence, params: Params, *, modes: int) -> None:
        self.model = body.points(np.append(sole_vertices(body.generic), body.generic.feature("head_top")), modes=modes)
        self.evidence, self.params = evidence, params

    def residuals(self, drawn: ProjectedPoints) -> Residuals:
        """Return residuals and Jacobian: the floor (2 N), the top (1), corrected soles."""
        mm, params = self.evidence.mm_per_px, self.params
        scale = mm_from_m(1.0) / params.floor_mm
        height, by_height = drawn.points_m[:-1, 1], drawn.by_points[:-1, 1]
        values = [scale * (height - height.mean())]
        jacobian = [scale * (by_height - by_height.mean(axis=0))]
        hair_mm, sigma_mm = self.evidence.hair_mm
        above = (drawn.pixels[-1, 1] - self.evidence.top_px) * mm - hair_mm
        values.append(np.array([above / sigma_mm]))
        jacobian.append(drawn.by_pixels[-1:, 1] * mm / sigma_mm)
        for side, row_px in self.evidence.soles_px.items():
            own = np.arange(len(height) // 2) + (len(height) // 2 if side == "right" else 0)
            lowest = int(own[np.argmax(drawn.pixels[own, 1])])
            values.append(np.array([(drawn.pixels[lowest, 1] - row_px) * mm / params.corrected_mm]))
            jacobian.append(drawn.by_pixels[lowest : lowest + 1, 1] * mm / params.corrected_mm)
        return Residuals(block_names(self.evidence.view.view), np.concatenate(values), np.vstack(jacobian))


def outline_trust(generic: GenericHuman) -> Array:
    """Return the weight (V,) of each vertex on the outline: none under hair, little at fingers and shoes."""
    trust = np.ones(len(generic.vertices_m))
    for name, value in (("hand", 0.3), ("foot", 0.5)):
        for side in ("left", "right"):
            trust[generic.segment(f"{side}_{name}")] = value
    trust[generic.region("scalp")] = 0.0
    return trust


class OutlineTerm:
    """The outline of one photo against the model's silhouette; samples are matched anew at every linearisation."""

    def __init__(
        self,
        body: BodyFamily,
        evidence: PhotoEvidence,
        params: Params,
        *,
        shape: Array,
        stand: Array,
        pose: Array,
        reach_mm: float,
    ) -> None:
        triangles, field = body_triangles(), evidence.field
        skin = body.points(np.arange(int(triangles.max()) + 1), modes=len(shape))
        camera = camera_from_stand(stand, evidence.view.camera)
        posed = skin.posed(shape, pose)
        pixels = camera.project(posed)
        small = (pixels + 0.5) / field.reduction - 0.5
        height, width = field.distance.shape
        rim, _ = silhouette_vertices(small, posed, triangles, camera.position_m, (height, width), 2.5)
        normals = vertex_normals(posed, triangles)[rim] @ camera.camera_from_model[:3, :3].T
        self.normals = unit(normals[:, :2])
        self.model, self.field, self.of = skin.part(rim), field, block_names(evidence.view.view)
        self.trust = outline_trust(body.generic)[rim]
        mm, sigma = evidence.mm_per_px, params.outline_mm
        self.reach_px = reach_mm / mm
        pieces = field.step_px * mm / params.outline_piece_mm
        self.weight = mm / sigma * np.sqrt(min(pieces, 1.0))
        spacing = np.sqrt(len(field.samples_px) * pieces / max(len(rim), 1))
        self.rim_weight = 0.5 * mm / sigma * min(spacing, 1.0)
        self.soft = reach_mm / 2.0 / sigma

    def gap_mm(self, rim_px: Array, mm_per_px: float) -> float:
        """Return the mean distance from the silhouette to the outline where nothing covers it, mm."""
        shown = ~self._one_sided(rim_px)
        return float(np.abs(self.field.signed_distance(rim_px)[shown]).mean()) * mm_per_px

    def residuals(self, drawn: ProjectedPoints) -> Residuals:
        """Return the residuals, photo to model, then model to photo, and their Jacobian."""
        pick, keep = self._matched(drawn.pixels)
        normal = self.field.normals[keep] * (self.weight * self.trust[pick])[:, None]
        towards = np.einsum("ka,ka->k", drawn.pixels[pick] - self.field.samples_px[keep], normal)
        by_towards = normal[:, :1] * drawn.by_pixels[pick, 0] + normal[:, 1:] * drawn.by_pixels[pick, 1]
        beyond = self.field.signed_distance(drawn.pixels) * self.rim_weight
        slope = self._slope(drawn.pixels) * self.rim_weight
        by_beyond = slope[:, :1] * drawn.by_pixels[:, 0] + slope[:, 1:] * drawn.by_pixels[:, 1]
        inside = self._one_sided(drawn.pixels) & (beyond < 0.0)
        beyond[inside], by_beyond[inside] = 0.0, 0.0
        value = np.concatenate([towards, beyond])
        return Residuals(self.of, value, np.vstack([by_towards, by_beyond]), cauchy_weights(value**2, self.soft) ** 2)

    def _matched(self, pixels: Array) -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
        """Return the silhouette points matched to outline samples, and which samples count."""
        nearest, distance = self.field.nearest_rim(pixels, self.normals, self.reach_px)
        keep = (distance < self.reach_px) & (self.trust[nearest] > 0) & ~self.field.veiled
        return nearest[keep], keep

    def _one_sided(self, pixels: Array) -> NDArray[np.bool_]:
        """Return which silhouette points may lie inside the outline, because hair or cloth makes it there."""
        return np.asarray((self.trust == 0) | self.field.is_veiled(pixels))

    def _slope(self, pixels: Array) -> Array:
        """Return gradients (N, 2) of the signed distance."""
        step = self.field.reduction
        shifts = step * np.eye(2)
        return np.stack(
            [self.field.signed_distance(pixels + d) - self.field.signed_distance(pixels - d) for d in shifts], axis=1
        ) / (2.0 * step)
