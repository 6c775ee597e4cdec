"""A pack from end to end: whole, the same twice, readable by others, and refused where it should be."""

from __future__ import annotations

import errno
import json
import os
import shutil
import subprocess
import zipfile
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pygltflib
import pytest

from cloner.crowd.clones.clips import resample_motion, sample_walk
from cloner.crowd.clones.levels import body_levels
from cloner.crowd.clones.vat import LEVEL
from cloner.crowd.packs.check import check_pack
from cloner.crowd.packs.files import pack_folder
from cloner.crowd.packs.pack import make_pack
from cloner.crowd.packs.reading import read_facts
from cloner.crowd.packs.wanted import parse_rings
from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.motion.limbs.body import body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.acts import ACTS
from cloner.motion.moves.gait import walk
from cloner.motion.moves.slide import RULER_HZ, step_slides_m
from cloner.motion.moves.styles import REGULAR, STYLES, Style
from cloner.personal_data.holdings import find_holding, holdings
from cloner.personal_data.privacy import export_data, forget
from cloner.project.clone_file import CLONE_FILE, load_clone
from kit import readers
from kit.crowds import WANTED, dressed_toy, saved

NODE_MODULES = Path(os.environ.get("CLONER_NODE_MODULES", ".cache/npm"))
HAS_VALIDATOR = (NODE_MODULES / "node_modules" / "gltf-validator").is_dir() and shutil.which("node")
VALIDATOR = Path(__file__).parents[2] / "formats" / "validate_gltf.mjs"

pytestmark = [pytest.mark.gl, pytest.mark.slow]


def test_a_pack_is_whole_and_says_what_is_in_it(pack: Path) -> None:
    lines = check_pack(pack)
    assert lines[0] == "2 clones: ada, ben"
    facts = read_facts(pack)
    assert [tier["level"] for tier in facts["tiers"]] == [0, 1, 2, 3]
    assert all(row["consent"] == "recorded" for row in facts["people"])
    assert facts["switch"]["metres_per_focal_px"] == pytest.approx(1.5 / facts["switch"]["texels_per_m"])


def test_the_same_clones_give_the_same_bytes(pack: Path, results: Path, tmp_path: Path) -> None:
    make_pack([results / "ada", results / "ben"], tmp_path / "again", WANTED)
    first = {path.relative_to(pack): path.read_bytes() for path in pack.rglob("*") if path.is_file()}
    again = {p.relative_to(tmp_path / "again"): p.read_bytes() for p in (tmp_path / "again").rglob("*") if p.is_file()}
    assert first == again


@pytest.mark.skipif(not HAS_VALIDATOR, reason="the Khronos validator is not here; run: npm install gltf-validator")
@pytest.mark.parametrize("name", ["people/ada/ada.glb", "people/ada/vat/ada_vat.glb"])
def test_the_khronos_validator_finds_nothing(pack: Path, name: str) -> None:
    done = subprocess.run(["node", VALIDATOR, NODE_MODULES, pack / name], capture_output=True, text=True, check=True)
    issues = json.loads(done.stdout)["issues"]
    assert (issues["numErrors"], issues["numWarnings"]) == (0, 0), issues["messages"][:3]


def test_the_levels_leave_under_their_names_with_the_very_same_vertices(pack: Path) -> None:
    gltf = pygltflib.GLTF2.load(pack / "people/ada/ada.glb")
    assert [mesh.name for mesh in gltf.meshes] == [f"ada_LOD{k}" for k in range(4)]
    first = gltf.meshes[0].primitives[0].attributes
    for mesh in gltf.meshes[1:]:
        own = mesh.primitives[0].attributes
        for name in ("POSITION", "NORMAL", "TEXCOORD_0", "JOINTS_0", "WEIGHTS_0"):
            views = [gltf.accessors[getattr(one, name)].bufferView for one in (first, own)]
            assert views[0] == views[1]  # one buffer: bit-equal by construction
    assert {one.name for one in gltf.animations} == {"walk", "idle"}


@pytest.mark.skipif(readers.GODOT is None, reason="Godot is not here; run: apt-get install godot3-server")
def test_godot_reads_the_levels(pack: Path) -> None:
    told = readers.godot(pack / "people/ada/ada.glb")
    assert told.get("error") is None
    assert (told["joints"], told["clips"]) == (94, 2)
    assert told["high"] - told["low"] == pytest.approx(1.70, abs=0.05)


