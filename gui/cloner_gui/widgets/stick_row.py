"""The plugged-in USB stick: detected automatically, written with one click, ejected with another."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from PySide6.QtCore import QTimer, Signal
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QComboBox, QVBoxLayout, QWidget

from cloner.booth.handover.sticks import Stick, eject, mounted_sticks
from cloner.errors import ClonerError
from cloner_gui.background.newest import shared_latest
from cloner_gui.background.worker import Task
from cloner_gui.language.words import translate
from cloner_gui.widgets.letters import escape_mnemonic
from cloner_gui.widgets.pieces import GAP, button, label, set_accessible_name

#: Where Linux tells what is mounted; read again and again, it costs nothing. Only when it changes a program is asked.
MOUNTS: Final = Path("/proc/self/mountinfo")
_LOOK_MS: Final = 1500


class StickRow(QWidget):
    """One stick's buttons, and a choice between several."""

    copy_wanted = Signal(object)
    failed = Signal(object)
    changed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._known: bytes | None = None
        self._ejecting: Task | None = None
        self._said = ""
        self.sticks: tuple[Stick, ...] = ()
        self.choice, self.note = QComboBox(), label("dim")
        self.copy_button, self.eject_button = button("main"), button()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(GAP)
        for one in (self.choice, self.copy_button, self.eject_button, self.note):
            column.addWidget(one)
        self._timer = QTimer(self, interval=_LOOK_MS)
        self._timer.timeout.connect(self.look)
        self.choice.currentIndexChanged.connect(self._show)
        self.copy_button.clicked.connect(lambda: self.copy_wanted.emit(self.stick))
        self.eject_button.clicked.connect(self._eject)
        self._ready = False

    @property
    def stick(self) -> Stick | None:
        """The stick that is chosen; None where none is plugged in."""
        at = self.choice.currentIndex()
        return self.sticks[at] if 0 <= at < len(self.sticks) else None

    @property
    def busy(self) -> bool:
        """Whether a stick is being let go."""
        return self._ejecting is not None

    def allow(self, ready: bool) -> None:
        """Take that there is something to copy, and nobody copies just now."""
        self._ready = ready
        self._show()

    def look(self) -> None:
        """Look whether something was plugged in or pulled out; only then a program is asked what it is."""
        try:
            now = MOUNTS.read_bytes()
        except OSError:
            self._say(translate("stick", "Sticks are found by themselves on Linux only: choose the stick's folder."))
            self._timer.stop()
            return
        if now != self._known:
            self._known = now
            shared_latest().ask(self, "sticks", mounted_sticks, self._take, self._give_up)

    def showEvent(self, event: QShowEvent) -> None:
        """Look while it is seen."""
        super().showEvent(event)
        self._timer.start()
        self.look()

    def hideEvent(self, event: QHideEvent) -> None:
        """Look no more."""
        super().hideEvent(event)
        self._timer.stop()

    def close_all(self) -> None:
        """Wait for a stick that is being let go."""
        if self._ejecting is not None:
            self._ejecting.wait()

    def speak(self) -> None:
        """Say everything in the window's language."""
        self._said = ""
        set_accessible_name(self.choice, translate("stick", "Which stick"))
        self._show()

    def _take(self, sticks: tuple[Stick, ...]) -> None:
        chosen, before = self.stick, {one.mount for one in self.sticks}
        self.sticks = sticks
        self.choice.blockSignals(True)
        self.choice.clear()
        for one in sticks:
            self.choice.addItem(one.label)
        at = [one.mount for one in sticks].index(chosen.mount) if chosen in sticks and chosen is not None else 0
        self.choice.setCurrentIndex(at if sticks else -1)
        self.choice.blockSignals(False)
        if any(one.mount not in before for one in sticks):
            self._said = ""
        self._show()

    def _give_up(self, error: ClonerError) -> None:
        self._say(translate("stick", "This system does not tell which sticks are plugged in: choose the folder."))

    def _say(self, text: str) -> None:
        self._said = text
        self._show()

    def _show(self) -> None:
        stick = self.stick
        self.choice.setVisible(len(self.sticks) > 1)
        for one in (self.copy_button, self.eject_button):
            one.setVisible(stick is not None)
        free = self._ready and not self.busy
        self.copy_button.setEnabled(free and stick is not None and not stick.read_only)
        self.eject_button.setEnabled(not self.busy and stick is not None)
        waits = translate("stick", "No stick is plugged in: it is found by itself.")
        if stick is not None:
            self.copy_button.setText(translate("stick", "&Copy to {stick}").format(stick=escape_mnemonic(stick.label)))
            self.eject_button.setText(translate("stick", "E&ject {stick}").format(stick=escape_mnemonic(stick.label)))
            free_gb = f"{stick.free_bytes / 1e9:.1f}"
            waits = translate("stick", "{n} GB are free.").format(n=free_gb)
            if stick.read_only:
                waits = translate("stick", "It is write-protected.")
        if self.busy:
            waits = translate("stick", "The stick is being let go…")
        self.note.setText(self._said or waits)
        self.changed.emit()

    def _eject(self) -> None:
        stick = self.stick
        if stick is None or self._ejecting is not None:
            return
        self._ejecting = Task(lambda _: eject(stick))
        gone = translate("stick", "{stick} can be pulled out.").format(stick=stick.label)
        self._ejecting.succeeded.connect(lambda _: self._say(gone))
        self._ejecting.failed.connect(self.failed)
        self._ejecting.finished.connect(self._ejected)
        self._ejecting.start()
        self._say("")

    def _ejected(self) -> None:
        self._ejecting = None
        self._known = None  # what is mounted has changed
        said = self._said
        self.look()
        self._say(said)
