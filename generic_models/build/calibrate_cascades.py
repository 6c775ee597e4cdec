"""Teach where small features of faces lie:
``python generic_models/build/calibrate_cascades.py --scans ICT_FAMILY.npz --people PEOPLE [--features NAME ...]``.

Three families: portraits of random heads (``painted_portraits.py``), with ``--scans`` half of them of a scan-based
family, with ``--people`` photos of the generator of photographed people; nobody of them is judged by a benchmark. A
cascade of ridge regressions for each feature learns points from gradient histograms around a rough guess, which is what
a profile laid on the outline would tell. Goes to ``cloner_models/cascades.npz`` with the error to expect for the spread
that several guesses show. 40 CPU minutes for all; other features than the told ones stay as they are. The shipped side
eye was taught on painted heads alone: the three families find it nearer in the generator's photos (10.2 to 5.7 % of the
eye distance) and 13 % off in a sample's hand-held one.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

import numpy as np
from archives import save
from numpy.typing import NDArray
from painted_portraits import portrait
from photographed_heads import Head, photographed
from portrait_canvas import canvas
from scipy.spatial import cKDTree

from cloner.detectors.face.cascade import (
    FEATURES,
    Cascade,
    FeaturePose,
    Picture,
    describe_window,
    find_feature,
    prepare,
    side_names,
)
from cloner.detectors.face.face_front_features import front_pose
from cloner.detectors.face.face_net import load_face_net
from cloner.detectors.face.face_points import PROFILE
from cloner.detectors.face.face_side import IOD_M
from cloner.generic.load import load_generic

Array = NDArray[np.float64]
OUT = Path(__file__).resolve().parent.parent / "cloner_models" / "cascades.npz"
FIRST_PORTRAIT: Final = {"side": 20000, "front": 21500}
REPEATS: Final = {"side": 8, "front": 4}  # guesses a picture and feature
RIDGE = 40.0
LATER = 0.02  # noise that later stages are taught with, so that they do not believe the first one's own pictures
TILT, SIZE = 0.07, 0.06  # errors of a laid profile's turn, radians, and size, logarithmic
PEOPLE_COUNT = 2  # a photographed head counts as so many painted ones: there are fewer of them
HELD_OUT = 5  # every so manieth head tells the errors


@dataclass(frozen=True, slots=True)
class Plan:
    """Eye distances in the windows of a cascade's stages, px; the first guess's error beyond what faces differ, and the
    reach of later guesses, eye distances."""

    iods_px: tuple[float, ...]
    guess: float
    reach: float


#: What a model tells beside the named points, for the head fit: vertices of the generic human's left half.
BESIDE: Final[dict[str, tuple[int, ...]]] = {"front_nose": (7057, 7053, 7119, 201)}  # three on the wing, the back
PLANS: Final = {
    "front_ear": Plan((40.0, 40.0, 64.0), 0.15, 0.10),
    "front_nose": Plan((64.0, 80.0, 80.0), 0.05, 0.05),
    "front_chin": Plan((40.0, 56.0, 56.0), 0.06, 0.06),
    "side_ear": Plan((30.0, 40.0, 56.0, 56.0), 0.15, 0.14),
    "side_eye": Plan((48.0, 72.0, 72.0), 0.05, 0.06),
    "side_nose": Plan((48.0, 72.0, 72.0), 0.05, 0.06),
    "side_mouth": Plan((48.0, 72.0, 72.0), 0.05, 0.06),
    "side_bridge": Plan((48.0, 72.0, 72.0), 0.05, 0.06),
}


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """One feature in a picture: points (K, 2) px, its pose, and where it is guessed (2,) px."""

    seed: int
    rgb: NDArray[np.uint8]
    mask: NDArray[np.uint8]
    points_px: Array
    pose: FeaturePose
    guess_px: Array


def heads(view: str, portraits: int, scans: Path | None, people: Path | None) -> list[Head]:
    """Return the pictures of one view, "front" or "side"; a front picture counts for both its ears.

    With ``scans`` two sitters of the generic's family and two of the scan-based one follow each other; photographed
    ``people`` come after them, each as often as `PEOPLE_COUNT` tells.
    """
    out = []
    for seed in range(FIRST_PORTRAIT[view], FIRST_PORTRAIT[view] + portraits):
        side = "LR"[seed % 2]
        azimuth = 0.0 if view == "front" else {"L": 90.0, "R": -90.0}[side]
        known = portrait(seed, azimuth, scans if seed % 4 > 1 else None)
        for one in "LR" if view == "front" else side:
            out.append(Head(seed, known.rgb, known.mask, known.marks_px, known.hidden, known.vertices_px, one))
    for known in [] if people is None else photographed(people, f"face_{view}", tuple(canvas().rows)):
        for one in "LR" if view == "front" else known.side:
            out += PEOPLE_COUNT * [replace(known, side=one)]
    return out


def profile_pose(head: Head, names: tuple[str, ...]) -> tuple[FeaturePose, Array] | None:
    """Return how a head lies in a side picture and where a feature is guessed, by its true profile alone."""
    model = load_face_net().profile
    known = [name for name in PROFILE if name in head.marks_px]
    if len(known) < 6:
        return None
    mirror = np.array([-1.0 if head.side == "R" else 1.0, 1.0])
    flat = -model.mean[model.samples :] / IOD_M
    source = flat[[model.names.index(name) for name in known]] @ [1, 1j]
    goal = (np.array([head.marks_px[name] for name in known]) * mirror) @ [1, 1j]
    away = source - source.mean()
    factor = np.vdot(away, goal - goal.mean()) / np.vdot(away, away).real
    middle = flat[[model.names.index(name) for name in names]].mean(axis=0) @ [1, 1j]
    there = goal.mean() + factor * (middle - source.mean())
    pose = FeaturePose(float(abs(factor)), float(np.angle(factor)), head.side == "R")
    return pose, np.array([there.real, there.imag]) * mirror


def eyes_pose(head: Head) -> FeaturePose | None:
    """Return how a head lies in a front picture by its eyes."""
    if any(f"pupil_{side}" not in head.marks_px for side in "LR"):
        return None
    return front_pose(np.array([head.marks_px[f"pupil_{side}"] for side in "LR"]), head.side)


def vertices_of(feature: str) -> NDArray[np.int64]:
    """Return (2, K) the vertices of a feature's points, on the person's left and right."""
    generic = load_generic()
    left = [*(generic.feature(name) for name in side_names(feature, "L")), *BESIDE.get(feature, ())]
    body = generic.part("body")
    _, twin = cKDTree(generic.vertices_m[body]).query(generic.vertices_m[left] * [-1.0, 1.0, 1.0])
    return np.array([left, body[twin]], dtype=np.int64)


def seen(feature: str, pictures: list[Head]) -> list[Seen]:
    """Return a feature in the pictures that show it."""
    names, vertices, out = FEATURES[feature], vertices_of(feature), []
    for head in pictures:
        marks = side_names(feature, head.side)
        if any(name not in head.marks_px for name in marks):
            continue
        if "ear" in feature and len(head.hidden.intersection(marks)) > 1:
            continue
        points = head.vertices_px[vertices["LR".index(head.side)]]
        if feature.startswith("front"):
            pose = eyes_pose(head)
            found = None if pose is None else (pose, points[: len(names)].mean(axis=0))
        else:
            found = profile_pose(head, names)
        if found is not None:
            out.append(Seen(head.seed, head.rgb, head.mask, points, *found))
    return out


def upright(one: Seen, pose: FeaturePose, places_px: Array, middle_px: Array) -> Array:
    """Return places around a middle as the pose sees them upright, eye distances."""
    return np.asarray((places_px - middle_px) @ pose.upright().T / pose.iod_px)


@dataclass(slots=True, eq=False)
class Try:
    """A guess on its way: which picture, its doubtful pose, and where it stands, px."""

    row: int
    pose: FeaturePose
    middle_px: Array


def tries(known: list[Seen], plan: Plan, repeats: int, rng: np.random.Generator) -> list[Try]:
    """Return several doubtful guesses for each picture."""
    out = []
    for row, one in enumerate(known):
        for _ in range(repeats):
            size = float(np.exp(SIZE * rng.normal()))
            pose = replace(one.pose, iod_px=one.pose.iod_px * size, tilt=one.pose.tilt + TILT * rng.normal())
            out.append(Try(row, pose, one.guess_px + plan.guess * one.pose.iod_px * rng.normal(size=2)))
    return out


def pictures_of(known: list[Seen], iod_px: float) -> list[tuple[Picture, Picture, Array]]:
    """Return each photo and mask at a stage's size, and the factors of their sizes."""
    out = []
    for one in known:
        grey, person = prepare(one.rgb, one.mask, iod_px / one.pose.iod_px)
        out.append((grey, person, np.array(grey.shape[::-1]) / np.array(one.rgb.shape[1::-1])))
    return out


