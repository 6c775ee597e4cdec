"""Markers: vertices of a mesh with their pixels in a photograph, as JSON.

::

    {"format": 1, "markers": [{"at": "nose_tip", "px": [612, 800]}, {"at": 5130, "px": [540.5, 702]}]}

"at" is a vertex's number from 0, or on a clone the name of a feature point (`fdp_` and a number for MPEG-4's); "px"
counts from the middle of the photo's top left pixel.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner.statues.listed import read_listed

FORMAT: Final = 1
#: More are a mesh of their own.
MOST: Final = 400
#: Markers to begin with: what nets find in a face, and MPEG-4's points on cheeks, brow and crown between them.
MARKED: Final = (
    "glabella", "nasion", "nose_tip", "subnasale", "lip_top", "lip_bottom", "chin_front", "chin_bottom", "eye_inner_L",
    "eye_inner_R", "eye_outer_L", "eye_outer_R", "eye_upper_L", "eye_upper_R", "eye_lower_L", "eye_lower_R",
    "mouth_corner_L", "mouth_corner_R", "ala_L", "ala_R", "ear_top_L", "ear_top_R", "ear_lobe_L", "ear_lobe_R",
    "fdp_4.1", "fdp_4.2", "fdp_4.3", "fdp_4.4", "fdp_4.5", "fdp_4.6", "fdp_2.13", "fdp_2.14", "fdp_5.1", "fdp_5.2",
    "fdp_5.3", "fdp_5.4", "fdp_10.7", "fdp_10.8", "fdp_11.1", "fdp_2.2",
)  # fmt: skip
_HINT: Final = 'Write {"format": 1, "markers": [{"at": "nose_tip", "px": [612, 800]}, ...]}'


@dataclass(frozen=True, slots=True, eq=False)
class Markers:
    """What a file of markers says.

    Attributes
    ----------
    at : tuple of int or str
        Vertices, or names of feature points.
    px : (K, 2) float64
    """

    at: tuple[int | str, ...]
    px: NDArray[np.float64]

    def vertices(self, *, named: bool) -> NDArray[np.int32]:
        """Return (K,) vertices; names are those of the generic human's points, where a mesh has any.

        Raises
        ------
        ClonerError
            If a name is not known.
        """
        points = known_points() if named else {}
        for one in self.at:
            if isinstance(one, str) and one not in points:
                hint = "Names are the feature points of a clone's report" if named else "Give vertices by number"
                raise ClonerError(f"the marker {one[:40]!r} is not known", hint, "--markers")
        return np.array([one if isinstance(one, int) else points[one] for one in self.at], np.int32)


def known_points() -> dict[str, int]:
    """Return the vertex of every named point of a clone."""
    generic = load_generic()
    named = zip(generic.feature_names, generic.feature_vertices, strict=True)
    standard = zip(generic.fdp_names, generic.fdp_vertices, strict=True)
    return {name: int(vertex) for name, vertex in named} | {f"fdp_{name}": int(vertex) for name, vertex in standard}


def read_markers(path: Path) -> Markers:
    """Return the markers of a file.

    Raises
    ------
    ClonerError
        If it cannot be read or makes no sense.
    """
    data = read_listed(path, "markers", FORMAT, _HINT)
    if len(data) > MOST:
        raise ClonerError(f"{len(data)} markers are too many", f"Give at most {MOST}", path.name)
    at, px = zip(*(_marker(one, path.name) for one in data), strict=True) if data else ((), ())
    return Markers(at, np.array(px, np.float64).reshape(-1, 2))


def _marker(one: Any, where: str) -> tuple[int | str, tuple[float, float]]:
    if not isinstance(one, dict) or set(one) != {"at", "px"}:
        raise ClonerError("a marker lacks its place", _HINT, where)
    at, px = one["at"], one["px"]
    if isinstance(at, bool) or not (isinstance(at, str) or (isinstance(at, int) and 0 <= at < 2**31)):
        raise ClonerError("a marker is neither a vertex nor a name", _HINT, where)
    if not isinstance(px, list) or len(px) != 2 or not all(_is_place(each) for each in px):
        raise ClonerError("a marker has no place in the photo", _HINT, where)
    return at, (float(px[0]), float(px[1]))


def _is_place(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < 1e5
