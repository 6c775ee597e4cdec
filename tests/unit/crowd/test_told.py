"""A pack's description from somebody else: the unfit value is named, and nothing larger than a clone is unpacked."""

from __future__ import annotations

import json
import zlib
from pathlib import Path
from typing import Any

import pytest

from cloner.crowd.packs.files import decode_webp, unpack_arrays
from cloner.crowd.packs.reading import read_facts
from cloner.crowd.packs.told import find_invalid
from cloner.errors import ClonerError
from fuzz.targets import crowd_bytes


def facts() -> dict[str, Any]:
    return dict(json.loads(crowd_bytes()))


def test_what_a_pack_says_is_fit() -> None:
    assert find_invalid(facts()) == ""


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("scene", "moon"),
        ("people_count", 10**9),
        ("people", []),
        ("people.0.id", "../../etc"),
        ("people.1.id", "a\x1b[2J"),
        ("people.0.arrays.bones.shape", [1, 2, 3]),
        ("people.0.arrays.vertices.at", -8),
        ("people.0.arrays.table.type", "object"),
        ("tiers", [{"largest_px": 3}]),
        ("tiers.2.largest_px", "big"),
        ("switch.metres_per_focal_px", 0),
        ("impostors.views", 1e400),
        ("impostors.rings_deg", [float("nan")]),
        ("looks.own_share", True),
        ("looks.clones", 3),
        ("looks.wardrobe.top", [[7], [0]]),
    ],
)
def test_an_unfit_value_is_named(path: str, value: object, tmp_path: Path) -> None:
    told = facts()
    *way, last = path.split(".")
    place: Any = told
    for step in way:
        place = place[int(step)] if isinstance(place, list) else place[step]
    place[last] = value
    (tmp_path / "crowd.json").write_text(json.dumps(told))
    with pytest.raises(ClonerError, match="is unfit"):
        read_facts(tmp_path)
    assert find_invalid(told).startswith(path)


def test_only_the_finest_level_has_no_largest_size() -> None:
    told = facts()
    told["tiers"][0]["largest_px"] = 0
    assert find_invalid(told) == ""
    told["tiers"][3]["largest_px"] = 0
    assert find_invalid(told) == "tiers.largest_px"


def test_a_missing_part_is_named() -> None:
    told = facts()
    del told["impostors"]["classic"]
    assert find_invalid(told) == "impostors.classic"


def test_files_lie_inside_the_pack() -> None:
    for name in ("/etc/passwd", "people/../../x"):
        told = facts()
        told["files"][name] = "ab"
        assert find_invalid(told) == "files"


def test_no_bomb_is_unpacked() -> None:
    bomb = zlib.compress(bytes(50_000_000), 9)
    row = {"at": 0, "type": "uint16", "shape": [4]}
    assert unpack_arrays(bomb, {"corners": row})["corners"].tolist() == [0, 0, 0, 0]
    with pytest.raises(ValueError, match="more numbers"):
        unpack_arrays(bomb, {"corners": {**row, "shape": [1 << 28]}})
    with pytest.raises(ValueError, match="buffer"):  # fewer bytes than told
        unpack_arrays(zlib.compress(b"1234"), {"corners": {**row, "shape": [4000]}})


def test_a_picture_larger_than_a_page_is_refused() -> None:
    with pytest.raises(ValueError, match="larger than any page"):
        decode_webp(webp_head(16383, 16383))


def webp_head(width: int, height: int) -> bytes:
    """Return the head of a WebP picture of a size, lossless, without its pixels (RFC 9649, 2.6)."""
    bits = (width - 1) | (height - 1) << 14
    body = b"\x2f" + bits.to_bytes(4, "little") + bytes(11)
    chunk = b"VP8L" + len(body).to_bytes(4, "little") + body
    return b"RIFF" + (len(chunk) + 4).to_bytes(4, "little") + b"WEBP" + chunk
