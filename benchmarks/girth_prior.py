"""Girths of random generic bodies, and how the fit errs on naked ones: the tables of cloner/generic/girth_prior.py.

``python benchmarks/girth_prior.py`` prints mean and covariance a sex (two minutes);
``python benchmarks/girth_prior.py --fit 16`` photographs that many naked bodies of the generic family, fits them
and prints the relative error of every girth (half a minute a body). No sample visitor takes part.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np

from cloner import pipeline
from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measures import GIRTH_NAMES, girths_mm
from cloner.records.photos import Person

BODIES = 300  # a girth is nearly linear in the shape: enough for a plane in 36 dimensions
DRAWS = 40_000
STATURE_M = 1.70
SEX = 0  # row of the phenotype that tells women (0) from men (1)


def prior(rng: np.random.Generator) -> None:
    """Print mean and standard deviation (thousandths of the stature) and correlation of the girths a sex."""
    generic, rules = load_generic(), load_tape_rules()
    count = len(generic.shape_basis)
    shapes = rng.normal(size=(BODIES, count))
    girths = np.array([list(girths_mm(*generic.shape(c, STATURE_M), rules).values()) for c in shapes]) / STATURE_M
    plane, *_ = np.linalg.lstsq(np.c_[np.ones(BODIES), shapes], girths, rcond=None)
    bend = np.cov((girths - np.c_[np.ones(BODIES), shapes] @ plane).T)
    shapes = rng.normal(size=(DRAWS, count))
    girths = np.c_[np.ones(DRAWS), shapes] @ plane + rng.multivariate_normal(np.zeros(len(bend)), bend, DRAWS)
    men = (generic.phenotype_mean + shapes @ generic.phenotype_from_shape.T)[:, SEX] > 0.5
    for name, chosen in (("women", ~men), ("men", men)):
        print(name)
        print("  mean", np.round(girths[chosen].mean(axis=0), 1).tolist())
        print("  deviation", np.round(girths[chosen].std(axis=0), 1).tolist())
        for row in np.round(np.corrcoef(girths[chosen].T), 2).tolist():
            print("   ", row)


def fit(bodies: int) -> None:
    """Print the relative error of each girth over naked bodies photographed in re-posed stances."""
    sys.path[:0] = [str(Path(__file__).resolve().parents[1] / folder) for folder in ("tests", "tests/stages")]
    from test_stature import BODY_STAGES, photograph

    from kit import people

    stages = tuple(stage for stage in pipeline.STAGES if stage.name in BODY_STAGES)
    errors = []
    for seed in range(200, 200 + bodies):
        person = people.known_person(seed, stature_m=STATURE_M, coefficients=len(load_generic().shape_basis))
        values = {**photograph(person, 100 * seed), "person": Person("known", "", STATURE_M)}
        body = pipeline.run(values, stages=stages)[0]["bodies"].consensus
        true, found = (
            np.array(list(girths_mm(shape.vertices_m, shape.joints_m, load_tape_rules()).values()))
            for shape in (person, body)
        )
        errors.append(found / true - 1.0)
        print(seed, np.round(found - true).astype(int).tolist(), "mm", flush=True)
    for name, values in zip(GIRTH_NAMES, np.array(errors).T, strict=True):
        print(f"{name:10} bias {values.mean():+.3f}  deviation {values.std(ddof=1):.3f}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--fit", type=int, default=0, metavar="BODIES")
    chosen = parser.parse_args()
    if chosen.fit:
        fit(chosen.fit)
    else:
        prior(np.random.default_rng(0))


if __name__ == "__main__":
    main()
