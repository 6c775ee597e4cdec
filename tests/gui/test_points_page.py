"""An operator drags points with a real mouse; values tell what happened."""

import json

import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QMenu

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner_gui.canvas.photos.painting import CORRECTED, point_colour
from cloner_gui.canvas.photos.picking import nearest_point
from kit.stand_ins import NAMES, PLACES

pytestmark = pytest.mark.gui
VIEW = ViewId.BODY_FRONT


@pytest.fixture
def canvas(window, qtbot):
    with qtbot.waitSignal(window.session.points_changed):
        qtbot.mouseClick(window.aside, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not window.session.busy)
    return window.points.views[VIEW]


def drag(qtbot, canvas, start_px, *way_px):
    """Press at one photo pixel, move over others, let go at the last."""
    places = [canvas.lens.widget_from_photo(*px).toPoint() for px in (start_px, *way_px)]
    qtbot.mousePress(canvas, Qt.MouseButton.LeftButton, pos=places[0])
    for place in places[1:]:
        qtbot.mouseMove(canvas, place)
    qtbot.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=places[-1])


def place_of(window, name, view=VIEW):
    return tuple(window.session.points(view).get(name))


def test_dragging_corrects_undo_returns_and_redo_repeats(window, canvas, qtbot, folder):
    before = place_of(window, "shoulder_end_left")
    assert before == (700.0, 700.0)
    drag(qtbot, canvas, before, (720, 690), (760, 650), (800, 600))
    moved = place_of(window, "shoulder_end_left")
    pixel = 1.0 / canvas.lens.scale  # the mouse moves in whole widget pixels
    assert moved == pytest.approx((800, 600), abs=1.5 * pixel)
    assert window.session.points(VIEW).corrected.tolist() == [False, False, True]
    assert place_of(window, "nose_tip") == (600.0, 300.0)
    assert window.session.undo_stack.count() == 1, "one drag is one step"
    window.undo_action.trigger()
    assert place_of(window, "shoulder_end_left") == before
    assert not window.session.points(VIEW).corrected.any()
    window.redo_action.trigger()
    assert place_of(window, "shoulder_end_left") == moved
    saved = json.loads((folder / "corrections.json").read_text())["views"]["body_front"]
    assert saved["shoulder_end_left"]["x"] == moved[0]


def test_undo_is_saved_too(window, canvas, qtbot, folder):
    drag(qtbot, canvas, (600, 300), (640, 320))
    assert "nose_tip" in (folder / "corrections.json").read_text()
    window.undo_action.trigger()
    assert "nose_tip" not in (folder / "corrections.json").read_text()


def test_two_drags_are_two_steps(window, canvas, qtbot):
    drag(qtbot, canvas, (600, 300), (620, 300))
    drag(qtbot, canvas, place_of(window, "nose_tip"), (700, 300))
    assert window.session.undo_stack.count() == 2
    window.undo_action.trigger()
    assert place_of(window, "nose_tip")[0] == pytest.approx(620, abs=4)
    window.undo_action.trigger()
    assert place_of(window, "nose_tip") == (600.0, 300.0)


def test_any_run_of_edits_undone_gives_the_first_value(window, canvas, qtbot):
    first = window.session.corrections
    for step, name in enumerate([*NAMES, *NAMES]):
        window.session.place_point(VIEW, name, 100 + 10 * step, 200)
    window.session.reset_point(VIEW, "nose_tip")
    while window.session.undo_stack.canUndo():
        window.undo_action.trigger()
    assert window.session.corrections.points == first.points


def test_a_point_stays_on_the_photo(window, canvas, qtbot):
    photo = window.session.photos.photos[VIEW]
    window.session.place_point(VIEW, "nose_tip", 5000.0, -300.0)
    assert place_of(window, "nose_tip") == (photo.width_px - 1.0, 0.0)


def test_dragging_beside_points_pans_and_changes_no_point(window, canvas, qtbot):
    canvas.zoom(3.0, QPointF(100, 100))
    before = canvas.lens.widget_from_photo(0, 0)
    empty = canvas.lens.photo_from_widget(QPointF(40, 40))
    there = canvas.lens.photo_from_widget(QPointF(70, 60))
    drag(qtbot, canvas, empty, there)
    after = canvas.lens.widget_from_photo(0, 0)
    assert (after - before).toPoint().toTuple() == (30, 20)
    assert window.session.undo_stack.count() == 0


