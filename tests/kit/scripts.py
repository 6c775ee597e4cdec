"""Scripts outside the packages, imported by file so that tests can call what they are made of."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from types import ModuleType

_ROOT = Path(__file__).resolve().parents[2]
FOLDERS = (_ROOT / "benchmarks", _ROOT / "generic_models" / "build")


def script(name: str) -> ModuleType:
    """Return a module of benchmarks/ or generic_models/build/, with its neighbours importable as they expect."""
    for folder in map(str, FOLDERS):
        if folder not in sys.path:
            sys.path.append(folder)
    return importlib.import_module(name)
