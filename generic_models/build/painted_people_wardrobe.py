"""What random people wear: cuts, fits and colours."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray
from painted_people_bodies import waves

Array = NDArray[np.float64]
Tightness = Literal["tight", "regular", "loose"]

TIGHTNESSES: Final[tuple[Tightness, ...]] = ("tight", "regular", "loose")
#: Ease of shirt and trousers where they are widest, metres (issue 4: tight ~3 mm, regular 8-15, loose 20-35).
EASE_M: Final = {"tight": (0.002, 0.004), "regular": (0.008, 0.015), "loose": (0.020, 0.035)}
#: Rounds of smoothing: how far a cloth bridges hollows.
SMOOTHING: Final = {"tight": 6, "regular": 25, "loose": 60}
#: Greatest folds, metres.
FOLDS_M: Final = {"tight": 0.0004, "regular": 0.0018, "loose": 0.0040}
SOLE_M: Final = (0.015, 0.030)
SHOE_M: Final = 0.005  # thickness of a shoe's upper
#: Over what length a hem falls from cloth to skin, metres: about an edge of the fine mesh.
HEM_M: Final = 0.006
PATTERNS: Final = ("plain", "plain", "plain", "stripes", "checks", "print")
SKIN, CLOTH, HAIR, SHOE, ORGAN = range(5)  # kinds of vertices


@dataclass(frozen=True, slots=True)
class Wardrobe:
    """What a person wears; lengths in metres.

    Attributes
    ----------
    tightness : "tight", "regular" or "loose"
    shirt_m, trousers_m : float
        Ease where they are widest.
    sleeve, leg : float
        Where they end, 0 shoulder or hip, 1 wrist or ankle.
    sole_m : float
    hair : "short", "long" or "bald"
    hair_m : float
        Height of the hair above the scalp.
    alike : float
        How near the trousers' colour is to the shirt's, 0 any to 1 the same.
    """

    tightness: Tightness
    shirt_m: float
    trousers_m: float
    sleeve: float
    leg: float
    sole_m: float
    hair: str
    hair_m: float
    alike: float


def random_wardrobe(tightness: Tightness, rng: np.random.Generator, *, alike: float = 0.0) -> Wardrobe:
    """Return random clothes of a tightness; ``alike`` draws trousers and shirt together in colour."""
    ease = rng.uniform(*EASE_M[tightness], 2)
    sleeve = rng.choice([rng.uniform(0.28, 0.42), rng.uniform(0.88, 0.98)])
    leg = rng.uniform(0.97, 1.02) if rng.random() < 0.85 else rng.uniform(0.42, 0.55)
    hair = str(rng.choice(["short", "long", "bald"], p=[0.62, 0.30, 0.08]))
    hair_m = float(rng.uniform(0.004, 0.025)) if hair != "bald" else 0.0
    sole = float(rng.uniform(*SOLE_M))
    shirt, trousers = float(ease[0]), float(ease[1])
    return Wardrobe(tightness, shirt, trousers, float(sleeve), float(leg), sole, hair, hair_m, alike)


def random_colour(rng: np.random.Generator) -> Array:
    """Return an sRGB colour 0..1 as clothes have: mostly greyish."""
    return np.asarray(np.clip(rng.uniform(0.06, 0.90) + rng.choice([0.05, 0.15]) * rng.normal(size=3), 0.03, 0.95))


def cloth_colours(points_m: Array, base: Array, rng: np.random.Generator, *, patterns: tuple[str, ...]) -> Array:
    """Return (N, 3) colours of one cloth: a colour with wear, and perhaps stripes, checks or a print."""
    shade = 1.0 + 0.02 * waves(points_m, (0.015, 0.05), 10, rng) + 0.05 * waves(points_m, (0.1, 0.4), 8, rng)
    other = np.clip(base + rng.choice([-1.0, 1.0]) * rng.uniform(0.12, 0.4), 0.03, 0.97)
    width = rng.uniform(0.02, 0.06)
    rows, columns = (np.tanh(3.0 * np.sin(points_m[:, axis] / width * np.pi)) for axis in (1, 0))
    spot = rng.uniform(0.05, 0.1) - np.hypot(points_m[:, 0], points_m[:, 1] - np.quantile(points_m[:, 1], 0.7))
    share = {
        "plain": np.zeros(len(points_m)),
        "stripes": 0.5 + 0.5 * rows,
        "checks": 0.5 + 0.5 * rows * columns,
        "print": np.clip(0.5 + spot / HEM_M, 0.0, 1.0) * (points_m[:, 2] > 0.0),
    }[str(rng.choice(patterns))]
    return np.asarray((base + share[:, None] * (other - base)) * shade[:, None])
