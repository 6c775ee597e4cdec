"""Copies to a USB stick: written, flushed, and read back before they are reported as complete."""

from __future__ import annotations

import glob
import hashlib
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final

from cloner.errors import ClonerError
from cloner.pipeline import Progress
from cloner.project.atomic import atomic_path, remove

#: Bytes that are copied between two looks whether somebody stopped it: a slow stick takes a quarter of a second.
_CHUNK: Final = 1 << 20


def copy_verified(source: Path, target: Path, progress: Progress) -> Path:
    """Copy a file or a folder and read it back before it gets its name: it is complete and correct, or absent.

    Parameters
    ----------
    source, target : Path
        The target must not exist; what a killed run left of it is removed.
    progress : callable
        Called with "copy" and "verify"; may raise Cancelled.

    Raises
    ------
    ClonerError
        If what is read back is not what was written.
    OSError
        If it cannot be written.
    """
    remove_leftovers(target)
    with atomic_path(target) as room:
        files = [source] if source.is_file() else sorted(path for path in source.rglob("*") if path.is_file())
        pairs = [(path, room / path.relative_to(source)) for path in files]
        bytes_done = _ByteProgress(progress, 2 * sum(path.stat().st_size for path in files))
        digests = [_copy(one, other, bytes_done.on("copy")) for one, other in pairs]
        for (_, other), digest in zip(pairs, digests, strict=True):
            if _read_back(other, bytes_done.on("verify")) != digest:
                hint = "Use another stick: this one loses what is written on it"
                raise ClonerError("what was written there reads differently", hint, target.name)
    _write_through(target.parent)
    return target


def remove_leftovers(target: Path) -> None:
    """Remove what a killed process left of a copy to ``target``."""
    for rest in target.parent.glob(f".{glob.escape(target.name)}.partial-*"):
        remove(rest)


class _ByteProgress:
    """Reports how many of all bytes are done."""

    def __init__(self, progress: Progress, whole: int) -> None:
        self._progress, self._whole, self._done = progress, max(whole, 1), 0

    def on(self, step: str) -> Callable[[int], None]:
        """Return a function that reports the bytes done of a step."""

        def tell(count: int) -> None:
            self._done += count
            self._progress(step, min(self._done / self._whole, 1.0))

        return tell


def _copy(source: Path, target: Path, tell: Callable[[int], None]) -> str:
    """Copy a file through to the disk and return the sha256 of what was read."""
    target.parent.mkdir(parents=True, exist_ok=True)
    seen = hashlib.sha256()
    with source.open("rb") as read, target.open("wb") as written:
        for chunk in _chunks(read.read):
            seen.update(chunk)
            written.write(chunk)
            tell(len(chunk))
        written.flush()
        os.fsync(written.fileno())
    return seen.hexdigest()


def _read_back(path: Path, tell: Callable[[int], None]) -> str:
    """Return the sha256 of a file as the disk returns it: the page cache is dropped first."""
    seen = hashlib.sha256()
    with path.open("rb", buffering=0) as read:
        if hasattr(os, "posix_fadvise"):
            os.posix_fadvise(read.fileno(), 0, 0, os.POSIX_FADV_DONTNEED)
        for chunk in _chunks(read.read):
            seen.update(chunk)
            tell(len(chunk))
    return seen.hexdigest()


def _chunks(read: Callable[[int], bytes]) -> Iterator[bytes]:
    while chunk := read(_CHUNK):
        yield chunk


def _write_through(folder: Path) -> None:
    """Sync a folder's entries to the disk; file systems without that are no error."""
    try:
        held = os.open(folder, os.O_RDONLY)
    except OSError:
        return
    try:
        os.fsync(held)
    except OSError:
        pass
    finally:
        os.close(held)
