"""A clone with a photograph on it while its markers are dragged, and picking of points of its skin."""

from __future__ import annotations

import time
from dataclasses import dataclass

import cv2
import numpy as np
from PySide6.QtCore import QPointF, Signal
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QWidget

from cloner.generic.layers import Layer
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.meshes import Mesh
from cloner.render import draw
from cloner.statues.photo_fit import Fit
from cloner_gui.canvas.clones.preview import Preview
from cloner_gui.canvas.clones.scene import BACKGROUND, Image, Scene

#: The photo is shown on triangles that face its camera by this cosine at least; taste, as the texture's own rule.
_SQUARE = 0.15
_GREY = (0.78, 0.77, 0.75)
#: A place of the skin is picked within so many pixels.
_REACH_PX = 14.0


@dataclass(frozen=True, slots=True, eq=False)
class FittedPhotoScene(Scene):
    """A clone's skin with a photo on all that faces the photo's camera; the rest is grey.

    Attributes
    ----------
    mesh : Mesh or None
        None shows the clone as it is.
    fit : Fit or None
    photo : (H, W, 3) uint8 or None
        Read-only: it is taken to the painter once.
    """

    mesh: Mesh | None = None
    fit: Fit | None = None
    photo: Image | None = None

    def picture(self, width_px: int, height_px: int, *, fine: bool) -> Image:
        """Return the (H, W, 3) picture; ``fine`` smooths its edges."""
        mesh, fit, photo = self.mesh, self.fit, self.photo
        if mesh is None or fit is None or photo is None:
            return super(FittedPhotoScene, self).picture(width_px, height_px, fine=fine)
        places = fit.vertices_m
        normals = vertex_normals(places, mesh.triangles)
        towards = fit.camera.position_m - places
        towards /= np.maximum(np.linalg.norm(towards, axis=1, keepdims=True), 1e-9)
        shows = np.einsum("va,va->v", normals, towards) > _SQUARE
        uv = fit.uv_photo
        shows &= ((uv > 0.0) & (uv < 1.0)).all(axis=1)
        inside = shows[mesh.triangles].all(axis=1)
        layers = [
            Layer(places, normals, mesh.triangles[inside], uv, photo),
            Layer(places, normals, mesh.triangles[~inside], colour=_GREY),
        ]
        if fine:
            camera = self.orbit.camera(self.clone, width_px, height_px, np.zeros(3))
            return draw(layers, camera, shading="soft", background=BACKGROUND, supersample=2)
        # under a hand that drags: a quarter of the pixels cost a third of the time in software GL
        camera = self.orbit.camera(self.clone, (width_px + 1) // 2, (height_px + 1) // 2, np.zeros(3))
        coarse = draw(layers, camera, shading="soft", background=BACKGROUND, supersample=1)
        return np.asarray(cv2.resize(coarse, (width_px, height_px), interpolation=cv2.INTER_LINEAR), np.uint8)


class FittedPhotoPreview(Preview):
    """A preview of a clone under a photo; a double click picks a point of its skin."""

    picked = Signal(int)
    """A vertex of the clone."""
    laid = Signal(float)
    """A fit is on the screen; seconds since it was asked for."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._mesh: Mesh | None = None
        self._fit: Fit | None = None
        self._photo: Image | None = None
        self._since = 0.0
        self.drawn.connect(self._tell_laid)

    def show_fit(self, mesh: Mesh | None, fit: Fit | None, photo: Image | None, asked_s: float = 0.0) -> None:
        """Show a photo on the clone; None shows the clone as it is."""
        self._mesh, self._fit, self._photo, self._since = mesh, fit, photo, asked_s
        self.refresh()

    def scene(self) -> Scene | None:
        """Return what is seen now; None without a clone."""
        found = super().scene()
        if found is None or self._fit is None:
            return found
        return FittedPhotoScene(found.clone, found.orbit, mesh=self._mesh, fit=self._fit, photo=self._photo)

    def _tell_laid(self) -> None:
        if isinstance(self.shown, FittedPhotoScene) and self.shown.fit is self._fit and self._since:
            self.laid.emit(time.monotonic() - self._since)
            self._since = 0.0

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Pick the place of the skin under the hand."""
        vertex = self.vertex_at(event.position())
        if vertex is not None:
            self.picked.emit(vertex)

    def vertex_at(self, at: QPointF) -> int | None:
        """Return the vertex nearest to a place of the picture that faces whoever looks; None where there is none."""
        scene = self.scene()
        if scene is None or self._mesh is None or self._fit is None:
            return None
        camera = scene.orbit.camera(scene.clone, self.width(), self.height(), np.zeros(3))
        places = self._fit.vertices_m
        normals = vertex_normals(places, self._mesh.triangles)
        faces = np.einsum("va,va->v", normals, camera.position_m - places) > 0.0
        away = np.linalg.norm(camera.project(places) - (at.x(), at.y()), axis=1)
        away[~faces] = np.inf
        near = np.flatnonzero(away < _REACH_PX)
        if not len(near):
            return None
        # of those under the hand the one in front: an ear lies before the head behind it
        depth = np.linalg.norm(places[near] - camera.position_m, axis=1)
        front = near[depth < depth.min() + 0.01]
        return int(front[np.argmin(away[front])])
