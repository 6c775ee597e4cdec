"""Batches on many processes of this machine: child processes over pipes, without ports or socket files.

A visitor is one task. A worker that dies (crash, memory, or the watchdog that ends a hang) costs its visitor one try
and nobody else anything: another worker is started and the task given again. A worker that dies before it has begun
costs nobody a try.
"""

from __future__ import annotations

import contextlib
import importlib
import logging
import multiprocessing as mp
import os
import pickle
import signal
import threading
import time
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from types import FrameType
from typing import Any, Final

from cloner.errors import ClonerError

log = logging.getLogger(__name__)

#: Exit code of a worker that the watchdog ended.
TIMED_OUT: Final = 75
#: When no worker has come up for so long none ever will, seconds.
START_S: Final = 120.0
#: After a worker that died while it started the next one waits, seconds: one that cannot start must not eat a core.
PAUSE_S: Final = 0.5
#: So long a worker may take to tidy up when the batch ends, seconds.
TIDY_S: Final = 10.0
#: Of every worker, before its libraries load: one thread each, as there is one process a core.
_ENVIRONMENT: Final = {
    "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1",
    "LP_NUM_THREADS": "1", "OPENCV_FOR_THREADS_NUM": "1",
}  # fmt: skip
LOST: Final = "its worker died: a crash, no memory left, or longer than --timeout allows"
_READY: Final = "ready"

Task = tuple[str, Callable[..., Any], tuple[Any, ...], Mapping[str, Any]]
"""Name, function, arguments and keywords; the last three must travel to another process, the name stays here."""


@dataclass(slots=True)
class _Try:
    task: Task
    deaths: int = 0


@dataclass(slots=True)
class _Worker:
    process: SpawnProcess
    pipe: Connection
    ready: bool = False
    doing: _Try | None = None


def run_tasks(tasks: Sequence[Task], workers: int, retries: int = 1) -> Iterator[tuple[str, Any]]:
    """Yield (name, result) of every task as it ends; one whose workers died, or that raised, gives the exception.

    Parameters
    ----------
    tasks : sequence of Task
    workers : int
        Processes at once.
    retries : int
        How many workers more may die over one task before it counts as failed.

    Raises
    ------
    ClonerError
        If no process starts on this machine.
    """
    waiting = deque(_Try(task) for task in tasks)
    modules = tuple({task[1].__module__ for task in tasks})
    crew: list[_Worker] = []
    sign_of_life, not_before = time.monotonic(), 0.0
    try:
        while waiting or any(one.doing for one in crew):
            busy = sum(one.doing is not None for one in crew)
            if len(crew) < min(workers, len(waiting) + busy) and time.monotonic() >= not_before:
                crew.append(_started(modules))
                continue
            for one in crew:
                if waiting and one.ready and one.doing is None:
                    _give(one, waiting.popleft())
            for one in _heard(crew):
                said, alive = _said(one)
                ended, one.doing = one.doing, None
                if alive or one.ready:
                    sign_of_life = time.monotonic()
                if alive:
                    one.ready = True
                else:
                    crew.remove(one)
                    _end([one])
                    not_before = 0.0 if one.ready else time.monotonic() + PAUSE_S
                if ended is not None and (alive or ended.deaths >= retries):
                    name = ended.task[0]
                    yield name, said if alive else ClonerError(LOST, "Clone it alone with --verbose", name)
                elif ended is not None:
                    ended.deaths += 1
                    waiting.appendleft(ended)
            if time.monotonic() - sign_of_life > START_S and not any(one.ready for one in crew):
                hint = "Look for what ends them, such as a limit on memory, or use --workers 1"
                raise ClonerError("its processes do not start", hint, "batch")
    finally:
        _end(crew)


def _started(modules: tuple[str, ...]) -> _Worker:
    context = mp.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=_serve, args=(theirs, modules), daemon=True)
    with _one_thread_each():
        process.start()
    theirs.close()
    return _Worker(process, ours)


@contextmanager
def _one_thread_each() -> Iterator[None]:
    """Set the environment that a process inherits; this process has read its own already."""
    before = {name: os.environ.get(name) for name in _ENVIRONMENT}
    os.environ.update(_ENVIRONMENT)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value


def _heard(crew: Sequence[_Worker]) -> list[_Worker]:
    """Return the workers that have said something or are gone, after at most `PAUSE_S`."""
    if not crew:
        time.sleep(PAUSE_S)
    pipes = wait([one.pipe for one in crew], PAUSE_S)
    return [one for one in crew if one.pipe in pipes]


def _said(worker: _Worker) -> tuple[Any, bool]:
    """Return a worker's message, and whether it is alive."""
    try:
        return worker.pipe.recv(), True
    except (EOFError, OSError):
        return None, False
    except (pickle.UnpicklingError, AttributeError, ImportError, TypeError) as error:  # its class cannot be made here
        return error, True


def _give(worker: _Worker, one: _Try) -> None:
    worker.doing = one
    with contextlib.suppress(OSError):  # it has just died: heard of next
        worker.pipe.send(one.task[1:])


def _end(crew: Sequence[_Worker]) -> None:
    """End workers; busy ones get a signal first, so that they leave nothing half-written."""
    for one in crew:
        one.pipe.close()
        if one.doing is not None:
            one.process.terminate()
    over = time.monotonic() + TIDY_S
    for one in crew:
        one.process.join(max(over - time.monotonic(), 0.1))
        if one.process.is_alive():
            one.process.kill()
            one.process.join()
        one.process.close()


def _serve(pipe: Connection, modules: tuple[str, ...]) -> None:
    """Load what the tasks need, then do tasks until the other side closes the pipe; runs in the worker."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # a terminal's Ctrl-C reaches the batch, which ends its workers
    signal.signal(signal.SIGTERM, _stop)
    threading.Thread(target=end_with_parent, daemon=True).start()
    with contextlib.suppress(EOFError, OSError, KeyboardInterrupt):
        for module in modules:
            importlib.import_module(module)
        pipe.send(_READY)
        while True:
            function, arguments, keywords = pipe.recv()
            try:
                answer = function(*arguments, **keywords)
            except Exception as error:  # becomes the task's result
                log.info("a task failed", exc_info=True)
                answer = error
            _tell(pipe, answer)


def _tell(pipe: Connection, answer: object) -> None:
    try:
        pipe.send(answer)
    except (pickle.PicklingError, TypeError, AttributeError):
        pipe.send(RuntimeError(f"its result, a {type(answer).__name__}, cannot travel"))


def _stop(number: int, frame: FrameType | None) -> None:
    raise KeyboardInterrupt


def end_with_parent() -> None:
    """End this process when its parent does, even in the middle of a stage."""
    parent = mp.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


@contextmanager
def watchdog(seconds: float) -> Iterator[None]:
    """End this process when the block takes longer; 0 never does. Only for worker processes."""
    if seconds <= 0.0:
        yield
        return
    timer = threading.Timer(seconds, os._exit, (TIMED_OUT,))
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
