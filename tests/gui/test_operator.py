"""What is the operator's alone: settings, what is held, retention, effort, and the log without personal data."""

import logging
import os
import shutil
import time

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QDialog, QFileDialog, QMessageBox, QPushButton

from cloner.booth.events.event import new_visitor, read_event
from cloner.booth.events.recent import recent_events
from cloner.booth.visitors.person_file import write_person
from cloner.errors import ClonerError
from cloner_gui.event.effort import ClickCounter
from cloner_gui.event.session import Session
from cloner_gui.logs import log_to
from cloner_gui.main_window import MainWindow
from cloner_gui.pages.held import HeldWindow
from cloner_gui.pages.settings import SettingsWindow
from cloner_gui.pages.statistics import StatisticsWindow

from .test_flow import _box

pytestmark = pytest.mark.gui


@pytest.fixture
def root(tmp_path):
    """An event of two visitors, one of them long gone."""
    root = tmp_path / "fair"
    root.mkdir()
    old, new = new_visitor(root, "2026-10-01T10:00:00"), new_visitor(root, "2026-11-21T10:00:00")
    write_person(old, name="Anna Long", height_cm=None, consent="yes (2026-10-01 10:00 UTC, en)")
    for path in old.iterdir():
        os.utime(path, (time.time() - 40 * 86400,) * 2)
    assert new.is_dir()
    return root


@pytest.fixture
def window(qtbot, jobs, root):
    window = MainWindow(Session(jobs.services()))
    qtbot.addWidget(window)
    window.show()
    yield window
    window.booth.close()
    for handler in list(logging.getLogger().handlers):
        if getattr(handler, "baseFilename", "").endswith("cloner.log"):
            logging.getLogger().removeHandler(handler)
            handler.close()


def asked(window, qtbot):
    """Return the question that comes when everybody's files were counted."""
    qtbot.waitUntil(lambda: any(box.isVisible() for box in window.findChildren(QMessageBox)))
    return _box(window)


def test_whose_time_is_over_is_asked_about_at_the_start(window, root, qtbot):
    window.open_folder(root)
    box = asked(window, qtbot)
    assert "Anna Long (1)" in box.text()
    assert "Visitor 2" not in box.text()
    box.reject()
    assert (root / "visitor-001").is_dir(), "nothing goes unasked"
    window.booth.change(retention_days=0)
    window.sweep()
    assert window.booth.overdue_soon()() == ()
    window.booth.change(retention_days=30)
    window.sweep()
    next(one for one in asked(window, qtbot).buttons() if "Delete" in one.text()).click()
    assert [path.name for path in sorted(root.glob("visitor-*"))] == ["visitor-002"]


def test_the_list_says_what_is_held_and_deletes_who_is_marked(window, root, qtbot, monkeypatch, tmp_path):
    window.booth.open(root)
    held = HeldWindow(window.booth, window)
    held.show()
    qtbot.waitUntil(lambda: held.table.rowCount() == 2)
    assert held.table.item(0, 4).text() == "2026-10-01 10:00 UTC, en"
    assert held.table.item(0, 4).toolTip().startswith("yes"), "all of it, where somebody asks"
    assert held.table.item(1, 4).text() == "not recorded"
    held.table.selectRow(0)
    target = tmp_path / "out.zip"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(target), ""))
    qtbot.mouseClick(held.save_button, Qt.MouseButton.LeftButton)
    assert target.stat().st_size > 100
    qtbot.mouseClick(held.forget_button, Qt.MouseButton.LeftButton)
    next(one for one in _box(held).buttons() if "Delete" in one.text()).click()
    qtbot.waitUntil(lambda: held.table.rowCount() == 1)
    assert not (root / "visitor-001").exists()


def test_settings_are_saved_in_the_events_folder(window, root):
    window.booth.open(root)
    dialog = SettingsWindow(window.booth, window)
    assert dialog.days.value() == 30
    dialog.days.setValue(7)
    dialog.consent.setPlainText("Our own words.")
    dialog.accept()
    assert (read_event(root).retention_days, read_event(root).consents) == (7, {"en": "Our own words."})
    assert window.visitor.form.asked() == "Our own words."


