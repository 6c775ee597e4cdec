"""One window on a copy of a sample visitor, with stand-ins for the long jobs."""

import shutil
import threading
import time
from types import SimpleNamespace

import numpy as np
import pytest

from cloner.evaluate.baselines import generic_clone
from cloner.generic.load import load_generic
from cloner.records.points import ViewPoints
from cloner_gui.main_window import MainWindow
from cloner_gui.services import Proposed, Services
from cloner_gui.session import Session

NAMES = ("nose_tip", "eye_inner_L", "shoulder_end_left")
PLACES = np.array([[600.0, 300.0], [650.0, 400.0], [700.0, 700.0]])


class Jobs:
    """Stand-ins for proposing and cloning that a test can steer."""

    def __init__(self):
        self.error = None
        self.wait_for_cancel = False
        self.started = threading.Event()
        self.seen = []

    def propose(self, photos, progress):
        progress("proposals", 0.5)
        if self.error:
            raise self.error
        points = {
            view: ViewPoints(view, NAMES, PLACES, np.array([0.9, 0.5, 0.1]), np.zeros(3, bool))
            for view in photos.photos
        }
        return Proposed(points, {"photos": photos, "proposals": "found"})

    def clone(self, folder, out, height_cm, known, progress):
        self.seen.append((folder, out, height_cm))
        self.known = known
        self.started.set()
        if self.error:
            raise self.error
        deadline = time.monotonic() + 20
        while self.wait_for_cancel and time.monotonic() < deadline:
            progress("fine", 0.5)
            time.sleep(0.005)
        progress("textures", 0.9)
        clone = generic_clone(load_generic(), 1.7)
        return SimpleNamespace(folder=out / "anna", values={"clone": clone}, warnings=("the hair is a guess",))


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
    session = Session(Services(propose=jobs.propose, clone=jobs.clone))
    window = MainWindow(session)
    qtbot.addWidget(window)
    window.show()
    session.open(folder)
    yield window
    session.close()
