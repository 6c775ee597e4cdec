"""MPEG-4 facial definition points (ISO/IEC 14496-2) of the named face points."""

from __future__ import annotations

import functools
from typing import Final

from cloner.generic.load import load_generic

#: Points of photos that are no vertex of the generic human.
_IN_PHOTOS: Final = {"hairline_top": "11.1"}


@functools.cache
def fdp_names() -> dict[str, str]:
    """Return the MPEG-4 number, such as "8.3", of every named face point that has one.

    A name and a number belong together where they are the same vertex of the generic human; the hairline is a point
    of photos only.
    """
    generic = load_generic()
    number = {int(vertex): name for name, vertex in zip(generic.fdp_names, generic.fdp_vertices, strict=True)}
    named = {
        name: number[int(vertex)]
        for name, vertex in zip(generic.feature_names, generic.feature_vertices, strict=True)
        if int(vertex) in number
    }
    return named | _IN_PHOTOS
