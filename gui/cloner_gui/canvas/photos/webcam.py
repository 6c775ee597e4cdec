"""Photos from a camera at this computer: its live picture under an outline of how to stand."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF, Qt, QTimer, Signal
from PySide6.QtGui import QCloseEvent, QColor, QPainter, QPainterPath, QPaintEvent, QPen
from PySide6.QtWidgets import QComboBox, QDialog, QVBoxLayout, QWidget

from cloner.booth.photos.camera import Camera, Webcam, limit_height, rotate_file, rotate_quarters
from cloner.booth.photos.tethered import Tethered
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner_gui.background.worker import Kept
from cloner_gui.canvas.photos.painting import to_pixmap
from cloner_gui.canvas.photos.poses import pose_outline as pose_outline
from cloner_gui.language.words import VIEW_TITLES, translate
from cloner_gui.widgets.flow import Flow
from cloner_gui.widgets.pieces import button, label, set_accessible_name

#: Time between button and photo, seconds, so that the operator can look at the visitor again (taste).
COUNTDOWN_S: Final = 3
_LIVE_PX: Final = 720  # height of the live picture; the photo itself keeps all that the camera gives
_COUNT_SHARE: Final = 0.5  # of the picture's height; 10 cm on a small screen are read from 3 m
_PAUSE_S: Final = 0.04  # 25 pictures a second are smooth, more only warm the machine


class FrameGrabber(Kept):
    """Reads a camera in a background thread; only the latest picture counts."""

    seen = Signal()
    shot = Signal(bytes)
    failed = Signal(object)

    def __init__(self, make: Callable[[], Camera]) -> None:
        super().__init__()
        self._make = make
        self._shown, self._wanted = threading.Event(), threading.Event()
        self._shown.set()
        self.newest: NDArray[np.uint8] | None = None
        self.small: NDArray[np.uint8] | None = None

    def run(self) -> None:
        """Read until it is enough; Qt calls this on the new thread."""
        try:
            camera = self._make()
        except ClonerError as error:
            self.failed.emit(error)
            return
        try:
            while not self._cancelled.is_set():
                if self._wanted.is_set():
                    self._wanted.clear()
                    self.shot.emit(camera.shoot())
                picture = camera.read()
                if picture is None:
                    self.failed.emit(ClonerError("the camera gives no pictures any more", "Plug it in again", "Camera"))
                    return
                self.newest, self.small = picture, limit_height(picture, _LIVE_PX)
                if self._shown.is_set():  # a slow window skips pictures instead of piling them up
                    self._shown.clear()
                    self.seen.emit()
                time.sleep(_PAUSE_S)
        except ClonerError as error:
            self.failed.emit(error)
        finally:
            camera.close()

    def shoot(self) -> None:
        """Have a photo taken; ``shot`` tells it."""
        self._wanted.set()

    def shown(self) -> None:
        """Say that the newest picture is on the screen."""
        self._shown.set()

    def stop(self) -> None:
        """End, and wait for it."""
        self.cancel()
        self.wait()


class GuidedPicture(QWidget):
    """The live picture, with the outline of the wanted pose over it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMinimumSize(300, 340)
        self.picture: NDArray[np.uint8] | None = None
        self.view = ViewId.BODY_FRONT
        self.count = ""

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw picture, outline and countdown."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.fillRect(self.rect(), QColor(20, 22, 26))
        room = QRectF(self.rect())
        if self.picture is not None:
            high, wide = self.picture.shape[:2]
            scale = min(self.width() / wide, self.height() / high)
            room = QRectF(0, 0, wide * scale, high * scale)
            room.moveCenter(QRectF(self.rect()).center())
            painter.drawPixmap(room, to_pixmap(self.picture), QRectF(0, 0, wide, high))
        outline = pose_outline(self.view, room)
        for colour, width in ((QColor(0, 0, 0, 150), 6), (QColor(255, 255, 255, 230), 2.5)):
            painter.setPen(QPen(colour, width, Qt.PenStyle.DashLine if width < 4 else Qt.PenStyle.SolidLine))
            painter.drawPath(outline)
        if self.count:
            self._draw_count(painter)

    def _draw_count(self, painter: QPainter) -> None:
        """Draw the number that counts down so large that the visitor reads it from three metres, on whatever ground."""
        font, number = painter.font(), QPainterPath()
        font.setPixelSize(max(round(_COUNT_SHARE * self.height()), 1))
        font.setBold(True)
        number.addText(0.0, 0.0, font, self.count)
        number.translate(QRectF(self.rect()).center() - number.boundingRect().center())
        painter.setPen(QPen(QColor(0, 0, 0), font.pixelSize() / 24.0))
        painter.setBrush(QColor(255, 255, 255))
        painter.drawPath(number)


