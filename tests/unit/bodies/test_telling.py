"""What nobody can measure is refused in one sentence that names the measure."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.bodies.children import STATURES_MM, SURVEY_AGES, USUAL_AGE, stature_mm
from cloner.bodies.population import STATURE_MM, SURVEY_MM, people
from cloner.bodies.telling import BodySpecification, check_specification, untold_mm
from cloner.errors import ClonerError
from cloner.geometry.measurement.measuring import ALL_KEYS


@pytest.mark.parametrize(
    ("told", "names"),
    [
        (BodySpecification("x", 1.7, {}), "sex"),
        (BodySpecification("f", 0.9, {}), "stature of 90 cm"),
        (BodySpecification("f", float("nan"), {}), "stature"),
        (BodySpecification("f", 1.7, {}, 8.0), "stature of 170 cm"),
        (BodySpecification("m", 0.8, {}, 2.0), "age of 2 years"),
        (BodySpecification("m", 1.28, {"waist_girth": 900.0}, 8.0), "waist girth of 90.0 cm"),
        (BodySpecification("f", 1.7, {"head_girth": 560.0}), "head girth"),
        (
            BodySpecification("f", 1.7, {"bust_girth": 800.0, "underbust_girth": 850.0}),
            "bust girth of 80.0 cm is smaller",
        ),
        (
            BodySpecification("f", 1.7, {"inside_leg_height": 700.0, "waist_height": 690.0}),
            "waist height of 69.0 cm is smaller",
        ),
        (BodySpecification("m", 1.7, {"waist_girth": 1900.0}), "waist girth of 190.0 cm"),
        (BodySpecification("f", 1.7, {"waist_girth": 700.0, "navel_girth": 1150.0}), "girth"),
    ],
)
def test_the_impossible_is_refused_by_name(told: BodySpecification, names: str) -> None:
    with pytest.raises(ClonerError, match=names):
        check_specification(told)


def test_what_people_have_is_taken() -> None:
    for sex in ("f", "m"):
        for spreads in (-3.0, 0.0, 3.0):
            survey = SURVEY_MM[sex]
            mm = {key: survey[key][0] + spreads * survey[key][1] for key in ("bust_girth", "navel_girth", "hip_girth")}
            check_specification(BodySpecification(sex, STATURE_MM[sex][0] / 1e3, mm))


@pytest.mark.parametrize("sex", ["f", "m"])
def test_the_table_has_the_survey_s_means_and_spreads(sex: str) -> None:
    stature_m = STATURE_MM[sex][0] / 1e3
    for key, pair in SURVEY_MM[sex].items():
        assert people(sex, USUAL_AGE).spread_mm(key, stature_m) == pytest.approx(pair, rel=1e-6)
    assert np.linalg.eigvalsh(people(sex, USUAL_AGE).covariance).min() > -1e-9


def test_what_is_told_moves_what_is_not_told_and_makes_it_surer() -> None:
    nothing = untold_mm(BodySpecification("f", 1.68, {}))
    stout = untold_mm(BodySpecification("f", 1.68, {"hip_girth": 1200.0}))
    assert stout["thigh_girth"][0] > nothing["thigh_girth"][0] + 60.0
    assert stout["thigh_girth"][1] < 0.7 * nothing["thigh_girth"][1]


@pytest.mark.parametrize("sex", ["f", "m"])
def test_children_grow_and_their_heads_are_large_for_them(sex: str) -> None:
    statures = [stature_mm(sex, age)[0] for age in SURVEY_AGES]
    assert statures == sorted(STATURES_MM[sex])
    tables = [people(sex, age) for age in (5.0, 9.0, 13.0, 17.0, USUAL_AGE)]
    heads = [table.mean[ALL_KEYS.index("head_girth")] for table in tables]
    assert heads == sorted(heads, reverse=True), "over the stature"
    assert heads[0] > 1.3 * heads[-1]
    for table in tables:
        assert np.linalg.eigvalsh(table.covariance).min() > -1e-9
