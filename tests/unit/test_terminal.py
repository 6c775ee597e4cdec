"""Progress for terminals and for logs."""

from __future__ import annotations

import io

import pytest

from cloner.errors import ClonerError
from cloner.terminal import ProgressLine


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_a_log_gets_one_line_a_step() -> None:
    stream = io.StringIO()
    with ProgressLine(stream) as progress:
        for step, fraction in (("views", 0.0), ("views", 0.1), ("views", 0.2), ("head", 0.5)):
            progress(step, fraction)
    lines = stream.getvalue().splitlines()
    assert [line.split()[-1] for line in lines] == ["views", "head"]
    assert lines[1].startswith(" 50 %")


def fail_half_way(progress: ProgressLine) -> None:
    progress("views", 0.5)
    raise ClonerError("m", "h", "w")


def test_a_terminal_gets_one_line_that_is_gone_at_the_end() -> None:
    stream = Terminal()
    with pytest.raises(ClonerError), ProgressLine(stream) as progress:
        fail_half_way(progress)
    assert "\n" not in stream.getvalue()
    assert stream.getvalue().endswith("\r\x1b[2K")
