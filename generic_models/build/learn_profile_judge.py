"""Teach which of several laid profiles is the face's: ``python generic_models/build/learn_profile_judge.py PEOPLE``.

PEOPLE holds folders of the generator of photographed synthetic people with a side photo of the face each (180 people of
its seeds 7301 to 7414 and 8001 to 8183 taught the committed arrays; no benchmark draws them). Every profile that the
search lays on an outline is compared with the truth; a ridge regression tells the logarithm of its error from
``cloner.detectors.face.profile_judge.features``. Printed are the errors of the chosen profiles of people left out.
Goes to ``cloner_models/profile_judge.npz``.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from archives import save
from numpy.typing import NDArray

from cloner.detectors.face.face_net import load_face_net
from cloner.detectors.face.face_side import align_anywhere, align_near_hints, judge_hints, pose_hints, whole_outline
from cloner.detectors.face.profile_fit import named_px
from cloner.detectors.face.profile_judge import COST, features
from cloner.errors import ClonerError
from cloner.evaluate.truths.kit import kit_people, read_kit
from cloner.evaluate.truths.truth import TruthView
from cloner.frames import ViewId, mm_from_m
from cloner.project.folder import load_photo
from cloner.records.proposals import Proposal
from cloner.stages.proposals import propose

Array = NDArray[np.float64]
OUT = Path(__file__).resolve().parent.parent / "cloner_models" / "profile_judge.npz"
#: Points of the midline by which a profile is judged.
MARKS = ("nasion", "nose_tip", "subnasale", "stomion", "chin_front", "chin_bottom")
#: Smaller errors are all right and larger ones all wrong, mm.
LEAST_MM, MOST_MM = 2.0, 15.0
RIDGE = 30.0
#: What the outline's cost adds to the logarithm: a line makes too little of what counts only among the best. With 0, 2,
#: 4 and 6 profiles of 9, 5, 6 and 5 people were lost of whom another start was right, of 152 people left out.
OUTLINE = 2.0
FOLDS = 8
#: A face is lost where its points are off by more on the mean, mm.
LOST_MM = 8.0


@dataclass(frozen=True, slots=True, eq=False)
class Examples:
    """Profiles laid on one photo.

    Attributes
    ----------
    seen : (N, D) float64
    error_mm : (N,) float64
    """

    seen: Array
    error_mm: Array


def examples(proposal: Proposal, truth: TruthView) -> Examples | None:
    """Return all profiles that the search lays on a photo's outline, None where it lays none."""
    model, hints = load_face_net().profile, pose_hints(proposal)
    full = whole_outline(proposal.mask)
    if full is None:
        return None
    fitted = align_near_hints(proposal.mask, full, model, hints) + align_anywhere(proposal.mask, full, model)
    if not fitted:
        return None
    rows = [model.names.index(name) for name in MARKS]
    places = np.array([truth.points_m[name] for name in MARKS])
    true_px, pixel_mm = truth.camera.project(places), mm_from_m(truth.camera.metres_per_pixel(places.mean(axis=0)))
    away = [np.linalg.norm(named_px(model, one)[0][rows] - true_px, axis=1).mean() * pixel_mm for _, one in fitted]
    seen = [features(model, one, facing, proposal.labels, judge_hints(hints)) for facing, one in fitted]
    return Examples(np.array(seen), np.array(away))


def fit(people: list[Examples]) -> tuple[Array, Array, float]:
    """Return mean and weights (D,) and the mean logarithm of a ridge regression."""
    seen = np.concatenate([one.seen for one in people])
    wanted = np.log(np.clip(np.concatenate([one.error_mm for one in people]), LEAST_MM, MOST_MM))
    mean, usual = seen.mean(axis=0), float(wanted.mean())
    apart = seen - mean
    system = apart.T @ apart + RIDGE * np.eye(len(mean))
    weights = np.linalg.solve(system, apart.T @ (wanted - usual))
    weights[COST] += OUTLINE
    return mean, weights, usual


def chosen(people: list[Examples], taught: tuple[Array, Array, float]) -> Array:
    """Return (P, 2) the expected and the true error, mm, of the profile that is chosen for each person."""
    mean, weights, usual = taught
    told = [np.exp(usual + (one.seen - mean) @ weights) for one in people]
    return np.array([(t.min(), one.error_mm[t.argmin()]) for t, one in zip(told, people, strict=True)])


def report(name: str, found_mm: Array) -> None:
    """Print how far chosen profiles are off."""
    low, high = np.percentile(found_mm, [50, 75])
    print(
        f"{name}: median {low:.2f}, quartile {high:.2f} mm, {int((found_mm > LOST_MM).sum())} of {len(found_mm)} lost"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("people", type=Path, nargs="+")
    people = []
    for person in kit_people(parser.parse_args().people):
        photo = person / "face_side.jpg"
        try:
            proposal = propose(load_photo(photo, ViewId.FACE_SIDE))
        except ClonerError as error:
            print(f"{person.name}: {error.message}")
            continue
        found = examples(proposal, read_kit(person).truth.views["face_side"])
        people += [] if found is None else [found]
    report("nearest of all laid", np.array([one.error_mm.min() for one in people]))
    order = np.random.default_rng(0).permutation(len(people))
    left_out = np.concatenate([
        chosen([people[k] for k in part], fit([people[k] for k in order if k not in part]))
        for part in (order[fold::FOLDS] for fold in range(FOLDS))
    ])  # fmt: skip
    report("left out", left_out[:, 1])
    for low, high in ((0, 3), (3, 5), (5, 8), (8, 12), (12, 99)):
        rows = (left_out[:, 0] >= low) & (left_out[:, 0] < high)
        if rows.any():
            report(f"  expected {low} to {high} mm", left_out[rows, 1])
    mean, weights, usual = fit(people)
    save(OUT, {"mean": mean.astype(np.float32), "weights": weights.astype(np.float32), "usual": np.float64(usual)})


if __name__ == "__main__":
    main()
