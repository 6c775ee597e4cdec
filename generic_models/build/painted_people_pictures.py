"""Rooms, cameras, light and photographs for dressed random people."""

from __future__ import annotations

import functools
import os
from dataclasses import replace

os.environ.setdefault("PYOPENGL_PLATFORM", "egl")

from typing import Any, Final, Literal

import cv2
import numpy as np

setattr(np, "infty", np.inf)  # noqa: B010 - pyrender 0.1.45 wants it back under numpy 2
import pyrender  # noqa: E402
from numpy.typing import NDArray  # noqa: E402

from cloner.frames import focal_px_from_35mm  # noqa: E402
from cloner.records.views import Camera  # noqa: E402

Array = NDArray[np.float64]
Image = NDArray[np.uint8]
Picture = NDArray[np.float32]
Background = Literal["plain", "cluttered", "low_contrast"]

BACKGROUNDS: Final[tuple[Background, ...]] = ("plain", "cluttered", "low_contrast")
#: 35-mm-equivalent focal lengths, distances and heights of body cameras, and the share of the photo a person fills.
FOCAL_35MM: Final = (45.0, 75.0)
DISTANCE_M: Final = (2.5, 4.5)
CAMERA_HEIGHT_M: Final = (0.9, 1.6)
FILL: Final = (0.74, 0.90)
MARGIN: Final = 0.015  # of the photo that stays empty around a person
TILT_DEG: Final = (1.0, 1.5)  # aim and roll, spread
M_FROM_GL: Final = np.diag([1.0, -1.0, -1.0, 1.0])  # OpenGL looks along -z with y up
_GAMMA: Final = 2.2


def random_camera(
    azimuth_deg: float, bottom_top_m: tuple[float, float], size_px: tuple[int, int], rng: np.random.Generator
) -> tuple[Camera, float]:
    """Return a camera that sees the whole person, and its 35-mm-equivalent focal length.

    Parameters
    ----------
    azimuth_deg : float
        Direction of the camera around the person: 0 front, +90 the person's left.
    bottom_top_m : (2,) heights of the floor and the highest point, model frame
    size_px : (width, height)
    """
    width, height = size_px
    bottom, top = bottom_top_m
    focal_mm = float(rng.uniform(*FOCAL_35MM))
    focal = focal_px_from_35mm(focal_mm, width, height)
    distance = float(np.clip(focal * (top - bottom) / (rng.uniform(*FILL) * height), *DISTANCE_M))
    focal = min(focal, 0.93 * height * distance / (top - bottom))  # a tall person stands nearer the frame's end
    focal_mm *= focal / focal_px_from_35mm(focal_mm, width, height)
    turn = np.radians(azimuth_deg)
    out = np.array([np.sin(turn), 0.0, np.cos(turn)])
    eye = distance * out + [0.0, bottom + rng.uniform(*CAMERA_HEIGHT_M), 0.0]
    forward = np.array([0.0, (bottom + top) / 2.0, 0.0]) - eye
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, [0.0, 1.0, 0.0])
    right /= np.linalg.norm(right)
    level = np.stack([right, np.cross(forward, right), forward])
    spare = 0.5 * (1.0 - focal * (top - bottom) / distance / height) * height / focal  # so that nothing is cut off
    yaw, pitch = np.clip(rng.normal(0.0, np.radians(TILT_DEG[0]), 2), -0.6 * spare, 0.6 * spare)
    roll = rng.normal(0.0, np.radians(TILT_DEG[1]))
    tilt = cv2.Rodrigues(np.array([pitch, yaw, 0.0]))[0] @ cv2.Rodrigues(np.array([0.0, 0.0, roll]))[0]
    rotation = tilt @ level
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, -rotation @ eye
    return Camera(width, height, focal, matrix), focal_mm


def framed(camera: Camera, focal_35mm: float, vertices_m: Array) -> tuple[Camera, float]:
    """Return the camera zoomed out until nothing of a person is cut off, and its 35-mm-equivalent focal length."""
    away = np.abs(camera.project(vertices_m) - camera.centre_px).max(axis=0) / (camera.centre_px * (1.0 - MARGIN))
    shrink = 1.0 / max(1.0, float(away.max()))
    return replace(camera, focal_px=camera.focal_px * shrink), focal_35mm * shrink


