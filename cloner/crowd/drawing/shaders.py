"""Shader sources, shared by the page and the offscreen renderer."""

from __future__ import annotations

import importlib.resources
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, Final

_LIT: Final = ("light", "shading")
#: Vertex and fragment parts of each program.
PARTS: Final[Mapping[str, tuple[tuple[str, ...], tuple[str, ...]]]] = MappingProxyType({
    "person": (("common", "person.vert"), ("common", *_LIT, "worn", "person.frag")),
    "bake": (("common", "person.vert"), ("common", *_LIT, "worn", "bake.frag")),
    "cast": (("common", "person.vert"), ("common", "cast.frag")),
    "impostor": (("common", "impostor.vert"), ("common", *_LIT, "impostor.frag")),
    "ground": (("common", "ground.vert"), ("light", "ground.frag")),
    "block": (("block.vert",), (*_LIT, "block.frag")),
    "room": (("room.vert",), ("light", "room.frag")),
    "sky": (("sky.vert",), ("light", "sky.frag")),
})  # fmt: skip
#: What shaders read of a room where there is none.
UNROOMED: Final[Mapping[str, Any]] = MappingProxyType({
    "roomed": 0, "sunLight": (0.0,) * 3, "skyLight": (0.0,) * 3, "groundColour": (0.0,) * 3, "daylight": (1.0,) * 3,
    "exposure": (1.0,) * 3, "shadowed": 0, "lantern": (0.0,) * 4, "lanternLight": (0.0,) * 3, "starry": 0.0,
    "stoneColour": (1.0,) * 3,
})  # fmt: skip


def shader_path(name: str) -> str:
    """Return the file of a shader part."""
    return name if "." in name else f"{name}.glsl"


def shader_source(names: Sequence[str]) -> str:
    """Return the text of shader parts, concatenated."""
    folder = importlib.resources.files("cloner.crowd") / "web"
    return "\n".join((folder / shader_path(name)).read_text(encoding="utf-8") for name in names)


def page_shaders() -> tuple[str, ...]:
    """Return the files of all parts that the page needs."""
    used = [part for key, pair in PARTS.items() if key != "bake" for part in pair]
    return tuple(sorted({shader_path(name) for part in used for name in part}))
