"""Bodies have the measures that were told, on the product's tape and on one of another make."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh
from scipy.spatial import ConvexHull

from cloner.bodies.children import USUAL_AGE
from cloner.bodies.family import round_body, usual_body
from cloner.bodies.measured import measured_body, remeasured_body
from cloner.bodies.ruler import girth_slopes, level_slopes, read
from cloner.bodies.telling import GIRTHS, BodySpecification, untold_mm
from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measures import girth_planes, mean_girth_mm
from cloner.geometry.meshes.triangles import edges_of
from cloner.records.bodies import BodyMesh

STOUT = BodySpecification("f", 1.68, {"bust_girth": 1090.0, "waist_girth": 980.0, "hip_girth": 1160.0})
TAILOR = BodySpecification(
    "m",
    1.80,
    {
        "neck_girth": 390.0, "bust_girth": 1000.0, "waist_girth": 850.0, "hip_girth": 990.0, "thigh_girth": 570.0,
        "calf_girth": 380.0, "upper_arm_girth": 320.0, "inside_leg_height": 860.0, "arm_length": 640.0,
        "shoulder_width": 455.0,
    },
)  # fmt: skip


def foreign_girth_mm(body: BodyMesh, height_m: float) -> float:
    """Return the hull of trimesh's own plane cut through the trunk, mm: arms are cut off where they leave it."""
    generic, rules = load_generic(), load_tape_rules()
    mesh = trimesh.Trimesh(body.vertices_m, rules.torso, process=False)
    assert len(generic.vertices_m) == len(mesh.vertices)
    lines = trimesh.intersections.mesh_plane(mesh, [0.0, 1.0, 0.0], [0.0, height_m, 0.0])
    points = lines.reshape(-1, 3)[:, [0, 2]]
    hull = points[ConvexHull(points).vertices]
    return float(np.linalg.norm(hull - np.roll(hull, 1, axis=0), axis=1).sum() * 1e3)


@pytest.mark.parametrize("told", [STOUT, TAILOR], ids=["stout", "tailor"])
def test_every_told_measure_is_met(told: BodySpecification) -> None:
    body, rules = measured_body(told), load_tape_rules()
    shown = read(body.vertices_m, body.joints_m, rules, tuple(told.mm)).mm
    for key, value in told.mm.items():
        assert shown[key] == pytest.approx(value, abs=1.0 if key.endswith("girth") else 3.0), key
    assert body.vertices_m[load_generic().feature("head_top"), 1] == pytest.approx(told.stature_m, abs=0.001)


def test_a_tape_of_another_make_reads_the_same() -> None:
    body, rules = measured_body(STOUT), load_tape_rules()
    planes = girth_planes(body.vertices_m, body.joints_m, rules, tuple(STOUT.mm))
    for key, value in STOUT.mm.items():
        assert foreign_girth_mm(body, float(planes[key][0].point_m[1])) == pytest.approx(value, abs=1.0), key


def test_a_waist_beyond_the_hips_is_met_over_the_seat() -> None:
    told = BodySpecification("f", 1.65, {"bust_girth": 1100.0, "waist_girth": 1150.0, "hip_girth": 1060.0})
    assert told.seat
    body = measured_body(told)
    seat = body.vertices_m[[load_generic().feature(f"buttock_{side}") for side in ("left", "right")], 1].mean()
    assert foreign_girth_mm(body, float(seat)) == pytest.approx(1060.0, abs=1.0)


def test_a_child_has_a_child_s_proportions_and_what_was_told() -> None:
    told = BodySpecification("m", 1.28, {"bust_girth": 640.0, "waist_girth": 580.0, "hip_girth": 690.0}, 8.0)
    child, man = measured_body(told), measured_body(BodySpecification("m", 1.76, {}))
    shown = read(child.vertices_m, child.joints_m, load_tape_rules(), tuple(told.mm)).mm
    for key, value in told.mm.items():
        assert shown[key] == pytest.approx(value, abs=1.0), key
    head = load_generic().head_blend > 0.999
    heads = [np.ptp(body.vertices_m[head, 1]) / stature for body, stature in ((child, 1.28), (man, 1.76))]
    assert heads[0] > 1.15 * heads[1]
    assert child.vertices_m[load_generic().feature("head_top"), 1] == pytest.approx(1.28, abs=0.001)


