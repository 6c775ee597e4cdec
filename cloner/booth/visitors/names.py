"""Visitors' names on the operator's screen: name and number; log and files use numbers only."""

from __future__ import annotations

import os
import tomllib
from pathlib import Path

from cloner.errors import ClonerError
from cloner.project.folder import PERSON_FILE
from cloner.project.texts import LARGEST_BYTES
from cloner.untrusted import read_untrusted


def number_of(folder: Path) -> str:
    """Return a visitor's number, "7" of ``visitor-007``; the folder's name if it has none."""
    digits = folder.name.removeprefix("visitor-")
    return str(int(digits)) if digits != folder.name and digits.isdigit() else folder.name


def display_name(name: str, folder: Path, visitor: str) -> str:
    """Return "Anna (7)", or "Visitor 7" for visitors without a name.

    Parameters
    ----------
    name : str
        As it was typed.
    folder : Path
    visitor : str
        "Visitor {n}" in the window's language.
    """
    number = number_of(folder)
    if name and name != number:
        return f"{name} ({number})" if number != folder.name else name
    return visitor.format(n=number) if number != folder.name else folder.name


def first_name(name: str) -> str:
    """Return the first word of a name, for public display."""
    return name.split()[0] if name.split() else ""


class KnownNames:
    """Reads visitors' names, and a file again only after it has changed, as lists are redrawn often."""

    def __init__(self) -> None:
        self._known: dict[Path, tuple[tuple[int, int, int], str]] = {}

    def read(self, folder: Path) -> str:
        """Return the name as it was entered; "" if there is none or the file cannot be read."""
        try:
            found = os.stat(os.path.join(folder, PERSON_FILE))  # asked for hundreds of visitors at once
        except OSError:
            self._known.pop(folder, None)
            return ""
        stamp = (found.st_ino, found.st_mtime_ns, found.st_size)
        known = self._known.get(folder)
        if known is None or known[0] != stamp:
            try:
                text = read_untrusted(folder / PERSON_FILE, LARGEST_BYTES).decode("utf-8-sig")
                given = tomllib.loads(text).get("name", "")
            except (ClonerError, OSError, ValueError, RecursionError):
                given = ""
            name = given.strip() if isinstance(given, str) else ""
            known = self._known[folder] = (stamp, name)
        return known[1]
