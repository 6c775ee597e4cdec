"""clone.vrm as a VRM 1.0 file, and in three-vrm in a real browser."""

from __future__ import annotations

import io
import json
import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pygltflib
import pytest
from PIL import Image

from cloner.exporters.avatars.vrm import EXPRESSIONS, export, human_bones
from cloner.exporters.avatars.vrm_terms import vrm_meta
from cloner.generic.load import load_generic
from cloner.motion.flesh.rest import in_t_pose
from cloner.records.terms import Terms
from kit.browser import CHROMIUM, browser
from kit.clones import toy_clone
from kit.compare_clones import snapshot
from kit.tails import with_skirt, with_tail

MODULES = Path(os.environ.get("CLONER_NODE_MODULES", "/tmp/cloner-node")).resolve()
READER = Path(__file__).with_name("read_vrm.mjs")
VALIDATOR = Path(__file__).with_name("validate_gltf.mjs")
REQUIRED = ["hips", "spine", "head"] + [
    f"{side}{bone}"
    for side in ("left", "right")
    for bone in ("UpperLeg", "LowerLeg", "Foot", "UpperArm", "LowerArm", "Hand")
]


@pytest.fixture(scope="module")
def clone():
    return toy_clone(1.64)


@pytest.fixture(scope="module")
def vrm(clone, tmp_path_factory) -> Path:
    before = snapshot(clone)
    (path,) = export(clone, tmp_path_factory.mktemp("vrm"))
    assert snapshot(clone) == before
    return path


@pytest.fixture(scope="module")
def gltf(vrm):
    return pygltflib.GLTF2().load_binary(str(vrm))


def test_all_required_bones_stand_in_one_chain_below_the_hips(gltf) -> None:
    bones = gltf.extensions["VRMC_vrm"]["humanoid"]["humanBones"]
    assert set(REQUIRED) <= set(bones)
    assert set(bones) == set(human_bones())
    parent = {child: number for number, node in enumerate(gltf.nodes) for child in node.children or []}
    for name in REQUIRED:
        node, chain = bones[name]["node"], []
        while node in parent:
            node = parent[node]
            chain.append(node)
        assert name == "hips" or bones["hips"]["node"] in chain


def test_the_rest_pose_is_a_t(clone) -> None:
    """Arms level within a degree or two and straight, palms down, both feet flat on the floor."""
    posed, generic = in_t_pose(clone), load_generic()
    for side, sign in (("l", 1.0), ("r", -1.0)):
        shoulder, elbow, wrist = (
            posed.joints_m[generic.joint(f"{side}_{name}")] for name in ("shoulder", "elbow", "wrist")
        )
        for bone in (elbow - shoulder, wrist - elbow):
            assert np.degrees(np.arccos(sign * bone[0] / np.linalg.norm(bone))) < 1.0
        index, little = (posed.joints_m[generic.joint(f"{side}_{name}")] for name in ("index1", "pinky1"))
        assert index[2] > little[2], "palm down: the thumb's side is in front"
        assert abs(index[1] - little[1]) < 0.02
        hip, ankle = posed.joints_m[generic.joint(f"{side}_hip")], posed.joints_m[generic.joint(f"{side}_ankle")]
        assert np.abs((hip - ankle)[[0, 2]]).max() < 0.01
    assert posed.vertices_m[:, 1].min() == pytest.approx(clone.vertices_m[:, 1].min(), abs=1e-6)
    soles = posed.vertices_m[generic.region("sole")]
    assert np.median(soles[:, 1]) < 0.02
    assert np.ptp(posed.vertices_m[:, 0]) > 0.9 * clone.stature_m


def test_expressions_bind_existing_targets(gltf, clone) -> None:
    preset = gltf.extensions["VRMC_vrm"]["expressions"]["preset"]
    assert set(preset) == set(EXPRESSIONS)
    for name, expression in preset.items():
        for bind in expression["morphTargetBinds"]:
            assert gltf.nodes[bind["node"]].mesh is not None
            assert clone.morph_names[bind["index"]] in EXPRESSIONS[name]
            assert 0.0 < bind["weight"] <= 1.0


