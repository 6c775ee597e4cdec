"""Opening folders, heights, cloning, cancelling, and errors that are told."""

import shutil
import subprocess
import sys

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QMessageBox

from cloner.errors import ClonerError
from cloner.frames import ViewId

pytestmark = pytest.mark.gui


def dialogs(window):
    return [box for box in window.findChildren(QMessageBox) if box.isVisible()]


def drop(page, path):
    mime = QMimeData()
    mime.setUrls([QUrl.fromLocalFile(str(path))])
    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    page.dropEvent(QDropEvent(QPointF(5, 5), Qt.DropAction.CopyAction, mime, left, none))


def test_the_first_page_shows_the_photos_and_the_height(window, folder):
    assert window.photos.folder_label.text() == "anna"
    assert window.photos.missing_label.text() == "All five photos are here."
    assert window.visitor.height_field.value() == 158.0
    assert window.visitor.height_known.isChecked()
    assert all(label.pixmap().height() > 100 for label in window.photos.thumbnails.values())
    assert window.next.isEnabled()


def test_what_is_missing_is_said_in_words(window, folder):
    (folder / "face_side.jpg").unlink()
    (folder / "body_back.jpg").unlink()
    window.session.open(folder)
    assert window.photos.missing_label.text() == (
        "The clone will be less exact. Missing: body_back.jpg, face_side.jpg."
    )
    assert window.photos.thumbnails[ViewId.FACE_SIDE].text() == "missing"
    assert window.points.tabs.count() == 3


def test_a_photo_dropped_opens_its_folder(window, samples, tmp_path):
    other = tmp_path / "boris"
    shutil.copytree(samples / "boris" / "plain", other)
    drop(window.photos, other / "face_front.jpg")
    assert window.session.folder == other
    assert window.visitor.height_field.value() == 175.0


def test_an_unusable_folder_is_told_and_the_old_one_stays(window, tmp_path, folder):
    empty = tmp_path / "empty"
    empty.mkdir()
    drop(window.photos, empty)
    (box,) = dialogs(window)
    assert box.text().startswith("empty: ")
    assert "body_front.jpg" in box.informativeText()
    assert window.session.folder == folder
    box.close()


def test_an_unknown_height_is_said_to_leave_lengths_unscaled(window, jobs, qtbot):
    window.visitor.height_known.setChecked(False)
    assert "170 cm is assumed" in window.visitor.height_hint.text()
    assert window.session.height_cm is None
    window.visitor.height_known.setChecked(True)
    window.visitor.height_field.setValue(999.0)
    assert window.session.height_cm == 250.0, "the field keeps within what people measure"


def test_clone_shows_progress_and_the_result(window, jobs, qtbot, folder):
    window.visitor.height_field.setValue(160.0)
    window.show_page(window.clone)
    steps = []
    window.session.progressed.connect(lambda step, fraction: steps.append((step, fraction)))
    with qtbot.waitSignal(window.session.cloned, timeout=20000):
        qtbot.mouseClick(window.clone.clone_button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not window.session.busy)
    assert jobs.seen == [(folder, folder / "clones", 160.0)]
    assert steps == [("textures", 0.9)]
    assert window.clone.warnings.text() == "• the hair is a guess"
    assert window.takeaway.report_button.isEnabled()
    assert window.clone.status.text() == "Written to clones/anna"


def test_cancel_stops_and_opens_no_dialog(window, jobs, qtbot):
    jobs.wait_for_cancel = True
    window.show_page(window.clone)
    assert not window.clone.cancel_button.isEnabled()
    qtbot.mouseClick(window.clone.clone_button, Qt.MouseButton.LeftButton)
    assert jobs.started.wait(5)
    assert not window.clone.clone_button.isEnabled()
    qtbot.waitUntil(lambda: window.clone.progress.value() == 500)
    qtbot.mouseClick(window.clone.cancel_button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not window.session.busy, timeout=5000)
    assert window.session.outcome is None
    assert dialogs(window) == []
    assert window.clone.clone_button.isEnabled()
    assert not window.clone.progress.isVisible()


