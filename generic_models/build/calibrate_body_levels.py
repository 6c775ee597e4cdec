"""Learn where body features lie: ``python generic_models/build/calibrate_body_levels.py PEOPLE [--painted 180]``.

People of two families are photographed from the front, behind and the side and shown to the pose net: painted here, and
from PEOPLE, folders of the generator of photographed synthetic people (its seeds 7001 and on, far from those that
benchmarks draw). The levels of the net's joints, of the contour's extremes and of the true features go into one
Gaussian a view, and with them the errors of the net's points and the width of legs; all to
``cloner_models/body_levels.npz`` (see ``cloner.detectors.body.levels``).
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

import cv2
import numpy as np
from archives import save
from numpy.typing import NDArray
from painted_people import BACKGROUNDS, TIGHTNESSES, Shot, photograph_once
from painted_people_clothes import HAIR

from cloner.detectors.body.front_cues import arm_cues, front_cues, level_of
from cloner.detectors.body.front_features import find_side, foot_end, joint_places
from cloner.detectors.body.pose_order import corrected_pose
from cloner.detectors.body.side_contours import find_side_contour, outward_sign, polyline_columns
from cloner.detectors.body.side_cues import body_axis, find_body_profile, foot_ends, side_cues
from cloner.detectors.body.side_features import find_from_side, profile_joints
from cloner.detectors.nets import litert
from cloner.detectors.nets import pose_rows as net
from cloner.evaluate.measures.posing import JOINTS
from cloner.evaluate.truths.kit import kit_people, read_kit
from cloner.frames import ViewId
from cloner.generic.load import GenericHuman, load_generic
from cloner.records.labels import Label
from cloner.vision.segmentation.outline_walk import SoftMask, soft_mask

Array = NDArray[np.float64]
Samples = dict[str, list[dict[str, float]]]
Errors = dict[str, list[Array]]
OUT: Final = Path(__file__).resolve().parent.parent / "cloner_models" / "body_levels.npz"
FIRST_SEED: Final = 700_000  # any number; far from the seeds of benchmarks
SIZE_PX: Final = (800, 1200)
HEADING_DEG: Final = 6.0
VIEWS: Final = {"front": ViewId.BODY_FRONT, "side": ViewId.BODY_SIDE, "back": ViewId.BODY_BACK}
AZIMUTHS: Final = {"front": (0.0,), "side": (-90.0, 90.0), "back": (180.0,)}
FRONT: Final = ("neck_base", "armpit", "waist", "hip", "knee_outer", "knee_inner", "ankle_outer", "ankle_inner")
SIDE: Final = ("buttock", "thigh_front", "thigh_back", "knee_front", "knee_back", "calf", "ankle_front", "ankle_back")
MIDDLE: Final = ("neck_front", "neck_back", "chest_front", "back", "belly_front", "waist_front", "waist_back")
#: Strength of the diagonal that holds the covariance of few samples apart, levels squared (0.2 % of the height).
RIDGE: Final = 0.002**2
TURNS: Final = 30


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """One photograph of a random person: what net and outline show, and what is true; all in pixels."""

    mask: NDArray[np.uint8]
    pose: Array
    hair: NDArray[np.bool_]
    features: Mapping[str, Array]
    joints: Mapping[str, Array]
    azimuth_deg: float


def photographs(people: int, view: str) -> Iterator[Seen]:
    """Yield photographs from one direction; people whom the net does not find are left out."""
    generic = load_generic()
    for number in range(people):
        seed = FIRST_SEED + 3 * number + list(AZIMUTHS).index(view)
        rng = np.random.default_rng([seed, 6])
        azimuth = float(rng.choice(AZIMUTHS[view]))
        shot, _, dressed = photograph_once(
            seed,
            azimuth + rng.uniform(-HEADING_DEG, HEADING_DEG),
            tightness=TIGHTNESSES[number % 3],
            background=BACKGROUNDS[(number // 3) % 2],
            size_px=SIZE_PX,
        )
        pose = litert.detect_pose(shot.rgb)
        if pose is not None:
            hair = hair_of(shot, dressed.kind == HAIR)
            yield Seen(soft(shot.mask), np.asarray(pose.points_px), hair, *truth(generic, shot), azimuth)


def generated(people: Path, view: str) -> Iterator[Seen]:
    """Yield photographs of generated people from one direction; people whom the net does not find are left out."""
    generic = load_generic()
    features = {n: generic.feature(n) for n in generic.feature_names}
    for person in kit_people([people]):
        kit = read_kit(person)
        known, shown = kit.truth.views[VIEWS[view].value], kit.whole_m(VIEWS[view].value)
        pose = litert.detect_pose(known.photo)
        if pose is None:
            continue
        for eye in ("pupil_L", "pupil_R"):  # the naked body's vertices end at the sockets
            shown[features[eye]] = known.points_m[eye]
        places = known.camera.project(shown[list(features.values())])
        joints = {ours: known.camera.project(known.joints_m[name][None])[0] for name, ours in JOINTS.items()}
        beside = known.camera.to_camera(np.stack([known.joints_m["shoulder_L"], known.joints_m["shoulder_R"]]))
        azimuth = (90.0 if beside[0, 2] < beside[1, 2] else -90.0) if view == "side" else AZIMUTHS[view][0]
        labels = kit.labels[VIEWS[view].value]
        yield Seen(
            soft(labels > 0), np.asarray(pose.points_px), labels == Label.HAIR,
            dict(zip(features, places, strict=True)), joints, azimuth,
        )  # fmt: skip


def put_in_order(seen: Seen, view: ViewId) -> Seen:
    """Return what the net showed with left and right as the product puts them."""
    figure = soft_mask(seen.mask)
    return seen if figure is None else replace(seen, pose=corrected_pose(figure, seen.pose, view)[0])


def soft(mask: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """Return a mask with an edge as soft as the product's."""
    return np.asarray(cv2.GaussianBlur(mask.astype(np.uint8) * 255, (0, 0), 0.8), np.uint8)


