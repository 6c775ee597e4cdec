"""Teach where ears lie: ``python generic_models/build/calibrate_ears.py``.

Random painted people with short hair or none are photographed from the front and the side; a cascade of ridge
regressions learns top, lobe, back and outermost point of their ears from gradient histograms around a rough guess. Goes
to ``cloner_models/ears.npz`` with the error to expect for the spread that several guesses show.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from archives import save
from numpy.typing import NDArray
from painted_faces import Extra, make_sitter, photograph_face
from painted_people_pictures import BACKGROUNDS

from cloner.detectors.ears import FRONT_EARS, SIDE_EARS, EarModel, find_ear, look, prepare
from cloner.frames import ViewId

Array = NDArray[np.float64]
OUT = Path(__file__).resolve().parent.parent / "cloner_models" / "ears.npz"
FIRST_SITTER = 8000
EXTRAS: tuple[tuple[Extra, ...], ...] = ((), (), ("glasses",), ("beard",), (), ("dark_wall",))
SIZE_PX = (540, 720)
STAGES = 3
REPEATS = 6  # guesses a picture and ear
RIDGE = 6.0
#: Errors of the first guess, shares of the eye distance: rules in front, the laid profile at the side.
GUESS = {"front": 0.17, "side": 0.28}
SIZE_SPREAD = 0.08  # of the eye distance's own error, logarithmic
LATER = 0.03  # noise that later stages are taught with, so that they do not believe the first one's own pictures
HELD_OUT = 4  # every so manieth person tells the errors


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """One visible ear in a shrunk picture."""

    seed: int
    rgb: NDArray[np.uint8]
    mask: NDArray[np.uint8]
    points_px: Array
    iod_px: float
    right: bool


def seen_ears(view: str, seed: int, rgb: NDArray[np.uint8], mask: NDArray[np.uint8], hair: NDArray[np.uint8],
              marks: dict[str, Array], iod_px: float) -> list[Seen]:  # fmt: skip
    """Return the ears of a picture that no hair hides."""
    out = []
    for side in "LR":
        names = [f"{name}_{side}" for name in (FRONT_EARS if view == "front" else SIDE_EARS)]
        if any(name not in marks for name in names):
            continue
        points = np.array([marks[name] for name in names])
        column, row = np.clip(np.round(points.mean(axis=0)).astype(int), 0, np.array(hair.shape[::-1]) - 1)
        if hair[row, column] < 128:
            out.append(Seen(seed, rgb, mask, points, iod_px, side == "R"))
    return out


def photographed(count: int) -> dict[str, list[Seen]]:
    """Return the ears of random people by view."""
    out: dict[str, list[Seen]] = {"front": [], "side": []}
    for seed in range(FIRST_SITTER, FIRST_SITTER + count):
        sitter = make_sitter(seed, EXTRAS[seed % 6], hair=("short", "short", "bald")[seed % 3], splits=1)
        for name, view in (("front", ViewId.FACE_FRONT), ("side", ViewId.FACE_SIDE)):
            known = photograph_face(sitter, view, background=BACKGROUNDS[seed % 3], size_px=SIZE_PX)
            mask, hair = (np.where(m, np.uint8(255), np.uint8(0)) for m in (known.mask, known.hair))
            out[name] += seen_ears(name, seed, known.rgb, mask, hair, dict(known.marks_px), known.iod_px)
    return out


def train(ears: list[Seen], names: tuple[str, ...], guess: float, rng: np.random.Generator) -> EarModel:
    """Return a cascade; each stage is taught from where the ones before it arrive."""
    turns = [np.array([-1.0 if ear.right else 1.0, 1.0]) for ear in ears]
    laid = [(e.points_px - e.points_px.mean(axis=0)) * t / e.iod_px for e, t in zip(ears, turns, strict=True)]
    base = np.mean(laid, axis=0)
    pictures = [prepare(ear.rgb, ear.mask, ear.iod_px) for ear in ears]
    rows = np.repeat(np.arange(len(ears)), REPEATS)
    sizes = np.exp(SIZE_SPREAD * rng.normal(size=len(rows)))
    iods = np.array([pictures[k][2] * ears[k].iod_px for k in rows]) / sizes
    goals = [(ears[k].points_px + 0.5) * pictures[k][2] - 0.5 for k in rows]
    middles = np.array([goal.mean(axis=0) for goal in goals]) + guess * iods[:, None] * rng.normal(size=(len(rows), 2))
    means, weights, offsets = [], [], []
    for _ in range(STAGES):
        seen = np.stack(
            [look(*pictures[k][:2], m, iod, ears[k].right) for k, m, iod in zip(rows, middles, iods, strict=True)]
        )
        wanted = np.stack(
            [((g - m) * turns[k] / iod - base).ravel() for k, g, m, iod in zip(rows, goals, middles, iods, strict=True)]
        )
        mean, offset = seen.mean(axis=0), wanted.mean(axis=0)
        centred = seen - mean
        weight = np.linalg.solve(centred.T @ centred + RIDGE * np.eye(centred.shape[1]), centred.T @ (wanted - offset))
        told = (centred @ weight + offset).reshape(len(rows), -1, 2) + base
        step = told.mean(axis=1) * np.array([turns[k] for k in rows]) * iods[:, None]
        middles = middles + step + LATER * iods[:, None] * rng.normal(size=step.shape)
        means, weights, offsets = [*means, mean], [*weights, weight], [*offsets, offset]
    return EarModel(names, base, np.array(means), np.array(weights), np.array(offsets), np.array([0.0, 1.0]))


def held_out_errors(model: EarModel, ears: list[Seen], guess: float, rng: np.random.Generator) -> Array:
    """Return (N, 2) spread of the guesses and true mean error of ears that taught nothing, eye distances."""
    out = []
    for ear in ears:
        start = ear.points_px.mean(axis=0) + guess * ear.iod_px * rng.normal(size=2)
        found = find_ear(model, ear.rgb, ear.mask, start, ear.iod_px, right=ear.right)
        away = float(np.linalg.norm(found.points_px - ear.points_px, axis=1).mean()) / ear.iod_px
        out.append([found.error_iod, away])  # the model still tells the bare spread
    return np.array(out)


def calibrate(ears: dict[str, list[Seen]]) -> dict[str, NDArray[np.generic]]:
    """Return the arrays of both models and print their errors on people that taught nothing."""
    arrays: dict[str, NDArray[np.generic]] = {}
    for view, names in (("front", FRONT_EARS), ("side", SIDE_EARS)):
        rng = np.random.default_rng(1)
        known = [e for e in ears[view] if e.seed % HELD_OUT]
        spread, error = held_out_errors(
            train(known, names, GUESS[view], rng), [e for e in ears[view] if e.seed % HELD_OUT == 0], GUESS[view], rng
        ).T
        floor = float(np.median(error[spread <= np.median(spread)]))
        slope = float(np.median(((error - floor) / spread)[spread > np.median(spread)]))
        told = [100 * np.median(error), 100 * error.mean(), 100 * np.quantile(error, 0.9)]
        print(f"{view}: {len(known)} ears; error median, mean, 90 %: {np.round(told, 1)} % of the eye distance")
        print(f"  expected {floor:.3f} + {slope:.2f} x spread")
        model = train(ears[view], names, GUESS[view], rng)
        arrays |= {
            f"{view}_base": model.base.astype(np.float32),
            f"{view}_means": model.means.astype(np.float16),
            f"{view}_weights": model.weights.astype(np.float16),
            f"{view}_offsets": model.offsets.astype(np.float32),
            f"{view}_error": np.array([floor, max(slope, 1.0)], dtype=np.float32),
        }
    return arrays


def main() -> None:
    """Photograph, teach, write."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--people", type=int, default=260)
    chosen = parser.parse_args()
    cv2.setNumThreads(1)
    save(OUT, calibrate(photographed(chosen.people)))


if __name__ == "__main__":
    main()