def test_closing_the_window_stops_the_work(window, jobs, qtbot):
    jobs.wait_for_cancel = True
    window.show_page(window.clone)
    window.session.clone()
    assert jobs.started.wait(5)
    task = window.session._task
    window.close()
    assert task.isFinished()


@pytest.mark.parametrize(
    ("error", "text", "hint"),
    [
        (
            ClonerError("the photo is dark", "Retake it", "face_side.jpg"),
            "face_side.jpg: the photo is dark.",
            "Retake it.",
        ),
        (ZeroDivisionError("x"), "Cloner: something went wrong that the program did not expect.", "terminal"),
    ],
)
def test_a_failed_clone_is_told_in_one_sentence(window, jobs, qtbot, error, text, hint):
    jobs.error = error
    window.show_page(window.clone)
    with qtbot.waitSignal(window.session.failed, timeout=5000):
        window.session.clone()
    qtbot.waitUntil(lambda: not window.session.busy)
    (box,) = dialogs(window)
    assert box.text() == text
    assert hint in box.informativeText()
    assert window.session.outcome is None
    box.close()


@pytest.mark.gl
def test_the_result_turns_with_the_mouse(window, qtbot):
    window.show_page(window.clone)
    with qtbot.waitSignal(window.session.cloned, timeout=20000):
        window.session.clone()
    table = window.clone.turntable
    front = pixels(table)
    assert (front != front[0, 0]).any(axis=2).mean() > 0.03, "somebody stands there"
    assert mirrored_difference(front) < 3.0, "seen from the front, a symmetric body is symmetric"
    qtbot.mousePress(table, Qt.MouseButton.LeftButton, pos=QPoint(100, 100))
    qtbot.mouseMove(table, QPoint(178, 100))
    qtbot.mouseRelease(table, Qt.MouseButton.LeftButton, pos=QPoint(178, 100))
    turned = pixels(table)
    assert mirrored_difference(turned) > 2 * mirrored_difference(front)
    qtbot.mouseClick(window.clone.body_button, Qt.MouseButton.LeftButton)
    assert np.array_equal(pixels(table), front)
    qtbot.mouseClick(window.clone.face_button, Qt.MouseButton.LeftButton)
    close = pixels(table)
    assert (close != close[0, 0]).any(axis=2).mean() > 1.5 * (front != front[0, 0]).any(axis=2).mean()


def pixels(label):
    image = label.pixmap().toImage().convertToFormat(label.pixmap().toImage().Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


def mirrored_difference(picture):
    return np.abs(picture - picture[:, ::-1]).mean()


def test_the_window_opens_and_closes_as_a_program(folder):
    code = (
        "from PySide6.QtCore import QTimer; from PySide6.QtWidgets import QApplication; from pathlib import Path;"
        "import sys; app = QApplication([]); QTimer.singleShot(400, QApplication.closeAllWindows);"
        "from cloner_gui.app import run_app; sys.exit(run_app(Path(sys.argv[1])))"
    )
    done = subprocess.run([sys.executable, "-c", code, str(folder)], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr


def test_cloning_reuses_what_the_points_page_found(window, jobs, qtbot, tmp_path):
    session = window.session
    with qtbot.waitSignal(session.cloned, timeout=20000):
        session.clone(tmp_path / "first")
    assert jobs.known == {}, "nothing was proposed yet"
    qtbot.waitUntil(lambda: not session.busy)
    with qtbot.waitSignal(session.points_changed, timeout=20000):
        session.propose()
    qtbot.waitUntil(lambda: not session.busy)
    with qtbot.waitSignal(session.cloned, timeout=20000):
        session.clone(tmp_path / "second")
    assert jobs.known["proposals"] == "found"
    assert jobs.known["photos"] is session.photos


def test_the_bar_starts_empty_for_every_work(window, jobs, qtbot):
    window.clone.progress.setValue(1000)
    jobs.wait_for_cancel = True
    shown = []
    window.session.busy_changed.connect(lambda: shown.append(window.clone.progress.value()))
    window.session.clone()
    assert shown == [0]
