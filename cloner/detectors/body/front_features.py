"""Named points of a front or back photo: levels from pose and contour together, points on the contour itself."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.body.front_cues import arm_cues, front_cues, row_of, sole_row
from cloner.detectors.body.levels import Levels, Offsets, infer_levels, load_levels, load_offsets
from cloner.detectors.body.side_contours import SideContour, arm_polyline, find_side_contour
from cloner.detectors.nets import pose_rows as net
from cloner.records.arrays import Array
from cloner.records.labels import Label, labels_at
from cloner.vision.segmentation.outline_walk import SoftMask, Strip, gap_apex

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.front_features")

#: A point with its expected error, share of the figure's height.
Placed = tuple[Array, float]
Found = dict[str, Placed]

#: Mean size of a normal error, in its standard deviations.
MEAN_OF_NORMAL: Final = 0.8
MASK_ERROR: Final = _CALIBRATED.number("mask_error", "figure")
ARM_WIDTH: Final = _CALIBRATED.number("arm_width", "figure")
_LEAN: Final = _CALIBRATED.number("lean", "factor")
GAP_ASTRAY: Final = _CALIBRATED.number("gap_astray", "figure")
GAP_ERROR: Final = _CALIBRATED.number("gap_error", "figure")
HEM_REACH: Final = _CALIBRATED.pair("hem_reach", "figure")
NECK_REACH: Final = _CALIBRATED.number("neck_reach", "figure")
FOOT_END: Final = _CALIBRATED.number("foot_end", "figure")


@dataclass(frozen=True, slots=True, eq=False)
class SideFindings:
    """What was found along one side of a front or back photo.

    Attributes
    ----------
    contour : SideContour
    cues : mapping of str to float
        Seen levels.
    levels : Levels
        All levels given the seen ones.
    arm : Strip
        Outline across the arm; ``far`` is outwards.
    arm_share : (T,) float64
        Place of every entry of ``arm`` as a share of the arm's length.
    arm_levels : Levels
        Places along the arm.
    """

    contour: SideContour
    cues: Mapping[str, float]
    levels: Levels
    arm: Strip
    arm_share: Array
    arm_levels: Levels

    def used(self, cue: str) -> bool:
        """Return whether a level was found and agrees with the others."""
        return cue in self.cues and cue not in self.levels.refused


def find_side(figure: SoftMask, pose_px: Array, side: int, kind: str, hair: NDArray[np.bool_]) -> SideFindings:
    """Return what pose and contour show along one side.

    Parameters
    ----------
    figure : Figure
    pose_px : (33, 2) float64
    side : int
    kind : "front" or "back"
    hair : (H, W) bool
    """
    contour = find_side_contour(figure, pose_px, side, hair)
    cues = front_cues(figure, pose_px, contour)
    places, strip, share = arm_cues(figure, pose_px, side)
    return SideFindings(
        contour,
        cues,
        infer_levels(load_levels(kind), cues),
        strip,
        share,
        infer_levels(load_levels(f"arm_{kind}"), places),
    )


def side_points(figure: SoftMask, pose_px: Array, look: SideFindings, kind: str) -> Found:
    """Return the named points of one side, joints too."""
    name = net.SIDES[look.contour.side]
    found = {f"{n}_{name}": placed for n, placed in _contour_points(figure, look).items()}
    found |= {f"{n}_{name}": placed for n, placed in _arm_contour_points(figure, look).items()}
    found |= {f"{n}_{name}": placed for n, placed in _shoulder(figure, pose_px, look).items()}
    armpit = _armpit(figure, pose_px, look, kind)
    if armpit is not None:
        found[f"armpit_{name}"] = armpit
    offsets = load_offsets(kind)
    foot = foot_end(figure, pose_px, look)
    if foot is not None and "bottom" not in figure.cut:
        end = "toe" if kind == "front" else "heel"
        found[f"{end}_{name}"] = _corrected_joint(figure, look, end, {"outline": foot}, offsets)
    for joint, places in joint_places(figure, pose_px, look).items():
        found[f"{name[0]}_{joint}"] = _corrected_joint(figure, look, joint, places, offsets)
    return found


def _contour_point(figure: SoftMask, look: SideFindings, name: str, *, far: bool) -> Placed | None:
    """Return the contour at a feature's level, with its expected error."""
    place = look.contour.place(row_of(figure, look.levels.level[name]))
    point = look.contour.strip.border_px(place, far=far)
    if point is None:
        return None
    step = 0.01 * figure.height_px
    ends = [look.contour.strip.border_px(place + at, far=far) for at in (-step, step)]
    lean = [abs(float(end[0] - point[0])) / step for end in ends if end is not None]
    steep = min(float(np.mean(lean)), _LEAN) if lean else _LEAN
    return point, _level_error(look.levels.sigma[name]) * float(np.hypot(1.0, steep)) + MASK_ERROR


