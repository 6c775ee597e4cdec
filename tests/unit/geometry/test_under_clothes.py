"""Bodies drawn from the shipped table and dressed here, by rules of this test: the estimate must find them back."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.generic.load import load_generic
from cloner.generic.measure_prior import load_measure_prior
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measuring import ALL_KEYS, measures_mm
from cloner.geometry.measurement.prior import MeasurePrior
from cloner.geometry.measurement.under_clothes import BodyEstimate, OutlineMeasures, estimate_body

STATURE_M = 1.72
COUNT = len(ALL_KEYS)
WAIST, HIP, CALF, ARM, WRIST = (
    ALL_KEYS.index(f"{name}_girth") for name in ("navel", "hip", "calf", "upper_arm", "wrist")
)
NOTHING_BARE = np.zeros(COUNT, dtype=bool)


def exact_fit() -> MeasurePrior:
    """Return the shipped table as if outlines were fitted within half a percent."""
    return replace(load_measure_prior(), fit_bias=np.zeros(COUNT), fit_covariance=0.005**2 * np.eye(COUNT))


def bodies(count: int) -> np.ndarray:
    prior = load_measure_prior()
    rng = np.random.default_rng(7)
    sexes = rng.integers(0, 2, count)
    drawn = [rng.multivariate_normal(prior.means[sex], prior.covariances[sex]) for sex in sexes]
    return STATURE_M * np.array(drawn)


def found(shown: np.ndarray, **more: object) -> BodyEstimate:
    return estimate_body(OutlineMeasures(shown, STATURE_M, **{"bare": NOTHING_BARE, **more}), exact_fit())


@pytest.mark.parametrize("fit", [0, 1, 2])
def test_bodies_are_found_under_clothes_of_every_fit(fit: int) -> None:
    ease = load_measure_prior().ease_mm[fit]
    mean_body = STATURE_M * load_measure_prior().means.mean(axis=0)
    true = bodies(30)
    each = [found(body + ease) for body in true]
    error = np.array([one.mm for one in each]) - true
    for row in (WAIST, HIP, CALF):
        by_mean = np.sqrt(np.mean((true[:, row] - mean_body[row]) ** 2))
        own = np.sqrt(np.mean(error[:, row] ** 2))
        assert own < 0.6 * by_mean, f"{ALL_KEYS[row]}: {own:.0f} mm, the mean body {by_mean:.0f} mm"
    if fit == 2:
        by_outline = ease[WAIST]
        assert np.median(np.abs(error[:, WAIST])) < 0.4 * by_outline
    said = np.mean([np.argmax(one.upper_fit) == fit for one in each])
    assert said > 0.6, f"the clothes' fit was recognised in {100 * said:.0f} percent"


def test_folds_make_loose_clothes_likelier_but_smooth_ones_prove_nothing() -> None:
    prior = load_measure_prior()
    rumpled, flat = (np.exp(prior.rumple_means[fit]) for fit in (2, 0))
    for body in bodies(5):
        regular = body + prior.ease_mm[1]
        plain, folded, smooth = (found(regular, rumple_mm=each) for each in (np.full(2, np.nan), rumpled, flat))
        assert folded.upper_fit[2] >= plain.upper_fit[2] >= smooth.upper_fit[2]
        assert folded.lower_fit[2] >= plain.lower_fit[2]
        assert folded.mm[WAIST] <= smooth.mm[WAIST] + 0.5
    wide = bodies(1)[0] + 1.3 * prior.ease_mm[2]
    pressed = found(wide, rumple_mm=0.5 * flat)
    assert pressed.upper_fit[2] > 0.8, "a wide suit stays wide, however well it is pressed"
    assert pressed.upper_fit == pytest.approx(found(wide, rumple_mm=flat).upper_fit), "nothing is closer than tight"


def test_bare_skin_is_taken_as_it_is() -> None:
    bare = NOTHING_BARE.copy()
    bare[[ARM, WRIST]] = True
    body = bodies(1)[0]
    shown = body + np.where(bare, 0.0, load_measure_prior().ease_mm[2])
    known, unknown = found(shown, bare=bare), found(shown)
    assert abs(known.mm[ARM] - body[ARM]) < 5.0
    assert known.deviation_mm[ARM] < unknown.deviation_mm[ARM]


def test_a_tape_is_believed_and_tells_the_clothes() -> None:
    body = bodies(1)[0]
    shown = body + load_measure_prior().ease_mm[2]
    told = found(shown, tape_mm={WAIST: float(body[WAIST])})
    assert told.mm[WAIST] == pytest.approx(body[WAIST], abs=5.0)
    assert told.deviation_mm[WAIST] < 4.0
    assert told.upper_fit[2] > 0.8
    contrary = found(shown, tape_mm={WAIST: float(shown[WAIST])})
    assert contrary.upper_fit[2] < told.upper_fit[2]
    assert contrary.mm[HIP] > told.mm[HIP], "a stouter waist makes stouter hips likelier"


def test_the_spread_is_what_it_says() -> None:
    """Two thirds of the errors lie inside one standard deviation, nineteen in twenty inside two."""
    rng = np.random.default_rng(3)
    prior = load_measure_prior()
    away = []
    for body in bodies(60):
        fit = rng.integers(3)
        ease = rng.multivariate_normal(prior.ease_mm[fit], prior.ease_covariances[fit])
        one = found(body + ease + 0.005 * body * rng.normal(size=COUNT))
        away.append(((one.mm - body) / one.deviation_mm)[[WAIST, HIP, CALF, ARM]])
    assert 0.5 < np.mean(np.abs(away) < 1.0) < 0.85
    assert 0.88 < np.mean(np.abs(away) < 2.0)


def test_a_worse_outline_leaves_more_open_and_missing_slices_are_no_zero() -> None:
    shown = bodies(1)[0]
    assert found(shown, noise=4.0).deviation_mm[WAIST] > 1.1 * found(shown).deviation_mm[WAIST]
    half = shown.copy()
    half[CALF] = np.nan
    assert found(half).mm[CALF] == pytest.approx(found(shown).mm[CALF], abs=40.0)
    assert found(half).deviation_mm[CALF] > found(shown).deviation_mm[CALF]


def test_a_hidden_depth_leaves_that_girth_open_and_its_neighbours_speak_for_it() -> None:
    wider = []
    for body in bodies(20):
        hidden = body.copy()
        hidden[WAIST] = np.nan
        wider.append(found(hidden).deviation_mm[WAIST] - found(body).deviation_mm[WAIST])
    assert np.mean(wider) > 0.2, "one is unsure of what one has not seen"


def test_the_table_is_that_of_the_shipped_human() -> None:
    generic, prior = load_generic(), load_measure_prior()
    mean = np.array(list(measures_mm(*generic.shape(np.zeros(0), STATURE_M), load_tape_rules()).values()))
    middle = STATURE_M * prior.means.mean(axis=0)
    girths = [row for row, key in enumerate(ALL_KEYS) if "girth" in key]
    assert mean[girths] == pytest.approx(middle[girths], rel=0.04)
    for covariance in (*prior.covariances, *prior.ease_covariances, prior.fit_covariance):
        assert np.linalg.eigvalsh(covariance).min() > -1e-4 * np.linalg.eigvalsh(covariance).max()
    assert (np.diff(prior.ease_mm[:, [WAIST, HIP, CALF]], axis=0) > 0).all(), "looser clothes add more"


def test_what_a_net_sees_under_clothes_is_a_rougher_tape() -> None:
    usual = load_measure_prior().means.mean(axis=0)
    drawn_to_the_mean = {"under_shift": 0.3 * usual, "under_gain": np.full(COUNT, 0.7)}
    prior = replace(exact_fit(), **drawn_to_the_mean, under_covariance=np.diag((0.02 * usual) ** 2))
    with_it, without = [], []
    for body in bodies(30):
        shown = body + prior.ease_mm[2]
        under = np.full(COUNT, np.nan)
        under[[WAIST, HIP]] = (0.3 * STATURE_M * usual + 0.7 * body)[[WAIST, HIP]]
        estimates = [
            estimate_body(OutlineMeasures(shown, STATURE_M, NOTHING_BARE, under_mm=own), prior) for own in (under, None)
        ]
        with_it.append(estimates[0].mm[WAIST] - body[WAIST])
        without.append(estimates[1].mm[WAIST] - body[WAIST])
        assert estimates[0].deviation_mm[WAIST] < estimates[1].deviation_mm[WAIST]
    assert np.abs(with_it).mean() < 0.6 * np.abs(without).mean()
