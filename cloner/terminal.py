"""Progress on terminals and in logs, and exit messages and codes of commands."""

from __future__ import annotations

import contextlib
import errno
import io
import logging
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Final, Self, TextIO

import typer

from cloner.errors import Cancelled, ClonerError, printable

log = logging.getLogger(__name__)

#: The exit codes (docs/exit_codes.md).
EXIT_INPUT: Final = 2
EXIT_SOME_FAILED: Final = 1
EXIT_DEFECT: Final = 70  # sysexits.h: internal software error
EXIT_CANCELLED: Final = 130  # 128 + SIGINT, as shells have it
_CHECK: Final = "Check the path, its permissions and the space there"
_HINTS: Final = {
    errno.ENAMETOOLONG: "Give a shorter path", errno.ELOOP: "Its links lead in a circle: give the place itself",
    errno.ENOSPC: "Free some space there", errno.EDQUOT: "Free some space there",
    errno.EMFILE: "Close other programs, or raise the limit of open files (ulimit -n)",
}  # fmt: skip
#: How libraries in C say it.
_NO_MEMORY: Final = ("XNNPack delegate failed",
    "bad_alloc", "Insufficient memory", "annot allocate memory", "can't start new thread", "failed to allocate",
    "ailed to map segment",
)  # fmt: skip
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


class UnfailingStderr(io.TextIOWrapper):
    """Standard error that never raises: the reader may be gone, and the work continues."""

    def write(self, text: str) -> int:
        """Write what can be written."""
        with contextlib.suppress(OSError, ValueError):
            super().write(text)
        return len(text)

    def flush(self) -> None:
        """Flush what can be flushed."""
        with contextlib.suppress(OSError, ValueError):
            super().flush()


def prepare_streams() -> None:
    """Make standard streams that print any file name and survive a closed reader.

    Raises
    ------
    ClonerError
        If standard output is closed: what is asked for would be lost.
    """
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w", encoding="utf-8")
    elif sys.stderr is sys.__stderr__ and isinstance(sys.stderr, io.TextIOWrapper):
        encoding = sys.stderr.encoding
        sys.stderr = UnfailingStderr(sys.stderr.detach(), encoding, "backslashreplace", line_buffering=True)
    if sys.stdout is None:
        sys.stdout = open(os.devnull, "w", encoding="utf-8")
        raise ClonerError("it is closed", "Give it a place, for example > /dev/null", "standard output")
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")  # names of folders need not be text


def run_command(work: Callable[[], object]) -> int:
    """Run a command and return its exit code; errors are printed in one line, never as a traceback.

    The only place beside the batch and the window that catches everything.
    """
    try:
        prepare_streams()
        code = work()
        if code == EXIT_CANCELLED:  # typer turns Ctrl-C into this code before we see it
            raise KeyboardInterrupt
        sys.stdout.flush()
        return code if isinstance(code, int) else 0
    except ClonerError as error:
        return _print_error(str(error), EXIT_INPUT)
    except (Cancelled, KeyboardInterrupt, typer.Abort):
        return _print_error("stopped; nothing half-written was left", EXIT_CANCELLED)
    except typer.TyperException as error:  # a wrong option or argument
        return _print_error(error.format_message(), error.exit_code)
    except BrokenPipeError:  # the reader of our output, say "head", has seen enough
        _discard_stdout()
        return 0
    except Exception as error:
        log.info("the command failed", exc_info=True)
        mendable = isinstance(error, OSError) or out_of_memory(error)
        return _print_error(sentence_of(error), EXIT_INPUT if mendable else EXIT_DEFECT)


def _discard_stdout() -> None:
    """Discard further standard output, as Python would fail over it at exit."""
    with contextlib.suppress(OSError, ValueError, AttributeError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def split_formats(text: str) -> tuple[str, ...]:
    """Return the formats in a list with commas, each once, lower case."""
    names = [name.strip().lower() for name in text.split(",")]
    return tuple(dict.fromkeys(name for name in names if name))


def sentence_of(error: BaseException) -> str:
    """Return the message for an unexpected error."""
    if out_of_memory(error):
        return "there is not enough memory. Close other programs, or ask for a smaller --size"
    if isinstance(error, OSError):
        where = (
            printable(Path(os.fsdecode(error.filename)).name) if isinstance(error.filename, str | bytes) else "system"
        )
        return f"{where}: {error.strerror or 'it cannot be used'}. {_HINTS.get(error.errno or 0, _CHECK)}"
    return f"a defect of Cloner ({type(error).__name__}). Run it again with --verbose and report what it says"


def out_of_memory(error: BaseException) -> bool:
    """Return whether an error means that memory is exhausted, whichever library raised it."""
    if isinstance(error, MemoryError) or (isinstance(error, OSError) and error.errno == errno.ENOMEM):
        return True
    may = isinstance(error, RuntimeError | ImportError | SystemError) or type(error).__module__ == "cv2"
    return may and any(words in str(error) for words in _NO_MEMORY)


def _print_error(text: str, code: int) -> int:
    _to_nowhere_if_full()
    sys.stderr.write(f"cloner: {text}\n")
    sys.stderr.flush()
    return code


def _to_nowhere_if_full() -> None:
    try:
        sys.stdout.flush()
    except (OSError, ValueError, AttributeError):
        _discard_stdout()
