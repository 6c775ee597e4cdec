"""The benchmark's rulers read known errors, and its page names what is wrong."""

from dataclasses import replace
from functools import lru_cache

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.records.bodies import PosedView
from cloner.records.points import PointSet, ViewPoints
from kit.scripts import script

pytestmark = pytest.mark.gl

scores = script("body_scores")
truths = script("body_truth")
tables = script("body_tables")
explained = script("body_explained")
painted = script("painted_people")


@lru_cache(maxsize=1)
def known():
    """Return a person in tight clothes and what is true of him, the shoes left out: no mesh of ours has them apart."""
    person = painted.photograph_person(21, tightness="tight", background="plain", size_px=(400, 600), splits=0)
    truth = truths.known_truth(person)
    shod, surface = truth.surface.points_m[:, 1] < 0.12, truth.surface
    bare = replace(surface, points_m=surface.points_m[~shod], normals=surface.normals[~shod], kind=surface.kind[~shod])
    return person, replace(truth, surface=bare)


def clone_of(person, grown_mm=0.0):
    """Return the dressed truth itself as a clone, grown along its normals."""
    generic = load_generic()
    vertices = person.dressed.vertices_m[: len(person.body.vertices_m)]
    triangles, _ = generic.triangles()
    vertices = vertices + 1e-3 * grown_mm * vertex_normals(vertices, triangles)
    views = {
        ViewId(name): PosedView(ViewId(name), shot.camera, shot.rotations)
        for name, shot in person.shots.items()
        if name != scores.HELD_OUT
    }
    return scores.body_clone(generic, vertices, person.body.joints_m, views, person.body.stature_m, 0.0)


@pytest.mark.slow
@pytest.mark.parametrize("grown_mm", [0.0, 8.0])
def test_a_clone_is_as_wrong_as_it_was_made(grown_mm):
    person, truth = known()
    found = scores.score_step(clone_of(person, grown_mm), load_generic(), truth)
    parts = {name: mean for name, (mean, _) in found["part_mm"].items()}
    for name in ("torso", "pelvis", "thighs", "calves"):
        # 8 mm on every side; armpits and crotch, where both sides grow into each other, read less
        assert parts[name] == pytest.approx(grown_mm, abs=0.6 + 0.2 * grown_mm), f"{name} grown by {grown_mm} mm"
    overlaps = [value for view, value in found["below_head_iou"].items() if view != scores.HELD_OUT]
    # outlines of a perfect clone differ by the shoes, which the clone has not
    assert (np.mean(overlaps) > 0.955) == (grown_mm == 0.0), overlaps
    assert max(found["joints_mm"].values()) < 4.0


def test_a_moved_point_is_called_wrong_by_name():
    _, truth = known()
    true = truth.points_px["body_front"]
    height = np.ptp(np.flatnonzero(truth.views["body_front"].mask.any(axis=1)))
    names = ("l_knee", "r_knee", "crotch")
    places = np.array([true[name] for name in names])
    places[1] += [0.06 * height, 0.0]
    places[2] += [0.04 * height, 0.0]
    view = ViewPoints(ViewId.BODY_FRONT, names, places, np.ones(3), np.zeros(3, bool))
    found = scores.score_points(PointSet({view.view: view}), truth)
    assert found["wrong"] == ["front r_knee"]
    assert found["percent"]["body_front"]["crotch"] == pytest.approx(4.0, abs=0.05)


def test_heads_do_not_count_below_the_head():
    _, truth = known()
    front = truth.views["body_front"].mask
    bald = front & ~truth.head_masks["body_front"]
    assert scores.below_head_overlap(bald, truth, "body_front") > 0.999
    legless = front.copy()
    legless[-200:] = False
    assert scores.below_head_overlap(legless, truth, "body_front") < 0.9


def test_the_true_surface_knows_cloth_from_skin():
    _, truth = known()
    kinds, counts = np.unique(truth.surface.kind, return_counts=True)
    share = dict(zip(kinds, counts / counts.sum(), strict=True))
    assert share["worn"] > 0.5
    assert share["bare"] > 0.05
    assert set(kinds) <= {"bare", "worn", "hair", "organ"}
    assert truth.dressed_girths_mm["hip"] > truth.girths_mm["hip"] + 5.0


def test_a_distribution_tells_median_rare_and_worst():
    assert tables.spread([1.0, 2.0, 3.0, 4.0, 10.0], 1) == "3.0 / 7.6 / 10.0"
    assert tables.spread([0.9, 0.95, 0.99], 2, high=True) == "0.95 / 0.91 / 0.90"
    assert tables.spread([], 1) == "-"


def test_causes_are_told_in_words():
    outlines = {"body_front": (0.91, 0.93), "body_side": (0.99, 0.98)}
    last = {"joints_mm": {"wrist_L": 55.0, "hip_L": 4.0}, "part_mm": {"torso": (12.0, 30.0), "feet": (3.0, 5.0)}}
    row = {
        "outlines": {view: {"outline_iou": iou, "mask_iou": mask} for view, (iou, mask) in outlines.items()},
        "points": {"wrong": ["front l_knee"]},
        "steps": {"finished": last},
    }
    told = explained.explain(row)
    for cause in ("front photo", "wrist_L 55 mm", "torso 12 mm"):
        assert cause in told
    for innocent in ("side photo", "hip_L", "feet", "l_knee"):
        assert innocent not in told
