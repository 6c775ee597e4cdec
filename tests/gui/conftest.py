"""Windows with stand-ins for the long jobs: on a copy of a sample visitor, and with the studio's own jobs."""

import dataclasses
import gc
import shutil
import threading
import time

import numpy as np
import pytest

from cloner.booth.growing import Shape
from cloner.booth.opened import Cloned
from cloner.booth.photos.looking_table import Look
from cloner.booth.photos.photo_files import decoded
from cloner.evaluate.truths.baselines import generic_clone
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.records.points import ViewPoints
from cloner_gui.event.services import Services
from cloner_gui.event.session import Session
from cloner_gui.main_window import MainWindow
from kit.studio_window import Studio

NAMES = ("nose_tip", "eye_inner_L", "shoulder_end_left")
PLACES = np.array([[600.0, 300.0], [650.0, 400.0], [700.0, 700.0]])


class Jobs:
    """Stand-ins for the long jobs that a test can steer."""

    def __init__(self):
        self.error = None
        self.wait_for_cancel = False
        self.started = threading.Event()
        self.seen = []
        self.looks = {}
        self.default = None
        self.hold_points = self.hold_looks = self.hold_copies = None

    def services(self):
        return Services(look=self.look, propose=self.propose, clone=self.clone, hand_over=self.hand_over)

    def look(self, path, wanted, progress):
        while self.hold_looks is not None and not self.hold_looks.wait(0.01):
            progress("look", 0.0)
        photo = decoded(path, wanted or ViewId.BODY_FRONT)
        view, troubles = self.looks.get(photo.digest, self.default or (wanted, ()))
        return Look(photo.digest, view, troubles)

    def propose(self, folder, photos, progress):
        progress("proposals", 0.5)
        while self.hold_points is not None and not self.hold_points.wait(0.01):
            progress("proposals", 0.5)
        if self.error:
            raise self.error
        return {
            view: ViewPoints(view, NAMES, PLACES, np.array([0.9, 0.5, 0.1]), np.zeros(3, bool))
            for view in photos.photos
        }

    def clone(self, folder, formats, progress, show):
        self.seen.append((folder, tuple(formats)))
        self.started.set()
        if self.error:
            raise self.error
        deadline = time.monotonic() + 20
        while self.wait_for_cancel and time.monotonic() < deadline:
            progress("fine", 0.5)
            time.sleep(0.005)
        show(Shape("fine", generic_clone(load_generic(), 1.7).vertices_m.astype(np.float32)))
        progress("textures", 0.9)
        clone = generic_clone(load_generic(), 1.7)
        return Cloned(folder / "clones" / folder.name, {"clone": clone}, ("the hair is a guess",)), 12.5

    def hand_over(self, result, target, formats, progress):
        while self.hold_copies is not None and not self.hold_copies.wait(0.01):
            progress("copy", 0.7)
        target.mkdir()
        for name in formats:
            (target / f"clone.{name}").write_text("x")
        return target


@pytest.fixture(autouse=True)
def _garbage_on_the_main_thread():
    """Widgets of earlier tests must not die on a worker's thread: see `cloner_gui.background.tidying`."""
    gc.disable()
    yield
    gc.collect()
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
