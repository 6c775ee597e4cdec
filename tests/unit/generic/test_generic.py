"""The shipped generic human keeps its promises."""

from __future__ import annotations

import hashlib
import importlib.resources
import json

import numpy as np
import numpy.typing as npt
import pytest

from cloner.generic.load import GenericHuman, load_generic

Floats = npt.NDArray[np.float64]


@pytest.fixture(scope="module")
def generic() -> GenericHuman:
    return load_generic()


def _body_triangles(generic: GenericHuman) -> npt.NDArray[np.integer]:
    corners, _ = generic.triangles()
    return corners[(generic.vertex_part[corners] == 0).all(axis=1)]


def _winding(points: Floats, vertices: Floats, triangles: npt.NDArray[np.integer]) -> Floats:
    """Return each point's winding number: 1 inside a closed surface, 0 outside (Van Oosterom, Strackee 1983)."""
    out = np.zeros(len(points))
    for row, point in enumerate(points):
        a, b, c = (vertices[triangles[:, k]] - point for k in range(3))
        la, lb, lc = (np.linalg.norm(x, axis=1) for x in (a, b, c))
        up = np.einsum("ij,ij->i", a, np.cross(b, c))
        down = la * lb * lc + (a * b).sum(1) * lc + (b * c).sum(1) * la + (c * a).sum(1) * lb
        out[row] = 2.0 * np.arctan2(up, down).sum() / (4.0 * np.pi)
    return out


def test_files_are_the_ones_that_were_built() -> None:
    folder = importlib.resources.files("cloner_models")
    recorded = json.loads((folder / "PROVENANCE.json").read_text())["outputs"]
    assert {"body.npz", "head.npz"} <= set(recorded)
    for name, digest in recorded.items():
        assert hashlib.sha256((folder / name).read_bytes()).hexdigest() == digest, name


def test_arrays_are_read_only(generic: GenericHuman) -> None:
    with pytest.raises(ValueError, match="read-only"):
        generic.vertices_m[0, 0] = 1.0


def test_body_is_watertight_and_faces_outward(generic: GenericHuman) -> None:
    triangles = _body_triangles(generic)
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    there = {(int(a), int(b)) for a, b in edges}
    assert len(there) == len(edges), "an edge is used twice in one direction"
    assert all((b, a) in there for a, b in there), "an edge has no partner"
    a, b, c = (generic.vertices_m[triangles[:, k]].astype(np.float64) for k in range(3))
    litres = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6 * 1000
    assert 40 < litres < 90  # a person of 1.70 m weighs about as many kilograms


def test_eyeballs_face_outward(generic: GenericHuman) -> None:
    corners, _ = generic.triangles()
    for name in ("eye_left", "eye_right"):
        rows = generic.part(name)
        own = corners[np.isin(corners[:, 0], rows)]
        a, b, c = (generic.vertices_m[own[:, k]] - generic.vertices_m[rows].mean(axis=0) for k in range(3))
        assert np.einsum("ij,ij->i", a, np.cross(b, c)).min() > 0, name


def test_skin_weights(generic: GenericHuman) -> None:
    assert generic.skin_weights.shape == (len(generic.vertices_m), 4)
    assert generic.skin_weights.min() >= 0
    np.testing.assert_allclose(generic.skin_weights.sum(axis=1), 1.0, atol=1e-6)
    np.testing.assert_allclose(generic.segment_weights.sum(axis=1), 1.0, atol=2e-3)  # stored as half floats


def test_joints_are_h_anim(generic: GenericHuman) -> None:
    assert len(generic.joint_names) == 94 == len(set(generic.joint_names))
    assert generic.joint_names[0] == "HumanoidRoot"
    assert generic.joint_parents[0] == -1
    assert all(0 <= p < k for k, p in enumerate(generic.joint_parents.tolist()) if k)
    assert generic.joint_names[generic.joint_parents[generic.joint("l_shoulder")]] == "l_acromioclavicular"
    assert generic.joints_m[generic.joint("l_hip"), 0] > 0 > generic.joints_m[generic.joint("r_hip"), 0]


def test_joints_lie_inside_the_body(generic: GenericHuman) -> None:
    # The eyes' own joints sit in the sockets, which the closed body surface leaves outside.
    names = [n for n in generic.joint_names if "eyeball" not in n and "eyelid" not in n]
    rng = np.random.default_rng(5)
    for c in (np.zeros(36), 0.8 * rng.normal(size=36), 0.8 * rng.normal(size=36)):
        vertices, joints = generic.shape(c, 1.7)
        inside = _winding(joints[[generic.joint(n) for n in names]], vertices, _body_triangles(generic))
        assert not [n for n, w in zip(names, inside, strict=True) if w < 0.5]


