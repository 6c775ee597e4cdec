"""The paper's own way to an outline, without any net: from feature points alone, on a plain background.

References
----------
W.-S. Lee, J. Gu, N. Magnenat-Thalmann, "Generating Animatable 3D Virtual Humans from
Photographs", Eurographics 2000, section 3.5; method note section 4.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.vision.band import LinkParams
from cloner.vision.loops import LEAST_BODY_AREA, fill_polygon
from cloner.vision.outlines import Outline, extract_outline
from cloner.vision.parting import likeness_map

#: The person reaches at most so far beyond the polygon of the feature points, figure heights: a hand beyond the wrists.
BEYOND: Final = 0.12
#: Half width of the vicinity band around the first guess, figure heights.
BAND: Final = 0.015
#: Narrower gaps between pixels unlike the wall are the person's, figure heights: buttons, stripes of the wall's colour.
CLOSED: Final = 0.004


def outline_from_points(rgb: NDArray[np.uint8], feature_points_px: NDArray[np.float64]) -> Outline:
    """Trace a person's outline from feature points on it, before a plain background.

    Parameters
    ----------
    rgb : ndarray, shape (H, W, 3), uint8
        The upright photo.
    feature_points_px : ndarray, shape (N, 2), float64
        At least three points near the outline, in their order along it, px.

    Returns
    -------
    Outline
        Linked edges; each feature segment lies between two of the points.

    Raises
    ------
    ValueError
        If fewer than three points are given.

    Notes
    -----
    Departure: the paper looks for edges near the straight line between two points, which misses a hand beyond the
    wrists.  Here colours that the wall does not have, connected to the points' polygon, make the first guess.
    """
    if len(feature_points_px) < 3:
        raise ValueError(f"an outline needs three feature points, {len(feature_points_px)} were given")
    inside = fill_polygon(feature_points_px, (rgb.shape[0], rgb.shape[1]))
    height = float(np.ptp(feature_points_px[:, 1]))
    odds = likeness_map(rgb, inside.astype(np.float32), None, height_px=height, reach_px=BEYOND * height)
    size = 2 * round(CLOSED * height) + 1
    disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
    unlike = cv2.morphologyEx((odds > 0.0).astype(np.uint8), cv2.MORPH_CLOSE, disc)
    # Where colours say nothing, deep inside, the polygon does.
    unlike |= (inside & (odds == 0.0)).astype(np.uint8)
    _, labels = cv2.connectedComponents(unlike, connectivity=4)
    # A white collar before a white wall parts the head from the trunk.
    touched = np.bincount(labels[inside & (unlike > 0)], minlength=2) >= LEAST_BODY_AREA * height**2
    touched[0] = False
    guess = np.pad(touched, (0, int(labels.max()) + 1 - len(touched)))[labels].astype(np.float32)
    return extract_outline(rgb, guess, feature_points_px, params=replace(LinkParams(), band=BAND))
