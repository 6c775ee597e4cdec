"""Independent work two by two: NumPy, OpenCV and the nets let other threads run while they count."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from typing import Final, TypeVar

#: A booth computer has two cores to spare; more would only hold more photos in memory at once.
ABREAST: Final = 2

Item = TypeVar("Item")
Result = TypeVar("Result")


def abreast(work: Callable[[Item], Result], items: Iterable[Item]) -> Iterator[Result]:
    """Yield ``work(item)`` of all items in their order; two are worked on at a time.

    The results are those of one thread if ``work`` is a pure function. What it raises is raised here, that of
    the first failing item first; work not begun yet is left undone then, and also when the caller stops early.
    """
    pool = ThreadPoolExecutor(ABREAST)
    try:
        yield from pool.map(work, items)
    finally:
        pool.shutdown(cancel_futures=True)


@contextmanager
def beside(work: Callable[[], object]) -> Iterator[None]:
    """Do ``work`` in another thread while the block runs, and wait for it; what it raises is raised here.

    The block's own error wins.
    """
    with ThreadPoolExecutor(1) as pool:
        pending = pool.submit(work)
        yield
        pending.result()
