"""The event's visitors as thumbnails: searched, opened, cloned again, deleted and restored."""

from __future__ import annotations

from collections import deque
from pathlib import Path

from PySide6.QtCore import QRect, QSize, Qt, QTimer
from PySide6.QtGui import QIcon, QImageReader, QPixmap
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QLineEdit,
    QListView,
    QListWidget,
    QListWidgetItem,
    QVBoxLayout,
    QWidget,
)

from cloner.booth.events import trash
from cloner.booth.photos.photo_files import photo_of
from cloner.booth.visitors.cached_work import RESULTS
from cloner.booth.visitors.versions import has_previous
from cloner.booth.visitors.visits import State, Visit, read_visit
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project.folder import safe_identifier
from cloner_gui.dialogs import ask_to_forget
from cloner_gui.event.booth import Booth
from cloner_gui.event.day_label import DayLabel
from cloner_gui.language.words import STATES, translate
from cloner_gui.widgets.flow import Flow
from cloner_gui.widgets.letters import assign_to_dialog
from cloner_gui.widgets.pieces import button, label, set_accessible_name, set_window_size

_ICON_PX = QSize(120, 160)
_EDGE_PX = 8  # around an entry, as the style sheet has it
#: What is shown: everybody, the cloned, those without a clone, who lies in the trash.
ALL, CLONED, OPEN, TRASHED = range(4)


