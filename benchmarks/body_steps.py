"""Draw one person after every step of the body: ``python benchmarks/body_steps.py samples/boris/plain``.

Writes ``docs/pictures/body_steps.png``: the clay body through the front and side photos' cameras with the outline
that was found in the photo; blue where the body lies outside of it, red where it does not fill it.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Final

import cv2
import numpy as np
from body_people import ALL_STAGES, finished_clone, step_clones
from body_pictures import captioned, clay, cropped
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.records.bodies import PosedView
from cloner.records.clones import Clone
from cloner.render import draw, render_mask
from cloner.testing import folder_values, run_stages

OUT: Final = Path(__file__).resolve().parents[1] / "docs" / "pictures" / "body_steps.png"
VIEWS: Final = (ViewId.BODY_FRONT, ViewId.BODY_SIDE)
_OUTSIDE: Final = (50, 90, 255)
_UNFILLED: Final = (230, 40, 40)


def panel(clone: Clone, posed: PosedView, wanted: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """Return the clay body in a photo's pose over the silhouette found there."""
    picture = draw(clay(clone, posed.rotations), posed.camera, shading="soft")
    covered = render_mask(clone, posed.camera, posed.rotations)
    for region, colour in ((covered & ~wanted, _OUTSIDE), (wanted & ~covered, _UNFILLED)):
        picture[region] = (0.35 * picture[region] + 0.65 * np.array(colour)).astype(np.uint8)
    lines, _ = cv2.findContours(wanted.astype(np.uint8), cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
    cv2.drawContours(picture, lines, -1, (20, 130, 40), 2)
    return cropped(picture, wanted)


def overlap(clone: Clone, posed: PosedView, wanted: NDArray[np.bool_]) -> float:
    """Return the IoU of a body with the silhouette found in the photo."""
    covered = render_mask(clone, posed.camera, posed.rotations)
    return float((covered & wanted).sum() / (covered | wanted).sum())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("photos", type=Path)
    folder = parser.parse_args().photos
    values, _ = run_stages(folder_values(folder), ALL_STAGES)
    clones = step_clones(values, load_generic()) | {"finished": finished_clone(values)}
    columns = []
    for name, clone in clones.items():
        seen = [(clone.views[view], values["silhouettes"].views[view].mask) for view in VIEWS]
        words = f"{name}  " + "  ".join(f"{overlap(clone, *one):.3f}" for one in seen)
        columns.append(captioned(np.hstack([panel(clone, *one) for one in seen]), words))
    rows = [np.hstack(columns[:3]), np.hstack(columns[3:])]
    cv2.imwrite(str(OUT), np.vstack(rows)[..., ::-1])
    print(OUT)


if __name__ == "__main__":
    main()
