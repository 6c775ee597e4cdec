"""Keyboard handling on a photo."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QKeyEvent

from cloner_gui.canvas.photos.lens import ZOOM_STEP

if TYPE_CHECKING:
    from cloner_gui.canvas.photos.view import PhotoView

_STEPS: Final = {
    Qt.Key.Key_Left: (-1.0, 0.0),
    Qt.Key.Key_Right: (1.0, 0.0),
    Qt.Key.Key_Up: (0.0, -1.0),
    Qt.Key.Key_Down: (0.0, 1.0),
}
_MANY: Final = 10.0  # pixels that an arrow key with Shift moves a point
_PAN: Final = 40.0  # widget pixels that an arrow key moves the photo; taste
_ZOOM: Final = {Qt.Key.Key_Plus: ZOOM_STEP, Qt.Key.Key_Equal: ZOOM_STEP, Qt.Key.Key_Minus: 1.0 / ZOOM_STEP}


def press_tab(view: PhotoView, event: QKeyEvent) -> bool:
    """Select the next point, with Shift the previous one; Control and Tab leave the photo. Return whether the key was
    handled.
    """
    step = {Qt.Key.Key_Tab: 1, Qt.Key.Key_Backtab: -1}.get(Qt.Key(event.key()))
    if step is None or view.points is None or event.modifiers() & Qt.KeyboardModifier.ControlModifier:
        return False
    view.next_wanted.emit(step)
    return True


def press(view: PhotoView, event: QKeyEvent) -> bool:
    """Move the selected point or the photo, zoom, add and remove; return whether the key was handled."""
    key = Qt.Key(event.key())
    if key in _STEPS:
        x, y = _STEPS[key]
        many = _MANY if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
        if not view.nudge(many * x, many * y):
            view.lens.pan(view.lens.offset - QPointF(x, y) * _PAN)
            view.update()
    elif key in _ZOOM:
        view.zoom(_ZOOM[key], view.attention())
    elif key == Qt.Key.Key_Home:
        view.show_all()
    elif key == Qt.Key.Key_Insert:
        view.add_anchor(view.attention())
    elif key in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace) and view.chosen:
        view.point_reset.emit(view.chosen)
    elif key == Qt.Key.Key_Escape and view.chosen:
        view.choose("")
    else:
        return False
    return True
