"""Captured motions are read, understood whatever their names, and laid on other bodies."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pygltflib
import pytest

from cloner.animating import animate_file
from cloner.errors import ClonerError
from cloner.motion.captures.acclaim import read_acclaim
from cloner.motion.captures.anatomy import find_anatomy, plain
from cloner.motion.captures.bvh import parse_bvh, read_bvh
from cloner.motion.captures.retarget import retarget
from cloner.motion.limbs.body import Body, body_of
from cloner.motion.limbs.turns import matrices, rotations_about, vectors
from cloner.motion.moves.cycle import walk_cycle
from cloner.motion.moves.gait import walk
from cloner.motion.moves.slide import step_slides_m
from cloner.project.clone_file import save_clone
from kit.clones import toy_clone

MOCAP = Path(__file__).resolve().parents[4] / "shared" / "mocap"
needs_mocap = pytest.mark.skipif(not MOCAP.is_dir(), reason="../shared/mocap is not here: no real captures are read")

SIMPLE = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Chest
  {
    OFFSET 0 10 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 5 0
    }
  }
}
MOTION
Frames: 2
Frame Time: 0.1
1 2 3 0 0 0 0 0 0
1 2 4 90 0 0 0 90 0
"""


@pytest.fixture(scope="module")
def body() -> Body:
    return body_of(toy_clone(1.70))


def test_numbers_of_a_small_file_are_the_ones_by_hand() -> None:
    capture = parse_bvh(SIMPLE)
    assert capture.names == ("Hips", "Chest")
    assert capture.parents.tolist() == [-1, 0]
    assert capture.ends[1].tolist() == [0, 5, 0]
    assert capture.root.tolist() == [[1, 2, 3], [1, 2, 4]]
    assert capture.frame_s == 0.1
    assert np.allclose(capture.local[1, 0], rotations_about(2, np.pi / 2))
    assert np.allclose(capture.world()[1, 1], rotations_about(2, np.pi / 2) @ rotations_about(0, np.pi / 2))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (("HIERARCHY", "HIER"), "HIERARCHY"),
        (("Frames: 2", "Frames: 3"), "promised"),
        (("Zrotation Xrotation", "Wrotation Xrotation"), "Wrotation"),
        (("1 2 4 90", "1 2 nan 90"), "numbers"),
        (("}\nMOTION", "MOTION"), "bracket"),
        (("Frames: 2", "Frames: -2"), "frames"),
    ],
)
def test_broken_files_are_refused_in_words(change, words, tmp_path: Path) -> None:
    path = tmp_path / "broken.bvh"
    path.write_text(SIMPLE.replace(*change))
    with pytest.raises(ClonerError) as caught:
        read_bvh(path)
    assert words in caught.value.message
    assert caught.value.where == "broken.bvh"


@pytest.mark.parametrize(
    ("name", "parts"),
    [
        ("mixamorig:LeftForeArm", ("forearm", "l")),
        ("mixamorig1:RightUpLeg", ("upleg", "r")),
        ("lShin", ("shin", "l")),
        ("RightKnee", ("knee", "r")),
        ("LoArm_L", ("loarm", "l")),
        ("calf_r", ("calf", "r")),
        ("l_elbow", ("elbow", "l")),
        ("rradius", ("radius", "r")),
        ("leftLowerLeg", ("lowerleg", "l")),
        ("Bip01_L_Calf", ("calf", "l")),
        ("Bip001 R UpperArm", ("upperarm", "r")),
        ("Bip01_Head", ("head", "")),
        ("Hips", ("hips", "")),
        ("lowerback", ("lowerback", "")),
    ],
)
def test_sides_and_names_of_every_dialect(name: str, parts: tuple[str, str]) -> None:
    assert plain(name) == parts


def test_a_skeleton_without_knees_is_refused_in_words() -> None:
    with pytest.raises(ClonerError) as caught:
        find_anatomy(parse_bvh(SIMPLE))
    assert "left knee" in caught.value.message


