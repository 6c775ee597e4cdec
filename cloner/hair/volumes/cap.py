"""The cap of hair that follows the head: where it grows, by votes of the photos, and its thickness."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.frames import m_from_mm, mm_from_m
from cloner.geometry.cameras.visibility import depth_at
from cloner.geometry.meshes.graphs import SurfaceGraph
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.volumes.tail import Tail
from cloner.hair.volumes.views import MASK_SCALE, SIDES, HairView, covered_window
from cloner.parallel import ABREAST, parallel_map
from cloner.records.arrays import Array
from cloner.vision.retouching.aligning import sample
from cloner.vision.retouching.repair import signed_distance

VOTE_MM = 12.0  # farther from the hairline than this a photo is no surer
VOTE_COSINE = 0.05  # surfaces turned farther away have no vote
DEPTH_SLACK_M = 0.01  # taste: skin so far behind what is drawn is still seen
TAIL_STEPS_M = (0.02, 0.035, 0.05, 0.07, 0.09, 0.12, 0.15)  # where a tail before the skin is looked for
FACE_PHOTO = 0.35  # weight of a face photo's outline: its camera is worse known than a body photo's
SOFT_MM = 2.0 * VOTE_MM  # hairiness goes from 0 to 1 over what a photo can tell
ROOT_MM, STEEP_MM = 1.0, 0.5  # hair rises from this far outside the hairline: 4 mm thick 3 mm inside, 30 at 9
BARE_MM = 6.0  # beyond the scalp (ears, cheeks, neck) labels must be this sure of hair, and none as sure of skin
HAIR_BESIDE = 0.25  # taste: so much hair in what photos show beside unseen scalp is no stray label
SURE_VOTE = 0.2  # of photos that see it
GROWTH_RINGS = 3  # hair may grow this many rings of edges beyond the scalp
RIM_POWER = 6  # an outline says nothing about surfaces that face the camera: trust is (1 - |cos|)**6
RIM_MM = 12.0  # nor about points farther than this inside the own outline
SAME_EDGE_MM = 3.0  # hair's edge is the person's outline where both lie so
FIRST_MM = 5.0  # taste: hair begins this thick, then it is fitted
CLOSE_MM = 25.0  # thicker hair does not follow the head: all outlines together say where it is
FURTHEST_MM = 40.0  # an outline farther off is another thing's, say a tail's
ROUNDS = 4  # count: of settling between the outlines
STIFFNESS = 0.08  # of the surface between outlines, against one outline point
FULL_SHARE = 0.8  # hairiness where hair has its whole thickness
SURE_RIM = 0.3  # weight of outline points that tell how thick the cap usually is
THICKEST_SHARE, THICKEST_EXTRA_MM = 1.8, 5.0  # a cap is no thicker than this against its median; more is a tail
DEEPEST_MM = 20.0  # the bare skull may stand out of the photos' hair by this much
THINNEST_MM = 2.0  # where hair grows it covers the skin
PLANE_REACH_M = 0.03  # tangent planes tell distances up to here


@dataclass(frozen=True, slots=True, eq=False)
class Scalp:
    """Hair measured at the skin's vertices.

    Attributes
    ----------
    points_m, normals : (N, 3)
    lobes_m : (3,)
        Middle between the ears' lobes.
    triangles : (T, 3) int32
    votes : (K, N) float64
        How much each photo's labels count at each vertex, zero where it does not see it.
    hairy : (N,) float64 in 0..1, smooth over the surface
    growth : (N,) float64 in 0..1, where hair can grow at all
    thickness_mm : (N,) float64
        Of the cap; zero where there is no hair.
    """

    points_m: Array
    normals: Array
    lobes_m: Array
    triangles: NDArray[np.int32]
    votes: Array
    hairy: Array
    growth: Array
    thickness_mm: Array


def measure_scalp(
    views: list[HairView],
    points_m: Array,
    normals: Array,
    triangles: NDArray[np.int32],
    graph: SurfaceGraph,
    scalp: NDArray[np.bool_],
    ears: NDArray[np.bool_],
    tail: Tail | None,
) -> Scalp:
    """Return where hair grows and its thickness over the skin.

    No photo can forbid what another shows: heads turn a few degrees between
    photos, and the intersection of all cones would lose a centimetre of hair.
    Labels vote where their photo sees the skin squarely; outlines pull the
    cap where the skin turns away from the camera.

    Parameters
    ----------
    views : list of HairView
    points_m, normals : (N, 3) skin vertices of head and neck
    triangles : (T, 3) of those vertices
    graph : SurfaceGraph of those vertices
    scalp, ears : (N,) bool
    tail : Tail or None
        Free hair; behind it no photo sees the skin.
    """
    lobes_m = points_m[ears].mean(axis=0)
    lobes_m[1] = points_m[ears, 1].min()
    votes, line = label_votes(views, points_m, normals, tail, lobes_m)
    votes = graph.smooth(votes.T.copy(), 1).T * (votes > 0.0)
    total = votes.sum(axis=0)
    mean = (votes * line).sum(axis=0) / np.maximum(total, 1e-9)
    mean = graph.fill(mean[:, None], np.clip(total, 0.0, 1.0), 0.02)[:, 0]
    mean = _with_unseen(graph, scalp, mean, total > 0.0, points_m[:, 1] > points_m[ears, 1].max(initial=-np.inf))
    denied = ((line < -BARE_MM) & (votes > SURE_VOTE)).any(axis=0)
    hidden = (mean > BARE_MM) & (total > SURE_VOTE)
    beyond = (_dilated(scalp, triangles) | _dilated(hidden, triangles)) & ~denied & (~ears | hidden)
    growth = graph.smooth((scalp | beyond).astype(float), 1)
    hairy = graph.smooth(np.clip(0.5 + mean / SOFT_MM, 0.0, 1.0) * growth, 1)
    thickness = settle_cap(views, points_m, triangles, hairy, graph)
    # A skull may stand out of the photos' hair: no photo shows it, so it gives way.
    tucked = points_m + normals * m_from_mm(1.0) * np.minimum(thickness - THINNEST_MM * hairy, 0.0)[:, None]
    thickness = rounded_thickness(np.maximum(thickness, THINNEST_MM), hairy)
    return Scalp(tucked, normals, lobes_m, triangles, votes, hairy, growth, thickness)


def _with_unseen(
    graph: SurfaceGraph, scalp: NDArray[np.bool_], line_mm: Array, shown: NDArray[np.bool_], high: NDArray[np.bool_]
) -> Array:
    """Return distances (N,) to the hairline, mm, with unseen scalp as hair if photos show some beside it.

    Faces, ears and necks around it are no sign of baldness; the bare top of a head goes on behind.

    Parameters
    ----------
    graph : SurfaceGraph
    scalp, shown, high : (N,) bool
        Where hair grows, what some photo shows, and what lies above the ears.
    line_mm : (N,)
        Known where photos show the scalp.
    """
    rows = np.flatnonzero(scalp)
    if shown[rows].all() or not shown[rows].any():
        return line_mm
    unseen = rows[~shown[rows]]
    nearest = rows[graph.part(rows).nearest(shown[rows])][~shown[rows]]
    beside = np.unique(nearest)
    if (line_mm[beside] > 0.0).mean() < HAIR_BESIDE or not high[beside].any():
        return line_mm
    bare = line_mm < -BARE_MM
    bald = bare[nearest] & high[unseen] & (bare[beside[high[beside]]].mean() > 0.5)
    found = line_mm.copy()
    found[unseen] = np.where(bald, -VOTE_MM, VOTE_MM)
    return found


def rounded_thickness(thickness_mm: Array, hairy: Array) -> Array:
    """Return a thickness (N,) that rises from the hairline in a round edge; zero without hair."""
    inside_mm = np.clip((hairy - 0.5) * SOFT_MM + ROOT_MM, 0.0, VOTE_MM)
    most_mm = VOTE_MM * inside_mm / (VOTE_MM + STEEP_MM - inside_mm)
    return np.asarray(np.clip(thickness_mm, -DEEPEST_MM * (hairy > 0.5), most_mm))


def _dilated(flags: NDArray[np.bool_], triangles: NDArray[np.int32]) -> NDArray[np.bool_]:
    """Return flags dilated by rings of triangles."""
    for _ in range(GROWTH_RINGS):
        touched = flags[triangles].any(axis=1)
        flags = flags.copy()
        flags[triangles[touched]] = True
    return flags


def label_votes(
    views: list[HairView], points_m: Array, normals: Array, tail: Tail | None, lobes_m: Array
) -> tuple[Array, NDArray[np.float32]]:
    """Return the weights (K, N) of the photos' labels, and their votes (K, N) (:func:`hairline_mm`).

    What side photos show of a throat is the curtain of hair before it, unless front photos see the throat covered.

    Points (N, 3) are the skin's; ``lobes_m`` (3,) is the middle between the ears' lobes.
    """
    votes = np.stack([visibility_weights(view, points_m, normals, tail) for view in views])
    line = np.stack([hairline_mm(view, points_m) for view in views])
    away = points_m - lobes_m
    throat = (away[:, 1] < 0.0) & (away[:, 2] > np.abs(away[:, 0]))  # within 45 degrees of straight ahead
    front, aside = (np.array([view.posed.view in of for view in views]) for of in SIDES[:2])
    seen = np.ix_(front, throat)
    if np.sum(votes[seen] * line[seen]) <= 0.0:
        votes[np.ix_(aside, throat)] = 0.0
    return votes, line


def visibility_weights(view: HairView, points_m: Array, normals: Array, tail: Tail | None) -> Array:
    """Return the weight (N,) of a photo's labels: squared cosine where the skin is visible."""
    posed = view.to_view(points_m)
    towards = view.posed.camera.position_m - posed
    towards = towards / np.linalg.norm(towards, axis=1, keepdims=True)
    cosine = np.einsum("nk,nk->n", view.turn(normals), towards)
    depth = view.posed.camera.to_camera(posed)[:, 2]
    # NaN outside the picture: no vote.
    seen = (depth < depth_at(view.nearest_m, view.posed.camera.project(posed)) + DEPTH_SLACK_M) & (cosine > VOTE_COSINE)
    if tail is not None:
        for step in TAIL_STEPS_M:
            before = view.to_rest(posed + step * towards)
            seen &= tail.inside_mm(before) <= 0.0
    return np.where(seen & view.speaks_for(points_m), cosine**2, 0.0)