def hair_of(shot: Shot, hairy: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return (H, W) roughly where hair is seen."""
    drawn = np.zeros(shot.mask.shape, np.uint8)
    column, row = np.round(shot.camera.project(shot.dressed_m[hairy])).astype(int).T
    good = (row >= 0) & (row < drawn.shape[0]) & (column >= 0) & (column < drawn.shape[1])
    drawn[row[good], column[good]] = 1
    return np.asarray(cv2.dilate(drawn, np.ones((9, 9), np.uint8)) > 0)


def truth(generic: GenericHuman, shot: Shot) -> tuple[dict[str, Array], dict[str, Array]]:
    """Return true feature and joint pixels by name."""
    vertices = shot.camera.project(shot.naked_m[generic.feature_vertices])
    joints = shot.camera.project(shot.joints_m)
    return dict(zip(generic.feature_names, vertices, strict=True)), dict(zip(generic.joint_names, joints, strict=True))


def gather(shown: Mapping[str, list[Seen]]) -> Samples:
    """Return samples of levels by model: front, back, their arms, and side."""
    samples: Samples = {name: [] for name in ("front", "back", "arm_front", "arm_back", "side")}
    for view, photos in shown.items():
        for seen in photos:
            figure = soft_mask(seen.mask)
            if figure is None:
                continue
            if view == "side":
                samples[view].append(side_sample(figure, seen))
                continue
            for side in (net.LEFT, net.RIGHT):
                samples[view].append(front_sample(figure, seen, side))
                samples[f"arm_{view}"].append(arm_sample(figure, seen, side))
    return samples


def side_sample(figure: SoftMask, seen: Seen) -> dict[str, float]:
    """Return seen and true levels of a side photo."""
    near, forwards = (net.LEFT, -1.0) if seen.azimuth_deg > 0 else (net.RIGHT, 1.0)
    found = side_cues(figure, seen.pose, find_body_profile(figure, seen.pose, near, forwards, seen.hair))
    name = net.SIDES[near]
    rows = {n: seen.features[n] for n in MIDDLE} | {n: seen.features[f"{n}_{name}"] for n in SIDE}
    rows |= {f"joint_{n}": seen.joints[f"{name[0]}_{n}"] for n in ("shoulder", "hip", "knee", "ankle")}
    ankle, instep = profile_axis_place(seen.pose, near, float(rows["ankle_front"][1])), rows["ankle_front"]
    found["ankle_front_ahead"] = float((instep[0] - ankle) * forwards / figure.height_px)
    return found | {n: level_of(figure, float(point[1])) for n, point in rows.items()}


def profile_axis_place(pose: Array, near: int, row: float) -> float:
    """Return the column of the side photo's body axis at a row."""
    return float(polyline_columns(np.array([row]), body_axis(pose, near))[0])


def front_sample(figure: SoftMask, seen: Seen, side: int) -> dict[str, float]:
    """Return seen and true levels of one side of a front or back photo."""
    name = net.SIDES[side]
    found = front_cues(figure, seen.pose, find_side_contour(figure, seen.pose, side, seen.hair))
    rows = {n: seen.features[f"{n}_{name}"] for n in FRONT} | {"crotch": seen.features["crotch"]}
    rows |= {f"joint_{n}": seen.joints[f"{name[0]}_{n}"] for n in ("shoulder", "hip", "knee", "ankle")}
    return found | {n: level_of(figure, float(point[1])) for n, point in rows.items()}


def arm_sample(figure: SoftMask, seen: Seen, side: int) -> dict[str, float]:
    """Return seen and true places along one arm, and the shoulder's end across the trunk."""
    name = net.SIDES[side]
    found, strip, share = arm_cues(figure, seen.pose, side)
    points = {f"{n}_{s}": seen.features[f"{n}_{s}_{name}"] for n in ("elbow", "wrist") for s in ("outer", "inner")}
    points |= {f"joint_{n}": seen.joints[f"{name[0]}_{n}"] for n in ("elbow", "wrist")}
    along = np.stack([-strip.across[:, 1], strip.across[:, 0]], axis=1)
    for n, point in points.items():
        offset = point - strip.centres_px
        away = np.abs(np.einsum("ta,ta->t", offset, along)) + 0.2 * np.linalg.norm(offset, axis=1)
        found[n] = float(share[away.argmin()])
    middle = seen.pose[list(net.SHOULDERS), 0].mean()
    apart = seen.pose[net.SHOULDERS[side], 0] - middle
    for n in ("shoulder_end", "neck_base"):
        found[n] = float((seen.features[f"{n}_{name}"][0] - middle) / apart)
    return found


def gaussian(samples: list[dict[str, float]]) -> tuple[tuple[str, ...], Array, Array]:
    """Return names, mean and covariance of samples with gaps, by expectation and maximisation.

    Names that fewer than a third of the samples have are left out.
    """
    every = sorted({name for sample in samples for name in sample})
    table = np.array([[sample.get(name, np.nan) for name in every] for sample in samples])
    table[np.abs(table - np.nanmedian(table, axis=0)) > 6 * np.nanstd(table, axis=0)] = np.nan
    kept = np.isfinite(table).mean(axis=0) > 1 / 3
    table, names = table[:, kept], tuple(name for name, keep in zip(every, kept, strict=True) if keep)
    known = np.isfinite(table)
    mean, covariance = np.nanmean(table, axis=0), np.diag(np.nanvar(table, axis=0))
    for _ in range(TURNS):
        filled, extra = np.empty_like(table), np.zeros_like(covariance)
        for row, (values, seen) in enumerate(zip(table, known, strict=True)):
            gain = np.linalg.solve(covariance[np.ix_(seen, seen)] + RIDGE * np.eye(seen.sum()), covariance[seen]).T
            filled[row] = np.where(seen, values, mean + gain @ (values[seen] - mean[seen]))
            rest = covariance - gain @ covariance[seen]
            rest[seen], rest[:, seen] = 0.0, 0.0
            extra += rest
        mean = filled.mean(axis=0)
        covariance = (filled - mean).T @ (filled - mean) / len(table) + extra / len(table)
    return names, mean, covariance


def point_errors(photos: list[Seen], view: str) -> Errors:
    """Return true place minus proposed place, outwards (from the side: forwards) and up, in figure heights."""
    found: Errors = {}
    for seen in photos:
        figure = soft_mask(seen.mask)
        if figure is None:
            continue
        near, forwards = (net.LEFT, -1.0) if seen.azimuth_deg > 0 else (net.RIGHT, 1.0)
        for side in (near,) if view == "side" else (net.LEFT, net.RIGHT):
            name = net.SIDES[side]
            if view == "side":
                look = find_from_side(figure, seen.pose, near, forwards, seen.hair)
                places = profile_joints(figure, seen.pose, look)
                ends = zip(("toe", "heel"), foot_ends(figure, look.profile), strict=True)
                pairs = [(f"{n}_outline", p, seen.features[f"{n}_{name}"]) for n, p in ends if p is not None]
                pairs += [(n, p, seen.joints[f"{name[0]}_{n}"]) for n, p in places.items()]
            else:
                forwards = outward_sign(seen.pose, side)
                front_look = find_side(figure, seen.pose, side, view, seen.hair)
                every = joint_places(figure, seen.pose, front_look)
                pairs = [
                    (f"{n}_{source}", p, seen.joints[f"{name[0]}_{n}"])
                    for n, places in every.items()
                    for source, p in places.items()
                ]
                end, foot = "toe" if view == "front" else "heel", foot_end(figure, seen.pose, front_look)
                pairs += [] if foot is None else [(f"{end}_outline", foot, seen.features[f"{end}_{name}"])]
            pairs += [
                (n, seen.pose[row], seen.features[n])
                for n, row in net.FEATURES.items()
                if n.endswith(("tip", name, name[0].upper()))
            ]
            for n, proposed, true in pairs:
                n = n.removesuffix(f"_{name}").removesuffix(f"_{name[0].upper()}")
                away = (true - proposed) * [forwards, -1.0] / figure.height_px
                found.setdefault(n, []).append(away)
    return found


def offset_arrays(view: str, errors: Errors) -> dict[str, NDArray[np.generic]]:
    """Return names, median offset and the mean distance that is left."""
    names = sorted(errors)
    offset = np.array([np.median(errors[name], axis=0) for name in names])
    offset[[k for k, name in enumerate(names) if name == "nose_tip" and view != "side"], 0] = 0.0  # it has no side
    left = [
        np.linalg.norm(np.array(errors[name]) - own, axis=1).mean() for name, own in zip(names, offset, strict=True)
    ]
    return {
        f"{view}_point_names": np.array(names),
        f"{view}_point_offset": offset,
        f"{view}_point_error": np.array(left),
    }


def learn(shown: Mapping[str, list[Seen]]) -> None:
    """Write what photographs by view teach."""
    shown = {view: [put_in_order(seen, VIEWS[view]) for seen in photos] for view, photos in shown.items()}
    samples = gather(shown)
    arrays: dict[str, NDArray[np.generic]] = {}
    for kind, rows in samples.items():
        names, mean, covariance = gaussian(rows)
        arrays |= {f"{kind}_names": np.array(names), f"{kind}_mean": mean, f"{kind}_covariance": covariance}
    save(OUT, arrays)
    for view, photos in shown.items():  # with the levels just learnt
        arrays |= offset_arrays(view, point_errors(photos, view))
    save(OUT, arrays)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("people", type=Path, help="folders of generated people")
    parser.add_argument("--painted", type=int, default=180, help="people painted here")
    chosen = parser.parse_args()
    learn({v: [*photographs(chosen.painted, v), *generated(chosen.people, v)] for v in AZIMUTHS})


if __name__ == "__main__":
    main()
