"""Cameras that frame a clone from a named side."""

from __future__ import annotations

import numpy as np

from cloner.generic.load import load_generic
from cloner.geometry.cameras.viewpoints import AZIMUTH_DEG, framing_camera
from cloner.records.clones import Clone
from cloner.records.views import Camera


def standard_camera(clone: Clone, view: str, width_px: int, height_px: int) -> Camera:
    """Return the camera that frames the clone in rest pose.

    Parameters
    ----------
    view : str
        front, side, left, right, back, three_quarter, and the same after
        ``face_`` ("face" alone is the face's front). "side" and "right" look
        from the person's right, three_quarter from the left front.

    Raises
    ------
    ValueError
        If the view is unknown.
    """
    side = view.removeprefix("face_") if view != "face" else "front"
    if side not in AZIMUTH_DEG:
        raise ValueError(f"unknown view {view!r}; known: {', '.join(AZIMUTH_DEG)}, face, face_...")
    points = np.vstack([clone.vertices_m, *(shell.vertices_m for shell in clone.shells)])
    if view.startswith("face"):
        generic = load_generic()
        head = clone.vertices_m[generic.segment("head")]
        points = points[points[:, 1] >= head[:, 1].min()]  # long hair must not shrink the face
        points = points[np.abs(points[:, 0]) <= 1.5 * np.abs(head[:, 0]).max()]  # nor raised shoulders
    return framing_camera(points, AZIMUTH_DEG[side], width_px, height_px)