def test_mirror_symmetry(generic: GenericHuman) -> None:
    twin, flip = generic.mirror, np.array([-1.0, 1.0, 1.0])
    assert (twin[twin] == np.arange(len(twin))).all()
    assert np.abs(generic.vertices_m[twin] * flip - generic.vertices_m).max() < 1e-5
    assert np.abs(generic.shape_basis[:, twin] * flip - generic.shape_basis).max() < 1e-4
    left, right = generic.region("ear_left"), generic.region("ear_right")
    assert (left[twin] == right).all()
    weights = np.zeros((len(twin), 94))
    np.put_along_axis(weights, generic.skin_joints.astype(np.int64), generic.skin_weights, axis=1)
    other = [generic.joint({"l_": "r_", "r_": "l_"}.get(n[:2], n[:2]) + n[2:]) for n in generic.joint_names]
    assert np.abs(weights[twin][:, other] - weights).max() < 1e-5


def test_shape_reaches_the_stature_exactly(generic: GenericHuman) -> None:
    rng = np.random.default_rng(1)
    soles = [6280, 12877, 6164, 12761, 6461, 13057]
    for stature_m in (1.2, 1.58, 1.95):
        for _ in range(5):
            vertices, joints = generic.shape(rng.normal(size=36), stature_m)
            top, floor = vertices[generic.feature("head_top"), 1], vertices[soles, 1].mean()
            assert abs(top - floor - stature_m) < 2e-4
            assert abs(floor) < 1e-4
            assert abs(np.ptp(vertices[generic.vertex_part == 0, 1]) - stature_m) < 0.006 * stature_m
            assert joints.shape == (94, 3)


def test_shape_is_linear_and_short_coefficients_do(generic: GenericHuman) -> None:
    few, _ = generic.shape(np.array([1.0, -2.0]), 1.7)
    full = np.zeros(36)
    full[:2] = 1.0, -2.0
    np.testing.assert_allclose(few, generic.shape(full, 1.7)[0])
    np.testing.assert_allclose(generic.shape(full, 3.4)[0], 2 * few)
    with pytest.raises(ValueError, match="coefficients"):
        generic.shape(np.zeros(99), 1.7)


def test_phenotypes_point_the_right_way(generic: GenericHuman) -> None:
    weight = generic.phenotype_from_shape[generic.phenotype_names.index("weight")]
    direction = weight / np.linalg.norm(weight)
    girth = {}
    for sign in (-1, 1):
        vertices, _ = generic.shape(2 * sign * direction, 1.7)
        girth[sign] = vertices[generic.feature("waist_left"), 0] - vertices[generic.feature("waist_right"), 0]
    assert girth[1] > girth[-1] + 0.03


def test_atlas_has_no_overlap_and_a_big_head(generic: GenericHuman) -> None:
    size = 1024
    corners, corner_uv = generic.triangles()
    cover = np.zeros((size, size), dtype=np.int32)
    points = generic.uv[corner_uv].astype(np.float64) * size
    assert points.min() > 1
    assert points.max() < size - 1
    for a, b, c in points:
        low = np.floor(np.minimum(np.minimum(a, b), c)).astype(int)
        high = np.ceil(np.maximum(np.maximum(a, b), c)).astype(int)
        x, y = np.meshgrid(np.arange(low[0], high[0]) + 0.5, np.arange(low[1], high[1]) + 0.5)
        signs = [(q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]) for p, q in ((a, b), (b, c), (c, a))]
        inside = (np.minimum.reduce(signs) > 1e-9) | (np.maximum.reduce(signs) < -1e-9)
        cover[low[1] : high[1], low[0] : high[0]] += inside
    assert cover.max() == 1, f"{(cover > 1).sum()} texels are covered twice"
    head = generic.region("face") | generic.region("scalp") | generic.region("ear_left") | generic.region("ear_right")
    own = points[head[corners].any(axis=1)]
    one, two = own[:, 1] - own[:, 0], own[:, 2] - own[:, 0]
    area = np.abs(one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]).sum() / 2
    assert area / size**2 > 0.35
    eye = points[(generic.vertex_part[corners] == generic.part_names.index("eye_left")).all(axis=1)]
    assert np.ptp(eye.reshape(-1, 2), axis=0).min() * 2 > 220  # px at 2048


def test_blink_closes_the_lids(generic: GenericHuman) -> None:
    for side, letter in (("Left", "L"), ("Right", "R")):
        gaps = []
        for unit in (None, f"eyeBlink{side}"):
            vertices = generic.vertices_m.astype(np.float64)
            if unit:
                rows, offsets = generic.face_unit(unit)
                vertices[rows] += offsets
            upper, lower = (vertices[generic.feature(f"eye_{n}_{letter}")] for n in ("upper", "lower"))
            gaps.append(upper[1] - lower[1])
        assert gaps[0] > 0.007, (side, gaps)
        assert gaps[1] < 0.0035, (side, gaps)  # a shut eye's two lash rows, each as thick as a ring of the mesh