def test_the_logo_is_a_picture_that_is_chosen_and_taken_away_again(window, root, qtbot, monkeypatch, tmp_path):
    window.booth.open(root)
    dialog = SettingsWindow(window.booth, window)
    dialog.show()
    (tmp_path / "no.png").write_bytes(b"no picture")
    QImage(40, 20, QImage.Format.Format_RGB32).save(str(tmp_path / "fair.png"))
    for file, seen in (("no.png", ""), ("fair.png", str(tmp_path / "fair.png"))):
        place = str(tmp_path / file)
        monkeypatch.setattr(
            "cloner_gui.widgets.logo_field.QFileDialog.getOpenFileName", lambda *_, place=place: (place, "")
        )
        qtbot.mouseClick(dialog.logo.choose_button, Qt.MouseButton.LeftButton)
        assert dialog.logo.path == seen
    assert dialog.logo.seen.pixmap().size().toTuple() == (96, 48)
    dialog.accept()
    assert read_event(root).logo == str(tmp_path / "fair.png")
    dialog = SettingsWindow(window.booth, window)
    dialog.show()
    qtbot.mouseClick(dialog.logo.none_button, Qt.MouseButton.LeftButton)
    dialog.accept()
    assert read_event(root).logo == ""


def test_events_that_were_open_last_are_offered_at_the_start(qtbot, jobs, root, tmp_path):
    file, other = tmp_path / "config" / "recent.json", tmp_path / "other & fair"
    other.mkdir()
    for folder in (root, other):
        window = MainWindow(Session(jobs.services()))
        qtbot.addWidget(window)
        window.visitor.recent.follow(file)
        window.open_folder(folder)
        window.booth.change(title="Fair of today" if folder == root else "")
        window.close()
    window = MainWindow(Session(jobs.services()))
    qtbot.addWidget(window)
    window.show()
    window.visitor.recent.follow(file)
    shown = [one for one in window.visitor.recent.findChildren(QPushButton) if one.isVisible()]
    assert [one.text() for one in shown] == ["other && fair", "Fair of today (fair)"]
    qtbot.mouseClick(shown[1], Qt.MouseButton.LeftButton)
    assert window.booth.root == root
    assert not window.visitor.recent.isVisible()
    window.close()
    shutil.rmtree(other)
    assert recent_events(file) == (root,), "what is gone is not offered"
    file.write_text("[[")
    assert recent_events(file) == ()


def test_the_table_of_effort_is_a_window_of_its_own(window, root, qtbot, monkeypatch, tmp_path):
    window.booth.open(root)
    effort = StatisticsWindow(window.booth, window)
    assert effort.isWindow()
    assert effort.table.rowCount() == 2
    target = tmp_path / "effort.csv"
    monkeypatch.setattr("cloner_gui.pages.statistics.QFileDialog.getSaveFileName", lambda *_: (str(target), ""))
    effort._save()
    assert len(target.read_text().splitlines()) == 3
    assert not [one for one in window.findChildren(QDialog) if one.isVisible()]


def test_a_click_is_counted_once(window, root, qtbot):
    from PySide6.QtWidgets import QApplication

    window.booth.open(root)
    counter = ClickCounter(window.booth)
    QApplication.instance().installEventFilter(counter)
    try:
        before = window.booth.clicks
        qtbot.mouseClick(window.steps.buttons[0], Qt.MouseButton.LeftButton)
        assert window.booth.clicks == before + 1
        qtbot.keyClick(window.steps.buttons[0], Qt.Key.Key_Space)
        assert window.booth.clicks == before + 2
    finally:
        QApplication.instance().removeEventFilter(counter)


def test_the_log_holds_no_home_and_no_event_path(tmp_path, monkeypatch):
    handler = log_to(tmp_path)
    try:
        log = logging.getLogger("cloner.test")
        try:
            raise ClonerError("broken", "mend", "x")
        except ClonerError:
            log.exception("reading %s and %s", tmp_path / "visitor-001" / "a.jpg", os.path.expanduser("~/b"))
        text = (tmp_path / "cloner.log").read_text()
    finally:
        logging.getLogger().removeHandler(handler)
        handler.close()
    assert "visitor-001" in text
    assert str(tmp_path) not in text
    assert os.path.expanduser("~") + "/" not in text


def test_a_camera_folder_is_kept_and_a_broken_setting_stops_nobody(window, root, tmp_path):
    window.booth.open(root)
    window.booth.change(camera_folder=str(tmp_path / "pulled"))
    assert read_event(root).camera_folder.endswith("pulled")
    (root / "event.json").write_text("{")
    window.booth.open(root)
    assert "damaged" in window.notice.text.text()
    assert window.booth.root == root
