"""What is held of whom: listed, handed out, and forgotten.

Of a visitor there are the photo folder (with what was typed and corrected), the result folder, and a row in each batch
summary. Nothing else is ever written: no cache, no log file, no copy of a photo.
"""

from __future__ import annotations

import json
import os
import shutil
import time
import zipfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, Final

from cloner.errors import ClonerError
from cloner.project.atomic import RESULT_MARK
from cloner.project.folder import read_consent, read_person, safe_identifier, view_files
from cloner.project.manifest import DEEPEST, photo_folders
from cloner.project.stamps import file_digest
from cloner.records.batches import BatchRow
from cloner.report.batch import write_summary

_DAY_S: Final = 86_400.0
_FORGOTTEN: Final = ".forgotten-"
_SCANNED_SUFFIXES: Final = (".json", ".csv", ".html", ".toml", ".txt", ".log", ".wrl", ".x3d", ".gltf", ".md")
_SUMMARIES: Final = "batch*.json"


@dataclass(frozen=True, slots=True)
class Holding:
    """All that is held of one visitor.

    Attributes
    ----------
    identifier : str
    photos, result : Path or None
    files : int
    size_bytes : int
    newest : datetime
        Last change of any file, UTC.
    consent : str
        As written in ``person.toml``; "" where nothing is.
    """

    identifier: str
    photos: Path | None
    result: Path | None
    files: int
    size_bytes: int
    newest: datetime
    consent: str

    @property
    def folders(self) -> tuple[Path, ...]:
        """The folders that exist."""
        return tuple(folder for folder in (self.photos, self.result) if folder is not None)


def holdings(photos_root: Path | None, out: Path | None) -> tuple[Holding, ...]:
    """Return what is held below a root of photos and a folder of results, by identifier.

    Raises
    ------
    ClonerError
        If neither is given or a given folder is missing.
    """
    for folder in (photos_root, out):
        if folder is not None and not folder.is_dir():
            raise ClonerError(
                "there is no such folder", "Give --photos and --out as you gave them to batch", folder.name
            )
    if photos_root is None and out is None:
        raise ClonerError("there is nowhere to look", "Give --photos, --out or both", "cloner")
    photos = (
        {} if photos_root is None else {_name(photos_root, one): one for one in photo_folders(photos_root, DEEPEST)}
    )
    results = {} if out is None else {one.parent.name: one.parent for one in sorted(out.glob(f"*/{RESULT_MARK}"))}
    return tuple(holding_of(name, photos.get(name), results.get(name)) for name in sorted({*photos, *results}))


def _name(root: Path, folder: Path) -> str:
    parts = folder.relative_to(root).parts
    return safe_identifier("-".join(parts) if parts else root.resolve().name)


def holding_of(name: str, photos: Path | None, result: Path | None) -> Holding:
    """Return what is held of one visitor in a folder of photos and a folder of results."""
    files = [path for folder in (photos, result) if folder is not None for path in _files(folder)]
    newest = max((path.stat().st_mtime for path in files), default=0.0)
    size = sum(path.stat().st_size for path in files)
    consent = read_consent(photos) if photos is not None else ""
    return Holding(name, photos, result, len(files), size, datetime.fromtimestamp(newest, UTC), consent)


def _files(folder: Path) -> Iterator[Path]:
    return (path for path in sorted(folder.rglob("*")) if path.is_file() and not path.is_symlink())


def find_holding(identifier: str, held: Sequence[Holding]) -> Holding:
    """Return what is held of one visitor.

    Raises
    ------
    ClonerError
        If nothing is.
    """
    for one in held:
        if one.identifier == identifier:
            return one
    raise ClonerError("nothing is held under this name", "cloner list shows the names", identifier)


