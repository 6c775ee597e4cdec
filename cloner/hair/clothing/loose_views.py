"""Loose clothing in the photos: its skinning, and the position of rest points between its edges."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.easing import smoothstep
from cloner.frames import ViewId
from cloner.generic.load import GenericHuman
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.paint.lookups.posed import parents_of
from cloner.records.arrays import Array
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.loose import LooseRegion

LEG_SHARE = 0.92  # of the motion of cloth well below the hips that is the thigh's
FIRST_LEG, LEG_RAMP = 0.2, 1.1  # legs begin this far above the hip joints, over this height; in distances between them
#: What carries cloth above the hips, upwards; each from its own height to its neighbours'.
TRUNK = ("sacroiliac", "vl5", "vl4", "vl3", "vl2", "vl1", "vt12", "vt11", "vt10")


@dataclass(frozen=True, slots=True, eq=False)
class LegSkinning:
    """Skinning of cloth around the legs: trunk and both thighs.

    Attributes
    ----------
    trunk : (J,) int32 joints, upwards
    levels_m : (J,) float64, their heights at rest
    hips : (2,) int32 joints, left and right
    hip_m : float
        Height of the hip joints.
    apart_m : float
        Distance between them.
    middle_m : float
        x between them.
    """

    trunk: NDArray[np.int32]
    levels_m: Array
    hips: NDArray[np.int32]
    hip_m: float
    apart_m: float
    middle_m: float

    @classmethod
    def of(cls, generic: GenericHuman, joined: Joined) -> LegSkinning:
        """Return the skinning of a person's clothes."""
        trunk = np.array([generic.joint(name) for name in TRUNK], np.int32)
        hips = np.array([generic.joint("l_hip"), generic.joint("r_hip")], np.int32)
        left, right = joined.joints_m[hips]
        middle, apart = (left + right) / 2, left - right
        return cls(trunk, joined.joints_m[trunk, 1], hips, float(middle[1]), float(apart[0]), float(middle[0]))

    def weights(self, points_m: Array) -> tuple[NDArray[np.int32], Array]:
        """Return skin joints and weights (N, 4) of rest points.

        Below the hips cloth follows the thigh beside it, halfway between the legs
        both; above them the two joints of the spine around its height, as the skin does.
        """
        height = points_m[:, 1]
        legs = LEG_SHARE * smoothstep((self.hip_m + FIRST_LEG * self.apart_m - height) / (LEG_RAMP * self.apart_m))
        left = smoothstep(0.5 + (points_m[:, 0] - self.middle_m) / self.apart_m)
        place = np.interp(height, self.levels_m, np.arange(len(self.trunk)))
        lower = np.minimum(place.astype(int), len(self.trunk) - 2)
        upper = place - lower
        hips = np.broadcast_to(self.hips, (len(points_m), 2))
        joints = np.concatenate([np.stack([self.trunk[lower], self.trunk[lower + 1]], axis=1), hips], axis=1)
        rest = 1.0 - legs
        weights = np.stack([rest * (1.0 - upper), rest * upper, legs * left, legs * (1.0 - left)], axis=1)
        return joints.astype(np.int32), weights


@dataclass(frozen=True, slots=True, eq=False)
class LooseView:
    """Loose clothing in one photo, in the photo's pose.

    Attributes
    ----------
    posed : PosedView
    region : LooseRegion
    transforms : (J, 4, 4)
        Posed from rest.
    hanging : Hanging
    """

    posed: PosedView
    region: LooseRegion
    transforms: Array
    hanging: LegSkinning

    def project(self, points_m: Array) -> Array:
        """Return photo pixels (N, 2) of rest points of the cloth."""
        return self.posed.camera.project(self._posed(points_m))

    def _posed(self, points_m: Array) -> Array:
        joints, weights = self.hanging.weights(points_m)
        return linear_blend_skinning(points_m, self.transforms, joints, weights)

    def depths(self, points_m: Array) -> Array:
        """Return the distances (N,) of rest points (N, 3) from the camera along its axis, metres."""
        return self.posed.camera.to_camera(self._posed(points_m))[:, 2]

    def across(self, points_m: Array) -> Array:
        """Return the position (N,) of rest points between the cloth's edges: -1 at the first, 1 at the last."""
        pixel = self.project(points_m)
        rows = self.region.top_px + np.arange(len(self.region.edges_px))
        first, last = (np.interp(pixel[:, 1], rows, edge) for edge in self.region.edges_px.T)
        return np.asarray((2.0 * pixel[:, 0] - first - last) / np.maximum(last - first, 1.0))

    def height_of(self, row_px: float, beside_m: Array) -> float:
        """Return the rest height at which the vertical through a point (3,) meets a photo row."""
        heights = np.linspace(beside_m[1] - 0.5, beside_m[1] + 0.5, 51)
        line = np.stack([np.full(51, beside_m[0]), heights, np.full(51, beside_m[2])], axis=1)
        return float(np.interp(-row_px, -self.project(line)[:, 1], heights))


def loose_views(
    generic: GenericHuman, joined: Joined, regions: Mapping[ViewId, LooseRegion], hanging: LegSkinning
) -> list[LooseView]:
    """Return the photos that show a piece of loose clothing."""
    found = []
    for view, region in regions.items():
        if view in joined.views:
            posed = joined.views[view]
            transforms = joint_transforms(joined.joints_m, parents_of(generic), posed.rotations)
            found.append(LooseView(posed, region, transforms, hanging))
    return found
