"""Independent work on two threads: NumPy, OpenCV and the nets release the interpreter lock while they compute."""

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


def parallel_map(work: Callable[[Item], Result], items: Iterable[Item]) -> Iterator[Result]:
    """Yield ``work(item)`` of all items in order, two at a time.

    The results are those of one thread if ``work`` is a pure function. What it raises is raised here, that of
    the first failing item first; work not begun yet is left undone then, and also when the caller stops early.
    """
    pool = ThreadPoolExecutor(ABREAST)
    try:
        yield from pool.map(work, items)
    finally:
        pool.shutdown(cancel_futures=True)


def pipelined(
    first: Callable[[Item], Middle], second: Callable[[Item, Middle], Result], items: Iterable[Item]
) -> Iterator[Result]:
    """Yield ``second(item, first(item))`` of all items in order, two steps at a time.

    All first steps come before the second ones: the shorter the steps, the shorter one thread waits for the other
    at the end. Errors are raised as by :func:`parallel_map`, those of first steps before those of second ones.
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


def as_completed(
    work: Callable[[Item], Result], take: Callable[[], Item | None], stop: Callable[[BaseException], None]
) -> Iterator[tuple[Item, Result]]:
    """Yield items and ``work(item)`` as they complete, two at a time.

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
def in_background(work: Callable[[], object]) -> Iterator[None]:
    """Run ``work`` in another thread during the block and wait for it; its exception is raised here.

    The block's own error wins.
    """
    with ThreadPoolExecutor(1) as pool:
        pending = pool.submit(work)
        yield
        pending.result()