def train(feature: str, known: list[Seen], rng: np.random.Generator) -> Cascade:
    """Return a cascade; each stage is taught from where the ones before it arrive."""
    plan, names = PLANS[feature], FEATURES[feature]
    base = np.mean([upright(o, o.pose, o.points_px, o.points_px[: len(names)].mean(axis=0)) for o in known], axis=0)
    guesses = tries(known, plan, REPEATS[feature.split("_")[0]], rng)
    levels: dict[float, list[tuple[Picture, Picture, Array]]] = {}
    means: list[Array] = []
    weights: list[Array] = []
    offsets: list[Array] = []
    for iod_px in plan.iods_px:
        if iod_px not in levels:
            levels = {iod_px: pictures_of(known, iod_px)}
        looked, wanted = [], []
        for one in guesses:
            grey, person, factor = levels[iod_px][one.row]
            there = replace(one.pose, iod_px=one.pose.iod_px * float(factor[0]))
            looked.append(
                describe_window((grey, person), (one.middle_px + 0.5) * factor - 0.5, there, iod_px).astype(np.float32)
            )
            sight = known[one.row]
            wanted.append((upright(sight, one.pose, sight.points_px, one.middle_px) - base).ravel())
        described, goals = np.stack(looked), np.stack(wanted)
        mean, offset = described.mean(axis=0).astype(np.float64), goals.mean(axis=0)
        centred = described - mean.astype(np.float32)
        gram = (centred.T @ centred).astype(np.float64) + RIDGE * np.eye(centred.shape[1])
        weight = np.linalg.solve(gram, (centred.T @ (goals - offset)).astype(np.float64))
        step = (np.asarray(centred @ weight) + offset).reshape(len(guesses), -1, 2) + base
        step = step[:, : len(names)].mean(axis=1)
        step += LATER * rng.normal(size=step.shape)
        for one, moved in zip(guesses, step, strict=True):
            one.middle_px = one.middle_px + one.pose.iod_px * moved @ one.pose.upright()
        means, weights, offsets = [*means, mean], [*weights, weight], [*offsets, offset]
    error, joint = np.tile([0.0, 1.0], (len(base), 1)), np.zeros((base.size, base.size))
    return Cascade(names, vertices_of(feature), base, plan.reach, np.array(plan.iods_px), np.array(means),
                   np.array(weights), np.array(offsets), error, joint)  # fmt: skip


