"""Display of a clone in cloth: one frame during the simulation, then the loop."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Final

import numpy as np
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from cloner.booth.studio.values import Draped
from cloner.generic.layers import Layer, clone_layers
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array
from cloner.render import draw
from cloner_gui.canvas.clones.preview import Preview
from cloner_gui.canvas.clones.scene import BACKGROUND, Image, Scene

#: Between two pieces of a cutting plan, and round them: share of the width of all.
_BETWEEN: Final = 0.04


@dataclass(frozen=True, slots=True, eq=False)
class DrapedScene(Scene):
    """A clone and its garment at one time; motions and photos of a `Scene` do not apply.

    Attributes
    ----------
    draped : Draped or None
        None shows the clone alone.
    frame : int
        Of the cloth's frames.
    """

    draped: Draped | None = None
    frame: int = 0

    def picture(self, width_px: int, height_px: int, *, fine: bool) -> Image:
        """Return the (H, W, 3) picture; ``fine`` smooths its edges."""
        shown, row = self.draped, self.frame
        if shown is None:
            return super(DrapedScene, self).picture(width_px, height_px, fine=fine)
        layers = clone_layers(self.clone, shown.rotations[row])
        root = shown.root_m[row]
        places = shown.places_m[row].astype(np.float64) - root  # as the clone's own layers, which stand at home
        normals, first = vertex_normals(places, shown.faces), 0
        for count, rgb in shown.parts:
            layers.append(Layer(places, normals, shown.faces[first : first + count], colour=rgb, two_sided=True))
            first += count
        camera = self.orbit.camera(self.clone, width_px, height_px, root)
        return draw(layers, camera, shading="soft", background=BACKGROUND, supersample=2 if fine else 1)


class DrapedPreview(Preview):
    """A preview that can show cloth on its clone."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.draped: Draped | None = None
        self._per_second, self._from = 0.0, 0.0

    def show_draped(self, draped: Draped | None, per_second: float = 0.0) -> None:
        """Show cloth, None for none; a loop plays at so many frames a second."""
        self.draped, self._per_second, self._from = draped, per_second, time.monotonic()
        if per_second:
            self._film.start()
        else:
            self._film.stop()
        self.refresh()

    def scene(self) -> Scene | None:
        """Return what is seen now; None without a clone."""
        found = super().scene()
        if found is None or self.draped is None:
            return found
        frame = int((time.monotonic() - self._from) * self._per_second) % len(self.draped.places_m)
        return DrapedScene(found.clone, found.orbit, draped=self.draped, frame=frame)


class PiecesView(QWidget):
    """A garment's pieces as they are cut, side by side."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.pieces_m: tuple[Array, ...] = ()
        self.setMinimumHeight(6 * self.fontMetrics().height())

    def show_pieces(self, pieces_m: tuple[Array, ...]) -> None:
        """Show outlines (M, 2), metres."""
        self.pieces_m = pieces_m
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw all pieces in one scale."""
        if not self.pieces_m:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        wide = sum(float(np.ptp(one[:, 0])) for one in self.pieces_m)
        gap = _BETWEEN * wide
        total, high = wide + gap * (len(self.pieces_m) + 1), max(float(np.ptp(one[:, 1])) for one in self.pieces_m)
        scale = min(self.width() / total, self.height() / (high + 2 * gap))
        room = QRectF(0.0, 0.0, total * scale, high * scale)
        room.moveCenter(QRectF(self.rect()).center())
        left = room.left() + gap * scale
        painter.setPen(QPen(self.palette().text(), 1.5))
        painter.setBrush(self.palette().alternateBase())
        for one in self.pieces_m:
            low, top = float(one[:, 0].min()), float(one[:, 1].max())
            corners = [QPointF(left + (x - low) * scale, room.top() + (top - y) * scale) for x, y in one]
            painter.drawPolygon(QPolygonF(corners))
            left += (float(np.ptp(one[:, 0])) + gap) * scale
