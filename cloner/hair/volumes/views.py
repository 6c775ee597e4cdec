"""The photos' evidence of hair and no hair: its visual hull."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId, mm_from_m
from cloner.generic.load import GenericHuman
from cloner.geometry.articulation.skinning import joint_transforms
from cloner.geometry.cameras.visibility import depth_at
from cloner.geometry.meshes.rasters import nearest_depth
from cloner.hair.volumes.pictures import FAR_MM, body_depth_m, clean_hair, distances_px
from cloner.paint.lookups.posed import parents_of
from cloner.paint.lookups.prepared import person_mask
from cloner.parallel import parallel_map
from cloner.records.arrays import Array
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.labels import GARMENTS, Label, shows
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.vision.retouching.aligning import sample

NEVER_ON_SCALPS = (Label.BODY_SKIN, *GARMENTS)
MASK_SCALE = 0.5  # surfaces are drawn at this share of the photo's size
LIES_BELOW_M = 0.12  # so far below the chest's joint hair lies on the back and follows no head
ONE_SIDED_MM = 4.0  # hair that is so far inside here and so far outside there hangs on one side (taste)
ONE_SIDED = 0.05  # of the hair, or both halves are alike: 18 of 33 generated people (of 30501 to 30923) have less
INVERSE_ROUNDS = 3  # rests to a micrometre: neck and skull differ by few degrees
#: Photos from before, from aside and from behind.
SIDES = (
    (ViewId.BODY_FRONT, ViewId.FACE_FRONT),
    (ViewId.BODY_SIDE, ViewId.FACE_SIDE),
    (ViewId.BODY_BACK,),
)


@dataclass(frozen=True, slots=True, eq=False)
class HairSkinning:
    """Skinning of hair: the skull, and further down partly neck and chest.

    Attributes
    ----------
    joints : (4,) int32
        Skull, neck, chest, and the skull again to fill the fourth place.
    heights_m : (3,) float64
        Their heights at rest.
    """

    joints: NDArray[np.int32]
    heights_m: Array

    @classmethod
    def of(cls, generic: GenericHuman, joined: Joined) -> HairSkinning:
        """Return the skinning for a person."""
        index = [generic.joint_names.index(name) for name in ("skullbase", "vc4", "vt1", "skullbase")]
        return cls(np.array(index, np.int32), np.asarray(joined.joints_m[index[:3], 1], np.float64))

    def weights(self, points_m: Array) -> tuple[NDArray[np.int32], Array]:
        """Return skin joints and weights (N, 4) of rest points.

        Hair below the skull's base hangs from the head by half and follows the chest by half; what is farther down
        than the chest's joint lies on the back and follows that.
        """
        shares = self.shares(points_m)
        weights = np.stack([*shares, np.zeros_like(shares[0])], axis=1)
        return np.tile(self.joints, (len(points_m), 1)), weights

    def shares(self, points_m: Array) -> tuple[Array, Array, Array]:
        """Return the weights (N,) of skull, neck and chest at rest points."""
        top, middle, bottom = self.heights_m
        down = np.clip((top - points_m[:, 1]) / max(top - bottom, 1e-6), 0.0, 1.0)
        half = max((top - middle) / max(top - bottom, 1e-6), 1e-6)
        neck = 0.5 * np.clip(np.minimum(down / half, (1.0 - down) / max(1.0 - half, 1e-6)), 0.0, 1.0)
        chest = 0.5 * np.clip((down - half) / max(1.0 - half, 1e-6), 0.0, 1.0)
        chest += 0.5 * np.clip((bottom - points_m[:, 1]) / LIES_BELOW_M, 0.0, 1.0)
        return 1.0 - neck - chest, neck, chest


@dataclass(frozen=True, slots=True, eq=False)
class HairView:
    """Evidence of hair in one photo.

    Attributes
    ----------
    posed : PosedView
    transforms : (J, 4, 4)
        Carry what is fixed to a joint from rest into the photo's pose.
    hanger : Hanger
        Which joints carry hair at which height.
    nearest_m : (h, w) float32
        Depth picture of the posed body without hair.
    hair : (H, W) bool
    hair_px : (H, W) float32
        Signed distance to the hair's outline in the photo, positive inside; far from all hair -FAR_MM.
    line_px : (H, W) float32
        Signed distance to the hairline, positive on the hair's side; the background counts as
        what lies nearest to it, so that a head a little off its photo still finds its hair.
    outline_px : (H, W) float32
        Signed distance to the person's outline, positive inside.
    clothed : (H, W) bool
        Pixels labelled as clothes or skin of the body: no scalp has them.
    flip_m : float or None
        When set, points are mirrored at x = flip_m first: the photo stands for the other half.
    front : HairView or None
        Of a mirrored photo: the photo from the front, which tells where both halves differ.
    above_m, taller : float
        Above this height hair is so many times taller here than photos together say; see `crowns.py`.
    """

    posed: PosedView
    transforms: Array
    hanger: HairSkinning
    nearest_m: NDArray[np.float32]
    hair: NDArray[np.bool_]
    hair_px: NDArray[np.float32]
    line_px: NDArray[np.float32]
    outline_px: NDArray[np.float32]
    clothed: NDArray[np.bool_]
    flip_m: float | None = None
    front: HairView | None = None
    above_m: float = np.inf
    taller: float = 1.0

    def to_hair(self, points_m: Array) -> Array:
        """Return the rest points (N, 3) at which this photo shows the hair that all photos place at some points."""
        higher = np.maximum(points_m[:, 1] - self.above_m, 0.0) * (self.taller - 1.0)
        return self.to_view(points_m + higher[:, None] * (0.0, 1.0, 0.0))

    def to_view(self, points_m: Array) -> Array:
        """Return rest points (N, 3) in this photo's pose."""
        return self._hung(points_m if self.flip_m is None else self._mirrored(points_m))

    def _mirrored(self, points_m: Array) -> Array:
        return points_m * (-1.0, 1.0, 1.0) + (2.0 * (self.flip_m or 0.0), 0.0, 0.0)

    def _hung(self, points_m: Array) -> Array:
        """Return rest points (N, 3) skinned by skull, neck and chest only."""
        found = np.zeros_like(points_m)
        for weight, joint in zip(self.hanger.shares(points_m), self.hanger.joints[:3], strict=True):
            if weight.any():
                turned = points_m @ self.transforms[joint, :3, :3].T
                turned += self.transforms[joint, :3, 3]
                turned *= weight[:, None]
                found += turned
        return found

    def to_rest(self, posed_m: Array) -> Array:
        """Return posed points (N, 3) at rest (not mirrored back)."""
        turn = self.transforms[self.hanger.joints[0], :3, :3]
        points = (posed_m - self.transforms[self.hanger.joints[0], :3, 3]) @ turn
        for _ in range(INVERSE_ROUNDS):
            points = points + (posed_m - self._hung(points)) @ turn
        return np.asarray(points)

    def pixel_mm(self, posed_m: Array) -> float:
        """Return the size of a pixel at posed points (N, 3), millimetres."""
        return mm_from_m(self.posed.camera.metres_per_pixel(posed_m.mean(axis=0)))

    def turn(self, normals: Array) -> Array:
        """Return rest directions (N, 3) in this photo's pose."""
        if self.flip_m is not None:
            normals = normals * (-1.0, 1.0, 1.0)
        return np.asarray(normals @ self.transforms[self.hanger.joints[0], :3, :3].T)

    def seen_at(self, points_m: Array) -> tuple[Array, Array]:
        """Return where the photo shows rest points (N, 3): in its pose (N, 3) and in its pixels (N, 2)."""
        posed = self.to_hair(points_m)
        return posed, self.posed.camera.project(posed)

    def evidence(
        self, points_m: Array, seen_at: tuple[Array, Array] | None = None
    ) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:
        """Return the depth (N,) of points inside the hair's outline, mm, and which the photo can judge (N,).

        It judges what is in the picture and not behind the body: if it shows no hair there, there is none.
        ``seen_at`` is what the method of that name gives, where that is known.
        """
        posed, pixel = seen_at or self.seen_at(points_m)
        depth = self.posed.camera.to_camera(posed)[:, 2]
        before = depth < depth_at(self.nearest_m, pixel)  # NaN outside the picture: not judged
        return self._inside_mm(posed, pixel), before & self.speaks_for(points_m)

    def speaks_for(self, points_m: Array) -> NDArray[np.bool_]:
        """Return whether (N,) the photo may say that there is no hair at rest points.

        A mirrored photo may not where the photo from the front shows hair there and none in the place that the mirrored
        one saw: a parting at the side, a curtain over one eye.
        """
        if self.flip_m is None or self.front is None:
            return np.ones(len(points_m), np.bool_)
        own, other = (self.front.inside_mm(place) for place in (points_m, self._mirrored(points_m)))
        return np.asarray(~((own > ONE_SIDED_MM) & (other < -ONE_SIDED_MM)))

    def inside_mm(self, points_m: Array) -> NDArray[np.float32]:
        """Return how far (N,) rest points lie inside the hair's outline in the photo, mm."""
        return self._inside_mm(*self.seen_at(points_m))

    def _inside_mm(self, posed_m: Array, pixel: Array) -> NDArray[np.float32]:
        return np.asarray(sample(self.hair_px, pixel)[:, 0] * np.float32(self.pixel_mm(posed_m)))


