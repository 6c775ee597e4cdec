"""From what a clone's skin measures to what the report says of the body."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.generic.load import load_generic
from cloner.generic.measure_prior import load_measure_prior
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measuring import ALL_KEYS, LOOSE_KEYS, measures_mm
from cloner.records.measures import MEASURE_KEYS, Cover
from cloner.records.photos import Person
from cloner.stages.measures import TAPE_ERROR_MM, estimate_measures

STATURE_M = 1.72
BARE_ARMS = {
    f"{side}_{part}": Cover((False,) * 8, 0.9) for side in ("left", "right") for part in ("upper_arm", "forearm")
}


@pytest.fixture(scope="module")
def shown() -> dict[str, float]:
    """Return what a clone of an average body in regular clothes measures."""
    body = measures_mm(*load_generic().shape(np.zeros(0), STATURE_M), load_tape_rules())
    ease = load_measure_prior().ease_mm[1]
    return {key: body[key] + more for key, more in zip(ALL_KEYS, ease, strict=True)}


def person(known: bool = True, **tape_mm: float) -> Person:
    return Person("x", "", STATURE_M, known, "", tuple(tape_mm.items()))


def test_every_measure_has_a_value_and_a_plus_minus(shown: dict[str, float]) -> None:
    found, warnings = estimate_measures(shown, person(), {})
    assert tuple(found.measures) == MEASURE_KEYS
    assert not warnings
    for key, measure in found.measures.items():
        assert measure.shown_mm == shown[key]
        assert 2.0 < measure.plus_minus_mm < 0.25 * measure.value_mm, key
    assert found.measures["hip_girth"].value_mm < shown["hip_girth"], "clothes are taken off"
    assert sum(found.lower_fit.values()) == pytest.approx(1.0)


def test_an_assumed_height_widens_every_measure(shown: dict[str, float]) -> None:
    known, assumed = estimate_measures(shown, person(), {})[0], estimate_measures(shown, person(known=False), {})[0]
    for key in MEASURE_KEYS:
        assert assumed.measures[key].plus_minus_mm > known.measures[key].plus_minus_mm, key
        assert assumed.measures[key].value_mm == known.measures[key].value_mm


def test_bare_arms_are_measured_as_they_are(shown: dict[str, float]) -> None:
    covered, bare = estimate_measures(shown, person(), {})[0], estimate_measures(shown, person(), BARE_ARMS)[0]
    assert bare.measures["upper_arm_girth"].value_mm > covered.measures["upper_arm_girth"].value_mm + 5.0
    assert bare.covers["left_forearm"].share == 0.0


def test_an_arm_over_the_waist_is_told_and_leaves_it_less_sure(shown: dict[str, float]) -> None:
    hidden = np.array([key in ("waist_girth", "navel_girth", "narrowest_waist_girth") for key in ALL_KEYS])
    plain, told = estimate_measures(shown, person(), {}), estimate_measures(shown, person(), {}, hidden=hidden)
    assert not plain[1]
    assert len(told[1]) == 1
    assert "arm" in told[1][0]
    assert told[0].measures["waist_girth"].plus_minus_mm > plain[0].measures["waist_girth"].plus_minus_mm + 1.0
    wrong = estimate_measures(shown | {"waist_girth": shown["waist_girth"] + 30.0}, person(), {}, hidden=hidden)
    assert wrong[0].measures["waist_girth"].value_mm == pytest.approx(told[0].measures["waist_girth"].value_mm)


def test_a_bare_throat_does_not_make_the_neck_bare(shown: dict[str, float]) -> None:
    # the nape's height is told to be bare then, which moves the neck by a millimetre or two
    neck = {"neck": Cover((False,), 1.0)}
    covered, open_collar = (estimate_measures(shown, person(), cover)[0].measures["neck_girth"] for cover in ({}, neck))
    assert covered.value_mm == pytest.approx(open_collar.value_mm, abs=4.0)


def test_a_tape_is_told_as_it_is_and_helps_its_neighbours(shown: dict[str, float]) -> None:
    plain = estimate_measures(shown, person(), {})[0]
    tape = plain.measures["waist_girth"].value_mm - 25.0
    taped, warnings = estimate_measures(shown, person(waist_girth=tape), {})
    waist, navel = taped.measures["waist_girth"], taped.measures["navel_girth"]
    assert (waist.value_mm, waist.plus_minus_mm, waist.taped) == (tape, TAPE_ERROR_MM, True)
    assert navel.value_mm < plain.measures["navel_girth"].value_mm - 5.0
    assert navel.plus_minus_mm < plain.measures["navel_girth"].plus_minus_mm
    assert not navel.taped
    assert not warnings


def test_a_tape_that_contradicts_the_photos_is_asked_about(shown: dict[str, float]) -> None:
    _, warnings = estimate_measures(shown, person(waist_girth=1250.0, hip_girth=shown["hip_girth"] - 40.0), {})
    assert len(warnings) == 1
    assert "125.0 cm" in warnings[0]
    assert "waist_girth" in warnings[0]
    assert "measure again" in warnings[0]


def test_what_a_skirt_hides_is_guessed_and_said_to_be_open(shown: dict[str, float]) -> None:
    visible = {key: value for key, value in shown.items() if key not in LOOSE_KEYS}
    hidden, plain = estimate_measures(visible, person(), {})[0], estimate_measures(shown, person(), {})[0]
    for key in ("thigh_girth", "hip_girth"):
        assert hidden.measures[key].shown_mm is None
        assert hidden.measures[key].value_mm == pytest.approx(plain.measures[key].value_mm, rel=0.15)
        assert hidden.measures[key].plus_minus_mm > plain.measures[key].plus_minus_mm
