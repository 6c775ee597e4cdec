"""A clone in stone: one material, facial relief kept, still rigged."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.generic.charts import generic_atlas
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.charts.atlas import AtlasMap, map_atlas
from cloner.records.arrays import Array
from cloner.records.clones import Clone, TextureAtlas
from cloner.records.heads import Shell
from cloner.records.regions import REGIONS
from cloner.stages.textures import pad_charts
from cloner.statues.eyes import SIDES, carved_eyes, eye_light
from cloner.statues.materials import MATERIALS, Look
from cloner.statues.noise import MaterialBlock
from cloner.statues.relief import detail, hollows, outwards, raked

Pixels = NDArray[np.uint8]
Values = NDArray[np.float32]

#: What photographs showed darkens and hollows by so much, and slopes of the carving lighten by so much; taste.
SHOWN, SUNK, RAKED = 0.10, 0.15, 0.55
#: Hair is carved deeper than cloth.
LOCKS: Final = 1.8
#: What is left of the light inside a mouth.
INSIDE: Final = 0.3
#: Of a shell's texels, what is less opaque than this is cut away: stone is not sheer.
OPAQUE: Final = 128
#: Side of the map of shine, texels: patina is coarser than colour.
SHINE_PX: Final = 1024
#: Texels at once: keeps the memory near 100 MiB.
CHUNK: Final = 400_000
#: Any; every block of stone is another one, the same clone always of the same.
SEED: Final = 24


@dataclass(frozen=True, slots=True, eq=False)
class Charts:
    """A mesh with a texture: where its texels lie, and what they showed."""

    atlas: AtlasMap
    uv: Array
    uv_triangles: NDArray[np.int32]
    vertices_m: Array
    shown: Pixels


def statue_of(clone: Clone, material: str) -> Clone:
    """Return the clone, or statue, made of one material: skin, clothes, hair and eyes.

    Parameters
    ----------
    clone : Clone
    material : str
        One of `MATERIALS`.

    Raises
    ------
    ClonerError
        If the material is not known.
    """
    check_material(material)
    generic, block = load_generic(), MaterialBlock(SEED)
    triangles, uv_triangles = generic.triangles()
    size = len(clone.atlas.rgb)
    charts = Charts(
        generic_atlas(generic, size), np.asarray(generic.uv, np.float64), uv_triangles.astype(np.int32),
        clone.vertices_m, clone.atlas.rgb,
    )  # fmt: skip
    body = generic.skin
    hollow = np.where(body, hollows(clone.vertices_m, triangles.astype(np.int32)), 0.0)
    hollow[generic.region("mouth_interior")] = 1.0
    rgb, shine = _cut(block, material, charts, hollow, body.astype(np.float64), _light(generic, clone, charts.atlas))
    carved = clone if clone.atlas.shine.size else carved_eyes(generic, clone)  # a statue's eyes are drilled already
    covered = charts.atlas.covered()
    small = cv2.resize(pad_charts(shine, covered), (min(size, SHINE_PX),) * 2, interpolation=cv2.INTER_AREA)
    return replace(
        carved,
        atlas=TextureAtlas(pad_charts(rgb, covered), np.zeros_like(clone.atlas.coverage), small),
        shells=tuple(_cut_shell(block, material, shell) for shell in clone.shells if shell.kind != "frizz"),
        triangle_regions=np.full(len(triangles), REGIONS.index("skin"), np.uint8),  # nothing on it can be dyed
        stamp=f"{clone.stamp}, {material}"[:400],
    )


def check_material(material: str) -> None:
    """Raise a ClonerError if the material is not known."""
    if material not in MATERIALS:
        hint = f"Give --material one of {', '.join(MATERIALS)}"
        raise ClonerError(f"the material {material!r} is not known", hint, "--material")


def _cut(
    block: MaterialBlock, material: str, charts: Charts, hollow: Array, carved: Array, light: Values
) -> tuple[Pixels, Pixels]:
    """Return the (S, S, 3) texture and shine of a mesh cut from a block.

    Parameters
    ----------
    hollow, carved : (V,)
        How hollow the vertices lie, and how deep what was shown on them is carved, shares of the usual.
    light : (N,)
        What is left of the light at each texel.
    """
    atlas = charts.atlas
    size = len(charts.shown)
    height = detail(charts.shown, atlas.covered())
    depth = atlas.interpolate(carved)
    facing = RAKED * depth * raked(height, atlas, charts.uv, charts.uv_triangles, charts.vertices_m)
    shown = depth * height.ravel()[atlas.texel]
    rgb, shine = np.zeros((size * size, 3), np.uint8), np.zeros((size * size, 3), np.uint8)
    for start in range(0, len(atlas.texel), CHUNK):
        rows = np.arange(start, min(start + CHUNK, len(atlas.texel)))
        places = atlas.interpolate(charts.vertices_m, rows).astype(np.float64)
        deep = np.clip(atlas.interpolate(hollow, rows) - SUNK * shown[rows], -1.0, 1.0)
        look: Look = MATERIALS[material](block, places, deep)
        gain = (1.0 + SHOWN * shown[rows] + facing[rows]) * light[rows]
        rgb[atlas.texel[rows]] = np.clip(np.rint(look.rgb * gain[:, None]), 0, 255)
        shine[atlas.texel[rows], 1] = np.rint(255.0 * np.clip(look.rough, 0.04, 1.0))
        shine[atlas.texel[rows], 2] = np.rint(255.0 * np.clip(look.metal, 0.0, 1.0))
    return rgb.reshape(size, size, 3), shine.reshape(size, size, 3)


def _light(generic: GenericHuman, clone: Clone, atlas: AtlasMap) -> Values:
    """Return (N,) the share of light at each texel: dark pupils, dark inside the mouth."""
    light = np.ones(len(atlas.texel), np.float32)
    part = np.array(generic.part_names)[generic.vertex_part[atlas.triangles[:, 0]]]
    for side in SIDES:
        rows = atlas.rows_of(part == f"eye_{side}")
        places = atlas.interpolate(clone.vertices_m, rows).astype(np.float64)
        light[rows] = eye_light(generic, clone.vertices_m, side, places)
    light[atlas.rows_of(np.isin(part, ("teeth_upper", "teeth_lower", "tongue")))] = INSIDE
    return light


def _cut_shell(block: MaterialBlock, material: str, shell: Shell) -> Shell:
    """Return hair or cloth cut from the same block, without anything sheer."""
    shell = _squared(shell)
    size = len(shell.rgba)
    triangles = outwards(shell.vertices_m, shell.triangles)
    atlas = map_atlas(shell.uv, shell.triangles, shell.triangles, size)
    charts = Charts(atlas, shell.uv, shell.triangles, shell.vertices_m, np.ascontiguousarray(shell.rgba[..., :3]))
    deep = np.full(len(shell.vertices_m), LOCKS if shell.kind in ("hair", "beard") else 1.0)
    light = np.ones(len(atlas.texel), np.float32)
    rgb, _ = _cut(block, material, charts, hollows(shell.vertices_m, triangles), deep, light)
    alpha = np.where(shell.rgba[..., 3] >= OPAQUE, 255, 0).astype(np.uint8)
    return replace(shell, rgba=np.dstack([pad_charts(rgb, atlas.covered()), alpha]))


def _squared(shell: Shell) -> Shell:
    """Return a shell whose picture is square: glasses have a wide one, and atlases have one size."""
    height, width = shell.rgba.shape[:2]
    size = max(height, width)
    rgba = np.zeros((size, size, 4), np.uint8)
    rgba[:height, :width] = shell.rgba
    return replace(shell, rgba=rgba, uv=shell.uv * (width / size, height / size))
