"""Rows and table of the scoreboard, with clones made elsewhere; and what is refused."""

import json

import numpy as np
import pytest

from cloner.errors import ClonerError
from cloner.evaluate import scoreboard
from cloner.evaluate.measuring import CloneRun
from cloner.evaluate.truths.baselines import generic_clone
from cloner.evaluate.truths.truth import given_height_m, read_truth
from cloner.generic.load import load_generic
from cloner.records.points import PointSet

KEYS = ["visitor", "set", "view", "metric", "value", "unit", "generic", "other"]
METRICS = {
    "outline_iou", "outline_mean_px", "outline_p95_px", "silhouette_iou", "body_surface_mean_mm", "body_surface_p95_mm",
    "face_surface_similarity_mm", "face_surface_rigid_mm", "face_landmarks_mean_mm", "face_landmarks_worst_mm",
    "ssim", "delta_e", "region_agreement", "seconds", "cpu_seconds", "floor_seconds", "peak_mib",
}  # fmt: skip


@pytest.mark.gl
@pytest.mark.slow
def test_rows_have_the_promised_form(samples, tmp_path, monkeypatch):
    order = []

    def clone(photos, stature_m, out):
        order.append(("clone", photos.parent.name, round(stature_m, 3)))
        silhouette = read_truth(photos.parent, "plain").views["body_front"].mask
        return CloneRun(
            generic_clone(load_generic(), stature_m), {"body_front": silhouette}, PointSet({}), 9.0, 12.0, 3.0, 700.0
        )

    def read(path, set_name):
        order.append(("truth", path.name, 0))
        return read_truth(path, set_name)

    monkeypatch.setattr(scoreboard, "clone_in_process", clone)
    monkeypatch.setattr(scoreboard, "read_truth", read)
    rows = scoreboard.evaluate_visitors([samples / "anna"], ["plain"], tmp_path)
    # every clone exists before any truth is read; the neighbour is cloned for comparison only
    assert order == [("clone", "anna", 1.58), ("clone", "boris", 1.75), ("truth", "anna", 0)]
    assert all(list(row) == KEYS for row in rows)
    assert {row["metric"] for row in rows if not row["metric"].startswith("girth")} == METRICS
    assert {row["visitor"] for row in rows} == {"anna"}
    assert len({(row["view"], row["metric"]) for row in rows}) == len(rows)
    by_name = {(row["view"], row["metric"]): row for row in rows}
    assert by_name["body_front", "outline_iou"]["value"] == 1.0
    assert by_name[None, "seconds"]["generic"] is None
    surface = by_name[None, "body_surface_mean_mm"]
    assert surface["value"] == surface["generic"], "this clone is the generic human"
    # rulers: generic scaled to stature 9.7-12 mm; slim anna, with the spine laid on her marks, less
    assert 5.0 < surface["value"] < 13.0
    assert surface["other"] > surface["value"]
    assert json.loads((tmp_path / "scoreboard.json").read_text()) == rows
    assert (tmp_path / "anna" / "plain" / "held_out_body_three_quarter.jpg").is_file()
    table = scoreboard.format_table(rows).splitlines()
    assert len(table) == len(rows) + 1
    assert table[0].split() == ["visitor", "set", "view", "metric", "value", "generic", "other", "unit"]
    assert len({line.rstrip().rfind("body_surface_mean_mm") for line in table} - {-1}) == 1


def test_a_folder_without_sets_is_refused(tmp_path):
    with pytest.raises(ClonerError) as caught:
        scoreboard.evaluate_visitors([tmp_path])
    assert "samples/anna" in caught.value.hint


def test_a_visitor_without_truth_is_refused(tmp_path):
    (tmp_path / "plain").mkdir()
    with pytest.raises(ClonerError) as caught:
        scoreboard.evaluate_visitors([tmp_path], ["plain"])
    assert caught.value.where.endswith("truth.json")


def test_truth_of_both_kinds_is_read_in_our_frame(samples):
    for set_name, size in (("plain", (1200, 1800)), ("handheld", (1500, 2000))):
        truth = read_truth(samples / "anna", set_name)
        assert len(truth.views) == 7
        view = truth.views["body_three_quarter"]
        assert (view.camera.width_px, view.camera.height_px) == size
        assert view.mask.shape == view.photo.shape[:2] == size[::-1]
        seen = view.camera.project(view.points_m["nose_tip"][None])[0]
        assert np.linalg.norm(seen - view.marks_px["nose_tip"]) < 2.0, "the half pixel is taken off once"
        row, column = np.round(seen[::-1]).astype(int)
        assert view.mask[row, column]
    assert given_height_m(samples / "boris") == 1.75
