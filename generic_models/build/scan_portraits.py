"""Face photographs of random heads of a scan-based family (``scan_heads.py``), painted as the benchmark's own are.

Skin, brows, lips, lids and nostrils are taken over from the painter of generic heads through the laid generic; hair is
a coloured cap of some thickness or none; a plain shirt hides the bust's cut. Nobody of them lives.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from painted_faces import LIGHTS, SIZE_PX, Light, _lit, _portrait_camera
from painted_heads import Head, midpoint_subdivision
from painted_people_pictures import BACKGROUNDS, Background, developed, rendered, room
from scan_heads import EYES, SKIN, laid_generic, read_family, twin_vertices
from scipy.sparse import csr_matrix
from scipy.spatial import cKDTree

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.records.views import Camera

Array = NDArray[np.float64]

#: Radii of iris and pupil, metres, and how soft their rims are.
IRIS_M, PUPIL_M, RIM_M = 0.0060, 0.0021, 0.0003
#: Skin below this is shirt, metres over the family's origin; the shirt stands so far off the generic's bust.
COLLAR_M, SHIRT_M = -0.135, 0.006
#: Chances and thickness of hair, metres: none, cropped, thick.
HAIR: Final = ((0.3, (0.0, 0.0)), (0.35, (0.001, 0.006)), (0.35, (0.008, 0.024)))
#: Photos are exposed for the face: this power of what the lamps alone give (taste).
EXPOSED: Final = 0.8
#: Spread of head coefficients: the family's own.
SPREAD: Final = 1.0


class ScanHead(Head):
    """The family's triangles, split, with the generic painter's masks."""

    def __init__(self, path: Path) -> None:
        family, laid, generic = read_family(path), laid_generic(path), load_generic()
        own = Head(generic, below_m=0.22, aside_m=0.3, splits=1)
        self.eyes = own.eyes
        self.coarse = family.triangles
        self.fine, matrix = midpoint_subdivision(family.triangles, len(family.mean_m))
        self.matrix = csr_matrix(matrix)
        shape = self.matrix @ family.mean_m
        body = np.eye(len(generic.part_names))[generic.vertex_part][:, generic.part_names.index("body")]
        rows = np.flatnonzero((own.matrix @ body > 0.99) & (own.matrix @ generic.head_blend > 0.02))
        _, near = cKDTree((own.matrix @ laid.vertices_m)[rows]).query(shape)
        near = rows[near]
        used = np.zeros(len(shape), dtype=bool)
        used[self.fine.ravel()] = True
        skin = np.asarray(self.matrix[:, :SKIN].sum(axis=1)).ravel() > 0.99
        self.mean = own.mean[near]
        self.front = own.front[near] & skin
        self.masks = {name: np.where(skin, mask[near], 0.0) for name, mask in own.masks.items()}
        for low, high in EYES.values():
            self._paint_eye(shape, family.mean_m[low:high], np.asarray(self.matrix[:, low:high].sum(axis=1)).ravel())
        self.skin, self.shape = skin, shape

    def bald_colours(self, rng: np.random.Generator) -> Array:
        """Return (V', 3) colours of a head without hair but brows."""
        hair = self.masks["scalp"]
        self.masks["scalp"] = np.zeros_like(hair)
        try:
            return self.colours(rng)
        finally:
            self.masks["scalp"] = hair

    def _paint_eye(self, shape: Array, ball: Array, on: Array) -> None:
        """Add white, iris and pupil of one eyeball, which looks straight on."""
        centre = (ball.min(axis=0) + ball.max(axis=0)) / 2.0
        away = np.hypot(*(shape[:, :2] - centre[:2]).T)
        whole = (on > 0.99).astype(np.float64)
        forward = whole * (shape[:, 2] > centre[2])
        self.masks["white"] = self.masks["white"] + whole
        for name, radius in (("iris", IRIS_M), ("pupil", PUPIL_M)):
            self.masks[name] = self.masks[name] + forward * np.clip((radius + RIM_M - away) / (2.0 * RIM_M), 0.0, 1.0)


@functools.cache
def scan_head(path: Path) -> ScanHead:
    """Return the paintable head, made once a process (4 s)."""
    return ScanHead(path)


@dataclass(frozen=True, slots=True, eq=False)
class ScanSitter:
    """One random head and its looks.

    Attributes
    ----------
    head_m : (N, 3) float64
        The family's vertices, metres: what is true.
    twin_m : (V, 3) float64
        The generic's vertices laid on it.
    worn_m, triangles, colours
        What is drawn: hair and shirt too; colours sRGB 0..1.
    hair_m : float
    """

    head_m: Array
    twin_m: Array
    worn_m: Array
    triangles: NDArray[np.int64]
    colours: Array
    hair_m: float

    @property
    def naked_m(self) -> Array:
        """The generic's vertices, by the name that painted people have them."""
        return self.twin_m


def scan_sitter(path: Path, seed: int, scale: float = 1.0) -> ScanSitter:
    """Return the random head of a seed, larger by ``scale``."""
    rng = np.random.default_rng([seed, 68])
    family, laid, painter, generic = read_family(path), laid_generic(path), scan_head(path), load_generic()
    head = scale * family.head(SPREAD * rng.normal(size=len(family.modes_m)))
    twin = twin_vertices(laid, head / scale) * scale
    fine = painter.matrix @ head
    kind = int(rng.choice(len(HAIR), p=[chance for chance, _ in HAIR]))
    hair = float(rng.uniform(*HAIR[kind][1]))
    colours = painter.colours(rng) if kind else painter.bald_colours(rng)
    shirt = rng.uniform(0.05, 0.95) * np.ones(3) + rng.normal(0.0, 0.12, 3)
    normals = vertex_normals(fine, painter.fine)
    worn = fine + (hair * painter.masks["scalp"] * painter.skin)[:, None] * normals
    colours = np.where((painter.skin & (painter.shape[:, 1] < COLLAR_M))[:, None], np.clip(shirt, 0.02, 0.98), colours)
    below, bust = _shirt(twin, float(scale), generic)
    return ScanSitter(
        head, twin, np.vstack([worn, below]), np.vstack([painter.fine, bust + len(worn)]),
        np.vstack([colours, np.tile(np.clip(shirt, 0.02, 0.98), (len(below), 1))]), hair,
    )  # fmt: skip


def _shirt(twin_m: Array, scale: float, generic: object) -> tuple[Array, NDArray[np.int64]]:
    """Return vertices and triangles of the generic's bust under the collar, a little wider."""
    human = load_generic()
    triangles = human.triangles()[0]
    skin = human.vertex_part == human.part_names.index("body")
    wanted = skin & (twin_m[:, 1] < scale * (COLLAR_M + 0.01)) & (twin_m[:, 1] > scale * -0.75)
    wanted &= np.abs(twin_m[:, 0]) < 0.35 * scale
    normals = vertex_normals(twin_m, triangles)
    kept = triangles[wanted[triangles].all(axis=1)]
    return twin_m + SHIRT_M * normals, np.asarray(kept, dtype=np.int64)


def photograph_scan(
    sitter: ScanSitter, camera: Camera, light: Light, background: Background, rng: np.random.Generator
) -> NDArray[np.uint8]:
    """Return a photo (H, W, 3) of a sitter."""
    normals = vertex_normals(sitter.worn_m, sitter.triangles)
    colours = _lit(sitter.worn_m, normals, sitter.colours, camera, light, rng) ** EXPOSED
    person = rendered(sitter.worn_m, sitter.triangles, colours, camera)
    behind = room(background, camera, -1.5, np.median(colours, axis=0), person, rng)
    return developed(person, behind, rng)


def scan_portrait(
    path: Path, seed: int, view: ViewId = ViewId.FACE_FRONT
) -> tuple[ScanSitter, Camera, NDArray[np.uint8]]:
    """Return a random sitter with one portrait as calibrations take them."""
    sitter = scan_sitter(path, seed)
    rng = np.random.default_rng([seed, 70 + (view is ViewId.FACE_SIDE)])
    azimuth = 0.0 if view is ViewId.FACE_FRONT else float(rng.choice([-90.0, 90.0]))
    camera = _portrait_camera(sitter, azimuth, None, SIZE_PX, rng)  # type: ignore[arg-type]
    light, background = LIGHTS[int(rng.integers(3))], BACKGROUNDS[seed % len(BACKGROUNDS)]
    return sitter, camera, photograph_scan(sitter, camera, light, background, rng)
