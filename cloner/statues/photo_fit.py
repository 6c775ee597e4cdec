"""Fitting of a photograph to a mesh by markers: camera, deformation, texture.

The source (statues of the tutorial): interesting vertices are marked, projected on the picture and dragged to their
right places in it, while the textured object shows live. Ours: the marks tell the camera, what the camera leaves bends
the mesh (DFFD with the marks as control points), and `cloner.statues.continued` paints what the photo does not show.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix

from cloner.errors import ClonerError
from cloner.fit.cameras import resect
from cloner.geometry.cameras.viewpoints import facing_camera
from cloner.geometry.deformation.dffd import deform, enclosing_points, sibson_weights
from cloner.records.arrays import Array
from cloner.records.meshes import Mesh
from cloner.records.views import Camera
from cloner.statues.continued import ContinuedTexture, laid_photo, photo_trust

Index = NDArray[np.int32]

#: Fewer markers tell no camera.
FEWEST: Final = 6
#: Focal length where the photo tells none, mm at 35 mm film: a portrait lens, as of the product's own face photos.
FOCAL_35MM: Final = 75.0
#: From where the photo may have been taken, radians round the mesh.
AZIMUTHS: Final = tuple(np.radians([-60.0, -30.0, 0.0, 30.0, 60.0]).tolist())
#: What shapes of one kind differ by, share of the markers' spread in the photo: markers that miss by more than some of
#: these turn no camera.
SIGMA: Final = 0.03
#: A long face seen straight is no round face seen from aside: so many times as high as the mesh the thing may be while
#: its camera is sought; then halfway to the neighbours of the best. A tenth more or less costs as much as missing all
#: markers by `SIGMA`.
HEIGHTS: Final = (0.8, 0.9, 1.0, 1.12, 1.25)
HALVINGS, USUAL_STRETCH = 3, 0.1
#: A triangle that faced the camera by this cosine and is turned away is turned over.
SQUARE: Final = 0.3
#: The mesh bends within a box so far round the markers, share of their extent; beyond it stays.
REACH: Final = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Marked:
    """A mesh with its markers, ready to be dragged about.

    Attributes
    ----------
    mesh : Mesh
    vertex : (K,) int32
        The marked vertices.
    reached : (R,) int64
        The vertices that bend.
    bent : (B, 3) int32
        The triangles among them.
    weights : (R, K + 26) sparse
        Sibson coordinates of them among markers and the box round them.
    """

    mesh: Mesh
    vertex: Index
    reached: NDArray[np.int64]
    bent: Index
    weights: csr_matrix


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """Where the markers put the mesh.

    Attributes
    ----------
    camera : Camera
    height : float
        So many times as high as the mesh the thing was taken for while its camera was sought.
    vertices_m : (V, 3) float64
        Bent so that every marked vertex is seen at its marker.
    missed_px : (K,) float64
        How far from its marker each vertex was seen before the mesh was bent.
    turned : int
        Triangles that faced the camera and are turned over now: markers that cross one another.
    """

    camera: Camera
    height: float
    vertices_m: Array
    missed_px: Array
    turned: int

    @property
    def uv_photo(self) -> Array:
        """Places (V, 2) of all vertices in the photo, 0..1, v downwards: what a live view needs for a texture."""
        size = (self.camera.width_px, self.camera.height_px)
        return np.asarray((self.camera.project(self.vertices_m) + 0.5) / size)


@dataclass(frozen=True, slots=True, eq=False)
class PhotoFit:
    """A mesh bent to a photo, and the photo as its texture, continued all round."""

    fit: Fit
    laid: ContinuedTexture


def mark(mesh: Mesh, vertex: Index) -> Marked:
    """Return a mesh with some vertices (K,) marked.

    Raises
    ------
    ClonerError
        If there are too few markers, one twice, or one that the mesh does not have.
    """
    rows = np.asarray(vertex, np.int64)
    if len(rows) < FEWEST:
        raise ClonerError(f"{len(rows)} markers are too few", f"Mark at least {FEWEST} vertices", "--markers")
    if rows.min() < 0 or rows.max() >= len(mesh.vertices_m):
        raise ClonerError("a marker's vertex is not on the mesh", f"It has {len(mesh.vertices_m)} of them", "--markers")
    places = mesh.vertices_m[rows]
    if len(np.unique(places, axis=0)) < len(places):
        raise ClonerError("two markers lie on the same vertex", "Leave one of them out", "--markers")
    if np.linalg.matrix_rank(places - places.mean(axis=0), tol=1e-3 * float(np.ptp(places, axis=0).max())) < 2:
        raise ClonerError("all markers lie on one line", "Mark vertices beside it too", "--markers")
    box = enclosing_points(places, margin=REACH)
    inside = (mesh.vertices_m > box.min(axis=0)) & (mesh.vertices_m < box.max(axis=0))
    bends = inside.all(axis=1)
    bent, reached = mesh.triangles[bends[mesh.triangles].any(axis=1)], np.flatnonzero(bends)
    return Marked(mesh, rows.astype(np.int32), reached, bent, _weights(mesh.vertices_m[reached], places, box))


def _weights(queries_m: Array, places_m: Array, box_m: Array) -> csr_matrix:
    """Return Sibson coordinates; marked vertices are themselves to the bit."""
    return sibson_weights(queries_m, np.concatenate([places_m, box_m]))


def focal_px_of(width_px: int, height_px: int, focal_35mm: float | None = None) -> float:
    """Return the focal length of a photo in pixels, a portrait lens' where it tells none."""
    return (focal_35mm or FOCAL_35MM) / 36.0 * max(width_px, height_px)


