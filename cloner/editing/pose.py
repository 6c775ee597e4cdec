"""Poses turned at corrected joints, so that the clone's joints lie in each photo where an operator placed them.

A corrected joint says how the limb is held in that photo, and a little where the joint lies in the limb: angles of the
limb give way first, then the joint's place in rest pose (the paper's post-correction of the skeleton). The skin in rest
pose stays as it is.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.editing.wishes import Wish
from cloner.frames import ViewId, m_from_mm, mm_from_m
from cloner.generic.load import load_generic
from cloner.geometry.articulation.poses import FREEDOMS, SIGMAS, pose_matrix
from cloner.geometry.articulation.skinning import joint_transforms
from cloner.records.arrays import Array
from cloner.records.bodies import PosedView
from cloner.records.points import ObeyedPoint

#: What each number is and where it comes from: ``cloner/calibration/editing.toml``.
_CALIBRATED: Final = calibrated("editing.pose")


#: Angles of each limb, by the names of its freedoms; the side's letter stands before.
LIMBS = {"arm": ("clavicle", "shoulder", "elbow", "wrist"), "leg": ("hip", "knee", "ankle")}
#: Which limb a joint or feature is turned with, by the start of its name without the side.
LIMB_OF = {
    **dict.fromkeys(("shoulder", "elbow", "wrist"), "arm"),
    **dict.fromkeys(("hip", "knee", "ankle", "heel", "toe"), "leg"),
}
#: Joints that should stay where they are seen while others are moved.
KEPT = tuple(f"{s}_{name}" for name in ("elbow", "wrist", "knee", "ankle") for s in "lr")


@dataclass(frozen=True, slots=True)
class Params:
    """What gives way (taste, after watching limbs follow a drag).

    Limbs lie on their outlines already, so a small move is rather the joint's place in the limb than the limb's: with
    stiffer places a knee dragged by 10 px took the whole leg 6 px off its outline.

    Its numbers: ``cloner/calibration/editing.toml``, ``[pose.*]``.

    Attributes
    ----------
    turns : int
    """

    angle_share: float = _CALIBRATED.number("angle_share", "share")
    place_mm: float = _CALIBRATED.number("place_mm", "mm")
    kept_px: float = _CALIBRATED.number("kept_px", "px")
    exact_px: float = _CALIBRATED.number("exact_px", "px")
    most_angle: float = _CALIBRATED.number("most_angle", "rad")
    most_mm: float = _CALIBRATED.number("most_mm", "mm")
    turns: int = 6
    still: float = _CALIBRATED.number("still", "factor")


@dataclass(frozen=True, slots=True, eq=False)
class _Held:
    """One photo's part: its wishes, the angles that may turn (282, F) and their spreads (F,), and where joints stay."""

    posed: PosedView
    wishes: tuple[Wish, ...]
    angles: Array
    spread: Array
    kept_px: Array

    def rotations(self, turned: Array) -> Array:
        """Return the (..., 94, 3) rotations after the angles turned by (..., F) radians."""
        return np.asarray(self.posed.rotations + (turned @ self.angles.T).reshape(*turned.shape[:-1], -1, 3))


def obey_pose(
    vertices_m: Array, joints_m: Array, views: Mapping[ViewId, PosedView], wishes: list[Wish]
) -> tuple[Array, dict[ViewId, PosedView], list[ObeyedPoint]]:
    """Return the joints in rest pose (94, 3), the poses, and how well each corrected joint is obeyed.

    Parameters
    ----------
    vertices_m : (V, 3) rest pose
    joints_m : (94, 3) rest pose
    views : mapping
        Camera and pose of every body photo.
    wishes : list of Wish
    """
    if not wishes:
        return joints_m, dict(views), []
    params, generic = Params(), load_generic()
    held = [
        _hold(vertices_m, joints_m, views[view], tuple(wish for wish in wishes if wish.view is view), params)
        for view in dict.fromkeys(wish.view for wish in wishes)
    ]
    rows = sorted({generic.joint(wish.name) for wish in wishes if wish.name in generic.joint_names})
    shift_m, turned = _solved(vertices_m, joints_m, held, rows, params)
    joints = joints_m.copy()
    joints[rows] += shift_m
    poses, told = dict(views), {}
    for one, angles in zip(held, turned, strict=True):
        view = one.posed.view
        poses[view] = PosedView(view, one.posed.camera, one.rotations(angles))
        was = _seen(one.posed, one.wishes, vertices_m, joints_m, one.posed.rotations, ())
        now = _seen(one.posed, one.wishes, vertices_m, joints, poses[view].rotations, ())
        for wish, old, new in zip(one.wishes, was, now, strict=True):
            row = rows.index(generic.joint(wish.name)) if wish.name in generic.joint_names else -1
            told[id(wish)] = _tell(wish, old, new, float(np.linalg.norm(shift_m[row])) if row >= 0 else 0.0)
    return joints, poses, [told[id(wish)] for wish in wishes]


