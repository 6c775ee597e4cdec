"""Read the shipped generic human: mesh, skeleton, shape space, segments, names and face units."""

from __future__ import annotations

import functools
import importlib.resources
from dataclasses import dataclass, fields

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.floating]
IntArray = npt.NDArray[np.integer]
BoolArray = npt.NDArray[np.bool_]

GENERIC_STATURE_M = 1.70  # stature that every shipped length is scaled to
_REGION = "region_"


@dataclass(frozen=True, slots=True, eq=False)
class GenericHuman:
    """The generic human in its rest pose; every array is read-only.

    Model frame: metres, Y up, facing +Z, the person's left is +X, origin on the floor between the ankles, naked soles
    on y = 0, stature 1.70 m from the soles to the skull's top (feature ``head_top``).

    Attributes
    ----------
    vertices_m : (V, 3) float32, the mean adult; body vertices first, then eyes, teeth, tongue, lashes.
    quads, quad_uv : (Q, 4) int32 vertex and UV indices; a triangle repeats its last index.
    quad_part, vertex_part : index into ``part_names``.
    uv : (T, 2) float32 in [0, 1], glTF convention (v grows downwards).
    mirror : (V,) int32, each vertex's twin on the other side.
    joint_names, joint_parents, joints_m : 94 H-Anim 1.1 joints, parents first, -1 above the root.
    skin_joints, skin_weights : (V, 4), four influences a vertex, weights sum to one.
    shape_basis, joint_basis : (C, V, 3) and (C, 94, 3) float32, metres per standard deviation at 1.70 m.
    shape_share : (C,) explained share of the sample's variance.
    phenotype_names, phenotype_from_shape, phenotype_mean : linear guess (P, C) and (P,) of sex (0 female, 1 male),
        age_years and further axes in 0..1.
    segment_names, segment_weights, vertex_segment, quad_segment : the 15 skin segments.
    slice_s, slice_theta, slice_axis_joints : slice overlay; s in 0..1, theta in radians, 0 in front, left positive.
    connections : (M, 3) int32 rows (segment a, segment b, vertex) of border vertices that two segments share.
    feature_names, feature_vertices : named points, one vertex each.
    fdp_names, fdp_vertices : MPEG-4 facial definition points, one vertex each.
    region_names, regions : (R, V) bool.
    head_vertices, head_blend : vertices above the neck base and (V,) weights, 1 on the head, 0 at the neck base.
    face_basis : (F, H, 3) float32, metres per standard deviation at 1.70 m, on ``head_vertices``.
    arkit_names, arkit_start, arkit_index, arkit_delta_m : 52 sparse face units; unit k owns rows start[k]:start[k+1].
    viseme_names, viseme_start, viseme_index, viseme_delta_m : 15 sparse mouth shapes, the same way.
    """

    vertices_m: FloatArray
    quads: IntArray
    quad_part: IntArray
    vertex_part: IntArray
    part_names: tuple[str, ...]
    uv: FloatArray
    quad_uv: IntArray
    mirror: IntArray
    joint_names: tuple[str, ...]
    joint_parents: IntArray
    joints_m: FloatArray
    skin_joints: IntArray
    skin_weights: FloatArray
    shape_basis: FloatArray
    joint_basis: FloatArray
    shape_share: FloatArray
    phenotype_names: tuple[str, ...]
    phenotype_from_shape: FloatArray
    phenotype_mean: FloatArray
    segment_names: tuple[str, ...]
    segment_weights: FloatArray
    vertex_segment: IntArray
    quad_segment: IntArray
    slice_s: FloatArray
    slice_theta: FloatArray
    slice_axis_joints: IntArray
    connections: IntArray
    feature_names: tuple[str, ...]
    feature_vertices: IntArray
    fdp_names: tuple[str, ...]
    fdp_vertices: IntArray
    region_names: tuple[str, ...]
    regions: BoolArray
    head_vertices: IntArray
    head_blend: FloatArray
    face_basis: FloatArray
    arkit_names: tuple[str, ...]
    arkit_start: IntArray
    arkit_index: IntArray
    arkit_delta_m: FloatArray
    viseme_names: tuple[str, ...]
    viseme_start: IntArray
    viseme_index: IntArray
    viseme_delta_m: FloatArray

    def triangles(self) -> tuple[IntArray, IntArray]:
        """Return vertex and UV indices of the triangles, (T, 3) int32 each."""
        corners = np.concatenate([self.quads[:, [0, 1, 2]], self.quads[:, [0, 2, 3]]])
        corner_uv = np.concatenate([self.quad_uv[:, [0, 1, 2]], self.quad_uv[:, [0, 2, 3]]])
        real = (corners[:, 1] != corners[:, 2]) & (corners[:, 2] != corners[:, 0]) & (corners[:, 0] != corners[:, 1])
        return corners[real], corner_uv[real]

    def shape(
        self, coefficients: FloatArray, stature_m: float
    ) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        """Return the vertices (V, 3) and joints (94, 3) of a person, metres, float64.

        Parameters
        ----------
        coefficients : (C',) with C' <= C, in standard deviations; the missing ones are zero.
        stature_m : soles to skull top; reached exactly, because every basis vector keeps both ends still.
        """
        weights = np.asarray(coefficients, dtype=np.float64)
        if weights.ndim != 1 or weights.size > self.shape_basis.shape[0]:
            raise ValueError(f"expected at most {self.shape_basis.shape[0]} coefficients, got shape {weights.shape}")
        scale = stature_m / GENERIC_STATURE_M
        used = weights.size
        vertices_m = self.vertices_m + np.tensordot(weights, self.shape_basis[:used], axes=1)
        joints_m = self.joints_m + np.tensordot(weights, self.joint_basis[:used], axes=1)
        return scale * vertices_m, scale * joints_m

    def part(self, name: str) -> IntArray:
        """Return the vertices of a part, for example ``"eye_left"``."""
        return np.flatnonzero(self.vertex_part == self.part_names.index(name))

    @property
    def skin(self) -> BoolArray:
        """(V,) which vertices are skin: no eyes, teeth, tongue and lashes."""
        return np.asarray(self.vertex_part == self.part_names.index("body"))

    def segment(self, *names: str) -> BoolArray:
        """Return (V,) which vertices have one of some segments as their main one."""
        return np.isin(self.vertex_segment, [self.segment_names.index(name) for name in names])

    def share(self, *names: str) -> npt.NDArray[np.float64]:
        """Return (V,) how much of each vertex belongs to some segments, about 0..1."""
        rows = [self.segment_names.index(name) for name in names]
        return np.asarray(self.segment_weights[:, rows].astype(np.float64).sum(axis=1))

    def carried_by(self, joint: str) -> FloatArray:
        """Return (V,) how much of a joint's turn each vertex takes part in by itself, 0..1."""
        return np.asarray((self.skin_weights * (self.skin_joints == self.joint(joint))).sum(axis=1))

    def joint(self, name: str) -> int:
        """Return a joint's row."""
        return self.joint_names.index(name)

    def feature(self, name: str) -> int:
        """Return the vertex of a named feature, or of an MPEG-4 feature point (FDP) such as ``"2.13"``."""
        if name in self.fdp_names:
            return int(self.fdp_vertices[self.fdp_names.index(name)])
        return int(self.feature_vertices[self.feature_names.index(name)])

    def region(self, name: str) -> BoolArray:
        """Return the (V,) mask of a region, for example ``"scalp"``."""
        mask: BoolArray = self.regions[self.region_names.index(name)]
        return mask

    def face_unit(self, name: str) -> tuple[IntArray, FloatArray]:
        """Return the vertices (K,) and offsets (K, 3) in metres at 1.70 m of an ARKit unit or a viseme."""
        if name in self.arkit_names:
            k = self.arkit_names.index(name)
            rows = slice(int(self.arkit_start[k]), int(self.arkit_start[k + 1]))
            return self.arkit_index[rows], self.arkit_delta_m[rows]
        k = self.viseme_names.index(name)
        rows = slice(int(self.viseme_start[k]), int(self.viseme_start[k + 1]))
        return self.viseme_index[rows], self.viseme_delta_m[rows]


