"""Find where the face net's 468 points lie on the generic head: ``python generic_models/build/calibrate_face_net.py``.

Random generic heads are painted, photographed and shown to the net; every point's place on the surface and its spread
go to ``cloner_models/face_net.npz``, with the linear rules that turn net points into named feature points.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from archives import save
from numpy.typing import NDArray
from painted_heads import Head, photograph, random_camera

from cloner.detectors import litert
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.rims import vertex_normals
from cloner.geometry.surface import SurfacePoints, first_hits, nearest_points
from cloner.records.views import Camera

Array = NDArray[np.float64]
OUT = Path(__file__).resolve().parent.parent / "cloner_models" / "face_net.npz"
SEED = 468  # any number; fixed so that a rebuild gives the same file
NAMED = (
    "eye_inner", "eye_outer", "eye_upper", "eye_lower", "mouth_corner", "ala", "pupil",
    "ear_top", "ear_lobe", "ear_outer",
)  # fmt: skip
MIDDLE = ("nasion", "glabella", "nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom", "chin_front",
          "chin_bottom")  # fmt: skip
PROFILE = ("glabella", "nasion", "nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom", "chin_front",
           "chin_bottom")  # fmt: skip
MODES = 24  # joint errors of the net that are kept; the rest counts as independent
BANK = 24  # profiles kept for the search in side photos
NEIGHBOURS = 14  # net points a named point is made from
RIDGE = 30.0  # holds the rule near plain interpolation; taste, 40 heads fix 14 weights only softly


def random_head(generic: GenericHuman, rng: np.random.Generator, spread: float = 0.8) -> Array:
    """Return the vertices of a random person at 1.70 m, metres; ``spread`` scales the population's variety."""
    vertices, _ = generic.shape(0.8 * rng.normal(size=generic.shape_basis.shape[0]), 1.70)
    if generic.face_basis.size:
        face = np.tensordot(spread * rng.normal(size=len(generic.face_basis)), generic.face_basis, axes=1)
        vertices[generic.head_vertices] += face
    return vertices


def exposed_triangles(generic: GenericHuman, triangles: NDArray[np.integer]) -> NDArray[np.bool_]:
    """Return the body triangles that a camera in front can see on the mean head: no sockets, no mouth bag."""
    vertices = generic.vertices_m.astype(np.float64)
    low, high = vertices[generic.feature("neck_front_base"), 1], vertices[generic.feature("vertex_top"), 1]
    seen = np.zeros(len(triangles), dtype=bool)
    grid = np.stack(np.meshgrid(np.arange(-0.1, 0.1, 0.0012), np.arange(low, high, 0.0012)), axis=-1).reshape(-1, 2)
    for yaw in np.radians([-55, 0, 55]):
        turned = vertices @ np.array([[np.cos(yaw), 0, -np.sin(yaw)], [0, 1, 0], [np.sin(yaw), 0, np.cos(yaw)]])
        hit, _ = first_hits(grid, turned[:, :2], -turned[:, 2], triangles)
        seen[hit[hit >= 0]] = True
    body = generic.vertex_part[triangles].max(axis=1) == generic.part_names.index("body")
    return seen & body


def net_points(picture: NDArray[np.uint8]) -> Array | None:
    """Return the net's (468, 2) points or None when it sees no face."""
    result = litert.detect_face(picture)
    return None if result is None else np.asarray(result.points_px)


def places(generic: GenericHuman, vertices: Array, camera: Camera, points: Array, triangles: NDArray[np.integer],
           exposed: NDArray[np.bool_]) -> Array:  # fmt: skip
    """Return where the points lie on the *mean* head, (468, 3) metres; off the outline, on its rim."""
    mean = generic.vertices_m.astype(np.float64)
    seen = triangles[exposed]
    normals = vertex_normals(vertices, triangles)
    facing = np.einsum("va,va->v", normals, camera.position_m - vertices) > 0
    seen = seen[facing[seen].all(axis=1)]
    projected, depth = camera.project(vertices), camera.to_camera(vertices)[:, 2]
    hit, weights = first_hits(points, projected, depth, seen)
    out = np.einsum("nk,nka->na", weights, mean[seen[hit]])
    missed = hit < 0
    if missed.any():
        flat = np.column_stack([projected, np.zeros(len(projected))])
        rim = nearest_points(np.column_stack([points[missed], np.zeros(missed.sum())]), flat, seen)
        out[missed] = rim.at(mean)
    return out


