"""The whole path with real widgets: visitor, photos, clone, take away, delete; and errors that are told quietly."""

import json
import subprocess
import sys

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt

from cloner.booth.photos.photo_problems import PhotoProblem
from cloner.booth.visitors.visits import State, read_visit
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project.folder import read_consent, read_person, view_files
from cloner.project.results import file_digest
from cloner_gui.event.session import Session
from cloner_gui.main_window import MainWindow
from kit.stand_ins import drop

pytestmark = pytest.mark.gui


def settled(window, qtbot):
    """Wait until no photo is on its way and nobody is being opened."""
    qtbot.waitUntil(lambda: window.booth.intake.pending() == 0 and window.booth._opening is None)


@pytest.fixture
def event(qtbot, jobs, tmp_path):
    """A window on a new, empty event."""
    root = tmp_path / "fair"
    root.mkdir()
    window = MainWindow(Session(jobs.services()))
    qtbot.addWidget(window)
    window.show()
    window.booth.open(root)
    yield window
    window.booth.close()


def begin(window, qtbot):
    """Take a new visitor who agrees."""
    with qtbot.waitSignal(window.booth.page_wanted):
        qtbot.mouseClick(window.visitor.new_button, Qt.MouseButton.LeftButton)
    box = window.visitor.form.consent_box
    left = box.width() - 10 if box.layoutDirection() is Qt.LayoutDirection.RightToLeft else 10
    qtbot.mouseClick(box, Qt.MouseButton.LeftButton, pos=QPointF(left, 10).toPoint())
    assert window.session.consent
    return window.session.folder


def test_the_first_page_shows_who_is_open_and_the_height(window):
    form = window.visitor.form
    assert form.name_field.text() == "Anna"
    assert form.height_field.height_cm() == 158.0
    assert window.photos.missing_label.text().startswith("All five photos are here.")
    assert "No consent is recorded" in window.photos.missing_label.text()
    assert all(card.picture.pixmap().height() > 60 for card in window.photos.cards.values())
    assert window.stack.currentWidget() is window.photos, "an opened folder with photos shows them"
    assert window.next.isEnabled()


def test_no_photo_is_stored_before_the_visitor_agrees(event, qtbot, samples):
    with qtbot.waitSignal(event.booth.page_wanted):
        qtbot.mouseClick(event.visitor.new_button, Qt.MouseButton.LeftButton)
    assert not event.next.isEnabled()
    assert "agree" in event.reason.text()
    drop(event.photos, samples / "anna" / "plain" / "body_front.jpg")
    settled(event, qtbot)
    assert list(event.session.folder.rglob("*.jpg")) == []
    assert "agreed" in event.notice.text.text()
    assert event.notice.isVisible()


def test_consent_keeps_its_text_its_time_and_its_language(event, qtbot):
    folder = begin(event, qtbot)
    told = read_consent(folder)
    assert "three-dimensional likeness" in told
    assert told.endswith("UTC, en)")
    qtbot.mouseClick(event.visitor.form.consent_box, Qt.MouseButton.LeftButton, pos=QPointF(10, 10).toPoint())
    assert read_consent(folder) == ""


def test_typing_is_saved_without_a_button(event, qtbot):
    folder = begin(event, qtbot)
    qtbot.keyClicks(event.visitor.form.name_field, "Guest 12")
    event.visitor.form.height_field.known.setChecked(True)
    event.visitor.form.height_field.unit.setCurrentIndex(1)
    event.visitor.form.height_field.feet.setValue(6)
    event.visitor.form.height_field.inches.setValue(8.5)
    qtbot.waitUntil(lambda: read_person(folder).stature_is_known)
    assert read_person(folder).name == "Guest 12"
    assert read_person(folder).stature_m == pytest.approx(2.045, abs=0.001)


def test_what_is_typed_never_goes_to_the_next_visitor(event, qtbot):
    first = begin(event, qtbot)
    event.visitor.form.name_field.setFocus()
    qtbot.keyClicks(event.visitor.form.name_field, "Guest 12")
    with qtbot.waitSignal(event.booth.page_wanted):
        event.booth.new_visitor()
    assert read_person(first).name == "Guest 12"
    assert event.session.folder != first
    assert event.visitor.form.name_field.text() == ""
    qtbot.wait(600)
    assert read_person(event.session.folder).name == ""


