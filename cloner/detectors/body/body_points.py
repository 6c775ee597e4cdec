"""Named points of a body photo: pose joints say where to look, the outline where the points are (method §3).

The steps: the net's left and right are put in order (``pose_order``); pose and contour give levels along the body
that are weighed against each other (``front_cues``, ``side_cues``, ``levels``); points are placed on the outline at
these levels, joints where the label net sees them under clothes, else halfway between a limb's borders
(``front_features``, ``side_features``); and what the photo does not show is said (``photo_states``).
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.detectors.body.front_cues import sole_row
from cloner.detectors.body.front_features import Found, SideFindings, crotch, find_side, side_points
from cloner.detectors.body.levels import load_levels, load_offsets
from cloner.detectors.body.photo_states import cut_states, front_states, turned_states
from cloner.detectors.body.pose_order import corrected_pose
from cloner.detectors.body.side_features import find_from_side, profile_points
from cloner.detectors.nets import pose_rows as net
from cloner.frames import ViewId
from cloner.generic import seen_points
from cloner.records.arrays import Array
from cloner.records.labels import Label
from cloner.records.points import PhotoState, ViewPoints, confidence_of
from cloner.records.proposals import Proposal
from cloner.vision.segmentation.outline_walk import SoftMask, soft_mask

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.body_points")


KINDS: Final = {ViewId.BODY_FRONT: "front", ViewId.BODY_SIDE: "side", ViewId.BODY_BACK: "back"}
#: Mean length of a two-dimensional normal error, in its standard deviations (Rayleigh).
MEAN_DISTANCE: Final = math.sqrt(math.pi / 2)
#: Points that set a body photo's scale.
ENDS = ("head_top", "sole_left", "sole_right")
END_ERROR: Final = _CALIBRATED.number("end_error", "figure")
CUT_ERROR: Final = _CALIBRATED.number("cut_error", "figure")
_SURE: Final = _CALIBRATED.number("sure", "score")


def propose_body_points(proposal: Proposal) -> ViewPoints:
    """Return the named body points of one photo.

    Joint centres carry their H-Anim names, outline points the names of the
    generic human's features (method §3). Points that cannot be found are absent.

    Parameters
    ----------
    proposal : Proposal
        Pose, mask and labels of a body photo.

    Raises
    ------
    ValueError
        If the mask shows nobody.
    """
    figure = soft_mask(proposal.mask)
    if figure is None:
        raise ValueError(f"{proposal.view}: the mask shows nobody")
    pose, states = corrected_pose(figure, proposal.pose_px, proposal.view)
    figure = with_cut_ends(figure, pose, KINDS[proposal.view])
    if proposal.view is ViewId.BODY_SIDE:
        found, seen = _side_points(figure, pose, proposal)
    else:
        found, seen = _front_points(figure, pose, proposal)
    found = _head_and_feet(figure, pose, proposal) | found | _label_net_joints(found, pose, proposal)
    names = tuple(found)
    return ViewPoints(
        proposal.view,
        names,
        np.array([found[name][0] for name in names]),
        np.array([confidence_of(found[name][1]) for name in names]),
        np.zeros(len(names), dtype=bool),
        states=(*states, *seen),
    )


def faces_image_right(pose_px: Array) -> bool:
    """Return whether a person seen from the side faces the image's right: nose against ears, toes against heels."""
    head = pose_px[net.NOSE, 0] - pose_px[list(net.EARS), 0].mean()
    feet = pose_px[list(net.TOES), 0].mean() - pose_px[list(net.HEELS), 0].mean()
    return bool(head + 0.5 * feet > 0)


def with_cut_ends(figure: SoftMask, pose_px: Array, kind: str) -> SoftMask:
    """Return the figure with ends beyond the photo's border placed where the pose puts them."""
    if not {"top", "bottom"} & set(figure.cut):
        return figure
    model = load_levels(kind)
    ankle, ears = (float(model.mean[model.index(name)]) for name in ("net_ankle", "net_ears"))
    rows = [float(pose_px[list(pair), 1].mean()) for pair in (net.ANKLES, net.EARS)]
    whole = (rows[0] - rows[1]) / (ears - ankle)
    top, bottom = figure.top_px.copy(), figure.bottom_px.copy()
    if "bottom" in figure.cut:
        bottom[1] = max(bottom[1], rows[0] + ankle * whole)
    if "top" in figure.cut:
        top[1] = min(top[1], rows[1] - (1.0 - ears) * whole)
    return replace(figure, top_px=top, bottom_px=bottom)


