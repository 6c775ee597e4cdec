"""Draw the sample people's clones for the visitors' screen: python gui/build_attract.py anna=RESULT boris=RESULT.

Each RESULT is the folder of a clone that `cloner clone samples/NAME/plain` made. Writes one sheet a person, the sides
of a whole turn beside and below each other, into ``cloner_gui/pictures``; `cloner_gui.canvas.clones.attract` shows
them.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from PIL import Image

from cloner.generic.framing import standard_camera
from cloner.generic.layers import clone_layers
from cloner.project.clone_file import CLONE_FILE, load_clone
from cloner.render import draw
from cloner_gui.canvas.clones.attract import ACROSS, DOWN, PICTURES, SIDE_PX

_BACKGROUND = (226, 228, 232)  # as the preview's
_QUALITY = 80


def main(arguments: Sequence[str]) -> None:
    """Draw every NAME=RESULT."""
    for one in arguments:
        name, _, result = one.partition("=")
        sheet(Path(result)).save(PICTURES / f"turn_{name}.jpg", quality=_QUALITY)


def sheet(result: Path) -> Image.Image:
    """Return all sides of a clone in one picture."""
    clone = load_clone(result / CLONE_FILE)
    layers, camera = clone_layers(clone, None), standard_camera(clone, "front", *SIDE_PX)
    whole = Image.new("RGB", (ACROSS * SIDE_PX[0], DOWN * SIDE_PX[1]))
    for number in range(ACROSS * DOWN):
        angle = 2.0 * math.pi * number / (ACROSS * DOWN)
        cosine, sine = math.cos(angle), math.sin(angle)
        turn = np.array([[cosine, 0, sine, 0], [0, 1, 0, 0], [-sine, 0, cosine, 0], [0, 0, 0, 1.0]])
        seen = replace(camera, camera_from_model=camera.camera_from_model @ turn)
        side = Image.fromarray(draw(layers, seen, background=_BACKGROUND, supersample=2))
        whole.paste(side, (number % ACROSS * SIDE_PX[0], number // ACROSS * SIDE_PX[1]))
    return whole


if __name__ == "__main__":
    main(sys.argv[1:])
