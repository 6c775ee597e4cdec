"""Small portraits of random heads by a painter of its own, to teach where small features lie.

``painted_faces`` dresses whole people, which takes seconds each; this paints heads alone, in a tenth of a second, with
what photographs of skin have and those lack: soft shade in hollows, soft shadows, blotches, stubble, cropped or full
hair with a ragged edge, ears of many sizes and slants. ``python generic_models/build/painted_portraits.py OUT`` writes
some to look at. Nobody of them lives.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from painted_faces_extras import spectacled
from painted_people_bodies import waves
from painted_people_pictures import rendered
from painted_skin import marked, packed
from portrait_canvas import Canvas, canvas, hidden_from, scan_canvas
from profile_shapes import random_face
from scan_heads import laid_generic, read_family, twin_vertices
from scipy.spatial import cKDTree

from cloner.generic.load import load_generic
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.head.ears import ear_modes
from cloner.head.modes import bent_shapes
from cloner.records.views import Camera

Array = NDArray[np.float64]
Picture = NDArray[np.float32]

SIZE_PX: Final = (432, 528)
#: Eye distance of the portraits, px, and its spread, logarithmic.
IOD_PX: Final = 96.0
SIZE_SPREAD: Final = 0.05
#: Turn about the vertical and nod, degrees; roll; distances, metres.
TURN_DEG: Final = 15.0
ROLL_DEG: Final = 6.0
DISTANCE_M: Final = (0.6, 2.0)
#: Standard deviations of the ears' moves, and bends of their rims: root mean square and wave lengths, metres.
EAR_VARIETY: Final = 1.8
EAR_BENDS_M, EAR_WAVES_M = 0.0012, (0.012, 0.05)
#: Marks farther than this behind what is seen are hidden, metres.
HIDDEN_M: Final = 0.005
GLASSES, STUBBLE, CROPPED = 0.15, 0.35, 0.35
_GAMMA: Final = 2.2


@dataclass(frozen=True, slots=True, eq=False)
class Portrait:
    """One portrait and what is true of it.

    Attributes
    ----------
    rgb : (H, W, 3) uint8
    mask : (H, W) uint8
        The person, 0..255.
    marks_px : mapping of str to (2,) float64
        All features of the face that lie in the picture.
    hidden : frozenset of str
        Those that hair or the head itself hides.
    vertices_px : (V, 2) float64
        All vertices of the generic human, without hair.
    iod_px : float
    tilt : float
        Clockwise turn of the head in the picture, radians.
    """

    rgb: NDArray[np.uint8]
    mask: NDArray[np.uint8]
    marks_px: Mapping[str, Array]
    hidden: frozenset[str]
    vertices_px: Array
    iod_px: float
    tilt: float


def random_head(rng: np.random.Generator) -> Array:
    """Return the vertices of a random head within and beyond the generic's family, with ears of many kinds."""
    generic = load_generic()
    vertices = random_face(generic, rng)
    mean, basis = bent_shapes()
    rows = generic.head_vertices
    vertices[rows] += mean + np.tensordot(0.8 * rng.normal(size=len(basis)), basis, axes=1)
    fields = ear_modes(generic)
    vertices[rows] += np.tensordot(EAR_VARIETY * rng.normal(size=len(fields)), fields, axes=1)
    bent = np.stack([waves(vertices[rows], EAR_WAVES_M, 12, rng) for _ in range(3)], axis=1)
    share = (generic.region("ear_left") | generic.region("ear_right"))[rows]
    vertices[rows] += EAR_BENDS_M * share[:, None] * bent
    return vertices


def portrait(seed: int, azimuth_deg: float, scans: Path | None = None) -> Portrait:
    """Return one random portrait; azimuth 0 shows the front, 90 the person's left, -90 the right.

    ``scans`` is the file of the scan-based family when the head is to be one of it.
    """
    rng = np.random.default_rng([seed, 31])
    if scans is None:
        shared, naked = canvas(), random_head(rng)
        skin = np.asarray(shared.head.matrix @ naked)
    else:
        shared, family = scan_canvas(scans), read_family(scans)
        head = family.head(np.random.default_rng([seed, 68]).normal(size=len(family.modes_m)))
        naked = twin_vertices(laid_generic(scans), head)
        skin = np.asarray(shared.head.matrix @ head)
    return _taken(shared, naked, skin, azimuth_deg, rng)