def _front_points(figure: SoftMask, pose: Array, proposal: Proposal) -> tuple[Found, list[PhotoState]]:
    """Return points and states of a front or back photo."""
    kind, hair = KINDS[proposal.view], proposal.labels == Label.HAIR
    looks = (find_side(figure, pose, net.LEFT, kind, hair), find_side(figure, pose, net.RIGHT, kind, hair))
    found: Found = {}
    for look in looks:
        found |= side_points(figure, pose, look, kind)
        found[f"sole_{net.SIDES[look.contour.side]}"] = _sole(figure, pose, look)
    fork = crotch(figure, looks, kind, proposal.labels)
    if fork is not None:
        found["crotch"] = fork
    return found, front_states(figure, pose, proposal.pose_visibility, looks, found, proposal.view)


def _sole(figure: SoftMask, pose: Array, look: SideFindings) -> tuple[Array, float]:
    """Return the lowest outline under an ankle."""
    ankle = pose[net.ANKLES[look.contour.side]]
    if "bottom" in figure.cut:
        return np.array([ankle[0], figure.bottom_px[1]]), CUT_ERROR
    return np.array([ankle[0], sole_row(figure, look.contour, float(ankle[1]))]), END_ERROR


def _side_points(figure: SoftMask, pose: Array, proposal: Proposal) -> tuple[Found, list[PhotoState]]:
    """Return points and states of a side photo."""
    right = faces_image_right(pose)
    near = net.RIGHT if right else net.LEFT
    look = find_from_side(figure, pose, near, 1.0 if right else -1.0, proposal.labels == Label.HAIR)
    found = profile_points(figure, pose, look)
    for side, name in enumerate(net.SIDES):
        error = CUT_ERROR if "bottom" in figure.cut else END_ERROR
        found[f"sole_{name}"] = np.array([pose[net.ANKLES[side], 0], figure.bottom_px[1]]), error
    return found, cut_states(figure, proposal.view) + turned_states(figure, pose, proposal.view)


def _label_net_joints(found: Found, pose: Array, proposal: Proposal) -> Found:
    """Return the joints that the label net sees under the clothes, if it ran."""
    near = "right" if faces_image_right(pose) else "left"
    shown = near if proposal.view is ViewId.BODY_SIDE else KINDS[proposal.view]
    return {
        name: (point, MEAN_DISTANCE * seen_points.point_sigma(name, shown))
        for name, point in zip(seen_points.NAMES, proposal.seen_px, strict=False)
        if name in found and name in net.JOINTS
    }


def _head_and_feet(figure: SoftMask, pose: Array, proposal: Proposal) -> Found:
    """Return the head's top and the net's own points on head and feet, corrected for their mean errors."""
    offsets, view = load_offsets(KINDS[proposal.view]), proposal.view
    forwards = 1.0 if faces_image_right(pose) else -1.0
    found: Found = {"head_top": (figure.top_px, CUT_ERROR if "top" in figure.cut else END_ERROR)}
    for name, row in net.FEATURES.items():
        side = "left" if name.endswith(("_left", "_L")) else "right"
        if not is_visible(name, side, view, right=forwards > 0):
            continue
        bare = name.removesuffix(f"_{side}").removesuffix(f"_{side[0].upper()}")
        offset, error = offsets.of(bare)
        if view is not ViewId.BODY_SIDE:
            forwards = 1.0 if (side == "left") == (view is ViewId.BODY_FRONT) else -1.0
        point = pose[row] + offset * [forwards, -1.0] * np.array(figure.height_px)
        if proposal.pose_visibility[row] > _SURE or name.startswith("ear"):
            found[name] = point, error
    return found


def is_visible(name: str, side: str, view: ViewId, *, right: bool) -> bool:
    """Return whether a feature of head or feet can be visible in a view.

    Parameters
    ----------
    name, side : the feature and its side, "left" or "right"
    view : ViewId
    right : whether a person seen from the side looks to the image's right, and so shows the right side
    """
    if view is ViewId.BODY_SIDE:
        near = "right" if right else "left"
        return not name.startswith(("heel", "toe")) and (name == "nose_tip" or side == near)
    if view is ViewId.BODY_BACK:
        return name.startswith(("ear", "heel"))
    return not name.startswith("heel")
