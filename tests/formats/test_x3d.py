"""clone.x3d as XML, and in X_ITE in a real browser."""

from __future__ import annotations

import os
import shutil
import time
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest

from cloner.exporters.vrml.x3d import export
from cloner.generic.load import load_generic
from kit.browser import CHROMIUM, browser
from kit.clones import toy_clone
from kit.compare_clones import snapshot

X_ITE = Path(os.environ.get("CLONER_NODE_MODULES", "/tmp/cloner-node")) / "node_modules" / "x_ite" / "dist"
needs_x_ite = pytest.mark.skipif(
    CHROMIUM is None or not X_ITE.is_dir(), reason="X_ITE or Chromium is not here; run: npm install x_ite"
)


@pytest.fixture(scope="module")
def clone():
    return toy_clone(1.64)


@pytest.fixture(scope="module")
def x3d(clone, tmp_path_factory) -> Path:
    before = snapshot(clone)
    path = export(clone, tmp_path_factory.mktemp("x3d"))[0]
    assert snapshot(clone) == before
    return path


@pytest.fixture(scope="module")
def root(x3d) -> ET.Element:
    return ET.parse(x3d).getroot()


def numbers(text: str) -> np.ndarray:
    return np.array(text.replace(",", " ").split(), dtype=float)


def test_every_name_is_defined_once_and_before_it_is_used(root) -> None:
    defined: set[str] = set()
    for element in root.iter():
        if name := element.get("DEF"):
            assert name not in defined
            defined.add(name)
        if name := element.get("USE"):
            assert name in defined
    for route in root.iter("ROUTE"):
        assert {route.get("fromNode"), route.get("toNode")} <= defined


def test_all_joints_hang_in_the_skeleton_and_are_listed(root) -> None:
    humanoid = next(root.iter("HAnimHumanoid"))
    listed = [joint for joint in humanoid.findall("HAnimJoint") if joint.get("containerField") == "joints"]
    (skeleton,) = [joint for joint in humanoid.findall("HAnimJoint") if joint.get("containerField") == "skeleton"]
    assert len(listed) == 94
    assert len(list(skeleton.iter("HAnimJoint"))) == 94
    assert skeleton.get("name") == "humanoid_root"
    names = {joint.get("name") for joint in skeleton.iter("HAnimJoint")}
    assert {"l_talocrural", "r_radiocarpal", "l_carpal_distal_interphalangeal_5", "skullbase", "vc4"} <= names


def test_the_skin_is_one_coordinate_bent_by_whole_weights(root, clone) -> None:
    humanoid = next(root.iter("HAnimHumanoid"))
    points = numbers(next(humanoid.iter("Coordinate")).get("point")).reshape(-1, 3)
    assert points[:, 1].min() == pytest.approx(0.0, abs=0.002)
    assert points[:, 2].max() == pytest.approx(clone.vertices_m[:, 2].max(), abs=1e-4)
    total = np.zeros(len(points))
    for joint in humanoid.iter("HAnimJoint"):
        if joint.get("skinCoordIndex"):
            index = numbers(joint.get("skinCoordIndex")).astype(int)
            np.add.at(total, index, numbers(joint.get("skinCoordWeight")))
    assert total == pytest.approx(1.0, abs=0.002)
    shapes = list(humanoid.iter("IndexedFaceSet"))
    assert all(shape.find("Coordinate").get("USE") == "skin_coord" for shape in shapes)
    corners = np.concatenate([numbers(shape.get("coordIndex")).astype(int) for shape in shapes])
    assert corners.max() == len(points) - 1


def test_the_face_has_displacers_in_metres(root, clone) -> None:
    blink = next(one for one in root.iter("HAnimDisplacer") if one.get("name") == "eyeBlinkLeft")
    moved = numbers(blink.get("displacements")).reshape(-1, 3)
    assert len(moved) == len(blink.get("coordIndex").split())
    assert 0.003 < np.linalg.norm(moved, axis=1).max() < 0.03
    assert load_generic().arkit_names[0] in {one.get("name") for one in root.iter("HAnimDisplacer")}


