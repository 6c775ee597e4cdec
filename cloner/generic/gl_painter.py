"""Offscreen OpenGL renderer; the only module that uses moderngl. ``cloner.generic.painter`` is its twin in NumPy."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import moderngl
import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.generic.layers import Layer
from cloner.records.arrays import Array
from cloner.records.views import Camera

Image = NDArray[np.uint8]

#: The renderer's near plane, metres; nothing of a person comes nearer to a lens.
NEAR_M: Final = 0.05
FAR_M: Final = 100.0
#: Textures left in the driver; an atlas of 2048 texels is 16 MB there. One clone has two to four.
KEPT_TEXTURES: Final = 6
#: Alphas, from and below: texels that hide what lies behind them, and those that let it through.
HIDES, BLENDS = (0.9, 2.0), (0.004, 0.9)
#: Lights that the shader takes.
LIGHTS: Final = 3
#: Colours of the wire mesh's faces and edges, 0..1; taste.
_WIRE_FACE: Final = (0.93, 0.93, 0.94)
_WIRE_EDGE: Final = (0.12, 0.22, 0.42)
#: The libraries by the names that run-time packages give them.
_EGL: Final[Any] = {"backend": "egl", "libgl": "libGL.so.1", "libegl": "libEGL.so.1"}
INSTALL: Final = "Install it with: sudo apt-get install -y libegl1 libgl1 libgl1-mesa-dri"
_VERTEX: Final = """
uniform mat4 clip_from_model;
in vec3 place; in vec2 uv;
out vec2 at;
#ifndef PLAIN
uniform mat3 camera_from_model;
in vec3 normal;
out vec3 towards;
#endif
void main() {
    gl_Position = clip_from_model * vec4(place, 1.0);
#ifndef PLAIN
    towards = camera_from_model * normal;
#endif
    at = uv;
}"""
#: As ``cloner.generic.painter`` shades: light adds up in linear colour, two-sided faces take it from both sides.
_FRAGMENT: Final = """
uniform sampler2D picture;
uniform bool textured; uniform bool white;
uniform vec3 colour; uniform vec2 alphas;
in vec2 at;
out vec4 shown;
#ifndef PLAIN
uniform bool two_sided; uniform float ambient; uniform vec4 lights[3];
in vec3 towards;
#endif
void main() {
    vec4 texel = textured ? texture(picture, at) : vec4(colour, 1.0);
    if (texel.a < alphas.x || texel.a >= alphas.y) discard;
    if (white) texel.rgb = vec3(1.0);
#ifdef PLAIN
    shown = texel;
#else
    float light = ambient;
    vec3 n = normalize(towards);
    for (int k = 0; k < 3; k++) {
        float facing = dot(n, lights[k].xyz);
        light += lights[k].w * max(two_sided ? abs(facing) : facing, 0.0);
    }
    vec3 lit = light == 1.0 ? texel.rgb : pow(clip_(pow(texel.rgb, vec3(2.2)) * light), vec3(1.0 / 2.2));
    shown = vec4(lit, texel.a);
#endif
}""".replace("clip_(", "min(vec3(1.0), ")


@dataclass(frozen=True, slots=True, eq=False)
class Frame:
    """How a picture is drawn.

    Attributes
    ----------
    camera : Camera
    size_px : (width, height), a multiple of the camera's
    background : 3 ints, 0..255 sRGB
    lights : sequence of (direction (3,) towards the light in camera axes, strength), at most ``LIGHTS``
    ambient : float
        Share of the texture that shows without any light.
    wire : bool
        Only the edges of the triangles that are seen.
    """

    camera: Camera
    size_px: tuple[int, int]
    background: tuple[int, int, int]
    lights: Sequence[tuple[Array, float]]
    ambient: float
    wire: bool

    @property
    def plain(self) -> bool:
        """Whether everything shows in its own colour."""
        return self.ambient == 1.0 and not self.lights


def new_context() -> moderngl.Context:
    """Return a context that draws without a screen, on this thread.

    Raises
    ------
    ClonerError
        If EGL gives none; the hint is the line that installs it.
    """
    try:
        return moderngl.create_context(require=330, standalone=True, **_EGL)
    except Exception as error:  # glcontext raises bare Exceptions for a missing library or driver
        raise ClonerError("This machine cannot draw: EGL gives no context", INSTALL, "EGL") from error


class Stage:
    """One thread's GL context with its shader, the last picture's buffers, and textures that come again."""

    def __init__(self, context: moderngl.Context) -> None:
        self._gl = context
        self._programs: dict[bool, Any] = {}
        self._target: Any = None
        self._textures: dict[int, tuple[Image, Any]] = {}

    def picture(self, layers: Sequence[Layer], frame: Frame) -> Image:
        """Return the (H, W, 3) uint8 sRGB picture of some meshes."""
        width, height = frame.size_px
        with self._gl:
            self._begin(frame)
            blended = sorted(filter(_blends, layers), key=lambda each: -_depth_m(each, frame.camera))
            # what covers hides, in whatever order; then soft edges are laid over it, the farthest mesh first
            for layer in (*(layer for layer in layers if not _blends(layer)), *blended):
                self._draw(layer, frame, HIDES)
            self._target.depth_mask = False
            for layer in blended:
                self._draw(layer, frame, BLENDS)
            self._target.depth_mask = True
            pixels = self._target.read(components=3, alignment=1)
        return np.frombuffer(pixels, np.uint8).reshape(height, width, 3)

    def _begin(self, frame: Frame) -> None:
        gl, program, camera = self._gl, self._program_of(frame), frame.camera
        if self._target is None or self._target.size != frame.size_px:
            self._forget_target()
            self._target = gl.framebuffer([gl.renderbuffer(frame.size_px)], gl.depth_renderbuffer(frame.size_px))
        self._target.use()
        self._target.clear(*(value / 255.0 for value in frame.background), 1.0)
        gl.enable_only(moderngl.DEPTH_TEST | moderngl.BLEND)
        # pictures are drawn top row first, so what faces us turns the other way round
        gl.front_face, gl.depth_func = "cw", "<="
        program["clip_from_model"].write(_column_major(_lens(camera) @ camera.camera_from_model))
        if not frame.plain:
            program["camera_from_model"].write(_column_major(camera.camera_from_model[:3, :3]))
            program["ambient"].value = frame.ambient
            lights = [(*direction, strength) for direction, strength in frame.lights]
            program["lights"].value = [*lights, *[(0.0, 0.0, 1.0, 0.0)] * LIGHTS][:LIGHTS]

    def _program_of(self, frame: Frame) -> Any:
        """Return the shader for a picture: one without light is drawn in half the time by one that knows no light."""
        if frame.plain not in self._programs:
            vertex, fragment = (f"#version 330\n{'#define PLAIN' * frame.plain}{text}" for text in (_VERTEX, _FRAGMENT))
            self._programs[frame.plain] = self._gl.program(vertex_shader=vertex, fragment_shader=fragment)
        return self._programs[frame.plain]

    def _forget_target(self) -> None:
        if self._target is not None:
            for part in (*self._target.color_attachments, self._target.depth_attachment, self._target):
                part.release()

    def _draw(self, layer: Layer, frame: Frame, alphas: tuple[float, float]) -> None:
        gl, program = self._gl, self._program_of(frame)
        uv = np.zeros((len(layer.vertices_m), 2)) if layer.uv is None else layer.uv
        corners = gl.buffer(np.hstack([layer.vertices_m, layer.normals, uv]).astype(np.float32).tobytes())
        triangles = _back_to_front(layer, frame.camera) if _blends(layer) else layer.triangles
        indices = gl.buffer(np.ascontiguousarray(triangles, dtype=np.int32).tobytes())
        parts = ("3f 3x4 2f", "place", "uv") if frame.plain else ("3f 3f 2f", "place", "normal", "uv")
        mesh = gl.vertex_array(program, [(corners, *parts)], indices)
        textured = layer.texture is not None and layer.uv is not None and not frame.wire
        program["textured"].value = textured
        if not frame.plain:
            program["two_sided"].value = layer.two_sided
        program["white"].value, program["alphas"].value = layer.white, alphas
        program["colour"].value = _WIRE_FACE if frame.wire else layer.colour
        texture = self._texture(layer.texture) if textured and layer.texture is not None else None
        (gl.disable if layer.two_sided else gl.enable)(moderngl.CULL_FACE)
        if texture is not None:
            texture.use(0)
        gl.polygon_offset = (1.0, 1.0) if frame.wire else (0.0, 0.0)  # faces stay behind their own edges
        mesh.render()
        if frame.wire:
            gl.polygon_offset, gl.wireframe = (0.0, 0.0), True
            program["colour"].value = _WIRE_EDGE
            mesh.render()
            gl.wireframe = False
        for part in (mesh, corners, indices):
            part.release()
        if texture is not None and layer.texture is not None and layer.texture.flags.writeable:
            texture.release()

    def _texture(self, pixels: Image) -> Any:
        """Return a texture; those of read-only pixels stay in the driver for the next pictures.

        Sending an atlas of 2048 texels and making its mipmaps costs more than drawing the whole clone.
        """
        if id(pixels) in self._textures:
            return self._textures[id(pixels)][1]
        texture = self._gl.texture(pixels.shape[1::-1], pixels.shape[2], np.ascontiguousarray(pixels))
        texture.build_mipmaps()
        if pixels.flags.writeable:
            return texture
        self._textures[id(pixels)] = (pixels, texture)  # the pixels too: their id must not be given away
        if len(self._textures) > KEPT_TEXTURES:
            self._textures.pop(next(iter(self._textures)))[1].release()
        return texture


def _blends(layer: Layer) -> bool:
    return layer.texture is not None and layer.texture.shape[2] == 4


def _depth_m(layer: Layer, camera: Camera) -> float:
    return float(camera.to_camera(layer.vertices_m)[:, 2].mean())


def _back_to_front(layer: Layer, camera: Camera) -> NDArray[np.int32]:
    depth = camera.to_camera(layer.vertices_m)[:, 2]
    return layer.triangles[np.argsort(-depth[layer.triangles].mean(axis=1), kind="stable")]


def _lens(camera: Camera) -> Array:
    """Return the (4, 4) clip space from camera axes; the principal point is the picture's middle, as ours is."""
    width, height, reach = camera.width_px, camera.height_px, FAR_M - NEAR_M
    if camera.pixels_per_m is not None:
        scale = 2.0 * camera.pixels_per_m
        return np.array(
            [
                [scale / width, 0, 0, 0],
                [0, scale / height, 0, 0],
                [0, 0, 2.0 / reach, -(FAR_M + NEAR_M) / reach],
                [0, 0, 0, 1.0],
            ]
        )
    scale = 2.0 * camera.focal_px
    return np.array(
        [
            [scale / width, 0, 0, 0],
            [0, scale / height, 0, 0],
            [0, 0, (FAR_M + NEAR_M) / reach, -2.0 * FAR_M * NEAR_M / reach],
            [0, 0, 1.0, 0],
        ]
    )


def _column_major(matrix: Array) -> bytes:
    return np.ascontiguousarray(matrix.T, dtype=np.float32).tobytes()