def test_the_head_keeps_its_shape_whatever_the_tape_says() -> None:
    generic = load_generic()
    skull = generic.head_blend > 0.999
    slim, stout = (
        measured_body(BodySpecification("f", 1.68, {"waist_girth": waist})).vertices_m for waist in (700.0, 1000.0)
    )
    apart = stout[skull] - slim[skull]
    assert np.ptp(apart, axis=0).max() < 1e-5
    assert np.abs(apart[:, [0, 1]]).max() < 1e-5
    assert generic.vertices_m[skull, 1].min() > 1.4


def test_no_skin_turns_over_in_an_extreme_body() -> None:
    told = BodySpecification("m", 1.75, {"bust_girth": 1310.0, "waist_girth": 1250.0, "hip_girth": 1240.0})
    generic, after = load_generic(), measured_body(told).vertices_m
    triangles = generic.triangles()[0]
    before = generic.vertices_m.astype(float)

    def normals(points: np.ndarray) -> np.ndarray:
        return np.cross(*(points[triangles[:, k]] - points[triangles[:, 0]] for k in (1, 2)))

    assert (np.einsum("ij,ij->i", normals(before), normals(after)) > 0.0).all()
    edges, _ = edges_of(triangles)
    stretch = np.linalg.norm(np.diff(after[edges], axis=1), axis=2) / np.linalg.norm(
        np.diff(before[edges], axis=1), axis=2
    )
    assert np.median(stretch) == pytest.approx(1.15, abs=0.15)


def test_what_is_not_told_is_likely_beside_what_is() -> None:
    """The family's men have thin ankles: nearest to the told measures alone they lie 3.6 spreads below the table's."""
    told = BodySpecification("m", 1.80, {"bust_girth": 1190.0, "waist_girth": 1060.0, "hip_girth": 1130.0})
    body, usual = measured_body(told), untold_mm(told)
    girths = tuple(key for key in usual if key in GIRTHS)
    shown = read(body.vertices_m, body.joints_m, load_tape_rules(), girths).mm
    assert len(girths) > 6
    assert max(abs(shown[key] - usual[key][0]) / usual[key][1] for key in girths) < 2.0


def test_a_body_told_what_it_has_stays_as_it_is() -> None:
    base, rules = usual_body("f", 1.70, USUAL_AGE), load_tape_rules()
    own = read(base.vertices_m, base.joints_m, rules, ("waist_girth", "hip_girth")).mm
    again = remeasured_body(base, BodySpecification("f", 1.70, dict(own)))
    assert np.abs(again.vertices_m - base.vertices_m).max() < 1e-5


def test_slopes_of_a_girth_are_those_of_the_tape() -> None:
    family, rules = round_body(usual_body("f", 1.70, USUAL_AGE), 1.70), load_tape_rules()
    body = family.base
    for key in ("bust_girth", "thigh_girth"):
        planes = girth_planes(body.vertices_m, body.joints_m, rules, (key,))
        slopes = girth_slopes(body.vertices_m, family.modes_m, planes[key], level_slopes(family.modes_m, rules, key))
        row = int(np.abs(slopes).argmax())
        own = np.zeros(len(slopes))
        own[row] = 0.05
        moved = family.body(own)
        after = girth_planes(moved.vertices_m, moved.joints_m, rules, (key,))
        change = (mean_girth_mm(moved.vertices_m, after[key]) - mean_girth_mm(body.vertices_m, planes[key])) / 0.05
        assert slopes[row] == pytest.approx(change, rel=0.1), key


def test_joints_stay_inside_the_limbs_that_grew() -> None:
    body, generic = measured_body(TAILOR), load_generic()
    for side in ("l", "r"):
        chain = body.joints_m[[generic.joint(f"{side}_{name}") for name in ("shoulder", "elbow", "wrist")]]
        bones = np.linalg.norm(np.diff(chain, axis=0), axis=1).sum()
        assert 0.8 * 0.64 < bones < 0.64  # the tape runs outside the bones
        crotch = body.vertices_m[generic.feature("crotch"), 1]
        hip, knee = body.joints_m[[generic.joint(f"{side}_{name}") for name in ("hip", "knee")], 1]
        assert knee < crotch < hip + 0.03
