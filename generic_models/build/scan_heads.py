"""Heads of a scan-based family (ICT-FaceKit's identity modes) laid into the generic human's numbering.

The family is told by a file outside this project (``ict_family.npz``: mean, modes, quads, 68 landmarks); nothing of it
is copied here. The generic head is laid on its mean once (``laid_generic``), so that every drawn head has a twin in the
generic's vertices: named points for rulers, masks for painting, and shapes to learn variances from.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import RBFInterpolator
from scipy.sparse import coo_matrix, csr_matrix, diags, identity
from scipy.sparse.linalg import splu

from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.meshes.alignment import similarity_alignment
from cloner.geometry.meshes.surface import SurfacePoints, nearest_points
from cloner.geometry.meshes.triangles import edges_of
from cloner.geometry.outlines.silhouette import vertex_normals

Array = NDArray[np.float64]

#: Vertices of the skin (face, neck, sockets) and of both eyeballs in the family's numbering.
SKIN: Final = 14062
EYES: Final = {"eye_left": (21451, 22221), "eye_right": (23021, 23791)}
#: Rows of the 68 landmarks that are points of ours; the stomion is the middle of the two inner lips.
LANDMARKS: Final = {
    "subnasale": 33, "lip_top": 51, "lip_bottom": 57,
    "eye_outer_R": 36, "eye_inner_R": 39, "eye_inner_L": 42, "eye_outer_L": 45, "mouth_corner_R": 48,
    "mouth_corner_L": 54,
}  # fmt: skip
#: Points of the mean head's profile defined as ours are, height and depth, metres: forehead's and chin's foremost,
#: bridge's deepest, just below the nose's foremost, and 12 mm behind the chin's front under it. The 68 landmarks of
#: those names lie 2 to 6 mm beside them.
PROFILE: Final = {
    "glabella": (0.0565, 0.1077), "nasion": (0.0429, 0.1064), "nose_tip": (0.0022, 0.1307),
    "chin_front": (-0.0609, 0.1105), "chin_bottom": (-0.0788, 0.0985),
}  # fmt: skip
INNER_LIPS: Final = (62, 66)
LIDS: Final = {
    "eye_upper_R": (37, 38), "eye_lower_R": (40, 41), "eye_upper_L": (43, 44), "eye_lower_L": (46, 47),
}  # fmt: skip
#: Rounds of laying, from stiff to soft: weight of smoothness against nearness.
STIFFNESS: Final = (30.0, 10.0, 3.0, 1.0, 0.4, 0.2)
#: Weight of a named point against a vertex.
PINNED: Final = 20.0
#: Skin is laid on skin that faces alike (cosine) and is no farther than this, metres.
ALIKE, NEAR_M = 0.5, 0.02


@dataclass(frozen=True, slots=True, eq=False)
class Family:
    """A family of heads, metres, left = +X, facing +Z: mean (N, 3), modes (M, N, 3) a standard deviation each."""

    mean_m: Array
    modes_m: NDArray[np.float32]
    triangles: NDArray[np.int64]
    landmarks: NDArray[np.int64]

    def head(self, coefficients: Array) -> Array:
        """Return the vertices (N, 3) of a head with coefficients (M,)."""
        moved = np.tensordot(coefficients.astype(np.float32), self.modes_m[: len(coefficients)], axes=1)
        return np.asarray(self.mean_m + moved, dtype=np.float64)


@functools.cache
def read_family(path: Path) -> Family:
    """Return the family's skin and eyeballs, the first rows of its vertices.

    Raises
    ------
    FileNotFoundError
        If the file is not on this machine: it is not ours to ship.
    """
    with np.load(path, allow_pickle=False) as data:
        mean = data["vertices_cm"].astype(np.float64) / 100.0
        modes = data["modes_int16"].astype(np.float32) * (data["modes_scale_cm"][:, None, None] / np.float32(100.0))
        quads, landmarks = data["faces"].astype(np.int64), data["landmarks68"].astype(np.int64)
    triangles = np.concatenate([quads[:, :3], quads[quads[:, 3] >= 0][:, [0, 2, 3]]])
    kept = (triangles < SKIN).all(axis=1)
    for low, high in EYES.values():
        kept |= ((triangles >= low) & (triangles < high)).all(axis=1)
    return Family(mean, modes, triangles[kept], landmarks)


@functools.cache
def _vertices(mean_bytes: bytes) -> dict[str, int]:
    """Return vertices of the mean head: its profile's points, and ears where skin stands out from the skull."""
    mean = np.frombuffer(mean_bytes).reshape(-1, 3)
    out = {}
    for name, (height, depth) in PROFILE.items():
        out[name] = int(np.linalg.norm(mean[:SKIN] - [0.0, height, depth], axis=1).argmin())
    for side, sign in (("L", 1.0), ("R", -1.0)):
        skin = mean[:SKIN] * [sign, 1.0, 1.0]
        near = (np.abs(skin[:, 1] - 0.01) < 0.05) & (np.abs(skin[:, 2]) < 0.03)
        rim = np.flatnonzero(near & (skin[:, 0] > 0.081))
        lobe = np.flatnonzero(near & (skin[:, 0] > 0.073) & (np.abs(skin[:, 2] - 0.006) < 0.012))
        out[f"ear_top_{side}"] = int(rim[skin[rim, 1].argmax()])
        out[f"ear_outer_{side}"] = int(rim[skin[rim, 0].argmax()])
        out[f"ear_lobe_{side}"] = int(lobe[skin[lobe, 1].argmin()])
    return out


