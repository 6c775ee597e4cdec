"""The attract loop: sample people turn on the visitors' screen until a visitor may be shown there.

Shipped pictures, a sheet a person, one of which is read when it is first shown: no clone is loaded, nothing is drawn
in three dimensions. The people are synthetic (``gui/build_attract.py``).
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

from PySide6.QtCore import QRectF, QSizeF, Qt, QTimer
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPixmap
from PySide6.QtWidgets import QWidget

PICTURES: Final = Path(__file__).parents[2] / "pictures"
PEOPLE: Final = ("anna", "boris")
#: Sides of a whole turn: pixels of each, how many beside and below each other in a sheet.
SIDE_PX: Final = (360, 540)
ACROSS, DOWN = 6, 4
_FRAME_MS: Final = 120  # a turn in three seconds (taste)
_TURNS: Final = 2  # of one before the next comes
_STILL_MS: Final = 8000  # where nothing moves by itself the next comes so late, without a turn
_BACKGROUND: Final = QColor(226, 228, 232)


class AttractLoop(QWidget):
    """Turns one sample person after another; with ``calm`` each stands still."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.calm = False
        self.person, self.side = 0, 0
        self._turned = 0
        self._sheets: dict[int, QPixmap] = {}
        self._timer = QTimer(self)
        self._timer.timeout.connect(self.go_on)

    @property
    def active(self) -> bool:
        """Whether it is shown and goes on."""
        return self._timer.isActive()

    def begin(self, *, calm: bool) -> None:
        """Go on from where it was; a change of ``calm`` counts at once."""
        wanted = _STILL_MS if calm else _FRAME_MS
        if self._timer.isActive() and self._timer.interval() == wanted:
            return
        self.calm = calm
        self.side = 0 if calm else self.side
        self._timer.start(wanted)
        self.update()

    def stop(self) -> None:
        """Rest; the pictures are let go."""
        self._timer.stop()
        self._sheets.clear()

    def go_on(self) -> None:
        """Show the next side, or the next person."""
        self.side = 0 if self.calm else (self.side + 1) % (ACROSS * DOWN)
        self._turned += self.side == 0
        if self.side == 0 and (self.calm or self._turned >= _TURNS):
            self.person, self._turned = (self.person + 1) % len(PEOPLE), 0
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw one side as large as there is room."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.fillRect(self.rect(), _BACKGROUND)
        sheet = self._sheet()
        if sheet.isNull():
            return
        size = QSizeF(*SIDE_PX).scaled(QSizeF(self.size()), Qt.AspectRatioMode.KeepAspectRatio)
        room = QRectF(0.0, 0.0, size.width(), size.height())
        room.moveCenter(QRectF(self.rect()).center())
        wide, high = SIDE_PX
        painter.drawPixmap(room, sheet, QRectF(self.side % ACROSS * wide, self.side // ACROSS * high, wide, high))

    def _sheet(self) -> QPixmap:
        """Return the pictures of who is shown, read now if they were not yet; one person's are held at a time."""
        if self.person not in self._sheets:
            self._sheets = {self.person: QPixmap(str(PICTURES / f"turn_{PEOPLE[self.person]}.jpg"))}
        return self._sheets[self.person]
