"""Validation of ``crowd.json``: every value is checked once before a pack is drawn."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import pairwise
from pathlib import PurePosixPath
from typing import Any, Final

from cloner.crowd.clones.faces import FEELINGS, STEP_M, TARGETS, WEIGHTS
from cloner.crowd.clones.stock import COLUMNS, MOST_CLIPS
from cloner.crowd.staged.faces import MOST_SAID
from cloner.crowd.staged.footing import COLUMNS as FOOTING
from cloner.crowd.staged.scene import ACTED, SCENES

Check = Callable[[Any], bool]

#: More than any pack has; they bound what a hostile one can make us hold.
MOST_CLONES: Final = 1000
MOST_PEOPLE: Final = 200_000
TIERS: Final = 4
LONGEST_TEXT: Final = 300
LONGEST_LIST: Final = 10_000
LARGEST_COUNT: Final = 1 << 28
GARMENTS: Final = ("top", "bottom", "shoes", "hair")


def find_invalid(facts: Any) -> str:
    """Return the name of the first invalid value in a pack's description; "" if it is valid.

    Only what Cloner reads back is looked at; other programs may add what they like.
    """
    wrong = _first_invalid(facts, _FACTS, "")
    if not wrong and ("acted" in facts or facts["scene"] == ACTED):
        wrong = _first_invalid(facts, _ACTED, "")
    if not wrong and "statues" in facts:
        wrong = _first_invalid(facts, _STATUES, "")
    if not wrong and "staging" in facts:
        wrong = _first_invalid(facts, _STAGING, "") or _unknown_staged(facts["staging"], facts.get("people_count", 0))
    if not wrong and "faces" in facts:
        wrong = _first_invalid(facts, _FACES, "")
    if not wrong and "spoken" in facts:
        wrong = _first_invalid(facts, {"faces": _FACES["faces"], **_SPOKEN}, "")
    if not wrong and "room" in facts:
        wrong = _first_invalid(facts, _ROOM, "")
    if not wrong and "echo" in facts.get("room", {}):
        wrong = _first_invalid(facts["room"]["echo"], _Rows(_number(-1e6, 1e6), 4, 4), "room.echo")
    if wrong:
        return wrong
    clones = len(facts["people"])
    if facts["looks"]["clones"] != clones:
        return "looks.clones"
    if len({row["id"] for row in facts["people"]}) != clones:
        return "people.id"
    if any(tier["largest_px"] < 1.0 for tier in facts["tiers"][1:]):
        return "tiers.largest_px"
    for garment, others in facts["looks"]["wardrobe"].items():
        if len(others) != clones or any(other >= clones for own in others for other in own):
            return f"looks.wardrobe.{garment}"
    return ""


def find_invalid_newcomer(row: Any, *, faces: bool) -> str:
    """Return the name of the first invalid value in the description of another booth's clone; "" if it is valid."""
    arrays = {**_ARRAYS, **_FEET, **({"moves": _MOVES} if faces else {})}
    wrong = _first_invalid(row, {"arrays": arrays, "stature_m": _number(0.3, 3.0)}, "")
    return wrong or ("" if set(row) == {"arrays", "stature_m"} and set(row["arrays"]) == set(arrays) else "arrays")


def _text(value: Any) -> bool:
    return isinstance(value, str) and len(value) <= LONGEST_TEXT


def _identifier(value: Any) -> bool:
    return _text(value) and value not in ("", ".", "..") and not set(value) & set("/\\\0") and value.isprintable()


def _inside(value: Any) -> bool:
    path = PurePosixPath(value) if _text(value) else PurePosixPath("..")
    return value.isprintable() and ".." not in path.parts and not path.is_absolute()


def _boolean(value: Any) -> bool:
    return isinstance(value, bool)


def _whole(low: int, high: int) -> Check:
    return lambda value: isinstance(value, int) and not isinstance(value, bool) and low <= value <= high


def _number(low: float, high: float) -> Check:
    return lambda value: isinstance(value, int | float) and not isinstance(value, bool) and low <= value <= high


class _Rows:
    """A list with a limited number of values of one kind."""

    def __init__(self, each: Any, least: int = 0, most: int = LONGEST_LIST) -> None:
        self.each, self.least, self.most = each, least, most


