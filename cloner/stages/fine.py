"""Fine skin from silhouettes (paper §3.6), then a smooth settling of the whole silhouette on all outlines.

Slices of the grid segments are moved by T_i,m so that they reproduce the
silhouette's pixels; head, hands and feet are never pushed by slices. Afterwards
("beyond") a smooth displacement along the normals takes up what slices cannot
reach: shoulders, crotch, a shoe's collar and heel.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.body.feet import Params as FeetParams
from cloner.body.feet import scale_feet, shape_feet, toe_weights
from cloner.body.hands import SPREAD, USUAL, scale_hands
from cloner.body.limb_poses import Params as StanceParams
from cloner.body.limb_poses import fit_limb_poses
from cloner.body.observed_joints import ObservedJoints, observed_joints
from cloner.body.outlined import (
    OutlinedPhoto,
    outline_distances_mm,
    outlined_photos,
    paper_body_views,
    posed_silhouette,
    silhouette_iou,
)
from cloner.body.tape_fit import fit_tape_measures
from cloner.calibration.loader import calibrated
from cloner.frames import ViewId, m_from_mm
from cloner.generic.load import load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.meshes.vectors import unit
from cloner.geometry.outlines.settling import bending_matrix, settle, smoothed_directions, without_folds
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh, BodySet, FineBody, Phenotype
from cloner.records.photos import Person
from cloner.records.points import PointSet
from cloner.records.proposals import Proposals
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import SilhouetteSet
from cloner.stages.points import points_for_fit
from cloner.stages.rough import shape_slices

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.fine")

FOOT_TRUST: Final = _CALIBRATED.number("foot_trust", "share")


@dataclass(frozen=True, slots=True)
class Params:
    """Number of slices and smoothness of the settling.

    Its numbers: ``cloner/calibration/stages.toml``, ``[fine.*]``.

    Attributes
    ----------
    slices : int
        Slices a segment; 8, 16 or 32 hardly matter (parts).
    direction_turns : int
        How often the directions in which skin settles are averaged, over some 25 mm (measured: crossing triangle pairs
        of four people fell from 128, 40, 25, 21 to 6, 0, 0, 0 and no overlap changed).
    """

    slices: int = 16
    smooth: float = _CALIBRATED.number("smooth", "factor")
    slice_reach_mm: float = _CALIBRATED.number("slice_reach_mm", "mm")
    settle_reach_mm: tuple[float, ...] = _CALIBRATED.triple("settle_reach_mm", "mm")
    stiffness: float = _CALIBRATED.number("stiffness", "factor")
    anchor: float = _CALIBRATED.number("anchor", "factor")
    doubt_mm: tuple[float, float] = _CALIBRATED.pair("doubt_mm", "mm")
    direction_turns: int = 20


def settling_weights() -> Array:
    """Return the weight (V,) with which the outline moves each vertex when the skin settles.

    Not head, toes and soles, little the fingers.
    """
    generic = load_generic()
    trust = np.where(generic.skin, 1.0, 0.0)
    for side in ("left", "right"):
        trust[generic.segment(f"{side}_hand")] = 0.05
        trust[generic.segment(f"{side}_foot") & generic.skin] = FOOT_TRUST
    trust *= np.where(generic.region("sole"), 0.0, 1.0 - toe_weights())
    if len(generic.head_blend):
        trust *= 1.0 - np.clip(generic.head_blend.astype(np.float64) * 2.0, 0.0, 1.0)
    else:
        trust[generic.segment("head")] = 0.0
    return trust


def outside_cloth(photo: OutlinedPhoto, pixels: Array) -> NDArray[np.bool_]:
    """Return whether (M,) the body at pixels (M, 2) lies outside an outline of cloth, which then counts too."""
    return np.asarray(photo.field.signed_distance(pixels) > 0.0)


def neck_settling_weights() -> Array:
    """Return the weight (V,) with which the outline moves each vertex of a joined person's neck; all
    others are fixed.
    """
    generic = load_generic()
    return np.where(generic.region("neck") & generic.skin, 1.0, 0.0)


def settle_on_outlines(
    mesh: BodyMesh, photos: tuple[OutlinedPhoto, ...], reach_mm: float, params: Params, trust: Array
) -> BodyMesh:
    """Return the body after one smooth displacement of its skin on to all outlines.

    Parameters
    ----------
    trust : (V,) 0..1
        How far outlines move each vertex; vertices without trust stay where they are.

    Returns
    -------
    BodyMesh
        The same one where no photo shows what may move at its outline.
    """
    triangles = body_triangles()
    normals = vertex_normals(mesh.vertices_m, triangles)
    ways = smoothed_directions(normals, triangles, turns=params.direction_turns)
    rows, slopes, gaps, weights = [], [], [], []
    for photo in photos:
        seen = posed_silhouette(mesh, photo)
        camera = photo.posed.camera
        rim = np.flatnonzero(seen.body.on_rim & (trust > 0))
        if not len(rim):  # arms or hair hide all that may move
            continue
        turned = np.einsum("vab,vb->va", seen.blended[rim, :, :3], normals[rim])
        across = turned @ camera.camera_from_model[:3, :3].T
        moving = np.einsum("vab,vb->va", seen.blended[rim, :, :3], ways[rim]) @ camera.camera_from_model[:3, :3].T
        per_m = 1.0 / np.linalg.norm(seen.body.lift[rim, :, 0], axis=1)
        flat = unit(across[:, :2])
        reach_px = reach_mm / seen.mm_per_px
        nearest, distance = photo.field.nearest_rim(seen.body.pixels[rim], flat, reach_px)
        keep = distance < reach_px * np.where(trust[rim[nearest]] > 0.5, 1.0, 0.35)
        keep &= ~photo.field.veiled | (photo.field.draped & outside_cloth(photo, seen.body.pixels[rim[nearest]]))
        vertex = rim[nearest[keep]]
        normal = photo.field.normals[keep]
        wanted = np.einsum("ka,ka->k", photo.field.samples_px[keep] - seen.body.pixels[vertex], normal)
        rows.append(vertex)
        gaps.append(wanted * m_from_mm(seen.mm_per_px))
        slopes.append(
            np.einsum("ka,ka->k", moving[nearest[keep], :2], normal) * per_m[nearest[keep]] * m_from_mm(seen.mm_per_px)
        )
        step_mm = photo.field.step_px * seen.mm_per_px
        weights.append(np.full(len(vertex), step_mm / 4.0) * trust[vertex] * (1.0 - distance[keep] / reach_px))
    if not rows:
        return mesh
    anchor = np.where(trust > 0.5, params.anchor, np.where(trust > 0, 0.1, 1e3))
    heights = settle(
        np.concatenate(rows),
        np.concatenate(slopes),
        np.concatenate(gaps),
        np.concatenate(weights),
        bending_matrix(triangles, len(mesh.vertices_m)),
        stiffness=params.stiffness,
        anchor=anchor,
        doubt_m=(m_from_mm(params.doubt_mm[0]), m_from_mm(params.doubt_mm[1])),
    )
    moved = mesh.vertices_m + np.clip(heights, -0.05, 0.05)[:, None] * ways
    return BodyMesh(without_folds(mesh.vertices_m, moved, triangles), mesh.joints_m)


def fit_extremities(
    mesh: BodyMesh, photos: dict[ViewId, OutlinedPhoto], sole_m: float, joints: Mapping[ViewId, ObservedJoints]
) -> tuple[BodyMesh, dict[ViewId, OutlinedPhoto]]:
    """Return the body with hands and feet of the photos' size, and the photos with limb poses fitted to it."""
    start, usual, spread = shape_feet(mesh, sole_m, FeetParams())
    feet = len(usual)

    def sizer(size: Array) -> BodyMesh:
        return scale_hands(BodyMesh(scale_feet(start, size[:feet], sole_m), start.joints_m), size[feet:])

    size = (np.concatenate([usual, USUAL]), np.concatenate([spread, SPREAD]))
    return fit_limb_poses(sizer, size, photos, joints, StanceParams())


