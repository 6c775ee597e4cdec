"""Write ``cloner_models/measures.npz`` from the samples of ``benchmarks/measure_samples.py``.

``python benchmarks/measure_table.py SAMPLES``; with ``--check`` nothing is written and the errors on ``SAMPLES/checks``
are printed, people who took no part in the table. No sample visitor takes part in either.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import minimize

from cloner.generic.load import load_generic
from cloner.generic.measure_prior import FILE, load_measure_prior
from cloner.geometry.measuring import ALL_KEYS, bare_rows
from cloner.geometry.under_clothes import (
    HIDDEN,
    LOWER,
    NINE_IN_TEN,
    UPPER,
    Estimate,
    Evidence,
    Hypotheses,
    MeasurePrior,
    estimate,
    hypotheses,
    weighed,
)
from cloner.records.measures import FITS, Cover

MODELS = Path(__file__).resolve().parents[1] / "generic_models" / "cloner_models"
DRAWS = 40_000
SEX = 0  # row of the phenotype that tells women (0) from men (1)
#: Keys that no garment of the table changes; shoes and hair are errors of the fit.
FREE = ("head_", "face_", "hand_", "foot_")
ABOVE = (
    *("neck", "bust", "underbust", "narrowest", "waist", "upper_arm", "wrist", "forearm"),
    *("back_", "shoulder", "biac", "chest", "arm_"),
)
#: Where shirts hang over trousers the wider of both makes the outline.
BOTH = (
    *("navel_girth", "hip_girth", "hip_height", "total_crotch_length"),
    *("trunk_slice_55", "trunk_slice_70", "trunk_slice_85"),
)
#: Real garments are cut in more ways than the painted ones: their spread is widened, and each slice differs a little.
WIDER = 1.2
CUT_SHARE = 0.1
#: Real cloth folds in more ways too: standard deviation of a rumple's logarithm beside that of painted cloth.
RUMPLED = 1.3
#: A fit's own bias counts in full with many more people than this a fit.
LEAN = 5.0
#: Largest believed relative error of a clone.
LARGEST = 0.15
#: Share of the calibrating people within the ±. The temper was chosen on them too: of others, measured in folds of
#: whole tables, one or two in a hundred fewer lie within it, and nine in ten are promised.
COVER = 0.92
#: Shrinkage of the fit's covariance towards its diagonal, and a floor (relative).
SHRINK = 0.3
FLOOR = 0.003


def read(folder: Path) -> list[dict[str, Any]]:
    """Return all samples of a folder in the order of their seeds."""
    return [dict(np.load(path)) for path in sorted(folder.glob("*.npz"))]


def garments() -> np.ndarray:
    """Return which garment makes each measure."""
    codes = []
    for key in ALL_KEYS:
        above = key.startswith(ABOVE) or (key.startswith("trunk_slice") and key not in BOTH)
        codes.append(0 if key.startswith(FREE) else UPPER | LOWER if key in BOTH else UPPER if above else LOWER)
    return np.array(codes)


def family(samples: Sequence[Mapping[str, Any]], rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Return means (2, K) and covariances (2, K, K) of measures over stature for women and men.

    A measure is nearly linear in the shape: a ridge plane over the coefficients, drawn from many times.
    """
    generic = load_generic()
    shapes = np.array([sample["coefficients"] for sample in samples])
    shares = np.array([sample["naked"] / sample["stature_m"] for sample in samples])
    design = np.c_[np.ones(len(shapes)), shapes]
    ridge = np.diag(np.r_[0.0, np.full(shapes.shape[1], 2.0)])
    hat = design @ np.linalg.solve(design.T @ design + ridge, design.T)
    plane = np.linalg.solve(design.T @ design + ridge, design.T @ shares)
    rest = (shares - design @ plane) / (1.0 - np.diag(hat))[:, None]  # as if each had been left out
    drawn = rng.normal(size=(DRAWS, shapes.shape[1]))
    values = np.c_[np.ones(DRAWS), drawn] @ plane + rng.multivariate_normal(
        np.zeros(len(ALL_KEYS)), np.cov(rest.T), DRAWS
    )
    men = (generic.phenotype_mean + drawn @ generic.phenotype_from_shape.T)[:, SEX] > 0.5
    return np.array([values[~men].mean(0), values[men].mean(0)]), np.array(
        [np.cov(values[~men].T), np.cov(values[men].T)]
    )


