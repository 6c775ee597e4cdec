"""The clone in 3-D: rotated, zoomed, in several display modes, over a photo, and moving."""

from __future__ import annotations

import functools
import time
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QPointF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QImage, QKeyEvent, QMouseEvent, QPixmap, QShowEvent, QTouchEvent, QWheelEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.motions import Motion
from cloner_gui.background.newest import shared_latest
from cloner_gui.canvas.clones.acting import MODES, MOTIONS, OUTLINE, find_motion
from cloner_gui.canvas.clones.orbit import Orbit
from cloner_gui.canvas.clones.scene import Scene
from cloner_gui.canvas.photos.touch import TouchHand

Image = NDArray[np.uint8]

_RADIANS_PER_PIXEL: Final = 0.01  # taste: half a turn for a drag over 300 px
_KEY_PIXELS: Final = 20.0  # what an arrow key turns, as if dragged so far
_ZOOM_STEP: Final = 1.15
_FINE_AFTER_MS: Final = 200  # edges are smoothed when nothing moved for so long
_FRAME_MS: Final = 40  # between two pictures of a motion
_LEAST_PX: Final = 160  # width without a picture


class Preview(QLabel):
    """Shows a clone. Dragging rotates it, with Shift or the right button moves it; the wheel zooms, a double click
    resets.

    Arrow keys turn, + and - zoom, Home resets; one finger turns, two zoom and move.
    """

    failed = Signal(object)
    drawn = Signal()
    touched = Signal()
    """A hand, a key or a wheel turned, moved or zoomed the clone."""
    _empty_text = ""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setWordWrap(True)
        self.setMinimumSize(_LEAST_PX, 200)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_AcceptTouchEvents)
        self._empty_text = self.tr("Press Clone: after about a minute the person stands here.")
        self.mode, self.motion_kind, self.opacity = "textured", "stand", 1.0
        self.shown: Scene | None = None  # what the picture on the screen shows: it lags behind what is asked for
        self._clone: Clone | None = None
        self._motion: Motion | None = None
        self._gaps_mm: Array | None = None
        self._overlay: tuple[ViewId, Image] | None = None
        self._orbit, self._touch = Orbit(), TouchHand(self)
        self._held: QPointF | None = None
        self._pans = self._broken = False
        self._began, self._person = 0.0, 0
        self._spin_s, self._spun_from = 0.0, 0.0
        self._soon = QTimer(self, singleShot=True, interval=0)
        self._soon.timeout.connect(lambda: self._draw(fine=False))
        self._later = QTimer(self, singleShot=True, interval=_FINE_AFTER_MS)
        self._later.timeout.connect(lambda: self._draw(fine=True))
        self._film = QTimer(self, interval=_FRAME_MS)
        self._film.timeout.connect(self.refresh)
        self.setText(self._empty_text)
        self._speak()

    def sizeHint(self) -> QSize:
        """Return the least size: the picture takes what room there is, and asks for none."""
        return self.minimumSize()

    def minimumSizeHint(self) -> QSize:
        """Return the least size: the picture that is shown must not keep the room it was given."""
        return self.minimumSize()

    def _speak(self) -> None:
        self.setAccessibleName(self.tr("The clone in three dimensions"))

    def say_when_empty(self, text: str) -> None:
        """Say something else where nobody is shown."""
        self._empty_text = text
        self._make_room()
        if self._clone is None:
            self.setText(text)

    def _make_room(self) -> None:
        """Be no narrower than the longest word that is said where nobody is shown."""
        longest = max(map(self.fontMetrics().horizontalAdvance, self._empty_text.split()), default=0)
        self.setMinimumSize(max(_LEAST_PX, longest), 200)

    # --- what is shown -------------------------------------------------------

    def set_clone(self, clone: Clone | None) -> None:
        """Show a clone from the front, standing; a picture of the one before that is still drawn is never shown."""
        self._gaps_mm, self._broken = None, False
        self._person += 1
        self.update_clone(clone)
        self.play("stand")
        self.frame("front")

    def update_clone(self, clone: Clone | None) -> None:
        """Show a clone from where the last one was seen, doing what it did."""
        self._clone = clone
        if clone is None:
            self._film.stop()
            self.setText(self._empty_text)
        elif self.pixmap().isNull():
            self.setText("")  # it is being drawn: nobody has to press Clone any more
        self.refresh()

    def set_mode(self, mode: str) -> None:
        """Show one of `MODES`."""
        if mode not in (*MODES, OUTLINE):
            raise ValueError(f"{mode!r} is no mode; known are {', '.join(MODES)}")
        self.mode = mode
        self.refresh()

    def set_gaps(self, gaps_mm: Array | None) -> None:
        """Take the distances (V,) that the mode "gaps" paints, mm."""
        self._gaps_mm = gaps_mm
        self.refresh()

    def set_overlay(self, view: ViewId | None, rgb: Image | None = None) -> None:
        """Show the clone over a photo (H, W, 3), through that photo's camera; None shows it alone."""
        self._overlay = None if view is None or rgb is None else (view, rgb)
        self.refresh()

    def set_opacity(self, opacity: float) -> None:
        """Let the clone cover the photo by this share, 0..1."""
        self.opacity = opacity
        self.refresh()

    def frame(self, framing: str) -> None:
        """Show "front" (the whole person) or "face", turned to the front."""
        self._orbit = Orbit(framing)
        self.refresh()

    def turn(self, turn: float, tilt: float) -> None:
        """Turn the clone on, radians."""
        self._orbit = self._orbit.turned(turn, tilt)
        self.refresh()

    def spin(self, seconds: float) -> None:
        """Turn the clone round once in so many seconds, again and again; 0 stops that."""
        self._spin_s, self._spun_from = seconds, time.monotonic()
        self.refresh()

    def play(self, kind: str) -> None:
        """Let the clone do one of `MOTIONS`."""
        self.motion_kind = kind
        self._motion = None
        self._film.stop()
        shared_latest().drop(self, "motion")
        if kind != MOTIONS[0] and self._clone is not None:
            shared_latest().ask(
                self, "motion", functools.partial(find_motion, kind, self._clone), self._act, self.failed.emit
            )
        self.refresh()

    def _act(self, motion: Motion) -> None:
        """Let the clone begin to move."""
        if self.motion_kind != MOTIONS[0]:
            self._motion, self._began = motion, time.monotonic()
            self._film.start()

    def refresh(self) -> None:
        """Draw at the next chance: many changes at once are one picture."""
        if self.isVisible() and self._clone is not None:
            self._soon.start()
            self._later.start()

    # --- drawing -----------------------------------------------------------------

    def scene(self) -> Scene | None:
        """Return what is seen now; None without a clone."""
        if self._clone is None:
            return None
        now = time.monotonic()
        seconds = now - self._began
        turn = 2.0 * np.pi * (now - self._spun_from) / self._spin_s if self._spin_s else 0.0
        return Scene(
            self._clone,
            self._orbit.turned(turn, 0.0),
            self.mode,
            self._motion,
            seconds,
            self._gaps_mm,
            self._overlay,
            self.opacity,
        )

    def _draw(self, *, fine: bool) -> None:
        """Have the picture drawn beside the window's own work."""
        scene = self.scene()
        if scene is None or self._broken or (fine and self._film.isActive()):
            return
        density = self.devicePixelRatioF()
        width, height = (max(round(side * density), 64) for side in (self.width(), self.height()))
        work = functools.partial(scene.image, width, height, fine=fine)
        shared_latest().ask(
            self, "picture", work, functools.partial(self._take_picture, self._person, scene), self._give_up
        )

    def _take_picture(self, person: int, scene: Scene, picture: QImage) -> None:
        if self._clone is None or person != self._person:
            return  # somebody else's by now
        self.shown = scene
        shown = QPixmap.fromImage(picture)
        shown.setDevicePixelRatio(self.devicePixelRatioF())
        self.setPixmap(shown)
        self.drawn.emit()

    def _give_up(self, error: ClonerError) -> None:
        self._broken = True
        self._film.stop()
        self.setText(self.tr("This machine cannot draw in 3-D"))
        self.failed.emit(error)

    # --- hand ------------------------------------------------------------------

    def take_hold(self, at: QPointF, *, finger: bool = False) -> None:
        """Take hold of the clone."""
        self._held = at

    def drag(self, to: QPointF) -> None:
        """Turn or move the clone with the hand."""
        if self._held is None:
            return
        self.touched.emit()
        way, self._held = to - self._held, to
        if self._pans:
            self.pinch(way, 1.0, to)
        else:
            self.turn(_RADIANS_PER_PIXEL * way.x(), _RADIANS_PER_PIXEL * way.y())

    def let_go(self) -> None:
        """Hold nothing any more."""
        self._held, self._pans = None, False

    def pinch(self, move: QPointF, factor: float, about: QPointF) -> None:
        """Move and zoom the clone."""
        self.touched.emit()
        height = max(self.height(), 1)
        self._orbit = self._orbit.moved(move.x() / height, move.y() / height).zoomed(factor)
        self.refresh()

    # --- events -----------------------------------------------------------------

    def changeEvent(self, event: QEvent) -> None:
        """Be called in another language."""
        if event.type() == QEvent.Type.LanguageChange:
            self._speak()
        elif event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self._make_room()
        super().changeEvent(event)

    def event(self, event: QEvent) -> bool:
        """Take fingers."""
        if isinstance(event, QTouchEvent):
            self._touch.feel(event)
            return True
        return super().event(event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of the clone."""
        self._pans = event.button() != Qt.MouseButton.LeftButton or bool(
            event.modifiers() & Qt.KeyboardModifier.ShiftModifier
        )
        self.take_hold(event.position())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Turn or move the clone with the mouse."""
        self.drag(event.position())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go."""
        self.let_go()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Show all from the front again."""
        self.frame(self._orbit.framing)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom."""
        self.pinch(QPointF(), _ZOOM_STEP if event.angleDelta().y() > 0 else 1.0 / _ZOOM_STEP, event.position())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Turn, zoom and reset by keys."""
        self.touched.emit()
        key = event.key()
        ways = {Qt.Key.Key_Left: (-1, 0), Qt.Key.Key_Right: (1, 0), Qt.Key.Key_Up: (0, -1), Qt.Key.Key_Down: (0, 1)}
        zooms = {Qt.Key.Key_Plus: _ZOOM_STEP, Qt.Key.Key_Equal: _ZOOM_STEP, Qt.Key.Key_Minus: 1.0 / _ZOOM_STEP}
        if key in ways:
            x, y = ways[Qt.Key(key)]
            self.turn(_RADIANS_PER_PIXEL * _KEY_PIXELS * x, _RADIANS_PER_PIXEL * _KEY_PIXELS * y)
        elif key in zooms:
            self.pinch(QPointF(), zooms[Qt.Key(key)], QPointF())
        elif key == Qt.Key.Key_Home:
            self.frame(self._orbit.framing)
        else:
            super().keyPressEvent(event)

    def showEvent(self, event: QShowEvent) -> None:
        """Draw what changed while nobody looked."""
        super().showEvent(event)
        self.refresh()

    def resizeEvent(self, event: QEvent) -> None:
        """Draw at the new size."""
        self.refresh()
