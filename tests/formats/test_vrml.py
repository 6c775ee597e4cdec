"""clone_hanim.wrl through Coin, the strictest parser, and as text."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from cloner.exporters.hanim.hanim_names import segment_name
from cloner.exporters.hanim.partition import partition
from cloner.exporters.vrml.vrml_hanim import export
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_surfaces
from cloner.motion.flesh.rest import in_hanging_pose
from cloner.motion.limbs.rig import centre_joints
from cloner.records.clones import Clone
from kit.clones import toy_clone
from kit.compare_clones import snapshot

READER = Path(__file__).with_name("read_wrl.py")
SYSTEM_PYTHON = "/usr/bin/python3"


def _has_coin() -> bool:
    if not Path(SYSTEM_PYTHON).exists():
        return False
    return subprocess.run([SYSTEM_PYTHON, "-c", "import pivy.coin"], capture_output=True, check=False).returncode == 0


needs_coin = pytest.mark.skipif(not _has_coin(), reason="Coin is not here; run: sudo apt-get install -y python3-pivy")


@pytest.fixture(scope="module")
def clone() -> Clone:
    return toy_clone(1.64)


@pytest.fixture(scope="module")
def wrl(clone, tmp_path_factory) -> Path:
    return export(clone, tmp_path_factory.mktemp("wrl"))[0]


def _coin(path: Path, *names: str) -> tuple[dict, str]:
    done = subprocess.run(
        [SYSTEM_PYTHON, READER, path, *names], capture_output=True, text=True, check=True, timeout=120
    )
    return json.loads(done.stdout), done.stderr


@needs_coin
def test_coin_parses_every_joint_and_segment_without_complaint(wrl, clone):
    names = [f"hanim_{joint}" for joint in load_generic().joint_names]
    names += [f"hanim_{segment_name(joint)}" for joint in load_generic().joint_names]
    found, complaints = _coin(wrl, *names)
    assert complaints == ""
    assert all(found["nodes"].values())
    assert len(found["nodes"]) == 2 * 94


@needs_coin
def test_coin_sees_all_triangles_in_metres_on_the_floor(wrl, clone):
    found, _ = _coin(wrl)
    triangles = sum(len(surface.triangles) for surface in load_surfaces())
    everything = triangles + sum(len(shell.triangles) for shell in clone.shells)
    # pieces repeat a ring of the pieces above, so that bent joints stay closed
    assert everything <= found["triangles"] < 1.2 * everything
    assert found["low"][1] == pytest.approx(0.0, abs=0.002)
    posed = in_hanging_pose(centre_joints(clone))
    assert found["high"][1] == pytest.approx(posed.shells[0].vertices_m[:, 1].max(), abs=1e-4)
    assert found["high"][2] == pytest.approx(posed.vertices_m[:, 2].max(), abs=1e-4), "it faces +Z"
    assert found["high"][0] < 0.8 * clone.vertices_m[:, 0].max(), "arms hang, as H-Anim has them at rest"


@needs_coin
def test_coin_does_complain_about_a_broken_file(wrl, tmp_path):
    """The test above means something only if this reader says when it is unhappy."""
    broken = tmp_path / "broken.wrl"
    broken.write_text(
        wrl.read_text().replace("center IS center", "centre IS center", 1).replace("center           IS", "centre IS")
    )
    done = subprocess.run([SYSTEM_PYTHON, READER, broken], capture_output=True, text=True, check=False, timeout=120)
    assert done.stderr != "" or done.returncode != 0


@pytest.mark.slow
@pytest.mark.skipif(
    shutil.which("tovrmlx3d") is None, reason="view3dscene is not here; run: sudo apt-get install -y view3dscene"
)
def test_view3dscene_s_reader_gives_no_warning(wrl):
    done = subprocess.run(
        ["tovrmlx3d", wrl], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=True, timeout=300
    )
    assert done.stderr == ""


def test_the_file_names_94_joints_and_facts(wrl):
    text = wrl.read_text()
    assert text.startswith("#VRML V2.0 utf8\n")
    assert len(re.findall(r"^DEF hanim_\w+ Joint ", text, re.M)) == 94
    assert len(re.findall(r"^DEF hanim_\w+ Segment ", text, re.M)) == 94
    for proto in ("Humanoid", "Joint", "Segment", "Site", "Displacer"):
        assert text.count(f"PROTO {proto} [") == 1
    defined = re.findall(r"DEF (\w+)", text)
    assert len(defined) == len(set(defined)), "every DEF name once"
    assert set(re.findall(r"USE (\w+)", text)) <= set(defined)


def test_the_walk_is_played_by_routes_that_come_last(wrl):
    text = wrl.read_text()
    assert re.search(r"DEF walk_clock TimeSensor \{ cycleInterval 1.0000 loop TRUE \}", text)
    routes = re.findall(r"ROUTE (\w+)\.\w+ TO (\w+)\.\w+", text)
    assert ("walk_l_knee_rotation", "hanim_l_knee") in routes
    assert {name for pair in routes for name in pair} <= set(re.findall(r"DEF (\w+)", text))
    assert "DEF" not in text[text.index("ROUTE") :]
    knee = re.search(
        r"DEF walk_l_knee_rotation OrientationInterpolator \{ key \[ (.*?) \] keyValue \[ (.*?) \] \}", text
    )
    keys = np.array(knee[1].split(), dtype=float)
    angles = np.array(knee[2].replace(",", " ").split(), dtype=float).reshape(-1, 4)[:, 3]
    assert keys[0] == 0.0
    assert keys[-1] == 1.0
    assert (np.diff(keys) > 0).all()
    assert 0.7 < np.ptp(angles) < 1.6, "a knee bends by some 60 degrees"


def test_joint_centres_and_sites_are_where_the_clone_has_them(wrl, clone):
    text = wrl.read_text()
    elbow = re.search(r'name "l_elbow" center (\S+) (\S+) (\S+)', text)
    posed = in_hanging_pose(centre_joints(clone))
    wanted = posed.joints_m[load_generic().joint("l_elbow")]
    assert np.array(elbow.groups(), dtype=float) == pytest.approx(wanted, abs=1e-5)
    assert wanted[0] > 0.1
    crown = re.search(r'Site { name "skull_tip" translation (\S+) (\S+) (\S+)', text)
    assert np.array(crown.groups(), dtype=float) == pytest.approx(posed.features_m["head_top"], abs=1e-5)


def test_the_face_has_displacers(wrl):
    text = wrl.read_text()
    assert re.search(r'Displacer { name "eyeBlinkLeft"', text)
    assert re.search(r"DEF hanim_(skull|jaw)_jawOpen Displacer", text)


def test_the_textures_lie_where_the_file_looks(wrl):
    for relative in set(re.findall(r'url "([^"]+)"', wrl.read_text())):
        with Image.open(wrl.parent / relative) as picture:
            assert min(picture.size) >= 8


def test_pieces_hold_every_triangle_once_and_share_their_borders(clone):
    generic = load_generic()
    body = load_surfaces()[0]
    pieces = partition(
        body.triangles, generic.skin_joints[body.vertex], generic.skin_weights[body.vertex], generic.joint_parents
    )
    rows = np.concatenate([piece.rows for piece in pieces])
    assert np.array_equal(np.sort(rows), np.arange(len(body.triangles)))
    for piece in pieces:
        assert np.array_equal(piece.vertex[piece.triangles], body.triangles[piece.rows])
    names = {generic.joint_names[piece.joint] for piece in pieces}
    assert {"l_elbow", "r_knee", "skullbase", "l_index3"} <= names


def test_segment_names_are_the_standard_s():
    pairs = {"HumanoidRoot": "sacrum", "vl5": "l5", "vt1": "t1", "vc4": "c4", "l_hip": "l_thigh", "skullbase": "skull",
             "r_wrist": "r_hand", "l_thumb1": "l_thumb_metacarpal", "r_pinky3": "r_pinky_distal"}  # fmt: skip
    assert {joint: segment_name(joint) for joint in pairs} == pairs
    assert len({segment_name(joint) for joint in load_generic().joint_names}) == 94
    with pytest.raises(ValueError, match="l_wing"):
        segment_name("l_wing")


def test_exporting_does_not_change_the_clone(clone, tmp_path):
    before = snapshot(clone)
    paths = export(clone, tmp_path)
    assert snapshot(clone) == before
    assert sorted(paths) == sorted(path for path in tmp_path.rglob("*") if path.is_file())