def _hold(vertices_m: Array, joints_m: Array, posed: PosedView, wishes: tuple[Wish, ...], params: Params) -> _Held:
    """Return one photo's part of the solution."""
    starts: set[str] = set()
    for wish in wishes:
        words = wish.name.split("_")
        side = next((word[0] for word in words if word in ("l", "r", "left", "right")), "")
        limb = next((LIMB_OF[word] for word in words if word in LIMB_OF), "")
        starts |= {f"{side}_{part}" for part in LIMBS[limb]} if limb else {"neck"}
    columns = [k for k, freedom in enumerate(FREEDOMS) if freedom.name.startswith(tuple(starts))]
    angles = pose_matrix(load_generic().joint_names)[:, columns]
    kept = _seen(posed, (), vertices_m, joints_m, posed.rotations, KEPT)
    return _Held(posed, wishes, angles, params.angle_share * SIGMAS[columns], kept)


def _seen(
    posed: PosedView,
    wishes: tuple[Wish, ...],
    vertices_m: Array,
    joints_m: Array,
    rotations: Array,
    others: tuple[str, ...],
) -> Array:
    """Return where the wishes' joints and features, and other joints, are seen, (..., N, 2) px.

    Joints (..., 94, 3) and rotations (..., 94, 3) may have leading axes: many poses at once.
    """
    generic = load_generic()
    transforms = joint_transforms(joints_m, generic.joint_parents, rotations)
    points = []
    for name in (*(wish.name for wish in wishes), *others):
        if name in generic.joint_names:
            row = generic.joint(name)
            turn, place = transforms[..., row, :3, :], joints_m[..., row, :]
        else:
            row = generic.feature(name)
            weights, carriers = generic.skin_weights[row].astype(np.float64), generic.skin_joints[row]
            turn = np.einsum("k,...kab->...ab", weights, transforms[..., carriers, :3, :])
            place = vertices_m[row]
        points.append(np.einsum("...ab,...b->...a", turn[..., :3], place) + turn[..., 3])
    every = np.stack(points, axis=-2)
    return posed.camera.project(every.reshape(-1, 3)).reshape(*every.shape[:-1], 2)


def _solved(
    vertices_m: Array, joints_m: Array, held: list[_Held], rows: list[int], params: Params
) -> tuple[Array, list[Array]]:
    """Return how joints move in rest pose (M, 3), and the angles' changes of every photo; Gauss-Newton."""
    places = 3 * len(rows)
    ends = np.cumsum([places, *(len(one.spread) for one in held)])
    spread = np.concatenate([np.full(places, m_from_mm(params.place_mm)), *(one.spread for one in held)])
    most = np.concatenate(
        [np.full(places, m_from_mm(params.most_mm)), np.full(int(ends[-1]) - places, params.most_angle)]
    )

    def residuals(number: int, tried: Array) -> Array:
        """Return (B, R) residuals of one photo for (B, X) trials."""
        one = held[number]
        joints = np.repeat(joints_m[None], len(tried), axis=0)
        joints[:, rows] += tried[:, :places].reshape(len(tried), -1, 3)
        turned = one.rotations(tried[:, ends[number] : ends[number + 1]])
        seen = _seen(one.posed, one.wishes, vertices_m, joints, turned, KEPT)
        exact = (seen[:, : len(one.wishes)] - [wish.target_px for wish in one.wishes]) / params.exact_px
        kept = (seen[:, len(one.wishes) :] - one.kept_px) / params.kept_px
        return np.concatenate([exact, kept], axis=1).reshape(len(tried), -1)

    x = np.zeros(int(ends[-1]))
    for _ in range(params.turns):
        parts, right = [np.diag(1.0 / spread)], [-x / spread]
        for number in range(len(held)):
            columns = np.array([*range(places), *range(int(ends[number]), int(ends[number + 1]))])
            tried = np.repeat(x[None], len(columns) + 1, axis=0)
            tried[np.arange(len(columns)) + 1, columns] += 1e-4
            value, *ahead = residuals(number, tried)
            jacobian = np.zeros((len(value), len(x)))
            jacobian[:, columns] = (np.array(ahead) - value).T / 1e-4
            parts.append(jacobian)
            right.append(-value)
        step = np.linalg.lstsq(np.vstack(parts), np.concatenate(right), rcond=None)[0]
        x = np.clip(x + step, -most, most)
        if np.abs(step / spread).max() < params.still:
            break
    return x[:places].reshape(-1, 3), [x[ends[k] : ends[k + 1]] for k in range(len(held))]


def _tell(wish: Wish, was_px: Array, now_px: Array, shift_m: float) -> ObeyedPoint:
    """Return what became of a wish."""
    before, after = (float(np.linalg.norm(seen - wish.target_px)) for seen in (was_px, now_px))
    note = "" if after <= 1.0 else f"the limb does not reach it, so the clone stays {after:.0f} px off it"
    return ObeyedPoint(wish.view, wish.name, "pose", before, after, mm_from_m(shift_m), note)
