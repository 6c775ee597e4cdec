"""Clone everyone below a folder; a failed visitor is recorded and the rest goes on."""

from __future__ import annotations

import json
import logging
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Final

from cloner.cloning import CLONE_FILE, DEFAULT_FORMATS, Progress, check_formats, clone_folder, quiet
from cloner.errors import Cancelled, ClonerError
from cloner.project.atomic import RESULT_MARK, write_text
from cloner.project.folder import holds_photos, safe_identifier

log = logging.getLogger(__name__)

SUMMARY_FILE: Final = "batch.json"
DEEPEST: Final = 3  # levels below the root that are searched for visitors: day / stand / visitor


@dataclass(frozen=True, slots=True)
class BatchRow:
    """What became of one visitor.

    Attributes
    ----------
    identifier : str
    status : str
        "cloned", "skipped" (there was a result) or "failed".
    seconds : float
    warnings : int
    message : str
        One line for people.
    """

    identifier: str
    status: str
    seconds: float
    warnings: int
    message: str


def find_visitors(root: Path) -> dict[str, Path]:
    """Return the folders below a root that hold photos, by identifier.

    Parameters
    ----------
    root : Path
        Searched `DEEPEST` levels deep; hidden folders and results are left out.

    Raises
    ------
    ClonerError
        If the root is missing or holds no visitor, or two would share a name.
    """
    if not root.is_dir():
        raise ClonerError("there is no such folder", "Give the folder that holds the visitors' folders", root.name)
    visitors: dict[str, Path] = {}
    for folder in _walk(root, DEEPEST):
        identifier = safe_identifier("-".join(folder.relative_to(root).parts))
        if identifier in visitors:
            message = f"two visitors would both be called {identifier}"
            raise ClonerError(message, "Rename one of the folders", folder.name)
        visitors[identifier] = folder
    if not visitors:
        hint = "Put each visitor's photos into a folder of its own below it"
        raise ClonerError("no folder below it holds photos named as views", hint, root.resolve().name)
    return visitors


def batch_folder(
    root: Path,
    out: Path,
    *,
    formats: Sequence[str] = DEFAULT_FORMATS,
    seed: int = 0,
    again: bool = False,
    progress: Progress = quiet,
    told: Callable[[BatchRow], None] = lambda row: None,
) -> tuple[BatchRow, ...]:
    """Clone every visitor below a root and return one row each; also writes ``batch.json``.

    Parameters
    ----------
    root, out : Path
    formats : sequence of str
    seed : int
    again : bool
        Whether visitors with a result are cloned once more.
    progress : callable
        Called with "visitor: step" and the fraction of the whole batch.
    told : callable
        Called with each row as soon as it is known.

    Raises
    ------
    ClonerError
        If the batch cannot start at all; a visitor's own failure is a row.
    Cancelled, KeyboardInterrupt
        After the rows so far were written.
    """
    check_formats(formats)
    visitors = find_visitors(root)
    rows: list[BatchRow] = []
    try:
        for number, (identifier, folder) in enumerate(visitors.items()):

            def step(name: str, fraction: float, number: int = number, identifier: str = identifier) -> None:
                progress(f"{identifier}: {name}", (number + fraction) / len(visitors))

            row = _one(identifier, folder, out, formats, seed, again, step)
            rows.append(row)
            told(row)
    finally:
        if out.is_dir():
            _write_summary(out, rows, len(visitors))
    return tuple(rows)


def summary_table(rows: Sequence[BatchRow]) -> str:
    """Return the rows as a table of text, with the totals below."""
    width = max((len(row.identifier) for row in rows), default=7)
    lines = [f"{'visitor':{width}}  {'status':8}  {'seconds':>7}  notes"]
    lines += [f"{row.identifier:{width}}  {row.status:8}  {row.seconds:7.1f}  {row.message}" for row in rows]
    counts = {status: sum(row.status == status for row in rows) for status in ("cloned", "skipped", "failed")}
    lines.append(", ".join(f"{count} {status}" for status, count in counts.items()))
    return "\n".join(lines)


def _one(
    identifier: str, folder: Path, out: Path, formats: Sequence[str], seed: int, again: bool, progress: Progress
) -> BatchRow:
    """Clone one visitor and return what became of it."""
    start = time.perf_counter()
    if not again and _has_result(out / identifier):
        return BatchRow(identifier, "skipped", 0.0, 0, "there is a result already; --again clones once more")
    try:
        outcome = clone_folder(folder, out, formats=formats, seed=seed, identifier=identifier, progress=progress)
    except ClonerError as error:
        return BatchRow(identifier, "failed", time.perf_counter() - start, 0, str(error))
    except Cancelled:
        raise
    except Exception as error:  # one visitor's defect must not end a night's batch
        log.exception("%s failed", identifier)
        message = f"a defect of Cloner ({type(error).__name__}); run it alone with --verbose and report it"
        return BatchRow(identifier, "failed", time.perf_counter() - start, 0, message)
    count = len(outcome.warnings)
    message = "fine" if count == 0 else f"{count} note{'s' if count > 1 else ''} in its report"
    return BatchRow(identifier, "cloned", time.perf_counter() - start, count, message)


def _has_result(folder: Path) -> bool:
    return (folder / RESULT_MARK).is_file() and (folder / CLONE_FILE).is_file()


def _walk(folder: Path, depth: int) -> list[Path]:
    """Return the folders below one that hold photos; none below a folder that holds some itself."""
    if depth < 0 or (folder / RESULT_MARK).is_file():
        return []
    if holds_photos(folder):
        return [folder]
    try:
        inner = sorted(path for path in folder.iterdir() if path.is_dir() and not path.name.startswith("."))
    except OSError:
        log.warning("a folder cannot be read and is left out")
        return []
    return [found for path in inner for found in _walk(path, depth - 1)]


def _write_summary(out: Path, rows: Sequence[BatchRow], wanted: int) -> None:
    told: dict[str, Any] = {"format": 1, "visitors": wanted, "rows": [asdict(row) for row in rows]}
    write_text(out / SUMMARY_FILE, json.dumps(told, indent=1, ensure_ascii=False) + "\n")
