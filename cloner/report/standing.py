"""Differences of pose between clone and person in the photos: the head's yaw, and the arm beside the trunk."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Final

import numpy as np

from cloner.detectors.nets import pose_rows as net
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import joint_transforms, posed_joints
from cloner.records.bodies import PosedView
from cloner.records.clones import Clone
from cloner.records.proposals import Proposal, Proposals

#: A head turned by more from front or profile is told, degrees.
MOST_TURNED: Final = 20.0
#: Elbow or wrist of the fitted arm farther from the pose net's than this is told, metres (9 generated people: elbows
#: 0.006 to 0.020, wrists 0.023 to 0.041).
MOST_BESIDE_M: Final = 0.08
_VISIBLE: Final = 0.5
_STRAIGHT: Final[Mapping[ViewId, float]] = {ViewId.FACE_FRONT: 0.0, ViewId.FACE_SIDE: 90.0}


def pose_warnings(clone: Clone, proposals: Proposals) -> tuple[str, ...]:
    """Return sentences about photos in which the clone's pose differs from the person's."""
    warnings = [*_turned(clone)]
    side = clone.views.get(ViewId.BODY_SIDE)
    if side is not None and ViewId.BODY_SIDE in proposals.views:
        warnings += _arms(clone, side, proposals.views[ViewId.BODY_SIDE])
    return tuple(warnings)


def _turned(clone: Clone) -> Iterator[str]:
    for view, straight in _STRAIGHT.items():
        if view in clone.views:
            turn = abs(abs(azimuth_degrees(clone.views[view])) - straight)
            if turn > MOST_TURNED:
                yield (
                    f"{view}: the head is turned by about {turn:.0f} degrees from where it should look; "
                    "retake it with the head turned as the body"
                )


def azimuth_degrees(posed: PosedView) -> float:
    """Return a camera's azimuth around a person, degrees: 0 in front, 90 at the person's left."""
    towards = -np.asarray(posed.camera.camera_from_model)[2, :3]
    return math.degrees(math.atan2(float(towards[0]), float(towards[2])))


def _arms(clone: Clone, side: PosedView, proposal: Proposal) -> Iterator[str]:
    generic = load_generic()
    transforms = joint_transforms(clone.joints_m, generic.joint_parents.astype(np.int32), side.rotations)
    placed = posed_joints(transforms, clone.joints_m)
    for number, name in enumerate(net.SIDES):
        away = []
        for joint, pair in (("elbow", net.ELBOWS), ("wrist", net.WRISTS)):
            if proposal.pose_visibility[pair[number]] > _VISIBLE:
                place_m = placed[generic.joint(f"{name[0]}_{joint}")]
                gap_px = side.camera.project(place_m[None])[0] - proposal.pose_px[pair[number]]
                away.append(side.camera.metres_per_pixel(place_m) * float(np.linalg.norm(gap_px)))
        if max(away, default=0.0) > MOST_BESIDE_M:
            yield (
                f"{ViewId.BODY_SIDE}: the {name} arm of the clone lies {100.0 * max(away):.0f} cm beside the arm in "
                "this photo; let the arms hang a little away from the body and retake it"
            )
