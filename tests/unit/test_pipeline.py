"""Order, skipping, cancelling and randomness of the stages; the stages here are stand-ins."""

import threading
import time

import numpy as np
import pytest

from cloner import pipeline
from cloner.errors import Cancelled, ClonerError
from cloner.pipeline import STAGES, Stage
from cloner.records.results import Residual, StageResult


def doubling(*, number, tick):
    tick(0.5)
    return StageResult({"double": 2 * number}, (Residual("size", float(number), "mm"),), ("a word of warning",))


def drawing(*, double, tick, rng):
    return StageResult({"drawn": rng.integers(0, 10**9), "same": double})


TWO = (
    Stage("doubling", 1, ("number",), ("double",), doubling),
    Stage("drawing", 1, ("double",), ("drawn", "same"), drawing, draws=True),
)


def test_values_flow_and_every_stage_reports():
    given = {"number": 21}
    known, reports = pipeline.run(given, stages=TWO)
    assert known["double"] == known["same"] == 42
    assert given == {"number": 21}, "the given mapping is unchanged"
    assert [report.name for report in reports] == ["doubling", "drawing"]
    assert reports[0].residuals[0].unit == "mm"
    assert reports[0].warnings == ("a word of warning",)
    assert all(report.seconds >= 0 and report.peak_mib > 10 for report in reports)


def test_stages_that_do_not_need_each_other_run_abreast():
    met = threading.Barrier(2, timeout=60.0)

    def meeting(name):
        def run(*, number, tick):
            met.wait()
            return StageResult({name: number})

        return run

    both = tuple(Stage(name, 1, ("number",), (name,), meeting(name)) for name in ("left", "right"))
    after = Stage(
        "after", 1, ("left", "right"), ("sum",), lambda *, left, right, tick: StageResult({"sum": left + right})
    )
    told, found = [], []
    known, reports = pipeline.run(
        {"number": 1},
        stages=(*both, after),
        progress=lambda name, fraction: told.append(fraction),
        found=lambda name, values: found.append(name),
    )
    assert known["sum"] == 2
    assert [report.name for report in reports] == ["left", "right", "after"], "reports keep the order of the stages"
    assert sorted(found[:2]) == ["left", "right"]
    assert told == sorted(told)


def test_a_failing_stage_ends_the_one_beside_it_and_its_error_is_told():
    def failing(*, number, tick):
        begun.wait(5.0)
        raise ClonerError("no", "hint", "where")

    def long(*, number, tick):
        begun.set()
        for step in range(500):
            time.sleep(0.01)
            tick(step / 500)
        raise AssertionError("it went on")

    begun = threading.Event()
    stages = (Stage("long", 1, ("number",), ("one",), long), Stage("failing", 1, ("number",), ("two",), failing))
    with pytest.raises(ClonerError, match="no"):
        pipeline.run({"number": 1}, stages=stages)


def test_a_need_that_nobody_gives_is_named():
    with pytest.raises(KeyError, match="number"):
        pipeline.run({}, stages=TWO)


def test_what_is_known_is_not_made_again():
    known, reports = pipeline.run({"number": 21, "double": 5}, stages=TWO)
    assert known["same"] == 5
    assert [report.name for report in reports] == ["drawing"]


def test_progress_rises_from_nothing_to_all():
    told = []
    pipeline.run({"number": 1}, stages=TWO, progress=lambda name, fraction: told.append((name, fraction)))
    assert told == [("doubling", 0.0), ("doubling", 0.25), ("drawing", 0.5), ("done", 1.0)]


def test_cancelling_in_a_tick_stops_there():
    def stop(name, fraction):
        if fraction > 0.2:
            raise Cancelled

    with pytest.raises(Cancelled):
        pipeline.run({"number": 1}, stages=TWO, progress=stop)


def test_a_stage_that_gives_other_values_is_a_mistake():
    wrong = (Stage("doubling", 1, ("number",), ("triple",), doubling),)
    with pytest.raises(ValueError, match="doubling"):
        pipeline.run({"number": 1}, stages=wrong)


def test_randomness_comes_from_seed_and_stage_alone():
    def drawn(**options):
        return pipeline.run({"number": 1}, **options)[0]["drawn"]

    assert drawn(stages=TWO) == drawn(stages=TWO)
    assert drawn(stages=TWO) != drawn(stages=TWO, seed=1)
    between = Stage(
        "between",
        1,
        ("number",),
        ("other",),
        lambda *, number, tick, rng: StageResult({"other": rng.random()}),
        draws=True,
    )
    assert drawn(stages=TWO) == drawn(stages=(TWO[0], between, TWO[1])), "a new stage shifts no other"
    first, second = (pipeline.stage_rng(0, name).random() for name in ("hair", "head"))
    assert first != second


def test_every_need_of_a_stage_is_given_before():
    known = {"photos", "corrections", "person"}
    for stage in STAGES:
        assert set(stage.needs) <= known, stage.name
        assert not set(stage.gives) & known, f"{stage.name} gives again what is known"
        known |= set(stage.gives)
    assert "clone" in known
    assert len({stage.name for stage in STAGES}) == len(STAGES)


def test_stage_rng_is_a_numpy_generator():
    assert isinstance(pipeline.stage_rng(0, "x"), np.random.Generator)
