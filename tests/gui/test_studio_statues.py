"""Statues in the window: a clone in stone, a photograph laid by dragged markers, a body of blobs."""

import json

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt

from cloner.bodies.telling import BodySpecification
from cloner.booth.studio.carving import MARKED
from cloner.picture import load_clone_at
from cloner.statues.markers import known_points
from cloner_gui.studio.blob_scene import blob_meshes
from cloner_gui.studio.blobs import BlobsWindow
from cloner_gui.studio.photo_scene import FittedPhotoScene
from cloner_gui.studio.photograph import PhotographWindow
from cloner_gui.studio.statues import StoneWindow
from kit.studio_window import TEXELS, press, tape_clone

pytestmark = pytest.mark.gui


@pytest.fixture(scope="module")
def tom(tmp_path_factory):
    return tape_clone(tmp_path_factory.mktemp("tom") / "tom", BodySpecification("m", 1.78, {}))


@pytest.fixture
def booth(studio_window, monkeypatch):
    monkeypatch.setattr("cloner_gui.studio.statues._TEXELS", TEXELS)
    monkeypatch.setattr("cloner.booth.studio.carving._SHOWN_TEXELS", TEXELS)
    return studio_window.booth


def rested(qtbot, window):
    qtbot.waitUntil(lambda: not window.busy)


def test_a_clone_is_cut_from_bronze_and_lies_beside_it(booth, qtbot, tom):
    window = StoneWindow(booth)
    window.show()
    assert not window.save_button.isEnabled()
    window.subject.choose(tom)
    qtbot.waitUntil(lambda: not window.preview.pixmap().isNull())
    window.material.setCurrentIndex(window.material.findData("bronze"))
    window.material.activated.emit(0)
    rested(qtbot, window)
    colours = window.preview._clone.atlas.rgb.reshape(-1, 3).mean(axis=0)
    assert colours[0] > colours[2] + 10, "bronze is brown"
    press(qtbot, window.save_button)
    rested(qtbot, window)
    statue = load_clone_at(tom.parent / "tom-bronze")
    assert statue.atlas.shine.size
    assert "tom-bronze" in window.written.text()
    window.close()


@pytest.fixture
def laid(booth, qtbot, samples):
    window = PhotographWindow(booth)
    window.resize(1100, 700)
    window.show()
    window.open_photo(samples / "boris" / "plain" / "face_front.jpg")
    qtbot.waitUntil(lambda: window._fit is not None and bool(window.drags_s))
    rested(qtbot, window)
    yield window
    window.close()


def at(window, name):
    return window.view.lens.widget_from_photo(*window.view.points.get(name)).toPoint()


def test_markers_are_dragged_and_the_clone_shows_it_live(laid, qtbot):
    assert len(laid.markers().at) == len(MARKED) == 40
    before = laid._fit
    assert isinstance(laid.preview.shown, FittedPhotoScene)
    start = at(laid, "nose_tip")
    qtbot.mousePress(laid.view, Qt.MouseButton.LeftButton, pos=start)
    assert laid.view.chosen == "nose_tip"
    for step in range(1, 9):
        count = len(laid.drags_s)
        qtbot.mouseMove(laid.view, start + QPoint(2 * step, step))
        qtbot.waitUntil(lambda count=count: len(laid.drags_s) > count)
    qtbot.mouseRelease(laid.view, Qt.MouseButton.LeftButton, pos=start + QPoint(16, 8))
    qtbot.waitUntil(lambda: laid._fit is not before)
    vertex = known_points()["nose_tip"]
    seen = laid._fit.camera.project(laid._fit.vertices_m[[vertex]])[0]
    told = laid.markers().px[laid.markers().at.index("nose_tip")]
    assert np.linalg.norm(seen - told) < 0.5, "every marker is met"
    # the bar is 50 ms at the desk (docs/statues_benchmark.md); tests share their machine
    assert np.median(laid.drags_s[1:]) < 0.5


def test_markers_are_added_on_the_clone_and_taken_away_on_the_photo(laid, qtbot):
    middle = laid.preview.rect().center() + QPoint(12, -30)
    qtbot.mouseDClick(laid.preview, Qt.MouseButton.LeftButton, pos=middle)
    qtbot.waitUntil(lambda: len(laid.markers().at) == 41 and laid._marked is not None)
    added = laid.markers().at[-1]
    assert isinstance(added, int)
    assert laid.view.chosen == f"vertex_{added}"
    laid.view.setFocus()
    qtbot.keyClick(laid.view, Qt.Key.Key_Delete)
    assert len(laid.markers().at) == 40
    assert added not in laid.markers().at


def test_the_photo_is_painted_all_round_and_saved(laid, qtbot, monkeypatch, tmp_path):
    monkeypatch.setattr("cloner_gui.studio.statues.QFileDialog.getExistingDirectory", lambda *_: str(tmp_path / "all"))
    press(qtbot, laid.paint_button)
    rested(qtbot, laid)
    assert not isinstance(laid.preview.scene(), FittedPhotoScene)
    laid.material.setCurrentIndex(laid.material.findData("clay"))
    laid.name_field.setText("soldier")
    press(qtbot, laid.save_button)
    rested(qtbot, laid)
    assert not laid.notice.messages
    clone = load_clone_at(tmp_path / "all" / "soldier")
    assert clone.atlas.shine.size
    report = json.loads((tmp_path / "all" / "soldier" / "report.json").read_text())
    assert report["kind"] == "photo on a mesh"


