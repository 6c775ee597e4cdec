"""The screen for visitors: the newest clone shows itself, then those of the day, and a line says who is next."""

from __future__ import annotations

import functools
from pathlib import Path

from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtGui import QCloseEvent, QGuiApplication, QMouseEvent, QPixmap
from PySide6.QtWidgets import QLabel, QStackedWidget, QVBoxLayout, QWidget

from cloner.booth.stage import public_name, queue_names, result_of, shown_clones
from cloner.booth.visitors.kept import CLONE_FILE
from cloner.booth.visitors.visits import read_visit
from cloner.errors import ClonerError
from cloner.project.clone_file import load_clone
from cloner.records.clones import Clone
from cloner_gui.background.newest import newest
from cloner_gui.canvas.clones.attract import Attract
from cloner_gui.canvas.clones.preview import Preview
from cloner_gui.canvas.clones.reveal import Reveal
from cloner_gui.event.booth import Booth
from cloner_gui.language.words import translate
from cloner_gui.widgets.pieces import label

#: A clone that does not move by itself is seen so long, milliseconds; and so often it is looked for a first one.
_STILL_MS = 12_000
_LOGO_PX = 96
_QUEUED = 5  # names in the line of who is next


class StageWindow(QWidget):
    """A window of its own; F11 or a double click fills the screen it is on, a second one where there is one."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(parent, Qt.WindowType.Window)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setObjectName("page")
        self._booth = booth
        self._shown: Path | None = None
        self._wanted: list[Path] = []
        self.title, self.who, self.queue = label("title"), label("title"), label("heading")
        self.logo, self.preview, self.attract, self.middle = QLabel(), Preview(), Attract(), QStackedWidget()
        self.middle.addWidget(self.preview)
        self.middle.addWidget(self.attract)
        self.preview.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.reveal = Reveal(self.preview, self)
        self._still = QTimer(self, singleShot=True, interval=_STILL_MS)
        self._still.timeout.connect(self.go_on)
        self.reveal.ended.connect(self.go_on)
        column = QVBoxLayout(self)
        for one in (self.logo, self.title, self.who, self.queue):
            one.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        for one in (self.logo, self.title):
            column.addWidget(one)
        column.addWidget(self.middle, 1)
        for one in (self.who, self.queue):
            column.addWidget(one)
        booth.visits_changed.connect(self._show_queue)
        booth.event_changed.connect(self._speak)
        booth.session.queue.finished.connect(lambda folder, _: self.welcome(folder))
        self.resize(720, 900)
        self._speak()
        self.go_on()

    def fill_screen(self) -> None:
        """Fill the second screen, or the only one."""
        screens = QGuiApplication.screens()
        if len(screens) > 1:
            self.setGeometry(screens[1].geometry())
        self.showFullScreen()

    def welcome(self, folder: Path) -> None:
        """Show a clone that was just finished next, if its visitor agreed to that."""
        if read_visit(folder).shown:
            self._wanted.insert(0, folder)
            self.reveal.stop()
            self.go_on()

    def go_on(self) -> None:
        """Show the next clone of those who may be seen; nobody's where there is none."""
        waiting = [one for one in self._wanted if one.is_dir()]
        self._wanted = waiting[1:]
        chosen = waiting[0] if waiting else self._next_of_day()
        self._still.start()
        if chosen is None:
            self._take(None, None)
            return
        work = functools.partial(load_clone, result_of(chosen) / CLONE_FILE)
        newest().ask(self, "stage", work, functools.partial(self._take, chosen), self._skip)

    def _next_of_day(self) -> Path | None:
        shown = shown_clones(self._booth.visits())
        if not shown:
            return None
        at = shown.index(self._shown) + 1 if self._shown in shown else 0
        return shown[at % len(shown)]

    def _take(self, folder: Path | None, clone: Clone | None) -> None:
        """Show a clone, unless its visitor changed their mind or went meanwhile."""
        if folder is not None and not (folder.is_dir() and read_visit(folder).shown):
            folder, clone = None, None
        self._shown = folder
        self.preview.set_clone(clone)
        self._show_middle()
        said = self._invitation()
        if folder is not None:
            said = public_name(folder, read_visit(folder), self._booth.typed_name(folder))
            if not self._booth.settings.calm:
                self._still.stop()
                self.reveal.begin()
        self.who.setText(said)

    def _show_middle(self) -> None:
        """Show the clone, or sample people where nobody's may be seen."""
        if self._shown is None:
            self.middle.setCurrentWidget(self.attract)
            self.attract.begin(calm=self._booth.settings.calm)
        else:
            self.attract.stop()
            self.middle.setCurrentWidget(self.preview)

    def _invitation(self) -> str:
        return translate("stage", "Five photos, one minute: your own clone stands here.")

    def _skip(self, error: ClonerError) -> None:
        self._take(None, None)

    def _show_queue(self) -> None:
        visits = self._booth.visits()
        if self._shown is not None and not (self._shown in visits and visits[self._shown].shown):
            self.reveal.stop()
            self._take(None, None)
            self._still.start()
        names = queue_names(visits, self._booth.typed_name)
        more = translate("stage", " and {n} more").format(n=len(names) - _QUEUED) if len(names) > _QUEUED else ""
        told = translate("stage", "Next: {names}").format(names=", ".join(names[:_QUEUED]) + more)
        self.queue.setText(told if names else "")

    def _speak(self) -> None:
        settings, root = self._booth.settings, self._booth.root
        self.setWindowTitle(translate("stage", "Screen for visitors"))
        self.title.setText(settings.title or ("" if root is None else root.name))
        logo = QPixmap(settings.logo) if settings.logo else QPixmap()
        self.logo.setVisible(not logo.isNull())
        if not logo.isNull():
            self.logo.setPixmap(logo.scaledToHeight(_LOGO_PX, Qt.TransformationMode.SmoothTransformation))
        if self._shown is None:
            self.who.setText(self._invitation())
        if settings.calm:
            self.reveal.rest()
            self._still.start()
        self._show_middle()
        self._show_queue()

    def changeEvent(self, event: QEvent) -> None:
        """Speak another language."""
        if event.type() == QEvent.Type.LanguageChange:
            self._speak()
        super().changeEvent(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Fill the screen, or leave it."""
        if self.isFullScreen():
            self.showNormal()
        else:
            self.fill_screen()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Show nothing any more."""
        self.reveal.stop()
        self.attract.stop()
        self._still.stop()
        super().closeEvent(event)
