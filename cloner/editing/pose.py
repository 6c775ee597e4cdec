"""Poses fitted to corrected joints, so that the clone's joints lie where an operator placed them.

A corrected joint says how the limb is held in that photo, and a little where the joint lies in the limb: angles of the
limb give way first, then the joint's place in rest pose (the paper's post-correction of the skeleton). The skin in rest
pose stays as it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.editing.targets import PointConstraint
from cloner.fit.evidence import Residuals, point_residuals
from cloner.fit.problem import ParameterBlock, Problem, Values
from cloner.frames import ViewId, m_from_mm, mm_from_m
from cloner.generic.load import load_generic
from cloner.geometry.articulation.poses import FREEDOMS, SIGMAS, pose_matrix
from cloner.geometry.articulation.posing import PointModel
from cloner.geometry.cameras.motions import projection_derivatives
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
    """Priors of the solution (taste, after watching limbs follow a drag).

    Limbs lie on their outlines already, so a small move is rather the joint's place in the limb than the limb's: with
    stiffer places a knee dragged by 10 px took the whole leg 6 px off its outline.

    Its numbers: ``cloner/calibration/editing.toml``, ``[pose.*]``.

    Attributes
    ----------
    iterations : int
    """

    angle_share: float = _CALIBRATED.number("angle_share", "share")
    place_mm: float = _CALIBRATED.number("place_mm", "mm")
    kept_px: float = _CALIBRATED.number("kept_px", "px")
    exact_px: float = _CALIBRATED.number("exact_px", "px")
    most_angle: float = _CALIBRATED.number("most_angle", "rad")
    most_mm: float = _CALIBRATED.number("most_mm", "mm")
    iterations: int = 6
    tolerance: float = _CALIBRATED.number("tolerance", "factor")


@dataclass(frozen=True, slots=True, eq=False)
class _PhotoConstraints:
    """Constraints of one photo: its corrected points, and the points (N) that they and the fixed joints are.

    Points depend on how corrected joints move in rest pose (3 M), then on the angles that may turn.
    """

    posed: PosedView
    targets: tuple[PointConstraint, ...]
    points: PointModel
    sigma: Array

    def rotations(self, turned: Array) -> Array:
        """Return the rotations (94, 3) after angles changed by (F,) radians."""
        return self.points.rotations(turned)

    def seen(self, shift_m: Array, turned: Array) -> tuple[Array, Array]:
        """Return the projected points (N, 2) px, and their Jacobian (N, 2, 3 M + F)."""
        moved = self.points.moved(shift_m, turned)
        pixels, by_points, _ = projection_derivatives(self.posed.camera, moved.points_m)
        return pixels, by_points @ np.concatenate([moved.by_shape, moved.by_pose], axis=2)


def obey_pose(
    vertices_m: Array, joints_m: Array, views: Mapping[ViewId, PosedView], targets: list[PointConstraint]
) -> tuple[Array, dict[ViewId, PosedView], list[ObeyedPoint]]:
    """Return the joints in rest pose (94, 3), the poses, and how well each corrected joint is met.

    Parameters
    ----------
    vertices_m : (V, 3) rest pose
    joints_m : (94, 3) rest pose
    views : mapping
        Camera and pose of every body photo.
    targets : list of Wish
    """
    if not targets:
        return joints_m, dict(views), []
    params, generic = Params(), load_generic()
    rows = sorted({generic.joint(target.name) for target in targets if target.name in generic.joint_names})
    held = {
        view.value: _photo_constraints(
            vertices_m, joints_m, rows, views[view], tuple(one for one in targets if one.view is view), params
        )
        for view in dict.fromkeys(target.view for target in targets)
    }
    found = _solve_joints(held, len(rows), params)
    shift_m, poses, outcomes = found["places"].reshape(-1, 3), dict(views), {}
    joints = joints_m.copy()
    joints[rows] += shift_m
    for name, one in held.items():
        view = one.posed.view
        poses[view] = PosedView(view, one.posed.camera, one.rotations(found[name]))
        was, _ = one.seen(0.0 * found["places"], 0.0 * found[name])
        now, _ = one.seen(found["places"], found[name])
        for target, old, new in zip(one.targets, was, now, strict=False):  # joints to be kept follow the wishes
            row = rows.index(generic.joint(target.name)) if target.name in generic.joint_names else -1
            outcomes[id(target)] = _outcome(target, old, new, float(np.linalg.norm(shift_m[row])) if row >= 0 else 0.0)
    return joints, poses, [outcomes[id(target)] for target in targets]


def _photo_constraints(
    vertices_m: Array,
    joints_m: Array,
    rows: list[int],
    posed: PosedView,
    targets: tuple[PointConstraint, ...],
    params: Params,
) -> _PhotoConstraints:
    """Return the constraints of one photo; ``rows`` are the joints that may move in rest pose."""
    generic, starts = load_generic(), set[str]()
    for target in targets:
        words = target.name.split("_")
        side = next((word[0] for word in words if word in ("l", "r", "left", "right")), "")
        limb = next((LIMB_OF[word] for word in words if word in LIMB_OF), "")
        starts |= {f"{side}_{part}" for part in LIMBS[limb]} if limb else {"neck"}
    columns = [k for k, freedom in enumerate(FREEDOMS) if freedom.name.startswith(tuple(starts))]
    names = (*(target.name for target in targets), *KEPT)
    moves = np.zeros((len(joints_m), 3, 3 * len(rows)))
    for place, row in enumerate(rows):
        moves[row, :, 3 * place : 3 * place + 3] = np.eye(3)
    own = [generic.joint(name) if name in generic.joint_names else -1 for name in names]
    skin = [0 if joint >= 0 else generic.feature(name) for name, joint in zip(names, own, strict=True)]
    is_joint, influences = np.array(own) >= 0, generic.skin_joints.shape[1]
    points = PointModel(
        np.where(is_joint[:, None], joints_m[own], vertices_m[skin]),
        np.where(is_joint[:, None, None], moves[own], 0.0),
        joints_m,
        moves,
        np.asarray(generic.joint_parents, dtype=np.int64),
        np.where(is_joint[:, None], np.array(own)[:, None], generic.skin_joints[skin]),
        np.where(is_joint[:, None], np.eye(influences)[0], generic.skin_weights[skin].astype(np.float64)),
        pose_matrix(generic.joint_names)[:, columns],
        posed.rotations.ravel(),
    )
    return _PhotoConstraints(posed, targets, points, params.angle_share * SIGMAS[columns])


def _solve_joints(held: Mapping[str, _PhotoConstraints], count: int, params: Params) -> Values:
    """Return the displacements of ``count`` joints in rest pose ("places", (3 count,)), and every photo's changes of
    angles.
    """
    most_m, still = m_from_mm(params.most_mm), np.zeros(3 * count)
    blocks = {"places": ParameterBlock(still, sigma=m_from_mm(params.place_mm), lower=-most_m, upper=most_m)}
    goals, sigma_px = {}, {}
    for name, one in held.items():
        start, most = np.zeros(len(one.sigma)), params.most_angle
        blocks[name] = ParameterBlock(start, sigma=one.sigma, lower=-most, upper=most)
        kept_px = one.seen(still, start)[0][len(one.targets) :]
        goals[name] = np.concatenate([[target.target_px for target in one.targets], kept_px])
        sigma_px[name] = np.repeat([params.exact_px, params.kept_px], [len(one.targets), len(kept_px)])

    def linearise(values: Values, iteration: int) -> Iterator[Residuals]:
        for name, one in held.items():
            seen, jacobian = one.seen(values["places"], values[name])
            yield point_residuals(("places", name), seen - goals[name], jacobian, sigma_px[name])

    return Problem(blocks).solve(linearise, iterations=params.iterations, tolerance=params.tolerance).values


def _outcome(target: PointConstraint, was_px: Array, now_px: Array, shift_m: float) -> ObeyedPoint:
    """Return the outcome for a corrected point."""
    before, after = (float(np.linalg.norm(seen - target.target_px)) for seen in (was_px, now_px))
    note = "" if after <= 1.0 else f"the limb does not reach it, so the clone stays {after:.0f} px off it"
    return ObeyedPoint(target.view, target.name, "pose", before, after, mm_from_m(shift_m), note)
