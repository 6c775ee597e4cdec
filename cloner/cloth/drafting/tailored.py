"""Garments with sleeves or legs, drafted from a clone's measures: tee, dress, coat and trousers.

Pieces are drawn as they lie on the body: y is the height over the natural waist, on sleeves over the shoulder joint.
Ease and shape are those of plain basic blocks of pattern books; taste.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.cloth.drafting.blocks import cubic_through, line
from cloner.cloth.drafting.pattern import Pattern, Segment, length_m
from cloner.cloth.drafting.sections import STEP_M, Sections
from cloner.records.arrays import Array

Point = tuple[float, float]

#: An armhole ends so far below the armpit, a shoulder lies so far over the skin, metres.
DROP_M, OVER_M = 0.025, 0.012
#: Crotch below the body's; ease at seat and waist (cloth lies 6 mm off the skin, 5 % of a waist); and how far the rise
#: of front and back reaches between the legs, shares of the hips' girth. With 8, 14, 18 and 24 % at the seat threads
#: are 7.2, 6.1, 5.9 and 5.4 % too long in the walk (triangles of 2 cm); below 18 % trousers cross themselves in all
#: frames of a loop, and with 24 % they stand off at the hips like a balloon.
SEAT_M, SEAT_EASE, WAIST_EASE = 0.05, 1.18, 1.10
RISES: Final = (0.0675, 0.16)
#: Trousers end so high over the floor, a share of the stature: lower, a foot that swings pulls their hem apart.
ANKLE: Final = 0.08
HALVINGS: Final = 40
#: A section's points so near a line up the body lie on it, metres.
SEEN_M: Final = 0.015


@dataclass(frozen=True, slots=True)
class UpperCut:
    """What distinguishes one upper garment from another.

    Attributes
    ----------
    ease, hem_ease : float
        Shares of the body's girth that the garment is wider at chest and hem.
    low : float
        Hem: share of the way from the waist (0) down to the floor (1).
    sleeve : float
        Length as a share of the arm to the wrist; 0 for none.
    is_open : bool
        Down the front.
    neck_m : float
        How much wider and lower than the neck's base the neckline is, metres.
    """

    ease: float
    hem_ease: float
    low: float
    sleeve: float
    is_open: bool
    neck_m: float


#: Ease, hems and sleeves are taste.
CUTS: Final[Mapping[str, UpperCut]] = {
    "tee": UpperCut(0.10, 0.08, 0.20, 0.36, False, 0.015),
    "dress": UpperCut(0.08, 0.55, 0.56, 0.0, False, 0.03),
    "coat": UpperCut(0.28, 0.30, 0.48, 1.10, True, 0.02),
}
TROUSERS: Final = "trousers"
TAILORED: Final = (*CUTS, TROUSERS)


def draft_tailored(name: str, body: Sections, down_m: float | None = None) -> Pattern:
    """Return a garment drafted from a body.

    Parameters
    ----------
    name : str
        One of `TAILORED`.
    body : Sections
    down_m : float or None
        From the natural waist to the hem; the block's own where None.
    """
    return _trousers(body, down_m) if name == TROUSERS else _upper(name, CUTS[name], body, down_m)


def _upper(name: str, cut: UpperCut, body: Sections, length: float | None) -> Pattern:
    hem = -(cut.low * body.waist_m if length is None else length)
    under = body.place("armpit_left")[1] - body.waist_m - DROP_M
    chest = (1.0 + cut.ease) * max(body.girth("trunk", under + body.waist_m - k * 0.02) for k in range(6)) / 4.0
    low = [hem * share for share in (0.3, 0.6, 1.0)]
    widest = max(body.girth("trunk", body.waist_m + y) for y in (*low, -0.2) if y >= hem - 0.01 or y == -0.2)
    bottom = max((1.0 + cut.hem_ease) * widest / 4.0, chest * (1.0 + cut.hem_ease) / (1.0 + cut.ease))
    tip, neck = body.place("acromion_L"), body.place("neck_base_L")
    shoulder = (float(abs(tip[0])), float(tip[1] - body.waist_m + OVER_M))
    collar = (float(abs(neck[0])) + cut.neck_m, float(neck[1] - body.waist_m + OVER_M))
    depth = {
        "front": float(body.place("neck_front_base")[1]) - body.waist_m - cut.neck_m,
        "back": float(body.place("nape")[1]) - body.waist_m - cut.neck_m / 2.0,
    }
    segments, seams, held = [], [], []
    for side in ("front", "back"):
        up = extra_over_body_m(
            body, (tip + neck) / 2.0 - [0.0, body.waist_m - OVER_M, 0.0], under, is_front=side == "front"
        )
        panel = _panel(
            chest, bottom, hem, under, (shoulder[0], shoulder[1] + up), (collar[0], collar[1] + up),
            min(depth[side], collar[1] - 0.015) + up, side == "front",
        )  # fmt: skip
        lies = tuple((y + (up if y > under else 0.0), y) for y in (hem, under, shoulder[1], collar[1]))
        if cut.is_open and side == "front":
            segments += [Segment(f"{part}_front", edges, "front", lies) for part, edges in _split_front(panel).items()]
        else:
            segments.append(Segment(side, panel, side, lies))
    for part in ("left", "right"):
        front = f"{part}_front" if cut.is_open else "front"
        seams += [(f"{front}.{part}{edge}", f"back.{part}{edge}") for edge in ("", "_shoulder")]
        if cut.is_open or cut.sleeve == 0.0:  # a tee stays on by itself
            held.append(f"{front}.{part}_shoulder")
        if cut.sleeve > 0.0:
            holes = [next(s for s in segments if s.name == name).edges[f"{part}_armhole"] for name in (front, "back")]
            hole = sum(map(length_m, holes)) / 2.0
            segments.append(_sleeve(part, cut, body, hole))
            seams.append((f"{part}_sleeve.under_a", f"{part}_sleeve.under_b"))
            ahead, behind = ("cap_b", "cap_a") if part == "left" else ("cap_a", "cap_b")
            seams.append((f"{front}.{part}_armhole", f"{part}_sleeve.{ahead}"))
            seams.append((f"back.{part}_armhole", f"{part}_sleeve.{behind}"))
    return Pattern(name, tuple(segments), tuple(seams), tuple(held))


def extra_over_body_m(body: Sections, seam: Array, low: float, *, is_front: bool) -> float:
    """Return the extra length over the body compared with straight up, metres, to the middle of a shoulder seam.

    ``seam`` (3,) is that middle, ``low`` where the way begins, over the waist. A front that was only as long as the
    body is high was drawn 15 % too long over the bust.
    """
    way = []
    for height in np.arange(low, seam[1], STEP_M):
        ring = body.ring("trunk", body.waist_m + float(height))
        beside = ring[np.abs(ring[:, 0] - seam[0]) < SEEN_M, 1]
        if len(beside):
            way.append((float(height), float(beside.max() if is_front else beside.min())))
    steps = np.diff([*way, (seam[1], seam[2])], axis=0)
    return float(np.hypot(steps[:, 0], steps[:, 1]).sum() - steps[:, 0].sum())


def _panel(
    chest: float, bottom: float, hem: float, under: float, shoulder: Point, collar: Point, depth: float, is_front: bool
) -> dict[str, Array]:
    """Return the edges of a front or back, counter-clockwise from the hem; sides are the wearer's."""
    first, second = ("left", "right") if is_front else ("right", "left")
    side, arm = (bottom, hem), (chest, under)
    reach = max(under + 0.02, shoulder[1] - 0.6 * (shoulder[1] - under))
    hole = np.array([arm, (max(shoulder[0], 0.62 * chest), under), (shoulder[0] - 0.012, reach), shoulder])
    fall = 4.0 / 3.0 * (collar[1] - depth)
    throat = np.array([
        collar, (collar[0], collar[1] - fall), (-collar[0], collar[1] - fall), (-collar[0], collar[1])
    ])  # fmt: skip
    return {
        "hem": line(_mirror(side), side),
        first: line(side, arm),
        f"{first}_armhole": hole,
        f"{first}_shoulder": line(shoulder, collar),
        "neck": throat,
        f"{second}_shoulder": line(_mirror(collar), _mirror(shoulder)),
        f"{second}_armhole": _mirrored(hole),
        second: line(_mirror(arm), _mirror(side)),
    }


