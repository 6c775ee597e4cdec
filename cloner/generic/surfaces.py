"""The generic human split by material, with seams split."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.caching import cached_per_object
from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.toes import closed_toe_normals
from cloner.geometry.meshes.wedges import split_seams, triangulate, vertex_normals
from cloner.records.arrays import freeze, is_frozen

#: Share of a tooth normal's part along the tooth that is taken away (taste).
_TOOTH_FRONT: Final = 0.8
#: Surface name -> parts of the generic human it is made of.
_PARTS: Final = {
    "body": ("body",),
    "eyes": ("eye_left", "eye_right"),
    "mouth": ("teeth_upper", "teeth_lower", "tongue"),
    "lashes": ("lashes_left", "lashes_right"),
}
_LASH_RGB: Final = (38, 28, 24)  # taste: dark brown, right for nearly everybody
_LASH_COUNT: Final = 60  # hairs along one lid; anatomy says 90-150 above, fewer but thicker read the same
_LASH_TEXTURE_PX: Final = (64, 512)


@dataclass(frozen=True, slots=True, eq=False)
class Surface:
    """Triangles of one material, with one vertex per position and texture coordinate.

    Attributes
    ----------
    name : str
        "body", "eyes", "mouth" or "lashes".
    vertex : (W,) int32
        The generic human's vertex of every wedge.
    uv : (W, 2) float64 in 0..1, v downwards
    triangles : (T, 3) int32 into the wedges
    rgba : (h, w, 4) uint8 or None
        A texture of its own; None when the clone's atlas is used.
    """

    name: str
    vertex: NDArray[np.int32]
    uv: NDArray[np.float64]
    triangles: NDArray[np.int32]
    rgba: NDArray[np.uint8] | None

    def __post_init__(self) -> None:
        freeze(
            self,
            vertex=(np.int32, (None,)),
            uv=(np.float64, (len(self.vertex), 2)),
            triangles=(np.int32, (None, 3)),
        )


@functools.cache
def load_surfaces() -> tuple[Surface, ...]:
    """Return the shipped generic human's surfaces, opaque ones first."""
    return surfaces(load_generic())


@functools.cache
def load_triangles() -> NDArray[np.int32]:
    """Return all (T, 3) triangles of the shipped generic human, read-only."""
    triangles, _ = triangulate(load_generic().quads.astype(np.int32))
    triangles.setflags(write=False)
    return triangles


@functools.cache
def body_triangles() -> NDArray[np.int32]:
    """Return the (T, 3) triangles of the generic human's skin, without eyes, teeth, tongue and lashes."""
    generic = load_generic()
    triangles = generic.triangles()[0]
    return np.ascontiguousarray(triangles[generic.skin[triangles].all(axis=1)], dtype=np.int32)


