"""Initial placement of pieces wrapped around trunk, arms and legs: close without contact, seams half-way.

Where the cloth round a part is wider than the part, its ring is moved outward until it is as long as the cloth; above
the height at which the pieces close round the body (armpits, the sleeve's cap) they keep the width they had there.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.cloth.drafting.cut import Cloth
from cloner.cloth.drafting.pattern import Pattern, Segment, evenly_spaced
from cloner.cloth.drafting.sections import STEP_M, Sections, girth_of, offset_ring
from cloner.cloth.simulation.core.host import push_out_of_skin
from cloner.cloth.simulation.placing import OUTSIDE_M
from cloner.cloth.simulation.wearer import make_wearer, skin_interval
from cloner.records.arrays import Array

Ints = NDArray[np.int64]

#: By how much points of an outline may lie beyond it, metres.
ROUNDED_M: Final = 1e-9
#: Cloth round a part closes where it has at least this share of the part's girth.
CLOSES: Final = 0.9
#: Steps of height in which an armhole may begin.
ARMHOLE: Final = 5
#: Times that cloth is pushed out of the skin after seams were closed, and how far it may lie in it.
PUSHES, DEEP_M = 12, 0.12


def wrap_around(pattern: Pattern, cloth: Cloth, body: Sections) -> tuple[Array, Ints, Array]:
    """Return positions (N, 3) of a garment's vertices around the body at rest, the held vertices, and
    their positions.
    """
    points = np.zeros((len(cloth.flat_m), 3))
    widths = {part: _width(pattern, part, body) for part in {_part(segment) for segment in pattern.segments}}
    for number, segment in enumerate(pattern.segments):
        own = cloth.segment == number
        points[own] = _wrapped_places(segment, cloth.flat_m[own], body, widths)
    places = cloth.seam_means(points)
    skin = make_wearer(body.clone, whole=True)
    skin_m = body.clone.vertices_m[skin.rows]
    now = skin_interval(skin, skin_m, skin_m)
    left, right = (_of_leg(side, pattern, cloth) for side in ("left", "right"))
    for _ in range(PUSHES):
        places = push_out_of_skin(places, now, OUTSIDE_M, DEEP_M)
        places[left & ~right, 0] = np.maximum(places[left & ~right, 0], OUTSIDE_M)  # legs' pieces do not cross
        places[right & ~left, 0] = np.minimum(places[right & ~left, 0], -OUTSIDE_M)
    held = np.unique(cloth.vertex[np.concatenate([np.zeros(0, np.int64), *(cloth.edges[e] for e in pattern.held)])])
    return places, held, places[held]


def _of_leg(side: str, pattern: Pattern, cloth: Cloth) -> NDArray[np.bool_]:
    """Return (N,) whether vertices belong to a leg's pieces."""
    own = np.zeros(cloth.count, dtype=bool)
    for number, segment in enumerate(pattern.segments):
        if segment.around.startswith(f"{side}_leg"):
            own[cloth.vertex[cloth.segment == number]] = True
    return own


def _part(segment: Segment) -> str:
    """Return the part whose sections a piece surrounds: legs' pieces surround the trunk above the crotch."""
    return segment.around if segment.around.endswith("_arm") else "trunk"


def _spans(segment: Segment, heights: Array) -> tuple[Array, Array]:
    """Return the least and largest x of a piece at heights; NaN outside the piece."""
    outline = np.concatenate([evenly_spaced(edge, 24)[:-1] for edge in segment.edges.values()])
    start, end = outline, np.roll(outline, -1, axis=0)
    low, high = np.full(len(heights), np.inf), np.full(len(heights), -np.inf)
    for one, other in zip(start, end, strict=True):
        inside = (heights >= min(one[1], other[1]) - ROUNDED_M) & (heights <= max(one[1], other[1]) + ROUNDED_M)
        share = (heights[inside] - one[1]) / (other[1] - one[1]) if other[1] != one[1] else 0.0
        at = one[0] + share * (other[0] - one[0])
        low[inside], high[inside] = np.minimum(low[inside], at), np.maximum(high[inside], at)
    none = low > high
    return np.where(none, np.nan, low), np.where(none, np.nan, high)


