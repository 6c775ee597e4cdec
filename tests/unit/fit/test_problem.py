"""Unknowns with priors find the likeliest values, keep their bounds, and tell how certain they are."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.fit.evidence import Residuals, agreement_residuals, cauchy_weights, correlated_residuals, point_residuals
from cloner.fit.problem import ParameterBlock, Problem, solve_bounded


def measured(value: float, spread: float, *, outlier: float = np.inf) -> list[Residuals]:
    """Return how one unknown of block "x" is measured: 0 is wanted to be ``value``."""
    return [point_residuals(("x",), np.array([[-value]]), np.ones((1, 1, 1)), spread, outlier=outlier)]


def test_a_measure_and_what_is_expected_meet_by_their_spreads() -> None:
    """Expected 1 within 2, measured 4 within 1: 4 · 4/5 + 1 · 1/5, known to 2/√5."""
    problem = Problem({"x": ParameterBlock(np.zeros(1), mean=1.0, sigma=2.0)})
    found = problem.solve(lambda values, iteration: [Residuals(("x",), values["x"] - 4.0, np.eye(1))], iterations=3)
    assert found.values["x"] == pytest.approx([3.4])
    assert found.covariance("x") == pytest.approx(np.array([[0.8]]))


def test_the_told_covariance_is_that_of_fits_to_noisy_data() -> None:
    """A circle's middle and radius from points on a third of it: the radius and one coordinate err together."""
    rng, around = np.random.default_rng(19), np.linspace(-1.0, 1.0, 12)
    rays = np.column_stack([np.cos(around), np.sin(around)])
    blocks = {"middle": ParameterBlock(np.zeros(2)), "radius": ParameterBlock(np.ones(1), mean=2.0, sigma=0.05)}

    def fitted(seen: np.ndarray, usual: float) -> tuple[np.ndarray, np.ndarray]:
        def linearise(values, iteration):
            away = values["middle"] + values["radius"] * rays - seen
            jacobian = np.concatenate([np.broadcast_to(np.eye(2), (12, 2, 2)), rays[..., None]], axis=2)
            return [point_residuals(("middle", "radius"), away, jacobian, 0.01)]

        own = {**blocks, "radius": ParameterBlock(np.ones(1), mean=usual, sigma=0.05)}
        found = Problem(own).solve(linearise, iterations=5)
        return np.concatenate(list(found.values.values())), found.covariance("middle", "radius")

    told = fitted([0.3, -0.1] + 2.0 * rays, 2.0)[1]
    radii = rng.normal(2.0, 0.05, 2000)
    several = [fitted([0.3, -0.1] + r * rays + rng.normal(0.0, 0.01, (12, 2)), 2.0)[0] - [0.3, -0.1, r] for r in radii]
    spread = np.sqrt(np.diag(told))
    np.testing.assert_allclose(np.cov(np.array(several).T) / np.outer(spread, spread), told / np.outer(spread, spread),
                               atol=0.08)  # fmt: skip


def test_values_stay_within_bounds_and_the_others_explain_the_rest() -> None:
    """x + y = 3 with x at most 1 (and least 0): y takes 2; unbounded they would share it."""
    problem = Problem(
        {"x": ParameterBlock(np.zeros(1), sigma=1.0, lower=0.0, upper=1.0), "y": ParameterBlock(np.zeros(1), sigma=1.0)}
    )

    def linearise(values, iteration):
        return [Residuals(("x", "y"), 1e3 * (values["x"] + values["y"] - 3.0), 1e3 * np.ones((1, 2)))]

    found = problem.solve(linearise, iterations=4).values
    assert found["x"] == pytest.approx([1.0])
    assert found["y"] == pytest.approx([2.0], abs=1e-4)
    assert solve_bounded(
        np.eye(2), np.array([-2.0, 5.0]), np.array([-1.0, -1.0]), np.array([9.0, 4.0])
    ) == pytest.approx([-1.0, 4.0])


def test_a_guard_cuts_off_what_evidence_takes_too_far() -> None:
    problem = Problem({"x": ParameterBlock(np.zeros(1), mean=1.0, sigma=0.5, max_sigmas=2.0)})
    found = problem.solve(
        lambda values, iteration: [Residuals(("x",), 1e3 * (values["x"] - 9.0), 1e3 * np.eye(1))], iterations=2
    )
    assert found.values["x"] == pytest.approx([2.0])


