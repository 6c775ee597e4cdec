"""The recently opened events, one button each: shown while none is open."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from cloner.booth.events.event import read_event
from cloner.booth.events.recent import note_recent, recent_events
from cloner.errors import ClonerError
from cloner_gui.language.words import translate
from cloner_gui.widgets.letters import escape_mnemonic
from cloner_gui.widgets.pieces import Card, button, label, set_accessible_name


class RecentCard(Card):
    """Opens a recent event."""

    chosen = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.heading = label("heading")
        self.column.addWidget(self.heading)
        self.folders: tuple[Path, ...] = ()
        self._file: Path | None = None
        self._buttons: list[QWidget] = []
        self.setVisible(False)

    def follow(self, file: Path) -> None:
        """Offer what a file notes, and note there what is opened from now on; without one nothing is noted."""
        self._file = file
        self.show_all(recent_events(file))

    def note(self, folder: Path) -> None:
        """Note that an event was opened."""
        if self._file is not None:
            note_recent(self._file, folder)

    def show_all(self, folders: Sequence[Path]) -> None:
        """Show a button for each event; nothing where there is none."""
        self.heading.setText(translate("visitor", "Opened last"))
        self.folders = tuple(folders)
        for one in self._buttons:
            one.deleteLater()
        self._buttons = []
        for folder in folders:
            one = button()
            one.setText(escape_mnemonic(_title(folder)))
            set_accessible_name(one, _title(folder), str(folder))
            one.clicked.connect(functools.partial(self.chosen.emit, folder))
            self.column.addWidget(one)
            self._buttons.append(one)
        self.setVisible(bool(folders))


def _title(folder: Path) -> str:
    """Return what an event is called: its title and its folder's name, where they differ."""
    try:
        title = read_event(folder).title
    except ClonerError:
        title = ""
    return f"{title} ({folder.name})" if title and title != folder.name else folder.name
