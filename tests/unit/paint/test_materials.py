"""Skin and cloth told by vote: a bare hand is bare all over, a gloved one is not."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.charts import person_graph
from cloner.generic.load import load_generic
from cloner.paint.lookups.materials import find_materials, hands_beyond_cuffs
from cloner.records.labels import Label


def seen(shown):
    """Return a photo that sees every vertex squarely and shows this much skin (V,) there."""
    count = len(shown)
    picture = np.where(shown > 0.5, Label.BODY_SKIN, Label.UPPER_CLOTHES).astype(np.uint8).reshape(1, count)
    return SimpleNamespace(
        view=ViewId.BODY_FRONT,
        mirrored=False,
        score=np.ones(count),
        visibility=SimpleNamespace(cosine=np.ones(count)),
        matted=SimpleNamespace(labels=picture),
        lookup_px=np.column_stack([np.arange(count), np.zeros(count)]).astype(float),
    )


@pytest.mark.parametrize(("bare_share", "expected"), [(0.85, 1.0), (0.1, 0.0)])
def test_what_shows_between_thumb_and_fingers_is_no_part_of_the_hand(bare_share, expected):
    generic = load_generic()
    hand = hands_beyond_cuffs(generic)[0]
    beside = generic.vertices_m[hand]
    order = hand[np.argsort(np.linalg.norm(beside - beside[0], axis=1))]
    shown = np.zeros(len(generic.vertices_m))
    shown[order[int((1 - bare_share) * len(order)) :]] = 1.0  # the rest, one patch, shows the coat behind
    kinds = find_materials(generic, [seen(shown)], person_graph(generic, generic.vertices_m.astype(float)))
    patch = order[: int((1 - bare_share) * len(order) * 0.5)]
    assert abs(np.median(kinds.bare[patch]) - expected) < 0.05


def test_no_cuff_reaches_the_fingers_and_some_of_the_hand_is_left_to_it():
    generic = load_generic()
    for hand, side in zip(hands_beyond_cuffs(generic), ("left", "right"), strict=True):
        whole = generic.vertex_segment == generic.segment_names.index(f"{side}_hand")
        assert whole[hand].all()
        assert 0.6 < len(hand) / whole.sum() < 0.95
