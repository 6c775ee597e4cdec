"""Hands on a photo: keys, magnifier, pieces of outline, fingers; on the real page with real events."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QPointingDevice
from PySide6.QtTest import QTest

from cloner.frames import BODY_VIEWS, ViewId
from cloner.interactive.relinking import LiveOutline
from cloner.records.photos import Photo, PhotoSet
from cloner.vision.contours.outlines import extract_outline
from cloner.vision.contours.stretches import prepare_linking
from kit.drawn import AXES, CENTRE, photograph, rough_mask

from .test_points_page import VIEW, canvas, drag, place_of  # noqa: F401 - the fixture is used by name

pytestmark = pytest.mark.gui


@pytest.fixture
def drawn(window, qtbot):
    """The page on three drawn figures whose outlines are ready."""
    rgb, mask = photograph(), rough_mask()
    session = window.session
    session.photos = PhotoSet({view: Photo(view, rgb, None, view.value, "") for view in BODY_VIEWS})
    session.opened.emit()
    window.show_page(window.points)
    qtbot.waitUntil(lambda: session.points(VIEW) is not None and not session.busy)
    qtbot.waitUntil(lambda: not window.points.live.busy)
    ready = prepare_linking(rgb, mask)
    outline = LiveOutline(ready, (extract_outline(rgb, mask).loops[0].polygon,))
    window.points.live.take({VIEW: outline})
    page = window.points.views[VIEW]
    qtbot.waitUntil(lambda: len(page.outline_px) == 1)
    return page


def outline_gap(page, at_px):
    return float(np.linalg.norm(np.concatenate(page.outline_px) - at_px, axis=1).min())


def test_tab_goes_to_the_least_sure_point_and_on_to_the_next_photo(window, canvas, qtbot):  # noqa: F811
    canvas.setFocus()
    qtbot.keyClick(canvas, Qt.Key.Key_Tab)
    first = window.points.view
    assert window.points.views[first].chosen == "shoulder_end_left", "the least sure of the three"
    qtbot.keyClick(window.points.views[first], Qt.Key.Key_Tab)
    second = window.points.view
    assert second is not first
    assert window.points.views[second].chosen == "shoulder_end_left"
    qtbot.keyClick(window.points.views[second], Qt.Key.Key_Backtab)
    assert window.points.view is first
    assert window.points.strip.photos[first].isChecked()


def test_keys_alone_correct_reset_zoom_and_choose_photos(window, canvas, qtbot):  # noqa: F811
    canvas.choose("nose_tip")
    qtbot.keyClick(canvas, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    qtbot.keyClick(canvas, Qt.Key.Key_Down)
    assert place_of(window, "nose_tip") == (590.0, 301.0)
    qtbot.keyClick(canvas, Qt.Key.Key_Delete)
    assert place_of(window, "nose_tip") == (600.0, 300.0)
    scale = canvas.lens.scale
    qtbot.keyClick(canvas, Qt.Key.Key_Plus)
    assert canvas.lens.scale == pytest.approx(1.25 * scale)
    qtbot.keyClick(canvas, Qt.Key.Key_Home)
    assert canvas.lens.scale == pytest.approx(scale)
    back = window.points.strip.photos[ViewId.BODY_BACK]
    qtbot.keyClick(back, Qt.Key.Key_Space)
    assert window.points.view is ViewId.BODY_BACK
    assert "doubtful" in back.accessibleName()


def test_the_magnifier_shows_the_pixels_under_the_point_while_it_is_dragged(window, canvas, qtbot):  # noqa: F811
    start = canvas.lens.widget_from_photo(600, 300).toPoint()
    before = canvas.grab().toImage()
    qtbot.mousePress(canvas, Qt.MouseButton.LeftButton, pos=start)
    qtbot.mouseMove(canvas, start + QPoint(3, 0))
    during = canvas.grab().toImage()
    side = 40 if start.x() > canvas.width() / 2 else canvas.width() - 40
    assert during.pixelColor(side, 60) != before.pixelColor(side, 60), "a close-up in the corner away from the hand"
    qtbot.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=start + QPoint(3, 0))
    after = canvas.grab().toImage()
    assert after.pixelColor(side, 60) == before.pixelColor(side, 60)


def test_the_outline_follows_a_dragged_point_by_linking(window, drawn, qtbot):
    target = CENTRE + (AXES + 15.0) * np.array([1.0, 0.0])
    start = CENTRE + AXES * np.array([1.0, 0.0])
    window.session.place_point(VIEW, "waist_left", *start)
    qtbot.waitUntil(lambda: outline_gap(drawn, start) < 0.2)
    drawn.lens.look_at(*start, 2.0)
    drag(qtbot, drawn, tuple(start), tuple(target - 5.0), tuple(target))
    place = place_of(window, "waist_left")
    qtbot.waitUntil(lambda: outline_gap(drawn, place) < 0.2)
    assert outline_gap(drawn, CENTRE - AXES * np.array([1.0, 0.0])) < 1.5, "the other side stays"
    window.undo_action.trigger()
    qtbot.waitUntil(lambda: outline_gap(drawn, start) < 0.2 and outline_gap(drawn, place) > 5.0)


def test_a_piece_of_outline_is_pulled_and_its_point_removed_again(window, drawn, qtbot):
    start = CENTRE + AXES * np.array([-1.0, 0.0])
    drawn.lens.look_at(*start, 2.0)
    drag(qtbot, drawn, tuple(start), tuple(start - [6.0, 0.0]), tuple(start - [12.0, 0.0]))
    assert window.session.undo_stack.count() == 1, "one pull is one step"
    place = place_of(window, "outline_1")
    assert place == pytest.approx(start - [12.0, 0.0], abs=2.5)
    qtbot.waitUntil(lambda: outline_gap(drawn, place) < 0.2)
    assert drawn.anchor_name == "outline_2", "the next pull makes another point"
    qtbot.keyClick(drawn, Qt.Key.Key_Delete)
    assert "outline_1" not in window.session.corrections.points.get(VIEW, {})
    qtbot.waitUntil(lambda: outline_gap(drawn, place) > 5.0)
    qtbot.keyClick(drawn, Qt.Key.Key_Insert)
    assert "outline_1" in window.session.corrections.points[VIEW], "a point on the outline by keys alone"


def test_a_finger_drags_a_point_it_only_nearly_hits_and_two_fingers_zoom(window, canvas, qtbot):  # noqa: F811
    device = QTest.createTouchDevice(QPointingDevice.DeviceType.TouchScreen)
    at = canvas.lens.widget_from_photo(600, 300).toPoint() + QPoint(18, 0)
    QTest.touchEvent(canvas, device).press(0, at, canvas).commit()
    QTest.touchEvent(canvas, device).move(0, at + QPoint(30, 0), canvas).commit()
    QTest.touchEvent(canvas, device).release(0, at + QPoint(30, 0), canvas).commit()
    moved = place_of(window, "nose_tip")
    assert moved == pytest.approx((600.0 + 30.0 / canvas.lens.scale, 300.0), abs=1.5 / canvas.lens.scale)
    scale, left, right = canvas.lens.scale, QPoint(100, 100), QPoint(160, 100)
    QTest.touchEvent(canvas, device).press(0, left, canvas).press(1, right, canvas).commit()
    QTest.touchEvent(canvas, device).move(0, left - QPoint(30, 0), canvas).move(
        1, right + QPoint(30, 0), canvas
    ).commit()
    QTest.touchEvent(canvas, device).release(0, left, canvas).release(1, right, canvas).commit()
    assert canvas.lens.scale == pytest.approx(2.0 * scale, rel=0.05)
    assert place_of(window, "nose_tip") == moved, "pinching drags nothing"
