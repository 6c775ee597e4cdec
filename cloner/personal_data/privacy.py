"""Listing, export and deletion of a visitor's data.

Of a visitor there are the photo folder (with what was typed and corrected), the result folders, what killed runs left
of them, and a row in each batch summary. Packs of crowds, and films of them, show them
too (`cloner.crowd.packs.held`). Nothing else is ever written: no cache, no log file, no copy of a photo.
Photos and results belong together by what a result's manifest says it was made from, whatever they are called.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import shutil
import stat
import time
import zipfile
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any, Final

from cloner.crowd.packs.held import find_films, pack_of
from cloner.errors import ClonerError
from cloner.personal_data.holdings import Holding, photo_digests
from cloner.personal_data.leftovers import Traces, left_of
from cloner.project.atomic import atomic_path, interrupted, safe_output
from cloner.project.claims import claim
from cloner.project.corrections import WHERE as CORRECTIONS_FILE
from cloner.project.folder import PERSON_FILE, SUFFIXES, read_person
from cloner.project.results import RESULT_MARK, file_digest, foreign_files, read_manifest
from cloner.project.stamps import photos_token
from cloner.project.texts import LARGEST_BYTES
from cloner.records.batches import BatchRow
from cloner.report.batch import write_summary
from cloner.untrusted import read_untrusted, walk_files

_FORGOTTEN: Final = ".forgotten-"
_ASIDE: Final = re.compile(r"\.forgotten-\d+-\d+")
_SUMMARIES: Final = "batch*.json"
#: What is typed or counted may be the same of two visitors: its digest tells of nobody.
_TYPED: Final = (".json", ".toml", ".txt", ".csv")


def export_data(holding: Holding, to: Path) -> Path:
    """Write everything that is held of a visitor into a new zip file and return its path.

    Raises
    ------
    ClonerError
        If the file exists or cannot be written.
    """
    safe_output(to)
    try:
        with atomic_path(to) as temporary, zipfile.ZipFile(temporary, "w", zipfile.ZIP_DEFLATED) as archive:
            for folder, label in _labelled(holding):
                for path in holding.files_in(folder):
                    archive.write(path, f"{holding.identifier}/{label}/{path.relative_to(folder).as_posix()}")
    except OSError as error:
        raise ClonerError("the zip file cannot be written", "Check the folder and its space", to.name) from error
    return to


def _labelled(holding: Holding) -> Iterator[tuple[Path, str]]:
    """Yield the folders of a visitor and what they are called in a zip file."""
    names = {"photos": holding.photos, "result": holding.results, "interrupted": holding.rests, "crowd": holding.packs}
    for label, folders in names.items():
        for number, folder in enumerate(folders):
            yield folder, label if number == 0 else f"{label}-{number + 1}"


def forget(holding: Holding, photos_root: Path | None, out: Path | None) -> tuple[str, ...]:
    """Delete everything that is held of a visitor and return the files that still speak of it; see `forget_all`."""
    return forget_all((holding,), photos_root, out)


def forget_all(held: Sequence[Holding], photos_root: Path | None, out: Path | None) -> tuple[str, ...]:
    """Delete everything that is held of visitors and return the files that still speak of them: none if all is well.

    Folders are renamed before they are deleted, so a kill half-way leaves nothing that would still be cloned or listed;
    the next call deletes such rests too. What cannot be deleted, and what a result's manifest does not list, stays and
    is told. Everything below both folders is then searched, once; see `cloner.personal_data.leftovers`.

    Raises
    ------
    ClonerError
        If a run is at work on a visitor; nothing is deleted then.
    """
    traces = _traces(held)
    roots = [root for root in (photos_root, out) if root is not None]
    with contextlib.ExitStack() as stack:
        for holding in held:
            if out is not None and not all(stack.enter_context(claim(out, name)) for name in holding.names):
                raise _busy(holding)
        left = [one for holding in held for one in _delete(holding, roots, out)]
        left += [*_delete_rests(roots), *_delete_films(roots, traces)]
    left_names = {one.partition(" (")[0] for one in left}
    left += [one for one in left_of(traces, roots) if one not in left_names]
    return tuple(dict.fromkeys(left))


def _delete(holding: Holding, roots: Sequence[Path], out: Path | None) -> Iterator[str]:
    """Delete folders, lines and rows of a visitor; yield what stays."""
    for name in holding.names if out is not None else ():
        if interrupted(out, name) is None:  # type: ignore[arg-type]
            raise _busy(holding)
    for pack in dict.fromkeys(map(pack_of, holding.packs)):
        yield from _remove(pack)
    for folder in (*holding.results, *holding.rests):
        yield from _delete_result(folder) if folder in holding.results else _remove(folder)
    for folder in holding.photos:
        yield from _delete_photos(folder, roots, out)
    for path in [path for root in roots for path in root.glob("*.log*")]:
        yield from _forget_lines(path, holding.names)
    if out is not None:
        yield from _forget_rows(out, holding.names)


def _delete_rests(roots: Sequence[Path]) -> Iterator[str]:
    """Delete what killed deletions left; yield what stays."""
    for path in [path for root in roots for path in walk_files(root)]:
        if _ASIDE.fullmatch(path.name):
            yield from _remove(path)


def _delete_films(roots: Sequence[Path], traces: Traces) -> Iterator[str]:
    """Delete the films and pictures of packs that show a visitor; yield what stays."""
    for path in [path for root in roots for path in find_films(root, set(traces.tokens))]:
        try:
            path.unlink(missing_ok=True)
        except OSError as error:
            yield _stays(path, error)


def _delete_result(folder: Path) -> Iterator[str]:
    """Delete a result; of one with additional files only what its manifest lists, the rest is reported."""
    foreign, manifest = foreign_files(folder), read_manifest(folder)
    if not foreign:
        yield from _remove(folder)
        return
    for name in (*manifest.outputs, RESULT_MARK) if manifest is not None else ():
        if name not in foreign:
            with contextlib.suppress(FileNotFoundError):
                (folder / name).unlink()
    yield from (f"{folder.name}/{name} (no part of a result)" for name in foreign if not (folder / name).is_dir())


def _delete_photos(folder: Path, roots: Sequence[Path], out: Path | None) -> Iterator[str]:
    """Delete a visitor's folder; where others lie below it, only the visitor's own files."""
    own = folder.resolve()
    above = [one for one in (*roots, *([out] if out is not None else [])) if one.resolve().is_relative_to(own)]
    if not above:
        yield from _remove(folder)
        return
    for path in sorted(folder.iterdir()):
        is_photo = path.suffix.lower() in SUFFIXES and not path.is_dir()
        if is_photo or path.name in (PERSON_FILE, CORRECTIONS_FILE):
            try:
                path.unlink()
            except OSError as error:
                yield _stays(path, error)


def _remove(folder: Path) -> Iterator[str]:
    """Delete a folder; yield it where that cannot be."""
    aside = folder.with_name(f"{_FORGOTTEN}{os.getpid()}-{time.monotonic_ns()}")
    try:
        folder.rename(aside)
    except FileNotFoundError:
        return
    except OSError as error:
        yield _stays(folder, error)
        return
    try:
        shutil.rmtree(aside)
    except OSError as error:
        with contextlib.suppress(OSError):  # what cannot be deleted keeps its name
            aside.rename(folder)
        yield _stays(folder, error)


def _stays(path: Path, error: OSError) -> str:
    return f"{path.name} (cannot be deleted: {error.strerror or type(error).__name__})"


def _forget_lines(path: Path, names: Iterable[str]) -> Iterator[str]:
    """Remove the lines about a visitor from a log, in place, as a running window keeps writing to it.

    A link is left alone: what it leads to is somebody else's; so is what is no file.
    """
    pattern = re.compile("|".join(rf"(?<![\w.-]){re.escape(name)}(?![\w-])" for name in names))
    try:
        if not stat.S_ISREG(path.lstat().st_mode):
            return
        descriptor = os.open(path, os.O_RDWR | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))
        with os.fdopen(descriptor, "r+", encoding="utf-8", errors="surrogateescape") as stream:
            lines = stream.readlines()
            kept = [line for line in lines if not pattern.search(line)]
            if len(kept) < len(lines):
                stream.seek(0)
                stream.writelines(kept)
                stream.truncate()
    except OSError as error:
        yield _stays(path, error)


def _busy(holding: Holding) -> ClonerError:
    return ClonerError("somebody is cloning this visitor just now", "Wait or stop that, and repeat", holding.identifier)


def _traces(held: Sequence[Holding]) -> Traces:
    """Return what would identify visitors."""
    digests: dict[str, int | None] = {}
    names, tokens = {name for holding in held for name in holding.names}, set()
    for folder in [folder for holding in held for folder in holding.results]:
        manifest = read_manifest(folder)
        if manifest is not None:
            photos = [digest for name, digest in manifest.inputs.items() if "." not in name]
            digests |= dict.fromkeys((*photos, *manifest.outputs.values()))
            tokens.add(photos_token(photos))
    digests.pop("", None)
    for folder in [folder for holding in held for folder in holding.photos]:
        tokens.add(photos_token(photo_digests(folder)))
        with contextlib.suppress(ClonerError):  # a broken file tells no name
            names |= {read_person(folder).name.strip()} - {""}
    for path in [path for holding in held for folder in holding.folders for path in holding.files_in(folder)]:
        with contextlib.suppress(OSError):
            if path.stat().st_size and path.suffix.lower() not in _TYPED:
                digests[file_digest(path)] = path.stat().st_size
    return Traces(digests, names, tokens)


def _forget_rows(out: Path, names: Iterable[str]) -> Iterator[str]:
    """Write the batch summaries anew without one visitor; yield those that cannot be written."""
    gone = set(names)
    for path in out.glob(_SUMMARIES):
        try:
            data: dict[str, Any] = json.loads(read_untrusted(path, LARGEST_BYTES))
            rows = [BatchRow(**row) for row in data["rows"]]
        except (OSError, ValueError, LookupError, TypeError):
            continue  # no summary of ours; the search afterwards tells whether it speaks of the visitor
        kept = [row for row in rows if row.identifier not in gone]
        if len(kept) != len(rows):
            try:
                write_summary(kept, int(data["visitors"]) - 1, out, path.stem)
            except ClonerError as error:
                yield f"{path.name} ({error.message})"
