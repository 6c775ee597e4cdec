"""A photo with its points and outlines: zoom, pan, and dragging points and pieces of outline."""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QPointF, QSizeF, Qt, Signal
from PySide6.QtGui import (
    QContextMenuEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPainterPath,
    QPaintEvent,
    QPixmap,
    QTouchEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QMenu, QWidget

from cloner.records.points import ANCHOR, ViewPoints
from cloner_gui.canvas.photos import painting
from cloner_gui.canvas.photos.keys import press, press_tab
from cloner_gui.canvas.photos.lens import ZOOM_STEP, Lens
from cloner_gui.canvas.photos.overlay import paint_close_up, paint_outlines, paint_points
from cloner_gui.canvas.photos.picking import nearest_on_outline, nearest_point
from cloner_gui.canvas.photos.touch import TouchHand
from cloner_gui.language.point_names import point_label

Borders = tuple[NDArray[np.float64], ...]

_NEAR: Final = 1.8  # a point that is gone to is seen with the half of all points around it; taste
_REACH: Final = 12.0  # widget pixels around a point that still pick it; taste
_TOUCH_REACH: Final = 28.0  # the same for a finger: half its tip
_OUTLINE_REACH: Final = 6.0  # widget pixels beside the outline that still take hold of it; taste
_gestures = itertools.count(1)


class PhotoView(QWidget):
    """One photo with its named points and its outlines.

    Left drag on a point moves it, on the photo's outline pulls that piece along, elsewhere pans; middle drag always
    pans; the wheel zooms, a double click or Home shows all; Tab asks for the next point, arrow keys move the chosen
    one by a pixel, with Shift by ten; Insert puts a point on the outline, Delete takes a correction back, and so does
    a right click. One finger does what the left button does, two fingers zoom and pan.
    """

    point_moved = Signal(str, float, float, str)
    """Name, x and y in photo pixels, and the gesture that all moves of one drag share."""
    point_reset = Signal(str)
    hovered = Signal(str)
    chosen_changed = Signal(str)
    next_wanted = Signal(int)
    """+1 for the next point, -1 for the one before."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMouseTracking(True)
        self.setAttribute(Qt.WidgetAttribute.WA_AcceptTouchEvents)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumSize(200, 200)
        self.lens = Lens()
        self.anchor_name = ""  # name of the outline point that pulling the outline makes; "" allows none
        self.points: ViewPoints | None = None
        self._rgb: NDArray[np.uint8] | None = None
        self._pixmap, self._scaled = QPixmap(), painting.ScaledPhoto()
        self.outline_px: Borders = ()
        self._clone, self._outline = QPainterPath(), QPainterPath()
        self._hovered = self.chosen = self._gesture = ""
        self._grip = QPointF()  # from the mouse to the thing that is dragged
        self._panning = self._close_up = False
        self._touch = TouchHand(self)

    # --- what is shown -------------------------------------------------------

    def set_photo(self, rgb: NDArray[np.uint8]) -> None:
        """Show an (H, W, 3) photo, all of it."""
        self._rgb, self._pixmap = rgb, QPixmap()
        self.points, self._hovered, self.chosen = None, "", ""
        self.outline_px, self._clone, self._outline = (), QPainterPath(), QPainterPath()
        self.lens = Lens(QSizeF(rgb.shape[1], rgb.shape[0]), QSizeF(self.size()))
        self.show_all()

    def set_points(self, points: ViewPoints | None) -> None:
        """Show points in photo pixels; zoom and choice stay."""
        self.points = points
        self.update()

    def set_clone_outline(self, borders_px: Iterable[NDArray[np.float64]]) -> None:
        """Show the (M, 2) closed borders of the clone, photo pixels; none shows nothing."""
        self._clone = painting.to_painter_path(borders_px)
        self.update()

    def set_outline(self, borders_px: Borders) -> None:
        """Show the (M, 2) closed borders of the person as linked in the photo, photo pixels."""
        self.outline_px, self._outline = borders_px, painting.to_painter_path(borders_px)
        self.update()

    def show_all(self) -> None:
        """Zoom so that the whole photo is seen."""
        self.lens.show_all()
        self.update()

    def zoom(self, factor: float, about: QPointF) -> None:
        """Zoom and keep the place under ``about`` still."""
        self.lens.zoom(factor, about)
        self.update()

    def pinch(self, move: QPointF, factor: float, about: QPointF) -> None:
        """Pan, and zoom about a place."""
        self.lens.pan(self.lens.offset + move)
        self.zoom(factor, about)

    def choose(self, name: str, *, close: bool = False) -> None:
        """Choose a point by name, "" for none; ``close`` brings it to the middle, large."""
        self.chosen, self._close_up = name, False
        place = self._place_of(name)
        if close and place is not None and self.points is not None:
            spread = float(np.ptp(self.points.points_px, axis=0).max()) if len(self.points.names) > 1 else 400.0
            self.lens.look_at(*place, _NEAR * min(self.width(), self.height()) / max(spread, 100.0))
        self.chosen_changed.emit(name)
        self.update()

    # --- hand ------------------------------------------------------------------

    def take_hold(self, at: QPointF, *, finger: bool = False) -> None:
        """Take hold of the point at a place, else of the outline, else of the photo."""
        reach = _TOUCH_REACH if finger else _REACH
        name = self._name_at(at, reach)
        place = self._place_of(name)
        if place is None:
            place = self._outline_at(at, reach if finger else _OUTLINE_REACH)
            name = self.anchor_name if place is not None else ""
        if name != self.chosen:
            self.choose(name)
        if place is None:
            self._panning, self._grip = True, self.lens.offset - at
        else:
            self._gesture = f"drag {next(_gestures)}"
            self._grip = self.lens.widget_from_photo(*place) - at
        self.update()

    def drag(self, to: QPointF) -> None:
        """Move what is held."""
        if self._gesture:
            self._close_up = True
            self._move(self.chosen, *self.lens.photo_from_widget(to + self._grip), self._gesture)
        elif self._panning:
            self.lens.pan(to + self._grip)
            self.update()

    def let_go(self) -> None:
        """Hold nothing any more."""
        self._gesture, self._panning, self._close_up = "", False, False
        self.update()

    def nudge(self, x_px: float, y_px: float) -> bool:
        """Move the chosen point by so many photo pixels; False when none is chosen."""
        place = self.chosen_place()
        if place is None:
            return False
        self._close_up = True
        self._move(self.chosen, place[0] + x_px, place[1] + y_px, "")
        return True

    def chosen_place(self) -> tuple[float, float] | None:
        """Return the pixel of the chosen point, None without one."""
        return self._place_of(self.chosen)

    def attention(self) -> QPointF:
        """Return the widget's place that keys are about: the chosen point, else the middle."""
        place = self.chosen_place()
        return QPointF(self.rect().center()) if place is None else self.lens.widget_from_photo(*place)

    def add_anchor(self, at: QPointF) -> None:
        """Put a point on the outline, at the place nearest to ``at``."""
        place = self._outline_at(at, 1e6)
        if place is not None:
            name = self.anchor_name
            self._move(name, *place, "")
            self.choose(name)

    def _name_at(self, at: QPointF, reach: float = _REACH) -> str:
        if self.points is None:
            return ""
        places = [self.lens.widget_from_photo(x, y).toTuple() for x, y in self.points.points_px]
        row = nearest_point(np.array(places).reshape(-1, 2), (at.x(), at.y()), reach)
        return "" if row is None else self.points.names[row]

    def _outline_at(self, at: QPointF, reach: float) -> tuple[float, float] | None:
        if not self.anchor_name:
            return None
        place = nearest_on_outline(self.outline_px, self.lens.photo_from_widget(at), reach / self.lens.scale)
        return None if place is None else (float(place[0]), float(place[1]))

    def _place_of(self, name: str) -> tuple[float, float] | None:
        place = None if self.points is None else self.points.get(name)
        return None if place is None else (float(place[0]), float(place[1]))

    def _move(self, name: str, x_px: float, y_px: float, gesture: str) -> None:
        x_px = min(max(x_px, 0.0), self.lens.photo.width() - 1.0)
        y_px = min(max(y_px, 0.0), self.lens.photo.height() - 1.0)
        self.point_moved.emit(name, x_px, y_px, gesture)

    # --- events -----------------------------------------------------------------

    def event(self, event: QEvent) -> bool:
        """Take fingers, and Tab, which Qt would keep for itself."""
        if isinstance(event, QTouchEvent):
            self._touch.feel(event)
            return True
        if event.type() == QEvent.Type.KeyPress and isinstance(event, QKeyEvent) and press_tab(self, event):
            return True
        return super().event(event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of a point, of the outline, or of the photo."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.take_hold(event.position())
        elif event.button() == Qt.MouseButton.MiddleButton:
            self._panning, self._grip = True, self.lens.offset - event.position()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag what is held, else name the point under the mouse."""
        if self._gesture or self._panning:
            self.drag(event.position())
            return
        self._hover(self._name_at(event.position()))
        holds = self._hovered or self._outline_at(event.position(), _OUTLINE_REACH)
        self.setCursor(Qt.CursorShape.SizeAllCursor if holds else Qt.CursorShape.ArrowCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go."""
        self.let_go()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Show the whole photo, unless a point was meant."""
        if not self._name_at(event.position()):
            self.show_all()

    def leaveEvent(self, event: QEvent) -> None:
        """Forget the point under the mouse."""
        self._hover("")

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom about the mouse."""
        self.zoom(ZOOM_STEP if event.angleDelta().y() > 0 else 1.0 / ZOOM_STEP, event.position())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Do what a key says."""
        if not press(self, event):
            super().keyPressEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer to take a correction back, or to put a point on the outline."""
        at = QPointF(event.pos())
        name = self._name_at(at)
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        if name.startswith(ANCHOR):
            menu.addAction(self.tr("Remove this outline point")).triggered.connect(lambda: self.point_reset.emit(name))
        elif name:
            text = self.tr("Use the proposal for %1 again").replace("%1", point_label(name))
            menu.addAction(text).triggered.connect(lambda: self.point_reset.emit(name))
        elif self._outline_at(at, _REACH) is not None:
            menu.addAction(self.tr("Add an outline point here")).triggered.connect(lambda: self.add_anchor(at))
        if menu.actions():
            menu.popup(event.globalPos())
        else:
            menu.deleteLater()

    def resizeEvent(self, event: QEvent) -> None:
        """Keep showing all while nobody has zoomed, else the same place in the middle."""
        self.lens.resize(QSizeF(self.size()))

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw photo, outlines, points, and what is being done."""
        painter = QPainter(self)
        painter.fillRect(self.rect(), self.palette().dark())
        if self._pixmap.isNull() and self._rgb is not None:
            self._pixmap = painting.to_pixmap(self._rgb)  # when it is first seen: five at once hold the window up
        self._scaled.draw(painter, self._pixmap, self.lens, self.devicePixelRatioF())
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        outlines = [(self._clone, painting.CLONE), (self._outline, painting.LINKED)]
        paint_outlines(painter, self.lens, outlines)
        if self.points is not None:
            paint_points(painter, self.lens, self.points, self.chosen, self._hovered)
        place = self.chosen_place()
        if self._close_up and place is not None:
            paint_close_up(painter, self.lens, self._pixmap, outlines, place)

    def _hover(self, name: str) -> None:
        if name != self._hovered:
            self._hovered = name
            self.hovered.emit(name)
            self.update()