def _taken(shared: Canvas, naked: Array, skin: Array, azimuth_deg: float, rng: np.random.Generator) -> Portrait:
    """Return a portrait of a head: ``naked`` (V, 3) are the generic's vertices on it, ``skin`` (V', 3) the canvas'."""
    normals = vertex_normals(skin, shared.head.fine)
    camera, tilt = _camera(shared, naked, azimuth_deg, rng)
    hair = _hair(shared, rng)
    long = 0.0 if rng.random() < CROPPED else rng.uniform(0.003, 0.03)
    rough = 1.0 + 0.3 * waves(shared.head.mean, (0.01, 0.04), 16, rng)
    worn = skin + (long * np.clip(shared.hair_m / 0.02, 0.0, 1.0) * hair * rough)[:, None] * normals
    colours = _painted(shared, hair, rng)
    lit = _lit(worn, vertex_normals(worn, shared.head.fine), colours, shared.shade, camera, rng)
    person = rendered(worn, shared.head.fine, lit, camera)
    picture = _developed(person, rng)
    if rng.random() < GLASSES:
        picture = spectacled(picture, naked, camera, int(-np.sign(azimuth_deg)), rng)
    marks = camera.project(naked[list(shared.rows.values())])
    inside = ((marks > 1.0) & (marks < np.array(SIZE_PX) - 2.0)).all(axis=1)
    left, right = (naked[shared.rows[f"pupil_{side}"]] for side in "LR")
    iod = float(np.linalg.norm(left - right)) / camera.metres_per_pixel((left + right) / 2.0)
    known = {name: marks[k] for k, name in enumerate(shared.rows) if inside[k]}
    mask, hidden = segmented(person[..., 3], rng), _hidden(shared, naked, worn, camera)
    return Portrait(packed(picture, rng), mask, known, hidden, camera.project(naked), iod, tilt)


def _camera(shared: Canvas, naked: Array, azimuth_deg: float, rng: np.random.Generator) -> tuple[Camera, float]:
    """Return a camera on the head, turned, nodded and rolled a little, and its clockwise roll of the head."""
    rows = shared.rows
    target = naked[[rows[name] for name in ("nasion", "chin_bottom", "ear_top_L", "ear_top_R")]].mean(axis=0)
    target = target + rng.uniform(-0.015, 0.015, 3)
    away = float(np.exp(rng.uniform(*np.log(DISTANCE_M))))
    yaw, pitch = np.radians([azimuth_deg, 0.0] + rng.uniform(-TURN_DEG, TURN_DEG, 2) * [1.0, 0.6])
    out = np.array([np.sin(yaw) * np.cos(pitch), np.sin(pitch), np.cos(yaw) * np.cos(pitch)])
    right = np.cross(-out, [0.0, 1.0, 0.0])
    right /= np.linalg.norm(right)
    level = np.stack([right, np.cross(-out, right), -out])
    roll = np.radians(ROLL_DEG) * rng.normal()
    matrix = np.eye(4)
    matrix[:3, :3] = cv2.Rodrigues(np.array([0.0, 0.0, roll]))[0] @ level
    matrix[:3, 3] = -matrix[:3, :3] @ (target + away * out)
    focal = IOD_PX * np.exp(SIZE_SPREAD * rng.normal()) / 0.063 * away
    return Camera(*SIZE_PX, float(focal), matrix), float(roll)