def export_data(holding: Holding, to: Path) -> Path:
    """Write everything that is held of a visitor into a new zip file and return its path.

    Raises
    ------
    ClonerError
        If the file exists or cannot be written.
    """
    if to.exists():
        raise ClonerError("the file exists", "Choose another name", to.name)
    temporary = to.with_name(f".{to.name}.partial-{os.getpid()}")
    try:
        with zipfile.ZipFile(temporary, "w", zipfile.ZIP_DEFLATED) as archive:
            for folder, label in ((holding.photos, "photos"), (holding.result, "result")):
                for path in _files(folder) if folder is not None else ():
                    archive.write(path, f"{holding.identifier}/{label}/{path.relative_to(folder).as_posix()}")  # type: ignore[arg-type]
        temporary.replace(to)
    except OSError as error:
        raise ClonerError("the zip file cannot be written", "Check the folder and its space", to.name) from error
    finally:
        temporary.unlink(missing_ok=True)
    return to


def forget(holding: Holding, photos_root: Path | None, out: Path | None) -> tuple[str, ...]:
    """Delete everything that is held of a visitor and return the files that still speak of it: none if all is well.

    Folders are renamed before they are deleted, so a kill half-way leaves nothing that would still be cloned or listed;
    the next call deletes such rests too. Every text below both folders is then searched for the visitor's identifier,
    name and photo digests.

    Raises
    ------
    ClonerError
        If something cannot be deleted.
    """
    traces = _traces(holding)
    try:
        for folder in holding.folders:
            _remove(folder)
        for root in (photos_root, out):
            for rest in root.glob(f"**/{_FORGOTTEN}*") if root is not None else ():
                shutil.rmtree(rest)
        if out is not None:
            _forget_rows(out, holding.identifier)
            for rest in out.glob(f".{holding.identifier}.*"):  # locks and rests of killed runs
                shutil.rmtree(rest) if rest.is_dir() else rest.unlink()
    except OSError as error:
        raise ClonerError(
            "not everything could be deleted", "Check permissions and repeat", holding.identifier
        ) from error
    return tuple(still_told(traces, [root for root in (photos_root, out) if root is not None]))


def _traces(holding: Holding) -> tuple[str, ...]:
    """Return the texts that would tell of a visitor."""
    found = {f'"{holding.identifier}"', f"/{holding.identifier}/"}
    if holding.photos is not None:
        found |= {file_digest(path) for path in view_files(holding.photos).values()}
        name = read_person(holding.photos).name.strip()
        if len(name) > 2:
            found.add(name)
    return tuple(found)


def still_told(traces: Sequence[str], roots: Sequence[Path]) -> Iterator[str]:
    """Yield the files below the roots that hold one of the texts or are called by one."""
    for root in roots:
        for path in _files(root):
            if path.suffix.lower() not in _SCANNED_SUFFIXES:
                continue
            text = path.read_text(encoding="utf-8", errors="replace")
            if any(trace in text for trace in traces):
                yield path.relative_to(root).as_posix()


def _remove(folder: Path) -> None:
    aside = folder.with_name(f"{_FORGOTTEN}{os.getpid()}-{time.monotonic_ns()}")
    folder.rename(aside)
    shutil.rmtree(aside)


def _forget_rows(out: Path, identifier: str) -> None:
    """Write the batch summaries anew without one visitor."""
    for path in out.glob(_SUMMARIES):
        told: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        rows = [BatchRow(**row) for row in told["rows"]]
        kept = [row for row in rows if row.identifier != identifier]
        if len(kept) != len(rows):
            write_summary(kept, int(told["visitors"]) - 1, out, path.stem)


def older_than(held: Sequence[Holding], days: float, now: datetime | None = None) -> tuple[Holding, ...]:
    """Return what was last changed more than so many days ago."""
    limit = (now or datetime.now(UTC)).timestamp() - days * _DAY_S
    return tuple(one for one in held if one.newest.timestamp() < limit)


def table(held: Sequence[Holding]) -> str:
    """Return the holdings as a table of text."""
    width = max((len(one.identifier) for one in held), default=7)
    lines = [f"{'visitor':{width}}  photos  result  files      MB  last change (UTC)  consent"]
    for one in held:
        has = [("yes" if folder is not None else "-") for folder in (one.photos, one.result)]
        lines.append(
            f"{one.identifier:{width}}  {has[0]:6}  {has[1]:6}  {one.files:5}  {one.size_bytes / 1e6:6.1f}  "
            f"{one.newest:%Y-%m-%d %H:%M}   {one.consent or 'not recorded'}"
        )
    return "\n".join(lines)
