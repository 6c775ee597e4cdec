"""CONTRIBUTING's picture is the import contracts', and what it names is there."""

from __future__ import annotations

import ast
import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TEXT = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
PLACES = {"cloner_gui": ROOT / "gui" / "cloner_gui"}


def drawn_layers() -> list[str]:
    """Return the picture's floors without the words beside them."""
    picture = TEXT.split("```\n")[1]
    return [line.split("  ")[0].strip() for line in picture.splitlines()]


def sub_rooms() -> dict[str, list[list[str]]]:
    """Return the table of sub-rooms: room to floors, the lowest first."""
    rows = re.findall(r"^\| `(\w+)` \| (`.*) \|$", TEXT, re.M)
    return {room: [re.findall(r"`(\w+)`", floor) for floor in cells.split(";")] for room, cells in rows}


def test_the_picture_is_the_contract() -> None:
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"][
        "contracts"
    ]
    (layers,) = (one["layers"] for one in contracts if one["type"] == "layers")
    assert drawn_layers() == [layer.replace("cloner.", "") for layer in layers]


def test_the_table_of_sub_rooms_is_the_folders() -> None:
    for room, floors in sub_rooms().items():
        place = PLACES.get(room, ROOT / "cloner" / room)
        there = {one.parent.name for one in place.glob("*/__init__.py")}
        assert {name for floor in floors for name in floor} == there, room
    roomy = {one.parent.parent.name for one in (ROOT / "cloner").glob("*/*/__init__.py")}
    assert roomy - set(sub_rooms()) == {"behaviour"}, "its core and eight group behaviours are no walls"


def test_sub_rooms_import_only_lower_ones() -> None:
    for room, floors in sub_rooms().items():
        package = room if room in PLACES else f"cloner.{room}"
        height = {name: k for k, floor in enumerate(floors) for name in floor}
        for name, own in height.items():
            for path in (PLACES.get(room, ROOT / "cloner" / room) / name).rglob("*.py"):
                for asked in imported(path, package):
                    assert asked == name or height.get(asked, -1) < own, f"{path.relative_to(ROOT)} imports {asked}"


def imported(path: Path, package: str) -> set[str]:
    """Return the sub-rooms of a package that a module imports, not for types alone."""
    found = set()
    tree = ast.parse(path.read_text(encoding="utf-8"))
    for_types = {
        one
        for node in ast.walk(tree)
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test)
        for one in ast.walk(node)
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node not in for_types and (node.module or "").startswith(f"{package}."):
            found.add((node.module or "").removeprefix(f"{package}.").split(".")[0])
    return found


def test_files_that_are_named_exist() -> None:
    named = {one for one in re.findall(r"`([\w/]+\.(?:py|toml|md))`", TEXT) if "NAME" not in one and "ROOM" not in one}
    roots = [
        ROOT / place for place in (".", "cloner", "cloner/calibration", "gui", "gui/cloner_gui", "generic_models/build")
    ]
    roots += [ROOT / "gui" / "cloner_gui" / "language"]
    assert len(named) > 15
    assert not [one for one in named if not any((root / one).is_file() for root in roots)]


def test_scripts_use_no_private_names() -> None:
    """What several benchmarks need of the wiring stands in ``cloner.testing``."""
    for folder in ("benchmarks", "generic_models/build", "release"):
        for path in (ROOT / folder).glob("*.py"):
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("cloner"):
                    assert not [one.name for one in node.names if one.name.startswith("_")], path.name


def test_nothing_of_the_product_uses_the_door_for_benchmarks() -> None:
    for package in (ROOT / "cloner", ROOT / "gui" / "cloner_gui"):
        for path in package.rglob("*.py"):
            assert "cloner.testing" not in path.read_text(encoding="utf-8"), path.name
