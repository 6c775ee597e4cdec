"""The window: page order, menus and the bar with Back and Next; no logic."""

from __future__ import annotations

from PySide6.QtGui import QAction, QCloseEvent, QKeySequence
from PySide6.QtWidgets import QHBoxLayout, QLabel, QMainWindow, QPushButton, QStackedWidget, QVBoxLayout, QWidget

from cloner_gui.dialogs import show_error
from cloner_gui.pages.clone import ClonePage
from cloner_gui.pages.photos import PhotosPage
from cloner_gui.pages.points import PointsPage
from cloner_gui.pages.takeaway import TakeawayPage
from cloner_gui.pages.visitor import VisitorPage
from cloner_gui.session import Session

Page = VisitorPage | PhotosPage | PointsPage | ClonePage | TakeawayPage


class MainWindow(QMainWindow):
    """All pages in their order."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self.session = session
        self.setWindowTitle("Cloner")
        self.resize(1180, 860)
        self.visitor, self.photos, self.points = VisitorPage(session), PhotosPage(session), PointsPage(session)
        self.clone, self.takeaway = ClonePage(session), TakeawayPage(session)
        self.pages: tuple[Page, ...] = (self.visitor, self.photos, self.points, self.clone, self.takeaway)
        self.stack = QStackedWidget()
        self.steps = [_step_button(page.title) for page in self.pages]
        self.back, self.next, self.reason = QPushButton("Back"), QPushButton("Next"), QLabel()
        self._lay_out()
        self._make_menus()
        session.failed.connect(lambda error: show_error(error, self))
        session.opened.connect(lambda: self.show_page(self.photos))
        self.back.clicked.connect(lambda: self.go(self.stack.currentIndex() - 1))
        self.next.clicked.connect(lambda: self.go(self.stack.currentIndex() + 1))
        self.go(0)

    def go(self, number: int) -> None:
        """Show a page."""
        self.stack.setCurrentIndex(number)
        self._refresh()

    def show_page(self, page: Page) -> None:
        """Show a page."""
        self.go(self.pages.index(page))

    def closeEvent(self, event: QCloseEvent) -> None:
        """Stop the work before the window goes."""
        self.session.close()
        super().closeEvent(event)

    def _lay_out(self) -> None:
        top, bottom = QHBoxLayout(), QHBoxLayout()
        for number, (page, step) in enumerate(zip(self.pages, self.steps, strict=True)):
            self.stack.addWidget(page)
            page.changed.connect(self._refresh)
            step.clicked.connect(lambda _, number=number: self.go(number))
            top.addWidget(step)
        top.addStretch(1)
        bottom.addWidget(self.back)
        bottom.addWidget(self.reason, 1)
        bottom.addWidget(self.next)
        whole = QWidget()
        column = QVBoxLayout(whole)
        column.addLayout(top)
        column.addWidget(self.stack, 1)
        column.addLayout(bottom)
        self.setCentralWidget(whole)

    def _make_menus(self) -> None:
        files, edit = self.menuBar().addMenu("&File"), self.menuBar().addMenu("&Edit")
        opening, leaving = QAction("&Open folder…", self), QAction("&Quit", self)
        opening.setShortcut(QKeySequence.StandardKey.Open)
        leaving.setShortcut(QKeySequence.StandardKey.Quit)
        opening.triggered.connect(self.photos.choose_folder)
        leaving.triggered.connect(self.close)
        files.addActions([opening, leaving])
        self.undo_action = self.session.undo_stack.createUndoAction(self)
        self.undo_action.setShortcut(QKeySequence.StandardKey.Undo)
        self.redo_action = self.session.undo_stack.createRedoAction(self)
        self.redo_action.setShortcut(QKeySequence.StandardKey.Redo)
        edit.addActions([self.undo_action, self.redo_action])

    def _refresh(self) -> None:
        """Say which page is shown and whether the next may come."""
        number = self.stack.currentIndex()
        blocked = self.photos.why_not()
        for place, step in enumerate(self.steps):
            step.setChecked(place == number)
            step.setEnabled(place < 2 or not blocked)
        reason = self.pages[number].why_not()
        self.back.setEnabled(number > 0)
        self.next.setVisible(number < len(self.pages) - 1)
        self.next.setEnabled(not reason)
        self.reason.setText(reason if number < len(self.pages) - 1 else "")


def _step_button(title: str) -> QPushButton:
    button = QPushButton(title)
    button.setCheckable(True)
    button.setFlat(True)
    return button
