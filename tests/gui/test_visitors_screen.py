"""The screen for visitors before anybody may be seen on it, reduced motion, and the numbers of the day."""

import csv
import os
from dataclasses import replace
from datetime import UTC, datetime

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage

from cloner.booth.events.trash import move_to_trash
from cloner.booth.photos.check_cache import store_check
from cloner.booth.photos.photo_problems import PhotoCheck, PhotoProblem
from cloner.booth.visitors.visits import read_visit, write_visit
from cloner.booth.walk_pictures import FILE
from cloner_gui.canvas.clones import attract
from cloner_gui.event.day_label import _counted
from cloner_gui.main_window import CLONE
from cloner_gui.pages.gallery import GalleryWindow
from cloner_gui.pages.stage import StageWindow

from .test_flow import begin, event  # noqa: F401  (event is a fixture)
from .test_visitors_side import cloned, with_result

pytestmark = pytest.mark.gui
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def stage(event, qtbot):  # noqa: F811
    window = StageWindow(event.booth)
    window.resize(400, 600)
    window.show()
    yield window
    window.close()


def test_sample_people_turn_until_a_visitor_may_be_seen(event, stage, qtbot):  # noqa: F811
    loop = stage.attract
    assert loop.active
    loop._timer.timeout.disconnect(loop.go_on)  # only the test turns them, however slow the machine is
    loop.side = loop._turned = 0
    assert stage.middle.currentWidget() is loop
    assert stage.who.text().startswith("Five photos")
    front = loop.grab().toImage()
    for _ in range(attract.ACROSS * attract.DOWN // 2):
        loop.go_on()
    assert loop.grab().toImage() != front, "the back is seen"
    for _ in range(attract.ACROSS * attract.DOWN * 3 // 2):
        loop.go_on()
    assert (loop.person, loop.side) == (1, 0), "after two turns the next one comes"
    folder = begin(event, qtbot)
    with_result(folder, shown=True)
    stage.go_on()
    qtbot.waitUntil(lambda: stage._shown == folder)
    assert not loop.active
    assert stage.middle.currentWidget() is stage.preview
    event.booth.forget(folder)
    qtbot.waitUntil(lambda: loop.active)


def test_nothing_moves_by_itself_where_that_is_wanted(event, stage, qtbot, samples):  # noqa: F811
    loop = stage.attract
    loop.go_on()
    event.booth.change(calm=True)
    assert loop.active
    front = loop.grab().toImage()
    loop.go_on()
    assert (loop.person, loop.side) == (1, 0), "it stands still, and another one comes"
    assert loop.grab().toImage() != front
    event.booth.change(calm=False)
    cloned(event, qtbot, samples)
    assert event.stack.currentIndex() == CLONE
    assert event.clone.reveal.active
    event.booth.change(calm=True)
    assert not event.clone.reveal.active, "it stops at once"
    assert event.clone.preview.motion_kind == "stand"


def test_the_shipped_pictures_are_whole_turns_and_read_only_when_they_are_shown(qtbot):
    for person in attract.PEOPLE:
        sheet = QImage(str(attract.PICTURES / f"turn_{person}.jpg"))
        assert sheet.width() == attract.ACROSS * attract.SIDE_PX[0]
        assert sheet.height() == attract.DOWN * attract.SIDE_PX[1]
        assert (attract.PICTURES / f"turn_{person}.jpg").stat().st_size < 500_000
    made = attract.AttractLoop()
    qtbot.addWidget(made)
    assert not made.active
    assert made._sheets == {}


def test_the_gallery_tells_the_numbers_of_the_day_and_saves_them(event, qtbot, tmp_path, monkeypatch):  # noqa: F811
    first, second = begin(event, qtbot), begin(event, qtbot)
    with_result(first, started="2026-11-22T10:00:00+00:00", queued="2026-11-22T10:00:00+00:00",
                finished="2026-11-22T10:03:00+00:00")  # fmt: skip
    with_result(second, started="2026-11-22T11:00:00+00:00")
    store_check(second, PhotoCheck("a", None, (PhotoProblem.BLURRED,)))
    gallery = GalleryWindow(event.booth, event)
    gallery.show()
    qtbot.waitUntil(lambda: gallery.numbers_label.text() != "")
    told = gallery.numbers_label.text()
    assert "2 visitors, 2 clones" in told
    assert "3.0 minutes in the middle, 3.0 at most" in told
    assert "Refused: 1 × It is blurred." in told
    monkeypatch.setattr(
        "cloner_gui.event.day_label.QFileDialog.getSaveFileName", lambda *_: (str(tmp_path / "n.csv"), "")
    )
    qtbot.mouseClick(gallery.numbers_button, LEFT)
    rows = list(csv.reader((tmp_path / "n.csv").open()))
    assert ["visitors", "", "2"] in [row[1:] for row in rows]
    assert ["photos to take again", "blurred", "1"] in [row[1:] for row in rows]
    gallery.list.setCurrentRow(1)
    gallery.list.item(1).setSelected(True)
    qtbot.mouseClick(gallery.trash_button, LEFT)
    qtbot.waitUntil(lambda: "1 of them lie in the trash" in gallery.numbers_label.text())
    assert "2 visitors, 2 clones" in gallery.numbers_label.text()
    assert "Refused: 1 × It is blurred." in gallery.numbers_label.text(), "what was refused was refused"
    gallery.close()


def test_who_is_thrown_away_while_the_day_is_counted_counts_once(event, qtbot):  # noqa: F811
    first, second = begin(event, qtbot), begin(event, qtbot)
    with_result(first)
    with_result(second)
    listed = {folder: read_visit(folder) for folder in (first, second)}
    move_to_trash(second, datetime.now(UTC))
    (found,) = _counted(listed, first.parent)
    assert (found.visitors, found.trashed) == (2, 1)


@pytest.fixture
def day(event, stage, qtbot, monkeypatch):  # noqa: F811
    """Three visitors with clones, of whom two agreed to be seen; their walks are drawn as soon as they may be."""
    monkeypatch.setattr("cloner.booth.walk_pictures.SIZE_PX", (24, 40))
    folders = [begin(event, qtbot) for _ in range(3)]
    for folder, shown in zip(folders, (True, True, False), strict=True):
        with_result(folder, shown=shown)
    event.booth.visits_changed.emit()
    qtbot.waitUntil(lambda: all((one / FILE).is_file() for one in folders[:2]))
    return folders


def test_the_day_s_crowd_walks_by_and_who_is_forgotten_leaves_it_at_once(event, stage, day, qtbot):  # noqa: F811
    seen, gone, unseen = day
    assert not (unseen / FILE).exists(), "nobody is drawn who did not agree"
    stage._seen = 3  # clones have shown themselves one by one
    stage.go_on()
    qtbot.waitUntil(lambda: stage.middle.currentWidget() is stage.parade)
    assert set(stage.parade.walkers) == {seen, gone}
    assert stage.who.text() == "Everybody of today"
    stage.parade._timer.stop()  # only the test moves them, however slow the machine is
    before = stage.parade.grab().toImage()
    for _ in range(6):
        stage.parade.go_on()
    assert stage.parade.grab().toImage() != before, "they walk"
    event.booth.change(calm=True)
    still = stage.parade.grab().toImage()
    stage.parade.go_on()
    assert stage.parade.grab().toImage() == still, "they stand where nothing moves by itself"
    event.booth.forget(gone)
    assert set(stage.parade.walkers) == {seen}
    write_visit(seen, replace(read_visit(seen), shown=False))
    event.booth.visits_changed.emit()
    assert not stage.parade.walkers, "who changes their mind leaves it too"
    assert stage.middle.currentWidget() is stage.attract


def test_one_alone_is_no_crowd_and_a_new_clone_is_drawn_anew(event, stage, day, qtbot):  # noqa: F811
    first, second, _ = day
    event.booth.forget(second)
    assert not stage.show_crowd()
    drawn = (first / FILE).stat().st_mtime_ns
    later = drawn + 20_000_000  # files' times move on in steps of milliseconds: now may be the time of the drawing
    os.utime(first / "clones" / first.name / "clone.npz", ns=(later, later))
    event.booth.visits_changed.emit()
    qtbot.waitUntil(lambda: (first / FILE).stat().st_mtime_ns > drawn)
