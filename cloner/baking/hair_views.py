"""What every photo says about where hair is and is not: the hair's visual hull."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.baking.sources import body_triangles, parents_of, person_mask, pose
from cloner.frames import ViewId, mm_from_m
from cloner.generic.load import GenericHuman
from cloner.geometry.seeing import depth_at, nearest_of
from cloner.geometry.skinning import joint_transforms
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.points import Proposal, Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.vision.aligning import sample
from cloner.vision.plates import HAIR_LABEL
from cloner.vision.repair import signed_distance

Array = NDArray[np.float64]

SMALLEST_PIECE = 0.08  # of the largest hair area: brows and specks are smaller
FAR_MM = 1000.0


@dataclass(frozen=True, slots=True, eq=False)
class HairView:
    """One photo's evidence of hair.

    Attributes
    ----------
    posed : PosedView
    view_from_rest : (4, 4)
        Carries points that are fixed to the resting head into the photo's pose.
    nearest_m : (h, w) float32
        Depth picture of the posed body without hair.
    hair_px : (H, W) float32
        Signed distance to the hair's outline in the photo, positive inside.
    hair : (H, W) bool
    flip_m : float or None
        When set, points are mirrored at x = flip_m first: the photo stands for the other half.
    """

    posed: PosedView
    view_from_rest: Array
    nearest_m: NDArray[np.float32]
    hair_px: NDArray[np.float32]
    hair: NDArray[np.bool_]
    flip_m: float | None = None

    def to_view(self, points_m: Array) -> Array:
        """Return (N, 3) rest points as they stand in this photo."""
        if self.flip_m is not None:
            points_m = points_m * (-1.0, 1.0, 1.0) + (2.0 * self.flip_m, 0.0, 0.0)
        return points_m @ self.view_from_rest[:3, :3].T + self.view_from_rest[:3, 3]

    def evidence(self, points_m: Array) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:
        """Return how deep points lie inside the hair's outline, and which the photo can judge.

        Returns
        -------
        inside_mm : (N,) float32, positive inside the hair's outline
        judged : (N,) bool
            In the picture and not behind the body: if the photo shows no hair there, there is none.
        """
        posed = self.to_view(points_m)
        camera = self.posed.camera
        pixel = camera.project(posed)
        depth = camera.to_camera(posed)[:, 2]
        scale = mm_from_m(camera.metres_per_pixel(posed.mean(axis=0)))
        before = depth < depth_at(self.nearest_m, pixel)  # NaN outside the picture: not judged
        return sample(self.hair_px, pixel)[:, 0] * np.float32(scale), before


def hair_views(
    generic: GenericHuman, joined: Joined, proposals: Proposals, silhouettes: SilhouetteSet
) -> list[HairView]:
    """Return every photo's evidence; side photos also mirrored for the half they do not show."""
    found: list[HairView] = []
    triangles = body_triangles(generic)
    middle = float(joined.joints_m[generic.joint_names.index("skullbase"), 0])
    for view, posed in joined.views.items():
        if view not in proposals.views:
            continue
        hair = clean_hair(view, proposals.views[view], silhouettes)
        transforms = joint_transforms(joined.joints_m, parents_of(generic), posed.rotations)
        one = HairView(
            posed,
            transforms[generic.joint_names.index("skullbase")],
            nearest_of(pose(generic, joined, posed), triangles, posed.camera),
            signed_distance(hair),
            hair,
        )
        found.append(one)
        if view in (ViewId.BODY_SIDE, ViewId.FACE_SIDE):
            found.append(replace(one, flip_m=middle))
    return found


def clean_hair(view: ViewId, proposal: Proposal, silhouettes: SilhouetteSet) -> NDArray[np.bool_]:
    """Return (H, W) pixels of hair: labelled so, on the person, in pieces of some size."""
    hair = (proposal.labels == HAIR_LABEL) & person_mask(view, proposal, silhouettes)
    small = cv2.morphologyEx(hair.astype(np.uint8), cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    count, pieces, stats, _ = cv2.connectedComponentsWithStats(small, connectivity=8)
    if count < 2:
        return np.zeros_like(hair)
    area = stats[:, cv2.CC_STAT_AREA].astype(float)
    area[0] = 0.0
    return np.isin(pieces, np.flatnonzero(area >= SMALLEST_PIECE * area.max()))


def hull_mm(views: list[HairView], points_m: Array) -> NDArray[np.float32]:
    """Return (N,) how deep points lie in the hair's visual hull, millimetres, positive inside.

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