#: What files of older builds lack.
_EMPTY: dict[str, npt.NDArray[np.generic]] = {
    "fdp_names": np.array([], dtype=np.str_),
    "fdp_vertices": np.zeros(0, dtype=np.int32),
    "head_vertices": np.zeros(0, dtype=np.int32),
    "head_blend": np.zeros(0, dtype=np.float32),
    "face_basis": np.zeros((0, 0, 3), dtype=np.float32),
    "arkit_names": np.array([], dtype=np.str_),
    "arkit_start": np.zeros(1, dtype=np.int32),
    "arkit_index": np.zeros(0, dtype=np.int32),
    "arkit_delta_m": np.zeros((0, 3), dtype=np.float32),
    "viseme_names": np.array([], dtype=np.str_),
    "viseme_start": np.zeros(1, dtype=np.int32),
    "viseme_index": np.zeros(0, dtype=np.int32),
    "viseme_delta_m": np.zeros((0, 3), dtype=np.float32),
}


def _read(name: str) -> dict[str, npt.NDArray[np.generic]]:
    """Return a shipped file's arrays; half floats widen to float32, everything turns read-only."""
    place = importlib.resources.files("cloner_models") / name
    out: dict[str, npt.NDArray[np.generic]] = {}
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        for key in archive.files:
            array = archive[key]
            out[key] = array.astype(np.float32) if array.dtype == np.float16 else array
    return out


@functools.cache
def load_generic() -> GenericHuman:
    """Return the shipped generic human, read once per process."""
    arrays = dict(_EMPTY)
    for name in ("body.npz", "head.npz"):
        if (importlib.resources.files("cloner_models") / name).is_file():
            arrays |= _read(name)
    masks = sorted(key for key in arrays if key.startswith(_REGION))
    arrays["region_names"] = np.array([key.removeprefix(_REGION) for key in masks], dtype=np.str_)
    arrays["regions"] = np.array([arrays[key] for key in masks], dtype=np.bool_)
    values: dict[str, object] = {}
    for field in fields(GenericHuman):
        array = arrays[field.name]
        array.setflags(write=False)
        values[field.name] = tuple(str(s) for s in array) if field.name.endswith("_names") else array
    return GenericHuman(**values)  # type: ignore[arg-type]
