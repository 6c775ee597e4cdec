"""Many visitors on many processes: this machine's, or those of a running Dask cluster. Only home of dask.

A visitor is one task. A worker that dies (crash, memory, or the watchdog that ends a hang) costs its visitor one try
and nobody else anything: the cluster starts another worker and gives the task again. Dask gives up a worker that dies
before it has started; a local cluster is therefore tended: what is missing is started again.
"""

from __future__ import annotations

import asyncio
import logging
import os
import threading
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any, Final

import dask
from distributed import Client, LocalCluster, Status, as_completed
from distributed.scheduler import KilledWorker

from cloner.errors import ClonerError

log = logging.getLogger(__name__)

#: Exit code of a worker that the watchdog ended.
TIMED_OUT: Final = 75
#: A scheduler that does not answer is not there, seconds.
PATIENCE_S: Final = 20
#: Workers of this machine that are not there after so long never will be, seconds.
START_S: Final = 120
#: How often a local cluster's lost workers are looked for, seconds.
TEND_S: Final = 1.0
#: Of every worker, before its libraries load: one thread each, as there is one process a core.
_ENVIRONMENT: Final = {
    "OMP_NUM_THREADS": 1, "OPENBLAS_NUM_THREADS": 1, "MKL_NUM_THREADS": 1,
    "LP_NUM_THREADS": 1, "OPENCV_FOR_THREADS_NUM": 1,
}  # fmt: skip
#: Loggers of Dask with a level of their own.
_TALKERS: Final = ("distributed", "distributed.client", "distributed.gc", "tornado.application")
_OVER: Final = (Status.closed, Status.failed)
LOST: Final = "its worker died: a crash, no memory left, or longer than --timeout allows"

Task = tuple[str, Callable[..., Any], tuple[Any, ...], Mapping[str, Any]]
"""Name, function, arguments and keywords; all must travel to another process."""


@contextmanager
def farm(workers: int, scheduler: str = "", retries: int = 1) -> Iterator[Client]:
    """Give a client of a local cluster of so many processes, or of the cluster at an address.

    Parameters
    ----------
    workers : int
        Processes of the local cluster.
    scheduler : str
        Address of a running cluster, "tcp://host:8786"; "" starts a local one.
    retries : int
        How many workers may die over one visitor before it counts as failed.

    Raises
    ------
    ClonerError
        If there is no cluster at the address, or no worker starts on this machine.
    """
    settings = {
        "distributed.scheduler.allowed-failures": retries,
        "distributed.worker.daemon": False,
        "distributed.nanny.pre-spawn-environ": _ENVIRONMENT,
        "distributed.worker.profile.enabled": False,  # it wakes every worker a hundred times a second
        "distributed.comm.timeouts.connect": f"{PATIENCE_S}s",
    }
    with dask.config.set(settings), _speechless():
        if scheduler:
            try:
                client = Client(scheduler, timeout=PATIENCE_S)
            except (OSError, TimeoutError, ValueError) as error:
                hint = "Start it with: dask scheduler, and its workers with: dask worker ADDRESS"
                raise ClonerError("no scheduler answers there", hint, scheduler) from error
            with client:
                yield client
            return
        cluster = LocalCluster(
            n_workers=0, threads_per_worker=1, processes=True, dashboard_address=None, host="127.0.0.1"
        )
        with cluster, Client(cluster) as client, _tended(cluster, workers):
            try:
                client.wait_for_workers(workers, timeout=START_S)
            except TimeoutError as error:
                hint = "Look for what ends them, such as a limit on memory, or use --workers 1"
                raise ClonerError("its processes do not start", hint, "batch") from error
            yield client


@contextmanager
def _speechless() -> Iterator[None]:
    """Keep Dask's talk and traces off the terminal: rows and sentences tell an operator what there is to do."""
    levels = {logger: logger.level for logger in map(logging.getLogger, _TALKERS)}
    try:
        for logger in levels:
            logger.setLevel(logging.CRITICAL)
        yield
    finally:
        for logger, level in levels.items():
            logger.setLevel(level)


@contextmanager
def _tended(cluster: LocalCluster, workers: int) -> Iterator[None]:
    """Keep so many workers in a local cluster: its own restart ends with a worker killed while it starts."""

    async def tend() -> None:
        while True:
            for name in [name for name, one in cluster.workers.items() if one.status in _OVER]:
                del cluster.workers[name]
            cluster.scale(workers)  # starts what is wanted and not there
            await asyncio.sleep(TEND_S)

    async def start() -> asyncio.Task[None]:
        return asyncio.create_task(tend())

    tending = cluster.sync(start)
    try:
        yield
    finally:
        cluster.loop.add_callback(tending.cancel)


def run_tasks(client: Client, tasks: Sequence[Task]) -> Iterator[tuple[str, Any]]:
    """Yield (name, result) of every task as it ends; a task whose workers died gives an exception instead.

    Only as many tasks are given as there are workers: what waits on a worker that dies would count as guilty too.

    Raises
    ------
    ClonerError
        If the scheduler disappears; what is finished stays finished.
    """
    waiting, running = deque(enumerate(tasks)), as_completed()
    names: dict[Any, str] = {}

    def give() -> None:
        while waiting and len(names) < max(len(client.scheduler_info(n_workers=-1)["workers"]), 1):
            number, (name, function, arguments, keywords) = waiting.popleft()
            future = client.submit(function, *arguments, **keywords, pure=False, key=f"cloner-{number}-{name}")
            names[future.key] = name
            running.add(future)

    try:
        give()
        for future in running:
            name = names.pop(future.key)
            if future.cancelled():
                raise _gone()
            yield name, _outcome(future, name)
            future.release()
            give()
    except (OSError, TimeoutError, KeyError) as error:
        raise _gone() from error
    if waiting or names:
        raise _gone()


def _outcome(future: Any, name: str) -> Any:
    error = future.exception()
    if isinstance(error, KilledWorker):
        return ClonerError(LOST, "Clone it alone with --verbose", name)
    return future.result() if error is None else error


def _gone() -> ClonerError:
    hint = "Start it again and repeat the command: finished visitors are kept"
    return ClonerError("the scheduler has disappeared", hint, "cluster")


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
