"""Arms and hands in a photo, as thick lines along their joints."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array

#: Shoulder, elbow, wrist, then little finger, index finger and thumb of each arm in the pose net's order.
ARMS = ((11, 13, 15, 17, 19, 21), (12, 14, 16, 18, 20, 22))
#: Full widths of a sleeved arm and of a finger's line with the net's error (20 px in 1,800), share of the figure.
ARM_SHARE, HAND_SHARE = 0.060, 0.055
FINGER_STRETCH = 3.0  # the net's finger points are knuckles; long hands' tips lie this much farther from the wrist
POSE_TRUST = 0.5
#: Before the shoulder's end lies the trunk's own side: lines begin this share of the upper arm below the shoulder.
BELOW_SHOULDER = 0.3


def arm_zone(
    stance: tuple[Array, Array], figure_px: float, shape: tuple[int, ...], *, below_shoulder: float = 0.0
) -> NDArray[np.bool_]:
    """Return the pixels (H, W) of arms and hands, with a margin for the nets' mean error.

    Parameters
    ----------
    stance : (33, 2) px, (33,)
        Points and visibility (``generic.seen_points.stance``); arms and fingers that nothing is seen of are left out.
    figure_px : float
        Height of the person in the photo.
    below_shoulder : float
        Share of the upper arm that is left out below the shoulder.
    """
    pose_px, visibility = stance
    picture = np.zeros(shape[:2], np.uint8)
    arm, hand = (max(1, round(share * figure_px)) for share in (ARM_SHARE, HAND_SHARE))
    for shoulder, elbow, wrist, *fingers in ARMS:
        if min(visibility[[shoulder, elbow, wrist]]) < POSE_TRUST:
            continue
        begin = pose_px[shoulder] + below_shoulder * (pose_px[elbow] - pose_px[shoulder])
        lines = [(begin, pose_px[elbow], arm), (pose_px[elbow], pose_px[wrist], arm)]
        for finger in (one for one in fingers if visibility[one] >= POSE_TRUST):
            tip = pose_px[wrist] + FINGER_STRETCH * (pose_px[finger] - pose_px[wrist])
            lines.append((pose_px[wrist], tip, hand))
        for start, end, width in lines:
            ends = [tuple(round(float(value)) for value in point) for point in (start, end)]
            cv2.line(picture, ends[0], ends[1], 255, width)
    return picture > 0
