"""A photograph fitted to a clone: markers are dragged on the picture, and the clone beside it follows."""

from __future__ import annotations

import functools
import time
from dataclasses import replace
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtWidgets import QFileDialog, QHBoxLayout, QMenu, QWidget

from cloner.booth.studio.values import MarkedPhoto, Markers, StatueWish, received
from cloner.frames import ViewId
from cloner.records.clones import Clone
from cloner.records.points import ViewPoints
from cloner.statues.markers import known_points
from cloner.statues.photo_fit import FEWEST, Fit, Marked, fit_markers, mark
from cloner.statues.photographed import mesh_of
from cloner_gui.background.newest import shared_latest
from cloner_gui.canvas.photos.view import PhotoView
from cloner_gui.event.booth import Booth
from cloner_gui.language.point_names import is_point, point_label
from cloner_gui.language.words import translate
from cloner_gui.studio.photo_scene import FittedPhotoPreview
from cloner_gui.studio.statues import StatueBench
from cloner_gui.widgets.pieces import button, label

_KINDS: Final = "*.jpg *.jpeg *.png *.webp *.tif *.tiff *.heic"
#: What a vertex is called that has no name of its own: this and its number.
_VERTEX: Final = "vertex_"


class MarkerView(PhotoView):
    """The photo with its markers; Delete and the right button remove one."""

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer to take the marker under the hand away."""
        at = self._name_at(QPointF(event.pos()))
        if at:
            menu = QMenu(self)
            menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
            text = translate("studio", "Take this marker away")
            menu.addAction(text).triggered.connect(lambda: self.point_reset.emit(at))
            menu.popup(event.globalPos())


class PhotographWindow(StatueBench):
    """A photo, its markers, and the clone it is fitted to."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(booth, translate("studio", "Photograph on a statue"), parent, usual=True)
        self.photo_button, self.paint_button = button(), button()
        self.view, self.preview, self.told = MarkerView(), FittedPhotoPreview(), label("dim")
        self.drags_s: list[float] = []  # from a hand's move to the picture on the screen
        self._photo: MarkedPhoto | None = None
        self._path: Path | None = None
        self._markers = Markers((), np.zeros((0, 2)))
        self._marked: Marked | None = None
        self._fit: Fit | None = None
        self._rgb = np.zeros((1, 1, 3), np.uint8)
        self._place()
        self._connect()
        self._show_ready()
        self.settle()

    def _place(self) -> None:
        self.photo_button.setText(translate("studio", "Choose a &photograph…"))
        self.paint_button.setText(translate("studio", "Paint it all &round"))
        self.preview.say_when_empty(translate("studio", "Choose a photograph of a face, of flesh or of stone."))
        self.controls.addWidget(self.photo_button)
        self.controls.addWidget(self.told)
        self.field(translate("studio", "&Material"), self.material)
        self.controls.addWidget(self.paint_button)
        self.end_fields()
        both = QHBoxLayout()
        both.addWidget(self.view, 1)
        both.addWidget(self.preview, 1)
        self.stage.addLayout(both, 1)

    def _connect(self) -> None:
        self.photo_button.clicked.connect(self._choose)
        self.paint_button.clicked.connect(self.paint)
        self.material.activated.connect(lambda _: self._show_live())
        self.subject.changed.connect(self.begin_anew)
        self.view.point_moved.connect(self.move_marker)
        self.view.point_reset.connect(self.remove_marker)
        self.view.chosen_changed.connect(self._tell_marker)
        self.view.next_wanted.connect(self._choose_next)
        self.preview.picked.connect(self.add_marker)
        self.preview.laid.connect(self.drags_s.append)
        self.preview.failed.connect(self.notice.tell)
        self.busy_changed.connect(self._show_ready)

    # --- photo and clone ---------------------------------------------------------------

    def _choose(self) -> None:
        title = translate("studio", "Photograph")
        path, _ = QFileDialog.getOpenFileName(self, title, "", f"{title} ({_KINDS})")
        if path:
            self.open_photo(Path(path))

    def open_photo(self, path: Path) -> None:
        """Read a photo and find a face in it."""
        self._path = path
        self.begin_anew()

    def begin_anew(self) -> None:
        """Mark the photo anew: another one, or another clone, is wanted."""
        if not self.is_ready():
            self._photo, self._fit = None, None
            self.preview.show_fit(None, None, None)
            self.preview.set_clone(None)
        elif self._path is not None:
            self.work("mark_photo", self._path, self.onto(), then=self._take_photo)

    def _take_photo(self, found: MarkedPhoto) -> None:
        self._photo, self._fit = replace(found, clone=received(found.clone)), None
        rgb = np.ascontiguousarray(found.rgb)
        rgb.setflags(write=False)  # it came through a pipe: the painter keeps what cannot change
        self._rgb = rgb
        self.view.set_photo(rgb)
        self.preview.set_clone(self._photo.clone)
        self.preview.frame("face")
        if not found.found:
            self.told.setText(translate("studio", "No face was found: drag the markers to their places."))
        self._mark(found.markers)
        if found.found:
            self._tell_marker("")

    # --- markers ---------------------------------------------------------------------------

    def markers(self) -> Markers:
        """Return the markers as they are now."""
        return self._markers

    def move_marker(self, name: str, x_px: float, y_px: float, gesture: str = "") -> None:
        """Put a marker elsewhere on the photo."""
        px = self._markers.px.copy()
        px[[str(_called(at)) for at in self._markers.at].index(name)] = x_px, y_px
        self._markers = Markers(self._markers.at, px)
        self._show_markers()
        self._lay()

    def add_marker(self, vertex: int) -> None:
        """Mark a place of the clone's skin, where the photo shows it now."""
        known = set(_vertices(self._markers.at))
        if self._fit is None or self._marked is None or vertex in known:
            return
        place = self._fit.camera.project(self._fit.vertices_m[[vertex]])
        self._mark(Markers((*self._markers.at, vertex), np.vstack([self._markers.px, place])))
        self.view.choose(f"{_VERTEX}{vertex}")

    def remove_marker(self, name: str) -> None:
        """Take a marker away; some must stay."""
        rows = [row for row, at in enumerate(self._markers.at) if _called(at) != name]
        if FEWEST <= len(rows) < len(self._markers.at):
            self._mark(Markers(tuple(self._markers.at[row] for row in rows), self._markers.px[rows]))

    def _mark(self, markers: Markers) -> None:
        """Have other places of the clone marked."""
        if self._photo is None:
            return
        self._markers, self._marked = markers, None
        self._show_markers()
        clone, vertices = self._photo.clone, np.array(_vertices(markers.at), np.int32)
        work = functools.partial(_marked, clone, vertices)
        shared_latest().ask(self, "mark", work, functools.partial(self._take_marked, markers.at), self.notice.tell)

    def _take_marked(self, at: tuple[int | str, ...], marked: Marked) -> None:
        if at == self._markers.at:
            self._marked = marked
            self._lay()

    def _lay(self) -> None:
        """Have the photo laid where the markers are now."""
        if self._photo is None or self._marked is None:
            return
        size = (self._rgb.shape[1], self._rgb.shape[0])
        work = functools.partial(
            fit_markers, self._marked, self._markers.px, size, self._photo.focal_px, self._fit
        )  # fmt: skip
        shared_latest().ask(self, "lay", work, functools.partial(self._take_fit, time.monotonic()), self.notice.tell)

    def _take_fit(self, asked_s: float, fit: Fit) -> None:
        if self._marked is not None and self._photo is not None:
            self._fit = fit
            self._show_live(asked_s)
            self._show_ready()

    def _show_markers(self) -> None:
        names = tuple(_called(at) for at in self._markers.at)
        count = len(names)
        sure, placed = np.ones(count), np.zeros(count, dtype=bool)
        self.view.set_points(ViewPoints(ViewId.FACE_FRONT, names, self._markers.px, sure, placed))

    def _tell_marker(self, name: str) -> None:
        """Say which marker is chosen, or what can be done."""
        usual = translate("studio", "Drag the markers. A double click on the clone adds one, Delete takes one away.")
        self.told.setText((point_label(name) if is_point(name) else usual) if name else usual)

    def _choose_next(self, way: int) -> None:
        names = [_called(at) for at in self._markers.at]
        if names:
            now = names.index(self.view.chosen) if self.view.chosen in names else -way
            self.view.choose(names[(now + way) % len(names)], close=True)

    # --- the statue ---------------------------------------------------------------------------

    def paint(self) -> None:
        """Paint what the photo does not show, and cut the clone from its material."""
        if self._photo is not None:
            material = str(self.material.currentData())
            photo = self._photo
            self.work(
                "paint_photo", photo.rgb, photo.focal_px, self._markers, self.onto(), material, then=self._take_painted
            )

    def _take_painted(self, clone: Clone) -> None:
        self.preview.show_fit(None, None, None)
        self.preview.update_clone(received(clone))

    def _show_live(self, asked_s: float = 0.0) -> None:
        """Show the photo itself where the markers lay it."""
        if self._fit is not None and self._photo is not None and self._marked is not None:
            self.preview.update_clone(self._photo.clone)
            self.preview.show_fit(self._marked.mesh, self._fit, self._rgb, asked_s)

    def save(self, wish: StatueWish) -> None:
        """Write the statue."""
        if self._path is not None:
            self.work("save_photo", self._path, self._markers, self.onto(), wish, then=self.tell_written)

    def _show_ready(self) -> None:
        for one in (self.photo_button, self.kind, self.subject):
            one.setEnabled(not self.busy)
        for one in (self.save_button, self.paint_button):
            one.setEnabled(not self.busy and self._fit is not None)


def _called(at: int | str) -> str:
    return at if isinstance(at, str) else f"{_VERTEX}{at}"


def _vertices(at: tuple[int | str, ...]) -> list[int]:
    known = known_points()
    return [one if isinstance(one, int) else known[one] for one in at]


def _marked(clone: Clone, vertices: NDArray[np.int32]) -> Marked:
    return mark(mesh_of(clone), vertices)
