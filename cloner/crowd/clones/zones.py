"""Zones of limbs in the atlas, and how far each clone's clothes cover its limbs.

Clothes of a clone fit every other one whose trunk they cover alike: sleeves and legs may end elsewhere. Near people
look their garments up in the donor's atlas; impostors, which have no atlas, show cloth or skin by zones.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.exporters.shared.regions import texel_triangles
from cloner.generic.load import load_generic

#: Halves of the limbs' parts in the order of their numbers from 1 on; 0 is trunk and head, the last hands and feet.
HALVES: Final = ("upper_arm", "forearm", "thigh", "calf")
ENDS: Final = 2 * len(HALVES) + 1
#: Zones that each garment may reach; impostors know four of either, see ``impostor.frag``.
REACHED: Final[Mapping[str, range]] = MappingProxyType({"top": range(1, 5), "bottom": range(5, 9)})
_ALONG: Final = MappingProxyType({"upper_arm": ("shoulder", "elbow"), "forearm": ("elbow", "wrist"),
                                  "thigh": ("hip", "knee"), "calf": ("knee", "ankle")})  # fmt: skip


@functools.lru_cache(maxsize=3)
def zone_texels(size: int) -> NDArray[np.uint8]:
    """Return the (size, size) zones of the atlas' texels, 0 to `ENDS`; 0 outside the charts."""
    return np.asarray(np.append(_zones(), 0).astype(np.uint8)[texel_triangles(size)])


def _zones() -> NDArray[np.uint8]:
    """Return (T,) the zone of each triangle of the generic human: by its segment, and its position along the bone."""
    generic = load_generic()
    triangles, _ = generic.triangles()
    segment = generic.vertex_segment[triangles[:, 0]]
    middles = generic.vertices_m[triangles].mean(axis=1)
    found = np.zeros(len(triangles), np.uint8)
    for number, name in enumerate(generic.segment_names):
        side, _, part = name.partition("_")
        own = segment == number
        if part in ("hand", "foot"):
            found[own] = ENDS
        elif part in HALVES:
            near, far = (generic.joints_m[generic.joint(f"{side[0]}_{joint}")] for joint in _ALONG[part])
            along = (middles[own] - near) @ (far - near) / float((far - near) @ (far - near))
            found[own] = 1 + 2 * HALVES.index(part) + (along > 0.5)
    return found


def covered_zones(masks: Mapping[str, NDArray[np.bool_]]) -> dict[str, list[float]]:
    """Return for top and bottom which of their zones they cover for the most part, 1 or 0 each.

    Parameters
    ----------
    masks : mapping of garment to (S, S) bool
        Which texels the garment covers.
    """
    size = len(masks["top"])
    zones = zone_texels(size)
    return {
        name: [float(masks[name][zones == zone].mean() > 0.5) for zone in own] for name, own in REACHED.items()
    }  # fmt: skip
