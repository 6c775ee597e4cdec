"""What is asked before any work, and what the report tells of stages that did not run again."""

from __future__ import annotations

import subprocess
import sys

import pytest

from cloner.errors import ClonerError
from cloner.exporters.table import check_formats
from cloner.making import merge_reports
from cloner.pipeline import STAGES, StageReport


def report(name: str, seconds: float) -> StageReport:
    return StageReport(name, seconds, seconds, 100.0, (), (f"a word of {name}",))


def test_stages_that_did_not_run_again_are_told_again_at_no_time() -> None:
    earlier = tuple(report(stage.name, 2.0) for stage in STAGES)
    fresh = [report("points", 0.5), report("textures", 1.5)]
    told = merge_reports(fresh, earlier)
    assert [one.name for one in told] == [stage.name for stage in STAGES]
    seconds = {one.name: one.seconds for one in told}
    assert (seconds["points"], seconds["textures"], seconds["fine"]) == (0.5, 1.5, 0.0)
    assert all(one.warnings == (f"a word of {one.name}",) for one in told), "warnings are not forgotten"
    assert merge_reports(fresh, ()) == tuple(fresh)


def test_the_library_of_usd_is_loaded_before_threads_begin() -> None:
    code = "import sys, cloner.exporters.table as c; c.check_formats(['usdz']); print('pxr.UsdSkel' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "True"


def test_usd_without_its_library_is_refused_before_any_work(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pxr.Gf", None)
    with pytest.raises(ClonerError, match="USD needs a library"):
        check_formats(("glb", "usdz"))
