"""Clones for a crowd: found in result folders, checked, and refused without consent."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from cloner.errors import ClonerError
from cloner.motion.limbs.rig import centre_joints
from cloner.project.clone_file import CLONE_FILE, load_clone
from cloner.project.folder import safe_identifier
from cloner.records.clones import Clone

#: Layers of textures that every browser with WebGL2 takes.
MOST: Final = 256
_GENERIC: Final = re.compile(r"generic ([0-9a-f]+)")


@dataclass(frozen=True, slots=True)
class Found:
    """A clone's name in the crowd and its result folder."""

    identifier: str
    folder: Path


def find_people(results: Sequence[Path]) -> tuple[Found, ...]:
    """Return the clones in result folders and in folders of results, in the given order.

    Raises
    ------
    ClonerError
        If there is none, a folder holds none, two have one name, or there are too many.
    """
    if not results:
        raise ClonerError("no clones were given", "Give result folders, or the folder of a batch", "cloner crowd")
    found: list[Found] = []
    for path in results:
        folders = (
            [path] if (path / CLONE_FILE).is_file() else sorted(one.parent for one in path.glob(f"*/{CLONE_FILE}"))
        )
        if not folders:
            raise ClonerError("there is no clone", "Give a result's folder or a batch's output", path.name or str(path))
        for folder in folders:
            if not folder.name.startswith("."):
                found.append(Found(safe_identifier(folder.resolve().name), folder))
    names = [one.identifier for one in found]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise ClonerError("two clones have this name", "Give each clone once, or rename a folder", twice[0])
    if len(found) > MOST:
        raise ClonerError(f"{len(found)} clones are too many", f"Give at most {MOST}", "cloner crowd")
    return tuple(found)


def load_person(found: Found, generic: str) -> tuple[Clone, str]:
    """Return a clone that may be shown, and the generic human it was made with.

    Parameters
    ----------
    found : Found
    generic : str
        Of the clones before; "" for the first one.

    Raises
    ------
    ClonerError
        If it cannot be read, knows no regions, comes from another generic human, or may not be shown.
    """
    try:
        clone = load_clone(found.folder / CLONE_FILE)
    except ClonerError as error:
        raise ClonerError(error.message, error.hint, found.identifier) from error
    if not clone.consent:
        hint = 'Write consent = "..." into person.toml and clone again, or leave this person out'
        raise ClonerError("no consent to being shown is recorded", hint, found.identifier)
    if not len(clone.triangle_regions):
        raise ClonerError("the clone knows no regions", "Clone the person again with this version", found.identifier)
    match = _GENERIC.search(clone.stamp)
    own = match.group(1) if match else generic
    if generic and own != generic:
        raise ClonerError("the clone was made with another generic human than the others", "Clone all of them again "
                          "with one version", found.identifier)  # fmt: skip
    return centre_joints(clone), own
