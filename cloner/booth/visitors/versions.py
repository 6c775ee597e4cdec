"""The previous clone: kept when a visitor is cloned again, and restored if the new one is no better."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from cloner.booth.visitors.cached_work import CLONE_FILE, RESULTS, VALUES_FILE, WORK
from cloner.errors import ClonerError
from cloner.project.results import RESULT_MARK
from cloner.project.texts import read_text

#: Beside the results: the result before with its values, one of them; and while it is put in place.
BEFORE: Final = "clone_before"
_COMING: Final = ".clone_before-coming"
_GOING: Final = ".clone_before-going"
_VALUES: Final = "values.npz"
_RESULT: Final = "result"


def has_previous(visitor: Path) -> bool:
    """Return whether there is a previous clone."""
    result = visitor / BEFORE / _RESULT
    return (result / RESULT_MARK).is_file() and (result / CLONE_FILE).is_file()


@contextmanager
def keep_previous(visitor: Path, name: str, photos: Mapping[str, str]) -> Iterator[None]:
    """Keep a visitor's result as the previous clone if the block, which makes another, succeeds.

    Parameters
    ----------
    visitor : Path
    name : str
        Of the result below the visitor's results.
    photos : mapping
        Digests of the photos that are cloned; a result of others is not kept, because it is nobody's any more.
    """
    coming, before = visitor / _COMING, visitor / BEFORE
    shutil.rmtree(coming, ignore_errors=True)  # of a run that was killed
    result = visitor / RESULTS / name
    kept = _photos_of(result) == photos
    if kept:
        _linked_copy(result, visitor / WORK / VALUES_FILE, coming)
    try:
        yield
    except BaseException:
        shutil.rmtree(coming, ignore_errors=True)
        raise
    shutil.rmtree(before, ignore_errors=True)
    if kept:
        coming.rename(before)


def swap_with_previous(visitor: Path, name: str) -> None:
    """Exchange a visitor's clone and the previous one; doing it twice changes nothing.

    Raises
    ------
    ClonerError
        If there is none before, or files cannot be moved.
    """
    if not has_previous(visitor):
        raise ClonerError("there is no clone before this one", "Clone again", visitor.name)
    try:
        shutil.rmtree(visitor / _COMING, ignore_errors=True)
        _linked_copy(visitor / RESULTS / name, visitor / WORK / VALUES_FILE, visitor / _COMING)
        (visitor / RESULTS / name).rename(visitor / _GOING)
        finish_swap(visitor, name)
        os.utime(visitor / RESULTS / name / CLONE_FILE)  # what was drawn of the other is older, and drawn anew
    except OSError as error:
        raise ClonerError("the visitor cannot be moved", "Check permissions and space", visitor.name) from error


def finish_swap(visitor: Path, name: str) -> None:
    """Finish an exchange that a crash interrupted: both clones are complete afterwards.

    Raises
    ------
    OSError
        If files cannot be moved.
    """
    result, before, coming, going = visitor / RESULTS / name, visitor / BEFORE, visitor / _COMING, visitor / _GOING
    if going.is_dir():
        if not result.is_dir():
            (before / _RESULT).rename(result)
        if coming.is_dir():
            with contextlib.suppress(FileNotFoundError):
                os.replace(before / _VALUES, visitor / WORK / VALUES_FILE)
            shutil.rmtree(before, ignore_errors=True)
            coming.rename(before)
    for rest in (going, coming):
        shutil.rmtree(rest, ignore_errors=True)


def _photos_of(result: Path) -> object:
    """Return the digests of the photos that a result was made of; None if the result is incomplete."""
    if not (result / CLONE_FILE).is_file():
        return None
    try:
        return json.loads(read_text(result / RESULT_MARK))["stamp"]["photos"]
    except (ClonerError, OSError, ValueError, LookupError, TypeError):
        return None


def _linked_copy(result: Path, values: Path, to: Path) -> None:
    """Hard-link a result and its values to another place; copy them if the disk has no links."""
    to.mkdir()
    shutil.copytree(result, to / _RESULT, copy_function=_link)
    if values.is_file():
        _link(str(values), str(to / _VALUES))


def _link(source: str, target: str) -> str:
    try:
        os.link(source, target)
    except OSError:
        shutil.copy2(source, target)
    return target
