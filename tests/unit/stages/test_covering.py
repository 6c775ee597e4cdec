"""Cloth and skin told apart on people painted here: sleeves, shorts, and clothes of the skin's own colour."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.records.labels import Label
from cloner.records.measures import Cover
from cloner.records.points import Proposals
from cloner.stages.covering import covers, ending
from cloner.vision.skin_colour import FARTHEST, skin_colour, skin_distance
from kit import painted, people, studio

VIEWS = ("body_front", "body_back")
SKIN, BLUE, GREY = (205.0, 160.0, 140.0), (50.0, 80.0, 150.0), (70.0, 70.0, 74.0)
ARM, LEG = ("upper_arm", "forearm"), ("thigh", "calf")


def told(sleeve: float, leg: float, skin: tuple, shirt: tuple, trousers: tuple) -> dict[str, Cover]:
    """Return what is told of a person whose sleeves and trousers end at a share of arm and leg."""
    generic = load_generic()
    person = people.known_person(5, stature_m=1.7)
    fit = painted.joined(person, {view: people.known_pose(3) for view in VIEWS})
    colours = np.tile(skin, (len(person.vertices_m), 1))
    for number, name in enumerate(generic.segment_names):
        own = generic.vertex_segment == number
        limb, end = (ARM, sleeve) if "arm" in name else (LEG, leg)
        part = name.split("_", 1)[-1]
        if part in limb:
            place = (limb.index(part) + generic.slice_s) / 2.0
            colours[own & (place < end)] = shirt if limb is ARM else trousers
        elif name in ("torso", "pelvis"):
            colours[own & ~generic.region("neck")] = shirt if name == "torso" else trousers
    light = 0.85 + 0.15 * np.sin(9.0 * person.vertices_m[:, 1])  # shading changes brightness, not colour
    photos, proposals = {}, {}
    head = generic.vertex_segment == generic.segment_names.index("head")
    for view in VIEWS:
        picture, mask = painted.photograph(fit, colours * light[:, None], view)
        noisy = picture + np.random.default_rng(1).normal(0.0, 4.0, picture.shape)
        photos[view] = np.clip(noisy, 0, 255).astype(np.uint8)
        labels = np.where(mask, Label.UPPER_CLOTHES, 0).astype(np.uint8)
        place = np.rint(fit.views[ViewId(view)].camera.project(painted.posed(fit, view)[head])).astype(int)
        labels[place[:, 1], place[:, 0]] = Label.FACE_SKIN
        proposals[view] = replace(studio.empty_proposal(view, mask), labels=labels)
    return covers(studio.photo_set(photos), Proposals({ViewId(view): p for view, p in proposals.items()}), fit)


@pytest.mark.parametrize(
    ("skin", "sleeve", "leg"), [(SKIN, 0.3, 1.0), ((95.0, 62.0, 48.0), 1.0, 0.5), (SKIN, 0.0, 0.25)]
)
def test_sleeves_and_legs_end_where_they_were_painted(skin: tuple, sleeve: float, leg: float) -> None:
    found = told(sleeve, leg, skin, BLUE, GREY)
    for side in ("left", "right"):
        for limb, end in ((ARM, sleeve), (LEG, leg)):
            slices = [slice_ for part in limb for slice_ in found[f"{side}_{part}"].covered]
            assert np.mean(slices) == pytest.approx(end, abs=0.08), f"{side} {limb}: {slices}"
            assert slices == sorted(slices, reverse=True), "cloth above, skin below"
    assert found["torso"].share == 1.0
    assert found["neck"].share == 0.0
    assert found["left_hand"].share == 0.0


def test_a_shirt_of_the_skins_colour_says_nothing_of_its_sleeves() -> None:
    found = told(0.5, 1.0, SKIN, (200.0, 158.0, 139.0), GREY)
    for part in ARM:
        cover = found.get(f"left_{part}")
        assert cover is None or not any(slice_ is False for slice_ in cover.covered), "no sleeve is called bare"
    assert found["left_calf"].share == 1.0


def test_ends_follow_the_colours_with_the_fewest_exceptions() -> None:
    nan = np.nan
    assert ending(np.array([0.0, 0.1, 0.9, 0.2, 1.0, 1.0])) == [True, True, False, False, False, False]
    assert ending(np.array([0.0, nan, nan, 1.0])) == [True, False, False, False]
    assert ending(np.array([1.0, 1.0, 1.0, 0.0])) == [False, False, False, True], "a sock"
    assert ending(np.full(3, nan)) == [None] * 3
    assert ending(np.zeros(4)) == [True] * 4


def test_skin_is_known_in_any_light_but_black_and_glare() -> None:
    rng = np.random.default_rng(0)
    samples = np.array(SKIN) * rng.uniform(0.8, 1.1, (400, 1)) + rng.normal(0, 3, (400, 3))
    own = skin_colour(np.clip(samples, 0, 255))
    assert own is not None
    light, shade = np.array(SKIN)[None] * 1.15, np.array(SKIN)[None] * 0.65
    assert skin_distance(light, own)[0] < FARTHEST
    assert skin_distance(shade, own)[0] < FARTHEST
    for cloth in (BLUE, GREY, (12, 9, 8), (250, 250, 250), (150, 160, 140)):
        assert skin_distance(np.array([cloth]), own)[0] > FARTHEST, cloth
    assert skin_colour(samples[:5]) is None
