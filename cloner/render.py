"""Pictures of a clone through any camera; only home of pyrender."""

from __future__ import annotations

import functools
import logging
import os
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.generic.framing import standard_camera
from cloner.generic.layers import Layer, clone_layers, whitened
from cloner.generic.painter import mean_of_samples, paint
from cloner.geometry.viewpoints import pose_along
from cloner.geometry.wedges import vertex_normals
from cloner.records.clones import Clone
from cloner.records.views import Camera

__all__ = [
    "Layer", "clone_layers", "coverage", "draw", "render", "render_mask", "render_mesh", "render_rgba", "require_gl",
    "standard_camera",
]  # fmt: skip

log = logging.getLogger(__name__)

Array = NDArray[np.float64]
Image = NDArray[np.uint8]
Shading = Literal["photo", "soft"]

#: Samples a pixel and axis; taste: edges as smooth as a camera's, 4x the work.
SUPERSAMPLE: Final = 2
#: The renderer's near plane, metres; nothing of a person comes nearer to a lens.
NEAR_M: Final = 0.05
FAR_M: Final = 100.0
#: Largest side GL can draw to on every driver that was tried, pixels.
LARGEST_SIDE_PX: Final = 8192
#: Textures left in the driver; an atlas of 2048 texels is 16 MB there. One clone has two to four.
KEPT_TEXTURES: Final = 6
#: Lights of the soft shading in camera axes (x right, y up, z to the viewer) and strength; taste.
_LIGHTS: Final = (((-0.5, 0.6, 0.8), 1.7), ((0.8, 0.2, 0.6), 0.7), ((0.0, 0.7, -0.8), 0.6))
_AMBIENT: Final = 0.42  # taste: the shadow side keeps about half its colour
#: GL's camera axes (y up, z backwards) from ours (y down, z forward).
_GL_FROM_CAMERA: Final = np.diag([1.0, -1.0, -1.0, 1.0])
_INSTALL: Final = "Install it with: sudo apt-get install -y libegl1 libgl1-mesa-dri libgles2"


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
    layers = clone_layers(clone, rotations)
    alpha = coverage(layers, camera)[..., None]
    colour = draw(layers, camera, shading=shading, background=(0, 0, 0)) / np.maximum(alpha, 1e-3)
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
    shading : "photo" or "soft"
        "photo" shows the texture as it is, to lay beside a photograph; "soft"
        adds a studio light that moves with the camera.
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
    ambient = _AMBIENT if shading == "soft" else 1.0
    if not has_gl():
        lights = [(np.array(direction) * (1, -1, -1), strength / np.pi) for direction, strength in _LIGHTS]
        return paint(layers, camera, background=background, lights=lights if shading == "soft" else (), ambient=ambient)
    pyrender = _pyrender()
    width, height = camera.width_px * supersample, camera.height_px * supersample
    if max(width, height) > LARGEST_SIDE_PX:
        raise ClonerError(
            "The picture is too large to draw", f"Keep it under {LARGEST_SIDE_PX // supersample} pixels", "render"
        )
    scene = pyrender.Scene(bg_color=[*(value / 255.0 for value in background), 1.0], ambient_light=[ambient] * 3)
    model_from_gl = np.linalg.inv(_GL_FROM_CAMERA @ camera.camera_from_model)
    # pyrender draws blended meshes by their nodes' distance: the farthest layer's node stands farthest away
    farthest_first = sorted(layers, key=lambda layer: -float(camera.to_camera(layer.vertices_m)[:, 2].mean()))
    for number, layer in enumerate(farthest_first):
        place = camera.position_m + (len(layers) - number) * camera.camera_from_model[2, :3]
        pose = np.eye(4)
        pose[:3, 3] = place
        scene.add(_mesh(pyrender, layer, camera, place), pose=pose)
    scene.add(_lens(pyrender, camera, supersample), pose=model_from_gl)
    flags = pyrender.RenderFlags.FLAT
    if shading == "soft":
        flags = pyrender.RenderFlags.NONE
        for direction, strength in _LIGHTS:
            pose = model_from_gl @ pose_along(-np.array(direction))
            scene.add(pyrender.DirectionalLight(color=np.ones(3), intensity=strength), pose=pose)
    with _renderer(width, height) as renderer:
        large, _ = renderer.render(scene, flags=flags)
    return mean_of_samples(large[..., :3], supersample)


def coverage(layers: Sequence[Layer], camera: Camera, *, supersample: int = SUPERSAMPLE) -> Array:
    """Return the (H, W) share 0..1 of every pixel that the meshes cover; alpha counts as cover."""
    return draw(whitened(layers), camera, background=(0, 0, 0), supersample=supersample)[..., 0] / 255.0


