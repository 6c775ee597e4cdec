"""Matted photos: background removed, and what must not be painted on skin masked."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.records.labels import OWN, SKINS, Label, shows
from cloner.vision.photographs.arms import BELOW_SHOULDER, arm_zone
from cloner.vision.retouching.normalising import SATURATED
from cloner.vision.retouching.open_mouth import open_lip_borders
from cloner.vision.retouching.repair import repair_bleeding
from cloner.vision.retouching.skin_colour import LEAST_SAMPLES, SkinColour
from cloner.vision.retouching.soles import contact_shadow, shaded_floor

#: Outline of the eye openings in the 468-point face net, right eye then left eye (MediaPipe's own contour lists).
EYE_OPENINGS = (
    (33, 7, 163, 144, 145, 153, 154, 155, 133, 173, 157, 158, 159, 160, 161, 246),
    (263, 249, 390, 373, 374, 380, 381, 382, 362, 398, 384, 385, 386, 387, 388, 466),
)
#: Outlines of the brows in the face net, right then left (MediaPipe's own contour lists, lower line backwards).
BROWS = (
    (70, 63, 105, 66, 107, 55, 65, 52, 53, 46),
    (300, 293, 334, 296, 336, 285, 295, 282, 283, 276),
)
BROW_SPARE = 0.08  # of a brow's length: hairs beyond the outline
BROW_REACH = 0.25  # of a brow's length, 1.2 cm: a photo a little off shows the tail so far away
BAND_SHARE = 0.004  # unsafe band inside the outline, of the figure's height (0.5 % less what edge linking wins)
SMALLEST_BAND_PX = 2.0
BRIGHT = 200  # green of skin next to burning out, up to where levels are believed less


@dataclass(frozen=True, slots=True, eq=False)
class MattedPhoto:
    """One photo without background, with masks of what must not be painted on skin.

    Attributes
    ----------
    rgb : (H, W, 3) uint8
        Background and unsafe border replaced by the nearest safe foreground colour.
    blurred : (H, W, 3) uint8
        The same, blurred over about a centimetre, for comparing photos.
    inside_px : (H, W) float32
        Signed distance to the outline, positive inside.
    labels : (H, W) uint8
        Values of ``Label``.
    hair : (H, W) bool
        Pixels labelled hair.
    bare : (H, W) bool
        Pixels labelled skin.
    skin : (H, W) uint8
        255 where a pixel shows the person's own: skin, hair, eyes, mouth.
    shares : (float, float) or None
        Red and blue against green of this skin, levels.
    openings : (H, W) bool
        Open eyes and mouths: what shows there belongs to eyeballs and teeth, not to lids and lips.
    lips_px : (2, 11, 2) or None
        Inner borders of upper and lower lip where they are open, from the person's right to the left.
    brows : (H, W) uint8
        Brows of a frontal face 255, what lies close by 127: two photos never agree about them to the millimetre.
    arms : (H, W) bool
        Where arms and hands are seen below the shoulders; all False where nobody looked.
    figure_px : float
        Height of the person in the photo.
    """

    rgb: NDArray[np.uint8]
    blurred: NDArray[np.uint8]
    inside_px: NDArray[np.float32]
    labels: NDArray[np.uint8]
    hair: NDArray[np.bool_]
    bare: NDArray[np.bool_]
    skin: NDArray[np.uint8]
    shares: tuple[float, float] | None
    openings: NDArray[np.bool_]
    lips_px: NDArray[np.float64] | None
    brows: NDArray[np.uint8]
    arms: NDArray[np.bool_]
    figure_px: float


def prepare_matted_photo(
    rgb: NDArray[np.uint8],
    mask: NDArray[np.bool_],
    labels: NDArray[np.uint8],
    face_px: NDArray[np.float64] | None,
    stance: tuple[NDArray[np.float64], NDArray[np.float64]] | None,
    skin: SkinColour | None,
) -> MattedPhoto:
    """Return a photo prepared for projection.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    mask : (H, W) bool, the person
    labels : (H, W) uint8, values of ``Label``
    face_px : (468, 2) or None
        Points of the face net; None where there is no frontal face.
    stance : ((33, 2), (33,)) or None
        Points and visibility (``generic.seen_points.stance``); None where arms do not lie before the body.
    skin : SkinColour or None
        The person's, from this photo or, where it shows no face, from another.
    """
    rows = np.flatnonzero(mask.any(axis=1))
    figure = float(rows[-1] - rows[0] + 1) if rows.size else float(mask.shape[0])
    band = max(SMALLEST_BAND_PX, BAND_SHARE * figure)
    mixed = np.ones((2 * round(band / 2.0) + 1,) * 2, np.uint8)  # the shoe's edge is as soft as the outline
    shadow = cv2.dilate((contact_shadow(rgb, mask) | shaded_floor(rgb, mask)).astype(np.uint8), mixed) > 0
    repaired, inside = repair_bleeding(rgb, mask, band, shadow)
    blurred = cv2.GaussianBlur(repaired, (0, 0), max(1.5, 0.003 * figure))
    hair, bare = labels == Label.HAIR, shows(labels, *SKINS)
    arms = np.zeros(mask.shape, bool)
    if stance is not None:
        arms = arm_zone(stance, figure, mask.shape, below_shoulder=BELOW_SHOULDER)
    own = shows(labels, *OWN).astype(np.uint8) * 255
    shares = None if skin is None else skin_shares(skin, rgb[bare])
    lips = None if face_px is None else open_lip_borders(face_px)
    openings, brows = _eye_and_mouth_openings(face_px, lips, labels), _brows(face_px, mask.shape)
    # labels end in steps of a pixel: a soft edge keeps them from showing
    return MattedPhoto(
        repaired,
        blurred,
        inside,
        labels,
        hair,
        bare,
        cv2.blur(own, (3, 3)),
        shares,
        openings,
        lips,
        brows,
        arms,
        figure,
    )


def skin_shares(skin: SkinColour, shown: NDArray[np.uint8]) -> tuple[float, float]:
    """Return red and blue relative to green for overexposed skin; blue as in the brightest skin (N, 3) that is not
    saturated, as it is paler there than elsewhere.
    """
    red, blue = skin.shares()
    bright = shown[(shown[:, 1] > BRIGHT) & (shown[:, 1] < SATURATED[0])].astype(np.float64)
    return red, max(blue, float(np.median(bright[:, 2] / bright[:, 1]))) if len(bright) >= LEAST_SAMPLES else blue


def _eye_and_mouth_openings(
    face_px: NDArray[np.float64] | None, lips_px: NDArray[np.float64] | None, labels: NDArray[np.uint8]
) -> NDArray[np.bool_]:
    """Return the pixels (H, W) of open eyes with their rims, and between open lips, by net and labels."""
    picture = np.zeros(labels.shape, np.uint8)
    if face_px is None:
        return picture > 0
    if lips_px is not None:  # without a rim: lookups are laid on these borders
        picture[labels == Label.MOUTH] = 255
        around = np.concatenate([lips_px[0, 1:-1], lips_px[1, -2:0:-1]])
        cv2.fillPoly(picture, [np.rint(around).astype(np.int32)], 255)
    for ring in EYE_OPENINGS:
        polygon = np.rint(face_px[list(ring)]).astype(np.int32)
        cv2.fillPoly(picture, [polygon], 255)
        cv2.polylines(picture, [polygon], True, 255, max(1, int(0.03 * np.ptp(polygon[:, 0]))))
    return picture > 0


def _brows(face_px: NDArray[np.float64] | None, shape: tuple[int, ...]) -> NDArray[np.uint8]:
    picture = np.zeros(shape, np.uint8)
    if face_px is None:
        return picture
    polygons = [np.rint(face_px[list(ring)]).astype(np.int32) for ring in BROWS]
    for share, level in ((BROW_REACH, 127), (BROW_SPARE, 255)):
        for polygon in polygons:
            # a line reaches half its width beyond the polygon
            wide = max(1, round(2.0 * share * float(np.ptp(polygon[:, 0]))))
            cv2.fillPoly(picture, [polygon], level)
            cv2.polylines(picture, [polygon], True, level, wide)
    return picture
