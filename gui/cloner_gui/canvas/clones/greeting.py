"""The clone on the printed card: it waves and smiles."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from PySide6.QtGui import QImage

from cloner.motion.face.expressions import EXPRESSIONS
from cloner.motion.moves.wave import UP_S
from cloner.records.clones import Clone
from cloner_gui.canvas.clones.acting import find_motion, with_face
from cloner_gui.canvas.clones.orbit import Orbit
from cloner_gui.canvas.clones.scene import Scene

_SMILE: Final = 0.8  # of the whole smile: friendly, no grin
#: Taste: down to the knees, so that the face is large enough to be known.
_ZOOM, _BELOW = 1.5, 0.25


def greeting_picture(clone: Clone, width_px: int, height_px: int) -> QImage:
    """Return the picture; thread-safe."""
    motion = find_motion("wave", clone)
    still = None if motion is None else replace(motion, weights={})
    smiles = {name: _SMILE * weight for name, weight in EXPRESSIONS["joy"].items()}
    near = Orbit("front").zoomed(_ZOOM).moved(0.0, _BELOW)
    scene = Scene(with_face(clone, smiles), near, motion=still, seconds=sum(UP_S[1:3]) / 2.0)
    return scene.image(width_px, height_px, fine=True)
