"""Ways told as footings: feet stay where they stand, at any pace and turn, and bodies are where the way is."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import cloner.crowd
from cloner.acting.tracks import Track, footings_on_tracks
from cloner.behaviour.feet import Feet
from cloner.crowd.packs.reading import read_facts, read_stock
from cloner.crowd.staged.footing import (
    CLIP,
    COLUMNS,
    FIRST,
    LAST,
    OTHER,
    Acted,
    is_in_range,
    people_at,
    touching_points,
)
from cloner.crowd.staged.scene import IDLE
from kit.feet import Soles

pytestmark = pytest.mark.slow
OFF_RAD = 0.15  # who stands turns when off by more (core/feet/walker.ts)
WALKS = ("walk", "walk_sad", "walk_calm", "walk_happy", "walk_explosive", "walk_afraid")


class Stage:
    """A pack's clones and their soles."""

    def __init__(self, pack: Path) -> None:
        people = read_facts(pack)["people"]
        held = read_stock(pack, read_facts(pack))
        self.names = [clip["name"] for clip in people[0]["clips"]]
        self.own = [[clip["speed_m_s"] for clip in row["clips"]] for row in people]
        self.touches = np.stack(
            [touching_points(n, held.body, r["clips"]) for n, r in zip(held.numbers, people, strict=True)]
        )
        self.clips = np.array([[[c["frames"], c["seconds"]] for c in row["clips"]] for row in people], np.float32)
        self.soles = Soles(pack)

    def acted(self, track: Track, clone: int = 0, scale: float = 1.0) -> Acted:
        """What one clone makes of a track."""
        row = np.zeros((1, 5, 4), np.float32)
        row[0, 1], row[0, 3] = (0.0, 0.0, clone, scale), -1.0
        run = self.names.index("run")
        feet = Feet(self.touches, self.clips, np.array([clone]), np.array([scale]), np.array([0.3]), {}, {}, run)
        (own,) = footings_on_tracks([track], feet)
        return Acted(own, np.array([0, len(own)], np.uint32), row, self.touches, self.clips)


@pytest.fixture(scope="module")
def stage(lively: Path) -> Stage:
    return Stage(lively)


def curve(speed: float, turn: float, walk: int, seconds: float = 10.0, act: int = IDLE) -> Track:
    """Somebody who walks at a speed and turns by so many radians a second."""
    times = np.arange(0.0, seconds, 0.1)
    heading = turn * times
    place = np.cumsum(0.1 * speed * np.stack([np.sin(heading), np.cos(heading)], axis=1), axis=0)
    every = np.ones(len(times), np.int64)
    return Track(times, place, heading, every * act, every * walk)


def off_m(acted: Acted, track: Track, times: np.ndarray) -> np.ndarray:
    """How far the body is from where the track has it."""
    return np.array([np.linalg.norm(people_at(acted, now)[0, 0, 1:3] - track.place(now)) for now in times])


@pytest.mark.parametrize("name", WALKS)
@pytest.mark.parametrize(("share", "turn"), [(1.0, 0.0), (1.0, 1.5), (0.6, 0.0), (0.6, 1.5)])
def test_feet_stay_where_they_stand_on_straight_and_bent_ways(
    stage: Stage, name: str, share: float, turn: float
) -> None:
    walk = stage.names.index(name)
    track = curve(share * stage.own[1][walk], turn, walk)
    acted = stage.acted(track, clone=1)
    slid = stage.soles.slides_mm(acted, 0, 3.0, 9.0)
    assert len(slid) >= 8, "steps"
    bent_and_slow = share < 1.0 and turn > 0.0  # a sole that lies flat turns about one point, and shows another
    assert slid.mean() < (20.0 if bent_and_slow else 5.0)
    assert slid.max() < (30.0 if bent_and_slow else 15.0)
    assert off_m(acted, track, np.arange(3.0, 9.0, 0.5)).max() < 0.3


def test_a_walk_played_at_a_pace_that_is_not_its_own_would_slide(stage: Stage) -> None:
    """The ruler can fail: the same steps carried a fifth too far slide by a fifth of a stand."""
    track = curve(1.3, 0.0, 0)
    acted = stage.acted(track)
    far = Acted(acted.footings, acted.starts, acted.people, acted.touches * np.float32(1.2), acted.clips)
    assert stage.soles.slides_mm(far, 0, 3.0, 8.0).mean() > 50.0


