"""Glasses as an object of their own: the frame as the front photo shows it, on a sheet before the eyes, with temples.

Lenses are clear, so only what the photo shows of the frame (or of dark lenses) is drawn.
"""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.load import GenericHuman
from cloner.geometry.articulation.skinning import joint_transforms
from cloner.labels.glasses import frame_of
from cloner.paint.lookups.posed import parents_of
from cloner.records.arrays import Array
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.heads import Shell
from cloner.records.photos import Photo
from cloner.records.points import Proposal
from cloner.vision.retouching.repair import spread_nearest

#: The sheet stands this far before the nasion, and bends back with this radius: the face form of usual frames (taste).
BEFORE_M, BEND_M = 0.006, 0.16
#: Points of the sheet across and down; texels of its texture's longer side; rows below it hold the temples' colour.
GRID: Final = (33, 13)
TEXELS: Final = 512
TEMPLE_ROWS: Final = 16
#: Height of a temple; how far it stays off the ear's top; its bend behind the ear, down and back (usual frames).
TEMPLE_M, OFF_EAR_M, HOOK_M = 0.005, 0.004, (0.022, 0.018)
#: Air around the frame in the texture, share of its width.
AIR: Final = 0.02


def glasses_shell(generic: GenericHuman, joined: Joined, photo: Photo, proposal: Proposal) -> Shell | None:
    """Return the glasses of somebody who wears them, None where the frame cannot be made out.

    Parameters
    ----------
    generic : GenericHuman
    joined : Joined
        Its views hold the camera of the face's front photo.
    photo : Photo
        The face from the front.
    proposal : Proposal
        Of that photo.
    """
    frame = frame_of(proposal)
    rows, columns = np.flatnonzero(frame.any(axis=1)), np.flatnonzero(frame.any(axis=0))
    if not rows.size:
        return None
    air = int(AIR * np.ptp(columns)) + 2
    box = (columns[0] - air, rows[0] - air, columns[-1] + air, rows[-1] + air)
    view = joined.views[ViewId.FACE_FRONT]
    head = generic.joint_names.index("skullbase")
    posed_from_rest = joint_transforms(joined.joints_m, parents_of(generic), view.rotations)[head]
    sheet_m, sheet_uv, sheet_triangles = _sheet(joined, view, posed_from_rest, box)
    rgba = _texture(photo.rgb, frame, box)
    share = TEMPLE_ROWS / len(rgba)
    sheet_uv[:, 1] *= 1.0 - share
    temples = [_temple(generic, joined, sheet_m, side, 1.0 - 0.5 * share) for side in "LR"]
    parts = [(sheet_m, sheet_uv, sheet_triangles), *temples]
    starts = np.cumsum([0] + [len(part[0]) for part in parts])
    triangles = np.concatenate([part[2] + start for part, start in zip(parts, starts, strict=False)])
    vertices = np.concatenate([part[0] for part in parts])
    joints = np.zeros((len(vertices), 4), np.int32)
    joints[:] = head
    weights = np.tile([1.0, 0.0, 0.0, 0.0], (len(vertices), 1))
    uv = np.concatenate([part[1] for part in parts])
    return Shell(vertices, triangles.astype(np.int32), uv, joints, weights, rgba, "glasses")