def test_the_thumbnail_shows_the_head(gltf) -> None:
    image = gltf.images[gltf.extensions["VRMC_vrm"]["meta"]["thumbnailImage"]]
    view = gltf.bufferViews[image.bufferView]
    data = gltf.binary_blob()[view.byteOffset : view.byteOffset + view.byteLength]
    with Image.open(io.BytesIO(data)) as picture:
        assert picture.size == (256, 256)
        pixels = np.asarray(picture.convert("RGB")).astype(int)
    shown = (np.abs(pixels - pixels[0, 0]).max(axis=2) > 12).mean()
    assert 0.25 < shown < 0.8, "a head fills a third to two thirds of its picture"


def test_terms_protect_the_person(gltf) -> None:
    meta = gltf.extensions["VRMC_vrm"]["meta"]
    assert meta["avatarPermission"] == "onlyAuthor"
    assert meta["commercialUsage"] == "personalNonProfit"
    assert meta["allowRedistribution"] is False
    assert meta["modification"] == "prohibited"
    assert meta["creditNotation"] == "required"
    assert (meta["name"], meta["authors"]) == ("clone", ["The person shown"])
    assert meta["licenseUrl"] == "https://vrm.dev/licenses/1.0/", "the only one that the format's schema knows"


@pytest.mark.parametrize(("licence", "told"), [
    ("own", ("onlySeparatelyLicensedPerson", "personalNonProfit", False, "allowModification")),
    ("event", ("onlySeparatelyLicensedPerson", "corporation", False, "allowModification")),
    ("everyone", ("everyone", "personalNonProfit", True, "allowModificationRedistribution")),
])  # fmt: skip
def test_a_consent_s_licence_says_who_may_use_it(licence: str, told: tuple[object, ...]) -> None:
    meta = vrm_meta(Terms("Zoë", "Fair 2026", licence), "clone")
    keys = ("avatarPermission", "commercialUsage", "allowRedistribution", "modification")
    assert tuple(meta[key] for key in keys) == told
    assert (meta["name"], meta["authors"]) == ("Zoë", ["Zoë", "Fair 2026"])
    assert meta["creditNotation"] == "required"
    assert not any(meta[key] for key in meta if key.startswith("allow") and key != "allowRedistribution")


def test_eyes_turn_so_that_it_is_seen(gltf) -> None:
    """By the format: a target at 45 degrees turns an eye by outputScale * 45 / inputMaxValue; iris edges move 4 mm."""
    look = gltf.extensions["VRMC_vrm"]["lookAt"]
    for way in ("HorizontalInner", "HorizontalOuter", "VerticalDown", "VerticalUp"):
        turned = look[f"rangeMap{way}"]["outputScale"] * min(45.0 / look[f"rangeMap{way}"]["inputMaxValue"], 1.0)
        assert 15.0 <= turned <= 35.0, way


@pytest.mark.skipif(
    shutil.which("node") is None or not (MODULES / "node_modules/gltf-validator").is_dir(),
    reason="gltf-validator is not here",
)
def test_the_khronos_validator_finds_no_error(vrm) -> None:
    done = subprocess.run(["node", VALIDATOR, MODULES, vrm], capture_output=True, text=True, check=True, timeout=120)
    issues = json.loads(done.stdout)["issues"]
    assert issues["numErrors"] == issues["numWarnings"] == 0


