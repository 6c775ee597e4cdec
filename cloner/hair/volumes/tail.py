"""Free hair (tails, plaits) from side and back photos."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId, mm_from_m
from cloner.hair.volumes.pictures import FAR_MM
from cloner.hair.volumes.views import SIDES, HairView, covered_by_surface
from cloner.records.arrays import Array
from cloner.vision.retouching.aligning import sample

ROUND_TAIL = (0.6, 2.5)  # a tail's width against its depth: limits of what is believed
WIDEST_TAIL_MM = 110.0  # wider hair in the back photo is the head's, not a tail's
FARTHEST_ASIDE_MM = 40.0  # a tail is looked for this far beside where the side photo has it
LEAST_ALONE = 0.3  # of a tail's rows stand alone in the back photo; above them the head's hair lies behind it
THINNEST_MM = 10.0  # thin plaits
#: A bun's height against its depth, how much of both it fills, and how far below the head's middle it reaches. Three
#: buns 1.2 to 1.5, .50 to .66, above it; of 40 others with free hair none meets all three: a cap's brim fills .62 and
#: is .6 as high as deep, the thick hair of afros fills .44 at most, collars of scarves reach 130 mm below.
KNOT, KNOT_FILL, LOWEST_KNOT_MM = (0.8, 1.6), 0.47, 80.0
AIR_MM = 3.0  # taste: between a tail and the neck; labels err by less
FREE_MM = 30.0  # a tail hangs farther than this from body and cap; nearer is their own error: a fin behind the head
SMALLEST_TAIL_MM2 = 900.0  # smaller free areas are the cap's own roughness


@dataclass(frozen=True, slots=True, eq=False)
class Tail:
    """Free hair in one side photo, assumed round.

    Attributes
    ----------
    view : HairView
    half_px : (H, W) float32
        Half width across the picture, signed: negative outside.
    centre : callable
        Height (N,), m -> x of the middle (N,), m.
    broadest : callable
        Height (N,), m -> half the width that the back photo shows (N,), m.
    ratio : float
        Width against depth.
    """

    view: HairView
    half_px: NDArray[np.float32]
    centre: Callable[[Array], Array]
    broadest: Callable[[Array], Array]
    ratio: float

    def inside_mm(self, points_m: Array) -> NDArray[np.float32]:
        """Return the depth (N,) of points inside the tail, millimetres; -FAR_MM outside the picture."""
        posed = self.view.to_view(points_m)
        pixel = self.view.posed.camera.project(posed)
        height, width = self.half_px.shape
        shown = (pixel >= 0).all(axis=1) & (pixel <= (width - 1, height - 1)).all(axis=1)
        half = sample(self.half_px, pixel)[:, 0] * np.float32(self.view.pixel_mm(posed))
        lateral = mm_from_m(1.0) * np.abs(points_m[:, 0] - self.centre(points_m[:, 1]))
        bound = mm_from_m(1.0) * self.broadest(points_m[:, 1])
        across = np.where(half > 0.0, np.minimum(half * self.ratio, bound), half) - lateral
        return np.where(shown, across, -FAR_MM).astype(np.float32)

    def holds(self, points_m: Array) -> NDArray[np.bool_]:
        """Return the points (N,) in which the side photo shows the tail: it alone decides there."""
        pixel = self.view.posed.camera.project(self.view.to_view(points_m))
        return np.asarray(sample(self.half_px, pixel)[:, 0] > 0.0)


def find_tail(views: list[HairView], cap_m: Array, triangles: NDArray[np.int32], middle_m: float) -> Tail | None:
    """Return the free hair of the best side photo, None where there is none.

    One photo only: two cannot agree to the millimetre, and the thinner part
    that they share is nobody's tail. A body photo's camera is known better.

    Parameters
    ----------
    views : list of HairView
    cap_m : (N, 3), triangles : (T, 3)
        The head with its cap, which is no tail.
    middle_m : float
        x of the head's middle, used where no back photo tells.
    """
    behind = any(view.posed.view is ViewId.BODY_BACK for view in views)
    for wanted in SIDES[1]:
        for view in views:
            if view.posed.view is not wanted or view.flip_m is not None:
                continue
            head = covered_pixels(view, cap_m, triangles)
            free = free_hair(view, head, cap_m)
            if not behind:
                free = free & hangs_clear(view, free, head, cap_m)
            course = tail_course(views, view, free, cap_m.mean(axis=0), middle_m) if free.any() else None
            if course is not None:
                return Tail(view, strand_half_width(view, free, head), *course)
    return None


def strand_half_width(view: HairView, free: NDArray[np.bool_], head: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return half the width (H, W) of a round strand across the picture, px, negative outside.

    At distance d from the edge of a strand with half thickness R it is
    sqrt(d (2 R - d)). Where the strand meets the head there is no edge; it runs on below the cap.
    """
    edge = cv2.distanceTransform((view.hair | head).astype(np.uint8), cv2.DIST_L2, 5)
    alone = cv2.distanceTransform(free.astype(np.uint8), cv2.DIST_L2, 5)
    thickest = float(alone.max())
    depth = np.minimum(edge, thickest)
    reach = 2 * int(np.ceil(thickest)) + 1
    root = cv2.dilate(free.astype(np.uint8), np.ones((reach, reach), np.uint8)) > 0
    zone = (free | (root & head)) & (edge > 0.0)
    # A square is separable: 50 times faster than a disc.
    radius = cv2.dilate(np.where(zone, depth, np.float32(0.0)), np.ones((reach, reach), np.uint8))
    half = np.sqrt(np.clip(depth * (2.0 * radius - depth), 0.0, None))
    outside = cv2.distanceTransform((~zone).astype(np.uint8), cv2.DIST_L2, 5)
    return np.asarray(np.where(zone, half, -outside), np.float32)


