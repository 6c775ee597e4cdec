"""Small text files of unknown origin, read with limits."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

from cloner.errors import ClonerError
from cloner.untrusted import UnsuitableFile, read_untrusted

LARGEST_BYTES: Final = 10_000_000  # taste: a thousand times what a person types


def check_own(path: Path) -> None:
    """Refuse a link that leads out of its folder: it would pass somebody else's file for the visitor's own.

    Raises
    ------
    ClonerError
        If it is such a link, or one that leads nowhere.
    """
    if not path.is_symlink():
        return
    try:
        inside = path.resolve(strict=True).is_relative_to(path.parent.resolve())
    except (OSError, RuntimeError):  # nowhere, or in a circle
        inside = False
    if not inside:
        raise ClonerError("this is a link that leads out of its folder", "Put the file itself there", path.name)


def check_format(value: Any, newest: int, where: str) -> int:
    """Return the number of a file's format, 1 to ``newest``.

    Raises
    ------
    ClonerError
        If it is none, or that of a newer version.
    """
    if isinstance(value, bool) or not isinstance(value, int) or value < 1:
        raise ClonerError('"format" must be a whole number', f"Write format = {newest}, as this version does", where)
    if value > newest:
        message = f"it was written by a newer version of Cloner (format {value}, this one knows {newest})"
        raise ClonerError(message, "Update Cloner, or move the file away", where)
    return value


def read_text(path: Path) -> str:
    """Return the text of a small UTF-8 file; a byte order mark is left out.

    Raises
    ------
    ClonerError
        If it is no ordinary file of its folder, larger than `LARGEST_BYTES`, or no text.
    """
    hint = "Check it or move it away"
    check_own(path)
    try:
        return read_untrusted(path, LARGEST_BYTES).decode("utf-8-sig").replace("\r\n", "\n").replace("\r", "\n")
    except UnsuitableFile as error:
        raise ClonerError(f"this cannot be read: {error.strerror}", hint, path.name) from error
    except (OSError, UnicodeDecodeError) as error:
        raise ClonerError("the file cannot be read as text", hint, path.name) from error
