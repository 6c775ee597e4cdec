"""Where the nets disagree about a person, what they agree about best after a second look counts."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.stages import figures
from cloner.stages.figures import NobodySeen, find_figure

SIZE = (60, 40)


def person(rows):
    """Return a mask (H, W) of somebody who covers so many rows."""
    mask = np.zeros(SIZE, np.float32)
    mask[:rows, 10:30] = 1.0
    return mask


@pytest.fixture
def looked(monkeypatch):
    """Return a function that finds a figure among what the detector and the second look say, by rows covered."""

    def find(view, detected, second, labelled):
        poses = {
            rows: SimpleNamespace(points_px=rows, visibility=1.0, mask=person(rows)) for rows in (detected, second)
        }
        seen = {rows: SimpleNamespace(person=lambda shape, own=own: person(own)) for rows, own in labelled.items()}
        monkeypatch.setattr(figures, "check_people", lambda photo: None)
        monkeypatch.setattr(figures, "DETECTORS", {"pose": lambda rgb, box: poses[detected]})
        monkeypatch.setattr(figures, "pose_by_mirror", lambda rgb, view, pose, detect: pose)
        monkeypatch.setattr(figures, "frontal_face", lambda photo: None)
        monkeypatch.setattr(figures, "_pose_of_undetected", lambda photo: poses.get(second) if second else None)
        monkeypatch.setattr(figures, "_label_person", lambda photo, mask, points, face: seen[points])
        monkeypatch.setattr(figures, "_figure", lambda photo, points, *rest: points)
        return find_figure(SimpleNamespace(rgb=None, view=view, name="photo.jpg"))

    return find


@pytest.mark.parametrize(
    ("view", "detected", "second", "labelled", "wanted"),
    [
        (ViewId.BODY_SIDE, 50, 55, {50: 50, 55: 55}, 50),  # they agree: nobody looks again
        (ViewId.BODY_SIDE, 30, 55, {30: 40, 55: 54}, 55),  # legs lost before a dark wall
        (ViewId.BODY_SIDE, 30, 55, {30: 27, 55: 10}, 30),  # the second look is worse
        (ViewId.BODY_SIDE, 30, 0, {30: 27, 0: 0}, 30),  # or sees nobody
        (ViewId.FACE_FRONT, 30, 55, {30: 40, 55: 54}, 30),  # a face photo is a whole picture
        (ViewId.BODY_SIDE, 0, 55, {0: 0, 55: 54}, 55),  # next to nothing was taken for a person
    ],
)
def test_what_the_nets_agree_about_best_counts(looked, view, detected, second, labelled, wanted):
    assert looked(view, detected, second, labelled) == wanted


def test_nobody_is_seen_where_both_looks_see_next_to_nothing(looked):
    with pytest.raises(NobodySeen):
        looked(ViewId.BODY_SIDE, 0, 0, {0: 0})
