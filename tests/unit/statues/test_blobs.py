"""Metaballs: their surface, a body laid on it, and the blobs that make a body."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from cloner.bodies.made import clone_of_measures
from cloner.bodies.telling import BodySpecification
from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_triangles
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.picture import load_clone_at
from cloner.project.results import is_result
from cloner.statues.blob_bodies import blob_folder, blobs_file, clone_of_blobs
from cloner.statues.blobs import LEVEL, Blob, field_of, read_blobs, written_blobs
from cloner.statues.envelope import fit_to_blobs
from cloner.statues.usual_blobs import usual_blobs
from kit.crowds import dressed_toy, saved

SOLDIER = Path(__file__).resolve().parents[3] / "samples" / "soldier.blobs.json"


@pytest.fixture(scope="module")
def man():
    return clone_of_measures(BodySpecification("m", 1.75, {}), 512)


@pytest.fixture(scope="module")
def blobs(man):
    return usual_blobs(man.vertices_m, man.joints_m)


def test_the_surface_of_a_lone_blob_lies_at_its_radius(man) -> None:
    joint = man.joints_m[load_generic().joint("vl3")]
    ball = field_of((Blob("a", ("vl3",), (0.1,), ((0.0, 0.0, 0.05),), (2.0, 1.0, 1.0)),), man.joints_m)
    around = joint + [0.0, 0.0, 0.05] + np.array([[0.2, 0, 0], [0, 0.1, 0], [0, 0, -0.1]])
    assert ball.at(around) == pytest.approx([LEVEL] * 3)
    assert ball.at(joint[None] + 0.5) == pytest.approx(0.0)
    drawn = field_of((Blob("b", ("l_hip", "l_knee"), (0.08, 0.05), ((0, 0, 0),) * 2),), man.joints_m)
    hip, knee = (man.joints_m[load_generic().joint(name)] for name in ("l_hip", "l_knee"))
    way = (knee - hip) / np.linalg.norm(knee - hip)
    across = np.cross(way, [0.0, 0.0, 1.0])
    across /= np.linalg.norm(across)
    middle = 0.5 * (hip + knee) + 0.065 * across
    assert drawn.at(np.stack([knee + 0.05 * way, hip - 0.08 * way, middle])) == pytest.approx([LEVEL] * 3)


def test_blobs_melt_together(man) -> None:
    one, other = (Blob("a", ("vl3",), (0.1,), ((x, 0.0, 0.0),)) for x in (-0.13, 0.13))
    between = man.joints_m[load_generic().joint("vl3")][None]
    alone = field_of((one,), man.joints_m).at(between)
    assert alone < LEVEL
    assert field_of((one, other), man.joints_m).at(between) == pytest.approx(2.0 * alone)


def test_usual_blobs_make_the_body_they_were_taken_from(man, blobs) -> None:
    found = fit_to_blobs(man.vertices_m, man.joints_m, field_of(blobs, man.joints_m))
    laid = np.isfinite(found.off_m)
    moved = np.linalg.norm(found.vertices_m - man.vertices_m, axis=1)[laid]
    assert moved.mean() < 0.005
    assert np.abs(found.off_m[laid]).mean() < 0.0015
    assert found.missed < 0.05 * found.asked
    left = {blob.name: blob for blob in blobs}
    for name, blob in left.items():
        if name.startswith("l_"):
            twin = left[name.replace("l_", "r_", 1)]
            assert twin.radius_m == blob.radius_m
            assert twin.off_m[0][0] == -blob.off_m[0][0]


def test_the_skin_lies_on_the_surface_and_head_hands_and_feet_stay(man, blobs) -> None:
    generic = load_generic()
    grown = [replace(blob, off_m=tuple((x, y, z + 0.03) for x, y, z in blob.off_m)) if blob.name == "belly" else blob
             for blob in blobs]  # fmt: skip
    field = field_of(grown, man.joints_m)
    found = fit_to_blobs(man.vertices_m, man.joints_m, field)
    before = fit_to_blobs(man.vertices_m, man.joints_m, field_of(blobs, man.joints_m))
    belly = generic.feature("belly_front")
    ahead = found.vertices_m[belly, 2] - before.vertices_m[belly, 2]
    assert 0.01 < ahead < 0.035
    on = np.flatnonzero(np.abs(found.off_m) < 0.001)
    assert len(on) > 0.6 * np.isfinite(found.off_m).sum()
    step = np.abs(field.at(found.vertices_m[on]) - LEVEL)
    assert np.percentile(step, 95) < 0.03  # some 2 mm: the field falls by 15 a metre there
    for name in ("left_hand", "right_foot"):
        own = generic.segment_weights[:, generic.segment_names.index(name)] == 1.0
        assert np.abs(found.vertices_m - man.vertices_m)[own].max() < 0.003
    head = generic.head_blend == 1.0
    assert np.abs(found.vertices_m - man.vertices_m)[head].max() < 0.003
    eyes = generic.part("eye_left")
    assert np.array_equal(found.vertices_m[eyes], man.vertices_m[eyes])


def test_no_triangle_is_turned_over_by_a_stout_body(man, blobs) -> None:
    stout = [replace(blob, radius_m=tuple(1.2 * each for each in blob.radius_m)) for blob in blobs]
    made, _ = clone_of_blobs(man, stout)
    triangles = load_triangles()
    before, now = (
        np.cross(points[triangles[:, 1]] - points[triangles[:, 0]], points[triangles[:, 2]] - points[triangles[:, 0]])
        for points in (man.vertices_m, made.vertices_m)
    )
    assert (np.einsum("ta,ta->t", before, now) < 0.0).mean() < 0.01
    assert made.measures_mm["hip_girth"] > man.measures_mm["hip_girth"] + 60.0
    assert made.measures_mm["neck_girth"] >= man.measures_mm["neck_girth"]
    assert own_motions(centre_joints(made))[0].name == "walk"


def test_blobs_go_through_their_file(blobs, tmp_path: Path) -> None:
    (tmp_path / "a.json").write_text(written_blobs(blobs, "Cloner, photos 00ff"), encoding="utf-8")
    again = read_blobs(tmp_path / "a.json")
    assert [blob.name for blob in again] == [blob.name for blob in blobs]
    for first, second in zip(blobs, again, strict=True):
        assert second.ends == first.ends
        assert np.allclose(second.radius_m, first.radius_m, atol=6e-5)
        assert np.allclose(second.off_m, first.off_m, atol=6e-5)


@pytest.mark.parametrize(
    "one",
    [
        {}, {"from": "l_hip"}, {"from": "l_wing", "radius_m": [0.1]}, {"from": "l_hip", "radius_m": [0.0]},
        {"from": "l_hip", "radius_m": ["a"]}, {"from": "l_hip", "to": "l_knee", "radius_m": [0.1]},
        {"from": "l_hip", "radius_m": [0.1], "off_m": [[0, 0]]},
        {"from": "l_hip", "radius_m": [0.1], "wide": [1, 1, 99]},
        {"from": "l_hip", "radius_m": [0.1], "colour": 1}, {"from": "l_hip", "radius_m": [True]},
        {"from": ["l_hip"], "radius_m": [0.1]}, {"from": "l_hip", "radius_m": [0.1], "name": ""},
    ],
)  # fmt: skip
def test_bad_blobs_are_refused_in_a_sentence(tmp_path: Path, one) -> None:
    (tmp_path / "a.json").write_text(json.dumps({"format": 1, "blobs": [one]}), encoding="utf-8")
    with pytest.raises(ClonerError):
        read_blobs(tmp_path / "a.json")


@pytest.mark.parametrize("text", ["", "[]", '{"format": 1, "blobs": []}', '{"format": 9, "blobs": [1]}', "[" * 5000])
def test_what_is_no_file_of_blobs_is_refused(tmp_path: Path, text: str) -> None:
    (tmp_path / "a.json").write_text(text, encoding="utf-8")
    with pytest.raises(ClonerError):
        read_blobs(tmp_path / "a.json")


def test_blobs_beside_the_body_are_refused(man) -> None:
    with pytest.raises(ClonerError, match="nowhere near"):
        clone_of_blobs(man, (Blob("stray", ("l_wrist",), (0.02,), ((0.9, 0.9, 0.9),)),))


def test_the_soldier_is_a_statue_that_walks(tmp_path: Path) -> None:
    folder, lines = blob_folder(SOLDIER, tmp_path, "soldier", material="clay", formats=("glb",), texture_size=512)
    assert is_result(folder)
    assert "blobs" in lines[0]
    clone = load_clone_at(folder)
    assert clone.atlas.shine.size
    assert clone.measures_mm["waist_girth"] > 950.0  # in armour


def test_a_clone_tells_its_blobs_and_stays_its_visitors(tmp_path: Path) -> None:
    ada = saved(tmp_path / "ada", dressed_toy())
    told = blobs_file(ada, tmp_path / "ada.json")
    assert load_clone_at(ada).stamp in (tmp_path / "ada.json").read_text(encoding="utf-8")  # forget finds copies by it
    assert "mm from the clone's" in told
    folder, _ = blob_folder(tmp_path / "ada.json", tmp_path, "again", onto=ada, formats=(), texture_size=512)
    before, now = load_clone_at(ada), load_clone_at(folder)
    assert np.linalg.norm(now.vertices_m - before.vertices_m, axis=1).mean() < 0.005
    assert now.stamp.startswith(before.stamp)
    assert now.consent
