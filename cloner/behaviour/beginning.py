"""A scenario's initial state as numbers, so that another host of the engine computes the same steps."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.behaviour.core.host import ARRAYS
from cloner.behaviour.world import World

#: What the engine makes itself.
_MADE: Final = {"others", "distance", "fields", "told"}


def initial_state(world: World) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """Return the initial state of a world that has made no step, for ``crowd/web/engine.js``.

    Returns
    -------
    facts : dict
        With what the engine is made, and name, type and size of each array that it lends, in turn.
    arrays : dict
        Those that are not all zero; bytes for truth values.
    """
    rows = world.core.arrays
    kept = {name: own.view(np.uint8) if own.dtype == bool else own.copy() for name, own in rows.items()
            if name not in _MADE and own.any()}  # fmt: skip
    return engine_layout(world), kept


def engine_layout(world: World) -> dict[str, Any]:
    """Return the arguments of a world's engine, and name, type and size of each array it shares, in order."""
    rows = world.core.arrays
    return world.core.begun | {"arrays": [[name, kind, int(rows[name].size)] for name, kind, _ in ARRAYS]}