def _mesh(pyrender: Any, layer: Layer, camera: Camera, place: Array) -> Any:
    """Return the layer as a pyrender mesh around ``place``, its transparent triangles sorted back to front."""
    textured = layer.texture is not None and layer.uv is not None
    blended = textured and layer.texture is not None and layer.texture.shape[2] == 4
    texture = _texture(pyrender, layer.texture) if textured and layer.texture is not None else None
    material = pyrender.MetallicRoughnessMaterial(
        baseColorTexture=texture,
        # pyrender 0.1.45 never looks into a texture for alpha; a factor just below one makes it blend after the rest
        baseColorFactor=[*layer.colour, 0.9999 if blended else 1.0],
        metallicFactor=0.0,
        roughnessFactor=0.9,
        alphaMode="BLEND" if blended else "OPAQUE",
        doubleSided=layer.two_sided,
    )
    triangles = layer.triangles
    if blended:
        depth = camera.to_camera(layer.vertices_m)[:, 2]
        triangles = triangles[np.argsort(-depth[triangles].mean(axis=1), kind="stable")]
    # pyrender counts v upwards and we count it downwards
    uv = np.column_stack([layer.uv[:, 0], 1.0 - layer.uv[:, 1]]) if textured and layer.uv is not None else None
    primitive = pyrender.Primitive(
        positions=layer.vertices_m - place,
        normals=layer.normals,
        texcoord_0=uv,
        indices=triangles,
        material=material,
        mode=4,
    )
    return pyrender.Mesh([primitive])


def _texture(pyrender: Any, pixels: Image) -> Any:
    """Return a texture; those of read-only pixels stay in the driver for the next pictures.

    Sending an atlas of 2048 texels and making its mipmaps costs more than drawing the whole clone.
    """
    kept: dict[int, tuple[Image, Any]] = _local.__dict__.setdefault("textures", {})
    if id(pixels) in kept:
        return kept[id(pixels)][1]
    sampler = pyrender.Sampler(wrapS=10497, wrapT=10497, minFilter=9987, magFilter=9729)  # repeat, trilinear
    channels = "RGBA" if pixels.shape[2] == 4 else "RGB"
    if pixels.flags.writeable:
        return pyrender.Texture(source=pixels, source_channels=channels, sampler=sampler)
    texture = _kept_texture()(source=pixels, source_channels=channels, sampler=sampler)
    kept[id(pixels)] = (pixels, texture)  # the pixels too: their id must not be given away
    if len(kept) > KEPT_TEXTURES:
        _, oldest = kept.pop(next(iter(kept)))
        oldest.release()
    return texture


@functools.cache
def _kept_texture() -> Any:
    """Return a kind of texture that pyrender does not throw away after each picture."""
    pyrender = _pyrender()

    class KeptTexture(pyrender.Texture):  # type: ignore[misc,name-defined]
        def _add_to_context(self) -> None:
            if not self._in_context():
                super()._add_to_context()

        def delete(self) -> None:
            """Stay; :meth:`release` lets go."""

        def release(self) -> None:
            if self._in_context():
                super().delete()

    return KeptTexture


def _lens(pyrender: Any, camera: Camera, supersample: int) -> Any:
    """Return the pyrender camera; its principal point is the picture's middle, as ours is."""
    width, height = camera.width_px * supersample, camera.height_px * supersample
    if camera.pixels_per_m is not None:
        half = 0.5 / (camera.pixels_per_m * supersample)
        return pyrender.OrthographicCamera(xmag=width * half, ymag=height * half, znear=NEAR_M, zfar=FAR_M)
    focal = camera.focal_px * supersample
    return pyrender.IntrinsicsCamera(focal, focal, width / 2, height / 2, znear=NEAR_M, zfar=FAR_M)


def require_gl() -> None:
    """Draw nothing, but through EGL.

    Raises
    ------
    ClonerError
        If this machine has no EGL; the hint is the line that installs it.
    """
    with _renderer(16, 16):
        pass


@functools.cache
def has_gl() -> bool:
    """Return whether EGL works here; says so once in the log when it does not."""
    try:
        require_gl()
    except ClonerError as error:
        log.warning("%s; pictures are drawn without it, their edges not smooth. %s", error.message, error.hint)
        return False
    return True


_local = threading.local()  # a GL context stays on the thread that made it


@contextmanager
def _renderer(width: int, height: int) -> Iterator[Any]:
    """Give this thread's renderer at the wanted size."""
    renderer = getattr(_local, "renderer", None)
    if renderer is None:
        try:
            renderer = _pyrender().OffscreenRenderer(width, height)
        except Exception as error:  # PyOpenGL raises a dozen unrelated kinds for a missing driver
            raise ClonerError("This machine cannot draw: EGL gives no context", _INSTALL, "EGL") from error
        _local.renderer = renderer
    renderer.viewport_width, renderer.viewport_height = width, height
    yield renderer


def _pyrender() -> Any:
    """Return the pyrender module, repaired for NumPy 2.

    Raises
    ------
    ClonerError
        If the EGL library is missing.
    """
    os.environ.setdefault("PYOPENGL_PLATFORM", "egl")
    if not hasattr(np, "infty"):
        # pyrender 0.1.45 asks for the name that NumPy 2 dropped
        np.infty = np.inf  # type: ignore[attr-defined]  # noqa: NPY201
    try:
        import pyrender  # here, not above: it looks for a GL library while it is imported
    except Exception as error:  # ImportError, AttributeError or OSError, by driver
        raise ClonerError("This machine cannot draw: the EGL library is missing", _INSTALL, "EGL") from error
    return pyrender
