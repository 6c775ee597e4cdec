"""The reveal: a finished clone turns, walks, waves and smiles by itself, then stands again."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from PySide6.QtCore import QObject, QTimer, Signal

from cloner_gui.canvas.clones.preview import Preview


@dataclass(frozen=True, slots=True)
class Act:
    """One part of the reveal: a motion of `cloner_gui.canvas.clones.acting.MOTIONS`, the camera, and the duration."""

    motion: str
    framing: str
    seconds: float
    spins: bool = False


#: Taste: long enough to be seen, short enough for the next in the queue.
ACTS: Final = (
    Act("idle", "front", 7.0, spins=True),
    Act("walk", "three_quarter", 5.0),
    Act("wave", "front", 6.0),
    Act("smile", "face", 5.0),
)


class Reveal(QObject):
    """Plays the acts in a preview, once or repeatedly.

    Parameters
    ----------
    preview : Preview
    """

    ended = Signal()

    def __init__(self, preview: Preview, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._preview = preview
        self._next = QTimer(self, singleShot=True)
        self._next.timeout.connect(self._go_on)
        self._number = 0
        preview.touched.connect(self.stop)

    @property
    def active(self) -> bool:
        """Whether the clone acts by itself."""
        return self._next.isActive()

    @property
    def act(self) -> Act:
        """What the clone does."""
        return ACTS[self._number]

    def begin(self) -> None:
        """Begin with the first act."""
        self._number = -1
        self._go_on()

    def stop(self) -> None:
        """Stop: a hand on the clone takes over."""
        if self._next.isActive():
            self._next.stop()
            self._preview.spin(0.0)

    def rest(self) -> None:
        """Stop, and let the clone stand: nothing is to move by itself any more."""
        if self._next.isActive():
            self.stop()
            self._preview.play("stand")

    def _go_on(self) -> None:
        self._number += 1
        if self._number == len(ACTS):
            self._number = 0
            self._preview.play("stand")
            self._preview.frame("front")
            self.ended.emit()
            return
        act = ACTS[self._number]
        self._preview.frame(act.framing)
        self._preview.play(act.motion)
        self._preview.spin(act.seconds if act.spins else 0.0)
        self._next.start(round(1000 * act.seconds))