def surface_normals(vertices_m: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return (V, 3) unit normals, read-only, of the generic human's vertices moved to ``vertices_m``.

    Those of a record's vertices are found once for all pictures and formats.

    Teeth are lit as their fronts are: the smooth normal of a biting edge points along the tooth, and all that shows of
    the upper ones between two lips would be as grey as their undersides. Toes in shoes are lit as the shoe's tip is.
    """
    return _records_normals(vertices_m) if is_frozen(vertices_m) else _normals(vertices_m)


def _normals(vertices_m: NDArray[np.float64]) -> NDArray[np.float64]:
    normals, generic = closed_toe_normals(vertices_m, vertex_normals(vertices_m, load_triangles())), load_generic()
    for part in ("teeth_upper", "teeth_lower"):
        rows = generic.part(part)
        along = np.linalg.svd(vertices_m[rows] - vertices_m[rows].mean(axis=0), full_matrices=False)[2][2]
        own = normals[rows]
        own -= _TOOTH_FRONT * (own @ along)[:, None] * along
        normals[rows] = own / np.linalg.norm(own, axis=1, keepdims=True)
    normals.setflags(write=False)
    return normals


_records_normals = cached_per_object(_normals)


def surfaces(generic: GenericHuman) -> tuple[Surface, ...]:
    """Return the generic human's triangles grouped by material."""
    found = []
    for name, parts in _PARTS.items():
        wanted = [generic.part_names.index(part) for part in parts]
        rows = np.isin(generic.quad_part, wanted)
        triangles, corners = triangulate(generic.quads[rows].astype(np.int32))
        wedges = split_seams(triangles, generic.quad_uv[rows].reshape(-1)[corners].astype(np.int32))
        uv, rgba = generic.uv[wedges.uv].astype(np.float64), None
        if name == "lashes":
            uv, rgba = _lash_uv(generic, wedges.vertex), lash_texture()
        found.append(Surface(name, wedges.vertex, uv, wedges.triangles, rgba))
    return tuple(found)


def _lash_uv(generic: GenericHuman, vertex: NDArray[np.int32]) -> NDArray[np.float64]:
    """Return (W, 2) texture coordinates of lashes: u along the lid, v = 0 at the tip, 1 at the root.

    The atlas has no alpha and a lash only a few texels, so lashes get a strip of their own.
    """
    uv = np.zeros((len(vertex), 2))
    points = generic.vertices_m.astype(np.float64)
    skin = points[generic.part("body")]
    for side in ("left", "right"):
        rows = np.isin(vertex, generic.part(f"lashes_{side}"))
        centre = points[generic.part(f"eye_{side}")].mean(axis=0)
        spoke = points[vertex[rows]] - centre
        above = _upper(generic, vertex[rows])
        # measured from straight up (upper lid) or down (lower lid): no jump inside a strip
        turn = np.arctan2(spoke[:, 0], np.where(above, spoke[:, 1], -spoke[:, 1]))
        root, _ = cKDTree(skin).query(points[vertex[rows]])
        for strip in (above, ~above):
            root[strip] /= max(float(root[strip].max(initial=0.0)), 1e-6)
        uv[rows] = np.column_stack([0.5 + turn / (2.0 * np.pi), 1.0 - root])
    return uv


def _upper(generic: GenericHuman, vertex: NDArray[np.int32]) -> NDArray[np.bool_]:
    """Return which lash vertices belong to the upper lid's strip (strips are separate components)."""
    label = np.arange(len(generic.vertices_m))
    quads = generic.quads[np.isin(generic.quads[:, 0], vertex)]
    while True:
        lowest = label[quads].min(axis=1)
        before = label.copy()
        np.minimum.at(label, quads, lowest[:, None])
        if np.array_equal(before, label):
            break
    own = label[vertex]
    height = {int(strip): float(generic.vertices_m[vertex[own == strip], 1].mean()) for strip in np.unique(own)}
    middle = (max(height.values()) + min(height.values())) / 2.0
    return np.array([height[int(strip)] > middle for strip in own])


def lash_texture() -> NDArray[np.uint8]:
    """Return the (64, 512, 4) strip of lashes: rows tip to root, hairs that taper and differ in length.

    The whole width stands for a full turn around the eye; a lid covers about half.
    """
    height, width = _LASH_TEXTURE_PX
    rng = np.random.default_rng(7)  # any number; every clone has the same strip
    image = np.zeros((height, width, 4), dtype=np.uint8)
    image[..., :3] = _LASH_RGB
    along = np.linspace(1.0, 0.0, height)[:, None]  # 1 at the tip
    column = np.arange(width)[None, :]
    alpha = np.zeros((height, width))
    for hair in range(2 * _LASH_COUNT):
        middle = (hair + rng.uniform(0.2, 0.8)) * width / (2 * _LASH_COUNT)
        length, lean = rng.uniform(0.6, 1.0), rng.uniform(-4.0, 4.0)
        thick = 1.5 * np.clip(1.0 - along / length, 0.0, 1.0) ** 0.6
        gap = np.abs(column - middle - lean * along)
        gap = np.minimum(gap, width - gap)
        alpha = np.maximum(alpha, np.clip(thick - gap, 0.0, 1.0))
    image[..., 3] = np.round(255 * alpha)
    image.setflags(write=False)
    return image
