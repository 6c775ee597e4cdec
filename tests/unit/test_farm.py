"""Plain worker processes: results, errors, deaths, and an end that leaves nothing."""

from __future__ import annotations

import multiprocessing
import time
from pathlib import Path

import pytest

from cloner.errors import ClonerError
from cloner.machines import farm
from cloner.machines.farm import run_tasks
from kit import chores


def test_results_and_errors_come_back_by_name() -> None:
    tasks = [(f"t{number}", chores.doubled, (number,), {}) for number in range(5)]
    tasks += [("bad", chores.refuse, ("no",), {}), ("odd", chores.give_a_lock, (), {})]
    found = dict(run_tasks(tasks, workers=2))
    assert [found[f"t{number}"] for number in range(5)] == [0, 2, 4, 6, 8]
    assert isinstance(found["bad"], ValueError)
    assert "cannot travel" in str(found["odd"])
    assert not multiprocessing.active_children()


def test_a_task_whose_worker_died_is_given_to_one_that_waits(tmp_path: Path) -> None:
    """The other worker has nothing left to do by then, and says nothing by itself."""
    tasks = [("slow", chores.die_once, (tmp_path / "mark", 1.0), {}), ("quick", chores.doubled, (1,), {})]
    start = time.monotonic()
    assert dict(run_tasks(tasks, workers=2)) == {"quick": 2, "slow": "second"}
    assert time.monotonic() - start < 30.0


def test_deaths_are_counted(tmp_path: Path) -> None:
    ((name, error),) = run_tasks([("once", chores.die_once, (tmp_path / "mark", 0.0), {})], workers=1, retries=0)
    assert name == "once"
    assert isinstance(error, ClonerError)
    assert "worker died" in error.message


def test_a_worker_that_dies_late_is_not_one_that_never_started(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(farm, "START_S", 1.5)
    tasks = [("once", chores.die_once, (tmp_path / "mark", 2.0), {})]
    assert dict(run_tasks(tasks, workers=1)) == {"once": "second"}


def test_workers_that_cannot_start_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(farm, "START_S", 1.0)
    monkeypatch.setattr(farm, "_serve", chores.refuse_to_serve)
    with pytest.raises(ClonerError, match="do not start"):
        list(run_tasks([("t", chores.doubled, (1,), {})], workers=1))


def test_an_early_end_lets_workers_tidy_up(tmp_path: Path) -> None:
    tasks = [("long", chores.ignore_an_end, (tmp_path / "mark",), {}), ("quick", chores.doubled, (1,), {})]
    running = run_tasks(tasks, workers=2)
    assert next(running) == ("quick", 2)
    over = time.monotonic() + 20
    while not (tmp_path / "mark").exists() and time.monotonic() < over:
        time.sleep(0.05)
    running.close()
    assert not (tmp_path / "mark").exists()
    assert not multiprocessing.active_children()
