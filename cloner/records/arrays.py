"""Array types, checks and immutability of frozen records."""

from __future__ import annotations

import copyreg
from types import MappingProxyType
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import DTypeLike, NDArray

#: Its shape and unit stand where it is taken or given.
Array = NDArray[np.float64]


def _read_only(mapping: dict[Any, Any]) -> MappingProxyType[Any, Any]:
    """Return a read-only view; the class itself has no importable name."""
    return MappingProxyType(mapping)


# Records hold their mappings in MappingProxyType, which pickle does not know: they go to other processes.
copyreg.pickle(MappingProxyType, lambda proxy: (_read_only, (dict(proxy),)))


def frozen_array(value: Any, name: str, dtype: DTypeLike, shape: tuple[int | None, ...]) -> NDArray[Any]:
    """Return a read-only contiguous copy of ``value`` after checking it.

    What another record has frozen already is shared instead: an atlas of 50 MiB goes through several.

    Parameters
    ----------
    value : array_like
        The array to freeze.
    name : str
        Field name used in error messages.
    dtype : dtype
        Wanted element type.
    shape : tuple of int or None
        Wanted shape; None accepts any length.

    Raises
    ------
    ValueError
        If the shape differs or a float value is not finite.
    """
    array = value if is_frozen(value) and value.dtype == dtype else np.array(value, dtype=dtype, order="C", copy=True)
    if len(shape) != array.ndim or any(
        want is not None and want != have for want, have in zip(shape, array.shape, strict=True)
    ):
        raise ValueError(f"{name} has shape {array.shape}, wanted {shape}")
    if array.dtype.kind == "f" and not bool(np.isfinite(array).all()):
        raise ValueError(f"{name} holds values that are not finite")
    array.setflags(write=False)
    return array


def is_frozen(value: Any) -> TypeGuard[NDArray[Any]]:
    """Return whether a value is an array of its own that nobody may write to, as :func:`frozen_array` leaves it."""
    return type(value) is np.ndarray and value.flags.owndata and value.flags.c_contiguous and not value.flags.writeable


def freeze(record: object, **shapes: tuple[DTypeLike, tuple[int | None, ...]]) -> None:
    """Replace the named fields of a frozen dataclass by read-only copies.

    Call from ``__post_init__`` with ``field=(dtype, shape)``.
    """
    for name, (dtype, shape) in shapes.items():
        object.__setattr__(record, name, frozen_array(getattr(record, name), name, dtype, shape))
