"""Draw random people: weights of hm08's macro and local targets, and the bodies they make."""

from __future__ import annotations

from itertools import product

import numpy as np
from source import FloatArray, Source

ADULTS = 1500  # sample size; the basis is stable to < 1 % above about 1000 (measured by halves)
CHILDREN = 150

# A symmetric local target pair: (negative, positive, reach). "{s}" stands for l and r.
BODY_PAIRS: tuple[tuple[str, str, float], ...] = (
    ("torso/torso-scale-depth-decr", "torso/torso-scale-depth-incr", 0.5),
    ("torso/torso-scale-horiz-decr", "torso/torso-scale-horiz-incr", 0.5),
    ("torso/torso-scale-vert-decr", "torso/torso-scale-vert-incr", 0.35),
    ("torso/torso-vshape-decr", "torso/torso-vshape-incr", 0.5),
    ("torso/measure-shoulder-dist-decr", "torso/measure-shoulder-dist-incr", 0.35),
    ("torso/measure-waist-circ-decr", "torso/measure-waist-circ-incr", 0.35),
    ("torso/measure-bust-circ-decr", "torso/measure-bust-circ-incr", 0.3),
    ("torso/torso-muscle-dorsi-decr", "torso/torso-muscle-dorsi-incr", 0.4),
    ("torso/torso-muscle-pectoral-decr", "torso/torso-muscle-pectoral-incr", 0.4),
    ("hip/hip-scale-depth-decr", "hip/hip-scale-depth-incr", 0.5),
    ("hip/hip-scale-horiz-decr", "hip/hip-scale-horiz-incr", 0.5),
    ("hip/hip-scale-vert-decr", "hip/hip-scale-vert-incr", 0.35),
    ("hip/hip-waist-down", "hip/hip-waist-up", 0.4),
    ("stomach/stomach-tone-decr", "stomach/stomach-tone-incr", 0.7),
    ("stomach/stomach-pregnant-decr", "stomach/stomach-pregnant-incr", 0.25),
    ("buttocks/buttocks-volume-decr", "buttocks/buttocks-volume-incr", 0.6),
    ("legs/{s}-upperleg-scale-depth-decr", "legs/{s}-upperleg-scale-depth-incr", 0.3),
    ("legs/{s}-upperleg-scale-horiz-decr", "legs/{s}-upperleg-scale-horiz-incr", 0.3),
    ("legs/{s}-upperleg-fat-decr", "legs/{s}-upperleg-fat-incr", 0.6),
    ("legs/{s}-upperleg-muscle-decr", "legs/{s}-upperleg-muscle-incr", 0.5),
    ("legs/{s}-lowerleg-scale-depth-decr", "legs/{s}-lowerleg-scale-depth-incr", 0.3),
    ("legs/{s}-lowerleg-scale-horiz-decr", "legs/{s}-lowerleg-scale-horiz-incr", 0.3),
    ("legs/{s}-lowerleg-fat-decr", "legs/{s}-lowerleg-fat-incr", 0.6),
    ("legs/{s}-lowerleg-muscle-decr", "legs/{s}-lowerleg-muscle-incr", 0.5),
    ("legs/{s}-leg-valgus-decr", "legs/{s}-leg-valgus-incr", 0.2),
    ("legs/upperlegs-height-decr", "legs/upperlegs-height-incr", 0.25),
    ("legs/lowerlegs-height-decr", "legs/lowerlegs-height-incr", 0.25),
    ("arms/{s}-upperarm-scale-depth-decr", "arms/{s}-upperarm-scale-depth-incr", 0.4),
    ("arms/{s}-upperarm-scale-horiz-decr", "arms/{s}-upperarm-scale-horiz-incr", 0.3),
    ("arms/{s}-upperarm-scale-vert-decr", "arms/{s}-upperarm-scale-vert-incr", 0.25),
    ("arms/{s}-upperarm-fat-decr", "arms/{s}-upperarm-fat-incr", 0.5),
    ("arms/{s}-upperarm-muscle-decr", "arms/{s}-upperarm-muscle-incr", 0.5),
    ("arms/{s}-upperarm-shoulder-muscle-decr", "arms/{s}-upperarm-shoulder-muscle-incr", 0.5),
    ("arms/{s}-lowerarm-scale-depth-decr", "arms/{s}-lowerarm-scale-depth-incr", 0.4),
    ("arms/{s}-lowerarm-scale-horiz-decr", "arms/{s}-lowerarm-scale-horiz-incr", 0.3),
    ("arms/{s}-lowerarm-scale-vert-decr", "arms/{s}-lowerarm-scale-vert-incr", 0.25),
    ("arms/{s}-lowerarm-fat-decr", "arms/{s}-lowerarm-fat-incr", 0.5),
    ("arms/measure-upperarm-length-decr", "arms/measure-upperarm-length-incr", 0.2),
    ("arms/measure-lowerarm-length-decr", "arms/measure-lowerarm-length-incr", 0.2),
    ("neck/neck-scale-depth-decr", "neck/neck-scale-depth-incr", 0.5),
    ("neck/neck-scale-horiz-decr", "neck/neck-scale-horiz-incr", 0.5),
    ("neck/neck-scale-vert-decr", "neck/neck-scale-vert-incr", 0.5),
    ("neck/neck-trans-backward", "neck/neck-trans-forward", 0.4),
)

