"""Cloned again: the clone before is one press away; several visitors are cloned at the same time where that is set."""

import json

import numpy as np
import pytest
from PySide6.QtCore import Qt

from cloner.booth.opened import read_cloned
from cloner.booth.photos.photo_files import placed_photos
from cloner.booth.visitors.cached_work import photo_digests
from cloner.booth.visitors.versions import keep_previous
from cloner.booth.visitors.visits import State, read_visit
from cloner.evaluate.truths.baselines import generic_clone
from cloner.generic.load import load_generic
from cloner.project.clone_file import save_clone
from cloner_gui.main_window import CLONE
from cloner_gui.pages.gallery import GalleryWindow
from cloner_gui.pages.settings import SettingsWindow
from kit.stand_ins import drop

from .test_flow import asked, begin, event, settled  # noqa: F401  (event is a fixture)

pytestmark = pytest.mark.gui
LEFT = Qt.MouseButton.LeftButton


def clone_as_the_worker_does(folder, stature_m):
    """Leave a clone of that stature, the one before kept."""
    result, photos = folder / "clones" / folder.name, photo_digests(placed_photos(folder))
    with keep_previous(folder, folder.name, photos):
        result.mkdir(parents=True, exist_ok=True)
        (result / "clone.npz").unlink(missing_ok=True)  # the one before shares its bytes
        (result / "report.json").unlink(missing_ok=True)
        save_clone(generic_clone(load_generic(), stature_m), result / "clone.npz")
        (result / "report.json").write_text(json.dumps({"stamp": {"photos": photos}, "warnings": []}))


def stature(folder):
    """Return the stature of the clone that is there, in metres; None in the moment of an exchange."""
    cloned = read_cloned(folder, placed_photos(folder))
    return cloned and round(float(np.ptp(cloned.values["clone"].vertices_m[:, 1])), 2)


@pytest.fixture
def twice(event, qtbot, samples):  # noqa: F811
    """A visitor who was cloned twice."""
    folder = begin(event, qtbot)
    event.go(1)
    drop(event.photos, samples / "anna" / "plain" / "body_front.jpg")
    settled(event, qtbot)
    for stature_m in (1.6, 1.8):
        clone_as_the_worker_does(folder, stature_m)
    event.session.open(folder)
    return folder


def test_the_clone_before_is_one_press_away_and_so_is_the_other(event, twice, qtbot):  # noqa: F811
    event.go(CLONE)
    assert event.clone.before_button.isVisible()
    new = stature(twice)
    qtbot.mouseClick(event.clone.before_button, LEFT)
    qtbot.waitUntil(lambda: bool(event.notice.messages))
    assert "the clone before is back" in event.notice.text.text()
    assert stature(twice) == pytest.approx(new - 0.2, abs=0.02)
    seen = event.session.clone_now()
    assert round(float(np.ptp(seen.vertices_m[:, 1])), 2) == stature(twice), "it is the one that is seen"
    assert event.stack.currentIndex() == CLONE
    qtbot.mouseClick(event.clone.before_button, LEFT)
    qtbot.waitUntil(lambda: stature(twice) == new)


def test_the_gallery_takes_clones_before_back_of_all_who_are_marked(event, twice, qtbot):  # noqa: F811
    other = begin(event, qtbot)
    gallery = GalleryWindow(event.booth, event)
    gallery.show()
    gallery.list.item(1).setSelected(True)
    assert not gallery.before_button.isEnabled(), f"{other.name} has none"
    gallery.list.selectAll()
    new = stature(twice)
    qtbot.mouseClick(gallery.before_button, LEFT)
    qtbot.waitUntil(lambda: stature(twice) < new)
    gallery.close()


def test_as_many_are_cloned_at_the_same_time_as_the_settings_say(event, jobs, qtbot, samples):  # noqa: F811
    dialog = SettingsWindow(event.booth, event)
    assert dialog.at_once.value() == 1
    dialog.at_once.setValue(2)
    dialog.accept()
    assert json.loads((event.booth.root / "event.json").read_text())["at_once"] == 2
    jobs.wait_for_cancel = True
    folders = asked(event, qtbot, samples, 3)
    qtbot.waitUntil(lambda: len(jobs.seen) == 2)
    assert [folder for folder, _ in jobs.seen] == folders[:2]
    assert event.session.queue.size() == 3
    assert event.session.queue.at_work == folders[0]
    event.session.queue.withdraw(folders[0])
    qtbot.waitUntil(lambda: len(jobs.seen) == 3)
    assert read_visit(folders[0]).state is State.NONE
    jobs.wait_for_cancel = False
    qtbot.waitUntil(lambda: event.session.queue.size() == 0)
    assert [read_visit(folder).state for folder in folders[1:]] == [State.CLONED] * 2