class GalleryWindow(QDialog):
    """The event's visitors."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._booth = booth
        self.setWindowTitle(translate("gallery", "Everybody of today"))
        set_window_size(self, 900, 640)
        self.search, self.which, self.list = QLineEdit(), QComboBox(), QListWidget()
        self.told, self.numbers_label = label("dim"), label()
        self.numbers = DayLabel(booth, self)
        self.open_button, self.again_button, self.trash_button = button("main"), button(), button()
        self.before_button = button()
        self.back_button, self.forget_button, self.numbers_button = button(), button("danger"), button()
        self._icons: deque[QListWidgetItem] = deque()
        self._loader = QTimer(self, interval=0)
        self._loader.timeout.connect(self._load_one)
        self._soon = QTimer(self, singleShot=True, interval=0)  # one deed is told of several times
        self._soon.timeout.connect(self.show_all)
        self._known: dict[tuple[Path, int], QIcon] = {}
        self._lay_out()
        self._connect()
        self.show_all()
        assign_to_dialog(self)

    def _lay_out(self) -> None:
        self.list.setViewMode(QListView.ViewMode.IconMode)
        self.list.setResizeMode(QListView.ResizeMode.Adjust)
        self.list.setMovement(QListView.Movement.Static)
        self.list.setIconSize(_ICON_PX)
        self.list.setSpacing(8)
        self.list.setTextElideMode(Qt.TextElideMode.ElideNone)
        self.list.setWordWrap(True)
        self.list.setSelectionMode(QListWidget.SelectionMode.ExtendedSelection)
        self.search.setPlaceholderText(translate("gallery", "Name or number"))
        self.search.setClearButtonEnabled(True)
        for text in (
            translate("gallery", "everybody"),
            translate("gallery", "with a clone"),
            translate("gallery", "without a clone"),
            translate("gallery", "in the trash"),
        ):
            self.which.addItem(text)
        for widget, text in (
            (self.search, translate("gallery", "Search by name or number")),
            (self.which, translate("gallery", "Who is shown")),
            (self.list, translate("gallery", "Visitors of this event")),
        ):
            set_accessible_name(widget, text)
        for one, text in (
            (self.open_button, translate("gallery", "&Open")),
            (self.again_button, translate("gallery", "Clone &again")),
            (self.before_button, translate("gallery", "The clone be&fore")),
            (self.trash_button, translate("gallery", "&Throw away")),
            (self.back_button, translate("gallery", "&Bring back")),
            (self.forget_button, translate("gallery", "&Delete for good…")),
            (self.numbers_button, translate("gallery", "Save the &numbers of the days…")),
        ):
            one.setText(text)
        top, bottom, column = Flow(), Flow(), QVBoxLayout(self)
        for field in (self.search, self.which):
            top.addWidget(field)
        for one in (self.open_button, self.again_button, self.before_button, self.trash_button, self.back_button,
                    self.forget_button, self.numbers_button):  # fmt: skip
            bottom.addWidget(one)
        column.addLayout(top)
        column.addWidget(self.list, 1)
        column.addWidget(self.told)
        column.addWidget(self.numbers_label)
        column.addLayout(bottom)

    def _connect(self) -> None:
        self.search.textChanged.connect(self.show_all)
        self.which.currentIndexChanged.connect(self.show_all)
        self.list.itemSelectionChanged.connect(self._show_buttons)
        self.list.itemActivated.connect(lambda _: self._open())
        self.open_button.clicked.connect(self._open)
        self.again_button.clicked.connect(self._clone_again)
        self.before_button.clicked.connect(lambda: self._booth.bring_clone_before(*self.marked()))
        self.trash_button.clicked.connect(self._throw_away)
        self.back_button.clicked.connect(self._bring_back)
        self.forget_button.clicked.connect(lambda: self.marked() and ask_to_forget(self._booth, self.marked(), self))
        self.numbers_button.clicked.connect(lambda: self.numbers.save(self))
        self.numbers.changed.connect(lambda: self.numbers_label.setText(self.numbers.told()))
        self._booth.visits_changed.connect(self._soon.start)

    def marked(self) -> tuple[Path, ...]:
        """Return the folders of the marked visitors."""
        return tuple(item.data(Qt.ItemDataRole.UserRole) for item in self.list.selectedItems())

    def show_all(self) -> None:
        """Show who is wanted; the marks stay."""
        marked, root = self.marked(), self._booth.root
        in_trash = self.which.currentIndex() == TRASHED
        visits = self._booth.visits()
        if in_trash and root is not None:
            visits = {folder: read_visit(folder) for folder in trash.trashed_visitors(root)}
        shown = {folder: visit for folder, visit in visits.items() if self._is_wanted(folder, visit)}
        self._icons.clear()
        self.list.blockSignals(True)
        self.list.clear()
        for folder, visit in shown.items():
            state = self._told_end(folder) if in_trash else STATES[visit.state]
            if not state:
                continue  # gone between the look into the folder and this one
            item = QListWidgetItem(f"{self._booth.name_of(folder)}\n{state}")
            item.setData(Qt.ItemDataRole.UserRole, folder)
            self.list.addItem(item)
            item.setSelected(folder in marked)
            self._icons.append(item)
        self._make_room()
        self.list.blockSignals(False)
        cloned = sum(visit.state is State.CLONED for visit in shown.values())
        told = translate("gallery", "{n} visitors, {m} with a clone")
        self.told.setText(told.format(n=len(shown), m=cloned))
        self._loader.start()
        self.numbers.refresh()
        self._show_buttons()

    def _make_room(self) -> None:
        """Make all entries so large that the longest name and state have room below their picture."""
        letters = self.list.fontMetrics()
        wide = max(_ICON_PX.width() + 50, 9 * letters.height())
        room = QRect(0, 0, wide - 3 * _EDGE_PX, 9999)
        items = [self.list.item(row) for row in range(self.list.count())]
        wraps = Qt.TextFlag.TextWordWrap
        high = max((letters.boundingRect(room, wraps, item.text()).height() for item in items), default=0)
        for item in items:
            item.setSizeHint(QSize(wide, _ICON_PX.height() + high + 3 * _EDGE_PX))

    def _is_wanted(self, folder: Path, visit: Visit) -> bool:
        text, which = self.search.text().casefold().strip(), self.which.currentIndex()
        cloned = visit.state is State.CLONED
        fits = which in (ALL, TRASHED) or cloned == (which == CLONED)
        return fits and text in self._booth.name_of(folder).casefold()

    def _told_end(self, folder: Path) -> str:
        end = trash.deletion_time(folder, self._booth.settings.trash_days)
        if end is None:
            return ""
        return translate("gallery", "deleted for good on {when}").format(when=f"{end.astimezone():%d.%m. %H:%M}")

    def _show_buttons(self) -> None:
        marked, in_trash = len(self.marked()), self.which.currentIndex() == TRASHED
        self.open_button.setEnabled(marked == 1 and not in_trash)
        for one in (self.again_button, self.trash_button):
            one.setEnabled(marked > 0 and not in_trash)
        self.before_button.setEnabled(not in_trash and any(map(has_previous, self.marked())))
        self.trash_button.setVisible(self._booth.settings.trash_days > 0)
        self.back_button.setEnabled(marked > 0 and in_trash)
        self.forget_button.setEnabled(marked > 0)

    def _load_one(self) -> None:
        """Load one small picture at a time: hundreds at once would hold the window up."""
        if not self._icons:
            self._loader.stop()
            return
        item = self._icons.popleft()
        path = picture_of(item.data(Qt.ItemDataRole.UserRole))
        if path is None:
            return
        key = path, path.stat().st_mtime_ns
        if key not in self._known:
            reader = QImageReader(str(path))
            reader.setAutoTransform(True)
            size = reader.size()
            if size.isValid():
                reader.setScaledSize(size.scaled(_ICON_PX * 2, Qt.AspectRatioMode.KeepAspectRatio))
            self._known[key] = QIcon(QPixmap.fromImage(reader.read()))
        item.setIcon(self._known[key])

    # --- what the operator does -----------------------------------------------------

    def _open(self) -> None:
        for folder in self.marked()[:1]:
            if self.which.currentIndex() != TRASHED:
                self._booth.open_visitor(folder)
                self.close()

    def _clone_again(self) -> None:
        self._booth.clone_again(*self.marked())

    def _throw_away(self) -> None:
        self._booth.throw_away(*self.marked())

    def _bring_back(self) -> None:
        self._booth.bring_back(*self.marked())


def picture_of(folder: Path) -> Path | None:
    """Return a visitor's thumbnail: of the clone, else a photo; None without either."""
    previews = folder / RESULTS / safe_identifier(folder.name) / "previews"
    for path in (folder / "phone" / "picture.jpg", previews / "face.jpg", previews / "face.png"):
        if path.is_file():
            return path
    try:
        return photo_of(folder, ViewId.FACE_FRONT) or photo_of(folder, ViewId.BODY_FRONT)
    except ClonerError:
        return None
