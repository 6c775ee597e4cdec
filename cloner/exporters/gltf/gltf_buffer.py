"""The buffer of a glTF file: arrays in, accessor numbers out."""

from __future__ import annotations

from typing import Any, ClassVar, Final

import numpy as np
import pygltflib
from numpy.typing import NDArray

from cloner.records.arrays import Array

_COMPONENT: Final = {
    np.dtype(np.uint8): pygltflib.UNSIGNED_BYTE,
    np.dtype(np.int8): pygltflib.BYTE,
    np.dtype(np.int16): pygltflib.SHORT,
    np.dtype(np.uint16): pygltflib.UNSIGNED_SHORT,
    np.dtype(np.uint32): pygltflib.UNSIGNED_INT,
    np.dtype(np.float32): pygltflib.FLOAT,
}
#: glTF's word for rows of so many numbers.
_KIND: Final = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


class GltfBuffer:
    """Collects arrays for one ``pygltflib.GLTF2`` and keeps its accessor table in step.

    Sparse accessors stand on one view of zeros. The specification does without it, but readers do not: Godot up to 4.0,
    SharpGLTF and UnityGLTF take the first view instead or refuse the file.
    """

    #: Whether sparse accessors stand on a view of zeros.
    founded: ClassVar[bool] = True

    def __init__(self, gltf: Any, box_m: Array) -> None:
        self._gltf = gltf
        self._box_m = box_m
        self._chunks: list[bytes] = []
        self._length = 0
        self._ground: int | None = None
        self._ground_bytes = 0

    def data(self) -> bytes:
        """Return everything that was added; to be asked once, at the end."""
        if self._ground is not None:
            self.fill(self._ground, bytes(self._ground_bytes))
        return b"".join(self._chunks)

    def view(self, data: bytes, target: int | None = None, stride: int | None = None) -> int:
        """Add raw bytes and return their buffer view; every view starts on 4 bytes."""
        view = pygltflib.BufferView(
            buffer=0, byteOffset=self._length, byteLength=len(data), byteStride=stride, target=target
        )
        padding = b"\0" * (-len(data) % 4)
        self._chunks += [data, padding]
        self._length += len(data) + len(padding)
        self._gltf.bufferViews.append(view)
        return len(self._gltf.bufferViews) - 1

    def fill(self, number: int, data: bytes) -> None:
        """Put bytes into a view that was added empty."""
        view = self._gltf.bufferViews[number]
        view.byteOffset, view.byteLength = self._length, len(data)
        self._chunks += [data, b"\0" * (-len(data) % 4)]
        self._length += len(data) + (-len(data) % 4)

    def attribute(
        self,
        values: NDArray[Any],
        *,
        bounds: bool = False,
        normalised: bool = False,
        target: int | None = pygltflib.ARRAY_BUFFER,
    ) -> int:
        """Add a vertex attribute (N, k) and return its accessor.

        Parameters
        ----------
        values : (N, k)
        bounds : bool
            Tell its smallest and largest values.
        normalised : bool
            Integers stand for -1..1 or 0..1.
        target : int or None
            What GL keeps it for; None for data that is no vertex attribute.
        """
        view = self.view(np.ascontiguousarray(values).tobytes(), target)
        return self.accessor(values, view, bounds=bounds, normalised=normalised)

    def positions(self, values_m: Array) -> int:
        """Add (N, 3) vertex positions, metres, and return their accessor."""
        return self.attribute(values_m.astype(np.float32), bounds=True)

    def normals(self, values: Array) -> int:
        """Add (N, 3) unit normals and return their accessor."""
        unit = values.astype(np.float32)
        return self.attribute(unit / np.linalg.norm(unit, axis=1, keepdims=True))

    def uv(self, values: Array) -> int:
        """Add (N, 2) texture coordinates and return their accessor."""
        return self.attribute(values.astype(np.float32))

    def skin(self, bones: NDArray[np.integer], weights: Array) -> tuple[int, int]:
        """Add (N, 4) bones and their weights, which sum to one, and return both accessors."""
        return self.attribute(bones.astype(np.uint8)), self.attribute(weights.astype(np.float32))

    def turns(self, values: Array) -> int:
        """Add the (F, 4) quaternions of an animation and return their accessor."""
        return self.values(values)

    def bind(self, values: Array) -> int:
        """Add the (K, 4, 4) matrices that take vertices to the bones' frames and return their accessor."""
        return self.matrices(values)

    def values(self, values: NDArray[Any], *, bounds: bool = False) -> int:
        """Add plain float32 values (N,) or (N, k), of an animation for example, and return their accessor."""
        plain = np.ascontiguousarray(values, dtype=np.float32)
        return self.accessor(plain, self.view(plain.tobytes()), bounds=bounds)

    def indices(self, values: NDArray[Any]) -> int:
        """Add the (N,) corners of triangles, as short as they fit, and return the accessor."""
        flat = values.reshape(-1)
        flat = flat.astype(np.uint16 if flat.max(initial=0) < 65535 else np.uint32)
        return self.accessor(flat, self.view(flat.tobytes(), pygltflib.ELEMENT_ARRAY_BUFFER))

    def matrices(self, values: NDArray[np.float64]) -> int:
        """Add (N, 4, 4) matrices, stored by columns as glTF wants, and return the accessor."""
        flat = np.ascontiguousarray(values.transpose(0, 2, 1)).reshape(-1, 16).astype(np.float32)
        return self.accessor(flat, self.view(flat.tobytes()))

    def offsets(self, count: int, index: NDArray[Any], values: NDArray[np.float32]) -> int:
        """Add (count, 3) offsets of a target, metres, zero except in the rows ``index`` (ascending, may be empty)."""
        return self.sparse(count, index, np.asarray(values, dtype=np.float32))

    def sparse(self, count: int, index: NDArray[Any], values: NDArray[Any]) -> int:
        """Add a (count, 3) attribute that is zero except in the rows ``index`` (ascending, may be empty).

        One that is zero everywhere still names its first row: the specification allows an accessor without any data,
        but Assimp 5 and Open3D refuse the whole file over it.
        """
        if not len(index):
            index, values = np.zeros(1, dtype=np.int64), np.zeros((1, 3), dtype=values.dtype)
        rows = index.astype(np.uint16 if count < 65535 else np.uint32)
        accessor = pygltflib.Accessor(
            bufferView=self._zeros(count * 3 * values.itemsize) if self.founded else None,
            byteOffset=None,
            componentType=_COMPONENT[values.dtype],
            normalized=values.dtype.kind == "i",
            count=count,
            type="VEC3",
            min=np.minimum(values.min(axis=0, initial=0.0), 0.0).astype(float).tolist(),
            max=np.maximum(values.max(axis=0, initial=0.0), 0.0).astype(float).tolist(),
        )
        indices, changed = self.stored(rows, values)
        accessor.sparse = pygltflib.Sparse(count=len(rows), indices=indices, values=changed)
        self._gltf.accessors.append(accessor)
        return len(self._gltf.accessors) - 1

    def _zeros(self, size: int) -> int:
        """Return the view of zeros, which will hold at least so many bytes."""
        if self._ground is None:
            self._ground = self.view(b"", pygltflib.ARRAY_BUFFER, stride=12)
        self._ground_bytes = max(self._ground_bytes, size)
        return self._ground

    def stored(self, rows: NDArray[Any], values: NDArray[Any]) -> tuple[Any, Any]:
        """Add rows and values of a sparse accessor and return where they lie, as its two parts."""
        return (
            pygltflib.AccessorSparseIndices(bufferView=self.view(rows.tobytes()), componentType=_COMPONENT[rows.dtype]),
            pygltflib.AccessorSparseValues(bufferView=self.view(values.tobytes())),
        )

    def accessor(
        self, values: NDArray[Any], view: int, *, bounds: bool = False, normalised: bool = False, offset: int = 0
    ) -> int:
        """Add the accessor of values that lie in a view, so many bytes behind its start."""
        width = 1 if values.ndim == 1 else values.shape[1]
        accessor = pygltflib.Accessor(
            bufferView=view,
            byteOffset=offset,
            componentType=_COMPONENT[values.dtype],
            normalized=normalised,
            count=len(values),
            type=_KIND[width],
        )
        if bounds:
            accessor.min = np.atleast_1d(values.min(axis=0)).astype(float).tolist()
            accessor.max = np.atleast_1d(values.max(axis=0)).astype(float).tolist()
        self._gltf.accessors.append(accessor)
        return len(self._gltf.accessors) - 1
