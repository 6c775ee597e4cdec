"""Pictures of a clone through any camera, by OpenGL or in NumPy."""

from __future__ import annotations

import functools
import logging
import threading
from collections.abc import Sequence
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.generic.framing import standard_camera
from cloner.generic.gl_painter import Frame, Stage, new_context
from cloner.generic.layers import Layer, clone_layers, white_layers
from cloner.generic.painter import downsample_samples, paint
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.views import Camera

__all__ = [
    "Layer", "clone_layers", "coverage", "draw", "render", "render_mask", "render_mesh", "render_rgba", "require_gl",
    "standard_camera",
]  # fmt: skip

log = logging.getLogger(__name__)

Image = NDArray[np.uint8]
Shading = Literal["photo", "soft", "wire"]

#: Samples a pixel and axis; taste: edges as smooth as a camera's, 4x the work.
SUPERSAMPLE: Final = 2
#: Largest side GL can draw to on every driver that was tried, pixels.
LARGEST_SIDE_PX: Final = 8192
#: Lights of the soft shading in camera axes (x right, y up, z to the viewer) and strength; taste.
_LIGHTS: Final = (((-0.5, 0.6, 0.8), 1.7), ((0.8, 0.2, 0.6), 0.7), ((0.0, 0.7, -0.8), 0.6))
_AMBIENT: Final = 0.42  # taste: the shadow side keeps about half its colour


def render(
    clone: Clone,
    camera: Camera,
    rotations: Array | None = None,
    *,
    shading: Shading = "photo",
    background: tuple[int, int, int] = (255, 255, 255),
) -> Image:
    """Return the (H, W, 3) uint8 sRGB picture of a clone.

    Parameters
    ----------
    clone : Clone
    camera : Camera
    rotations : (94, 3) or None
        Rotation vectors of the joints, radians; None is the rest pose.
    shading, background
        As in :func:`draw`.
    """
    return draw(clone_layers(clone, rotations), camera, shading=shading, background=background)


def render_mask(clone: Clone, camera: Camera, rotations: Array | None = None) -> NDArray[np.bool_]:
    """Return the (H, W) pixels that body and hair cover by more than half."""
    return coverage(clone_layers(clone, rotations), camera) > 0.5


def render_rgba(clone: Clone, camera: Camera, rotations: Array | None = None, *, shading: Shading = "photo") -> Image:
    """Return the (H, W, 4) uint8 cut-out of a clone, alpha not multiplied in."""
    return draw_rgba(clone_layers(clone, rotations), camera, shading=shading)


def draw_rgba(
    layers: Sequence[Layer], camera: Camera, *, shading: Shading = "photo", supersample: int = SUPERSAMPLE
) -> Image:
    """Return the (H, W, 4) uint8 picture of meshes on a transparent background, alpha not premultiplied."""
    alpha = coverage(layers, camera, supersample=supersample)[..., None]
    dark = draw(layers, camera, shading=shading, background=(0, 0, 0), supersample=supersample)
    colour = dark / np.maximum(alpha, 1e-3)
    return np.concatenate([np.clip(colour, 0, 255), 255 * alpha], axis=2).round().astype(np.uint8)


def render_mesh(
    vertices_m: Array,
    triangles: NDArray[np.int32],
    camera: Camera,
    *,
    colour: tuple[float, float, float] = (0.72, 0.62, 0.56),
    shading: Shading = "soft",
    background: tuple[int, int, int] = (255, 255, 255),
) -> Image:
    """Return the (H, W, 3) picture of a plain mesh in one colour (sRGB 0..1)."""
    layer = Layer(vertices_m, vertex_normals(vertices_m, triangles), triangles, colour=colour)
    return draw([layer], camera, shading=shading, background=background)


def draw(
    layers: Sequence[Layer],
    camera: Camera,
    *,
    shading: Shading = "photo",
    background: tuple[int, int, int] = (255, 255, 255),
    supersample: int = SUPERSAMPLE,
) -> Image:
    """Return the (H, W, 3) uint8 sRGB picture of some meshes.

    Parameters
    ----------
    layers : sequence of Layer
        In any order; those with four channels are drawn last, back to front.
    camera : Camera
        Pixel (0, 0) is the centre of the top-left pixel, as everywhere.
    shading : "photo", "soft" or "wire"
        "photo" shows the texture as it is, to lay beside a photograph; "soft"
        adds a studio light that moves with the camera; "wire" shows the edges of
        the triangles that are seen.
    background : 3 ints, 0..255 sRGB
    supersample : int
        Samples a pixel and axis.

    Raises
    ------
    ClonerError
        If the picture is too large.

    Notes
    -----
    A machine without EGL draws with :func:`cloner.generic.painter.paint`: one
    sample a pixel, so edges are not smooth.
    """
    lights = _lights() if shading == "soft" else []
    if not has_gl():
        return paint(layers, camera, background=background, lights=lights, ambient=_ambient(shading))
    width, height = camera.width_px * supersample, camera.height_px * supersample
    if max(width, height) > LARGEST_SIDE_PX:
        raise ClonerError(
            "The picture is too large to draw", f"Keep it under {LARGEST_SIDE_PX // supersample} pixels", "render"
        )
    frame = Frame(camera, (width, height), background, lights, _ambient(shading), shading == "wire")
    return downsample_samples(_stage().picture(layers, frame), supersample)


def coverage(layers: Sequence[Layer], camera: Camera, *, supersample: int = SUPERSAMPLE) -> Array:
    """Return each pixel's share (H, W), 0..1, that the meshes cover; alpha counts as cover."""
    return draw(white_layers(layers), camera, background=(0, 0, 0), supersample=supersample)[..., 0] / 255.0


def require_gl() -> None:
    """Draw only by EGL; raise without it.

    Raises
    ------
    ClonerError
        If this machine has no EGL; the hint is the line that installs it.
    """
    _stage()


@functools.cache
def has_gl() -> bool:
    """Return whether EGL works here; logs it once if not."""
    try:
        require_gl()
    except ClonerError as error:
        log.warning("%s; pictures are drawn without it, their edges not smooth. %s", error.message, error.hint)
        return False
    return True


_local = threading.local()  # a GL context stays on the thread that made it


def _stage() -> Stage:
    """Return this thread's stage.

    Raises
    ------
    ClonerError
        If EGL gives no context.
    """
    stage: Stage | None = getattr(_local, "stage", None)
    if stage is None:
        stage = _local.stage = Stage(new_context())
    return stage


def _lights() -> list[tuple[Array, float]]:
    """Return unit directions towards the lights in our camera axes, and their strengths."""
    towards = [(np.array(direction) * (1.0, -1.0, -1.0), strength) for direction, strength in _LIGHTS]
    return [(direction / np.linalg.norm(direction), strength / np.pi) for direction, strength in towards]


def _ambient(shading: Shading) -> float:
    return _AMBIENT if shading == "soft" else 1.0
