"""Progress for people who watch a terminal, and for logs."""

from __future__ import annotations

import sys
import time
from types import TracebackType
from typing import Final, Self, TextIO

REDRAW_S: Final = 0.1  # taste: often enough to look alive, seldom enough to cost nothing


class ProgressLine:
    """One line that is redrawn on a terminal; one line a step anywhere else.

    Parameters
    ----------
    stream : TextIO, optional
        Standard error when not given.
    """

    def __init__(self, stream: TextIO | None = None) -> None:
        self._stream = stream if stream is not None else sys.stderr
        self._live = self._stream.isatty()
        self._start = time.monotonic()
        self._drawn = 0.0
        self._step = ""

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.clear()

    def __call__(self, step: str, fraction: float) -> None:
        """Show a step and the fraction 0..1 of the whole."""
        now = time.monotonic()
        new = step != self._step
        self._step = step
        text = f"{100 * fraction:3.0f} %  {now - self._start:5.1f} s  {step}"
        if not self._live:
            if new:
                self._stream.write(text + "\n")
                self._stream.flush()
            return
        if new or now - self._drawn >= REDRAW_S:
            self._drawn = now
            self._stream.write(f"\r\x1b[2K{text}")
            self._stream.flush()

    def clear(self) -> None:
        """Remove the live line, so that what follows stands alone."""
        if self._live and self._step:
            self._stream.write("\r\x1b[2K")
            self._stream.flush()
        self._step = ""