def _mirror(point: Point) -> Point:
    return -point[0], point[1]


def _mirrored(edge: Array) -> Array:
    """Return an edge of the other side, in opposite direction."""
    return np.asarray(edge[::-1] * [-1.0, 1.0])


def _split_front(panel: dict[str, Array]) -> dict[str, dict[str, Array]]:
    """Return the left and the right half of a front."""
    hem, neck = panel["hem"], panel["neck"]
    low = (float(neck.mean(axis=0)[0]), float((neck[0] + 3 * neck[1] + 3 * neck[2] + neck[3])[1] / 8.0))
    middle = (0.0, float(hem[0, 1]))
    handle = neck[1, 1] - neck[0, 1]
    curve = np.array([neck[0], neck[0] + [0.0, 0.55 * handle], [0.4 * neck[0, 0], low[1]], low])
    left = {
        "hem": line(middle, (float(hem[3, 0]), float(hem[3, 1]))),
        **{name: panel[name] for name in ("left", "left_armhole", "left_shoulder")},
        "neck": curve,
        "opening": line(low, middle),
    }
    right = {
        "hem": _mirrored(left["hem"]),
        "opening": _mirrored(left["opening"]),
        "neck": _mirrored(curve),
        **{name: panel[name] for name in ("right_shoulder", "right_armhole", "right")},
    }
    return {"left": left, "right": right}


