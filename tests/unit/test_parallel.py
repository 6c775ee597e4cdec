"""Work done two by two gives what one by one gives, and fails the same way."""

from __future__ import annotations

import threading
import time

import pytest

from cloner.parallel import as_completed, in_background, parallel_map, pipelined


def test_results_come_in_the_order_of_the_items():
    first_may_end = threading.Event()

    def work(item):
        if item == 0:
            assert first_may_end.wait(5.0), "the second item was not begun beside the first"
        else:
            first_may_end.set()
        return 10 * item

    assert list(parallel_map(work, range(5))) == [0, 10, 20, 30, 40]


def test_the_first_failing_item_is_told():
    def work(item):
        if item % 2:
            raise ValueError(f"item {item}")
        return item

    with pytest.raises(ValueError, match="item 1"):
        list(parallel_map(work, range(6)))


def test_work_not_begun_is_left_when_the_caller_stops():
    begun = []

    def work(item):
        begun.append(item)
        time.sleep(0.02)  # all of them take 10 s: no scheduler begins the last before the caller stops

    going = parallel_map(work, range(1000))
    next(going)
    going.close()
    assert len(begun) < 1000


def test_work_is_told_to_end_when_the_caller_is_interrupted():
    items, told = ["quick", "long"], threading.Event()

    def work(name):
        return name == "quick" or told.wait(5.0)

    going = as_completed(work, lambda: items.pop(0) if items else None, stop=lambda error: told.set())
    assert next(going) == ("quick", True)
    with pytest.raises(KeyboardInterrupt):
        going.throw(KeyboardInterrupt)
    assert told.is_set()


def test_an_error_beside_the_block_is_raised_after_it():
    done = []

    def work():
        raise OSError("disk full")

    with pytest.raises(OSError, match="disk full"), in_background(work):
        done.append(True)
    assert done


def test_the_blocks_own_error_wins():
    with pytest.raises(KeyError), in_background(lambda: 1 / 0):
        raise KeyError("own")


def test_second_steps_get_what_the_first_ones_gave_in_the_order_of_the_items():
    begun = []

    def first(item):
        begun.append(("first", item))
        return 10 * item

    def second(item, half):
        begun.append(("second", item))
        return item, half

    assert list(pipelined(first, second, range(5))) == [(item, 10 * item) for item in range(5)]
    assert {step for step, _ in begun[:4]} == {"first"}, "first steps come first"
    assert list(pipelined(first, second, [])) == []


def test_a_failing_first_step_is_told_before_any_second_one():
    def first(item):
        if item == 2:
            raise ValueError("item 2")
        return item

    def second(item, half):
        raise KeyError(item)

    with pytest.raises(ValueError, match="item 2"):
        list(pipelined(first, second, range(4)))


def test_what_is_ready_goes_on_beside_slower_work():
    waiting, done = ["slow", "quick", "after quick"], []
    quick_ended = threading.Event()

    def take():
        ready = next((name for name in waiting if name != "after quick" or "quick" in done), None)
        if ready is not None:
            waiting.remove(ready)
        return ready

    def work(name):
        if name == "after quick":
            quick_ended.set()
        return name != "slow" or quick_ended.wait(5.0)

    for name, well in as_completed(work, take, stop=pytest.fail):
        assert well, "nothing was begun beside the slow work"
        done.append(name)
    assert sorted(done) == ["after quick", "quick", "slow"]