def test_dropped_photos_find_their_places_and_troubles_are_told(event, jobs, qtbot, samples):
    folder = begin(event, qtbot)
    source = samples / "anna" / "plain"
    for number, view in enumerate(ViewId):
        target = folder.parent.parent / f"DSC{number:04d}.jpg"
        target.write_bytes((source / f"{view}.jpg").read_bytes())

        jobs.checks[file_digest(target)] = (view, (PhotoProblem.BLURRED,) if view is ViewId.BODY_SIDE else ())
    drop(event.photos, *sorted(folder.parent.parent.glob("DSC*.jpg")))
    settled(event, qtbot)
    assert set(view_files(folder)) == set(ViewId)
    assert "blurred" in event.photos.cards[ViewId.BODY_SIDE].verdict.text()
    assert event.photos.cards[ViewId.BODY_FRONT].verdict.text() == "✓ Good"
    assert event.next.isEnabled()


def test_a_retaken_photo_replaces_and_the_old_one_is_in_the_tray(window, qtbot, jobs, folder, samples):
    window.booth.agree("yes", "en")
    before = window.session.photos.photos[ViewId.FACE_FRONT].digest
    drop(window.photos.cards[ViewId.FACE_FRONT], samples / "boris" / "plain" / "face_front.jpg")
    settled(window, qtbot)
    assert window.session.photos.photos[ViewId.FACE_FRONT].digest != before
    assert [photo.digest for photo in window.session.tray] == [before]
    window.photos._use(window.session.tray[0].path, ViewId.FACE_FRONT)
    settled(window, qtbot)
    assert window.session.photos.photos[ViewId.FACE_FRONT].digest == before


def test_photos_are_exchanged_turned_taken_out_and_deleted(window, qtbot, folder):
    digests = {view: photo.digest for view, photo in window.session.photos.photos.items()}
    window.photos._exchange(ViewId.BODY_FRONT, ViewId.BODY_BACK)
    settled(window, qtbot)
    now = window.session.photos.photos
    assert now[ViewId.BODY_FRONT].digest == digests[ViewId.BODY_BACK]
    assert now[ViewId.BODY_BACK].digest == digests[ViewId.BODY_FRONT]
    window.photos.cards[ViewId.FACE_SIDE].turn_wanted.emit(ViewId.FACE_SIDE)
    settled(window, qtbot)
    assert window.session.photos.photos[ViewId.FACE_SIDE].width_px == 1600, "a portrait photo lies on its side"
    window.photos.cards[ViewId.BODY_SIDE].tray_wanted.emit(ViewId.BODY_SIDE)
    window.photos.cards[ViewId.FACE_SIDE].remove_wanted.emit(ViewId.FACE_SIDE)
    settled(window, qtbot)
    assert set(view_files(folder)) == {ViewId.BODY_FRONT, ViewId.BODY_BACK, ViewId.FACE_FRONT}
    assert len(window.session.tray) == 1


def test_a_tethered_camera_fills_the_places(event, jobs, qtbot, samples, tmp_path):
    begin(event, qtbot)
    camera = tmp_path / "camera"
    camera.mkdir()
    (camera / "old.jpg").write_bytes((samples / "boris" / "plain" / "body_back.jpg").read_bytes())
    event.booth.change(camera_folder=str(camera))
    (camera / "body_front.jpg").write_bytes((samples / "anna" / "plain" / "body_front.jpg").read_bytes())
    qtbot.waitUntil(lambda: ViewId.BODY_FRONT in event.session.photos.photos)
    settled(event, qtbot)
    assert set(event.session.photos.photos) == {ViewId.BODY_FRONT}, "what lay there before belongs to somebody else"
    assert event.session.tray == ()


def test_an_unusable_folder_is_told_and_the_old_one_stays(window, tmp_path, folder):
    other = tmp_path / "other"
    other.mkdir()
    (other / "taxes.pdf").write_text("x")
    window.booth.open(other)
    assert window.notice.isVisible()
    assert "other things than visitors" in window.notice.text.text()
    assert window.session.folder == folder


