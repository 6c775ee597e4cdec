"""The hair field: a cap of measured thickness, free tails and hanging hair."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter
from scipy.spatial import cKDTree

from cloner.frames import m_from_mm, mm_from_m
from cloner.geometry.meshes.triangles import longest_sides
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.volumes.cap import FULL_SHARE, SOFT_MM, VOTE_MM, Scalp, hairline_mm, label_votes, surface_mm
from cloner.hair.volumes.gaps import close_gaps
from cloner.hair.volumes.grid import CLIP_MM, attached_to, candidate_points, near_hair
from cloner.hair.volumes.hanging import INNER_MM, LYING_MM, default_depth_m, default_width_m, hanging_mm, has_side_view
from cloner.hair.volumes.pictures import FAR_MM
from cloner.hair.volumes.tail import Tail, find_tail
from cloner.hair.volumes.views import HairView, visual_hull_mm
from cloner.records.arrays import Array

SMOOTH_VOXELS = 0.8  # taste: sigma that takes the cells' steps away
FILM_MM = 2.0  # clear of the skin's mesh
BEYOND_MM = 8.0  # how far the film reaches: past what labels and mesh may err
OVERHANG_DOUBT_MM = 2.0  # heads stand a little off their photos
TAIL_DOUBT_MM = 6.0  # heads nod between photos, and tails swing
LIFT_MM = 2.5  # labels are read this far above the skin: clear of the mesh, below the hair's surface
GROWTH_MM = 40.0  # the growth share falls from 1 to 0 over about two rings of this mesh
UNSEEN_VOTE = 0.05  # what neighbours say counts where photos see badly
FAR_SLACK_MM = 10.0  # planes of skin far below tell distances this badly
BESIDE_TAIL_MM = 50.0  # what lies between a tail and the back below it is air


@dataclass(frozen=True, slots=True, eq=False)
class NearSkin:
    """Grid points relative to the nearest skin.

    Attributes
    ----------
    points_m : (N, 3)
    skin_mm, cap_mm : (N,) float32, signed distance to the skin and to the cap's outside, positive outside
    outward : (N, 3) float32, the skin's normal nearby
    hairy, growth : (N,) float32, of the skin nearby
    votes : (K, N) float32, of the skin nearby
    """

    points_m: Array
    skin_mm: NDArray[np.float32]
    cap_mm: NDArray[np.float32]
    outward: NDArray[np.float32]
    hairy: NDArray[np.float32]
    growth: NDArray[np.float32]
    votes: NDArray[np.float32]


def near_skin(scalp: Scalp, points_m: Array) -> NearSkin:
    """Return points with the values of the four nearest skin vertices, weighted by closeness."""
    skin, rows, weight = surface_mm(scalp.points_m, scalp.normals, points_m)
    # Planes of a skin far below lie askew: hair's outside is told by its own.
    thickness = np.maximum(scalp.thickness_mm, FILM_MM)
    lifted = scalp.points_m + scalp.normals * m_from_mm(1.0) * thickness[:, None]
    # Deep in the head and far above all hair nobody asks for the cap: half of the points.
    thickest = float(thickness.max())
    asked = (skin > -INNER_MM - CLIP_MM) & (skin < thickest + CLIP_MM + FAR_SLACK_MM)
    cap = skin - np.float32(thickest)
    cap[asked] = surface_mm(lifted, vertex_normals(lifted, scalp.triangles), points_m[asked])[0]
    # Where ears fold it some planes stand upright and would call air hair: spikes. No hair is farther from a vertex
    # than it is thick and its triangles are long.
    away_m = np.linalg.norm(points_m - scalp.points_m[rows[:, 0]], axis=1)
    least = mm_from_m(1.0) * (away_m - longest_sides(scalp.points_m, scalp.triangles)[rows[:, 0]])
    least -= thickness[rows].max(axis=1)
    return NearSkin(
        points_m,
        skin,
        np.maximum(cap, least).astype(np.float32),
        np.einsum("nk,nkc->nc", weight, scalp.normals[rows]).astype(np.float32),
        (weight * scalp.hairy[rows]).sum(axis=1).astype(np.float32),
        (weight * scalp.growth[rows]).sum(axis=1).astype(np.float32),
        np.stack([(weight * vote[rows]).sum(axis=1) for vote in scalp.votes]).astype(np.float32),
    )


def cap_mm(views: list[HairView], near: NearSkin) -> NDArray[np.float32]:
    """Return the field (N,) of the hair that follows the head, mm.

    Thickness bounds it outwards. It runs on as a film beyond the hairline, where the texture fades it out:
    labels are as fine as photos, voxels are not.
    """
    field = np.minimum(-near.cap_mm, near.skin_mm + INNER_MM)
    rows = np.flatnonzero(field > -CLIP_MM)
    line = voted_hairline_mm(views, near, rows) + BEYOND_MM
    field[rows] = np.minimum(field[rows], np.minimum(line, (near.growth[rows] - 0.5) * GROWTH_MM))
    return np.asarray(field, np.float32)


def lying_hair_mm(views: list[HairView], lain: NearSkin) -> NDArray[np.float32]:
    """Return the field (N,) of hair that lies on neck, shoulders and back, mm: no wider than in body photos.

    Photos vote on the skin, but none sees the top of a shoulder well: a side photo of the face, in which shoulders
    hang in no known pose, may show the hair behind it in its place.
    """
    field = cap_mm(views, lain)
    across = [view for view in views if view.posed.view.is_body and not view.posed.view.is_side]
    rows = np.flatnonzero(field > -CLIP_MM)
    if not rows.size:
        return field
    above_m = m_from_mm(1.0) * (LIFT_MM - lain.skin_mm[rows])
    wide = visual_hull_mm(across, lain.points_m[rows] + above_m[:, None] * lain.outward[rows])
    field[rows] = np.where(wide > -FAR_MM, np.minimum(field[rows], wide + VOTE_MM), field[rows])
    return field


def near_lying_hair(body: tuple[Array, Array], votes: Array, points_m: Array) -> NearSkin:
    """Return points relative to hair of even thickness on the body; photos that see it vote on where it is."""
    skin, rows, weight = surface_mm(*body, points_m)
    return NearSkin(
        points_m,
        skin,
        skin - np.float32(LYING_MM),
        np.einsum("nk,nkc->nc", weight, body[1][rows]).astype(np.float32),
        np.zeros(len(skin), np.float32),
        np.ones(len(skin), np.float32),
        np.stack([(weight * vote[rows]).sum(axis=1) for vote in votes]).astype(np.float32),
    )


def overhang_mm(views: list[HairView], scalp: Scalp, points_m: Array) -> NDArray[np.float32]:
    """Return the field (N,) of hair that overhangs the hairline, mm: as thick as inside it, where photos agree.

    There is none where no photo shows the head from aside: nothing would end it in front.
    """
    full = scalp.hairy > FULL_SHARE
    if not full.any() or not has_side_view(views):
        return np.full(len(points_m), -CLIP_MM, np.float32)
    thickness = scalp.thickness_mm[full]
    reach = m_from_mm(float(thickness.max()) + CLIP_MM)
    gap, row = cKDTree(scalp.points_m[full]).query(points_m, distance_upper_bound=reach)
    rows = np.flatnonzero(np.isfinite(gap))
    field = np.full(len(points_m), -CLIP_MM, np.float32)
    round_mm = thickness[row[rows]] - mm_from_m(1.0) * gap[rows]
    near = rows[round_mm > -CLIP_MM]
    field[near] = np.minimum(round_mm[round_mm > -CLIP_MM], visual_hull_mm(views, points_m[near]) + OVERHANG_DOUBT_MM)
    return field


def voted_hairline_mm(views: list[HairView], near: NearSkin, rows: NDArray[np.int64]) -> NDArray[np.float32]:
    """Return the distance (R,) along the skin to the voted hairline, mm, positive on the hair's side.

    Labels are read a little above the skin, also for points below it.
    """
    lift = m_from_mm(1.0) * (np.minimum(near.skin_mm[rows], LIFT_MM) - near.skin_mm[rows])
    read = near.points_m[rows] + near.outward[rows] * lift[:, None]
    votes = near.votes[:, rows]
    line = np.zeros(rows.size, np.float32)
    for view, vote in zip(views, votes, strict=True):
        line += vote * hairline_mm(view, read)
    unseen = (near.hairy[rows] - 0.5) * SOFT_MM
    return np.asarray((line + UNSEEN_VOTE * unseen) / (votes.sum(axis=0) + UNSEEN_VOTE), np.float32)


def tail_mm(views: list[HairView], tail: Tail, points_m: Array) -> NDArray[np.float32]:
    """Return the field (N,) of a tail, mm, without what front photos do not show as hair.

    In a side photo a crown that stands over its cap looks like a strand in the head's middle: a knob.
    """
    field = tail.inside_mm(points_m)
    rows = np.flatnonzero(field > -CLIP_MM)
    front = [view for view in views if view.posed.view.is_front]
    if front and rows.size:
        seen = visual_hull_mm(front, points_m[rows])
        judged = seen > -FAR_MM  # behind head and shoulders no front photo sees a tail
        field[rows] = np.where(judged, np.minimum(field[rows], seen + TAIL_DOUBT_MM), field[rows])
    return field


def hair_field(
    views: list[HairView],
    scalp: Scalp,
    body: tuple[Array, Array],
    low_m: Array,
    high_m: Array,
    middle_m: float,
    hang_below_m: float,
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return the hair's field and the distance to the skin on a grid.

    Parameters
    ----------
    views : list of HairView
    scalp : Scalp
    body : (M, 3) vertices of the whole body's skin, the scalp's tucked in, metres, and their normals
    low_m, high_m : (3,) corners of the grid, rest frame
    middle_m : float
        x of the head's middle.
    hang_below_m : float
        Height below which hair may lie on bare skin or hang free.

    Returns
    -------
    field_mm : (X, Y, Z) float32, positive inside the hair, clipped to +-CLIP_MM
    skin_mm : (X, Y, Z) float32, positive outside the body, FAR_MM where no hair is near
    """
    surface = scalp.points_m + scalp.normals * m_from_mm(1.0) * scalp.thickness_mm[:, None]
    tail = find_tail(views, surface, scalp.triangles, middle_m)
    votes, line = label_votes(views, *body, tail, scalp.lobes_m)
    lying = body[0][((votes * line).sum(axis=0) > 0.0) & (body[0][:, 1] < hang_below_m)]
    hung = default_depth_m(scalp), default_width_m(scalp), hang_below_m

    def fields(points_m: Array) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]]:
        lain = near_lying_hair(body, votes, points_m)
        grown = np.maximum(cap_mm(views, near_skin(scalp, points_m)), overhang_mm(views, scalp, points_m))
        hanging = hanging_mm(views, points_m, lain.skin_mm, *hung)
        low = points_m[:, 1] < hang_below_m
        hanging = np.where(low, np.maximum(hanging, lying_hair_mm(views, lain)), hanging)
        if tail is not None:
            grown = np.maximum(grown, tail_mm(views, tail, points_m))
            hanging = np.where(tail.holds(points_m), -CLIP_MM, hanging)
        return grown, hanging, lain.skin_mm

    points, rows, shape = candidate_points(views, scalp, lying, tail, low_m, high_m)
    field = np.full(int(np.prod(shape)), -CLIP_MM, np.float32)
    skin = np.full(field.shape, np.float32(FAR_MM))
    kept, skin[rows] = near_hair(rows, shape, lambda some: fields(points[some]))
    points, rows = points[kept], rows[kept]
    grown, hanging, skin[rows] = fields(points)
    found = np.where(attached_to(grown, hanging, rows, shape), np.maximum(grown, hanging), grown)
    free = np.zeros(len(points), np.bool_) if tail is None else tail.inside_mm(points) > -BESIDE_TAIL_MM
    skin = skin.reshape(shape)
    found = close_gaps(views, np.asarray(found, np.float32), skin, points, rows, free)
    field[rows] = np.clip(found, -CLIP_MM, CLIP_MM)
    return gaussian_filter(field.reshape(shape), SMOOTH_VOXELS), skin
