"""Regions of a clone's surface: skin, hair, eyes, clothes, shoes."""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

#: Names of the regions; a label is a place in this tuple.
REGIONS: Final = ("skin", "hair", "eyes", "mouth", "upper_clothes", "lower_clothes", "shoes")
#: What a shell of each kind is; loose cloth hangs around the legs.
SHELL_REGIONS: Final = MappingProxyType(
    {
        "hair": "hair",
        "beard": "hair",
        "cloth": "lower_clothes",
        "glasses": "upper_clothes",
        "frizz": "hair",
        "scarf": "upper_clothes",
    }
)
