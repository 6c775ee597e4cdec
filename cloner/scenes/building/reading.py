"""Reading of a plan's text file; `docs/scenes.md` describes its tables."""

from __future__ import annotations

import importlib.resources
import re
import tomllib
from dataclasses import MISSING, fields
from pathlib import Path
from typing import Any, Final

from cloner.errors import ClonerError, printable
from cloner.scenes.building.looks import LOOKS
from cloner.scenes.building.plan import (
    LARGEST,
    Block,
    Ceiling,
    Floor,
    Lamp,
    Opening,
    Photographed,
    Plan,
    Sky,
    Sun,
    Vault,
    Wall,
)
from cloner.untrusted import UnsuitableFile, read_untrusted

#: Plans that come with Cloner.
SHIPPED: Final = ("museum", "nave", "pit")
LARGEST_PLAN_BYTES: Final = 1_000_000
LARGEST_FLOOR_M2: Final = 20_000.0
MOST_PARTS: Final = 500
#: Photographs of a plan, the texels that a side of one may have, and pixels that no photo's corner is beyond.
MOST_PHOTOS: Final = 20
MOST_TEXELS: Final = 2048
SMALLEST_TEXEL_M: Final = 1e-4
LARGEST_PX: Final = 100_000.0
_NAME: Final = re.compile(r"[a-z][a-z0-9_]{0,30}")


def read_plan(source: str | Path) -> tuple[Plan, str]:
    """Return a shipped plan by its name, or a file's plan, and its text.

    Raises
    ------
    ClonerError
        If there is none, or it says something that cannot be built.
    """
    if str(source) in SHIPPED:
        text = (importlib.resources.files("cloner.scenes") / "plans" / f"{source}.toml").read_text(encoding="utf-8")
        return parse_plan(text, str(source)), text
    path = Path(source)
    try:
        text = read_untrusted(path, LARGEST_PLAN_BYTES).decode("utf-8")
    except (OSError, UnsuitableFile, UnicodeDecodeError) as error:
        hint = f"Give {', '.join(SHIPPED)} or a plan's file (docs/scenes.md)"
        raise ClonerError("there is no plan", hint, path.name) from error
    return parse_plan(text, path.name), text


def parse_plan(text: str, where: str) -> Plan:
    """Return the plan of a text; see :func:`read_plan`."""
    try:
        return _plan(tomllib.loads(text))
    except _Wrong as error:
        raise ClonerError(
            f"the plan says {printable(str(error))}", "Write it as docs/scenes.md shows", where
        ) from error
    except (ValueError, RecursionError) as error:  # numbers of thousands of digits are no TOML errors
        hint = "Write it as docs/scenes.md shows"
        raise ClonerError(f"the plan cannot be read: {printable(str(error))}", hint, where) from error


class _Wrong(ValueError):
    pass


_RENAMED: Final = {"from": "low", "to": "high"}


def _plan(data: dict[str, Any]) -> Plan:
    known = ("name", "sun", "sky", "floor", "wall", "ceiling", "vault", "pillar", "block", "lamp", "photo")
    for key in data:
        if key not in known:
            raise _Wrong(f"{key!r}, which is none of {', '.join(known)}")
    blocks = [_row(Block, one, "block", {"pillar": False}) for one in _rows(data, "block")]
    for row in _rows(data, "pillar"):
        names, places = row.pop("names", None), row.pop("at", None)
        if not (isinstance(names, list) and isinstance(places, list) and len(names) == len(places)):
            raise _Wrong("a pillar without as many names as places (at)")
        blocks += [_row(Block, {**row, "name": a, "at": b}, "pillar", {"pillar": True})
                   for a, b in zip(names, places, strict=True)]  # fmt: skip
    walls = []
    for row in _rows(data, "wall"):
        if "high" in row:
            row["height"] = row.pop("high")
        openings = row.pop("openings", [])
        if not isinstance(openings, list):
            raise _Wrong("openings that are no list")
        made = tuple(_row(Opening, one, "opening", {}, {}) for one in openings)
        walls.append(_row(Wall, row, "wall", {"openings": made}))
    plan = Plan(
        str(data.get("name", "room")), tuple(_row(Floor, one, "floor") for one in _rows(data, "floor")), tuple(walls),
        tuple(_row(Ceiling, one, "ceiling") for one in _rows(data, "ceiling")),
        tuple(_row(Vault, one, "vault") for one in _rows(data, "vault")), tuple(blocks),
        tuple(_row(Lamp, one, "lamp") for one in _rows(data, "lamp")),
        tuple(_row(Photographed, one, "photo") for one in _rows(data, "photo")),
        _row(Sun, data["sun"], "sun") if "sun" in data else None,
        _row(Sky, data["sky"], "sky") if "sky" in data else Sky((0.0, 0.0, 0.0)),
    )  # fmt: skip
    return _checked(plan)


def _rows(data: dict[str, Any], name: str) -> list[dict[str, Any]]:
    rows = data.get(name, [])
    if not isinstance(rows, list) or not all(isinstance(one, dict) for one in rows) or len(rows) > MOST_PARTS:
        raise _Wrong(f"{name} not as [[{name}]], or more than {MOST_PARTS} of them")
    return [dict(one) for one in rows]


