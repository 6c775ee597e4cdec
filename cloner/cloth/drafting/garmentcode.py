"""Import of GarmentCode patterns: panels around trunk and arms, stitches as seams.

A panel is drawn in centimetres and stands in space beside its body; where that is tells which part it goes round, which
way is up and how far to the left it lies. Its height is not kept, for the body is another one's: what reaches the
shoulders is hung from the wearer's neck, what does not from the natural waist. Trousers meet in the middle where their
rises stand upright.

References
----------
M. Korosteleva, O. Sorkine-Hornung, GarmentCode: Programming Parametric Sewing Patterns, SIGGRAPH Asia 2023; form of
``*_specification.json`` as its documentation and the files of the project show it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Final

import numpy as np
from scipy.spatial.transform import Rotation

from cloner.cloth.drafting.blocks import line
from cloner.cloth.drafting.pattern import (
    LARGEST_M,
    MOST_SEGMENTS,
    Pattern,
    Segment,
    check_pattern,
    evenly_spaced,
    json_of,
    parse_pattern,
    seen_from_outside,
)
from cloner.cloth.drafting.sections import Sections
from cloner.cloth.drafting.tailored import OVER_M
from cloner.errors import ClonerError
from cloner.records.arrays import Array

#: Edges whose middles lie so near under the highest point of what hangs from the waist stay on the skin, metres.
HELD_M: Final = 0.02
#: Sewn edges so near under the highest point of what reaches the shoulders are shoulder seams, metres.
SHOULDER_M: Final = 0.05
#: Panels whose names or labels have one of these words go round an arm, or a leg.
ARMS, LEGS = ("arm", "sleeve", "sl_"), ("pant", "trouser")
#: What reaches the shoulders has a panel with one of these words.
TORSO: Final = ("torso", "bodice", "shirt")
_HINT: Final = "Write it again with GarmentCode, or draw it anew (docs/cloth.md)"


@dataclass(frozen=True, slots=True, eq=False)
class _Panel:
    """One panel: its curves (E, 4, 2) as drawn and its pose in space, metres; ``around`` as a segment's."""

    name: str
    curves: tuple[Array, ...]
    turn: Array
    middle: Array
    corner: Array
    around: str


def read_garment(path: Path, body: Sections) -> Pattern:
    """Return the garment in a JSON file, ours or GarmentCode's.

    Raises
    ------
    ClonerError
        If it is neither, or cannot be worn.
    """
    data = json_of(path)
    if isinstance(data, dict) and isinstance(data.get("pattern"), dict):
        return from_garmentcode(data, path.stem.removesuffix("_specification"), body, path.name)
    return parse_pattern(data, path.stem, path.name)


def from_garmentcode(data: Mapping[str, Any], name: str, body: Sections, where: str) -> Pattern:
    """Return a GarmentCode design as a garment for a body.

    Parameters
    ----------
    data : mapping
        The file's contents.
    name : str
    body : Sections
    where : str
        The file's name, for messages.

    Raises
    ------
    ClonerError
        If it is none, or cannot be worn.
    """
    try:
        scale = 1.0 / float(data["properties"]["units_in_meter"])
        rows = list(dict(data["pattern"]["panels"]).items())[: MOST_SEGMENTS + 1]
        panels = [_panel(str(title), dict(each), scale) for title, each in rows]
        stitches = [
            tuple((str(side["panel"]), int(side["edge"])) for side in stitch[:2])
            for stitch in data["pattern"]["stitches"]
        ]
        reaches = any(word in panel.name.lower() for panel in panels for word in TORSO)
        high = float(body.place("neck_base_L")[1]) - body.waist_m + OVER_M if reaches else 0.0
        rise = high - max(_in_space(panel)[:, 1].max() for panel in panels if "arm" not in panel.around)
        pieces = dict(_piece(panel, panels, float(rise)) for panel in panels)
        seams = tuple((pieces[one][1][k], pieces[other][1][m]) for (one, k), (other, m) in stitches)
    except (ValueError, LookupError, TypeError, AttributeError, ArithmeticError) as error:
        raise ClonerError("the file is no garment of GarmentCode", _HINT, where) from error
    segments = tuple(segment for segment, _ in pieces.values())
    pattern = Pattern(name, segments, seams, _held_edges(segments, seams, reaches))
    check_pattern(pattern, where)
    return pattern


def _panel(name: str, data: Mapping[str, Any], scale: float) -> _Panel:
    words = f"{name} {data.get('label', '')}".lower()
    corners = scale * np.asarray(data["vertices"], np.float64).reshape(-1, 2)
    if not (np.abs(corners) < LARGEST_M).all():  # nor nan
        raise ValueError("no garment's size")
    curves = tuple(_curve(corners, dict(edge), scale) for edge in data["edges"])
    turn = Rotation.from_euler("xyz", np.asarray(data.get("rotation", (0.0, 0.0, 0.0)), np.float64), degrees=True)
    corner = scale * np.asarray(data["translation"], np.float64)
    panel = _Panel(name, curves, turn.as_matrix(), corner, corner, "")
    placed = _in_space(panel)
    if not np.isfinite(placed).all():
        raise ValueError("no number")
    middle = (placed.min(axis=0) + placed.max(axis=0)) / 2.0
    side, trunk = ("left" if middle[0] > 0.0 else "right"), ("front" if middle[2] > 0.0 else "back")
    if any(word in words for word in LEGS):
        return replace(panel, middle=middle, around=f"{side}_leg_{trunk}")
    return replace(panel, middle=middle, around=f"{side}_arm" if any(word in words for word in ARMS) else trunk)


