"""All photos as thumbnails with their points; one is selected for the large view."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, QSize, QSizeF, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QAbstractButton, QButtonGroup, QSizePolicy, QVBoxLayout, QWidget

from cloner.frames import ViewId
from cloner.records.points import ViewPoints
from cloner_gui.canvas.photos.lens import Lens
from cloner_gui.canvas.photos.painting import UNSURE_BELOW, ScaledPhoto, point_colour, to_pixmap

_DOT: Final = 2.0  # radius of a point, widget pixels
_MARGIN: Final = 4


class SmallPhoto(QAbstractButton):
    """One thumbnail; a click selects it.

    Parameters
    ----------
    title : str
    number : int
        With Alt it is the key that shows the photo.
    rgb : (h, w, 3) uint8
        The small picture.
    height_px : int
        Of the photo itself, whose pixels points are counted in.
    """

    def __init__(
        self,
        title: str,
        number: int,
        rgb: NDArray[np.uint8],
        height_px: int,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setCheckable(True)
        self._number = number
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._height_px = height_px
        self._pixmap = to_pixmap(rgb)
        self._scaled = ScaledPhoto()
        self._points: ViewPoints | None = None
        self.call(title)

    def call(self, title: str) -> None:
        """Give the photo its title."""
        self.setText(title)
        self.setShortcut(f"Alt+{self._number}")  # a new text takes the old shortcut away
        self.setToolTip(f"{title} (Alt+{self._number})")
        self.updateGeometry()
        self.set_points(self._points)

    def set_points(self, points: ViewPoints | None) -> None:
        """Show points, and say how many are doubtful."""
        self._points = points
        self.doubtful = 0 if points is None else int(np.sum((points.confidence < UNSURE_BELOW) & ~points.corrected))
        told = self.tr("%n doubtful point(s)", "", self.doubtful) if points is not None else self.tr("no points yet")
        self.setAccessibleName(f"{self.text()}: {told}")
        self.update()

    def sizeHint(self) -> QSize:
        """Return the size of a small photo."""
        return QSize(92, 120)

    def minimumSizeHint(self) -> QSize:
        """Return the least size: five of them fit a low screen, and their titles fit them."""
        return QSize(max(72, self.fontMetrics().horizontalAdvance(f"{self.text()} · 99")), 60)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw photo, points and title."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        palette = self.palette()
        painter.fillRect(self.rect(), palette.highlight() if self.isChecked() or self.hasFocus() else palette.button())
        line = painter.fontMetrics().height()
        inside = QRectF(self.rect()).adjusted(_MARGIN, _MARGIN, -_MARGIN, -_MARGIN - line)
        lens = Lens(QSizeF(self._pixmap.size()), inside.size())
        lens.show_all()
        painter.save()
        painter.translate(inside.topLeft())
        self._scaled.draw(painter, self._pixmap, lens, self.devicePixelRatioF())
        self._paint_points(painter, lens, self._pixmap.height() / self._height_px)
        painter.restore()
        painter.setPen(palette.highlightedText().color() if self.isChecked() else palette.buttonText().color())
        text = f"{self.text()} · {self.doubtful}" if self.doubtful else self.text()
        at = QRectF(0, self.height() - line - 2, self.width(), line)
        shown = painter.fontMetrics().elidedText(text, Qt.TextElideMode.ElideRight, self.width())
        painter.drawText(at, Qt.AlignmentFlag.AlignCenter, shown)

    def _paint_points(self, painter: QPainter, lens: Lens, share: float) -> None:
        if self._points is None:
            return
        painter.setPen(QColor(0, 0, 0, 120))
        rows = zip(self._points.points_px, self._points.confidence, self._points.corrected, strict=True)
        for (x, y), confidence, fixed in rows:
            painter.setBrush(point_colour(confidence, bool(fixed)))
            painter.drawEllipse(QPointF(lens.widget_from_photo(x * share, y * share)), _DOT, _DOT)


class Filmstrip(QWidget):
    """The thumbnails of one visitor."""

    chosen = Signal(object)
    """The ViewId that is to be seen large."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(2)
        self._group = QButtonGroup(self)
        self.photos: dict[ViewId, SmallPhoto] = {}

    def set_photos(self, photos: Mapping[ViewId, tuple[str, NDArray[np.uint8], int]]) -> None:
        """Show photos with their titles, in this order: each a small picture, and the height of its photo, px."""
        for old in self.photos.values():
            self._group.removeButton(old)
            self._column.removeWidget(old)
            old.deleteLater()
        self.photos = {}
        for number, (view, (title, rgb, height_px)) in enumerate(photos.items(), start=1):
            small = SmallPhoto(title, number, rgb, height_px, self)
            small.clicked.connect(lambda _=False, view=view: self.chosen.emit(view))
            self._group.addButton(small)
            self._column.addWidget(small)
            self.photos[view] = small

    def call(self, titles: Mapping[str, str]) -> None:
        """Give the photos their titles in another language."""
        for view, small in self.photos.items():
            small.call(titles[view])

    def mark(self, view: ViewId) -> None:
        """Show which photo is seen large."""
        if view in self.photos:
            self.photos[view].setChecked(True)
