"""What a day at a booth must not lose or shame: who leaves without a clone, photos not yet judged, damaged files."""

import json
import threading

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication, QMessageBox

from cloner.booth.events.event import open_event, read_event
from cloner.booth.photos import arrivals
from cloner.booth.photos.photo_files import new_photos
from cloner.booth.photos.photo_problems import PhotoProblem
from cloner.booth.visitors.person_file import person_facts
from cloner.booth.visitors.visits import State, read_visit
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project.folder import read_corrections, view_files
from cloner.project.results import file_digest
from cloner_gui.event.session import Session
from cloner_gui.main_window import CLONE, PHOTOS, POINTS, VISITOR, MainWindow
from kit.stand_ins import drop

from .test_flow import begin, event, settled  # noqa: F401  (event is a fixture)

pytestmark = pytest.mark.gui
LEFT = Qt.MouseButton.LeftButton
FRONT, SIDE, BACK = ViewId.BODY_FRONT, ViewId.BODY_SIDE, ViewId.BODY_BACK


def photographed(window, qtbot, samples, *views):
    """Take a new visitor who agrees, with photos named as their views, and show the photos."""
    folder = begin(window, qtbot)
    window.go(PHOTOS)
    drop(window.photos, *(samples / "anna" / "plain" / f"{view}.jpg" for view in views))
    settled(window, qtbot)
    return folder


def new_by_mouse(window, qtbot):
    with qtbot.waitSignal(window.booth.page_wanted):
        qtbot.mouseClick(window.visitor.new_button, LEFT)


# --- 1: nobody goes away without a clone ------------------------------------------


def test_clone_is_pressed_while_points_are_still_sought(event, jobs, qtbot, samples):  # noqa: F811
    folder = photographed(event, qtbot, samples, FRONT)
    hold = threading.Event()
    jobs.hold_points = hold
    event.session.propose()
    assert event.session.seeking
    assert event.next.isEnabled()
    qtbot.mouseClick(event.next, LEFT)
    assert read_visit(folder).state is State.WAITING
    assert event.stack.currentIndex() == CLONE
    hold.set()
    qtbot.waitUntil(lambda: read_visit(folder).state is State.CLONED)


def test_who_is_left_without_a_clone_is_put_into_the_queue_and_it_is_said(event, jobs, qtbot, samples):  # noqa: F811
    jobs.wait_for_cancel = True  # a clone that is ready at once is said in its place
    folder = photographed(event, qtbot, samples, FRONT)
    event.go(VISITOR)
    new_by_mouse(event, qtbot)
    assert event.session.folder != folder
    assert "Visitor 1 waits for the clone" in event.notice.text.text()
    jobs.wait_for_cancel = False
    qtbot.waitUntil(lambda: read_visit(folder).state is State.CLONED)


def test_who_was_taken_out_of_the_queue_stays_out(event, jobs, qtbot, samples):  # noqa: F811
    jobs.wait_for_cancel = True
    folder = photographed(event, qtbot, samples, FRONT)
    event.session.clone()
    assert jobs.started.wait(60)
    event.go(CLONE)
    qtbot.mouseClick(event.clone.cancel_button, LEFT)
    qtbot.waitUntil(lambda: not event.session.cloning)
    event.go(VISITOR)
    new_by_mouse(event, qtbot)
    assert read_visit(folder).state is State.NONE


# --- 2: a verdict belongs to the photo ----------------------------------------------


def test_exchanged_photos_do_not_stay_good(event, jobs, qtbot, samples):  # noqa: F811
    photographed(event, qtbot, samples, FRONT, SIDE)
    cards = event.photos.cards
    assert [cards[view].verdict.text() for view in (FRONT, SIDE)] == ["✓ Good", "✓ Good"]
    event.photos._exchange(FRONT, SIDE)
    settled(event, qtbot)
    assert all("does not show this view" in cards[view].verdict.text() for view in (FRONT, SIDE))
    event.photos._exchange(FRONT, BACK)
    settled(event, qtbot)
    event.photos._exchange(BACK, FRONT)
    settled(event, qtbot)
    event.photos._exchange(FRONT, SIDE)
    settled(event, qtbot)
    assert [cards[view].verdict.text() for view in (FRONT, SIDE)] == ["✓ Good", "✓ Good"]


def test_a_turned_photo_is_looked_at_anew(event, jobs, qtbot, samples):  # noqa: F811
    folder = photographed(event, qtbot, samples, SIDE)
    before = file_digest(view_files(folder)[SIDE])
    jobs.default = (None, (PhotoProblem.LYING,))
    event.photos.cards[SIDE].turn_wanted.emit(SIDE)
    settled(event, qtbot)
    assert file_digest(view_files(folder)[SIDE]) != before
    assert "lies on the side" in event.photos.cards[SIDE].verdict.text()