def covered_share(views: list[HairView], points_m: Array, normals: Array) -> Array:
    """Return 0..1 (N,) how far photos that face some skin show hair over it instead; zero where none faces it."""
    votes = np.stack([visibility_weights(view, points_m, normals, None) for view in views])
    line = np.stack([hairline_mm(view, points_m) for view in views])
    mean = (votes * line).sum(axis=0) / np.maximum(votes.sum(axis=0), 1e-9)
    return np.where(votes.sum(axis=0) > SURE_VOTE, np.clip(0.5 + mean / BARE_MM, 0.0, 1.0), 0.0)


def hairline_mm(view: HairView, points_m: Array) -> NDArray[np.float32]:
    """Return the signed distance (N,) to one photo's hairline, mm, at most VOTE_MM, positive inside the hair."""
    posed = view.to_view(points_m)
    line = sample(view.line_px, view.posed.camera.project(posed))[:, 0].astype(np.float64) * view.pixel_mm(posed)
    return np.asarray(np.clip(line, -VOTE_MM, VOTE_MM), np.float32)


def settle_cap(
    views: list[HairView], points_m: Array, triangles: NDArray[np.int32], hairy: Array, graph: SurfaceGraph
) -> Array:
    """Return the cap's thickness (N,), mm, that brings the head's outlines to those of the photos.

    It is negative where the skull stands out of the photos' hair. The surface is pushed along its normals by the gap
    between its own outline and the photo's, and again, because the rim moves with it. Between outlines the thickness is
    smooth. Where photos disagree it is their mean.
    """
    normals = vertex_normals(points_m, triangles)
    thickness = rounded_thickness(np.full(len(points_m), FIRST_MM), hairy)
    for _ in range(ROUNDS):
        surface = points_m + normals * m_from_mm(1.0) * thickness[:, None]
        drive, trust, thickest = np.zeros(len(points_m)), np.zeros(len(points_m)), 0.0
        for gap, weight in outline_gaps(views, surface, triangles):
            weight = weight * (hairy > 0.5)
            limit = _thickest_mm(thickness + gap, weight, hairy) if len(views) > 1 else FURTHEST_MM
            weight = np.where(thickness + gap > limit, 0.0, weight)  # a tail's root says nothing about the cap
            drive, trust, thickest = drive + weight * gap, trust + weight, max(thickest, limit)
        if not np.any(trust > 0.0):
            break
        wanted = thickness + drive / np.maximum(trust, 1e-9)
        thickness = graph.fill(wanted[:, None], np.clip(trust, 0.0, 1.0), STIFFNESS)[:, 0]
        thickness = rounded_thickness(np.minimum(graph.smooth(thickness, 1), thickest), hairy)
    return thickness


