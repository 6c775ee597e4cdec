"""Picking: which point or piece of outline is meant, the next point, and a point's expected mirrored partner."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Final

import numpy as np

from cloner.frames import ViewId
from cloner.records.arrays import Array
from cloner.records.points import ViewPoints

_PARTNER_ENDS: Final = (("_L", "_R"), ("_left", "_right"))
_PARTNER_STARTS: Final = (("l_", "r_"),)
#: Photos in which left and right mirror each other.
_FLAT: Final = (ViewId.BODY_FRONT, ViewId.BODY_BACK, ViewId.FACE_FRONT)


def nearest_point(places: Array, at: tuple[float, float], reach: float) -> int | None:
    """Return the row of the point nearest to ``at``, or None if all are farther than ``reach``.

    Parameters
    ----------
    places : (N, 2) float64, widget coordinates
    at : (x, y), same frame
    reach : float, same unit
    """
    if not len(places):
        return None
    distance = np.linalg.norm(places - np.asarray(at), axis=1)
    row = int(np.argmin(distance))
    return row if distance[row] <= reach else None


def nearest_on_outline(borders_px: Iterable[Array], at_px: tuple[float, float], reach_px: float) -> Array | None:
    """Return the (2,) corner of the closed borders (M, 2) nearest to a place, None beyond reach."""
    corners = [border for border in borders_px if len(border)]
    if not corners:
        return None
    every = np.concatenate(corners)
    row = nearest_point(every, at_px, reach_px)
    return None if row is None else every[row]


def worst_first(points: Mapping[ViewId, ViewPoints]) -> list[tuple[ViewId, str]]:
    """Return the proposed points of all photos in the order of their expected improvement by a correction.

    See `cloner.editing.order.by_expected_gain`; what an operator placed comes last.
    """
    from cloner.editing.order import by_expected_gain  # with the generic human: not paid for at the start

    return by_expected_gain(points)


def next_in_order(
    order: list[tuple[ViewId, str]], now: tuple[ViewId, str] | None, step: int
) -> tuple[ViewId, str] | None:
    """Return the point ``step`` places after ``now`` in an order, cyclically; the first without ``now``."""
    if not order:
        return None
    if now not in order:
        return order[0 if step > 0 else -1]
    return order[(order.index(now) + step) % len(order)]


def mirrored_name(name: str) -> str:
    """Return the name of the same point on the person's other side, "" for points in the middle."""
    for here, there in (*_PARTNER_ENDS, *(pair[::-1] for pair in _PARTNER_ENDS)):
        if name.endswith(here):
            return name.removesuffix(here) + there
    for here, there in (*_PARTNER_STARTS, *(pair[::-1] for pair in _PARTNER_STARTS)):
        if name.startswith(here):
            return there + name.removeprefix(here)
    return ""


def expected_mirror_px(points: ViewPoints, name: str) -> Array | None:
    """Return the (2,) pixel of a point's mirrored partner if the person were symmetric in the photo; or None.

    The mirror is the line through the middles of all other pairs, perpendicular to what joins them.
    """
    other, place = mirrored_name(name), points.get(name)
    if points.view not in _FLAT or not other or place is None:
        return None
    pairs = [
        (points.points_px[row], points.get(mirrored_name(own)))
        for row, own in enumerate(points.names)
        if own not in (name, other) and own.endswith(("_L", "_left")) | own.startswith("l_")
    ]
    ends = np.array([(first, second) for first, second in pairs if second is not None])
    if len(ends) < 3:
        return None
    across = ends[:, 0] - ends[:, 1]
    across = across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-9)
    normal = np.median(across, axis=0)
    normal = normal / max(float(np.linalg.norm(normal)), 1e-9)
    middle = float(np.median(ends.mean(axis=1) @ normal))
    return np.asarray(place - 2.0 * (float(place @ normal) - middle) * normal)
