"""The phenotype's generic head: its shape, how the net sees it, and its jaw."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cloner.detectors.face.face_net import FaceNet, load_face_net
from cloner.generic.load import GENERIC_STATURE_M, GenericHuman, load_generic
from cloner.geometry.meshes.surface import SurfacePoints
from cloner.head.jaw import PHOTOS, USUAL_RAD, jaw_way
from cloner.head.modes import HeadModes, load_head_modes
from cloner.records.arrays import Array
from cloner.records.bodies import Phenotype


@dataclass(frozen=True, slots=True, eq=False)
class Model:
    """The generic head of the phenotype: rest vertices (V, 3), basis (F + 2, H, 3) and where head rows are.

    ``jaw_m`` (H, 3) is what the usual opening of the jaw does to it.

    ``modes`` tells how the net sees the basis. Its last two directions are the jaws of front and side photo, which move
    nothing in a head at rest; :meth:`in_photo` gives the head in which one of them does.
    """

    generic: GenericHuman
    net: FaceNet
    modes: HeadModes
    vertices_m: Array
    joints_m: Array
    basis_m: Array
    jaw_m: Array
    row: NDArray[np.int64]

    def in_photo(self, number: int) -> Model:
        """Return the head as the front (0) or the side photo (1) shows it, its jaw moved by a direction of its own."""
        basis = self.basis_m.copy()
        basis[len(self.modes.basis_m) + number] = self.jaw_m
        return replace(self, basis_m=basis)

    def whole_in_photo(self, number: int, coefficients: Array) -> Array:
        """Return the vertices (V, 3) as the front (0) or the side photo (1) shows them."""
        own = coefficients[: len(self.basis_m)]
        return self.whole(self.head(own) + own[len(self.modes.basis_m) + number] * self.jaw_m)

    def jaws_rad(self, coefficients: Array) -> Array:
        """Return (2,) how far front and side photo show the jaw open."""
        return np.asarray(USUAL_RAD * coefficients[len(self.modes.basis_m) : len(self.basis_m)])

    def head(self, coefficients: Array) -> Array:
        """Return the (H, 3) head vertices of some coefficients."""
        return self.vertices_m[self.generic.head_vertices] + np.tensordot(coefficients, self.basis_m, axes=1)

    def whole(self, head: Array) -> Array:
        """Return (V, 3) vertices with the head's replaced."""
        out = self.vertices_m.copy()
        out[self.generic.head_vertices] = head
        return out

    def places(self, surface: SurfacePoints) -> tuple[Array, Array]:
        """Return base (N, 3) and basis (F, N, 3) of surface points."""
        return self.head_places(SurfacePoints(self.row[surface.corners].astype(np.int32), surface.weights))

    def head_places(self, places: SurfacePoints) -> tuple[Array, Array]:
        """Return base (N, 3) and basis (F, N, 3) of surface points told in rows of the head."""
        basis = np.einsum("nk,fnka->fna", places.weights, self.basis_m[:, places.corners])
        return places.at(self.vertices_m[self.generic.head_vertices]), basis

    def vertex_places(self, vertices: NDArray[np.integer]) -> tuple[Array, Array]:
        """Return base (N, 3) and basis (F, N, 3) of vertices."""
        return self.vertices_m[vertices], self.basis_m[:, self.row[vertices]]


def make_model(phenotype: Phenotype) -> Model:
    """Return the phenotype's generic head."""
    generic = load_generic()
    vertices, joints = generic.shape(phenotype.coefficients, phenotype.stature_m)
    row = np.full(len(vertices), -1, dtype=np.int64)
    row[generic.head_vertices] = np.arange(len(generic.head_vertices))
    modes, scale = load_head_modes(), phenotype.stature_m / GENERIC_STATURE_M
    vertices[generic.head_vertices] += scale * modes.mean_m
    shapes = scale * modes.basis_m
    basis = np.concatenate([shapes, np.zeros((len(PHOTOS), *shapes.shape[1:]))])
    jaw = jaw_way(generic, vertices, joints)[generic.head_vertices]
    return Model(generic, load_face_net(), modes, vertices, joints, basis, jaw, row)