def _sleeve(part: str, cut: UpperCut, body: Sections, hole: float) -> Segment:
    """Return a sleeve whose cap is as long as both armholes of its side, ``hole`` each."""
    arm = f"{part}_arm"
    long = cut.sleeve * body.arm_length_m(part)
    top = (1.0 + 1.4 * cut.ease) * body.girth(arm, -0.09) / 2.0 + 0.012
    top = min(top, 0.97 * hole)
    cuff = max((1.0 + 2.0 * cut.ease) * body.girth(arm, -long + 0.01) / 2.0 + 0.01, 0.55 * top)
    low, high = 0.0, hole

    def cap(height: float) -> Array:
        return np.array([(top, 0.0), (0.55 * top, 0.0), (0.5 * top, height), (0.0, height)])

    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        low, high = (low, middle) if length_m(cap(middle)) > hole else (middle, high)
    rise = cap(low) + [0.0, -min(low, 0.75 * long)]  # the cap's top at the shoulder
    hem = (cuff, -long)
    edges = {
        "cuff": line(_mirror(hem), hem), "under_a": line(hem, (top, float(rise[0, 1]))), "cap_a": rise,
        "cap_b": _mirrored(rise), "under_b": line((-top, float(rise[0, 1])), _mirror(hem)),
    }  # fmt: skip
    return Segment(f"{part}_sleeve", edges, arm)


def _trousers(body: Sections, length: float | None) -> Pattern:
    crotch = float(body.place("crotch")[1]) - body.waist_m - SEAT_M
    ankle = -body.waist_m + ANKLE * body.stature_m
    hem = ankle if length is None else -length
    buttock = float(body.place("buttock_left")[1])
    hips, seat = SEAT_EASE * body.girth("trunk", buttock), buttock - body.waist_m
    waist = WAIST_EASE * body.girth("trunk", body.waist_m) / 4.0
    fulls = [SEAT_EASE * body.girth("trunk", body.waist_m + share * seat) / 4.0 for share in (2 / 3, 1 / 3)]
    leg = body.girth("left_leg", body.waist_m + hem + 0.02)
    segments = []
    for side, rise in zip(("front", "back"), RISES, strict=True):
        reach = rise * hips
        half = max(0.62 * leg / 2.0, 0.11)
        middle = (hips / 4.0 - reach) / 2.0
        bottom = (middle - half, hem), (middle + half, hem)
        wide = (hips / 4.0, seat)
        edges = {
            "hem": line(*bottom),
            "out": np.array([bottom[1], (middle + half, 0.6 * hem + 0.4 * seat), (wide[0], seat + 0.4 * crotch), wide]),
            "hip": cubic_through(wide, (fulls[0], 2.0 * seat / 3.0), (fulls[1], seat / 3.0), (waist, 0.0)),
            "waist": line((waist, 0.0), (0.0, 0.0)),
            "rise": np.array([(0.0, 0.0), (0.0, 0.8 * crotch), (-0.15 * reach, crotch), (-reach, crotch)]),
            "in": line((-reach, crotch), bottom[0]),
        }
        other = {name: _mirrored(edge) for name, edge in reversed(edges.items())}
        left, right = (edges, other) if side == "front" else (other, edges)
        segments.append(Segment(f"left_{side}", left, f"left_leg_{side}"))
        segments.append(Segment(f"right_{side}", right, f"right_leg_{side}"))
    seams = [
        (f"{part}_front.{edge}", f"{part}_back.{edge}") for part in ("left", "right") for edge in ("out", "hip", "in")
    ]
    seams += [(f"left_{side}.rise", f"right_{side}.rise") for side in ("front", "back")]
    held = tuple(f"{segment.name}.waist" for segment in segments)
    return Pattern(TROUSERS, tuple(segments), tuple(seams), held)