def test_no_step_is_longer_than_the_model_is_good() -> None:
    turns = []
    problem = Problem({"x": ParameterBlock(np.zeros(1), max_step=0.5)})

    def linearise(values, iteration):
        turns.append(float(values["x"][0]))
        return [Residuals(("x",), values["x"] - 2.0, np.eye(1))]

    assert problem.solve(linearise, iterations=9, tolerance=1e-6).values["x"] == pytest.approx([2.0])
    assert turns == pytest.approx([0.0, 0.5, 1.0, 1.5, 2.0])  # and the last step is still


def test_a_rare_thing_is_found_only_where_evidence_asks_for_it() -> None:
    """An exponential prior beside the normal one: its decline is the least evidence that moves the value from 0."""
    for pull, wanted in ((0.9, 0.0), (3.0, 1.0)):
        problem = Problem({"x": ParameterBlock(np.zeros(1), sigma=1.0, decay_rate=1.0, lower=0.0)})
        found = problem.solve(
            lambda values, iteration, p=pull: [Residuals(("x",), values["x"] - p, np.eye(1))], iterations=3
        )
        assert found.values["x"] == pytest.approx([wanted])


def test_a_wrong_point_fades_and_a_far_value_is_held_loosely() -> None:
    def linearise(values, iteration):
        away = np.broadcast_to(values["x"], (10, 1)) - np.r_[np.zeros(9), 50.0][:, None]
        return [point_residuals(("x",), away, np.ones((10, 1, 1)), 1.0, outlier=3.0)]

    assert abs(Problem({"x": ParameterBlock(np.zeros(1))}).solve(linearise, iterations=30).values["x"][0]) < 0.05
    held = ParameterBlock(np.zeros(1), sigma=1.0, cauchy_scale=1.5)
    far = Problem({"x": held}).solve(
        lambda values, iteration: [Residuals(("x",), values["x"] - 10.0, np.eye(1))], iterations=60
    )
    assert far.values["x"][0] > 9.0
    assert cauchy_weights(np.array([4.0]), 2.0) == pytest.approx([0.5])


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_tie_brings_the_unseen_side_to_the_seen_one(sign: float) -> None:
    problem = Problem({"seen": ParameterBlock(np.zeros(1)), "unseen": ParameterBlock(np.zeros(1), sigma=1.0)})

    def linearise(values, iteration):
        apart = values["seen"] - sign * values["unseen"]
        return [
            Residuals(("seen",), (values["seen"] - 0.4) / 0.01, np.eye(1) / 0.01),
            agreement_residuals(("seen", "unseen"), apart, np.array([[1.0, -sign]]), 0.05, outlier=2.0),
        ]

    found = problem.solve(linearise, iterations=8).values
    assert [found["seen"][0], found["unseen"][0]] == pytest.approx([0.4, sign * 0.4], abs=0.002)


def test_along_a_curve_points_slide() -> None:
    along = np.array([[0.0, 1.0]])
    rows = point_residuals(("x",), np.array([[5.0, 0.2]]), np.eye(2)[None], 0.1, normal=along)
    assert rows.value == pytest.approx([2.0])
    assert rows.jacobian == pytest.approx(np.array([[0.0, 10.0]]))


def test_points_that_err_together_count_by_their_joint_errors_alone() -> None:
    """Two points shifted alike, whose shift is uncertain by 10 and whose difference by 0.1: near to no evidence."""
    shift, own = np.full((2, 2), 100.0), 0.01 * np.eye(2)
    covariance = np.kron(shift + own, np.eye(2))
    whiten = np.linalg.inv(np.linalg.cholesky(covariance))
    alike = correlated_residuals(("x",), np.full((2, 2), 3.0), np.ones((2, 2, 1)), whiten, outlier=3.0)
    apart = correlated_residuals(("x",), np.array([[3.0, 0.0], [-3.0, 0.0]]), np.ones((2, 2, 1)), whiten, outlier=3.0)
    assert (alike.value**2).sum() == pytest.approx(0.18, rel=0.01)  # 3 of 10, in x and in y
    assert np.min(alike.weight) > 0.95 > 0.05 > np.max(apart.weight)
