"""Ten groups; the own outfit gives the own colours; dyes and exchanged clothes touch nothing but cloth."""

from __future__ import annotations

import numpy as np
import pytest
from skimage.color import deltaE_ciede2000, rgb2lab

from cloner.crowd.clones.groups import (
    GROUPS,
    STEP,
    exchange_garment,
    grey_atlas,
    group_looks,
    recolour,
    shader_codes,
    texel_groups,
    triangle_groups,
)
from kit.crowds import dressed_toy

SIZE = 256
SHIRT, SKIN = (60, 90, 160), (214, 168, 142)


def worn(**told) -> tuple[np.ndarray, np.ndarray]:
    clone = dressed_toy(**told)
    return clone.atlas.rgb[2::4, 2::4], texel_groups(triangle_groups(clone), SIZE)


def group(codes: np.ndarray, name: str) -> np.ndarray:
    return codes == STEP * (GROUPS.index(name) + 1)


def test_the_sources_eight_groups_are_found_and_lie_where_they_belong() -> None:
    clone = dressed_toy()
    found = triangle_groups(clone)
    names = {GROUPS[k] for k in np.unique(found)}
    assert names >= {"eyes", "head", "arms", "nails", "top", "bottom", "shoes", "mouth"}
    nails = (found == GROUPS.index("nails")).sum()
    hands = (found == GROUPS.index("arms")).sum()
    assert 10 * 8 <= nails < 0.1 * (nails + hands)  # ten nails of several triangles, a small part of arms and hands


def test_the_own_outfit_times_grey_is_the_atlas() -> None:
    rgb, codes = worn()
    looks = group_looks(rgb, codes)
    again = recolour(grey_atlas(rgb, codes, looks), {name: look.colour for name, look in looks.items()})
    inside = codes > 0
    away = deltaE_ciede2000(rgb2lab(again[inside]), rgb2lab(rgb[inside]))
    assert away.mean() < 3.0


def test_a_dye_leaves_every_other_texel_alone() -> None:
    rgb, codes = worn()
    looks = group_looks(rgb, codes)
    grey, own = grey_atlas(rgb, codes, looks), {name: look.colour for name, look in looks.items()}
    before, after = recolour(grey, own), recolour(grey, own | {"top": (200.0, 20.0, 20.0)})
    changed = (before != after).any(axis=2)
    assert changed[group(codes, "top")].mean() > 0.95
    assert not changed[~group(codes, "top")].any()


def test_a_shorter_sleeve_shows_the_wearers_own_skin() -> None:
    rgb, codes = worn(sleeves=True, shift=60)
    other_rgb, other_codes = worn()
    out, told = exchange_garment(rgb, codes, other_rgb, other_codes, "top")
    taken, bare = group(other_codes, "top"), group(codes, "top") & ~group(other_codes, "top")
    assert bare.sum() > 200
    assert np.median(np.abs(out[taken].astype(int) - SHIRT).max(axis=1)) == 0
    assert group(told, "arms")[bare].all()
    skin = np.array(SKIN) + [60, 60, 0]  # the wearer's, who is painted 60 brighter
    assert np.abs(np.median(out[bare], axis=0) - np.minimum(skin, 255)).max() < 90  # hands are of another paint
    untouched = ~taken & ~group(codes, "top")
    assert np.array_equal(out[untouched], rgb[untouched])


def test_codes_go_on_beyond_the_charts_but_never_change_inside() -> None:
    _, codes = worn()
    marks = shader_codes(codes)
    assert np.array_equal(marks[codes > 0] // STEP, codes[codes > 0] // STEP)
    assert (marks > 0).sum() > (codes > 0).sum()


@pytest.mark.parametrize("name", ["eyes", "mouth", "head", "arms", "legs", "nails"])
def test_skin_is_not_among_what_outfits_dye(name: str) -> None:
    from cloner.crowd.clones.groups import WORN

    assert name not in WORN
