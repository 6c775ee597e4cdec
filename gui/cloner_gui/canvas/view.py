"""A photo with its points: zoom, pan, and dragging points; the only home of the half pixel."""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QPointF, Qt, Signal
from PySide6.QtGui import (
    QContextMenuEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPainterPath,
    QPaintEvent,
    QPixmap,
    QPolygonF,
    QWheelEvent,
)
from PySide6.QtWidgets import QMenu, QWidget

from cloner.records.points import ViewPoints
from cloner_gui.canvas.painting import draw_name, draw_outline, draw_point, pixmap_of, point_colour
from cloner_gui.canvas.picking import nearest_point
from cloner_gui.words import spoken

_HALF_PX: Final = 0.5  # a pixel's centre is at 0 for us and at 0.5 for Qt
_REACH: Final = 12.0  # widget pixels around a point that still pick it; taste
_ZOOM_STEP: Final = 1.25
_ZOOM_MOST: Final = 16.0
_STEPS: Final = {
    Qt.Key.Key_Left: (-1.0, 0.0),
    Qt.Key.Key_Right: (1.0, 0.0),
    Qt.Key.Key_Up: (0.0, -1.0),
    Qt.Key.Key_Down: (0.0, 1.0),
}
_gestures = itertools.count(1)


class PhotoView(QWidget):
    """One photo with its named points.

    Left drag on a point moves it, left drag elsewhere pans, the wheel zooms,
    a double click shows all, arrow keys move the chosen point by a pixel, and
    a right click offers the proposal again.
    """

    point_moved = Signal(str, float, float, str)
    """Name, x and y in photo pixels, and the gesture that all moves of one drag share."""
    point_reset = Signal(str)
    hovered = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumSize(240, 240)
        self._pixmap = QPixmap()
        self._points: ViewPoints | None = None
        self._outline = QPainterPath()
        self._scale, self._offset = 1.0, QPointF()
        self._fitted = True
        self._hovered = self._chosen = ""
        self._gesture = ""
        self._grip = QPointF()  # from the mouse to the thing that is dragged
        self._panning = False

    def set_photo(self, rgb: NDArray[np.uint8]) -> None:
        """Show an (H, W, 3) photo, all of it."""
        self._pixmap = pixmap_of(rgb)
        self._points, self._hovered, self._chosen = None, "", ""
        self._outline = QPainterPath()
        self.show_all()

    def set_points(self, points: ViewPoints | None) -> None:
        """Show points in photo pixels; zoom and choice stay."""
        self._points = points
        self.update()

    def set_outline(self, borders_px: Iterable[NDArray[np.float64]]) -> None:
        """Show the (M, 2) closed borders of the clone, photo pixels; none shows nothing."""
        self._outline = QPainterPath()
        for border in borders_px:
            self._outline.addPolygon(QPolygonF([QPointF(x + _HALF_PX, y + _HALF_PX) for x, y in border]))
            self._outline.closeSubpath()
        self.update()

    def show_all(self) -> None:
        """Zoom so that the whole photo is seen."""
        self._fitted = True
        if not self._pixmap.isNull():
            self._scale = min(self.width() / self._pixmap.width(), self.height() / self._pixmap.height())
            left = (self.width() - self._scale * self._pixmap.width()) / 2
            top = (self.height() - self._scale * self._pixmap.height()) / 2
            self._offset = QPointF(left, top)
        self.update()

    def widget_from_photo(self, x_px: float, y_px: float) -> QPointF:
        """Return where a photo pixel is seen."""
        return self._offset + QPointF(x_px + _HALF_PX, y_px + _HALF_PX) * self._scale

    def photo_from_widget(self, at: QPointF) -> tuple[float, float]:
        """Return the photo pixel seen at a place."""
        inside = (at - self._offset) / self._scale
        return inside.x() - _HALF_PX, inside.y() - _HALF_PX

    def zoom(self, factor: float, about: QPointF) -> None:
        """Zoom and keep the place under ``about`` still."""
        least = min(self.width() / max(self._pixmap.width(), 1), self.height() / max(self._pixmap.height(), 1))
        scale = min(max(self._scale * factor, least), _ZOOM_MOST)
        self._offset = about - (about - self._offset) * (scale / self._scale)
        self._scale, self._fitted = scale, False
        self.update()

    def _name_at(self, at: QPointF) -> str:
        if self._points is None:
            return ""
        places = [self.widget_from_photo(x, y) for x, y in self._points.points_px]
        row = nearest_point(np.array([(p.x(), p.y()) for p in places]), (at.x(), at.y()), _REACH)
        return "" if row is None else self._points.names[row]

    def _place_of(self, name: str) -> tuple[float, float] | None:
        place = None if self._points is None else self._points.get(name)
        return None if place is None else (float(place[0]), float(place[1]))

    def _move(self, name: str, x_px: float, y_px: float, gesture: str) -> None:
        x_px = min(max(x_px, 0.0), self._pixmap.width() - 1.0)
        y_px = min(max(y_px, 0.0), self._pixmap.height() - 1.0)
        self.point_moved.emit(name, x_px, y_px, gesture)

    # --- events -----------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of a point, or of the photo."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        self._chosen = self._name_at(event.position())
        place = self._place_of(self._chosen)
        if place is None:
            self._panning, self._grip = True, self._offset - event.position()
        else:
            self._gesture = f"drag {next(_gestures)}"
            self._grip = self.widget_from_photo(*place) - event.position()
        self.update()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag what is held, else name the point under the mouse."""
        if self._gesture:
            self._move(self._chosen, *self.photo_from_widget(event.position() + self._grip), self._gesture)
        elif self._panning:
            self._offset, self._fitted = event.position() + self._grip, False
            self.update()
        else:
            self._hover(self._name_at(event.position()))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go."""
        self._gesture, self._panning = "", False

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Show the whole photo, unless a point was meant."""
        if not self._name_at(event.position()):
            self.show_all()

    def leaveEvent(self, event: QEvent) -> None:
        """Forget the point under the mouse."""
        self._hover("")

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom about the mouse."""
        self.zoom(_ZOOM_STEP if event.angleDelta().y() > 0 else 1.0 / _ZOOM_STEP, event.position())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Move the chosen point by one pixel, with Shift by ten."""
        place, step = self._place_of(self._chosen), _STEPS.get(Qt.Key(event.key()))
        if place is None or step is None:
            super().keyPressEvent(event)
            return
        many = 10.0 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
        self._move(self._chosen, place[0] + many * step[0], place[1] + many * step[1], "")

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer to take a correction back."""
        name = self._name_at(QPointF(event.pos()))
        if not name:
            return
        menu = QMenu(self)
        action = menu.addAction(f"Use the proposal for {spoken(name)} again")
        action.triggered.connect(lambda: self.point_reset.emit(name))
        menu.popup(event.globalPos())

    def resizeEvent(self, event: QEvent) -> None:
        """Keep showing all while nobody has zoomed."""
        if self._fitted:
            self.show_all()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw photo and points."""
        painter = QPainter(self)
        painter.fillRect(self.rect(), self.palette().dark())
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, self._scale < 2.0)
        painter.save()
        painter.translate(self._offset)
        painter.scale(self._scale, self._scale)
        painter.drawPixmap(0, 0, self._pixmap)
        draw_outline(painter, self._outline)
        painter.restore()
        if self._points is None:
            return
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        rows = zip(
            self._points.names, self._points.points_px, self._points.confidence, self._points.corrected, strict=True
        )
        for name, (x, y), confidence, fixed in rows:
            strong = name in (self._hovered, self._chosen)
            draw_point(painter, self.widget_from_photo(x, y), point_colour(confidence, bool(fixed)), strong=strong)
        named = self._hovered or self._chosen
        place = self._place_of(named)
        if place is not None:
            draw_name(painter, self.widget_from_photo(*place), spoken(named))

    def _hover(self, name: str) -> None:
        if name != self._hovered:
            self._hovered = name
            self.hovered.emit(name)
            self.update()
