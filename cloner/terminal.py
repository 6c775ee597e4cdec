"""Progress for people who watch a terminal and for logs, and how a command ends: a sentence and a number."""

from __future__ import annotations

import logging
import os
import sys
import time
from collections.abc import Callable
from types import TracebackType
from typing import Final, Self, TextIO

import typer

from cloner.errors import Cancelled, ClonerError

log = logging.getLogger(__name__)

EXIT_INPUT: Final = 2
EXIT_SOME_FAILED: Final = 1
EXIT_DEFECT: Final = 70  # sysexits.h: internal software error
EXIT_CANCELLED: Final = 130  # 128 + SIGINT, as shells have it
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


def ended(work: Callable[[], object]) -> int:
    """Do the work of a command and return its exit code; what went wrong is said in one line, never as a trace.

    The only place beside the batch and the window that catches everything.
    """
    try:
        code = work()
        if code == EXIT_CANCELLED:  # typer turns Ctrl-C into this code before we see it
            raise KeyboardInterrupt
        sys.stdout.flush()
        return code if isinstance(code, int) else 0
    except ClonerError as error:
        return _said(str(error), EXIT_INPUT)
    except (Cancelled, KeyboardInterrupt, typer.Abort):
        return _said("stopped; nothing half-written was left", EXIT_CANCELLED)
    except typer.TyperException as error:  # a wrong option or argument
        return _said(error.format_message(), error.exit_code)
    except BrokenPipeError:  # the reader of our output, say "head", has seen enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except Exception as error:
        log.info("the command failed", exc_info=True)
        return _said(defect(error), EXIT_DEFECT)


def defect(error: BaseException) -> str:
    """Return what to say of an error that nobody expected."""
    if isinstance(error, MemoryError):
        return "there is not enough memory. Close other programs, or ask for a smaller --size"
    return f"a defect of Cloner ({type(error).__name__}). Run it again with --verbose and report what it says"


def _said(text: str, code: int) -> int:
    sys.stderr.write(f"cloner: {text}\n")
    return code