def _width(pattern: Pattern, part: str, body: Sections) -> Callable[[Array], Array]:
    """Return the total width of all pieces around a part, by height."""
    own = [segment for segment in pattern.segments if _part(segment) == part]
    ends = [edge[[0, 3], 1] for segment in own for edge in segment.edges.values()]
    highest = float(np.max(ends))
    heights = np.append(np.arange(float(np.min(ends)), highest, STEP_M), highest)  # a waist is narrower than below
    total = np.zeros(len(heights))
    for segment in own:
        low, high = _spans(segment, heights)
        if segment.around.startswith(("left_leg", "right_leg")):  # what reaches between the legs is round no trunk
            low, high = np.clip([low, high], *((0.0, 9.0) if np.nanmax(high) > -np.nanmin(low) else (-9.0, 0.0)))
        total += np.nan_to_num(high - low)
    base = body.waist_m if part == "trunk" else 0.0
    closed = np.array([w >= CLOSES * body.girth(part, base + y) for y, w in zip(heights, total, strict=True)])
    if closed.any():
        last = int(np.flatnonzero(closed)[-1])
        if last < np.flatnonzero(total)[-1]:  # an armhole, which cuts in before the cloth is too narrow
            first = max(0, last - ARMHOLE)
            last = first + int(np.argmax(total[first : last + 1]))
        total[last:] = total[last]
    return lambda y: np.interp(y, heights, np.maximum(total, 1e-3))


def _wrapped_places(
    segment: Segment, flat: Array, body: Sections, widths: dict[str, Callable[[Array], Array]]
) -> Array:
    """Return the positions (N, 3) of a piece's points."""
    part, around = _part(segment), segment.around
    width = widths[part](flat[:, 1])
    turn = 0.5 if around.endswith("back") else 0.0
    share = turn + flat[:, 0] / width
    if "_leg_" not in around:
        base = body.waist_m if part == "trunk" else 0.0
        height = np.interp(flat[:, 1], *np.transpose(segment.lies)) if segment.lies else flat[:, 1]
        return _on(body, part, base + height, share, width)
    crotch = float(body.place("crotch")[1]) - body.waist_m
    low, high = _spans(segment, flat[:, 1])
    outer = 1.0 if around in ("left_leg_front", "right_leg_back") else -1.0
    beyond = np.minimum(flat[:, 0] * outer, 0.0)
    above = _on(body, "trunk", body.waist_m + flat[:, 1], np.where(beyond < 0.0, turn, share), width)
    above[:, 2] += beyond * (-1.0 if turn else 1.0)  # under the crotch, towards the other piece
    middle, half = (low + high) / 2.0, np.maximum((high - low) / 2.0, 1e-3)
    side = turn + 0.25 * np.clip((flat[:, 0] - middle) / half, -1.0, 1.0)
    leg = around.split("_")[0] + "_leg"
    below = _on(body, leg, body.waist_m + np.minimum(flat[:, 1], crotch - 0.02), side, 4.0 * half)
    below[:, 1] = body.waist_m + flat[:, 1]
    corners = np.array([edge[0] for edge in segment.edges.values()])
    lowest = float(corners[np.argmin(outer * corners[:, 0]), 1])  # the garment's own crotch
    share_low = np.clip((lowest + 0.01 - flat[:, 1]) / 0.06, 0.0, 1.0)[:, None]
    return np.asarray((1.0 - share_low) * above + share_low * below)


def _on(body: Sections, part: str, at_m: Array, share: Array, width: Array) -> Array:
    """Return (N, 3) points on the rings of a part, scaled to the cloth's width there."""
    frame, out = body.frames[part], np.zeros((len(at_m), 3))
    steps = np.round(at_m / STEP_M).astype(np.int64)
    for step in np.unique(steps):
        rows = np.flatnonzero(steps == step)
        ring = body.ring(part, step * STEP_M)
        loose = max(OUTSIDE_M, (float(width[rows].mean()) - girth_of(ring)) / (2.0 * np.pi))
        ring = offset_ring(ring, loose)
        way = np.mod(share[rows], 1.0) * (len(ring) - 1)
        left, ahead = (np.interp(way, np.arange(len(ring)), ring[:, k]) for k in (0, 1))
        out[rows] = left[:, None] * frame.left + ahead[:, None] * frame.ahead
    return frame.origin_m + out + at_m[:, None] * frame.up