def _sheet(
    joined: Joined, view: PosedView, posed_from_rest: Array, box: tuple[int, int, int, int]
) -> tuple[Array, Array, NDArray[np.int64]]:
    """Return rest points (N, 3), uv and triangles of a bent sheet that the camera sees fill a box of the photo."""
    left, top, right, bottom = box
    across, down = np.meshgrid(np.linspace(0.0, 1.0, GRID[0]), np.linspace(0.0, 1.0, GRID[1]))
    pixel = np.column_stack([left + across.ravel() * (right - left), top + down.ravel() * (bottom - top)])
    start = view.camera.position_m
    any_depth = np.tile(joined.features_m["nasion"], (len(pixel), 1))
    way = view.camera.back_project(pixel, any_depth) - start
    # rays in the head's rest frame: there the gaze is +Z and left is +X
    rest_from_posed = np.linalg.inv(posed_from_rest)
    start = rest_from_posed[:3, :3] @ start + rest_from_posed[:3, 3]
    way = way @ rest_from_posed[:3, :3].T
    nasion = joined.features_m["nasion"]
    depth = np.full(len(way), nasion[2] + BEFORE_M)
    for _ in range(4):  # the bend is slight: three rounds settle to a hundredth of a millimetre
        reach = (depth - start[2]) / way[:, 2]
        points = start + reach[:, None] * way
        depth = nasion[2] + BEFORE_M - (points[:, 0] - nasion[0]) ** 2 / (2.0 * BEND_M)
    corner = np.arange(GRID[0] * GRID[1]).reshape(GRID[1], GRID[0])
    a, b, c, d = (part.ravel() for part in (corner[:-1, :-1], corner[:-1, 1:], corner[1:, :-1], corner[1:, 1:]))
    triangles = np.concatenate([np.column_stack([a, c, b]), np.column_stack([b, c, d])])
    return points, np.column_stack([across.ravel(), down.ravel()]), triangles


def _texture(rgb: NDArray[np.uint8], frame: NDArray[np.bool_], box: tuple[int, int, int, int]) -> NDArray[np.uint8]:
    """Return (S, T, 4) the frame cut out of the photo, with rows of its usual colour below."""
    left, top, right, bottom = box
    part = np.s_[max(top, 0) : bottom + 1, max(left, 0) : right + 1]
    width, height = right - left + 1, bottom - top + 1
    scale = TEXELS / max(width, height)
    size = (max(1, round(width * scale)), max(1, round(height * scale)))
    photo_from_texel = np.array([[1.0 / scale, 0.0, min(left, 0)], [0.0, 1.0 / scale, min(top, 0)]])
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    cut = cv2.warpAffine(spread_nearest(rgb[part], frame[part]), photo_from_texel, size, flags=flags)
    alpha = cv2.warpAffine(frame[part].astype(np.uint8) * 255, photo_from_texel, size, flags=flags)
    rgba = np.zeros((size[1] + TEMPLE_ROWS, size[0], 4), np.uint8)
    rgba[: size[1], :, :3], rgba[: size[1], :, 3] = cut, cv2.GaussianBlur(alpha, (3, 3), 0)
    rgba[size[1] :, :, :3], rgba[size[1] :, :, 3] = np.median(rgb[frame], axis=0), 255
    return rgba


def _temple(
    generic: GenericHuman, joined: Joined, sheet_m: Array, side: str, v: float
) -> tuple[Array, Array, NDArray[np.int64]]:
    """Return points, uv and triangles of the strip from the sheet's outer part over the ear and down behind it."""
    grid = sheet_m.reshape(GRID[1], GRID[0], 3)
    sign = 1.0 if side == "L" else -1.0
    column = 0 if sign * grid[0, 0, 0] > sign * grid[0, -1, 0] else -1
    hinge = grid[GRID[1] // 3, column]
    ear = joined.vertices_m[generic.feature(f"ear_top_{side}")]
    root = np.array([ear[0] + sign * OFF_EAR_M, ear[1] - OFF_EAR_M, ear[2] + 0.5 * HOOK_M[1]])
    end = root - (0.0, HOOK_M[0], HOOK_M[1] + 0.5 * HOOK_M[1])
    middle = np.stack([hinge, 0.5 * (hinge + root) + (sign * OFF_EAR_M, 0.0, 0.0), root, end])
    half = np.array([0.0, 0.5 * TEMPLE_M, 0.0])
    points = np.concatenate([middle + half, middle - half])
    upper, count = np.arange(len(middle) - 1), len(middle)
    triangles = np.concatenate([
        np.column_stack([upper, upper + count, upper + 1]),
        np.column_stack([upper + 1, upper + count, upper + count + 1]),
    ])  # fmt: skip
    return points, np.tile([0.5, v], (len(points), 1)), triangles
