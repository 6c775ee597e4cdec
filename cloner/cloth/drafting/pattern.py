"""Patterns: planar segments with splines as edges, and seams between them, as JSON.

The words are the crowd paper's: a *segment* is a planar piece of cloth, a *seam* couples two edges. A file::

    {"format": 1, "name": "skirt", "segments": [{"name": "front", "edges": {
        "top": [[x, y], [x, y], [x, y], [x, y]], ...}}], "seams": [["front.left", "back.right"]]}

Edges follow one another round a segment, each a cubic Bézier curve of four points in metres; warp runs along y.
A segment with "around" lies round a part of the body (`AROUND`) as it is drawn, x to the left as its wearer's front is
seen from within, y up from the natural waist, on arms from the shoulder joint; without, it hangs from a ring by its
edge "top". "held" names edges that stay on the skin under them.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np

from cloner.errors import ClonerError
from cloner.geometry.meshes.vectors import arc_lengths, places_along
from cloner.project.texts import read_text
from cloner.records.arrays import Array

FORMAT: Final = 1
#: A garment's pieces lie within this of one another, metres; nothing smaller is a piece.
LARGEST_M, SMALLEST_M = 10.0, 0.02
MOST_SEGMENTS: Final = 60
#: Where a segment can lie; "" hangs from a ring.
AROUND: Final = (
    "", "front", "back", "left_arm", "right_arm", "left_leg_front", "left_leg_back", "right_leg_front",
    "right_leg_back",
)  # fmt: skip
#: Two edges that are sewn differ by less than this share of their length: the rest would be gathers.
EASE: Final = 0.10
#: Ends of neighbouring edges meet within this, metres.
MEET_M: Final = 1e-4
_HINT: Final = "See docs/cloth.md for the form of a garment's file"


@dataclass(frozen=True, slots=True, eq=False)
class Segment:
    """A planar piece.

    Attributes
    ----------
    name : str
    edges : mapping of str to (4, 2) float64
        Cubic Bézier curves, metres, in order round the piece.
    around : str
        One of `AROUND`.
    lies : tuple of (float, float)
        Heights y as drawn, rising, and where these lie on the body, metres; as drawn where it is empty.
    """

    name: str
    edges: Mapping[str, Array]
    around: str = ""
    lies: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Pattern:
    """A garment's pieces.

    Attributes
    ----------
    name : str
    segments : tuple of Segment
    seams : tuple of (str, str)
        Pairs of "segment.edge"; the second runs against the first.
    held : tuple of str
        Edges, as "segment.edge", that stay on the skin; a ring's upper edges always do.
    """

    name: str
    segments: tuple[Segment, ...]
    seams: tuple[tuple[str, str], ...]
    held: tuple[str, ...] = ()

    @property
    def from_ring(self) -> bool:
        """Whether it hangs from a ring."""
        return all(not segment.around for segment in self.segments)

    def edge(self, place: str) -> Array:
        """Return the (4, 2) curve of "segment.edge"."""
        name, _, edge = place.partition(".")
        return next(segment for segment in self.segments if segment.name == name).edges[edge]


def bezier(points: Array, share: Array) -> Array:
    """Return (N, 2) points of a cubic Bézier curve (4, 2) at parameters 0..1."""
    t = share[:, None]
    first, second, third, last = points
    return np.asarray((1 - t) ** 3 * first + 3 * t * (1 - t) ** 2 * second + 3 * t**2 * (1 - t) * third + t**3 * last)


def length_m(points: Array) -> float:
    """Return the length of a curve, metres."""
    return float(np.linalg.norm(np.diff(bezier(points, np.linspace(0.0, 1.0, 129)), axis=0), axis=1).sum())


def evenly_spaced(points: Array, count: int) -> Array:
    """Return (count + 1, 2) points that lie evenly along a curve, including both ends."""
    fine = bezier(points, np.linspace(0.0, 1.0, 257))
    run = arc_lengths(fine)
    wanted = np.linspace(0.0, run[-1], count + 1)
    return places_along(fine, run, wanted)


def is_clockwise(outline: Array) -> bool:
    """Return whether a closed polygon (N, 2) runs clockwise, y up."""
    following = np.roll(outline, -1, axis=0)
    return float((outline[:, 0] * following[:, 1] - outline[:, 1] * following[:, 0]).sum()) < 0.0


def seen_from_outside(edges: Mapping[str, Array]) -> dict[str, Array]:
    """Return a piece's edges in counter-clockwise order, reversed where they were clockwise."""
    if is_clockwise(np.concatenate([edge[:-1] for edge in edges.values()])):
        return {name: edge[::-1] for name, edge in reversed(list(edges.items()))}
    return dict(edges)


