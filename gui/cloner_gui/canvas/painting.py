"""How points and photos are drawn."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPainterPath, QPen, QPixmap

RADIUS: Final = 5.0  # taste: visible on a photo of 1,800 px shown at half size
CORRECTED: Final = QColor(64, 156, 255)
SURE: Final = QColor(60, 200, 90)
UNSURE: Final = QColor(240, 70, 50)
CLONE: Final = QColor(255, 40, 220)  # as in the previews
_UNSURE_BELOW: Final = 0.25  # confidence at which a point is fully red; taste
_SURE_ABOVE: Final = 0.75  # confidence at which a point is fully green; taste


def pixmap_of(rgb: NDArray[np.uint8]) -> QPixmap:
    """Return an (H, W, 3) uint8 picture as a pixmap."""
    pixels = np.ascontiguousarray(rgb)
    height, width = pixels.shape[:2]
    image = QImage(pixels.data, width, height, 3 * width, QImage.Format.Format_RGB888)
    return QPixmap.fromImage(image.copy())  # the pixels belong to numpy and may go


def point_colour(confidence: float, corrected: bool) -> QColor:
    """Return blue for a corrected point, else red through yellow to green by confidence."""
    if corrected:
        return QColor(CORRECTED)
    share = min(max((confidence - _UNSURE_BELOW) / (_SURE_ABOVE - _UNSURE_BELOW), 0.0), 1.0)
    hue = UNSURE.hueF() + share * (SURE.hueF() - UNSURE.hueF())
    return QColor.fromHsvF(hue, 0.8, 0.95)


def draw_point(painter: QPainter, at: QPointF, colour: QColor, *, strong: bool) -> None:
    """Draw one point as a ring with a dark rim, so that it shows on any photo; its middle stays free."""
    radius = RADIUS * (1.6 if strong else 1.0)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for pen in (QPen(QColor(0, 0, 0, 170), 4.0), QPen(colour, 2.0)):
        painter.setPen(pen)
        painter.drawEllipse(at, radius, radius)
    painter.setPen(QPen(colour, 1.0))
    painter.drawPoint(at)


def draw_outline(painter: QPainter, outline: QPainterPath) -> None:
    """Draw the clone's outline over its photo, as thin as the screen allows at any zoom."""
    pen = QPen(CLONE, 1.5)
    pen.setCosmetic(True)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(pen)
    painter.drawPath(outline)


def draw_name(painter: QPainter, at: QPointF, text: str) -> None:
    """Draw a name beside a point, on a dark plate."""
    box = painter.fontMetrics().boundingRect(text)
    plate = QRectF(at.x() + 12, at.y() - box.height() - 6, box.width() + 12, box.height() + 6)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(20, 20, 20, 210))
    painter.drawRoundedRect(plate, 3, 3)
    painter.setPen(QColor(255, 255, 255))
    painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, text)
