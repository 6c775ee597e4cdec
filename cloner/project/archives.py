"""Archives of arrays (.npz) that somebody else may have written: opened with care."""

from __future__ import annotations

import math
import struct
import zipfile
import zlib
from pathlib import Path
from typing import Final

import numpy as np
from PIL import Image

#: What numpy, zipfile, zlib and pillow raise over files that are none of ours, damaged, or made to hurt.
BROKEN: Final = (
    OSError, ValueError, LookupError, AttributeError, TypeError, ArithmeticError, EOFError, SyntaxError, MemoryError,
    RuntimeError, struct.error, zlib.error, zipfile.BadZipFile, Image.DecompressionBombError,
)  # fmt: skip
LARGEST_BYTES: Final = 1_000_000_000  # taste: twenty times a clone with the largest texture


def check_sizes(path: Path) -> None:
    """Refuse archives that would fill the memory: every array inside is as large as it says, and not larger.

    Raises
    ------
    One of `BROKEN`
        If it is one of those, or no archive.
    """
    with zipfile.ZipFile(path) as archive:
        if sum(part.file_size for part in archive.infolist()) > LARGEST_BYTES:
            raise ValueError("larger than any clone")
        for part in archive.infolist():
            with archive.open(part) as stream:
                version = np.lib.format.read_magic(stream)
                read = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
                shape, _, dtype = read(stream)
            if math.prod(shape) * dtype.itemsize > part.file_size:
                raise ValueError(f"{part.filename} is cut short")