def outline_residuals(mesh: BodyMesh, photos: dict[ViewId, OutlinedPhoto]) -> tuple[Residual, ...]:
    """Return the distance from silhouette to outline in every photo, whole and per part, and the overlap."""
    residuals = []
    for view, photo in photos.items():
        seen = posed_silhouette(mesh, photo)
        for part, gap in outline_distances_mm(seen, photo).items():
            residuals.append(Residual(f"outline gap {part}".strip(), gap, "mm", view.value))
        overlap = 100.0 * silhouette_iou(seen, photo)
        residuals.append(Residual("silhouette overlap without hair", overlap, "percent", view.value))
    return (*residuals,)


def run(
    *,
    proposals: Proposals,
    body_points: PointSet,
    rough_bodies: BodySet,
    silhouettes: SilhouetteSet,
    phenotype: Phenotype,
    person: Person,
    tick: Callable[[float], None],
) -> StageResult:
    """Produce the body: front and back, each with the side, after slices, and their mean settled on
    all photos at once.
    """
    params = Params()
    photos = outlined_photos(phenotype, silhouettes, proposals)
    if not photos:
        start, usual, _ = shape_feet(rough_bodies.consensus, phenotype.sole_m, FeetParams())
        shod = BodyMesh(scale_feet(start, usual, phenotype.sole_m), start.joints_m)
        return StageResult({"body": FineBody(shod)})
    levels = (np.arange(params.slices) + 0.5) / params.slices
    sliced = []
    for main, body in ((ViewId.BODY_FRONT, rough_bodies.front_side), (ViewId.BODY_BACK, rough_bodies.back_side)):
        sliced.append(shape_slices(body, paper_body_views(photos, main), levels, params.slice_reach_mm, params.smooth))
        tick(0.2 * len(sliced))
    joints = rough_bodies.consensus.joints_m
    consensus = BodyMesh((sliced[0].vertices_m + sliced[1].vertices_m) / 2, joints)
    points = {view: points_for_fit(of_view) for view, of_view in body_points.views.items()}
    joints_seen = observed_joints(phenotype, proposals, points)
    consensus, photos = fit_extremities(consensus, photos, phenotype.sole_m, joints_seen)
    for number, reach in enumerate(params.settle_reach_mm):
        consensus = settle_on_outlines(consensus, tuple(photos.values()), reach, params, settling_weights())
        tick(0.4 + 0.6 * (number + 1) / len(params.settle_reach_mm))
    consensus = fit_tape_measures(consensus, dict(person.tape_mm), side_seen=ViewId.BODY_SIDE in photos)
    return StageResult(
        {"body": FineBody(consensus, {view: photo.posed for view, photo in photos.items()})},
        outline_residuals(consensus, photos),
    )
