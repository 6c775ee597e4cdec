"""H-Anim's sites are where anatomy has them, and its joint limits hold what a person does."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from cloner.exporters.hanim.hanim_limits import hanging_limits, limits_of
from cloner.exporters.hanim.hanim_sites import name_2, placed_sites, standard_sites
from cloner.exporters.vrml import vrml97, vrml_hanim, x3d
from cloner.generic.load import GENERIC_STATURE_M, load_generic
from cloner.motion.flesh.rest import hanging_pose, in_hanging_pose
from cloner.motion.limbs.body import body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from kit.clones import toy_clone

#: Heights of the standard's own figure (stature 1.7504 m), as shares of it.
STANDARD_HEIGHTS = {
    "skull_tip": 1.0, "sellion_pt": 0.932, "l_infraorbitale_pt": 0.924, "supramenton_pt": 0.880, "l_tragion_pt": 0.934,
    "l_gonion_pt": 0.887, "nuchale_pt": 0.912, "suprasternale_pt": 0.841, "l_clavicale_pt": 0.853,
    "substernale_pt": 0.742, "l_rib10_pt": 0.682, "l_asis_pt": 0.570, "l_psis_pt": 0.582,
    "l_iliocristale_pt": 0.602, "l_trochanterion_pt": 0.476, "cervicale_pt": 0.868, "l_acromion_pt": 0.843,
    "l_axilla_ant_pt": 0.803, "l_knee_crease_pt": 0.279, "l_femoral_lateral_epicn_pt": 0.284,
    "l_lateral_malleolus_pt": 0.034, "l_medial_malleolus_pt": 0.041, "l_sphyrion_pt": 0.033, "crotch_pt": 0.472,
    "l_neck_base_pt": 0.865, "navel_pt": 0.626, "waist_preferred_post_pt": 0.624, "l_metatarsal_pha1_pt": 0.013,
    "l_calcaneous_post_pt": 0.015, "l_digit2_pt": 0.005,
}  # fmt: skip


@pytest.fixture(scope="module")
def places() -> dict[str, np.ndarray]:
    points = np.asarray(load_generic().vertices_m, float)
    return {site.name: points[site.vertex] for site in standard_sites()}


@pytest.fixture(scope="module")
def clone():
    return centre_joints(toy_clone(1.64))


def test_all_points_of_the_standard_have_a_site_and_each_another_vertex(places) -> None:
    assert len(standard_sites()) == 89
    assert len(places) == 89
    assert sum(name.endswith("_tip") for name in places) == 13
    assert len({name_2(name) for name in places}) == 89
    shared = len(standard_sites()) - len({site.vertex for site in standard_sites()})
    assert shared <= 2, "only the middle finger's end has two names a side"


def test_they_are_as_high_as_on_the_standard_s_figure(places) -> None:
    for name, share in STANDARD_HEIGHTS.items():
        assert places[name][1] / GENERIC_STATURE_M == pytest.approx(share, abs=0.05), name


def test_left_and_right_mirror_each_other(places) -> None:
    for name, place in places.items():
        if name.startswith("l_"):
            assert places["r_" + name[2:]] == pytest.approx(place * [-1.0, 1.0, 1.0], abs=2e-4), name


def test_neighbours_lie_where_anatomy_has_them(places) -> None:
    def before(one: str, other: str, axis: int, mm: float) -> None:
        assert places[one][axis] - places[other][axis] > mm / 1000.0, (one, other)

    x, y, z = range(3)
    before("l_asis_pt", "l_psis_pt", z, 120)
    before("l_asis_pt", "l_trochanterion_pt", z, 60)
    before("l_iliocristale_pt", "l_asis_pt", y, 30)
    before("l_trochanterion_pt", "l_asis_pt", x, 40)
    before("l_axilla_ant_pt", "l_axilla_post_pt", z, 60)
    before("l_thelion_pt", "substernale_pt", z, 5)
    before("l_femoral_lateral_epicn_pt", "l_femoral_medial_epicn_pt", x, 70)
    before("l_lateral_malleolus_pt", "l_medial_malleolus_pt", x, 40)
    before("l_medial_malleolus_pt", "l_sphyrion_pt", y, 5)
    before("l_metatarsal_pha5_pt", "l_metatarsal_pha1_pt", x, 50)
    before("l_digit2_pt", "l_forefoot_tip", x, 10)
    before("l_radial_styloid_pt", "l_ulnar_styloid_pt", z, 25)
    before("l_metacarpal_pha2_pt", "l_metacarpal_pha5_pt", z, 40)
    before("l_humeral_lateral_epicn_pt", "l_humeral_medial_epicn_pt", x, 30)
    before("l_infraorbitale_pt", "supramenton_pt", y, 50)
    before("l_clavicale_pt", "suprasternale_pt", x, 10)
    elbow = load_generic().joints_m[load_generic().joint("l_elbow")]
    assert np.linalg.norm(places["l_radiale_pt"] - places["l_humeral_lateral_epicn_pt"]) < 0.04
    assert places["l_olecranon_pt"][z] < elbow[z] - 0.015, "the elbow's point lies behind it"


def test_vrml_has_them_on_segments_and_lists_them(clone, tmp_path: Path) -> None:
    text = vrml_hanim.export(clone, tmp_path)[0].read_text()
    written = re.findall(r'DEF hanim_(\w+) Site { name "(\w+)" translation (\S+) (\S+) (\S+) }', text)
    assert len(written) == len(placed_sites(clone)) == len({name for name, *_ in written})
    hanging = in_hanging_pose(clone)
    at = {own: np.array(place, float) for _, own, *place in written}
    for site in standard_sites():
        assert at[site.name] == pytest.approx(hanging.vertices_m[site.vertex], abs=1e-5)
    listed = text[text.index("sites [") :]
    assert all(f"USE hanim_{name}\n" in listed for name in at)
    pelvis = text[text.index("DEF hanim_pelvis Segment") :]
    assert "l_asis_pt" in pelvis[: pelvis.index("Joint {")]
    seamless = vrml97.export(clone, tmp_path)[0].read_text()
    assert all(f"DEF hanim_{site.name} Transform" in seamless for site in standard_sites())


def test_x3d_has_them_by_the_second_version_s_names_with_limits(clone, tmp_path: Path) -> None:
    root = ET.parse(x3d.export(clone, tmp_path)[0]).getroot()
    held = {site.get("name"): segment.get("name") for segment in root.iter("HAnimSegment") for site in segment}
    assert len(held) == 89
    assert held["l_humeral_lateral_epicondyle_pt"] == "l_upperarm"
    assert held["skull_vertex_tip"] == "skull"
    listed = [one for one in root.iter("HAnimSite") if one.get("containerField") == "sites"]
    assert len(listed) == 89
    knee = next(one for one in root.iter("HAnimJoint") if one.get("name") == "l_knee")
    span = [np.array(knee.get(end).split(), float)[0] for end in ("llimit", "ulimit")]
    assert span[1] - span[0] == pytest.approx(np.radians(130.0), abs=1e-4)


def test_right_limbs_have_the_left_one_s_limits_mirrored() -> None:
    for bare in ("hip", "shoulder", "wrist", "index1", "thumb2"):
        left, right = hanging_limits(f"l_{bare}"), hanging_limits(f"r_{bare}")
        assert right.low == pytest.approx([left.low[0], -left.high[1], -left.high[2]])
        assert right.high == pytest.approx([left.high[0], -left.low[1], -left.low[2]])
    assert hanging_limits("HumanoidRoot") is None
    assert hanging_limits("l_hip").high[2] == pytest.approx(np.radians(45.0)), "a left leg goes outwards about +Z"


def test_limits_of_another_rest_pose_let_the_arms_hang(clone) -> None:
    """Whatever the rest pose, both tell the same: lowered arms are allowed, bending on backwards is not."""
    generic, told = load_generic(), limits_of(clone)
    lowered = hanging_pose(body_of(clone))
    for name in ("l_shoulder", "r_shoulder", "l_elbow", "r_elbow", "l_knee", "l_hip"):
        limits = told[name]
        axes = Rotation.from_rotvec(limits.axes)
        own = (axes.inv() * Rotation.from_rotvec(lowered[generic.joint(name)]) * axes).as_euler("XYZ")
        assert (own >= limits.low - 1e-6).all(), name
        assert (own <= limits.high + 1e-6).all(), name
    straight = np.linalg.norm(lowered[generic.joint("l_elbow")])
    assert told["l_elbow"].high[0] == pytest.approx(straight, abs=np.radians(6.0)), "it ends where the arm is straight"


def test_nobody_walks_beyond_the_limits(clone) -> None:
    hanging = in_hanging_pose(clone)
    for motion in own_motions(hanging):
        for joint, name in enumerate(load_generic().joint_names):
            limits = hanging_limits(name)
            if limits is None or name[2:-1] in ("thumb", "index", "middle", "ring", "pinky"):
                continue  # relaxed fingers curl about oblique axes
            turns = Rotation.from_rotvec(np.array(motion.rotations[:, joint])).as_euler("XYZ")
            slack = np.radians(6.0)
            assert (turns > limits.low - slack).all(), (motion.name, name, np.degrees(turns.min(axis=0)))
            assert (turns < limits.high + slack).all(), (motion.name, name, np.degrees(turns.max(axis=0)))