def test_two_motions_have_clocks_and_a_click_changes_over(root) -> None:
    clocks = {clock.get("DEF"): clock for clock in root.iter("TimeSensor")}
    assert list(clocks) == ["walk_clock", "idle_clock"]
    assert clocks["walk_clock"].get("startTime") is None
    assert float(clocks["idle_clock"].get("stopTime")) > float(clocks["idle_clock"].get("startTime")), "it waits"
    (touch,) = root.iter("TouchSensor")
    group = next(group for group in root.iter("Group") if touch in list(group))
    assert group.find("HAnimHumanoid") is not None, "what is clicked on stands beside it"
    routes = {(route.get("toNode"), route.get("toField")) for route in root.iter("ROUTE")
              if route.get("fromNode") == "touch"}  # fmt: skip
    assert routes == {("walk_clock", "set_stopTime"), ("idle_clock", "set_startTime")}
    moved = [{route.get("toNode") for route in root.iter("ROUTE") if route.get("fromNode").startswith(f"{name}_")
              and route.get("fromField") == "value_changed"} for name in ("walk", "idle")]  # fmt: skip
    assert moved[0] == moved[1], "nothing stays as the walk left it"
    assert len(list(root.iter("Viewpoint"))) == 5


def test_displacers_are_driven_the_idle_blinks(root) -> None:
    named = {node.get("DEF"): node for node in root.iter("ScalarInterpolator")}
    key, value = (numbers(named["idle_face_eyeBlinkLeft"].get(field)) for field in ("key", "keyValue"))
    assert len(key) == len(value) < 60, "few keys where nothing moves"
    assert value.max() > 0.9
    assert value[[0, -1]] == pytest.approx(0.0)
    assert np.diff(key).min() > 0.0
    assert numbers(named["walk_face_eyeBlinkLeft"].get("keyValue")).max() == 0.0
    wired = {(route.get("fromNode"), route.get("toNode"), route.get("toField")) for route in root.iter("ROUTE")}
    assert ("idle_face_eyeBlinkLeft", "face_eyeBlinkLeft", "weight") in wired


@needs_x_ite
@pytest.mark.slow
def test_x_ite_shows_the_person_upright_and_walking(x3d, tmp_path: Path) -> None:
    for name in ("x_ite.min.js", "x_ite.css"):
        shutil.copy(X_ITE / name, x3d.parent)
    shutil.copytree(X_ITE / "assets", x3d.parent / "assets", dirs_exist_ok=True)
    page_file = x3d.with_name("page.html")
    page_file.write_text(
        '<!doctype html><meta charset="utf-8"><link rel="stylesheet" href="x_ite.css"><style>body{margin:0}'
        'x3d-canvas{width:500px;height:500px}</style><script defer src="x_ite.min.js"></script>'
        '<body><x3d-canvas src="clone.x3d"></x3d-canvas></body>'
    )
    with browser(tmp_path / "profile", "--allow-file-access-from-files") as page:
        page.open(page_file, 500, 500)
        end, shirt = time.monotonic() + 60, np.zeros((0, 2))
        while time.monotonic() < end and len(shirt) < 500:
            time.sleep(0.5)
            first = page.picture().astype(int)
            shirt = np.argwhere((first[..., 2] > first[..., 0] + 30) & (first[..., 2] > 60))
        assert len(shirt) >= 500, page.complaints()
        moved, end = 0, time.monotonic() + 10  # some poses of a walk look alike
        while moved <= 300 and time.monotonic() < end:
            time.sleep(0.4)
            moved = int((np.abs(first - page.picture()).max(axis=2) > 24).sum())
        person = np.argwhere(np.abs(first - first[2, 2]).max(axis=2) > 24)
        assert np.ptp(person[:, 0]) > 1.3 * np.ptp(person[:, 1]), "upright"
        assert moved > 300, "it walks"
        assert not page.complaints()
