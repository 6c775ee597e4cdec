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

from cloner.booth.visitors.kept import CLONE_FILE, RESULTS, VALUES_FILE, WORK
from cloner.errors import ClonerError
from cloner.project.results import RESULT_MARK
from cloner.project.texts import read_text

#: Beside the results: the result before with its values, one of them; and while it is put in place.
BEFORE: Final = "clone_before"
_COMING: Final = ".clone_before-coming"
_GOING: Final = ".clone_before-going"
_VALUES: Final = "values.npz"
_RESULT: Final = "result"


def has_before(visitor: Path) -> bool:
    """Return whether there is a clone before the last one."""
    result = visitor / BEFORE / _RESULT
    return (result / RESULT_MARK).is_file() and (result / CLONE_FILE).is_file()


@contextmanager
def keeping_before(visitor: Path, name: str, photos: Mapping[str, str]) -> Iterator[None]:
    """Keep a visitor's result as the clone before, if the block, which makes another, ends well.

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
        _laid_aside(result, visitor / WORK / VALUES_FILE, coming)
    try:
        yield
    except BaseException:
        shutil.rmtree(coming, ignore_errors=True)
        raise
    shutil.rmtree(before, ignore_errors=True)
    if kept:
        coming.rename(before)


def bring_before(visitor: Path, name: str) -> None:
    """Exchange a visitor's clone and the one before; done again it is as it was.

    Raises
    ------
    ClonerError
        If there is none before, or files cannot be moved.
    """
    if not has_before(visitor):
        raise ClonerError("there is no clone before this one", "Clone again", visitor.name)
    try:
        shutil.rmtree(visitor / _COMING, ignore_errors=True)
        _laid_aside(visitor / RESULTS / name, visitor / WORK / VALUES_FILE, visitor / _COMING)
        (visitor / RESULTS / name).rename(visitor / _GOING)
        mend_versions(visitor, name)
        os.utime(visitor / RESULTS / name / CLONE_FILE)  # what was drawn of the other is older, and drawn anew
    except OSError as error:
        raise ClonerError("the visitor cannot be moved", "Check permissions and space", visitor.name) from error


def mend_versions(visitor: Path, name: str) -> None:
    """Finish an exchange that has begun, also one that a crash broke off: both clones are whole afterwards.

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
    """Return the digests of the photos that a result was made of; None where there is no whole one."""
    if not (result / CLONE_FILE).is_file():
        return None
    try:
        return json.loads(read_text(result / RESULT_MARK))["stamp"]["photos"]
    except (ClonerError, OSError, ValueError, LookupError, TypeError):
        return None


def _laid_aside(result: Path, values: Path, to: Path) -> None:
    """Link a result and its values to another place; copy them where the disk has no links."""
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
