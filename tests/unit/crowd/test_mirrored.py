"""Walkers whose sides look alike have impostors of one side alone."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.crowd.drawing.theatre import CrowdRenderer
from cloner.crowd.packs.pack import make_pack
from cloner.crowd.packs.reading import read_stock
from cloner.exporters.shared.regions import texel_triangles
from cloner.generic.load import load_generic
from kit.crowds import WANTED, dressed_toy, likeness, row, saved, shot

pytestmark = [pytest.mark.gl, pytest.mark.slow]


@pytest.fixture(scope="module")
def mirrored(tmp_path_factory: pytest.TempPathFactory):
    """A pack of two with a mirrored side each, and a painter of it: one of one colour, one painted on one side only."""
    out = tmp_path_factory.mktemp("mirrored")
    plain = dressed_toy()
    rgb = np.full_like(plain.atlas.rgb, 90)
    saved(out / "results" / "alike", replace(plain, atlas=replace(plain.atlas, rgb=rgb)))
    generic = load_generic()
    left = np.append(generic.vertices_m[generic.triangles()[0]][..., 0].mean(axis=1) > 0.0, False)
    striped = np.where(left[texel_triangles(len(rgb))][..., None], np.uint8(200), rgb)
    saved(out / "results" / "striped", replace(plain, atlas=replace(plain.atlas, rgb=striped)))
    facts = make_pack([out / "results"], out / "pack", replace(WANTED, vat=False, mirror=True, views=16))
    made = CrowdRenderer(read_stock(out / "pack", facts))
    yield facts, made
    made.close()


def test_who_looks_alike_on_both_sides_has_impostors_of_one(mirrored) -> None:
    facts, _ = mirrored
    seen = {row["id"]: [clip["impostors"] for clip in row["clips"]] for row in facts["people"]}
    assert seen == {"alike": ["left", "left", "front"], "striped": ["all", "all", "front"]}
    tiles = {row["id"]: row["arrays"]["tiles"]["shape"][0] for row in facts["people"]}
    assert tiles["alike"] < 0.7 * tiles["striped"]


@pytest.mark.parametrize("heading", [0.3, 1.2, 2.0, 2.9, 3.4, 4.3, 5.1, 5.9])
def test_a_mirrored_side_looks_like_the_geometry_it_stands_for(mirrored, heading: float) -> None:
    """The seen side is behind headings below pi: both halves must stand for the walker, at a pose that limps."""
    person = row(heading=heading, phase=0.14)
    want, got = shot(mirrored[1], person, 0), shot(mirrored[1], person, None)
    assert likeness(want, got) > 0.94
