"""Write ``cloner_models/measures.npz`` from the samples of ``benchmarks/measure_samples.py``.

``python benchmarks/measure_table.py SAMPLES`` learns the table from SAMPLES/people, SAMPLES/painted and SAMPLES/bodies;
without bodies the family's own numbers stay as they are. Nobody of the generator wears tight clothes, and its cloth has
no folds at the outline: what tight clothes add and rumples stay too, learned from painted people and kept in the file.
What is seen under clothes is learned from both, as the label net, which knows the generator's people alone, sees
too slim a body under tight clothes. ``--check`` writes nothing: it prints the errors on the people, each judged by a
table made without them. No sample visitor takes part.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from cloner.generic.load import load_generic
from cloner.generic.measure_prior import FILE, load_measure_prior
from cloner.geometry.measurement.measuring import ALL_KEYS, LOOSE_KEYS, bare_rows
from cloner.geometry.measurement.prior import LOWER, UPPER, MeasurePrior
from cloner.geometry.measurement.under_clothes import NINE_IN_TEN, OutlineMeasures, estimate_body
from cloner.records.measures import FITS, Cover

#: People as ``measure_samples.py`` keeps them; means and covariances of a family.
Samples = Sequence[Mapping[str, Any]]
Bodies = tuple[np.ndarray, np.ndarray]
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
#: What a skirt or a coat around the legs hides, (K,).
UNDER_SKIRTS = np.array([key in LOOSE_KEYS for key in ALL_KEYS])
#: Girths that tell how loosely a person is dressed above and below the waist.
TELLING = (
    ("bust_girth", "underbust_girth", "narrowest_waist_girth", "waist_girth", "navel_girth"),
    ("thigh_girth", "knee_girth", "calf_girth"),
)
#: Largest believed relative error of a clone where nothing is worn; a clone that failed is a warning's business.
LARGEST = 0.15
#: Floors: relative error of the fit, and spread of what clothes of one fit add, mm.
FLOOR, LEAST_MM = 0.003, 6.0
#: Shrinkage of correlations towards none, and how many people's worth all fits together count in one
#: fit's mean. Of shrinkages .2 and .5 the first errs by .4 mm less on people left out.
SHRINK, LEAN = 0.2, 3.0
#: Places in `FITS` that the generator's clothes take, by the smallest and largest girths they add, and how often tight
#: clothes, which it lacks, are worn (judgement).
TIGHT, REGULAR, LOOSE = 0, 1, 2
WEAR_TIGHT = 0.15
#: A fit of clothes is told by this many people at least before its spread stands for itself.
FEW = 4.0
#: A girth that fewer people show under clothes is not read there.
ENOUGH = 20
#: Share of the people left out that lie within the +-; nine in ten are promised of others.
COVER = 0.92
FOLDS = 5


def read(folder: Path) -> list[dict[str, Any]]:
    """Return all samples of a folder in the order of their names."""
    return [dict(np.load(path)) for path in sorted(folder.glob("*.npz"))]


def garments() -> np.ndarray:
    """Return which garment makes each measure."""
    codes = []
    for key in ALL_KEYS:
        above = key.startswith(ABOVE) or (key.startswith("trunk_slice") and key not in BOTH)
        codes.append(0 if key.startswith(FREE) else UPPER | LOWER if key in BOTH else UPPER if above else LOWER)
    return np.array(codes)


def family(samples: Samples, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
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


def covers_of(sample: Mapping[str, Any]) -> dict[str, Cover]:
    """Return what cloth covers by segment."""
    names = [name for name in sample if name.startswith("cover_")]
    return {name[6:]: Cover(tuple(None if s < 0 else bool(s) for s in sample[name]), 1.0) for name in names}


def fits_of(people: Samples) -> np.ndarray:
    """Return (N, 2) the place in `FITS` of what each person wears above and below: two means of what clothes add."""
    found = []
    for telling in TELLING:
        rows = [ALL_KEYS.index(key) for key in telling]
        added = np.array([((one["shown"] - one["naked"]) / one["naked"])[rows].mean() for one in people])
        middles = np.quantile(added, [0.25, 0.75])
        for _ in range(50):
            nearest = np.abs(added[:, None] - middles).argmin(axis=1)
            middles = np.array([added[nearest == which].mean() for which in range(2)])
        found.append(nearest + REGULAR)
    return np.array(found).T


def fit_error(errors: np.ndarray, told: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return bias (K,) and covariance (K, K) of the clone's relative errors (N, K) where nothing is worn (N, K)."""
    bias, variance = np.zeros(errors.shape[1]), np.full(errors.shape[1], 0.02**2)
    for key in np.flatnonzero(told.sum(axis=0) >= 2.0 * FEW):
        own = np.clip(errors[told[:, key], key], -LARGEST, LARGEST)
        bias[key] = np.median(own)
        variance[key] = max(float(np.mean((own - bias[key]) ** 2)), FLOOR**2)
    return bias, np.diag(variance)