def _hair(shared: Canvas, rng: np.random.Generator) -> Array:
    """Return (V',) 0..1 where hair grows: the mean hairline moved up or down, ragged; not on ears, not on the bald."""
    if rng.random() < 0.12:
        return np.zeros(len(shared.hair_m))
    edge = shared.hair_m + rng.normal(0.0, 0.007) + 0.004 * waves(shared.head.mean, (0.01, 0.06), 16, rng)
    return np.asarray(np.clip(0.5 + edge / 0.004, 0.0, 1.0) * (1.0 - shared.ears))


def _painted(shared: Canvas, hair: Array, rng: np.random.Generator) -> Array:
    """Return (V', 3) colours 0..1: blotched skin, hair by strands, perhaps stubble or a beard."""
    mean = shared.head.mean
    colours = shared.head.colours(rng)
    skin = np.median(colours[shared.beard > 0.5], axis=0)
    bare = shared.head.masks["scalp"][:, None]
    colours = (1.0 - bare) * colours + bare * skin
    blotch = rng.uniform(0.01, 0.05) * waves(mean, (0.006, 0.04), 24, rng)[:, None] * [0.6, 1.0, 1.0]
    lips = rng.uniform(0.4, 1.0) * np.clip(2.0 - shared.corner_m / rng.uniform(0.001, 0.003), 0.0, 1.0)[:, None]
    colours += lips * (colours[shared.lips].mean(axis=0) * rng.uniform(0.6, 1.0) - colours)
    red = rng.uniform(0.0, 0.12) * shared.ears[:, None] * np.array([0.3, -1.0, -1.0])
    colours = colours * (1.0 + blotch + red)
    colours = marked(shared.head, colours, shared.lips, rng)
    tone = np.array([0.26, 0.17, 0.11]) * rng.uniform(0.3, 1.6) + rng.choice([0.0, 0.0, 0.35]) * rng.random()
    strands = 1.0 + rng.uniform(0.05, 0.3) * waves(mean * [1.0, 0.35, 1.0], (0.004, 0.015), 32, rng)
    if rng.random() < STUBBLE:
        grown = rng.uniform(0.15, 0.95) * shared.beard * (0.8 + 0.2 * waves(mean, (0.004, 0.02), 24, rng))
        colours += np.clip(grown, 0.0, 1.0)[:, None] * (0.8 * tone - colours)
    share = hair[:, None]
    return np.clip((1.0 - share) * colours + share * tone * strands[:, None], 0.01, 1.0)


def _lit(worn: Array, normals: Array, colours: Array, shade: Array, camera: Camera, rng: np.random.Generator) -> Array:
    """Return (V', 3) sRGB colours under a soft room and two lamps with soft shadows, the skin shining a little."""
    to_model = camera.camera_from_model[:3, :3].T
    openness = np.clip(1.0 - shade, 0.02, 0.6) / 0.5
    hollow = openness ** rng.uniform(0.7, 1.5)
    light = rng.uniform(0.2, 0.6) * hollow * (0.85 + 0.25 * normals[:, 1])
    shine = np.zeros(len(worn))
    for strength in (rng.uniform(0.2, 0.9), rng.uniform(0.0, 0.4)):
        way = to_model @ np.array([rng.normal(0.0, 1.0), rng.normal(-0.6, 0.5), -1.0])
        way /= np.linalg.norm(way)
        soft = [hidden_from(worn, normals, way + rng.normal(0.0, 0.12, 3)) for _ in range(3)]
        light += strength * np.clip((normals @ way + 0.15) / 1.15, 0.0, 1.0) * (1.0 - 0.85 * np.mean(soft, axis=0))
        half = way - to_model @ np.array([0.0, 0.0, 1.0])
        shine += strength * np.clip(normals @ (half / np.linalg.norm(half)), 0.0, 1.0) ** 20
    warm = 1.0 + rng.uniform(-0.08, 0.08) * np.array([1.0, 0.0, -1.0])
    linear = colours**_GAMMA * light[:, None] * warm + rng.uniform(0.0, 0.08) * (shine * hollow)[:, None]
    return np.asarray(np.clip(linear * rng.uniform(0.9, 1.7), 0.0, 1.0) ** (1.0 / _GAMMA))


