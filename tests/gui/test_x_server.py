"""The path in a real X server with its own mouse, also on a screen of double density; skipped where Xvfb is missing."""

import ctypes.util
import json
import os
import shutil
import subprocess
import sys
import time

import cv2
import pytest

from kit import walker

pytestmark = [
    pytest.mark.gui,
    pytest.mark.slow,
    pytest.mark.skipif(shutil.which("Xvfb") is None, reason="Xvfb is not installed"),
    pytest.mark.skipif(ctypes.util.find_library("Xtst") is None, reason="libXtst is not installed"),
    pytest.mark.skipif(ctypes.util.find_library("xcb-cursor") is None, reason="libxcb-cursor0 is not installed"),
]


@pytest.fixture
def display():
    """Return the number of a new X server's display."""
    read, write = os.pipe()
    command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "1920x1080x24", "-nolisten", "tcp"]
    server = subprocess.Popen(command, pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    with os.fdopen(read) as stream:
        number = stream.readline().strip()
    if not number:
        pytest.skip("Xvfb does not start")
    time.sleep(0.2)
    yield number
    server.terminate()
    server.wait()


@pytest.mark.parametrize("scale", ["1", "2"])
def test_the_path_with_the_servers_own_mouse(samples, tmp_path, display, scale):
    photos = tmp_path / "photos"
    photos.mkdir()
    (tmp_path / "fair").mkdir()
    for view in walker.VIEWS:
        photo = cv2.imread(str(samples / "anna" / "plain" / f"{view}.jpg"))
        cv2.imwrite(str(photos / f"{view}.jpg"), cv2.resize(photo, None, fx=0.2, fy=0.2))
    environment = {
        **os.environ, "DISPLAY": f":{display}", "QT_QPA_PLATFORM": "xcb", "QT_SCALE_FACTOR": scale,
        "PYTHONPATH": os.pathsep.join(sys.path),
    }  # fmt: skip
    command = [sys.executable, "-m", "kit.x_walk", str(tmp_path / "fair"), str(photos)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr[-3000:]
    told = json.loads(done.stdout.splitlines()[-1])
    assert told["visitors"] == ["visitor-001"]
    assert told["agreed"]
    assert len(told["photos"]) == 3
    assert told["cloned"]
    assert told["clicks_seen"], "the last page is reached by clicks alone"
    x, y = told["points"]["body_front"]["nose_tip"]
    near = 2.0 if scale == "1" else 3.0  # on 960 x 540 points the canvas is small: a point is some 2.5 px of the photo
    assert (x, y) == (pytest.approx(60.0, abs=near), pytest.approx(90.0, abs=near))