def test_slow_ways_take_shorter_and_slower_steps(stage: Stage) -> None:
    def steps(speed: float) -> tuple[float, float]:
        own = stage.acted(curve(speed, 0.0, 0, 12.0)).footings
        whole = own[(own[:, LAST] - own[:, FIRST]) == 24.0][2:-2]
        return float(np.diff(whole[:, 0]).mean()), float(np.linalg.norm(np.diff(whole[:, 8:10], axis=0), axis=1).mean())

    usual, slow = steps(1.4), steps(0.7)
    assert slow[0] == pytest.approx(usual[0] * np.sqrt(2.0), rel=0.1)
    assert slow[1] == pytest.approx(usual[1] / np.sqrt(2.0), rel=0.1)


def test_who_has_to_hurry_goes_over_to_running_and_back_without_a_stop(stage: Stage) -> None:
    times = np.arange(0.0, 14.0, 0.1)
    speed = np.where((times > 5.0) & (times < 9.0), 2.3, 1.3)
    place = np.outer(np.cumsum(0.1 * speed), (0.0, 1.0))
    still = np.zeros(len(times), np.int64)
    track = Track(times, place, 0.0 * times, still + IDLE, still)
    acted = stage.acted(track, clone=1)
    own = acted.footings
    run = stage.names.index("run")
    over = own[own[:, OTHER] < 0.0][:, CLIP]
    assert over[own[own[:, OTHER] < 0.0][:, LAST] >= 0.0].tolist() == [run, 0]
    assert (own[2:-2, LAST] >= 0.0).all(), "on the way all the time"
    running = own[own[:, CLIP] == run]
    assert 4.0 < running[0, 0] < 6.0
    assert 8.0 < running[-1, 1] < 10.5
    assert off_m(acted, track, np.arange(3.0, 13.0, 0.25)).max() < 0.6
    assert np.median(stage.soles.slides_mm(acted, 0, 3.0, 13.0)) < 15.0


def test_a_feeling_that_changes_changes_the_walk_in_one_step(stage: Stage) -> None:
    sad, happy = stage.names.index("walk_sad"), stage.names.index("walk_happy")
    track = curve(1.1, 0.3, sad, 12.0)
    track.walks[60:] = happy
    acted = stage.acted(track)
    own = acted.footings[2:-2]
    assert set(own[own[:, 0] < 5.5][:, CLIP]) == {sad}
    assert set(own[own[:, 0] > 7.5][:, CLIP]) == {happy}
    assert (own[:, LAST] >= 0.0).all(), "nobody stops for it"
    body = np.array([people_at(acted, now)[0, 0, 1:3] for now in np.arange(4.0, 9.0, 1.0 / 60.0)])
    assert np.linalg.norm(np.diff(body, axis=0), axis=1).max() < 0.06


def test_who_creeps_stands_and_who_arrives_stands_at_the_end(stage: Stage) -> None:
    times = np.arange(0.0, 8.0, 0.1)
    still = np.zeros(len(times), np.int64)
    creeping = Track(times, np.outer(times, (0.02, 0.0)), 0.0 * times, still + IDLE, still)
    assert len(stage.acted(creeping).footings) == 1
    arriving = Track(times, np.outer(np.minimum(1.2 * times, 4.0), (1.0, 0.0)), 0.0 * times + 1.5, still + IDLE, still)
    acted = stage.acted(arriving)
    assert off_m(acted, arriving, np.array([7.9]))[0] < 0.25
    assert acted.footings[-1, LAST] < 0.0, "he stands"


def test_who_looks_elsewhere_turns_on_one_foot_within_a_second(stage: Stage) -> None:
    times = np.arange(0.0, 6.0, 0.1)
    still = np.zeros(len(times), np.int64)
    track = Track(times, np.zeros((len(times), 2)), np.where(times < 2.0, 0.0, 1.5), still + IDLE, still)
    acted = stage.acted(track)
    assert abs(people_at(acted, 3.0)[0, 0, 3] - 1.5) <= OFF_RAD + 1e-6
    assert OFF_RAD < np.radians(10.0)
    assert stage.soles.slides_mm(acted, 0, 0.0, 5.9).max() < 60.0, "feet are set down beside, two lifts"


