"""Stand-ins for the window's long jobs, and photos let go over a widget."""

import threading
import time

import numpy as np
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent

from cloner.booth.body_preview import Shape
from cloner.booth.opened import Cloned
from cloner.booth.photos.photo_files import decode_photo
from cloner.booth.photos.photo_problems import PhotoCheck
from cloner.evaluate.truths.baselines import generic_clone
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.records.points import ViewPoints
from cloner_gui.event.services import Services

NAMES = ("nose_tip", "eye_inner_L", "shoulder_end_left")
PLACES = np.array([[600.0, 300.0], [650.0, 400.0], [700.0, 700.0]])


class Jobs:
    """Stand-ins for the long jobs that a test can steer."""

    def __init__(self):
        self.error = None
        self.wait_for_cancel = False
        self.started = threading.Event()
        self.seen = []
        self.checks = {}
        self.default = None
        self.hold_points = self.hold_checks = self.hold_copies = None

    def services(self):
        return Services(check_photo=self.check_photo, propose=self.propose, clone=self.clone, hand_over=self.hand_over)

    def check_photo(self, path, wanted, progress):
        while self.hold_checks is not None and not self.hold_checks.wait(0.01):
            progress("look", 0.0)
        photo = decode_photo(path, wanted or ViewId.BODY_FRONT)
        view, troubles = self.checks.get(photo.digest, self.default or (wanted, ()))
        return PhotoCheck(photo.digest, view, troubles)

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


def drop(widget, *paths):
    mime = QMimeData()
    mime.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    widget.dropEvent(QDropEvent(QPointF(5, 5), Qt.DropAction.CopyAction, mime, left, none))
