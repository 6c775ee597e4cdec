"""Scale and position of a photo in a widget; the only module that knows the half pixel."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, QSizeF

HALF_PX: Final = 0.5  # a pixel's centre is at 0 for us and at 0.5 for Qt
ZOOM_STEP: Final = 1.25
ZOOM_MOST: Final = 16.0


class Lens:
    """Scale and position of a photo inside a widget; ``fitted`` while all of it is shown.

    Parameters
    ----------
    photo, widget : QSizeF
        Sizes, photo pixels and widget pixels.
    """

    def __init__(self, photo: QSizeF | None = None, widget: QSizeF | None = None) -> None:
        self.photo, self.widget = photo or QSizeF(), widget or QSizeF()
        self.scale, self.offset, self.fitted = 1.0, QPointF(), True

    def show_all(self) -> None:
        """Show the whole photo in the middle."""
        self.fitted = True
        if not self.photo.isEmpty() and not self.widget.isEmpty():
            self.scale = self._least()
            left = (self.widget.width() - self.scale * self.photo.width()) / 2
            top = (self.widget.height() - self.scale * self.photo.height()) / 2
            self.offset = QPointF(left, top)

    def resize(self, widget: QSizeF) -> None:
        """Keep showing all, or the same place in the middle."""
        middle = self.photo_from_widget(QPointF(self.widget.width() / 2, self.widget.height() / 2))
        self.widget = widget
        if self.fitted:
            self.show_all()
        else:
            self.look_at(*middle)

    def zoom(self, factor: float, about: QPointF) -> None:
        """Zoom and keep the place under ``about`` still."""
        scale = min(max(self.scale * factor, self._least()), ZOOM_MOST)
        self.offset = about - (about - self.offset) * (scale / self.scale)
        self.scale, self.fitted = scale, False

    def pan(self, offset: QPointF) -> None:
        """Put the photo's corner elsewhere; a part of the photo always stays in sight."""
        margin = 40.0
        low_x, low_y = (margin - self.scale * side for side in (self.photo.width(), self.photo.height()))
        x = min(max(offset.x(), low_x), self.widget.width() - margin)
        y = min(max(offset.y(), low_y), self.widget.height() - margin)
        self.offset, self.fitted = QPointF(x, y), False

    def look_at(self, x_px: float, y_px: float, scale: float | None = None) -> None:
        """Bring a photo pixel to the middle."""
        if scale is not None:
            self.scale = min(max(scale, self._least()), ZOOM_MOST)
        middle = QPointF(self.widget.width() / 2, self.widget.height() / 2)
        self.offset, self.fitted = middle - QPointF(x_px + HALF_PX, y_px + HALF_PX) * self.scale, False

    def widget_from_photo(self, x_px: float, y_px: float) -> QPointF:
        """Return where a photo pixel is seen."""
        return self.offset + QPointF(x_px + HALF_PX, y_px + HALF_PX) * self.scale

    def photo_from_widget(self, at: QPointF) -> tuple[float, float]:
        """Return the photo pixel seen at a place."""
        inside = (at - self.offset) / self.scale
        return inside.x() - HALF_PX, inside.y() - HALF_PX

    def _least(self) -> float:
        if self.photo.isEmpty():
            return 1.0
        return min(self.widget.width() / self.photo.width(), self.widget.height() / self.photo.height())