def test_clone_shows_progress_and_the_result(window, jobs, qtbot, folder):
    window.show_page(window.clone)
    with qtbot.waitSignal(window.session.cloned):
        window.session.clone()
    qtbot.waitUntil(lambda: not window.session.busy)
    assert jobs.seen == [(folder, ("glb", "wrl"))]
    assert read_visit(folder).state is State.CLONED
    assert read_visit(folder).clone_seconds == 12.5
    assert window.next.isEnabled()
    assert not window.queue_bar.isVisible()


def asked(event, qtbot, samples, many):
    """Begin visitors with a photo each and ask for their clones; return their folders."""
    folders = []
    for _ in range(many):
        folders.append(begin(event, qtbot))
        drop(event.photos, samples / "anna" / "plain" / "body_front.jpg")
        settled(event, qtbot)
        event.session.clone()
    return folders


def test_one_visitor_is_cloned_while_the_next_is_photographed(event, jobs, qtbot, samples):
    jobs.wait_for_cancel = True
    folders = asked(event, qtbot, samples, 2)
    assert jobs.started.wait(60)
    assert event.session.queue.at_work == folders[0]
    assert event.session.busy, "the second visitor waits"
    assert read_visit(folders[1]).state is State.WAITING
    event.show_page(event.clone)
    assert event.next.isEnabled()
    assert "visitor" in event.next.text(), "nobody waits for a clone before the next one steps up"
    with qtbot.waitSignal(event.session.opened):
        qtbot.mouseClick(event.next, Qt.MouseButton.LeftButton)
    third = event.session.folder
    assert third not in folders
    assert not event.session.busy
    qtbot.waitUntil(lambda: "fitting" in event.queue_bar.text.text().lower())
    assert "1 more wait" in event.queue_bar.text.text()
    jobs.wait_for_cancel = False
    qtbot.waitUntil(lambda: event.session.queue.size() == 0)
    assert [read_visit(folder).state for folder in (*folders, third)] == [State.CLONED, State.CLONED, State.NONE]
    assert event.session.outcome is None, "another visitor's clone is not shown"
    assert event.notice.messages == ("Visitor 2: the clone is ready.", "Visitor 1: the clone is ready.")


def test_cancel_stops_and_tells_nothing(window, jobs, qtbot, folder):
    jobs.wait_for_cancel = True
    window.session.clone()
    assert jobs.started.wait(60)
    qtbot.waitUntil(lambda: window.queue_bar.bar.value() == 500)
    qtbot.mouseClick(window.queue_bar.cancel, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not window.session.busy)
    assert window.session.outcome is None
    assert not window.notice.isVisible()
    assert read_visit(folder).state is State.NONE


def test_closing_the_window_stops_the_work_and_who_waits_is_cloned_next_time(window, jobs, qtbot, folder):
    jobs.wait_for_cancel = True
    window.session.clone()
    assert jobs.started.wait(60)
    task = window.session.queue._runs[folder].task
    window.close()
    assert task.isFinished()
    assert read_visit(folder).state is State.WAITING


@pytest.mark.parametrize(
    ("error", "text"),
    [
        (
            ClonerError("the photo is dark", "Retake it", "face_side.jpg"),
            "Face, side: the photo is dark. Retake it.",
        ),
        (ZeroDivisionError("x"), "Cloner: something went wrong that the program did not expect"),
    ],
)
def test_a_failed_clone_is_told_in_the_quiet_bar(window, jobs, qtbot, folder, error, text):
    jobs.error = error
    with qtbot.waitSignal(window.session.failed):
        window.session.clone()
    qtbot.waitUntil(lambda: not window.session.busy)
    assert window.notice.isVisible()
    assert text in window.notice.text.text()
    assert read_visit(folder).state is State.FAILED
    qtbot.mouseClick(window.notice.close_button, Qt.MouseButton.LeftButton)
    assert not window.notice.isVisible()
    assert text in window.clone.warnings.text(), "who comes back to the visitor later still learns why"
    qtbot.waitUntil(lambda: text in window.visitor.list.item(0).toolTip())
    jobs.error = None
    with qtbot.waitSignal(window.session.cloned):
        window.session.clone()
    qtbot.waitUntil(lambda: not window.session.busy)
    assert text not in window.clone.warnings.text()


