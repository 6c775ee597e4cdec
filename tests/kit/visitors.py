"""The sample visitors and the truth that belongs to them."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.vision.photographs.pictures import Picture, read_picture

SAMPLES = Path(__file__).resolve().parents[2] / "samples"
NAMES = ("anna", "boris")
SETS = ("plain", "booth", "handheld")
VIEWS = ("body_front", "body_side", "body_back", "face_front", "face_side")


def visitor_folder(name: str, set_name: str | None = None) -> Path:
    """Return samples/NAME, or the folder of one of its sets of five photos."""
    folder = SAMPLES / name
    return folder if set_name is None else folder / set_name


@lru_cache(maxsize=6)
def photo(name: str, set_name: str, view: str) -> Picture:
    """Return one decoded photo of a visitor."""
    return read_picture(visitor_folder(name, set_name) / f"{view}.jpg")


def truth_mask(name: str, set_name: str, view: str) -> NDArray[np.bool_]:
    """Return (H, W) bool: where the dressed person truly is, at the photo's size."""
    prefix = "truth_handheld_mask" if set_name == "handheld" else "truth_mask"
    image = cv2.imread(str(SAMPLES / name / f"{prefix}_{view}.png"), cv2.IMREAD_GRAYSCALE)
    assert image is not None, f"no truth mask for {name} {set_name} {view}"
    return np.asarray(image > 127)


def overlap(first: NDArray[np.bool_], second: NDArray[np.bool_]) -> float:
    """Return the intersection over union."""
    return float((first & second).sum() / max(int((first | second).sum()), 1))
