"""Find where the face net's 468 points lie on the generic head: ``python generic_models/build/calibrate_face_net.py``.

Random dressed people (``painted_faces.py``) are photographed from the front and shown to the net; every point's place
on the surface and its spread go to ``cloner_models/face_net.npz``, with the linear rules that turn net points into
named feature points, and with the model of profiles (``profile_shapes.py``) that side photos need.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from archives import save
from face_curves_generic import face_curves
from numpy.typing import NDArray
from painted_faces import EXTRAS, make_sitter, photograph_face
from painted_heads import Head
from painted_people_pictures import BACKGROUNDS
from profile_shapes import NAMES as PROFILE
from profile_shapes import joint_model, profile_shapes

from cloner.detectors.nets import litert
from cloner.frames import ViewId
from cloner.generic.face_grids import mouth_grid
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.meshes.surface import SurfacePoints, first_hits, nearest_points
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.records.views import Camera
from cloner.vision.retouching.open_mouth import INNER_LIPS

Array = NDArray[np.float64]
OUT = Path(__file__).resolve().parent.parent / "cloner_models" / "face_net.npz"
SEED = 468  # any number; fixed so that a rebuild gives the same file
FIRST_SITTER = 5000  # far from the seeds that tests and benchmarks draw
EXTRA_EVERY = 4  # every so manieth sitter wears a beard, glasses or hair over the ears
NAMED = (
    "eye_inner", "eye_outer", "eye_upper", "eye_lower", "mouth_corner", "ala", "pupil",
    "ear_top", "ear_lobe", "ear_outer",
)  # fmt: skip
MIDDLE = ("nasion", "glabella", "nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom", "chin_front",
          "chin_bottom")  # fmt: skip
MODES = 24  # joint errors of the net that are kept; the rest counts as independent
PROFILES = 500  # random side faces behind the profile model
PROFILE_MODES = 20
NEIGHBOURS = 14  # net points a named point is made from
RIDGE = 30.0  # holds the rule near plain interpolation; taste, 40 heads fix 14 weights only softly


@dataclass(frozen=True, slots=True, eq=False)
class Shown:
    """One front face as the net saw it: true vertices and camera, net points (468, 2) and irises (2, 2)."""

    vertices_m: Array
    camera: Camera
    points_px: Array
    irises_px: Array
    picture: NDArray[np.uint8]


def show_sitter(seed: int, beyond_m: Array | None = None) -> Shown | None:
    """Return a random person's front face with the net's points, or None when it sees no face.

    ``beyond_m`` (H, 3) moves the head's vertices beyond the generic's family.
    """
    extras = () if seed % EXTRA_EVERY else (EXTRAS[seed // EXTRA_EVERY % 3],)
    background = BACKGROUNDS[seed % len(BACKGROUNDS)]
    known = photograph_face(make_sitter(seed, extras, beyond_m=beyond_m), ViewId.FACE_FRONT, background=background)
    found = litert.detect_face(known.rgb)
    if found is None:
        return None
    return Shown(known.vertices_m, known.camera, found.points_px, found.irises_px, known.rgb)


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

    The error is that of a face the rule was not made from (leave one out).


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
    system = columns.T @ columns + ridge
    free = np.linalg.solve(system, columns.T @ target)
    leverage = 1.0 - np.einsum("ri,ij,rj->r", columns, np.linalg.inv(system), columns)
    error = ((columns @ free - target) / leverage).reshape(-1, 2)
    weights = start + np.append(free, -free.sum())
    return chosen, weights, float(np.sqrt((error**2).sum(axis=1).mean()))


def main() -> None:
    """Photograph, ask, average, write."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--heads", type=int, default=120)
    parser.add_argument("--sheet", type=Path, help="write a picture of some heads with the net's points")
    arguments = parser.parse_args()
    shown = [show_sitter(seed) for seed in range(FIRST_SITTER, FIRST_SITTER + arguments.heads)]
    faces = [face for face in shown if face is not None]
    generic = load_generic()
    surface, twin = mean_places(generic, faces)
    arrays = (
        named_rules(generic, faces)
        | curve_rules(generic, faces)
        | spreads(generic, faces, surface, twin)
        | profiles(generic)
    )
    arrays |= {"corners": surface.corners, "weights": surface.weights.astype(np.float32)}
    save(OUT, arrays)
    report(arrays, len(faces))
    if arguments.sheet:
        write_sheet(arguments.sheet, faces[:6], surface)


