"""Ears are found near a rough guess, left and right alike, and what is none is not believed."""

from __future__ import annotations

import json

import numpy as np
import pytest

from cloner.detectors.ears import FRONT_EARS, SIDE_EARS, find_ear, load_ears
from cloner.vision.gradients import describe
from kit.visitors import photo, truth_mask, visitor_folder


def marks(name: str, view: str) -> dict[str, np.ndarray]:
    points = json.loads((visitor_folder(name) / "truth.json").read_text())["features"][view]["points"]
    return {n: np.array(p.get("xy_rendered", p["xy"])) - 0.5 for n, p in points.items() if p["visible"]}


@pytest.mark.parametrize(("name", "side"), [("anna", "L"), ("anna", "R"), ("boris", "L"), ("boris", "R")])
def test_front_ears_of_the_visitors_are_found_from_a_sixth_of_the_eye_distance(name, side):
    known = marks(name, "face_front")
    true = np.array([known[f"{n}_{side}"] for n in FRONT_EARS])
    iod = float(np.linalg.norm(known["pupil_L"] - known["pupil_R"]))
    rgb, mask = photo(name, "plain", "face_front").rgb, truth_mask(name, "plain", "face_front").astype(np.uint8) * 255
    for push in ([0.12, 0.1], [-0.12, -0.1]):
        start = true.mean(axis=0) + iod * np.array(push)
        ear = find_ear(load_ears()["front"], rgb, mask, start, iod, right=side == "R")
        assert np.linalg.norm(ear.points_px - true, axis=1).mean() < 0.09 * iod
        assert ear.error_iod < 0.10


@pytest.mark.parametrize("name", ["anna", "boris"])
def test_side_ears_of_the_visitors_are_found(name):
    known = marks(name, "face_side")
    side = "L" if "ear_lobe_L" in known else "R"
    true = np.array([known[f"{n}_{side}"] for n in SIDE_EARS])
    rgb, mask = photo(name, "plain", "face_side").rgb, truth_mask(name, "plain", "face_side").astype(np.uint8) * 255
    iod = float(np.linalg.norm(marks(name, "face_front")["pupil_L"] - marks(name, "face_front")["pupil_R"]))
    start = true.mean(axis=0) + iod * np.array([0.15, -0.12])
    ear = find_ear(load_ears()["side"], rgb, mask, start, iod, right=side == "R")
    assert np.linalg.norm(ear.points_px - true, axis=1).mean() < 0.10 * iod


def test_a_mirrored_photo_gives_the_other_ear():
    known = marks("anna", "face_front")
    iod = float(np.linalg.norm(known["pupil_L"] - known["pupil_R"]))
    rgb, mask = (
        photo("anna", "plain", "face_front").rgb,
        truth_mask("anna", "plain", "face_front").astype(np.uint8) * 255,
    )
    start, last = np.mean([known[f"{n}_L"] for n in FRONT_EARS], axis=0), rgb.shape[1] - 1
    left = find_ear(load_ears()["front"], rgb, mask, start, iod, right=False)
    flipped = [np.ascontiguousarray(image[:, ::-1]) for image in (rgb, mask)]
    right = find_ear(load_ears()["front"], *flipped, np.array([last - start[0], start[1]]), iod, right=True)
    assert np.column_stack([last - right.points_px[:, 0], right.points_px[:, 1]]) == pytest.approx(
        left.points_px, abs=0.03 * iod
    )


def test_light_and_contrast_do_not_change_a_description_but_shape_does():
    y, x = np.mgrid[:80, :64].astype(np.float32)
    edge = (np.hypot(x - 32, y - 40) < 20).astype(np.float32) * 120
    brighter = describe(1.4 * edge + 50)
    assert np.linalg.norm(brighter - describe(edge)) < 0.15 * np.linalg.norm(brighter)
    other = (np.abs(x - 32) < 20).astype(np.float32) * 120
    assert np.linalg.norm(describe(other) - describe(edge)) > 0.5 * np.linalg.norm(brighter)
    assert np.abs(describe(np.full((80, 64), 90, np.float32))).max() < 1e-6
