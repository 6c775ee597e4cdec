"""An operator's hands on an X server: every click, key and turn of the wheel is counted, and what it takes a person.

Seconds are those of the keystroke-level model, not of the machine: a practised person moves the pointer to a target in
1.1 s, presses and lets go a button in .2 s, strikes a key in .28 s, changes between mouse and keys in .4 s.

References
----------
Card, Moran, Newell 1980, The keystroke-level model for user performance time with interactive systems (table 1; "B"
from the book of 1983: .1 s down, .1 s up).
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Final

from kit.xmouse import Keys, Mouse

POINT_S: Final = 1.1
CLICK_S: Final = 0.2
KEY_S: Final = 0.28
HOME_S: Final = 0.4
#: A turn of the wheel by one notch is taken for a key.
WHEEL_S: Final = KEY_S
_PATIENCE_S: Final = 900.0


@dataclass
class Done:
    """What the hands have done."""

    clicks: int = 0
    keys: int = 0
    wheels: int = 0
    seconds: float = 0.0


class Hands:
    """Moves, clicks and types as a person does, and looks at nothing but what is seen.

    Parameters
    ----------
    app : QApplication
    """

    def __init__(self, app: Any) -> None:
        self._app, self._mouse, self._keys = app, Mouse(), Keys()
        self._at_mouse = True
        self.done = Done()

    def wait(self, done: Callable[[], bool], what: str = "") -> None:
        """Let the window work until something holds: that is the machine's time, not the hands'."""
        end = time.monotonic() + _PATIENCE_S
        while not done():
            if time.monotonic() > end:
                raise TimeoutError(what)
            self._app.processEvents()
            time.sleep(0.003)

    def settle(self, seconds: float = 0.1) -> None:
        """Let the window draw."""
        end = time.monotonic() + seconds
        self.wait(lambda: time.monotonic() > end)

    def click(self, widget: Any, place: Any = None, times: int = 1) -> None:
        """Click on a control; it must be enabled, and seen: else the wheel is turned until it is."""
        if not (widget.isVisible() and widget.isEnabled()):
            raise AssertionError(f"nobody can click on {widget!r}")
        self._bring_into_sight(widget)
        spot = widget.mapToGlobal(place or widget.rect().center()) * widget.devicePixelRatioF()
        self._mouse.move(spot.x(), spot.y())
        self.settle(0.03)
        self._home(at_mouse=True)
        for _ in range(times):
            self._mouse.button(True)
            self.settle(0.02)
            self._mouse.button(False)
            self.settle(0.02)
        self.done.clicks += times
        self.done.seconds += POINT_S + times * CLICK_S
        self.settle()

    def strike(self, *names: str) -> None:
        """Strike keys, one after the other; "Control_L+a" holds one down."""
        self._home(at_mouse=False)
        for one in names:
            held = one.split("+")
            self._keys.strike(*held)
            self.done.keys += len(held)
            self.done.seconds += KEY_S * len(held)
            self.settle(0.03)

    def write(self, text: str) -> None:
        """Type a text of small letters and digits."""
        self.strike(*text)

    def focus(self, window: Any) -> None:
        """Give a window the keyboard, as a window manager does by itself when it appears."""
        self._keys.focus(int(window.winId()))
        self.settle(0.05)

    def _home(self, *, at_mouse: bool) -> None:
        self.done.seconds += HOME_S * (at_mouse != self._at_mouse)
        self._at_mouse = at_mouse

    def _bring_into_sight(self, widget: Any) -> None:
        from PySide6.QtCore import QPoint, QRect
        from PySide6.QtWidgets import QScrollArea

        area = widget.parentWidget()
        while area is not None and not isinstance(area, QScrollArea):
            area = area.parentWidget()
        if area is None:
            return
        view = area.viewport()
        for _ in range(60):
            place = QRect(widget.mapTo(view, QPoint()), widget.size())
            middle = place.center().y()
            if 0 <= middle < view.height() and (place.height() > view.height() or view.rect().contains(place)):
                return
            spot = view.mapToGlobal(QPoint(6, view.height() // 2)) * widget.devicePixelRatioF()
            self._mouse.move(spot.x(), spot.y())
            self._mouse.wheel(down=middle > view.height() // 2)
            self._home(at_mouse=True)
            self.done.wheels += 1
            self.done.seconds += WHEEL_S
            self.settle(0.03)


def seen(widgets: Sequence[Any]) -> Any:
    """Return the one of some widgets that is seen."""
    return next(one for one in widgets if one.isVisible())
