"""A hair's surface made a shell: cut at the hairline, charted, painted, with a soft edge."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation
from scipy.sparse.csgraph import connected_components

from cloner.frames import ViewId
from cloner.generic.load import GenericHuman
from cloner.geometry.charts.atlas import map_atlas
from cloner.geometry.charts.unwrapping import unwrap
from cloner.geometry.meshes.graphs import surface_graph
from cloner.geometry.meshes.triangles import areas
from cloner.hair.shells.edge import FADE_MM, STRAND_MM, inside_hairline_mm, soften_edge, unseen_inside_mm
from cloner.hair.shells.shell_paint import ShellView, paint_shell
from cloner.hair.volumes.cap import VOTE_MM, Scalp
from cloner.hair.volumes.views import HairView
from cloner.records.arrays import Array
from cloner.records.clones import Joined
from cloner.records.heads import NO_RIDES, Shell
from cloner.records.photos import PhotoSet

Skinned = tuple[NDArray[np.int32], Array]

CLAIM: Final = {  # taste: face photos have three times the pixels
    ViewId.FACE_FRONT: 1.0,
    ViewId.FACE_SIDE: 1.0,
    ViewId.BODY_BACK: 0.85,
    ViewId.BODY_FRONT: 0.6,
    ViewId.BODY_SIDE: 0.6,
}

SMALLEST_PIECE: Final = 0.02  # of the largest piece's area (24 people: scraps had .4 % at most)
EDGE_TEXELS: Final = 2  # colours go on so far beyond a part's charts, for what is sampled between texels


def visible_part(
    views: list[HairView], vertices_m: Array, triangles: NDArray[np.int32], scalp: Scalp | None = None
) -> tuple[NDArray[np.int32], NDArray[np.int32], Array]:
    """Return which vertices (M,) photos show as hair, triangles of those, and their distance inside its edge, mm.

    What no photo sees is where the ``scalp`` grows hair; all of it without one.
    """
    claims = [CLAIM[v.posed.view] for v in views]
    unseen_mm = VOTE_MM if scalp is None else unseen_inside_mm(scalp, vertices_m)
    inside_mm = inside_hairline_mm(views, claims, vertices_m, triangles, unseen_mm)
    shown = triangles[(inside_mm[triangles] > FADE_MM[0] - STRAND_MM).any(axis=1)]
    used, places = np.unique(without_scraps(vertices_m, shown), return_inverse=True)
    return used.astype(np.int32), places.reshape(-1, 3).astype(np.int32), inside_mm[used]


def without_scraps(vertices_m: Array, triangles: NDArray[np.int32]) -> NDArray[np.int32]:
    """Return the triangles (T, 3) without components that are too small beside the largest."""
    if not len(triangles):
        return triangles
    _, pieces = connected_components(surface_graph(vertices_m, triangles).lengths, directed=False)
    piece = pieces[triangles[:, 0]]
    area = np.bincount(piece, areas(vertices_m, triangles))
    return np.asarray(triangles[(area >= SMALLEST_PIECE * area.max())[piece]], np.int32)


def shell_views(views: list[HairView]) -> list[ShellView]:
    """Return the hair views as views of a shell."""
    return [ShellView(v.posed, v.hair, v.hair_px, CLAIM[v.posed.view], v.flip_m) for v in views]


def dress_shell(
    generic: GenericHuman,
    joined: Joined,
    photos: PhotoSet,
    views: list[HairView],
    surface: tuple[Array, NDArray[np.int32], Array],
    skinned: Skinned,
    size: int,
    *,
    strands: float | None,
    carried: Skinned | None = None,
    kind: str = "hair",
    rides: NDArray[np.int32] | None = None,
    worn: tuple[NDArray[np.bool_], list[HairView]] | None = None,
) -> Shell:
    """Return the shell with weights, charts and texture.

    Parameters
    ----------
    views : list of HairView
    surface : vertices (N, 3), triangles (T, 3), and how far inside the hairline the vertices lie (N,), mm
    skinned : joints and weights (N, 4) with which the photos saw it
    size : int
        Side of the texture, texels.
    strands : float or None
        See :func:`paint_shell`.
    carried : joints and weights (N, 4), or None
        With which it moves; as the photos saw it when None.
    kind : str
        One of ``SHELL_KINDS``.
    rides : (N,) int32 or None
        Vertices of the skin that carry the shell's in morph targets.
    worn : (T,) bool and a list of HairView, or None
        Triangles with evidence of their own: a cap's peak shows no hair.
    """
    vertices_m, triangles, inside_mm = surface
    joints, weights = skinned
    charts = unwrap(vertices_m, triangles, size)
    atlas = map_atlas(charts.uv, charts.triangles, triangles, size)
    sights = shell_views(views)
    rgba = paint_shell(generic, joined, photos.photos, sights, atlas, vertices_m, joints, weights, strands=strands)
    if worn is not None:
        used, places = np.unique(triangles[worn[0]], return_inverse=True)
        apart = map_atlas(charts.uv, charts.triangles[worn[0]], places.reshape(-1, 3).astype(np.int32), size)
        own_views, own_m = shell_views(worn[1]), vertices_m[used]
        painted = paint_shell(generic, joined, photos.photos, own_views, apart, own_m, joints[used], weights[used])
        place = binary_dilation(apart.covered(), iterations=EDGE_TEXELS)
        rgba = np.where(place[..., None], painted, rgba)
    rgba = soften_edge(rgba, atlas, inside_mm)
    chart = charts.vertex
    joints, weights = skinned if carried is None else carried
    own = NO_RIDES if rides is None else rides[chart]
    return Shell(vertices_m[chart], charts.triangles, charts.uv, joints[chart], weights[chart], rgba, kind, own)
