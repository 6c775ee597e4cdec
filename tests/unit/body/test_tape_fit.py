"""Tape measures against the generic body: what is too slim grows, what is wide enough stays."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.body.tape_fit import fit_tape_measures
from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measures import girth_planes, mean_girth_mm, slice_points
from cloner.records.bodies import BodyMesh


@pytest.fixture(scope="module")
def body() -> BodyMesh:
    return BodyMesh(*load_generic().shape(np.zeros(0), 1.70))


def girths(body: BodyMesh) -> dict[str, float]:
    planes = girth_planes(body.vertices_m, body.joints_m, load_tape_rules())
    return {key: mean_girth_mm(body.vertices_m, own) for key, own in planes.items()}


def width_and_depth_mm(body: BodyMesh, key: str) -> np.ndarray:
    plane = girth_planes(body.vertices_m, body.joints_m, load_tape_rules())[key][0]
    return 1e3 * np.ptp(slice_points(body.vertices_m, plane.triangles, plane.point_m, plane.normal), axis=0)[[0, 2]]


def test_slim_slices_grow_to_the_tape_and_the_rest_stays(body: BodyMesh) -> None:
    before = girths(body)
    tape = {
        "bust_girth": 40.0,
        "narrowest_waist_girth": 30.0,
        "hip_girth": 50.0,
        "thigh_girth": 25.0,
        "calf_girth": 15.0,
    }
    wanted = {key: before[key] + more for key, more in tape.items()} | {
        "upper_arm_girth": before["upper_arm_girth"] - 40
    }
    taped = fit_tape_measures(body, wanted, side_seen=True)
    after = girths(taped)
    for key in tape:
        assert after[key] == pytest.approx(wanted[key], abs=3.0), key
    assert after["upper_arm_girth"] == pytest.approx(before["upper_arm_girth"], abs=0.5), "that is a sleeve"
    away = np.linalg.norm(taped.vertices_m - body.vertices_m, axis=1)
    generic = load_generic()
    head = generic.vertex_segment == generic.segment_names.index("head")
    assert away[head].max() < 1e-3, "nobody taped the head"
    assert away.max() < 0.03
    first, last = generic.quads[:, 0], generic.quads[:, 2]
    apart = np.maximum(np.linalg.norm(body.vertices_m[first] - body.vertices_m[last], axis=1), 0.004)
    assert (np.abs(away[first] - away[last]) / apart).max() < 0.5, "no steps in the skin"


@pytest.mark.parametrize("side_seen", [True, False])
def test_seen_outlines_give_way_last(body: BodyMesh, side_seen: bool) -> None:
    before = width_and_depth_mm(body, "navel_girth")
    tape = {"navel_girth": girths(body)["navel_girth"] + (20.0 if side_seen else 40.0)}
    taped = fit_tape_measures(body, tape, side_seen=side_seen)
    assert girths(taped)["navel_girth"] == pytest.approx(tape["navel_girth"], abs=1.5)
    wider, deeper = width_and_depth_mm(taped, "navel_girth") - before
    assert abs(wider) < 3.0, "every photo from the front shows the width"
    if side_seen:
        assert abs(deeper) < 3.0, "corners grow where no outline lies"
    else:
        assert deeper > 5.0, "nobody saw the depth"


def test_tapes_below_the_outline_and_lengths_change_nothing(body: BodyMesh) -> None:
    before = girths(body)
    loose = {"hip_girth": before["hip_girth"] - 60.0, "inside_leg_height": 900.0, "arm_length": 700.0}
    for tape in (loose, {}):
        assert np.array_equal(fit_tape_measures(body, tape, side_seen=True).vertices_m, body.vertices_m)
