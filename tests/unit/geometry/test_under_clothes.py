"""Bodies drawn from the prior and dressed here, by rules of this test: the estimate must find them back."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.generic.girth_prior import load_girth_prior
from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measures import GIRTH_NAMES, girths_mm
from cloner.geometry.under_clothes import GirthPrior, girths_under_clothes

STATURE_M = 1.72
WAIST, HIP, CALF = (GIRTH_NAMES.index(name) for name in ("waist", "hip", "calf"))
#: What a jacket (upper row) and wide trousers (lower row) add, mm; round figures of this test.
JACKET = np.array([30.0, 90.0, 100.0, 110.0, 115.0, 90.0, 0.0, 0.0, 60.0])
TROUSERS = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 50.0, 45.0, 90.0, 0.0])


def exact_fit() -> GirthPrior:
    """Return the shipped prior as if outlines were fitted without error."""
    prior = load_girth_prior()
    none = np.zeros(len(GIRTH_NAMES))
    return GirthPrior(prior.means, prior.covariance, none, none + 0.005)


def bodies(count: int) -> np.ndarray:
    prior = load_girth_prior()
    rng = np.random.default_rng(7)
    each = prior.means[rng.integers(0, 2, count)]
    return 1e3 * STATURE_M * (each + rng.multivariate_normal(np.zeros(len(GIRTH_NAMES)), prior.covariance, count))


def estimates(shown: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    found = [
        girths_under_clothes(dict(zip(GIRTH_NAMES, row, strict=True)), STATURE_M, exact_fit()).values() for row in shown
    ]
    values = np.array([[girth.value_mm for girth in row] for row in found])
    return values, np.array([[girth.plus_minus_mm for girth in row] for row in found])


def test_bodies_under_jackets_are_found_better_than_by_their_outline_and_by_the_mean() -> None:
    true = bodies(60)
    ease = np.maximum(JACKET, TROUSERS)
    found, _ = estimates(true + ease)
    error = np.sqrt(np.mean((found - true) ** 2, axis=0))
    mean_body = 1e3 * STATURE_M * load_girth_prior().means.mean(axis=0)
    by_mean = np.sqrt(np.mean((true - mean_body) ** 2, axis=0))
    for k, name in enumerate(GIRTH_NAMES):
        assert error[k] < by_mean[k], f"{name}: {error[k]:.0f} mm, the mean body {by_mean[k]:.0f} mm"
    for k in (WAIST, HIP, CALF):
        assert error[k] < 0.7 * ease[k], f"{GIRTH_NAMES[k]}: {error[k]:.0f} mm under {ease[k]:.0f} mm of cloth"


def test_close_clothes_leave_less_open_than_wide_ones() -> None:
    true = bodies(20)
    close, close_spread = estimates(true + 0.05 * np.maximum(JACKET, TROUSERS))
    _, wide_spread = estimates(true + np.maximum(JACKET, TROUSERS))
    assert np.median(close_spread[:, WAIST]) < np.median(wide_spread[:, WAIST])
    # nothing says that clothes are close, so a little is always taken off: it must stay near what ± admits
    off = np.abs(np.median((close - true) / close_spread, axis=0))
    assert off.max() < 1.5, f"close clothes make people {off.max():.1f} standard deviations thinner"


def test_the_plus_minus_is_what_it_says() -> None:
    """Two thirds of the errors lie inside one standard deviation, nine in ten inside two, over a mixture of clothes."""
    true = bodies(90)
    share = np.repeat([0.1, 0.4, 1.0], 30)[:, None]
    found, spread = estimates(true + share * np.maximum(JACKET, TROUSERS))
    away = np.abs(found - true) / spread
    assert 0.5 < np.mean(away < 1.0) < 0.9
    assert np.mean(away < 2.0) > 0.9


def test_everything_grows_with_the_person() -> None:
    shown = dict(zip(GIRTH_NAMES, bodies(1)[0] + JACKET, strict=True))
    small = girths_under_clothes(shown, STATURE_M, load_girth_prior())
    tall = girths_under_clothes(
        {name: 1.02 * value for name, value in shown.items()}, 1.02 * STATURE_M, load_girth_prior()
    )
    for name in GIRTH_NAMES:  # clothes do not grow: nearly, not exactly
        assert tall[name].value_mm == pytest.approx(1.02 * small[name].value_mm, rel=0.01), name


def test_the_prior_is_that_of_the_shipped_human() -> None:
    generic, prior = load_generic(), load_girth_prior()
    mean = np.array(list(girths_mm(*generic.shape(np.zeros(0), STATURE_M), load_tape_rules()).values()))
    assert mean == pytest.approx(1e3 * STATURE_M * prior.means.mean(axis=0), rel=0.03)
    assert np.linalg.eigvalsh(prior.covariance).min() > 0.0
