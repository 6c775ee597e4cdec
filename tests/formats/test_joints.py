"""Every format tells the joints of its skeleton, and none more: told by the formats' own words, not by the exporters.

Users once met a message of 3,600 joints; no reader or validator at hand says so (docs/decisions/, issue 22). What
could make a reader count so many are joints written again, for each mesh, motion or face target.
"""

from __future__ import annotations

import json
import re
import struct
from pathlib import Path

import pytest

from cloner.exporters.table import EXPORTERS
from cloner.generic.load import load_generic
from kit.clones import toy_clone

NAMES = set(load_generic().joint_names)
JOINTS = len(load_generic().joint_names)
#: Bones that files of other programs' names have, and joints of the VRM with its look-at and springs.
GLTF = {"glb": JOINTS, "small": JOINTS, "lods": JOINTS, "mixamo": 54, "unity": 55, "unreal": 53, "vrm": JOINTS}


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    made = tmp_path_factory.mktemp("joints")
    for name in (*GLTF, "vrma", "wrl", "hanim", "flat", "x3d"):
        EXPORTERS.get(name)(toy_clone(1.64), made / name)
    return made


def gltf(path: Path) -> dict:
    data = path.read_bytes()
    return dict(json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]]))


@pytest.mark.parametrize("name", GLTF)
def test_a_gltf_has_one_skin_with_its_joints_and_hardly_any_other_node(name: str, folder: Path) -> None:
    (path,) = [one for one in (folder / name).iterdir() if one.suffix in (".glb", ".vrm")]
    told = gltf(path)
    assert len(told["skins"]) == 1
    joints = told["skins"][0]["joints"]
    assert len(joints) == len(set(joints)) == GLTF[name]
    assert len(told["nodes"]) - len(joints) <= 12, "an armature, meshes, levels of detail"
    for animation in told["animations"] if "animations" in told else ():
        assert len(animation["channels"]) <= len(joints) + 2, "a channel a joint, where the root goes, the face"


def test_an_animation_of_avatars_has_a_node_a_bone(folder: Path) -> None:
    told = gltf(next((folder / "vrma").iterdir()))
    assert len(told["nodes"]) <= JOINTS + 1


def test_vrml_defines_each_joint_once(folder: Path) -> None:
    (world,) = [one.read_text() for one in (folder / "hanim").iterdir() if one.suffix == ".wrl"]
    body = world[world.rindex("PROTO") :]
    names = re.findall(r"DEF hanim_(\w+) Joint\b", body)
    assert len(names) == len(set(names)) == JOINTS
    (seamless,) = [one.read_text() for one in (folder / "wrl").iterdir() if one.suffix == ".wrl"]
    joints = [name for name in re.findall(r"DEF hanim_(\w+) Transform", seamless) if name in NAMES]
    assert len(joints) == len(set(joints)) == JOINTS
    (flat,) = [one.read_text() for one in (folder / "flat").iterdir() if one.suffix == ".wrl"]
    assert not re.findall(r"\bJoint\b", flat)


def test_x3d_defines_each_joint_once(folder: Path) -> None:
    (world,) = [one.read_text() for one in (folder / "x3d").iterdir() if one.suffix == ".x3d"]
    names = re.findall(r'<HAnimJoint DEF="(\w+)"', world)
    assert len(names) == len(set(names)) == JOINTS


def test_usd_has_one_skeleton(tmp_path: Path) -> None:
    usd = pytest.importorskip("pxr.Usd", reason="usd-core is not here; run: pip install photo-cloner[usd]")
    from pxr import UsdSkel

    (path,) = EXPORTERS.get("usdz")(toy_clone(1.64), tmp_path)
    stage = usd.Stage.Open(str(path))  # held: its prims end with it
    (skeleton,) = [UsdSkel.Skeleton(prim) for prim in stage.Traverse() if prim.IsA(UsdSkel.Skeleton)]
    assert len(skeleton.GetJointsAttr().Get()) == JOINTS
    animations = [UsdSkel.Animation(prim) for prim in stage.Traverse() if prim.IsA(UsdSkel.Animation)]
    assert {len(animation.GetJointsAttr().Get()) for animation in animations} == {JOINTS}