def marks_of(family: Family, head_m: Array) -> dict[str, Array]:
    """Return the points (3,) of a head (N, 3) of the family that are named like ours."""
    rows = family.landmarks
    out = {name: head_m[rows[row]] for name, row in LANDMARKS.items()}
    out["stomion"] = head_m[rows[list(INNER_LIPS)]].mean(axis=0)
    out |= {name: head_m[rows[list(pair)]].mean(axis=0) for name, pair in LIDS.items()}
    return out | {name: head_m[row] for name, row in _vertices(family.mean_m.tobytes()).items()}


@dataclass(frozen=True, slots=True, eq=False)
class Laid:
    """The generic human laid on the family's mean head.

    Attributes
    ----------
    vertices_m : (V, 3) float64
        Skin of the head on the family's skin, the body below carried along.
    rows : (R,) int64
        Generic vertices that are bound to the family's skin, in ``generic.head_vertices``' order.
    places : SurfacePoints
        Where on the family's skin.
    gap_m : (R,) float64
        How far from it they stayed.
    """

    vertices_m: Array
    rows: NDArray[np.int64]
    places: SurfacePoints
    gap_m: Array

    def twin(self, head_m: Array) -> Array:
        """Return the bound vertices (R, 3) of a head (N, 3) of the family."""
        return self.places.at(head_m)


def outer_skin(generic: GenericHuman) -> NDArray[np.bool_]:
    """Return which generic vertices (V,) are the head's outer skin, down to the neck's base."""
    skin = generic.vertex_part == generic.part_names.index("body")
    skin &= ~generic.region("mouth_interior")
    wanted = np.zeros(len(skin), dtype=bool)
    wanted[generic.head_vertices] = True
    return np.asarray(skin & wanted & (generic.head_blend > 0.05))


@functools.cache
def laid_generic(path: Path) -> Laid:
    """Return the generic laid on the family's mean head: by named points first, then skin on skin, ever softer."""
    family, generic = read_family(path), load_generic()
    rest, marks = generic.vertices_m.astype(np.float64), marks_of(family, family.mean_m)
    own = rest[[generic.feature(name) for name in marks]]
    goal = np.array(list(marks.values()))
    scale, rotation, shift = similarity_alignment(own, goal)
    first = scale * rest @ rotation.T + shift
    anchors = scale * own @ rotation.T + shift
    warp = RBFInterpolator(anchors, goal - anchors, kernel="linear", smoothing=1e-5)
    rows = np.flatnonzero(outer_skin(generic))
    start = first[rows] + warp(first[rows])
    skin = family.triangles[(family.triangles < SKIN).all(axis=1)]
    local = np.full(len(rest), -1, dtype=np.int64)
    local[rows] = np.arange(len(rows))
    triangles = local[generic.triangles()[0]]
    triangles = triangles[(triangles >= 0).all(axis=1)]
    pins = {int(local[generic.feature(name)]): place for name, place in marks.items()}
    found = _laid_softly(start, triangles, family.mean_m, skin, pins)
    places = nearest_points(found, family.mean_m, skin, candidates=40)
    vertices = first.copy()
    carried = RBFInterpolator(anchors, goal - anchors, kernel="linear", smoothing=1e-5)(first)
    fade = np.clip((generic.head_blend - 0.0) / 0.05, 0.0, 1.0)[:, None]
    vertices += fade * carried
    vertices[rows] = places.at(family.mean_m)
    gap = np.linalg.norm(vertices[rows] - found, axis=1)
    return Laid(vertices, rows, places, gap)


def _laid_softly(
    start: Array, triangles: NDArray[np.int64], goal: Array, skin: NDArray[np.int64], pins: Mapping[int, Array]
) -> Array:
    """Return points (R, 3) drawn to the nearest skin that faces alike, neighbours moving alike; pins have places."""
    count, edges = len(start), edges_of(triangles)[0]
    ones = np.ones(len(edges))
    near = coo_matrix((ones, (edges[:, 0], edges[:, 1])), shape=(count, count))
    near = csr_matrix(near + near.T)
    degree = np.maximum(np.asarray(near.sum(axis=1)).ravel(), 1.0)
    bend = identity(count) - diags(1.0 / degree) @ near
    smooth = csr_matrix(bend.T @ bend)
    goal_normals = vertex_normals(goal, skin)
    moved = np.zeros_like(start)
    for stiff in STIFFNESS:
        for _ in range(4):
            here = start + moved
            places = nearest_points(here, goal, skin, candidates=30)
            away = places.at(goal) - here
            normals = places.at(goal_normals)
            alike = (normals * vertex_normals(here, triangles)).sum(axis=1)
            weight = ((alike > ALIKE) & (np.linalg.norm(away, axis=1) < NEAR_M)).astype(np.float64)
            for row, place in pins.items():
                away[row], weight[row] = place - here[row], PINNED
            system = csr_matrix(diags(weight) + stiff * smooth + 1e-6 * identity(count))
            moved = splu(system.tocsc()).solve(weight[:, None] * (away + moved))
    return np.asarray(start + moved)


def twin_vertices(laid: Laid, head_m: Array) -> Array:
    """Return the generic's vertices (V, 3) of a head (N, 3): its skin as bound, eyeballs where its own are.

    The rest stays as on the mean head.
    """
    out, generic = laid.vertices_m.copy(), load_generic()
    out[laid.rows] = laid.twin(head_m)
    for part, (low, high) in EYES.items():
        rows = generic.part(part)
        out[rows] += _middle(head_m[low:high]) - _middle(out[rows])
    return out


def _middle(points: Array) -> Array:
    """Return the middle (3,) of the box around points."""
    return np.asarray((points.min(axis=0) + points.max(axis=0)) / 2.0)