def lit(vertices_m: Array, normals: Array, colours: Array, camera: Camera, rng: np.random.Generator) -> Array:
    """Return (N, 3) sRGB colours 0..1 under soft light with one shadow; the lights stand beside the camera."""
    linear = colours**_GAMMA
    to_model = camera.camera_from_model[:3, :3].T
    key = to_model @ _unit(np.array([rng.choice([-1, 1]) * rng.uniform(0.3, 1.1), -rng.uniform(0.4, 1.3), -1.0]))
    fill = to_model @ _unit(np.array([rng.uniform(-1, 1), rng.uniform(-0.6, 0.2), -1.0]))
    hard = rng.uniform(0.35, 0.8)
    shade = 1.0 - 0.75 * in_shadow(vertices_m, key)
    light = 0.30 * (0.8 + 0.2 * normals[:, 1]) + hard * np.clip(normals @ key, 0, 1) * shade
    light += rng.uniform(0.2, 0.4) * np.clip(0.25 + 0.75 * (normals @ fill), 0, 1)
    warm = 1.0 + rng.uniform(-0.06, 0.06) * np.array([1.0, 0.0, -1.0])
    return np.clip(linear * light[:, None] * warm * rng.uniform(0.95, 1.3), 0.0, 1.0) ** (1 / _GAMMA)


def in_shadow(vertices_m: Array, towards: Array, cell_m: float = 0.012) -> Array:
    """Return (N,) 0..1 how much of a vertex's surroundings other vertices hide from a far light."""
    across = _unit(np.cross(towards, [0.0, 1.0, 0.0] if abs(towards[1]) < 0.9 else [1.0, 0.0, 0.0]))
    plane = np.stack([across, np.cross(towards, across)], axis=1)
    cells = np.floor(vertices_m @ plane / cell_m).astype(int)
    cells -= cells.min(axis=0) - 1
    depth = vertices_m @ towards
    nearest = np.full(cells.max(axis=0) + 2, -np.inf)
    np.maximum.at(nearest, tuple(cells.T), depth)
    hidden = np.zeros(len(depth))
    for step in np.array([[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]]):
        hidden += nearest[tuple((cells + step).T)] > depth + 0.03
    return np.asarray(hidden / 5.0)


def rendered(vertices_m: Array, triangles: NDArray[np.integer], colours: Array, camera: Camera) -> Picture:
    """Return the (H, W, 4) picture 0..1 of coloured triangles; alpha is coverage, colours are multiplied by it."""
    rgba = np.c_[colours, np.ones(len(colours))].astype(np.float32)
    material = pyrender.MetallicRoughnessMaterial(metallicFactor=0.0, roughnessFactor=1.0, doubleSided=True)
    primitive = pyrender.Primitive(
        positions=vertices_m.astype(np.float32), indices=triangles, color_0=rgba, material=material, mode=4
    )
    scene = pyrender.Scene(bg_color=[0.0, 0.0, 0.0, 0.0])
    scene.add(pyrender.Mesh([primitive]))
    eye = np.linalg.inv(M_FROM_GL @ camera.camera_from_model)
    centre = camera.centre_px + 0.5
    scene.add(pyrender.IntrinsicsCamera(camera.focal_px, camera.focal_px, *centre, znear=0.1, zfar=20.0), pose=eye)
    renderer = _renderer()
    renderer.viewport_width, renderer.viewport_height = camera.width_px, camera.height_px
    picture, _ = renderer.render(scene, flags=pyrender.RenderFlags.FLAT | pyrender.RenderFlags.RGBA)
    return np.asarray(picture, dtype=np.float32) / np.float32(255.0)


@functools.cache
def _renderer() -> Any:
    """Return the process's one renderer: a GL context is dear to make."""
    return pyrender.OffscreenRenderer(16, 16)


