"""A real mouse and keyboard for an X server: they act by the XTest extension, through the server as hands do."""

from __future__ import annotations

import ctypes
import ctypes.util
import os


class _Server:
    """The server that ``DISPLAY`` names.

    Raises
    ------
    OSError
        If the libraries or the server are missing.
    """

    def __init__(self) -> None:
        self._x = ctypes.CDLL(ctypes.util.find_library("X11") or "libX11.so.6")
        self._test = ctypes.CDLL(ctypes.util.find_library("Xtst") or "libXtst.so.6")
        self._x.XOpenDisplay.restype = ctypes.c_void_p
        self._display = ctypes.c_void_p(self._x.XOpenDisplay(os.environ["DISPLAY"].encode()))
        if not self._display:
            raise OSError("there is no X server")


class Mouse(_Server):
    """The server's pointer."""

    def move(self, x: int, y: int) -> None:
        """Move to a pixel of the screen."""
        self._test.XTestFakeMotionEvent(self._display, -1, int(x), int(y), 0)
        self._x.XSync(self._display, 0)

    def button(self, down: bool) -> None:
        """Press or let go the left button."""
        self._test.XTestFakeButtonEvent(self._display, 1, int(down), 0)
        self._x.XSync(self._display, 0)

    def wheel(self, down: bool) -> None:
        """Turn the wheel by one notch."""
        for pressed in (True, False):
            self._test.XTestFakeButtonEvent(self._display, 5 if down else 4, int(pressed), 0)
        self._x.XSync(self._display, 0)


class Keys(_Server):
    """The server's keyboard, with the letters of X.Org's own layout."""

    def strike(self, *names: str) -> None:
        """Press keys by X.Org's names ("a", "Return", "Control_L") one after the other, and let them go again."""
        self._x.XStringToKeysym.restype = ctypes.c_ulong
        symbols = [self._x.XStringToKeysym(name.encode()) for name in names]
        codes = [self._x.XKeysymToKeycode(self._display, ctypes.c_ulong(symbol)) for symbol in symbols]
        if not all(codes):
            raise ValueError(f"the server has no key for one of {names}")
        for code in codes:
            self._test.XTestFakeKeyEvent(self._display, code, 1, 0)
        for code in reversed(codes):
            self._test.XTestFakeKeyEvent(self._display, code, 0, 0)
        self._x.XSync(self._display, 0)

    def focus(self, window: int) -> None:
        """Give a window the keyboard: a server without a window manager leaves that to its clients."""
        self._x.XSetInputFocus(self._display, ctypes.c_ulong(window), 1, ctypes.c_ulong(0))
        self._x.XSync(self._display, 0)