def test_a_photo_without_a_face_begins_with_markers_in_its_middle(booth, qtbot, tmp_path):
    from PIL import Image

    Image.fromarray(np.full((600, 500, 3), 120, np.uint8)).save(tmp_path / "wall.png")
    window = PhotographWindow(booth)
    window.show()
    window.open_photo(tmp_path / "wall.png")
    qtbot.waitUntil(lambda: window._fit is not None)
    px = window.markers().px
    assert np.abs(px.mean(axis=0) - (250, 300)).max() < 120
    assert 100 < np.ptp(px[:, 1]) < 500
    assert "face" in window.told.text().lower()
    window.close()


@pytest.fixture
def blobs(booth, qtbot):
    window = BlobsWindow(booth)
    window.resize(1100, 760)
    window.show()
    qtbot.waitUntil(lambda: bool(window.blobs) and not window.busy and not window._stale)
    yield window
    window.close()


def laid_on(qtbot, window):
    qtbot.waitUntil(lambda: not window.busy and not window._stale)


def test_a_radius_makes_the_body_stouter(blobs, qtbot):
    row = next(number for number, blob in enumerate(blobs.blobs) if blob.name == "belly")
    blobs.list.setCurrentRow(row)
    before = blobs.preview._clone.vertices_m
    waist = (np.abs(before[:, 1] - 1.05) < 0.05) & (np.abs(before[:, 0]) < 0.15)
    blobs.numbers["radius 0"].setValue(blobs.numbers["radius 0"].value() + 5.0)
    blobs.numbers["radius 1"].setValue(blobs.numbers["radius 1"].value() + 5.0)
    laid_on(qtbot, blobs)
    after = blobs.preview._clone.vertices_m
    assert after[waist, 2].max() - before[waist, 2].max() > 0.02
    head = before[:, 1] > 1.65
    assert np.allclose(after[head], before[head], atol=1e-6)


def test_a_blob_is_dragged_in_the_picture(blobs, qtbot):
    shown = blobs.preview
    qtbot.waitUntil(lambda: not shown.pixmap().isNull())
    scene = shown.scene()
    row = next(number for number, blob in enumerate(blobs.blobs) if blob.name == "chest")
    camera = scene.orbit.camera(scene.clone, shown.width(), shown.height(), np.zeros(3))
    from cloner.statues.blobs import field_of

    places, _ = blob_meshes(field_of(blobs.blobs, scene.clone.joints_m), [row])
    start = QPoint(*camera.project(places).mean(axis=0).round().astype(int).tolist())
    found = shown.blob_at(start.toPointF())
    assert found is not None
    before = np.array(blobs.blobs[found].off_m)
    qtbot.mousePress(shown, Qt.MouseButton.LeftButton, pos=start)
    assert blobs.list.currentRow() == found
    qtbot.mouseMove(shown, start + QPoint(20, 0))
    qtbot.mouseRelease(shown, Qt.MouseButton.LeftButton, pos=start + QPoint(20, 0))
    way = np.array(blobs.blobs[found].off_m) - before
    assert way[0, 0] > 0.01, "to the person's left, which is right in the picture"
    assert np.abs(way[:, 1:]).max() < 0.005
    laid_on(qtbot, blobs)
    outside = QPoint(5, 5)
    turn = shown._orbit.turn
    qtbot.mousePress(shown, Qt.MouseButton.LeftButton, pos=outside)
    qtbot.mouseMove(shown, outside + QPoint(30, 0))
    qtbot.mouseRelease(shown, Qt.MouseButton.LeftButton, pos=outside + QPoint(30, 0))
    assert shown._orbit.turn != turn, "elsewhere a drag turns the body"


def test_blobs_are_opened_saved_and_become_a_statue(blobs, qtbot, monkeypatch, tmp_path, samples):
    monkeypatch.setattr(
        "cloner_gui.studio.blobs.QFileDialog.getOpenFileName", lambda *_: (str(samples / "soldier.blobs.json"), "")
    )
    target = tmp_path / "mine.json"
    monkeypatch.setattr("cloner_gui.studio.blobs.QFileDialog.getSaveFileName", lambda *_: (str(target), ""))
    monkeypatch.setattr("cloner_gui.studio.statues.QFileDialog.getExistingDirectory", lambda *_: str(tmp_path / "all"))
    press(qtbot, blobs.open_button)
    laid_on(qtbot, blobs)
    assert blobs.list.count() == len(blobs.blobs) == 29
    press(qtbot, blobs.file_button)
    assert len(json.loads(target.read_text())["blobs"]) == 29
    target.write_text("{")
    monkeypatch.setattr("cloner_gui.studio.blobs.QFileDialog.getOpenFileName", lambda *_: (str(target), ""))
    press(qtbot, blobs.open_button)
    assert blobs.notice.messages
    assert len(blobs.blobs) == 29, "what was there stays"
    blobs.material.setCurrentIndex(blobs.material.findData("stone"))
    blobs.name_field.setText("guard")
    press(qtbot, blobs.save_button)
    laid_on(qtbot, blobs)
    assert load_clone_at(tmp_path / "all" / "guard").atlas.shine.size
