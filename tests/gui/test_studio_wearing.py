"""A clone is dressed in the window: arranged, sewn, hung, walked in, saved; nobody is undressed unasked."""

import shutil
import threading

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QMessageBox

from cloner.bodies.telling import BodySpecification
from cloner.booth.studio.jobs import StudioJobs
from cloner.cloth import dressing
from cloner.errors import Cancelled
from cloner.project.clone_file import load_clone
from cloner.project.flow_file import load_flow
from cloner_gui.studio.wardrobe import TARGETS
from cloner_gui.studio.wearing import ANIMATE, ARRANGE, EXPORT, FABRIC, SEW, WearingWindow
from kit.studio_window import Studio, press, tape_clone

pytestmark = pytest.mark.gui


@pytest.fixture(scope="module")
def eva(tmp_path_factory):
    return tape_clone(tmp_path_factory.mktemp("eva") / "eva", BodySpecification("f", 1.68, {"waist_girth": 740.0}))


class SteeredStudio(Studio):
    """The studio's jobs, held up where a test wants that."""

    hold = None

    def __call__(self, method, arguments, progress, show):
        while self.hold is not None and not self.hold.wait(0.01):
            progress(method, 0.5)
        return super().__call__(method, arguments, progress, show)


@pytest.fixture
def studio(monkeypatch):
    usual = dressing.Dressing.__init__.__kwdefaults__
    monkeypatch.setattr(dressing.Dressing.__init__, "__kwdefaults__", usual | {"cycles": 4, "step_m": 0.08})
    return SteeredStudio()


@pytest.fixture
def wearing(studio_window, eva):
    made = WearingWindow(studio_window.booth, studio_window)
    made.show()
    made.subject.choose(eva)
    yield made
    made.close()


def on(qtbot, window, step):
    qtbot.waitUntil(lambda: window.step == step and not window.busy)


def test_a_skirt_is_arranged_sewn_walked_in_and_saved(wearing, qtbot, monkeypatch, tmp_path):
    target = tmp_path / "eva.glb"
    monkeypatch.setattr("cloner_gui.studio.wearing.QFileDialog.getSaveFileName", lambda *_: (str(target), ""))
    seen = []
    wearing.preview.drawn.connect(lambda: seen.append(wearing.preview.shown))
    press(qtbot, wearing.next_button)
    on(qtbot, wearing, SEW)
    assert len(wearing.pieces.pieces_m) == 2
    flat = wearing.preview.draped.places_m
    assert len(flat) == 1
    press(qtbot, wearing.next_button)
    on(qtbot, wearing, FABRIC)
    hung = wearing.preview.draped.places_m
    assert np.abs(hung - flat).max() > 0.005, "it was let go"
    wearing.fabric.setCurrentIndex(wearing.fabric.findData("denim"))
    wearing.fabric.activated.emit(wearing.fabric.currentIndex())
    on(qtbot, wearing, FABRIC)
    assert wearing.outfit().fabric == "denim"
    colour = wearing.preview.draped.parts[-1][1]
    assert colour[2] > colour[0], "denim is blue"
    press(qtbot, wearing.next_button)
    on(qtbot, wearing, ANIMATE)
    assert len(wearing.preview.draped.places_m) > 20
    press(qtbot, wearing.next_button)
    on(qtbot, wearing, EXPORT)
    assert target.read_bytes()[:4] == b"glTF"
    assert wearing.written.isVisible()
    qtbot.waitUntil(lambda: any(one.draped is not None for one in seen if hasattr(one, "draped")))
    folder, kind = tmp_path / "eva-skirt", f"{TARGETS['']} (*)"
    monkeypatch.setattr(
        "cloner_gui.studio.wearing.QFileDialog.getSaveFileName", lambda *_: (f"{folder}.glb", kind)
    )  # the dialog's own proposal, with the folder chosen
    wearing._export(wearing.outfit())
    qtbot.waitUntil(lambda: (folder / "report.json").is_file() and not wearing.busy, timeout=30_000)
    clone = load_clone(folder / "clone.npz")
    flow = load_flow(folder, clone)
    assert flow is not None
    assert len(flow.frames_m) > 20


def test_a_cape_is_worn_over_a_skirt(wearing, qtbot):
    for step in (SEW, FABRIC, ANIMATE):
        press(qtbot, wearing.next_button)
        on(qtbot, wearing, step)
    assert wearing.over_button.isVisible()
    skirt = wearing.outfit()
    press(qtbot, wearing.over_button)
    assert wearing.step == ARRANGE
    assert not wearing.subject.isEnabled(), "who wears it stays"
    wearing.garment.setCurrentIndex(wearing.garment.findData("cape"))
    wearing.garment.activated.emit(wearing.garment.currentIndex())
    wearing.fabric.setCurrentIndex(wearing.fabric.findData("silk"))
    assert wearing.outfit().under == skirt
    for step in (SEW, FABRIC, ANIMATE):
        press(qtbot, wearing.next_button)
        on(qtbot, wearing, step)
        shown = wearing.preview.draped
        assert len(shown.parts) == 2
        assert sum(count for count, _ in shown.parts) == len(shown.faces)
        assert shown.faces.max() == shown.places_m.shape[1] - 1
    assert len(wearing.preview.draped.places_m) > 20


