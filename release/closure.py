"""Which distributions Cloner stands on, as the environment at hand has them."""

from __future__ import annotations

import sys
import tomllib
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from pathlib import Path
from typing import Any

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).resolve().parents[1]


def project() -> dict[str, Any]:
    """Return the table [project] of pyproject.toml."""
    table: dict[str, Any] = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    return table


def closure() -> list[Distribution]:
    """Return the distributions that Cloner needs without its extras, by name; ends where one is not installed."""
    waiting = [Requirement(line) for line in project()["dependencies"]]
    found: dict[str, Distribution] = {}
    seen: set[tuple[str, frozenset[str]]] = set()
    while waiting:
        needed = waiting.pop()
        name, extras = canonicalize_name(needed.name), frozenset(needed.extras)
        if (name, extras) in seen:
            continue
        seen.add((name, extras))
        try:
            found[name] = distribution(name)
        except PackageNotFoundError:
            sys.exit(f"{name} is not installed here: pip install -e .")
        for requirement in map(Requirement, found[name].requires or ()):
            if requirement.marker is None or any(requirement.marker.evaluate({"extra": one}) for one in (*extras, "")):
                waiting.append(requirement)
    return [found[name] for name in sorted(found)]
