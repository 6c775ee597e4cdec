"""The card that a visitor takes home on paper: the clone's picture, a name, and a QR code; drawn in millimetres."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QMarginsF, QRect, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QImage, QPageLayout, QPageSize, QPainter, QPdfWriter

from cloner.errors import ClonerError

#: A6 upright, as photo printers have it, mm.
CARD_MM: Final = (105.0, 148.0)
DOTS_PER_INCH: Final = 300  # what photo printers print
MM_PER_INCH: Final = 25.4
_EDGE_MM: Final = 6.0  # printers leave up to 5 mm white
_CODE_MM: Final = 27.0  # a telephone reads 25 mm from an arm's length (taste)
_TITLE_MM, _NAME_MM, _NOTE_MM = 5.0, 8.0, 3.2
_INK, _DIM = QColor(28, 36, 48), QColor(90, 100, 114)


@dataclass(frozen=True, slots=True, eq=False)
class CardContent:
    """The content of a card.

    Attributes
    ----------
    picture : QImage
    title : str
        Of the event.
    name : str
        As the visitor agreed to be called where others read it.
    note : str
        Below the name: what the code is for, or where the files lie.
    code : (N, N) bool or None
        Dark modules of the code with its white border.
    logo : QImage or None
    """

    picture: QImage
    title: str
    name: str
    note: str
    code: NDArray[np.bool_] | None = None
    logo: QImage | None = None


def picture_room() -> QRectF:
    """Return the picture's rectangle on the card, mm."""
    width, height = CARD_MM
    below = _EDGE_MM + _CODE_MM + _EDGE_MM / 2.0
    top = _EDGE_MM + 1.6 * _TITLE_MM
    return QRectF(_EDGE_MM, top, width - 2.0 * _EDGE_MM, height - top - below)


def paint_card(painter: QPainter, room: QRectF, content: CardContent) -> None:
    """Draw a card into a rectangle, as large as it fits."""
    scale = min(room.width() / CARD_MM[0], room.height() / CARD_MM[1])

    def at(place: QRectF) -> QRectF:
        return QRectF(
            room.left() + place.left() * scale, room.top() + place.top() * scale,
            place.width() * scale, place.height() * scale,
        )  # fmt: skip

    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    painter.fillRect(at(QRectF(0.0, 0.0, *CARD_MM)), Qt.GlobalColor.white)
    picture = picture_room()
    wide = picture.width()
    if content.logo is not None:
        high = 1.5 * _TITLE_MM
        logo = QSizeF(content.logo.size()).scaled(QSizeF(0.4 * wide, high), Qt.AspectRatioMode.KeepAspectRatio)
        painter.drawImage(
            at(QRectF(picture.right() - logo.width(), _EDGE_MM / 2.0, logo.width(), logo.height())), content.logo
        )
        wide -= logo.width() + _EDGE_MM / 2.0
    _write(painter, at(QRectF(_EDGE_MM, _EDGE_MM / 2.0, wide, 1.5 * _TITLE_MM)), content.title, _TITLE_MM * scale, _DIM)
    painter.drawImage(at(picture), content.picture)
    top, wide = picture.bottom() + _EDGE_MM / 2.0, picture.width()
    if content.code is not None:
        wide -= _CODE_MM + _EDGE_MM / 2.0
        _draw_code(painter, at(QRectF(picture.right() - _CODE_MM, top, _CODE_MM, _CODE_MM)), content.code)
    name_room = QRectF(_EDGE_MM, top, wide, 1.5 * _NAME_MM)
    _write(painter, at(name_room), content.name, _NAME_MM * scale, _INK, bold=True)
    note_room = QRectF(_EDGE_MM, name_room.bottom(), wide, _CODE_MM - 1.5 * _NAME_MM)
    _write(painter, at(note_room), content.note, _NOTE_MM * scale, _DIM, wraps=True)


def _write(
    painter: QPainter, room: QRectF, text: str, high: float, ink: QColor, *, bold: bool = False, wraps: bool = False
) -> None:
    """Write a text as large as wanted, smaller where it would not fit."""
    flags = int(Qt.AlignmentFlag.AlignLeft) | int(Qt.AlignmentFlag.AlignTop if wraps else Qt.AlignmentFlag.AlignVCenter)
    flags |= int(Qt.TextFlag.TextWordWrap) if wraps else 0
    font = QFont(painter.font())
    font.setBold(bold)
    for size in np.linspace(high, 0.35 * high, 14):
        font.setPixelSize(max(int(size), 1))
        needed = QFontMetricsF(font).boundingRect(room, flags, text)
        if needed.width() <= room.width() and needed.height() <= room.height():
            break
    painter.setFont(font)
    painter.setPen(ink)
    painter.drawText(room, flags, text)


def _draw_code(painter: QPainter, room: QRectF, modules: NDArray[np.bool_]) -> None:
    """Draw a code's modules as rectangles: they stay sharp on paper."""
    each = int(room.width() // len(modules)) or 1
    left, top = (
        round(room.left() + (room.width() - each * len(modules)) / 2.0),
        round(room.top() + (room.height() - each * len(modules)) / 2.0),
    )
    for row, column in zip(*np.nonzero(modules), strict=True):
        painter.fillRect(QRect(left + each * int(column), top + each * int(row), each, each), Qt.GlobalColor.black)


def card_image(content: CardContent, dots_per_inch: int = DOTS_PER_INCH) -> QImage:
    """Return the card as a picture."""
    width, height = (round(side / MM_PER_INCH * dots_per_inch) for side in CARD_MM)
    image = QImage(width, height, QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.white)
    image.setDotsPerMeterX(round(1000.0 * dots_per_inch / MM_PER_INCH))
    image.setDotsPerMeterY(round(1000.0 * dots_per_inch / MM_PER_INCH))
    painter = QPainter(image)
    paint_card(painter, QRectF(image.rect()), content)
    painter.end()
    return image


def save_card(content: CardContent, path: Path) -> None:
    """Write the card as a PDF page of its own size, or as a PNG picture, by the file's suffix.

    Raises
    ------
    ClonerError
        If it cannot be written.
    """
    if path.suffix.lower() == ".pdf":
        writer = QPdfWriter(str(path))
        writer.setResolution(DOTS_PER_INCH)
        size = QPageSize(QSizeF(*CARD_MM), QPageSize.Unit.Millimeter)
        writer.setPageLayout(QPageLayout(size, QPageLayout.Orientation.Portrait, QMarginsF()))
        painter = QPainter()
        fine = painter.begin(writer)
        if fine:
            paint_card(painter, QRectF(0.0, 0.0, writer.width(), writer.height()), content)
            fine = painter.end()
    else:
        fine = card_image(content).save(str(path))
    if not fine:
        raise ClonerError("it cannot be written there", "Is the stick full or write-protected?", path.name)


def paint_true_size(painter: QPainter, page: QRectF, dots_per_inch: float, content: CardContent) -> None:
    """Draw the card centred on a printer's page, at true size or as large as the paper allows."""
    wide, high = (side / MM_PER_INCH * dots_per_inch for side in CARD_MM)
    share = min(page.width() / wide, page.height() / high, 1.0)
    room = QRectF(0.0, 0.0, share * wide, share * high)
    room.moveCenter(page.center())
    paint_card(painter, room, content)