# --- 3: one new visitor at a time ------------------------------------------------------


def test_typing_after_new_visitor_is_the_name_and_three_clicks_make_one(event, qtbot):  # noqa: F811
    event.activateWindow()
    new_by_mouse(event, qtbot)
    qtbot.waitUntil(lambda: QApplication.focusWidget() is event.visitor.form.name_field)
    for _ in range(2):
        qtbot.mouseClick(event.visitor.new_button, LEFT)
        qtbot.wait(50)
    event.booth.new_visitor()
    event.booth.new_visitor()
    settled(event, qtbot)
    assert [path.name for path in sorted(event.booth.root.glob("visitor-*"))] == ["visitor-001"]
    qtbot.keyClicks(event.visitor.form.name_field, "Anna")
    new_by_mouse(event, qtbot)
    assert sorted(event.booth.visits()) == [event.booth.root / "visitor-001", event.booth.root / "visitor-002"]
    assert person_facts(event.booth.root / "visitor-001")[0] == "Anna"


def test_two_new_visitors_in_one_moment_leave_no_unlisted_folder(event, qtbot):  # noqa: F811
    event.booth.new_visitor()
    event.booth.new_visitor()
    settled(event, qtbot)
    assert len(list(event.booth.root.glob("visitor-*"))) == event.visitor.list.count() == 1


def test_the_list_has_a_menu_and_delete_asks_by_name(event, qtbot):  # noqa: F811
    begin(event, qtbot)
    event.booth.save_person("Anna Long", None)
    item = event.visitor.list.item(0)
    assert "Anna Long (1)" in item.text()
    menu = event.visitor.menu_of(item)
    assert [one.text().replace("&", "") for one in menu.actions()] == ["Open", "Save everything held…", "Delete…"]
    qtbot.keyClick(event.visitor.list, Qt.Key.Key_Delete)
    (box,) = [one for one in event.findChildren(QMessageBox) if one.isVisible()]
    assert "Anna Long (1)" in box.text()
    assert "visitor-001" not in box.text()
    box.reject()


# --- 4, 5, 6: stale clones, the code, no bare body ---------------------------------------


def test_a_correction_after_the_clone_is_said_on_both_pages(window, jobs, qtbot):
    with qtbot.waitSignal(window.session.cloned):
        window.session.clone()
    qtbot.waitUntil(lambda: not window.session.busy)
    window.go(CLONE)
    assert not window.clone.stale.isVisible()
    window.session.propose()
    qtbot.waitUntil(lambda: bool(window.session.proposed) and not window.session.busy)
    window.session.place_point(FRONT, "nose_tip", 610.0, 300.0)
    assert window.clone.stale.isVisible()
    assert window.clone.clone_button.text().replace("&", "") == "Clone again"
    window.show_page(window.takeaway)
    assert "clone before" in window.takeaway.stale.text()
    assert window.takeaway.stale.isVisible()
    window.undo_action.trigger()
    assert not window.takeaway.stale.isVisible(), "taken back: the clone is of these points again"


def test_the_code_never_holds_a_path_of_this_computer(window, jobs, qtbot, tmp_path):
    with qtbot.waitSignal(window.session.cloned):
        window.session.clone()
    window.show_page(window.takeaway)
    window.takeaway.handing.target = tmp_path / "stick"
    window.takeaway._show()
    assert window.takeaway.code.isHidden()
    assert "file:" not in window.takeaway.code_note.text()


# --- 8, 9, 10, 12 -------------------------------------------------------------------------


def test_cancelling_the_question_for_the_cameras_folder_keeps_it(event, qtbot, tmp_path, monkeypatch):  # noqa: F811
    begin(event, qtbot)
    event.go(PHOTOS)
    (tmp_path / "camera").mkdir()
    event.booth.change(camera_folder=str(tmp_path / "camera"))
    monkeypatch.setattr("cloner_gui.pages.photos.QFileDialog.getExistingDirectory", lambda *_: "")
    qtbot.mouseClick(event.photos.watch_button, LEFT)
    assert event.booth.settings.camera_folder == str(tmp_path / "camera")
    qtbot.mouseClick(event.photos.unwatch_button, LEFT)
    assert event.booth.settings.camera_folder == ""


def test_all_dropped_photos_are_stored_before_the_first_is_judged(event, jobs, qtbot, samples, tmp_path):  # noqa: F811
    folder = begin(event, qtbot)
    jobs.hold_checks = threading.Event()
    drop(event.photos, *(samples / "anna" / "plain" / f"{view}.jpg" for view in ViewId))
    try:
        qtbot.waitUntil(lambda: len(new_photos(folder)) == 5)
    finally:
        jobs.hold_checks.set()
    settled(event, qtbot)
    assert set(view_files(folder)) == set(ViewId)
    assert new_photos(folder) == ()


