"""A whole clone of a sample visitor, from photos to files."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest

from cloner.cloning import CloneOutcome
from cloner.frames import BODY_VIEWS, ViewId
from cloner.generic.load import load_generic
from cloner.pipeline import STAGES

pytestmark = pytest.mark.slow


def test_every_file_is_there(cloned_anna: CloneOutcome) -> None:
    files = [path for path in cloned_anna.folder.rglob("*") if path.is_file()]
    names = {path.relative_to(cloned_anna.folder).as_posix() for path in files}
    assert {"clone.npz", "clone.glb", "clone.wrl", "report.html", "report.json"} <= names
    assert any(name.startswith("previews/") and name.endswith((".png", ".jpg")) for name in names)
    assert {*cloned_anna.report["files"], "report.html"} == names
    assert all(path.stat().st_size > 0 for path in files)


def test_report_tells_what_was_promised(cloned_anna: CloneOutcome) -> None:
    report = json.loads((cloned_anna.folder / "report.json").read_text(encoding="utf-8"))
    assert report["stature"]["value_m"] == pytest.approx(1.580, abs=0.005)
    assert [stage["stage"] for stage in report["timings"]["stages"]] == [stage.name for stage in STAGES]
    assert report["side_shown"] == {"body_side": "right", "face_side": "right"}
    assert set(report["features"]) == set(ViewId)
    assert all(measure["plus_minus"] > 0 for measure in report["measures_mm"]["values"].values())
    assert {each["unit"] for each in report["residuals"]} >= {"px", "mm"}
    assert report["versions"]["numpy"] == np.__version__
    assert len(report["models"]) >= 7
    for view in BODY_VIEWS:
        assert report["silhouette_iou"][view] >= 0.94, view


def test_features_lie_on_the_person_in_metres(cloned_anna: CloneOutcome) -> None:
    features = cloned_anna.report["features_m"]
    top = cloned_anna.report["stature"]["value_m"] + cloned_anna.report["stature"]["sole_m"]
    assert features["head_top"][1] == pytest.approx(top, abs=0.005)
    assert features["nose_tip"][2] > features["nape"][2], "the face looks along +z"
    assert features["shoulder_end_left"][0] > 0 > features["shoulder_end_right"][0], "left is +x"
    assert set(features) >= set(load_generic().feature_names)


def test_page_shows_pictures_that_exist_and_loads_nothing_else(cloned_anna: CloneOutcome) -> None:
    html = (cloned_anna.folder / "report.html").read_text(encoding="utf-8")
    sources = [piece.split('"')[0] for piece in html.split('src="')[1:]]
    assert sources
    assert all((cloned_anna.folder / source).is_file() for source in sources)
    assert not re.search(r"https?:", html)
    assert "Anna" in html


def test_clone_stands_on_the_floor(cloned_anna: CloneOutcome) -> None:
    clone = cloned_anna.values["clone"]
    assert clone.vertices_m[:, 1].min() == pytest.approx(0.0, abs=0.004)
