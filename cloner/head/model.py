"""The linear head model of a phenotype: mean, basis, the face net's view of it, and the jaw."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cloner.detectors.face.face_net import FaceNet, load_face_net
from cloner.generic.load import GENERIC_STATURE_M, GenericHuman, load_generic
from cloner.geometry.meshes.surface import SurfacePoints
from cloner.head.jaw import PHOTOS, USUAL_RAD, jaw_opening_mode
from cloner.head.modes import HeadModes, load_head_modes
from cloner.records.arrays import Array
from cloner.records.bodies import Phenotype


@dataclass(frozen=True, slots=True, eq=False)
class HeadModel:
    """The linear head model of a phenotype: vertices at rest (V, 3), basis (F + 2, H, 3), and the rows of head
    vertices.

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

    def in_photo(self, number: int) -> HeadModel:
        """Return the model for the front (0) or the side photo (1), with that photo's jaw opening in its basis."""
        basis = self.basis_m.copy()
        basis[len(self.modes.basis_m) + number] = self.jaw_m
        return replace(self, basis_m=basis)

    def whole_in_photo(self, number: int, coefficients: Array) -> Array:
        """Return all vertices (V, 3) in the front (0) or the side photo (1), with that photo's jaw opening."""
        own = coefficients[: len(self.basis_m)]
        return self.whole(self.head(own) + own[len(self.modes.basis_m) + number] * self.jaw_m)

    def jaws_rad(self, coefficients: Array) -> Array:
        """Return the jaw's opening in front and side photo, (2,) radians."""
        return np.asarray(USUAL_RAD * coefficients[len(self.modes.basis_m) : len(self.basis_m)])

    def head(self, coefficients: Array) -> Array:
        """Return the head's vertices (H, 3) for some coefficients."""
        return self.vertices_m[self.generic.head_vertices] + np.tensordot(coefficients, self.basis_m, axes=1)

    def whole(self, head: Array) -> Array:
        """Return all vertices (V, 3) with the head's replaced."""
        out = self.vertices_m.copy()
        out[self.generic.head_vertices] = head
        return out

    def places(self, surface: SurfacePoints) -> tuple[Array, Array]:
        """Return base (N, 3) and basis (F, N, 3) of surface points."""
        return self.head_places(SurfacePoints(self.row[surface.corners].astype(np.int32), surface.weights))

    def head_places(self, places: SurfacePoints) -> tuple[Array, Array]:
        """Return base (N, 3) and basis (F, N, 3) of surface points that are given in rows of the head."""
        basis = np.einsum("nk,fnka->fna", places.weights, self.basis_m[:, places.corners])
        return places.at(self.vertices_m[self.generic.head_vertices]), basis

    def vertex_places(self, vertices: NDArray[np.integer]) -> tuple[Array, Array]:
        """Return base (N, 3) and basis (F, N, 3) of vertices."""
        return self.vertices_m[vertices], self.basis_m[:, self.row[vertices]]


def make_head_model(phenotype: Phenotype) -> HeadModel:
    """Return the head model of a phenotype."""
    generic = load_generic()
    vertices, joints = generic.shape(phenotype.coefficients, phenotype.stature_m)
    row = np.full(len(vertices), -1, dtype=np.int64)
    row[generic.head_vertices] = np.arange(len(generic.head_vertices))
    modes, scale = load_head_modes(), phenotype.stature_m / GENERIC_STATURE_M
    vertices[generic.head_vertices] += scale * modes.mean_m
    shapes = scale * modes.basis_m
    basis = np.concatenate([shapes, np.zeros((len(PHOTOS), *shapes.shape[1:]))])
    jaw = jaw_opening_mode(generic, vertices, joints)[generic.head_vertices]
    return HeadModel(generic, load_face_net(), modes, vertices, joints, basis, jaw, row)
