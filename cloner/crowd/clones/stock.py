"""Arrays of clones for the shaders: integers in rows, the same in a pack and in the renderer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.crowd.clones.cast import CrowdClone
from cloner.crowd.clones.clips import Clip
from cloner.crowd.clones.groups import GROUPS, WORN, garment_masks, skin_colours
from cloner.crowd.clones.levels import LOOSE, BodyLevels, LooseShells
from cloner.crowd.clones.zones import covered_zones
from cloner.records.arrays import Array

#: All rest poses lie in this box: its corner and side, metres. 16 bits of it are .04 mm.
BOX_MIN_M: Final = (-1.28, -0.1, -1.28)
BOX_M: Final = 2.56
BOX_STEP_M: Final = BOX_M / 65535.0
#: Farthest translation of a bone, metres; 16 bits of it are .12 mm.
BONE_REACH_M: Final = 4.0
BONE_FULL: Final = 32767
#: Texels a metre of impostors; a person of 1.75 m is 58 texels tall, 38 px at the switch: 20 clones fit
#: 150 MiB of a card with their atlases.
TEXELS_PER_M: Final = 33.0
#: Texels a screen pixel where geometry gives way to impostors (measured best, 1 to 2 tried).
TEXELS_PER_PX: Final = 1.5
#: The bake's eye stands where the switch happens through a lens of 869 px (45 degrees over 720 lines), metres.
BAKED_FROM_M: Final = 869.0 * TEXELS_PER_PX / TEXELS_PER_M
#: Widths of textures, texels: vertices, loose vertices (two texels each), loose corners.
WIDE: Final = 128
CORNERS_WIDE: Final = 256
#: Columns of the clones' table: facts, clips, sets of tiles, looks, colours of garments, skin, reach of top and bottom,
#: group of the garment that hangs on as a shell.
COLUMNS: Final = 64
CLIPS_AT, SETS_AT, LOOKS_AT, COLOURS_AT, SKIN_AT, REACH_AT, HUNG_AT = 1, 25, 49, 53, 58, 61, 63
MOST_CLIPS: Final = SETS_AT - CLIPS_AT
_DYED: Final = (*WORN, "hair")
#: How much brighter than its median what has no look of its own may be; a dye shows no more.
BRIGHT: Final = 2.0


@dataclass(frozen=True, slots=True, eq=False)
class CloneArrays:
    """One clone's arrays for the shaders.

    Attributes
    ----------
    vertices : (N, 4) uint16: place in the box, normal as an octahedron's point
    loose : (2 M, 4) uint16: uv and joints; weights
    corners : (K,) uint16: loose vertices of every level's triangles, levels padded to ``LOOSE``
    bones : (F, J, 3, 4) int16: rows of the joints' transforms, all clips after one another
    """

    vertices: NDArray[np.uint16]
    loose: NDArray[np.uint16]
    corners: NDArray[np.uint16]
    bones: NDArray[np.int16]


@dataclass(frozen=True, slots=True, eq=False)
class CrowdArrays:
    """All arrays that the shaders read.

    Attributes
    ----------
    body : BodyLevels
    budgets : loose triangles of each level
    numbers : tuple of Numbers, one a clone
    table : (C, COLUMNS, 4) float32
    atlases : (C, A, A, 4) uint8, shells : (C, B, 2 B, 4) uint8
    tiles : (C, 2 T, 4) float32, colours : (C, H, W, 4) uint8, shapes : (C, H/2, W/2, 4) uint8, or None before baking
    elevations : tuple of radians
    stones : (C, A, A, 3) uint8, stone_shells : (C, B, 2 B, 3) uint8
        The same people in stone, or None.
    faces : (C, K, N, 3) int16
        How faces move that can speak; see :func:`cloner.crowd.clones.faces.face_offsets`; or None.
    """

    body: BodyLevels
    budgets: tuple[int, ...]
    numbers: tuple[CloneArrays, ...]
    table: NDArray[np.float32]
    atlases: NDArray[np.uint8]
    shells: NDArray[np.uint8]
    tiles: NDArray[np.float32] | None = None
    colours: NDArray[np.uint8] | None = None
    shapes: NDArray[np.uint8] | None = None
    elevations: tuple[float, ...] = (0.0,)
    stones: NDArray[np.uint8] | None = None
    stone_shells: NDArray[np.uint8] | None = None
    faces: NDArray[np.int16] | None = None


def clone_arrays(cast: CrowdClone, budgets: Sequence[int] = LOOSE) -> CloneArrays:
    """Return a clone's arrays; ``budgets`` are the loose triangles of each level."""
    used, triangles = _compact(cast.loose)
    places = np.concatenate([cast.vertices_m, cast.loose.vertices_m[used]])
    normals = np.concatenate([cast.normals, cast.loose.normals[used]])
    place = np.round((places - BOX_MIN_M) / BOX_STEP_M)
    vertices = np.column_stack([np.clip(place, 0, 65535), encode_octahedral(normals)]).astype(np.uint16)
    frames = np.concatenate([clip.frames for clip in cast.clips])
    scale = np.array([1.0, 1.0, 1.0, BONE_REACH_M])
    bones = np.clip(np.round(frames / scale * BONE_FULL), -BONE_FULL, BONE_FULL).astype(np.int16)
    return CloneArrays(vertices, _loose_rows(cast.loose, used), _corners(triangles, budgets), bones)