def held_out_errors(cascade: Cascade, plan: Plan, known: list[Seen], rng: np.random.Generator) -> tuple[Array, Array]:
    """Return the guesses' spread (N,) and the errors (N, K, 2) of heads that taught nothing, upright, eye distances."""
    spreads, errors = [], []
    for one, guess in zip(known, tries(known, plan, 1, rng), strict=True):
        found = find_feature(cascade, one.rgb, one.mask, guess.middle_px, guess.pose)
        spreads.append(float(found.error_iod[0]))  # the cascade still tells the bare spread
        errors.append((found.points_px - one.points_px) @ one.pose.upright().T / one.pose.iod_px)
    return np.array(spreads), np.array(errors)


def expected(spread: Array, errors: Array) -> Array:
    """Return (K, 2) floor and slope of each point's error for a spread; the slope is common."""
    away, mean = spread - spread.mean(), np.minimum(errors, 0.5).mean(axis=0)
    slope = max(float(away @ np.minimum(errors, 0.5).mean(axis=1) / max(float(away @ away), 1e-12)), 0.5)
    floor = np.maximum(mean - slope * spread.mean(), 0.4 * mean)
    return np.column_stack([floor, np.full(len(mean), slope)])


def told(feature: str, known: list[Seen], cascade: Cascade) -> dict[str, NDArray[np.generic]]:
    """Return what heads that taught nothing tell of a cascade, and print it."""
    rng = np.random.default_rng(2)
    spread, away = held_out_errors(cascade, PLANS[feature], [one for one in known if one.seed % HELD_OUT == 0], rng)
    errors = np.linalg.norm(away, axis=2)
    usual = away[spread < np.quantile(spread, 0.9)].reshape(-1, cascade.base.size)  # lost ones are told by their spread
    parts = np.round(100.0 * np.stack([np.median(errors, axis=0), errors.mean(axis=0), np.quantile(errors, 0.9, 0)]), 1)
    print(f"{feature}: {len(known)} seen; median, mean, 90 % of {cascade.names} and others: {parts.tolist()} %")
    error = expected(spread, errors)
    print(f"  expected {np.round(error, 3).tolist()}")
    return {
        f"{feature}_vertices": cascade.vertices.astype(np.int32),
        f"{feature}_joint": (usual.T @ usual / len(usual)).astype(np.float32),
        f"{feature}_error": error.astype(np.float32),
    }


