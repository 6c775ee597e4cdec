"""What the learned detectors return, and the names of their points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

POSE_NAMES: Final = (
    "nose",
    "eye_inner_l", "eye_l", "eye_outer_l", "eye_inner_r", "eye_r", "eye_outer_r",
    "ear_l", "ear_r", "mouth_l", "mouth_r",
    "shoulder_l", "shoulder_r", "elbow_l", "elbow_r", "wrist_l", "wrist_r",
    "pinky_l", "pinky_r", "index_l", "index_r", "thumb_l", "thumb_r",
    "hip_l", "hip_r", "knee_l", "knee_r", "ankle_l", "ankle_r",
    "heel_l", "heel_r", "foot_index_l", "foot_index_r",
)  # fmt: skip
"""BlazePose's 33 points in the net's order; l and r are the person's own sides."""


@dataclass(frozen=True, slots=True, eq=False)
class Box:
    """A person or face found in a photo, upright, in photo px.

    Parameters
    ----------
    kind : "person" or "face"
    left_px, top_px, right_px, bottom_px : float
        May reach beyond the photo.
    score : float
        0..1.
    keypoints_px : (K, 2) float64
        Person: hip centre, a point on the circle round the body, shoulder centre, nose.
        Face: right eye, left eye, nose tip, mouth centre, right and left ear (the
        person's sides).
    """

    kind: Literal["person", "face"]
    left_px: float
    top_px: float
    right_px: float
    bottom_px: float
    score: float
    keypoints_px: NDArray[np.float64]

    @property
    def width_px(self) -> float:
        """Width in px."""
        return self.right_px - self.left_px

    @property
    def height_px(self) -> float:
        """Height in px."""
        return self.bottom_px - self.top_px


@dataclass(frozen=True, slots=True, eq=False)
class PoseResult:
    """A body found in a photo.

    Parameters
    ----------
    points_px : (33, 2) float64
        `POSE_NAMES` in photo px.
    visibility, presence : (33,) float64
        0..1: seen, and inside the photo.
    score : float
        0..1, the net's belief that this is a person.
    mask : (H, W) float32
        Probability of the person, 0..1, at the photo's size; about 1/256 of the body
        sharp, so refine it.
    """

    points_px: NDArray[np.float64]
    visibility: NDArray[np.float64]
    presence: NDArray[np.float64]
    score: float
    mask: NDArray[np.float32]


@dataclass(frozen=True, slots=True, eq=False)
class FaceResult:
    """A face found in a photo.

    Parameters
    ----------
    points_px : (468, 2) float64
        The face mesh's points in photo px; those of lips, eyes and brows from a second, closer look.
    depth_px : (468,) float64
        Relative depth in px, smaller is nearer to the camera; weak perspective.
    presence : float
        0..1. High also for profiles, where the far half is invented.
    turn_deg : float
        Rough yaw of the head, 0 front; positive when the person looks to the image's
        right. Trust the points below about 40 degrees only.
    box : Box or None
        The detector's box the search started from.
    irises_px : (2, 2) float64
        Centres of the person's left and right iris.
    first_px : (468, 2) float64
        The mesh before the closer look.
    """

    points_px: NDArray[np.float64]
    depth_px: NDArray[np.float64]
    presence: float
    turn_deg: float
    box: Box | None
    irises_px: NDArray[np.float64]
    first_px: NDArray[np.float64]