def named_rule(net: Array, named: Array, centre: Array) -> tuple[NDArray[np.int64], Array, float]:
    """Return net indices, weights summing to one and rms error (share of the eye distance) for one named point.

    Parameters
    ----------
    net : (heads, 468, 2), named : (heads, 2)
        In units of each picture's eye distance.
    centre : (468, 2) mean net points, same unit
    """
    away = np.linalg.norm(centre - named.mean(axis=0), axis=1)
    chosen = np.argsort(away)[:NEIGHBOURS] if away.min() < 0.2 else np.argsort(away)[: 3 * NEIGHBOURS : 3]
    start = np.exp(-(((away[chosen] - away[chosen].min()) / 0.1) ** 2))
    start /= start.sum()
    # weights = start + free, free sums to zero: columns relative to the last chosen point
    columns = (net[:, chosen[:-1]] - net[:, chosen[-1:]]).transpose(0, 2, 1).reshape(-1, len(chosen) - 1)
    target = (named - np.einsum("k,hka->ha", start, net[:, chosen])).reshape(-1)
    ridge = RIDGE * 0.02**2 * np.eye(len(chosen) - 1)
    free = np.linalg.solve(columns.T @ columns + ridge, columns.T @ target)
    weights = start + np.append(free, -free.sum())
    error = np.einsum("k,hka->ha", weights, net[:, chosen]) - named
    return chosen, weights, float(np.sqrt((error**2).sum(axis=1).mean()))


def profile_template(generic: GenericHuman, vertices: Array) -> tuple[Array, Array]:
    """Return a head's side outline from 25 mm over the glabella to the chin's underside, and its named points.

    Both are (120, 2) and (K, 2) metres, forward and up from the nose tip. The outline is the foremost point of each
    level, filled up with the midline under the nose and the chin where a level has more than one.
    """
    body = generic.vertex_part == generic.part_names.index("body")
    tip = vertices[generic.feature("nose_tip")]
    corners = generic.triangles()[0]
    corners = corners[body[corners].all(axis=1) & (np.abs(vertices[corners, 0]) < 0.03).all(axis=1)]
    low = vertices[generic.feature("chin_bottom"), 1] - 0.001
    high = vertices[generic.feature("glabella"), 1] + 0.025
    front: list[Array] = []
    for level in np.arange(low, high, 0.001):
        above = vertices[corners, 1] > level
        cut = corners[above.any(axis=1) & ~above.all(axis=1)]
        reach = -np.inf
        for first, second in ((0, 1), (1, 2), (2, 0)):
            a, b = vertices[cut[:, first]], vertices[cut[:, second]]
            crosses = (a[:, 1] > level) != (b[:, 1] > level)
            a, b = a[crosses], b[crosses]
            depth = a[:, 2] + (level - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 2] - a[:, 2])
            reach = max(reach, float(depth.max(initial=-np.inf)))
        front.append(np.array([reach, level]))
    points = np.stack(front)
    gap = np.linalg.norm(np.diff(points, axis=0), axis=1)
    along = np.concatenate([[0.0], np.cumsum(gap)])
    even = np.linspace(0.0, along[-1], 120)
    points = np.column_stack([np.interp(even, along, points[:, k]) for k in range(2)])
    named = np.stack([vertices[generic.feature(n)][[2, 1]] for n in PROFILE])
    return points - tip[[2, 1]], named - tip[[2, 1]]


def profile_bank(generic: GenericHuman, rng: np.random.Generator) -> tuple[Array, Array]:
    """Return the outlines (B, 120, 2) and named points (B, K, 2) of the mean head and of random ones."""
    heads = [generic.vertices_m.astype(np.float64)] + [random_head(generic, rng, 1.3) for _ in range(BANK - 1)]
    pairs = [profile_template(generic, vertices) for vertices in heads]
    return np.stack([p for p, _ in pairs]), np.stack([n for _, n in pairs])


