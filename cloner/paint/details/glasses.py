"""Glasses as a separate object: rims, bridge and temples in the front photo's colours.

Clear lenses are not drawn, dark ones are.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.frames import ViewId, m_from_mm, mm_from_m
from cloner.generic.load import GenericHuman
from cloner.geometry.articulation.skinning import joint_transforms
from cloner.geometry.meshes.sweeps import sweep_profile
from cloner.geometry.meshes.vectors import arc_lengths, places_along
from cloner.labels.glasses import glasses_frame
from cloner.paint.details.frame_shape import FrameShape, fit_frame, frame_reader, has_dark_lenses, picture_px
from cloner.paint.details.glasses_texture import paint_glasses
from cloner.paint.details.rims import SIDES, outward_normals, usual_rims_m
from cloner.paint.lookups.posed import parents_of
from cloner.records.arrays import Array
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.heads import Shell
from cloner.records.labels import Label, shows
from cloner.records.photos import Photo
from cloner.records.proposals import Proposal
from cloner.vision.retouching.aligning import sample
from cloner.vision.retouching.matting import EYE_OPENINGS

Part = tuple[Array, Array, NDArray[np.int64]]
"""Vertices (N, 3), uv (N, 2) and triangles (T, 3)."""

#: The frame's plane stands this far before the nasion, and bends back with this radius: the face form of usual frames
#: (taste). Its back stays so far off the skin.
BEFORE_M, BEND_M, OFF_SKIN_M = 0.006, 0.16, 0.001
#: What is looked at, mm from the nasion: left, right, up, down; and how finely.
REACH_MM, PIXEL_MM = (80.0, 40.0, 45.0), 0.4
CORNER_MM: Final = (-REACH_MM[0], REACH_MM[1])
#: How much the labels say of what is frame; its colour says the rest (taste).
LABELLED: Final = 0.4
#: Lashes reach so far around the openings of the eyes, as a share of the eyes' span.
LASHES: Final = 0.033
#: Skin is told from frame by the colours this far around it, mm.
SKIN_MM: Final = (3.0, 8.0)
#: As wide as a gleam along a frame, 2.8 mm.
GLEAM: Final = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (7, 7))
#: Depth of a rim against its height, and the least half of it.
DEEP_SHARE, LEAST_DEEP_M = 0.7, 0.0008
#: Rise of a bridge's middle, and how far before the rims it stands.
BRIDGE_M: Final = (0.001, 0.002)
#: Half the height of a temple, between these, and half its width; how far it stays off the head; its bend behind the
#: ear, down and back (usual frames).
TEMPLE_M, TEMPLE_WIDE_M, OFF_HEAD_M, HOOK_M = (0.001, 0.0025), 0.0009, 0.0015, (0.024, 0.016)
#: Skin this near, seen from aside, lies beside a temple.
BESIDE_M: Final = 0.006
#: Points of a bridge and of a temple.
BRIDGE_POINTS, TEMPLE_POINTS = 7, 16


def glasses_shell(generic: GenericHuman, joined: Joined, photo: Photo, proposal: Proposal) -> Shell | None:
    """Return the glasses of a person who wears them, None where the frame cannot be found.

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
    view = joined.views[ViewId.FACE_FRONT]
    head = generic.joint("skullbase")
    posed_from_rest = joint_transforms(joined.joints_m, parents_of(generic), view.rotations)[head]
    labelled = glasses_frame(proposal)
    if not labelled.any():
        return None
    eyes = np.stack([joined.joints_m[generic.joint(f"{side}_eyeball_joint")] for side in "lr"])
    eyes_m = (eyes - joined.features_m["nasion"])[:, :2]
    eyes_mm = mm_from_m(1.0) * eyes_m
    before_m = BEFORE_M + _clearance_m(generic, joined, _frame_points(joined, usual_rims_m(eyes_m), BEFORE_M))
    read = _plane_reader(joined, view, posed_from_rest, before_m)
    frame, colours = read(labelled.astype(np.float32))[..., 0], read(photo.rgb)
    dark = has_dark_lenses(frame_reader(frame, CORNER_MM, PIXEL_MM), eyes_mm)
    by_colour = frame
    if not dark:
        by_colour = _frame_by_colour(frame, colours, read(_without_eyes(proposal).astype(np.float32))[..., 0])
        frame = LABELLED * frame + (1.0 - LABELLED) * by_colour
    at, coloured = (frame_reader(picture, CORNER_MM, PIXEL_MM) for picture in (frame, by_colour))
    shape = fit_frame(at, coloured, eyes_mm, dark=dark)
    if shape is None:
        return None

    def shown(points_mm: Array) -> tuple[NDArray[np.float32], Array]:
        return sample(colours, picture_px(points_mm, CORNER_MM, PIXEL_MM)), at(points_mm)

    picture, parts = paint_glasses(shape, shown), _parts(generic, joined, shape, before_m)
    vertices = np.concatenate([part[0] for part in parts])
    uv = np.concatenate([picture.uv(part[1], k) for k, part in enumerate(parts)])
    starts = np.cumsum([0] + [len(part[0]) for part in parts])
    triangles = np.concatenate([part[2] + start for part, start in zip(parts, starts, strict=False)])
    joints, weights = np.full((len(vertices), 4), head, np.int32), np.tile([1.0, 0.0, 0.0, 0.0], (len(vertices), 1))
    return Shell(vertices, triangles.astype(np.int32), uv, joints, weights, picture.rgba, "glasses")


