"""Import of FreeSewing patterns: fronts and backs cut on the fold, sleeves of one piece.

Its SVG tells outlines and the names of parts, no seams. They follow from the corners: from the fold on, a front or
back goes by hem, side, armhole, shoulder and neck, a sleeve by hem, side, cap and side. What else is drawn (ribbing,
pockets, linings) is left out; a front that has other corners (darts, plackets) is refused. Sizes stay as they were
drafted, and the collar is hung from the wearer's neck.

References
----------
FreeSewing 4 (MIT), https://freesewing.eu: the SVG that its ``render()`` writes: millimetres, a group a part, the
outline of class "fabric", notches "notch" on the front's side of a sleeve and "bnotch" on the back's.
"""

from __future__ import annotations

import contextlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final
from xml.etree import ElementTree

import numpy as np

from cloner.cloth.drafting.blocks import cubic_through
from cloner.cloth.drafting.drawn import garment_from_svg, metres_per_unit, parse_path, read_svg
from cloner.cloth.drafting.pattern import (
    Pattern,
    Segment,
    bezier,
    check_pattern,
    is_clockwise,
    length_m,
    seen_from_outside,
)
from cloner.cloth.drafting.sections import Sections
from cloner.cloth.drafting.tailored import OVER_M, extra_over_body_m
from cloner.errors import ClonerError
from cloner.geometry.meshes.vectors import arc_lengths, places_along
from cloner.records.arrays import Array

#: Edges turn by more than this where two runs meet, degrees: a curve's own pieces go on smoothly (taste).
CORNER_DEG: Final = 40.0
#: A fold's points lie so near the drawing's left, metres.
FOLD_M: Final = 1e-3
#: Every run becomes so many cubics: within .3 mm of the armholes of the drafts tried.
PIECES: Final = 3
#: What runs a front or back has from the fold on, and a sleeve, counter-clockwise from the hem.
HALF: Final = ("hem", "side", "armhole", "shoulder", "neck")
SLEEVE: Final = ("hem", "side", "cap", "side")
_HINT: Final = "Cloner reads fronts and backs on the fold and sleeves of one piece (docs/cloth.md)"


def read_svg_garment(path: Path, body: Sections) -> Pattern:
    """Return the garment in an SVG file, drawn for Cloner or by FreeSewing.

    Raises
    ------
    ClonerError
        If it is neither, or cannot be worn.
    """
    root = read_svg(path)
    if root.get("freesewing"):
        return from_freesewing(root, path.stem, body, path.name)
    return garment_from_svg(root, path.stem, path.name)


def from_freesewing(root: ElementTree.Element, name: str, body: Sections, where: str) -> Pattern:
    """Return a FreeSewing design as a garment for a body.

    Raises
    ------
    ClonerError
        If it has no front and back on the fold, or cannot be worn.
    """
    scale, parts = metres_per_unit(root, where), _parts(root)
    for part in parts:
        if "sleeve" in part.lower() and part != "sleeve":
            raise ClonerError(f"the part {part!r} is no whole sleeve", _HINT, where)
    outlines = {part: scale * _outline(parts[part], part, where) * [1.0, -1.0]
                for part in ("front", "back", "sleeve") if part in parts}  # fmt: skip
    if not {"front", "back"} <= outlines.keys():
        raise ClonerError("the draft has no parts 'front' and 'back'", _HINT, where)
    halves = {part: _half(outlines[part], part, where) for part in ("front", "back")}
    segments = [_trunk(part, half, body, where) for part, half in halves.items()]
    seams = [
        (f"front.{side}_{run}_{k}", f"back.{side}_{run}_{k}")
        for side in ("left", "right")
        for run in ("side", "shoulder")
        for k in range(PIECES)
    ]
    if "sleeve" in outlines:
        sleeve, top_m = _whole_sleeve(outlines["sleeve"], halves, parts["sleeve"], where)
        for side in ("left", "right"):
            segments.append(_sleeve(side, sleeve, top_m))
            pairs = [(f"{side}_sleeve.ahead", f"{side}_sleeve.behind")]
            pairs += [(f"{trunk}.{side}_armhole", f"{side}_sleeve.cap_{trunk}") for trunk in halves]
            seams += [(f"{one}_{k}", f"{other}_{k}") for one, other in pairs for k in range(PIECES)]
    held = () if "sleeve" in outlines else tuple(seam[0] for seam in seams if "shoulder" in seam[0])
    pattern = Pattern(name, tuple(segments), tuple(seams), held)
    check_pattern(pattern, where)
    return pattern


