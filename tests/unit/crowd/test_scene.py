"""A thousand people: many looks, nobody twice in one place, the same in both languages."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import cloner.crowd
from cloner.crowd.packs.check import closest_repeat_m
from cloner.crowd.staged.looks import PALETTES
from cloner.crowd.staged.scene import SCENES, Casting, facts, looks_shown, make_scene, places_at

CLONES = 20
CASTING = Casting(
    CLONES,
    PALETTES,
    {name: [[c for c in range(CLONES) if c != k] for k in range(CLONES)] for name in ("top", "bottom", "shoes")},
)


@pytest.mark.parametrize("name", SCENES)
def test_looks_differ_and_a_clone_never_meets_itself(name: str) -> None:
    made = make_scene(name, 1000, CASTING)
    assert len(made.rows) == 1000
    assert looks_shown(made) >= 200
    assert min(closest_repeat_m(made, now) for now in (0.0, 2.3, 9.7, 31.0)) >= 2.0


def test_people_in_a_lane_walk_at_their_speed() -> None:
    made = make_scene("walk", 300, CASTING)
    before, after = places_at(made, 5.0), places_at(made, 5.5)
    moved = np.abs(after - before)[:, 2]
    stayed = moved < made.lane_m / 2.0  # not those who begin their lane again
    assert np.allclose(moved[stayed], made.rows[stayed, 1, 0] * 0.5, atol=1e-6)


@pytest.mark.skipif(shutil.which("node") is None, reason="no node on this machine")
@pytest.mark.parametrize("name", SCENES)
def test_the_page_places_everybody_as_the_painter_does(name: str, tmp_path: Path) -> None:
    script = (Path(cloner.crowd.__file__).parent / "web" / "scene.js").read_text()
    run = tmp_path / "run.js"
    run.write_text(
        f"{script}\nconst made = sceneOf({json.dumps(name)}, 700, {json.dumps(facts(CASTING))});"
        "console.log(JSON.stringify({ rows: Array.from(made.rows), lane: made.lane }));"
    )
    told = json.loads(subprocess.run(["node", run], capture_output=True, text=True, check=True).stdout)
    made = make_scene(name, 700, CASTING)
    assert told["lane"] == made.lane_m
    assert np.array_equal(np.array(told["rows"], np.float32), made.rows.ravel())
