"""Feet sized from the photos: a shoe closes over the toes, soles reach the floor."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from cloner.generic.load import load_generic
from cloner.records.bodies import BodyMesh

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Params:
    """How a foot becomes a shoe.

    Attributes
    ----------
    barefoot_m : float
        Soles thinner than this are taken for naked feet, metres.
    shod, spread : tuple of float
        Usual width, length and height of a shoe over the foot in it, and a shift
        forwards in metres; and how far each may differ (taste).
    """

    barefoot_m: float = 0.006
    shod: tuple[float, float, float, float] = (1.08, 1.08, 1.2, 0.0)
    spread: tuple[float, float, float, float] = (0.1, 0.06, 0.15, 0.01)


@functools.cache
def _feet() -> tuple[NDArray[np.int64], Array, NDArray[np.int64]]:
    """Return the feet's vertices, their foot weight, and the ankle joint of each."""
    generic = load_generic()
    rows = [generic.segment_names.index(f"{side}_foot") for side in ("left", "right")]
    weights = generic.segment_weights[:, rows].astype(np.float64)
    vertices = np.flatnonzero(weights.sum(axis=1) > 0.01)
    ankles = np.array([generic.joint("l_ankle"), generic.joint("r_ankle")])
    return vertices, weights[vertices].sum(axis=1), ankles[np.argmax(weights[vertices], axis=1)]


def closed_toes(mesh: BodyMesh) -> BodyMesh:
    """Return the body with its toes pushed out on to their convex hull, as in a shoe."""
    generic = load_generic()
    vertices, _, ankle = _feet()
    moved = mesh.vertices_m.copy()
    for side in ("l", "r"):
        own = vertices[ankle == generic.joint(f"{side}_ankle")]
        start_z = mesh.joints_m[generic.joint(f"{side}_midtarsal"), 2]
        tip_z = mesh.vertices_m[own, 2].max()
        low = mesh.vertices_m[own, 1] < mesh.joints_m[generic.joint(f"{side}_ankle"), 1]
        front = own[low & (mesh.vertices_m[own, 2] > start_z)]
        points = mesh.vertices_m[front]
        hull = ConvexHull(points)
        middle = points.mean(axis=0)
        middle[2] = start_z + 0.25 * (tip_z - start_z)
        ray = points - middle
        rise = ray @ hull.equations[:, :3].T
        room = -(middle @ hull.equations[:, :3].T + hull.equations[:, 3])
        reach = np.where(rise > 1e-9, room / np.maximum(rise, 1e-9), np.inf).min(axis=1)
        share = np.clip((points[:, 2] - start_z) / (0.4 * (tip_z - start_z)), 0.0, 1.0)
        moved[front] = points + (share * (reach - 1.0))[:, None] * ray
    return BodyMesh(moved, mesh.joints_m)


def sized_feet(mesh: BodyMesh, size: Array, sole_m: float) -> Array:
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


def shaped_feet(mesh: BodyMesh, sole_m: float, params: Params) -> tuple[BodyMesh, Array, Array]:
    """Return the body with toes closed where it wears shoes, the feet's usual size and its spread."""
    shod = sole_m > params.barefoot_m
    mean = np.array(params.shod) if shod else np.array([1.0, 1.0, 1.0, 0.0])
    return (flat_soled(closed_toes(mesh)) if shod else mesh), mean, np.array(params.spread)


def flat_soled(mesh: BodyMesh) -> BodyMesh:
    """Return the body with the arches of its soles filled down to the floor, as a shoe's sole does."""
    generic = load_generic()
    flat = mesh.vertices_m.copy()
    for side in ("left", "right"):
        sole = np.flatnonzero(generic.region("sole") & generic.region(f"foot_{side}"))
        flat[sole, 1] = flat[sole, 1].min()
    return BodyMesh(flat, mesh.joints_m)