def test_the_visitor_takes_the_chosen_files(window, jobs, qtbot, tmp_path, monkeypatch):
    with qtbot.waitSignal(window.session.cloned):
        window.session.clone()
    window.show_page(window.takeaway)
    box = window.takeaway.formats["obj"]
    qtbot.mouseClick(box, Qt.MouseButton.LeftButton, pos=QPointF(10, box.height() / 2).toPoint())
    stick = tmp_path / "stick"
    stick.mkdir()
    monkeypatch.setattr("cloner_gui.pages.takeaway.QFileDialog.getExistingDirectory", lambda *_: str(stick))
    qtbot.mouseClick(window.takeaway.folder_button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not window.takeaway.handing.busy)
    assert sorted(path.name for path in (stick / "anna").iterdir()) == ["clone.glb", "clone.obj", "clone.wrl"]
    assert "stick/anna" in window.takeaway.status.text()
    assert window.takeaway.code.isHidden(), "a path of this computer is of no use on a telephone"
    window.takeaway.link.setText("https://booth.example/{id}")
    assert window.takeaway.code_note.text() == "https://booth.example/anna"
    assert not window.takeaway.code.pixmap().isNull()


def test_deleting_takes_everything_and_asks_first(event, jobs, qtbot, samples):
    folder = begin(event, qtbot)
    drop(event.photos, samples / "anna" / "plain" / "body_front.jpg")
    settled(event, qtbot)
    event.show_page(event.takeaway)
    event.takeaway.forget_button.click()
    box = _box(event)
    assert box.defaultButton().text().replace("&", "") == "Cancel", "Return alone deletes nothing"
    delete = next(one for one in box.buttons() if "Delete" in one.text())
    delete.click()
    qtbot.waitUntil(lambda: not folder.exists())
    assert event.session.folder is None
    assert event.visitor.list.count() == 0


def _box(window):
    from PySide6.QtWidgets import QMessageBox

    (box,) = [one for one in window.findChildren(QMessageBox) if one.isVisible()]
    return box


def test_effort_is_counted_for_the_operator_alone(window, qtbot, folder):
    window.booth.clicks = 3
    window.session.propose()
    qtbot.waitUntil(lambda: window.session.points(ViewId.BODY_FRONT) is not None and not window.session.busy)
    window.session.place_point(ViewId.BODY_FRONT, "nose_tip", 610.0, 300.0)
    window.booth.note_effort()
    visit = read_visit(folder)
    assert (visit.clicks, visit.drags) == (3, 1)
    assert visit.seconds > 0.0
    window.booth.note_effort()
    assert read_visit(folder) == visit, "nothing done, nothing written"


def test_the_window_opens_and_closes_as_a_program(folder):
    code = (
        "from PySide6.QtCore import QTimer; from PySide6.QtWidgets import QApplication; from pathlib import Path;"
        "import sys; app = QApplication([]); QTimer.singleShot(2500, QApplication.closeAllWindows);"
        "from cloner_gui.app import run_app; sys.exit(run_app(Path(sys.argv[1])))"
    )
    done = subprocess.run([sys.executable, "-c", code, str(folder)], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr
    assert json.loads((folder / "visit.json").read_text())["page"] == "photos"


def test_reopening_goes_on_where_the_work_was_left(window, jobs, qtbot, folder):
    window.session.propose()
    qtbot.waitUntil(lambda: window.session.points(ViewId.BODY_FRONT) is not None and not window.session.busy)
    window.show_page(window.points)
    window.session.place_point(ViewId.BODY_FRONT, "nose_tip", 620.0, 310.0)
    window.points.show_view(ViewId.FACE_SIDE)
    again = MainWindow(Session(jobs.services()))
    qtbot.addWidget(again)
    with qtbot.waitSignal(again.booth.page_wanted):
        again.booth.open(folder)
    assert again.stack.currentWidget() is again.points
    assert again.points.view is ViewId.FACE_SIDE
    point = again.session.corrections.points[ViewId.BODY_FRONT]["nose_tip"]
    assert (point.x_px, point.y_px) == (620.0, 310.0)
    assert np.isfinite(again.session.drags)
    settled(again, qtbot)
    again.booth.close()