def ease(samples: Sequence[Mapping[str, Any]], garment: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return what clothes of each fit add, (F, K) mm, and its widened covariances."""
    added = np.array([sample["worn"] - sample["naked"] for sample in samples]) * (garment > 0)
    mean = added.mean(axis=0)
    spread = [WIDER**2 * np.cov(added[:, fit].T) + np.diag((CUT_SHARE * mean[fit]) ** 2) for fit in range(len(FITS))]
    return mean, np.array(spread)


def fit_error(samples: Sequence[Mapping[str, Any]], garment: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return bias (K,), covariance (K, K) and the extra bias (F, K) under each fit of the clone's relative error.

    What the fit makes of cloth depends on the cloth; few people say how, so each fit's bias leans on the common one.
    """
    true = np.array([np.where(garment > 0, sample["dressed"], sample["naked"]) for sample in samples])
    fits = np.array([int(sample["tightness"]) for sample in samples])
    error = np.array([sample["shown"] for sample in samples]) / true - 1.0
    middle = np.median(error, axis=0)
    hidden = np.array([sample["hidden"] for sample in samples])
    error = np.clip(error - middle, -LARGEST, LARGEST) / np.where(
        hidden, HIDDEN, 1.0
    )  # a clone that failed is a warning's business, not the table's
    own = np.array([error[fits == fit].mean(axis=0) for fit in range(len(FITS))])
    share = len(samples) / (len(samples) + len(FITS) * LEAN)
    extra = share * (own - own.mean(axis=0)) * (garment > 0)
    rest = error - own.mean(axis=0) - extra[fits]
    covariance = rest.T @ rest / max(len(samples) - len(FITS), 1)
    shrunk = (1 - SHRINK) * covariance + np.diag(SHRINK * np.diag(covariance) + FLOOR**2)
    return middle + own.mean(axis=0), shrunk, extra


def rumples(samples: Sequence[Mapping[str, Any]]) -> tuple[np.ndarray, np.ndarray]:
    """Return mean and widened standard deviation (F, 2) of the logarithm of what the outlines' rumples are."""
    fits = np.array([int(sample["tightness"]) for sample in samples])
    logs = np.log(np.array([sample["rumple"] for sample in samples]))
    means = np.array([np.nanmean(logs[fits == fit], axis=0) for fit in range(len(FITS))])
    own = np.sqrt(np.nanmean((logs - means[fits]) ** 2, axis=0))
    return means, np.tile(RUMPLED * own, (len(FITS), 1))


def table(bodies: Sequence[Mapping[str, Any]], fits: Sequence[Mapping[str, Any]]) -> MeasurePrior:
    """Return the table without what only its own use can tell: tempering, odds and spread."""
    garment = garments()
    means, covariances = family(bodies, np.random.default_rng(0))
    added, spread = ease(bodies, garment)
    bias, covariance, extra = fit_error(fits, garment)
    usual = np.mean([sample["naked"] for sample in fits], axis=0)
    gap = float(np.median([np.mean(sample["gap_mm"]) for sample in fits]))
    shown = added + extra * (usual + added)
    flat = (1.0, np.zeros(len(FITS)), np.full(len(ALL_KEYS), NINE_IN_TEN))
    return MeasurePrior(means, covariances, shown, spread, bias, covariance, *flat, *rumples(fits), garment, gap)


def odds(found: Sequence[Hypotheses], fits: Sequence[int]) -> tuple[float, np.ndarray]:
    """Return the temper and the log odds with which likelihoods tell the true fit best (J. C. Platt, 1999)."""

    def cost(x: np.ndarray) -> float:
        added = np.array([0.0, x[1], x[2]])
        total = 0.5 * (x[0] + 1.0) ** 2 + 0.05 * (x[1] ** 2 + x[2] ** 2)  # weak beliefs, for few people
        for each, fit in zip(found, fits, strict=True):
            weights = weighed(each, float(np.exp(x[0])), added)
            total -= np.log(weights[:, fit].sum() + 1e-6) + np.log(weights[:, :, fit].sum() + 1e-6)
        return float(total)

    best = minimize(cost, [-1.0, 0.0, 0.0], method="Nelder-Mead").x
    return float(np.exp(best[0])), np.array([0.0, best[1], best[2]])


def evidence(sample: Mapping[str, Any], prior: MeasurePrior) -> Evidence:
    """Return what the product would know of a photographed sample."""
    names = [name for name in sample if name.startswith("cover_")]
    covers = {name[6:]: Cover(tuple(None if s < 0 else bool(s) for s in sample[name]), 1.0) for name in names}
    noise = max(1.0, float(np.mean(sample["gap_mm"])) / prior.gap_mm)
    folds, hidden = sample["rumple"], np.asarray(sample["hidden"], dtype=bool)
    return Evidence(sample["shown"], float(sample["stature_m"]), bare_rows(covers), {}, noise, folds, hidden)


def judged(samples: Sequence[Mapping[str, Any]], prior: MeasurePrior) -> tuple[np.ndarray, np.ndarray, list[Estimate]]:
    """Return errors (N, K) mm, standard deviations (N, K) and the estimates."""
    found = [estimate(evidence(sample, prior), prior) for sample in samples]
    errors = np.array([each.mm - sample["naked"] for each, sample in zip(found, samples, strict=True)])
    return errors, np.array([each.deviation_mm for each in found]), found


def make(bodies: Sequence[Mapping[str, Any]], fits: Sequence[Mapping[str, Any]], folds: int = 5) -> MeasurePrior:
    """Return the whole table; tempering, odds and spread come from people judged by a table made without them."""
    groups = (np.arange(len(fits)) // len(FITS)) % folds
    parts = [
        table(bodies, [sample for sample, group in zip(fits, groups, strict=True) if group != fold])
        for fold in range(folds)
    ]
    pairs = [(sample, parts[group]) for sample, group in zip(fits, groups, strict=True)]
    found = [hypotheses(evidence(sample, part), part) for sample, part in pairs]
    temper, log_odds = odds(found, [int(sample["tightness"]) for sample in fits])
    ratios = []
    for sample, judge in pairs:
        part = replace(judge, temper=temper, log_odds=log_odds)
        each = estimate(evidence(sample, part), part)
        ratios.append(np.abs(each.mm - sample["naked"]) / each.deviation_mm)
    own, common = np.quantile(ratios, COVER, axis=0), np.quantile(ratios, COVER)
    spread = (len(fits) * own + 20.0 * common) / (len(fits) + 20.0)  # few people: lean on what all have in common
    return replace(table(bodies, fits), temper=temper, log_odds=log_odds, spread=spread)


def told(samples: Sequence[Mapping[str, Any]], prior: MeasurePrior) -> None:
    """Print bias, median error, coverage and median ± of every measure, and how often the fit was recognised."""
    errors, deviations, found = judged(samples, prior)
    half = deviations * prior.spread
    shown = np.array([s["shown"] - s["naked"] for s in samples])
    fits = np.array([int(s["tightness"]) for s in samples])
    print(f"{len(samples)} people; mm: mean and median error under clothes, of the outline; ± and its coverage")
    for k, key in enumerate(ALL_KEYS):
        if "slice" in key:
            continue
        by = " ".join(f"{np.median(np.abs(errors[fits == f, k])):4.0f}" for f in range(3))
        print(
            f"{key:24} {errors[:, k].mean():+6.1f} {np.median(np.abs(errors[:, k])):5.1f}  ({by})  "
            f"outline {np.median(np.abs(shown[:, k])):5.1f}   ± {np.median(half[:, k]):5.1f}  "
            f"{100 * np.mean(np.abs(errors[:, k]) <= half[:, k]):4.0f} %"
        )
    keys = [k for k, key in enumerate(ALL_KEYS) if "slice" not in key]
    print(f"coverage of all: {100 * np.mean(np.abs(errors[:, keys]) <= half[:, keys]):.1f} %")
    right = [np.mean([np.argmax(e.upper_fit) == f for e, f in zip(found, fits, strict=True)])]
    right += [np.mean([np.argmax(e.lower_fit) == f for e, f in zip(found, fits, strict=True)])]
    print(f"fit recognised: above {100 * right[0]:.0f} %, below {100 * right[1]:.0f} %")


def runs(seeds: Sequence[str]) -> list[str]:
    """Return seeds as "first-last" of those that follow each other."""
    numbers = np.array(sorted(map(int, seeds)))
    parts = np.split(numbers, np.flatnonzero(np.diff(numbers) > 1) + 1)
    return [f"{part[0]}-{part[-1]}" for part in parts]


def write(prior: MeasurePrior, folder: Path) -> None:
    """Write the table and how it was made."""
    arrays = {name: getattr(prior, name) for name in prior.__slots__}
    small = {name: np.asarray(a, np.float32) if np.asarray(a).dtype == np.float64 else a for name, a in arrays.items()}
    small["spread"] = np.round(small["spread"], 3)
    seeds = {kind: [path.stem for path in sorted((folder / kind).glob("*.npz"))] for kind in ("ease", "fits")}
    made = {
        "by": "benchmarks/measure_table.py",
        "bodies dressed without photos": {"count": len(seeds["ease"]), "seeds": runs(seeds["ease"])},
        "people photographed and cloned": {"count": len(seeds["fits"]), "seeds": runs(seeds["fits"])},
        "people": "random members of the generic family (generic_models/build/painted_people.py); nobody real",
        "licence": "CC0-1.0",
    }
    np.savez_compressed(MODELS / FILE, keys=np.array(ALL_KEYS), made=json.dumps(made), **small)
    print(
        json.dumps(made, indent=1), prior.temper, prior.log_odds, f"\n{(MODELS / FILE).stat().st_size / 1024:.0f} KiB"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("samples", type=Path)
    parser.add_argument("--check", action="store_true")
    chosen = parser.parse_args()
    if chosen.check:
        told(read(chosen.samples / "checks"), load_measure_prior())
    else:
        prior = make(read(chosen.samples / "ease"), read(chosen.samples / "fits"))
        write(prior, chosen.samples)
        told(read(chosen.samples / "fits"), prior)


if __name__ == "__main__":
    main()