def _curve(corners: Array, data: Mapping[str, Any], scale: float) -> Array:
    """Return the (4, 2) cubic of an edge: straight, of one or two handles beside it, or an arc."""
    start, end = (corners[int(row)] for row in data["endpoints"])
    bend = data.get("curvature")
    if bend is None:
        return line(start, end)
    along = end - start
    across = np.array([-along[1], along[0]])
    kind = "quadratic" if isinstance(bend, list) else str(bend["type"])
    values: list[Any] = [bend] if isinstance(bend, list) else list(bend["params"])
    if kind == "circle":
        return _arc(start, end, scale * float(values[0]), large=bool(values[1]), right=bool(values[2]))
    handles = [start + float(x) * along + float(y) * across for x, y in values]
    if len(handles) == 1:  # a quadratic curve as a cubic one
        handles = [start + 2.0 / 3.0 * (handles[0] - start), end + 2.0 / 3.0 * (handles[0] - end)]
    return np.array([start, handles[0], handles[1], end])


def _arc(start: Array, end: Array, radius: float, *, large: bool, right: bool) -> Array:
    """Return the cubic of a circle's arc that bulges to the right or left of its chord.

    Raises
    ------
    ValueError
        If both ends are one point, or the radius is none.
    """
    along = end - start
    chord = float(np.linalg.norm(along))
    if not (chord > 0.0 and radius > 0.0):
        raise ValueError("no arc")
    half = float(np.arcsin(min(chord / (2.0 * radius), 1.0)))
    half = np.pi - half if large else half
    out = np.array([along[1], -along[0]]) / chord * (1.0 if right else -1.0)
    handle = 4.0 / 3.0 * float(np.tan(half / 2.0)) * radius
    ahead = along / chord
    leave, arrive = np.cos(half) * ahead + np.sin(half) * out, np.cos(half) * ahead - np.sin(half) * out
    return np.array([start, start + handle * leave, end - handle * arrive, end])


def _piece(panel: _Panel, panels: list[_Panel], rise_m: float) -> tuple[str, tuple[Segment, list[str]]]:
    """Return a panel's name, its segment as worn, and the full original names of its edges."""
    beside = [one for one in panels if one.around == panel.around]
    flat = [_on_arm(panel, curve, beside) if "arm" in panel.around else _on_trunk(panel, curve, rise_m)
            for curve in panel.curves]  # fmt: skip
    if "_leg_" in panel.around:
        middle = np.array([_rise_of(panel, flat), 0.0])
        flat = [curve - middle for curve in flat]
    names = [f"e{number}" for number in range(len(flat))]
    edges = seen_from_outside(dict(zip(names, flat, strict=True)))
    return panel.name, (Segment(panel.name, edges, panel.around), [f"{panel.name}.{edge}" for edge in names])


def _in_space(panel: _Panel) -> Array:
    """Return the positions of a panel's corners and handles, (M, 3) metres."""
    flat = np.concatenate([curve[:-1] for curve in panel.curves])
    return np.asarray(np.column_stack([flat, np.zeros(len(flat))]) @ panel.turn.T + panel.corner)


def _on_trunk(panel: _Panel, curve: Array, rise_m: float) -> Array:
    """Return a curve x to the left of the wearer's front, to the right of the back, y up from the natural waist."""
    axes = panel.turn[:2, :2].T  # the panel's x and y as they are seen from the front
    seen = curve @ (axes / np.maximum(np.linalg.norm(axes, axis=1, keepdims=True), 1e-9)) + panel.corner[:2]
    return np.asarray((seen + [0.0, rise_m]) * [1.0 if panel.around.endswith("front") else -1.0, 1.0])


def _rise_of(panel: _Panel, flat: list[Array]) -> float:
    """Return the position across a leg piece at which its rise is vertical: in the upper third over
    the inmost point.
    """
    outer = 1.0 if panel.around in ("left_leg_front", "right_leg_back") else -1.0
    x, y = np.concatenate([evenly_spaced(curve, 16) for curve in flat]).T
    inmost = int(np.argmin(outer * x))
    return outer * float((outer * x)[y > (y[inmost] + 2.0 * y.max()) / 3.0].min())


def _on_arm(panel: _Panel, curve: Array, beside: list[_Panel]) -> Array:
    """Return a curve y along the arm from the shoulder, x round it from its upper line; its panels lie along x."""
    inward = 1.0 if panel.turn[0, 0] * panel.middle[0] < 0.0 else -1.0
    over = 1.0 if panel.turn[1, 1] > 0.0 else -1.0
    highest = max(float((inward * np.concatenate(one.curves)[:, 0]).max()) for one in beside)
    upper = max(float((over * np.concatenate(one.curves)[:, 1]).max()) for one in beside)
    is_front = panel.middle[2] >= np.mean([one.middle[2] for one in beside])
    round_m = (upper - over * curve[:, 1]) * (1.0 if is_front == (panel.around == "right_arm") else -1.0)
    return np.column_stack([round_m, inward * curve[:, 0] - highest])


def _held_edges(segments: tuple[Segment, ...], seams: tuple[tuple[str, str], ...], reaches: bool) -> tuple[str, ...]:
    """Return the edges that stay on the skin: the highest of what hangs from the waist, shoulders without sleeves."""
    sewn = {place for seam in seams for place in seam}
    trunk = [segment for segment in segments if "arm" not in segment.around]
    if reaches and len(trunk) < len(segments):  # sleeves hold it
        return ()
    top = max(float(edge[:, 1].max()) for segment in trunk for edge in segment.edges.values())
    low = top - (SHOULDER_M if reaches else HELD_M)
    return tuple(
        f"{segment.name}.{name}"
        for segment in trunk
        for name, edge in segment.edges.items()
        if float(edge[[0, 3], 1].mean()) > low and (f"{segment.name}.{name}" in sewn) == reaches
    )
