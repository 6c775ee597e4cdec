"""Paint and photograph random generic heads, so that a face net can be asked where its points lie on them."""

from __future__ import annotations

import itertools
import os

os.environ.setdefault("PYOPENGL_PLATFORM", "egl")

import numpy as np

setattr(np, "infty", np.inf)  # noqa: B010 - pyrender 0.1.45 wants it back under numpy 2
import pyrender  # noqa: E402
import trimesh  # noqa: E402
from numpy.typing import NDArray  # noqa: E402
from scipy.sparse import coo_matrix, csr_matrix, identity  # noqa: E402

from cloner.generic.load import GenericHuman  # noqa: E402
from cloner.geometry.outlines.silhouette import vertex_normals  # noqa: E402
from cloner.records.views import Camera  # noqa: E402

Array = NDArray[np.float64]
WIDTH, HEIGHT = 768, 1024
M_FROM_GL = np.diag([1.0, -1.0, -1.0, 1.0])  # OpenGL looks along -z with y up


def midpoint_subdivision(triangles: NDArray[np.integer], count: int) -> tuple[NDArray[np.int64], csr_matrix]:
    """Return triangles split in four and the (V', V) matrix that places the new vertices."""
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    unique, inverse = np.unique(edges, axis=0, return_inverse=True)
    middle = count + inverse.reshape(3, -1).T
    a, b, c = triangles.T
    ab, bc, ca = middle.T
    fine = np.concatenate([np.stack(t, axis=1) for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
    rows = np.concatenate([np.arange(count), np.repeat(count + np.arange(len(unique)), 2)])
    columns = np.concatenate([np.arange(count), unique.ravel()])
    values = np.concatenate([np.ones(count), np.full(2 * len(unique), 0.5)])
    return fine, csr_matrix(coo_matrix((values, (rows, columns)), shape=(count + len(unique), count)))


class Head:
    """The generic head's triangles, split, with per-vertex masks of brows, lips, lids, irises and hair.

    ``below_m`` and ``aside_m`` say how far the triangles reach below the neck and aside; infinity takes the body too.
    """

    def __init__(self, generic: GenericHuman, *, below_m: float = 0.10, aside_m: float = 0.2, splits: int = 2) -> None:
        vertices = generic.vertices_m.astype(np.float64)
        triangles, _ = generic.triangles()
        keep = (vertices[triangles, 1] > vertices[generic.feature("neck_front_base"), 1] - below_m).all(axis=1)
        lashes = np.isin(generic.vertex_part, [i for i, n in enumerate(generic.part_names) if "lash" in n])
        keep &= ~lashes[triangles].any(axis=1) & (np.abs(vertices[triangles, 0]) < aside_m).all(axis=1)
        self.coarse = triangles[keep]
        self.fine, self.matrix = self.coarse, csr_matrix(identity(len(vertices)))
        for _ in range(splits):
            self.fine, finer = midpoint_subdivision(self.fine, self.matrix.shape[0])
            self.matrix = csr_matrix(finer @ self.matrix)
        self.mean = self.matrix @ vertices
        self.masks = _masks(generic, self.mean, self.matrix)
        corners = {side: [generic.feature(f"eye_{corner}_{side}") for corner in ("inner", "outer")] for side in "LR"}
        self.eyes = {side: (vertices[inner], vertices[outer]) for side, (inner, outer) in corners.items()}
        body = np.eye(len(generic.part_names))[generic.vertex_part][:, generic.part_names.index("body")]
        self.front = (self.matrix @ body > 0.99) & (self.mean[:, 2] > self.eyes["L"][1][2] - 0.02)

    def brows(self, rng: np.random.Generator) -> Array:
        """Return a soft mask (V',) of brows at a random height and slope: they say little about the bone below.

        Their middle lies 19 mm over the eye on average: 16-17 mm on the sample visitors, 25 on a scanned head.
        """
        height, slope, arch, thick = rng.normal([-0.0035, 0.0, 0.0, 0.0028], [0.0045, 0.0025, 0.0018, 0.0005])
        out = np.zeros(len(self.mean))
        for side, sign in (("L", 1.0), ("R", -1.0)):
            inner, outer = self.eyes[side]
            middle = (inner + outer) / 2.0
            brow = np.array(
                [
                    [inner[0] - sign * 0.003, 0.0195 - slope],
                    [middle[0] - sign * 0.004, 0.0225 + arch],
                    [middle[0] + sign * 0.008, 0.0235 + arch],
                    [outer[0] + sign * 0.005, 0.018 + slope],
                ]
            )
            brow[:, 1] += middle[1] + height
            out += self.front * _soft(_to_polyline(self.mean[:, :2], brow), max(thick, 0.0016), 0.0018)
        return out

    def colours(self, rng: np.random.Generator) -> Array:
        """Return (V', 3) random but plausible colours, 0..1."""
        skin = np.array([0.85, 0.65, 0.55]) * rng.uniform(0.45, 1.05) * rng.uniform(0.94, 1.06, 3)
        hair = np.array([0.20, 0.13, 0.09]) * rng.uniform(0.4, 2.2)
        layers = {
            "flush": (skin * [1.0, 0.86, 0.84], rng.uniform(0.3, 0.9)),
            "lips": (skin * [0.9, 0.62, 0.62], rng.uniform(0.6, 1.0)),
            "lids": (skin * 0.35, rng.uniform(0.5, 0.9)),
            "nostrils": (skin * 0.15, 0.9),
            "mouth": (skin * 0.25, 0.9),
            "brows": (hair * 0.8, rng.uniform(0.6, 1.0)),
            "scalp": (hair, 1.0),
            "white": (np.array([0.93, 0.92, 0.91]) * rng.uniform(0.85, 1.0), 1.0),
            "iris": (np.array([0.30, 0.28, 0.22]) * rng.uniform(0.4, 1.5, 3), 1.0),
            "pupil": (np.array([0.02, 0.02, 0.02]), 1.0),
        }
        out = np.tile(skin, (self.matrix.shape[0], 1))
        masks = {**self.masks, "brows": self.brows(rng)}
        for name, (colour, strength) in layers.items():
            share = strength * masks[name][:, None]
            out = (1.0 - share) * out + share * colour
        return np.clip(out, 0.0, 1.0)


def _soft(distance: Array, radius: float, blur: float) -> Array:
    return np.clip((radius + blur - distance) / (2.0 * blur), 0.0, 1.0)


def _to_polyline(points: Array, line: Array) -> Array:
    """Return the distance of (N, D) points to a polyline (M, D)."""
    best = np.full(len(points), np.inf)
    for start, end in itertools.pairwise(line):
        along = end - start
        share = np.clip((points - start) @ along / (along @ along), 0.0, 1.0)
        best = np.minimum(best, np.linalg.norm(points - start - share[:, None] * along, axis=1))
    return best


def _masks(generic: GenericHuman, fine: Array, matrix: csr_matrix) -> dict[str, Array]:
    """Return soft masks (V',) of what is painted, from named points of the mean head (metres)."""
    v = generic.vertices_m.astype(np.float64)
    part = (matrix @ np.eye(len(generic.part_names))[generic.vertex_part]) > 0.99
    body = part[:, generic.part_names.index("body")].astype(np.float64)

    def point(name: str) -> Array:
        return v[generic.feature(name)]

    front = body * (fine[:, 2] > point("eye_outer_L")[2] - 0.02)
    out = {name: np.zeros(len(fine)) for name in ("lids", "white", "iris", "pupil", "nostrils", "flush")}
    for side, part_name in (("L", "eye_left"), ("R", "eye_right")):
        ball = v[generic.part(part_name)]
        centre, radius = (ball.min(0) + ball.max(0)) / 2.0, float(np.ptp(ball[:, 0])) / 2.0
        on_eye = part[:, generic.part_names.index(part_name)].astype(np.float64)
        away = np.hypot(*(fine[:, :2] - centre[:2]).T)
        forward = on_eye * (fine[:, 2] > centre[2])
        out["white"] += on_eye
        out["iris"] += forward * _soft(away, 0.0060, 0.0003)
        out["pupil"] += forward * _soft(away, 0.0021, 0.0003)
        gap = np.abs(np.linalg.norm(fine - centre, axis=1) - radius)
        lid = front * _soft(gap, 0.0012, 0.0012) * (fine[:, 2] > centre[2])
        out["lids"] += lid * np.where(fine[:, 1] > centre[1], 1.0, 0.35)
        sign = 1.0 if side == "L" else -1.0
        # The hollow lies in the height of the wings: at the subnasale's the upper lip would be painted.
        nostril = point("subnasale") + np.array([sign * 0.0082, 0.0075, 0.0010])
        out["nostrils"] += front * _soft(np.linalg.norm(fine - nostril, axis=1), 0.0038, 0.0012)
    lips = generic.region("lips") if "lips" in generic.region_names else _guess_lips(generic, v)
    out["lips"] = np.asarray(matrix @ lips.astype(np.float64)) * body
    out["mouth"] = (
        front
        * _soft(np.abs(fine[:, 1] - point("stomion")[1]), 0.0002, 0.0008)
        * _soft(np.abs(fine[:, 0]), float(point("mouth_corner_L")[0]) - 0.001, 0.001)
    )
    scalp = generic.region("scalp") if "scalp" in generic.region_names else _guess_scalp(generic, v)
    out["scalp"] = np.asarray(matrix @ scalp.astype(np.float64)) * body
    out["flush"] = front * _soft(np.hypot(*(np.abs(fine[:, :2]) - [0.035, point("nose_tip")[1]]).T), 0.012, 0.012)
    return out


def _guess_lips(generic: GenericHuman, v: Array) -> NDArray[np.bool_]:
    top, bottom = v[generic.feature("lip_top")], v[generic.feature("lip_bottom")]
    corner, middle = v[generic.feature("mouth_corner_L")], v[generic.feature("stomion")]
    half = np.where(v[:, 1] > middle[1], top[1] - middle[1], middle[1] - bottom[1]) + 0.001
    inside = (v[:, 0] / corner[0]) ** 2 + ((v[:, 1] - middle[1]) / half) ** 2 < 1.0
    return inside & (v[:, 2] > corner[2] - 0.02)


def _guess_scalp(generic: GenericHuman, v: Array) -> NDArray[np.bool_]:
    top, glabella = v[generic.feature("vertex_top")], v[generic.feature("glabella")]
    line = glabella[1] + 0.05 - np.clip(glabella[2] - 0.03 - v[:, 2], 0.0, 0.16) * 0.8
    return (v[:, 1] > line) & (np.abs(v[:, 0]) < 0.09) & (v[:, 1] <= top[1] + 0.01)


def random_lights(rng: np.random.Generator) -> list[tuple[float, Array]]:
    """Return strength and direction of a main light and a weaker one."""
    return [(rng.uniform(1.5, 3.0), rng.uniform([-1, 0.2, 1], [1, 1.2, 1.6])),
            (rng.uniform(0.4, 1.2), rng.uniform([-1, -0.2, 0.4], [1, 0.6, 1]))]  # fmt: skip


def photograph(
    head: Head,
    vertices_m: Array,
    camera: Camera,
    rng: np.random.Generator,
    *,
    lights: list[tuple[float, Array]] | None = None,
    colours: Array | None = None,
) -> NDArray[np.uint8]:
    """Return a shaded (H, W, 3) picture of the painted head.

    Parameters
    ----------
    lights : list of (strength, direction towards the light), optional
        Random ones when not given.
    colours : (V', 3), optional
        What :meth:`Head.colours` gave, for two photos of one person.
    """
    fine = head.matrix @ vertices_m
    shown = head.colours(rng) if colours is None else colours
    colours = (np.clip(shown, 0, 1) ** 2.2 * 255).astype(np.uint8)
    mesh = trimesh.Trimesh(fine, head.fine, vertex_colors=np.c_[colours, np.full(len(colours), 255)], process=False,
                           vertex_normals=vertex_normals(fine, head.fine))  # fmt: skip
    backdrop = rng.uniform(0.2, 0.8, 3)
    scene = pyrender.Scene(bg_color=[*backdrop, 1.0], ambient_light=[0.28] * 3)
    shape = pyrender.Mesh.from_trimesh(mesh, smooth=True)
    shape.primitives[0].material = pyrender.MetallicRoughnessMaterial(metallicFactor=0.0, roughnessFactor=0.75)
    scene.add(shape)
    eye = np.linalg.inv(M_FROM_GL @ camera.camera_from_model)
    centre = camera.centre_px + 0.5
    scene.add(pyrender.IntrinsicsCamera(camera.focal_px, camera.focal_px, *centre, znear=0.1, zfar=10.0), pose=eye)
    for strength, direction in random_lights(rng) if lights is None else lights:
        place = np.eye(4)
        z = direction / np.linalg.norm(direction)
        x = np.cross([0, 1, 0], z) / np.linalg.norm(np.cross([0, 1, 0], z))
        place[:3, :3] = np.stack([x, np.cross(z, x), z], axis=1)
        scene.add(pyrender.DirectionalLight(intensity=strength), pose=place)
    renderer = pyrender.OffscreenRenderer(camera.width_px, camera.height_px)
    picture, _ = renderer.render(scene)
    renderer.delete()
    noise = rng.normal(0.0, 2.0, picture.shape)
    return np.clip(picture + noise, 0, 255).astype(np.uint8)
