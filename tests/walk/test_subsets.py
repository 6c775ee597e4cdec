"""Fewer photos are a smaller job: the clone still stands, and says what is weak."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from cloner.cloning import CloneOutcome, clone_folder

pytestmark = pytest.mark.slow


def cloned(tmp_path: Path, source: Path, *names: str) -> CloneOutcome:
    """Clone a copy of some of a visitor's photos with a small texture."""
    photos = tmp_path / "photos"
    photos.mkdir()
    for name in (*names, "person.toml"):
        shutil.copy(source / name, photos / name)
    return clone_folder(photos, tmp_path / "out", texture_size=512)


def told(outcome: CloneOutcome) -> str:
    return " | ".join(outcome.warnings)


def painted(outcome: CloneOutcome) -> np.ndarray:
    """Return the colours of the texture where the generic human's charts lie and no photo was laid."""
    atlas = outcome.values["clone"].atlas
    return atlas.rgb[atlas.coverage == 0].astype(float)


def test_two_face_photos_give_a_head_on_a_body_of_matching_build(tmp_path: Path, samples: Path) -> None:
    outcome = cloned(tmp_path, samples / "anna" / "plain", "face_front.jpg", "face_side.jpg")
    assert "no body photo" in told(outcome)
    report = outcome.report
    assert report["stature"]["value_m"] == pytest.approx(1.58, abs=0.005)
    assert report["measures_mm"]["measured"] is False
    assert set(report["silhouette_iou"]) == {"face_front", "face_side"}
    assert min(report["silhouette_iou"].values()) > 0.80, (
        "with all five photos 0.83 to 0.92: the hair's outline limits it"
    )
    assert np.percentile(painted(outcome), 5) > 12.0, "black holes"
    hair = [len(shell.rgba) for shell in outcome.values["clone"].shells if shell.kind == "hair"]
    assert hair == [512], "a clone for a small texture needs no larger one for its hair"
    attributes = outcome.values["phenotype"].attributes
    assert attributes["sex"] < 0.45, "Anna's face is a woman's, so is the body under it"


def test_three_body_photos_give_their_own_face_with_a_warning(tmp_path: Path, samples: Path) -> None:
    outcome = cloned(tmp_path, samples / "boris" / "plain", "body_front.jpg", "body_side.jpg", "body_back.jpg")
    assert "the face comes from the small one in the body photo" in told(outcome)
    assert "body photo" in told(outcome)
    assert min(outcome.report["silhouette_iou"].values()) > 0.92
    percent = [each for each in outcome.report["residuals"] if each["stage"] == "head" and each["unit"] == "percent"]
    assert percent, "the head says how well it fits"


def test_a_real_portrait_gives_a_person_and_says_what_is_weak(tmp_path: Path) -> None:
    data = pytest.importorskip("skimage.data")
    photos = tmp_path / "astronaut"
    photos.mkdir()
    Image.fromarray(data.astronaut()).save(photos / "face_front.png")  # public domain, NASA
    outcome = clone_folder(photos, tmp_path / "out", texture_size=512)
    for words in (
        "No height",
        "no body photo",
        "no side photo of the face",
        "small in its photo",
        "mouth is open",
        "a guess",
    ):
        assert words in told(outcome), words
    features = outcome.report["features"]["face_front"]
    read_by_eye = {  # in an enlarged picture, to a pixel or two
        "eye_outer_R": (193.3, 101.2),
        "eye_outer_L": (258.2, 103.9),
        "mouth_corner_R": (202.9, 140.0),
        "mouth_corner_L": (244.3, 140.7),
        "nose_tip": (225.3, 127.0),
        "chin_bottom": (221.2, 178.0),
    }
    for name, place in read_by_eye.items():
        off_px = np.hypot(features[name]["x_px"] - place[0], features[name]["y_px"] - place[1])
        assert off_px < 5.0, f"{name} lies {off_px:.1f} px off; the eyes are 62 px apart"
