"""Third page: see the proposed points and drag them right."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QPushButton, QTabWidget, QVBoxLayout, QWidget

from cloner.frames import ViewId
from cloner_gui.canvas.painting import CORRECTED, SURE, UNSURE
from cloner_gui.canvas.view import PhotoView
from cloner_gui.session import Session
from cloner_gui.words import VIEW_TITLES, spoken, spoken_refit, spoken_step

_HELP = (
    "Drag a point to correct it. Wheel: zoom. Drag beside points: pan. Double click: whole photo. Right click: reset."
)


class PointsPage(QWidget):
    """One tab a photo, each with its points."""

    changed = Signal()
    title = "3  Points"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self.views: dict[ViewId, PhotoView] = {}
        self.tabs = QTabWidget()
        self.again = QPushButton("Find points")
        self.again.clicked.connect(session.propose)
        self.progress = QProgressBar()
        self.progress.setRange(0, 1000)
        self.status = QLabel(_HELP)
        legend = " ".join(
            f'<span style="color:{colour.name()}">●</span> {text} '
            for colour, text in ((SURE, "sure"), (UNSURE, "unsure"), (CORRECTED, "corrected by you"))
        )
        bottom = QHBoxLayout()
        bottom.addWidget(self.status, 1)
        bottom.addWidget(self.progress)
        bottom.addWidget(self.again)
        bottom.addWidget(QLabel(legend))
        column = QVBoxLayout(self)
        column.addWidget(self.tabs, 1)
        column.addLayout(bottom)
        session.opened.connect(self._open)
        session.points_changed.connect(self._show_points)
        session.busy_changed.connect(self._show_busy)
        session.progressed.connect(self._show_progress)
        session.cloned.connect(self._show_body)
        session.refitted.connect(self._show_refit)
        self.tabs.currentChanged.connect(self._show_body)
        self._open()
        self._show_busy()

    def why_not(self) -> str:
        """Return why the next page cannot come yet: points may always stay as they are."""
        return "" if self._session.photos.photos else "Choose a folder with photos first."

    def showEvent(self, event: QShowEvent) -> None:
        """Propose points when the page is first seen."""
        super().showEvent(event)
        self._session.propose()

    def _open(self) -> None:
        """Make one tab a photo."""
        self.tabs.clear()
        for old in self.views.values():
            old.deleteLater()
        self.views = {}
        for view, photo in self._session.photos.photos.items():
            canvas = PhotoView()
            canvas.set_photo(photo.rgb)
            canvas.point_moved.connect(
                lambda name, x, y, gesture, view=view: self._session.place_point(view, name, x, y, gesture)
            )
            canvas.point_reset.connect(lambda name, view=view: self._session.reset_point(view, name))
            canvas.hovered.connect(lambda name: self.status.setText(spoken(name) if name else _HELP))
            self.views[view] = canvas
            self.tabs.addTab(canvas, VIEW_TITLES[view])
        self._show_points()
        self.changed.emit()

    def _show_points(self) -> None:
        for view, canvas in self.views.items():
            canvas.set_points(self._session.points(view))
        self.again.setVisible(not self._session.proposed and not self._session.busy)
        self.changed.emit()

    def _show_busy(self) -> None:
        self.progress.setVisible(self._session.busy)
        self.again.setVisible(not self._session.proposed and not self._session.busy)
        if self._session.busy:
            self.progress.setValue(0)
        else:
            self.status.setText(_HELP)

    def _show_progress(self, step: str, fraction: float) -> None:
        self.progress.setValue(round(1000 * fraction))
        self.status.setText(spoken_step(step))

    def _show_body(self) -> None:
        """Draw the clone's outline on the photo that is seen."""
        for view, canvas in self.views.items():
            if canvas is self.tabs.currentWidget():
                canvas.set_outline(self._session.clone_outline(view))

    def _show_refit(self) -> None:
        """Show where the body went, and say what it could not follow."""
        self._show_body()
        if self._session.moved is not None:
            self.status.setText(spoken_refit(self._session.moved))
