"""Prior weights of each photo on each part of the generic human, before viewing angles."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.load import GenericHuman

# All taste, judged by eye on the sample visitors. A side photo at 0.75 takes over where the surface turns
# more than about 53 degrees away from the front photo; the face's 1.3 moves that border behind the cheek.
_SIDE = 0.75
_MIRRORED = 0.7  # a mirrored photo shows the other half only by assumption
_FACE_FRONT = 1.3
_EAR_SIDE = 1.6
_BODY_ON_HEAD = {ViewId.BODY_FRONT: 0.12, ViewId.BODY_SIDE: 0.1, ViewId.BODY_BACK: 0.6}
# An arm hangs before the body in the side photo: a few pixels off, it would take the shirt's colour. Front and back
# photos see arms against the background.
_ARM_SIDE = {"upper_arm": 0.4, "forearm": 0.15, "hand": 0.1}
# Collars belong to the face photos: two photos never agree about them to the millimetre, further down on plain cloth
# they may. Arms hang in no known pose in face photos, so they keep near the neck; from the side the top of a shoulder
# is seen in none as well as there.
_SHOULDER_REACH_M, _SIDE_REACH_M = 0.08, 0.13
# With no photo of the body the front of the chest is painted as far as a portrait shows it; forearms and what hands
# hold lie before the trunk below that.
_CHEST_REACH_M = 0.25


def photo_shares(generic: GenericHuman, view: ViewId, *, photos: frozenset[ViewId]) -> NDArray[np.float64]:
    """Return factors (V,) >= 0 that scale a photo's claim on each vertex.

    Parameters
    ----------
    generic : GenericHuman
    view : ViewId
    photos : frozenset of ViewId
        The photos there are: those of the face keep those of the body off the head, and paint the chest without them.
    """
    faces = frozenset(one for one in photos if one.is_face)
    reach = _SIDE_REACH_M if view.is_side else _SHOULDER_REACH_M
    if view is ViewId.FACE_FRONT and faces == photos:
        reach = _CHEST_REACH_M
    head = np.maximum(head_weight(generic), _beside_neck(generic, reach)) if faces else head_weight(generic)
    ears = generic.region("ear_left") | generic.region("ear_right")
    if view is ViewId.FACE_FRONT:
        return head * np.where(generic.region("face"), _FACE_FRONT, 1.0) * np.where(ears, 0.6, 1.0)
    if view is ViewId.FACE_SIDE:
        return head * np.where(ears, _EAR_SIDE, _SIDE)
    on_body = np.ones(len(head))
    if view is ViewId.BODY_SIDE:
        on_body[:] = _SIDE
        for name, share in _ARM_SIDE.items():
            on_body[_segments(generic, (name,))] = share
    covered = {
        ViewId.BODY_FRONT: ViewId.FACE_FRONT in faces,
        ViewId.BODY_SIDE: ViewId.FACE_SIDE in faces,
        ViewId.BODY_BACK: bool(faces),
    }[view]
    on_head = _BODY_ON_HEAD[view] if covered else on_body
    return on_body * (1.0 - head) + on_head * head


def mirrored_share() -> float:
    """Return the factor on a photo's claim for the half that it does not show."""
    return _MIRRORED


def head_weight(generic: GenericHuman) -> NDArray[np.float64]:
    """Return (V,) weights, 1 on the head, 0 below the base of the neck."""
    weight = np.zeros(len(generic.vertices_m))
    weight[: generic.head_blend.size] = generic.head_blend
    return weight


def arms_beside_head(generic: GenericHuman) -> NDArray[np.bool_]:
    """Return (V,) upper arms: in a side photo they lie before neck and collar when the shoulder is misjudged."""
    return _segments(generic, ("upper_arm",))


def lower_arms(generic: GenericHuman) -> NDArray[np.bool_]:
    """Return (V,) forearms and hands."""
    return _segments(generic, ("forearm", "hand"))


def arms(generic: GenericHuman) -> NDArray[np.bool_]:
    """Return (V,) arms with their hands."""
    return _segments(generic, tuple(_ARM_SIDE))


def _segments(generic: GenericHuman, endings: tuple[str, ...]) -> NDArray[np.bool_]:
    """Return (V,) where the segments of both sides with these names are."""
    names = [k for k, name in enumerate(generic.segment_names) if name.endswith(endings)]
    return np.isin(generic.vertex_segment, names)


def _beside_neck(generic: GenericHuman, reach_m: float) -> NDArray[np.float64]:
    """Return (V,) weights falling from 1 at the neck's base to 0 on the shoulders."""
    base = generic.vertices_m[generic.region("neck")].astype(np.float64)
    low = base[base[:, 1] < np.quantile(base[:, 1], 0.2)]
    gap = np.linalg.norm(generic.vertices_m[:, None, [0, 2]] - low[None, ::4, [0, 2]], axis=2).min(axis=1)
    below = np.clip((low[:, 1].mean() - generic.vertices_m[:, 1]) / reach_m, 0.0, 1.0)
    on_torso = ~_segments(generic, tuple(_ARM_SIDE)) & (generic.vertices_m[:, 1] > low[:, 1].mean() - reach_m)
    return np.where(on_torso, np.clip(1.0 - gap / reach_m, 0.0, 1.0) * (1.0 - below), 0.0)
