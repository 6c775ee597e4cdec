"""Every calibrated number says what it is and where it comes from, and is read by the module it is named for."""

from __future__ import annotations

import ast
import importlib
import re
from pathlib import Path

import pytest

import cloner
from cloner.calibration import loader
from cloner.calibration.loader import ORIGINS, UNITS, Calibrated, Entry, calibrated, modules, rooms

CODE = Path(cloner.__file__).parent
TABLES = [f"{room}.{module}" for room in rooms() for module in modules(room)]
READERS = {"number", "numbers", "pair", "triple", "quadruple", "table"}
#: Entries of which the history tells neither reason nor figure; the count may only fall.
UNKNOWN = 20
#: What the end of an entry's name promises of its unit.
SUFFIXES = {"_mm": ("mm",), "_px": ("px",), "_iod": ("iod",), "_deg": ("deg",), "_degrees": ("deg",), "_mm2": ("mm2",)}


def keys_read(path: Path) -> list[str]:
    """Return the patterns of the names that a module asks its calibration for."""
    found = []
    for call in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if not (isinstance(call, ast.Call) and isinstance(call.func, ast.Attribute) and call.func.attr in READERS):
            continue
        if not (isinstance(call.func.value, ast.Name) and call.func.value.id == "_CALIBRATED"):
            continue
        name = call.args[0]
        if isinstance(name, ast.JoinedStr):
            parts = [re.escape(part.value) if isinstance(part, ast.Constant) else ".+" for part in name.values]
            found.append("".join(parts))
        else:
            assert isinstance(name, ast.Constant)
            found.append(re.escape(name.value))
    return found


@pytest.mark.parametrize("module", TABLES)
def test_every_entry_says_what_it_is_and_where_from(module: str) -> None:
    for name, entry in calibrated(module).entries.items():
        where = f"{module}.{name}"
        assert entry.unit in UNITS, where
        assert entry.origin in ORIGINS, where
        assert re.fullmatch("[0-9a-f]{7}", entry.since), where
        for sentence in (entry.what, entry.how):
            assert len(sentence) > 4, where
            assert sentence[-1] == ".", where
        for suffix, units in SUFFIXES.items():
            if name.endswith(suffix):
                assert entry.unit in units, where


def test_fewer_and_fewer_numbers_have_no_known_origin() -> None:
    unknown = [f"{module}.{name}" for module in TABLES for name, entry in calibrated(module).entries.items()
               if entry.origin == "unknown"]  # fmt: skip
    assert len(unknown) <= UNKNOWN, "a number that comes new says where from"


@pytest.mark.parametrize("module", TABLES)
def test_every_entry_is_read_where_its_name_says(module: str) -> None:
    room, _, name = module.partition(".")
    (path,) = (CODE / room).rglob(f"{name}.py")
    patterns = keys_read(path)
    for entry in calibrated(module).entries:
        assert any(re.fullmatch(pattern, entry) for pattern in patterns), f"nobody reads {module}.{entry}"


def test_whoever_reads_calibration_reads_his_own() -> None:
    readers = [path for path in CODE.rglob("*.py") if "_CALIBRATED" in path.read_text(encoding="utf-8")]
    assert len(readers) > 50
    for path in readers:
        name = f"{path.relative_to(CODE).parts[0]}.{path.stem}"
        assert f'calibrated("{name}")' in path.read_text(encoding="utf-8"), name
        assert name in TABLES


def test_a_number_is_read_with_its_unit() -> None:
    hand = Calibrated("room.module", {
        "one_mm": Entry(2.5, "mm", "What.", "taste", "How.", "0123abc"),
        "two_mm": Entry((1.0, 2.0), "mm", "What.", "taste", "How.", "0123abc"),
        "named": Entry({"a": 3.0}, "share", "What.", "taste", "How.", "0123abc"),
    })  # fmt: skip
    assert hand.number("one_mm", "mm") == 2.5
    assert hand.pair("two_mm", "mm") == (1.0, 2.0)
    assert hand.table("named", "share") == {"a": 3.0}
    with pytest.raises(KeyError, match="is in 'mm', not in 'm'"):
        hand.number("one_mm", "m")
    with pytest.raises(KeyError, match="no single number"):
        hand.number("two_mm", "mm")
    with pytest.raises(KeyError, match="no list"):
        hand.numbers("one_mm", "mm")
    with pytest.raises(KeyError, match="no table"):
        hand.table("one_mm", "mm")
    with pytest.raises(KeyError):
        hand.number("unheard_of", "mm")
    with pytest.raises(KeyError, match="no calibration"):
        calibrated("nowhere.module")


def test_what_code_reads_is_what_the_file_says() -> None:
    text = (CODE / "calibration" / "body.toml").read_text(encoding="utf-8")
    said = re.search(r"\[bone_checks\.longest\]\nvalue = (\S+)\n", text)
    assert said is not None
    assert importlib.import_module("cloner.body.bone_checks").LONGEST == float(said.group(1))
    assert isinstance(loader.calibrated("body.bone_checks").entries["longest"].value, float)
