"""Bodies of metaballs: a hierarchy of blobs on the joints of the standard skeleton, as JSON, and their field.

::

    {"format": 1, "blobs": [
      {"name": "l_thigh", "from": "l_hip", "to": "l_knee", "radius_m": [0.09, 0.06],
       "off_m": [[0, 0, 0], [0, 0, 0.01]], "wide": [1, 1, 1.1]},
      {"name": "belly", "from": "vl3", "radius_m": [0.14], "off_m": [[0, 0, 0.03]], "wide": [1.3, 1, 1]}]}

A blob with "to" is drawn out between two joints of H-Anim, one without is a ball. "radius_m" is where its surface
lies if it is alone, at either end; "off_m" moves the ends from the joints, metres of the model; "wide" stretches it
along the model's axes. Blobs melt together where they meet.

References
----------
J. Blinn, A Generalization of Algebraic Surface Drawing, ACM Transactions on Graphics 1982.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np

from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner.records.arrays import Array
from cloner.statues.listed import read_listed

FORMAT: Final = 1
#: The surface lies where the field has this value; a blob alone has it at its radius.
LEVEL: Final = 0.5
#: The field of a blob ends at so many radii: (1 - q^2)^2 is `LEVEL` at one.
REACH: Final = float(1.0 / np.sqrt(1.0 - np.sqrt(LEVEL)))
#: A body has no more parts, none is thicker or farther from its joint, metres, nor flatter than this.
MOST, THICKEST_M, FARTHEST_M, FLATTEST = 200, 1.0, 1.0, 10.0
#: Points and blobs evaluated at once: keeps the memory near 50 MiB.
CHUNK: Final = 400_000
_KEYS: Final = {"name", "from", "to", "radius_m", "off_m", "wide"}
_HINT: Final = "See docs/statues.md for how blobs are written"


@dataclass(frozen=True, slots=True)
class Blob:
    """One ball, or a piece drawn out between two joints.

    Attributes
    ----------
    name : str
    ends : one or two names of joints
    radius_m : as many floats
    off_m : as many places (3,), metres
    wide : (3,) floats
    """

    name: str
    ends: tuple[str, ...]
    radius_m: tuple[float, ...]
    off_m: tuple[tuple[float, float, float], ...]
    wide: tuple[float, float, float] = (1.0, 1.0, 1.0)


@dataclass(frozen=True, slots=True, eq=False)
class Field:
    """Blobs on somebody's joints: (B, 3) ends, (B, 2) radii, (B, 3) stretch."""

    first_m: Array
    last_m: Array
    radius_m: Array
    wide: Array

    def of_each(self, points_m: Array) -> Array:
        """Return (N, B) the field of each blob at points (N, 3)."""
        direction = self.last_m - self.first_m
        length2 = np.maximum(np.einsum("ba,ba->b", direction, direction), 1e-12)
        off = points_m[:, None] - self.first_m
        along = np.clip(np.einsum("nba,ba->nb", off, direction) / length2, 0.0, 1.0)
        off -= along[..., None] * direction
        off /= self.wide
        radius = REACH * (self.radius_m[:, 0] + along * (self.radius_m[:, 1] - self.radius_m[:, 0]))
        inside = np.maximum(1.0 - np.einsum("nba,nba->nb", off, off) / radius**2, 0.0)
        return np.asarray(inside**2)

    def at(self, points_m: Array) -> Array:
        """Return (N,) the field of all blobs together."""
        step = max(1, CHUNK // max(len(self.radius_m), 1))
        parts = [self.of_each(points_m[start : start + step]).sum(axis=1) for start in range(0, len(points_m), step)]
        return np.concatenate(parts) if parts else np.zeros(0)


def field_of(blobs: Sequence[Blob], joints_m: Array) -> Field:
    """Return the field of blobs on joints (94, 3), metres."""
    row = {name: number for number, name in enumerate(load_generic().joint_names)}
    first = np.array([joints_m[row[blob.ends[0]]] + blob.off_m[0] for blob in blobs])
    last = np.array([joints_m[row[blob.ends[-1]]] + blob.off_m[-1] for blob in blobs])
    radius = np.array([(blob.radius_m[0], blob.radius_m[-1]) for blob in blobs])
    return Field(first, last, radius, np.array([blob.wide for blob in blobs]))


def read_blobs(path: Path) -> tuple[Blob, ...]:
    """Return the blobs of a file.

    Raises
    ------
    ClonerError
        If it cannot be read or makes no sense.
    """
    data = read_listed(path, "blobs", FORMAT, _HINT, also=("made_by",))
    if not 1 <= len(data) <= MOST:
        raise ClonerError(f"a body has 1 to {MOST} blobs, not {len(data)}", _HINT, path.name)
    return tuple(_blob(one, number, path.name) for number, one in enumerate(data, start=1))


def written_blobs(blobs: Sequence[Blob], made_by: str) -> str:
    """Return the JSON text of blobs, one a line, to a tenth of a millimetre; and whose body it is."""
    rows = []
    for blob in blobs:
        data: dict[str, Any] = {"name": blob.name, "from": blob.ends[0]}
        if len(blob.ends) == 2:
            data["to"] = blob.ends[1]
        data["radius_m"] = [round(each, 4) for each in blob.radius_m]
        data["off_m"] = [[round(each, 4) for each in off] for off in blob.off_m]
        data["wide"] = [round(each, 3) for each in blob.wide]
        rows.append(json.dumps(data))
    return f'{{"format": {FORMAT}, "made_by": {json.dumps(made_by)}, "blobs": [\n' + ",\n".join(rows) + "\n]}\n"


def _blob(one: Any, number: int, where: str) -> Blob:
    if not isinstance(one, dict) or not {"from", "radius_m"} <= set(one) or set(one) - _KEYS:
        raise ClonerError(f"blob {number} lacks its joint or radius, or tells more than blobs have", _HINT, where)
    name = one.get("name", f"blob {number}")
    if not isinstance(name, str) or not 0 < len(name) <= 60:
        raise ClonerError(f"blob {number} has no name of 1 to 60 letters", _HINT, where)
    ends = (one["from"], one["to"]) if "to" in one else (one["from"],)
    known = load_generic().joint_names
    for joint in ends:
        if joint not in known:
            message = f"the blob {name!r} hangs on {str(joint)[:40]!r}, which is no joint"
            raise ClonerError(message, "Joints have H-Anim's names", where)
    radius = _numbers(one["radius_m"], len(ends), 0.001, THICKEST_M, f"radius of {name!r}", where)
    offs = one.get("off_m", [[0.0, 0.0, 0.0]] * len(ends))
    if not isinstance(offs, list) or len(offs) != len(ends):
        raise ClonerError(f"the blob {name!r} needs a place for each end", _HINT, where)
    moved = tuple(_numbers(off, 3, -FARTHEST_M, FARTHEST_M, f"place of {name!r}", where) for off in offs)
    wide = _numbers(one.get("wide", [1.0] * 3), 3, 1.0 / FLATTEST, FLATTEST, f"width of {name!r}", where)
    return Blob(name, ends, radius, moved, wide)  # type: ignore[arg-type]  # three each, as counted


def _numbers(value: Any, count: int, low: float, high: float, what: str, where: str) -> tuple[float, ...]:
    fits = isinstance(value, list) and len(value) == count
    if not fits or not all(isinstance(x, int | float) and not isinstance(x, bool) and low <= x <= high for x in value):
        raise ClonerError(f"the {what} must be {count} numbers from {low:g} to {high:g}", _HINT, where)
    return tuple(float(each) for each in value)