def as_bvh(body: Body, motion, *, scale: float, up: str) -> str:
    """Write a motion of ours as a BVH of main joints in another unit and with another axis up."""
    kept = ["HumanoidRoot", "vl1", "vt1", "skullbase"]
    for side in "lr":
        kept += [f"{side}_{name}" for name in ("shoulder", "elbow", "wrist", "hip", "knee", "ankle", "metatarsal")]
    parent = {"HumanoidRoot": "", "vl1": "HumanoidRoot", "vt1": "vl1", "skullbase": "vt1"}
    for side in "lr":
        chain = ("vt1", *(f"{side}_{name}" for name in ("shoulder", "elbow", "wrist")))
        parent |= dict(zip(chain[1:], chain, strict=False))
        chain = ("HumanoidRoot", *(f"{side}_{name}" for name in ("hip", "knee", "ankle", "metatarsal")))
        parent |= dict(zip(chain[1:], chain, strict=False))
    turn = np.eye(3) if up == "y" else np.array([[1.0, 0, 0], [0, 0, -1.0], [0, 1.0, 0]])
    world = turn @ body.world(motion) @ turn.T
    place = {name: turn @ body.joints_m[body.joint(name)] * scale for name in kept}
    lines, order = ["HIERARCHY"], []

    def write(name: str, depth: int) -> None:
        above = parent[name]
        order.append(name)
        offset = place[name] - (place[above] if above else 0)
        kind = "ROOT" if not above else "JOINT"
        channels = "CHANNELS 6 Xposition Yposition Zposition" if not above else "CHANNELS 3"
        lines.extend([f"{kind} {name}", "{", "OFFSET " + " ".join(f"{v:.6f}" for v in offset)])
        lines.append(channels + " Zrotation Yrotation Xrotation")
        children = [other for other in kept if parent[other] == name]
        for child in children:
            write(child, depth + 1)
        if not children:
            lines.extend(["End Site", "{", "OFFSET 0 1 0", "}"])
        lines.append("}")

    write("HumanoidRoot", 0)
    from scipy.spatial.transform import Rotation

    rows = []
    root = (body.places(motion)[:, body.joint("HumanoidRoot")] @ turn.T) * scale
    for frame in range(len(motion.times_s)):
        numbers = list(root[frame])
        for name in order:
            own = world[frame, body.joint(name)]
            local = own if not parent[name] else world[frame, body.joint(parent[name])].T @ own
            numbers += Rotation.from_matrix(local).as_euler("ZYX", degrees=True).tolist()
        rows.append(" ".join(f"{number:.8f}" for number in numbers))
    step = float(np.diff(motion.times_s).mean())
    return "\n".join([*lines, "MOTION", f"Frames: {len(rows)}", f"Frame Time: {step:.9f}", *rows]) + "\n"


@pytest.mark.parametrize(("scale", "up"), [(1.0, "y"), (100.0, "y"), (39.37, "z")])
def test_our_own_walk_comes_back_through_a_file_of_another_unit_and_axis(body: Body, scale: float, up: str) -> None:
    """Limbs point as before within a degree or two, whatever unit and axis the file has; soles are on the floor."""
    motion = walk(body)
    back = retarget(parse_bvh(as_bvh(body, motion, scale=scale, up=up)), body, name="back")
    before, after = body.world(motion), body.world(back)
    for name in ("l_hip", "r_knee", "l_shoulder", "r_elbow", "vt1", "skullbase"):
        joint = body.joint(name)
        cosine = (np.einsum("fab,fab->f", before[:, joint], after[:, joint]) - 1.0) / 2.0
        assert np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))).max() < 6.0, name
    left, right = body.sole_points(body.world(back), back.root_m)
    assert min(left[..., 1].min(), right[..., 1].min()) > -0.01


