"""A face behind hair is found where the detector sees one and skin shows, never on backs and profiles."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.detectors.face import frontal
from cloner.detectors.face.frontal import frontal_face_behind_hair, skin_share
from cloner.detectors.nets.results import FaceResult
from cloner.frames import ViewId
from cloner.records.labels import Label
from cloner.records.photos import Photo

SIDE = 200
NOSE, LEFT_EAR, RIGHT_EAR = 0, 7, 8


def photo(view: ViewId = ViewId.FACE_FRONT) -> Photo:
    return Photo(view, np.zeros((SIDE, SIDE, 3), np.uint8), None, "0" * 64, f"{view}.jpg")


def pose(nose: float = 100.0, left: float = 140.0, right: float = 60.0) -> np.ndarray:
    points = np.full((33, 2), 100.0)
    points[[NOSE, LEFT_EAR, RIGHT_EAR], 0] = nose, left, right
    return points


def labels(seen_rows: int) -> np.ndarray:
    """Return a head of hair that leaves so many rows of the face's lower end bare."""
    out = np.full((SIDE, SIDE), Label.HAIR, np.uint8)
    out[140 - seen_rows : 140, 60:140] = Label.FACE_SKIN
    return out


@pytest.fixture(autouse=True)
def guessed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Give every photo a face from (60, 60) to (140, 140) that the mesh net hardly sees."""
    angle = np.linspace(0.0, 2.0 * np.pi, 468)
    mesh = 100.0 + 40.0 * np.column_stack([np.cos(angle), np.sin(angle)])
    face = FaceResult(mesh, np.zeros(468), 0.1, 0.0, None, np.array([[115.0, 90.0], [85.0, 90.0]]), mesh)
    answers = {"guessed_face": lambda rgb: face, "refined_face": lambda rgb, points, irises: points}
    monkeypatch.setattr(frontal.DETECTORS, "get", lambda name: answers[name])


def test_a_face_below_a_fringe_is_found_with_the_least_presence_that_counts() -> None:
    face = frontal_face_behind_hair(photo(), pose(), labels(40))
    assert face is not None
    assert face[2] == frontal.LEAST_PRESENCE
    assert face[0].shape == (468, 2)


@pytest.mark.parametrize(
    ("view", "points", "seen"),
    [
        (ViewId.FACE_SIDE, pose(), 40),
        (ViewId.FACE_FRONT, pose(), 5),  # a back: hair alone
        (ViewId.FACE_FRONT, pose(nose=180.0), 40),  # a profile
        (ViewId.FACE_FRONT, pose(left=60.0, right=140.0), 40),  # seen from behind
    ],
)
def test_backs_and_profiles_have_none(view: ViewId, points: np.ndarray, seen: int) -> None:
    assert frontal_face_behind_hair(photo(view), points, labels(seen)) is None


def test_skin_is_counted_inside_the_mesh() -> None:
    mesh = np.array([[60.0, 60.0], [140.0, 60.0], [140.0, 140.0], [60.0, 140.0]])
    assert skin_share(mesh, labels(40)) == pytest.approx(0.5, abs=0.02)
