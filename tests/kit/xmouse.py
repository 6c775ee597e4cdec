"""A real mouse for an X server: moves and presses by the XTest extension, through the server as a hand's would come."""

from __future__ import annotations

import ctypes
import ctypes.util
import os


class Mouse:
    """The pointer of the server that ``DISPLAY`` names.

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

    def move(self, x: int, y: int) -> None:
        """Move to a pixel of the screen."""
        self._test.XTestFakeMotionEvent(self._display, -1, int(x), int(y), 0)
        self._x.XSync(self._display, 0)

    def button(self, down: bool) -> None:
        """Press or let go the left button."""
        self._test.XTestFakeButtonEvent(self._display, 1, int(down), 0)
        self._x.XSync(self._display, 0)
