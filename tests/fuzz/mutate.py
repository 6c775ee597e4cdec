"""Small blind changes of files, of the kinds that break parsers."""

from __future__ import annotations

import random

TOKENS = (
    b"nan", b"inf", b"-1", b"0", b"1e999", b"-1e-999", b"9" * 400, b"9" * 5000, b"4294967295", b"65536",
    b"[", b"]", b"{", b"}", b'"', b"'", b"\\", b",", b";", b"=", b"\n", b"\r", b"\0", b"\xff\xfe", b"\xef\xbb\xbf",
    b"\xed\xa0\x80", b"\x1b[2J", "\u202e".encode(), b"[" * 2000, b"{" * 2000, b"../", b"/etc/passwd", b"true", b"null",
    b"format", b"views", b"ROOT", b"JOINT x {", b"End Site", b"CHANNELS 3", b"CHANNELS -3", b"OFFSET", b"MOTION",
    b"Frames: 1000000", b"Frame Time:", b"height_cm", b"[measures]", b"[[visitor]]", b"photos",
)  # fmt: skip


def mutated(data: bytes, rng: random.Random, others: tuple[bytes, ...] = ()) -> bytes:
    """Return a file changed in one to eight places."""
    out = bytearray(data)
    for _ in range(rng.choice((1, 1, 2, 3, 8))):
        at = rng.randrange(len(out) + 1)
        length = min(rng.choice((1, 1, 2, 4, 16, 64, 512)), len(out) - at)
        kind = rng.randrange(7)
        if kind == 0 and out:
            out[min(at, len(out) - 1)] = rng.randrange(256)
        elif kind == 1:
            out[at:at] = rng.choice(TOKENS)
        elif kind == 2:
            out[at : at + length] = rng.choice(TOKENS)
        elif kind == 3:
            del out[at : at + length]
        elif kind == 4:
            out[at:at] = out[at : at + length] * rng.choice((1, 2, 50))
        elif kind == 5:
            del out[at:]
        elif others:
            other = rng.choice(others)
            start = rng.randrange(len(other) + 1)
            out[at : at + length] = other[start : start + rng.choice((4, 64, 1024))]
    return bytes(out)
