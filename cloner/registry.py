"""The registry of exchangeable parts: a name stands for ``module:attribute``, loaded on first use."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from typing import Any


class Registry:
    """Names of exchangeable parts, resolved lazily.

    Heavy libraries load only when their part is asked for.
    """

    def __init__(self, kind: str) -> None:
        self._kind = kind
        self._targets: dict[str, str] = {}

    def add(self, name: str, target: str) -> None:
        """Register ``target`` ("module:attribute") under ``name``.

        Raises
        ------
        ValueError
            If the name is taken or the target is malformed.
        """
        if name in self._targets:
            raise ValueError(f"{self._kind} {name!r} is registered twice")
        if target.count(":") != 1:
            raise ValueError(f"{self._kind} {name!r}: {target!r} is not 'module:attribute'")
        self._targets[name] = target

    def __iter__(self) -> Iterator[str]:
        return iter(self._targets)

    def __contains__(self, name: object) -> bool:
        return name in self._targets

    def get(self, name: str) -> Any:
        """Return the registered object.

        Raises
        ------
        KeyError
            If the name is unknown; the message lists the known ones.
        """
        if name not in self._targets:
            raise KeyError(f"unknown {self._kind} {name!r}; known: {', '.join(self._targets)}")
        module, attribute = self._targets[name].split(":")
        return getattr(importlib.import_module(module), attribute)
