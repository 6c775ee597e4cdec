"""First page: the event's visitors, and name, height and consent of the open one."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPoint, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QHBoxLayout, QListWidget, QListWidgetItem, QMenu, QVBoxLayout, QWidget

from cloner.booth.visitors.visits import State
from cloner_gui.dialogs import ask_to_forget, ask_to_save_data
from cloner_gui.event.booth import Booth
from cloner_gui.language.told import translated_problem
from cloner_gui.language.words import STATES, translate
from cloner_gui.pages.person_form import PersonForm
from cloner_gui.widgets.pieces import GAP, Card, button, label, make_scrollable, set_accessible_name
from cloner_gui.widgets.recent_card import RecentCard

_MARKS = {State.NONE: "○", State.WAITING: "◔", State.CLONED: "●", State.FAILED: "!"}


class VisitorPage(QWidget):
    """The event's visitors, and what is known of the open one."""

    changed = Signal()

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._booth = booth
        self._told: tuple[object, ...] = ()
        self.event_label, self.hint = label("dim"), label("dim")
        self.heading = label("heading")
        self.list = QListWidget()
        self.list.setWordWrap(True)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.opening_label = label("dim")
        self.new_button, self.open_button = button("main"), button()
        self.form, self.recent = PersonForm(booth), RecentCard()
        self._lay_out()
        self.new_button.clicked.connect(booth.new_visitor)
        self.open_button.clicked.connect(lambda: self.window().choose_folder())  # type: ignore[attr-defined]
        self.list.itemActivated.connect(self._open)
        self.list.itemClicked.connect(self._open)
        self.list.customContextMenuRequested.connect(self._show_menu)
        self.list.installEventFilter(self)
        booth.opening_changed.connect(self._show_opening)
        booth.page_wanted.connect(self._take_keys)
        self.form.changed.connect(self.changed)
        booth.visits_changed.connect(self._show)
        booth.event_changed.connect(self._show)
        booth.session.opened.connect(self._show)
        self._speak()

    def why_not(self) -> str:
        """Return why the next page cannot come yet."""
        if self._booth.session.folder is None:
            return translate("visitor", "Begin with a visitor first.")
        return self.form.why_not()

    def _lay_out(self) -> None:
        left = Card()
        left.column.addWidget(self.heading)
        left.column.addWidget(self.event_label)
        left.column.addWidget(self.new_button)
        left.column.addWidget(self.opening_label)
        left.column.addWidget(self.list, 1)
        self.list.setMinimumWidth(120)
        left.column.addWidget(self.open_button)
        right, inside = QWidget(), QWidget()
        column = QVBoxLayout(inside)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.form)
        column.addWidget(self.hint)
        column.addWidget(self.recent)
        column.addStretch(1)
        make_scrollable(right, inside)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(GAP)
        row.addWidget(left, 1)
        row.addWidget(right, 2)

    def show_others(self, seen: bool) -> None:
        """Show or hide the other visitors of the day: they are nobody's business in a kiosk."""
        for one in (self.heading, self.event_label, self.list, self.open_button):
            one.setVisible(seen)

    def changeEvent(self, event: QEvent) -> None:
        """Speak another language."""
        if event.type() == QEvent.Type.LanguageChange:
            self._speak()
        super().changeEvent(event)

    def _speak(self) -> None:
        self.heading.setText(translate("visitor", "Visitors"))
        self.new_button.setText(translate("visitor", "&New visitor"))
        self.open_button.setText(translate("visitor", "&Open…"))
        set_accessible_name(self.list, translate("visitor", "Visitors of this event"))
        self._show()

    def _show(self) -> None:
        """Show who is here."""
        root, folder = self._booth.root, self._booth.session.folder
        self.event_label.setText(translate("visitor", "No event is open.") if root is None else root.name)
        self._show_opening()
        self.form.setVisible(folder is not None)
        self.hint.setVisible(folder is None)
        begin = translate("visitor", "Open the event's folder; an empty one begins a new event.")
        self.recent.setVisible(root is None and folder is None and bool(self.recent.folders))
        self.hint.setText(begin if root is None else translate("visitor", "Press New visitor when somebody steps up."))
        self._fill()
        self.changed.emit()

    def _fill(self) -> None:
        """Show the visitors; the list stays where it was scrolled to while only their states change."""
        folder, visits = self._booth.session.folder, self._booth.visits()
        rows = [(place, visit.state, visit.problem, self._booth.name_of(place)) for place, visit in visits.items()]
        told = (folder, STATES[State.NONE], rows)
        if told == self._told:
            return  # much is said to have changed that does not concern the list
        self._told = told
        shown = [self.list.item(row).data(Qt.ItemDataRole.UserRole) for row in range(self.list.count())]
        self.list.blockSignals(True)
        if shown != list(visits):
            self.list.clear()
            for _ in visits:
                self.list.addItem(QListWidgetItem())
        for row, (place, state, problem, called) in enumerate(rows):
            item = self.list.item(row)
            item.setText(f"{_MARKS[state]}  {called}\n     {STATES[state]}")
            item.setData(Qt.ItemDataRole.UserRole, place)
            item.setData(Qt.ItemDataRole.AccessibleTextRole, f"{called}, {STATES[state]}")
            item.setToolTip(translated_problem(problem))
            if place == folder and self.list.currentItem() is not item:
                self.list.setCurrentItem(item)
        self.list.blockSignals(False)

    def _open(self, item: QListWidgetItem) -> None:
        place = item.data(Qt.ItemDataRole.UserRole)
        if place != self._booth.session.folder:
            self._booth.open_visitor(place)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Ask about deleting the marked visitor when Delete is pressed in the list."""
        if event.type() == QEvent.Type.KeyPress and isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Delete:
            self._delete(self.list.currentItem())
            return True
        return super().eventFilter(watched, event)

    def menu_of(self, item: QListWidgetItem) -> QMenu:
        """Return what can be done with a visitor of the list."""
        place = item.data(Qt.ItemDataRole.UserRole)
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addAction(translate("visitor", "&Open"), lambda: self._open(item))
        menu.addAction(
            translate("visitor", "&Save everything held…"), lambda: ask_to_save_data(self._booth, place, self)
        )
        menu.addAction(translate("visitor", "&Delete…"), lambda: self._delete(item))
        return menu

    def _show_menu(self, at: QPoint) -> None:
        item = self.list.itemAt(at)
        if item is not None:
            self.menu_of(item).popup(self.list.mapToGlobal(at))

    def _delete(self, item: QListWidgetItem | None) -> None:
        if item is not None:
            ask_to_forget(self._booth, (item.data(Qt.ItemDataRole.UserRole),), self)

    def _show_opening(self) -> None:
        """Say who is being opened: large photos take a second or two."""
        folder = self._booth.opening
        message = (
            "" if folder is None else translate("visitor", "Opening {name}…").format(name=self._booth.name_of(folder))
        )
        self.opening_label.setText(message)
        self.opening_label.setVisible(folder is not None)
        self.list.setEnabled(folder is None)
        self.new_button.setEnabled(folder is None and self._booth.root is not None)

    def _take_keys(self, page: str) -> None:
        """Let what is typed for a new visitor be the name, not another new visitor."""
        if page == "visitor" and self._booth.session.folder is not None:
            self.form.name_field.setFocus()
