"""kill -9 at random moments: the reopened event has lost at most the last step of the operator.

``CLONER_KILLS=20 pytest tests/gui/test_kill.py`` kills twenty times; CI three times.
"""

import json
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import cv2
import pytest

from cloner_gui.event.session import Session
from cloner_gui.main_window import MainWindow
from kit import walker

pytestmark = [pytest.mark.gui, pytest.mark.slow]
KILLS = int(os.environ.get("CLONER_KILLS", "3"))


@pytest.fixture(scope="module")
def small_photos(tmp_path_factory):
    """Small copies of the sample's photos: the window's behaviour does not depend on their size."""
    folder = tmp_path_factory.mktemp("photos")
    for view in walker.VIEWS:
        photo = cv2.imread(str(Path(__file__).parents[2] / "samples" / "anna" / "plain" / f"{view}.jpg"))
        cv2.imwrite(str(folder / f"{view}.jpg"), cv2.resize(photo, None, fx=0.15, fy=0.15))
    return folder


def start(event, photos):
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, "-m", "kit.walker", str(event), str(photos)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment)


@pytest.fixture(scope="module")
def whole_walk(small_photos, tmp_path_factory):
    """Every state of an undisturbed walk, and the seconds between its first and last step."""
    event = tmp_path_factory.mktemp("event")
    process = start(event, small_photos)
    assert process.stdout.readline() == "ready\n"
    begun = time.monotonic()
    states = [json.loads(line) for line in process.stdout]
    assert process.wait() == 0
    return states, time.monotonic() - begun


def reopened(event, qtbot):
    """Return what a new window knows of the event."""
    window = MainWindow(Session(walker.services()))
    qtbot.addWidget(window)
    window.booth.open(event)
    qtbot.waitUntil(lambda: window.booth._opening is None and window.booth.intake.pending() == 0)
    told = walker.known(window)
    window.session.queue.close()
    window.booth.close()
    return told


@pytest.mark.parametrize("moment", range(KILLS))
def test_killed_at_a_random_moment_nothing_but_the_last_step_is_lost(whole_walk, small_photos, tmp_path, qtbot, moment):
    states, seconds = whole_walk
    process = start(tmp_path, small_photos)
    assert process.stdout.readline() == "ready\n"
    time.sleep(random.Random(f"{moment}").uniform(0.0, 0.95 * seconds))
    process.send_signal(signal.SIGKILL)
    done = len(process.stdout.read().splitlines())
    process.wait()
    now = reopened(tmp_path, qtbot)
    before = {**states[0], "visitors": [], "open": None, "page": 0, "name": "", "agreed": False}
    allowed = [before, *states][done : done + 2]
    told = [{key: value for key, value in state.items() if key != "step"} for state in allowed]
    # between the steps lie moments of their own: a photo stored and not yet looked at, a page noted, a visitor made
    parts = {key: [state[key] for state in told] for key in now}
    for key, value in now.items():
        assert value in parts[key], f"{key} after {done} steps ({allowed[-1]['step']}): {value}, wanted {parts[key]}"


def test_the_walk_reaches_its_end(whole_walk):
    states, _ = whole_walk
    assert states[-1]["visitors"] == ["visitor-001", "visitor-002"]
    assert states[-1]["cloned"]
    assert states[-1]["points"] == {"body_front": {"nose_tip": [45.0, 50.0]}}
