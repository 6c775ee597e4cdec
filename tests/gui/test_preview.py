"""The clone in three dimensions: what is drawn tells what happened."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication

from cloner.booth.body_preview import Shape, plain_clone
from cloner.frames import ViewId
from cloner.geometry.cameras.viewpoints import look_at
from cloner.records.bodies import PosedView
from cloner.records.photos import Photo
from cloner.records.views import Camera
from cloner_gui.background.newest import shared_latest
from cloner_gui.canvas.clones.acting import MODES, MOTIONS, display_meshes, find_motion, pose_at
from cloner_gui.canvas.clones.growth import Growth
from cloner_gui.canvas.clones.preview import Preview
from cloner_gui.canvas.clones.preview_panel import PreviewPanel
from cloner_gui.language.languages import set_language
from cloner_gui.main_window import CLONE
from kit.clones import toy_clone

pytestmark = [pytest.mark.gui, pytest.mark.gl]
FRONT = ViewId.BODY_FRONT


@pytest.fixture(scope="module")
def clone():
    from dataclasses import replace

    made = toy_clone()
    eye = np.array([0.1, 1.0, 3.5])
    camera = Camera(600, 900, 900.0, look_at(eye, np.array([0.0, 0.85, 0.0])))
    return replace(made, views={FRONT: PosedView(FRONT, camera, np.zeros((94, 3)))})


@pytest.fixture
def preview(qtbot, clone):
    widget = Preview()
    qtbot.addWidget(widget)
    widget.resize(240, 320)
    widget.show()
    with qtbot.waitSignal(widget.drawn):
        widget.set_clone(clone)
    return widget


def picture(widget, qtbot, change=None):
    """Return the (H, W, 3) pixels after a change was drawn."""
    (change or widget.refresh)()
    film = widget._film  # while it runs there is always another picture to come
    qtbot.waitUntil(lambda: film.isActive() or (not widget._soon.isActive() and shared_latest().idle))
    image = widget.pixmap().toImage().convertToFormat(widget.pixmap().toImage().Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


def covered(pixels):
    return (pixels != pixels[0, 0]).any(axis=2)


def test_it_turns_moves_zooms_and_comes_back(preview, qtbot):
    first = picture(preview, qtbot)
    assert 0.03 < covered(first).mean() < 0.6, "somebody stands there"
    turned = picture(preview, qtbot, lambda: drag(qtbot, preview, QPoint(78, 0)))
    assert np.ptp(np.flatnonzero(covered(turned).any(axis=0))) < 0.9 * np.ptp(
        np.flatnonzero(covered(first).any(axis=0))
    )
    preview.frame("front")
    moved = picture(preview, qtbot, lambda: drag(qtbot, preview, QPoint(14, 0), Qt.MouseButton.RightButton))
    way = np.flatnonzero(covered(moved).any(axis=0)).mean() - np.flatnonzero(covered(first).any(axis=0)).mean()
    assert way == pytest.approx(14.0, abs=2.0), "the hand keeps hold of the clone"
    again = picture(preview, qtbot, lambda: qtbot.keyClick(preview, Qt.Key.Key_Home))
    assert np.abs(again - first).mean() < 1.0
    at = QPointF(120, 160)
    turn = QWheelEvent(
        at, at, QPoint(), QPoint(0, 120), Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    near = picture(preview, qtbot, lambda: preview.wheelEvent(turn))
    assert covered(near).mean() > 1.2 * covered(first).mean()


def drag(qtbot, widget, way, button=Qt.MouseButton.LeftButton):
    start = QPoint(100, 150)
    qtbot.mousePress(widget, button, pos=start)
    qtbot.mouseMove(widget, start + way)
    qtbot.mouseRelease(widget, button, pos=start + way)


def test_every_way_of_looking_is_another_picture_of_the_same_person(preview, qtbot, clone):
    preview.set_gaps(np.linspace(0.0, 15.0, len(clone.vertices_m)))
    shown = {mode: picture(preview, qtbot, lambda mode=mode: preview.set_mode(mode)) for mode in MODES}
    for mode, pixels in shown.items():
        assert 0.7 < covered(pixels).mean() / covered(shown["textured"]).mean() < 1.1, mode
        assert all(np.abs(pixels - other).mean() > 2.0 for key, other in shown.items() if key != mode), mode
    shaded = shown["shaded"][covered(shown["shaded"])]
    assert np.ptp(shaded, axis=1).mean() < 12, "shape alone has no colour"
    with pytest.raises(ValueError, match="wire"):
        preview.set_mode("x-ray")


def test_distances_are_painted_from_blue_to_red_and_unknown_ones_grey(preview, qtbot, clone):
    preview.set_mode("gaps")
    colours = {}
    for name, value in (("none", 0.0), ("far", 30.0), ("unknown", np.nan)):
        gaps = np.full(len(clone.vertices_m), value)
        pixels = picture(preview, qtbot, lambda gaps=gaps: preview.set_gaps(gaps))
        colours[name] = np.median(pixels[covered(pixels)], axis=0)
    assert colours["none"][2] > 1.5 * colours["none"][0]
    assert colours["far"][0] > 2.0 * colours["far"][2]
    assert np.ptp(colours["unknown"]) < 10


def test_the_clone_lies_over_the_photo_through_the_photo_s_camera(preview, qtbot, clone):
    photo = np.full((900, 600, 3), (30, 160, 60), np.uint8)
    camera = clone.views[FRONT].camera
    preview.resize(300, 450)
    preview.set_opacity(1.0)
    pixels = picture(preview, qtbot, lambda: preview.set_overlay(FRONT, photo))
    assert pixels.shape[:2] == (450, 300)
    person = np.abs(pixels - (30, 160, 60)).sum(axis=2) > 60
    wanted = camera.project(clone.vertices_m) / 2.0
    rows, columns = np.nonzero(person)
    assert rows.min() == pytest.approx(wanted[:, 1].min(), abs=4.0)
    assert columns.max() == pytest.approx(wanted[:, 0].max(), abs=4.0)
    faint = picture(preview, qtbot, lambda: preview.set_opacity(0.25))
    inside = person & (np.abs(pixels - (30, 160, 60)).sum(axis=2) > 120)
    share = np.abs(faint - (30, 160, 60))[inside].sum() / np.abs(pixels - (30, 160, 60))[inside].sum()
    assert share == pytest.approx(0.25, abs=0.03)


@pytest.mark.parametrize("kind", MOTIONS[1:])
def test_every_motion_moves_what_it_should(clone, kind):
    motion = find_motion(kind, clone)
    still = display_meshes(clone, None, "shaded", None)[0].vertices_m
    moved = np.zeros(len(still))
    for seconds in np.linspace(0.0, 3.0, 16):
        person, rotations, _ = pose_at(clone, motion, seconds)
        faced = np.linalg.norm(person.vertices_m - clone.vertices_m, axis=1)
        moved = np.maximum(
            moved, np.linalg.norm(display_meshes(person, rotations, "shaded", None)[0].vertices_m - still, axis=1)
        )
    if kind == "walk":
        assert moved.max() > 0.2, "arms and legs swing"
    assert moved.max() > 0.002, kind
    assert faced.max() < 0.05, "faces do not fly apart"


def test_a_motion_plays_by_itself_and_stops(preview, qtbot):
    first = picture(preview, qtbot, lambda: preview.play("walk"))
    qtbot.waitUntil(lambda: np.abs(picture(preview, qtbot) - first).mean() > 1.0)
    preview.play("stand")
    qtbot.waitUntil(lambda: not preview._film.isActive())


def test_an_updated_clone_is_seen_from_where_the_last_one_was(preview, qtbot, clone):
    preview.turn(0.9, 0.2)
    before = picture(preview, qtbot)
    assert np.abs(picture(preview, qtbot, lambda: preview.update_clone(clone)) - before).mean() < 1.0


def test_the_panel_s_controls_reach_the_preview_and_have_names(qtbot, clone):
    panel = PreviewPanel()
    qtbot.addWidget(panel)
    panel.resize(500, 400)
    panel.show()
    assert not panel.mode.isEnabled(), "nobody is there yet"
    panel.set_clone(clone, {FRONT: Photo(FRONT, np.zeros((900, 600, 3), np.uint8), None, "front", "")})
    with qtbot.waitSignal(panel.gaps_wanted):
        panel.mode.setCurrentIndex(MODES.index("gaps"))
    assert panel.scale.isVisible()
    assert panel.preview.mode == "gaps"
    panel.motion.setCurrentIndex(MOTIONS.index("smile"))
    assert panel.preview.motion_kind == "smile"
    assert not panel.opacity.isEnabled()
    panel.overlay.setCurrentIndex(1)
    assert panel.opacity.isEnabled()
    controls = (panel.mode, panel.motion, panel.overlay, panel.opacity)
    assert all(control.accessibleName() for control in controls)


def test_nobody_to_show_is_said_in_words(qtbot):
    preview = Preview()
    qtbot.addWidget(preview)
    assert "Press Clone" in preview.text()


def test_a_body_that_is_being_cloned_grows_from_shape_to_shape(qtbot, clone):
    growth, seen = Growth(), []
    growth.shown.connect(lambda body: seen.append(body.vertices_m))
    small, tall = (Shape(step, np.float32(share * clone.vertices_m)) for step, share in (("fine", 0.9), ("join", 1.0)))
    growth.take(small)
    assert np.allclose(seen[-1], small.vertices_m), "the first one stands there at once"
    growth.take(tall)
    qtbot.waitUntil(lambda: np.allclose(seen[-1], tall.vertices_m))
    heights = [np.ptp(one[:, 1]) for one in seen[1:]]
    assert len(heights) > 3, "it moves"
    assert heights == sorted(heights)
    growth.forget()
    count = len(seen)
    qtbot.wait(200)
    assert len(seen) == count
    assert not growth.active


def test_the_panel_shows_an_unfinished_body_without_its_controls(qtbot, clone):
    panel = PreviewPanel()
    qtbot.addWidget(panel)
    panel.resize(400, 500)
    panel.show()
    with qtbot.waitSignal(panel.preview.drawn):
        panel.show_growing(plain_clone(clone.vertices_m))
    assert not panel.motion.isEnabled()
    with qtbot.waitSignal(panel.preview.drawn):
        panel.set_clone(clone, {})
    assert panel.motion.isEnabled()
    assert panel.preview.mode == "textured", "the finished person has colours again"


def test_a_picture_that_is_still_drawn_is_never_shown_of_the_next_person(preview, qtbot, clone):
    shown = []
    preview.drawn.connect(lambda: shown.append(preview.shown.clone))
    preview._draw(fine=False)
    other = plain_clone(clone.vertices_m)
    preview.set_clone(other)
    preview._draw(fine=False)
    qtbot.waitUntil(lambda: shared_latest().idle and not preview._soon.isActive())
    assert shown
    assert all(one is other for one in shown)
    preview._draw(fine=False)
    preview.set_clone(None)
    qtbot.waitUntil(lambda: shared_latest().idle)
    assert "Press Clone" in preview.text()


def test_what_an_empty_place_says_changes_with_the_language(window, qtbot):
    window.go(CLONE)
    assert "Press Clone" in window.clone.preview.text()
    set_language("de")
    QApplication.processEvents()
    assert "Klonen drücken" in window.clone.preview.text()
    set_language("en")