def _thickest_mm(wanted_mm: Array, weight: Array, hairy: Array) -> float:
    """Return the largest thickness that one photo's outline allows, mm: hair flat in front may be thick behind."""
    sure = wanted_mm[(weight > SURE_RIM) & (hairy > FULL_SHARE)]
    sure = sure if sure.size else wanted_mm[weight > 0.0]
    usual = max(float(np.median(sure)), 0.0) if sure.size else 0.0
    return min(THICKEST_SHARE * usual + THICKEST_EXTRA_MM, CLOSE_MM)


def surface_mm(
    vertices_m: Array, normals: Array, points_m: Array
) -> tuple[NDArray[np.float32], NDArray[np.intp], NDArray[np.float64]]:
    """Return the signed distance (N,) of points to a surface, mm, positive outside, its nearest rows and their weights.

    It is the mean of the distances to four vertices' tangent planes, weighted by closeness: good near the surface.
    """
    gap, rows = cKDTree(vertices_m).query(points_m, k=4, workers=ABREAST)
    weight = 1.0 / (gap + 1e-4) ** 2
    weight /= weight.sum(axis=1, keepdims=True)
    along = np.einsum("nkc,nkc->nk", points_m[:, None] - vertices_m[rows], normals[rows])
    away = mm_from_m(1.0) * (weight * along).sum(axis=1)
    # Plane distances mean nothing far away, where the Euclidean one takes over.
    away = np.where(gap[:, 0] > PLANE_REACH_M, np.sign(away) * mm_from_m(1.0) * gap[:, 0], away)
    return away.astype(np.float32), rows, weight


