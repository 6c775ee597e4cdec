"""The day's crowd on the visitors' screen: everybody who agreed walks by, at their own height and pace.

What is shown are pictures of each visitor's walk (`cloner.booth.walk_pictures`), read in a thread of their own: drawing
them takes a second per person, once, and nothing is rendered in 3-D while the crowd is shown.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from PySide6.QtCore import QPointF, QRectF, Qt, QTimer
from PySide6.QtGui import QColor, QImage, QLinearGradient, QPainter, QPaintEvent, QPixmap
from PySide6.QtWidgets import QWidget

from cloner.booth.walk_pictures import FRAMES, GROUND, HIGH, PACE

#: The newest so many walk: each holds 4 MB.
MOST: Final = 12
_FRAME_MS: Final = 83  # a step of the pictures
#: Taste: how far people walk before they come again, how many lanes there are, how much smaller the farthest is.
_WIDE_M: Final = 9.0
_LANES: Final = 4
_FARTHEST: Final = 0.55
_APART: Final = 0.382  # of the way, from one to the next: nobody walks behind another for long
_SKY, _FLOOR, _NEAR = QColor(238, 240, 243), QColor(206, 210, 216), QColor(190, 194, 201)
_FLOOR_FROM: Final = 0.62  # of the height


@dataclass(frozen=True, slots=True)
class Walker:
    """One visitor's pictures.

    Attributes
    ----------
    pictures : QPixmap
        `FRAMES` beside each other.
    high_m : float
        Height of a picture.
    pace_m_s : float
    ground : float
        At which share of its height the feet stand.
    """

    pictures: QPixmap
    high_m: float
    pace_m_s: float
    ground: float


def read_walkers(files: Mapping[Path, Path]) -> dict[Path, QImage]:
    """Return the pictures of visitors' walks by visitor, without those that were removed meanwhile.
    For another thread.
    """
    images = {visitor: QImage(str(file)) for visitor, file in files.items()}
    return {visitor: image for visitor, image in images.items() if not image.isNull()}


class Parade(QWidget):
    """Shows visitors walking by; with ``calm`` they stand."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.walkers: dict[Path, Walker] = {}
        self.calm = False
        self._seconds = 0.0
        self._timer = QTimer(self, interval=_FRAME_MS)
        self._timer.timeout.connect(self.go_on)

    @property
    def active(self) -> bool:
        """Whether it is shown and goes on."""
        return self._timer.isActive()

    def show_people(self, images: Mapping[Path, QImage], *, calm: bool) -> None:
        """Begin with these."""
        self.walkers = {
            visitor: Walker(
                QPixmap.fromImage(image), _told(image, HIGH, 1.9), _told(image, PACE, 1.2), _told(image, GROUND, 0.95)
            )
            for visitor, image in images.items()
        }
        self.be_calm(calm)

    def be_calm(self, calm: bool) -> None:
        """Walk, or stand."""
        self.calm = calm
        if calm or not self.walkers:
            self._timer.stop()
        else:
            self._timer.start()
        self.update()

    def keep(self, visitors: frozenset[Path]) -> None:
        """Let everybody else go at once."""
        if not self.walkers.keys() <= visitors:
            self.walkers = {visitor: one for visitor, one in self.walkers.items() if visitor in visitors}
            self.update()

    def stop(self) -> None:
        """Rest; the pictures are let go."""
        self._timer.stop()
        self.walkers = {}

    def go_on(self) -> None:
        """Take a step."""
        self._seconds += _FRAME_MS / 1000.0
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the floor, and everybody from the farthest lane to the nearest."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        wide, high = float(self.width()), float(self.height())
        painter.fillRect(self.rect(), _SKY)
        floor = QLinearGradient(QPointF(0.0, _FLOOR_FROM * high), QPointF(0.0, high))
        floor.setColorAt(0.0, _FLOOR)
        floor.setColorAt(1.0, _NEAR)
        painter.fillRect(QRectF(0.0, _FLOOR_FROM * high, wide, high), floor)
        placed = [(number % _LANES, number, one) for number, one in enumerate(self.walkers.values())]
        for lane, number, one in sorted(placed, key=lambda row: row[0]):
            self._draw(painter, one, lane, number)

    def _draw(self, painter: QPainter, one: Walker, lane: int, number: int) -> None:
        """Draw one walker, from right to left, over and over again."""
        near = _FARTHEST + (1.0 - _FARTHEST) * lane / (_LANES - 1)
        px_per_m = near * 0.36 * self.height()
        size = one.pictures.width() / FRAMES, float(one.pictures.height())
        room_high = one.high_m * px_per_m
        room_wide = room_high * size[0] / size[1]
        way = max(self.width() / px_per_m, _WIDE_M) + room_wide / px_per_m
        gone = (one.pace_m_s * self._seconds + number * _APART * way) % way
        ground = (_FLOOR_FROM + (0.97 - _FLOOR_FROM) * (lane + 0.6) / (_LANES - 0.4)) * self.height()
        if self.calm:
            gone = (number + 0.5) / max(len(self.walkers), 1) * self.width() / px_per_m + 0.5 * room_wide / px_per_m
        left = self.width() - gone * px_per_m
        frame = 0 if self.calm else int(self._seconds * FRAMES + 5 * number) % FRAMES
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(60, 64, 72, 40))
        middle = QPointF(left + 0.5 * room_wide, ground)
        painter.drawEllipse(middle, 0.27 * room_wide, 0.04 * room_wide)
        room = QRectF(left, ground - one.ground * room_high, room_wide, room_high)
        painter.drawPixmap(room, one.pictures, QRectF(frame * size[0], 0.0, *size))


def _told(image: QImage, key: str, usual: float) -> float:
    try:
        return float(image.text(key)) or usual
    except ValueError:
        return usual
