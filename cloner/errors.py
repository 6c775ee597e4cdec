"""The two exceptions an entry point catches; programmer mistakes stay ValueError."""

from __future__ import annotations

from typing import Final

LONGEST: Final = 400  # taste: a file's own words may be endless, a sentence is not


def printable(text: str) -> str:
    """Return text safe for a terminal, a log and a table: one line, no control or direction marks."""
    shown = "".join(character if character.isprintable() else "\N{REPLACEMENT CHARACTER}" for character in text)
    return shown if len(shown) <= LONGEST else f"{shown[: LONGEST // 2]}…{shown[-LONGEST // 2 :]}"


class ClonerError(Exception):
    """A failure the operator can fix.

    Parameters
    ----------
    message : str
        What is wrong, one clause without a full stop.
    hint : str
        What to do about it, one clause without a full stop.
    where : str
        The file, view or field it concerns; a name, never a home path.

    All three may quote what somebody else wrote: they are made :func:`printable`.
    """

    def __init__(self, message: str, hint: str, where: str) -> None:
        self.message = printable(message)
        self.hint = printable(hint)
        self.where = printable(where)
        super().__init__(self.message, self.hint, self.where)

    def __str__(self) -> str:
        """Return ``where: message. hint``."""
        return f"{self.where}: {self.message}. {self.hint}"


class Cancelled(Exception):
    """The operator stopped the work; no dialog appears."""
