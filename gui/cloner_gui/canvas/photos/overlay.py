"""What is drawn over a photo: outlines, points, and the magnifier at the moved one."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QPointF
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPixmap

from cloner.records.points import ANCHOR, ViewPoints
from cloner_gui.canvas.photos import painting
from cloner_gui.canvas.photos.lens import HALF_PX, Lens
from cloner_gui.canvas.photos.picking import expected_mirror_px
from cloner_gui.language.point_names import point_label

Outlines = Sequence[tuple[QPainterPath, QColor]]


def paint_outlines(painter: QPainter, lens: Lens, outlines: Outlines) -> None:
    """Draw outlines in Qt's photo coordinates through a lens."""
    painter.save()
    painter.translate(lens.offset)
    painter.scale(lens.scale, lens.scale)
    for outline, colour in outlines:
        painting.draw_outline(painter, outline, colour)
    painter.restore()


def paint_points(painter: QPainter, lens: Lens, points: ViewPoints, chosen: str, hovered: str) -> None:
    """Draw all points, the selected and the hovered one larger, one's name, and the selected one's mirrored partner."""
    rows = zip(points.names, points.points_px, points.confidence, points.corrected, strict=True)
    for name, (x, y), confidence, fixed in rows:
        at = lens.widget_from_photo(x, y)
        radius = painting.point_radius(lens.scale, strong=name in (hovered, chosen))
        if name.startswith(ANCHOR):
            painting.draw_anchor(painter, at, radius)
        else:
            colour, shape = (
                painting.point_colour(confidence, bool(fixed)),
                painting.point_shape(confidence, bool(fixed)),
            )
            painting.draw_point(painter, at, colour, radius, shape)
    mirrored = expected_mirror_px(points, chosen)
    if mirrored is not None:
        painting.draw_partner(painter, lens.widget_from_photo(*mirrored))
    named = hovered or chosen
    place = points.get(named)
    if place is not None:
        painting.draw_name(painter, lens.widget_from_photo(*place), point_label(named))


def paint_close_up(
    painter: QPainter, lens: Lens, photo: QPixmap, outlines: Outlines, place_px: tuple[float, float]
) -> None:
    """Draw the magnifier in the upper corner away from the mouse."""
    half = painting.MAGNIFIER / 2.0 + 6.0
    width = lens.widget.width()
    on_the_right = lens.widget_from_photo(*place_px).x() > width / 2.0
    at = QPointF(half if on_the_right else width - half, half)
    inside = QPointF(place_px[0] + HALF_PX, place_px[1] + HALF_PX)
    painting.draw_magnifier(painter, photo, outlines, at, inside)
