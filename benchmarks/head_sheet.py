"""Contact sheet of a clone's head: around, from above and below, smiling, blinking, mouth open.

    python benchmarks/head_sheet.py RESULT [RESULT …] --out docs/pictures/head_sheet_NAME.png

RESULT is a folder that `cloner clone` made, or its clone.npz. Several stand one below the other.
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.generic.layers import clone_layers
from cloner.generic.load import load_generic
from cloner.generic.morphs import target_offsets
from cloner.geometry.cameras.viewpoints import FOCAL_PER_LONG_SIDE, look_at
from cloner.picture import load_clone_at
from cloner.records.clones import Clone
from cloner.records.views import Camera
from cloner.render import draw

#: Cell: name, azimuth and elevation in degrees, weights of face targets.
SMILE = {f"{name}{side}": weight for side in ("Left", "Right") for name, weight in
         (("mouthSmile", 0.8), ("cheekSquint", 0.5), ("mouthUpperUp", 0.25), ("mouthLowerDown", 0.2))}  # fmt: skip
BLINK = {"eyeBlinkLeft": 1.0, "eyeBlinkRight": 1.0}
CELLS: tuple[tuple[str, float, float, dict[str, float]], ...] = (
    ("front", 0.0, 0.0, {}), ("30", 30.0, 0.0, {}), ("60", 60.0, 0.0, {}), ("90", 90.0, 0.0, {}),
    ("back", 180.0, 0.0, {}), ("above", 0.0, 40.0, {}), ("below", 0.0, -35.0, {}), ("smiling", 0.0, 0.0, SMILE),
    ("blinking", 20.0, 0.0, BLINK), ("mouth open", 15.0, 0.0, {"jawOpen": 0.7}),
)  # fmt: skip
COLUMNS = 5
CELL_PX = (360, 450)
BACKDROP = (226, 228, 230)


def morphed(clone: Clone, weights: dict[str, float]) -> Clone:
    """Return the clone with face targets in its rest shape."""
    vertices = clone.vertices_m.copy()
    for name, offsets in target_offsets(clone):
        vertices += weights.get(name, 0.0) * offsets[:-1]
    return replace(clone, vertices_m=vertices)


def head_camera(clone: Clone, azimuth_deg: float, elevation_deg: float, size: tuple[int, int]) -> Camera:
    """Return a camera on the whole head with its hair; the head fills the same part of every cell."""
    generic = load_generic()
    head = clone.vertices_m[generic.vertex_segment == generic.segment_names.index("head")]
    middle = (head.min(axis=0) + head.max(axis=0)) / 2.0
    azimuth, elevation = np.radians([azimuth_deg, elevation_deg])
    outward = np.array([np.sin(azimuth) * np.cos(elevation), np.sin(elevation), np.cos(azimuth) * np.cos(elevation)])
    focal = FOCAL_PER_LONG_SIDE * max(size)
    distance = focal * 1.45 * float(np.ptp(head[:, 1])) / size[1]
    return Camera(size[0], size[1], focal, look_at(middle + distance * outward, middle))


def cell(clone: Clone, azimuth_deg: float, elevation_deg: float, weights: dict[str, float],
         size: tuple[int, int] = CELL_PX) -> NDArray[np.uint8]:  # fmt: skip
    """Return one picture of the head, softly lit."""
    camera = head_camera(clone, azimuth_deg, elevation_deg, size)
    return draw(clone_layers(morphed(clone, weights)), camera, background=BACKDROP, shading="soft")


def sheet(clone: Clone, size: tuple[int, int] = CELL_PX) -> NDArray[np.uint8]:
    """Return all cells, two rows of five, each with its name."""
    tiles = []
    for name, azimuth, elevation, weights in CELLS:
        tile = np.ascontiguousarray(cell(clone, azimuth, elevation, weights, size))
        cv2.putText(tile, name, (10, 24), cv2.FONT_HERSHEY_SIMPLEX, 0.6, (90, 90, 90), 1, cv2.LINE_AA)
        tiles.append(tile)
    rows = [np.hstack(tiles[k : k + COLUMNS]) for k in range(0, len(tiles), COLUMNS)]
    return np.vstack(rows)


def main() -> None:
    """Draw the sheet of every result, one below the other."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=Path, nargs="+")
    parser.add_argument("--out", type=Path, required=True)
    options = parser.parse_args()
    picture = np.vstack([sheet(load_clone_at(path)) for path in options.results])
    options.out.parent.mkdir(parents=True, exist_ok=True)
    cv2.imwrite(str(options.out), picture[..., ::-1])


if __name__ == "__main__":
    main()
