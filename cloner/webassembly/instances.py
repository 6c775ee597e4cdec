"""A WebAssembly module in Python by wasmtime, with its memory as NumPy arrays.

Modules are made of the AssemblyScript beside them by `generic_models/build/build_engine.py`. They import nothing: they
can touch no file, clock or network, only their own memory.
"""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from wasmtime import Config, Engine, Func, Memory, Module, Store, WasmtimeError
from wasmtime import Instance as Running

from cloner.errors import ClonerError

#: Type and shape of an array.
Shape = tuple[str, tuple[int, ...]]
#: A module's memory ends at 4 GiB.
LARGEST_BYTES: Final = 4_000_000_000


def shapes_for(arrays: Iterable[tuple[str, str, tuple[str | int, ...]]], known: Mapping[str, int]) -> dict[str, Shape]:
    """Return type and shape of arrays (name, type, sides), a side's name being how many there are of it."""
    return {
        name: (kind, tuple(known[side] if isinstance(side, str) else side for side in sides))
        for name, kind, sides in arrays
    }


def bytes_of(shapes: Mapping[str, Shape]) -> int:
    """Return the size of arrays in bytes."""
    return sum(int(np.prod(shape, dtype=object)) * np.dtype(kind).itemsize for kind, shape in shapes.values())


class Instance:
    """One instance of a module.

    Parameters
    ----------
    module : Path
        A file (.wasm).
    counts : sequence of int
        How many there are of everything, in the module's order.
    shapes : mapping of str to Shape
        The arrays that it lends, in its order (`arrays.ts`).
    begin : sequence of number
        What its ``begin`` is called with.
    missing : ClonerError
        What is raised where there is not memory enough.

    Attributes
    ----------
    arrays : dict
        Its arrays by name, in its own memory.
    """

    def __init__(
        self,
        module: Path,
        counts: Sequence[int],
        shapes: Mapping[str, Shape],
        begin: Sequence[float],
        missing: ClonerError,
    ) -> None:
        engine, compiled = _compiled(module)
        self._store = Store(engine)
        self.arrays: dict[str, NDArray[Any]] = {}
        try:
            self._exports: Any = Running(self._store, compiled, []).exports(self._store)
            self._memory: Memory = self._exports["memory"]
            self._memory.write(self._store, np.array(counts, "<i4").tobytes(), self._exports["counts"](self._store))
            first: Func = self._exports["begin"]
            first(self._store, *begin)
        except WasmtimeError as error:
            raise missing from error
        base = ctypes.addressof(self._memory.data_ptr(self._store).contents)
        for number, (name, (kind, shape)) in enumerate(shapes.items()):
            at = base + (self._exports["at"](self._store, number) & 0xFFFFFFFF)
            self.arrays[name] = np.asarray(_Lent(self, at, shape, kind))

    def call(self, name: str, *values: float) -> Any:
        """Call what the module exports."""
        return self._exports[name](self._store, *values)

    def read(self, end: int) -> bytes:
        """Return its memory up to an end."""
        return bytes(self._memory.read(self._store, 0, end))


class _Lent:
    """A part of a module's memory for NumPy; who holds the array holds the memory."""

    def __init__(self, instance: Instance, address: int, shape: tuple[int, ...], kind: str) -> None:
        self._instance = instance
        self.__array_interface__ = {"version": 3, "data": (address, False), "shape": shape, "typestr": kind}


@lru_cache(maxsize=4)  # there are two
def _compiled(module: Path) -> tuple[Engine, Module]:
    config = Config()
    config.parallel_compilation = False  # small modules: no threads for so little
    engine = Engine(config)
    return engine, Module(engine, module.read_bytes())
