"""Cloth that ends as it began: the best stretch of a long simulation is found in two passes and closed.

The crowd paper, section "cyclic cloth": the human cycle is repeated many times; pass 1 compares all vertices of frames
that lie a whole number of cycles apart (the body is then the same), pass 2 edge images of the best of them. What still
gapes is spread over the loop, and what it put into the body is pushed out frame by frame, by a rule without memory:
alike frames stay alike, so the loop stays closed.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np

from cloner.cloth.simulation.moving import Worn
from cloner.cloth.simulation.solver import leash
from cloner.cloth.simulation.threads import limit, pull
from cloner.cloth.simulation.wearer import planes_under, skin_between
from cloner.easing import smoothstep
from cloner.geometry.cameras.viewpoints import framing_camera
from cloner.records.arrays import Array
from cloner.render import render_mesh

#: Cycles that are thrown away while the cloth settles, and how many candidates reach the second pass.
SETTLING: Final = 2
FINALISTS: Final = 3
#: Speeds count as the way that they go in this time, seconds.
SPEED_S: Final = 1.0 / 30.0
#: Where the second pass looks from, degrees, and the height of its pictures.
VIEWS: Final = (0.0, 90.0, 180.0, 270.0)
PICTURE_PX: Final = 200
#: A finished frame's cloth lies at least so far outside the skin, metres.
CLEAR_M: Final = 0.004
PUSHES: Final = 4
#: Times that a closed frame's threads are pulled to their lengths again.
RELAXATIONS: Final = 24


@dataclass(frozen=True, slots=True, eq=False)
class Loop:
    """A closed stretch of cloth.

    Attributes
    ----------
    frames_m : (F, N, 3) float64
        Frame k goes with frame k of the motion's cycle.
    gap_mm, median_mm : float
        RMS between its first frame and the one a cycle later, before closing, and of the median stretch.
    edge_px : float
        Mean distance between the edges in both frames' pictures.
    moved_mm : float
        Farthest that closing took a vertex.
    """

    frames_m: Array
    gap_mm: float
    median_mm: float
    edge_px: float
    moved_mm: float


def best_loop(worn: Worn, places_m: Array) -> Loop:
    """Return the best closed loop of a simulation.

    Parameters
    ----------
    worn : Worn
    places_m : (S, N, 3)
        All frames from the motion's first on, at least two cycles more than `SETTLING`.
    """
    period = len(worn.rotations)
    starts = np.arange(SETTLING * period, len(places_m) - period)
    gaps = np.array([_gap_m(places_m, int(start), period) for start in starts])
    order = np.argsort(gaps, kind="stable")
    finalists: list[int] = []
    for row in order:
        if all(abs(int(starts[row]) - other) > 2 for other in finalists):
            finalists.append(int(starts[row]))
        if len(finalists) == FINALISTS:
            break
    edges = [_edge_px(worn, places_m[start], places_m[start + period]) for start in finalists]
    chosen = finalists[int(np.argmin(edges))]
    closed, moved = _closed(worn, places_m[chosen : chosen + period + 1], chosen)
    gap = float(gaps[chosen - starts[0]])
    return Loop(closed, 1e3 * gap, 1e3 * float(np.median(gaps)), float(min(edges)), 1e3 * moved)


def _gap_m(places_m: Array, start: int, period: int) -> float:
    """Return the RMS distance of all vertices between two frames a cycle apart, their speeds' added."""
    apart = places_m[start + period] - places_m[start]
    before, after = (places_m[row] - places_m[row - 1] for row in (start, start + period))
    faster = (after - before) * 30.0 * SPEED_S
    return float(np.sqrt((apart**2).sum(axis=1).mean() + (faster**2).sum(axis=1).mean()))


def _edge_px(worn: Worn, first_m: Array, last_m: Array) -> float:
    """Return the mean distance in pixels between edges seen in the pictures of two frames, both ways."""
    found = []
    for view in VIEWS:
        camera = framing_camera(first_m, view, PICTURE_PX, PICTURE_PX)
        faces = worn.cloth.faces.astype(np.int32)
        pictures = [render_mesh(places, faces, camera) for places in (first_m, last_m)]
        lines = [cv2.Canny(np.asarray(picture), 40, 120) > 0 for picture in pictures]
        if not all(line.any() for line in lines):
            continue
        away = [cv2.distanceTransform((~line).astype(np.uint8), cv2.DIST_L2, 3) for line in lines]
        found += [float(away[1][lines[0]].mean()), float(away[0][lines[1]].mean())]
    return float(np.mean(found)) if found else 0.0


def _closed(worn: Worn, stretch_m: Array, start: int) -> tuple[Array, float]:
    """Return (F, N, 3) the stretch closed, in the order of the motion, and how far a vertex was moved, metres."""
    period = len(stretch_m) - 1
    gap = stretch_m[0] - stretch_m[-1]
    share = np.arange(period) / period
    spread = stretch_m[:-1] + smoothstep(share)[:, None, None] * gap
    out = np.empty_like(spread)
    for number in range(period):
        frame = (start + number) % period
        out[frame] = cleared(worn, spread[number], frame)
    straight = np.roll(stretch_m[:-1], start % period, axis=0)
    return out, float(np.linalg.norm(out - straight, axis=2).max())


def cleared(worn: Worn, places_m: Array, frame: int) -> Array:
    """Return a frame's cloth with its threads' lengths and out of the skin; the same start always gives the same."""
    below_m = None if worn.under is None else worn.under.loop_m[frame]
    skin_m = worn.met_m(worn.root_m[frame], worn.rotations[frame], below_m)
    now = skin_between(worn.body, skin_m, skin_m)
    tree, out = now.tree, places_m.copy()
    free = 1.0 / worn.sheet.mass_kg
    free[worn.sheet.held] = 0.0
    for number in range(RELAXATIONS + PUSHES):
        if number < RELAXATIONS:  # what was spread lies askew over folds: threads go back to their lengths
            leash(worn.sheet, out)
            pull(worn.sheet.stretch, out, free, SPEED_S / 20.0)
            limit(worn.sheet.stretch, out, free)
            if number % 4 < 3:
                continue
        planes_under(now, tree, out, 0.05).push_out(out, CLEAR_M)
    return out