def _compact(loose: LooseShells) -> tuple[NDArray[np.int64], list[NDArray[np.int64]]]:
    """Return the loose vertices that any level uses, and the levels' triangles among them."""
    every = np.concatenate([triangles.reshape(-1) for triangles in loose.triangles])
    used = np.unique(every).astype(np.int64)
    return used, [np.searchsorted(used, triangles) for triangles in loose.triangles]


def _loose_rows(loose: LooseShells, used: NDArray[np.int64]) -> NDArray[np.uint16]:
    uv = np.round(np.clip(loose.uv[used], 0.0, 1.0) * 65535.0).astype(np.uint16)
    joints = loose.joints[used].astype(np.uint16)
    weights = whole_weights(loose.weights[used]).astype(np.uint16)
    rows = np.zeros((len(used), 2, 4), np.uint16)
    rows[:, 0, :2] = uv
    rows[:, 0, 2:] = joints[:, ::2] | (joints[:, 1::2] << 8)
    rows[:, 1, :2] = weights[:, ::2] | (weights[:, 1::2] << 8)
    return rows.reshape(-1, 4)


def _corners(triangles: Sequence[NDArray[np.int64]], budgets: Sequence[int]) -> NDArray[np.uint16]:
    """Return the corners of all levels in one list; a level with fewer triangles is padded with degenerate ones."""
    lines = []
    for own, budget in zip(triangles, budgets, strict=True):
        line = np.zeros(3 * budget, np.uint16)
        line[: own.size] = own.reshape(-1)
        lines.append(line)
    return np.concatenate(lines)


def whole_weights(weights: Array) -> NDArray[np.int64]:
    """Return (N, 4) weights as integers whose sum is exactly 255."""
    whole = np.floor(weights * 255.0 + 1e-6).astype(np.int64)
    whole[np.arange(len(whole)), weights.argmax(axis=1)] += 255 - whole.sum(axis=1)
    return whole


def encode_octahedral(normals: Array) -> NDArray[np.uint16]:
    """Return (N,) unit normals as two bytes each (octahedral mapping)."""
    n = normals / np.abs(normals).sum(axis=1, keepdims=True)
    fold = n[:, 2] < 0.0
    signs = np.where(n[:, :2] >= 0.0, 1.0, -1.0)
    flat = np.where(fold[:, None], (1.0 - np.abs(n[:, 1::-1])) * signs, n[:, :2])
    whole = np.clip(np.round((flat + 1.0) * 127.5), 0, 255).astype(np.uint16)
    return np.asarray(whole[:, 0] | (whole[:, 1] << 8), np.uint16)


class BakedClip(IntEnum):
    """Which views of a clip have impostors; shaders read the number."""

    FRONT = 0  # for those in a stand
    ALL = 1
    LEFT = 2  # front, left and back; the right is the left half a cycle later, mirrored


#: First tile of each clip, and which views follow.
Sets = Sequence[tuple[int, BakedClip]]


def sets_without_impostors(cast: CrowdClone) -> Sets:
    """Return the sets of a clone without impostors."""
    return [(0, BakedClip.ALL)] * len(cast.clips)


