"""Feet scaled to the photos: closed toes in shoes, flat soles."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import RBFInterpolator
from scipy.spatial import ConvexHull

from cloner.calibration.loader import calibrated
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_triangles
from cloner.geometry.charts.discs import even_disc_weights
from cloner.geometry.meshes.triangles import areas, edges_of
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.feet")


TOES_FROM = _CALIBRATED.number("toes_from", "share")
TIPS_BACK = _CALIBRATED.number("tips_back", "share")
WELT_M = _CALIBRATED.number("welt_m", "m")


@dataclass(frozen=True, slots=True)
class Params:
    """How a foot becomes a shoe.

    Its numbers: ``cloner/calibration/body.toml``, ``[feet.*]``.
    """

    barefoot_m: float = _CALIBRATED.number("barefoot_m", "m")
    shod: tuple[float, float, float, float] = _CALIBRATED.quadruple("shod", "m")
    sigma: tuple[float, float, float, float] = _CALIBRATED.quadruple("spread", "m")


@functools.cache
def _feet() -> tuple[NDArray[np.int64], Array, NDArray[np.int64]]:
    """Return the feet's vertices, their foot weights, and the ankle joint of each."""
    generic = load_generic()
    weights = np.column_stack([generic.share("left_foot"), generic.share("right_foot")])
    vertices = np.flatnonzero(weights.sum(axis=1) > 0.01)
    ankles = np.array([generic.joint("l_ankle"), generic.joint("r_ankle")])
    return vertices, weights[vertices].sum(axis=1), ankles[np.argmax(weights[vertices], axis=1)]


@dataclass(frozen=True, slots=True, eq=False)
class ShoeTip:
    """The inside of a shoe's tip: a convex hull, star-shaped around a middle.

    Attributes
    ----------
    middle, half : (3,) metres
        The middle, and half the hull's extents: seen from there and measured in them a shoe is nearly a ball.
    planes : (H, 4)
        The hull's outward unit normals and offsets.
    """

    middle: Array
    half: Array
    planes: Array

    def flat(self, points_m: Array) -> Array:
        """Return the directions of points from the middle as (N, 2) on a disc, straight ahead in its centre."""
        direction = (points_m - self.middle) / self.half
        direction /= np.linalg.norm(direction, axis=1, keepdims=True)
        return np.asarray(direction[:, :2] / (1.0 + direction[:, 2:]))

    def laid(self, flat: Array) -> Array:
        """Return the points (N, 3) on the hull, metres, for positions on the disc."""
        out = (flat**2).sum(axis=1, keepdims=True)
        return self.onto_hull(self.middle + np.hstack([2.0 * flat, 1.0 - out]) / (1.0 + out) * self.half)

    def onto_hull(self, points_m: Array) -> Array:
        """Return points (N, 3) projected radially on to the hull."""
        ray = points_m - self.middle
        rise = ray @ self.planes[:, :3].T
        room = -(self.middle @ self.planes[:, :3].T + self.planes[:, 3])
        reach = np.where(rise > 1e-9, room / np.maximum(rise, 1e-9), np.inf).min(axis=1)
        return np.asarray(self.middle + reach[:, None] * ray)


def _front(mesh: BodyMesh, side: str) -> tuple[NDArray[np.int64], Array]:
    """Return a foot's vertices before its instep, and how far before, 0 to 1 at the tip of the longest toe."""
    generic = load_generic()
    vertices, _, ankle = _feet()
    own = vertices[ankle == generic.joint(f"{side}_ankle")]
    start_z = mesh.joints_m[generic.joint(f"{side}_midtarsal"), 2]
    before = (mesh.vertices_m[own, 2] - start_z) / (mesh.vertices_m[own, 2].max() - start_z)
    low = mesh.vertices_m[own, 1] < mesh.joints_m[generic.joint(f"{side}_ankle"), 1]
    front = low & (before > 0.0)
    return own[front], before[front]


def _shoe_tip(mesh: BodyMesh, side: str) -> ShoeTip:
    """Return the inside of one shoe's tip, on a flat sole."""
    generic = load_generic()
    points = mesh.vertices_m[_front(mesh, side)[0]]
    foot = generic.region("sole") & generic.region({"l": "foot_left", "r": "foot_right"}[side])
    floor = float(mesh.vertices_m[foot, 1].min())
    under = points[points[:, 1] < floor + WELT_M]
    points = np.vstack([points, np.column_stack([under[:, 0], np.full(len(under), floor), under[:, 2]])])
    start_z = mesh.joints_m[generic.joint(f"{side}_midtarsal"), 2]
    middle = points.mean(axis=0)
    middle[2] = start_z + 0.25 * (points[:, 2].max() - start_z)
    return ShoeTip(middle, np.ptp(points, axis=0) / 2.0, ConvexHull(points).equations)


@functools.cache
def toe_weights() -> Array:
    """Return the weight (V,) with which each vertex belongs to the toes, 0 from the instep backwards."""
    generic = load_generic()
    mesh = BodyMesh(generic.vertices_m.astype(np.float64), generic.joints_m.astype(np.float64))
    share = np.zeros(len(mesh.vertices_m))
    for side in ("l", "r"):
        front, before = _front(mesh, side)
        share[front] = np.clip(before / TOES_FROM, 0.0, 1.0)
    share.flags.writeable = False
    return share


