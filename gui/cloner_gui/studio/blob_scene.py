"""Display and picking of a body's metaballs."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Signal
from PySide6.QtWidgets import QWidget

from cloner.generic.layers import Layer
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array
from cloner.render import draw
from cloner.statues.blobs import Blob, Field, field_of
from cloner_gui.canvas.clones.preview import Preview
from cloner_gui.canvas.clones.scene import BACKGROUND, Image, Scene

_COLOUR: Final = (0.62, 0.68, 0.76)
_CHOSEN: Final = (0.95, 0.55, 0.20)
#: Rings and sectors of a drawn blob; taste.
_RINGS, _SECTORS = 10, 16


@dataclass(frozen=True, slots=True, eq=False)
class BlobScene(Scene):
    """A clone's metaballs alone, one of them selected.

    Attributes
    ----------
    blobs : tuple of Blob
    chosen : int
        -1 for none.
    """

    blobs: tuple[Blob, ...] = ()
    chosen: int = -1

    def picture(self, width_px: int, height_px: int, *, fine: bool) -> Image:
        """Return the (H, W, 3) picture; ``fine`` smooths its edges."""
        field = field_of(self.blobs, self.clone.joints_m)
        layers = []
        for rows, colour in (
            ([row for row in range(len(self.blobs)) if row != self.chosen], _COLOUR),
            ([self.chosen] if self.chosen >= 0 else [], _CHOSEN),
        ):
            if rows:
                places, triangles = blob_meshes(field, rows)
                layers.append(Layer(places, vertex_normals(places, triangles), triangles, colour=colour))
        camera = self.orbit.camera(self.clone, width_px, height_px, np.zeros(3))
        return draw(layers, camera, shading="soft", background=BACKGROUND, supersample=2 if fine else 1)


def blob_meshes(field: Field, rows: Sequence[int]) -> tuple[Array, NDArray[np.int32]]:
    """Return one mesh (N, 3), (T, 3) of the surfaces of some metaballs, each by itself."""
    ball, faces = _ball()
    places, triangles = [], []
    for number, row in enumerate(rows):
        first, last, wide = field.first_m[row], field.last_m[row], field.wide[row]
        way = last - first
        length = float(np.linalg.norm(way))
        ahead = ball @ (way / length) > 0.0 if length > 1e-9 else np.zeros(len(ball), dtype=bool)
        radius = np.where(ahead, field.radius_m[row, 1], field.radius_m[row, 0])[:, None]
        places.append(np.where(ahead[:, None], last, first) + radius * wide * ball)
        triangles.append(faces + number * len(ball))
    return np.concatenate(places), np.concatenate(triangles).astype(np.int32)


@functools.cache
def _ball() -> tuple[Array, NDArray[np.int32]]:
    """Return a ball's places (N, 3), at distance one, and its triangles, outside counter-clockwise."""
    high = np.pi * np.arange(1, _RINGS) / _RINGS
    around = 2.0 * np.pi * np.arange(_SECTORS) / _SECTORS
    ring = np.stack(
        [
            np.outer(np.sin(high), np.sin(around)),
            np.repeat(np.cos(high)[:, None], _SECTORS, axis=1),
            np.outer(np.sin(high), np.cos(around)),
        ],
        axis=2,
    ).reshape(-1, 3)
    places = np.vstack([ring, [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]]])
    top, bottom, faces = len(ring), len(ring) + 1, []
    for sector in range(_SECTORS):
        after = (sector + 1) % _SECTORS
        faces += [(top, sector, after)]
        faces += [(bottom, (_RINGS - 2) * _SECTORS + after, (_RINGS - 2) * _SECTORS + sector)]
        for row in range(_RINGS - 2):
            a, b = row * _SECTORS + sector, row * _SECTORS + after
            c, d = a + _SECTORS, b + _SECTORS
            faces += [(a, c, b), (b, c, d)]
    return places, np.array(faces, np.int32)


class BlobPreview(Preview):
    """A preview of the metaballs or the skin on them; dragging the selected one moves it, dragging
    elsewhere rotates.
    """

    blob_chosen = Signal(int)
    blob_moved = Signal(int, object)
    """A blob and how far it was dragged in the picture's plane, (3,) metres."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.blobs: tuple[Blob, ...] = ()
        self.chosen, self.shows_blobs = -1, True
        self._drags = False

    def show_blobs(self, blobs: tuple[Blob, ...], chosen: int, *, shown: bool) -> None:
        """Show blobs, one of them chosen; or the skin."""
        self.blobs, self.chosen, self.shows_blobs = blobs, chosen, shown
        self.refresh()

    def scene(self) -> Scene | None:
        """Return what is seen now; None without a clone."""
        found = super().scene()
        if found is None or not self.shows_blobs or not self.blobs:
            return found
        return BlobScene(found.clone, found.orbit, blobs=self.blobs, chosen=self.chosen)

    def blob_at(self, at: QPointF) -> int | None:
        """Return the foremost blob under a place of the picture; None where there is none."""
        scene = self.scene()
        if not isinstance(scene, BlobScene):
            return None
        camera = scene.orbit.camera(scene.clone, self.width(), self.height(), np.zeros(3))
        field, under = field_of(self.blobs, scene.clone.joints_m), []
        for row in range(len(self.blobs)):
            places, _ = blob_meshes(field, [row])
            seen = camera.project(places)
            hull = cv2.convexHull(seen.astype(np.float32))
            if cv2.pointPolygonTest(hull, (at.x(), at.y()), False) >= 0.0:
                near = np.argsort(np.linalg.norm(seen - (at.x(), at.y()), axis=1))[:2]  # its front and its back
                under.append((float(np.linalg.norm(places[near] - camera.position_m, axis=1).min()), row))
        return min(under)[1] if under else None

    def take_hold(self, at: QPointF, *, finger: bool = False) -> None:
        """Take hold of the blob under the hand, else of the whole body."""
        row = None if self._pans else self.blob_at(at)
        if row is not None and row != self.chosen:
            self.blob_chosen.emit(row)
        self._drags = row is not None
        super().take_hold(at, finger=finger)

    def drag(self, to: QPointF) -> None:
        """Move the chosen blob, else turn the body."""
        scene = self.scene()
        if not self._drags or self._held is None or not isinstance(scene, BlobScene):
            super().drag(to)
            return
        way, self._held = to - self._held, to
        camera = scene.orbit.camera(scene.clone, self.width(), self.height(), np.zeros(3))
        field = field_of(self.blobs, scene.clone.joints_m)
        middle = (field.first_m[self.chosen] + field.last_m[self.chosen]) / 2.0
        there = camera.project(middle[None]) + (way.x(), way.y())
        self.blob_moved.emit(self.chosen, camera.back_project(there, middle[None])[0] - middle)

    def let_go(self) -> None:
        """Hold nothing any more."""
        self._drags = False
        super().let_go()


def move_blob(blob: Blob, by_m: Array) -> Blob:
    """Return a metaball with both its ends moved by (3,) metres."""
    ends = tuple(tuple(float(value) for value in np.asarray(off) + by_m) for off in blob.off_m)
    return replace(blob, off_m=ends)  # type: ignore[arg-type]  # three each
