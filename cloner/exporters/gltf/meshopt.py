"""Encoders of EXT_meshopt_compression: attributes, triangles, and index sequences.

References
----------
Khronos Group 2022, EXT_meshopt_compression, appendix A ("Bitstream"): version 0 of attributes, version 1 of indices.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

Bytes = NDArray[np.uint8]

#: A block holds so many bytes at most, and so many elements; a group so many elements.
BLOCK_BYTES, BLOCK, GROUP = 8192, 256, 16
#: Edges looked at for the next triangle; more take longer and save less than 1 % (measured).
RECENT: Final = 8
#: An attribute stream ends in its first element, with zeros before it up to so many bytes.
TAIL: Final = 32
_ATTRIBUTES, _TRIANGLES, _SEQUENCE = 0xA0, 0xE1, 0xD1
#: Pairs of places of a fresh triangle's second and third corner that take no byte of their own (the reference's table).
_PAIRS: Final = (0x00, 0x76, 0x87, 0x56, 0x67, 0x78, 0xA9, 0x86, 0x65, 0x89, 0x68, 0x98, 0x01, 0x69, 0x00, 0x00)
_FIFO, _NEAR, _FREE = 16, 13, 15


def attributes(values: Bytes) -> bytes:
    """Return the packed form of elements (N, stride), N at least 1, stride a multiple of 4 up to 256."""
    count, stride = values.shape
    before = np.vstack([values[:1], values[:-1]])
    step = (values - before).astype(np.int8).astype(np.int16)
    zigzag = np.where(step >= 0, 2 * step, -2 * step - 1).astype(np.uint8)
    rows = np.zeros((-(-count // GROUP) * GROUP, stride), np.uint8)
    rows[:count] = zigzag
    groups = np.ascontiguousarray(rows.reshape(-1, GROUP, stride).transpose(2, 0, 1))
    modes, stored = _packed_groups(groups)
    in_block = min((BLOCK_BYTES // stride) & ~(GROUP - 1), BLOCK) // GROUP
    out = [bytes([_ATTRIBUTES])]
    for start in range(0, groups.shape[1], in_block):
        for column in range(stride):
            out += [_header(modes[column, start : start + in_block]), *stored[column][start : start + in_block]]
    return b"".join([*out, bytes(max(0, TAIL - stride)), values[0].tobytes()])


def _packed_groups(groups: Bytes) -> tuple[NDArray[np.int64], list[list[bytes]]]:
    """Return how every group of (stride, G, 16) is stored, and its bytes: in 0, 2, 4 or 8 bits a value."""
    most = groups.max(axis=2)
    escapes = [(groups >= full).sum(axis=2) for full in (3, 15)]
    sizes = np.stack([np.where(most, 99, 0), 4 + escapes[0], 8 + escapes[1], np.full(most.shape, GROUP)])
    modes = sizes.argmin(axis=0)
    pairs = np.minimum(groups, 3).reshape(*most.shape, 4, 4) << np.array([6, 4, 2, 0], np.uint8)
    halves = np.minimum(groups, 15).reshape(*most.shape, 8, 2) << np.array([4, 0], np.uint8)
    two, four = (np.bitwise_or.reduce(bits, axis=3) for bits in (pairs, halves))
    stored = []
    for column, modes_here in enumerate(modes.tolist()):
        own = []
        for number, mode in enumerate(modes_here):
            values = groups[column, number]
            if mode == 0:
                own.append(b"")
            elif mode == 3:
                own.append(values.tobytes())
            else:
                bits, full = ((two, 3), (four, 15))[mode - 1]
                own.append(bits[column, number].tobytes() + bytes(one for one in values.tolist() if one >= full))
        stored.append(own)
    return modes, stored


def _header(modes: NDArray[np.int64]) -> bytes:
    """Return the 2 bits a group that say how a block's groups are stored."""
    widths = [*modes.tolist(), 0, 0, 0]
    return bytes(a | b << 2 | c << 4 | d << 6 for a, b, c, d in zip(*(widths[k : len(modes) + k : 4] for k in range(4)),
                                                                     strict=False))  # fmt: skip


def sequence(values: NDArray[np.integer]) -> bytes:
    """Return the packed form of indices (N,) in their order."""
    step = np.diff(values.astype(np.int64), prepend=0)
    left = np.where(step >= 0, 2 * step, -2 * step - 1) << 1
    sevens = left[:, None] >> (7 * np.arange(5))  # low ones first; 32 bits with a sign and a flag fit five
    more = sevens[:, 1:] > 0
    bits = (sevens & 127).astype(np.uint8)
    bits[:, :-1] |= more.astype(np.uint8) << 7
    kept = np.concatenate([np.ones((len(bits), 1), np.bool_), more], axis=1)
    return b"".join([bytes([_SEQUENCE]), bits[kept].tobytes(), bytes(4)])


