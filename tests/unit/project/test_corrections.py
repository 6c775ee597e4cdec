"""Edits are pure, files are checked."""

from __future__ import annotations

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project import corrections as edits
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import Correction, Corrections


def photo_set(digest: str = "d") -> PhotoSet:
    rgb = np.zeros((100, 80, 3), dtype=np.uint8)
    return PhotoSet({ViewId.BODY_FRONT: Photo(ViewId.BODY_FRONT, rgb, None, digest, "body_front.jpg")})


def corrected(x_px: float, y_px: float, digest: str = "d") -> Corrections:
    return edits.move_point(edits.no_corrections(), ViewId.BODY_FRONT, "crotch", x_px, y_px, digest)


def test_moving_leaves_the_old_value_alone() -> None:
    before = corrected(1.0, 2.0)
    after = edits.move_point(before, ViewId.BODY_FRONT, "crotch", 3.0, 4.0, "e")
    assert before.points[ViewId.BODY_FRONT]["crotch"] == Correction(1.0, 2.0, "d")
    assert after.points[ViewId.BODY_FRONT]["crotch"] == Correction(3.0, 4.0, "e")


def test_removing_gives_the_proposal_back() -> None:
    assert not edits.remove_point(corrected(1.0, 2.0), ViewId.BODY_FRONT, "crotch").points
    assert not edits.remove_point(edits.no_corrections(), ViewId.BODY_FRONT, "crotch").points


def test_places_must_be_finite() -> None:
    with pytest.raises(ValueError, match="no place"):
        corrected(float("nan"), 0.0)


views = st.sampled_from(list(ViewId))
places = st.floats(-1e4, 1e4)


@given(st.lists(st.tuples(views, st.text(min_size=1, max_size=8), places, places), max_size=12))
def test_json_there_and_back_returns_the_value(rows: list[tuple[ViewId, str, float, float]]) -> None:
    value = edits.no_corrections()
    for view, name, x_px, y_px in rows:
        value = edits.move_point(value, view, name, x_px, y_px, "sha")
    again = edits.from_json(edits.to_json(value))
    assert {view: dict(named) for view, named in again.points.items()} == {
        view: dict(named) for view, named in value.points.items()
    }


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("{", "not valid JSON"),
        ("[]", '"format": 1'),
        ('{"format": 1, "extra": 0}', "'extra' is not known"),
        ('{"format": 1, "views": []}', "views must be an object"),
        ('{"format": 1, "views": {"body_top": {}}}', "'body_top' is not a view"),
        ('{"format": 1, "views": {"body_front": {"a": 3}}}', "must be an object"),
        ('{"format": 1, "views": {"body_front": {"a": {"x": 1}}}}', 'numbers "x" and "y"'),
        ('{"format": 1, "views": {"body_front": {"a": {"x": "1", "y": 2}}}}', 'numbers "x" and "y"'),
        ('{"format": 1, "views": {"body_front": {"a": {"x": NaN, "y": 2}}}}', 'numbers "x" and "y"'),
        ('{"format": 1, "views": {"body_front": {"a": {"x": 1, "y": 2, "z": 3}}}}', "'z' is not known"),
    ],
)
def test_malformed_files_are_refused(text: str, words: str) -> None:
    with pytest.raises(ClonerError, match=words) as caught:
        edits.from_json(text)
    assert caught.value.where.startswith("corrections.json")
    assert "proposals" in caught.value.hint


@pytest.mark.parametrize(
    ("x_px", "y_px", "inside"), [(-0.5, 0, True), (79.5, 99.5, True), (79.6, 0, False), (0, -1, False)]
)
def test_points_off_the_photo_are_refused(x_px: float, y_px: float, inside: bool) -> None:
    if inside:
        assert edits.check_against(corrected(x_px, y_px), photo_set()) == ()
    else:
        with pytest.raises(ClonerError, match="outside the photo of 80 x 100") as caught:
            edits.check_against(corrected(x_px, y_px), photo_set())
        assert caught.value.where == "corrections.json, body_front.crotch"


def test_unknown_names_are_refused_where_names_are_known() -> None:
    edits.check_against(corrected(1, 1), photo_set(), ["crotch"])
    with pytest.raises(ClonerError, match="no feature point of this name"):
        edits.check_against(corrected(1, 1), photo_set(), ["knee"])


def test_a_changed_photo_is_flagged_and_a_missing_one_too() -> None:
    assert "has changed" in edits.check_against(corrected(1, 1), photo_set("other"))[0]
    assert edits.check_against(corrected(1, 1, ""), photo_set("other")) == ()
    assert "no such photo" in edits.check_against(corrected(1, 1), PhotoSet({}))[0]


def test_the_file_is_what_the_documents_say() -> None:
    assert json.loads(edits.to_json(corrected(1.5, 2.5))) == {
        "format": 1,
        "views": {"body_front": {"crotch": {"x": 1.5, "y": 2.5, "photo_sha256": "d"}}},
    }
