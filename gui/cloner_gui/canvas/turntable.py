"""The finished clone, turned with the mouse."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QPointF, Qt, Signal
from PySide6.QtGui import QMouseEvent, QShowEvent, QWheelEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from cloner.errors import ClonerError
from cloner.generic.layers import Layer, clone_layers
from cloner.records.clones import Clone
from cloner.records.views import Camera
from cloner.render import draw, standard_camera
from cloner_gui.canvas.painting import pixmap_of

_RADIANS_PER_PIXEL: Final = 0.01  # taste: half a turn for a drag over 300 px
_TILT_MOST: Final = math.radians(80.0)
_ZOOM_STEP: Final = 1.15
_BACKGROUND: Final = (226, 228, 232)
_EMPTY: Final = "Press Clone: after about a minute the person stands here.\nDrag to turn, wheel to zoom."


class Turntable(QLabel):
    """Shows a clone; drag turns it, the wheel zooms."""

    failed = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setMinimumSize(240, 320)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)
        self._clone: Clone | None = None
        self._layers: list[Layer] = []
        self._framing = "front"
        self._turn, self._tilt, self._zoom = 0.0, 0.0, 1.0
        self._last: QPointF | None = None

    def set_clone(self, clone: Clone | None) -> None:
        """Show a clone from the front."""
        self._clone = clone
        self._layers = [] if clone is None else clone_layers(clone)
        self.frame("front")

    def update_clone(self, clone: Clone | None) -> None:
        """Show a clone from where the last one was seen."""
        self._clone = clone
        self._layers = [] if clone is None else clone_layers(clone)
        if self.isVisible():
            self._draw(fine=True)

    def frame(self, framing: str) -> None:
        """Show "front" (the whole person) or "face", turned to the front."""
        self._framing, self._turn, self._tilt, self._zoom = framing, 0.0, 0.0, 1.0
        self._draw(fine=True)

    def turn(self, turn: float, tilt: float) -> None:
        """Turn the clone on, radians."""
        self._turn += turn
        self._tilt = min(max(self._tilt + tilt, -_TILT_MOST), _TILT_MOST)
        self._draw(fine=False)

    def camera(self, clone: Clone, width_px: int, height_px: int) -> Camera:
        """Return the camera that sees the turned clone."""
        first = standard_camera(clone, self._framing, width_px, height_px)
        pivot = _point_ahead(first)
        matrix = first.camera_from_model @ _shift(pivot) @ _turned(self._turn, self._tilt) @ _shift(-pivot)
        return replace(first, camera_from_model=matrix, focal_px=first.focal_px * self._zoom)

    def _draw(self, *, fine: bool) -> None:
        if self._clone is None:
            self.setText(_EMPTY)
            return
        camera = self.camera(self._clone, max(self.width(), 64), max(self.height(), 64))
        try:
            picture = draw(self._layers, camera, shading="soft", background=_BACKGROUND, supersample=2 if fine else 1)
        except ClonerError as error:
            self._clone = None
            self.setText("This machine cannot draw in 3-D")
            self.failed.emit(error)
            return
        self.setPixmap(pixmap_of(picture))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of the clone."""
        self._last = event.position()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Turn the clone with the mouse."""
        if self._last is not None:
            way = event.position() - self._last
            self._last = event.position()
            self.turn(_RADIANS_PER_PIXEL * way.x(), _RADIANS_PER_PIXEL * way.y())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go, and draw once more with smooth edges."""
        self._last = None
        self._draw(fine=True)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom."""
        self._zoom = min(max(self._zoom * (_ZOOM_STEP if event.angleDelta().y() > 0 else 1 / _ZOOM_STEP), 0.5), 8.0)
        self._draw(fine=True)

    def showEvent(self, event: QShowEvent) -> None:
        """Draw what changed while nobody looked."""
        super().showEvent(event)
        self._draw(fine=True)

    def resizeEvent(self, event: QEvent) -> None:
        """Draw at the new size."""
        self._draw(fine=True)


def _point_ahead(camera: Camera) -> NDArray[np.float64]:
    """Return the point of the model's vertical axis that the camera looks at, (3,) metres."""
    eye, forward = camera.position_m, camera.camera_from_model[2, :3]
    reach = -(eye[0] * forward[0] + eye[2] * forward[2]) / max(forward[0] ** 2 + forward[2] ** 2, 1e-9)
    return np.array([0.0, eye[1] + reach * forward[1], 0.0])


def _shift(by: NDArray[np.float64]) -> NDArray[np.float64]:
    matrix = np.eye(4)
    matrix[:3, 3] = by
    return matrix


def _turned(turn: float, tilt: float) -> NDArray[np.float64]:
    """Return a turn about the vertical axis, then a tilt about the picture's horizontal one."""
    cosine, sine = math.cos(turn), math.sin(turn)
    around = np.array([[cosine, 0, sine, 0], [0, 1, 0, 0], [-sine, 0, cosine, 0], [0, 0, 0, 1.0]])
    cosine, sine = math.cos(tilt), math.sin(tilt)
    over = np.array([[1, 0, 0, 0], [0, cosine, -sine, 0], [0, sine, cosine, 0], [0, 0, 0, 1.0]])
    return np.asarray(over @ around)
