"""TensorFlow Lite models with inner tensors as additional outputs."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from typing import Final

# Field numbers in the TFLite schema (version 3): Model.subgraphs, SubGraph.outputs
_SUBGRAPHS: Final = 2
_OUTPUTS: Final = 2


def with_outputs(model: bytes, tensors: Sequence[int]) -> bytes:
    """Return a copy of a model whose first graph has additional outputs, after its own.

    A FlatBuffer's vectors are found by forward offsets, so a longer list of outputs can stand at the file's end and
    the graph be pointed to it; nothing else moves.

    Parameters
    ----------
    model : bytes
        A TFLite FlatBuffer.
    tensors : sequence of int
        Numbers of the wanted tensors in the first graph.

    Raises
    ------
    ValueError
        If the model has no graph with outputs.
    """
    buffer = bytearray(model)
    root = _offset(buffer, 0)
    graphs = _offset(buffer, _field(buffer, root, _SUBGRAPHS))
    place = _field(buffer, _offset(buffer, graphs + 4), _OUTPUTS)
    old = _offset(buffer, place)
    count = struct.unpack_from("<I", buffer, old)[0]
    listed = struct.unpack_from(f"<{count}i", buffer, old + 4) + tuple(tensors)
    buffer += bytes(-len(buffer) % 4)
    struct.pack_into("<I", buffer, place, len(buffer) - place)
    buffer += struct.pack(f"<I{len(listed)}i", len(listed), *listed)
    return bytes(buffer)


def _offset(buffer: bytearray, place: int) -> int:
    """Return the target of the offset at a position."""
    return place + int(struct.unpack_from("<I", buffer, place)[0])


def _field(buffer: bytearray, table: int, number: int) -> int:
    """Return the position of a table's field."""
    described = table - int(struct.unpack_from("<i", buffer, table)[0])
    entry = 4 + 2 * number
    if entry >= struct.unpack_from("<H", buffer, described)[0]:
        raise ValueError(f"the table has no field {number}")
    shift = struct.unpack_from("<H", buffer, described + entry)[0]
    if not shift:
        raise ValueError(f"the table's field {number} is empty")
    return table + int(shift)
