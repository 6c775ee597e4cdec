"""The most recently opened events on this computer: paths of folders, no personal data."""

from __future__ import annotations

import contextlib
import json
import os
from pathlib import Path
from typing import Final

from cloner.errors import ClonerError
from cloner.project.atomic import write_text
from cloner.project.texts import LARGEST_BYTES
from cloner.untrusted import read_untrusted

RECENT_FILE: Final = "recent.json"
MOST: Final = 5  # taste: a booth has one event a day


def recent_events(file: Path) -> tuple[Path, ...]:
    """Return the recently opened events that still exist, the latest first; none if the file is damaged."""
    try:
        data = json.loads(read_untrusted(file, LARGEST_BYTES))
    except (OSError, ValueError, RecursionError):
        return ()
    folders = [one for one in data if isinstance(one, str)] if isinstance(data, list) else []
    return tuple(Path(folder) for folder in folders if os.path.isdir(folder))


def note_recent(file: Path, folder: Path) -> None:
    """Record that an event was opened now; a list that cannot be written is no error."""
    known = [one for one in recent_events(file) if one != folder]
    kept = [str(one) for one in (folder.absolute(), *known)][:MOST]
    with contextlib.suppress(ClonerError, OSError):
        file.parent.mkdir(parents=True, exist_ok=True)
        write_text(file, json.dumps(kept, indent=1, ensure_ascii=False) + "\n")
