"""Everything that determines a picture of the clone, as one value that another thread can draw."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from PySide6.QtGui import QImage

from cloner.frames import ViewId
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.motions import Motion
from cloner.render import Shading, coverage, draw
from cloner_gui.canvas.clones.acting import OUTLINE, display_meshes, pose_at
from cloner_gui.canvas.clones.orbit import Orbit, photo_camera
from cloner_gui.canvas.photos.painting import to_qimage

Image = NDArray[np.uint8]

BACKGROUND: Final = (226, 228, 232)
_FIGURE: Final = (196, 208, 226)
_LINE: Final = (58, 96, 168)
_LINE_SHARE: Final = 0.006  # of the picture's height
_SHADINGS: Final[dict[str, Shading]] = {"wire": "wire"}


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """A clone as shown at one time.

    Attributes
    ----------
    clone : Clone
    orbit : Orbit
    mode : str
        One of `cloner_gui.canvas.clones.acting.MODES`.
    motion : Motion or None
        What the clone does; None stands at rest.
    seconds : float
        Since when it does that.
    gaps_mm : (V,) or None
        Distances that the mode "gaps" paints.
    overlay : (ViewId, (H, W, 3) uint8) or None
        Photo that the clone is laid over, through that photo's camera.
    opacity : float
        Share 0..1 by which the clone covers the photo.
    """

    clone: Clone
    orbit: Orbit
    mode: str = "textured"
    motion: Motion | None = None
    seconds: float = 0.0
    gaps_mm: Array | None = None
    overlay: tuple[ViewId, Image] | None = None
    opacity: float = 1.0

    def image(self, width_px: int, height_px: int, *, fine: bool) -> QImage:
        """Return the picture as the window shows it."""
        return to_qimage(self.picture(width_px, height_px, fine=fine))

    def picture(self, width_px: int, height_px: int, *, fine: bool) -> Image:
        """Return the (H, W, 3) picture; ``fine`` smooths its edges.

        Raises
        ------
        ClonerError
            If the picture is too large.
        """
        samples = 2 if fine else 1
        if self.overlay is not None and self.overlay[0] in self.clone.views:
            return self._over_photo(self.overlay[0], self.overlay[1], (width_px, height_px), samples)
        posed, rotations, root_m = pose_at(self.clone, self.motion, self.seconds)
        layers = display_meshes(posed, rotations, self.mode, self.gaps_mm)
        camera = self.orbit.camera(self.clone, width_px, height_px, root_m)
        if self.mode == OUTLINE:
            return _outlined(coverage(layers, camera, supersample=2))
        shading = _SHADINGS.get(self.mode, "soft")
        return draw(layers, camera, shading=shading, background=BACKGROUND, supersample=samples)

    def _over_photo(self, view: ViewId, photo: Image, size_px: tuple[int, int], samples: int) -> Image:
        seen = self.clone.views[view]
        layers = display_meshes(self.clone, seen.rotations, self.mode, self.gaps_mm)
        camera, below = photo_camera(seen.camera, photo, *size_px)
        drawn = draw(layers, camera, shading=_SHADINGS.get(self.mode, "photo"), supersample=samples)
        share = self.opacity * coverage(layers, camera, supersample=samples)[..., None]
        return np.asarray(np.round(share * drawn + (1.0 - share) * below), dtype=np.uint8)


def _outlined(cover: Array) -> Image:
    """Return a figure drawn from the share (H, W) that a body covers: flat within its outline, nothing else of it."""
    wide = max(round(_LINE_SHARE * cover.shape[0]), 2)
    thick = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * wide + 1, 2 * wide + 1))
    line = np.clip(cv2.dilate(cover, thick) - cover, 0.0, 1.0)[..., None]
    inside = cover[..., None]
    paper = np.array(BACKGROUND, dtype=np.float64) * (1.0 - inside) + np.array(_FIGURE) * inside
    return np.asarray(np.round(paper * (1.0 - line) + np.array(_LINE) * line), dtype=np.uint8)
