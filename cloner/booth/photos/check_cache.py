"""Cached checks of a visitor's photos, by digest."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Final

from cloner.booth.photos.photo_problems import PhotoCheck, PhotoProblem
from cloner.booth.visitors.cached_work import WORK
from cloner.frames import ViewId
from cloner.project.atomic import write_text
from cloner.project.texts import LARGEST_BYTES
from cloner.untrusted import read_untrusted

CHECKS_FILE: Final = "looks.json"


def read_checks(folder: Path) -> dict[str, PhotoCheck]:
    """Return cached checks by digest; missing, damaged or outdated ones are computed again."""
    try:
        data = json.loads(read_untrusted(folder / WORK / CHECKS_FILE, LARGEST_BYTES))
        found = [_check(digest, one) for digest, one in data.items()]
    except (OSError, ValueError, AttributeError, RecursionError):
        return {}
    return {check.digest: check for check in found if check is not None}


def _check(digest: str, data: Mapping[str, object]) -> PhotoCheck | None:
    """Return one photo's entry; None if it is not as :func:`store_check` writes it."""
    try:
        view, troubles, passes = data["view"], data["troubles"], data["passes"]
        if not isinstance(troubles, list) or not isinstance(passes, list):
            return None
        views = frozenset(ViewId(one) for one in passes)
        return PhotoCheck(
            digest, ViewId(str(view)) if view else None, tuple(PhotoProblem(one) for one in troubles), views
        )
    except (ValueError, TypeError, KeyError):
        return None


def store_check(folder: Path, check: PhotoCheck) -> None:
    """Add the check of one photo.

    Raises
    ------
    ClonerError
        If the folder cannot be written.
    """
    checks = {**read_checks(folder), check.digest: check}
    data = {
        one.digest: {"view": one.view, "troubles": list(one.troubles), "passes": sorted(one.passes)}
        for one in checks.values()
    }
    (folder / WORK).mkdir(exist_ok=True)
    write_text(folder / WORK / CHECKS_FILE, json.dumps(data, indent=1) + "\n")
