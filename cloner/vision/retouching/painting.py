"""Painted colours of what no photo shows well: eyeballs, teeth, gums, tongue, lashes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cloner.easing import smoothstep

Image = NDArray[np.float32]

SCLERA_RGB = (214.0, 204.0, 197.0)  # taste: never white, else the clone stares
SCLERA_TO_SKIN = 1.02  # taste: the white of the eye is this much lighter than the face around it, in levels
#: Mean light of the lids' shade on what shows of the white; whites darker or lighter than the usual by more than these
#: are reflections or lashes (taste); never paper.
LID_SHADE, WHITE_RANGE, BRIGHTEST = 0.88, (0.6, 1.9), 238.0
VESSEL_RGB = (196.0, 130.0, 118.0)
PUPIL_RGB = (14.0, 11.0, 10.0)
TOOTH_RGB = (222.0, 209.0, 188.0)
TOOTH_WIDTH_M, CROWN_M = 0.0078, 0.012  # anatomy: 7 to 9 mm wide, 9 to 10 mm high; a raised lip must not show only gum
SHADED_TEETH, CHEEK_SHADE = (2.6, 4.2), 0.7  # teeth from the middle (canine to first molar); share of light; taste
GUM_RGB = (172.0, 96.0, 92.0)
TONGUE_RGB = (168.0, 88.0, 86.0)
LASH_RGB = (38.0, 28.0, 24.0)
FURROW_M, FURROW_SHADE = 0.0015, 0.18  # taste
MOUTH_RGB, DEEP_RGB = (104.0, 44.0, 42.0), (38.0, 14.0, 14.0)  # behind the lips, and in the throat (taste)
DEEP_M = (0.015, 0.055)  # light fades between these depths behind the lips or the tongue's tip, metres (taste)
PUPIL_SHARE = 0.36  # of the iris radius: 4 mm in 11.7 mm, indoor light


def _ramp(values: Image, low: float, high: float) -> Image:
    """Return a smooth step from 0 at ``low`` to 1 at ``high``."""
    return smoothstep(values, low, high).astype(np.float32)


def _mix(a: Image, b: NDArray[np.floating] | tuple[float, ...], share: Image) -> Image:
    return np.asarray(a + (np.asarray(b, np.float32) - a) * share[:, None], np.float32)


def paint_eye(
    directions: Image,
    iris_rgb: NDArray[np.floating],
    iris_angle: float,
    skin_rgb: NDArray[np.floating],
    white_to_skin: NDArray[np.floating] | None,
    rng: np.random.Generator,
) -> Image:
    """Return (N, 3) colours, levels, of points on an eyeball.

    Parameters
    ----------
    directions : (N, 3) unit, from the eyeball's centre, +Z is the gaze, +Y up
    iris_rgb : (3,) levels
    iris_angle : float
        Radius of the iris as an angle from the gaze, radians.
    skin_rgb : (3,) levels
        Colour of the face; a dim photo has dim eyes.
    white_to_skin : (3,) or None
        How much lighter the photo shows the whites than the skin around them; None where it does not tell.
    rng : numpy Generator, for fibres and vessels
    """
    angle = np.arccos(np.clip(directions[:, 2], -1.0, 1.0)).astype(np.float32)
    around = np.arctan2(directions[:, 1], directions[:, 0]).astype(np.float32)
    share = angle / np.float32(iris_angle)
    colour = _paint_sclera(share, around, sclera_rgb(np.asarray(skin_rgb, np.float64), white_to_skin), rng)
    iris = _paint_iris(share, around, np.asarray(iris_rgb, np.float32), rng)
    # The limbus is soft: about a tenth of the iris radius in life.
    colour = _mix(iris, colour, _ramp(share, 0.95, 1.10))
    # The upper lid throws a shadow on the ball; without it eyes look pasted on.
    shade = 1.0 - 0.40 * _ramp(directions[:, 1], 0.05, 0.45) - 0.10 * _ramp(-directions[:, 1], 0.15, 0.5)
    return np.clip(colour * shade[:, None], 0.0, 255.0).astype(np.float32)


def sclera_rgb(skin_rgb: NDArray[np.float64], white_to_skin: NDArray[np.floating] | None) -> Image:
    """Return the colour (3,) of the sclera: relative to the skin as in the photo, else as it usually is."""
    usual = np.array(SCLERA_RGB) * np.clip(SCLERA_TO_SKIN * np.mean(skin_rgb) / np.mean(SCLERA_RGB), 0.45, 1.0)
    if white_to_skin is None:
        return np.asarray(usual, np.float32)
    # what the photo shows lies in the shade of the lids that is painted here once more
    shown = np.asarray(white_to_skin) * skin_rgb / LID_SHADE
    grey = shown.mean()
    light = np.clip(grey, WHITE_RANGE[0] * usual.mean(), WHITE_RANGE[1] * usual.mean())
    return np.asarray(np.minimum(shown * light / grey, BRIGHTEST), np.float32)


def _paint_iris(share: Image, around: Image, rgb: Image, rng: np.random.Generator) -> Image:
    fibre = np.zeros_like(share)
    for count, strength in ((37, 0.10), (61, 0.08), (97, 0.06)):
        fibre += strength * np.sin(count * around + rng.uniform(0, 6.28) + 2.0 * np.sin(3.0 * share * 6.28))
    light = 0.85 + 0.35 * _ramp(share, 0.35, 0.65) - 0.25 * _ramp(share, 0.65, 0.95)
    iris = rgb[None] * (light * (1.0 + fibre))[:, None]
    # A warmer ring around the pupil, and a dark limbal ring.
    iris = _mix(iris, rgb * np.array([1.15, 0.95, 0.75], np.float32), 0.5 * (1.0 - _ramp(share, 0.45, 0.65)))
    iris = _mix(iris, rgb * np.float32(0.35), 0.75 * _ramp(share, 0.80, 0.98))
    return _mix(iris, PUPIL_RGB, 1.0 - _ramp(share, PUPIL_SHARE - 0.04, PUPIL_SHARE + 0.05))


def _paint_sclera(share: Image, around: Image, white_rgb: Image, rng: np.random.Generator) -> Image:
    colour = np.tile(white_rgb, (len(share), 1))
    reddening = 0.45 * _ramp(share, 1.35, 2.8)
    vessels = np.zeros_like(share)
    for _ in range(14):
        middle, wave, phase = rng.uniform(-np.pi, np.pi), rng.uniform(0.03, 0.09), rng.uniform(0, 6.28)
        path = middle + wave * np.sin(5.0 * share + phase)
        gap = np.abs(np.angle(np.exp(1j * (around - path))))
        vessels += np.exp(-((gap / 0.012) ** 2)).astype(np.float32)
    vessels = np.clip(vessels, 0.0, 1.0) * 0.35 * _ramp(share, 1.3, 2.2)
    red = np.array(VESSEL_RGB) / np.mean(SCLERA_RGB) * float(white_rgb.mean())
    return _mix(colour, red, np.clip(reddening + vessels, 0.0, 0.6).astype(np.float32))


def paint_teeth(height_m: Image, along_m: Image) -> Image:
    """Return (N, 3) colours of one jaw's teeth.

    Parameters
    ----------
    height_m : (N,) metres
        From the biting edge towards the gum.
    along_m : (N,) metres
        Along the arch from its middle.
    """
    colour = np.tile(np.array(TOOTH_RGB, np.float32), (len(height_m), 1))
    # the gum's edge dips between the teeth, and so does the light
    between = np.abs(np.asarray(along_m, np.float32) / np.float32(TOOTH_WIDTH_M) % 1.0 - 0.5) * 2.0
    colour *= (1.0 - 0.30 * _ramp(between, 0.86, 0.99))[:, None]
    gum = np.asarray(height_m, np.float32) / np.float32(CROWN_M) + 0.18 * between**2
    colour = _mix(colour, GUM_RGB, _ramp(gum, 0.92, 1.08))
    # behind the canines cheeks keep the light away: unshaded, side teeth stand like fangs in the mouth's corners
    from_middle = np.asarray(np.abs(along_m), np.float32) / np.float32(TOOTH_WIDTH_M)
    behind = _ramp(np.asarray(from_middle, np.float32), *SHADED_TEETH)
    return _mix(colour, DEEP_RGB, np.asarray(CHEEK_SHADE * behind, np.float32))


def paint_tongue(behind_m: Image, aside_m: Image) -> Image:
    """Return (N, 3) colours of a tongue: darker towards the throat and in the furrow along its middle.

    Parameters
    ----------
    behind_m : (N,) metres
        From the tip towards the throat.
    aside_m : (N,) metres
        From the middle.
    """
    furrow = FURROW_SHADE * np.exp(-((np.asarray(aside_m, np.float32) / np.float32(FURROW_M)) ** 2))
    colour = paint_plain(len(behind_m), TONGUE_RGB) * (1.0 - furrow)[:, None]
    return _mix(colour, DEEP_RGB, 0.85 * _ramp(np.asarray(behind_m, np.float32), *DEEP_M))


def paint_mouth(behind_m: Image) -> Image:
    """Return (N, 3) colours of the mouth's inside, so far behind the lips: light enters from the front only."""
    return _mix(paint_plain(len(behind_m), MOUTH_RGB), DEEP_RGB, _ramp(np.asarray(behind_m, np.float32), *DEEP_M))


def paint_plain(count: int, rgb: tuple[float, float, float]) -> Image:
    """Return (count, 3) copies of one colour."""
    return np.tile(np.array(rgb, np.float32), (count, 1))
