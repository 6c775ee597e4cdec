"""Stage: two skeletons from key joints (paper §3.3), and their consensus.

Key joints (shoulders, elbows, wrists, hips, knees, ankles) move to the middle of
the limb's two outline points at their level; the remaining of the 94 joints
follow by maps between key joints along the hierarchy, hands and feet with their
parent. Two skeletons result: front and side, back and side. Where a net sees the joints
under the clothes the phenotype's lie there already, and stay: the middles of outlines
were farther off (``docs/ablation.md``).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.body.clothes import clothed_body
from cloner.body.outlined import (
    OutlinedPhoto,
    PosedSilhouette,
    outlined_photos,
    paper_body_views,
    posed_silhouette,
    slice_pairs,
)
from cloner.calibration.loader import calibrated
from cloner.frames import ViewId, m_from_mm, mm_from_m
from cloner.generic.load import GenericHuman, load_generic
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh, Phenotype, Skeleton, SkeletonSet
from cloner.records.proposals import Proposals
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import SilhouetteSet

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.skeleton")


@dataclass(frozen=True, slots=True)
class Params:
    """Limits of the key joints' motion.

    Its numbers: ``cloner/calibration/stages.toml``, ``[skeleton.*]``.
    """

    reach_mm: float = _CALIBRATED.number("reach_mm", "mm")
    most_mm: float = _CALIBRATED.number("most_mm", "mm")


#: Key joints: the grid segments that meet there, with the slice nearest to the joint.
KEY_JOINTS = {
    "elbow": (("upper_arm", 0.9), ("forearm", 0.1)),
    "wrist": (("forearm", 0.93),),
    "knee": (("thigh", 0.93), ("calf", 0.07)),
    "ankle": (("calf", 0.93),),
}


def key_shift(
    photos: tuple[tuple[OutlinedPhoto, PosedSilhouette], ...], side: str, joint: str, params: Params
) -> Array:
    """Return the rest-pose displacement (3,) of a key joint towards the middle of the limb's outline, metres."""
    shifts = []
    for photo, seen in photos:
        for part, level in KEY_JOINTS[joint]:
            pairs = slice_pairs(seen, photo, f"{side}_{part}", np.array([level]), params.reach_mm)
            if pairs.valid[0].all():
                shifts.append(pairs.shift_m[0].mean(axis=0))
    if not shifts:
        return np.zeros(3)
    shift = np.mean(shifts, axis=0)
    limit = m_from_mm(params.most_mm)
    return np.asarray(shift * min(1.0, limit / max(float(np.linalg.norm(shift)), 1e-9)))


def along_hierarchy(generic: GenericHuman, joints_m: Array, shifts: dict[str, Array]) -> Array:
    """Return the joints (94, 3) after key joints moved; every other joint moves with its nearest key ancestor."""
    moved = np.zeros_like(joints_m)
    for row, (name, parent) in enumerate(zip(generic.joint_names, generic.joint_parents, strict=True)):
        inherited = moved[parent] if parent >= 0 else np.zeros(3)
        moved[row] = shifts.get(name, inherited)
    return np.asarray(joints_m + moved)


def run(
    *,
    proposals: Proposals,
    silhouettes: SilhouetteSet,
    phenotype: Phenotype,
    tick: Callable[[float], None],
) -> StageResult:
    """Produce the front+side and back+side skeletons and their consensus, in rest pose."""
    params, generic = Params(), load_generic()
    vertices, joints = clothed_body(phenotype)
    mesh = BodyMesh(vertices, joints)
    photos = outlined_photos(phenotype, silhouettes, proposals)
    made = {}
    for number, main in enumerate((ViewId.BODY_FRONT, ViewId.BODY_BACK)):
        pair = tuple(
            (photo, posed_silhouette(mesh, photo))
            for photo in paper_body_views(photos, main)
            if photo.view is not ViewId.BODY_SIDE and not len(proposals.views[photo.view].seen_px)
        )
        shifts = {
            f"{side[0]}_{joint}": key_shift(pair, side, joint, params)
            for side in ("left", "right")
            for joint in KEY_JOINTS
        }
        made[main] = along_hierarchy(generic, joints, shifts)
        tick((number + 1) / 2)
    front, back = made[ViewId.BODY_FRONT], made[ViewId.BODY_BACK]
    apart = mm_from_m(float(np.linalg.norm(front - back, axis=1).max()))
    value = SkeletonSet(Skeleton(front), Skeleton(back), Skeleton((front + back) / 2))
    return StageResult({"skeletons": value}, (Residual("two skeletons apart, worst joint", apart, "mm"),))
