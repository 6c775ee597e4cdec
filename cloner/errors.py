"""The two exceptions an entry point catches; programmer mistakes stay ValueError."""

from __future__ import annotations


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
    """

    def __init__(self, message: str, hint: str, where: str) -> None:
        self.message = message
        self.hint = hint
        self.where = where
        super().__init__(message, hint, where)

    def __str__(self) -> str:
        """Return ``where: message. hint``."""
        return f"{self.where}: {self.message}. {self.hint}"


class Cancelled(Exception):
    """The operator stopped the work; no dialog appears."""
