"""The screen for visitors: the latest clone presents itself, then those of the day, and a line says who is next."""

from __future__ import annotations

import functools
from pathlib import Path

from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtGui import QCloseEvent, QGuiApplication, QImage, QMouseEvent, QPixmap
from PySide6.QtWidgets import QLabel, QStackedWidget, QVBoxLayout, QWidget

from cloner.booth.stage import public_name, queue_names, result_of, shown_clones
from cloner.booth.visitors.cached_work import CLONE_FILE
from cloner.booth.visitors.visits import read_visit
from cloner.booth.walk_pictures import read_walk_pictures
from cloner.errors import ClonerError
from cloner.project.clone_file import load_clone
from cloner.records.clones import Clone
from cloner_gui.background.newest import shared_latest
from cloner_gui.background.worker import Task
from cloner_gui.canvas.clones.attract import AttractLoop
from cloner_gui.canvas.clones.parade import MOST, Parade, read_walkers
from cloner_gui.canvas.clones.preview import Preview
from cloner_gui.canvas.clones.reveal import Reveal
from cloner_gui.event.booth import Booth
from cloner_gui.language.words import translate
from cloner_gui.widgets.pieces import label

#: A clone that does not move by itself is seen so long, milliseconds; and so often it is looked for a first one.
_STILL_MS = 12_000
_LOGO_PX = 96
_QUEUED = 5  # names in the line of who is next
# After so many clones the day's crowd walks by, so long, milliseconds, where it has so many people (taste).
_CROWD_EACH, _CROWD_MS, _CROWD_LEAST = 3, 20_000, 2


class StageWindow(QWidget):
    """A window of its own; F11 or a double click fills the screen it is on, a second one where there is one."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(parent, Qt.WindowType.Window)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setObjectName("page")
        self._booth = booth
        self._shown: Path | None = None
        self._shows = True
        self._wanted: list[Path] = []
        self.title, self.who, self.queue = label("title"), label("title"), label("heading")
        self.logo, self.preview, self.attract, self.middle = QLabel(), Preview(), AttractLoop(), QStackedWidget()
        self.parade = Parade()
        for widget in (self.preview, self.attract, self.parade):
            self.middle.addWidget(widget)
        self._seen = 0
        self._drawing: Task | None = None
        self._vain: set[Path] = set()
        self.preview.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.reveal = Reveal(self.preview, self)
        self._still = QTimer(self, singleShot=True)
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
        if not waiting and self._seen >= _CROWD_EACH and self.show_crowd():
            return
        chosen = waiting[0] if waiting else self._next_of_day()
        self._seen += 1
        self._still.start(_STILL_MS)
        if chosen is None:
            self._take(None, None)
            return
        work = functools.partial(load_clone, result_of(chosen) / CLONE_FILE)
        shared_latest().ask(self, "stage", work, functools.partial(self._take, chosen), self._skip)

    def show_crowd(self) -> bool:
        """Let the day's people walk by; return whether there are enough of them."""
        self._seen = 0
        strolls = {one: read_walk_pictures(one, result_of(one)) for one in shown_clones(self._booth.visits())[:MOST]}
        files = {one: file for one, file in strolls.items() if file is not None}
        if len(files) < _CROWD_LEAST:
            return False
        self._still.start(_CROWD_MS)
        shared_latest().ask(self, "crowd", functools.partial(read_walkers, files), self._take_crowd, self._skip)
        return True

    def _take_crowd(self, images: dict[Path, QImage]) -> None:
        may_be = self._may_be_seen()
        seen = {folder: image for folder, image in images.items() if folder in may_be}
        self._take(None, None)
        self.attract.stop()
        self.parade.show_people(seen, calm=self._booth.settings.calm)
        self.middle.setCurrentWidget(self.parade)
        self.who.setText(translate("stage", "Everybody of today"))

    def _may_be_seen(self) -> frozenset[Path]:
        return frozenset(shown_clones(self._booth.visits()))

    def _draw_walks(self) -> None:
        """Draw the walk of one who may be seen and has none yet, beside everything else; then of the next."""
        if self._drawing is not None:
            return
        may_be = shown_clones(self._booth.visits())[:MOST]
        lacks = [one for one in may_be if one not in self._vain and read_walk_pictures(one, result_of(one)) is None]
        if lacks:
            folder, services = lacks[0], self._booth.session.services
            self._vain.add(folder)  # asked for once: who cannot be drawn keeps nobody waiting
            task = Task(lambda progress: services.draw_walk(folder, result_of(folder), progress))
            self._drawing = task
            task.succeeded.connect(lambda _: self._vain.discard(folder))
            task.finished.connect(self._drawn)
            task.start()

    def _drawn(self) -> None:
        self._drawing = None
        if self._shows:
            self._draw_walks()

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
        self.parade.stop()
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
        if self.parade.walkers:
            self.parade.keep(self._may_be_seen())
            if not self.parade.walkers:
                self.go_on()
        self._draw_walks()
        if self._shown is not None and not (self._shown in visits and visits[self._shown].shown):
            self.reveal.stop()
            self._take(None, None)
            self._still.start(_STILL_MS)
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
        if self._shown is None and not self.parade.walkers:
            self.who.setText(self._invitation())
        if settings.calm:
            self.reveal.rest()
            self._still.start(_STILL_MS)
        if self.parade.walkers:
            self.who.setText(translate("stage", "Everybody of today"))
            self.parade.be_calm(settings.calm)
        else:
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
        self.parade.stop()
        self._still.stop()
        self._shows = False
        super().closeEvent(event)
