"""How to stand for each photo, as a drawn figure: on the empty cards and over the live picture."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QPixmap, QPixmapCache

from cloner.frames import ViewId

#: Which way a figure that is seen from the side looks: the quarter turn to the left shows the right side.
_UPRIGHT: Final = 0.56  # width over height of a picture that a figure fits
_HEAD: Final = 0.66  # the same of a head, whose nose stands out at the side
_NOSE: Final = ((0.065, 0.055), (0.085, 0.075), (0.062, 0.085))


def pose_picture(view: ViewId, size: QSize, ink: QColor, paper: QColor) -> QPixmap:
    """Return a drawing of the pose for a photo; cached, as cards show it again often."""
    key = f"pose {view} {size.width()}x{size.height()} {ink.name()} {paper.name()}"
    known = QPixmap()
    if QPixmapCache.find(key, known):
        return known
    picture = _drawn_pose(view, size, ink, paper)
    QPixmapCache.insert(key, picture)
    return picture


def _drawn_pose(view: ViewId, size: QSize, ink: QColor, paper: QColor) -> QPixmap:
    picture = QPixmap(size)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    share = _HEAD if view.is_face else _UPRIGHT
    high = min(float(size.height()), size.width() / share)
    room = QRectF(0, 0, share * high, high)  # all of the figure is seen, however narrow the card
    room.moveCenter(QRectF(0, 0, size.width(), size.height()).center())
    painter.setPen(QPen(ink, max(size.height() / 90.0, 1.5)))
    painter.setBrush(paper)
    painter.drawPath(pose_outline(view, room))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for path in _marks(view, room):
        painter.drawPath(path)
    painter.end()
    return picture


def _marks(view: ViewId, room: QRectF) -> list[QPainterPath]:
    """Return what tells front from back and side: a face, a neck's hair, a nose."""
    high = 0.88 * room.height()
    top = QPointF(room.center().x(), room.top() + 0.06 * room.height())
    if view is ViewId.BODY_FRONT:
        return [_face(QPointF(top.x(), top.y() + 0.07 * high), 0.045 * high)]
    if view is ViewId.FACE_FRONT:
        return [_face(QPointF(room.center().x(), room.top() + 0.48 * room.height()), 0.22 * room.height())]
    if view is ViewId.BODY_BACK:
        return [_lines([QPointF(top.x(), top.y() + y * high) for y in (0.2, 0.48)])]
    if view is ViewId.BODY_SIDE:
        return [_lines([QPointF(top.x() + x * high, top.y() + y * high) for x, y in _NOSE])]
    middle, tall = QPointF(room.center().x(), room.top() + 0.46 * room.height()), 0.62 * room.height()
    nose = [
        QPointF(middle.x() + x * tall, middle.y() + y * tall) for x, y in ((0.36, -0.06), (0.46, 0.1), (0.35, 0.13))
    ]
    ear = QPainterPath()
    ear.addEllipse(QPointF(middle.x() - 0.04 * tall, middle.y()), 0.05 * tall, 0.1 * tall)
    return [_lines(nose), ear]


def _face(middle: QPointF, size: float) -> QPainterPath:
    """Return two eyes, a nose and a mouth."""
    path = QPainterPath()
    for side in (-1.0, 1.0):
        path.addEllipse(QPointF(middle.x() + side * 0.38 * size, middle.y() - 0.25 * size), 0.09 * size, 0.06 * size)
    path.moveTo(middle.x(), middle.y() - 0.1 * size)
    path.lineTo(middle.x() - 0.1 * size, middle.y() + 0.25 * size)
    path.lineTo(middle.x() + 0.05 * size, middle.y() + 0.25 * size)
    path.moveTo(middle.x() - 0.28 * size, middle.y() + 0.55 * size)
    path.lineTo(middle.x() + 0.28 * size, middle.y() + 0.55 * size)
    return path


def _lines(points: list[QPointF]) -> QPainterPath:
    path = QPainterPath(points[0])
    for point in points[1:]:
        path.lineTo(point)
    return path


def pose_outline(view: ViewId, room: QRectF) -> QPainterPath:
    """Return where the person should stand in a picture, in its pixels."""
    if view.is_face:
        high = 0.62 * room.height()
        head = QRectF(0, 0, 0.74 * high, high)
        head.moveCenter(QPointF(room.center().x(), room.top() + 0.46 * room.height()))
        path = QPainterPath()
        path.addEllipse(head)
        shoulders = 0.5 * min(room.width(), 2.6 * head.width())
        path.moveTo(room.center().x() - shoulders, room.bottom())
        path.quadTo(head.left(), head.bottom(), head.left() + 0.28 * head.width(), head.bottom() - 0.06 * high)
        path.moveTo(room.center().x() + shoulders, room.bottom())
        path.quadTo(head.right(), head.bottom(), head.right() - 0.28 * head.width(), head.bottom() - 0.06 * high)
        return path
    high = 0.88 * room.height()
    rows = _SIDE if view is ViewId.BODY_SIDE else _FRONT
    points = [QPointF(room.center().x() + x * high, room.top() + 0.06 * room.height() + y * high) for x, y in rows]
    path = QPainterPath(points[0])
    for point in points[1:]:
        path.lineTo(point)
    if view is not ViewId.BODY_SIDE:
        mirrored = [QPointF(2 * room.center().x() - point.x(), point.y()) for point in reversed(points)]
        for point in mirrored:
            path.lineTo(point)
    path.closeSubpath()
    return path


#: Half of a person with the arms a hand's breadth away from the body: shares of the height (taste).
_FRONT: Final = (
    (0.0, 0.0), (0.05, 0.02), (0.06, 0.07), (0.045, 0.12), (0.03, 0.15), (0.1, 0.175), (0.13, 0.2), (0.19, 0.33),
    (0.25, 0.45), (0.27, 0.52), (0.25, 0.53), (0.2, 0.45), (0.13, 0.31), (0.1, 0.28), (0.085, 0.4), (0.1, 0.5),
    (0.09, 0.7), (0.075, 0.95), (0.09, 1.0), (0.02, 1.0), (0.02, 0.75), (0.005, 0.53),
)  # fmt: skip
_SIDE: Final = (
    (0.0, 0.0), (0.05, 0.02), (0.065, 0.07), (0.05, 0.13), (0.02, 0.15), (0.06, 0.24), (0.065, 0.4), (0.055, 0.52),
    (0.05, 0.72), (0.04, 0.94), (0.1, 0.985), (0.1, 1.0), (-0.05, 1.0), (-0.045, 0.94), (-0.06, 0.73), (-0.075, 0.5),
    (-0.05, 0.4), (-0.07, 0.25), (-0.04, 0.16), (-0.06, 0.1), (-0.05, 0.03),
)  # fmt: skip
