"""One of the five photos as a card: picture, findings, and a menu."""

from __future__ import annotations

from functools import partial
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QMimeData, QPoint, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QDrag, QDragEnterEvent, QDropEvent, QKeyEvent, QMouseEvent, QPixmap, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QApplication, QHBoxLayout, QLabel, QMenu, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from cloner.frames import ViewId
from cloner_gui.canvas.photos.painting import to_pixmap
from cloner_gui.canvas.photos.poses import pose_picture
from cloner_gui.language.words import VIEW_TITLES, translate
from cloner_gui.widgets.pieces import Card, label, restyle, set_accessible_name

VIEW_MIME: Final = "application/x-cloner-view"


class Picture(QLabel):
    """A picture that fills the available space."""

    resized = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(60, 130)
        self._rgb: NDArray[np.uint8] | None = None
        self._whole: QPixmap | None = None
        self._pose: ViewId | None = None
        self._draw_soon = QTimer(self, singleShot=True, interval=0)
        self._draw_soon.timeout.connect(self._draw_pose)

    def sizeHint(self) -> QSize:
        """Return the least size: what is shown takes what room there is, and asks for none."""
        return self.minimumSize()

    def minimumSizeHint(self) -> QSize:
        """Return the least size: the picture that is shown must not keep the room it was given."""
        return self.minimumSize()

    def show_rgb(self, rgb: NDArray[np.uint8] | None) -> None:
        """Show an (H, W, 3) uint8 picture, or none; the same one again costs nothing."""
        if rgb is None or rgb is not self._rgb:
            self._rgb, self._whole = rgb, None if rgb is None else to_pixmap(rgb)
            self._fit()

    def show_pose(self, view: ViewId) -> None:
        """Show how to stand for a photo that is still to be taken."""
        self._rgb, self._whole, self._pose = None, None, view
        self._fit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the picture into its new room."""
        super().resizeEvent(event)
        self._fit()
        self.resized.emit()

    def _draw_pose(self) -> None:
        """Draw how to stand, or nothing."""
        drawn, ratio = QPixmap(), self.devicePixelRatioF()
        if self._pose is not None:
            palette = self.palette()
            ink, paper = palette.placeholderText().color(), palette.window().color()
            drawn = pose_picture(self._pose, (self.size() * ratio).expandedTo(QSize(8, 8)), ink, paper)
            drawn.setDevicePixelRatio(ratio)
        self.setPixmap(drawn)

    def showEvent(self, event: QShowEvent) -> None:
        """Draw what was shown meanwhile."""
        super().showEvent(event)
        self._fit()

    def _fit(self) -> None:
        if not self.isVisible():
            return  # drawn when it is seen
        ratio = self.devicePixelRatioF()
        if self._whole is None:
            self._draw_soon.start()  # five figures at once would hold the window up
            return
        self._draw_soon.stop()
        mode = (Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation)
        fitted = self._whole.scaled(self.size() * ratio, *mode)
        fitted.setDevicePixelRatio(ratio)
        self.setPixmap(fitted)


class PhotoCard(Card):
    """A view's photo; its menu, drags and drops emit signals."""

    add_wanted = Signal(object)
    exchange_wanted = Signal(object, object)
    turn_wanted = Signal(object)
    remove_wanted = Signal(object)
    tray_wanted = Signal(object)
    files_dropped = Signal(object, object)
    whole_wanted = Signal(object)
    """The photo is to be seen at its full size."""

    def __init__(self, view: ViewId, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.view = view
        self.setAcceptDrops(True)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.heading, self.picture, self.verdict = label("heading"), Picture(), label("dim")
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.menu_button = QToolButton()
        self.menu_button.setText("⋯")
        self.menu_button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.menu_button.setMenu(QMenu(self))
        self._press: QPoint | None = None
        self._has_photo = False
        self.column.setContentsMargins(10, 8, 10, 10)
        self.column.setSpacing(6)
        self.menu_button.setParent(self.picture)  # over the picture: a narrow card has no room beside its heading
        self.picture.resized.connect(self._place_menu)
        self.column.addWidget(self.heading)
        self.column.addWidget(self.picture, 1)
        self.column.addWidget(self.verdict)

    def minimumSizeHint(self) -> QSize:
        """Return a width in which the longest words of what is wrong fit; five cards beside each other as a rule."""
        return super().minimumSizeHint().expandedTo(QSize(9 * self.fontMetrics().height(), 0))

    def sizeHint(self) -> QSize:
        """Return no more than the least width: cards share what there is."""
        return QSize(self.minimumSizeHint().width(), super().sizeHint().height())

    def show_photo(self, rgb: NDArray[np.uint8] | None, verdict: str, *, fine: bool) -> None:
        """Show a photo with what was found; None shows an empty place."""
        self._has_photo = rgb is not None
        self.picture.show_rgb(rgb)
        if rgb is None:
            self.picture.show_pose(self.view)
            verdict = translate("photos", "Drop a photo here")
        self.verdict.setText(verdict)
        restyle(self.verdict, "good" if fine else "dim" if rgb is None else "warn")
        title = VIEW_TITLES[self.view]
        self.heading.setText(title)
        set_accessible_name(self.menu_button, translate("photos", "What to do with {photo}").format(photo=title))
        self.setAccessibleName(f"{title}: {verdict}")
        keys = translate("photos", "Return shows or chooses the photo, Space tells what else can be done.")
        self.setAccessibleDescription(keys)
        self._fill_menu()

    def event(self, event: QEvent) -> bool:
        """Place the menu's button anew where letters have grown."""
        done = super().event(event)
        if event.type() == QEvent.Type.LayoutRequest:
            self._place_menu()
        return done

    def _place_menu(self) -> None:
        size = self.menu_button.sizeHint()
        left = 0 if self.isRightToLeft() else self.picture.width() - size.width()
        self.menu_button.setGeometry(left, 0, size.width(), size.height())

    def _fill_menu(self) -> None:
        menu = self.menu_button.menu()
        menu.clear()
        view = self.view
        if self._has_photo:
            menu.addAction(translate("photos", "See it large"), lambda: self.whole_wanted.emit(view))
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

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Show the photo at its full size, or choose one."""
        (self.whole_wanted if self._has_photo else self.add_wanted).emit(self.view)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Do by keys what the mouse does: Return shows the photo, Space opens the menu, Delete deletes."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            (self.whole_wanted if self._has_photo else self.add_wanted).emit(self.view)
        elif event.key() in (Qt.Key.Key_Space, Qt.Key.Key_Menu):
            self.menu_button.showMenu()
        elif event.key() == Qt.Key.Key_Delete and self._has_photo:
            self.tray_wanted.emit(self.view)
        else:
            super().keyPressEvent(event)

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
    """A photo without a view; its menu assigns one."""

    use_wanted = Signal(object)
    remove_wanted = Signal()

    def __init__(self, rgb: NDArray[np.uint8], number: int, verdict: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.column.setContentsMargins(6, 6, 6, 6)
        picture = Picture()
        picture.setMinimumSize(0, 0)
        picture.setFixedSize(60, 80)
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
        set_accessible_name(
            self.menu_button, translate("photos", "Photo {n} without a place").format(n=number), verdict
        )
        row = QHBoxLayout()
        row.addWidget(picture)
        side = QVBoxLayout()
        told = label("warn" if verdict else "dim")
        told.setText(verdict)
        told.setMinimumWidth(120)
        told.setMaximumWidth(260)
        side.addWidget(told, 1)
        side.addWidget(self.menu_button)
        row.addLayout(side)
        self.column.addLayout(row)