def triangles(values: NDArray[np.integer]) -> bytes:
    """Return the packed form of triangles (T, 3); their order stays, each may begin with another of its corners."""
    writer = _Triangles()
    for a, b, c in values.tolist():
        writer.add(a, b, c)
    return bytes([_TRIANGLES]) + bytes(writer.codes) + bytes(writer.data) + bytes(_PAIRS)


def order_by_adjacency(values: NDArray[np.integer]) -> NDArray[np.integer]:
    """Return triangles (T, 3) in an order in which most share an edge with a recent one: a third less bytes."""
    corners = values.tolist()
    across = {}  # every edge, as its triangle goes along it: that triangle, the edge, the third corner
    for row, (a, b, c) in enumerate(corners):
        across[a, b], across[b, c], across[c, a] = (row, a, b, c), (row, b, c, a), (row, c, a, b)
    nobody = (len(corners), 0, 0, 0)
    done = bytearray(len(corners)) + b"\1"
    order: list[int] = []
    edges: list[tuple[int, int, int, int]] = []
    seen: list[int] = []
    for start, (a, b, c) in enumerate(corners):
        if done[start]:
            continue
        found, fresh = (start, a, b, c), True
        while fresh or found is not nobody:
            row, first, second, third = found
            done[row] = 1
            order.append(row)
            edges = [across.get((first, third), nobody), across.get((third, second), nobody),
                     *((across.get((second, first), nobody),) if fresh else ()), *edges][:RECENT]  # fmt: skip
            seen = [third, *(one for one in seen if one != third)][: _NEAR - 1]
            found, fresh = nobody, False
            for edge in edges:
                if not done[edge[0]]:
                    known = edge[3] in seen
                    if known or found is nobody:
                        found = edge
                    if known:
                        break
    return values[order]


class _Triangles:
    """Writes triangles one by one, most of them by an edge that one of the last has, and by a vertex seen lately."""

    def __init__(self) -> None:
        self.codes, self.data = bytearray(), bytearray()
        self._edges: list[tuple[int, int]] = []
        self._vertices: list[int] = []
        self._next = self._last = 0

    def add(self, a: int, b: int, c: int) -> None:
        """Write one triangle."""
        for turn in ((a, b, c), (b, c, a), (c, a, b)):
            if turn[:2] in self._edges:
                place = self._edges.index(turn[:2])
                if place < _FREE:
                    self._beside(place, *turn)
                    return
        if b == self._next:
            a, b, c = b, c, a
        elif c == self._next:
            a, b, c = c, a, b
        self._fresh(a, b, c)

    def _beside(self, edge: int, a: int, b: int, c: int) -> None:
        """Write a triangle across a known edge."""
        seen = self._place(c)
        if 1 <= seen < _NEAR:
            code = seen
        elif c == self._next:
            code, self._next = 0, self._next + 1
        elif c in (self._last - 1, self._last + 1):
            code = _NEAR if c < self._last else _NEAR + 1
            self._last = c
        else:
            code = _FREE
            self._index(c)
        self.codes.append(edge << 4 | code)
        if code == 0 or code >= _NEAR:
            self._remember(c)
        self._push(((c, b), (a, c)))

    def _fresh(self, a: int, b: int, c: int) -> None:
        """Write a triangle that shares no known edge."""
        first = a == self._next
        self._next += int(first)
        places = []
        for corner in (b, c):
            seen = self._place(corner)
            if 0 <= seen < _FREE - 1:
                places.append(seen + 1)
            elif corner == self._next:
                places.append(0)
                self._next += 1
            else:
                places.append(_FREE)
        pair = places[0] << 4 | places[1]
        if first and pair in _PAIRS[:14]:
            self.codes.append(0xF0 | _PAIRS.index(pair))
        else:
            self.codes.append(0xFE if first else 0xFF)
            self.data.append(pair)
        for corner, free in ((a, not first), (b, places[0] == _FREE), (c, places[1] == _FREE)):
            if free:
                self._index(corner)
        for corner, new in ((a, True), (b, places[0] in (0, _FREE)), (c, places[1] in (0, _FREE))):
            if new:
                self._remember(corner)
        self._push(((b, a), (c, b), (a, c)))

    def _place(self, vertex: int) -> int:
        """Return how many vertices were seen since this one, -1 if it is forgotten."""
        return self._vertices.index(vertex) if vertex in self._vertices else -1

    def _remember(self, vertex: int) -> None:
        self._vertices = [vertex, *self._vertices[: _FIFO - 1]]

    def _push(self, edges: tuple[tuple[int, int], ...]) -> None:
        self._edges = [*edges[::-1], *self._edges][:_FIFO]

    def _index(self, vertex: int) -> None:
        _put(self.data, _zigzag(vertex - self._last))
        self._last = vertex


def _zigzag(value: int) -> int:
    return 2 * value if value >= 0 else -2 * value - 1


def _put(out: bytearray, value: int) -> None:
    """Append a number by sevens of bits, the low ones first."""
    while value > 127:
        out.append(value & 127 | 128)
        value >>= 7
    out.append(value)
