"""Threads and the window: nothing of Qt's goes on another thread, and none is destroyed while it runs."""

import subprocess
import sys
import threading

import pytest
from PySide6.QtCore import QObject, Qt

from cloner.errors import ClonerError
from cloner_gui.background.newest import shared_latest
from cloner_gui.background.worker import Task, stop_all_tasks

pytestmark = pytest.mark.gui

#: A window goes, with the camera's window in it and work that it began, while both threads run.
GOES = """
import sys, threading
import numpy as np
import shiboken6
from PySide6.QtWidgets import QApplication, QWidget
from cloner.frames import ViewId
from cloner_gui.canvas.photos.webcam import WebcamDialog
from cloner_gui.background.worker import Task, stop_all_tasks

class Still:
    closed = threading.Event()
    def read(self):
        return np.full((90, 160, 3), 127, np.uint8)
    def close(self):
        self.closed.set()

app, window, seen = QApplication([]), QWidget(), threading.Event()
dialog = WebcamDialog(ViewId.FACE_SIDE, window, make=Still)
dialog.show()
window.task = Task(lambda progress: seen.wait(20))
window.task.start()
while dialog._grabber.newest is None:
    app.processEvents()
shiboken6.delete(window)
del window, dialog
assert Still.closed.wait(10)
seen.set()
stop_all_tasks()
app.processEvents()
print("well")
"""


def test_a_window_that_goes_takes_no_running_thread_along():
    done = subprocess.run([sys.executable, "-c", GOES], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr[-2000:]
    assert done.stdout == "well\n"
    assert "QThread" not in done.stderr


@pytest.mark.parametrize(("error", "told"), [(None, "succeeded"), (ClonerError("a", "b", "c"), "failed")])
def test_what_became_of_work_is_told_after_its_thread_ended(qtbot, error, told):
    def work(progress):
        if error:
            raise error
        return 1

    heard, task = [], Task(work)

    def hear(value=None):
        heard.append((threading.current_thread() is threading.main_thread(), task.isFinished()))

    getattr(task, told).connect(hear, Qt.ConnectionType.DirectConnection)
    task.finished.connect(lambda: heard.append("over"))
    task.start()
    qtbot.waitUntil(lambda: len(heard) == 2)
    assert heard == [(True, True), "over"]


def test_work_goes_outside_its_own_signals(qtbot):
    """Deleted while Qt delivers one of its events to it, it would be looked at once more."""
    gone, inside = [], []
    task = Task(lambda progress: None)
    task.finished.connect(lambda: inside.append(len(gone)))
    task.destroyed.connect(lambda: gone.append(1))
    task.start()
    del task
    qtbot.waitUntil(lambda: bool(gone))
    assert inside == [0]
    stop_all_tasks()


def test_what_short_work_holds_goes_on_the_windows_thread(qtbot):
    went = []

    class Work:
        def __call__(self):
            return self

        def __del__(self):
            went.append(threading.current_thread().name)

    owner = QObject()
    for number in range(200):
        shared_latest().ask(owner, "held", Work(), lambda _: None, lambda _: None)
        qtbot.waitUntil(lambda: shared_latest().idle)
        qtbot.waitUntil(lambda number=number: len(went) == number + 1)
    assert set(went) == {threading.main_thread().name}