def test_work_is_stopped_at_once_and_goes_on_from_there(wearing, qtbot, studio):
    press(qtbot, wearing.next_button)
    on(qtbot, wearing, SEW)
    studio.hold = threading.Event()
    press(qtbot, wearing.next_button)
    qtbot.waitUntil(lambda: wearing.busy)
    assert not wearing.garment.isEnabled()
    assert wearing.cancel_button.isVisible()
    press(qtbot, wearing.cancel_button)
    on(qtbot, wearing, SEW)
    assert not wearing.cancel_button.isVisible()
    studio.hold = None
    press(qtbot, wearing.next_button)
    on(qtbot, wearing, FABRIC)


def test_nobody_is_undressed_unasked(wearing, qtbot, eva, monkeypatch):
    def box():
        return next(one for one in wearing.findChildren(QMessageBox) if one.isVisible())

    def click(end):
        qtbot.mouseClick(wearing.bare, Qt.MouseButton.LeftButton, pos=QPoint(10, wearing.bare.height() // 2))
        qtbot.waitUntil(lambda: any(one.isVisible() for one in wearing.findChildren(QMessageBox)))
        asked = box()
        assert not wearing.bare.isChecked(), "not before the operator said so"
        end(asked)
        qtbot.waitUntil(lambda: not any(one.isVisible() for one in wearing.findChildren(QMessageBox)))

    click(lambda asked: asked.reject())
    assert not wearing.bare.isChecked()
    assert not wearing.outfit().bare
    click(lambda asked: qtbot.mouseClick(asked.buttons()[0], Qt.MouseButton.LeftButton))
    assert wearing.outfit().bare
    wearing.subject.choose(eva)
    assert not wearing.outfit().bare, "of another clone it is asked anew"
    monkeypatch.setattr(wearing.booth, "allowed", lambda: False)
    qtbot.mouseClick(wearing.bare, Qt.MouseButton.LeftButton, pos=QPoint(10, wearing.bare.height() // 2))
    assert not wearing.bare.isChecked()
    assert not wearing.outfit().bare, "in the kiosk only with the number"


def test_a_bad_file_is_refused_in_one_sentence(wearing, qtbot, monkeypatch, tmp_path):
    path = tmp_path / "bad.svg"
    path.write_text("<svg")
    monkeypatch.setattr("cloner_gui.studio.wearing.QFileDialog.getOpenFileName", lambda *_: (str(path), ""))
    last = wearing.garment.count() - 1
    wearing.garment.setCurrentIndex(last)
    wearing.garment.activated.emit(last)
    assert wearing.outfit().garment == str(path)
    press(qtbot, wearing.next_button)
    qtbot.waitUntil(lambda: bool(wearing.notice.messages))
    assert "SVG" in wearing.notice.messages[0]
    on(qtbot, wearing, ARRANGE)


def test_what_was_cancelled_leaves_no_file(eva, tmp_path, monkeypatch):
    usual = dressing.Dressing.__init__.__kwdefaults__
    monkeypatch.setattr(dressing.Dressing.__init__, "__kwdefaults__", usual | {"cycles": 4, "step_m": 0.06})
    from cloner.booth.studio.values import Outfit

    def stop(step, fraction):
        if step == "export":
            raise Cancelled

    with pytest.raises(Cancelled):
        StudioJobs().save_worn(Outfit(eva), tmp_path / "out.glb", stop)
    assert not list(tmp_path.iterdir())


def test_a_clone_that_is_deleted_is_seen_no_longer(wearing, qtbot, eva, tmp_path):
    gone = tmp_path / "gone"
    shutil.copytree(eva, gone)
    wearing.subject.choose(gone)
    qtbot.waitUntil(lambda: wearing.preview._clone is not None)
    press(qtbot, wearing.next_button)
    on(qtbot, wearing, SEW)
    shutil.rmtree(gone)
    wearing.booth.visits_changed.emit()
    assert wearing.outfit() is None
    assert wearing.preview._clone is None
    assert wearing.preview.draped is None
    assert not wearing.next_button.isEnabled()


def test_the_kiosk_hides_the_studio(wearing, qtbot):
    window = wearing.parent()
    window.booth.change(pin="x")
    window.menus._open_studio("wearing")
    opened = [one for one in window.findChildren(WearingWindow) if one is not wearing]
    assert len(opened) == 1
    window.kiosk.toggle()
    assert not opened[0].isVisible()
    assert not window.menuBar().isVisible()
    window.kiosk._end()
    titles = [one.text().replace("&", "") for one in window.menuBar().actions()]
    assert titles[-1] == "Studio"
