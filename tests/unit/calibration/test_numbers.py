"""No number stands at the head of a module without a word on what it is."""

from __future__ import annotations

import ast
from pathlib import Path

import cloner

CODE = Path(cloner.__file__).parent
#: Rooms that carry the fit: what people, photographs and nets decide lies in `cloner.calibration`.
CALIBRATED = ("body", "detectors", "editing", "head", "labels", "measure")
#: Fractions that stay beside the code there: of mathematics, of the generic human's mesh, and the steps of searches.
STAY = {
    "cascade._GUESSES", "front_features.MEAN_OF_NORMAL", "hairline.ANGLES_DEG", "nose.MEAN_OF_TWO", "lids.OVER_M",
    "lids.UNDER_M", "parts.RIM_ANGLE", "placing._NEARBY", "profile.KNOWN_SIZES", "profile.KNOWN_TILTS",
    "profile_search._SIZES", "profile_search._TILTS",
}  # fmt: skip


def numbers(node: ast.AST) -> list[float]:
    """Return the numbers written in an expression, but for 0 and 1."""
    found = [one.value for one in ast.walk(node) if isinstance(one, ast.Constant)]
    return [one for one in found if isinstance(one, int | float) and not isinstance(one, bool) and one not in (0, 1)]


def silent_numbers(source: str) -> list[str]:
    """Return the module's numbers with no comment: above them or above their run of lines, or beside them."""
    lines, silent = source.splitlines(), []
    for node in ast.parse(source).body:
        if not isinstance(node, ast.Assign | ast.AnnAssign) or node.value is None or not numbers(node.value):
            continue
        if any("#" in line for line in lines[node.lineno - 1 : node.end_lineno] if "# fmt" not in line):
            continue
        above = node.lineno - 2
        while above >= 0 and lines[above].strip() and not lines[above].startswith("#"):
            above -= 1
        if above < 0 or not lines[above].startswith("#"):
            silent.append(lines[node.lineno - 1])
    return silent


def test_the_scan_finds_a_silent_number() -> None:
    assert silent_numbers("A = 3\n") == ["A = 3"]
    assert silent_numbers("#: Legs of a table.\nA = 3\nB = 4\n\nC = (2.0, 1.0)\n") == ["C = (2.0, 1.0)"]
    assert silent_numbers("A = 3  # legs\nB = 0\nC = f(x)\n") == []


def test_every_number_says_what_it_is() -> None:
    silent = [
        f"{path.relative_to(CODE)}: {line}"
        for path in sorted(CODE.rglob("*.py"))
        for line in silent_numbers(path.read_text(encoding="utf-8"))
    ]
    assert not silent, "\n".join(silent)


def fractions(source: str) -> list[str]:
    """Return the names that a module or one of its classes gives a written fraction, but for simple ones."""
    tree, found = ast.parse(source), []
    for body in (tree.body, *(node.body for node in tree.body if isinstance(node, ast.ClassDef))):
        for node in body:
            if not isinstance(node, ast.Assign | ast.AnnAssign) or node.value is None:
                continue
            if any(isinstance(one, float) and one not in (0.5, 2.0) for one in numbers(node.value)):
                target = node.targets[0] if isinstance(node, ast.Assign) else node.target
                found.append(ast.unparse(target))
    return found


def test_the_scan_finds_a_fraction() -> None:
    assert fractions("A = 0.3\nclass Params:\n    b: float = 1.7\n    c: int = 3\nD = f(0.5)\n") == ["A", "b"]


def test_the_fit_reads_its_numbers_from_calibration() -> None:
    found = {
        f"{path.stem}.{name}"
        for room in CALIBRATED
        for path in sorted((CODE / room).rglob("*.py"))
        for name in fractions(path.read_text(encoding="utf-8"))
    }
    assert found == STAY
