"""Bodies from a tape in the window: sliders, what follows, what is refused, what is written."""

import numpy as np
import pytest
from PySide6.QtCore import Qt

from cloner.bodies.ruler import read
from cloner.bodies.telling import BodySpecification
from cloner.generic.tape import load_tape_rules
from cloner.picture import load_clone_at
from cloner.records.regions import REGIONS
from cloner_gui.studio.bodies import CLONE, NINE, BodiesWindow
from cloner_gui.studio.measure_row import STATURE
from kit.studio_window import TEXELS, tape_clone

pytestmark = pytest.mark.gui


@pytest.fixture
def bodies(studio_window, monkeypatch):
    monkeypatch.setattr("cloner_gui.studio.bodies._TEXELS", TEXELS)
    monkeypatch.setattr("cloner.booth.studio.shaping._SHOWN_TEXELS", TEXELS)
    shown = BodiesWindow(studio_window.booth, studio_window)
    shown.show()
    yield shown
    shown.close()


def rested(qtbot, window):
    qtbot.waitUntil(lambda: not window.busy and not window._stale and window._base is not None)


def girth(clone, key):
    return read(clone.vertices_m, clone.joints_m, load_tape_rules(), (key,)).mm[key]


def test_a_slider_tells_a_measure_and_the_others_follow(bodies, qtbot):
    rested(qtbot, bodies)
    assert bodies.rows["waist_girth"].told_cm() is None
    before = bodies.rows["hip_girth"].number.value()
    bodies.rows["bust_girth"].slider.setValue(1000)
    bodies.rows["waist_girth"].number.setValue(86.0)
    rested(qtbot, bodies)
    shown = bodies.preview._clone
    assert girth(shown, "bust_girth") == pytest.approx(1000.0, abs=1.0)
    assert girth(shown, "waist_girth") == pytest.approx(860.0, abs=1.0)
    assert bodies.rows["hip_girth"].told_cm() is None
    assert bodies.rows["hip_girth"].number.value() != before, "it follows"
    qtbot.mouseClick(
        bodies.rows["waist_girth"].box,
        Qt.MouseButton.LeftButton,
        pos=bodies.rows["waist_girth"].box.rect().center().__class__(8, bodies.rows["waist_girth"].box.height() // 2),
    )
    rested(qtbot, bodies)
    assert bodies.wish().cm == {"bust_girth": 100.0}


def test_a_child_of_that_age_stands_there(bodies, qtbot):
    rested(qtbot, bodies)
    bodies.age.setValue(8)
    rested(qtbot, bodies)
    assert bodies.rows[STATURE].number.value() == pytest.approx(127.6, abs=0.2)
    assert bodies.wish().age_years == 8.0
    shirt = bodies.preview._clone.triangle_regions == REGIONS.index("upper_clothes")
    assert shirt.any()
    bodies.rows["waist_girth"].number.setValue(60.0)
    rested(qtbot, bodies)
    assert girth(bodies.preview._clone, "waist_girth") == pytest.approx(600.0, abs=1.0)


def test_nine_measures_are_asked_where_a_tailor_takes_them(bodies, qtbot):
    rested(qtbot, bodies)
    assert sum(row.isVisible() for row in bodies.rows.values()) == 4
    bodies.preset.setCurrentIndex(bodies.preset.findData(NINE))
    bodies.preset.activated.emit(1)
    rested(qtbot, bodies)
    assert sum(row.isVisible() for row in bodies.rows.values()) == 9


def test_what_no_body_has_is_refused_in_one_sentence_and_not_saved(bodies, qtbot):
    rested(qtbot, bodies)
    bodies.preset.setCurrentIndex(bodies.preset.findData(NINE))
    bodies.preset.activated.emit(1)
    rested(qtbot, bodies)
    good = bodies.preview._clone
    bodies.rows["bust_girth"].number.setValue(80.0)
    bodies.rows["underbust_girth"].number.setValue(95.0)
    rested(qtbot, bodies)
    assert "bust girth" in bodies.refused.text()
    assert not bodies.save_button.isEnabled()
    assert np.isfinite(bodies.preview._clone.vertices_m).all()
    assert good is not None
    bodies.rows["underbust_girth"].number.setValue(72.0)
    rested(qtbot, bodies)
    assert not bodies.refused.text()
    assert bodies.save_button.isEnabled()


def test_a_body_is_saved_like_any_clone(bodies, qtbot, monkeypatch, tmp_path):
    monkeypatch.setattr("cloner_gui.studio.bodies.QFileDialog.getExistingDirectory", lambda *_: str(tmp_path / "all"))
    rested(qtbot, bodies)
    bodies.rows[STATURE].number.setValue(171.0)
    bodies.rows["hip_girth"].number.setValue(104.0)
    rested(qtbot, bodies)
    bodies.name_field.setText("eva")
    qtbot.mouseClick(bodies.save_button, Qt.MouseButton.LeftButton)
    rested(qtbot, bodies)
    clone = load_clone_at(tmp_path / "all" / "eva")
    assert clone.stature_m == pytest.approx(1.71)
    assert girth(clone, "hip_girth") == pytest.approx(1040.0, abs=1.0)
    assert (tmp_path / "all" / "eva" / "clone.glb").is_file()
    assert "all/eva" in bodies.written.text()


def test_a_clone_that_is_told_new_measures_lies_beside_the_old_one(bodies, qtbot, tmp_path):
    folder = tape_clone(tmp_path / "clones" / "tom", BodySpecification("m", 1.8, {}))
    clone = load_clone_at(folder)
    rested(qtbot, bodies)
    bodies.kind.setCurrentIndex(bodies.kind.findData(CLONE))
    bodies.kind.activated.emit(2)
    bodies.subject.choose(folder)
    rested(qtbot, bodies)
    waist = bodies.rows["waist_girth"].number.value()
    assert waist == pytest.approx(clone.measures_mm["waist_girth"] / 10.0, abs=0.1)
    bodies.rows["waist_girth"].number.setValue(waist - 6.0)
    rested(qtbot, bodies)
    qtbot.mouseClick(bodies.save_button, Qt.MouseButton.LeftButton)
    rested(qtbot, bodies)
    slim = load_clone_at(tmp_path / "clones" / "tom-2")
    assert slim.measures_mm["waist_girth"] == pytest.approx(10.0 * (waist - 6.0), abs=1.5)
    assert slim.stature_m == pytest.approx(1.8, abs=1e-3)
