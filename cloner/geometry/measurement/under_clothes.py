"""Bayesian estimate of body measures under clothes, from measures of the clothes' outline.

Outlines show clothes. A coat's waist says how large the waist can be, not how large
it is. So all measures are estimated together: which body of the generic family, in
which clothes, would show these? Bodies are Gaussian (women and men apart), clothes
above and below the waist fit tight, regular or loose, and each pair of fits gives a
Gaussian estimate and a likelihood; the answer is their mixture. A body has hollows at
waist, knees and armpits that cloth bridges, so many slices tell tight clothes on a
stout person from loose ones on a slim person, and folds at the outline tell them apart
further. Where a photo shows bare skin nothing is taken off, what a tape measured is
known, and what a net sees of the body under the clothes counts as a rougher tape.

References
----------
"Beyond": not in the paper, whose people wear tight clothes. The arithmetic is that of
a Gaussian mixture (C. M. Bishop, Pattern Recognition and Machine Learning, 2006, 2.3).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cho_factor, cho_solve
from scipy.special import ndtr

from cloner.geometry.measurement.prior import MeasurePrior
from cloner.records.arrays import Array
from cloner.records.measures import FITS

Rows = NDArray[np.intp]

#: What a tape reads, one standard deviation, mm: two people differ by this much (ISO 20685: 4 to 9 mm of group means).
TAPE_MM: Final = 3.0
#: Half of nine in ten of a normal distribution, in standard deviations.
NINE_IN_TEN: Final = 1.645
#: Share of regular and loose garments that hang as smooth as tight ones: pressed, stiff or heavy cloth. Judgement, not
#: measured: painted cloth folds by its fit alone, while the suit of a sample visitor is smooth and 150 mm too wide.
SMOOTH: Final = 0.2
#: Share of garments that are rumpled as no fit explains (belts, pockets, a torn outline), alike for every fit, and the
#: range of their rumples' logarithms.
ODD: Final = 0.05
ODD_RANGE: Final = 4.0
#: Of intervals of about a metre: to a tenth of a millimetre.
HALVINGS: Final = 14


@dataclass(frozen=True, slots=True, eq=False)
class OutlineMeasures:
    """The observations of one person.

    Attributes
    ----------
    shown_mm : (K,) float64
        Measures of the clone's skin, clothes included; NaN where not measured or hidden by an arm.
    stature_m : float
    bare : (K,) bool
        Where a photo shows bare skin at the measure's place.
    tape_mm : mapping of int to float
        Measures taken on the person, by row.
    noise : float
        How much worse this clone fits its outlines than those the prior was measured on, as a ratio.
    rumple_mm : (2,) float64
        How rumpled the outline of the clothes is above and below the waist; NaN where not seen.
    under_mm : (K,) float64
        Girths as a net sees them under the clothes; NaN where not seen; none at all by default.
    """

    shown_mm: Array
    stature_m: float
    bare: NDArray[np.bool_]
    tape_mm: Mapping[int, float] = field(default_factory=dict)
    noise: float = 1.0
    rumple_mm: Array = field(default_factory=lambda: np.full(2, np.nan))
    under_mm: Array | None = None


@dataclass(frozen=True, slots=True, eq=False)
class BodyEstimate:
    """The most likely measures of the body.

    Attributes
    ----------
    mm, deviation_mm : (K,) float64
        Median, and the half width that holds nine in ten as standard deviations of a normal distribution.
    upper_fit, lower_fit : (F,) float64
        Probabilities of `FITS`.
    """

    mm: Array
    deviation_mm: Array
    upper_fit: Array
    lower_fit: Array


@dataclass(frozen=True, slots=True, eq=False)
class Hypotheses:
    """Hypotheses of every sex in every pair of clothes' fits.

    Attributes
    ----------
    logs : (S, F, F) float64
        Logarithms of the likelihoods of the measures, neither tempered nor shifted; sex, fit above and below the waist.
    folds : (F, F) float64
        Logarithms of the likelihoods of the outline's rumples.
    mm, variances : (S, F, F, K) float64
        Measures of the body and their variances.
    """

    logs: Array
    folds: Array
    mm: Array
    variances: Array


def hypotheses(evidence: OutlineMeasures, prior: MeasurePrior) -> Hypotheses:
    """Return the hypotheses of every sex in every pair of clothes' fits for one person."""
    rows = np.flatnonzero(~np.isnan(evidence.shown_mm))
    shown = evidence.shown_mm[rows] / (1.0 + prior.fit_bias[rows])
    error = shown * evidence.noise
    noise = prior.fit_covariance[np.ix_(rows, rows)] * np.outer(error, error)
    noise += TAPE_MM**2 * np.eye(len(rows))
    taped = np.array(sorted(evidence.tape_mm), dtype=np.intp)
    tape = np.array([evidence.tape_mm[row] for row in taped])
    seen_rows, under, under_noise = _seen_girths(evidence, prior)
    size = (len(prior.means), len(FITS), len(FITS))
    logs, means, variances = (
        np.zeros(size),
        np.zeros((*size, len(prior.fit_bias))),
        np.zeros((*size, len(prior.fit_bias))),
    )
    for sex, (mean, covariance) in enumerate(zip(prior.means, prior.covariances, strict=True)):
        start = (evidence.stature_m * mean, evidence.stature_m**2 * covariance)
        known, log_evidence = _conditioned(*start, taped, tape, TAPE_MM**2 * np.eye(len(taped)))
        known, guessed = _conditioned(*known, seen_rows, under, under_noise)
        for upper, lower, which in _garments(prior, evidence.bare):
            ease, sigma = _select_by_fit(which, prior.ease_mm), _select_by_fit(which, prior.ease_covariances)
            wanted = shown - ease[rows]
            body, seen = _conditioned(*known, rows, wanted, noise + sigma[np.ix_(rows, rows)])
            logs[sex, upper, lower] = log_evidence + guessed + seen
            means[sex, upper, lower] = body[0]
            variances[sex, upper, lower] = np.diag(body[1])
    upper_folds, lower_folds = (_rumple_likelihoods(evidence.rumple_mm, prior, place) for place in (0, 1))
    return Hypotheses(logs, upper_folds[:, None] + lower_folds, means, np.maximum(variances, 0.0))