RACES = ("african", "asian", "caucasian")
PHENOTYPE_NAMES = (
    "sex",
    "age_years",
    "muscle",
    "weight",
    "height",
    "proportions",
    "cup_size",
    "firmness",
    *RACES,
)


def draw_phenotypes(count: int, youngest: float, oldest: float, *, rng: np.random.Generator) -> FloatArray:
    """Return random phenotypes, (count, 11) in the order of PHENOTYPE_NAMES; sex 0 female, 1 male, others 0..1."""

    def bell(centre: float, spread: float) -> FloatArray:
        return np.clip(rng.normal(centre, spread, count), 0.0, 1.0)

    columns = [
        rng.beta(0.35, 0.35, count),
        rng.uniform(youngest, oldest, count),
        bell(0.5, 0.22),
        bell(0.5, 0.22),
        bell(0.5, 0.13),  # narrower: hm08's height axis reaches from dwarfs to giants
        bell(0.6, 0.25),
        bell(0.5, 0.22),
        bell(0.5, 0.22),
    ]
    return np.column_stack([*columns, rng.dirichlet((0.6, 0.6, 0.6), count)])


def _hats(value: FloatArray, knots: tuple[float, ...]) -> FloatArray:
    """Return the piecewise-linear hat weights of each value over the knots, (count, knots)."""
    return np.column_stack([np.interp(value, knots, row) for row in np.eye(len(knots))])


def macro_weights(phenotypes: FloatArray, source: Source) -> tuple[list[str], FloatArray]:
    """Return macro target names and each person's weights on them.

    Notes
    -----
    MakeHuman interpolates every axis linearly between its named ends and multiplies the axis weights that a target's
    file name lists. Age is a fraction: 1 year 0, 10 years 0.1875, 25 years 0.5, 90 years 1.
    """
    age = np.interp(phenotypes[:, 1], (1.0, 25.0, 90.0), (0.0, 0.5, 1.0))
    halves = (0.0, 0.5, 1.0)
    axes = {
        "gender": (("female", "male"), _hats(phenotypes[:, 0], (0.0, 1.0))),
        "age": (("baby", "child", "young", "old"), _hats(age, (0.0, 0.1875, 0.5, 1.0))),
        "muscle": (("minmuscle", "averagemuscle", "maxmuscle"), _hats(phenotypes[:, 2], halves)),
        "weight": (("minweight", "averageweight", "maxweight"), _hats(phenotypes[:, 3], halves)),
        "height": (("minheight", "", "maxheight"), _hats(phenotypes[:, 4], halves)),
        "proportions": (("uncommonproportions", "", "idealproportions"), _hats(phenotypes[:, 5], halves)),
        "cup": (("mincup", "averagecup", "maxcup"), _hats(phenotypes[:, 6], halves)),
        "firmness": (("minfirmness", "averagefirmness", "maxfirmness"), _hats(phenotypes[:, 7], halves)),
        "race": (RACES, phenotypes[:, 8:11]),
    }
    body = ("gender", "age", "muscle", "weight")
    families = (
        ("macrodetails/", ("race", "gender", "age")),
        ("macrodetails/universal-", body),
        ("macrodetails/height/", (*body, "height")),
        ("macrodetails/proportions/", (*body, "proportions")),
        ("breast/", (*body, "cup", "firmness")),
    )
    names: list[str] = []
    weights: list[FloatArray] = []
    for start, factors in families:
        for choice in product(*(range(len(axes[f][0])) for f in factors)):
            words = [axes[f][0][i] for f, i in zip(factors, choice, strict=True)]
            name = start + "-".join(words)
            if "" in words or not source.has(f"mpfb2/targets/{name}.target.gz"):
                continue  # the average of an axis, babies' proportions and men's cups have no target
            weight = np.prod([axes[f][1][:, i] for f, i in zip(factors, choice, strict=True)], axis=0)
            if weight.max() > 0.0:
                names.append(name)
                weights.append(weight)
    return names, np.column_stack(weights)


def pair_weights(
    pairs: tuple[tuple[str, str, float], ...], count: int, *, rng: np.random.Generator, asymmetry: float
) -> tuple[list[str], FloatArray]:
    """Return local target names and random weights, uniform in +-reach; sides differ by a share ``asymmetry``."""
    names: list[str] = []
    weights: list[FloatArray] = []
    for negative, positive, reach in pairs:
        value = rng.uniform(-reach, reach, count)
        sides = ("l", "r") if "{s}" in positive else ("",)
        for side in sides:
            own = value + asymmetry * rng.uniform(-reach, reach, count)
            for name, part in ((negative, -own), (positive, own)):
                if name:
                    names.append(name.replace("{s}", side))
                    weights.append(np.clip(part, 0.0, None))
    return names, np.column_stack(weights)


def blend(source: Source, names: list[str], weights: FloatArray, rows: np.ndarray) -> FloatArray:
    """Return weighted sums of targets restricted to some full vertices, (people, rows * 3), metres."""
    total = np.zeros((weights.shape[0], rows.size * 3), dtype=np.float32)
    for first in range(0, len(names), 64):
        chunk = names[first : first + 64]
        stack = np.stack([source.mpfb_target(n)[rows].ravel() for n in chunk]).astype(np.float32)
        total += weights[:, first : first + 64].astype(np.float32) @ stack
    return total
