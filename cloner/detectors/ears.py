"""Ears in front and side photos: a cascade of linear regressions on gradient histograms.

Face nets tell ears badly and nothing marks them in an outline seen from the side. Each stage looks at the picture and
the person's mask around the present guess and says where top, lobe, back and outermost point lie; the next looks from
there. Right ears are mirrored, so one model serves both sides. Calibrated on painted people (``calibrate_ears.py``).
"""

from __future__ import annotations

import functools
import importlib.resources
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.vision.gradients import describe

Array = NDArray[np.float64]
Picture = NDArray[np.float32]

#: Points of a front and of a side photo, without the side.
FRONT_EARS: Final = ("ear_top", "ear_lobe", "ear_outer")
SIDE_EARS: Final = ("ear_top", "ear_lobe", "ear_back", "ear_outer")
#: The looked-at window, px, and the eye distance in it.
WINDOW_PX: Final = (64, 80)
IOD_PX: Final = 40.0
#: Eye distance to which photos are shrunk first; finer detail is not looked at.
_SHRUNK_IOD_PX: Final = 64.0
#: Weight of the mask's edge beside the picture's (a skin edge has about 100 grey levels, the mask 255).
MASK_WEIGHT: Final = 0.4
#: Guesses around the first one whose agreement tells the error, and how far apart, shares of the eye distance.
_GUESSES: Final = np.array([[0.0, 0.0], [0.1, 0.0], [-0.1, 0.0], [0.0, 0.1], [0.0, -0.1], [0.08, 0.08], [-0.08, -0.08]])


@dataclass(frozen=True, slots=True, eq=False)
class EarModel:
    """Stages of one cascade.

    Attributes
    ----------
    names : tuple of str
    base : (K, 2) float64
        Mean places around the ear's middle, eye distances, as the person's left ear is seen from the front, or the
        ear of a head that looks to the image's left.
    means, weights, offsets : (S, D), (S, D, 2 K), (S, 2 K) float64
    error : (2,) float64
        Expected error is the first plus the second times the guesses' spread, eye distances.
    """

    names: tuple[str, ...]
    base: Array
    means: Array
    weights: Array
    offsets: Array
    error: Array


@dataclass(frozen=True, slots=True, eq=False)
class Ear:
    """Points of one ear (K, 2) px in the order of the model's names, and their expected error in eye distances."""

    points_px: Array
    error_iod: float


@functools.cache
def load_ears() -> dict[str, EarModel]:
    """Return the shipped models "front" and "side" (made by ``calibrate_ears.py``)."""
    place = importlib.resources.files("cloner_models") / "ears.npz"
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        data = {name: archive[name] for name in archive.files}
    names = {"front": FRONT_EARS, "side": SIDE_EARS}
    keys = ("base", "means", "weights", "offsets", "error")
    return {view: EarModel(names[view], *(data[f"{view}_{key}"].astype(np.float64) for key in keys)) for view in names}


def prepare(rgb: NDArray[np.uint8], mask: NDArray[np.uint8], iod_px: float) -> tuple[Picture, Picture, float]:
    """Return grey picture and mask at the size that ears are looked at, and their scale.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    mask : (H, W) uint8, 0..255
    iod_px : float
    """
    scale = min(1.0, _SHRUNK_IOD_PX / iod_px)
    size = (max(8, round(rgb.shape[1] * scale)), max(8, round(rgb.shape[0] * scale)))
    grey = cv2.cvtColor(cv2.resize(rgb, size, interpolation=cv2.INTER_AREA), cv2.COLOR_RGB2GRAY)
    person = cv2.resize(mask, size, interpolation=cv2.INTER_AREA)
    smooth = cv2.GaussianBlur(grey.astype(np.float32), (0, 0), 0.7)
    return np.asarray(smooth, np.float32), np.asarray(cv2.GaussianBlur(person.astype(np.float32), (0, 0), 1.0)), scale


def look(grey: Picture, person: Picture, middle: Array, iod_px: float, mirrored: bool) -> Array:
    """Return the description (D,) of the window around a place; a mirrored one is seen as in a mirror."""
    width, height = WINDOW_PX
    scale = IOD_PX / iod_px
    across = -scale if mirrored else scale
    to_window = np.array(
        [[across, 0.0, width / 2 - 0.5 - across * middle[0]], [0.0, scale, height / 2 - 0.5 - scale * middle[1]]]
    )
    seen = [
        cv2.warpAffine(image, to_window, WINDOW_PX, flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        for image in (grey, person)
    ]
    return np.concatenate([describe(seen[0]), describe(np.asarray(MASK_WEIGHT * seen[1], np.float32))])


def walk(model: EarModel, grey: Picture, person: Picture, middle: Array, iod_px: float, mirrored: bool) -> Array:
    """Return the (K, 2) points that the cascade reaches from a guess of the ear's middle, px of the pictures."""
    turn = np.array([-1.0 if mirrored else 1.0, 1.0])
    points = middle + model.base * turn * iod_px
    for mean, weights, offset in zip(model.means, model.weights, model.offsets, strict=True):
        told = (look(grey, person, middle, iod_px, mirrored) - mean) @ weights + offset
        points = middle + (told.reshape(-1, 2) + model.base) * turn * iod_px
        middle = points.mean(axis=0)
    return np.asarray(points)


def find_ear(
    model: EarModel, rgb: NDArray[np.uint8], mask: NDArray[np.uint8], guess_px: Array, iod_px: float, *, right: bool
) -> Ear:
    """Return the ear near a guess: the median of what several guesses lead to.

    Parameters
    ----------
    model : EarModel
    rgb : (H, W, 3) uint8
    mask : (H, W) uint8, 0..255
    guess_px : (2,) the ear's middle, roughly
    iod_px : float
        Eye distance at the head's depth.
    right : bool
        Whether it is the person's right ear; those are looked at in a mirror.
    """
    grey, person, scale = prepare(rgb, mask, iod_px)
    size = np.array([grey.shape[1] / rgb.shape[1], grey.shape[0] / rgb.shape[0]])
    middle, iod = (guess_px + 0.5) * size - 0.5, iod_px * scale
    found = np.stack([walk(model, grey, person, middle + iod * away, iod, right) for away in _GUESSES])
    points = np.median(found, axis=0)
    spread = float(np.median(np.linalg.norm(found - points, axis=2))) / iod
    return Ear((points + 0.5) / size - 0.5, float(model.error[0] + model.error[1] * spread))