def _parts(root: ElementTree.Element) -> Mapping[str, ElementTree.Element]:
    """Return the groups of a draft's parts by their names without the design's."""
    found: dict[str, ElementTree.Element] = {}
    for group in root.iter():
        title = group.get("id", "")
        if "-part-" in title:
            found.setdefault(title.rpartition("-part-")[2].rpartition(".")[2], group)
    return found


def _outline(group: ElementTree.Element, part: str, where: str) -> Array:
    """Return the (E, 4, 2) curves of a part's outline without its seam allowance, in the drawing's units."""
    found = []
    for element in group.iter():
        kinds = element.get("class", "").split()
        if "fabric" in kinds and "sa" not in kinds and element.tag.rpartition("}")[2] == "path":
            curves = parse_path(element.get("d", ""), part, where)
            if len(curves) > 2 and np.allclose(curves[0][0], curves[-1][3], atol=1e-2):
                found.append(np.array(curves))
    if not found:
        raise ClonerError(f"the part {part!r} has no outline", _HINT, where)
    return max(found, key=lambda curves: float(np.prod(np.ptp(curves.reshape(-1, 2), axis=0))))


def _edge_chains(curves: Array, *, is_closed: bool) -> list[Array]:
    """Return the chains of curves between corners; a closed outline begins with the lowest chain."""
    leave, arrive = (np.array([_direction(each[::way]) for each in curves]) * way for way in (1, -1))
    turns = np.degrees(np.arccos(np.clip((arrive * np.roll(leave, -1, axis=0)).sum(axis=1), -1.0, 1.0)))
    ends = np.flatnonzero(turns[: len(curves) if is_closed else -1] > CORNER_DEG) + 1
    runs = np.split(curves, ends)
    if is_closed:
        runs = [run for run in [*runs[1:-1], np.concatenate([runs[-1], runs[0]])] if len(run)]
        lowest = int(np.argmin([run[:, [0, 3], 1].mean() for run in runs]))
        runs = [*runs[lowest:], *runs[:lowest]]
    return runs


def _direction(curve_m: Array) -> Array:
    """Return the (2,) unit direction of a curve at its first point, where handles may coincide with it."""
    away = curve_m[1:] - curve_m[0]
    far = np.linalg.norm(away, axis=1)
    first = int(np.argmax(far > 1e-3 * max(far.max(), 1e-9)))
    return np.asarray(away[first] / max(far[first], 1e-9))


def _half(curves: Array, part: str, where: str) -> dict[str, Array]:
    """Return the runs of a front's or back's half, the fold at x = 0, points (3 PIECES + 1, 2) evenly along each."""
    left = float(curves[..., 0].min())
    is_fold = np.abs(curves[..., 0] - left).max(axis=1) < FOLD_M
    if not is_fold.any() or is_fold.all():
        raise ClonerError(f"the part {part!r} is not cut on the fold", _HINT, where)
    after = int(np.flatnonzero(is_fold & ~np.roll(is_fold, -1))[0]) + 1
    chain = np.roll(curves, -after, axis=0)[: len(curves) - int(is_fold.sum())] - [left, 0.0]
    if chain[0, 0, 1] > chain[-1, 3, 1]:
        chain = chain[::-1, ::-1]
    runs = _edge_chains(chain, is_closed=False)
    if len(runs) != len(HALF):
        message = (
            f"the part {part!r} has {len(runs)} edges from corner to corner, not hem, side, armhole, shoulder, neck"
        )
        raise ClonerError(message, _HINT, where)
    return {name: _evenly_spaced(run) for name, run in zip(HALF, runs, strict=True)}


def _evenly_spaced(run: Sequence[Array] | Array, start: float = 0.0, end: float = 1.0) -> Array:
    """Return (3 PIECES + 1, 2) evenly spaced points along a part of a chain of curves."""
    fine = np.concatenate([bezier(each, np.linspace(0.0, 1.0, 65)) for each in run])
    along = arc_lengths(fine)
    return places_along(fine, along, np.linspace(start, end, 3 * PIECES + 1) * along[-1])