def fit_markers(
    marked: Marked, markers_px: Array, size_px: tuple[int, int], focal_px: float, start: Fit | None = None
) -> Fit:
    """Return camera and bent mesh for markers at (K, 2) pixels of a photo: what a drag asks for.

    Parameters
    ----------
    marked : Marked
    markers_px : (K, 2)
    size_px : (int, int)
        Width and height of the photo.
    focal_px : float
    start : Fit or None
        That of the drag before; None looks for the camera from several sides.

    Raises
    ------
    ClonerError
        If the markers do not fit the mesh in number, or lie at one place.
    """
    markers = np.asarray(markers_px, np.float64)
    if markers.shape != (len(marked.vertex), 2) or not np.isfinite(markers).all():
        raise ClonerError("markers on mesh and photo differ in number", "Give each both places", "--markers")
    spread = float(np.linalg.norm(markers - markers.mean(axis=0), axis=1).mean())
    if spread < 2.0:
        raise ClonerError("all markers lie at one place of the photo", "Drag them to their places", "--markers")
    places = marked.mesh.vertices_m[marked.vertex]
    sigma = SIGMA * spread
    if start is None:
        camera, height = _found(places, markers, sigma, size_px, focal_px)
    else:
        height = start.height
        camera = resect(_higher(places, height), markers, start.camera, sigma_px=sigma)
    target = camera.back_project(markers, places)
    vertices = marked.mesh.vertices_m.copy()
    vertices[marked.reached] += deform(marked.weights, target - places)
    vertices[marked.vertex] = target
    missed = np.linalg.norm(camera.project(places) - markers, axis=1)
    return Fit(camera, height, vertices, missed, _turned(marked, camera, vertices))


def fit_photo(
    mesh: Mesh,
    markers_mesh: Index,
    markers_px: Array,
    photo: NDArray[np.uint8],
    *,
    focal_px: float | None = None,
    size: int = 2048,
) -> PhotoFit:
    """Return a mesh bent to a photo of something alike, with the photo as its texture all round.

    Parameters
    ----------
    mesh : Mesh
    markers_mesh : (K,) int
        Marked vertices.
    markers_px : (K, 2) float
        Where the photo shows them.
    photo : (H, W, 3) uint8
    focal_px : float or None
    size : int
        Side of the texture, texels.

    Raises
    ------
    ClonerError
        As :func:`mark` and :func:`fit_markers`.
    """
    height, width = photo.shape[:2]
    focal = focal_px or focal_px_of(width, height)
    marked = mark(mesh, markers_mesh)
    fit = fit_markers(marked, markers_px, (width, height), focal)
    near = photo_trust(fit.vertices_m, fit.vertices_m[marked.vertex])
    return PhotoFit(fit, laid_photo(mesh, fit.vertices_m, fit.camera, photo, size, near))


def _found(
    places_m: Array, markers_px: Array, sigma_px: float, size_px: tuple[int, int], focal_px: float
) -> tuple[Camera, float]:
    """Return the camera that sees the markers best of several sides, and how high the thing is taken for."""
    width, height = size_px

    def tried(high: float, azimuths: tuple[float, ...]) -> list[tuple[float, float, float, Camera]]:
        own, found = _higher(places_m, high), []
        for azimuth in azimuths:
            start = facing_camera(
                own, markers_px, azimuth=azimuth, focal_px=focal_px, width_px=width, height_px=height
            )  # fmt: skip
            seen = resect(own, markers_px, start, sigma_px=sigma_px)
            error_px = np.linalg.norm(seen.project(own) - markers_px, axis=1)
            cost = float(np.minimum(error_px / sigma_px, 3.0).mean()) + abs(np.log(high)) / USUAL_STRETCH
            found.append((cost, high, azimuth, seen))
        return found

    best = min((one for high in HEIGHTS for one in tried(high, AZIMUTHS)), key=lambda each: each[0])
    step = (HEIGHTS[-1] / HEIGHTS[0]) ** (1.0 / (len(HEIGHTS) - 1))
    for _ in range(HALVINGS):
        step = step**0.5
        near = [one for high in (best[1] / step, best[1] * step) for one in tried(high, (best[2],))]
        best = min([best, *near], key=lambda each: each[0])
    return best[3], best[1]


def _higher(places_m: Array, times: float) -> Array:
    """Return points scaled vertically about their middle."""
    middle = places_m.mean(axis=0)
    return np.asarray(middle + (places_m - middle) * (1.0, times, 1.0))


def _turned(marked: Marked, camera: Camera, vertices_m: Array) -> int:
    before, now = (_facing(camera, points, marked.bent) for points in (marked.mesh.vertices_m, vertices_m))
    return int(((before > SQUARE) & (now < 0.0)).sum())


def _facing(camera: Camera, vertices_m: Array, triangles: Index) -> Array:
    """Return (T,) cosines of triangles' outsides to the camera."""
    a, b, c = (vertices_m[triangles[:, k]] for k in range(3))
    normal, towards = np.cross(b - a, c - a), camera.position_m - a
    length = np.linalg.norm(normal, axis=1) * np.linalg.norm(towards, axis=1)
    return np.asarray(np.einsum("ta,ta->t", normal, towards) / np.maximum(length, 1e-30))
