"""Cloner: five photographs and a height in, an animatable textured human out."""

from __future__ import annotations

import importlib
import os
from typing import TYPE_CHECKING, Any

# A sum's last digits depend on how many threads share it: with one, every process gives the same bytes.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

if TYPE_CHECKING:
    from cloner.making import clone

__version__ = "0.2.0"
__all__ = ["__version__", "clone"]


def __getattr__(name: str) -> Any:
    """Load what needs the whole product only when somebody asks for it: ``cloner doctor`` must work without."""
    if name == "clone":
        return importlib.import_module("cloner.making").clone
    raise AttributeError(f"module 'cloner' has no attribute {name!r}")
