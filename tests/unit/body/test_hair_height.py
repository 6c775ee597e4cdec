"""Hair above the skull, told by the face."""

from types import SimpleNamespace

import numpy as np
import pytest

from cloner.body.hair_height import BALD_SPREAD_MM, CHIN, EYES, SPREAD_MM, USUAL_MM, hair_height_mm, height_above_eyes
from cloner.frames import ViewId
from cloner.records.labels import Label
from cloner.records.silhouettes import Silhouette, SilhouetteSet


def face(eyes_px, chin_px):
    points = np.zeros((468, 2))
    points[list(EYES), 1], points[CHIN, 1] = eyes_px, chin_px
    return points


def outlined(top_px, view=ViewId.BODY_FRONT):
    mask = np.zeros((400, 50), bool)
    mask[top_px:, 10:40] = True
    return SilhouetteSet({view: Silhouette(view, (), mask, ())})


def proposals(points, presence=1.0):
    return SimpleNamespace(views={ViewId.BODY_FRONT: SimpleNamespace(face_px=points, face_presence=presence)})


def test_the_top_is_measured_from_the_eyes_in_lengths_to_the_chin():
    assert height_above_eyes(face(100.0, 120.0), 70.0) == pytest.approx(1.5)


def test_a_higher_top_above_the_same_face_is_higher_hair():
    low, high = (hair_height_mm(proposals(face(100.0, 120.0)), outlined(top))[0] for top in (80, 60))
    assert high > low >= 0.0


def test_a_bare_scalp_has_no_hair_and_is_surely_known():
    labels = np.full((400, 400), Label.FACE_SKIN, np.uint8)
    points = np.tile([[200.0, 230.0]], (468, 1))
    points[list(EYES)], points[[105, 334]] = [(150, 200), (250, 200)], [(155, 180), (245, 180)]
    near = SimpleNamespace(view=ViewId.FACE_FRONT, face_px=points, face_presence=1.0, labels=labels)
    found = proposals(face(100.0, 120.0))
    found.views[ViewId.FACE_FRONT] = near
    assert hair_height_mm(found, outlined(60)) == (0.0, BALD_SPREAD_MM)
    labels[:170] = Label.HAIR
    assert hair_height_mm(found, outlined(60)) == hair_height_mm(proposals(face(100.0, 120.0)), outlined(60))


def test_without_a_face_or_an_outline_hair_is_as_usual():
    usual = (USUAL_MM, SPREAD_MM)
    assert hair_height_mm(proposals(face(100.0, 120.0), presence=0.0), outlined(60)) == usual
    assert hair_height_mm(proposals(face(100.0, 120.0)), outlined(60, ViewId.BODY_BACK)) == usual
