"""A pack with walks of feelings, a scenario and a small lit room to act in."""

from __future__ import annotations

from pathlib import Path

import pytest

from cloner.scenes.inhabited import build_folder
from cloner.scenes.written import light_folder, make_folder
from kit.crowds import lively_pack, two_results
from kit.living import SCENARIO as WALKERS
from kit.living import SECONDS

PLAN = """name = "cell"
[sun]
towards_deg = 90
elevation_deg = 40
light = [4, 3.6, 3]
[sky]
light = [1.4, 1.6, 2]
[[floor]]
from = [0, 0]
to = [8, 6]
look = "flags"
[[wall]]
from = [-0.3, -0.3]
to = [8.3, 0]
high = 3
look = "plaster"
[[wall]]
from = [-0.3, 6]
to = [8.3, 6.3]
high = 3
look = "plaster"
[[wall]]
from = [-0.3, 0]
to = [0, 6]
high = 3
look = "plaster"
[[wall]]
from = [8, 0]
to = [8.3, 6]
high = 3
look = "plaster"
openings = [{ at = 3, wide = 2, low = 0.8, high = 2.5 }]
[[ceiling]]
from = [-0.3, -0.3]
to = [8.3, 6.3]
at = 3
look = "plaster"
"""
SCENARIO = """floor 0, 0 to 8, 6
point dark at 1.2, 4.6 region 1.6 x 1.6 act look for 60 s
point bright at 5.5, 3 region 1.6 x 1.6 act look for 60 s
group one: 2 people, visits dark, starts at dark
group two: 2 people, visits bright, starts at bright
"""


@pytest.fixture(scope="session")
def lively(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return lively_pack(two_results(tmp_path_factory.mktemp("results")), tmp_path_factory.mktemp("lively") / "pack")


@pytest.fixture(scope="session")
def lit_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("cell")
    (folder / "cell.toml").write_text(PLAN)
    make_folder(str(folder / "cell.toml"), folder / "room")
    light_folder(folder / "room")
    return folder / "room"


@pytest.fixture(scope="session")
def scenario(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("scenario") / "cell.crowd"
    path.write_text(SCENARIO)
    return path


@pytest.fixture(scope="session")
def built(lit_folder: Path, lively: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("served")
    (folder / "walk.crowd").write_text(WALKERS)
    build_folder(lit_folder, folder / "walk.crowd", lively, folder / "scene", seconds=SECONDS, seed=1)
    return folder / "scene"


@pytest.fixture
def hot(tmp_path: Path) -> Path:
    (tmp_path / "clones").mkdir()
    return tmp_path / "clones"
