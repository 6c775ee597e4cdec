"""A posed body against one photo's outline: shared by the skeleton, rough and fine stages."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId, mm_from_m
from cloner.generic.load import load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.articulation.skinning import blend_transforms, joint_transforms, posed_joints
from cloner.geometry.outlines.contours import OutlineField, outline_field
from cloner.geometry.outlines.silhouette import borders_px, silhouette_vertices
from cloner.geometry.outlines.slices import PosedBody, SlicePairs, occluding_pairs, rest_lift
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh, Phenotype, PosedView
from cloner.records.labels import Label, shows
from cloner.records.proposals import Proposal, Proposals
from cloner.records.silhouettes import SilhouetteSet

#: Height of the reduced photo on which rims are found, px.
PICTURE_HEIGHT = 640
#: Segments made of slices; head, hands and feet are free meshes (method §2).
GRID_SEGMENTS = (
    "torso",
    "pelvis",
    *(f"{side}_{part}" for part in ("upper_arm", "forearm", "thigh", "calf") for side in ("left", "right")),
)


@dataclass(frozen=True, slots=True, eq=False)
class OutlinedPhoto:
    """Pose, camera and outline of one photo."""

    posed: PosedView
    field: OutlineField

    @property
    def view(self) -> ViewId:
        """Name of the photo's view."""
        return self.posed.view


def outlined_photos(
    phenotype: Phenotype,
    silhouettes: SilhouetteSet,
    proposals: Proposals,
    poses: Mapping[ViewId, PosedView] | None = None,
) -> dict[ViewId, OutlinedPhoto]:
    """Return the body photos with outlines, in the phenotype's poses or in better ones."""
    photos = {}
    for view, posed in (poses or phenotype.views).items():
        reduction = max(posed.camera.height_px / PICTURE_HEIGHT, 1.0)
        silhouette = silhouettes.views[view]
        field = outline_field(
            silhouette.contours_px,
            silhouette.mask,
            proposals.views[view].labels == Label.HAIR,
            cloth=silhouette.loose_mask(),
            step_px=2.0 * reduction,
            reduction=reduction,
        )
        photos[view] = OutlinedPhoto(posed, field)
    return photos


def mask_outline_field(proposal: Proposal) -> OutlineField:
    """Return the outline field of a face photo from the net's mask, as it has no linked outline."""
    height = proposal.mask.shape[0]
    reduction = max(height / PICTURE_HEIGHT, 1.0)
    person = proposal.person()
    return outline_field(
        borders_px(person.astype(np.uint8)),
        person,
        shows(proposal.labels, Label.HAIR, Label.BEARD, Label.ACCESSORY),
        step_px=2.0 * reduction,
        reduction=reduction,
    )


@dataclass(frozen=True, slots=True, eq=False)
class PosedSilhouette:
    """A body posed as in a photo: geometry for slices, vertices in the model frame, and its filled silhouette,
    downscaled.
    """

    body: PosedBody
    posed_m: Array
    blended: Array
    mm_per_px: float
    picture: NDArray[np.bool_]


def posed_silhouette(mesh: BodyMesh, photo: OutlinedPhoto, among: NDArray[np.bool_] | None = None) -> PosedSilhouette:
    """Return the body posed and projected as in the photo.

    With ``among`` (V,) only these vertices are looked for on the rim, and the picture is filled around them only.
    """
    generic = load_generic()
    camera = photo.posed.camera
    transforms = joint_transforms(mesh.joints_m, generic.joint_parents, photo.posed.rotations)
    blended = blend_transforms(transforms, generic.skin_joints, generic.skin_weights.astype(np.float64))
    posed_m = np.einsum("vab,vb->va", blended[:, :, :3], mesh.vertices_m) + blended[:, :, 3]
    joints = posed_joints(transforms, mesh.joints_m)
    pixels = camera.project(posed_m)
    reduction = photo.field.reduction
    size = (photo.field.distance.shape[0], photo.field.distance.shape[1])
    small = (pixels + 0.5) / reduction - 0.5
    rim, picture = silhouette_vertices(small, posed_m, body_triangles(), camera.position_m, size, 2.5, among)
    on_rim = np.zeros(len(pixels), dtype=bool)
    on_rim[rim] = True
    depth = camera.to_camera(posed_m)[:, 2]
    size_m = depth / camera.focal_px if camera.pixels_per_m is None else np.full(len(depth), 1.0 / camera.pixels_per_m)
    lift = rest_lift(blended, camera.camera_from_model[:3, :3], size_m)
    body = PosedBody(pixels, camera.project(joints), on_rim, lift)
    return PosedSilhouette(body, posed_m, blended, mm_from_m(float(np.median(size_m))), picture > 0)


def slice_pairs(seen: PosedSilhouette, photo: OutlinedPhoto, name: str, levels: Array, reach_mm: float) -> SlicePairs:
    """Return the silhouette points of a segment's slices with their outline pixels in one photo."""
    generic = load_generic()
    first, second = generic.slice_axis_joints[generic.segment_names.index(name)]
    axis = (seen.body.joints_px[first], seen.body.joints_px[second])
    return occluding_pairs(
        seen.body,
        np.flatnonzero(generic.segment(name)),
        generic.slice_s.astype(np.float64),
        generic.slice_theta.astype(np.float64),
        axis,
        levels,
        photo.field,
        reach_mm / seen.mm_per_px,
    )


def paper_body_views(views: dict[ViewId, OutlinedPhoto], main: ViewId) -> tuple[OutlinedPhoto, ...]:
    """Return the photos of one of the paper's two bodies: front or back, and side."""
    wanted = [view for view in (main, ViewId.BODY_SIDE) if view in views]
    return tuple(views[view] for view in wanted) or tuple(views.values())


def outline_distances_mm(seen: PosedSilhouette, photo: OutlinedPhoto) -> dict[str, float]:
    """Return the mean distance from silhouette to outline, mm: of the whole body under "", and of each part.

    Method §7, residual in mm per part and per view. Left and right count together;
    what hair or loose clothing veils does not count.
    """
    generic = load_generic()
    rim = np.flatnonzero(seen.body.on_rim)
    rim = rim[~photo.field.is_veiled(seen.body.pixels[rim])]
    distance = np.abs(photo.field.signed_distance(seen.body.pixels[rim])) * seen.mm_per_px
    parts = np.array([name.removeprefix("left_").removeprefix("right_") for name in generic.segment_names])
    part = parts[generic.vertex_segment[rim]]
    gaps = {name: float(distance[part == name].mean()) for name in dict.fromkeys(parts) if (part == name).any()}
    return {"": float(distance.mean()) if len(rim) else 0.0, **gaps}


def mean_outline_distance_mm(mesh: BodyMesh, photo: OutlinedPhoto) -> float:
    """Return the mean distance from the body's silhouette to the photo's outline, mm."""
    return outline_distances_mm(posed_silhouette(mesh, photo), photo)[""]


def silhouette_iou(seen: PosedSilhouette, photo: OutlinedPhoto) -> float:
    """Return the intersection over union of the body's silhouette and the photo's filled outline."""
    inside = photo.field.distance <= 0
    return float((seen.picture & inside).sum() / max((seen.picture | inside).sum(), 1))