def covered_pixels(view: HairView, cap_m: Array, triangles: NDArray[np.int32]) -> NDArray[np.bool_]:
    """Return the pixels (H, W) that body or cap cover."""
    height, width = view.hair.shape
    both = (covered_by_surface(view, cap_m, triangles) | np.isfinite(view.nearest_m)).astype(np.uint8)
    return np.asarray(cv2.resize(both, (width, height), interpolation=cv2.INTER_NEAREST) > 0)


def free_hair(view: HairView, head: NDArray[np.bool_], cap_m: Array) -> NDArray[np.bool_]:
    """Return the hair pixels (H, W) of a side photo beside body and cap, if there is enough to hang.

    What stands above the head hangs from nothing: the dome of a cap, which all photos see, would be a knob of one.
    Right above what hangs on one side of the head it goes on: a bun, a high tail.
    """
    pixel_mm = view.pixel_mm(view.to_view(cap_m))
    least = max(3, int(np.ceil(THINNEST_MM / pixel_mm)))
    beside = cv2.morphologyEx((view.hair & ~head).astype(np.uint8), cv2.MORPH_OPEN, np.ones((least, least), np.uint8))
    top, free = int(head.any(axis=1).argmax()), beside.copy()
    free[:top] = 0
    _, pieces, stats, _ = cv2.connectedComponentsWithStats(free, connectivity=8)
    area = stats[:, cv2.CC_STAT_AREA] * pixel_mm**2
    away = np.zeros(len(stats))
    there = pieces > 0
    to_head = cv2.distanceTransform((~head).astype(np.uint8), cv2.DIST_L2, 5)[there]
    np.maximum.at(away, pieces[there], to_head * pixel_mm)
    hangs = (area >= SMALLEST_TAIL_MM2) & (away >= FREE_MM)
    hangs[0] = False
    found = np.asarray(hangs[pieces], np.bool_)
    crown = int(np.flatnonzero(head[top]).mean()) if head.any() else 0
    if found[top, :crown].any() != found[top, crown:].any():
        found[:top] = (beside[:top] > 0) & found[top]
    return found


def hangs_clear(view: HairView, free: NDArray[np.bool_], head: NDArray[np.bool_], cap_m: Array) -> NDArray[np.bool_]:
    """Return the components (H, W) of free hair with air between them and the head in enough rows.

    Where no photo of the back tells a tail from thick hair, which lies on the head all the way down. A tail's root
    and the hair of the nape may be one piece with it: then the air lies between two parts of its row.
    """
    air_px = AIR_MM / view.pixel_mm(view.to_view(cap_m))
    away = np.where(free, cv2.distanceTransform((~head).astype(np.uint8), cv2.DIST_L2, 5), np.float32(np.inf))
    count, pieces = cv2.connectedComponents(free.astype(np.uint8), connectivity=8)
    clear = np.zeros(count, np.bool_)
    air = ~(view.hair | head)
    for piece in range(1, count):
        own = pieces == piece
        nearest = np.where(own, away, np.float32(np.inf)).min(axis=1)
        spanned = np.logical_or.accumulate(own, axis=1) & np.logical_or.accumulate(own[:, ::-1], axis=1)[:, ::-1]
        alone = (nearest > air_px) | ((air & spanned).sum(axis=1) > air_px)
        clear[piece] = alone[np.isfinite(nearest)].mean() >= LEAST_ALONE
    return np.asarray(clear[pieces], np.bool_)


