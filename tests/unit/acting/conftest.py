"""Two people of paint with the walks of feelings, and a short walk of a few people."""

from __future__ import annotations

from pathlib import Path

import pytest

from kit.crowds import lively_pack, two_results

SCENARIO = """floor 0, 0 to 16, 10
obstacle plinth at 14, 5 size 1 x 1
obstacle pillar at 6, 8.5 size 0.6 x 0.6
statue lion at 14, 5
point door at 1, 5 region 1 x 4
point lion_front at 11, 5 region 3 x 4 act photograph for 5 s look at lion
crowd 5 guests: emotion happy 100 %, visits lion_front > door, starts at door, adapts to space
group sorry: 2 people, emotion sad, visits lion_front, starts at door
at 9 s: sorry becomes afraid
at 12 s: guests leave by door
"""


@pytest.fixture(scope="session")
def lively(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A pack with the walks of feelings and the acts."""
    return lively_pack(two_results(tmp_path_factory.mktemp("results")), tmp_path_factory.mktemp("lively") / "pack")


@pytest.fixture(scope="session")
def scenario(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("scenario") / "lion.crowd"
    path.write_text(SCENARIO)
    return path
