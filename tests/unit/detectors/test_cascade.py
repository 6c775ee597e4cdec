"""Ears, eye, wing and mouth corner are found near a rough guess, left and right alike; what is none is doubted."""

from __future__ import annotations

import json

import cv2
import numpy as np
import pytest

from cloner.detectors.face.cascade import FEATURES, FeaturePose, find_feature, load_cascades, side_names
from cloner.vision.photographs.gradients import gradient_histograms
from kit.visitors import photo, truth_mask, visitor_folder


def marks(name: str, view: str, photos: str = "plain") -> dict[str, np.ndarray]:
    truth = "truth_handheld.json" if photos == "handheld" else "truth.json"
    points = json.loads((visitor_folder(name) / truth).read_text())["features"][view]["points"]
    return {n: np.array(p.get("xy_rendered", p["xy"])) - 0.5 for n, p in points.items() if p["visible"]}


def shown(name: str, view: str, photos: str = "plain") -> tuple[np.ndarray, np.ndarray]:
    mask = truth_mask(name, photos, view).astype(np.uint8) * 255
    return photo(name, photos, view).rgb, mask


def eye_distance(name: str, photos: str = "plain") -> float:
    known = marks(name, "face_front", photos)
    return float(np.linalg.norm(known["pupil_L"] - known["pupil_R"]))


@pytest.mark.parametrize(("name", "side"), [("anna", "L"), ("anna", "R"), ("boris", "L"), ("boris", "R")])
def test_front_ears_are_found_from_a_sixth_of_the_eye_distance(name, side):
    known, iod = marks(name, "face_front"), eye_distance(name)
    true = np.array([known[f"{n}_{side}"] for n in FEATURES["front_ear"]])
    for push in ([0.12, 0.1], [-0.12, -0.1]):
        start = true.mean(axis=0) + iod * np.array(push)
        ear = find_feature(
            load_cascades()["front_ear"], *shown(name, "face_front"), start, FeaturePose(iod, 0.0, side == "R")
        )
        assert np.linalg.norm(ear.points_px - true, axis=1).mean() < 0.08 * iod
        assert ear.error_iod.mean() < 0.10


@pytest.mark.parametrize("name", ["anna", "boris"])
@pytest.mark.parametrize(("feature", "push", "reached"), [
    ("side_ear", 0.20, 0.09), ("side_eye", 0.08, 0.09), ("side_nose", 0.08, 0.06), ("side_mouth", 0.08, 0.06),
])  # fmt: skip
@pytest.mark.parametrize("photos", ["plain", "handheld"])
def test_side_features_are_found_from_where_a_profile_would_guess_them(name, feature, push, reached, photos):
    known, iod = marks(name, "face_side", photos), eye_distance(name, photos)
    side = "L" if "ear_lobe_L" in known else "R"
    names = [f"{n}_{side}" for n in FEATURES[feature]]
    if any(n not in known for n in names):
        pytest.skip("hidden in this photo")
    true = np.array([known[n] for n in names])
    for way in ([0.8, -0.6], [-0.8, 0.6]):
        start = true.mean(axis=0) + push * iod * np.array(way)
        found = find_feature(load_cascades()[feature], *shown(name, "face_side", photos), start,
                             FeaturePose(iod, 0.0, side == "R"))  # fmt: skip
        assert np.linalg.norm(found.points_px - true, axis=1).mean() < reached * iod


