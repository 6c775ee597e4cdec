"""A beard as a soft shell over jaw and cheeks, hanging below the chin as far as the photos show.

On the face it is as thick as the photos' outlines stand off the fitted skin, as the hair's cap is; below it fills what
front and side photos agree on, under the skin where it grows. Weights and morph targets of that skin carry it. Stubble,
which no outline shows, stays paint.

References
----------
Method notes section 12 (hair); visual hull after Laurentini 1994.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt, gaussian_filter, label
from scipy.spatial import cKDTree

from cloner.frames import ViewId, mm_from_m
from cloner.generic.load import GenericHuman
from cloner.generic.surfaces import body_triangles
from cloner.geometry.meshes.graphs import surface_graph
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.shells.edge import FADE_MM
from cloner.hair.shells.mesh import extract_mesh, lowest_hair_m
from cloner.hair.shells.shell import dress_shell, visible_part
from cloner.hair.volumes.cap import Scalp, measure_scalp, surface_mm
from cloner.hair.volumes.grid import CLIP_MM, VOXEL_M, voxels
from cloner.hair.volumes.hanging import DRAPE_MM, INNER_MM
from cloner.hair.volumes.pictures import FAR_MM, distances_px
from cloner.hair.volumes.settled import settle_shell
from cloner.hair.volumes.views import HairSkinning, HairView
from cloner.hair.volumes.volume import FILM_MM, SMOOTH_VOXELS, cap_mm, near_skin
from cloner.records.arrays import Array
from cloner.records.clones import Joined
from cloner.records.heads import Shell
from cloner.records.labels import FACE, Label, shows
from cloner.records.photos import PhotoSet
from cloner.records.proposals import Proposals

Floats = NDArray[np.float32]

#: A face photo with less of its face bearded shows a shadow (`cloner.labels.states.BEARD_SHARE` in the whole face).
LEAST_SHARE: Final = 0.03
#: Of the share of a face that a beard takes in one face photo it takes so much at least in the other: nine generated
#: people .23 and more from the side, two moustaches as they are labelled .19; a shadow under a chin had .09.
ALIKE_SHARE: Final = 0.14
#: Bearded pieces smaller than this share of the largest are specks.
SMALLEST_PIECE: Final = 0.08
#: A beard of which three quarters are thinner is stubble: the shell itself is some 2 mm thick everywhere.
#: Generated people: three with stubble 1.6 to 2.0, full beards 4.0 to 8.4, long ones 50 and more.
THINNEST_MM: Final = 3.0
#: The same where no photo shows it from aside: stubble on the throat looks like a beard that hangs before it.
UNSEEN_MM: Final = 20.0
#: How far behind the ear's lobe it grows, metres.
BEHIND_LOBE_M: Final = 0.01
#: Hanging hair's cones meet in a rounding of half a beard's width; hair thinner than the labels' doubt is none.
ROUND_MM, DOUBT_MM = 30.0, 2.0
#: A beard hangs below where it grows, wider by this much and by so much of its drop.
WIDER_MM, SPREAD = 5.0, 0.5
#: Hair on a face is nowhere thicker, mm.
NEAR_MM: Final = 40.0
#: So far down no neck is reached: a beard hangs from the skull alone.
ALL_SKULL_M: Final = 10.0
#: How far the grid reaches around the skin where a beard can grow, and below the lowest label, metres.
MARGIN_M: Final = 0.045
#: The first of these photos bounds a beard: the face was fitted to the face photos.
SEEN_FROM: Final = (ViewId.FACE_FRONT, ViewId.BODY_FRONT, ViewId.FACE_SIDE, ViewId.BODY_SIDE)
#: Most triangles, and the texture's side, texels.
TRIANGLES: Final = 3000
SIZE: Final = 512


def beard_shell(
    generic: GenericHuman, joined: Joined, photos: PhotoSet, proposals: Proposals, views: list[HairView]
) -> Shell | None:
    """Return the beard, None where the photos show none that stands off the skin.

    Parameters
    ----------
    generic, joined : the person
    photos, proposals
    views : list of HairView
        What every photo says of hair.
    """
    if is_contradicted(proposals):
        return None
    asked = (beard_evidence(view, proposals.views[view.posed.view].labels) for view in views if _shows_face(view))
    views = nearest_views([view for view in asked if view is not None])
    if not any(view.posed.view.is_face for view in views):
        return None
    rows, zone = beard_rows(generic, joined)
    place = np.full(len(joined.vertices_m), -1, np.int32)
    place[rows] = np.arange(len(rows), dtype=np.int32)
    own = place[body_triangles()]
    own = np.ascontiguousarray(own[(own >= 0).all(axis=1)])
    normals = vertex_normals(joined.vertices_m, body_triangles())
    points, ears = joined.vertices_m[rows], generic.region("ear_left")[rows] | generic.region("ear_right")[rows]
    grown = measure_scalp(views, points, normals[rows], own, surface_graph(points, own), zone, ears, None)
    grown = replace(grown, points_m=points)  # the chin was fitted, unlike the skull: it gives way to no beard
    roots = np.flatnonzero(zone & (grown.hairy > 0.5))
    if not roots.size:
        return None
    body = joined.vertices_m[generic.skin], normals[generic.skin]
    field, skin_mm, low = beard_field(views, grown, body, points[zone])
    mesh = extract_mesh(field, skin_mm, low, TRIANGLES, SMALLEST_PIECE)
    if mesh is None:
        return None
    # By the planes of a neck's end the chest's air would be skin: long beards were pushed out of it as spikes.
    shape = settle_shell(views, body, *mesh, FILM_MM)
    used, triangles, inside_mm = visible_part(views, shape, mesh[1], grown)
    aside = any(view.posed.view.is_side for view in views)
    if thickness_mm(grown, shape[used], inside_mm) < (THINNEST_MM if aside else UNSEEN_MM):
        return None
    rides = rows[roots[cKDTree(points[roots]).query(shape[used])[1]]].astype(np.int32)
    skinned = np.asarray(generic.skin_joints[rides], np.int32), np.asarray(generic.skin_weights[rides], np.float64)
    surface = shape[used], triangles, inside_mm
    return dress_shell(generic, joined, photos, views, surface, skinned, SIZE, strands=None, kind="beard", rides=rides)


def is_contradicted(proposals: Proposals) -> bool:
    """Return whether one photo of the face shows a beard and the other, with the face visible, hardly any."""
    shares = []
    for view in (ViewId.FACE_FRONT, ViewId.FACE_SIDE):
        if view in proposals.views:
            labels = proposals.views[view].labels
            face = np.count_nonzero(shows(labels, *FACE))
            shares.append(np.count_nonzero(labels == Label.BEARD) / face if face else 0.0)
    return len(shares) > 1 and min(shares) < ALIKE_SHARE * max(shares)


def _shows_face(view: HairView) -> bool:
    return view.posed.view is not ViewId.BODY_BACK


def beard_evidence(view: HairView, labels: NDArray[np.uint8]) -> HairView | None:
    """Return a photo's evidence of the beard as a hair view: its outline is the face's, and the skull moves it. None
    where it shows none.

    Below a beard that hangs before neck and clothes the face ends; there its outline tells how thick it is.
    """
    beard = _without_specks(labels == Label.BEARD)
    if not beard.any() or (view.posed.view.is_face and beard.sum() < LEAST_SHARE * shows(labels, *FACE).sum()):
        return None
    hair, to_beard, to_line, _ = distances_px(beard, labels != Label.BACKGROUND)
    to_face = distances_px(beard, shows(labels, *FACE, Label.HAIR) | beard)[3]
    skull = HairSkinning(view.hanger.joints, view.hanger.heights_m - ALL_SKULL_M)
    return replace(view, hair=hair, hair_px=to_beard, line_px=to_line, outline_px=to_face, hanger=skull)


def nearest_views(views: list[HairView]) -> list[HairView]:
    """Return the views without those of body photos from a side from which a photo of the face shows the beard.

    In body photos beards are small: their labels run into the hair beside them, and the room shows between hairs.
    """
    near = {view.posed.view.is_front for view in views if view.posed.view.is_face}
    return [view for view in views if view.posed.view.is_face or view.posed.view.is_front not in near]


def _without_specks(beard: NDArray[np.bool_]) -> NDArray[np.bool_]:
    if not beard.any():
        return beard
    _, pieces, stats, _ = cv2.connectedComponentsWithStats(beard.astype(np.uint8), connectivity=8)
    area = stats[:, cv2.CC_STAT_AREA].astype(float)
    area[0] = 0.0
    return np.asarray(np.isin(pieces, np.flatnonzero(area >= SMALLEST_PIECE * area.max())))


def beard_rows(generic: GenericHuman, joined: Joined) -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
    """Return the vertices of head and neck (N,), and on which of them a beard can grow.

    Beards grow below the line from the ears' tops to the nostrils, before the ears, not on lips. Heads stand upright at
    rest.
    """
    points = joined.vertices_m
    head = np.zeros(len(points), bool)
    head[generic.head_vertices] = True
    skin = generic.skin
    rows = np.flatnonzero(skin & head & ~generic.region("mouth_interior"))
    top, lobe, ala = (points[generic.feature(name)] for name in ("ear_top_L", "ear_lobe_L", "ala_L"))
    share = np.clip((points[rows, 2] - top[2]) / max(ala[2] - top[2], 1e-6), 0.0, 1.0)
    below = points[rows, 1] < top[1] + share * (ala[1] - top[1])
    before = points[rows, 2] > lobe[2] - BEHIND_LOBE_M
    ears = generic.region("ear_left") | generic.region("ear_right")
    return rows, below & before & ~(ears | generic.region("lips"))[rows]


def beard_field(
    views: list[HairView], grown: Scalp, body: tuple[Array, Array], zone_m: Array
) -> tuple[Floats, Floats, Array]:
    """Return the beard's field and the distance to the skin, (X, Y, Z) mm, and the grid's origin, metres.

    Parameters
    ----------
    views : list of HairView
    grown : Scalp
        Of the beard.
    body : (M, 3) vertices of the whole skin, metres, and their normals
    zone_m : (Z, 3) skin on which beards can grow, metres
    """
    low, high = zone_m.min(axis=0) - MARGIN_M, zone_m.max(axis=0) + MARGIN_M
    low[1] = min(low[1], lowest_hair_m(views) - MARGIN_M)
    grid, shape = voxels(low, high)
    shown = next(view for name in SEEN_FROM for view in views if view.posed.view is name and view.flip_m is None)
    rows = np.flatnonzero(shown.evidence(grid)[0] > -CLIP_MM)  # four fifths of the box are beside the beard
    points = grid[rows]
    skin_mm = surface_mm(*body, points)[0]
    cap, hanging = (np.full(len(rows), np.float32(-CLIP_MM)) for _ in range(2))
    close, outside = np.abs(skin_mm) < NEAR_MM, skin_mm > -INNER_MM
    cap[close] = cap_mm(views, near_skin(grown, points[close]))
    inside, sides = agreed_depth_mm(views, points[outside], float(zone_m[:, 0].mean()))
    thin = np.where(sides > 1, np.float32(FAR_MM), DRAPE_MM - skin_mm[outside])
    hanging[outside] = np.minimum(np.minimum(inside - DOUBT_MM, thin), skin_mm[outside] + INNER_MM)

    def spread(values: Floats, elsewhere: float) -> Floats:
        whole = np.full(len(grid), np.float32(elsewhere))
        whole[rows] = values
        return whole.reshape(shape)

    distance_mm, cap, hanging = spread(skin_mm, FAR_MM), spread(cap, -CLIP_MM), spread(hanging, -CLIP_MM)
    cap = np.clip(cap, -CLIP_MM, CLIP_MM)
    hanging = np.clip(np.minimum(hanging, depth_below_mm(cap)), -CLIP_MM, CLIP_MM)
    pieces = label((cap > 0.0) | (hanging > 0.0))[0]
    held = np.isin(pieces, np.unique(pieces[cap > 0.0])) & (pieces > 0)
    field = np.where(held, np.maximum(cap, hanging), cap)
    return gaussian_filter(field.astype(np.float32), SMOOTH_VOXELS), distance_mm, low


def agreed_depth_mm(views: list[HairView], points_m: Array, middle_m: float) -> tuple[Floats, NDArray[np.int64]]:
    """Return the depth (N,) of points in the beard on which front and side photo agree, mm, and how many of them see
    them.

    The face was fitted to the face photos, which come first. Shoulders hide half of a beard from aside: what the photo
    shows of its middle, at x = ``middle_m``, holds for all of it. The cones meet in a round edge.
    """
    away, sides = np.zeros(len(points_m), np.float32), np.zeros(len(points_m), np.int64)
    for names in ((ViewId.FACE_FRONT, ViewId.BODY_FRONT), (ViewId.FACE_SIDE, ViewId.BODY_SIDE)):
        seen = {view.posed.view: view for view in views if view.flip_m is None}
        view = next((seen[name] for name in names if name in seen), None)
        if view is not None:
            aside = ViewId.FACE_SIDE in names
            places = np.column_stack([np.full(len(points_m), middle_m), points_m[:, 1:]]) if aside else points_m
            inside, judged = view.evidence(places)
            away += np.where(judged, np.maximum(ROUND_MM - inside, 0.0) ** 2, 0.0).astype(np.float32)
            sides += judged
    return np.where(sides > 0, np.float32(ROUND_MM) - np.sqrt(away), np.float32(-FAR_MM)), sides


def depth_below_mm(cap: Floats) -> Floats:
    """Return the depth of a grid's points (X, Y, Z) below a beard that grows above, mm, negative beside it."""
    foot, height = (cap > 0.0).any(axis=1), np.arange(cap.shape[1])[None, :, None]
    lowest = np.where(foot, (cap > 0.0).argmax(axis=1), 0)
    highest = np.where(foot, cap.shape[1] - 1 - (cap > 0.0)[:, ::-1].argmax(axis=1), 0)  # a chin's over its throat's
    _, nearest = distance_transform_edt(~foot, return_indices=True)
    root, crest = (ends[tuple(nearest)] if foot.any() else np.full(foot.shape, -1) for ends in (lowest, highest))
    away_mm = mm_from_m(VOXEL_M) * (distance_transform_edt(foot) - distance_transform_edt(~foot))[:, None, :]
    drop_mm = mm_from_m(VOXEL_M) * np.maximum(root[:, None, :] - height, 0)
    return np.asarray(np.where(height < crest[:, None, :], away_mm + WIDER_MM + SPREAD * drop_mm, -CLIP_MM), np.float32)


def thickness_mm(grown: Scalp, shape_m: Array, inside_mm: Array) -> float:
    """Return the 75th percentile of a beard's thickness over the skin, mm, 0 without any.

    Parameters
    ----------
    inside_mm : (N,) how far inside the beard's edge the surface lies
    """
    full = inside_mm > FADE_MM[1]
    if not full.any():
        return 0.0
    return float(np.percentile(surface_mm(grown.points_m, grown.normals, shape_m[full])[0], 75))
