"""Atomic writes: results appear completely or not at all."""

from __future__ import annotations

import contextlib
import errno
import logging
import os
import re
import secrets
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from cloner.errors import ClonerError
from cloner.project.locks import lock
from cloner.project.results import check_replaceable

log = logging.getLogger(__name__)

_DISK_TROUBLE: Final = {
    errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EIO, errno.EACCES, errno.EPERM, errno.EFBIG,
}  # fmt: skip
_LOCK: Final = ".lock"
_REPLACED: Final = "replaced"
_REST: Final = re.compile(r"\.(?P<identifier>.+)\.partial-\d+-\w+")
#: Times a temporary folder is made anew when a neighbour swept it away (taste).
_TRIES: Final = 3
#: Random part of a temporary folder's name (taste): nobody on a shared disk has it already.
_NAME_BYTES: Final = 4


def write_text(path: Path, text: str) -> None:
    """Write a small file in one step; see :func:`atomic_file`.

    Raises
    ------
    ClonerError
        If the folder cannot be written.
    """
    with atomic_file(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


@contextlib.contextmanager
def atomic_file(out: Path) -> Iterator[Path]:
    """Yield a temporary neighbour, of the same suffix, that becomes the file ``out`` when the block succeeds.

    Raises
    ------
    ClonerError
        If the disk refuses.
    """
    try:
        with atomic_path(out, out.suffix) as temporary:
            yield temporary
    except OSError as error:
        raise ClonerError("the file cannot be written", "Check the folder's permissions and space", out.name) from error


@contextlib.contextmanager
def atomic_path(out: Path, suffix: str = "") -> Iterator[Path]:
    """Yield the name of a temporary neighbour, file or folder, that becomes ``out`` when the block succeeds.

    However the block ends, nothing of the neighbour stays. Only with a ``suffix`` can others take it for a finished
    file, as writers do that ask a name for its kind.
    """
    temporary = out.with_name(f".{out.name}.partial-{os.getpid()}{suffix}")
    try:
        yield temporary
        temporary.replace(out)
    finally:
        remove(temporary)


def remove(path: Path) -> None:
    """Remove a file or a folder with all that is in it, where it is there."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink(missing_ok=True)


@contextlib.contextmanager
def result_folder(out: Path, identifier: str, photos: Path | None = None) -> Iterator[Path]:
    """Give a temporary folder that becomes ``out/identifier`` when the block ends well.

    Whatever ends the block otherwise (an error, Ctrl-C) removes the temporary
    folder, and ``out`` too if it was made here.  An older result of the same
    name is replaced by renaming.  Temporary folders of killed runs are removed
    first; a lock on each folder tells the dead from the running.

    Parameters
    ----------
    out : Path
        Folder of all results; made if missing.
    identifier : str
        Name of this result, safe as a path component.
    photos : Path or None
        The folder that is cloned from; never replaced.

    Raises
    ------
    ClonerError
        If ``out`` cannot be written, or holds of that name anything but a whole result.
    """
    made = _missing(out)
    partial = partial_path(out, identifier)
    final = out / identifier
    held = -1
    try:
        _make_folder(out)
        recover(out)
        check_replaceable(final, photos)
        held = _make_locked(partial)
        inside = partial / identifier  # the temporary folder is private (0700); the result gets ordinary permissions
        inside.mkdir()
        yield inside
        _swap_in(inside, final, photos)
    except OSError as error:
        if error.errno in _DISK_TROUBLE:
            raise unwritable(out) from error
        raise
    finally:
        if held >= 0:
            os.close(held)
        shutil.rmtree(partial, ignore_errors=True)
        _remove_empty(made)


def check_writable(out: Path) -> None:
    """Refuse a folder of results that cannot be written, before any work; leaves none behind.

    Raises
    ------
    ClonerError
        If it cannot be made or written.
    """
    made = _missing(out)
    try:
        _make_folder(out)
    finally:
        _remove_empty(made)


def unwritable(out: Path) -> ClonerError:
    """Return the complaint about a folder of results that cannot be written."""
    hint = "Choose another --out folder, or check its permissions and free space"
    return ClonerError("the results cannot be written there", hint, out.name or "output folder")


def _missing(out: Path) -> list[Path]:
    """Return the folders that must be made for ``out`` to be there, outermost first."""
    return [folder for folder in (out, *out.parents) if not folder.exists()][::-1]


def _make_folder(out: Path) -> None:
    """Make ``out`` and see that it can be written."""
    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=out):
            pass  # permission bits do not tell the whole truth (read-only mounts, root): try
    except OSError as error:
        raise unwritable(out) from error


def _remove_empty(folders: list[Path]) -> None:
    """Remove the folders made here that hold nothing, innermost first."""
    for folder in reversed(folders):
        with contextlib.suppress(OSError):
            folder.rmdir()


def _make_locked(partial: Path) -> int:
    """Make a temporary folder and return the descriptor of its lock."""
    for _ in range(_TRIES):  # a neighbour that sweeps may take an unlocked folder for a dead one
        partial.mkdir(mode=0o700, exist_ok=True)
        with contextlib.suppress(FileNotFoundError):
            held = lock(partial / _LOCK)
            if held is not None:
                return held
    raise OSError(errno.EIO, "temporary folders vanish")


def partial_path(out: Path, identifier: str) -> Path:
    """Return a new name for a temporary folder of a result, which says whose process makes it.

    Named before it is made: a request to end may come between any two lines, and what has no name stays.
    """
    return out / f".{identifier}.partial-{os.getpid()}-{secrets.token_hex(_NAME_BYTES)}"


def partial_results(out: Path) -> dict[Path, str]:
    """Return the temporary folders of results in a folder, of running processes too, with their
    visitors' identifiers.
    """
    found = {}
    for path in sorted(out.iterdir()):
        match = _REST.fullmatch(path.name)
        if match is None or path.is_symlink() or not path.is_dir():
            continue
        with contextlib.suppress(FileNotFoundError):  # its own run has just removed it
            identifier = match["identifier"]
            if {inner.name for inner in path.iterdir()} <= {_LOCK, _REPLACED, identifier}:
                found[path] = identifier
    return found


def interrupted(out: Path, identifier: str) -> list[Path] | None:
    """Return the temporary folders that killed runs left of a result; None where a run is at work in one."""
    found = []
    for partial in [path for path, name in partial_results(out).items() if name == identifier]:
        try:
            held = lock(partial / _LOCK)
        except FileNotFoundError:
            continue
        if held is None:
            return None
        os.close(held)
        found.append(partial)
    return found


def recover(out: Path) -> tuple[str, ...]:
    """Recover a folder from killed runs: restore a result they had moved aside, delete their temporary files.

    Never touches another running one's: a lock tells. Returns the identifiers whose rests are gone.
    """
    gone = []
    for partial, identifier in partial_results(out).items():
        try:
            held = lock(partial / _LOCK)
        except OSError:
            continue  # its own run has just removed it
        if held is None:
            continue  # another run is at work in it
        older = partial / _REPLACED
        try:
            if older.is_dir() and not (out / identifier).exists():
                older.rename(out / identifier)
        finally:
            os.close(held)
        shutil.rmtree(partial, ignore_errors=True)
        gone.append(identifier)
        log.info("removed what an interrupted run left behind")
    return tuple(gone)


def _swap_in(inside: Path, final: Path, photos: Path | None) -> None:
    """Rename the finished result into place, an older one out of it first; one that gained files meanwhile stays."""
    older = inside.parent / _REPLACED
    if final.exists() or final.is_symlink():
        check_replaceable(final, photos)
        final.rename(older)
    try:
        check_replaceable(final, photos, whole=older)  # again: nobody reaches it by its name now
        inside.rename(final)
    except BaseException:
        if older.exists():
            older.rename(final)
        raise


def safe_output(path: Path) -> Path:
    """Return a path that a single file may be written to: nothing has this name yet.

    Raises
    ------
    ClonerError
        If anything has this name: a photo, a clone or a picture is never replaced by a command.
    """
    try:
        taken = path.is_symlink() or path.exists()
    except (OSError, ValueError) as error:  # longer than any file system takes, or with characters that none takes
        raise ClonerError("no file can be called that", "Choose another --out file", path.name or "--out") from error
    if taken:
        raise ClonerError("the file exists and is not replaced", "Choose another --out file, or delete it", path.name)
    return path
