"""Masks get sharper, never worse than a bound; hair is hair."""

from __future__ import annotations

from functools import lru_cache

import cv2
import numpy as np
import pytest

from cloner.detectors.litert import detect_face, detect_pose
from cloner.detectors.results import PoseResult
from cloner.vision.hair import CLOTH, HAIR, SKIN
from cloner.vision.masks import head_hair_labels, refine_mask
from kit.visitors import NAMES, SETS, VIEWS, overlap, photo, truth_mask

# measured means .986 .978 .981 (bodies), .995 .988 .983 (faces); here the worst photo
LEAST = {"plain": (0.965, 0.985), "booth": (0.970, 0.970), "handheld": (0.960, 0.983)}


@lru_cache(maxsize=4)
def seen(name: str, set_name: str, view: str) -> tuple[PoseResult, np.ndarray]:
    rgb = photo(name, set_name, view).rgb
    pose = detect_pose(rgb)
    assert pose is not None
    return pose, refine_mask(rgb, pose.mask, pose.points_px if view.startswith("body") else None)


def check(name: str, set_name: str, view: str) -> float:
    _, mask = seen(name, set_name, view)
    found = overlap(mask > 0.5, truth_mask(name, set_name, view))
    assert found > LEAST[set_name][view.startswith("face")], f"{name} {set_name} {view} {found:.4f}"
    return found


@pytest.mark.parametrize("set_name", SETS)
@pytest.mark.parametrize("view", ["body_front", "face_side"])
def test_mask_overlap(set_name: str, view: str) -> None:
    check("anna", set_name, view)


@pytest.mark.slow
@pytest.mark.parametrize("set_name", SETS)
def test_mask_overlap_of_all_photos(set_name: str) -> None:
    found = {v: [check(n, set_name, v) for n in NAMES] for v in VIEWS}
    body = float(np.mean([found[v] for v in VIEWS if v.startswith("body")]))
    assert body > {"plain": 0.983, "booth": 0.975, "handheld": 0.977}[set_name]


def test_grey_low_contrast_photo_is_not_made_worse() -> None:
    rgb = photo("anna", "plain", "body_front").rgb
    grey = cv2.cvtColor(rgb, cv2.COLOR_RGB2GRAY)
    flat = np.dstack([(grey * 0.35 + 80).astype(np.uint8)] * 3)
    pose = detect_pose(flat)
    assert pose is not None
    truth = truth_mask("anna", "plain", "body_front")
    before = overlap(pose.mask > 0.5, truth)
    after = overlap(refine_mask(flat, pose.mask) > 0.5, truth)
    assert before > 0.93
    assert after > before - 0.003


def test_flat_picture_keeps_its_probability() -> None:
    rgb = np.full((300, 200, 3), 90, np.uint8)
    probability = np.zeros((300, 200), np.float32)
    probability[50:250, 60:140] = 1.0
    kept = refine_mask(rgb, probability)
    assert overlap(kept > 0.5, probability > 0.5) > 0.99
    assert not (refine_mask(rgb, np.zeros_like(probability)) > 0.5).any()
    with pytest.raises(ValueError, match="differ"):
        refine_mask(rgb[1:], probability)


def labels(name: str, set_name: str, view: str) -> np.ndarray:
    pose, mask = seen(name, set_name, view)
    rgb = photo(name, set_name, view).rgb
    face = detect_face(rgb) if view.endswith("front") else None
    points = None if face is None else face.points_px
    return head_hair_labels(rgb, mask, points, view, pose_points=pose.points_px)


@pytest.mark.parametrize("set_name", SETS)
def test_ponytail_is_hair(set_name: str) -> None:
    found = labels("anna", set_name, "body_back")
    rows = np.flatnonzero((found == HAIR).any(axis=1))
    person = np.flatnonzero(truth_mask("anna", set_name, "body_back").any(axis=1))
    length = (rows[-1] - rows[0]) / (person[-1] - person[0])
    assert 0.16 < length < 0.26, length  # read off the photos: 0.19
    _, mask = seen("anna", set_name, "body_back")
    assert ((found > 0) == (mask > 0.5)).all()


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("set_name", ["plain", "booth"])
def test_front_face_is_skin_under_hair(name: str, set_name: str) -> None:
    found = labels(name, set_name, "face_front")
    face = detect_face(photo(name, set_name, "face_front").rgb)
    assert face is not None
    for index in (50, 280, 4, 152):  # cheeks, nose, chin
        x, y = np.round(face.points_px[index]).astype(int)
        assert found[y - 3, x] == SKIN, f"{name} {set_name} {index}"
    hair = np.argwhere(found == HAIR)
    assert len(hair) > 0.01 * found.size
    assert hair[:, 0].mean() < face.points_px[10, 1] + 60
    assert found[-20, found.shape[1] // 2] == CLOTH


def test_bald_head_has_no_hair() -> None:
    rgb = photo("boris", "plain", "face_front").rgb.copy()
    found = labels("boris", "plain", "face_front")
    skin = np.median(rgb[found == SKIN], axis=0)
    noise = np.random.default_rng(3).normal(0, 4, (*rgb.shape[:2], 3))
    bald = np.where((found == HAIR)[..., None], np.clip(skin + noise, 0, 255), rgb).astype(np.uint8)
    _, mask = seen("boris", "plain", "face_front")
    face = detect_face(bald)
    assert face is not None
    again = head_hair_labels(bald, mask, face.points_px, "face_front")
    assert (again == HAIR).sum() < 0.1 * (found == HAIR).sum()
