"""Drawing of points and photos."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPainterPath, QPen, QPixmap, QPolygonF

from cloner.booth.visitors.uncertain import DOUBTFUL_BELOW
from cloner_gui.canvas.photos.lens import HALF_PX, Lens

RADIUS: Final = 5.0  # taste: visible on a photo of 1,800 px shown at half size
CORRECTED: Final = QColor(64, 156, 255)
SURE: Final = QColor(60, 200, 90)
UNSURE: Final = QColor(240, 70, 50)
CLONE: Final = QColor(255, 40, 220)  # as in the previews
LINKED: Final = QColor(255, 190, 20)  # the photo's own outline
#: Outlines have a corner a pixel; drawn are as few as keep within so many photo pixels: strokes cost by the corner.
_STRAIGHT_PX: Final = 0.25
MAGNIFIED: Final = 4.0  # at least so many widget pixels a photo pixel inside the magnifier; taste
MAGNIFIER: Final = 150.0  # its diameter, widget pixels: a thumb's breadth on a touch screen
UNSURE_BELOW: Final = DOUBTFUL_BELOW  # confidence at which a point is fully red
_SURE_ABOVE: Final = 0.75  # confidence at which a point is fully green; taste


def to_qimage(rgb: NDArray[np.uint8]) -> QImage:
    """Return an (H, W, 3) uint8 picture as a QImage in Qt's fastest format; thread-safe."""
    pixels = np.ascontiguousarray(rgb)
    height, width = pixels.shape[:2]
    image = QImage(pixels.data, width, height, 3 * width, QImage.Format.Format_RGB888)
    return image.convertToFormat(QImage.Format.Format_RGB32)  # a copy: the pixels belong to numpy and may go


def to_pixmap(rgb: NDArray[np.uint8]) -> QPixmap:
    """Return an (H, W, 3) uint8 picture as a pixmap."""
    return QPixmap.fromImage(to_qimage(rgb))


def to_painter_path(borders_px: Iterable[NDArray[np.float64]]) -> QPainterPath:
    """Return closed borders (M, 2), photo pixels, as a path in Qt's photo coordinates."""
    path = QPainterPath()
    for border in borders_px:
        few = cv2.approxPolyDP(np.asarray(border, dtype=np.float32).reshape(-1, 1, 2), _STRAIGHT_PX, closed=True)
        corners = (few[:, 0].astype(np.float64) + HALF_PX).tolist()
        path.addPolygon(QPolygonF([QPointF(x, y) for x, y in corners]))
        path.closeSubpath()
    return path


def point_colour(confidence: float, corrected: bool) -> QColor:
    """Return blue for a corrected point, else red through yellow to green by confidence."""
    if corrected:
        return QColor(CORRECTED)
    share = min(max((confidence - UNSURE_BELOW) / (_SURE_ABOVE - UNSURE_BELOW), 0.0), 1.0)
    hue = UNSURE.hueF() + share * (SURE.hueF() - UNSURE.hueF())
    return QColor.fromHsvF(hue, 0.8, 0.95)


_TRIANGLE: Final = ((0.0, -1.3), (1.15, 0.75), (-1.15, 0.75))
_SQUARE: Final = ((-0.95, -0.95), (0.95, -0.95), (0.95, 0.95), (-0.95, 0.95))


def point_shape(confidence: float, corrected: bool) -> str:
    """Return a point's shape, see :func:`draw_point`."""
    return "square" if corrected else "triangle" if confidence < UNSURE_BELOW else "ring"


def point_radius(scale: float, *, strong: bool) -> float:
    """Return the radius of a point, widget pixels: small on a small photo, where points would hide the face."""
    return RADIUS * min(max(0.4 + scale, 0.6), 1.2) * (1.6 if strong else 1.0)


def draw_point(painter: QPainter, at: QPointF, colour: QColor, radius: float, shape: str = "ring") -> None:
    """Draw one point with a dark rim, so that it shows on any photo; its middle stays free.

    Its colour is not all that tells how sure it is: a sure one is a "ring", a doubtful one a "triangle", one that was
    placed by hand a "square".
    """
    corners = {"triangle": _TRIANGLE, "square": _SQUARE}.get(shape, ())
    outline = QPolygonF([at + QPointF(x * radius, y * radius) for x, y in corners])
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for pen in (QPen(QColor(0, 0, 0, 170), min(0.8 * radius, 4.0)), QPen(colour, min(0.4 * radius, 2.0))):
        painter.setPen(pen)
        if corners:
            painter.drawPolygon(outline)
        else:
            painter.drawEllipse(at, radius, radius)
    painter.setPen(QPen(colour, 1.0))
    painter.drawPoint(at)