def tail_course(
    views: list[HairView], side: HairView, free: NDArray[np.bool_], head_m: Array, middle_m: float
) -> tuple[Callable[[Array], Array], Callable[[Array], Array], float] | None:
    """Return a tail's middle x and half width as functions of height, metres, and the ratio of its width to its depth.

    All come from the rows of the back photo in which the tail stands alone; where it nowhere does, long hair hangs
    loose: None.
    """
    rows = np.flatnonzero(free.any(axis=1))[::4]
    first = free[rows].argmax(axis=1)
    last = free.shape[1] - 1 - free[rows][:, ::-1].argmax(axis=1)
    camera = side.posed.camera
    near = np.repeat(side.to_view(np.array([[middle_m, *head_m[1:]]])), len(rows), axis=0)
    ends = [camera.back_project(np.column_stack([edge, rows]).astype(float), near) for edge in (first, last)]
    posed = 0.5 * (ends[0] + ends[1])
    depth_m = np.linalg.norm(ends[1] - ends[0], axis=1)
    rest = side.to_rest(posed)
    back = next((v for v in views if v.posed.view is ViewId.BODY_BACK), None)
    found = [_back_width(back, point) for point in rest] if back is not None else []
    good = [k for k, width in enumerate(found) if width is not None]
    alone = back is None or len(good) >= LEAST_ALONE * len(rows)
    if not alone and not (is_knot(free) and mm_from_m(head_m[1] - rest[:, 1].min()) < LOWEST_KNOT_MM):
        return None
    if not alone or not good:
        middle = float(np.median([width[0] for width in found if width is not None] or [middle_m]))
        return (
            (lambda height_m: np.full(len(height_m), middle)),
            (lambda height_m: np.full(len(height_m), np.inf)),
            1.0,
        )
    widths = np.array([found[k] for k in good])
    order = np.argsort(rest[good, 1])
    heights, (centres, breadths) = rest[good, 1][order], widths[order].T
    ratio = float(np.clip(np.median(widths[:, 1] / np.maximum(depth_m[good], 1e-3)), *ROUND_TAIL))
    return (
        lambda height_m: np.interp(height_m, heights, centres),
        lambda height_m: 0.5 * np.interp(height_m, heights, breadths),
        ratio,
    )


def is_knot(free: NDArray[np.bool_]) -> bool:
    """Return whether free hair (H, W) is as compact as a bun, which is as wide as it is deep."""
    high, deep = int(free.any(axis=1).sum()), int(free.sum(axis=1).max())
    return KNOT[0] * deep <= high <= KNOT[1] * deep and int(free.sum()) >= KNOT_FILL * high * deep


def _back_width(back: HairView | None, point_m: Array) -> tuple[float, float] | None:
    """Return the middle x and width, metres, of the hair around a rest point in the back photo, None if too wide."""
    if back is None:
        return None
    camera = back.posed.camera
    posed = back.to_view(point_m[None])
    column, row = np.rint(camera.project(posed)[0]).astype(int)
    height, width = back.hair.shape
    if not (0 <= row < height and 0 <= column < width) or not back.hair[row].any():
        return None
    line = back.hair[row]
    # A head turned or leaning between the photos carries its tail aside.
    hairy = np.flatnonzero(line)
    nearest = int(hairy[np.abs(hairy - column).argmin()])
    if mm_from_m(abs(nearest - column) * camera.metres_per_pixel(posed[0])) > FARTHEST_ASIDE_MM:
        return None
    column = nearest
    left = column - int(line[column::-1].argmin() if not line[: column + 1].all() else column) + 1
    right = column + int(line[column:].argmin() if not line[column:].all() else width - column) - 1
    pixel_m = camera.metres_per_pixel(posed[0])
    if mm_from_m((right - left + 1) * pixel_m) > WIDEST_TAIL_MM:
        return None
    centre = camera.back_project(np.array([[0.5 * (left + right), float(row)]]), posed)
    rest = back.to_rest(centre)
    return float(rest[0, 0]), (right - left + 1) * pixel_m
