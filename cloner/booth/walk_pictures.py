"""Walking clones for the visitors' screen: transparent pictures of one walk cycle.

They lie in the visitor's own folder and go with it: nobody is in the crowd who was forgotten.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from PIL.PngImagePlugin import PngInfo

from cloner.booth.visitors.cached_work import CLONE_FILE
from cloner.booth.worker import Progress
from cloner.errors import ClonerError
from cloner.project.atomic import atomic_file
from cloner.project.clone_file import load_clone
from cloner.records.clones import Clone

#: Not beside the photos, where every picture counts as one.
FILE: Final = "stage/stroll.png"
FRAMES: Final = 12  # of the two steps of a walk, beside each other: 12 a second look like walking
#: Width and height of a picture, px: a walker on a screen of 1080 lines that is a third as high as it (taste).
SIZE_PX: Final = (240, 400)
AZIMUTH_DEG: Final = 55.0  # taste: the face is seen, and where the walker goes
#: What the file tells besides: the walker's pace, the height of the picture, and at which share of it the feet stand.
PACE, HIGH, GROUND = "metres_a_second", "metres_high", "ground"


def read_walk_pictures(visitor: Path, result: Path) -> Path | None:
    """Return the pictures of a visitor's walk; None if there are none of the present clone."""
    path, made = visitor / FILE, result / CLONE_FILE
    known = path.is_file() and made.is_file() and path.stat().st_mtime >= made.stat().st_mtime
    return path if known else None


def draw_walk_pictures(visitor: Path, result: Path, progress: Progress) -> Path:
    """Draw a visitor's walking clone and return the file.

    Raises
    ------
    ClonerError
        If there is no clone, or it cannot be drawn or written.
    """
    clone = load_clone(result / CLONE_FILE)
    text = PngInfo()
    whole, facts = _strip(clone, progress)
    for key, value in facts.items():
        text.add_text(key, f"{value:.4f}")
    try:
        (visitor / FILE).parent.mkdir(exist_ok=True)
        with atomic_file(visitor / FILE) as temporary:
            Image.fromarray(whole).save(temporary, format="PNG", pnginfo=text)
    except OSError as error:
        raise ClonerError("it cannot be written there", "Check the folder and its space", visitor.name) from error
    return visitor / FILE


def _strip(clone: Clone, progress: Progress) -> tuple[NDArray[np.uint8], dict[str, float]]:
    """Return the (H, W * FRAMES, 4) pictures, and their description in the file."""
    # drawing and scipy: the window knows where the pictures lie from its start, and draws none
    from cloner.generic.layers import clone_layers
    from cloner.geometry.cameras.viewpoints import framing_camera
    from cloner.motion.moves.own import own_motions
    from cloner.render import draw_rgba

    motion = own_motions(clone)[0]
    frames = np.linspace(0, len(motion.times_s) - 1, FRAMES, endpoint=False).round().astype(int)
    posed = [clone_layers(clone, motion.rotations[frame]) for frame in frames]
    points = np.vstack([layer.vertices_m for layers in posed for layer in layers])
    camera = framing_camera(points, AZIMUTH_DEG, *SIZE_PX)
    sides = []
    for number, layers in enumerate(posed):
        progress("previews", number / FRAMES)
        sides.append(draw_rgba(layers, camera, supersample=2))
    below = np.array([[0.0, points[:, 1].min(), 0.0]])
    facts = {
        PACE: motion.speed_m_s * float(np.sin(np.radians(AZIMUTH_DEG))),
        HIGH: float(SIZE_PX[1] * camera.metres_per_pixel(points.mean(axis=0))),
        GROUND: float(camera.project(below)[0, 1] / SIZE_PX[1]),
    }
    return np.hstack(sides), facts
