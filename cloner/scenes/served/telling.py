"""Messages of a served scene to its pages, and a pack's description of its page."""

from __future__ import annotations

import base64
import json
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from cloner.crowd.packs.files import MARK


def footing_message(ways: Mapping[int, NDArray[np.float32]]) -> dict[str, Any]:
    """Return footings as pages read them: the count per person, and all rows in one list."""
    data = b"".join(rows.astype("<f4").tobytes() for rows in ways.values())
    return {"of": [[who, len(rows)] for who, rows in ways.items()], "data": base64.b64encode(data).decode("ascii")}


def state_message(kept: bytes) -> str:
    """Return an engine's memory as pages read it: deflated, as it is mostly zeros."""
    return base64.b64encode(zlib.compress(kept, 1)).decode("ascii")


def page_description(pack: Path) -> Any:
    """Return a pack's current description of its page, None if the pack is gone."""
    try:
        return json.loads((pack / MARK).read_bytes())["player"]
    except (OSError, ValueError, LookupError, TypeError):
        return None
