"""Outfits of a crowd: palettes of dyes and exchangeable garments, configurable in ``looks.toml``."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.crowd.clones.cast import CrowdClone
from cloner.crowd.clones.groups import WORN, garment_masks
from cloner.crowd.clones.zones import REACHED, zone_texels
from cloner.crowd.staged.scene import Casting
from cloner.errors import ClonerError
from cloner.project.texts import read_text

#: Cloth that people wear, as it looks in daylight; taste. Hair is dyed only where looks.toml asks for it.
PALETTES: Final[Mapping[str, tuple[int, ...]]] = MappingProxyType({
    "top": (0xD8D4CB, 0x2F3B52, 0x7C2D2F, 0x44604A, 0xB98B4E, 0x5B6B85, 0x8A8C8E, 0xA44A3F, 0x33454A, 0xC9B79C,
            0x6E4F6B, 0x94A7B0),
    "bottom": (0x2B3A55, 0x3A3A3C, 0x6B5B4A, 0x8C8474, 0x1F2A38, 0x54606B, 0x4A4036),
    "shoes": (0x2A2522, 0x5A4030, 0xC8C4BC, 0x3B3F46, 0x7A6248),
    "hair": (),
})  # fmt: skip
#: Natural colours of hair, for those who ask for them by ``hair = "natural"``.
NATURAL_HAIR: Final = (0x1C1714, 0x3A2A20, 0x5A4030, 0x7A5A3C, 0xA88A5C, 0x8C8680, 0x6A3A22)
#: Garments fit another person when of the trunk (shoes: of the feet) the smaller one lies in the larger one by this
#: share; taste. On limbs they may end elsewhere, where the wearer's own skin begins.
FITS: Final = 0.6
#: Masks of garments are that small, texels a side.
MASK_PX: Final = 128
_KEYS: Final = {"palette", "own_share", "dyed_share", "wardrobe"}


def read_looks(path: Path | None) -> dict[str, Any]:
    """Return the contents of ``looks.toml``, empty if there is none.

    Raises
    ------
    ClonerError
        If the file is malformed.
    """
    if path is None:
        return {}
    try:
        data = tomllib.loads(read_text(path))
    except (ValueError, RecursionError) as error:
        raise ClonerError(
            f"this is not valid TOML ({error})", 'Write lines like: top = ["#2F3B52"]', path.name
        ) from error
    unknown = sorted(set(data) - _KEYS)
    if unknown:
        raise ClonerError(f"the key {unknown[0]!r} is not known", f"The keys are {', '.join(sorted(_KEYS))}", path.name)
    return data


def make_casting(masks: Sequence[Mapping[str, NDArray[np.bool_]]], data: Mapping[str, Any]) -> Casting:
    """Return palettes and wardrobe of some clones.

    Parameters
    ----------
    masks : sequence of mapping of garment to (S, S) bool
        Which texels each clone's garments cover.
    data : mapping
        Of :func:`read_looks`.

    Raises
    ------
    ClonerError
        If colours or shares make no sense.
    """
    own, dyed = _share(data, "own_share", 0.3), _share(data, "dyed_share", 0.45)
    palettes = {name: _palette(data.get("palette", {}), name) for name in PALETTES}
    wardrobe: dict[str, list[list[int]]] = {}
    if data.get("wardrobe", True):
        wardrobe = {garment: [_fitting(masks, garment, k) for k in range(len(masks))] for garment in WORN}
    return Casting(len(masks), palettes, wardrobe, own, min(dyed, 1.0 - own))


def exchangeable_garments(cast: CrowdClone) -> dict[str, NDArray[np.bool_]]:
    """Return which texels each of a clone's garments covers, (S, S) each; none for loose shells.

    A skirt's or a coat's shell belongs to its wearer alone: what it hangs from is neither lent nor put off.
    """
    step = len(cast.codes) // MASK_PX
    masks = garment_masks(cast.codes[::step, ::step])
    if cast.hung:
        masks[cast.hung] = np.zeros_like(masks[cast.hung])
    return masks


def _fitting(masks: Sequence[Mapping[str, NDArray[np.bool_]]], garment: str, wearer: int) -> list[int]:
    own = masks[wearer][garment]
    here = zone_texels(len(own)) == 0 if garment in REACHED else np.ones_like(own)
    found = []
    for other, mask in enumerate(masks):
        smaller = min(int((own & here).sum()), int((mask[garment] & here).sum()))
        if other != wearer and smaller and int((own & mask[garment] & here).sum()) / smaller >= FITS:
            found.append(other)
    return found


def _share(data: Mapping[str, Any], key: str, usual: float) -> float:
    value = data.get(key, usual)
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0.0 <= value <= 1.0:
        raise ClonerError(f"{key} must be a number from 0 to 1", f"Write {key} = {usual}", "looks.toml")
    return float(value)


def _palette(table: Any, name: str) -> tuple[int, ...]:
    if not isinstance(table, dict) or set(table) - set(PALETTES):
        hint = f"Write [palette] with {', '.join(PALETTES)}"
        raise ClonerError("the palette names something that is never dyed", hint, "looks.toml")
    colours = table.get(name, PALETTES[name])
    if colours == "natural" and name == "hair":
        return NATURAL_HAIR
    if not isinstance(colours, list | tuple):
        raise ClonerError(f"{name} must be a list of colours", f'Write {name} = ["#2F3B52"]', "looks.toml")
    found = []
    for colour in colours:
        if isinstance(colour, int) and not isinstance(colour, bool) and 0 <= colour <= 0xFFFFFF:
            found.append(colour)
        elif isinstance(colour, str) and re.fullmatch(r"#[0-9A-Fa-f]{6}", colour):
            found.append(int(colour[1:], 16))
        else:
            raise ClonerError(f"{colour!r} is no colour", 'Write colours like "#2F3B52"', f"looks.toml, {name}")
    return tuple(found)