def table_row(cast: CrowdClone, sets: Sets, texels_per_m: float, views: int, first_bone: int) -> NDArray[np.float32]:
    """Return a clone's (COLUMNS, 4) row of the clone table.

    Parameters
    ----------
    cast : Cast
    sets : sequence of (int, BakedClip)
        First tile of each clip and its views.
    texels_per_m : float
        Of the impostors.
    views : int
        Baked around the clone.
    first_bone : int
        Row of the clone's first frame among all clones' frames.
    """
    row = np.zeros((COLUMNS, 4), np.float32)
    row[0] = middle_m(cast), texels_per_m, views, float(len(cast.loose.vertices_m) > 0)
    frame = first_bone
    for k, clip in enumerate(cast.clips):
        row[CLIPS_AT + k] = frame, len(clip.frames), clip.seconds, clip.seconds * clip.speed_m_s
        far = next(one for one in cast.clips if one.name == (clip.far or clip.name))
        row[SETS_AT + k] = sets[k][0], far.poses, sets[k][1], clip.poses
        frame += len(clip.frames)
    for k, name in enumerate(_DYED):
        look = cast.looks.get(name)
        row[LOOKS_AT + k] = (128.0, 1.0, 0.0, BRIGHT)
        if look:
            row[LOOKS_AT + k] = look.median, look.evenness, look.share, look.scale / look.median
            shade = look.median / look.scale / 255.0
            row[COLOURS_AT + k, :3] = np.clip(np.array(look.colour) * shade, 0.0, 1.0)
    if not cast.looks.get("hair"):
        row[LOOKS_AT + 3, :2] = _shell_look(cast)
    for k, colour in enumerate(skin_colours(cast.atlas, cast.codes).values()):
        row[SKIN_AT + k, :3] = colour / 255.0
    for k, covered in enumerate(covered_zones(garment_masks(cast.codes)).values()):
        row[REACH_AT + k] = covered
    row[HUNG_AT] = GROUPS.index(cast.hung or "bottom") + 1
    return row


def _shell_look(cast: CrowdClone) -> tuple[float, float]:
    """Return the median luma and contrast of the hair's own picture."""
    hair = cast.shell[:, : cast.shell.shape[1] // 2].reshape(-1, 4)
    solid = hair[hair[:, 3] > 127]
    return (max(float(np.median(solid[:, :3] @ [0.2126, 0.7152, 0.0722])), 1.0), 1.0) if len(solid) else (128.0, 1.0)


def middle_m(cast: CrowdClone) -> float:
    """Return the height of the point around which impostors are baked, metres."""
    return float(cast.vertices_m[:, 1].max() / 2.0)


def level_arrays(body: BodyLevels, level: int, budgets: Sequence[int] = LOOSE) -> dict[str, NDArray[Any]]:
    """Return the vertex attributes and indices that all clones share at a level.

    ``which`` (N,) float32 counts the body's wedges, then the loose corners from ``len(body.vertex)`` on; ``uv``,
    ``joints`` and ``weights`` are the body's; ``index`` (3 T,) uint32, fronts only: what is loose comes with either
    winding, one behind the other: a processor that shades vertices then remembers them.
    """
    own, corners = body.counts[level], 3 * budgets[level]
    rest = np.zeros((corners, 4))
    which = np.concatenate([np.arange(own), len(body.vertex) + np.arange(corners)])
    loose = own + np.arange(corners).reshape(-1, 3)
    both = np.concatenate([loose, loose[:, [0, 2, 1]]], axis=1).reshape(-1, 3)
    index = np.concatenate([body.triangles[level], both]).reshape(-1)
    return {
        "which": which.astype(np.float32),
        "uv": np.concatenate([body.uv[:own], rest[:, :2]]).astype(np.float32),
        "joints": np.concatenate([body.joints[:own], rest]).astype(np.float32),
        "weights": np.concatenate([body.weights[:own], rest]).astype(np.float32),
        "index": index.astype(np.uint32),
    }


def face_texels(moves: NDArray[np.int16]) -> NDArray[np.int16]:
    """Return (K R, WIDE, 4) texels of a face's (K, N, 3) offsets: R rows per target."""
    targets, count, _ = moves.shape
    rows = np.zeros((targets, -(-count // WIDE) * WIDE, 4), np.int16)
    rows[:, :count, :3] = moves
    return rows.reshape(-1, WIDE, 4)


def rows_of_texels(values: NDArray[Any], wide: int) -> NDArray[Any]:
    """Return (N, ...) values as (rows, wide, ...), padded with zeros."""
    rows = -(-len(values) // wide)
    out = np.zeros((rows * wide, *values.shape[1:]), values.dtype)
    out[: len(values)] = values
    return out.reshape(rows, wide, *values.shape[1:])


def stack_padded(arrays: Sequence[NDArray[Any]]) -> NDArray[Any]:
    """Return (C, rows, ...) of arrays with (rows_k, ...), shorter ones padded with zeros."""
    tall = max(len(one) for one in arrays)
    out = np.zeros((len(arrays), tall, *arrays[0].shape[1:]), arrays[0].dtype)
    for k, one in enumerate(arrays):
        out[k, : len(one)] = one
    return out


def first_frame_rows(clips: Sequence[Sequence[Clip]]) -> list[int]:
    """Return the first row of each clone's frames when all are stacked."""
    counts = [sum(len(clip.frames) for clip in own) for own in clips]
    return [sum(counts[:k]) for k in range(len(counts))]
