"""The head's place in a photo, from whatever points are known."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

# Eyes with brows, and lips of the 468-point mesh
_EYES: Final = ((70, 63, 105, 66, 107, 133, 153, 145, 163, 33), (300, 293, 334, 296, 336, 362, 380, 374, 390, 263))
_LIPS: Final = (61, 39, 0, 269, 291, 405, 17, 181)


@dataclass(frozen=True, slots=True)
class HeadFrame:
    """Place and size of the head, px of the image in which it was found.

    Parameters
    ----------
    top_px, chin_px : float
        Rows of the crown and the chin.
    x_px : float
        Column of the head's middle.
    ear_px : float
        Row of the ear's middle.
    facing : float
        Where the nose points in the image: -1 left, 1 right, 0 to or from the camera.
    """

    top_px: float
    chin_px: float
    x_px: float
    ear_px: float
    facing: float

    @property
    def head_px(self) -> float:
        """Return the distance from crown to chin."""
        return self.chin_px - self.top_px


def find_head(person: Flags, face_points: Floats | None, view: str, pose_points: Floats | None) -> HeadFrame:
    """Return the head's place from the mesh, else the pose points, else the outline."""
    rows = np.flatnonzero(person.any(axis=1))
    if face_points is not None:
        low, high = face_points[:, 0].min(), face_points[:, 0].max()
        x, chin, brow = (low + high) / 2, float(face_points[152, 1]), float(face_points[10, 1])
        above = person[: int(max(brow, 1)), int(max(low, 0)) : int(max(high, 1))]
        found = np.flatnonzero(above.any(axis=1))
        top = float(found[0]) if len(found) else brow
        return HeadFrame(top, chin, float(x), float(face_points[[234, 454], 1].mean()), 0.0)
    if pose_points is not None:
        nose, ears = pose_points[0], pose_points[[7, 8]].mean(axis=0)
        top = float(rows[0])
        if view.endswith("side"):
            # a nose lies 0.62 of a head below the crown (generic head)
            head = max(float(nose[1] - top) / 0.62, 8.0)
            x = float(nose[0] + ears[0]) / 2 - 0.12 * head * np.sign(nose[0] - ears[0])
            return HeadFrame(top, top + head, float(x), float(ears[1]), float(np.sign(nose[0] - ears[0])))
        head = max(float(ears[1] - top) / 0.55, 8.0)
        return HeadFrame(top, top + head, float(ears[0]), float(ears[1]), 0.0)
    top, height = float(rows[0]), float(rows[-1] - rows[0])
    head = 0.135 * height if view.startswith("body") else 0.45 * height
    band = person[int(top + 0.2 * head) : int(top + 0.8 * head)]
    x = float(np.nonzero(band)[1].mean())
    return HeadFrame(top, top + head, x, top + 0.55 * head, 0.0)


def face_organs(face: Floats, shape: tuple[int, int]) -> Flags:
    """Return eyes with brows, and lips: no hair, whatever their colour."""
    organs = np.zeros(shape, np.uint8)
    for ring in (*_EYES, _LIPS):
        cv2.fillPoly(organs, [cv2.convexHull(np.round(face[list(ring)]).astype(np.int32))], 1)
    return organs > 0