class _Table:
    """Values of one kind by name."""

    def __init__(self, key: Check, each: Any) -> None:
        self.key, self.each = key, each


def _first_invalid(value: Any, shape: Any, name: str) -> str:
    if isinstance(shape, _Rows):
        if not isinstance(value, list) or not shape.least <= len(value) <= shape.most:
            return name
        parts = [(f"{name}.{k}", one, shape.each) for k, one in enumerate(value)]
    elif isinstance(shape, _Table):
        if not isinstance(value, dict) or len(value) > LONGEST_LIST or not all(shape.key(key) for key in value):
            return name
        parts = [(f"{name}.{key}", one, shape.each) for key, one in value.items()]
    elif isinstance(shape, Mapping):
        if not isinstance(value, dict):
            return name or "everything"
        missing = [key for key in shape if key not in value]
        if missing:
            return f"{name}.{missing[0]}".lstrip(".")
        parts = [(f"{name}.{key}".lstrip("."), value[key], one) for key, one in shape.items()]
    else:
        return "" if shape(value) else name
    return next((wrong for part in parts if (wrong := _first_invalid(part[1], part[2], part[0]))), "")


#: Lengths and other positive numbers of a pack: no crowd is smaller or larger.
_METRES: Final = _number(1e-6, 1e6)


def _array(kind: str, *axes: int) -> Mapping[str, Any]:
    """Return the check of an array's description with these axes; 0: any length."""
    lengths = [_whole(axis, axis or LARGEST_COUNT) for axis in axes]

    def fits(value: Any) -> bool:
        return (
            isinstance(value, list)
            and len(value) == len(lengths)
            and all(length(axis) for length, axis in zip(lengths, value, strict=True))
        )

    return {"at": _whole(0, LARGEST_COUNT), "type": lambda value: value == kind, "shape": fits}


#: As :class:`cloner.crowd.clones.stock.CloneArrays` has them.
_ARRAYS: Final = {
    "vertices": _array("uint16", 0, 4), "loose": _array("uint16", 0, 4), "corners": _array("uint16", 0),
    "bones": _array("int16", 0, 0, 3, 4), "table": _array("float32", COLUMNS, 4), "tiles": _array("float32", 0, 4),
}  # fmt: skip
#: And what a newcomer has besides.
_FEET: Final = {"touches": _array("float32", 0, 48, 6), "clips": _array("float32", 0, 2)}
_MOVES: Final = _array("int16", WEIGHTS + len(FEELINGS), 0, 3)
_CLIP: Final = {
    "name": _text, "seconds": _number(0.05, 1e4), "speed_m_s": _number(0.0, 100.0), "frames": _whole(1, 1023),
}  # fmt: skip
_FACTS: Final = {
    "scene": lambda value: _text(value) and value in (*SCENES, ACTED),
    "people_count": _whole(1, MOST_PEOPLE),
    "people": _Rows({"id": _identifier, "arrays": _ARRAYS, "clips": _Rows(_CLIP, 1, MOST_CLIPS)}, 1, MOST_CLONES),
    "tiers": _Rows({"largest_px": _number(0.0, 1e6)}, TIERS, TIERS),  # the finest has no largest: 0
    "switch": {"metres_per_focal_px": _METRES, "texels_per_px": _METRES, "texels_per_m": _METRES},
    "impostors": {"views": _whole(2, 64), "rings_deg": _Rows(_number(-90.0, 90.0), 1, 4), "classic": _boolean},
    "looks": {
        "clones": _whole(1, MOST_CLONES),
        "palettes": _Table(lambda key: key in GARMENTS, _Rows(_whole(0, 0xFFFFFF))),
        "wardrobe": _Table(lambda key: key in GARMENTS, _Rows(_Rows(_whole(0, MOST_CLONES)))),
        "own_share": _number(0.0, 1.0),
        "dyed_share": _number(0.0, 1.0),
    },
    "player": {"sha256": _text},
    "files": _Table(_inside, _text),
}
_PLACE: Final = _Rows(_number(-1e6, 1e6), 3, 3)
#: As :class:`cloner.crowd.staged.footing.Acted` has them, for packs that act a scenario.
_ACTED: Final = {
    "acted": {
        "seconds": _number(0.05, 1e6),
        "arrays": {
            "footings": _array("float32", 0, FOOTING), "starts": _array("uint32", 0),
            "people": _array("float32", 0, 5, 4),
            "touches": _array("float32", 0, 0, 48, 6), "clips": _array("float32", 0, 0, 2),
            "blocks": _array("float32", 0, 6),
        },
        "views": {name: _Rows(_PLACE, 2, 2) for name in ("overview", "near", "street")},
    }
}  # fmt: skip
#: For packs whose people can speak (:mod:`cloner.crowd.clones.faces`), and for films in which they do.
_FACES: Final = {
    "faces": {
        "targets": lambda value: value == list(TARGETS), "feelings": lambda value: value == list(FEELINGS),
        "step_m": lambda value: value == STEP_M,
    },
    "people": _Rows({"face": {"moves": _MOVES}}),
}  # fmt: skip
_SPOKEN: Final = {
    "spoken": {
        "arrays": {"weights": _array("float32", 0, WEIGHTS)},
        "said": _Rows({
            "who": _whole(0, MOST_PEOPLE), "when": _number(0.0, 1e6), "first": _whole(0, LARGEST_COUNT),
            "frames": _whole(1, LARGEST_COUNT), "sound": lambda value: value == "" or _inside(value),
        }, 0, MOST_SAID),
    }
}  # fmt: skip
#: For packs whose people can be statues: the material's mean colour.
_STATUES: Final = {"statues": {"colour": _PLACE}}