def test_jaw_opens_with_its_teeth(generic: GenericHuman) -> None:
    rows, offsets = generic.face_unit("jawOpen")
    moved = np.zeros_like(generic.vertices_m)
    moved[rows] = offsets
    assert moved[generic.feature("chin_front"), 1] < -0.015
    assert moved[generic.part("teeth_lower"), 1].max() < -0.005
    assert not moved[generic.part("teeth_upper")].any()
    assert not moved[generic.part("eye_left")].any()


def test_gaze_turns_the_eyeball(generic: GenericHuman) -> None:
    for unit, pupil, axis, sign in (
        ("eyeLookOutLeft", "pupil_L", 0, 1),
        ("eyeLookInLeft", "pupil_L", 0, -1),
        ("eyeLookOutRight", "pupil_R", 0, -1),
        ("eyeLookUpRight", "pupil_R", 1, 1),
    ):
        rows, offsets = generic.face_unit(unit)
        move = offsets[rows == generic.feature(pupil)][0]
        assert 0.004 < sign * move[axis] < 0.010, (unit, move)


def test_face_units_are_complete(generic: GenericHuman) -> None:
    assert len(generic.arkit_names) == 52
    assert len(generic.viseme_names) == 15
    for name in generic.arkit_names:
        assert len(generic.face_unit(name)[0]) > 10, name
    assert len(generic.face_unit("viseme_sil")[0]) == 0
    assert np.abs(generic.arkit_delta_m).max() < 0.06


def test_face_space_leaves_the_body_alone(generic: GenericHuman) -> None:
    outside = np.setdiff1d(np.arange(len(generic.vertices_m)), generic.head_vertices)
    assert (generic.head_blend[outside] == 0).all()
    assert generic.head_blend[generic.feature("chin_bottom")] == 1 == generic.head_blend[generic.feature("nose_tip")]
    assert generic.head_blend[generic.feature("neck_base_left")] < 0.1
    for name in ("eye_left", "tongue", "teeth_upper", "lashes_right"):
        assert np.isin(generic.part(name), generic.head_vertices).all(), name


def test_named_points_make_sense(generic: GenericHuman) -> None:
    at = {n: generic.vertices_m[v] for n, v in zip(generic.feature_names, generic.feature_vertices, strict=True)}
    assert at["head_top"][1] == pytest.approx(1.70, abs=1e-4)
    order = [
        "head_top",
        "glabella",
        "nose_tip",
        "chin_bottom",
        "neck_base_left",
        "shoulder_end_left",
        "armpit_left",
        "waist_left",
        "hip_left",
        "knee_outer_left",
        "ankle_outer_left",
        "sole_left",
    ]
    heights = [at[n][1] for n in order]
    assert heights == sorted(heights, reverse=True)
    for name in ("elbow", "wrist", "knee", "ankle"):
        assert at[f"{name}_outer_left"][0] > at[f"{name}_inner_left"][0], name
        assert at[f"{name}_outer_right"][0] < at[f"{name}_inner_right"][0], name
    assert at["toe_left"][2] > at["ankle_front_left"][2] > at["heel_left"][2]
    assert at["chest_front"][2] > 0 > at["back"][2]
    assert at["buttock_left"][2] < 0
    fdp = dict(zip(generic.fdp_names, generic.fdp_vertices.tolist(), strict=True))
    assert fdp["9.3"] == generic.feature("nose_tip")
    assert fdp["3.5"] == generic.feature("pupil_L")
    assert len(fdp) == 82


def test_slices_and_connections(generic: GenericHuman) -> None:
    assert len(generic.segment_names) == 15
    assert generic.slice_s.min() >= 0
    assert generic.slice_s.max() <= 1
    thigh = generic.vertex_segment == generic.segment_names.index("left_thigh")
    front = generic.feature("thigh_front_left")
    assert thigh[front]
    assert abs(generic.slice_theta[front]) < 0.6
    assert generic.slice_theta[generic.feature("thigh_outer_left")] == pytest.approx(np.pi / 2, abs=0.5)
    pairs = {(generic.segment_names[a], generic.segment_names[b]) for a, b, _ in generic.connections}
    assert {("head", "torso"), ("torso", "pelvis"), ("torso", "left_upper_arm"), ("pelvis", "left_thigh")} <= pairs
    assert ("left_thigh", "left_calf") in pairs
    assert ("left_calf", "left_foot") in pairs
