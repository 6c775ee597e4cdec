"""Scenes that go on: a scenario to walk in, clones that finish, and what pages are told."""

from __future__ import annotations

import json
from functools import partial
from pathlib import Path

from cloner.project.results import RESULT_MARK, file_digest
from cloner.scenes.served.living import RunningScene
from cloner.scenes.served.newcomers import finished_in
from kit.crowds import dressed_toy, saved

SECONDS = 30.0
SCENARIO = """floor 0, 0 to 8, 6
point a at 1.5, 3 region 2 x 4
point b at 6.5, 3 region 2 x 4
point out at 4, 1 region 2 x 1
group walkers: 3 people, visits a > b again, starts at a, adapts to space
group watchers: 2 people, visits b, starts at b
"""


def finished(folder: Path, name: str, **told: object) -> Path:
    """A clone that appears whole, as a result does."""
    aside = saved(folder / f".{name}", dressed_toy(1.60, shift=-40, **told))
    listed = {"clone.npz": file_digest(aside / "clone.npz")}
    (aside / RESULT_MARK).write_text(json.dumps({"format": 3, "stamp": {}, "outputs": listed}))
    return aside.rename(folder / name)


def shown(built: Path, hot: Path) -> tuple[RunningScene, list[str]]:
    said: list[str] = []
    return RunningScene(built, partial(finished_in, hot), said.append), said


def hello_of(scene: RunningScene) -> dict:
    kind, hello = next(scene.told(0.01))
    assert kind == "hello"
    return hello
