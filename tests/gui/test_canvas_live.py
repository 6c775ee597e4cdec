"""Work beside the window: its result comes to those who still want it, and it ends before the program does."""

import threading

import pytest

from cloner_gui.background.worker import Task, stop_all_tasks
from cloner_gui.canvas.photos.live import LiveOutlines

pytestmark = pytest.mark.gui


def test_work_that_nobody_holds_any_more_runs_to_its_end(qtbot):
    go, done = threading.Event(), threading.Event()

    def work(progress):
        go.wait(5)
        done.set()

    Task(work).start()  # no reference is kept here
    go.set()
    stop_all_tasks()
    assert done.is_set()


def test_outlines_of_a_visitor_who_has_gone_are_not_shown(qtbot, tmp_path, monkeypatch):
    waits, outlines = threading.Event(), LiveOutlines()

    def slow(folder, photos, proposed, progress):
        waits.wait(5)
        return {"front": "outline of the one who left"}

    monkeypatch.setattr("cloner_gui.canvas.photos.live.ready_outlines", slow)
    told = []
    outlines.changed.connect(lambda: told.append(dict(outlines._ready)))
    outlines.prepare(tmp_path, None, {})
    assert outlines.busy
    outlines.forget()
    waits.set()
    stop_all_tasks()
    qtbot.wait(50)
    assert told == []
    assert not outlines.busy
