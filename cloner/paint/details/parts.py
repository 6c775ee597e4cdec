"""Eyes, teeth, tongue and lashes painted into the atlas."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import GenericHuman
from cloner.geometry.charts.atlas import AtlasMap, colours_at
from cloner.geometry.meshes.vectors import unit
from cloner.vision.retouching.painting import (
    LASH_RGB,
    SCLERA_RGB,
    paint_eye,
    paint_plain,
    paint_teeth,
    paint_tongue,
    sclera_rgb,
)

USUAL_SKIN_RGB = (190.0, 160.0, 145.0)  # taste: for a mesh whose face has no texels
EDGE_STEP_M = 0.004  # half a tooth: the biting edge is found as finely
USUAL_IRIS_M = 0.00585  # anatomy: 11.7 mm across


def paint_parts(
    generic: GenericHuman,
    atlas: AtlasMap,
    rgb: NDArray[np.uint8],
    vertices_m: NDArray[np.float64],
    skin_rgb: NDArray[np.float64],
    iris_rgb: NDArray[np.float64],
    iris_radius_m: float,
    white_to_skin: NDArray[np.float64] | None,
    rng: np.random.Generator,
) -> None:
    """Paint every part but the skin into the texels (size, size, 3); ``atlas`` is that of the parts.

    ``skin_rgb`` (3,) is the face's in these texels (:func:`face_rgb`), ``sclera_to_skin`` (3,) how much lighter the
    whites are than the skin around the eyes, None for the usual.
    """
    flat = rgb.reshape(-1, 3)
    # teeth of full white stare out of a dark photo: they stand in the light of the eyes' whites
    light = min(float(np.mean(sclera_rgb(skin_rgb, white_to_skin)) / np.mean(SCLERA_RGB)), 1.0)
    part_of = generic.vertex_part[atlas.triangles[:, 0]]
    for number, name in enumerate(generic.part_names):
        if name == "body":
            continue
        rows = atlas.rows_of(part_of == number)
        if rows.size == 0:
            continue
        vertices = generic.part(name)
        points = atlas.interpolate(vertices_m, rows)
        if name.startswith("eye_"):
            centre, radius = fit_sphere(vertices_m[vertices])
            spokes = points - centre.astype(np.float32)
            spokes = unit(spokes)
            iris = iris_radius_m if iris_radius_m > 0.0 else USUAL_IRIS_M
            angle = float(np.arcsin(np.clip(iris / radius, 0.2, 0.7)))
            colour = paint_eye(spokes, iris_rgb, angle, skin_rgb, white_to_skin, rng)
        elif name.startswith("teeth_"):
            along, height = _along_arch(points), points[:, 1] if name == "teeth_upper" else -points[:, 1]
            colour = light * paint_teeth(height - _biting_edge(along, height), along)
        elif name == "tongue":
            tip = vertices_m[vertices].max(axis=0)[2]
            middle = (vertices_m[vertices, 0].min() + vertices_m[vertices, 0].max()) / 2.0
            colour = light * paint_tongue(tip - points[:, 2], points[:, 0] - middle)
        else:
            colour = paint_plain(rows.size, LASH_RGB)
        flat[atlas.texel[rows]] = np.clip(np.rint(colour), 0, 255)


def face_rgb(generic: GenericHuman, rgb: NDArray[np.uint8]) -> NDArray[np.float64]:
    """Return the median colour (3,) of the face in the atlas, sampled at every triangle's middle."""
    triangles, uv_triangles = generic.triangles()
    face = uv_triangles[np.all(generic.region("face")[triangles], axis=1)]
    if not len(face):
        return np.array(USUAL_SKIN_RGB)
    return np.asarray(np.median(colours_at(rgb, generic.uv[face].mean(axis=1)), axis=0), np.float64)


def fit_sphere(points_m: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
    """Return centre (3,) and radius of the best sphere through points (N, 3) (linear least squares)."""
    middle = points_m.mean(axis=0)
    local = points_m - middle
    system = np.column_stack([2.0 * local, np.ones(len(local))])
    solution = np.linalg.lstsq(system, (local**2).sum(axis=1), rcond=None)[0]
    return middle + solution[:3], float(np.sqrt(max(solution[3] + (solution[:3] ** 2).sum(), 1e-12)))


def _along_arch(points_m: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the position (N,) along the arch of teeth from its middle, metres."""
    aside = points_m[:, 0] - (points_m[:, 0].min() + points_m[:, 0].max()) / 2.0
    width = max(float(np.abs(aside).max()), 1e-6)
    behind = points_m[:, 2].max() - points_m[:, 2]
    return np.asarray(np.arctan2(aside, width - behind) * width, np.float32)


def _biting_edge(along_m: NDArray[np.float32], height_m: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the height (N,) of the biting edge at every position along the arch."""
    places = np.round(along_m / EDGE_STEP_M).astype(int)
    steps = np.unique(places)
    lowest = np.array([height_m[places == step].min() for step in steps])
    return np.asarray(np.interp(along_m, steps * EDGE_STEP_M, lowest), np.float32)
