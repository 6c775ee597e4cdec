"""Closed loops of cloth motion: the best stretch of a long simulation is found, and closed in two passes.

The crowd paper, section "cyclic cloth": the human cycle is repeated many times; pass 1 compares all vertices of frames
that lie a whole number of cycles apart (the body is then the same), pass 2 edge images of the best of them. From there
cloth goes on under feedback that is delayed by a cycle, until it all but repeats itself. Its last two cycles are faded
into one another, and what that put into the body is pushed out frame by frame, by a rule without memory: alike frames
stay alike, so the loop stays closed.

References
----------
K. Pyragas, Continuous control of chaos by self-controlling feedback, Physics Letters A 170, 1992.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

import cv2
import numpy as np

from cloner.cloth.simulation.core.host import push_out_of_skin
from cloner.cloth.simulation.moving import WornGarment
from cloner.cloth.simulation.solver import LoopTarget, State
from cloner.cloth.simulation.wearer import FRAMES_PER_S, skin_interval
from cloner.easing import smoothstep
from cloner.evaluate.measures.crossings import self_intersections
from cloner.geometry.cameras.viewpoints import framing_camera
from cloner.records.arrays import Array
from cloner.render import render_mesh

#: Cycles that are thrown away while the cloth settles, and how many candidates reach the second pass, of which the
#: first that closes without passing through itself is taken.
SETTLING: Final = 2
FINALISTS: Final = 4
#: Speeds count as the way that they go in this time, seconds.
SPEED_S: Final = 1.0 / 30.0
#: Where the second pass looks from, degrees, and the height of its pictures.
VIEWS: Final = (0.0, 90.0, 180.0, 270.0)
PICTURE_PX: Final = 200
#: A finished frame's cloth lies at least so far outside the skin, metres.
CLEAR_M: Final = 0.004
PUSHES: Final = 4
#: Cycles for which cloth goes on from the best stretch, led every frame this share of the way to where it was a cycle
#: earlier. With .3 the gap is up to twice as wide.
REPEATS: Final = 4
FEEDBACK: Final = 0.6
#: Stretches whose gap is no wider than so many times the least are as good.
NEARLY: Final = 1.5


@dataclass(frozen=True, slots=True, eq=False)
class Loop:
    """A closed stretch of cloth motion.

    Attributes
    ----------
    frames_m : (F, N, 3) float64
        Frame k goes with frame k of the motion's cycle.
    seam : int
        The frame in which the stretch began.
    gap_mm, median_mm : float
        RMS between its first frame and the one a cycle later, before closing, and of the median cut: of all pairs of
        frames that lie a whole number of cycles apart while the cloth was left alone.
    edge_px : float
        Mean distance between the edges in both frames' pictures.
    moved_mm : float
        Farthest that closing took a vertex.
    """

    frames_m: Array
    seam: int
    gap_mm: float
    median_mm: float
    edge_px: float
    moved_mm: float


def find_loop(worn: WornGarment, places_m: Array, progress: Callable[[float], None] = lambda _: None) -> Loop:
    """Return the best closed loop of a simulation.

    Parameters
    ----------
    worn : WornGarment
    places_m : (S, N, 3)
        All frames from the motion's first on, at least two cycles more than `SETTLING`.
    progress : callable
        Told, 0..1, how far it is; begins anew where a loop would pass through itself.
    """
    period = len(worn.rotations)
    first = SETTLING * period
    cuts = [_gaps_m(places_m[first - 1 :], apart) for apart in range(period, len(places_m) - first, period)]
    usual_m = float(np.median(np.concatenate(cuts)))
    finalists: list[int] = []
    for start in first + np.argsort(cuts[0], kind="stable"):
        if all(abs(int(start) - other) > 2 for other in finalists):
            finalists.append(int(start))
        if len(finalists) == FINALISTS:
            break
    tried: list[tuple[int, int, Loop]] = []
    for start in sorted(finalists, key=lambda start: _edge_px(worn, places_m[start], places_m[start + period])):
        loop = _crossfade(worn, _repeat_led(worn, places_m, start, progress), usual_m)
        crossings = sum(len(self_intersections(frame, worn.cloth.faces).pairs) for frame in loop.frames_m)
        tried.append((crossings, len(tried), loop))
        if not crossings:
            break
    return min(tried)[2]


def _gaps_m(places_m: Array, apart: int) -> Array:
    """Return RMS distances of all vertices between frames some time apart, speeds included."""
    away = [late - early for early, late in zip(places_m, places_m[apart:], strict=False)]
    pairs = pairwise(away)
    squares = [(now**2 + ((now - before) * FRAMES_PER_S * SPEED_S) ** 2).sum(axis=1).mean() for before, now in pairs]
    return np.sqrt(np.array(squares, dtype=np.float64))


def _edge_px(worn: WornGarment, first_m: Array, last_m: Array) -> float:
    """Return the mean symmetric distance in pixels between edges in the pictures of two frames."""
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


def _repeat_led(worn: WornGarment, places_m: Array, start: int, progress: Callable[[float], None]) -> Array:
    """Return (S, N, 3) the frames to a stretch's end and those of the following cycles, each led to the one before.

    Feedback that is delayed by a period (Pyragas 1992) pulls no more once cloth repeats itself: it nears a cycle of its
    own, not a mean of two. The gap of a skirt of 60 cm falls from 23 to 4 mm in four cycles, of a long one from 50 to
    6; left alone, both never come nearer, however long they walk (40 cycles).
    """
    period = len(worn.rotations)
    out = list(places_m[: start + period + 1])
    state, met = _state_at(np.array(out[-3:])), worn.colliders_in(start + period)
    for number in range(len(out), len(out) + REPEATS * period):
        now = worn.colliders_in(number)
        lead = LoopTarget(out[number - 1 - period], out[number - period], FEEDBACK)
        state, met = worn.after(state, met, now, lead=lead), now
        out.append(state.places_m)
        progress((number - start - period) / (REPEATS * period))
    return np.array(out)


def _crossfade(worn: WornGarment, places_m: Array, usual_m: float) -> Loop:
    """Return the last two cycles faded into a loop; ``usual_m`` is the median cut.

    It begins in the later one and ends in the earlier one, so that the end leads to the beginning. A mean of two cycles
    that are a few millimetres apart is cloth; led back within one, trousers' threads were drawn out by 16 %, not by 7.
    It begins where cloth moves calmly: what is uneven shows least there.
    """
    period = len(worn.rotations)
    earliest = len(places_m) - 2 * period
    gaps = _gaps_m(places_m[earliest - 1 :], period)
    jolts = np.array([_jolt_m(places_m[start - 2 : start + 2]) for start in range(earliest, earliest + period)])
    start = earliest + int(np.where(gaps <= NEARLY * gaps.min(), jolts, np.inf).argmin())
    share = smoothstep(np.arange(period) / period)[:, None, None]
    late, early = places_m[start : start + period], places_m[start - period : start]
    faded = (1.0 - share) * late + share * early
    frames = np.empty_like(faded)
    for number in range(period):
        frame = (start + number) % period
        frames[frame] = clear_of_skin(worn, faded[number], frame)
    return Loop(
        frames,
        start % period,
        1e3 * float(gaps[start - earliest]),
        1e3 * usual_m,
        _edge_px(worn, places_m[start], places_m[start + period]),
        1e3 * float(np.linalg.norm(frames - np.roll(late, start % period, axis=0), axis=2).max()),
    )


def _jolt_m(places_m: Array) -> float:
    """Return the largest deviation of a vertex from a straight path in the middle two of four frames (4, N, 3)."""
    return float(np.linalg.norm(np.diff(places_m, 2, axis=0), axis=2).max())


def _state_at(latest_m: Array) -> State:
    """Return the state in the last of three frames (3, N, 3) of which only positions are known."""
    earlier, before, last = latest_m
    return State(last, (3.0 * last - 4.0 * before + earlier) * FRAMES_PER_S / 2.0)


def clear_of_skin(worn: WornGarment, places_m: Array, frame: int) -> Array:
    """Return a frame's cloth pushed out of the skin; deterministic for the same start."""
    skin_m = worn.colliders_in(frame).skin_m
    return push_out_of_skin(places_m, skin_interval(worn.body, skin_m, skin_m), CLEAR_M, 0.05, PUSHES)
