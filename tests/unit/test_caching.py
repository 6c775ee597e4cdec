"""What is remembered is made once for each object and forgotten with it."""

from __future__ import annotations

import gc
import threading

import numpy as np

from cloner.caching import cached_per_object


def test_it_is_made_once_for_each_very_object() -> None:
    asked: list[int] = []

    @cached_per_object
    def total(values: np.ndarray) -> float:
        asked.append(len(values))
        return float(values.sum())

    first, twin, longer = np.ones(2), np.ones(2), np.ones(3)
    assert [total(first), total(first), total(twin), total(longer), total(first)] == [2.0, 2.0, 2.0, 3.0, 2.0]
    assert asked == [2, 2, 3], "equal arrays are two objects"


def test_it_is_forgotten_with_its_object_and_its_place_is_free_for_the_next() -> None:
    @cached_per_object
    def first_value(values: np.ndarray) -> float:
        return float(values[0])

    for value in range(200):  # a new array takes the place of the last one sooner or later
        thing = np.full(4, float(value))
        assert first_value(thing) == value
        del thing
        gc.collect(0)


def test_two_threads_that_ask_for_the_same_get_one_value() -> None:
    made: list[object] = []
    begun, go = threading.Event(), threading.Event()

    @cached_per_object
    def slow(_: np.ndarray) -> object:
        begun.set()
        go.wait(5.0)
        made.append(object())
        return made[-1]

    thing, got = np.zeros(1), []
    threads = [threading.Thread(target=lambda: got.append(slow(thing))) for _ in range(2)]
    threads[0].start()
    begun.wait(5.0)
    threads[1].start()
    go.set()
    for thread in threads:
        thread.join(5.0)
    assert len(made) == 1
    assert got == [made[0], made[0]]