def _frame_points(joined: Joined, flat_m: Array, before_m: float) -> Array:
    """Return rest points (..., 3) for points (..., 2) of the frame's plane, which bends back on both sides."""
    nasion = joined.features_m["nasion"]
    depth = before_m - flat_m[..., 0] ** 2 / (2.0 * BEND_M)
    return np.asarray(np.concatenate([flat_m, depth[..., None]], axis=-1) + nasion)


def _plane_reader(
    joined: Joined, view: PosedView, posed_from_rest: Array, before_m: float
) -> Callable[[NDArray[Any]], NDArray[np.float32]]:
    """Return a sampler of photo pictures (H, W, ...) at points (h, w, ...) of the frame's plane."""
    across = np.arange(-REACH_MM[0], REACH_MM[0], PIXEL_MM)
    down = np.arange(REACH_MM[1], -REACH_MM[2], -PIXEL_MM)
    rest = _frame_points(joined, m_from_mm(1.0) * np.stack(np.meshgrid(across, down), axis=-1), before_m)
    pixel = view.camera.project(rest.reshape(-1, 3) @ posed_from_rest[:3, :3].T + posed_from_rest[:3, 3])

    def read(picture: NDArray[Any]) -> NDArray[np.float32]:
        found = np.nan_to_num(sample(picture, pixel)).reshape(*rest.shape[:2], -1)
        return np.asarray(found, np.float32)

    return read