def developed(person: Picture, behind: Picture, rng: np.random.Generator) -> Image:
    """Return the photograph: person before room, then a lens's blur, a sensor's noise and JPEG's softness."""
    picture = person[..., :3] + (1.0 - person[..., 3:]) * behind
    picture *= (rng.uniform(0.88, 1.08) * (1.0 + rng.normal(0.0, 0.015, 3))).astype(np.float32)
    picture = cv2.GaussianBlur(picture, (0, 0), rng.uniform(0.45, 0.85))
    noise = rng.standard_normal(picture.shape[:2], dtype=np.float32) * np.float32(rng.uniform(1.0, 3.5))
    image = np.clip(np.float32(255.0) * picture + noise[..., None] + np.float32(0.5), 0, 255).astype(np.uint8)
    _, data = cv2.imencode(".jpg", image[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, int(rng.integers(84, 94))])
    return np.ascontiguousarray(np.asarray(cv2.imdecode(data, cv2.IMREAD_COLOR), dtype=np.uint8)[..., ::-1])


def room(
    kind: Background, camera: Camera, floor_m: float, cloth: Array, person: Picture, rng: np.random.Generator
) -> Picture:
    """Return the (H, W, 3) room 0..1 behind a person: wall, floor with his shadow, and what stands about.

    Parameters
    ----------
    cloth : (3,) sRGB 0..1
        What the clothes look like in this light; a room of low contrast has their colour.
    person : (H, W, 4)
        The rendered person, for the shadow on wall and floor.
    """
    height, width = camera.height_px, camera.width_px
    wall = np.clip(rng.uniform(0.25, 0.9) + rng.normal(0.0, 0.05, 3), 0.05, 0.95)
    ground = np.clip(rng.uniform(0.2, 0.7) + rng.normal(0.0, 0.05, 3), 0.05, 0.95)
    if kind == "low_contrast":
        wall = np.clip(cloth + rng.normal(0.0, 0.025, 3), 0.02, 0.98)
        ground = np.clip(cloth * rng.uniform(0.7, 1.1) + rng.normal(0.0, 0.03, 3), 0.02, 0.98)
    picture = np.empty((height, width, 3), np.float32)
    picture[:] = wall
    if kind == "cluttered":
        _furnish(picture, rng)
    border = _floor_line(camera, floor_m, rng.uniform(0.5, 1.6))
    below = np.zeros((height, width), np.uint8)
    cv2.fillPoly(
        below, [np.round(np.vstack([border, [[width + 9, height + 9], [-9, height + 9]]])).astype(np.int32)], 255
    )
    grain = cv2.resize(rng.standard_normal((height // 3, width // 3), dtype=np.float32), (width, height))
    rows = below > 0
    picture[rows] = ground.astype(np.float32) + np.float32(0.035) * grain[rows][:, None]
    if rng.random() < 0.5:
        line = tuple(float(value) for value in np.clip(wall * rng.uniform(0.6, 1.2), 0, 1))
        cv2.polylines(picture, [np.round(border).astype(np.int32)], False, line, int(rng.integers(2, 30)))
    lamp = rng.uniform([0, 0], [1.0, 0.6])
    across, down = (np.exp(-(((np.arange(n) / n - at) / 0.8) ** 2)) for n, at in ((width, lamp[0]), (height, lamp[1])))
    light = (0.86 + 0.2 * down[:, None] * across).astype(np.float32) * (1.0 - _shadow(person, rng))
    return np.asarray(np.clip(picture * light[..., None], 0.0, 1.0), dtype=np.float32)


def _floor_line(camera: Camera, floor_m: float, behind_m: float) -> Array:
    """Return the two pixels, left and right, of the line where wall and floor meet."""
    away = camera.camera_from_model[2, :3] * [1.0, 0.0, 1.0]
    away /= np.linalg.norm(away)
    across = np.cross([0.0, 1.0, 0.0], away)
    ends = behind_m * away + np.array([0.0, floor_m, 0.0]) + np.array([[-2.5], [2.5]]) * across
    pixels = camera.project(ends)
    return np.asarray(pixels[np.argsort(pixels[:, 0])])


def _shadow(person: Picture, rng: np.random.Generator) -> Picture:
    """Return (H, W) how much darker wall and floor are around the person: at the feet, and beside him on the wall."""
    height, width = person.shape[:2]
    cover = cv2.resize(person[..., 3], (width // 4, height // 4), interpolation=cv2.INTER_AREA)
    rows = np.flatnonzero(cover.max(axis=1) > 0.5)
    feet = cover.copy()
    feet[: rows[-1] - int(0.05 * len(rows))] = 0.0
    pool = cv2.GaussianBlur(feet, (0, 0), sigmaX=0.016 * len(cover), sigmaY=0.005 * len(cover))
    shift = np.array([[1, 0, rng.uniform(-0.03, 0.03) * width], [0, 1, rng.uniform(0.0, 0.0075) * height]])
    moved = cv2.warpAffine(cover, shift, cover.shape[::-1])
    moved = cv2.GaussianBlur(moved, (0, 0), rng.uniform(0.01, 0.04) * cover.shape[1])
    dark = np.clip(0.9 * pool + rng.uniform(0.0, 0.35) * moved, 0.0, 0.6)
    return np.asarray(cv2.resize(dark, (width, height)), dtype=np.float32)


def _furnish(picture: NDArray[np.float32], rng: np.random.Generator) -> None:
    """Draw panels, posters, shelves, lines, text and plants on a wall, in place."""
    height, width = picture.shape[:2]

    def colour() -> tuple[float, ...]:
        return tuple(float(value) for value in np.clip(rng.uniform(0.05, 0.95) + rng.normal(0, 0.22, 3), 0.02, 0.98))

    def box(low: float, high: float) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        size = rng.uniform(low, high, 2) * width
        corner = rng.uniform([-0.1 * width, 0.0], [width, 0.85 * height])
        return corner.astype(int), (corner + size).astype(int)

    edge = 0
    while edge < width and rng.random() < 0.8:  # tall panels
        end = edge + int(rng.uniform(0.15, 0.5) * width)
        cv2.rectangle(picture, (edge, 0), (end, height), colour(), -1)
        edge = end + int(rng.uniform(0, 0.05) * width)
    for _ in range(rng.integers(3, 8)):  # posters
        first, last = box(0.12, 0.5)
        cv2.rectangle(picture, first.tolist(), last.tolist(), colour(), -1)
        inside = picture[max(first[1], 0) : max(last[1], 0), max(first[0], 0) : max(last[0], 0)]
        if inside.size and rng.random() < 0.6:
            ramp = np.linspace(-0.2, 0.2, inside.shape[0], dtype=np.float32)[:, None, None]
            inside += ramp
        for _ in range(rng.integers(0, 5)):
            place = rng.uniform(first, last).astype(int).tolist()
            cv2.circle(picture, place, int(rng.uniform(0.01, 0.07) * width), colour(), -1 if rng.random() < 0.7 else 6)
        ink = colour()
        for row in (
            range(int(first[1] + 20), int(last[1] - 10), int(rng.integers(24, 60))) if rng.random() < 0.5 else ()
        ):
            cv2.line(picture, (int(first[0] + 15), row), (int(last[0] - rng.uniform(15, 60)), row), ink, 6)
    for _ in range(rng.integers(2, 7)):  # poles, cables, shelves
        ends = rng.uniform([0, 0], [width, height], (2, 2))
        ends[1, rng.integers(2)] = ends[0, rng.integers(2)]
        cv2.line(
            picture, ends[0].astype(int).tolist(), ends[1].astype(int).tolist(), colour(), int(rng.integers(3, 26))
        )
    for _ in range(rng.integers(0, 3)):  # leaves
        root, green = rng.uniform([0, 0.4 * height], [width, height]), (0.1, rng.uniform(0.25, 0.5), 0.12)
        for _ in range(25):
            tip = root + rng.normal(0.0, [0.08 * width, 0.1 * height])
            side = 0.15 * (tip - root)[::-1] * [1, -1]
            leaf = np.array([root, (root + tip) / 2 + side, tip, (root + tip) / 2 - side])
            cv2.fillPoly(picture, [leaf.astype(np.int32)], green)
    np.clip(picture, 0.02, 0.98, out=picture)


def _unit(vector: Array) -> Array:
    return np.asarray(vector / np.linalg.norm(vector))
