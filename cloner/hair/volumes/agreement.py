"""Agreement of hairlines: one line on the head, so photos that place it differently have a wrong pose.

A face seen from the front places its photo's head; a head seen from aside or behind shows
no point that a net knows well. Its hairline it shows sharply, and another photo shows part of the same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.body.head_pose_evidence import posed_vertices
from cloner.fit.evidence import Residuals
from cloner.frames import ViewId, mm_from_m
from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.hair.volumes.pictures import clean_hair, hairline
from cloner.paint.lookups.prepared import person_mask
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh, PosedView
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.vision.retouching.aligning import sample

#: Height of the reduced photo in which distances are told, px.
PICTURE_HEIGHT = 900
#: Hairlines lie this near to the scalp's usual border: beyond it, and on the scalp.
BEYOND_M, WITHIN_M = 0.03, 0.05
#: Farther from its hairline than this a photo says nothing, and so far two photos of one line usually disagree, mm.
REACH_MM, SPREAD_MM = 10.0, 3.0
#: Skin turned farther away is seen too narrowly.
LEAST_COSINE = 0.35
#: Neighbours err together: so many of a photo's vertices count as independent.
INDEPENDENT = 20.0
#: Step of the derivatives, radians.
STEP_RAD = 4e-3
#: Pixels along the photo's border that hold no line.
BORDER_PX = 3.0


@dataclass(frozen=True, slots=True, eq=False)
class HairField:
    """The hairline of one photo.

    Attributes
    ----------
    line_px : (h, w) float32
        Signed distance to the hairline in photo pixels, positive on the hair's side.
    reduction : float
        Photo pixels a pixel of the field.
    """

    line_px: NDArray[np.float32]
    reduction: float


@dataclass(frozen=True, slots=True, eq=False)
class LineReading:
    """One photo's hairline at the vertices of the usual hairline, in its present pose.

    Attributes
    ----------
    distance_mm : (N,) float64
        Signed distance to the photo's hairline.
    trust : (N,) float64
        How squarely the photo sees the vertex; zero where it says nothing.
    jacobian : (N, angles) float64
        Derivatives of the distance by the photo's angles, mm per radian.
    """

    distance_mm: Array
    trust: Array
    jacobian: Array


def hair_fields(
    proposals: Proposals, silhouettes: SilhouetteSet, views: Mapping[ViewId, object]
) -> dict[ViewId, HairField]:
    """Return the hairlines of the photos that show hair."""
    fields = {}
    for view in views:
        person = person_mask(view, proposals.views[view], silhouettes)
        hair = clean_hair(proposals.views[view], person)
        if not hair.any():
            continue
        reduction = max(hair.shape[0] / PICTURE_HEIGHT, 1.0)
        size = int(hair.shape[1] / reduction), int(hair.shape[0] / reduction)
        small, inside = (
            cv2.resize(flags.astype(np.float32), size, interpolation=cv2.INTER_AREA) > 0.5 for flags in (hair, person)
        )
        fields[view] = HairField(hairline(small, inside | small) * np.float32(reduction), reduction)
    return fields


def hairline_rows(generic: GenericHuman, vertices_m: Array) -> NDArray[np.int64]:
    """Return the vertices near the scalp's border, where hairlines run, without those of the ears."""
    scalp, bare = generic.region("scalp"), generic.skin
    near_scalp = cKDTree(vertices_m[scalp]).query(vertices_m, distance_upper_bound=BEYOND_M)[0] < BEYOND_M
    near_rest = cKDTree(vertices_m[bare & ~scalp]).query(vertices_m, distance_upper_bound=WITHIN_M)[0] < WITHIN_M
    left_out = generic.region("ear_left") | generic.region("ear_right") | generic.region("mouth_interior")
    return np.flatnonzero(near_scalp & near_rest & bare & ~left_out & (generic.head_blend > 0.9))


def read_line(
    mesh: BodyMesh, rows: NDArray[np.int64], field: HairField, turned: Callable[[Array], PosedView], angles: Array
) -> LineReading:
    """Return one photo's reading of the vertices ``rows``, posed by ``turned`` of the photo's angles."""
    normals = vertex_normals(mesh.vertices_m, body_triangles())[rows]
    scale = mm_from_m(turned(angles).camera.metres_per_pixel(mesh.vertices_m[rows].mean(axis=0)))

    def read(now: Array) -> tuple[Array, Array, Array]:
        posed = turned(now)
        places, transforms = posed_vertices(mesh, rows, posed)
        pixels = posed.camera.project(places)
        away = sample(field.line_px, (pixels + 0.5) / field.reduction - 0.5)[:, 0].astype(np.float64) * scale
        towards = posed.camera.position_m - places
        towards /= np.linalg.norm(towards, axis=1, keepdims=True)
        facing = normals @ transforms[load_generic().joint("skullbase"), :3, :3].T
        return np.nan_to_num(away, nan=-2.0 * REACH_MM), pixels, np.einsum("nk,nk->n", facing, towards)

    away, pixels, cosine = read(angles)
    camera = turned(angles).camera
    shown = (pixels > BORDER_PX).all(axis=1) & (pixels < (camera.width_px - 4.0, camera.height_px - 4.0)).all(axis=1)
    jacobian = [
        (read(angles + STEP_RAD * one)[0] - read(angles - STEP_RAD * one)[0]) / (2.0 * STEP_RAD)
        for one in np.eye(len(angles))
    ]
    good = shown & (cosine > LEAST_COSINE) & (np.abs(away) < REACH_MM)
    return LineReading(away, np.where(good, cosine, 0.0), np.stack(jacobian, axis=1))


def hairline_residuals(
    mesh: BodyMesh,
    lines: Mapping[ViewId, HairField],
    turned: Mapping[ViewId, Callable[[Array], PosedView]],
    angles: Mapping[ViewId, Array],
) -> Iterator[Residuals]:
    """Yield each photo's residuals (R,) against the mean hairline of all photos at the same vertices.

    They depend on every photo's angles, as the mean that all are compared with moves too.

    Parameters
    ----------
    mesh : BodyMesh
    lines : mapping of ViewId to HairField
    turned : mapping of ViewId to a function
        A photo's pose and camera by its angles.
    angles : mapping of ViewId to (angles,) float64
        As the photos stand now.
    """
    if len(lines) < 2:
        return
    rows = hairline_rows(load_generic(), mesh.vertices_m)
    readings = {view: read_line(mesh, rows, line, turned[view], angles[view]) for view, line in lines.items()}
    trust = np.stack([reading.trust for reading in readings.values()])
    share = trust / np.maximum(trust.sum(axis=0), 1e-9)
    mean = np.einsum("kn,kn->n", share, np.stack([reading.distance_mm for reading in readings.values()]))
    several, of = (trust > 0.0).sum(axis=0) > 1, tuple(view.value for view in readings)
    for place, reading in enumerate(readings.values()):
        used = several & (trust[place] > 0.0)
        away = np.tanh((reading.distance_mm - mean)[used] / SPREAD_MM / 4.0)
        weight = np.sqrt(trust[place][used] / max(np.count_nonzero(used) / INDEPENDENT, 1.0))
        steep = (weight * (1.0 - away**2) / SPREAD_MM)[:, None]
        jacobian = [
            steep * (float(row == place) - share[row][used])[:, None] * theirs.jacobian[used]
            for row, theirs in enumerate(readings.values())
        ]
        yield Residuals(of, 4.0 * away * weight, np.hstack(jacobian))
