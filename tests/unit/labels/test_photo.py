"""The label picture of the samples' photos, and of photos that nobody is on."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import pytest

from cloner.detectors.nets.litert import detect_face, detect_pose, label_features
from cloner.frames import ViewId
from cloner.labels.evidence import label_evidence
from cloner.labels.photo import label_photo
from cloner.records.labels import CLOTHES, Label, shows
from cloner.vision.segmentation.masks import refine_mask
from kit.visitors import NAMES, SETS, photo, truth_mask


@lru_cache(maxsize=8)
def labels(name: str, set_name: str, view: str) -> np.ndarray:
    rgb = photo(name, set_name, view).rgb
    pose = detect_pose(rgb)
    assert pose is not None
    mask = refine_mask(rgb, pose.mask, pose.points_px if view.startswith("body") else None) > 0.5
    face = detect_face(rgb) if view.endswith("front") else None
    points = None if face is None else face.points_px
    looks = label_evidence(rgb, mask, ViewId(view), label_features, face_points=points, pose_points=pose.points_px)
    found, sure = label_photo(rgb, mask, looks, points)
    assert ((found > 0) == mask).all()
    assert sure.shape == found.shape
    return found


@pytest.mark.parametrize("set_name", SETS)
def test_ponytail_is_hair(set_name: str) -> None:
    found = labels("anna", set_name, "body_back")
    rows = np.flatnonzero((found == Label.HAIR).any(axis=1))
    person = np.flatnonzero(truth_mask("anna", set_name, "body_back").any(axis=1))
    length = (rows[-1] - rows[0]) / (person[-1] - person[0])
    assert 0.16 < length < 0.26, length  # read off the photos: 0.19


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("set_name", ["plain", "booth"])
def test_front_face_is_skin_under_hair_over_clothes(name: str, set_name: str) -> None:
    found = labels(name, set_name, "face_front")
    face = detect_face(photo(name, set_name, "face_front").rgb)
    assert face is not None
    for index in (50, 280, 4, 152):  # cheeks, nose, chin
        x, y = np.round(face.points_px[index]).astype(int)
        assert found[y - 3, x] == Label.FACE_SKIN, f"{name} {set_name} {index}"
    hair = np.argwhere(found == Label.HAIR)
    assert len(hair) > 0.01 * found.size
    assert hair[:, 0].mean() < face.points_px[10, 1] + 60
    assert shows(found, *CLOTHES)[-20, found.shape[1] // 2]


def test_a_dressed_body_has_clothes_above_and_below_and_shoes() -> None:
    found = labels("boris", "plain", "body_front")
    rows = np.flatnonzero((found > 0).any(axis=1))
    height = np.ptp(rows)
    middles = {
        label: (np.argwhere(found == label)[:, 0].mean() - rows[0]) / height
        for label in (Label.FACE_SKIN, Label.UPPER_CLOTHES, Label.LOWER_CLOTHES, Label.SHOES)
    }
    # a head is an eighth of a person, shirts end above the crotch, feet stand at the bottom
    assert middles[Label.FACE_SKIN] < 0.14
    assert 0.15 < middles[Label.UPPER_CLOTHES] < 0.5
    assert 0.5 < middles[Label.LOWER_CLOTHES] < 0.85
    assert middles[Label.SHOES] > 0.92


def test_the_net_tells_the_person_from_the_room() -> None:
    rgb = photo("anna", "booth", "face_side").rgb
    pose = detect_pose(rgb)
    assert pose is not None
    looks = label_evidence(rgb, pose.mask > 0.5, ViewId.FACE_SIDE, label_features, pose_points=pose.points_px)
    found = looks.person(rgb.shape[:2]) > 0.5
    true = truth_mask("anna", "booth", "face_side")
    assert (found & true).sum() / (found | true).sum() > 0.93  # crops of 256 px: 6 px of the photo each