def mean_places(generic: GenericHuman, faces: list[Shown]) -> tuple[SurfacePoints, NDArray[np.int64]]:
    """Return the symmetric mean places of the net's points, and each one's twin on the other side."""
    triangles, mean = Head(generic, splits=0).coarse, generic.vertices_m.astype(np.float64)
    exposed = exposed_triangles(generic, triangles)
    stacked = [places(generic, f.vertices_m, f.camera, f.points_px, triangles, exposed) for f in faces]
    middle = np.median(np.stack(stacked), axis=0)
    twin = np.linalg.norm((middle * [-1.0, 1.0, 1.0])[:, None] - middle[None], axis=2).argmin(axis=1)
    middle = (middle + middle[twin] * [-1.0, 1.0, 1.0]) / 2.0
    surface = nearest_points(middle, mean, triangles[exposed], candidates=40)
    return on_lower_lip(generic, surface, triangles), twin


def on_lower_lip(generic: GenericHuman, surface: SurfacePoints, triangles: NDArray[np.integer]) -> SurfacePoints:
    """Return the net's places with the lower lip's inner border on the lower lip.

    Painted mouths are shut: there the border's places fall on either lip, but it opens with the lower one.
    """
    grid, mean = mouth_grid(), generic.vertices_m.astype(np.float64)
    border, lip = np.array(INNER_LIPS[1][1:-1]), np.zeros(len(mean), dtype=bool)
    lip[grid.rings[grid.margin - 1 :, grid.lower]] = True
    moved = nearest_points(surface.at(mean)[border], mean, triangles[lip[triangles].all(axis=1)], candidates=40)
    corners, weights = surface.corners.copy(), surface.weights.copy()
    corners[border], weights[border] = moved.corners, moved.weights
    return SurfacePoints(corners, weights)


def spreads(
    generic: GenericHuman, faces: list[Shown], surface: SurfacePoints, twin: NDArray[np.int64]
) -> dict[str, NDArray[np.generic]]:
    """Return how far net points lie from their places: each one's spread, joint errors, and what is left alone."""
    nasion = generic.feature("nasion")
    error = np.stack(
        [
            (f.points_px - f.camera.project(surface.at(f.vertices_m))) * f.camera.metres_per_pixel(f.vertices_m[nasion])
            for f in faces
        ]
    )
    drift, alone = joint_errors(np.concatenate([error, error[:, twin] * [-1.0, 1.0]]))
    sigma_m = np.sqrt((error**2).sum(axis=2).mean(axis=0) / 2.0)  # along one axis
    return {
        "sigma_m": sigma_m.astype(np.float32),
        "drift_m": drift.astype(np.float16),
        "alone_m": alone.astype(np.float32),
    }