def _level_error(sigma: float) -> float:
    return MEAN_OF_NORMAL * sigma


def _contour_points(figure: SoftMask, look: SideFindings) -> Found:
    """Return the points on the contours of trunk and leg."""
    contour, found = look.contour, dict[str, Placed]()
    for name in ("waist", "hip", "knee_outer", "ankle_outer", "knee_inner", "ankle_inner"):
        entry = round(np.clip(contour.place(row_of(figure, look.levels.level[name])), 0, len(contour.rows) - 1))
        inner = name.endswith("inner")
        hidden = contour.leg_gap[entry] <= 0.0 if inner else contour.arm_outline[entry]
        placed = None if hidden else _contour_point(figure, look, name, far=not inner)
        if placed is not None:
            found[name] = placed
    return found


def _arm_contour_points(figure: SoftMask, look: SideFindings) -> Found:
    """Return the points on the arm's contours."""
    found: Found = {}
    length = look.arm_levels.level["net_length"]
    for name in ("elbow_outer", "elbow_inner", "wrist_outer", "wrist_inner"):
        place = float(np.interp(look.arm_levels.level[name], look.arm_share, np.arange(len(look.arm_share))))
        point = look.arm.border_px(place, far=name.endswith("outer"))
        if point is None or not _is_arm(figure, look, place):
            continue
        found[name] = point, _level_error(look.arm_levels.sigma[name]) * length + MASK_ERROR
    return found


def _is_arm(figure: SoftMask, look: SideFindings, place: float) -> bool:
    """Return whether the contour across an arm's axis belongs to the arm alone."""
    width = look.arm.width[round(np.clip(place, 0, len(look.arm.near) - 1))]
    return bool(np.isfinite(width) and width < ARM_WIDTH * figure.height_px)


def _shoulder(figure: SoftMask, pose_px: Array, look: SideFindings) -> Found:
    """Return the base of the neck and the end of the shoulder, as shares of the shoulder width."""
    shoulders = pose_px[list(net.SHOULDERS)]
    middle, own = shoulders.mean(axis=0), shoulders[look.contour.side]
    breadth = abs(float(own[0] - middle[0])) / figure.height_px
    column = {
        name: float(middle[0] + look.arm_levels.level[name] * (own[0] - middle[0]))
        for name in ("neck_base", "shoulder_end")
    }
    error = {name: _level_error(look.arm_levels.sigma[name]) * breadth for name in column}
    found: Found = {}
    rows = np.arange(own[1] + 0.03 * figure.height_px, own[1] - 0.10 * figure.height_px, -1.0)
    line = np.stack([np.full(len(rows), column["shoulder_end"]), rows], axis=1)
    inside = figure.inside(line)
    if inside.any() and not inside[-1]:
        last = int(np.flatnonzero(inside)[-1])
        found["shoulder_end"] = figure.crossing(line[last], line[last + 1]), error["shoulder_end"] + MASK_ERROR
    base = np.array([column["neck_base"], row_of(figure, look.levels.level["neck_base"])])
    nearest = look.contour.strip.nearest_px(base, far=True, reach_px=NECK_REACH * figure.height_px)
    if nearest is not None and not look.contour.veiled[round(look.contour.place(float(nearest[1])))]:
        level_error = _level_error(look.levels.sigma["neck_base"])
        found["neck_base"] = nearest, float(np.hypot(error["neck_base"], level_error)) + MASK_ERROR
    return found


def _armpit(figure: SoftMask, pose_px: Array, look: SideFindings, kind: str) -> Placed | None:
    """Return the top of the background between arm and trunk, None where it is not the armpit's."""
    contour = look.contour
    if not look.used("cue_armpit"):
        return None
    row = row_of(figure, look.cues["cue_armpit"])
    entry = round(contour.place(row))
    line = arm_polyline(pose_px, contour.side)
    arm = np.array([np.interp(row, np.maximum.accumulate(line[:, 1]), line[:, 0]), row])
    return _gap_point(figure, look, "armpit", kind, contour.strip.centres_px[entry], arm)


