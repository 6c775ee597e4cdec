"""Windows with stand-ins for the long jobs: on a copy of a sample visitor, and with the studio's own jobs."""

import dataclasses
import gc
import shutil

import pytest
from pytestqt.qtbot import QtBot

from cloner_gui.event.session import Session
from cloner_gui.main_window import MainWindow
from kit.stand_ins import Jobs
from kit.studio_window import Studio

#: A busy machine is slow, not wrong: what is waited for comes late there, and pytest-qt gives up after 5 s by itself.
PATIENCE_MS = 60_000
for wait in (QtBot.waitUntil, QtBot.waitSignal, QtBot.waitSignals):
    wait.__kwdefaults__["timeout"] = PATIENCE_MS


@pytest.fixture(autouse=True)
def _garbage_on_the_main_thread():
    """Widgets of earlier tests must not die on a worker's thread: see `cloner_gui.background.tidying`.

    What was there before is not searched: by then other tests keep gigabytes of people.
    """
    gc.freeze()
    gc.disable()
    yield
    gc.collect()
    gc.unfreeze()
    gc.enable()


@pytest.fixture
def jobs():
    return Jobs()


@pytest.fixture
def folder(samples, tmp_path):
    target = tmp_path / "anna"
    shutil.copytree(samples / "anna" / "plain", target)
    return target


@pytest.fixture
def window(qtbot, jobs, folder):
    """The window on the photos page, the sample visitor open."""
    session = Session(jobs.services())
    window = MainWindow(session)
    qtbot.addWidget(window)
    window.show()
    with qtbot.waitSignal(window.booth.page_wanted, timeout=30000):
        window.booth.open(folder)
    qtbot.waitUntil(lambda: window.booth.intake.pending() == 0, timeout=30000)
    yield window
    window.booth.close()


@pytest.fixture(scope="module")
def kept_studio():
    """The studio's process of one file of tests: what it has read and made stays in its memory."""
    return Studio()


@pytest.fixture
def studio(kept_studio):
    """The studio's jobs; a file of tests that steers them gives its own."""
    return kept_studio


@pytest.fixture
def studio_window(qtbot, jobs, studio, tmp_path):
    """The window on an empty event, with the studio's jobs on the caller's thread; results are one GLB."""
    root = tmp_path / "fair"
    root.mkdir()
    window = MainWindow(Session(dataclasses.replace(jobs.services(), studio=studio)))
    qtbot.addWidget(window)
    window.show()
    window.booth.open(root)
    window.booth.change(formats=("glb",))
    yield window
    window.booth.close()