def test_the_wheel_zooms_about_the_mouse(canvas):
    at = QPointF(200.0, 150.0)
    before, scale = canvas.lens.photo_from_widget(at), canvas.lens.scale
    turn = QWheelEvent(
        at, at, QPointF().toPoint(), QPointF(0, 120).toPoint(), Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    canvas.wheelEvent(turn)
    assert canvas.lens.scale == pytest.approx(1.25 * scale)
    assert canvas.lens.photo_from_widget(at) == pytest.approx(before)


def test_a_pixel_is_seen_at_its_middle(canvas):
    corner, next_pixel = canvas.lens.widget_from_photo(-0.5, -0.5), canvas.lens.widget_from_photo(0.5, 0.5)
    middle = canvas.lens.widget_from_photo(0.0, 0.0)
    assert (corner + next_pixel) / 2 == middle
    assert canvas.lens.photo_from_widget(middle) == pytest.approx((0.0, 0.0))
    assert corner == canvas.lens.offset, "Qt draws the photo from the corner of its first pixel"


def test_arrow_keys_move_the_chosen_point_by_a_pixel(window, canvas, qtbot):
    qtbot.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=canvas.lens.widget_from_photo(600, 300).toPoint())
    qtbot.keyClick(canvas, Qt.Key.Key_Right)
    qtbot.keyClick(canvas, Qt.Key.Key_Up, Qt.KeyboardModifier.ShiftModifier)
    assert place_of(window, "nose_tip") == (601.0, 290.0)


def test_hovering_names_the_point_in_words(window, canvas, qtbot):
    qtbot.mouseMove(canvas, canvas.lens.widget_from_photo(650, 400).toPoint())
    assert "inner corner of the eye, left" in window.points.hint.text()
    assert "50 % sure" in window.points.hint.text()
    assert "Corner of the eye towards the nose" in window.points.hint.text()


def test_right_click_takes_a_correction_back(window, canvas, qtbot):
    drag(qtbot, canvas, (600, 300), (640, 320))
    canvas.point_reset.emit("nose_tip")
    assert place_of(window, "nose_tip") == tuple(PLACES[0])
    assert window.session.undo_stack.count() == 2
    window.undo_action.trigger()
    assert place_of(window, "nose_tip") == pytest.approx((640, 320), abs=3)


def test_the_menu_offers_the_proposal_only_on_a_point(window, canvas, qtbot):
    from PySide6.QtGui import QContextMenuEvent

    for px, wanted in (((600, 300), 1), ((20, 20), 0)):
        at = canvas.lens.widget_from_photo(*px).toPoint()
        canvas.contextMenuEvent(QContextMenuEvent(QContextMenuEvent.Reason.Mouse, at, canvas.mapToGlobal(at)))
        menus = [menu for menu in canvas.findChildren(QMenu) if menu.actions()]
        assert len(menus) == wanted, px
        for menu in menus:
            assert menu.actions()[0].text() == "Use the proposal for tip of the nose again"
            menu.close()
            menu.setParent(None)


def test_corrections_of_the_folder_are_shown(window, canvas, qtbot, folder):
    drag(qtbot, canvas, (600, 300), (640, 320))
    moved = place_of(window, "nose_tip")
    window.session.open(folder)
    assert window.session.undo_stack.count() == 0
    window.show_page(window.points)
    qtbot.waitUntil(lambda: window.session.points(VIEW) is not None and not window.session.busy)
    assert place_of(window, "nose_tip") == moved


def test_a_failed_proposal_says_why_and_can_be_tried_again(window, jobs, qtbot):
    jobs.error = ClonerError("no person found in this photo", "Take it again", "body_front.jpg")
    with qtbot.waitSignal(window.session.failed):
        window.show_page(window.points)
    qtbot.waitUntil(lambda: not window.session.busy)
    assert window.points.again.isVisible()
    jobs.error = None
    with qtbot.waitSignal(window.session.points_changed):
        qtbot.mouseClick(window.points.again, Qt.MouseButton.LeftButton)
    assert place_of(window, "nose_tip") == tuple(PLACES[0])
    qtbot.waitUntil(lambda: not window.session.busy)
    assert not window.points.again.isVisible()


def test_colours_tell_confidence_and_correction():
    assert point_colour(0.1, True) == CORRECTED
    sure, unsure = point_colour(0.9, False), point_colour(0.1, False)
    assert sure.green() > 2 * sure.red()
    assert unsure.red() > 2 * unsure.green()


def test_picking_takes_the_nearest_in_reach():
    assert nearest_point(PLACES, (655, 398), 12) == 1
    assert nearest_point(PLACES, (655, 398), 3) is None
    assert nearest_point(PLACES[:0], (0, 0), 12) is None
