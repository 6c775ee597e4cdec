"""Offscreen rendering of the crowd with the player's own shaders: geometry of any level, impostors, and their tiles."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.crowd.clones import stock
from cloner.crowd.clones.faces import face_rows
from cloner.crowd.clones.groups import STEP
from cloner.crowd.drawing.shaders import PARTS, UNROOMED, shader_source
from cloner.generic.gl_painter import new_context

Pixels = NDArray[np.uint8]

HEADER: Final = "#version 330\n"
#: Depth that 8 bits of an impostor stand for, metres: a stride with swinging arms.
DEPTH_RANGE_M: Final = 1.4
SUN: Final = (0.45, 0.75, 0.48)
#: The level whose shadow people cast: its outline is within a texel of the shadow's map.
CAST_LEVEL: Final = 2
_UNITS: Final = ("people", "clones", "vertices", "loose", "corners", "bones", "atlases", "shells", "tiles", "colours",
                 "shapes", "glow", "roomLooks", "roomLight", "roomSun", "shadows", "stones", "stoneShells", "faces",
                 "faceRows", "feels")  # fmt: skip


class CrowdRenderer:
    """One GL context with the textures of a stock and of the people in the scene."""

    def __init__(self, held: stock.CrowdArrays) -> None:
        self.stock = held
        self._gl: Any = new_context()
        self._programs = {name: self._program(*parts) for name, parts in PARTS.items()}
        self._textures: dict[str, Any] = {}
        self._levels: dict[tuple[str, int], tuple[Any, ...]] = {}
        self._instances = self._gl.buffer(reserve=8)
        self._targets: dict[tuple[int, int, int, int], Any] = {}
        self._send()

    def close(self) -> None:
        """Release the context."""
        self._gl.release()

    def _program(self, vertex: Sequence[str], fragment: Sequence[str]) -> Any:
        sources = [HEADER + shader_source(parts) for parts in (vertex, fragment)]
        return self._gl.program(vertex_shader=sources[0], fragment_shader=sources[1])

    def _send(self) -> None:
        held, wide = self.stock, stock.WIDE
        vertices = [stock.rows_of_texels(n.vertices, wide) for n in held.numbers]
        self._array("vertices", stock.stack_padded(vertices), "u2")
        nothing = np.zeros((2, 4), np.uint16)
        loose = [stock.rows_of_texels(n.loose if len(n.loose) else nothing, 2 * wide) for n in held.numbers]
        self._array("loose", stock.stack_padded(loose), "u2")
        corners = [stock.rows_of_texels(n.corners, stock.CORNERS_WIDE) for n in held.numbers]
        self._array("corners", stock.stack_padded(corners)[..., None], "u2")
        joints = max(n.bones.shape[1] for n in held.numbers)  # who wears simulated cloth has more
        rows = [np.pad(n.bones, ((0, 0), (0, joints - n.bones.shape[1]), (0, 0), (0, 0))) for n in held.numbers]
        self._flat("bones", (bones := np.concatenate(rows)).reshape(len(bones), -1, 4), "i2")
        self._flat("clones", held.table, "f4")
        self._array("atlases", held.atlases, "f1", mips=4)
        self._array("shells", held.shells, "f1", mips=4)
        none = np.zeros((len(held.table), 1, 1, 3), np.uint8)
        self._array("stones", none if held.stones is None else held.stones, "f1", mips=4)
        self._array("stoneShells", none if held.stone_shells is None else held.stone_shells, "f1", mips=4)
        faces = np.zeros((1, 1, 1, 3), np.int16) if held.faces is None else held.faces
        self._array("faces", moves := np.stack([stock.face_texels(one) for one in faces]), "i2")
        self._face_high = moves.shape[1] // faces.shape[1]
        self._flat("faceRows", stock.rows_of_texels(face_rows(held.body), wide)[..., None], "u2")
        self.send_tiles()

    def send_tiles(self) -> None:
        """Upload the impostors' pages, if the stock has any."""
        held = self.stock
        if held.tiles is None or held.colours is None or held.shapes is None:
            return
        self._flat("tiles", held.tiles, "f4")
        self._array("colours", held.colours, "f1", mips=2)
        self._array("shapes", held.shapes, "f1")

    def send_people(self, people: NDArray[np.float32]) -> None:
        """Upload (N, 5, 4) rows of people; see ``common.glsl``."""
        self._flat("people", (rows := stock.rows_of_texels(people, 256)).reshape(len(rows), -1, 4), "f4")

    def send_glow(self, glow: NDArray[np.float32]) -> None:
        """Upload (N, 4, 4) light of people; see ``shading.glsl``."""
        self._flat("glow", (rows := stock.rows_of_texels(glow, 256)).reshape(len(rows), -1, 4), "f4")

    def send_feels(self, feels: NDArray[np.float32]) -> None:
        """Upload (N, 2) feelings of people: which (0: none) and how strongly."""
        self._flat("feels", stock.rows_of_texels(feels, 256), "f4")

    def send_room(self, looks: Pixels, light: Pixels, sun: Pixels) -> None:
        """Upload a room's textures, stacked, its light map, (H, W, 3) each, and the sun's share (H, W)."""
        side = looks.shape[1]
        self._array("roomLooks", looks.reshape(-1, side, side, 3), "f1", mips=6)
        self._textures["roomLooks"].repeat_x = self._textures["roomLooks"].repeat_y = True
        self._flat("roomLight", light, "f1")
        self._flat("roomSun", sun[..., None], "f1")
        for name in ("roomLight", "roomSun"):
            self._textures[name].filter = (self._gl.LINEAR, self._gl.LINEAR)

    def draw_room(self, corners: NDArray[np.float32], values: Mapping[str, Any]) -> None:
        """Draw triangles given as (3 T, 8) corners: position, uv, light-map uv, look; front faces only."""
        self.uniforms("room", values)
        buffer = self._gl.buffer(np.ascontiguousarray(corners, np.float32).tobytes())
        names = ("position", "uv", "lightUv", "look")
        room = self._gl.vertex_array(self._programs["room"], [(buffer, "3f 2f 2f 1f", *names)])
        self._gl.enable(self._gl.CULL_FACE)
        room.render()
        self._gl.disable(self._gl.CULL_FACE)
        room.release()
        buffer.release()

    def _flat(self, name: str, values: NDArray[Any], dtype: str) -> None:
        self._drop(name)
        values = np.ascontiguousarray(values)
        texture = self._gl.texture(values.shape[1::-1], values.shape[2], values.tobytes(), dtype=dtype, alignment=1)
        texture.filter = (self._gl.NEAREST, self._gl.NEAREST)
        self._textures[name] = texture

    def _array(self, name: str, values: NDArray[Any], dtype: str, mips: int | None = None) -> None:
        self._drop(name)
        layers, height, width, parts = values.shape
        data = np.ascontiguousarray(values).tobytes()
        texture = self._gl.texture_array((width, height, layers), parts, data, dtype=dtype, alignment=1)
        if dtype == "f1":
            texture.repeat_x = texture.repeat_y = False
            texture.filter = (self._gl.LINEAR, self._gl.LINEAR)
            if mips:
                texture.build_mipmaps(0, mips)
                texture.filter = (self._gl.LINEAR_MIPMAP_LINEAR, self._gl.LINEAR)
        else:
            texture.filter = (self._gl.NEAREST, self._gl.NEAREST)
        self._textures[name] = texture

    def _drop(self, name: str) -> None:
        if name in self._textures:
            self._textures.pop(name).release()

    def level(self, level: int, program: str = "person") -> Any:
        """Return the vertex array of a level with the current instances."""
        key = (program, level)
        if key not in self._levels:
            arrays = stock.level_arrays(self.stock.body, level, self.stock.budgets)
            packed = np.column_stack([arrays["which"], arrays["uv"], arrays["joints"], arrays["weights"]])
            buffer = self._gl.buffer(np.ascontiguousarray(packed, np.float32).tobytes())
            index = self._gl.buffer(arrays["index"].tobytes())
            self._levels[key] = (buffer, index)
        buffer, index = self._levels[key]
        return self._gl.vertex_array(
            self._programs[program],
            [
                (buffer, "1f 2f 4f 4f", "which", "uv", "joints", "weights"),
                (self._instances, "2f/i", "instance"),
            ],
            index,
        )

    def uniforms(self, program: str, values: Mapping[str, Any]) -> None:
        """Set a program's uniforms, textures included, those that it has."""
        own = self._programs[program]
        fixed = {
            "bodyVertices": len(self.stock.body.vertex), "boxMin": stock.BOX_MIN_M, "boxStep": stock.BOX_STEP_M,
            "boneReach": stock.BONE_REACH_M, "codeStep": float(STEP), "depthRange": DEPTH_RANGE_M,
            "rings": len(self.stock.elevations), "sunWay": _unit(SUN), "debugView": 0,
            "ringElevations": (*self.stock.elevations, 0.0, 0.0, 0.0)[:4], "classic": 0, "dearFromPx": 24.0,
            "bakedFrom": stock.BAKED_FROM_M, "rim": 0, "now": 0.0, "coarse": 0, "laneLength": 100.0,
            "faced": 0, "speakers": 0, "faceHigh": self._face_high,
            **UNROOMED,
        }  # fmt: skip
        for name, value in {**fixed, **values}.items():
            if name in own:
                if isinstance(value, np.ndarray) and value.shape == (4, 4):
                    own[name].write(np.ascontiguousarray(value.T, np.float32).tobytes())
                else:
                    own[name].value = tuple(value) if isinstance(value, np.ndarray) else value
        for unit, name in enumerate(_UNITS):
            if name in own and name in self._textures:
                self._textures[name].use(unit)
                own[name].value = unit

    def target(self, size_px: tuple[int, int], colours: int = 1, samples: int = 0) -> Any:
        """Return a framebuffer; it is reused for the next picture of its kind."""
        key = (*size_px, colours, samples)
        if key not in self._targets:
            layers = [self._gl.renderbuffer(size_px, 4, samples=samples) for _ in range(colours)]
            depth = self._gl.depth_renderbuffer(size_px, samples=samples)
            self._targets[key] = self._gl.framebuffer(layers, depth)
        return self._targets[key]

    def begin(self, target: Any, background: Sequence[float]) -> None:
        """Clear a target and draw to it from now on."""
        target.use()
        target.clear(*background)
        self._gl.enable_only(self._gl.DEPTH_TEST)

    def viewport(self, box: tuple[int, int, int, int]) -> None:
        """Draw into a part of the target only."""
        self._gl.viewport = box

    def draw_people(
        self, level: int, instances: NDArray[np.float32], values: Mapping[str, Any], program: str = "person"
    ) -> None:
        """Draw (N, 2) instances (who, fade) as geometry of a level."""
        if not len(instances):
            return
        self._place(instances)
        starts = np.cumsum([0, *(3 * budget for budget in self.stock.budgets)])
        self.uniforms(program, {"looseStart": int(starts[level]), **values})
        mesh = self.level(level, program)
        self._gl.enable(self._gl.CULL_FACE)
        mesh.render(instances=len(instances))
        self._gl.disable(self._gl.CULL_FACE)
        mesh.release()

    def draw_impostors(self, instances: NDArray[np.float32], values: Mapping[str, Any]) -> None:
        """Draw (N, 2) instances (who, fade) as impostors: opaque pixels first, then all soft edges over them."""
        if not len(instances):
            return
        self._quads("impostor", instances, values)
        self._gl.enable(self._gl.BLEND)
        self._gl.fbo.depth_mask, self._gl.depth_func = False, "<"
        self._quads("impostor", instances, {**values, "rim": 1})
        self._gl.fbo.depth_mask, self._gl.depth_func = True, "<="
        self._gl.disable(self._gl.BLEND)

    def draw_ground(self, instances: NDArray[np.float32], values: Mapping[str, Any]) -> None:
        """Draw the floor and a soft shadow under each of (N, 2) instances."""
        self._quads("ground", np.array([[-1.0, 1.0]], np.float32), values)
        self._gl.enable(self._gl.BLEND)
        self._gl.fbo.depth_mask = False
        self._quads("ground", instances, values)
        self._gl.fbo.depth_mask = True
        self._gl.disable(self._gl.BLEND)

    def draw_sky(self, values: Mapping[str, Any]) -> None:
        """Draw the sky behind everything."""
        self.uniforms("sky", values)
        corner = self._gl.buffer(np.array([[0, 0], [1, 0], [0, 1], [1, 1]], np.float32).tobytes())
        quad = self._gl.vertex_array(self._programs["sky"], [(corner, "2f", "corner")])
        quad.render(self._gl.TRIANGLE_STRIP)
        quad.release()
        corner.release()

    def cast(self, who: NDArray[np.float32], values: Mapping[str, Any], size_px: int) -> None:
        """Draw the shadow map of (N, 2) instances; ``clipFromWorld`` is the sun's."""
        if "shadows" not in self._textures:
            self._textures["shadows"] = self._gl.depth_texture((size_px, size_px))
            self._textures["shadows"].compare_func = ""
            self._textures["shadows"].filter = (self._gl.NEAREST, self._gl.NEAREST)
            self._sun = self._gl.framebuffer(depth_attachment=self._textures["shadows"])
        self._sun.use()
        self._sun.clear()
        self._gl.enable_only(self._gl.DEPTH_TEST)
        self.draw_people(CAST_LEVEL, who, values, "cast")

    def draw_blocks(self, corners: NDArray[np.float32], values: Mapping[str, Any]) -> None:
        """Draw triangles given as (3 T, 6) corners and normals."""
        if not len(corners):
            return
        self.uniforms("block", values)
        buffer = self._gl.buffer(np.ascontiguousarray(corners, np.float32).tobytes())
        blocks = self._gl.vertex_array(self._programs["block"], [(buffer, "3f 3f", "position", "normal")])
        blocks.render()
        blocks.release()
        buffer.release()

    def _quads(self, program: str, instances: NDArray[np.float32], values: Mapping[str, Any]) -> None:
        self._place(instances)
        self.uniforms(program, values)
        corner = self._gl.buffer(np.array([[0, 0], [1, 0], [0, 1], [1, 1]], np.float32).tobytes())
        quads = self._gl.vertex_array(
            self._programs[program], [(corner, "2f", "corner"), (self._instances, "2f/i", "instance")]
        )
        quads.render(self._gl.TRIANGLE_STRIP, instances=len(instances))
        quads.release()
        corner.release()

    def _place(self, instances: NDArray[np.float32]) -> None:
        data = np.ascontiguousarray(instances, np.float32).tobytes()
        self._instances.orphan(max(len(data), 8))
        self._instances.write(data)

    def read(self, target: Any, attachment: int = 0) -> Pixels:
        """Return the (H, W, 4) pixels of a target, top row first; several samples are resolved."""
        width, height = target.size
        if target.samples:
            plain = self.target((width, height))
            self._gl.copy_framebuffer(plain, target)
            target = plain
        data = target.read(components=4, attachment=attachment, alignment=1)
        return np.frombuffer(data, np.uint8).reshape(height, width, 4)[::-1]


def _unit(vector: Sequence[float]) -> tuple[float, ...]:
    return tuple(np.array(vector) / np.linalg.norm(vector))