def _cubics(name: str, points: Array, *, is_back: bool = False) -> dict[str, Array]:
    """Return the named cubics through points of a run, one after another; numbered from its end where it runs back."""
    numbers = range(PIECES - 1, -1, -1) if is_back else range(PIECES)
    return {f"{name}_{number}": cubic_through(*points[3 * k : 3 * k + 4]) for k, number in enumerate(numbers)}


def _trunk(part: str, half: Mapping[str, Array], body: Sections, where: str) -> Segment:
    """Return a whole front or back, its collar as high as the wearer's neck and its length over bust or back."""
    neck, tip = body.place("neck_base_L"), body.place("acromion_L")
    top = float(neck[1]) - body.waist_m + OVER_M
    lift = np.array([0.0, top - float(half["shoulder"][-1, 1])])
    first, second = ("left", "right") if part == "front" else ("right", "left")
    edges: dict[str, Array] = {}
    for run in HALF:
        edges |= _cubics(f"{first}_{run}", half[run] + lift)
    for run in reversed(HALF):
        edges |= _cubics(f"{second}_{run}", (half[run][::-1] + lift) * [-1.0, 1.0], is_back=True)
    hem, under = (float(half[run][0, 1] + lift[1]) for run in ("hem", "armhole"))
    if under < float(body.place("crotch")[1]) - body.waist_m:
        message = f"the armhole of the part {part!r} lies below this wearer's trunk"
        raise ClonerError(message, "Draft it to the wearer's measures, in millimetres", where)
    up = extra_over_body_m(
        body, (tip + neck) / 2.0 - [0.0, body.waist_m - OVER_M, 0.0], under, is_front=part == "front"
    )
    up = min(up, 0.5 * (top - under))
    lies = ((hem, hem + up), (under, under + up), (top, top))
    return Segment(part, seen_from_outside(edges), part, lies)


def _whole_sleeve(
    curves: Array, halves: Mapping[str, Mapping[str, Array]], group: ElementTree.Element, where: str
) -> tuple[dict[str, Array], float]:
    """Return the edges of a sleeve, its front at +x, and the height of its cap's top as drawn."""
    notch = {kind: _notch(group, kind) for kind in ("#notch", "#bnotch")}
    if notch["#notch"] < notch["#bnotch"]:
        curves = curves[::-1, ::-1] * [-1.0, 1.0]
    if is_clockwise(curves[:, 0]):
        curves = curves[::-1, ::-1]
    runs = _edge_chains(curves, is_closed=True)
    if len(runs) != len(SLEEVE):
        message = f"the sleeve has {len(runs)} edges from corner to corner, not hem, side, cap and side"
        raise ClonerError(message, _HINT, where)
    holes = [sum(map(length_m, _cubics("", halves[part]["armhole"]).values())) for part in ("front", "back")]
    split = holes[0] / sum(holes)
    hem, ahead, cap, behind = runs
    top = _evenly_spaced(cap, 0.0, split)[-1]
    found = {
        "hem": _evenly_spaced(hem), "ahead": _evenly_spaced(ahead), "cap_front": _evenly_spaced(cap, 0.0, split),
        "cap_back": _evenly_spaced(cap, split, 1.0), "behind": _evenly_spaced(behind),
    }  # fmt: skip
    return {name: points - [float(top[0]), 0.0] for name, points in found.items()}, float(top[1])


def _notch(group: ElementTree.Element, kind: str) -> float:
    """Return the position of a kind of notch across a part, nan if there is none."""
    for element in group.iter():
        if element.tag.rpartition("}")[2] == "use" and kind in element.attrib.values():
            with contextlib.suppress(ValueError):
                return float(element.get("x", ""))
    return float("nan")


def _sleeve(side: str, runs: Mapping[str, Array], top_m: float) -> Segment:
    """Return a sleeve: y along the arm from the shoulder, its front where the arm's front is."""
    edges: dict[str, Array] = {}
    for run, points in runs.items():
        placed = (points - [0.0, top_m]) * [-1.0 if side == "left" else 1.0, 1.0]
        edges |= _cubics(run, placed, is_back=run in ("cap_back", "behind"))
    return Segment(f"{side}_sleeve", seen_from_outside(edges), f"{side}_arm")