def named_rules(generic: GenericHuman, faces: list[Shown]) -> dict[str, NDArray[np.generic]]:
    """Return the rules from net points to named points, and where the irises' centres lie from the pupils."""
    names = [f"{n}_{s}" for n in NAMED for s in "LR"] + list(MIDDLE)
    pupils = [generic.feature(f"pupil_{side}") for side in "LR"]
    seen = [f.camera.project(f.vertices_m) for f in faces]
    unit = np.array([np.linalg.norm(np.diff(s[pupils], axis=0)) for s in seen])[:, None, None]
    net = np.stack([f.points_px for f in faces]) / unit
    origin = net.mean(axis=1, keepdims=True)
    rules, errors = np.zeros((len(names), 468)), np.zeros(len(names))
    for row, name in enumerate(names):
        true = np.stack([s[generic.feature(name)] for s in seen])[:, None] / unit
        chosen, weights, errors[row] = named_rule(net - origin, (true - origin)[:, 0], (net - origin).mean(axis=0))
        rules[row, chosen] = weights
    away = np.stack([f.irises_px - s[pupils] for f, s in zip(faces, seen, strict=True)]) / unit
    away[:, 1, 0] *= -1.0  # the right eye mirrors the left
    error = np.sqrt(((away - away.mean(axis=(0, 1))) ** 2).sum(axis=2).mean())
    return {
        "named": np.array(names, dtype=np.str_),
        "rules": rules.astype(np.float32),
        "rule_error_iod": errors.astype(np.float32),
        "iris_offset_iod": away.mean(axis=(0, 1)).astype(np.float32),
        "iris_error_iod": np.array([error], dtype=np.float32),
    }


def curve_rules(generic: GenericHuman, faces: list[Shown]) -> dict[str, NDArray[np.generic]]:
    """Return the rules from net points to the points of the pulled curves."""
    pupils = [generic.feature(f"pupil_{side}") for side in "LR"]
    seen = [f.camera.project(f.vertices_m) for f in faces]
    unit = np.array([np.linalg.norm(np.diff(s[pupils], axis=0)) for s in seen])[:, None, None]
    net = np.stack([f.points_px for f in faces]) / unit
    origin = net.mean(axis=1, keepdims=True)
    out: dict[str, NDArray[np.generic]] = {}
    for name, vertices in face_curves(generic).items():
        rules = np.zeros((len(vertices), 468))
        for row, vertex in enumerate(vertices):
            true = np.stack([s[vertex] for s in seen])[:, None] / unit
            chosen, weights, _ = named_rule(net - origin, (true - origin)[:, 0], (net - origin).mean(axis=0))
            rules[row, chosen] = weights
        out[f"curve_{name}"] = rules.astype(np.float32)
    return out


def profiles(generic: GenericHuman) -> dict[str, NDArray[np.generic]]:
    """Return the joint model of side outlines and named points."""
    curves, named = profile_shapes(generic, np.random.default_rng(SEED), PROFILES)
    mean, modes, rest = joint_model(curves, named, PROFILE_MODES)
    return {
        "profile_mean_m": mean.astype(np.float32),
        "profile_modes_m": modes.astype(np.float32),
        "profile_rest_m": rest.astype(np.float32),
        "profile_names": np.array(PROFILE, dtype=np.str_),
    }


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


def report(arrays: dict[str, NDArray[np.generic]], count: int) -> None:
    """Print what was found."""
    sigma_m = arrays["sigma_m"]
    print(f"{count} heads; net points: median sigma {1e3 * np.median(sigma_m):.2f} mm, worst {1e3 * sigma_m.max():.2f}")
    for name, error in zip(arrays["named"], arrays["rule_error_iod"], strict=True):
        print(f"  {name:16s} {100 * error:5.2f} % of the eye distance")
    print(f"  irises {100 * float(arrays['iris_error_iod'][0]):.2f} %, beside by {100 * arrays['iris_offset_iod']} %")


def write_sheet(path: Path, faces: list[Shown], surface: SurfacePoints) -> None:
    """Draw the net's points (green) and the calibrated places (red) on some heads."""
    import cv2

    tiles = []
    for face in faces:
        tile = face.picture.copy()
        for colour, dots in (
            ((0, 255, 0), face.points_px),
            ((255, 0, 0), face.camera.project(surface.at(face.vertices_m))),
        ):
            for x, y in dots:
                cv2.circle(tile, (round(x), round(y)), 1, colour, -1)
        tiles.append(tile)
    cv2.imwrite(str(path), np.hstack(tiles)[..., ::-1])


if __name__ == "__main__":
    main()
