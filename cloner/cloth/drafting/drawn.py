"""Patterns drawn as SVG: one path per piece, one curve or line per edge; names and seams in attributes.

::

    <svg width="600mm" viewBox="0 0 600 900" data-seams="front.left back.left; front.right back.right" data-held="">
      <path id="front" data-around="front" data-edges="hem left top right" d="M ... C ... L ... Z"/>

References
----------
W3C, Scalable Vector Graphics 1.1, 8.3 (path data: M, L, H, V, C and Z, also relative).
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Final
from xml.etree import ElementTree

import numpy as np

from cloner.cloth.drafting.blocks import line
from cloner.cloth.drafting.pattern import MEET_M, MOST_SEGMENTS, Pattern, Segment, check_pattern, seen_from_outside
from cloner.errors import ClonerError
from cloner.project.texts import read_text
from cloner.records.arrays import Array

#: Metres of SVG's units; a bare number is a pixel, 96 an inch.
UNITS_M: Final = {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "in": 0.0254, "pt": 0.0254 / 72.0, "px": 0.0254 / 96.0}
#: Numbers that a command takes.
TAKES: Final = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "Z": 0}
#: No drawing is larger than this, in its own units.
LARGEST: Final = 1e6
_TOKEN: Final = re.compile(r"[A-Za-z]|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_HINT: Final = "See docs/cloth.md for how a garment is drawn"


def read_svg(path: Path) -> ElementTree.Element:
    """Return the root of an SVG file.

    Raises
    ------
    ClonerError
        If it is none.
    """
    text = read_text(path)
    if "<!DOCTYPE" in text or "<!ENTITY" in text:
        raise ClonerError("the drawing has a DOCTYPE", "Save it as plain SVG", path.name)
    try:
        return ElementTree.fromstring(text)
    except (ElementTree.ParseError, ValueError, RecursionError) as error:
        raise ClonerError("the file is no SVG", _HINT, path.name) from error


def garment_from_svg(root: ElementTree.Element, stem: str, where: str) -> Pattern:
    """Return the garment in a drawing; the origin's height is the waist (or an arm's shoulder joint).

    Raises
    ------
    ClonerError
        If it is no drawing of a garment, or one that cannot be cut.
    """
    scale = metres_per_unit(root, where)
    segments: list[Segment] = []
    for element in root.iter():
        if element.get("transform"):
            raise ClonerError("a part of the drawing is transformed", "Apply the transformation first", where)
        if element.tag.rpartition("}")[2] == "path" and len(segments) <= MOST_SEGMENTS:
            segments.append(_piece(element, scale, where))
    seams = [tuple(pair.split()) for pair in root.get("data-seams", "").split(";") if pair.strip()]
    if not all(len(pair) == 2 for pair in seams):
        raise ClonerError("a seam of the drawing does not name two edges", _HINT, where)
    pairs = tuple((pair[0], pair[1]) for pair in seams)
    pattern = Pattern(stem, tuple(segments), pairs, tuple(root.get("data-held", "").split()))
    check_pattern(pattern, where)
    return pattern


def metres_per_unit(root: ElementTree.Element, where: str) -> float:
    """Return the length of a drawing's unit, metres."""
    found = re.fullmatch(r"\s*([\d.]+)\s*([a-z]*)\s*", root.get("width", ""))
    box = [float(each) for each in _TOKEN.findall(root.get("viewBox", "")) if not each.isalpha()]
    unit = UNITS_M.get(found.group(2) or "px") if found else None
    if found is None or unit is None or found.group(1).count(".") > 1 or float(found.group(1)) > LARGEST:
        raise ClonerError("the drawing has no width in millimetres", 'Give it one, such as width="600mm"', where)
    return unit * float(found.group(1)) / box[2] if len(box) == 4 and box[2] > 0.0 else unit


def _piece(element: ElementTree.Element, scale: float, where: str) -> Segment:
    name = element.get("id", "")
    names = element.get("data-edges", "").split()
    curves = parse_path(element.get("d", ""), name, where)
    if len(names) != len(curves) or len(set(names)) != len(names):
        message = f"the piece {name!r} has {len(curves)} edges and {len(names)} names for them"
        raise ClonerError(message, "Name every edge once, in the order of drawing", where)
    if not curves:
        raise ClonerError(f"the outline of the piece {name!r} ends early", _HINT, where)
    edges = {edge: scale * curve * [1.0, -1.0] for edge, curve in zip(names, curves, strict=True)}
    return Segment(name, seen_from_outside(edges), element.get("data-around", ""))


def parse_path(data: str, name: str, where: str) -> list[Array]:
    """Return (4, 2) cubics of path data, in its own units, y down."""
    tokens = _TOKEN.findall(data)
    found: list[Array] = []
    here = start = np.zeros(2)
    command, place = "", 0
    while place < len(tokens):
        if tokens[place].isalpha():
            command, place = tokens[place], place + 1
        kind = command.upper()
        if kind not in TAKES or (kind == "Z" and place < len(tokens) and not tokens[place].isalpha()):
            raise ClonerError(f"the outline of the piece {name!r} has a command {command!r}", _HINT, where)
        given = tokens[place : place + TAKES[kind]]
        if len(given) < TAKES[kind] or any(each.isalpha() for each in given):
            raise ClonerError(f"the outline of the piece {name!r} ends early", _HINT, where)
        values, place = np.array([float(each) for each in given]), place + TAKES[kind]
        if np.abs(values).max(initial=0.0) > LARGEST:
            raise ClonerError(f"the outline of the piece {name!r} goes out of all bounds", _HINT, where)
        base = here if command.islower() else np.zeros(2)
        if kind == "M":
            here = start = base + values
            command = "l" if command == "m" else "L"
            continue
        if kind == "C":
            curve = np.vstack([here, base + values.reshape(3, 2)])
        elif kind in ("H", "V"):
            end = here.copy()
            end["HV".index(kind)] = base["HV".index(kind)] + values[0]
            curve = line(here, end)
        else:
            curve = line(here, start if kind == "Z" else base + values)
        if kind != "Z" or float(np.linalg.norm(curve[3] - curve[0])) > MEET_M:
            found.append(curve)
        here = curve[3]
    return found
