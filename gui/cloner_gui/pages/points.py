"""Third page: the proposed points on all photos, most uncertain first, corrected by dragging."""

from __future__ import annotations

import functools
from collections.abc import Callable

from PySide6.QtCore import QEvent, Qt, QTimer, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QLabel, QProgressBar, QSplitter, QStackedWidget, QVBoxLayout, QWidget

from cloner.frames import ViewId
from cloner.records.points import ViewPoints, next_anchor
from cloner_gui.background.newest import shared_latest
from cloner_gui.canvas.clones.orbit import photo_view_camera
from cloner_gui.canvas.clones.preview import Preview
from cloner_gui.canvas.photos.filmstrip import Filmstrip
from cloner_gui.canvas.photos.hints import legend_text, point_text, remaining_text
from cloner_gui.canvas.photos.live import LiveOutlines
from cloner_gui.canvas.photos.picking import next_in_order, worst_first
from cloner_gui.canvas.photos.view import PhotoView
from cloner_gui.event.session import Session
from cloner_gui.language.told import refit_text
from cloner_gui.language.words import VIEW_TITLES, step_text, translate
from cloner_gui.widgets.flow import Flow
from cloner_gui.widgets.pieces import button, make_scrollable, set_accessible_name

#: The clone's outline is drawn anew when the hand has rested so long: it costs as much as the preview.
_OUTLINE_AFTER_MS = 250


