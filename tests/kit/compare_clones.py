"""Whether two clones are the same, bit for bit."""

from __future__ import annotations

import dataclasses
import hashlib
from collections.abc import Mapping
from typing import Any

import numpy as np


def snapshot(value: Any) -> str:
    """Return a digest of everything a record holds: types, shapes, bytes, names."""
    return hashlib.sha256("\n".join(_lines("", value)).encode()).hexdigest()


def _lines(name: str, value: Any) -> list[str]:
    if isinstance(value, np.ndarray):
        return [f"{name} {value.dtype} {value.shape} {hashlib.sha256(np.ascontiguousarray(value)).hexdigest()}"]
    if dataclasses.is_dataclass(value):
        return [
            line
            for field in dataclasses.fields(value)
            for line in _lines(f"{name}.{field.name}", getattr(value, field.name))
        ]
    if isinstance(value, Mapping):
        return [line for key, each in value.items() for line in _lines(f"{name}[{key}]", each)]
    if isinstance(value, tuple):
        return [f"{name} {len(value)}"] + [
            line for k, each in enumerate(value) for line in _lines(f"{name}[{k}]", each)
        ]
    return [f"{name} {value!r}"]
