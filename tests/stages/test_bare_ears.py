"""From behind, a bare ear labelled hair makes no hair as wide as it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.hair.volumes.ears import without_ears
from cloner.hair.volumes.views import HairView, hair_views
from cloner.paint.details.tucking import ear_masks
from cloner.records.clones import Joined
from cloner.records.labels import Label
from cloner.records.proposals import Proposal, Proposals
from cloner.records.silhouettes import SilhouetteSet
from kit import painted, people

GENERIC = load_generic()
EARS = list(ear_masks(GENERIC))


@pytest.fixture(scope="module")
def seen() -> tuple[Joined, dict[ViewId, HairView]]:
    """Return a person and what front and back photo say whose whole head is labelled hair."""
    person = people.known_person(41, spread=0.5)
    fit = painted.joined(person, dict.fromkeys(painted.BODY, np.zeros((94, 3))), {})
    head = GENERIC.segment("head")
    views = {}
    for view in (ViewId.BODY_FRONT, ViewId.BODY_BACK):
        camera = fit.views[view].camera
        mask = np.zeros((camera.height_px, camera.width_px), np.uint8)
        pixel = np.rint(camera.project(person.vertices_m[head])).astype(int)
        mask[pixel[:, 1].min() : pixel[:, 1].max(), pixel[:, 0].min() : pixel[:, 0].max()] = 255
        labels = np.where(mask > 0, np.uint8(Label.HAIR), np.uint8(0))
        nothing = np.zeros((33, 2)), np.zeros(33), np.zeros((468, 2)), np.zeros(468)
        views[view] = Proposal(view, *nothing, 0.0, mask, labels)
    posed = replace(fit, views={view: fit.views[view] for view in views})
    found = hair_views(GENERIC, posed, Proposals(views), SilhouetteSet({}))
    return posed, {one.posed.view: one for one in found}


def shown(view: HairView, points_m: np.ndarray) -> np.ndarray:
    column, row = np.rint(view.posed.camera.project(points_m)).astype(int).T
    return view.hair[row, column]


def outermost(fit: Joined, ear: np.ndarray) -> np.ndarray:
    """Return the tenth of an ear's vertices that stand out most."""
    rows = np.flatnonzero(ear)
    return fit.vertices_m[rows[np.argsort(-np.abs(fit.vertices_m[rows, 0]))[: len(rows) // 10]]]


def test_a_bare_ear_is_no_hair_from_behind(seen: tuple[Joined, dict[ViewId, HairView]]) -> None:
    fit, views = seen
    back = without_ears(views[ViewId.BODY_BACK], fit.vertices_m, EARS[:1])
    assert not shown(back, outermost(fit, EARS[0])).any()
    assert shown(back, outermost(fit, EARS[1])).mean() > 0.9  # hair covers the other one
    crown = fit.vertices_m[GENERIC.region("scalp")]
    assert shown(back, crown[crown[:, 1] > np.quantile(crown[:, 1], 0.5)]).mean() > 0.95


def test_a_front_photo_is_believed(seen: tuple[Joined, dict[ViewId, HairView]]) -> None:
    fit, views = seen
    front = views[ViewId.BODY_FRONT]
    assert without_ears(front, fit.vertices_m, EARS) is front
