"""Cloning of everyone below a folder; failures are recorded and the rest continues."""

from __future__ import annotations

import contextlib
import logging
import os
import time
from collections.abc import Callable, Generator, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from cloner.cloning import DEFAULT_FORMATS, clone_folder, stamp_options
from cloner.errors import Cancelled, ClonerError
from cloner.exporters.table import check_formats
from cloner.machines.farm import Task, run_tasks, watchdog
from cloner.making import DEFAULT_TEXTURE_SIZE, check_texture_size
from cloner.project.atomic import check_writable, recover
from cloner.project.claims import claim
from cloner.project.manifest import Visitor, find_visitors, shard
from cloner.project.stamps import input_stamp, why_not_current
from cloner.records.batches import CLONED, FAILED, SKIPPED, BatchRow
from cloner.report.batch import write_summary
from cloner.terminal import sentence_of

log = logging.getLogger(__name__)

#: So few people are not worth a worker's start.
ALONE: Final = 1


@dataclass(frozen=True, slots=True)
class BatchOptions:
    """Options of a batch.

    Attributes
    ----------
    formats : tuple of str
    seed : int
    texture_size : int
    again : bool
        Whether visitors with a current result are cloned once more.
    workers : int
        Processes on this machine; 1 clones in this very process, so a crash there ends the batch.
    scheduler : str
        Address of a Dask cluster that clones instead; its workers must see photos and results under the same paths.
    cluster_keys : Path or None
        Folder of the cluster's certificates; see `cloner.machines.cluster_keys`.
    unprotected : bool
        Whether the cluster may be one to which anybody on its network can speak.
    shard : str
        "i/n": only every n-th visitor, from the i-th on, counted from 0.
    retries : int
        How often a visitor whose worker died is tried again.
    timeout_s : float
        After this long a visitor's worker is ended; 0 never.
    """

    formats: tuple[str, ...] = DEFAULT_FORMATS
    seed: int = 0
    texture_size: int = DEFAULT_TEXTURE_SIZE
    again: bool = False
    workers: int = 1
    scheduler: str = ""
    cluster_keys: Path | None = None
    unprotected: bool = False
    shard: str = ""
    retries: int = 1
    timeout_s: float = 0.0


RowReport = Callable[[BatchRow, int, int], None]
"""Called with a row, how many are done and how many there are; may raise Cancelled."""


def batch_folder(
    root: Path, out: Path, options: BatchOptions | None = None, *, report: RowReport = lambda row, done, of: None
) -> tuple[BatchRow, ...]:
    """Clone every visitor of a root or manifest and return one row each, in the order of their names.

    Also writes ``batch.json``, ``batch.csv`` and ``batch.html``, a sheet with the worst first; a shard's are numbered.

    Raises
    ------
    ClonerError
        If the batch cannot start at all, or its cluster disappears; a visitor's own failure is a row.
    Cancelled, KeyboardInterrupt
        After the rows so far were written.
    """
    options = options or BatchOptions()
    check_formats(options.formats)
    check_texture_size(options.texture_size)
    visitors = shard(find_visitors(root), options.shard)
    check_writable(out)
    rows: list[BatchRow] = []
    try:
        with contextlib.closing(_rows(visitors, out.resolve(), options)) as made:
            for row in made:
                rows.append(row)
                report(row, len(rows), len(visitors))
    finally:
        if out.is_dir():
            recover(out)  # what a worker that was killed here left
        rows.sort(key=lambda row: row.identifier)
        if out.is_dir():
            suffix = f"-{options.shard.replace('/', '-of-')}" if options.shard else ""
            write_summary(rows, len(visitors), out, f"batch{suffix}")
    return tuple(rows)


def _rows(visitors: Sequence[Visitor], out: Path, options: BatchOptions) -> Generator[BatchRow]:
    if not options.scheduler and (options.workers <= ALONE or len(visitors) <= ALONE):
        for visitor in visitors:
            yield clone_visitor(visitor, out, options)
        return
    tasks: list[Task] = [(visitor.identifier, clone_in_worker, (visitor, out, options), {}) for visitor in visitors]
    for name, result in _results(tasks, options):
        yield result if isinstance(result, BatchRow) else BatchRow(name, FAILED, 0.0, 0, str(result))


def _results(tasks: Sequence[Task], options: BatchOptions) -> Iterator[tuple[str, Any]]:
    """Yield what became of every task, on this machine or on a cluster."""
    if not options.scheduler:
        yield from run_tasks(tasks, options.workers, options.retries)
        return
    from cloner.machines.cluster import cluster, run_on

    with cluster(
        options.scheduler, options.retries, keys=options.cluster_keys, unprotected=options.unprotected
    ) as client:
        yield from run_on(client, tasks)


def clone_in_worker(visitor: Visitor, out: Path, options: BatchOptions) -> BatchRow:
    """Clone one visitor in a worker process, which is killed after a time limit."""
    os.umask(0o077)  # as the command line: results are the owner's alone
    with watchdog(options.timeout_s):
        return clone_visitor(visitor, out, options)


def clone_visitor(visitor: Visitor, out: Path, options: BatchOptions) -> BatchRow:
    """Clone one visitor and return its row."""
    start = time.perf_counter()
    identifier = visitor.identifier
    try:
        with claim(out, identifier) as ours:
            if not ours:
                return BatchRow(identifier, SKIPPED, 0.0, 0, "another run is cloning it just now")
            return _clone(visitor, out, options, start)
    except ClonerError as error:
        return BatchRow(identifier, FAILED, time.perf_counter() - start, 0, str(error))
    except Cancelled:
        raise
    except Exception as error:  # one visitor's defect must not end a night's batch
        log.info("%s failed", identifier, exc_info=True)  # a trace is for --verbose
        return BatchRow(identifier, FAILED, time.perf_counter() - start, 0, sentence_of(error))


def _clone(visitor: Visitor, out: Path, options: BatchOptions, start: float) -> BatchRow:
    identifier = visitor.identifier
    stamp = stamp_options(visitor.height_cm, options.formats, options.seed, options.texture_size)
    if not options.again:
        reason = why_not_current(out / identifier, input_stamp(visitor.photos, stamp))
        if not reason:
            return BatchRow(identifier, SKIPPED, 0.0, 0, "its result is current; --again clones once more")
        log.info("%s: %s", identifier, reason)
    outcome = clone_folder(
        visitor.photos,
        out,
        height_cm=visitor.height_cm,
        formats=options.formats,
        seed=options.seed,
        texture_size=options.texture_size,
        identifier=identifier,
    )
    count = len(outcome.warnings)
    message = "fine" if count == 0 else f"{count} note{'s' if count > 1 else ''} in its report"
    overlaps = list(outcome.report.get("silhouette_iou", {}).values())
    return BatchRow(identifier, CLONED, time.perf_counter() - start, count, message, min(overlaps, default=None))


def summary_table(rows: Sequence[BatchRow]) -> str:
    """Return the rows as a table of text, with the totals below."""
    width = max((len(row.identifier) for row in rows), default=7)
    lines = [f"{'visitor':{width}}  {'status':8}  {'seconds':>7}  notes"]
    lines += [f"{row.identifier:{width}}  {row.status:8}  {row.seconds:7.1f}  {row.message}" for row in rows]
    counts = {status: sum(row.status == status for row in rows) for status in (CLONED, SKIPPED, FAILED)}
    lines.append(", ".join(f"{count} {status}" for status, count in counts.items()))
    return "\n".join(lines)
