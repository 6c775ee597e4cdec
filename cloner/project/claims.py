"""Locks on visitors: one worker at a time."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from cloner.project.atomic import unwritable
from cloner.project.locks import lock, release

_SUFFIX: Final = ".claim"
_LOOKS: Final = 3  # others hold a claim for a moment when they look whether it is one
#: How often it is looked whether a claim is free, seconds (taste).
_LOOK_S: Final = 0.05


@contextmanager
def claim(out: Path, identifier: str) -> Iterator[bool]:
    """Yield whether this process may clone a visitor; other processes get False meanwhile.

    Raises
    ------
    ClonerError
        If ``out`` cannot be written.
    """
    path = claim_path(out, identifier)
    try:
        out.mkdir(parents=True, exist_ok=True)
        descriptor = _patient_lock(path)
    except OSError as error:
        raise unwritable(out) from error
    if descriptor is None:
        yield False
        return
    try:
        yield True
    finally:
        release(descriptor, path)


def _patient_lock(path: Path) -> int | None:
    """Return the lock of a path, None where somebody holds it for longer than a look at it takes."""
    for _ in range(_LOOKS):
        descriptor = lock(path)
        if descriptor is not None:
            return descriptor
        time.sleep(_LOOK_S)
    return None


def claimants(out: Path) -> tuple[str, ...]:
    """Return the identifiers of all claims in a folder, of killed runs too."""
    return tuple(path.name[1 : -len(_SUFFIX)] for path in sorted(out.glob(f".*{_SUFFIX}")))


def claim_path(out: Path, identifier: str) -> Path:
    """Return the lock file of a visitor."""
    return out / f".{identifier}{_SUFFIX}"
