"""The core in Python: its module is run by wasmtime, and its arrays are NumPy's, in the same memory.

The module (`walkers.wasm`; its source lies beside it, `generic_models/build/build_walkers.py` makes it) imports
nothing: it can touch no file, clock or network, only its own memory.
"""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from wasmtime import Config, Engine, Func, Instance, Memory, Module, Store, WasmtimeError

from cloner.errors import ClonerError

MODULE: Final = Path(__file__).with_name("walkers.wasm")
#: The core's arrays in the order of `at` in `memory.ts`: what each holds a row, type and width.
ARRAYS: Final = (
    ("place", "<f8", 2), ("velocity", "<f8", 2), ("way", "<f8", 2), ("wants", "<f8", 1), ("own_speed", "<f8", 1),
    ("radius", "<f8", 1), ("target", "<f8", 2), ("facing", "<f8", 2), ("look", "<f8", 2), ("goal", "<i4", 1),
    ("present", "|b1", 1), ("avoids", "|b1", 1), ("spotted", "|b1", 1), ("settled", "|b1", 1), ("wanders", "|b1", 1),
    ("looks", "|b1", 1), ("clear", "<f8", 1), ("walls", "<f8", 4), ("near", "<i4", 1), ("fields", "<f8", 2),
    ("regions", "|b1", 1), ("others", "<i4", 16), ("direct", "|b1", 1), ("slow", "<i4", 1), ("distance", "<f8", 1),
)  # fmt: skip
#: A module's memory ends at 4 GiB; a person takes 450 bytes, a cell 310 and 17 a place, walls 32.
_LARGEST_BYTES: Final = 4_000_000_000


class _Lent:
    """A part of the core's memory for NumPy; who holds the array holds the memory."""

    def __init__(self, core: Core, address: int, shape: tuple[int, ...], kind: str) -> None:
        self._core = core
        self.__array_interface__ = {"version": 3, "data": (address, False), "shape": shape, "typestr": kind}


class Core:
    """One instance of the module: one world.

    Parameters
    ----------
    people, places, walls : int
    cells : (rows, cols)
    reach : int
        How many walls the list of a cell holds.
    low : (2,) metres
        The raster's corner.
    period_m : float
        > 0: the world repeats along x.
    seed : int

    Raises
    ------
    ClonerError
        If there is not memory enough.
    """

    def __init__(
        self, *, people: int, places: int, walls: int, cells: tuple[int, int], reach: int, low: tuple[float, float],
        period_m: float, seed: int,
    ) -> None:  # fmt: skip
        area = cells[0] * cells[1]
        if people * 450 + area * (310 + 4 * reach + 17 * places) + walls * 32 > _LARGEST_BYTES:
            raise ClonerError(
                "the floor is too large for so many points", "Make it smaller, or take points away", "floor"
            )
        engine, module = _module()
        self._store = Store(engine)
        seed = (seed + (1 << 63)) % (1 << 64) - (1 << 63)  # as the signed number that passes
        try:
            self._exports: Any = Instance(self._store, module, []).exports(self._store)
            begin: Func = self._exports["begin"]
            begin(self._store, people, *cells, walls, reach, places, *low, period_m, seed)
        except WasmtimeError as error:
            raise ClonerError("there is not memory enough for the crowd", "Close other programs", "crowd") from error
        counts = {"clear": area, "distance": area, "near": area * reach, "walls": walls, "fields": places * area,
                  "regions": places * area}  # fmt: skip
        memory: Memory = self._exports["memory"]
        base = _address(memory, self._store)
        self.arrays: dict[str, NDArray[Any]] = {}
        for number, (name, kind, width) in enumerate(ARRAYS):
            count = counts.get(name, people)
            shape = (count,) if width == 1 else (count, width)
            at = base + (self._exports["at"](self._store, number) & 0xFFFFFFFF)
            self.arrays[name] = np.asarray(_Lent(self, at, shape, kind))

    def ready(self) -> None:
        """Cast the rays over the raster, when `clear`, `walls` and `near` are filled."""
        self._exports["ready"](self._store)

    def lead(self, place: int) -> None:
        """Find the directions to a place, when `distance` is filled."""
        self._exports["lead"](self._store, place)

    def step(self) -> None:
        """Let a step pass."""
        self._exports["step"](self._store)


def _address(memory: Memory, store: Store) -> int:
    import ctypes

    return ctypes.addressof(memory.data_ptr(store).contents)


@lru_cache(maxsize=1)
def _module() -> tuple[Engine, Module]:
    config = Config()
    config.parallel_compilation = False  # 15 kB: no threads for so little
    engine = Engine(config)
    return engine, Module(engine, MODULE.read_bytes())
