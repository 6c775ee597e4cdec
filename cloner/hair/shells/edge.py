"""Soft hairlines: alpha fades out over some millimetres around where the photos show the hairline."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt

from cloner.geometry.cameras.visibility import depth_at, depth_picture
from cloner.geometry.charts.atlas import AtlasMap
from cloner.geometry.meshes.graphs import surface_graph
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.volumes.cap import SOFT_MM, VOTE_MM, Scalp, hairline_mm, surface_mm
from cloner.hair.volumes.views import HairView
from cloner.records.arrays import Array

FADE_MM = (-1.5, 2.0)  # taste: transparent this far outside the hairline, opaque this far inside
SEEN_COSINE = 0.15  # surfaces turned farther away are seen too narrowly
SEEN_SLACK_M = 0.012  # a head a little off its photo hides its own hair
SHARPNESS = 2  # weights are (claim x cosine)**2
UNSEEN_STIFFNESS = 0.02  # of the hairline between what photos see
UNSEEN_TRUST = 0.02  # in what no photo sees: an edge goes on for some vertices, not around a head
FILM_SKIN_MM = 4.0  # nearer to the skin lies the film that goes on beyond the hairline
STRAND_MM = 1.5  # dark strands reach this much farther out than light gaps
STRAND_TEXELS = 4.0  # width of what counts as one strand's surroundings
LIGHTEST_LEVELS = 6.0  # differences below this are noise


def inside_hairline_mm(
    views: list[HairView],
    claims: list[float],
    vertices_m: Array,
    triangles: NDArray[np.int32],
    unseen_mm: Array | float = VOTE_MM,
) -> Array:
    """Return the distance (N,) of a shell's points inside the hair that the photos show, mm, at most VOTE_MM.

    Labels are read where the photo sees the hair's surface, not the skin below: what a photo shows as
    face stays clear through its own camera, however thick the hair. Photos that disagree are averaged. What none sees
    is as far inside as ``unseen_mm`` (N,) says.
    """
    normals = vertex_normals(vertices_m, triangles)
    total, drive = np.zeros(len(vertices_m)), np.zeros(len(vertices_m))
    for view, claim in zip(views, claims, strict=True):
        posed, camera = view.to_view(vertices_m), view.posed.camera
        towards = camera.position_m - posed
        towards /= np.linalg.norm(towards, axis=1, keepdims=True)
        cosine = np.einsum("nk,nk->n", view.turn(normals), towards)
        nearest = np.minimum(view.nearest_m, depth_picture(posed, triangles, camera))
        # NaN outside the picture: no vote
        before = camera.to_camera(posed)[:, 2] < depth_at(nearest, camera.project(posed)) + SEEN_SLACK_M
        before &= view.speaks_for(vertices_m)
        weight = np.where(before & (cosine > SEEN_COSINE), (claim * cosine) ** SHARPNESS, 0.0)
        drive += weight * hairline_mm(view, vertices_m)
        total += weight
    graph = surface_graph(vertices_m, triangles)
    mean = np.where(total > 0.0, drive / np.maximum(total, 1e-9), unseen_mm)
    trust = np.where(total > 0.0, np.clip(total, 0.0, 1.0), UNSEEN_TRUST)
    return np.asarray(graph.fill(mean[:, None], trust, UNSEEN_STIFFNESS)[:, 0])


def unseen_inside_mm(scalp: Scalp, vertices_m: Array) -> Array:
    """Return the distance (N,) of a shell's points inside the hair by the skin below them, mm: where no photo sees
    them.
    """
    away_mm, rows, weight = surface_mm(scalp.points_m, scalp.normals, vertices_m)
    hairy = (weight * scalp.hairy[rows]).sum(axis=1)
    return np.where(away_mm < FILM_SKIN_MM, (hairy - 0.5) * SOFT_MM, VOTE_MM)


def soften_edge(rgba: NDArray[np.uint8], atlas: AtlasMap, inside_mm: NDArray[np.floating]) -> NDArray[np.uint8]:
    """Return the texture (S, S, 4) with alpha that fades to zero over the hairline.

    Parameters
    ----------
    rgba : (S, S, 4) uint8
    atlas : AtlasMap of the shell
    inside_mm : (N,) of its vertices, distance inside the hairline
    """
    light = rgba[..., :3].astype(np.float32).mean(axis=2)
    gap = cv2.GaussianBlur(light, (0, 0), STRAND_TEXELS) - light
    spread = max(float(gap[atlas.covered()].std()), LIGHTEST_LEVELS)
    distance = np.zeros(light.size, np.float32)
    distance[atlas.texel] = atlas.interpolate(np.minimum(inside_mm, 4.0 * FADE_MM[1])[:, None])[:, 0]
    # Between texels beside charts are sampled too: were they opaque, triangles' edges would be drawn on the forehead.
    row, column = distance_transform_edt(~atlas.covered(), return_distances=False, return_indices=True)
    distance = distance.reshape(light.shape)[row, column] + STRAND_MM * np.clip(gap / spread, -1.0, 1.0)
    share = np.clip((distance - FADE_MM[0]) / (FADE_MM[1] - FADE_MM[0]), 0.0, 1.0)
    result = rgba.copy()
    result[..., 3] = np.rint(255.0 * share * share * (3.0 - 2.0 * share)).astype(np.uint8)
    return result
