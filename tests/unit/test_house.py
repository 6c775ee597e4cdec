"""The house rules that a script can see: short files, short functions, nothing said twice."""

from __future__ import annotations

import ast
import re
import tomllib
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CLONER = ROOT / "cloner"
FILE_LINES, FUNCTION_LINES = 300, 60
FOLDER_FILES = 20
#: Functions of fewer nodes, docstring left out, may say the same: accessors of one line.
TWIN_NODES = 20


def functions() -> Iterator[tuple[str, ast.FunctionDef]]:
    for path in sorted(CLONER.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.FunctionDef):
                yield path.relative_to(CLONER).as_posix(), node


def said(function: ast.FunctionDef) -> tuple[str, int]:
    """Return what a function does, without its name, docstring, types, and its own variables' names; and how much."""
    body = function.body[1:] if ast.get_docstring(function) is not None else function.body
    own = {n.arg for n in ast.walk(function) if isinstance(n, ast.arg)}
    own |= {n.id for n in ast.walk(function) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
    names: dict[str, str] = {}
    nodes = [node for one in body for node in ast.walk(one)]
    for node in nodes:
        if isinstance(node, ast.Name) and node.id in own:
            node.id = names.setdefault(node.id, f"v{len(names)}")
        if isinstance(node, ast.arg):
            node.arg, node.annotation = names.setdefault(node.arg, f"v{len(names)}"), None
    return "\n".join(ast.dump(one) for one in body), len(nodes)


def test_files_and_functions_are_short() -> None:
    files = {p.relative_to(CLONER).as_posix(): p.read_text(encoding="utf-8").count("\n") for p in CLONER.rglob("*.py")}
    assert not {name: lines for name, lines in files.items() if lines > FILE_LINES}
    lengths = {(file, f.name): (f.end_lineno or 0) - f.lineno + 1 for file, f in functions()}
    assert not {where: lines for where, lines in lengths.items() if lines > FUNCTION_LINES}


def test_folders_are_small() -> None:
    places = [path.parent for root in (CLONER, CLONER.parent / "gui") for path in root.rglob("*.py")]
    files = {str(place.relative_to(CLONER.parent)): places.count(place) for place in places}
    assert len(files) > 80, "both packages are read"
    assert not {folder: count for folder, count in files.items() if count > FOLDER_FILES}


def test_no_two_functions_say_the_same() -> None:
    alike = defaultdict(list)
    for file, function in functions():
        what, size = said(function)
        if size >= TWIN_NODES:
            alike[what].append(f"{file} {function.name}")
    assert not [where for where in alike.values() if len(where) > 1]


def test_words_that_context_explains_are_used() -> None:
    context = (CLONER.parent / "CONTEXT.md").read_text(encoding="utf-8")
    words = [word for row in re.findall(r"^\| ([^|-]+) \|", context, re.M) for word in row.split(", ")]
    text = "\n".join(path.read_text(encoding="utf-8") for path in CLONER.rglob("*.py"))
    used = re.sub(r"[^a-z]+", " ", re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text).lower())
    assert not [word for word in words if word.lower() not in used]


def test_every_folder_of_tests_is_run() -> None:
    """They are named one by one, the longest first."""
    asked = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["pytest"]["ini_options"]
    there = {f"tests/{path.relative_to(ROOT / 'tests').parts[0]}" for path in (ROOT / "tests").rglob("test_*.py")}
    assert set(asked["testpaths"]) == there