def _row(kind: Any, data: Any, name: str, given: dict[str, Any] | None = None, renamed: Any = _RENAMED) -> Any:
    """Return a record from a table; only numbers in bounds, known names and looks are accepted."""
    if not isinstance(data, dict):
        raise _Wrong(f"a {name} that is no table")
    given = given or {}
    own = {renamed.get(key, key): value for key, value in data.items()}
    shown = {value: key for key, value in renamed.items()}
    known = {one.name: one for one in fields(kind) if one.name not in given}
    for key in own:
        if key not in known:
            raise _Wrong(f"{shown.get(key, key)!r} of a {name}, which has none")
    for key, one in known.items():
        if key not in own and one.default is MISSING:
            raise _Wrong(f"a {name} without {('high' if key == 'height' else shown.get(key, key))!r}")
    return kind(**given, **{key: _value(str(known[key].type), value, f"{name}'s {key}") for key, value in own.items()})


def _value(kind: str, value: Any, name: str) -> Any:
    if kind == "str":
        if not isinstance(value, str) or len(value) > 100:
            raise _Wrong(f"an odd {name}")
        return value
    if kind == "Corners":
        fits = (
            isinstance(value, list)
            and len(value) == 4
            and all(isinstance(one, list) and len(one) == 2 for one in value)
        )
        if not (fits and all(_number(one, LARGEST_PX) for pair in value for one in pair)):
            raise _Wrong(f"{name} that are not four places, each as [x, y] in pixels")
        return tuple((float(x), float(y)) for x, y in value)
    long = {"float": 0, "XY": 2, "RGB": 3, "tuple[float, float, float]": 3}[kind]
    parts = value if long else [value]
    if not isinstance(parts, list) or len(parts) != max(long, 1) or not all(_number(one) for one in parts):
        raise _Wrong(f"a {name} that is not {long or 'one'} number{'s' if long else ''} up to {LARGEST:g}")
    return tuple(float(one) for one in parts) if long else float(value)


def _number(value: Any, largest: float = LARGEST) -> bool:
    whole = isinstance(value, int | float) and not isinstance(value, bool)
    return whole and abs(value) <= largest  # neither inf nor nan


def _checked(plan: Plan) -> Plan:
    """Refuse a plan without an inside."""
    if not plan.floors:
        raise _Wrong("no floor")
    for name, parts in (
        ("floor", plan.floors),
        ("wall", plan.walls),
        ("ceiling", plan.ceilings),
        ("vault", plan.vaults),
    ):
        for one in parts:
            if not (one.low[0] < one.high[0] and one.low[1] < one.high[1]):
                raise _Wrong(f"a {name} whose 'to' is not right of and above its 'from'")
    if sum((one.high[0] - one.low[0]) * (one.high[1] - one.low[1]) for one in plan.floors) > LARGEST_FLOOR_M2:
        raise _Wrong(f"more than {LARGEST_FLOOR_M2:g} m2 of floor")
    for wall in plan.walls:
        long = 0 if wall.high[0] - wall.low[0] >= wall.high[1] - wall.low[1] else 1
        if wall.height <= 0.0:
            raise _Wrong("a wall without height")
        for hole in wall.openings:
            inside = wall.low[long] < hole.at - hole.wide / 2.0 and hole.at + hole.wide / 2.0 < wall.high[long]
            if not (inside and 0.0 <= hole.low < hole.high < wall.height and hole.wide > 0.0):
                raise _Wrong("an opening that does not lie in its wall")
    for block in plan.blocks:
        if min(block.size) <= 0.0 or not 0.0 <= block.low < block.high:
            raise _Wrong(f"{block.name!r} without a size")
    if any(one.radius <= 0.0 or min(one.light) < 0.0 for one in plan.lamps):
        raise _Wrong("a lamp without radius, or darker than dark")
    if plan.sun and not (0.0 < plan.sun.elevation_deg <= 90.0 and min(plan.sun.light) >= 0.0):
        raise _Wrong("a sun below the horizon, or darker than dark")
    _check_looks(plan)
    return plan


def _check_looks(plan: Plan) -> None:
    """Refuse photos that cannot be rectified, and unknown looks."""
    if len(plan.photos) > MOST_PHOTOS:
        raise _Wrong(f"more than {MOST_PHOTOS} photos")
    known = list(LOOKS)
    for one in plan.photos:
        if not _NAME.fullmatch(one.name) or one.name in known:
            raise _Wrong(f"a photo called {one.name!r}, which is no word of small letters, or another look's name")
        known.append(one.name)
        if Path(one.file).is_absolute() or ".." in Path(one.file).parts or "\\" in one.file:
            raise _Wrong(f"a photo {one.name} that does not lie beside the plan")
        x, y = zip(*one.corners, strict=True)
        turns = [
            (x[k - 1] - x[k - 2]) * (y[k] - y[k - 1]) - (y[k - 1] - y[k - 2]) * (x[k] - x[k - 1]) for k in range(4)
        ]
        if min(turns) < 1.0:
            raise _Wrong(f"corners of the photo {one.name} that are not top left, top right, bottom right, bottom left")
        if one.texel < SMALLEST_TEXEL_M or not all(2 <= side <= MOST_TEXELS for side in one.texels):
            raise _Wrong(f"a photo {one.name} whose size is not 2 to {MOST_TEXELS} of its texels each way")
    for parts in (plan.floors, plan.walls, plan.ceilings, plan.vaults, plan.blocks):
        for part in parts:
            if part.look not in known:
                raise _Wrong(f"the look {part.look!r}, which is none of {', '.join(known)}")
