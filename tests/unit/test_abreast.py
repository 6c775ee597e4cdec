"""Work done two by two gives what one by one gives, and fails the same way."""

from __future__ import annotations

import threading

import pytest

from cloner.abreast import abreast, beside


def test_results_come_in_the_order_of_the_items():
    first_may_end = threading.Event()

    def work(item):
        if item == 0:
            assert first_may_end.wait(5.0), "the second item was not begun beside the first"
        else:
            first_may_end.set()
        return 10 * item

    assert list(abreast(work, range(5))) == [0, 10, 20, 30, 40]


def test_the_first_failing_item_is_told():
    def work(item):
        if item % 2:
            raise ValueError(f"item {item}")
        return item

    with pytest.raises(ValueError, match="item 1"):
        list(abreast(work, range(6)))


def test_work_not_begun_is_left_when_the_caller_stops():
    begun = []
    going = abreast(begun.append, range(1000))
    next(going)
    going.close()
    assert len(begun) < 1000


def test_an_error_beside_the_block_is_raised_after_it():
    done = []

    def work():
        raise OSError("disk full")

    with pytest.raises(OSError, match="disk full"), beside(work):
        done.append(True)
    assert done


def test_the_blocks_own_error_wins():
    with pytest.raises(KeyError), beside(lambda: 1 / 0):
        raise KeyError("own")