def _seen_girths(evidence: OutlineMeasures, prior: MeasurePrior) -> tuple[Rows, Array, Array]:
    """Return rows, values and noise of the girths that the label net sees under clothes."""
    seen = np.full(len(prior.under_gain), np.nan) if evidence.under_mm is None else evidence.under_mm
    rows = np.flatnonzero(~np.isnan(seen) & ~evidence.bare & (prior.under_gain > 0.0))
    gain = prior.under_gain[rows]
    values = (seen[rows] - evidence.stature_m * prior.under_shift[rows]) / gain
    noise = evidence.stature_m**2 * prior.under_covariance[np.ix_(rows, rows)] / np.outer(gain, gain)
    return rows, values, noise


def _rumple_likelihoods(rumple_mm: Array, prior: MeasurePrior, place: int) -> Array:
    """Return the log likelihoods (F,) of one garment's rumple, uniform where it was not seen.

    Smoother than tight clothes counts as tight: nothing lies closer than skin.
    """
    if np.isnan(rumple_mm[place]):
        return np.zeros(len(FITS))
    means, sigmas = prior.rumple_means[:, place], prior.rumple_spreads[:, place]
    away = (max(np.log(max(rumple_mm[place], 1e-3)), means[0]) - means) / sigmas
    density = np.exp(-0.5 * away**2) / (np.sqrt(2.0 * np.pi) * sigmas)
    likely = (1.0 - SMOOTH) * density + SMOOTH * density[0]
    return np.asarray(np.log((1.0 - ODD) * likely + ODD / ODD_RANGE))


def hypothesis_weights(found: Hypotheses, temper: float, log_odds: Array) -> Array:
    """Return the probabilities (S, F, F) of hypotheses from their log likelihoods."""
    odds = temper * found.logs + found.folds + log_odds[None, :, None] + log_odds[None, None, :]
    weights = np.exp(odds - odds.max())
    return np.asarray(weights / weights.sum())


def estimate_body(evidence: OutlineMeasures, prior: MeasurePrior) -> BodyEstimate:
    """Return the most likely measures of a body under its clothes."""
    found = hypotheses(evidence, prior)
    weights = hypothesis_weights(found, prior.temper, prior.log_odds)
    best, half = _mixture_medians(
        weights.ravel(), *(each.reshape(weights.size, -1) for each in (found.mm, found.variances))
    )
    return BodyEstimate(best, half / NINE_IN_TEN, weights.sum(axis=(0, 2)), weights.sum(axis=(0, 1)))


def _mixture_medians(weights: Array, mm: Array, variances: Array) -> tuple[Array, Array]:
    """Return medians (K,) of mixtures of normal distributions, and half widths that hold nine in ten.

    The median, not the mean: a small chance of loose clothes would draw the mean of a tightly dressed person far down.
    """
    sigma = np.sqrt(np.maximum(variances, 1e-6))

    def below(at: Array) -> Array:
        return np.asarray(weights @ ndtr((at - mm) / sigma))

    low, high = (mm - 6.0 * sigma).min(axis=0), (mm + 6.0 * sigma).max(axis=0)
    best = _bisect(below, low, high, 0.5)
    return best, _bisect(lambda half: below(best + half) - below(best - half), np.zeros_like(low), high - low, 0.9)


def _bisect(rising: Callable[[Array], Array], low: Array, high: Array, wanted: float) -> Array:
    """Return where an increasing function of (K,) values reaches ``wanted``, by bisection."""
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        under = rising(middle) < wanted
        low, high = np.where(under, middle, low), np.where(under, high, middle)
    return 0.5 * (low + high)


def _conditioned(
    mean: Array, covariance: Array, rows: Rows, values: Array, noise: Array
) -> tuple[tuple[Array, Array], float]:
    """Return a Gaussian conditioned on noisy observations of some rows, and their log likelihood."""
    if not len(rows):
        return (mean, covariance), 0.0
    factor = cho_factor(covariance[np.ix_(rows, rows)] + noise, lower=True)
    gap = values - mean[rows]
    gain = cho_solve(factor, covariance[rows]).T
    likelihood = -0.5 * float(gap @ cho_solve(factor, gap)) - float(np.log(np.diag(factor[0])).sum())
    return (mean + gain @ gap, covariance - gain @ covariance[rows]), likelihood


def _garments(prior: MeasurePrior, bare: NDArray[np.bool_]) -> Iterator[tuple[int, int, Rows]]:
    """Yield fit above and below the waist and the fit (K,) at each measure, -1 where none is worn, of all pairs."""
    for upper in range(len(FITS)):
        for lower in range(len(FITS)):
            which = np.choose(prior.garment, (-1, upper, lower, max(upper, lower)))
            yield upper, lower, np.where(bare, -1, which)


def _select_by_fit(which: Rows, values: Array) -> Array:
    """Return (K,) or (K, K) values from (F, K) or (F, K, K) by each measure's fit (K,), 0 where none is worn.

    Measures under cloth of one fit vary together; those of different fits do not.
    """
    found = np.zeros(values.shape[1:])
    for fit in range(len(values)):
        own = which == fit
        found = np.where(own if values.ndim == 2 else own[:, None] & own[None], values[fit], found)
    return found