def calibrate(feature: str, known: list[Seen]) -> dict[str, NDArray[np.generic]]:
    """Return the arrays of one cascade."""
    cascade = train(feature, [one for one in known if one.seed % HELD_OUT], np.random.default_rng(1))
    return told(feature, known, cascade) | {
        f"{feature}_base": cascade.base.astype(np.float32),
        f"{feature}_reach": np.array([cascade.reach], dtype=np.float32),
        f"{feature}_iods_px": cascade.iods_px.astype(np.float32),
        f"{feature}_means": cascade.means.astype(np.float16),
        f"{feature}_weights": cascade.weights.astype(np.float16),
        f"{feature}_offsets": cascade.offsets.astype(np.float32),
    }


def main() -> None:
    """Paint, train, write."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scans", type=Path, help="the scan-based family's file")
    parser.add_argument("--people", type=Path, help="people of the generator of photographed people")
    parser.add_argument("--portraits", type=int, default=800, help="of the side; of the front three quarters")
    parser.add_argument("--features", nargs="*", choices=FEATURES, default=list(FEATURES))
    chosen = parser.parse_args()
    arrays: dict[str, NDArray[np.generic]] = {}
    if OUT.exists():
        with np.load(OUT, allow_pickle=False) as kept:
            arrays = {name: kept[name] for name in kept.files}
    for view in ("side", "front"):
        wanted = [name for name in chosen.features if name.startswith(view)]
        count = chosen.portraits if view == "side" else 3 * chosen.portraits // 4
        pictures = heads(view, count, chosen.scans, chosen.people) if wanted else []
        for feature in wanted:
            arrays |= calibrate(feature, seen(feature, pictures))
    save(OUT, arrays)
    print(f"{OUT.stat().st_size} bytes")


if __name__ == "__main__":
    main()
