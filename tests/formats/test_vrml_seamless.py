"""clone.wrl, the default world: one skin that walks without a seam, with H-Anim's names on its joints."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest

from cloner.exporters.vrml.vrml97 import export
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_surfaces
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.records.clones import Clone
from formats.test_vrml import READER, SYSTEM_PYTHON, needs_coin
from kit.clones import toy_clone


@pytest.fixture(scope="module")
def clone() -> Clone:
    return toy_clone(1.64)


@pytest.fixture(scope="module")
def wrl(clone, tmp_path_factory) -> Path:
    return export(clone, tmp_path_factory.mktemp("wrl"))[0]


def numbers(text: str, width: int) -> np.ndarray:
    return np.array(text.replace(",", " ").split(), dtype=float).reshape(-1, width)


def pictures(text: str, name: str) -> tuple[np.ndarray, np.ndarray]:
    """The keys and the (K, N, 3) points in metres of one interpolator."""
    found = re.search(rf"DEF {name} CoordinateInterpolator {{ key \[ (.*?) \] keyValue \[\n(.*?)\] }}", text, re.S)
    unit = float(re.search(r"DEF skin Transform { scale (\S+)", text)[1])
    keys = np.array(found[1].split(), dtype=float)
    return keys, unit * numbers(found[2], 3).reshape(len(keys), -1, 3)


def test_every_picture_is_the_skin_that_the_joints_bend(wrl, clone) -> None:
    """Skinned here, by the library's linear blending: the first and a middle picture of the walk, within 1 mm."""
    generic, own = load_generic(), centre_joints(clone)
    motion = own_motions(own)[0]
    keys, points = pictures(wrl.read_text(), "walk_skin_0")
    body = np.unique(load_surfaces()[0].vertex)
    assert points.shape[1] == len(body), "one point for all wedges of a vertex: no seam can open"
    for row in (0, len(keys) // 2):
        frame = int(np.abs(motion.times_s - keys[row] * motion.times_s[-1]).argmin())
        transforms = joint_transforms(own.joints_m, generic.joint_parents, motion.rotations[frame])
        joints, weights = generic.skin_joints.astype(np.int32), generic.skin_weights.astype(float)
        wanted = linear_blend_skinning(own.vertices_m, transforms, joints, weights)
        assert np.abs(points[row] - wanted[body] - motion.root_m[frame]).max() < 0.001


def test_edges_keep_their_length_while_it_walks(wrl) -> None:
    """Rigid pieces gaped by centimetres at hem and groin; here no edge of the body is torn."""
    text = wrl.read_text()
    _, points = pictures(text, "walk_skin_0")
    corners = re.search(r"coordIndex \[\n(.*?)\]", text, re.S)[1]
    triangles = np.array(corners.split(), dtype=int).reshape(-1, 4)[:, :3]
    halfway = (points[:-1] + points[1:]) / 2.0  # what a browser shows between two pictures
    unit = float(re.search(r"DEF skin Transform { scale (\S+)", text)[1])
    rest = unit * numbers(re.search(r"DEF skin_0 Coordinate { point \[\n(.*?)\]", text, re.S)[1], 3)

    def edges(shown: np.ndarray) -> np.ndarray:
        return np.linalg.norm(shown[triangles] - shown[np.roll(triangles, 1, axis=1)], axis=2)

    for shown in (*points[::5], *halfway[::5]):
        assert (edges(shown) - edges(rest)).max() < 0.04, "metres"
    assert np.abs(points[0] - points[-1]).max() < 0.001, "the walk closes"


def test_it_blinks_in_its_idle_and_both_motions_have_clocks(wrl) -> None:
    text = wrl.read_text()
    assert "DEF walk_clock TimeSensor { cycleInterval 1.0000 loop TRUE }" in text
    assert "DEF idle_clock TimeSensor { cycleInterval 6.0000 loop TRUE startTime -1 stopTime 0 }" in text
    assert "ROUTE touch.touchTime TO idle_clock.set_startTime" in text
    keys, points = pictures(text, "idle_skin_0")
    lid = np.searchsorted(np.unique(load_surfaces()[0].vertex), load_generic().feature("3.1"))
    blink = int(np.abs(keys - 1.7 / 6.0).argmin())
    assert points[blink - 2 : blink + 3, lid, 1].min() < points[0, lid, 1] - 0.002, "an upper lid comes down"


def test_names_are_h_anim_s_and_there_is_no_prototype(wrl) -> None:
    text = wrl.read_text()
    assert "PROTO" not in text
    assert len(re.findall(r"DEF hanim_\w+ Transform { center", text)) == 94
    defined = re.findall(r"DEF (\w+)", text)
    assert len(defined) == len(set(defined)), "every DEF name once"
    routed = {name for pair in re.findall(r"ROUTE (\w+)\.\w+ TO (\w+)\.\w+", text) for name in pair}
    assert routed <= set(defined)
    assert "DEF" not in text[text.index("ROUTE") :]
    assert text.count("Viewpoint {") == 5
    assert wrl.stat().st_size < 14_000_000, "told in the readme"


@needs_coin
def test_coin_reads_it_in_metres_on_the_floor(wrl) -> None:
    done = subprocess.run(
        [SYSTEM_PYTHON, READER, wrl, "hanim_l_knee", "hanim_skull_tip"], capture_output=True, text=True, check=True
    )
    found = json.loads(done.stdout)
    assert done.stderr == ""
    assert found["low"][1] == pytest.approx(0.0, abs=0.002)
    assert found["high"][1] - found["low"][1] == pytest.approx(1.65, abs=0.03)
    assert all(found["nodes"].values())
