"""Feet sized from the photos: a shoe closes over the toes, soles reach the floor."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from cloner.generic.load import load_generic
from cloner.records.bodies import BodyMesh
from cloner.stages.outlined import Outlined, Seen, see

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
    outline_mm : float
        Trust in one rim vertex's distance from the outline.
    """

    barefoot_m: float = 0.006
    shod: tuple[float, float, float, float] = (1.08, 1.08, 1.2, 0.0)
    spread: tuple[float, float, float, float] = (0.1, 0.06, 0.15, 0.01)
    outline_mm: float = 5.0


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


def fit_feet(mesh: BodyMesh, photos: tuple[Outlined, ...], sole_m: float, params: Params) -> BodyMesh:
    """Return the body with feet or shoes of the size the outlines show."""
    shod = sole_m > params.barefoot_m
    start = closed_toes(mesh) if shod else mesh
    mean = np.array(params.shod) if shod else np.array([1.0, 1.0, 1.0, 0.0])
    spread = np.array(params.spread)
    size = mean.copy()
    on_feet = np.zeros(len(mesh.vertices_m), dtype=bool)
    on_feet[_feet()[0]] = _feet()[1] > 0.6
    for _ in range(3):
        body = BodyMesh(sized_feet(start, size, sole_m), mesh.joints_m)
        seen = [see(body, photo) for photo in photos]
        rims = [np.flatnonzero(s.body.on_rim & on_feet) for s in seen]

        def residual(values: Array, seen: list[Seen] = seen, rims: list[NDArray[np.int64]] = rims) -> Array:
            vertices = sized_feet(start, values, sole_m)
            parts = [(values - mean) / spread]
            for photo, one, rim in zip(photos, seen, rims, strict=True):
                posed = np.einsum("vab,vb->va", one.blended[rim, :, :3], vertices[rim]) + one.blended[rim, :, 3]
                gap = photo.field.signed_distance(photo.posed.camera.project(posed)) * one.mm_per_px / params.outline_mm
                parts.append(3.0 * np.tanh(gap / 3.0) / np.sqrt(max(len(rim) / 40.0, 1.0)))
            return np.concatenate(parts)

        value = residual(size)
        jacobian = np.stack([(residual(size + step) - value) / 1e-3 for step in 1e-3 * np.eye(4)], axis=1)
        size = size - np.linalg.solve(jacobian.T @ jacobian, jacobian.T @ value)
        size = np.clip(size, mean - 3 * spread, mean + 3 * spread)
    return BodyMesh(sized_feet(start, size, sole_m), mesh.joints_m)
