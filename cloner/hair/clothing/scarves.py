"""A scarf as a ring around the neck, outside the skin, where photos of all sides agree.

Painted on neck and shoulders it slid down the back and lost its folds.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter
from scipy.spatial import cKDTree

from cloner.frames import m_from_mm, mm_from_m
from cloner.generic.load import GenericHuman
from cloner.generic.surfaces import body_triangles
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.shells.mesh import extract_mesh
from cloner.hair.shells.shell import dress_shell, visible_part
from cloner.hair.volumes.cap import surface_mm
from cloner.hair.volumes.grid import CLIP_MM, voxels
from cloner.hair.volumes.hanging import INNER_MM
from cloner.hair.volumes.pictures import FAR_MM, distances_px
from cloner.hair.volumes.rows import agreed_mm
from cloner.hair.volumes.settled import settle_shell
from cloner.hair.volumes.views import SIDES, HairView
from cloner.hair.volumes.volume import FILM_MM, SMOOTH_VOXELS
from cloner.records.arrays import Array
from cloner.records.clones import Joined
from cloner.records.heads import Shell
from cloner.records.labels import Label, shows
from cloner.records.photos import PhotoSet
from cloner.records.proposals import Proposals

Bools = NDArray[np.bool_]

#: Where scarves lie against the chin, upwards and downwards, m; glasses lie higher, belts lower.
ABOVE_M, BELOW_M = 0.02, 0.22
#: Smaller pieces are specks, and a photo with less shows no scarf, mm2.
SPECK_MM2, LEAST_MM2 = 150.0, 1500.0
#: It stands out from the skin so far somewhere: anything flatter is a collar or a chain, mm.
STANDS_OUT_MM: Final = 12.0
#: How far the grid reaches around the neck, m; no scarf stands out farther.
AROUND_M: Final = 0.2
#: Labels err so much, mm.
DOUBT_MM: Final = 1.0
#: Never covered by a scarf.
BARE: Final = (Label.FACE_SKIN, Label.EYES, Label.MOUTH, Label.BEARD, Label.HAIR, Label.BACKGROUND)
#: Most triangles, the texture's side in texels, and pieces smaller than this share of the largest are dropped.
TRIANGLES, SIZE, SMALLEST_PIECE = 4000, 512, 0.2


def scarf_shell(
    generic: GenericHuman, joined: Joined, photos: PhotoSet, proposals: Proposals, views: list[HairView]
) -> Shell | None:
    """Return the scarf, None unless front and side photos show one.

    Parameters
    ----------
    generic, joined : the person
    photos, proposals
    views : list of HairView
        Poses and cameras of all photos.
    """
    chin = joined.vertices_m[generic.feature("chin_bottom")]
    worn = [
        view for view in (scarf_evidence(one, proposals.views[one.posed.view].labels, chin) for one in views) if view
    ]
    if not _seen_all_round(worn):
        return None
    skin, normals = generic.skin, vertex_normals(joined.vertices_m, body_triangles())
    near = skin & (np.abs(joined.vertices_m - chin) < 2.0 * AROUND_M).all(axis=1)
    body = joined.vertices_m[near], normals[near]
    field, skin_mm, low = scarf_field(worn, body, chin)
    mesh = extract_mesh(field, skin_mm, low, TRIANGLES, SMALLEST_PIECE)
    if mesh is None:
        return None
    shape = settle_shell(worn, body, *mesh, FILM_MM)
    used, triangles, inside_mm = visible_part(worn, shape, mesh[1])
    if not len(triangles) or surface_mm(*body, shape[used])[0].max() < STANDS_OUT_MM:
        return None
    carried = np.flatnonzero(near)[cKDTree(body[0]).query(shape[used])[1]]
    skinned = np.asarray(generic.skin_joints[carried], np.int32), np.asarray(generic.skin_weights[carried], np.float64)
    surface = shape[used], triangles, inside_mm
    return dress_shell(generic, joined, photos, worn, surface, skinned, SIZE, strands=None, kind="scarf")


def scarf_evidence(view: HairView, labels: NDArray[np.uint8], chin_m: Array) -> HairView | None:
    """Return a photo's evidence of a scarf as a hair view, None where it shows none.

    Folds and what hangs over it are labelled as other things: between its pieces all is scarf but face and hair.
    """
    posed = view.to_view(chin_m[None])
    pixel_mm = view.pixel_mm(posed)
    row = view.posed.camera.project(posed)[0, 1]
    count, pieces, stats, middles = cv2.connectedComponentsWithStats((labels == Label.ACCESSORY).astype(np.uint8))
    place = mm_from_m(1.0) * np.array([-ABOVE_M, BELOW_M]) / pixel_mm + row
    large = stats[:, cv2.CC_STAT_AREA] * pixel_mm**2 > SPECK_MM2
    kept = [k for k in range(1, count) if large[k] and place[0] < middles[k, 1] < place[1]]
    scarf = np.isin(pieces, kept)
    if np.count_nonzero(scarf) * pixel_mm**2 < LEAST_MM2:
        return None
    outline = cv2.convexHull(np.argwhere(scarf)[:, ::-1].astype(np.int32))
    filled = cv2.fillConvexPoly(np.zeros(labels.shape, np.uint8), outline, 1) > 0
    scarf |= filled & ~shows(labels, *BARE)
    hair, to_scarf, to_line, to_person = distances_px(scarf, labels != Label.BACKGROUND)
    clothed = np.zeros_like(view.clothed)
    return replace(view, hair=hair, hair_px=to_scarf, line_px=to_line, outline_px=to_person, clothed=clothed)


def _seen_all_round(worn: list[HairView]) -> bool:
    """Return whether photos from the front and from the side show it."""
    seen = {view.posed.view for view in worn}
    return all(seen & set(names) for names in SIDES[:2])


def scarf_field(
    worn: list[HairView], body: tuple[Array, Array], chin_m: Array
) -> tuple[NDArray[np.float32], NDArray[np.float32], Array]:
    """Return the scarf's field and the distance to the skin, (X, Y, Z) mm, and the grid's origin, m."""
    low = chin_m - (AROUND_M, BELOW_M, 1.5 * AROUND_M)
    high = chin_m + (AROUND_M, ABOVE_M + m_from_mm(CLIP_MM), AROUND_M)
    grid, shape = voxels(low, high)
    deep_m = float(body[0][:, 2].min()), float(body[0][:, 2].max())
    front = next(view for view in worn if view.posed.view.is_front)
    near = np.flatnonzero(front.evidence(grid)[0] > -CLIP_MM)
    inside, sides = agreed_mm(worn, grid[near], deep_m)
    observed = (inside > -CLIP_MM) & (sides > 1)  # one point of the grid in twelve
    near, inside = near[observed], inside[observed]
    field, skin_mm = np.full(len(grid), np.float32(-CLIP_MM)), np.full(len(grid), np.float32(FAR_MM))
    skin_mm[near] = surface_mm(*body, grid[near])[0]
    field[near] = np.clip(np.minimum(inside - DOUBT_MM, skin_mm[near] + INNER_MM), -CLIP_MM, CLIP_MM)
    return gaussian_filter(field.reshape(shape), SMOOTH_VOXELS), skin_mm.reshape(shape), low
