"""The webcam dialog with a camera of its own: live picture, countdown, photo, and a camera that is not there."""

import io
import threading

import cv2
import numpy as np
import pytest
from PIL import Image
from PySide6.QtCore import QRectF, Qt
from shiboken6 import isValid

from cloner.booth.photos.camera import jpeg_bytes
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner_gui.canvas.photos.webcam import WebcamDialog, pose_outline

pytestmark = pytest.mark.gui


class Still:
    """Shows one picture for ever, or stops giving any."""

    def __init__(self):
        self.thread = threading.current_thread()
        self.closed = self.broken = False
        self.rgb = np.zeros((90, 160, 3), np.uint8)
        self.rgb[:, :80] = (200, 30, 30)

    def read(self):
        return None if self.broken else self.rgb

    def shoot(self):
        return jpeg_bytes(self.rgb)

    def close(self):
        self.closed = True


@pytest.fixture
def camera(qtbot):
    made = []
    dialog = WebcamDialog(ViewId.BODY_SIDE, make=lambda: made.append(Still()) or made[0])
    dialog.show()
    qtbot.waitUntil(lambda: dialog.live.picture is not None)
    yield dialog, made[0]
    if isValid(dialog):
        dialog.close()


def test_a_photo_is_taken_after_the_countdown_and_the_next_view_is_asked_for(camera, qtbot):
    dialog, still = camera
    assert still.thread is not threading.main_thread(), "a slow camera never holds up the window"
    dialog._timer.setInterval(10)
    qtbot.mouseClick(dialog.turn_button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: dialog.live.picture.shape == (160, 90, 3))
    with qtbot.waitSignal(dialog.taken) as taken:
        qtbot.mouseClick(dialog.take_button, Qt.MouseButton.LeftButton)
        assert dialog.live.count == "3"
    data, view = taken.args
    pixels = np.asarray(Image.open(io.BytesIO(data)))
    assert pixels.shape == (160, 90, 3)
    assert pixels[10, 45, 0] > 150, "turned clockwise, the left of the picture is on top"
    assert view is ViewId.BODY_SIDE
    assert dialog.live.view is ViewId.BODY_BACK
    dialog.close()
    assert still.closed


def test_escape_lets_the_camera_go(camera, qtbot):
    dialog, still = camera
    qtbot.keyClick(dialog, Qt.Key.Key_Escape)
    assert still.closed


def test_a_camera_s_photo_goes_whole_to_the_visitor(window, qtbot, samples, tmp_path, monkeypatch):
    """The product's own camera plays a film, as a driver would; the live picture is small, the photo is not."""
    photo = cv2.resize(cv2.imread(str(samples / "anna" / "plain" / "body_front.jpg")), (720, 1080))
    film = tmp_path / "camera.avi"
    writer = cv2.VideoWriter(str(film), cv2.VideoWriter_fourcc(*"MJPG"), 25, (720, 1080))
    for _ in range(150):
        writer.write(photo)
    writer.release()
    opened = cv2.VideoCapture
    monkeypatch.setattr("cloner.booth.photos.camera.cv2.VideoCapture", lambda number: opened(str(film)))
    window.booth.agree("I agree", "en")
    before = window.session.photos.photos[ViewId.BODY_FRONT].digest
    window.show_page(window.photos)
    window.photos._open_webcam()
    dialog = window.findChild(WebcamDialog)
    qtbot.waitUntil(lambda: dialog.live.picture is not None)
    assert dialog.live.picture.shape == (720, 480, 3)
    dialog._timer.setInterval(10)
    with qtbot.waitSignal(dialog.taken):
        dialog.take()
    dialog.close()
    qtbot.waitUntil(lambda: window.session.photos.photos[ViewId.BODY_FRONT].digest != before)
    taken = window.session.photos.photos[ViewId.BODY_FRONT].rgb
    assert taken.shape == (1080, 720, 3)
    assert np.abs(taken.astype(int) - photo[..., ::-1]).mean() < 6.0, "colours and sides are the camera's"


@pytest.mark.parametrize("when", ["at once", "later"])
def test_a_camera_that_is_not_there_is_told(qtbot, when):
    def make():
        if when == "at once":
            raise ClonerError("there is no camera", "Plug it in", "Camera 0")
        still = Still()
        still.broken = True
        return still

    told = []
    dialog = WebcamDialog(ViewId.FACE_FRONT, make=make)
    dialog.failed.connect(told.append)
    dialog.show()
    qtbot.waitUntil(lambda: len(told) == 1)
    assert "camera" in told[0].message
    assert not isValid(dialog) or not dialog.isVisible()


@pytest.mark.parametrize("view", list(ViewId))
def test_the_outline_lies_in_the_picture(view):
    room = QRectF(10, 20, 300, 400)
    box = pose_outline(view, room).boundingRect()
    assert room.contains(box)
    assert box.height() > (0.8 if view.is_body else 0.6) * room.height()
    assert box.center().x() == pytest.approx(room.center().x(), abs=0.05 * room.width())
