"""Stand-ins for cloning that worker processes can import: fast, and bad on demand."""

from __future__ import annotations

import json
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from cloner import batch
from cloner.batch import BatchOptions
from cloner.cloning import CloneOutcome, stamp_options
from cloner.machines.farm import watchdog
from cloner.project.atomic import result_folder
from cloner.project.manifest import Visitor
from cloner.project.stamps import input_stamp, output_digests
from cloner.records.batches import CLONED, BatchRow
from cloner.report.batch import write_summary


def pretend(visitor: Visitor, out: Path, options: BatchOptions) -> BatchRow:
    """Write a result; those called "crash" kill their worker, "once" only the first time, "hang" never ends."""
    with watchdog(options.timeout_s):
        name = visitor.identifier
        tried = out / f".{name}.tried"
        first = not tried.exists()
        out.mkdir(parents=True, exist_ok=True)
        tried.touch()
        if name.startswith("crash") or (name.startswith("once") and first):
            os._exit(9)
        if name.startswith("hang"):
            time.sleep(600)
        with result_folder(out, name) as folder:
            (folder / "report.json").write_text('{"format": 3, "stamp": {}, "outputs": {}}')
        return BatchRow(name, CLONED, 0.0, 0, f"by {os.getpid()}")


def dawdle(visitor: Visitor, out: Path, options: BatchOptions) -> BatchRow:
    """Be at work for a minute, so that somebody can look."""
    out.mkdir(parents=True, exist_ok=True)
    (out / f".{visitor.identifier}.dawdling").touch()
    time.sleep(60)
    return BatchRow(visitor.identifier, CLONED, 0.0, 0, "")


@contextmanager
def shooting(shot: list[int], seconds: float) -> Iterator[None]:
    """Kill every process that this one starts within so many seconds, once it is seen; shot gets their numbers."""
    done = threading.Event()

    def shoot() -> None:
        over = time.monotonic() + seconds
        while time.monotonic() < over and not done.is_set():
            for process in multiprocessing.active_children():
                if process.pid is not None and process.pid not in shot:
                    process.kill()
                    shot.append(process.pid)
            time.sleep(0.2)

    shooter = threading.Thread(target=shoot)
    shooter.start()
    try:
        yield
    finally:
        done.set()
        shooter.join()


def write_result(photos: Path, out: Path, *, identifier: str, **options: Any) -> CloneOutcome:
    """Stand in for ``clone_folder``: a current result, after a moment in which a neighbour could interfere."""
    with result_folder(out, identifier) as folder:
        time.sleep(0.03)
        (folder / "clone.npz").write_text(identifier)
        told = stamp_options(options["height_cm"], options["formats"], options["seed"], options["texture_size"])
        report = {"stamp": input_stamp(photos, told), "outputs": output_digests(folder, ["clone.npz"]), "warnings": []}
        (folder / "report.json").write_text(json.dumps(report))
    return CloneOutcome(identifier, out / identifier, report, {})


def watch_summaries(folder: Path) -> None:
    """Write a batch's summary many times while another thread reads it; it must always be readable."""
    rows = [BatchRow(f"v{number}", CLONED, 1.0, 0, "fine") for number in range(50)]
    write_summary(rows[:1], 50, folder)
    stop = threading.Event()
    broken: list[str] = []

    def read() -> None:
        while not stop.is_set():
            try:
                json.loads((folder / "batch.json").read_text())
            except ValueError as error:
                broken.append(str(error))

    reader = threading.Thread(target=read)
    reader.start()
    for number in range(1, 50):
        write_summary(rows[:number], 50, folder)
    stop.set()
    reader.join()
    assert not broken


def clone_pretended(visitor: Visitor, out: Path, options: BatchOptions) -> BatchRow:
    """Stand in for ``clone_in_worker``: everything as it is but the cloning, which takes a moment."""
    batch.clone_folder = write_result
    time.sleep(0.5)
    return batch.clone_visitor(visitor, out, options)


#: A cluster of two workers that says where it is and stays until it is killed; with a folder's certificates if given.
CLUSTER = """
import sys, time
from distributed import LocalCluster
from distributed.security import Security
if __name__ == "__main__":
    keys = sys.argv[1] if len(sys.argv) > 1 else ""
    pairs = {
        f"tls_{role}_{what}": f"{keys}/{role}{end}.pem"
        for role in ("scheduler", "worker", "client") for what, end in (("cert", ""), ("key", "-key"))
    }
    security = Security(tls_ca_file=f"{keys}/ca.pem", require_encryption=True, **pairs) if keys else None
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address="127.0.0.1:0", security=security) as cluster:
        print(cluster.scheduler_address, flush=True)
        time.sleep(600)
"""


def start_cluster(*arguments: str) -> subprocess.Popen[str]:
    """Start `CLUSTER` as a process group of its own; its first line is its address."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    return subprocess.Popen(
        [sys.executable, "-c", CLUSTER, *arguments], env=environment, stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL, text=True, start_new_session=True,
    )  # fmt: skip


def end_cluster(cluster: subprocess.Popen[str]) -> None:
    os.killpg(cluster.pid, signal.SIGKILL)
    cluster.wait()


def address(cluster: subprocess.Popen[str]) -> str:
    assert cluster.stdout is not None
    return cluster.stdout.readline().strip()
