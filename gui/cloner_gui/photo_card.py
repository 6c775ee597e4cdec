"""One of the five photos as a card: picture, what was found, and a menu of what can be done with it."""

from __future__ import annotations

from functools import partial
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QMimeData, QPoint, Qt, Signal
from PySide6.QtGui import QDrag, QDragEnterEvent, QDropEvent, QMouseEvent, QPixmap, QResizeEvent
from PySide6.QtWidgets import QApplication, QHBoxLayout, QLabel, QMenu, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from cloner.frames import ViewId
from cloner_gui.canvas.painting import pixmap_of
from cloner_gui.pieces import Card, label, name, restyle
from cloner_gui.words import VIEW_TITLES, translate

VIEW_MIME: Final = "application/x-cloner-view"


class Picture(QLabel):
    """A picture as large as there is room."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)
        self.setMinimumSize(60, 80)
        self._rgb: NDArray[np.uint8] | None = None
        self._whole: QPixmap | None = None

    def show_rgb(self, rgb: NDArray[np.uint8] | None) -> None:
        """Show an (H, W, 3) uint8 picture, or none; the same one again costs nothing."""
        if rgb is None or rgb is not self._rgb:
            self._rgb, self._whole = rgb, None if rgb is None else pixmap_of(rgb)
            self._fit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the picture into its new room."""
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        if self._whole is None:
            self.setPixmap(QPixmap())
            return
        ratio = self.devicePixelRatioF()
        mode = (Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation)
        fitted = self._whole.scaled(self.size() * ratio, *mode)
        fitted.setDevicePixelRatio(ratio)
        self.setPixmap(fitted)


class PhotoCard(Card):
    """A view's photo; its menu, drags and drops are signals."""

    add_wanted = Signal(object)
    exchange_wanted = Signal(object, object)
    turn_wanted = Signal(object)
    remove_wanted = Signal(object)
    tray_wanted = Signal(object)
    files_dropped = Signal(object, object)

    def __init__(self, view: ViewId, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.view = view
        self.setAcceptDrops(True)
        self.setMinimumWidth(110)
        self.heading, self.picture, self.verdict = label("heading"), Picture(), label("dim")
        self.menu_button = QToolButton()
        self.menu_button.setText("⋯")
        self.menu_button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.menu_button.setMenu(QMenu(self))
        self._press: QPoint | None = None
        self._has_photo = False
        self.column.setContentsMargins(10, 8, 10, 10)
        self.column.setSpacing(6)
        top = QHBoxLayout()
        top.addWidget(self.heading, 1)
        top.addWidget(self.menu_button)
        self.column.addLayout(top)
        self.column.addWidget(self.picture, 1)
        self.column.addWidget(self.verdict)

    def show_photo(self, rgb: NDArray[np.uint8] | None, verdict: str, *, fine: bool) -> None:
        """Show a photo with what was found; None shows an empty place."""
        self._has_photo = rgb is not None
        self.picture.show_rgb(rgb)
        if rgb is None:
            self.picture.setText(translate("photos", "Drop a photo here"))
        self.verdict.setText(verdict)
        restyle(self.verdict, "good" if fine else "dim" if rgb is None else "warn")
        title = VIEW_TITLES[self.view]
        self.heading.setText(title)
        name(self.menu_button, translate("photos", "What to do with {photo}").format(photo=title))
        self.setAccessibleName(f"{title}: {verdict}")
        self._fill_menu()

    def _fill_menu(self) -> None:
        menu = self.menu_button.menu()
        menu.clear()
        view = self.view
        chosen = translate("photos", "Replace…") if self._has_photo else translate("photos", "Choose…")
        menu.addAction(chosen, lambda: self.add_wanted.emit(view))
        exchange = menu.addMenu(translate("photos", "Exchange with"))
        for other in ViewId:
            if other is not view:
                exchange.addAction(VIEW_TITLES[other], partial(self.exchange_wanted.emit, view, other))
        for text, signal in (
            (translate("photos", "Turn right"), self.turn_wanted),
            (translate("photos", "Take out"), self.tray_wanted),
            (translate("photos", "Delete"), self.remove_wanted),
        ):
            menu.addAction(text, partial(signal.emit, view)).setEnabled(self._has_photo)
        exchange.setEnabled(self._has_photo)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of the photo."""
        self._press = event.position().toPoint() if self._has_photo else None

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Carry the photo to another card."""
        far = QApplication.startDragDistance()
        if self._press is None or (event.position().toPoint() - self._press).manhattanLength() < far:
            return
        self._press = None
        carried = QMimeData()
        carried.setData(VIEW_MIME, self.view.value.encode())
        drag = QDrag(self)
        drag.setMimeData(carried)
        drag.setPixmap(self.picture.pixmap().scaledToHeight(160))
        drag.exec(Qt.DropAction.MoveAction)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Take files and other cards' photos."""
        if event.mimeData().hasUrls() or event.mimeData().hasFormat(VIEW_MIME):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """Take what was let go here."""
        data = event.mimeData()
        if data.hasFormat(VIEW_MIME):
            other = ViewId(bytes(data.data(VIEW_MIME).data()).decode())
            if other is not self.view:
                self.exchange_wanted.emit(self.view, other)
        else:
            self.files_dropped.emit(self.view, data)
        event.acceptProposedAction()


class TrayCard(Card):
    """A photo that shows no view yet; its menu gives it a place."""

    use_wanted = Signal(object)
    remove_wanted = Signal()

    def __init__(self, rgb: NDArray[np.uint8], number: int, verdict: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.column.setContentsMargins(6, 6, 6, 6)
        picture = Picture()
        picture.setFixedSize(72, 96)
        picture.show_rgb(rgb)
        self.menu_button = QToolButton()
        self.menu_button.setText(translate("photos", "Use as…"))
        self.menu_button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(self)
        for view in ViewId:
            menu.addAction(VIEW_TITLES[view], partial(self.use_wanted.emit, view))
        menu.addSeparator()
        menu.addAction(translate("photos", "Delete"), self.remove_wanted.emit)
        self.menu_button.setMenu(menu)
        name(self.menu_button, translate("photos", "Photo {n} without a place").format(n=number), verdict)
        row = QHBoxLayout()
        row.addWidget(picture)
        side = QVBoxLayout()
        told = label("warn" if verdict else "dim")
        told.setText(verdict)
        told.setMaximumWidth(180)
        side.addWidget(told, 1)
        side.addWidget(self.menu_button)
        row.addLayout(side)
        self.column.addLayout(row)