def _keys(columns: int) -> Check:
    """Return the check of keys, a time and so many values each: rows of numbers, times rising."""
    row = _Rows(_number(-1e6, 1e6), columns + 1, columns + 1)

    def fits(value: Any) -> bool:
        return not _first_invalid(value, _Rows(row, 1), "keys") and all(
            one[0] <= other[0] for one, other in pairwise(value)
        )

    return fits


def _pair(first: Check, second: Check) -> Check:
    return lambda value: isinstance(value, list) and len(value) == 2 and first(value[0]) and second(value[1])


def _unknown_staged(data: Any, people: int) -> str:
    """Return what is staged of people that do not exist."""
    named = [one[0] for name in ("wakes", "hardens", "stone", "up") for one in data[name]]
    named += [one[key] for one in data["heads"] for key in ("who", "of")]
    named += [int(key[7]) for shot in data["shots"] for key in shot]
    return "" if all(one < people for one in named) else "staging"


_WHO: Final = _whole(0, MOST_PEOPLE)
#: As :mod:`cloner.crowd.staged.staging` has it.
_STAGING: Final = {
    "staging": {
        "wakes": _Rows(_pair(_WHO, _number(0.0, 1e6))), "hardens": _Rows(_pair(_WHO, _number(0.0, 1e6))),
        "stone": _Rows(_pair(_WHO, _keys(1))), "up": _Rows(_pair(_WHO, _keys(1))),
        "heads": _Rows({"who": _WHO, "of": _WHO, "until": _number(0.0, 1e6), "path": _keys(5)}),
        "shots": _Rows(_keys(8)), "light": _keys(3), "stars": _keys(1), "stops": _keys(1), "curtain": _keys(1),
        "lantern": _keys(6),
        "captions": _Rows(lambda one: isinstance(one, list) and len(one) == 3 and all(map(_number(0, 1e6), one[:2]))
                          and _text(one[2])),
    }
}  # fmt: skip
#: As :class:`cloner.crowd.staged.rooms.LitRoom` has them, for packs whose clones stand in a lit room.
_ROOM: Final = {
    "room": {
        "arrays": {
            "corners": _array("float32", 0, 8), "probes": _array("float32", 0, 0, 0, 3, 4),
            "sun": _array("float32", 0, 0, 0),
            "walkable": _array("uint8", 0, 0),
        },
        "ground_low": _Rows(_number(-1e6, 1e6), 2, 2), "ground_step": _METRES,
        "low": _PLACE, "heights": _Rows(_number(0.0, 1000.0), 1, 16), "shape": _Rows(_whole(1, 10_000), 3, 3),
        "step": _METRES, "brightest": _METRES, "sun_way": _PLACE, "sun_light": _PLACE, "sky_light": _PLACE,
        "ground": _PLACE,
    }
}  # fmt: skip