def main() -> None:
    """Photograph, ask, average, write."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--heads", type=int, default=40)
    parser.add_argument("--sheet", type=Path, help="write a picture of some heads with the net's points")
    arguments = parser.parse_args()
    generic, rng = load_generic(), np.random.default_rng(SEED)
    head = Head(generic)
    exposed = exposed_triangles(generic, head.coarse)
    mean = generic.vertices_m.astype(np.float64)
    names = [f"{n}_{s}" for n in NAMED for s in "LR"] + list(MIDDLE)
    found: list[tuple[Array, Camera, Array, Array]] = []
    pictures = []
    for _ in range(arguments.heads):
        vertices = random_head(generic, rng)
        camera = random_camera(generic, vertices, rng)
        picture = photograph(head, vertices, camera, rng)
        points = net_points(picture)
        if points is None:
            continue
        found.append((vertices, camera, points, places(generic, vertices, camera, points, head.coarse, exposed)))
        pictures.append(picture)
    stacked = np.stack([p for *_, p in found])
    middle = np.median(stacked, axis=0)
    twin = np.linalg.norm((middle * [-1.0, 1.0, 1.0])[:, None] - middle[None], axis=2).argmin(axis=1)
    middle = (middle + middle[twin] * [-1.0, 1.0, 1.0]) / 2.0
    surface = nearest_points(middle, mean, head.coarse[exposed], candidates=40)
    reprojected, sizes = [], []
    for vertices, camera, points, _ in found:
        iod = np.linalg.norm(np.diff(camera.project(vertices[[generic.feature(f"pupil_{s}") for s in "LR"]]), axis=0))
        metres = camera.metres_per_pixel(vertices[generic.feature("nasion")])
        reprojected.append((points - camera.project(surface.at(vertices))) * metres)
        sizes.append(iod)
    error = np.stack(reprojected)
    sigma_m = np.sqrt((error**2).sum(axis=2).mean(axis=0) / 2.0)  # along one axis
    drift, alone = joint_errors(np.concatenate([error, error[:, twin] * [-1.0, 1.0]]))
    unit = np.array(sizes)[:, None, None]
    net = np.stack([p for _, _, p, _ in found]) / unit
    origin = net.mean(axis=1, keepdims=True)
    rules = np.zeros((len(names), 468))
    errors = np.zeros(len(names))
    for row, name in enumerate(names):
        vertex = generic.feature(name)
        seen = np.stack([c.project(v[vertex][None])[0] for v, c, *_ in found])[:, None] / unit
        chosen, weights, errors[row] = named_rule(net - origin, (seen - origin)[:, 0], (net - origin).mean(axis=0))
        rules[row, chosen] = weights
    profile, landmarks = profile_bank(generic, rng)
    save(OUT, {"profile_m": profile.astype(np.float32), "profile_names": np.array(PROFILE, dtype=np.str_),
               "profile_landmarks_m": landmarks.astype(np.float32),
               "corners": surface.corners, "weights": surface.weights.astype(np.float32),
               "sigma_m": sigma_m.astype(np.float32), "drift_m": drift.astype(np.float16),
               "alone_m": alone.astype(np.float32), "named": np.array(names, dtype=np.str_),
               "rules": rules.astype(np.float32), "rule_error_iod": errors.astype(np.float32)})  # fmt: skip
    report(names, errors, sigma_m, len(found))
    if arguments.sheet:
        write_sheet(arguments.sheet, pictures[:6], found[:6], surface)


def joint_errors(error: Array) -> tuple[Array, Array]:
    """Return the modes (M, 468, 2) of errors that net points make together, and what each errs alone (468,), metres.

    Parameters
    ----------
    error : (heads, 468, 2)
        Net point minus place, along the picture's axes, metres; a mode times a standard normal number is an error.
    """
    flat = error.reshape(len(error), -1)
    _, size, modes = np.linalg.svd(flat, full_matrices=False)
    drift = (size[:MODES, None] / np.sqrt(len(flat))) * modes[:MODES]
    rest = flat - (flat @ modes[:MODES].T) @ modes[:MODES]
    alone = np.sqrt((rest.reshape(error.shape) ** 2).sum(axis=2).mean(axis=0) / 2.0)
    return drift.reshape(MODES, 468, 2), alone


def report(names: list[str], errors: Array, sigma_m: Array, count: int) -> None:
    """Print what was found."""
    print(f"{count} heads; net points: median sigma {1e3 * np.median(sigma_m):.2f} mm, worst {1e3 * sigma_m.max():.2f}")
    for name, error in zip(names, errors, strict=True):
        print(f"  {name:16s} {100 * error:5.2f} % of the eye distance")


def write_sheet(
    path: Path,
    pictures: list[NDArray[np.uint8]],
    found: list[tuple[Array, Camera, Array, Array]],
    surface: SurfacePoints,
) -> None:
    """Draw the net's points (green) and the calibrated places (red) on some heads."""
    import cv2

    tiles = []
    for picture, (vertices, camera, points, _) in zip(pictures, found, strict=True):
        tile = picture.copy()
        for colour, dots in (((0, 255, 0), points), ((255, 0, 0), camera.project(surface.at(vertices)))):
            for x, y in dots:
                cv2.circle(tile, (round(x), round(y)), 1, colour, -1)
        tiles.append(tile)
    cv2.imwrite(str(path), np.hstack(tiles)[..., ::-1])


if __name__ == "__main__":
    main()