@pytest.mark.skipif(
    shutil.which("node") is None or not (MODULES / "node_modules/gltf-validator").is_dir(),
    reason="gltf-validator is not here",
)
def test_a_tail_s_bones_pass_the_validator_and_carry_it(clone, tmp_path: Path) -> None:
    (path,) = export(with_tail(clone), tmp_path)
    done = subprocess.run(["node", VALIDATOR, MODULES, path], capture_output=True, text=True, check=True, timeout=120)
    issues = json.loads(done.stdout)["issues"]
    assert issues["numErrors"] == issues["numWarnings"] == 0
    gltf = pygltflib.GLTF2().load_binary(str(path))
    spring = gltf.extensions["VRMC_springBone"]["springs"][0]
    names = [gltf.nodes[joint["node"]].name for joint in spring["joints"]]
    assert names == [f"hair_tail1_{number}" for number in range(1, len(names) + 1)]
    hair = next(mesh for mesh in gltf.meshes if mesh.name == "Hair").primitives[0].attributes
    joints, weights = (_values(gltf, accessor) for accessor in (hair.JOINTS_0, hair.WEIGHTS_0))
    assert weights.sum(axis=1) == pytest.approx(1.0, abs=1e-6)
    lowest = _values(gltf, hair.POSITION)[:, 1].argmin()
    assert gltf.nodes[gltf.skins[0].joints[joints[lowest, 0]]].name == names[-2], "the last one is but an end"


@pytest.mark.skipif(
    shutil.which("node") is None or not (MODULES / "node_modules/gltf-validator").is_dir(),
    reason="gltf-validator is not here",
)
def test_a_skirt_s_bones_pass_the_validator_and_carry_its_hem(clone, tmp_path: Path) -> None:
    """Chains hang on the leg beside them; what lies at the waist stays with the trunk."""
    (path,) = export(with_skirt(with_tail(clone)), tmp_path)
    done = subprocess.run(["node", VALIDATOR, MODULES, path], capture_output=True, text=True, check=True, timeout=120)
    issues = json.loads(done.stdout)["issues"]
    assert issues["numErrors"] == issues["numWarnings"] == 0
    gltf = pygltflib.GLTF2().load_binary(str(path))
    extension = gltf.extensions["VRMC_springBone"]
    names = [spring["name"] for spring in extension["springs"]]
    assert [name for name in names if name.startswith("hem")] == [f"hem{number}_1" for number in range(1, 9)]
    assert names[0] == "hair_tail1_1", "a tail swings beside it"
    groups = {group["name"]: group["colliders"] for group in extension["colliderGroups"]}
    legs = [gltf.nodes[extension["colliders"][row]["node"]].name for row in groups["cloth"]]
    assert legs == ["l_hip", "l_knee", "r_hip", "r_knee"]
    parent = {child: number for number, node in enumerate(gltf.nodes) for child in node.children or []}
    for spring in extension["springs"][1:]:
        first = spring["joints"][0]["node"]
        left = _world_x(gltf, parent, spring["joints"][-1]["node"]) > 0.0
        assert gltf.nodes[parent[first]].name == ("l_hip" if left else "r_hip")
    cloth = next(mesh for mesh in gltf.meshes if mesh.name == "Cloth").primitives[0].attributes
    joints, weights = (_values(gltf, accessor) for accessor in (cloth.JOINTS_0, cloth.WEIGHTS_0))
    assert weights.sum(axis=1) == pytest.approx(1.0, abs=1e-6)
    bones = np.array([gltf.nodes[node].name for node in gltf.skins[0].joints])
    swung = (weights * np.char.startswith(bones[joints], "hem")).sum(axis=1)
    height = _values(gltf, cloth.POSITION)[:, 1]
    assert swung[height < height.min() + 0.1].min() == pytest.approx(1.0, abs=1e-6)
    assert swung[height > height.max() - 0.1].max() == 0.0


def _world_x(gltf, parent: dict[int, int], node: int) -> float:
    found = 0.0
    while node is not None:
        found += (gltf.nodes[node].translation or [0.0])[0]
        node = parent.get(node)
    return found


def test_short_hair_has_no_springs(gltf) -> None:
    assert "VRMC_springBone" not in gltf.extensions


def _values(gltf, number: int) -> np.ndarray:
    accessor = gltf.accessors[number]
    kind, width = {5121: np.uint8, 5126: np.float32}[accessor.componentType], {"VEC3": 3, "VEC4": 4}[accessor.type]
    start = gltf.bufferViews[accessor.bufferView].byteOffset
    return np.frombuffer(gltf.binary_blob(), kind, accessor.count * width, start).reshape(-1, width)


