"""One visitor, one worker."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from cloner.project.atomic import unwritable
from cloner.project.locks import lock, release


@contextmanager
def claimed(out: Path, identifier: str) -> Iterator[bool]:
    """Give whether this process may clone a visitor; others that ask meanwhile get False.

    Raises
    ------
    ClonerError
        If ``out`` cannot be written.
    """
    path = claim_path(out, identifier)
    try:
        out.mkdir(parents=True, exist_ok=True)
        descriptor = lock(path)
    except OSError as error:
        raise unwritable(out) from error
    if descriptor is None:
        yield False
        return
    try:
        yield True
    finally:
        release(descriptor, path)


def claim_path(out: Path, identifier: str) -> Path:
    """Return the lock file of a visitor."""
    return out / f".{identifier}.claim"
