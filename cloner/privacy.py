"""What is held of whom: listed, handed out, and forgotten.

Of a visitor there are the photo folder (with what was typed and corrected), the result folder, and a row in each batch
summary. Nothing else is ever written: no cache, no log file, no copy of a photo.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import shutil
import time
import zipfile
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, Final

from cloner.errors import ClonerError, plain
from cloner.project.atomic import RESULT_MARK, interrupted
from cloner.project.claims import claimed
from cloner.project.folder import SUFFIXES, read_consent, read_person, safe_identifier
from cloner.project.manifest import DEEPEST, photo_folders
from cloner.project.stamps import file_digest
from cloner.records.batches import BatchRow
from cloner.report.batch import write_summary

SHORTEST_NAME: Final = 2  # letters; shorter ones stand in every file
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
    consent = _consent(photos) if photos is not None else ""
    return Holding(name, photos, result, len(files), size, datetime.fromtimestamp(newest, UTC), consent)


def _consent(photos: Path) -> str:
    try:
        return plain(read_consent(photos))
    except ClonerError as error:  # who is held must be told even where a file is broken
        return f"unreadable: {error.message}"


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
    name and photo digests, and every picture compared with the visitor's own.

    Raises
    ------
    ClonerError
        If something cannot be deleted, or a run is at work on the visitor.
    """
    traces, sizes = _traces(holding), {path.stat().st_size for path in _pictures(holding)}
    roots = [root for root in (photos_root, out) if root is not None]
    with contextlib.ExitStack() as stack:
        if out is not None and not stack.enter_context(claimed(out, holding.identifier)):
            raise _busy(holding)
        try:
            _delete(holding, roots, out)
        except OSError as error:
            raise ClonerError(
                "not everything could be deleted", "Check permissions and repeat", holding.identifier
            ) from error
    return tuple(still_told(traces, sizes, roots))


def _delete(holding: Holding, roots: Sequence[Path], out: Path | None) -> None:
    """Delete folders, rows, and what killed runs left of a visitor."""
    rests = interrupted(out, holding.identifier) if out is not None else []
    if rests is None:
        raise _busy(holding)
    for folder in (*holding.folders, *rests):
        _remove(folder)
    for root in roots:
        for rest in root.glob(f"**/{_FORGOTTEN}*"):
            shutil.rmtree(rest)
        for path in root.glob("*.log*"):
            _forget_lines(path, holding.identifier)
    if out is not None:
        _forget_rows(out, holding.identifier)


def _forget_lines(path: Path, identifier: str) -> None:
    """Take the lines about a visitor out of a log; in place, because a running window goes on writing into it."""
    told = re.compile(rf"(?<![\w.-]){re.escape(identifier)}(?![\w-])")
    with path.open("r+", encoding="utf-8", errors="replace") as stream:
        lines = stream.readlines()
        kept = [line for line in lines if not told.search(line)]
        if len(kept) < len(lines):
            stream.seek(0)
            stream.writelines(kept)
            stream.truncate()


def _busy(holding: Holding) -> ClonerError:
    return ClonerError("somebody is cloning this visitor just now", "Wait or stop that, and repeat", holding.identifier)


def _traces(holding: Holding) -> tuple[str, ...]:
    """Return the texts that would tell of a visitor."""
    found = {f'"{holding.identifier}"', f"/{holding.identifier}/"}
    if holding.photos is not None:
        found |= {file_digest(path) for path in _pictures(holding)}
        with contextlib.suppress(ClonerError):  # a broken file tells no name
            name = read_person(holding.photos).name.strip()
            found |= {name} if len(name) > SHORTEST_NAME else set()
    if holding.result is not None:
        found |= set(_photo_digests(holding.result))
    return tuple(found)


def _photo_digests(result: Path) -> Iterator[str]:
    """Yield the digests of the photos a result was made from, as far as its report can be read."""
    try:
        photos = json.loads((result / RESULT_MARK).read_text(encoding="utf-8"))["photos"]
        yield from (str(photo["sha256"]) for photo in photos.values())
    except (OSError, ValueError, LookupError, TypeError, AttributeError):
        return


def _pictures(holding: Holding) -> list[Path]:
    """Return the visitor's photos and the previews made of them."""
    folders = (holding.photos, holding.result / "previews" if holding.result is not None else None)
    return [path for folder in folders if folder is not None for path in _files(folder) if _is_picture(path)]


def _is_picture(path: Path) -> bool:
    return path.suffix.lower() in SUFFIXES


def still_told(traces: Sequence[str], sizes: Collection[int], roots: Sequence[Path]) -> Iterator[str]:
    """Yield the files below the roots that hold one of the texts, and pictures with one of them as their digest."""
    for root in roots:
        for path in _files(root):
            if _is_picture(path):
                text = file_digest(path) if path.stat().st_size in sizes else ""
            elif path.suffix.lower() in _SCANNED_SUFFIXES:
                text = path.read_text(encoding="utf-8", errors="replace")
            else:
                continue
            if any(trace in text for trace in traces):
                yield path.relative_to(root).as_posix()


def _remove(folder: Path) -> None:
    aside = folder.with_name(f"{_FORGOTTEN}{os.getpid()}-{time.monotonic_ns()}")
    folder.rename(aside)
    shutil.rmtree(aside)


def _forget_rows(out: Path, identifier: str) -> None:
    """Write the batch summaries anew without one visitor."""
    for path in out.glob(_SUMMARIES):
        try:
            told: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
            rows = [BatchRow(**row) for row in told["rows"]]
        except (ValueError, LookupError, TypeError):
            continue  # no summary of ours; the scan afterwards tells whether it speaks of the visitor
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
