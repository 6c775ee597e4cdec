"""The window: five steps, the status bar, and the menus; no logic."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Final, cast

from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent, QKeyEvent
from PySide6.QtWidgets import QDialog, QFileDialog, QHBoxLayout, QLabel, QMainWindow, QVBoxLayout, QWidget

from cloner.personal_data.holdings import Holding
from cloner_gui.background.newest import shared_latest
from cloner_gui.dialogs import ask_to_forget
from cloner_gui.event.booth import Booth
from cloner_gui.event.phone import Phone
from cloner_gui.event.queue_bar import QueueBar
from cloner_gui.event.session import Session
from cloner_gui.kiosk import Kiosk
from cloner_gui.language.words import translate
from cloner_gui.logs import log_to
from cloner_gui.menus import Menus
from cloner_gui.pages.photos import PhotosPage
from cloner_gui.pages.takeaway import TakeawayPage
from cloner_gui.pages.visitor import VisitorPage
from cloner_gui.shelf import Page, Shelf
from cloner_gui.widgets.letters import assign_to_page
from cloner_gui.widgets.notice import Notice
from cloner_gui.widgets.pieces import GAP, button, label
from cloner_gui.widgets.step_bar import StepBar, step_titles

if TYPE_CHECKING:
    from cloner_gui.pages.clone import ClonePage
    from cloner_gui.pages.points import PointsPage

#: Names under which a visit's file remembers the page.
PAGES: Final = ("visitor", "photos", "points", "clone", "takeaway")
VISITOR, PHOTOS, POINTS, CLONE, TAKEAWAY = range(len(PAGES))


class MainWindow(QMainWindow):
    """All pages in order."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self.session, self.booth = session, Booth(session)
        self.resize(1280, 800)
        self.setMinimumSize(760, 480)
        self.setAcceptDrops(True)
        self.visitor, self.photos = VisitorPage(self.booth), PhotosPage(self.booth)
        self.phone = Phone(self.booth)
        self.takeaway = TakeawayPage(self.booth, self.phone)
        self.stack = Shelf(
            (
                lambda: self.visitor,
                lambda: self.photos,
                lambda: _points_page(self.booth),
                lambda: _clone_page(self.booth),
                lambda: self.takeaway,
            )
        )
        self.steps = StepBar(len(PAGES))
        self.queue_bar = QueueBar(self.booth)
        self.back, self.aside, self.next, self.reason = button(), button(), button("main"), label("dim")
        self.who = QLabel()
        self._letters_soon = QTimer(self, singleShot=True, interval=0)
        self._letters_soon.timeout.connect(self._settle_letters)
        self._lay_out()
        self.notice = Notice(self.stack)
        self.menus = Menus(self)
        self.undo_action, self.redo_action = self.menus.undo, self.menus.redo
        self.kiosk = Kiosk(self)
        self._connect()
        self._speak()
        self.go(0)

    @property
    def points(self) -> PointsPage:
        """The page where points are corrected."""
        return cast("PointsPage", self.stack.page(POINTS))

    @property
    def clone(self) -> ClonePage:
        """The page where the clone is seen."""
        return cast("ClonePage", self.stack.page(CLONE))

    @property
    def pages(self) -> tuple[QWidget, ...]:
        """All pages, in their order."""
        return tuple(self.stack.page(number) for number in range(len(PAGES)))

    def go(self, number: int) -> None:
        """Show a page."""
        self.stack.show_page(number)
        self.booth.note_page(PAGES[number])
        self._refresh()

    def show_page(self, page: QWidget) -> None:
        """Show a page."""
        self.go(self.pages.index(page))

    def choose_folder(self) -> None:
        """Ask for an event's folder, or a visitor's, and open it."""
        folder = QFileDialog.getExistingDirectory(self, translate("window", "Folder of the event, or of one visitor"))
        if folder:
            self.open_folder(Path(folder))

    def open_folder(self, folder: Path) -> None:
        """Open an event, its log beside it, and ask about visitors whose time is over; or open one visitor."""
        self.booth.open(folder)
        if self.booth.root == folder:
            self.visitor.recent.note(folder)
            log_to(folder)
            self.booth.tidy_up()
            self.sweep()

    def sweep(self) -> None:
        """Ask about visitors whose time is over."""
        shared_latest().ask(self, "overdue", self.booth.overdue_soon(), self._ask_about, self.booth.failed.emit)

    def _ask_about(self, overdue: tuple[Holding, ...]) -> None:
        """Ask whether visitors whose time is over are deleted, if their event is still open."""
        folders = [one.folders[0] for one in overdue if self.booth.root in one.folders[0].parents]
        if folders:
            ask_to_forget(self.booth, folders, self)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Save, and stop the work before the window goes; a kiosk goes for the operator alone."""
        if not self.booth.allowed():
            event.ignore()
            return
        for dialog in self.findChildren(QDialog):
            dialog.close()  # a camera's thread must end before its dialog goes
        self.visitor.form.save()
        self.takeaway.close_all()
        self.phone.close()
        self.booth.close()
        super().closeEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        """Speak another language."""
        if event.type() == QEvent.Type.LanguageChange:
            self._speak()
        super().changeEvent(event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Take a folder to open."""
        if not self.kiosk.on and any(Path(url.toLocalFile()).is_dir() for url in event.mimeData().urls()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """Open the dropped folder."""
        self.open_folder(Path(event.mimeData().urls()[0].toLocalFile()))

    def _lay_out(self) -> None:
        top, bottom = QHBoxLayout(), QHBoxLayout()
        top.addWidget(self.steps, 1)
        top.addWidget(self.who)
        for widget, stretch in (
            (self.back, 0), (self.reason, 1), (self.queue_bar, 1), (self.aside, 0), (self.next, 0),
        ):  # fmt: skip
            bottom.addWidget(widget, stretch)
        bottom.setSpacing(GAP)
        whole = QWidget()
        whole.setObjectName("page")
        column = QVBoxLayout(whole)
        column.setContentsMargins(GAP, GAP // 2, GAP, GAP)
        column.setSpacing(GAP)
        column.addLayout(top)
        column.addWidget(self.stack, 1)
        column.addLayout(bottom)
        self.setCentralWidget(whole)

    def _connect(self) -> None:
        self.booth.failed.connect(self.notice.tell)
        self.booth.told.connect(self.notice.say)
        self.booth.leaving.connect(self.notice.clear)
        self.booth.visits_changed.connect(self._show_who)
        self.visitor.form.photos_wanted.connect(lambda: self.go(PHOTOS))
        self.session.cloned.connect(self._refresh)
        self.session.points_changed.connect(self._refresh)
        self.aside.clicked.connect(lambda: self.go(POINTS))
        self.booth.page_wanted.connect(self._resume)
        self.session.opened.connect(self._refresh)
        self.session.busy_changed.connect(self._refresh)
        for number in (VISITOR, PHOTOS, TAKEAWAY):
            self._page(number).changed.connect(self._refresh)
        self.stack.made.connect(lambda page: page.changed.connect(self._refresh))
        self.steps.chosen.connect(self.go)
        self.visitor.recent.chosen.connect(self.open_folder)
        self.back.clicked.connect(lambda: self.go(self.stack.currentIndex() - 1))
        self.next.clicked.connect(self._go_on)

    def _speak(self) -> None:
        self.setWindowTitle("Cloner")
        self.back.setText(translate("window", "&Back"))
        self.aside.setText(translate("window", "L&ook at the points"))
        self.menus.speak()
        self._refresh()

    def _go_on(self) -> None:
        """Do what comes next: a page, the clone, or after the last page and while it is made the next visitor."""
        if self._goes_to_next_visitor():
            self.booth.new_visitor()
        elif self._is_to_clone():
            self.session.clone()
            self.go(CLONE)
        elif self.stack.currentIndex() == PHOTOS:
            self.go(CLONE)
        else:
            self.go(min(self.stack.currentIndex() + 1, TAKEAWAY))

    def _goes_to_next_visitor(self) -> bool:
        """Return whether nothing is left to do here: nobody in a queue waits for a clone to be finished."""
        number = self.stack.currentIndex()
        return self.booth.root is not None and (number == TAKEAWAY or (number == CLONE and self.session.cloning))

    def _is_to_clone(self) -> bool:
        """Return whether the photos, or the points, are good and there is no clone of them yet."""
        session = self.session
        here = self.stack.currentIndex() in (PHOTOS, POINTS)
        return here and not session.cloning and (session.outcome is None or session.is_stale())

    def _resume(self, page: str) -> None:
        """Go on at the page where the visitor was left, or the last that may be shown."""
        wanted = min(PAGES.index(page) if page in PAGES else 0, self._reachable())
        view = self.booth.last_view()
        if wanted >= POINTS and view is not None:
            self.points.show_view(view)
        self.go(wanted)

    def _reachable(self) -> int:
        """Return the last page that may be shown: every page before it says that the next may come."""
        blocked = (number for number in range(TAKEAWAY) if self._page(number).why_not())
        return next(blocked, TAKEAWAY)

    def _page(self, number: int) -> Page:
        return cast(Page, self.stack.page(number))

    def _refresh(self) -> None:
        """Say which page is shown and whether the next may come."""
        number, reachable = self.stack.currentIndex(), self._reachable()
        self.steps.show_steps(step_titles(), number, reachable)
        reason = self._page(number).why_not()
        leaves = self._goes_to_next_visitor()
        self.back.setEnabled(number > 0)
        waits = translate("photos", "Photos are still looked at.") if self._waits_for_photos() else ""
        self.next.setText(self._next_text())
        self.next.setVisible(number != TAKEAWAY or leaves)
        self.next.setEnabled(leaves or not (reason or waits))
        self.aside.setVisible(number == PHOTOS)
        self.aside.setEnabled(not reason)
        self.reason.setText("" if leaves and number == TAKEAWAY else reason or waits)
        self.queue_bar.leave_to_page(number == CLONE)
        self._show_who()
        self._letters_soon.start()

    def _settle_letters(self) -> None:
        """Give every control that is seen a letter of its own; once, however many pages said that they changed."""
        assign_to_page(self.menuBar(), (self.back, self.aside, self.next), self.stack.page(self.stack.currentIndex()))

    def _next_text(self) -> str:
        """Return what the main button does."""
        if self._goes_to_next_visitor():
            return translate("window", "Ne&xt visitor")
        if self._is_to_clone():
            return translate("window", "&Clone")
        return translate("window", "Ne&xt")

    def _waits_for_photos(self) -> bool:
        return self._is_to_clone() and self.booth.intake.pending() > 0

    def _show_who(self) -> None:
        """Say whose pages these are."""
        folder = self.session.folder
        self.who.setText("" if folder is None else self.booth.name_of(folder))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Go on with Return where nothing else wants it."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.next.isEnabled() and self.next.isVisible():
            self.next.click()
        else:
            super().keyPressEvent(event)


# Both pages draw in three dimensions and know the fit; loading that takes longer than all the rest of the window.
def _points_page(booth: Booth) -> QWidget:
    from cloner_gui.pages.points import PointsPage

    page = PointsPage(booth.session)
    page.stack.currentChanged.connect(lambda _: booth.note_view(page.view) if page.isVisible() else None)
    return page


def _clone_page(booth: Booth) -> QWidget:
    from cloner_gui.pages.clone import ClonePage

    return ClonePage(booth)