class PointsPage(QWidget):
    """All photos small, one of them large with its points, and the clone beside it."""

    changed = Signal()

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self.views: dict[ViewId, PhotoView] = {}
        self._points: dict[ViewId, ViewPoints] = {}
        self._shown: dict[ViewId, tuple[object, ...]] = {}
        self.live = LiveOutlines(self)
        self.strip, self.stack = Filmstrip(), QStackedWidget()
        self.preview = Preview()
        self.hint, self.status, self.legend, self.keys = (QLabel(wordWrap=True) for _ in range(4))
        self.progress = QProgressBar()
        self.progress.setRange(0, 1000)
        self.again, self.previous, self.following = button("main"), button(), button("main")
        self.reset, self.whole, self.anchor = button(), button(), button()
        self._clone_later = QTimer(self, singleShot=True, interval=_OUTLINE_AFTER_MS)
        self._clone_later.timeout.connect(self._show_clone_outline)
        self._link_soon = QTimer(self, singleShot=True, interval=0)
        self._link_soon.timeout.connect(self._show_outline)
        self._lay_out()
        self._connect()
        self._speak()
        self._open()

    def why_not(self) -> str:
        """Return why the next page cannot come yet: points may always stay as they are."""
        return "" if self._session.photos.photos else translate("points", "Add photos first.")

    @property
    def view(self) -> ViewId | None:
        """The photo that is seen large."""
        return next((view for view, canvas in self.views.items() if canvas is self.stack.currentWidget()), None)

    def show_view(self, view: ViewId) -> None:
        """Show a photo large, and the clone from its side."""
        self.stack.setCurrentWidget(self.views[view])
        self.strip.mark(view)
        self._frame_preview(view)
        self._tell_point(self.views[view].chosen)
        self._link_soon.start()
        self._clone_later.start()

    def next_point(self, step: int) -> None:
        """Go to the next point, the least sure first, whichever photo it is on; -1 goes back."""
        view = self.view
        now = None if view is None or not self.views[view].chosen else (view, self.views[view].chosen)
        found = next_in_order(self._order, now, step)
        if found is not None:
            self.show_view(found[0])
            self.views[found[0]].setFocus()
            self.views[found[0]].choose(found[1], close=True)
            self.status.setText(remaining_text(self._order, self._points, found))

    # --- making -------------------------------------------------------------------

    def _lay_out(self) -> None:
        self.hint.setMinimumHeight(2 * self.fontMetrics().height())
        self.hint.setAlignment(Qt.AlignmentFlag.AlignTop)
        parts = QSplitter(Qt.Orientation.Horizontal)
        for part, share in ((self.strip, 0), (self.stack, 5), (self.preview, 3)):
            parts.addWidget(part)
            parts.setStretchFactor(parts.count() - 1, share)
            parts.setCollapsible(parts.count() - 1, False)
        parts.setSizes([96, 560, 320])
        bottom, inside = Flow(), QWidget()
        for widget in (self.previous, self.following, self.reset, self.anchor, self.whole, self.again):
            bottom.addWidget(widget)
            widget.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click must not take the keys from the photo
        bottom.addWidget(self.progress)
        column = QVBoxLayout(inside)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.hint)
        column.addWidget(parts, 1)
        column.addLayout(bottom)
        column.addWidget(self.status)
        column.addWidget(self.legend)
        column.addWidget(self.keys)
        make_scrollable(self, inside)

    def _connect(self) -> None:
        session = self._session
        self.again.clicked.connect(session.propose)
        self.previous.clicked.connect(lambda: self.next_point(-1))
        self.following.clicked.connect(lambda: self.next_point(1))
        self.reset.clicked.connect(lambda: self._on_view(lambda canvas: canvas.point_reset.emit(canvas.chosen)))
        self.whole.clicked.connect(lambda: self._on_view(PhotoView.show_all))
        self.anchor.clicked.connect(lambda: self._on_view(lambda canvas: canvas.add_anchor(canvas.attention())))
        self.strip.chosen.connect(self.show_view)
        self.live.changed.connect(self._link_soon.start)
        self.preview.failed.connect(session.failed)
        session.opened.connect(self._open)
        session.points_changed.connect(self._show_points)
        session.busy_changed.connect(self._show_busy)
        session.progressed.connect(self._show_progress)
        session.cloned.connect(self._show_clone)
        session.refitted.connect(self._show_refit)

    def _speak(self) -> None:
        """Put all words into the window's language."""
        says = (
            (self.again, translate("points", "Find points"), ""),
            (self.previous, translate("points", "◀"), translate("points", "Point before (Shift+Tab)")),
            (self.following, translate("points", "Next doubtful point"), translate("points", "Least sure first (Tab)")),
            (self.reset, translate("points", "Back to proposal"), translate("points", "Undo this point (Delete)")),
            (self.anchor, translate("points", "Add outline point"), translate("points", "Or pull at it (Insert)")),
            (self.whole, translate("points", "Whole photo"), translate("points", "Show all of the photo (Home)")),
        )
        for widget, text, told in says:
            widget.setText(text)
            set_accessible_name(widget, told.split(" (")[0] if widget is self.previous else text, told)
        self.legend.setText(legend_text())
        self.keys.setText(
            translate("points", "Tab: next point. Arrows: 1 pixel, with Shift 10. Wheel or + and −: zoom. Home: all.")
        )
        self.preview.say_when_empty(translate("points", "After the first clone, the person here follows your hand."))
        self.strip.call(VIEW_TITLES)
        self._tell_point("")

    def _open(self) -> None:
        """Show the open visitor's photos."""
        self.live.forget()
        for old in self.views.values():
            self.stack.removeWidget(old)
            old.deleteLater()
        self.views, self._points, self._shown = {}, {}, {}
        photos = self._session.photos.photos
        small = self._session.thumbnails
        self.strip.set_photos(
            {view: (VIEW_TITLES[view], small.get(view, one.rgb), one.height_px) for view, one in photos.items()}
        )
        for view, photo in photos.items():
            self.views[view] = self._canvas(view)
            self.views[view].set_photo(photo.rgb)
            self.stack.addWidget(self.views[view])
        self._order: list[tuple[ViewId, str]] = []
        self._show_clone()
        self._show_points()
        self._show_busy()
        if self.views:
            self.show_view(next(iter(self.views)))
        if self.isVisible():
            self._session.propose()
            self._take_keys()
        self.changed.emit()

    def _canvas(self, view: ViewId) -> PhotoView:
        canvas = PhotoView()
        canvas.point_moved.connect(lambda name, x, y, gesture: self._session.place_point(view, name, x, y, gesture))
        canvas.point_reset.connect(lambda name: self._session.reset_point(view, name))
        canvas.hovered.connect(lambda name: self._tell_point(name or canvas.chosen))
        canvas.chosen_changed.connect(self._tell_point)
        canvas.next_wanted.connect(self.next_point)
        return canvas

    def _on_view(self, act: Callable[[PhotoView], None]) -> None:
        """Do something with the photo that is seen large, and give it the keys again."""
        view = self.view
        if view is not None:
            act(self.views[view])
            self.views[view].setFocus()

    # --- events ------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        """Propose points when the page is first seen."""
        super().showEvent(event)
        self._session.propose()
        self._take_keys()

    def _take_keys(self) -> None:
        """Give the keyboard to the photo: the first Tab goes to the first point, not to a button."""
        if self.view is not None:
            self.views[self.view].setFocus()

    def changeEvent(self, event: QEvent) -> None:
        """Speak another language."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._speak()
            self._show_points()

    def _show_points(self) -> None:
        """Show what changed since the last time."""
        session, corrections = self._session, self._session.corrections
        for view, canvas in self.views.items():
            set_accessible_name(canvas, VIEW_TITLES[view])
            canvas.setAccessibleDescription(self.keys.text())
            state = (session.proposed.get(view), corrections.points.get(view, {}))
            if state == self._shown.get(view, ()):
                continue
            self._shown[view] = state
            points = session.points(view)
            canvas.anchor_name = next_anchor(corrections, view) if view.is_body and points is not None else ""
            canvas.set_points(points)
            self.strip.photos[view].set_points(points)
            if points is not None:
                self._points[view] = points
            if canvas is self.stack.currentWidget():
                self._tell_point(canvas.chosen)
        if self._points and not self._order:
            self._order = worst_first(self._points)
            if session.folder is not None:
                self.live.prepare(session.folder, session.photos, session.proposed)
        self._link_soon.start()
        self._show_busy()
        self.changed.emit()

    def _show_outline(self) -> None:
        """Link the photo's outline through the points as they are."""
        view = self.view
        if view is not None:
            self.views[view].set_outline(self.live.borders(view, self._session.corrections))

    def _show_clone_outline(self) -> None:
        """Draw the clone's outline on the photo that is seen."""
        view, person = self.view, self._session.person_now()
        if view is None:
            return
        canvas = self.views[view]
        if person is None:
            canvas.set_clone_outline(())
            return
        from cloner.interactive.refitting import outline_px  # the whole fit: not paid for before there is a clone

        work = functools.partial(outline_px, person, view)
        shared_latest().ask(canvas, "clone outline", work, canvas.set_clone_outline, self._session.failed.emit)

    def _show_clone(self) -> None:
        self.preview.set_clone(self._session.clone_now())
        if self.view is not None:
            self._frame_preview(self.view)
        self._clone_later.start()

    def _frame_preview(self, view: ViewId) -> None:
        """See the clone from where the photo saw the person."""
        self.preview.frame(photo_view_camera(self._session.clone_now(), view))

    def _show_refit(self) -> None:
        """Show where the body went, and say what it could not follow."""
        self.preview.update_clone(self._session.clone_now())
        self._clone_later.start()
        if self._session.moved is not None:
            self.status.setText(refit_text(self._session.moved))

    def _show_busy(self) -> None:
        session = self._session
        found = bool(session.proposed)
        self.progress.setVisible(session.seeking)
        self.again.setVisible(not found and not session.busy and bool(self.views))
        for widget in (self.previous, self.following, self.reset, self.whole, self.anchor):
            widget.setEnabled(found)
        if not session.seeking:
            self.status.setText("")

    def _show_progress(self, step: str, fraction: float) -> None:
        if not self._session.seeking:
            return
        self.progress.setValue(round(1000 * fraction))
        self.status.setText(step_text(step))

    def _tell_point(self, chosen: str) -> None:
        """Say which point this is, how sure it is, and how to place it."""
        self.hint.setText(point_text(None if self.view is None else self._points.get(self.view), chosen))
