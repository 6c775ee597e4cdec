"""A worker process for long jobs: the window's thread never waits for the interpreter lock, and a job can be killed at
once.

The caller's side blocks in `Worker.call`, on a thread of its own. Both sides speak tuples over a pipe: the caller sends
(method, arguments), the worker answers ("progress", step, fraction), ("shown", value), ("log", level, logger, text) and
at last ("done", value) or ("failed", error).
"""

from __future__ import annotations

import importlib
import logging
import multiprocessing as mp
import os
import threading
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any, Final

from cloner.errors import ClonerError
from cloner.machines.farm import end_with_parent

log = logging.getLogger(__name__)

Progress = Callable[[str, float], None]
Show = Callable[[object], None]
#: How often a caller looks whether its job is still wanted, seconds: "cancel at once" for a hand on a button.
LISTEN_S: Final = 0.05
_AGAIN: Final = "Try again; if it happens again, send the log file"


def ignore(value: object) -> None:
    """Ignore what a job shows."""


class Worker:
    """A process that does one job at a time; it starts with the first job, and again after a cancelled one.

    Parameters
    ----------
    make : str
        "module:class" of the object whose methods are the jobs; only the process loads it. It is made with a callable
        by which its jobs show what they have so far.
    """

    def __init__(self, make: str = "cloner.booth.jobs:Jobs") -> None:
        self._make = make
        self._turn = threading.Lock()
        self._process: mp.process.BaseProcess | None = None
        self._pipe: Connection | None = None

    def call(self, method: str, *arguments: object, progress: Progress, show: Show = ignore) -> Any:
        """Do a job in the process and return its value.

        Parameters
        ----------
        method : str
        arguments : object
            Can be pickled.
        progress : callable
            Called with every step, and with the last one again and again meanwhile; what it raises ends the process.
        show : callable
            Called with what the job shows.

        Raises
        ------
        ClonerError
            Of the job, or if the process dies.
        """
        while not self._turn.acquire(timeout=LISTEN_S):
            progress("", 0.0)  # who waits behind another job may give up too
        try:
            pipe = self._connected()
            try:
                pipe.send((method, arguments))
                return self._listen(pipe, progress, show)
            except (EOFError, OSError) as error:
                self.stop()
                raise ClonerError("the worker's process ended", _AGAIN, "Cloner") from error
            except ClonerError:
                raise
            except BaseException:
                self.stop()
                raise
        finally:
            self._turn.release()

    def start(self) -> None:
        """Start the process before it is needed, so that its first job does not wait for imports."""
        with self._turn:
            self._connected()

    def stop(self) -> None:
        """Kill the process, whatever it does."""
        process, self._process = self._process, None
        if process is not None and process.pid is not None:  # one that could not be started has none
            process.kill()
            process.join()
        if self._pipe is not None:
            self._pipe.close()
            self._pipe = None

    def _connected(self) -> Connection:
        if self._pipe is None or self._process is None or not self._process.is_alive():
            self.stop()
            context = mp.get_context("spawn")
            self._pipe, theirs = context.Pipe()
            self._process = context.Process(target=_serve, args=(theirs, self._make), daemon=True)
            self._process.start()
            theirs.close()
        return self._pipe

    def _listen(self, pipe: Connection, progress: Progress, show: Show) -> Any:
        step, fraction = "", 0.0
        while True:
            if not pipe.poll(LISTEN_S):
                progress(step, fraction)
                continue
            kind, *content = pipe.recv()
            if kind == "progress":
                step, fraction = content
                progress(step, fraction)
            elif kind == "shown":
                show(content[0])
            elif kind == "log":
                logging.getLogger(content[1]).log(content[0], "%s", content[2])
            elif kind == "done":
                return content[0]
            else:
                raise content[0]


class _Teller(logging.Handler):
    """Forwards log records to the calling process, as only one process writes the log file."""

    def __init__(self, tell: Show) -> None:
        super().__init__()
        self._tell = tell

    def emit(self, record: logging.LogRecord) -> None:
        self._tell(("log", record.levelno, record.name, self.format(record)))


def _serve(pipe: Connection, make: str) -> None:
    """Do jobs until the calling process is gone; runs in the worker process."""
    threading.Thread(target=end_with_parent, daemon=True).start()
    os.nice(5)  # the window comes first on a machine with two cores
    tell = _one_by_one(pipe.send)
    logging.basicConfig(level=logging.INFO, handlers=[_Teller(tell)], format="%(message)s")
    module, _, name = make.partition(":")
    jobs = getattr(importlib.import_module(module), name)(lambda value: tell(("shown", value)))
    while True:
        try:
            method, arguments = pipe.recv()
            tell(_answer(getattr(jobs, method), arguments, tell))
        except (EOFError, OSError):
            return


def _one_by_one(send: Show) -> Show:
    """Return a thread-safe send function: two long messages at once would be mixed."""
    turn = threading.Lock()

    def sent(message: object) -> None:
        with turn:
            send(message)

    return sent


def _answer(job: Callable[..., object], arguments: tuple[object, ...], tell: Show) -> tuple[str, object]:
    try:
        value = job(*arguments, progress=lambda step, fraction: tell(("progress", step, fraction)))
    except ClonerError as error:
        return "failed", error
    except OSError as error:
        if isinstance(error, BrokenPipeError):
            raise
        log.exception("a job failed")
        return "failed", _unexpected(error)
    except Exception as error:  # a worker must outlive the defect of one job
        log.exception("a job failed")
        return "failed", _unexpected(error)
    return "done", value


def _unexpected(error: Exception) -> ClonerError:
    message = f"something went wrong that the program did not expect ({type(error).__name__})"
    return ClonerError(message, _AGAIN, "Cloner")
