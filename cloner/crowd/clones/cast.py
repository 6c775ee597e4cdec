"""A clone prepared for the crowd: meshes at every level of detail, bone frames, a small atlas with codes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.crowd.clones.clips import Clip, make_clips
from cloner.crowd.clones.faces import face_offsets
from cloner.crowd.clones.flowing import skin_simulated_cloth
from cloner.crowd.clones.groups import (
    GROUPS,
    STEP,
    GroupLook,
    garment_masks,
    group_looks,
    reduced,
    shader_codes,
    texel_groups,
    triangle_groups,
)
from cloner.crowd.clones.hems import refine_hems
from cloner.crowd.clones.levels import LOOSE, BodyLevels, LooseShells, shell_levels
from cloner.generic.surfaces import surface_normals
from cloner.geometry.meshes.wedges import welded_normals
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.flows import Flow
from cloner.records.heads import Shell

Pixels = NDArray[np.uint8]

ATLAS_PX: Final = 512  # taste: 330 texels a metre, a screen pixel at 2.6 m through a 50 degree lens of 720 lines
SHELL_PX: Final = 192  # hair's density is then that of the body's
#: Shells that have a half of the picture; beards and glasses would be painted with hair, so walkers have them as paint.
DRAWN: Final = ("hair", "cloth")
#: Poses of a walk in which loose shells' coarse levels must look well.
STRIDES: Final = 4
#: Distance of colours, 0..255 a channel, from which a skirt that covers all below it is no part of the top; taste.
UNLIKE: Final = 25.0
#: Skin that cloth always covers lies so much deeper, metres: bones move cloth by some millimetres otherwise.
SUNK_M: Final = 0.02
#: Heights from the chest's middle count as chest, share of the stature either way; taste.
CHEST: Final = (0.68, 0.80)


@dataclass(frozen=True, slots=True, eq=False)
class CrowdClone:
    """A clone prepared for the crowd.

    Attributes
    ----------
    identifier : str
    stature_m : float
    vertices_m, normals : (V, 3) float64 of the wedges of :class:`BodyLevels`, rest pose
    loose : LooseShells
    clips : tuple of Clip
    atlas : (A, A, 3) uint8, codes : (A, A) uint8
    marks : (A, A) uint8
        The codes as shaders read them.
    shell : (B, 2 B, 4) uint8
        Hair in the left half, cloth in the right one.
    looks : mapping of str to GroupLook
    groups : (T,) uint8, place in ``GROUPS`` of the generic triangles
    width_to_depth : float
        Of the box around the walking chest and arms.
    hung : str
        The garment that goes on as a loose shell of cloth, "" without one.
    stone : (A, A, 3) uint8, stone_shell : (B, 2 B, 3) uint8, or None
        Atlas and shells as a statue's.
    face : (K, N, 3) int16 or None
        How it moves; see :func:`cloner.crowd.clones.faces.face_offsets`.
    """

    identifier: str
    stature_m: float
    vertices_m: Array
    normals: Array
    loose: LooseShells
    clips: tuple[Clip, ...]
    atlas: Pixels
    codes: Pixels
    marks: Pixels
    shell: Pixels
    looks: Mapping[str, GroupLook]
    groups: NDArray[np.uint8]
    width_to_depth: float
    hung: str = ""
    stone: Pixels | None = None
    stone_shell: Pixels | None = None
    face: NDArray[np.int16] | None = None


def make_crowd_clone(
    identifier: str,
    clone: Clone,
    body: BodyLevels,
    *,
    poses: int,
    walks: Sequence[Path] = (),
    feelings: bool = False,
    atlas_px: int = ATLAS_PX,
    carved: Callable[[Clone], Clone] | None = None,
    flow: Flow | None = None,
    faces: bool = False,
    budgets: Sequence[int] = LOOSE,
) -> CrowdClone:
    """Return a clone prepared for the crowd; ``carved`` adds a statue of it as another texture.

    Its loose shells have at most ``budgets`` triangles. With ``flow`` its shell of cloth moves as it was simulated,
    with ``faces`` its face can.

    Raises
    ------
    ClonerError
        If a captured walk cannot be laid on.
    """
    groups, shells = triangle_groups(clone), [shell for shell in clone.shells if shell.kind in DRAWN]
    atlas = reduced(clone.atlas.rgb, atlas_px)
    codes = refine_hems(atlas, texel_groups(groups, atlas_px))
    clips = make_clips(clone, poses, walks, feelings=feelings)
    statue = carved(clone) if carved else None
    vertices_m, outward, hung = clone.vertices_m, surface_normals(clone.vertices_m), ""
    if flow is not None:
        place = next(k for k, one in enumerate(shells) if one.kind == "cloth")
        shells[place], clips = skin_simulated_cloth(clone, shells[place], flow, clips)
        vertices_m = vertices_m - SUNK_M * flow.hidden[:, None] * outward
        hung = "top" if shells[place].vertices_m[:, 1].max() > CHEST[0] * clone.stature_m else "bottom"
    normals = outward[body.vertex]
    shell = _shell_picture(shells)
    looks = group_looks(atlas, codes)
    if flow is not None:
        looks[hung] = _loose_cloth_look(shell, hung)
    return CrowdClone(
        identifier,
        clone.stature_m,
        vertices_m[body.vertex],
        normals / np.linalg.norm(normals, axis=1, keepdims=True),
        _merge_loose_shells(shells, len(body.triangles), clips[0], budgets),
        clips,
        atlas,
        codes,
        shader_codes(codes),
        shell,
        looks,
        groups,
        _width_to_depth(clone.vertices_m[body.vertex], body, clips[0], clone.stature_m),
        hung or _loose_garment(shell, atlas, codes),
        reduced(statue.atlas.rgb, atlas_px) if statue else None,
        _shell_picture([one for one in statue.shells if one.kind in DRAWN])[..., :3] if statue else None,
        face_offsets(clone, body) if faces else None,
    )


def skin_vertices(vertices_m: Array, joints: NDArray[np.int64], weights: Array, frame: Array) -> Array:
    """Return (N, 3) vertices skinned by one frame of bones (J, 3, 4), metres."""
    blended = np.einsum("nk,nkab->nab", weights, frame[joints])
    return np.asarray(np.einsum("nab,nb->na", blended[:, :, :3], vertices_m) + blended[:, :, 3])


def _loose_cloth_look(shell: Pixels, group: str) -> GroupLook:
    """Return the look of attached cloth by its own picture, as another garment lies below it."""
    cloth = shell[:, SHELL_PX:]
    codes = np.where(cloth[..., 3] > 127, STEP * (GROUPS.index(group) + 1), 0).astype(np.uint8)
    return group_looks(cloth[..., :3], codes)[group]


def _loose_garment(shell: Pixels, atlas: Pixels, codes: Pixels) -> str:
    """Return the garment that a clone's loose cloth replaces, "" without any: the top if it has the coat's colour."""
    cloth = shell[:, SHELL_PX:].reshape(-1, 4)
    shown = cloth[cloth[:, 3] > 127, :3]
    if not len(shown):
        return ""
    masks, middle = garment_masks(codes), shown.mean(axis=0)
    away = {name: np.linalg.norm(atlas[masks[name]].mean(axis=0) - middle) for name in masks if masks[name].any()}
    return "top" if away.get("top", np.inf) < away.get("bottom", UNLIKE) else "bottom"


def _width_to_depth(vertices_m: Array, body: BodyLevels, walk: Clip, stature_m: float) -> float:
    """Return the width of the trunk with arms relative to its depth, at the chest, median over all walking poses."""
    ratios = []
    for frame in walk.frames[:: max(len(walk.frames) // 8, 1)]:
        points = skin_vertices(vertices_m, body.joints, body.weights, frame)
        chest = points[(points[:, 1] > CHEST[0] * stature_m) & (points[:, 1] < CHEST[1] * stature_m)]
        ratios.append(np.ptp(chest[:, 0]) / np.ptp(chest[:, 2]))
    return float(np.median(ratios))


def _merge_loose_shells(shells: Sequence[Shell], levels: int, walk: Clip, budgets: Sequence[int]) -> LooseShells:
    """Return all shells as one mesh: hair and a skirt share the triangles where they are seen most."""
    if not shells:
        none = np.zeros((0, 3))
        empty = np.zeros((0, 4))
        return LooseShells(
            none, none[:, :2], empty.astype(np.int64), empty, none, np.zeros(0, bool),
            tuple(np.zeros((0, 3), np.int32) for _ in range(levels)),
        )  # fmt: skip
    starts = np.cumsum([0, *(len(shell.vertices_m) for shell in shells)])
    moved = [shell.triangles + start for shell, start in zip(shells, starts[:-1], strict=True)]
    whole = np.concatenate(moved).astype(np.int32)
    cloth = np.concatenate([np.full(len(shell.vertices_m), shell.kind == "cloth") for shell in shells])
    uv = np.concatenate([np.clip(shell.uv, 0.0, 1.0) for shell in shells])
    weights = np.maximum(np.concatenate([shell.skin_weights for shell in shells]), 0.0).astype(np.float64)
    weights /= weights.sum(axis=1, keepdims=True)
    places = np.concatenate([shell.vertices_m for shell in shells])
    joints = np.concatenate([shell.skin_joints for shell in shells]).astype(np.int64)
    strides = walk.frames[:: max(len(walk.frames) // STRIDES, 1)][:STRIDES]
    fewer = shell_levels(places, whole, budgets, [skin_vertices(places, joints, weights, frame) for frame in strides])
    return LooseShells(
        places,
        np.column_stack([uv[:, 0] * 0.5 + np.where(cloth, 0.5, 0.0), uv[:, 1]]),
        joints,
        weights,
        np.concatenate([welded_normals(shell.vertices_m, shell.triangles) for shell in shells]),
        cloth,
        (whole,) * (levels - len(budgets)) + fewer,
    )


def _shell_picture(shells: Sequence[Shell]) -> Pixels:
    """Return the shells' pictures side by side; shells of one kind share the first one's picture."""
    picture = np.zeros((SHELL_PX, 2 * SHELL_PX, 4), np.uint8)
    for shell in reversed(shells):
        left = SHELL_PX if shell.kind == "cloth" else 0
        picture[:, left : left + SHELL_PX] = _shrunk(shell.rgba)
    return picture


def _shrunk(rgba: Pixels) -> Pixels:
    """Return a picture with alpha reduced to SHELL_PX; colours are averaged by alpha, and extended where nothing
    covers.
    """
    alpha = rgba[..., 3:].astype(np.float64) / 255.0
    small = reduced(np.dstack([rgba[..., :3] * alpha, alpha]), SHELL_PX)
    colour = small[..., :3] / np.maximum(small[..., 3:], 1e-6)
    mean = (rgba[..., :3] * alpha).sum(axis=(0, 1)) / max(float(alpha.sum()), 1e-6)
    colour = np.where(small[..., 3:] > 1.0 / 255.0, colour, mean)
    return np.clip(np.round(np.dstack([colour, 255.0 * small[..., 3]])), 0, 255).astype(np.uint8)