class WebcamDialog(QDialog):
    """Takes photos until it is closed.

    Parameters
    ----------
    view : ViewId
        Whose outline is shown first.
    make, tethered : callable
        Open the webcam, and the camera on a cable; called off the window's thread.
    """

    taken = Signal(bytes, object)
    failed = Signal(object)

    def __init__(
        self,
        view: ViewId,
        parent: QWidget | None = None,
        make: Callable[[], Camera] = Webcam,
        tethered: Callable[[], Camera] = Tethered,
    ) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(translate("webcam", "Webcam"))
        self.live, self.views, self.sources = GuidedPicture(), QComboBox(), QComboBox()
        self._makers = (make, tethered)
        self.take_button, self.turn_button, self.hint = button("main"), button(), label("dim")
        self._quarters, self._left = 0, 0
        self._timer = QTimer(self, interval=1000)
        self._timer.timeout.connect(self._count)
        for one in ViewId:
            self.views.addItem(VIEW_TITLES[one], one)
        self.views.setCurrentIndex(list(ViewId).index(view))
        self._lay_out()
        self._grabber = self._grab(make)
        self.sources.currentIndexChanged.connect(self._change_source)
        self.views.currentIndexChanged.connect(self._choose)
        self.take_button.clicked.connect(self.take)
        self.turn_button.clicked.connect(self._turn)
        self._choose()
        self._grabber.start()

    def _grab(self, make: Callable[[], Camera]) -> FrameGrabber:
        grabber = FrameGrabber(make)
        grabber.seen.connect(self._show)
        grabber.shot.connect(self._take)
        grabber.failed.connect(self._fail)
        self.destroyed.connect(grabber.cancel)  # also where a window around it goes without closing it
        return grabber

    def _change_source(self, number: int) -> None:
        """Look through the other camera."""
        self._grabber.stop()
        self.live.picture = None
        self._grabber = self._grab(self._makers[number])
        self._grabber.start()

    def take(self) -> None:
        """Take a photo after the countdown."""
        self._left = COUNTDOWN_S
        self.live.count = str(self._left)
        self.live.update()
        self._timer.start()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Let the camera go."""
        self._grabber.stop()
        super().closeEvent(event)

    def done(self, code: int) -> None:
        """Let the camera go, also when Escape closes the dialog."""
        self._timer.stop()
        self._grabber.stop()
        super().done(code)

    def _lay_out(self) -> None:
        self.take_button.setText(translate("webcam", "&Take the photo"))
        self.turn_button.setText(translate("webcam", "T&urn the picture"))
        self.hint.setText(translate("webcam", "Fill the outline, and keep all of it in the picture."))
        self.sources.addItem(translate("webcam", "Webcam"))
        self.sources.addItem(translate("webcam", "Camera on a cable"))
        set_accessible_name(self.sources, translate("webcam", "Which camera takes it"))
        set_accessible_name(self.views, translate("webcam", "Which photo is taken"))
        set_accessible_name(self.live, translate("webcam", "Live picture"))
        row, column = Flow(), QVBoxLayout(self)
        for one in (self.sources, self.views, self.turn_button, self.take_button):
            row.addWidget(one)
        column.addWidget(self.live, 1)
        column.addWidget(self.hint)
        column.addLayout(row)

    def _choose(self) -> None:
        self.live.view = ViewId(self.views.currentData())  # Qt hands a text back
        self.live.update()

    def _turn(self) -> None:
        self._quarters = (self._quarters + 1) % 4

    def _show(self) -> None:
        if self._grabber.small is not None:
            self.live.picture = rotate_quarters(self._grabber.small, self._quarters)
            self.live.update()
        self._grabber.shown()

    def _count(self) -> None:
        self._left -= 1
        self.live.count = str(self._left) if self._left > 0 else ""
        self.live.update()
        if self._left <= 0:
            self._timer.stop()
            if self._grabber.newest is not None:
                self._grabber.shoot()

    def _take(self, data: bytes) -> None:
        """Hand the photo over as the camera wrote it, turned where the picture is, and go on to the next view."""
        self.taken.emit(rotate_file(data, self._quarters), ViewId(self.views.currentData()))
        self._next()

    def _next(self) -> None:
        """Show the outline of the next view."""
        self.views.setCurrentIndex(min(self.views.currentIndex() + 1, self.views.count() - 1))

    def _fail(self, error: ClonerError) -> None:
        self.failed.emit(error)
        self.close()
