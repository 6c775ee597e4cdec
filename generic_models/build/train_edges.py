"""Teach which edges part a person from the room: ``python generic_models/build/train_edges.py PEOPLE``.

PEOPLE holds people of the kit with labels, none of whom may judge afterwards.  Prints
``cloner.vision.parting.WEIGHTS``: a logistic regression on the edge segments near the outline of each photo's mask,
once as the nets gave it and once disturbed by up to a fiftieth of the figure, so that no mask is believed more than it
deserves.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray
from PIL import Image
from scipy.spatial import cKDTree

from cloner import pipeline
from cloner.project.corrections import no_corrections
from cloner.project.folder import load_photos
from cloner.vision.band import LinkParams, find_segments
from cloner.vision.loops import figure_height, mask_loops
from cloner.vision.outlines import smoothed
from cloner.vision.seen_edges import see_edges

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))
from linking_masks import DISTURBED, disturb

#: An edge this near to the true outline, and this parallel to it, is the outline's, px and cosine.
NEAR_PX, PARALLEL = 1.5, 0.5
RIDGE = 1.0
TURNS = 15

Floats = NDArray[np.float64]


def rows_of(
    rgb: NDArray[np.uint8], mask: NDArray[np.float32], truth: NDArray[np.bool_]
) -> tuple[Floats, Floats, Floats]:
    """Return features (S, 7), share of each segment on the true outline (S,) and its number of points (S,)."""
    params, height = LinkParams(), figure_height(mask)
    soft = smoothed(mask, height, params)
    loops = mask_loops(soft, height_px=height)
    seen = see_edges(
        rgb,
        soft,
        np.concatenate([loop.points for loop in loops]),
        height_px=height,
        reach_px=params.band * height,
        margin_px=params.margin * height,
    )
    found = find_segments(seen, loops, height_px=height, params=params)
    true = mask_loops(cv2.GaussianBlur(truth.astype(np.float32), (0, 0), 1.0), height_px=height)
    towards = np.concatenate([loop.inward for loop in true])
    away, nearest = cKDTree(np.concatenate([loop.points for loop in true])).query(found.points)
    right = (away < NEAR_PX) & ((found.inward * towards[nearest]).sum(axis=1) > PARALLEL)
    count = np.diff(found.first)
    return found.features, np.add.reduceat(right.astype(np.float64), found.first[:-1]) / count, count.astype(np.float64)


def regress(features: Floats, right: Floats, weight: Floats) -> Floats:
    """Return the weights of a logistic regression, by Newton's steps."""
    solution = np.zeros(features.shape[1])
    for _ in range(TURNS):
        chance = 1.0 / (1.0 + np.exp(-np.clip(features @ solution, -30.0, 30.0)))
        doubt = weight * np.maximum(chance * (1.0 - chance), 1e-6)
        curvature = (features * doubt[:, None]).T @ features + RIDGE * np.eye(len(solution))
        slope = features.T @ (weight * (right - chance)) - RIDGE * solution
        solution += np.linalg.solve(curvature, slope)
    return solution


def main() -> None:
    """Teach and print."""
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("people", type=Path)
    rng, taught = np.random.default_rng(0), []
    stages = tuple(stage for stage in pipeline.STAGES if stage.name == "proposals")
    for number, person in enumerate(sorted(asked.parse_args().people.glob("p*"))):
        photos = load_photos(person)
        values, _ = pipeline.run({"photos": photos, "corrections": no_corrections()}, stages=stages)
        for view, proposal in values["proposals"].views.items():  # type: ignore[attr-defined]
            truth = np.asarray(Image.open(person / f"{view}_labels.png")) > 0
            mask = proposal.mask.astype(np.float32) / np.float32(255.0)
            kind = DISTURBED[(number + len(taught)) % len(DISTURBED)]
            taught += [rows_of(photos.photos[view].rgb, each, truth) for each in (mask, disturb(mask, kind, rng))]
    print(tuple(float(value) for value in regress(*map(np.concatenate, zip(*taught, strict=True))).round(2)))  # type: ignore[arg-type]


if __name__ == "__main__":
    main()