def draw_outline(painter: QPainter, outline: QPainterPath, colour: QColor = CLONE) -> None:
    """Draw an outline over its photo, one screen pixel wide at any zoom."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    pen = QPen(colour, 1.5)
    pen.setCosmetic(True)
    painter.setPen(pen)
    painter.drawPath(outline)


def draw_anchor(painter: QPainter, at: QPointF, radius: float) -> None:
    """Draw an operator's own outline point as a diamond."""
    corners = [at + QPointF(x * radius, y * radius) for x, y in ((0, -1), (1, 0), (0, 1), (-1, 0))]
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for pen in (QPen(QColor(0, 0, 0, 170), 4.0), QPen(CORRECTED, 2.0)):
        painter.setPen(pen)
        painter.drawPolygon(corners)


def draw_partner(painter: QPainter, at: QPointF) -> None:
    """Draw a dashed ring where the mirrored partner of the selected point is expected."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for pen in (QPen(QColor(0, 0, 0, 150), 3.5), QPen(QColor(255, 255, 255), 1.5, Qt.PenStyle.DashLine)):
        painter.setPen(pen)
        painter.drawEllipse(at, 2.0 * RADIUS, 2.0 * RADIUS)


def draw_magnifier(
    painter: QPainter, photo: QPixmap, outlines: Sequence[tuple[QPainterPath, QColor]], at: QPointF, place: QPointF
) -> None:
    """Draw a round magnification of the photo around ``place`` (Qt's photo coordinates) with cross hairs, around
    ``at``.
    """
    half, scale = MAGNIFIER / 2.0, max(MAGNIFIED, 2.0 * painter.device().devicePixelRatio())
    circle = QPainterPath()
    circle.addEllipse(at, half, half)
    painter.save()
    painter.setClipPath(circle)
    painter.fillPath(circle, QColor(40, 40, 40))
    painter.translate(at)
    painter.scale(scale, scale)
    painter.translate(-place)
    painter.drawPixmap(0, 0, photo)
    for outline, colour in outlines:
        draw_outline(painter, outline, colour)
    painter.restore()
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for pen in (QPen(QColor(0, 0, 0, 180), 4.0), QPen(QColor(255, 255, 255), 2.0)):
        painter.setPen(pen)
        painter.drawEllipse(at, half, half)
    painter.setPen(QPen(QColor(255, 255, 255, 200), 1.0))
    for x, y in ((1.0, 0.0), (0.0, 1.0)):
        for sign in (-1.0, 1.0):  # the middle stays free: there lies what is aimed at
            way = QPointF(sign * x, sign * y)
            painter.drawLine(at + way * 6.0, at + way * half)


def draw_name(painter: QPainter, at: QPointF, text: str) -> None:
    """Draw a name beside a point, on a dark plate."""
    box = painter.fontMetrics().boundingRect(text)
    plate = QRectF(at.x() + 12, at.y() - box.height() - 6, box.width() + 12, box.height() + 6)
    inside = QRectF(painter.viewport())
    plate.translate(min(0.0, inside.right() - plate.right()), max(0.0, inside.top() - plate.top()))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(20, 20, 20, 210))
    painter.drawRoundedRect(plate, 3, 3)
    painter.setPen(QColor(255, 255, 255))
    painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, text)


class ScaledPhoto:
    """A photo scaled to its displayed size, cached until the view changes, as scaling for every move is slow."""

    def __init__(self) -> None:
        self._key: tuple[object, ...] = ()
        self._shown = QPixmap()

    def draw(self, painter: QPainter, photo: QPixmap, lens: Lens, density: float) -> None:
        """Draw a photo through a lens, ``density`` screen pixels a widget pixel."""
        size = lens.widget * density
        key = (photo.cacheKey(), lens.scale, lens.offset.toTuple(), size.toTuple())
        if key != self._key:
            self._key = key
            self._shown = QPixmap(size.toSize())
            self._shown.setDevicePixelRatio(density)
            self._shown.fill(Qt.GlobalColor.transparent)
            inside = QPainter(self._shown)
            inside.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, lens.scale < 2.0)
            inside.translate(lens.offset)
            inside.scale(lens.scale, lens.scale)
            inside.drawPixmap(0, 0, photo)
            inside.end()
        painter.drawPixmap(0, 0, self._shown)