def test_acts_begin_and_end_from_standing(stage: Stage) -> None:
    """A blend of .4 s, and no body that jumps: the largest move of a sixtieth is a walker's."""
    wave, sit = stage.names.index("wave"), stage.names.index("sit")
    times = np.arange(0.0, 12.0, 0.1)
    place = np.outer(np.clip(1.3 * (times - 8.0), 0.0, None), (0.0, 1.0))
    acts = np.where(times < 2.0, IDLE, np.where(times < 5.0, wave, np.where(times < 8.0, sit, IDLE)))
    acted = stage.acted(Track(times, place, 0.0 * times, acts, np.zeros(len(times), np.int64)))
    shown = [people_at(acted, now)[0] for now in np.arange(0.0, 11.9, 1.0 / 60.0)]
    assert {int(row[2, 3]) for row in shown[150:270]} == {wave}
    assert {int(row[2, 3]) for row in shown[340:440]} == {sit}
    body = np.array([row[0, 1:3] for row in shown])
    assert np.linalg.norm(np.diff(body, axis=0), axis=1).max() < 0.06
    assert off_m(acted, Track(times, place, 0.0 * times, acts, acts * 0), np.array([11.5]))[0] < 0.3


@pytest.mark.skipif(shutil.which("node") is None, reason="no node on this machine")
def test_the_page_moves_everybody_as_the_painter_does(stage: Stage, tmp_path: Path) -> None:
    track = curve(1.2, 0.8, 3, 8.0, act=stage.names.index("wave"))
    track.walks[20:] = 4
    track.places_m[45:] = track.places_m[45]
    acted = stage.acted(track, clone=1, scale=0.97)
    web = Path(cloner.crowd.__file__).parent / "web"
    times = [0.0, 0.21, 1.0, 2.13, 3.3, 4.77, 5.2, 6.01, 7.9, 3.3, 99.0]
    arrays = {
        "footings": acted.footings, "starts": acted.starts, "people": acted.people, "touches": acted.touches,
        "clips": acted.clips,
    }  # fmt: skip
    kinds = {"starts": "Uint32Array"}
    lines = [
        f"{name}: new {kinds.get(name, 'Float32Array')}({json.dumps(one.ravel().tolist())})"
        for name, one in arrays.items()
    ]
    run = tmp_path / "run.js"
    run.write_text(
        (web / "scene.js").read_text() + (web / "footing.js").read_text().replace('"use strict";', "")
        + f"const all = actedOf({{ {', '.join(lines)} }}, 2), rows = all.people.slice(), found = [];\n"
        + f"for (const now of {json.dumps(times)}) {{ all.at(now, rows); found.push(Array.from(rows)); }}\n"
        + "console.log(JSON.stringify(found));"
    )  # fmt: skip
    told = np.array(json.loads(subprocess.run(["node", run], capture_output=True, text=True, check=True).stdout))
    for now, row in zip(times, told.reshape(len(times), 5, 4), strict=True):
        want = people_at(acted, now)[0]
        if want[0, 0] == 4.0:
            assert row[0, 0] == 4.0, "gone"
        else:
            assert np.abs(row - want).max() < 1e-4, now


def test_numbers_of_others_are_looked_at(stage: Stage) -> None:
    acted = stage.acted(curve(1.3, 0.0, 0))
    kinds = [len(stage.names)] * 2
    assert is_in_range(acted, kinds)
    for column, value in ((1, -1.0), (2, 99.0), (2, -1.0), (5, 1e6), (0, np.nan), (8, np.inf)):
        own = acted.footings.copy()
        own[2, column] = value
        assert not is_in_range(Acted(own, acted.starts, acted.people, acted.touches, acted.clips), kinds), (
            column,
            value,
        )
    assert not is_in_range(Acted(acted.footings, acted.starts + 1, acted.people, acted.touches, acted.clips), kinds)
    assert not is_in_range(acted, [3, 3])
    assert acted.footings.shape[1] == COLUMNS