@pytest.mark.parametrize("photos", ["plain", "handheld"])
@pytest.mark.parametrize("name", ["anna", "boris"])
@pytest.mark.parametrize(("feature", "reached"), [("front_nose", 0.055), ("front_chin", 0.06)])
def test_nose_and_chin_of_both_halves_are_found_where_the_net_errs_by_a_twentieth(name, photos, feature, reached):
    known, iod = marks(name, "face_front", photos), eye_distance(name, photos)
    picture = shown(name, "face_front", photos)
    across = known["pupil_L"] - known["pupil_R"]
    tilt = float(np.arctan2(across[1], across[0]))
    for way in ([0.03, 0.03], [-0.03, -0.03]):
        told: dict[str, list[np.ndarray]] = {}
        for side in "LR":
            pose, names = FeaturePose(iod, -tilt if side == "R" else tilt, side == "R"), side_names(feature, side)
            start = np.mean([known[n] for n in names], axis=0) + iod * np.array(way)
            found = find_feature(load_cascades()[feature], *picture, start, pose)
            for n, place in zip(names, found.points_px, strict=False):
                told.setdefault(n, []).append(place)
        away = {n: float(np.linalg.norm(np.mean(both, axis=0) - known[n])) / iod for n, both in told.items()}
        assert np.mean(list(away.values())) < reached, (name, photos, away)


def test_a_mirrored_photo_gives_the_other_ear():
    known, iod = marks("anna", "face_front"), eye_distance("anna")
    rgb, mask = shown("anna", "face_front")
    start, last = np.mean([known[f"{n}_L"] for n in FEATURES["front_ear"]], axis=0), rgb.shape[1] - 1
    cascade = load_cascades()["front_ear"]
    left = find_feature(cascade, rgb, mask, start, FeaturePose(iod, 0.1, False))
    flipped = [np.ascontiguousarray(image[:, ::-1]) for image in (rgb, mask)]
    right = find_feature(cascade, *flipped, np.array([last - start[0], start[1]]), FeaturePose(iod, 0.1, True))
    assert np.column_stack([last - right.points_px[:, 0], right.points_px[:, 1]]) == pytest.approx(
        left.points_px, abs=0.03 * iod
    )


def test_a_tilted_photo_gives_the_same_ear_tilted():
    known, iod = marks("boris", "face_side"), eye_distance("boris")
    side = "L" if "ear_lobe_L" in known else "R"
    rgb, mask = shown("boris", "face_side")
    start = np.mean([known[f"{n}_{side}"] for n in FEATURES["side_ear"]], axis=0)
    cascade = load_cascades()["side_ear"]
    upright = find_feature(cascade, rgb, mask, start, FeaturePose(iod, 0.0, side == "R"))
    clockwise = cv2.getRotationMatrix2D(start.tolist(), -20.0, 1.0)
    size = rgb.shape[1::-1]
    turned = [cv2.warpAffine(i, clockwise, size, borderMode=cv2.BORDER_REPLICATE) for i in (rgb, mask)]
    tilt = np.radians(-20.0 if side == "R" else 20.0)
    tilted = find_feature(cascade, turned[0], turned[1], start, FeaturePose(iod, float(tilt), side == "R"))
    expected = upright.points_px @ clockwise[:, :2].T + clockwise[:, 2]
    assert np.linalg.norm(tilted.points_px - expected, axis=1).max() < 0.05 * iod


def test_where_no_ear_is_none_is_believed():
    rng = np.random.default_rng(3)
    rgb = cv2.GaussianBlur(rng.integers(0, 255, (600, 500, 3)).astype(np.uint8), (0, 0), 3.0)
    mask = np.full(rgb.shape[:2], 255, np.uint8)
    ear = find_feature(load_cascades()["side_ear"], rgb, mask, np.array([250.0, 300.0]), FeaturePose(120.0, 0.0, False))
    assert ear.error_iod.min() > 0.10


def test_light_and_contrast_do_not_change_a_description_but_shape_does():
    y, x = np.mgrid[:80, :64].astype(np.float32)
    edge = (np.hypot(x - 32, y - 40) < 20).astype(np.float32) * 120
    brighter = gradient_histograms(1.4 * edge + 50)
    assert np.linalg.norm(brighter - gradient_histograms(edge)) < 0.15 * np.linalg.norm(brighter)
    other = (np.abs(x - 32) < 20).astype(np.float32) * 120
    assert np.linalg.norm(gradient_histograms(other) - gradient_histograms(edge)) > 0.5 * np.linalg.norm(brighter)
    assert np.abs(gradient_histograms(np.full((80, 64), 90, np.float32))).max() < 1e-6