needs_three_vrm = pytest.mark.skipif(
    CHROMIUM is None
    or not all((MODULES / "node_modules" / name).is_dir() for name in ("three", "@pixiv/three-vrm", "esbuild")),
    reason="three-vrm, esbuild or Chromium is not here; run: npm install three @pixiv/three-vrm esbuild",
)


def in_three_vrm(vrm: Path, tmp_path: Path) -> dict:
    """Return what the reader of the format's own makers tells of a file."""
    import base64

    entry = MODULES / "read_vrm_entry.mjs"
    shutil.copy(READER, entry)
    script = tmp_path / "reader.js"
    esbuild = MODULES / "node_modules" / ".bin" / "esbuild"
    subprocess.run(
        [esbuild, entry, "--bundle", "--format=iife", f"--outfile={script}", "--log-level=error"], check=True
    )
    page_file = tmp_path / "page.html"
    data = base64.b64encode(vrm.read_bytes()).decode()
    page_file.write_text(
        f'<!doctype html><body><script type="text/plain" id="vrm">{data}</script>'
        f"<script>{script.read_text()}</script></body>"
    )
    with browser(tmp_path / "profile") as page:
        page.open(page_file)
        page.wait_for("window.result")
        result = page.value("window.result")
    return result


@needs_three_vrm
@pytest.mark.slow
def test_three_vrm_reads_bones_expressions_and_gaze(vrm, tmp_path: Path) -> None:
    """The reader of the format's own makers finds the person, blinks it and lifts its arm."""
    result = in_three_vrm(vrm, tmp_path)
    assert result.get("error") is None
    assert result["metaVersion"] == "1"
    assert set(REQUIRED) <= set(result["bones"])
    assert set(EXPRESSIONS) <= set(result["expressions"])
    assert result["lookAt"] is True
    assert (result["name"], result["authors"]) == ("clone", ["The person shown"])
    turned = {way: np.array(result["gaze_deg"][way]) for way in ("left", "up", "down")}  # two eyes, aside and up
    assert (turned["left"][:, 0] > 15.0).all(), "her own left, seen from 45 degrees aside"
    assert (turned["up"][:, 1] > 12.0).all()
    assert (turned["down"][:, 1] < -12.0).all()
    assert result["hips_m"] == pytest.approx(0.85, abs=0.2)
    assert result["hand_raised_m"] > 0.2
    assert result["blink_weight"] == pytest.approx(1.0, abs=1e-3)


@needs_three_vrm
@pytest.mark.slow
def test_a_tail_lags_behind_a_turning_head_comes_to_rest_and_stays_outside_the_body(clone, tmp_path: Path) -> None:
    """Its tip hangs 8 cm behind the skull's axis: a head turned at once by a radian moves it by 8 cm and more."""
    (path,) = export(with_tail(clone), tmp_path)
    springs = in_three_vrm(path, tmp_path)["springs"]
    assert springs["colliders"] == 3
    assert springs["joints"] >= 3
    assert springs["sag_m"] < 0.03, "resting hair hangs as in the photos"
    assert springs["lag_m"] > 0.05
    assert springs["still_m"] < 0.001
    assert min(springs["inside_m"]) > -0.002


@needs_three_vrm
@pytest.mark.slow
def test_a_skirt_follows_a_lifted_leg_comes_to_rest_and_stays_outside_it(clone, tmp_path: Path) -> None:
    """A thigh lifted at once by 0.6 rad takes a hem 45 cm below the hip 20 cm along and more."""
    (path,) = export(with_skirt(clone), tmp_path)
    hems = in_three_vrm(path, tmp_path)["hems"]
    assert hems["joints"] >= 16
    assert hems["sag_m"] < 0.03, "resting cloth hangs as in the photos"
    assert hems["lag_m"] > 0.05
    assert hems["lift_m"] > 0.15
    assert hems["still_m"] < 0.001
    assert hems["back_m"] < 0.005
    assert min(hems["inside_m"]) > -0.002
