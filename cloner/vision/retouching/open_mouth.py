"""Detection of an open mouth from the face net's inner lip borders."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

#: Inner borders of the upper and the lower lip in the face net, from the person's right corner to the left.
INNER_LIPS: Final = (
    (78, 191, 80, 81, 82, 13, 312, 311, 310, 415, 308),
    (78, 95, 88, 178, 87, 14, 317, 402, 318, 324, 308),
)
#: Borders as far apart as this share of the mouth's width are an open mouth's (shut mouths of the samples and of 30
#: generated people: up to .13 where the face is small).
OPEN_SHARE: Final = 0.15
#: So far into the lips a photo shows their own colour, of the mouth's width: nearer the dark of the mouth mixes in.
SOFT_SHARE: Final = 0.03


def open_lip_borders(face_px: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Return the inner borders (2, 11, 2) of upper and lower lip in a photo, px; None where the mouth is closed.

    Parameters
    ----------
    face_px : (468, 2)
        Points of the face net.
    """
    borders = face_px[np.array(INNER_LIPS)]
    width = float(np.linalg.norm(borders[0, -1] - borders[0, 0]))
    apart = float((borders[1] - borders[0])[:, 1].max())
    return borders if apart > OPEN_SHARE * max(width, 1e-6) else None


def lip_colour_edges(borders_px: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return where the lips along open borders have their own colour, (2, 11, 2) px."""
    width = float(np.linalg.norm(borders_px[0, -1] - borders_px[0, 0]))
    return np.asarray(borders_px + SOFT_SHARE * width * np.array([[[0.0, -1.0]], [[0.0, 1.0]]]))