def hair_views(
    generic: GenericHuman, joined: Joined, proposals: Proposals, silhouettes: SilhouetteSet
) -> list[HairView]:
    """Return every photo's evidence; side photos also mirrored for the half they do not show."""
    hanger = HairSkinning.of(generic, joined)
    middle = float(joined.joints_m[generic.joint_names.index("skullbase"), 0])

    def seen(view: ViewId) -> HairView:
        posed, person = joined.views[view], person_mask(view, proposals.views[view], silhouettes)
        hair = clean_hair(proposals.views[view], person)
        transforms = joint_transforms(joined.joints_m, parents_of(generic), posed.rotations)
        clothed = person & shows(proposals.views[view].labels, *NEVER_ON_SCALPS)
        nearest = body_depth_m(generic, joined, posed, clothed)
        return HairView(posed, transforms, hanger, nearest, *distances_px(hair, person), clothed)

    straight = list(parallel_map(seen, [view for view in joined.views if view in proposals.views]))
    by_view = {one.posed.view: one for one in straight}
    front = by_view.get(ViewId.FACE_FRONT, by_view.get(ViewId.BODY_FRONT))
    if front is not None and one_sided_share(front, joined.joints_m[generic.joint("skullbase")]) < ONE_SIDED:
        front = None
    found: list[HairView] = []
    for one in straight:
        found.append(one)
        if one.posed.view.is_side:
            found.append(replace(one, flip_m=middle, front=front))
    return found