def test_vertex_animation_decodes_to_the_skinned_walk(pack: Path, results: Path) -> None:
    """Read as its documentation says, by nothing of ours, against linear blend skinning: at most 1 mm off."""
    folder = pack / "people/ada/vat"
    remap = json.loads((folder / "ada_vat-remap_info.json").read_text())
    image = cv2.imread(str(folder / "ada_vat.png"), cv2.IMREAD_UNCHANGED)[..., ::-1].astype(np.float64) / 65535.0
    gltf = pygltflib.GLTF2.load(folder / "ada_vat.glb")
    (primitive,) = gltf.meshes[0].primitives
    accessor = gltf.accessors[primitive.attributes.POSITION]
    view = gltf.bufferViews[accessor.bufferView]
    rest = np.frombuffer(gltf.binary_blob(), np.float32, 3 * accessor.count, view.byteOffset).reshape(-1, 3)
    assert accessor.count == image.shape[1] < 8192
    frames, told = remap["os-remap"]["Frames"], remap["os-remap"]
    assert image.shape[0] == 2 * frames
    clip = remap["animations"]["walk"]
    clone = centre_joints(load_clone(results / "ada" / CLONE_FILE))
    motion = sample_walk(body_of(clone), REGULAR)
    generic, body = load_generic(), body_levels()
    count = body.counts[LEVEL]
    row = clip["startFrame"] + 12  # a quarter of a second
    scaled = np.array(told["Min"]) + image[row] * (np.array(told["Max"]) - told["Min"])
    moved = rest + np.column_stack([scaled[:, 0], scaled[:, 2], -scaled[:, 1]])
    assert motion.times_s[12] == pytest.approx(0.25)
    transforms = joint_transforms(clone.joints_m, generic.joint_parents.astype(np.int32), motion.rotations[12])
    root = motion.root_m[12]
    weights = generic.skin_weights.astype(np.float64)
    want = (
        linear_blend_skinning(clone.vertices_m, transforms, generic.skin_joints.astype(np.int32), weights)[
            body.vertex[:count]
        ]
        + root
    )
    assert np.linalg.norm(moved[:count] - want, axis=1).max() < 1e-3


@pytest.mark.parametrize("style", STYLES.values(), ids=STYLES)
def test_standing_feet_slide_by_millimetres_between_the_frames_that_are_shown(results: Path, style: Style) -> None:
    """Strictly, at the crowd's own 48 frames a cycle: planted between others they slid by 17 mm."""
    body = body_of(centre_joints(load_clone(results / "ada" / CLONE_FILE)))
    motion, dense = sample_walk(body, style), walk(body, style)
    assert motion.speed_m_s > 0.8
    slid = step_slides_m(body, replace(motion, times_s=np.arange(49) / RULER_HZ,
                                       speed_m_s=motion.speed_m_s * motion.times_s[-1] * RULER_HZ / 48))  # fmt: skip
    assert len(slid) == 2
    assert slid.max() < 0.005
    moved = body.places(motion)[::4] - body.places(resample_motion(dense, 12))
    assert np.abs(moved).max() < 0.06, "the same walk, but that feet rise a frame longer before they swing"


def test_a_pack_with_feelings_has_their_walks_and_the_acts_but_not_one_impostor_more(pack: Path, lively: Path) -> None:
    (row, _), (plain, _) = read_facts(lively)["people"], read_facts(pack)["people"]
    names = [clip["name"] for clip in row["clips"]]
    assert [clip["name"] for clip in plain["clips"]] == names[:3] == ["walk", "idle", "sit"]
    assert set(names[3:]) == {f"walk_{name}" for name in STYLES if name != "regular"} | {"run"} | set(ACTS)
    for name in ("colours.webp", "shapes.webp", "covers.webp"):
        assert (pack / "people/ada" / name).read_bytes() == (lively / "people/ada" / name).read_bytes()
    speeds = {clip["name"]: clip["speed_m_s"] for clip in row["clips"]}
    assert speeds["walk_sad"] < speeds["walk"] < speeds["walk_explosive"]
    assert check_pack(lively)


def test_a_damaged_or_missing_file_is_named(pack: Path, tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    shutil.copytree(pack, copy)
    victim = copy / "people/ben/colours.webp"
    victim.write_bytes(victim.read_bytes()[:-7])
    with pytest.raises(ClonerError, match="damaged") as caught:
        check_pack(copy)
    assert caught.value.where == "people/ben/colours.webp"
    victim.unlink()
    with pytest.raises(ClonerError, match="missing"):
        check_pack(copy)
    (copy / "crowd.json").write_text('{"format": "cloner-crowd", "version": 1, "files": {"../x": ""}, "people": [1]}')
    with pytest.raises(ClonerError, match="cannot be read"):
        check_pack(copy)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"consent": False}, "consent"),
        ({"triangle_regions": np.zeros(0, np.uint8)}, "regions"),
        ({"stamp": "Cloner 0.1.0, generic beef"}, "another generic human"),
    ],
)
def test_clones_that_may_not_or_cannot_are_refused_by_name(
    results: Path, tmp_path: Path, change: dict, message: str
) -> None:
    other = saved(tmp_path / "carl", replace(dressed_toy(), **change))
    with pytest.raises(ClonerError, match=message) as caught:
        make_pack([results / "ada", other], tmp_path / "out", WANTED)
    assert caught.value.where == "carl"
    assert not (tmp_path / "out").exists()


