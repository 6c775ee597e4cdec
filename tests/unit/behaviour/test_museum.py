"""The sample scenario at small size, its files, and that the same seed gives the same steps."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from cloner.behaviour.language import parse_scenario
from cloner.behaviour.loop import digest, run
from cloner.behaviour.model import Scenario
from cloner.behaviour.plan import FLOOR, OBSTACLE, Plan
from cloner.behaviour.trajectories import UNIT_M, Trajectories, pack, read_trajectories, unpack
from cloner.behaviour.world import make_world
from cloner.behaviour.written import check_file, recorded, run_file
from cloner.errors import ClonerError

MUSEUM = Path(__file__).resolve().parents[3] / "samples" / "museum.crowd"
SHORT = [("crowd 70", "crowd 12"), ("school: 24", "school: 6"), ("at 60 s", "at 4 s")]
OUT_S = 44.0


def short_text() -> str:
    text = MUSEUM.read_text(encoding="utf-8")
    for old, new in SHORT:
        assert old in text
        text = text.replace(old, new)
    return text


@pytest.fixture(scope="module")
def small() -> tuple[Scenario, Trajectories]:
    scenario = parse_scenario(short_text())
    return scenario, recorded(make_world(scenario, 3), OUT_S)


def test_the_statue_drives_everybody_out(small: tuple[Scenario, Trajectories]) -> None:
    _, walk = small
    afraid = walk.emotion == walk.emotions.index("afraid")
    assert not afraid[:40].any(), "the statue sleeps for 4 s"
    assert 3 <= afraid[45].sum() < 24, "those who see it first"
    assert afraid[-1].all()
    assert (walk.place[:40, :, 1] > 0.0).all()
    assert (walk.place[-1, :, 1] < 0.0).all(), "all are outside"


def test_a_file_keeps_places_to_a_millimetre(small: tuple[Scenario, Trajectories], tmp_path: Path) -> None:
    _, walk = small
    data = pack(walk)
    assert len(data) / (walk.place.shape[0] / 10 * walk.place.shape[1]) < 16.0, "bytes a person and second"
    (tmp_path / "a.walk").write_bytes(data)
    back = read_trajectories(tmp_path / "a.walk")
    assert np.abs(back.place - walk.place).max() <= UNIT_M / 2 + 1e-9
    assert (back.facing * walk.facing).sum(axis=2).min() > np.cos(np.radians(0.8))
    for name in ("present", "posture", "emotion", "gaze"):
        assert np.array_equal(getattr(back, name), getattr(walk, name))
    assert (back.groups, back.acts, back.things, back.told) == (walk.groups, walk.acts, walk.things, walk.told)


def test_a_damaged_file_is_a_sentence(small: tuple[Scenario, Trajectories], tmp_path: Path) -> None:
    data = pack(small[1])
    for k, bad in enumerate(
        (b"", data[:7], data[:200], data[:-40], b"x" + data[1:], data[:12] + b"[" + data[13:], data[:9])
    ):
        (tmp_path / f"{k}.walk").write_bytes(bad)
        with pytest.raises(ClonerError, match="no trajectories"):
            read_trajectories(tmp_path / f"{k}.walk")
    head = data[: data.index(b"frames")] + b'frames": 999999999, "x": 1}'
    with pytest.raises(ValueError, match=r"head|many|damaged"):
        unpack(head)


def test_the_plan_shows_floor_obstacles_and_people(small: tuple[Scenario, Trajectories]) -> None:
    scenario, walk = small
    plan = Plan(scenario)
    picture = plan.draw(walk, 0)
    colours, counts = np.unique(picture.reshape(-1, 3), axis=0, return_counts=True)
    share = {tuple(int(v) for v in colour): count / counts.sum() for colour, count in zip(colours, counts, strict=True)}
    metres = (20 + 1.2) * (39 + 1.2)  # the floors' box with its margin
    assert share[FLOOR] == pytest.approx((12 * 30 + 0.96 + 20 * 8.6) / metres, rel=0.1)  # less lines, words and people
    assert share[OBSTACLE] == pytest.approx((10 * 0.49 + 2 + 1.44) / metres, rel=0.25)
    assert (picture != plan.draw(walk, 100)).any()


def test_the_same_seed_gives_the_same_steps_and_another_others() -> None:
    scenario = parse_scenario(short_text())
    found = []
    for seed in (1, 1, 2):
        world = make_world(scenario, seed)
        for _ in run(world, 6.0):
            pass
        found.append(digest(world))
    assert found[0] == found[1] != found[2]


def test_the_commands_check_and_run(tmp_path: Path) -> None:
    path = tmp_path / "small.crowd"
    path.write_text(short_text(), encoding="utf-8")
    lines = check_file(path)
    assert "school: 6 people, 100 % regular" in lines
    assert "4 rules" in lines
    out, picture = tmp_path / "a.walk", tmp_path / "a.png"
    told = run_file(path, out, seconds=1.0, seed=1, picture=picture)
    assert picture.read_bytes()[:4] == b"\x89PNG"
    assert len(read_trajectories(out).place) == 11
    assert any(line.startswith("digest ") for line in told)
    with pytest.raises(ClonerError, match="exists and is not replaced"):
        run_file(path, out, seconds=1.0)
    for seconds in (0.0, float("nan"), 1e9):
        with pytest.raises(ClonerError, match="seconds cannot be run"):
            run_file(path, tmp_path / "b.walk", seconds=seconds)
    path.write_text(short_text().replace("floor 4.8, -0.4 to 7.2, 0", "#"), encoding="utf-8")
    with pytest.raises(ClonerError, match="cannot reach square"):
        check_file(path)
