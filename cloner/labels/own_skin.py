"""The person's own skin colour against clothes of similar colour, such as tights below a coat."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.generic.seen_points import NAMES
from cloner.records.labels import GARMENTS, Label, shows
from cloner.vision.retouching.normalising import beyond_light, log_levels
from cloner.vision.segmentation.pieces import box_around, connected_pieces

#: What each number is and where it comes from: ``cloner/calibration/labels.toml``.
_CALIBRATED: Final = calibrated("labels.own_skin")

#: Everything in shares of the figure's height: pieces are smaller by their area over its square.
SMALLEST: Final = _CALIBRATED.number("smallest", "share")
HANDS: Final = _CALIBRATED.number("hands", "share")
BLUR: Final = _CALIBRATED.number("blur", "share")
BEYOND: Final = _CALIBRATED.number("beyond", "factor")
WRISTS: Final = [NAMES.index(f"{side}_wrist") for side in "lr"]


def relabel_foreign_skin(
    rgb: NDArray[np.uint8], labels: NDArray[np.uint8], seen_px: NDArray[np.float64], *, faced: bool
) -> NDArray[np.uint8]:
    """Return a body photo's labels with skin of a colour that cannot be the person's relabelled as clothes.

    What the person's skin is tell hands, and the face where it shows; what the clothes are, those around by colour.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    labels : (H, W) uint8
    seen_px : (21, 2) float64
        Joints and points under clothes.
    faced : bool
        Whether the photo may show the face: what is labelled so from behind is neck, ear or hair.
    """
    person = box_around(labels != Label.BACKGROUND)
    figure, shown = float(person[0].stop - person[0].start), labels[person]
    skin = shown == Label.BODY_SKIN
    known = skin & _near_points(shown.shape, seen_px[WRISTS] - (person[1].start, person[0].start), HANDS * figure)
    if faced:
        known |= shown == Label.FACE_SKIN
    if np.count_nonzero(known) <= SMALLEST * figure**2:
        return labels
    smooth = cv2.GaussianBlur(rgb[person], (0, 0), max(BLUR * figure, 0.5))
    logs = np.asarray(log_levels(smooth), np.float64)
    own = np.median(logs[known], axis=0)
    found = labels.copy()
    box, pieces, figures = connected_pieces(skin)
    for piece in np.flatnonzero(figures[1:, cv2.CC_STAT_AREA] >= SMALLEST * figure**2) + 1:
        inside = np.zeros(shown.shape, np.bool_)
        inside[box] = pieces == piece
        colour = np.median(logs[inside], axis=0)
        if beyond_light(colour - own) > BEYOND:
            found[person][inside] = _clothes_around(shown, logs, inside, colour, round(HANDS * figure))
    return found


def _near_points(shape: tuple[int, ...], points_px: NDArray[np.float64], reach_px: float) -> NDArray[np.bool_]:
    """Return the pixels (H, W) near some points."""
    disc = np.zeros(shape, np.uint8)
    for point in np.round(points_px).astype(int).tolist():
        cv2.circle(disc, tuple(point), round(reach_px), 1, -1)
    return disc > 0


def _clothes_around(
    labels: NDArray[np.uint8],
    logs: NDArray[np.float64],
    inside: NDArray[np.bool_],
    colour: NDArray[np.float64],
    reach_px: int,
) -> int:
    """Return the clothes label around a piece (H, W) with the closest colour; lower clothes without any."""
    rim = cv2.dilate(inside.astype(np.uint8), np.ones((2 * reach_px + 1,) * 2, np.uint8)) > 0
    beside = {int(label): rim & shows(labels, label) for label in GARMENTS}
    gaps = {
        label: float(beyond_light(np.median(logs[place], axis=0) - colour))
        for label, place in beside.items()
        if place.any()
    }
    return min(gaps, key=lambda label: gaps[label]) if gaps else int(Label.LOWER_CLOTHES)
