"""Archives of arrays (.npz) of unknown origin, opened with limits."""

from __future__ import annotations

import lzma
import math
import struct
import tokenize
import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, BinaryIO, Final

import numpy as np
from PIL import Image

from cloner.untrusted import open_untrusted

#: What numpy, zipfile, zlib and pillow raise over files that are none of ours, damaged, or made to hurt.
BROKEN: Final = (
    OSError, ValueError, LookupError, AttributeError, TypeError, ArithmeticError, EOFError, SyntaxError, MemoryError,
    RuntimeError, struct.error, zlib.error, lzma.LZMAError, zipfile.BadZipFile, zipfile.LargeZipFile,
    tokenize.TokenError, Image.DecompressionBombError,
)  # fmt: skip
MOST_ARRAYS: Final = 10_000  # taste: a hundred times what a clone holds


@contextmanager
def open_archive(path: Path, largest_bytes: int) -> Iterator[Any]:
    """Yield the arrays of an archive, none read yet; refuse one that would exhaust the memory.

    Every array inside is as large as it says, and all together are at most so many bytes.

    Raises
    ------
    One of `BROKEN`
        If it is one of those, no ordinary file, or no archive.
    """
    with open_untrusted(path) as stream:
        _check_sizes(stream, largest_bytes)
        stream.seek(0)
        with np.load(stream, allow_pickle=False) as archive:
            yield archive


def _check_sizes(file: BinaryIO, largest_bytes: int) -> None:
    with zipfile.ZipFile(file) as archive:
        if sum(part.file_size for part in archive.infolist()) > largest_bytes:
            raise ValueError("larger than any clone")
        if len(archive.infolist()) > MOST_ARRAYS:
            raise ValueError("more arrays than any clone has")
        for part in archive.infolist():
            with archive.open(part) as stream:
                version = np.lib.format.read_magic(stream)
                read = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
                shape, _, dtype = read(stream)
            if math.prod(shape) * dtype.itemsize > part.file_size:
                raise ValueError(f"{part.filename} is cut short")