@needs_mocap
@pytest.mark.parametrize(
    "name", ["cmu_02_02_walk.bvh", "cmu_131_01_start_walk_stop.bvh", "makehuman_walk1.bvh", "cmu_03_03.bvh"]
)
def test_real_captures_of_three_dialects_stand_upright_and_do_not_slide(body: Body, name: str) -> None:
    motion = retarget(read_bvh(MOCAP / name), body, name="real")
    places = body.places(motion)
    height = places[:, body.joint("skullbase"), 1] - places[:, body.joint("l_ankle"), 1]
    assert (height > 0.6).mean() > 0.95
    assert np.median(places[:, body.joint("l_knee"), 0] - places[:, body.joint("r_knee"), 0]) > 0.0, "left is left"
    left, right = body.sole_points(body.world(motion), motion.root_m)
    assert min(left[..., 1].min(), right[..., 1].min()) > -0.02
    lower = np.minimum(left[..., 1].min(axis=1), right[..., 1].min(axis=1))
    assert np.percentile(lower, 90) < 0.02, "walkers do not float: one sole is on the floor"
    slid = step_slides_m(body, motion)
    assert slid.mean() < 0.005, "by the strict ruler"
    assert np.median(slid) < 0.002
    assert slid.max() < (0.03 if "131" in name else 0.015), "one turns on his heels before he walks"


@needs_mocap
def test_a_walk_is_cut_to_a_circle_of_about_a_second(body: Body) -> None:
    made = walk_cycle(body, retarget(read_bvh(MOCAP / "cmu_02_02_walk.bvh"), body, name="walk"))
    assert 0.8 < made.times_s[-1] < 1.3
    assert np.abs(made.rotations[0] - made.rotations[-1]).max() < 1e-6
    assert 0.8 < made.speed_m_s < 2.2
    assert step_slides_m(body, made).max() < 0.005


def test_a_motion_without_steps_makes_no_walk(body: Body) -> None:
    from cloner.motion.moves.gait import idle

    with pytest.raises(ClonerError) as caught:
        walk_cycle(body, idle(body))
    assert "steps" in caught.value.hint


ASF = """:version 1.10
:units
  length 0.45
  angle deg
:root
   order TX TY TZ RX RY RZ
   axis XYZ
   position 0 0 0
   orientation 0 0 0
:bonedata
  begin
     id 1
     name lfemur
     direction 1 0 0
     length 4
     axis 0 0 90 XYZ
    dof rx rz
    limits (-160.0 20.0)
           (-70.0 70.0)
  end
  begin
     id 2
     name ltibia
     direction 0 1 0
     length 5
     axis 0 0 0 XYZ
    dof rx
  end
:hierarchy
  begin
    root lfemur
    lfemur ltibia
  end
"""
AMC = """:FULLY-SPECIFIED
:DEGREES
1
root 1 2 3 0 0 90
lfemur 0 0
ltibia 0
2
root 1 2 3 0 0 0
lfemur 90 0
ltibia 30
"""


def acclaim(tmp_path: Path, skeleton: str = ASF, motion: str = AMC) -> Path:
    (tmp_path / "07.asf").write_text(skeleton)
    (tmp_path / "07_02.amc").write_text(motion)
    return tmp_path / "07_02.amc"


def test_an_acclaim_capture_of_two_bones_is_the_one_by_hand(tmp_path: Path) -> None:
    capture = read_acclaim(acclaim(tmp_path))
    assert capture.names == ("root", "lfemur", "ltibia")
    assert capture.offsets.tolist() == [[0, 0, 0], [0, 0, 0], [4, 0, 0]], "a knee lies at the end of its thigh"
    assert capture.ends[2].tolist() == [0, 5, 0]
    assert capture.root.tolist() == [[1, 2, 3], [1, 2, 3]]
    assert np.allclose(capture.local[0, 0], rotations_about(2, np.pi / 2))
    # the thigh's own first axis is our second one: its axes are turned by 90 degrees about the third
    assert np.allclose(capture.local[1, 1], rotations_about(1, np.pi / 2))
    assert np.allclose(capture.world()[1, 2], rotations_about(1, np.pi / 2) @ rotations_about(0, np.pi / 6))


