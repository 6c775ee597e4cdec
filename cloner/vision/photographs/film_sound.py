"""A sound track for an MPEG-4 file: OpenCV writes films without one.

References
----------
ISO 14496-12 (boxes); QuickTime File Format, Sound Media: "sowt" are 16-bit samples, the low byte first.
"""

from __future__ import annotations

import mmap
import struct
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

#: Boxes are written one after another by what made the film; more would be another program's.
_MOST_BOXES: Final = 64
_UNITY: Final = struct.pack(">9i", 0x10000, 0, 0, 0, 0x10000, 0, 0, 0, 0x40000000)
_CHANNELS: Final = 2


def add_sound(path: Path, samples: NDArray[np.int16], rate_hz: int) -> None:
    """Add (N, 2) samples to an MPEG-4 file as a track of their own, uncompressed.

    Parameters
    ----------
    path : Path
        A film that OpenCV wrote; its index is its last box.
    samples : (N, 2) int16
        Left and right.
    rate_hz : int

    Raises
    ------
    ValueError
        If the file is not such a film.
    """
    with path.open("rb") as stream, mmap.mmap(stream.fileno(), 0, access=mmap.ACCESS_READ) as data:
        boxes = _boxes(data)
        if not boxes or boxes[-1][0] != b"moov":
            raise ValueError(f"{path.name} does not end with its index")
        _, begin, end = boxes[-1]
        index = bytearray(data[begin + 8 : end])
    head = next(one for one in _boxes(index) if one[0] == b"mvhd")
    scale, length = struct.unpack_from(">II", index, head[1] + 20)
    next_at = head[2] - 4
    track = struct.unpack_from(">I", index, next_at)[0]
    sound = np.ascontiguousarray(samples, "<i2").tobytes()
    seconds = len(samples) / rate_hz
    trak = _track(track, round(seconds * scale), rate_hz, len(samples), begin + 8)
    struct.pack_into(">I", index, head[1] + 24, max(length, round(seconds * scale)))
    struct.pack_into(">I", index, next_at, track + 1)
    with path.open("r+b") as out:
        out.seek(begin)
        out.truncate()
        out.write(_box(b"mdat", sound) + _box(b"moov", bytes(index) + trak))


def _boxes(data: bytearray | mmap.mmap) -> list[tuple[bytes, int, int]]:
    """Return kind, first and last byte of the boxes in line."""
    found: list[tuple[bytes, int, int]] = []
    at = 0
    while at + 8 <= len(data) and len(found) < _MOST_BOXES:
        size, kind = struct.unpack_from(">I4s", data, at)
        size = struct.unpack_from(">Q", data, at + 8)[0] if size == 1 else size or len(data) - at
        if size < 8:
            break
        found.append((kind, at, at + size))
        at += size
    return found


def _box(kind: bytes, *parts: bytes) -> bytes:
    body = b"".join(parts)
    return struct.pack(">I4s", 8 + len(body), kind) + body


def _full_box(kind: bytes, flags: int, *parts: bytes) -> bytes:
    return _box(kind, struct.pack(">I", flags), *parts)


def _track(number: int, length: int, rate: int, count: int, at: int) -> bytes:
    """Return the box of a track whose samples lie in line from a byte of the file on."""
    head = struct.pack(">IIIII8xhhhh", 0, 0, number, 0, length, 0, 0, 0x100, 0) + _UNITY + struct.pack(">II", 0, 0)
    entry = _box(b"sowt", struct.pack(">6xH8xHHHHI", 1, _CHANNELS, 16, 0, 0, rate << 16))
    table = _box(
        b"stbl",
        _full_box(b"stsd", 0, struct.pack(">I", 1), entry),
        _full_box(b"stts", 0, struct.pack(">III", 1, count, 1)),
        _full_box(b"stsc", 0, _runs(count, rate)),
        _full_box(b"stsz", 0, struct.pack(">II", 2 * _CHANNELS, count)),
        _full_box(b"co64", 0, _chunks(count, rate, at)),
    )
    refer = _box(b"dinf", _full_box(b"dref", 0, struct.pack(">I", 1), _full_box(b"url ", 1)))
    media = _box(
        b"mdia",
        _full_box(b"mdhd", 0, struct.pack(">IIIIHH", 0, 0, rate, count, 0x55C4, 0)),
        _full_box(b"hdlr", 0, struct.pack(">I4s12x", 0, b"soun"), b"sound\0"),
        _box(b"minf", _full_box(b"smhd", 0, bytes(4)), refer, table),
    )
    return _box(b"trak", _full_box(b"tkhd", 3, head), media)


def _chunks(count: int, rate: int, at: int) -> bytes:
    """Return the offset of each second of samples."""
    firsts = range(0, count, rate)
    return struct.pack(f">I{len(firsts)}Q", len(firsts), *(at + 2 * _CHANNELS * first for first in firsts))


def _runs(count: int, rate: int) -> bytes:
    """Return from which chunk on there are how many samples in each: a second, and what is left in the last one."""
    whole, left = divmod(count, rate)
    runs = ([(1, rate, 1)] if whole else []) + ([(whole + 1, left, 1)] if left else [])
    return struct.pack(">I", len(runs)) + b"".join(struct.pack(">III", *one) for one in runs)
