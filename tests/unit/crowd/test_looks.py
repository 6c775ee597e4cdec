"""Whose garments fit whom: trunks covered alike; a skirt that hangs loose stays its wearer's."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cloner.crowd.clones.cast import make_crowd_clone
from cloner.crowd.clones.groups import GROUPS, garment_masks
from cloner.crowd.clones.levels import body_levels
from cloner.crowd.clones.stock import HUNG_AT, sets_without_impostors, table_row
from cloner.crowd.clones.zones import ENDS, REACHED, covered_zones, zone_texels
from cloner.crowd.staged.looks import MASK_PX, exchangeable_garments, make_casting
from cloner.records.heads import Shell
from kit.clones import SHIRT, TROUSERS, toy_clone
from kit.crowds import dressed_toy


def trousers(cut: int) -> dict[str, np.ndarray]:
    """Trousers on the hips and on the zones below them up to one."""
    zones = zone_texels(MASK_PX)
    nothing = np.zeros(zones.shape, bool)
    hips = np.zeros_like(nothing)
    hips[MASK_PX // 2 :] = zones[MASK_PX // 2 :] == 0
    return {"top": nothing, "bottom": hips | np.isin(zones, range(5, cut)), "shoes": nothing}


def test_shorts_and_trousers_are_exchanged_but_not_with_who_wears_neither() -> None:
    bare = {name: np.zeros((MASK_PX, MASK_PX), bool) for name in ("top", "bottom", "shoes")}
    casting = make_casting([trousers(9), trousers(6), bare], {})
    assert casting.wardrobe["bottom"] == [[1], [0], []]
    assert casting.wardrobe["top"] == [[], [], []]


def test_reach_tells_the_zones_that_are_covered() -> None:
    assert covered_zones(trousers(9))["bottom"] == [1.0, 1.0, 1.0, 1.0]
    assert covered_zones(trousers(7))["bottom"] == [1.0, 1.0, 0.0, 0.0]
    assert covered_zones(trousers(7))["top"] == [0.0] * len(REACHED["top"])


def test_every_limb_has_its_zones() -> None:
    assert np.unique(zone_texels(256)).tolist() == list(range(ENDS + 1))


def hanging(cap: Shell, colour: tuple[int, int, int]) -> Shell:
    """A shell of cloth of some colour."""
    return replace(cap, kind="cloth", rgba=np.dstack([np.full_like(cap.rgba[..., :3], colour), cap.rgba[..., 3:]]))


def test_a_skirt_that_hangs_loose_is_not_lent_and_a_coats_is_dyed_with_the_coat() -> None:
    body, clone, cap = body_levels(), dressed_toy(), toy_clone().shells[0]
    plain = make_crowd_clone("ada", clone, body, poses=4)
    skirt, coat = hanging(cap, TROUSERS), hanging(cap, SHIRT)
    hung, wrapped = (make_crowd_clone("ada", replace(clone, shells=(one,)), body, poses=4) for one in (skirt, coat))
    assert wrapped.hung == "top"
    for cast in (hung, wrapped):
        row = table_row(cast, sets_without_impostors(cast), 33.0, 22, 0)
        assert GROUPS[int(row[HUNG_AT, 0]) - 1] == cast.hung
    assert (plain.hung, hung.hung) == ("", "bottom")
    assert exchangeable_garments(plain)["bottom"].sum() == garment_masks(plain.codes[::4, ::4])["bottom"].sum() > 0
    assert exchangeable_garments(hung)["bottom"].sum() == 0
    assert exchangeable_garments(hung)["top"].sum() > 0
