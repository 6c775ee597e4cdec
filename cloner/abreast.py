"""Independent work two by two: NumPy, OpenCV and the nets let other threads run while they count."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from typing import Final, TypeVar

#: A booth computer has two cores to spare; more would only hold more photos in memory at once.
ABREAST: Final = 2

Item = TypeVar("Item")
Middle = TypeVar("Middle")
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


def in_two_steps(
    first: Callable[[Item], Middle], second: Callable[[Item, Middle], Result], items: Iterable[Item]
) -> Iterator[Result]:
    """Yield ``second(item, first(item))`` of all items in their order; two steps are worked on at a time.

    All first steps come before the second ones: the shorter the steps, the shorter one thread waits for the other
    at the end. Errors are raised as by :func:`abreast`, those of first steps before those of second ones.
    """
    everything = list(items)
    with ThreadPoolExecutor(ABREAST) as pool:
        halves = [pool.submit(first, item) for item in everything]
        wholes = [pool.submit(_second, second, item, half) for item, half in zip(everything, halves, strict=True)]
        try:
            for half in halves:
                half.result()
            while wholes:
                halves.pop(0)
                yield wholes.pop(0).result()
        finally:
            pool.shutdown(cancel_futures=True)


def _second(second: Callable[[Item, Middle], Result], item: Item, half: Future[Middle]) -> Result:
    return second(item, half.result())


def as_ready(
    work: Callable[[Item], Result], take: Callable[[], Item | None], stop: Callable[[BaseException], None]
) -> Iterator[tuple[Item, Result]]:
    """Yield items and ``work(item)`` as they end; two are worked on at a time.

    What ``work`` raises is raised here, after the work beside it has ended.

    Parameters
    ----------
    work : callable
    take : callable
        Gives the next item, or None where nothing can be begun before more has ended; called on this thread only.
    stop : callable
        Gets what ends all this early, an interrupt say, so that work can be told to end: it is waited for.
    """
    running: dict[Future[Result], Item] = {}
    with ThreadPoolExecutor(ABREAST) as pool:
        try:
            while True:
                while len(running) < ABREAST and (item := take()) is not None:
                    running[pool.submit(work, item)] = item
                if not running:
                    return
                ended = wait(running, return_when=FIRST_COMPLETED).done
                first = next(future for future in running if future in ended)
                yield running.pop(first), first.result()
        except BaseException as error:
            stop(error)
            raise


@contextmanager
def beside(work: Callable[[], object]) -> Iterator[None]:
    """Do ``work`` in another thread while the block runs, and wait for it; what it raises is raised here.

    The block's own error wins.
    """
    with ThreadPoolExecutor(1) as pool:
        pending = pool.submit(work)
        yield
        pending.result()
