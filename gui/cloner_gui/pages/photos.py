"""Second page: photos arrive, are assigned to views, and checked while the visitor is still there."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QBuffer, QByteArray, QEvent, QIODevice, QMimeData, Qt, QTimer, Signal
from PySide6.QtGui import QDragEnterEvent, QDropEvent, QGuiApplication, QImage
from PySide6.QtWidgets import QFileDialog, QHBoxLayout, QScrollArea, QToolButton, QVBoxLayout, QWidget

from cloner.booth.photos import photo_files
from cloner.frames import ViewId
from cloner.project.folder import SUFFIXES
from cloner_gui.canvas.photos.photo_card import PhotoCard, TrayCard
from cloner_gui.canvas.photos.webcam import WebcamDialog
from cloner_gui.canvas.photos.whole_photo import WholePhoto
from cloner_gui.event.booth import Booth
from cloner_gui.event.leaving import has_front
from cloner_gui.language.told import translated as told_text
from cloner_gui.language.words import TROUBLES, VIEW_TITLES, translate, what_is_missing
from cloner_gui.language.worth import uncertain_text
from cloner_gui.widgets.flow import Flow
from cloner_gui.widgets.letters import escape_mnemonic, without_mnemonic
from cloner_gui.widgets.pieces import GAP, button, label, make_scrollable, set_accessible_name

#: Points are sought when photos have rested so long, milliseconds: looking at new ones comes first.
_SEEK_AFTER_MS = 500


class PhotosPage(QWidget):
    """Five places for photos, and a tray for those without one."""

    changed = Signal()

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._booth = booth
        self.setAcceptDrops(True)
        self.add_button, self.paste_button, self.watch_button = button("main"), button(), button()
        self.webcam_button, self.unwatch_button = button(), QToolButton()
        self.unwatch_button.setText("✕")
        self.worth_label = label()
        self.cards = {view: PhotoCard(view) for view in ViewId}
        self.missing_label, self.busy_label, self.tray_label = label(), label("dim", wraps=False), label("heading")
        self.tray = QScrollArea()
        self.tray.setWidgetResizable(True)
        self.tray.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.tray.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._seek_soon = QTimer(self, singleShot=True, interval=_SEEK_AFTER_MS)
        self._seek_soon.timeout.connect(self._seek)
        self._lay_out()
        self._connect()
        self._speak()

    def why_not(self) -> str:
        """Return why the next page cannot come yet, or an empty string."""
        views = self._booth.session.photos.photos
        if not views:
            return translate("photos", "Add the photos first.")
        if not has_front(self._booth.session):
            return what_is_missing(views)
        return ""

    def _lay_out(self) -> None:
        top, cards, inside = Flow(), Flow(), QWidget()
        for one in (self.add_button, self.paste_button, self.webcam_button, self.watch_button, self.unwatch_button):
            top.addWidget(one)
        top.addWidget(self.busy_label)
        cards.setSpacing(GAP)
        for card in self.cards.values():
            cards.addWidget(card)
        column = QVBoxLayout(inside)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(GAP)
        column.addLayout(top)
        column.addLayout(cards, 1)
        column.addWidget(self.missing_label)
        column.addWidget(self.worth_label)
        column.addWidget(self.tray_label)
        column.addWidget(self.tray)
        make_scrollable(self, inside)

    def _connect(self) -> None:
        booth, intake = self._booth, self._booth.intake
        self.add_button.clicked.connect(lambda: self.choose(None))
        self.paste_button.clicked.connect(self.paste)
        self.watch_button.clicked.connect(self._choose_camera_folder)
        self.webcam_button.clicked.connect(self._open_webcam)
        self.unwatch_button.clicked.connect(lambda: booth.change(camera_folder=""))
        booth.session.points_changed.connect(self._show_worth)
        booth.session.busy_changed.connect(self._seek_soon.start)
        for card in self.cards.values():
            card.add_wanted.connect(self.choose)
            card.whole_wanted.connect(self._show_whole)
            card.exchange_wanted.connect(self._exchange)
            card.turn_wanted.connect(self._on_file(photo_files.rotate_right))
            card.remove_wanted.connect(self._on_file(photo_files.remove))
            card.tray_wanted.connect(self._to_tray)
            card.files_dropped.connect(lambda view, data: self.take(data, view))
        booth.session.opened.connect(self._show)
        booth.event_changed.connect(self._speak)
        intake.busy_changed.connect(self._show_busy)

    def changeEvent(self, event: QEvent) -> None:
        """Speak another language."""
        if event.type() == QEvent.Type.LanguageChange:
            self._speak()
        super().changeEvent(event)

    def _speak(self) -> None:
        camera = self._booth.settings.camera_folder
        self.add_button.setText(translate("photos", "&Add photos…"))
        self.paste_button.setText(translate("photos", "&Paste"))
        watched = translate("photos", "Camera folder: {name}").format(name=Path(camera).name)
        wanted = translate("photos", "&Camera folder…")
        self.watch_button.setText(escape_mnemonic(watched) if camera else wanted)
        self.webcam_button.setText(translate("photos", "&Webcam…"))
        told = translate("photos", "Photos that appear in this folder are taken at once")
        self.unwatch_button.setVisible(bool(camera))
        set_accessible_name(self.unwatch_button, translate("photos", "Watch no camera folder any more"))
        set_accessible_name(self.watch_button, watched if camera else without_mnemonic(wanted), told)
        self.tray_label.setText(translate("photos", "Photos without a place"))
        self._show()

    def _show(self) -> None:
        """Show the open visitor's photos."""
        session = self._booth.session
        for view, card in self.cards.items():
            photo = session.photos.photos.get(view)
            check = None if photo is None else session.checks.get(photo.digest)
            verdict = "" if photo is None else translate("photos", "Being looked at…")
            if check is not None:
                good = translate("photos", "✓ Good")
                verdict = " ".join(TROUBLES[one] for one in check.troubles_as(view)) or good
            fine = check is not None and not check.troubles_as(view)
            card.show_photo(session.thumbnails.get(view), verdict, fine=fine)
        told = [what_is_missing(session.photos.photos), *(told_text(text) for text in session.warnings)]
        if session.photos.photos and not session.consent:
            told.append(translate("photos", "No consent is recorded: new photos are not stored."))
        self.missing_label.setText("\n".join(told))
        self._show_tray()
        self._show_busy()
        self._show_worth()
        self.changed.emit()

    def _show_tray(self) -> None:
        session = self._booth.session
        inside = QWidget()
        row = QHBoxLayout(inside)
        row.setContentsMargins(0, 0, 0, 0)
        for number, photo in enumerate(session.tray, start=1):
            check = session.checks.get(photo.digest)
            verdict = "" if check is None else " ".join(TROUBLES[one] for one in check.troubles)
            card = TrayCard(photo.thumbnail, number, verdict)
            card.use_wanted.connect(partial(self._use, photo.path))
            card.remove_wanted.connect(partial(self._booth.intake.edit, partial(photo_files.remove, photo.path)))
            row.addWidget(card)
        row.addStretch(1)
        self.tray.setWidget(inside)
        if session.tray:  # as high as the highest card, with room for the bar that scrolls
            bar = self.tray.horizontalScrollBar().sizeHint().height()
            self.tray.setFixedHeight(inside.sizeHint().height() + bar + 4)
        self.tray.setVisible(bool(session.tray))
        self.tray_label.setVisible(bool(session.tray))

    def _show_busy(self) -> None:
        count = self._booth.intake.pending()
        text = translate("photos", "Looking at photos: {n} to go").format(n=count)
        self.busy_label.setText(text if count else "")
        self.setEnabled(self._booth.session.folder is not None)
        if not count:
            self._seek_soon.start()
        self.changed.emit()

    def _seek(self) -> None:
        """Find the points while the operator still looks at the photos: the next page is then only for doubts."""
        booth = self._booth
        if self.isVisible() and not booth.intake.pending() and booth.session.consent and has_front(booth.session):
            booth.session.propose()

    def _show_worth(self) -> None:
        """Say which points are worth a look before cloning, and what they change; or that none is."""
        session = self._booth.session
        points = {view: session.points(view) for view in session.photos.photos}
        known = {view: one for view, one in points.items() if one is not None}
        self.worth_label.setText(uncertain_text(known) if known else "")
        self.worth_label.setVisible(bool(known))

    def _show_whole(self, view: ViewId) -> None:
        """Show a photo at its full size."""
        photo = self._booth.session.photos.photos.get(view)
        if photo is not None:
            WholePhoto(VIEW_TITLES[view], self.cards[view].verdict.text(), photo.rgb, self).open()

    # --- what the operator does -------------------------------------------------

    def choose(self, view: ViewId | None) -> None:
        """Ask for photo files, for one view or for whichever they show."""
        kinds = " ".join(f"*{suffix}" for suffix in SUFFIXES)
        text = translate("photos", "Photos of the visitor")
        files, _ = QFileDialog.getOpenFileNames(self, text, "", f"{translate('photos', 'Photos')} ({kinds})")
        self._booth.intake.add_files([Path(one) for one in files], view)

    def paste(self) -> None:
        """Take the clipboard's photo or files."""
        self.take(QGuiApplication.clipboard().mimeData(), None)

    def take(self, data: QMimeData, view: ViewId | None) -> None:
        """Take files, all photos of folders, or a picture."""
        intake = self._booth.intake
        if data.hasUrls():
            paths = [Path(url.toLocalFile()) for url in data.urls() if url.isLocalFile()]
            intake.add_files([photo for path in paths for photo in photo_files.photos_in(path)], view)
        elif data.hasImage():
            intake.add_bytes(_png_bytes(data.imageData()), ".png", view)

    def _exchange(self, one: ViewId, other: ViewId) -> None:
        folder = self._booth.session.folder
        if folder is not None:
            self._booth.intake.edit(lambda: photo_files.swap_views(folder, one, other))

    def _use(self, path: Path, view: ViewId) -> None:
        folder = self._booth.session.folder
        if folder is not None:
            self._booth.intake.edit(lambda: photo_files.assign_view(folder, path, view))

    def _to_tray(self, view: ViewId) -> None:
        folder, path = self._booth.session.folder, self._path(view)
        if folder is not None and path is not None:
            self._booth.intake.edit(lambda: photo_files.move_to_tray(folder, path))

    def _on_file(self, edit: Callable[[Path], None]) -> Callable[[ViewId], None]:
        def act(view: ViewId) -> None:
            path = self._path(view)
            if path is not None:
                self._booth.intake.edit(partial(edit, path))

        return act

    def _path(self, view: ViewId) -> Path | None:
        folder = self._booth.session.folder
        return None if folder is None else photo_files.photo_of(folder, view)

    def _choose_camera_folder(self) -> None:
        """Ask for the folder of a tethered camera; who asks for none keeps the one there is."""
        text = translate("photos", "Folder where the camera drops its photos")
        chosen = QFileDialog.getExistingDirectory(self, text)
        if chosen:
            self._booth.change(camera_folder=chosen)

    def _open_webcam(self) -> None:
        dialog = WebcamDialog(self._next_view(), self)
        dialog.taken.connect(lambda data, view: self._booth.intake.add_bytes(data, ".jpg", view))
        dialog.failed.connect(self._booth.failed)
        dialog.open()

    def _next_view(self) -> ViewId:
        """Return the first view that has no photo."""
        present = self._booth.session.photos.photos
        return next((view for view in ViewId if view not in present), ViewId.BODY_FRONT)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Take files and pictures."""
        if event.mimeData().hasUrls() or event.mimeData().hasImage():
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """Take what was dropped beside the cards: each photo finds its own place."""
        self.take(event.mimeData(), None)


def _png_bytes(image: QImage) -> bytes:
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    image.save(buffer, "PNG")  # type: ignore[call-overload]
    return bytes(data.data())
