"""Attributes of the person, read off the label images: bald, bearded, glasses, hat, bare feet."""

from __future__ import annotations

from collections.abc import Mapping
from enum import StrEnum
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.records.labels import SKINS, Label, shows

#: What each number is and where it comes from: ``cloner/calibration/labels.toml``.
_CALIBRATED: Final = calibrated("labels.states")

BEARD_SHARE: Final = _CALIBRATED.number("beard_share", "share")
GLASSES_SHARE: Final = _CALIBRATED.number("glasses_share", "share")
HEADWEAR_SHARE: Final = _CALIBRATED.number("headwear_share", "share")
FRINGE_SHARE: Final = _CALIBRATED.number("fringe_share", "share")
BALD_SHARE: Final = _CALIBRATED.number("bald_share", "share")
SCALP_SHARE: Final = _CALIBRATED.number("scalp_share", "share")
BARE_FOOT: Final = _CALIBRATED.number("bare_foot", "share")
#: Points of the 468-point face mesh: outer eye corners, and the brows' highest.
_EYES: Final = (33, 263)
_BROWS: Final = (105, 334)


class State(StrEnum):
    """An attribute that fit and textures treat differently."""

    BALD = "bald"
    BEARD = "beard"
    GLASSES = "glasses"
    HEADWEAR = "headwear"
    FRINGE = "hair over an eye"


def read_states(labels: Mapping[ViewId, NDArray[np.uint8]], face_px: NDArray[np.float64] | None) -> frozenset[State]:
    """Return the attributes that the face photos show.

    Parameters
    ----------
    labels : mapping
        Label pictures (H, W) of the photos.
    face_px : (468, 2) float64 or None
        Face mesh in the face's front photo; without it nothing but a beard is looked for.
    """
    found = set()
    near = [labels[view] for view in (ViewId.FACE_FRONT, ViewId.FACE_SIDE) if view in labels]
    count = sum((np.bincount(each.ravel(), minlength=len(Label)) for each in near), np.zeros(len(Label), np.int64))
    face = float(count[Label.FACE_SKIN] + count[Label.BEARD] + count[Label.EYES])
    if face == 0.0:
        return frozenset()
    if count[Label.BEARD] > BEARD_SHARE * face:
        found.add(State.BEARD)
    front = labels.get(ViewId.FACE_FRONT)
    if front is not None and face_px is not None:
        if min(_glasses_shares(front, face_px)) > GLASSES_SHARE:
            found.add(State.GLASSES)
        above = _above_the_brows(front, face_px)
        if above[Label.ACCESSORY] > HEADWEAR_SHARE:
            found.add(State.HEADWEAR)
        elif count[Label.HAIR] < BALD_SHARE * face and above[Label.FACE_SKIN] > SCALP_SHARE:  # no hood either
            found.add(State.BALD)
        if max(_fringe_shares(front, face_px)) > FRINGE_SHARE:
            found.add(State.FRINGE)
    return frozenset(found)


def eyes_span(face_px: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
    """Return the middle (2,) between the outer eye corners of a face mesh and their distance, px."""
    corners = face_px[list(_EYES)]
    return corners.mean(axis=0), float(np.hypot(*(corners[1] - corners[0])))


def _glasses_shares(labels: NDArray[np.uint8], face_px: NDArray[np.float64]) -> tuple[float, ...]:
    """Return the share of accessories in the bands above the eyes' corners, and below the left and the right one.

    Heavy brows are above alone, an earring or a clip is on one side.
    """
    middle, apart = eyes_span(face_px)
    upper = _box(labels, middle - (0.65 * apart, 0.22 * apart), middle + (0.65 * apart, 0.0))
    left = _box(labels, middle - (0.65 * apart, 0.0), middle + (0.0, 0.32 * apart))
    right = _box(labels, middle, middle + (0.65 * apart, 0.32 * apart))
    return tuple(float((box == Label.ACCESSORY).mean()) if box.size else 0.0 for box in (upper, left, right))


def _fringe_shares(labels: NDArray[np.uint8], face_px: NDArray[np.float64]) -> tuple[float, float]:
    """Return the share of hair around each eye, the image's left first."""
    middle, apart = eyes_span(face_px)
    low, high = middle - (0.65 * apart, 0.15 * apart), middle + (0.65 * apart, 0.2 * apart)
    left, right = _box(labels, low, np.array([middle[0], high[1]])), _box(labels, np.array([middle[0], low[1]]), high)
    first, second = (float((box == Label.HAIR).mean()) if box.size else 0.0 for box in (left, right))
    return first, second


def _above_the_brows(labels: NDArray[np.uint8], face_px: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the share of every label above the brows, none where there is nothing."""
    (x, _), apart = eyes_span(face_px)
    brows = float(face_px[list(_BROWS), 1].min()) - 0.2 * apart
    box = _box(labels, np.array([x - 1.2 * apart, 0.0]), np.array([x + 1.2 * apart, brows]))
    person = np.bincount(box[box > Label.BACKGROUND], minlength=len(Label))
    return np.asarray(person / max(int(person.sum()), 1))


def _box(labels: NDArray[np.uint8], low: NDArray[np.float64], high: NDArray[np.float64]) -> NDArray[np.uint8]:
    left, top = np.clip(np.round(low).astype(int), 0, None)
    right, bottom = np.clip(np.round(high).astype(int), 0, None)
    return labels[top:bottom, left:right]


def stands_barefoot(labels: NDArray[np.uint8], ankles_px: NDArray[np.float64]) -> bool:
    """Return whether what a body photo shows below the ankles is skin and not shoes.

    Parameters
    ----------
    labels : (H, W) uint8
    ankles_px : (N, 2) float64
        Both ankles, photo px; what lies below the higher one counts.
    """
    feet = labels[max(0, round(float(ankles_px[:, 1].min()))) :]
    skin, shoes = int(shows(feet, *SKINS).sum()), int(shows(feet, Label.SHOES).sum())
    return skin > BARE_FOOT * (skin + shoes)