def check_pattern(pattern: Pattern, where: str) -> None:
    """Refuse pieces that cannot be triangulated.

    Raises
    ------
    ClonerError
        One sentence that names the piece.
    """
    if not pattern.segments or len(pattern.segments) > MOST_SEGMENTS:
        raise ClonerError(f"a garment has 1 to {MOST_SEGMENTS} pieces", _HINT, where)
    if len({segment.name for segment in pattern.segments}) < len(pattern.segments):
        raise ClonerError("two pieces share one name", _HINT, where)
    for segment in pattern.segments:
        _check_segment(segment, where)
    known = {f"{segment.name}.{edge}" for segment in pattern.segments for edge in segment.edges}
    if not pattern.from_ring and not all(segment.around for segment in pattern.segments):
        raise ClonerError("some pieces hang from a ring and others lie round the body", _HINT, where)
    for place in pattern.held:
        if place not in known:
            raise ClonerError(f"the held edge {place!r} is in no piece", _HINT, where)
    sewn = [place for seam in pattern.seams for place in seam]
    for place in sewn:
        if place not in known:
            raise ClonerError(f"the seam's edge {place!r} is in no piece", _HINT, where)
        if sewn.count(place) > 1:
            raise ClonerError(f"the edge {place!r} is sewn twice", _HINT, where)
    for one, other in pattern.seams:
        long, short = length_m(pattern.edge(one)), length_m(pattern.edge(other))
        if abs(long - short) > EASE * max(long, short):
            message = f"{100 * long:.1f} and {100 * short:.1f} cm"
            raise ClonerError(f"the edges {one!r} and {other!r} of a seam are {message} long", "Make them alike", where)


def _check_segment(segment: Segment, where: str) -> None:
    edges = list(segment.edges.values())
    if segment.around not in AROUND:
        hint = f"A piece lies round {', '.join(filter(None, AROUND))}"
        raise ClonerError(f"the piece {segment.name!r} lies round {segment.around!r}, which is no part", hint, where)
    if not all(np.isfinite(segment.lies).ravel()) or (np.diff([y for y, _ in segment.lies]) <= 0.0).any():
        raise ClonerError(f"the piece {segment.name!r} lies at heights that do not rise", _HINT, where)
    if len(edges) < 2:
        raise ClonerError(f"the piece {segment.name!r} has fewer than two edges", _HINT, where)
    if not all(edge.shape == (4, 2) and np.isfinite(edge).all() for edge in edges):
        raise ClonerError(f"the piece {segment.name!r} has an edge that is no curve of four points", _HINT, where)
    for one, other in zip(edges, [*edges[1:], edges[0]], strict=True):
        if float(np.linalg.norm(one[3] - other[0])) > MEET_M:
            hint = "Let every edge begin where the one before ends"
            raise ClonerError(f"the outline of the piece {segment.name!r} is open", hint, where)
    outline = np.concatenate([evenly_spaced(edge, 16)[:-1] for edge in edges])
    if np.abs(outline).max() > LARGEST_M or float(np.ptp(outline, axis=0).min()) < SMALLEST_M:
        raise ClonerError(f"the piece {segment.name!r} has no garment's size", "Write metres", where)
    if _crosses(outline):
        raise ClonerError(f"the outline of the piece {segment.name!r} crosses itself", "Draw it without a loop", where)


def _crosses(outline: Array) -> bool:
    """Return whether a closed polygon crosses itself."""
    first, second = outline, np.roll(outline, -1, axis=0)
    along = second - first

    def side(line: Array, start: Array, points: Array) -> Array:
        away = points[None] - start[:, None]
        return np.asarray(line[:, None, 0] * away[..., 1] - line[:, None, 1] * away[..., 0])

    one, other = side(along, first, first), side(along, first, second)
    apart = one * other < -1e-18
    crossing = apart & apart.T
    count = len(outline)
    near = (np.abs(np.subtract.outer(np.arange(count), np.arange(count))) % (count - 1)) <= 1
    return bool((crossing & ~near).any())


def read_pattern(path: Path) -> Pattern:
    """Return the garment in one of our JSON files.

    Raises
    ------
    ClonerError
        As :func:`parse_pattern`.
    """
    return parse_pattern(json_of(path), path.stem, path.name)


def json_of(path: Path) -> Any:
    """Return the contents of a garment's JSON file.

    Raises
    ------
    ClonerError
        If it is no JSON.
    """
    try:
        return json.loads(read_text(path))
    except (ValueError, RecursionError) as error:
        raise ClonerError("the file is no garment", _HINT, path.name) from error


def parse_pattern(data: Any, name: str, where: str) -> Pattern:
    """Return the garment of a JSON file's contents.

    Raises
    ------
    ClonerError
        If it is no garment, or one that cannot be cut.
    """
    try:
        segments = tuple(
            Segment(
                str(each["name"]),
                {str(name): np.asarray(edge, dtype=np.float64) for name, edge in dict(each["edges"]).items()},
                str(each.get("around", "")),
                tuple((float(y), float(at)) for y, at in each.get("lies", ())),
            )
            for each in list(data["segments"])[: MOST_SEGMENTS + 1]
        )
        seams = tuple((str(one), str(other)) for one, other in data["seams"])
        held = tuple(str(place) for place in data.get("held", ()))
        pattern = Pattern(str(data.get("name", name)), segments, seams, held)
        if data.get("format") != FORMAT:
            raise ValueError("another form")
    except (ValueError, LookupError, TypeError, AttributeError, RecursionError) as error:
        raise ClonerError("the file is no garment", _HINT, where) from error
    check_pattern(pattern, where)
    return pattern


def pattern_text(pattern: Pattern) -> str:
    """Return a garment as JSON."""
    data = {
        "format": FORMAT,
        "name": pattern.name,
        "segments": [
            {
                "name": segment.name,
                "around": segment.around,
                **({"lies": segment.lies} if segment.lies else {}),
                "edges": {name: edge.round(5).tolist() for name, edge in segment.edges.items()},
            }
            for segment in pattern.segments
        ],
        "seams": [list(seam) for seam in pattern.seams],
        "held": list(pattern.held),
    }
    return json.dumps(data, indent=1) + "\n"