def crotch(
    figure: SoftMask, looks: tuple[SideFindings, SideFindings], kind: str, labels: NDArray[np.uint8]
) -> Placed | None:
    """Return the top of the background between the legs, None where it is not the crotch.

    Under the hem of a coat or a long shirt it is not: there the garment above ends and the legs go on in another.
    """
    if not looks[0].used("cue_crotch"):
        return None
    entries = [round(look.contour.place(row_of(figure, looks[0].cues["cue_crotch"]))) for look in looks]
    ends = [look.contour.strip.centres_px[entry] for look, entry in zip(looks, entries, strict=True)]
    placed = _gap_point(figure, looks[0], "crotch", kind, ends[0], ends[1])
    return None if placed is None or _under_a_hem(labels, placed[0], np.array(ends), figure.height_px) else placed


def _under_a_hem(labels: NDArray[np.uint8], apex_px: Array, ends_px: Array, height_px: float) -> bool:
    """Return whether upper clothes are seen above a gap, and none on both legs (2, 2) px beside it."""
    steps = height_px * np.linspace(*HEM_REACH, 8)
    above = labels_at(labels, apex_px - steps[:, None] * [0.0, 1.0])
    legs = [np.array([column, apex_px[1]]) for column in ends_px[:, 0]]
    below = [labels_at(labels, leg + steps[:, None] * [0.0, 1.0]) for leg in legs]
    upper = [float(np.mean(seen == Label.UPPER_CLOTHES)) for seen in (above, *below)]
    return upper[0] > 0.5 > max(upper[1:])


def _gap_point(
    figure: SoftMask, look: SideFindings, name: str, kind: str, first_px: Array, second_px: Array
) -> Placed | None:
    """Return the top of a gap; its confidence falls with the distance from where it usually opens."""
    model = load_levels(kind)
    usual = float(model.mean[model.index(name)] - model.mean[model.index(f"cue_{name}")])
    away = look.levels.level[name] - look.cues[f"cue_{name}"] - usual
    if away > GAP_ASTRAY:
        return None
    ordered = (first_px, second_px) if first_px[0] < second_px[0] else (second_px, first_px)
    return gap_apex(figure, *ordered), float(np.hypot(GAP_ERROR, away)) + MASK_ERROR


def joint_places(figure: SoftMask, pose_px: Array, look: SideFindings) -> dict[str, dict[str, Array]]:
    """Return positions of the joint centres before their mean error is subtracted.

    Each joint maps to places by source: ``net`` keeps the net's place across the limb,
    ``middle`` lies halfway between the limb's two outline points (method §5).
    """
    contour, found = look.contour, dict[str, dict[str, Array]]()
    for joint, pair in (("shoulder", net.SHOULDERS), ("hip", net.HIPS), ("knee", net.KNEES), ("ankle", net.ANKLES)):
        row = row_of(figure, look.levels.level[f"joint_{joint}"])
        found[joint] = {"net": np.array([pose_px[pair[contour.side], 0], row])}
        entry = round(np.clip(contour.place(row), 0, len(contour.rows) - 1))
        middle = contour.strip.middle_px[entry]
        if joint in ("knee", "ankle") and contour.leg_gap[entry] > 0.0 and np.isfinite(middle).all():
            found[joint]["middle"] = np.array([middle[0], row])
    for joint, pair in (("elbow", net.ELBOWS), ("wrist", net.WRISTS)):
        found[joint] = {"net": pose_px[pair[contour.side]]}
        place = np.interp(look.arm_levels.level[f"joint_{joint}"], look.arm_share, np.arange(len(look.arm_share)))
        entry = round(float(place))
        if _is_arm(figure, look, place) and np.isfinite(look.arm.middle_px[entry]).all():
            found[joint]["middle"] = look.arm.middle_px[entry]
    return found


def foot_end(figure: SoftMask, pose_px: Array, look: SideFindings) -> Array | None:
    """Return the middle of the foot a little above its lowest row: the toes from the front, the heel from behind."""
    contour = look.contour
    sole = sole_row(figure, contour, float(pose_px[net.ANKLES[contour.side], 1]))
    entry = round(contour.place(sole - FOOT_END * figure.height_px))
    if not 0 <= entry < len(contour.rows) or contour.leg_gap[entry] <= 0.0:
        return None
    middle = contour.strip.middle_px[entry]
    return middle if np.isfinite(middle).all() else None


def _corrected_joint(
    figure: SoftMask, look: SideFindings, joint: str, places: Mapping[str, Array], offsets: Offsets
) -> Placed:
    """Return a point's best position without its mean error, and the remaining error."""
    source = next(name for name in ("outline", "middle", "net") if name in places)
    offset, left = offsets.of(f"{joint}_{source}")
    outwards_up = np.array([look.contour.outwards, -1.0]) * figure.height_px
    return places[source] + offset * outwards_up, left
