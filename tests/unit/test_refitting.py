"""What a second run may take over from a first one, and what a moved point changes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.interactive.refitting import moved_points, reusable_values
from cloner.pipeline import STAGES
from cloner.project.corrections import move_point, no_corrections
from cloner.records.photos import Person, Photo, PhotoSet
from cloner.records.points import Corrections, PointSet, ViewPoints
from cloner.records.silhouettes import Silhouette, SilhouetteSet

FRONT = ViewId.BODY_FRONT
PERSON = Person("someone", "", 1.7)
#: Values that the stages give from the body's fit on.
FIT = {"views", "silhouettes", "phenotype", "skeletons", "rough_bodies", "body"}
PLACES = {
    "head_top": (200.0, 50.0), "sole_left": (220.0, 950.0), "sole_right": (180.0, 950.0), "l_knee": (215.0, 700.0),
    "waist_left": (250.0, 400.0), "nose_tip": (200.0, 120.0),
}  # fmt: skip


def photos(**digests: str) -> PhotoSet:
    blank = np.zeros((1000, 400, 3), dtype=np.uint8)
    return PhotoSet({ViewId(view): Photo(ViewId(view), blank, None, digest, "") for view, digest in digests.items()})


def points(*names: str) -> PointSet:
    places = np.array([PLACES[name] for name in names])
    return PointSet({FRONT: ViewPoints(FRONT, names, places, np.full(len(names), 0.6), np.zeros(len(names), bool))})


@pytest.fixture
def known() -> dict[str, Any]:
    """All values of a run; the outline is a box whose right side passes through the waist."""
    box = np.array([[x, y] for y in range(50, 951) for x in (150.0, 250.0)], dtype=np.float64)
    outline = Silhouette(FRONT, (box,), np.zeros((1000, 400), dtype=bool), ())
    values: dict[str, Any] = {name: f"old {name}" for stage in STAGES for name in stage.gives}
    return values | {
        "photos": photos(body_front="a"),
        "person": PERSON,
        "corrections": no_corrections(),
        "body_points": points("head_top", "sole_left", "sole_right", "l_knee", "waist_left"),
        "face_points": points("nose_tip"),
        "silhouettes": SilhouetteSet({FRONT: outline}),
    }


def corrected(name: str, x_px: float, y_px: float) -> Corrections:
    return move_point(no_corrections(), FRONT, name, x_px, y_px, "a")


def kept(known: dict[str, Any], corrections: Corrections, person: Person = PERSON, digest: str = "a") -> set[str]:
    return set(reusable_values(known, photos(body_front=digest), person, corrections))


def test_other_photos_keep_nothing(known: dict[str, Any]) -> None:
    assert kept(known, no_corrections(), digest="b") == set()
    assert kept({"proposals": "found"}, no_corrections()) == set()


def test_proposals_alone_are_kept_from_a_run_that_only_proposed(known: dict[str, Any]) -> None:
    first = {"photos": known["photos"], "proposals": "found"}
    assert reusable_values(first, photos(body_front="a"), PERSON, no_corrections()) == {"proposals": "found"}


def test_nothing_moved_keeps_all_but_the_painted_clone(known: dict[str, Any]) -> None:
    everything = {name for stage in STAGES for name in stage.gives}
    assert kept(known, no_corrections()) == everything - {"painted", "surfaces", "clone"}


def test_a_point_moved_on_the_outline_keeps_the_fit_and_changes_what_comes_after(known: dict[str, Any]) -> None:
    left = kept(known, corrected("waist_left", 262.0, 400.0))
    assert left >= FIT | {"proposals", "head", "joined"}
    assert not left & {"obeyed", "obeyed_silhouettes", "measures", "shells", "painted", "surfaces", "clone"}


@pytest.mark.parametrize(
    ("name", "place"), [("waist_left", (320.0, 400.0)), ("head_top", (200.0, 60.0)), ("l_knee", (260.0, 700.0))]
)
def test_gross_points_and_the_ends_change_the_fit(known: dict[str, Any], name: str, place: tuple[float, float]) -> None:
    left = kept(known, corrected(name, *place))
    assert "proposals" in left
    assert not left & (FIT - {"views"}), "a far point, a joint far off, or the photo's scale"


def test_a_small_move_of_a_joint_keeps_the_fit(known: dict[str, Any]) -> None:
    assert kept(known, corrected("l_knee", 225.0, 700.0)) >= FIT | {"joined"}


def test_a_face_point_never_refits_the_body(known: dict[str, Any]) -> None:
    left = kept(known, corrected("nose_tip", 204.0, 121.0))
    assert left >= FIT
    assert not left & {"head", "joined", "obeyed"}


def test_another_height_changes_the_fit(known: dict[str, Any]) -> None:
    left = kept(known, no_corrections(), person=Person("someone", "", 1.8))
    assert left >= {"proposals", "body_points", "silhouettes"}
    assert not left & {"views", "phenotype", "joined", "obeyed"}


def test_a_correction_taken_back_gives_the_proposal_again(known: dict[str, Any]) -> None:
    moved, _ = moved_points(known, corrected("waist_left", 262.0, 400.0))
    assert moved.views[FRONT].get("waist_left") == pytest.approx([262.0, 400.0])
    back, _ = moved_points({**known, "body_points": moved}, no_corrections())
    assert back.views[FRONT].get("waist_left") == pytest.approx([250.0, 400.0])
    assert not back.views[FRONT].corrected.any()