def test_photos_stored_and_not_judged_before_a_crash_find_their_places_afterwards(
    event,  # noqa: F811
    jobs,
    qtbot,
    samples,
):
    folder = begin(event, qtbot)
    for number, view in enumerate((FRONT, SIDE), start=1):
        (folder / "unsorted").mkdir(exist_ok=True)
        data = (samples / "anna" / "plain" / f"{view}.jpg").read_bytes()
        (folder / "unsorted" / f"photo_{number:03d}.{view}.jpg").write_bytes(data)  # as a killed window leaves them
    again = MainWindow(Session(jobs.services()))
    qtbot.addWidget(again)
    again.booth.open(event.booth.root)
    qtbot.waitUntil(lambda: set(again.session.photos.photos) == {FRONT, SIDE})
    settled(again, qtbot)
    again.booth.close()


def test_two_files_on_one_card_find_their_own_places(event, jobs, qtbot, samples):  # noqa: F811
    folder = begin(event, qtbot)
    event.go(PHOTOS)
    drop(event.photos.cards[FRONT], *(samples / "anna" / "plain" / f"{view}.jpg" for view in (SIDE, BACK)))
    settled(event, qtbot)
    assert set(view_files(folder)) == {SIDE, BACK}


def test_a_cameras_photos_of_the_moment_of_a_crash_are_still_taken(tmp_path):
    camera = tmp_path / "camera"
    camera.mkdir()
    (camera / "a.jpg").write_bytes(b"1")
    arrivals.write_note(tmp_path, camera, arrivals.photo_sizes(camera))
    (camera / "b.jpg").write_bytes(b"22")
    known = arrivals.read_note(tmp_path, camera)
    now = arrivals.photo_sizes(camera)
    assert arrivals.complete_photos(known, now, now) == (camera / "b.jpg",)
    assert arrivals.read_note(tmp_path, tmp_path / "other") is None
    arrivals.drop_note(tmp_path)
    assert arrivals.read_note(tmp_path, camera) is None


def test_damaged_settings_are_put_right_kept_and_said(event, qtbot):  # noqa: F811
    root = event.booth.root
    text = '{"format": 2, "retention_days": 7, "language": "de", "big": tr'
    (root / "event.json").write_text(text)
    event.booth.open(root)
    assert event.booth.root == root
    assert (event.booth.settings.retention_days, event.booth.settings.language) == (7, "de")
    assert (root / "event.json.damaged").read_text() == text
    assert "event.json" not in event.notice.text.text()
    assert event.notice.isVisible()
    event.booth.change(language="en")


def test_settings_of_a_newer_version_are_left_alone(tmp_path):
    (tmp_path / "event.json").write_text('{"format": 9, "retention_days": 7}')
    with pytest.raises(ClonerError, match="newer version"):
        open_event(tmp_path)
    assert json.loads((tmp_path / "event.json").read_text())["format"] == 9


def test_settings_of_the_first_format_keep_their_consent(tmp_path):
    (tmp_path / "event.json").write_text('{"format": 1, "language": "tr", "consent": "Evet."}')
    assert read_event(tmp_path).consents == {"tr": "Evet."}


def test_a_damaged_file_of_points_costs_the_torn_point_alone(event, qtbot, samples):  # noqa: F811
    folder = photographed(event, qtbot, samples, FRONT)
    good = '"nose_tip": {"x": 5.0, "y": 6.0, "photo_sha256": ""}'
    torn = f'{{"format": 1, "views": {{"body_front": {{{good}, "toe_left": {{"x": 1.0, "y"'
    (folder / "corrections.json").write_text(torn)
    (folder / "person.toml").write_text('name = "Anna"\nconsent = "yes (2026-11-21 12:00 UTC, en)"\nheight_cm = 16x\n')
    event.session.open(folder)
    assert set(read_corrections(folder).points[FRONT]) == {"nose_tip"}
    assert person_facts(folder) == ("Anna", None, "yes (2026-11-21 12:00 UTC, en)")
    assert (folder / "corrections.json.damaged").read_text() == torn
    assert "corrected points" in event.photos.missing_label.text()


def test_a_read_only_folder_is_told_at_opening(event, tmp_path, monkeypatch):  # noqa: F811
    fixed = tmp_path / "fixed"
    fixed.mkdir()

    def refuse(dir):  # noqa: A002  (nothing is read-only for root)
        raise PermissionError(dir)

    monkeypatch.setattr("cloner.booth.events.event.tempfile.TemporaryFile", refuse)
    event.booth.open(fixed)
    assert event.booth.root != fixed
    assert "nothing can be written" in event.notice.text.text()