def _frame_by_colour(
    frame: NDArray[np.float32], colours: NDArray[np.float32], open_skin: NDArray[np.float32]
) -> NDArray[np.float32]:
    """Return the frame's probability at points (h, w), from colours; from labels where they show too little of it.

    Labels lose thin frames, and dark skin or hair has a frame's colour.

    Parameters
    ----------
    frame : (h, w) float32 in 0..1, by labels alone
    colours : (h, w, 3) float32, levels
    open_skin : (h, w) float32 in 0..1
        Where skin is seen, or what is worn on it, and no eye.
    """
    sure = frame > 0.5
    core = cv2.erode(sure.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    away = PIXEL_MM * cv2.distanceTransform((~sure).astype(np.uint8), cv2.DIST_L2, 5)
    around = (away > SKIN_MM[0]) & (away < SKIN_MM[1]) & (open_skin > 0.5)
    if not core.any() or not around.any():
        return frame
    lab = cv2.cvtColor(cv2.GaussianBlur(colours, (0, 0), 0.8) / 255.0, cv2.COLOR_RGB2LAB)
    own, skin = np.median(lab[core], axis=0), np.median(lab[around], axis=0)
    lean = np.linalg.norm(lab - skin, axis=2) - np.linalg.norm(lab - own, axis=2)
    frame_share = np.clip(0.5 + 0.5 * lean / max(float(np.linalg.norm(own - skin)), 1.0), 0.0, 1.0)
    # a gleam along the frame is neither's colour
    whole = cv2.morphologyEx(frame_share.astype(np.float32), cv2.MORPH_CLOSE, GLEAM)
    return np.asarray(open_skin * whole, np.float32)


def _without_eyes(proposal: Proposal) -> NDArray[np.bool_]:
    """Return the pixels (H, W) of skin or of what is worn on it, without eyes and lashes."""
    eyes = np.zeros(proposal.labels.shape, np.uint8)
    for ring in EYE_OPENINGS:
        cv2.fillPoly(eyes, [np.round(proposal.face_px[list(ring)]).astype(np.int32)], 1)
    span = float(np.linalg.norm(proposal.face_px[EYE_OPENINGS[0][0]] - proposal.face_px[EYE_OPENINGS[1][0]]))
    side = 2 * int(LASHES * span) + 1
    eyes = cv2.dilate(eyes, np.ones((side, side), np.uint8))
    return np.asarray(shows(proposal.labels, Label.FACE_SKIN, Label.BODY_SKIN, Label.ACCESSORY) & (eyes == 0))


def _parts(generic: GenericHuman, joined: Joined, shape: FrameShape, before_m: float) -> list[Part]:
    """Return both rims, the bridge, both temples, and both lenses where they are dark."""
    thick = 0.5 * shape.thick_m
    deep = max(DEEP_SHARE * thick, LEAST_DEEP_M)
    rim, normals = shape.rim_m, outward_normals(shape.rim_m)
    flat = [rim * (sign, 1.0) + middle for sign, middle in zip(SIDES, shape.middles_m, strict=True)]
    before_m += _clearance_m(generic, joined, _frame_points(joined, np.concatenate(flat), before_m - deep))
    lifted = [_frame_points(joined, one, before_m) for one in flat]
    outward = [np.column_stack([normals * (sign, 1.0), np.zeros(len(rim))]) for sign in SIDES]
    rims = [
        sweep_profile(path, way, np.array([thick, deep]), closed=True)
        for path, way in zip(lifted, outward, strict=True)
    ]  # fmt: skip
    inner = _nearest_height(rim, shape.bridge_m[0], outer=False)
    bridge = _bridge_path(*(path[inner] for path in lifted))
    parts = [
        *rims,
        sweep_profile(bridge, _upward_directions(bridge), np.array([0.5 * shape.bridge_m[1], deep]), closed=False),
    ]
    for side, (sign, middle, hinge, lens) in enumerate(
        zip(SIDES, shape.middles_m, shape.hinges_m, lifted, strict=True)
    ):
        row = _nearest_height(rim, float(hinge[1] - middle[1]), outer=True)
        way = _temple_path(generic, joined, lens[row], _frame_points(joined, hinge, before_m), "LR"[side], sign)
        tall = np.clip(thick, *TEMPLE_M)
        parts.append(sweep_profile(way, _upward_directions(way), np.array([tall, TEMPLE_WIDE_M]), closed=False))
    if shape.dark:
        parts += [_lens_mesh(path) for path in lifted]
    return parts


def _upward_directions(path_m: Array) -> Array:
    """Return (K, 3) upward directions along a path."""
    return np.tile([0.0, 1.0, 0.0], (len(path_m), 1))


def _bridge_path(left_m: Array, right_m: Array) -> Array:
    """Return points (K, 3) from one rim to the other, arched over the nose."""
    share = np.linspace(0.0, 1.0, BRIDGE_POINTS)[:, None]
    return np.asarray(left_m + share * (right_m - left_m) + (1.0 - (2.0 * share - 1.0) ** 2) * (0.0, *BRIDGE_M))


def _nearest_height(rim_m: Array, height_m: float, *, outer: bool) -> int:
    """Return the point of the left rim (N, 2) at a height on its outer or inner side."""
    side = rim_m[:, 0] > 0.0 if outer else rim_m[:, 0] < 0.0
    return int(np.where(side, np.abs(rim_m[:, 1] - height_m), np.inf).argmin())


def _clearance_m(generic: GenericHuman, joined: Joined, points_m: Array) -> float:
    """Return how far points (N, 3) must move forward so that none of them is in the face."""
    face = joined.vertices_m[generic.region("face")]
    near = cKDTree(face[:, :2]).query_ball_point(points_m[:, :2], BESIDE_M)
    skin = np.array([face[rows, 2].max() if rows else -np.inf for rows in near])
    return max(float((skin + OFF_SKIN_M - points_m[:, 2]).max()), 0.0)


def _temple_path(generic: GenericHuman, joined: Joined, rim_m: Array, hinge_m: Array, side: str, sign: float) -> Array:
    """Return points (K, 3) from a rim to its hinge, over the ear and down behind it, outside the head."""
    ear = generic.region("ear_left" if side == "L" else "ear_right")
    top = joined.vertices_m[generic.feature(f"ear_top_{side}")]
    folds = joined.vertices_m[ear]
    high = folds[folds[:, 1] > np.median(folds[:, 1])]
    root_x = 0.5 * (top[0] + sign * float((sign * high[:, 0]).min()))
    root = np.array([root_x, top[1] - BESIDE_M, top[2]])
    end = root - (0.0, HOOK_M[0], HOOK_M[1])
    corners = np.stack([rim_m, hinge_m, root, root - (0.0, 0.3 * HOOK_M[0], 0.7 * HOOK_M[1]), end])
    length = arc_lengths(corners)
    wanted = np.linspace(length[1], length[-1], TEMPLE_POINTS)
    path = np.concatenate([corners[:1], places_along(corners, length, wanted)])
    head = joined.vertices_m[generic.skin & generic.segment("head") & ~ear]
    head = head[sign * head[:, 0] > 0.0]
    near = cKDTree(head[:, 1:]).query_ball_point(path[2:, 1:], BESIDE_M)
    least = np.array([(sign * head[rows, 0]).max() + OFF_HEAD_M if rows else 0.0 for rows in near])
    path[2:, 0] = sign * np.maximum(sign * path[2:, 0], least)
    return path


def _lens_mesh(rim_m: Array) -> Part:
    """Return a lens: a triangle fan in a rim (N, 3)."""
    rows, count = np.arange(len(rim_m)), len(rim_m)
    points = np.concatenate([rim_m, rim_m.mean(axis=0)[None]])
    turn = 2.0 * np.pi * rows / count
    uv = np.concatenate([0.5 + 0.5 * np.column_stack([np.cos(turn), np.sin(turn)]), [[0.5, 0.5]]])
    after = np.roll(rows, -1)
    triangles = np.column_stack([rows, after, np.full(count, count)])
    flip = np.cross(rim_m[after] - rim_m[rows], points[-1] - rim_m[rows])[:, 2].sum() < 0.0
    return points, uv, triangles[:, ::-1] if flip else triangles