def one_sided_share(front: HairView, middle_m: Array) -> float:
    """Return the share of the hair in a photo from the front that hangs on one side of the head's middle (3,) only."""
    middle = front.to_view(middle_m[None])
    columns = np.arange(front.hair_px.shape[1])
    mirrored = np.rint(2.0 * front.posed.camera.project(middle)[0, 0] - columns).astype(np.int64)
    inside = (mirrored >= 0) & (mirrored < len(columns))
    least = ONE_SIDED_MM / front.pixel_mm(middle)
    own, other = front.hair_px > least, np.zeros(front.hair_px.shape, np.bool_)
    other[:, inside] = front.hair_px[:, mirrored[inside]] < -least
    return float((own & other).sum() / max(own.sum(), 1))


def visual_hull_mm(views: list[HairView], points_m: Array) -> NDArray[np.float32]:
    """Return the depth (N,) of points in the hair's visual hull, millimetres, positive inside.

    A point is hair when no photo that can judge it shows something else there
    and at least one photo shows hair. Negative = outside; -FAR where no photo judges.
    """
    worst = np.full(len(points_m), FAR_MM, np.float32)
    judged = np.zeros(len(points_m), bool)
    for view in views:
        inside, before = view.evidence(points_m)
        worst = np.where(before, np.minimum(worst, inside), worst)
        judged |= before
    return np.where(judged, worst, np.float32(-FAR_MM))


def covered_by_surface(view: HairView, surface_m: Array, triangles: NDArray[np.int32]) -> NDArray[np.bool_]:
    """Return the pixels (h, w) that a surface covers, at MASK_SCALE of the photo."""
    camera = view.posed.camera
    size = int(camera.height_px * MASK_SCALE), int(camera.width_px * MASK_SCALE)
    pixel = (camera.project(view.to_view(surface_m)) + 0.5) * MASK_SCALE - 0.5
    depth = np.ones(len(pixel))  # which is nearer does not matter
    return np.isfinite(nearest_depth(np.clip(pixel, -1e4, 1e4), depth, triangles, size[1], size[0]))


def covered_window(
    view: HairView, surface_m: Array, triangles: NDArray[np.int32]
) -> tuple[NDArray[np.bool_], NDArray[np.float64]]:
    """Return :func:`covered_by_surface` cropped to the surface with a pixel of margin, and the vertices in it.

    Returns
    -------
    (h, w) bool and (N, 2) pixels of that picture
    """
    camera = view.posed.camera
    size = np.array([int(camera.width_px * MASK_SCALE), int(camera.height_px * MASK_SCALE)])
    pixel = np.clip((camera.project(view.to_view(surface_m)) + 0.5) * MASK_SCALE - 0.5, -1e4, 1e4)
    first = np.clip(np.floor(pixel.min(axis=0)).astype(int) - 1, 0, size - 1)
    width, height = (np.clip(np.ceil(pixel.max(axis=0)).astype(int) + 2, first + 1, size) - first).tolist()
    depth = np.ones(len(pixel))  # which is nearer does not matter
    return np.isfinite(nearest_depth(pixel - first, depth, triangles, width, height)), pixel - first
