"""Stand-ins for cloning that worker processes can import: fast, and bad on demand."""

from __future__ import annotations

import json
import multiprocessing
import os
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from cloner import batch
from cloner.batch import BatchOptions
from cloner.cloning import CloneOutcome, stamp_options
from cloner.farm import watchdog
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
            (folder / "report.json").write_text("{}")
        return BatchRow(name, CLONED, 0.0, 0, f"by {os.getpid()}")


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


#: A cluster of two workers that says where it is and stays until it is killed.
CLUSTER = """
import sys, time
from cloner.farm import farm
if __name__ == "__main__":
    with farm(2) as client:
        print(client.scheduler.address, flush=True)
        time.sleep(600)
"""