def _developed(person: Picture, rng: np.random.Generator) -> NDArray[np.uint8]:
    """Return the photograph: the person before a wall with edges on it, grained, blurred and toned as cameras do."""
    height, width = person.shape[:2]
    wall = np.empty((height, width, 3), np.float32)
    wall[:] = np.clip(rng.uniform(0.05, 0.95) + rng.normal(0.0, 0.06, 3), 0.0, 1.0)
    for _ in range(int(rng.integers(0, 7))):
        corner, size = rng.uniform(-0.2, 1.0, 2) * [width, height], rng.uniform(0.05, 0.7, 2) * [width, height]
        ends = [np.round(place).astype(int).tolist() for place in (corner, corner + size)]
        cv2.rectangle(wall, *ends, rng.uniform(0.0, 1.0, 3).tolist(), -1)
    wall = cv2.GaussianBlur(wall, (0, 0), float(np.exp(rng.uniform(np.log(0.5), np.log(6.0)))))
    grain = cv2.GaussianBlur(rng.standard_normal((height, width), dtype=np.float32), (0, 0), rng.uniform(0.6, 1.8))
    picture = person[..., :3] * (1.0 + rng.uniform(0.0, 0.16) * grain[..., None]) + (1.0 - person[..., 3:]) * wall
    picture = cv2.GaussianBlur(picture, (0, 0), rng.uniform(0.4, 1.3))
    picture = np.clip(picture, 0.0, 1.0) ** rng.uniform(0.75, 1.3) * rng.uniform(0.75, 1.1) + rng.uniform(0.0, 0.06)
    noise = rng.uniform(0.5, 4.0) * rng.standard_normal(picture.shape, dtype=np.float32)
    return np.clip(255.0 * picture + noise + 0.5, 0.0, 255.0).astype(np.uint8)


def segmented(person: Picture, rng: np.random.Generator) -> NDArray[np.uint8]:
    """Return a person's share (H, W), 0..1, as a segmentation gives it, 0..255: with a soft edge a little off."""
    height, width = person.shape
    away = cv2.resize(rng.standard_normal((7, 6), dtype=np.float32), (width, height), interpolation=cv2.INTER_CUBIC)
    soft = cv2.GaussianBlur(person, (0, 0), 2.0) + np.float32(rng.uniform(0.0, 0.2)) * away
    return np.asarray(np.clip(255.0 * (0.5 + (soft - 0.5) * 2.0), 0.0, 255.0), np.uint8)


def _hidden(shared: Canvas, naked: Array, worn: Array, camera: Camera) -> frozenset[str]:
    """Return the marks before which something else is seen."""
    seen, depth = camera.project(worn), camera.to_camera(worn)[:, 2]
    tree = cKDTree(seen)
    out = set()
    for name, row in shared.rows.items():
        place = naked[[row]]
        near = tree.query_ball_point(camera.project(place)[0], 0.05 * IOD_PX)
        if near and float(depth[near].min()) < float(camera.to_camera(place)[0, 2]) - HIDDEN_M:
            out.add(name)
    return frozenset(out)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path)
    parser.add_argument("--heads", type=int, default=8)
    parser.add_argument("--scans", type=Path, help="the scan-based family's file, to paint its heads instead")
    chosen = parser.parse_args()
    chosen.out.mkdir(parents=True, exist_ok=True)
    for seed in range(chosen.heads):
        shown = []
        for azimuth in (0.0, 90.0 if seed % 2 else -90.0):
            found = portrait(seed, azimuth, chosen.scans)
            drawn = found.rgb.copy()
            for name, place in found.marks_px.items():
                colour = (255, 0, 0) if name in found.hidden else (0, 255, 0)
                cv2.circle(drawn, np.round(place).astype(int).tolist(), 2, colour, -1)
            shown += [found.rgb, drawn]
        cv2.imwrite(str(chosen.out / f"{seed}.png"), np.hstack(shown)[..., ::-1])


if __name__ == "__main__":
    main()