def outline_gaps(views: list[HairView], surface_m: Array, triangles: NDArray[np.int32]) -> list[tuple[Array, Array]]:
    """Return each photo's signed distances (N,) to a surface's outline, mm, and their weights."""
    facing = vertex_normals(surface_m, triangles)
    straight = [view for view in views if view.flip_m is None]
    gaps = parallel_map(lambda view: _outline_gap(view, surface_m, facing, triangles), straight)
    return [
        (gap, weight * (FACE_PHOTO if view.posed.view.is_face else 1.0))
        for view, (gap, weight) in zip(straight, gaps, strict=True)
    ]


def _outline_gap(view: HairView, surface_m: Array, normals: Array, triangles: NDArray[np.int32]) -> tuple[Array, Array]:
    """Return the distance (N,) of the photo's outline outside the surface's own, mm, and its weight."""
    posed = view.to_view(surface_m)
    camera = view.posed.camera
    towards = camera.position_m - posed
    towards /= np.linalg.norm(towards, axis=1, keepdims=True)
    across = 1.0 - np.abs(np.einsum("nk,nk->n", view.turn(normals), towards))
    pixel, scale = camera.project(posed), view.pixel_mm(posed)
    own, within = covered_window(view, surface_m, triangles)
    inside = sample(signed_distance(own), within)[:, 0] / MASK_SCALE * scale
    outline, edge = (sample(distance, pixel)[:, 0] * scale for distance in (view.outline_px, view.hair_px))
    gap = outline - inside
    # The photo's outline must be the hair's, and this vertex at the own outline.
    good = (sample(view.line_px, pixel)[:, 0] > 0.0) & (inside < RIM_MM) & (np.abs(gap) < FURTHEST_MM)
    good &= np.abs(outline - edge) < SAME_EDGE_MM  # a tail before neck or back ends inside the person
    good &= (pixel > 2.0).all(axis=1) & (pixel < np.array([camera.width_px, camera.height_px]) - 3.0).all(axis=1)
    return gap, np.where(good, np.clip(across, 0.0, 1.0) ** RIM_POWER, 0.0)
