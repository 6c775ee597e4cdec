"""Values of the pipeline kept between runs: frozen records in one .npz, read back without executing code.

A record is written as its fields, by the name of its class; reading makes only dataclasses and enumerations of this
package, so a file from elsewhere can be wrong but can do nothing (a pickle could).
"""

from __future__ import annotations

import importlib
import json
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.project.archives import BROKEN, open_archive
from cloner.project.atomic import atomic_path

FORMAT: Final = 1
LARGEST_BYTES: Final = 1_000_000_000  # taste: many times the values of five large photos
_HOMES: Final = ("cloner.records.", "cloner.frames", "cloner.pipeline")
_SKELETON: Final = "skeleton_json"


def save_values(values: Mapping[str, object], path: Path) -> None:
    """Write named values in one step: numbers, texts, arrays, tuples, mappings, enumerations and frozen records.

    Raises
    ------
    ClonerError
        If the file cannot be written.
    TypeError
        If a value is of another kind.
    """
    arrays: dict[int, NDArray[Any]] = {}
    data = {"format": FORMAT, "values": _to_json(dict(values), arrays)}
    text = np.frombuffer(json.dumps(data).encode(), dtype=np.uint8)
    try:
        path.parent.mkdir(exist_ok=True)
        with atomic_path(path) as temporary, temporary.open("wb") as stream:
            packed: dict[str, NDArray[Any]] = {f"a{number}": array for number, array in enumerate(arrays.values())}
            np.savez_compressed(stream, allow_pickle=False, **{_SKELETON: text}, **packed)
    except OSError as error:
        raise ClonerError("the work folder cannot be written", "Check permissions and space", path.name) from error


def load_values(path: Path) -> dict[str, Any]:
    """Return the values of :func:`save_values`; nothing where the file is missing, broken or of another version.

    What is kept here can always be found again, so an unreadable file is no error.
    """
    try:
        with open_archive(path, LARGEST_BYTES) as archive:
            arrays = [archive[f"a{number}"] for number in range(len(archive.files) - 1)]
            data = json.loads(archive[_SKELETON].tobytes())
        return dict(_from_json(data["values"], arrays)) if data["format"] == FORMAT else {}
    except (*BROKEN, ImportError):
        return {}


def _to_json(value: Any, arrays: dict[int, NDArray[Any]]) -> Any:
    """Return a value as JSON; arrays are put aside, each once."""
    if isinstance(value, Enum):
        return {"enum": _name(type(value)), "value": value.value}
    if isinstance(value, np.generic):
        value = value.item()
    if value is None or isinstance(value, bool | int | float | str):
        return value
    if isinstance(value, np.ndarray):
        arrays.setdefault(id(value), value)
        return {"array": list(arrays).index(id(value))}
    if isinstance(value, tuple | list):
        return {"tuple": [_to_json(one, arrays) for one in value]}
    if isinstance(value, Mapping):
        return {"map": [[_to_json(key, arrays), _to_json(one, arrays)] for key, one in value.items()]}
    if is_dataclass(value) and not isinstance(value, type):
        inner = {one.name: _to_json(getattr(value, one.name), arrays) for one in fields(value)}
        return {"record": _name(type(value)), "fields": inner}
    raise TypeError(f"a {type(value).__name__} cannot be kept")


def _from_json(data: Any, arrays: list[NDArray[Any]]) -> Any:
    """Return the value of its JSON."""
    if not isinstance(data, dict):
        return data
    if "array" in data:
        return arrays[data["array"]]
    if "tuple" in data:
        return tuple(_from_json(one, arrays) for one in data["tuple"])
    if "map" in data:
        return {_from_json(key, arrays): _from_json(one, arrays) for key, one in data["map"]}
    if "enum" in data:
        return _class(data["enum"], Enum)(data["value"])
    kind = _class(data["record"], None)
    return kind(**{name: _from_json(one, arrays) for name, one in data["fields"].items()})


def _name(kind: type) -> str:
    if not kind.__module__.startswith(_HOMES):
        raise TypeError(f"a {kind.__name__} cannot be kept")  # it could not be read again
    return f"{kind.__module__}:{kind.__qualname__}"


def _class(name: str, base: type | None) -> Any:
    """Return a class of this package by name, and nothing else."""
    module, _, attribute = name.partition(":")
    if not module.startswith(_HOMES) or not attribute.isidentifier():
        raise ValueError(f"{name} is no record")
    kind = getattr(importlib.import_module(module), attribute)
    fits = isinstance(kind, type) and (issubclass(kind, base) if base else is_dataclass(kind))
    if not fits:
        raise ValueError(f"{name} is no record")
    return kind