@dataclass(frozen=True, slots=True, eq=False)
class Toes:
    """The left toes and their positions in a shoe.

    Attributes
    ----------
    vertices : (N,) int64
    ring : (B,) int64
        The vertices behind the toes, which bound them.
    shares : (N, B)
        How the ring's places on the disc place every vertex.
    warp : (N, 2)
        What brings the tips back towards where they point.
    """

    vertices: NDArray[np.int64]
    ring: NDArray[np.int64]
    shares: Array
    warp: Array


@functools.cache
def _toes() -> Toes:
    """Return the toes' positions in a shoe.

    Pushed straight outwards the toes' sides would cover each other; laid out from the ring that bounds them every
    place of the shoe is covered once, by about as much skin as it had.
    """
    generic = load_generic()
    mesh = BodyMesh(generic.vertices_m.astype(np.float64), generic.joints_m.astype(np.float64))
    front, before = _front(mesh, "l")
    inside = np.zeros(len(mesh.vertices_m), dtype=np.bool_)
    inside[front[before > TOES_FROM]] = True
    triangles = load_triangles()[inside[load_triangles()].all(axis=1)]
    rows = np.unique(triangles).astype(np.int64)
    local = np.searchsorted(rows, triangles)
    edges, owners = edges_of(local)
    rim, room = np.unique(edges[owners == 1]), _shoe_tip(mesh, "l")
    flat = room.flat(mesh.vertices_m[rows])
    shares = even_disc_weights(local, areas(mesh.vertices_m, triangles), flat[rim], room.laid)
    even = shares @ flat[rim]
    held = np.concatenate([rim, _peaks(mesh.vertices_m[rows, 2], edges)])
    back = RBFInterpolator(even[held], (flat - even)[held], kernel="thin_plate_spline", degree=1)
    return Toes(rows, rows[rim], shares, TIPS_BACK * back(even))


def _peaks(heights: Array, edges: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return the local maxima of heights on a mesh."""
    highest = np.full(len(heights), -np.inf)
    for one, other in ((0, 1), (1, 0)):
        np.maximum.at(highest, edges[:, one], heights[edges[:, other]])
    return np.flatnonzero(heights > highest)


def close_toes(mesh: BodyMesh) -> BodyMesh:
    """Return the body with its toes closed to their convex hull, as in a shoe, without folds."""
    mirror, toes = load_generic().mirror, _toes()
    moved = mesh.vertices_m.copy()
    for side in ("l", "r"):
        room = _shoe_tip(mesh, side)
        front, before = _front(mesh, side)
        share = np.clip(before / TOES_FROM, 0.0, 1.0)[:, None]
        moved[front] += share * (room.onto_hull(mesh.vertices_m[front]) - mesh.vertices_m[front])
        left = side == "l"
        own, ring = (toes.vertices, toes.ring) if left else (mirror[toes.vertices], mirror[toes.ring])
        outwards = 1.0 if left else -1.0
        moved[own] = room.laid(toes.shares @ room.flat(mesh.vertices_m[ring]) + toes.warp * [outwards, 1.0])
    return BodyMesh(moved, mesh.joints_m)


def scale_feet(mesh: BodyMesh, size: Array, sole_m: float) -> Array:
    """Return the vertices with both feet scaled about their ankles.

    Parameters
    ----------
    size : (4,) factors of width, length and height of the instep, and a shift forwards in metres
    sole_m : height of the soles below the naked foot; the foot is stretched down to them
    """
    vertices, weight, ankle = _feet()
    moved = mesh.vertices_m.copy()
    tall = mesh.joints_m[ankle, 1]
    local = moved[vertices] - mesh.joints_m[ankle]
    down = local[:, 1] * (1.0 + sole_m / tall * np.clip(-local[:, 1] / tall, 0.0, 1.0))
    before = np.clip(local[:, 2] / 0.05, 0.0, 1.0)
    raised = (down + tall + sole_m) * (1.0 + (size[2] - 1.0) * before) - tall - sole_m
    scaled = np.stack([local[:, 0] * size[0], raised, local[:, 2] * size[1] + size[3]], axis=1)
    moved[vertices] += weight[:, None] * (scaled - local)
    return moved


def shape_feet(mesh: BodyMesh, sole_m: float, params: Params) -> tuple[BodyMesh, Array, Array]:
    """Return the body with toes closed where it wears shoes, the feet's expected size and its sigma."""
    shod = sole_m > params.barefoot_m
    mean = np.array(params.shod) if shod else np.array([1.0, 1.0, 1.0, 0.0])
    return (flatten_soles(close_toes(mesh)) if shod else mesh), mean, np.array(params.sigma)


def flatten_soles(mesh: BodyMesh) -> BodyMesh:
    """Return the body with the arches of its soles filled down to the floor, as a shoe's sole does.

    Closed toes are as low as they get: their skin lies all around the shoe's tip.
    """
    generic = load_generic()
    flat = mesh.vertices_m.copy()
    for side in ("left", "right"):
        sole = np.flatnonzero(generic.region("sole") & generic.region(f"foot_{side}"))
        toes = _toes().vertices if side == "left" else generic.mirror[_toes().vertices]
        flat[np.setdiff1d(sole, toes), 1] = flat[sole, 1].min()
    return BodyMesh(flat, mesh.joints_m)
