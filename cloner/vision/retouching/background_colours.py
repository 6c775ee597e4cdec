"""Background colours inside a mask: colours that the person has nowhere else at the same height."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import maximum_filter

from cloner.vision.retouching.repair import spread_nearest

Bools = NDArray[np.bool_]
Picture = NDArray[np.uint8]

#: Photos are looked at in this share of their size.
SCALE: Final = 0.5
#: Cells of the height, and of L, a and b of OpenCV's 8-bit Lab.
CELLS: Final = (24, 16, 32, 32)
#: Neighbours of a cell that count as the same: shade and lamps change brightness most.
ALIKE_CELLS: Final = (3, 5, 1, 1)
#: Fewer pixels of a cell in all photos are noise.
LEAST_PX: Final = 6
#: Colours are doubted as deep inside the mask as this, share of the figure (3 cm); deeper ones, or half as deep as a
#: thin limb is, are the person's.
DOUBTED, DEEP, DEEP_SHARE = 0.016, 0.015, 0.5
#: Distances outside the mask, share of the figure, at which the room is looked at; nearer ones are mixed by the lens.
OUTSIDE: Final = (0.003, 0.008)
#: Difference of 8-bit Lab from the room's colour there.
ALIKE: Final = 22.0
#: Share of a strange piece that must have the room's colours.
LEAST_TOLD: Final = 0.1
SPECK_PX: Final = 5  # doubts smaller than that are noise


@dataclass(frozen=True, slots=True, eq=False)
class ColoursByHeight:
    """Colours deep inside the masks of some photos, by height: ``known`` is (H, L, a, b) bool."""

    known: Bools

    def without_room(self, rgb: Picture, mask: Bools) -> Bools:
        """Return the mask (H, W) without pixels near its outline in colours of the adjacent background."""
        seen = _colour_cells(rgb, mask)
        if seen is None or seen.inner.all():
            return mask
        lab = cv2.cvtColor(seen.rgb, cv2.COLOR_RGB2Lab).astype(np.float32)
        strange = seen.inner & (_depth(seen.inner) < DOUBTED * seen.figure_px)
        strange[strange] = ~self.known[tuple(cell[strange] for cell in seen.cells)]
        away, alike = _depth(~seen.inner), np.zeros(strange.shape, bool)
        for share in OUTSIDE:
            outside = away > share * seen.figure_px
            if outside.any():
                room = cv2.cvtColor(spread_nearest(seen.rgb, outside), cv2.COLOR_RGB2Lab)
                alike |= np.linalg.norm(lab - room, axis=2) < ALIKE
        sure = cv2.medianBlur((strange & alike).astype(np.uint8), SPECK_PX) > 0
        # what hangs together with the room's colours and is as strange, the line around a panel, is room as well
        count, pieces = cv2.connectedComponents(strange.astype(np.uint8), connectivity=8)
        whole, sure_count = (np.bincount(pieces[part], minlength=count) for part in (strange, sure & strange))
        doubt = (sure_count > LEAST_TOLD * np.maximum(whole, 1))[pieces] & strange
        grown = cv2.dilate((doubt | sure).astype(np.uint8), np.ones((3, 3), np.uint8))
        kept = mask.copy()
        part = kept[seen.box]
        part &= cv2.resize(grown, part.shape[::-1], interpolation=cv2.INTER_NEAREST) == 0
        return kept


def colours_by_height(photos: Iterable[tuple[Picture, Bools]]) -> ColoursByHeight:
    """Return the colours of a person in photos (H, W, 3) of one framing with masks (H, W)."""
    count = np.zeros(CELLS, np.int32)
    for rgb, mask in photos:
        seen = _colour_cells(rgb, mask)
        if seen is None:
            continue
        depth = _depth(seen.inner)
        reach = 2 * int(np.ceil(2.0 * DEEP * seen.figure_px)) + 1
        thickness = cv2.dilate(depth, np.ones((reach, reach), np.uint8))
        deep = depth > np.minimum(DEEP_SHARE * thickness, DEEP * seen.figure_px)
        np.add.at(count, tuple(cell[deep] for cell in seen.cells), 1)
    return ColoursByHeight(np.asarray(maximum_filter((count >= LEAST_PX).astype(np.uint8), ALIKE_CELLS) > 0, bool))


@dataclass(frozen=True, slots=True, eq=False)
class _ColourCells:
    """The masked part of a photo at `SCALE`: its position, and each pixel's cell of height and colour."""

    box: tuple[slice, slice]
    rgb: Picture
    inner: Bools
    cells: tuple[NDArray[np.integer], ...]
    figure_px: float


def _colour_cells(rgb: Picture, mask: Bools) -> _ColourCells | None:
    """Return the colour cells of a photo (H, W, 3) with a mask (H, W), None where it is empty."""
    rows, columns = (np.flatnonzero(mask.any(axis=axis)) for axis in (1, 0))
    if not rows.size:
        return None
    air = int(2.0 * OUTSIDE[-1] * len(rows)) + 2
    box = (slice(max(rows[0] - air, 0), rows[-1] + air), slice(max(columns[0] - air, 0), columns[-1] + air))
    high, wide = mask[box].shape
    size = (round(wide * SCALE), round(high * SCALE))
    small = np.asarray(cv2.blur(cv2.resize(rgb[box], size, interpolation=cv2.INTER_AREA), (3, 3)), np.uint8)
    inner = cv2.resize(mask[box].astype(np.uint8), size, interpolation=cv2.INTER_NEAREST) > 0
    lab = cv2.cvtColor(small, cv2.COLOR_RGB2Lab)
    height = np.arange(size[1])[::-1] * CELLS[0] // size[1]
    cells = [lab[..., k].astype(np.int32) * CELLS[k + 1] // 256 for k in range(3)]
    return _ColourCells(box, small, inner, (np.broadcast_to(height[:, None], inner.shape), *cells), SCALE * len(rows))


def _depth(part: Bools) -> NDArray[np.float32]:
    return np.asarray(cv2.distanceTransform(part.astype(np.uint8), cv2.DIST_L2, 5), np.float32)