def nobody_is_made(*told: object) -> None:
    raise AssertionError(f"{told} was begun before the looks were read")


def test_bad_words_end_in_one_sentence(results: Path, tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    with pytest.raises(ClonerError, match="no clones were given"):
        make_pack([], tmp_path / "out", WANTED)
    with pytest.raises(ClonerError, match="there is no clone"):
        make_pack([tmp_path / "empty"], tmp_path / "out", WANTED)
    with pytest.raises(ClonerError, match="two clones"):
        make_pack([results / "ada", results], tmp_path / "out", WANTED)
    for wrong in ({"views": 7}, {"poses": 5}, {"scene": "moon"}, {"people": 0}, {"rings_deg": (95.0,)}):
        with pytest.raises(ClonerError):
            make_pack([results], tmp_path / "out", replace(WANTED, **wrong))
    with pytest.raises(ClonerError):
        parse_rings("5,high")
    looks = tmp_path / "looks.toml"
    for text in ('[palette]\nskin = ["#112233"]', "own_share = 3", '[palette]\ntop = ["red"]', "x = 1", "= ="):
        looks.write_text(text)
        with pytest.raises(ClonerError):
            make_pack([results], tmp_path / "out", replace(WANTED, looks=looks), report=nobody_is_made)
    assert not (tmp_path / "out").exists()


def test_a_full_disk_leaves_nothing_and_harms_nobody(
    results: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = {path: path.read_bytes() for path in results.rglob("*") if path.is_file()}
    real, written = Path.write_bytes, []

    def full(self: Path, data: bytes) -> int:
        if len(written) > 3:
            raise OSError(errno.ENOSPC, "No space left on device")
        written.append(self)
        return real(self, data)

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(ClonerError, match="cannot be written"):
        make_pack([results / "ada"], tmp_path / "deep" / "out", WANTED)
    assert not (tmp_path / "deep").exists()
    assert {path: path.read_bytes() for path in results.rglob("*") if path.is_file()} == before


def test_what_a_killed_run_left_is_swept(tmp_path: Path) -> None:
    """The number of a process that has ended stands for one that was killed; our own is at work."""
    gone = subprocess.Popen(["true"])
    gone.wait()
    dead, busy = tmp_path / f".out.partial-{gone.pid}-x", tmp_path / f".out.partial-{os.getpid()}-y"
    (dead / "replaced").mkdir(parents=True)
    (dead / "replaced" / "crowd.json").write_text("{}")
    busy.mkdir()
    with pack_folder(tmp_path / "out") as inside:
        (inside / "crowd.json").write_text("new")
    assert (tmp_path / "out" / "crowd.json").read_text() == "new"
    assert not dead.exists()
    assert busy.exists()


def test_something_else_is_never_replaced(results: Path, tmp_path: Path) -> None:
    mine = tmp_path / "mine"
    mine.mkdir()
    (mine / "letter.txt").write_text("dear")
    with pytest.raises(ClonerError, match="in the way"):
        make_pack([results / "ada"], mine, WANTED)
    assert (mine / "letter.txt").read_text() == "dear"


def test_hostile_names_stay_names(tmp_path: Path) -> None:
    folder = saved(tmp_path / "x<script>alert(1)</script>"[:30].replace("/", "_"), dressed_toy())
    facts = make_pack([folder], tmp_path / "out", replace(WANTED, vat=False))
    (row,) = facts["people"]
    assert all(letter.isalnum() or letter in "-_." for letter in row["id"])
    assert b"<script>alert" not in (tmp_path / "out" / "player.html").read_bytes()


def test_a_pack_is_found_handed_out_and_forgotten(pack: Path, tmp_path: Path) -> None:
    copy = tmp_path / "event" / "wall"
    shutil.copytree(pack, copy)
    one = find_holding("ada", holdings(None, tmp_path / "event"))
    assert one.packs == (copy / "people" / "ada",)
    with zipfile.ZipFile(export_data(one, tmp_path / "ada.zip")) as archive:
        assert {Path(name).suffix for name in archive.namelist()} >= {".glb", ".webp", ".bin"}
    assert forget(one, None, tmp_path / "event") == ()
    assert not copy.exists()
