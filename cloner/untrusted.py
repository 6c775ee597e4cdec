"""Reading of files that somebody else may have placed: regular files only, up to a size limit.

A pipe would be waited for without end, a device read until the memory is full, and a file can grow while it is read.
"""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path
from typing import BinaryIO, Final

from cloner.errors import ClonerError

#: Bytes read at a time.
_BLOCK: Final = 1 << 20
_FLAGS: Final = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)


class UnsuitableFile(OSError):
    """The file is not a regular one, or larger than expected; the text says which."""


def open_untrusted(path: Path) -> BinaryIO:
    """Return a regular file opened for reading.

    Raises
    ------
    UnfitFile
        If it is a folder, pipe, socket or device.
    OSError
        If it cannot be opened.
    """
    try:
        descriptor = os.open(path, _FLAGS)  # a pipe without a writer opens at once, and is refused below
    except ValueError as error:  # a zero in its name
        raise UnsuitableFile(errno.EINVAL, "no file can be called that") from error
    try:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            raise UnsuitableFile(errno.EINVAL, "it is no ordinary file")
        return os.fdopen(descriptor, "rb")
    except BaseException:
        os.close(descriptor)
        raise


def walk_files(root: Path) -> list[Path]:
    """Return all files and folders below a folder, sorted; links are not followed, disappearing ones are skipped."""
    inside = [os.path.join(place, name) for place, folders, files in os.walk(root) for name in (*folders, *files)]
    return sorted(map(Path, inside))


def read_untrusted(path: Path, largest_bytes: int) -> bytes:
    """Return the bytes of a regular file, up to a limit.

    Raises
    ------
    UnfitFile
        If it is no ordinary file, or larger: ``errno`` is EFBIG then.
    OSError
        If it cannot be read.
    """
    with open_untrusted(path) as stream:
        blocks, left = [], largest_bytes
        while left >= 0 and (block := stream.read(min(_BLOCK, left + 1))):
            blocks.append(block)
            left -= len(block)
    if left < 0:
        raise UnsuitableFile(errno.EFBIG, f"it is larger than {largest_bytes / 1e6:.0f} MB")
    return b"".join(blocks)


def read_untrusted_text(path: Path, what: str, hint: str, largest_bytes: int, *, errors: str = "strict") -> str:
    """Return the text of a regular UTF-8 file.

    Parameters
    ----------
    path : Path
    what : str
        What a sentence calls it, "the capture".
    hint : str
        What to give instead.
    largest_bytes : int
    errors : str
        As of ``bytes.decode``.

    Raises
    ------
    ClonerError
        If it cannot be read, is too large or no text.
    """
    try:
        return read_untrusted(path, largest_bytes).decode("utf-8", errors)
    except UnsuitableFile as error:
        if error.errno == errno.EFBIG:
            raise ClonerError(f"{what} is too large", "Cut it into shorter pieces", path.name) from error
        raise ClonerError(f"{what} cannot be read: {error.strerror}", hint, path.name) from error
    except (OSError, UnicodeDecodeError) as error:
        raise ClonerError(f"{what} cannot be read", hint, path.name) from error
