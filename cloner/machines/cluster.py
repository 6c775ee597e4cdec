"""Batches on a running Dask cluster; the only module that uses dask.

Whoever may speak to a Dask scheduler may run any code on its machines: the default is therefore TLS with certificates
on both sides (`cloner.machines.cluster_keys` makes them). Names of tasks are numbers by chance: a cluster's pages and
logs tell of no visitor.
"""

from __future__ import annotations

import importlib.util
import logging
import secrets
from collections import deque
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from cloner.errors import ClonerError
from cloner.machines.cluster_keys import AUTHORITY, certificate, key
from cloner.machines.farm import LOST, Task

if TYPE_CHECKING:
    from distributed import Client

#: A scheduler that does not answer is not there, seconds.
PATIENCE_S: Final = 20
INSTALL: Final = 'Install it: pip install "photo-cloner[cluster]"'
#: Loggers of Dask with a level of their own.
_TALKERS: Final = ("distributed", "distributed.client", "distributed.gc", "tornado.application")
_SECURE: Final = "tls://"


@contextmanager
def cluster(address: str, retries: int = 1, *, keys: Path | None = None, unprotected: bool = False) -> Iterator[Client]:
    """Give a client of the cluster at an address.

    Parameters
    ----------
    address : str
        "tls://host:8786", or "tcp://host:8786" where ``unprotected``.
    retries : int
        How many workers may die over one visitor before it counts as failed.
    keys : Path or None
        Folder that ``cloner cluster keys`` made.
    unprotected : bool
        Whether a cluster may be used to which anybody on its network can speak.

    Raises
    ------
    ClonerError
        If Dask is not installed, certificates are missing, or no scheduler answers.
    """
    _check_protected(address, keys, unprotected)
    if importlib.util.find_spec("distributed") is None:
        raise ClonerError("Dask is not installed", INSTALL, "--scheduler")
    import dask
    from distributed import Client

    settings = {
        "distributed.scheduler.allowed-failures": retries,
        "distributed.comm.timeouts.connect": f"{PATIENCE_S}s",
        "distributed.comm.require-encryption": not unprotected,
    }
    with dask.config.set(settings), _speechless():
        try:
            client = Client(address, timeout=PATIENCE_S, security=None if keys is None else _security(keys))
        except (OSError, TimeoutError, ValueError, RuntimeError) as error:
            hint = "Start scheduler and workers as docs/cluster.md says, with certificates of the same folder of keys"
            raise ClonerError("no scheduler answers there", hint, address) from error
        try:
            yield client
        finally:
            # A scheduler that vanishes while it is spoken to can fail Dask's own farewell: nothing is lost by it.
            with suppress(OSError, TimeoutError, RuntimeError):
                client.close()


def _check_protected(address: str, keys: Path | None, unprotected: bool) -> None:
    """Refuse clusters that others could read or command, unless that was said in words."""
    if unprotected:
        return
    if keys is None:
        hint = "Make them with cloner cluster keys FOLDER and give --cluster-keys FOLDER; docs/cluster.md"
        raise ClonerError("a cluster wants certificates: without them anybody on the network runs code there", hint,
                          "--scheduler")  # fmt: skip
    if not address.startswith(_SECURE):
        raise ClonerError("this is a plain connection", f"Write {_SECURE}HOST:8786", "--scheduler")


def _security(keys: Path) -> Any:
    """Return the certificates of this side."""
    from distributed.security import Security

    files = {"tls_ca_file": AUTHORITY, "tls_client_cert": certificate("client"), "tls_client_key": key("client")}
    for name in files.values():
        if not (keys / name).is_file():
            raise ClonerError("this folder of keys is not complete", "Make one with: cloner cluster keys FOLDER", name)
    return Security(require_encryption=True, **{what: str(keys / name) for what, name in files.items()})


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


def run_on(client: Client, tasks: Sequence[Task]) -> Iterator[tuple[str, Any]]:
    """Yield (name, result) of every task as it ends; a task whose workers died gives an exception instead.

    Only as many tasks are given as there are workers: what waits on a worker that dies would count as guilty too.

    Raises
    ------
    ClonerError
        If the scheduler disappears; what is finished stays finished.
    """
    from distributed import as_completed

    waiting, running = deque(tasks), as_completed()
    names: dict[Any, str] = {}

    def give() -> None:
        while waiting and len(names) < max(len(client.scheduler_info(n_workers=-1)["workers"]), 1):
            name, function, arguments, keywords = waiting.popleft()
            future = client.submit(function, *arguments, **keywords, pure=False, key=f"cloner-{secrets.token_hex(8)}")
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
    from distributed.scheduler import KilledWorker

    error = future.exception()
    if isinstance(error, KilledWorker):
        return ClonerError(LOST, "Clone it alone with --verbose", name)
    return future.result() if error is None else error


def _gone() -> ClonerError:
    hint = "Start it again and repeat the command: finished visitors are kept"
    return ClonerError("the scheduler has disappeared", hint, "cluster")
