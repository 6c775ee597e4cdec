"""The numbers of a day, counted by hand."""

import csv
import io
from dataclasses import replace
from pathlib import Path

import pytest

from cloner.booth.events.day import days_csv, statistics_by_day
from cloner.booth.photos.photo_problems import PhotoCheck, PhotoProblem
from cloner.booth.visitors import waiting_line
from cloner.booth.visitors.visits import State, Visit


@pytest.fixture(autouse=True)
def by_the_sun(monkeypatch):
    import time

    monkeypatch.setenv("TZ", "UTC")
    time.tzset()
    yield
    monkeypatch.undo()
    time.tzset()


def visit(day, state, queued="", finished="", problem=""):
    at = f"2026-11-{day}T"
    return Visit(
        started=at + "10:00:00+00:00", state=state, problem=problem,
        queued=queued and f"{at}{queued}+00:00", finished=finished and f"{at}{finished}+00:00",
    )  # fmt: skip


VISITS = {
    Path("visitor-001"): visit(21, State.CLONED, "10:05:00", "10:06:00"),
    Path("visitor-002"): visit(22, State.CLONED, "10:05:00", "10:07:00"),
    Path("visitor-003"): visit(22, State.CLONED, "10:05:00", "10:15:00"),
    Path("visitor-004"): visit(22, State.CLONED),
    Path("visitor-005"): visit(22, State.FAILED, problem="visitor-005: nobody is seen. Retake the photo"),
    Path("visitor-006"): visit(22, State.WAITING, "10:05:00"),
}
TRASHED = replace(visit(22, State.NONE), trashed="2026-11-22T12:00:00+00:00")
LOOKS = {
    Path("visitor-002"): {
        "a": PhotoCheck("a", None, (PhotoProblem.BLURRED, PhotoProblem.DARK)),
        "b": PhotoCheck("b", None, ()),
    },
    Path("visitor-005"): {"c": PhotoCheck("c", None, (PhotoProblem.BLURRED,))},
}


def found():
    return statistics_by_day(VISITS, lambda folder: LOOKS.get(folder, {}))


def test_the_last_day_comes_first_and_everything_is_counted_once():
    last, first = found()
    assert (last.date, last.visitors, last.clones) == ("2026-11-22", 5, 3)
    assert (first.date, first.visitors, first.clones) == ("2026-11-21", 1, 1)
    assert sorted(last.waited_min) == [2.0, 10.0]
    assert (last.median_min, last.longest_min) == (6.0, 10.0)
    assert last.photos == {PhotoProblem.BLURRED: 2, PhotoProblem.DARK: 1}
    assert last.failures == {"nobody is seen": 1}


def test_who_lies_in_the_trash_came_too():
    thrown = Path("trash/visitor-007")
    told = {**VISITS, thrown: TRASHED}
    last, _ = statistics_by_day(
        told, lambda folder: {"d": PhotoCheck("d", None, (PhotoProblem.DARK,))} if folder == thrown else {}
    )
    assert (last.visitors, last.clones, last.trashed) == (6, 3, 1)
    assert last.photos == {PhotoProblem.DARK: 1}
    assert ["2026-11-22", "in the trash", "", "1"] in list(csv.reader(io.StringIO(days_csv((last,)))))


def test_the_table_tells_numbers_and_nobodys_name():
    text = days_csv(found())
    rows = list(csv.reader(io.StringIO(text)))
    assert rows[0] == ["day", "what", "reason", "number"]
    assert ["2026-11-22", "visitors", "", "5"] in rows
    assert ["2026-11-22", "minutes in the queue, longest", "", "10.0"] in rows
    assert ["2026-11-22", "photos to take again", "blurred", "2"] in rows
    assert ["2026-11-22", "not cloned", "nobody is seen", "1"] in rows
    assert "visitor-00" not in text


def test_what_is_not_known_is_not_counted():
    strange = {Path("x"): Visit(started="yesterday", state=State.CLONED, queued="2", finished="1")}
    assert [(day.date, day.clones, day.waited_min) for day in statistics_by_day(strange, lambda _: {})] == [("", 1, ())]
    assert statistics_by_day({}, lambda _: {}) == ()


def test_a_clone_that_is_asked_for_again_waits_anew():
    done = waiting_line.with_clone(
        waiting_line.with_request(Visit(), "2026-11-22T10:00:00+00:00"), 30.0, "2026-11-22T10:01:00+00:00"
    )
    assert done.finished
    assert waiting_line.with_request(done, "2026-11-22T11:00:00+00:00").finished == ""
