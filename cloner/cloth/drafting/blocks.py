"""Pattern blocks drafted from a clone's measures: two pieces that hang from a ring around the body."""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

import numpy as np

from cloner.cloth.drafting.pattern import Pattern, Segment
from cloner.records.arrays import Array

Corner = Array | tuple[float, float]


@dataclass(frozen=True, slots=True)
class Block:
    """A garment that hangs from a ring.

    Attributes
    ----------
    name : str
    ring : str
        Level of the measures' table that it hangs from: "natural_waist" or "neck".
    circle : float
        Share of a full circle that both pieces make together.
    share : float
        Its length as a share of the height of its ring above the floor.
    is_open : bool
        In front: then its pieces are a left and a right one, sewn behind.
    """

    name: str
    ring: str
    circle: float
    share: float
    is_open: bool = False


#: Shares of a circle and lengths are taste.
BLOCKS: Final = MappingProxyType({
    block.name: block
    for block in (
        Block("skirt", "natural_waist", 0.5, 0.60),
        Block("circle-skirt", "natural_waist", 1.0, 0.58),
        Block("straight-skirt", "natural_waist", 0.12, 0.52),
        Block("long-skirt", "natural_waist", 0.35, 0.90),
        Block("cape", "neck", 0.80, 0.48, is_open=True),
    )
})  # fmt: skip


def draft_block(block: Block, ring_m: float, length_m: float, least_rad: float = 0.0) -> Pattern:
    """Return the two pieces of a block: sectors of a ring, whose inner edge is half of the body's.

    Parameters
    ----------
    block : Block
    ring_m : float
        Girth that the upper edge closes round, metres.
    length_m : float
    least_rad : float
        That both sectors take together at least: a metre farther down they are so many metres wider.
    """
    angle = max(2.0 * np.pi * block.circle, least_rad)
    inner = ring_m / angle
    segments = []
    for name in ("left", "right") if block.is_open else ("front", "back"):
        half = angle / 4.0
        arcs = {
            "top": _arc(inner, half, -half),
            "left": line(_circle_point(inner, -half), _circle_point(inner + length_m, -half)),
        }
        arcs |= {
            "hem": _arc(inner + length_m, -half, half),
            "right": line(_circle_point(inner + length_m, half), _circle_point(inner, half)),
        }
        segments.append(Segment(name, arcs))
    seams: tuple[tuple[str, str], ...] = (("front.left", "back.right"), ("front.right", "back.left"))
    if block.is_open:
        seams = (("left.right", "right.left"),)
    return Pattern(block.name, tuple(segments), seams)


def _circle_point(radius: float, angle: float) -> Array:
    """Return a point of a circle about the origin; angles from straight down, left positive."""
    return np.array([radius * np.sin(angle), -radius * np.cos(angle)])


def line(start: Corner, end: Corner) -> Array:
    """Return the (4, 2) cubic of a straight edge."""
    start, end = np.asarray(start, np.float64), np.asarray(end, np.float64)
    return np.array([start + share * (end - start) for share in (0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0)])


def cubic_through(start: Corner, one: Corner, other: Corner, end: Corner) -> Array:
    """Return the (4, 2) cubic through four points at parameters 0, 1/3, 2/3 and 1."""
    a, b, c, d = (np.asarray(each, np.float64) for each in (start, one, other, end))
    return np.array(
        [a, (-5.0 * a + 18.0 * b - 9.0 * c + 2.0 * d) / 6.0, (2.0 * a - 9.0 * b + 18.0 * c - 5.0 * d) / 6.0, d]
    )


def _arc(radius: float, start: float, end: float) -> Array:
    """Return the (4, 2) cubic of an arc of at most half a circle (the usual handles of 4/3 tan(angle / 4))."""
    handle = 4.0 / 3.0 * np.tan((end - start) / 4.0) * radius
    first, last = _circle_point(radius, start), _circle_point(radius, end)
    along = [np.array([np.cos(angle), np.sin(angle)]) for angle in (start, end)]
    return np.array([first, first + handle * along[0], last - handle * along[1], last])
