"""Which outline of a side photo is the face's own, and how far a point is believed."""

from __future__ import annotations

import numpy as np

from cloner.fit.cameras import CameraUnknowns
from cloner.frames import ViewId
from cloner.head.ears import PointObservations
from cloner.head.evidence import Params, _face_skin_outline, _without_beard_points
from cloner.head.fit import _point_evidence
from cloner.head.model import make_head_model
from cloner.records.bodies import Phenotype
from cloner.records.labels import Label
from cloner.records.points import ViewPoints
from cloner.records.views import Camera

HEIGHT, WIDTH = 200, 120


def upright_front() -> np.ndarray:
    """Return a straight front, looking to the right at column 80: places and outward normals (200, 4)."""
    rows = np.arange(HEIGHT, dtype=np.float64)
    return np.column_stack([np.full(HEIGHT, 80.0), rows, np.ones(HEIGHT), np.zeros(HEIGHT)])


def labels(**spans: tuple[int, int]) -> np.ndarray:
    """Return face skin with other classes between rows."""
    found = np.full((HEIGHT, WIDTH), Label.FACE_SKIN, np.uint8)
    for name, (top, bottom) in spans.items():
        found[top:bottom] = Label[name.upper()]
    return found


def rows_kept(shown: np.ndarray) -> np.ndarray:
    return _face_skin_outline(upright_front(), shown, tip_row=100.0)[:, 1]


def test_all_of_a_bare_face_is_its_own() -> None:
    assert len(rows_kept(labels())) == HEIGHT
    assert len(rows_kept(np.zeros((HEIGHT, WIDTH), np.uint8))) == HEIGHT, "nobody labelled the photo"


def test_a_beards_outline_is_not_the_chins() -> None:
    kept = rows_kept(labels(beard=(140, 180)))
    assert not ((kept >= 140) & (kept < 180)).any()
    assert {139, 180} <= set(kept)


def test_points_on_a_beard_are_no_mouth_but_an_operators_stay() -> None:
    names = ("nose_tip", "stomion", "chin_front")
    places = np.array([[80.0, 100.0], [80.0, 150.0], [78.0, 170.0]])
    named = ViewPoints(ViewId.FACE_SIDE, names, places, np.full(3, 0.7), np.array([False, False, True]))
    assert _without_beard_points(named, labels(beard=(140, 180))).names == ("nose_tip", "chin_front")
    assert _without_beard_points(named, labels()).names == names


def test_under_a_cap_or_a_fringe_the_face_begins_below() -> None:
    assert rows_kept(labels(hair=(30, 60))).min() > 60.0, "what lies above hair is hidden by it"
    assert not np.isin(np.arange(0, 50), rows_kept(labels(accessory=(0, 50)))).any()


def test_a_point_dragged_far_keeps_its_weight_where_a_proposed_one_is_doubted() -> None:
    """The first drag in a side photo is farthest off all else: doubted for that, it told next to nothing."""
    model = make_head_model(Phenotype(np.zeros(1), 1.7, 0.02, {}, {}))
    pose = np.diag([1.0, -1.0, -1.0, 1.0])
    pose[:3, 3] = [0.0, 1.55, 1.2]
    seen = Camera(900, 1200, 2600.0, pose)
    lobe = np.array([model.generic.feature("ear_lobe_R")] * 2)
    metres = seen.metres_per_pixel(model.vertices_m[lobe[0]])
    away = seen.project(model.vertices_m[lobe]) + [0.0, 0.005 / metres]
    params = Params()
    spots = PointObservations(lobe, away, np.array([0.0025, params.corrected_m]))
    proposed, placed = _point_evidence(model, spots, 0, metres, params, outlier=1.5)
    aim, mean, still = CameraUnknowns(seen), np.zeros(len(model.basis_m)), np.zeros(6)
    weights = [np.min(one.residuals(mean, aim, still).weight) for one in (proposed, placed)]
    assert weights[0] < 0.4
    assert weights[1] > 0.6
