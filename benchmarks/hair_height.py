"""How far hair stands above the skull, beside what the face beneath it tells.

``python benchmarks/hair_height.py PEOPLE``. PEOPLE holds people of the generator (``make_people.py``, five views) that
judge nothing else. Everybody is outlined by the product; the truth is the naked body's crown and the true labels' top
in the three body photos. Prints the numbers of ``cloner/calibration/body.toml``, ``[hair_height.*]``.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from cloner.body.hair_height import height_above_eyes
from cloner.errors import ClonerError
from cloner.evaluate.truths.kit import KitTruth, kit_people, read_kit
from cloner.frames import ViewId, mm_from_m
from cloner.generic.load import load_generic
from cloner.testing import folder_values, run_stages

STAGES = ("proposals", "points", "views", "silhouettes")
#: Residuals beyond so many spreads hardly bend the line: a hat has no hair's height.
DOUBTED = 2.0


def true_height_mm(kit: KitTruth) -> float:
    """Return how far hair or headwear truly is above the skull, the mean of the body photos, mm."""
    crown, heights = load_generic().feature("head_top"), []
    for view in (ViewId.BODY_FRONT, ViewId.BODY_SIDE, ViewId.BODY_BACK):
        camera, point = kit.truth.views[view].camera, kit.bodies_m[view][crown]
        top_px = np.flatnonzero((kit.labels[view] > 0).any(axis=1))[0] - 0.5
        heights.append((camera.project(point[None])[0, 1] - top_px) * camera.metres_per_pixel(point))
    return mm_from_m(float(np.mean(heights)))


def told(person: Path) -> float | None:
    """Return what the face tells of one person, None where no face is seen or the photos are refused."""
    try:
        values, _ = run_stages(folder_values(person), STAGES)
    except ClonerError as error:
        print(f"{person.name}: {error}")
        return None
    seen, outline = (values[name].views.get(ViewId.BODY_FRONT) for name in ("proposals", "silhouettes"))
    if seen is None or outline is None or seen.face_presence == 0.0:
        return None
    return height_above_eyes(seen.face_px, outline.top_px)


def line(shares: NDArray[np.float64], heights_mm: NDArray[np.float64]) -> tuple[float, float, float]:
    """Return slope, height at no share, and spread, mm, of the robust line through people (N,) and (N,)."""
    design, weight, spread = np.column_stack([shares, np.ones(len(shares))]), np.ones(len(shares)), 0.0
    slope = np.zeros(2)
    for _ in range(20):
        root = np.sqrt(weight)
        slope = np.linalg.lstsq(design * root[:, None], heights_mm * root, rcond=None)[0]
        away = heights_mm - design @ slope
        spread = 1.48 * float(np.median(np.abs(away)))
        weight = 1.0 / (1.0 + (away / (DOUBTED * spread)) ** 2)
    return float(slope[0]), float(slope[1]), float(np.std(away))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("people", type=Path, nargs="+")
    parser.add_argument("--every", type=int, default=1, help="of so many people one")
    chosen = parser.parse_args()
    found = [
        (share, true_height_mm(read_kit(person)))
        for person in kit_people(chosen.people)[:: chosen.every]
        if (share := told(person)) is not None
    ]
    shares, heights = np.array(found).T
    slope, start, spread = line(shares, heights)
    print(f"{len(found)} people: {heights.mean():.1f} mm, spread {heights.std():.1f}, median {np.median(heights):.1f}")
    print(f"face_mm {slope:.1f}  bare_mm {-start:.1f}  leaving {spread:.1f} mm")


if __name__ == "__main__":
    main()
