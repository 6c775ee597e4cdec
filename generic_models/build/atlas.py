"""UV islands, and a new atlas in which face, hands and eyes get the pixels people look at."""

from __future__ import annotations

import numpy as np
import scipy.sparse as sparse
from cage import PARTS, Cage
from scipy.sparse.csgraph import connected_components
from source import FloatArray, IntArray

SIZE_PX = 2048
MARGIN_PX = 5  # round every island; neighbours are then 10 px apart
EYE_PX = 240  # diameter of the eye's disc: its front half then has 170 px


def island_of_uv(cage: Cage) -> IntArray:
    """Return the island number of every UV vertex, (T,)."""
    corners = cage.quad_uv
    edges = np.vstack([corners[:, [k, (k + 1) % 4]] for k in range(4)])
    links = sparse.coo_matrix((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(cage.uv.shape[0],) * 2)
    return connected_components(links, directed=False)[1]


def island_names(cage: Cage, island: IntArray, vertices_m: FloatArray) -> list[str]:
    """Return a name for each island, told apart by part, height and side."""
    out = []
    for number in range(island.max() + 1):
        quads = np.flatnonzero(island[cage.quad_uv[:, 0]] == number)
        points = vertices_m[np.unique(cage.quads[quads])]
        part = PARTS[cage.quad_part[quads[0]]]
        middle, size = points.mean(axis=0), np.ptp(points, axis=0)
        side = "left" if middle[0] > 0 else "right"
        if part != "body":
            out.append(part if part not in out else part + "_lower")
        elif size[1] > 1.0:
            out.append("trunk")
        elif middle[1] < 0.2:
            out.append(f"foot_{side}")
        elif middle[1] < 1.3:
            out.append(f"hand_{side}")
        elif size[1] > 0.15:
            out.append("head")
        else:
            out.append("mouth" if size[0] > 0.05 else f"socket_{side}")
    return out


def quad_areas(points: FloatArray, quads: IntArray) -> FloatArray:
    """Return the areas of quads in 2 or 3 dimensions, (Q,)."""
    corners = points[quads]
    if points.shape[1] == 2:
        corners = np.concatenate([corners, np.zeros((*corners.shape[:2], 1))], axis=2)
    cross = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    return np.linalg.norm(cross, axis=1) / 2


def _stretch(values: FloatArray, where: FloatArray, mass: FloatArray, floor: float) -> FloatArray:
    """Return a strictly rising map of ``values`` that gives each stretch a length near its share of ``mass``.

    ``floor`` in 0..1 keeps that part of the old spacing: 1 changes nothing.
    """
    bins = np.linspace(values.min(), values.max(), 33)
    height = np.histogram(where, bins=bins, weights=mass)[0]
    height = np.convolve(np.pad(height, 2, mode="edge"), np.ones(5) / 5, mode="valid")
    density = floor / height.size + (1 - floor) * height / height.sum()
    return np.interp(values, bins, np.concatenate([[0.0], np.cumsum(density)]))


def enlarge_face(uv: FloatArray, quad_uv: IntArray, mass: FloatArray) -> FloatArray:
    """Warp the head's island so that its busy middle grows, one rising map per axis (no fold can appear).

    Parameters
    ----------
    uv : (T, 2); quad_uv : (Q, 4) of this island only; mass : (Q,) wanted area share of each quad.
    """
    used = np.unique(quad_uv)
    middle = uv[quad_uv].mean(axis=1)
    out = uv.copy()
    spans = []
    for axis in (0, 1):
        spans.append(np.ptp(uv[used, axis]))
        out[used, axis] = _stretch(uv[used, axis], middle[:, axis], np.sqrt(mass), 0.45) * spans[-1]
    return out


# Enlargement of each island against hm08's own UV; taste, tuned until the head had 35 % and all fitted.
SCALE = {
    "head": 1.0,
    "trunk": 0.46,
    "hand": 0.66,
    "foot": 0.62,
    "mouth": 0.45,
    "socket": 0.45,
    "teeth": 1.1,
    "tongue": 1.1,
    "lashes": 1.0,
    "eye": 0.0,
}


def _place(sizes: FloatArray, order: list[int]) -> FloatArray | None:
    """Return lower-left corners of boxes in the unit square by skyline packing, or None if one does not fit."""
    sky = [(0.0, 1.0, 0.0)]  # stretches (from, to, height)
    corners = np.zeros_like(sizes)
    for box in order:
        width, height = sizes[box]
        best: tuple[float, float] | None = None
        for start, _, _ in sky:
            if start + width > 1.0 + 1e-12:
                continue
            level = max(h for a, b, h in sky if a < start + width - 1e-12 and b > start + 1e-12)
            if level + height <= 1.0 + 1e-12 and (best is None or (level, start) < best):
                best = (level, start)
        if best is None:
            return None
        level, start = best
        corners[box] = start, level
        kept = []
        for a, b, h in sky:
            if a < start:
                kept.append((a, min(b, start), h))
            if b > start + width:
                kept.append((max(a, start + width), b, h))
        sky = sorted(s for s in [*kept, (start, start + width, level + height)] if s[1] - s[0] > 1e-12)
    return corners


def repack(cage: Cage, vertices_m: FloatArray) -> FloatArray:
    """Return new UVs (T, 2), v upwards: head largest, hands enlarged, eyes of a fixed size, no overlap.

    The head's island is first warped so that the face has more of it than the scalp.
    """
    island = island_of_uv(cage)
    names = island_names(cage, island, vertices_m)
    of_quad = island[cage.quad_uv[:, 0]]
    uv = cage.uv.copy()
    head = of_quad == names.index("head")
    seen = quad_areas(vertices_m, cage.quads[head])
    centre = vertices_m[cage.quads[head]].mean(axis=1)
    face = np.clip((centre[:, 2] - 0.02) / 0.08, 0.0, 1.0)  # 0 behind the ears, 1 on the face; metres
    ear = np.abs(centre[:, 0]) > 0.072  # metres; only ears reach so far out on the mean head
    uv = enlarge_face(uv, cage.quad_uv[head], seen * (0.35 + 1.2 * face + 4.0 * ear))
    boxes = []
    for number, name in enumerate(names):
        points = uv[island == number]
        points -= points.min(axis=0)
        scale = SCALE[name.split("_")[0]]
        uv[island == number] = points * (scale if scale else EYE_PX / SIZE_PX / np.ptp(points, axis=0).max())
        boxes.append(np.ptp(uv[island == number], axis=0))
    sizes = np.array(boxes)
    fixed = np.array([n.startswith("eye_") for n in names])
    order = sorted(range(len(names)), key=lambda k: (-sizes[k, 1], k))
    margin = MARGIN_PX / SIZE_PX
    low, high, corners, grow = 0.2, 2.0, None, 0.2
    for _ in range(24):
        middle = (low + high) / 2
        found = _place(np.where(fixed[:, None], sizes, sizes * middle) + 2 * margin, order)
        if found is None:
            high = middle
        else:
            low = grow = middle
            corners = found
    if corners is None:
        raise ValueError("the islands do not fit the atlas")
    for number in range(len(names)):
        scale = 1.0 if fixed[number] else grow
        uv[island == number] = uv[island == number] * scale + corners[number] + margin
    return uv
