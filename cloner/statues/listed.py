"""JSON files of statues that people write by hand: a format and one list."""

from __future__ import annotations

import json
from collections.abc import Collection
from pathlib import Path
from typing import Any

from cloner.errors import ClonerError
from cloner.project.texts import check_format, read_text


def read_listed(path: Path, key: str, newest: int, hint: str, also: Collection[str] = ()) -> list[Any]:
    """Return the list that a JSON file holds under a key, beside its format and what else is allowed.

    Raises
    ------
    ClonerError
        If it cannot be read, is something else, or that of a newer version.
    """
    try:
        data: Any = json.loads(read_text(path))
    except (ValueError, RecursionError) as error:
        raise ClonerError(f"the {key} are no JSON", hint, path.name) from error
    if not isinstance(data, dict) or set(data) - set(also) != {"format", key} or not isinstance(data[key], list):
        raise ClonerError(f"the file holds no list of {key}", hint, path.name)
    check_format(data["format"], newest, path.name)
    return list(data[key])
