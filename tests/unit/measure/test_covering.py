"""Where sleeves and trousers end on people labelled here."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.measure.covering import covered_slices, find_covers
from cloner.records.labels import Label
from cloner.records.measures import Cover
from cloner.records.proposals import Proposals
from kit import painted, people, studio

VIEWS = ("body_front", "body_back")
ARM, LEG = ("upper_arm", "forearm"), ("thigh", "calf")


def told(sleeve: float, leg: float) -> dict[str, Cover]:
    """Return what is told of a person whose sleeves and trousers end at a share of arm and leg."""
    generic = load_generic()
    person = people.known_person(5, stature_m=1.7)
    fit = painted.joined(person, {view: people.known_pose(3) for view in VIEWS})
    kinds = np.full(len(person.vertices_m), float(Label.BODY_SKIN))
    for number, name in enumerate(generic.segment_names):
        own = generic.vertex_segment == number
        limb, end = (ARM, sleeve) if "arm" in name else (LEG, leg)
        part = name.split("_", 1)[-1]
        if part in limb:
            place = (limb.index(part) + generic.slice_s) / 2.0
            kinds[own & (place < end)] = Label.UPPER_CLOTHES if limb is ARM else Label.LOWER_CLOTHES
        elif name in ("torso", "pelvis"):
            kinds[own & ~generic.region("neck")] = Label.UPPER_CLOTHES if name == "torso" else Label.LOWER_CLOTHES
    proposals = {}
    for view in VIEWS:
        picture, mask = painted.photograph(fit, np.repeat(kinds[:, None] * 20.0, 3, axis=1), view)
        labels = np.where(mask, np.rint(picture[..., 0] / 20.0), 0).astype(np.uint8)
        proposals[ViewId(view)] = replace(studio.empty_proposal(view, mask), labels=labels)
    return find_covers(Proposals(proposals), fit)


@pytest.mark.parametrize(("sleeve", "leg"), [(0.3, 1.0), (1.0, 0.5), (0.0, 0.25)])
def test_sleeves_and_legs_end_where_they_are_labelled(sleeve: float, leg: float) -> None:
    found = told(sleeve, leg)
    for side in ("left", "right"):
        for limb, end in ((ARM, sleeve), (LEG, leg)):
            slices = [slice_ for part in limb for slice_ in found[f"{side}_{part}"].covered]
            assert np.mean(slices) == pytest.approx(end, abs=0.08), f"{side} {limb}: {slices}"
            assert slices == sorted(slices, reverse=True), "cloth above, skin below"
    assert found["torso"].share == 1.0
    assert found["neck"].share == 0.0
    assert found["left_hand"].share == 0.0


def test_a_photo_that_shows_nobody_tells_nothing() -> None:
    fit = painted.joined(people.known_person(5, stature_m=1.7), {view: people.known_pose(3) for view in VIEWS})
    nobody = studio.empty_proposal("body_front", np.zeros((300, 200), np.bool_))
    assert find_covers(Proposals({ViewId("body_front"): nobody}), fit) == {}


def test_ends_follow_the_colours_with_the_fewest_exceptions() -> None:
    nan = np.nan
    assert covered_slices(np.array([0.0, 0.1, 0.9, 0.2, 1.0, 1.0])) == [True, True, False, False, False, False]
    assert covered_slices(np.array([0.0, nan, nan, 1.0])) == [True, False, False, False]
    assert covered_slices(np.array([1.0, 1.0, 1.0, 0.0])) == [False, False, False, True], "a sock"
    assert covered_slices(np.full(3, nan)) == [None] * 3
    assert covered_slices(np.zeros(4)) == [True] * 4
