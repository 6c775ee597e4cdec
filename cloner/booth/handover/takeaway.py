"""The location of a visitor's files, with a QR code for them."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import numpy as np
import segno
from numpy.typing import NDArray

from cloner.booth.visitors.cached_work import CLONE_FILE
from cloner.errors import ClonerError
from cloner.project.results import RESULT_MARK

#: Characters a code may hold and still be read from a screen by any telephone (taste; the standard allows 2953).
LONGEST_CODE: Final = 600
QUIET_MODULES: Final = 4  # ISO/IEC 18004 wants this white border


def free_name(folder: Path, name: str, suffix: str = "") -> Path:
    """Return an unused path in a folder: name, name-2, name-3 and so on."""
    tries = (folder / f"{name}{'' if number == 1 else f'-{number}'}{suffix}" for number in range(1, 10_000))
    return next(path for path in tries if not path.exists())


def link_text(template: str, identifier: str) -> str:
    """Return the event's link for a visitor: an address that a phone can open, or ""."""
    return template.replace("{id}", identifier) if template else ""


def qr_modules(text: str) -> NDArray[np.bool_]:
    """Return the (N, N) dark modules of a QR code with its white border.

    Raises
    ------
    ClonerError
        If the text is too long to be scanned.
    """
    if len(text) > LONGEST_CODE:
        raise ClonerError("the text is too long for a code", f"{LONGEST_CODE} characters can be scanned", "Code")
    made = segno.make(text, micro=False, error="m")
    return np.pad(np.array([[module & 1 for module in row] for row in made.matrix], dtype=bool), QUIET_MODULES)


def has_result(result: Path) -> bool:
    """Return whether a folder holds a finished clone."""
    return (result / RESULT_MARK).is_file() and (result / CLONE_FILE).is_file()