def test_messages_move_nothing_are_all_read_and_go_with_the_visitor(event, qtbot):  # noqa: F811
    begin(event, qtbot)
    event.go(PHOTOS)
    QApplication.processEvents()
    before = event.photos.add_button.mapTo(event, QPoint())
    event.booth.failed.emit(ClonerError("the photo is dark", "Retake it", "visitor-001"))
    event.booth.failed.emit(ClonerError("the photo is burnt", "Retake it", "body_front.jpg"))
    QApplication.processEvents()
    assert event.photos.add_button.mapTo(event, QPoint()) == before
    assert event.notice.text.text() == "Body, front: the photo is burnt. Retake it."
    qtbot.mouseClick(event.notice.close_button, LEFT)
    assert event.notice.text.text() == "Visitor 1: the photo is dark. Retake it."
    event.booth.new_visitor()
    assert not event.notice.isVisible()


# --- 14, 15, 16 ------------------------------------------------------------------------------


def test_the_first_tab_goes_to_the_worst_point_and_the_last_one_says_so(window, qtbot):
    window.activateWindow()
    window.go(POINTS)
    qtbot.waitUntil(lambda: bool(window.session.proposed) and not window.session.busy)
    canvas = window.points.views[window.points.view]
    qtbot.waitUntil(lambda: QApplication.focusWidget() is canvas)
    qtbot.keyClick(canvas, Qt.Key.Key_Tab)
    view, name = window.points._order[0]
    assert window.points.views[view].chosen == name
    for _ in window.points._order[1:]:
        window.points.next_point(1)
    assert "All doubtful points are seen" in window.points.status.text()


def test_a_doubtful_point_is_told_by_its_shape_too():
    from cloner_gui.canvas.photos.painting import point_shape

    assert [point_shape(0.1, False), point_shape(0.9, False), point_shape(0.1, True)] == ["triangle", "ring", "square"]


def test_the_consent_names_its_days_and_is_kept_as_it_was_read(event, qtbot):  # noqa: F811
    event.booth.change(retention_days=7, consents={"en": "We keep you\nfor {days} days."})
    begin(event, qtbot)
    assert event.booth.person()[2].startswith("We keep you\nfor 7 days. (2")
    event.booth.change(retention_days=3)
    assert event.visitor.form.consent_text.text() == "We keep you\nfor 7 days.", "what was agreed to, not what is asked"


def test_a_typed_height_is_known_and_return_goes_on(event, qtbot):  # noqa: F811
    folder = begin(event, qtbot)
    field = event.visitor.form.height_field
    assert field.height_cm() is None
    field.cm.setFocus()
    field.cm.selectAll()
    qtbot.keyClicks(field.cm, "181")
    field.cm.interpretText()
    assert field.height_cm() == 181.0
    qtbot.waitUntil(lambda: person_facts(folder)[1] == 181.0)
    qtbot.keyClick(event, Qt.Key.Key_Return)
    assert event.stack.currentIndex() == PHOTOS


def test_an_empty_card_shows_how_to_stand_at_every_size(event, qtbot):  # noqa: F811
    begin(event, qtbot)
    event.go(PHOTOS)
    for width in (1280, 1000):
        event.resize(width, 740)
        QApplication.processEvents()
        card = event.photos.cards[SIDE]
        qtbot.waitUntil(lambda card=card: card.picture.pixmap().height() > 100)
        assert card.verdict.text() == "Drop a photo here"


def test_a_double_click_shows_the_photo_at_its_full_size(window, qtbot):
    from cloner_gui.canvas.photos.whole_photo import WholePhoto

    qtbot.mouseDClick(window.photos.cards[FRONT], LEFT, pos=QPoint(60, 100))
    (whole,) = window.findChildren(WholePhoto)
    assert whole.view.lens.photo.toSize().toTuple() == (
        window.session.photos.photos[FRONT].width_px, window.session.photos.photos[FRONT].height_px,
    )  # fmt: skip
    whole.close()


def test_who_is_opened_and_who_is_next_is_said(event, jobs, qtbot, samples):  # noqa: F811
    jobs.wait_for_cancel = True
    photographed(event, qtbot, samples, FRONT)
    event.session.clone()
    assert jobs.started.wait(60)
    event.go(PHOTOS)
    assert event.queue_bar.isVisible()
    event.session.queue._tell(event.session.folder, "", 0.0)
    assert ": ," not in event.queue_bar.text.text()
    event.go(CLONE)
    assert not event.queue_bar.isVisible(), "one bar is enough"
    jobs.wait_for_cancel = False
