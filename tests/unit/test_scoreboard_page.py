"""The written scoreboard names every missed bar and every row that a baseline wins."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest

_FILE = Path(__file__).resolve().parents[2] / "benchmarks" / "scoreboard.py"


@pytest.fixture(scope="module")
def scoreboard():
    spec = importlib.util.spec_from_file_location("bench_scoreboard", _FILE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def row(metric, value, generic=None, other=None, *, view=None, set_name="plain"):
    names = ("visitor", "set", "view", "metric", "value", "unit", "generic", "other")
    return dict(zip(names, ("anna", set_name, view, metric, value, "", generic, other), strict=True))


def test_bars_depend_on_set_and_view(scoreboard):
    rows = [
        row("silhouette_iou", 0.93, view="body_front"),
        row("silhouette_iou", 0.93, view="body_three_quarter"),
        row("silhouette_iou", 0.93, view="body_front", set_name="handheld"),
        row("silhouette_iou", 0.89, view="body_side", set_name="handheld"),
        row("stature_error_mm", 4.0),
        row("seconds", 61.0),
        row("peak_mib", None),
    ]
    assert list(scoreboard.missed(rows)) == [
        "anna plain body_front: silhouette IoU 0.930, wanted 0.94",
        "anna handheld body_side: silhouette IoU 0.890, wanted 0.90",
        "anna plain: seconds 61.0, wanted at most 60",
    ]


def test_a_tie_is_lost_and_the_direction_follows_the_metric(scoreboard):
    rows = [
        row("ssim", 0.6, 0.5, 0.7, view="face_three_quarter"),
        row("delta_e", 6.0, 9.0, 5.0),
        row("girth_hip_error_mm", 4.0, 4.0, None),
        row("girth_neck_error_mm", 3.0, 4.0, 5.0),
    ]
    assert [line.split(": ")[1] for line in scoreboard.lost(rows)] == [
        "ssim 0.600, other 0.700",
        "delta_e 6.000, other 5.000",
        "girth_hip_error_mm 4.000, generic 4.000",
    ]
    page = scoreboard.page(rows, "cloner evaluate", 10.0)
    assert "(3 comparisons in 4 rows)" in page
    assert "clone 4 mm, generic human 4 mm, other visitor 5 mm" in page
    assert "| girth_neck_error_mm |  | 3.000 (4.000, 5.000) |" in page