def alike(products: np.ndarray) -> np.ndarray:
    """Return (K, K) correlations from covariances, shrunk and clean: pairs may be seen on different people."""
    spread = np.sqrt(np.diag(products))
    found = products / np.maximum(np.outer(spread, spread), 1e-9)
    values, vectors = np.linalg.eigh((1.0 - SHRINK) * found + SHRINK * np.eye(len(found)))
    found = (vectors * np.maximum(values, 0.02)) @ vectors.T
    return np.asarray(found / np.sqrt(np.outer(np.diag(found), np.diag(found))))


def ease(added: np.ndarray, worn: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return what clothes of each fit add, (F, K) mm, and its covariances, from (N, K) mm and fits (N, K), -1 none."""
    count = added.shape[1]
    mean, covariance = np.zeros((len(FITS), count)), np.zeros((len(FITS), count, count))
    clothed = worn >= 0
    common = np.where(clothed, added, 0.0).sum(axis=0) / np.maximum(clothed.sum(axis=0), 1)
    usual = np.where(clothed, (added - common) ** 2, 0.0).sum(axis=0) / np.maximum(clothed.sum(axis=0), 1)
    for fit in (REGULAR, LOOSE):
        own = worn == fit
        mean[fit] = (np.where(own, added, 0.0).sum(axis=0) + LEAN * common) / (own.sum(axis=0) + LEAN)
        rest = np.where(own, added - mean[fit], 0.0)
        products = rest.T @ rest / (own.T.astype(float) @ own + FEW)
        spread = np.sqrt(np.diag(products))
        spread = np.maximum(np.where(spread > 0.0, spread, np.sqrt(usual)), LEAST_MM)
        covariance[fit] = np.outer(spread, spread) * alike(products)
    changed = (garments() > 0).astype(float)
    return mean * changed, covariance * np.outer(changed, changed)


def painted() -> dict[str, np.ndarray]:
    """Return what tight clothes add to painted people, and how the fit erred there, as it was learned."""
    with np.load(MODELS / FILE) as archive:
        if "painted_ease_mm" in archive:
            return {name: archive[name] for name in archive.files if name.startswith("painted_")}
        return {  # the last table that was learned from painted people alone
            "painted_ease_mm": archive["ease_mm"][TIGHT],
            "painted_ease_covariance": archive["ease_covariances"][TIGHT],
            "painted_fit_bias": archive["fit_bias"],
            "painted_fit_covariance": archive["fit_covariance"],
        }


def tight(naked: np.ndarray, bias: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return what tight clothes add to painted people, (K,) mm, and its covariance, for bodies (N, K) mm.

    There the fit's errors were told apart from what clothes add; under clothes this table counts both as one.
    """
    own, usual, changed = painted(), naked.mean(axis=0), (garments() > 0).astype(float)
    mean = own["painted_ease_mm"] + changed * (own["painted_fit_bias"] - bias) * usual
    erred = own["painted_fit_covariance"] * np.outer(changed * usual, changed * usual)
    return mean, own["painted_ease_covariance"] + erred


def seen_under(people: Samples) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return shift (K,), gain (K,) and the rest's covariance (K, K) of girths seen under clothes, over stature.

    Bare skin does not count; a girth that fewer than `ENOUGH` show has no gain.
    """
    stature = np.array([one["stature_m"] for one in people])[:, None]
    seen, naked = (np.array([one[name] for one in people]) / stature for name in ("under", "naked"))
    told = ~np.isnan(seen) & ~np.array([bare_rows(covers_of(one)) for one in people])
    shift, gain, rest = np.zeros(seen.shape[1]), np.zeros(seen.shape[1]), np.zeros(seen.shape)
    for key in np.flatnonzero(told.sum(axis=0) >= ENOUGH):
        own = told[:, key]
        gain[key], shift[key] = np.polyfit(naked[own, key], seen[own, key], 1)
        rest[own, key] = seen[own, key] - shift[key] - gain[key] * naked[own, key]
    together = told.astype(float).T @ told.astype(float)
    products = rest.T @ rest / np.maximum(together, 1.0)
    spread = np.sqrt(np.diag(products))
    return shift, np.maximum(gain, 0.0), np.outer(spread, spread) * alike(products)


def table(own: Bodies, people: Samples, in_tight: Samples) -> MeasurePrior:
    """Return the table of a family's means and covariances and of dressed people, without the spread of its errors."""
    garment, fits, before = garments(), fits_of(people), load_measure_prior()
    added = np.array([one["shown"] - one["naked"] for one in people])
    naked = np.array([one["naked"] for one in people])
    bare = np.array([bare_rows(covers_of(one)) for one in people]) | (garment == 0)
    hidden = np.array([bool(one["around_legs"]) for one in people])[:, None] & UNDER_SKIRTS
    bias, covariance = fit_error(added / naked, bare & ~hidden)
    which = np.stack([np.choose(garment, (-1, upper, lower, max(upper, lower))) for upper, lower in fits])
    mean, spread = ease(added - bias * naked, np.where(bare | hidden, -1, which))
    mean[TIGHT], spread[TIGHT] = tight(naked, bias)
    shares = np.array([(1.0 - WEAR_TIGHT) * (fits == fit).mean() for fit in range(len(FITS))])
    shares[TIGHT] = WEAR_TIGHT
    gap = float(np.median([one["gap_mm"] for one in people]))
    under = seen_under([*people, *in_tight])
    flat = (1.0, np.log(shares / shares[0]), np.full(len(ALL_KEYS), NINE_IN_TEN))
    return MeasurePrior(
        *own, mean, spread, bias, covariance, *flat, before.rumple_means, before.rumple_spreads, garment, gap,
        *under,
    )  # fmt: skip


def evidence(sample: Mapping[str, Any], prior: MeasurePrior) -> OutlineMeasures:
    """Return what the product would know of a photographed person."""
    hidden = np.asarray(sample["hidden"], dtype=bool) | (bool(sample["around_legs"]) & UNDER_SKIRTS)
    shown = np.where(hidden, np.nan, sample["shown"])
    noise = max(1.0, float(sample["gap_mm"]) / prior.gap_mm)
    return OutlineMeasures(
        shown, float(sample["stature_m"]), bare_rows(covers_of(sample)), {}, noise, sample["rumple"], sample["under"]
    )


def left_out(own: Bodies, people: Samples, in_tight: Samples) -> tuple[np.ndarray, np.ndarray]:
    """Return errors and deviations (N, K) mm of people judged by tables made without them."""
    errors, deviations = np.zeros((len(people), len(ALL_KEYS))), np.zeros((len(people), len(ALL_KEYS)))
    for fold in range(FOLDS):
        prior = table(own, [one for k, one in enumerate(people) if k % FOLDS != fold], in_tight)
        for k in range(fold, len(people), FOLDS):
            found = estimate_body(evidence(people[k], prior), prior)
            errors[k], deviations[k] = found.mm - people[k]["naked"], found.deviation_mm
    return errors, deviations


def make(own: Bodies, people: Samples, in_tight: Samples) -> MeasurePrior:
    """Return the whole table; its spread comes from people judged by a table made without them."""
    errors, deviations = left_out(own, people, in_tight)
    ratios = np.abs(errors) / deviations
    each, common = np.quantile(ratios, COVER, axis=0), np.quantile(ratios, COVER)
    spread = (len(people) * each + 20.0 * common) / (len(people) + 20.0)  # few people: lean on what all have in common
    return replace(table(own, people, in_tight), spread=spread)


def told(own: Bodies, people: Samples, in_tight: Samples, spread: np.ndarray) -> None:
    """Print bias, mean error, coverage and median +- of every measure of people left out."""
    errors, deviations = left_out(own, people, in_tight)
    half, shown = deviations * spread, np.array([one["shown"] - one["naked"] for one in people])
    print(f"{len(people)} people left out; mm: bias and mean error, of the outline; +- and its coverage")
    for k, key in enumerate(ALL_KEYS):
        if "slice" not in key:
            print(
                f"{key:24} {errors[:, k].mean():+6.1f} {np.abs(errors[:, k]).mean():5.1f}  outline "
                f"{np.abs(shown[:, k]).mean():5.1f}   +- {np.median(half[:, k]):5.1f}  "
                f"{100 * np.mean(np.abs(errors[:, k]) <= half[:, k]):4.0f} %"
            )
    girths = [k for k, key in enumerate(ALL_KEYS) if key.endswith("_girth")]
    inside = 100 * np.mean(np.abs(errors[:, girths]) <= half[:, girths])
    print(f"all girths: mean error {np.abs(errors[:, girths]).mean():.1f} mm, within the +- {inside:.1f} %")


def write(prior: MeasurePrior, names: Sequence[str], bodies: str) -> None:
    """Write the table and how it was made."""
    arrays = {name: getattr(prior, name) for name in prior.__slots__}
    small = {name: np.asarray(a, np.float32) if np.asarray(a).dtype == np.float64 else a for name, a in arrays.items()}
    made = {
        "by": "benchmarks/measure_table.py",
        "bodies": bodies,
        "people photographed and cloned": {"count": len(names), "names": [names[0], names[-1]]},
        "people": "of the generator of labelled people; nobody real",
        "licence": "CC0-1.0",
    }
    np.savez_compressed(MODELS / FILE, keys=np.array(ALL_KEYS), made=json.dumps(made), **small, **painted())
    print(json.dumps(made, indent=1), f"\n{(MODELS / FILE).stat().st_size / 1024:.0f} KiB")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("samples", type=Path)
    parser.add_argument("--check", action="store_true")
    chosen = parser.parse_args()
    shipped = load_measure_prior()
    bodies, people, in_tight = (read(chosen.samples / name) for name in ("bodies", "people", "painted"))
    own = family(bodies, np.random.default_rng(0)) if bodies else (shipped.means, shipped.covariances)
    prior = shipped if chosen.check else make(own, people, in_tight)
    if not chosen.check:
        names = [path.stem for path in sorted((chosen.samples / "people").glob("*.npz"))]
        write(prior, names, f"{len(bodies)} of the generic family" if bodies else "the family's of the table before")
    told(own, people, in_tight, prior.spread)


if __name__ == "__main__":
    main()