@pytest.mark.parametrize(
    ("skeleton", "motion", "words"),
    [
        (ASF, AMC.replace("lfemur 90 0", "lfemur nan 0"), "lfemur"),
        (ASF, AMC.replace("lfemur 90 0", "lfemur 90"), "lfemur"),
        (ASF, AMC.replace("ltibia 30\n", ""), "ltibia"),
        (ASF, AMC.replace("ltibia 30", "rtibia 30"), "rtibia"),
        (ASF, ":DEGREES\n", "no frames"),
        (ASF.replace(":hierarchy", ":nothing"), AMC, "hierarchy"),
        (ASF.replace("length 5", "length inf"), AMC, "ltibia"),
        (ASF.replace("    root lfemur", "    root lfemur root"), AMC, "root hangs"),
    ],
)
def test_broken_acclaim_files_are_refused_in_words(skeleton: str, motion: str, words: str, tmp_path: Path) -> None:
    with pytest.raises(ClonerError) as caught:
        read_acclaim(acclaim(tmp_path, skeleton, motion))
    assert words in caught.value.message
    assert caught.value.where == "07_02.amc"


def test_a_motion_without_its_skeleton_says_which_file_is_wanted(tmp_path: Path) -> None:
    path = acclaim(tmp_path)
    (tmp_path / "07.asf").unlink()
    with pytest.raises(ClonerError) as caught:
        read_acclaim(path)
    assert "skeleton" in caught.value.message
    assert "07_02.asf" in caught.value.hint


def test_a_limb_without_length_is_named_and_nothing_is_written(body: Body, tmp_path: Path) -> None:
    text = as_bvh(body, walk(body), scale=1.0, up="y")
    head, _, tail = text.partition("JOINT l_ankle\n{\nOFFSET ")
    path = tmp_path / "short.bvh"
    path.write_text(f"{head}JOINT l_ankle\n{{\nOFFSET 0 0 0\n{tail.partition(chr(10))[2]}")
    save_clone(toy_clone(), tmp_path / "clone.npz")
    with pytest.raises(ClonerError) as caught:
        animate_file(tmp_path / "clone.npz", [path], tmp_path / "out" / "walk.glb")
    assert caught.value.message == "the left leg has a bone without length in the capture"
    assert caught.value.where == "l_ankle"
    assert not (tmp_path / "out").exists()


def test_a_capture_of_a_head_that_rests_looking_up_is_levelled(body: Body) -> None:
    """The same walk from a marker set whose head looks up by 22 degrees: the laid head looks ahead as before."""
    motion = walk(body)
    rotations = motion.rotations.copy()
    head = body.joint("skullbase")
    rotations[:, head] = vectors(
        matrices(rotations[:, head]) @ rotations_about(0, np.full(len(rotations), np.radians(-22.0)))
    )
    askew = replace(motion, rotations=rotations)
    back = retarget(parse_bvh(as_bvh(body, askew, scale=1.0, up="y")), body, name="back")
    ahead = body.world(back)[:, head, :, 2]
    assert np.abs(np.degrees(np.arcsin(ahead[:, 1]))).max() < 4.0


def test_the_capture_is_the_first_clip_of_every_format(body: Body, tmp_path: Path) -> None:
    (tmp_path / "stroll.bvh").write_text(as_bvh(body, walk(body), scale=1.0, up="y"))
    save_clone(toy_clone(), tmp_path / "clone.npz")
    for suffix in (".glb", ".vrm"):
        (path,) = animate_file(tmp_path / "clone.npz", [tmp_path / "stroll.bvh"], tmp_path / f"out{suffix}")
        clips = [clip.name for clip in pygltflib.GLTF2().load_binary(str(path)).animations]
        assert clips == ["stroll", "walk", "idle"]
    for suffix in (".wrl", ".x3d"):
        path, *_ = animate_file(tmp_path / "clone.npz", [tmp_path / "stroll.bvh"], tmp_path / f"out{suffix}")
        assert "stroll_clock" in path.read_text()
    with pytest.raises(ClonerError) as caught:
        animate_file(tmp_path / "clone.npz", [tmp_path / "stroll.bvh"], tmp_path / "out.fbx")
    assert ".glb" in caught.value.hint
