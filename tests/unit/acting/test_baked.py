"""``cloner crowd bake``: a pack that acts a scenario, whole, the same twice, and refused where it should be."""

from __future__ import annotations

import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from typer.testing import CliRunner

from cloner.acting.written import bake_file
from cloner.behaviour.trajectories import Trajectories, pack, read_trajectories, unpack
from cloner.behaviour.walking import RATE_HZ
from cloner.behaviour.written import run_file
from cloner.cli import app
from cloner.crowd.packs.check import check_pack
from cloner.crowd.packs.pack import make_pack
from cloner.crowd.packs.reading import read_acted, read_facts
from cloner.crowd.packs.still import draw_pack
from cloner.crowd.packs.told import find_invalid
from cloner.crowd.staged.footing import BY_FOOTINGS, CLIP, GONE, LAST, OTHER, people_at
from cloner.errors import ClonerError
from cloner.personal_data.holdings import find_holding, holdings
from cloner.personal_data.privacy import forget
from kit.browser import CHROMIUM, browser
from kit.crowds import WANTED, dressed_toy, saved
from kit.feet import Soles

pytestmark = [pytest.mark.gl, pytest.mark.slow]
SECONDS = 20.0


@pytest.fixture(scope="module")
def walk(scenario: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("walk") / "lion.walk"
    run_file(scenario, out, seconds=SECONDS, seed=3)
    return out


@pytest.fixture(scope="module")
def baked(walk: Path, lively: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("baked") / "lion"
    bake_file(walk, lively, out)
    return out


def test_a_baked_pack_is_whole_and_says_what_it_acts(baked: Path) -> None:
    lines = check_pack(baked)
    assert lines[0] == "2 clones: ada, ben"
    assert lines[-1].startswith("scenario: 7 people act 20 s in ")
    facts = read_facts(baked)
    assert (facts["scene"], facts["people_count"]) == ("scenario", 7)
    assert facts["acted"]["seconds"] == SECONDS
    high = read_acted(baked, facts).blocks[:, 1].max()
    assert high == 3.0, "the pillar"


def test_everybody_is_where_the_trajectories_have_them_or_gone(baked: Path, walk: Path) -> None:
    acted, told = read_acted(baked, read_facts(baked)), read_trajectories(walk)
    off = []
    for frame in range(0, len(told.place) - 1, 5):
        rows = people_at(acted, frame / RATE_HZ + 1e-4)
        here = told.present[frame]
        assert (rows[here, 0, 0] == BY_FOOTINGS).all()
        want = np.column_stack([told.place[frame, :, 0], -told.place[frame, :, 1]])
        off.append(np.linalg.norm(rows[:, 0, 1:3] - want, axis=1)[here])
    assert np.concatenate(off).mean() < 0.3
    assert np.concatenate(off).max() < 1.7, "who turns about needs a second for it"
    last = people_at(acted, SECONDS - 0.05)
    assert (last[~told.present[-2], 0, 0] == GONE).all()


def test_feelings_show_in_the_walk_and_acts_while_standing(baked: Path, walk: Path) -> None:
    facts, told = read_facts(baked), read_trajectories(walk)
    acted = read_acted(baked, facts)
    names = [clip["name"] for clip in facts["people"][0]["clips"]]

    def walks(who: int, begin: float, end: float) -> set[str]:
        own = acted.footings[acted.starts[who] : acted.starts[who + 1]]
        own = own[(own[:, LAST] >= 0.0) & (own[:, 0] >= begin) & (own[:, 1] <= end)]
        return {names[int(clip)] for clip in own[:, CLIP]}

    sorry = [who for who, group in enumerate(told.groups) if group == "sorry"]
    assert all(walks(who, 0.0, 8.5) == {"walk_sad"} for who in sorry)
    assert all(walks(who, 10.5, SECONDS) <= {"walk_afraid", "run"} for who in sorry)
    guests = [who for who, group in enumerate(told.groups) if group == "guests"]
    assert all(walks(who, 0.0, SECONDS) == {"walk_happy"} for who in guests)
    stands = acted.footings[acted.footings[:, LAST] < 0.0]
    assert "photograph" in {names[int(clip)] for clip in stands[:, CLIP]}
    assert {int(clip) for clip in stands[stands[:, OTHER] >= 0.0][:, OTHER]} <= set(range(len(names)))


def test_feet_slide_by_millimetres_also_among_others(baked: Path) -> None:
    """Whole steps, begins, ends and turns on the spot together."""
    acted, soles = read_acted(baked, read_facts(baked)), Soles(baked)
    slid = np.concatenate([soles.slides_mm(acted, who, 0.0, SECONDS) for who in range(7)])
    assert len(slid) > 60
    assert np.median(slid) < 6.0
    assert np.percentile(slid, 90) < 40.0


def test_who_looks_at_something_faces_it(baked: Path, walk: Path) -> None:
    """A second and a half after the act began, until half a second before it ends: the next turn is begun in time."""
    acted, told = read_acted(baked, read_facts(baked)), read_trajectories(walk)
    lion = np.array([14.0, -5.0])
    photograph = told.acts.index("photograph")
    seen = 0
    for who in range(7):
        acts = (told.posture[:, who] == photograph) & told.present[:, who]
        for frame in (k for k in range(15, len(acts) - 6) if acts[k - 15 : k + 6].all()):
            row = people_at(acted, frame / RATE_HZ)[who]
            away = lion - row[0, 1:3]
            off = (np.arctan2(away[0], away[1]) - row[0, 3] + np.pi) % (2.0 * np.pi) - np.pi
            assert abs(np.degrees(off)) < 15.0, (who, frame)
            seen += 1
    assert seen > 20


def test_a_scenario_is_run_first_and_the_same_seed_bakes_the_same_bytes(
    scenario: Path, walk: Path, lively: Path, baked: Path, tmp_path: Path
) -> None:
    lines = bake_file(scenario, lively, tmp_path / "again", seconds=SECONDS, seed=3)
    assert lines[-1] == str(tmp_path / "again" / "player.html")
    told = [read_acted(one, read_facts(one)) for one in (baked, tmp_path / "again")]
    assert len(told[0].footings) == pytest.approx(len(told[1].footings), rel=0.1), "a file keeps places to 2 mm"
    bake_file(walk, lively, tmp_path / "third")
    for name in ("acted.bin", "player.html", "crowd.json"):
        assert (baked / name).read_bytes() == (tmp_path / "third" / name).read_bytes()


def test_a_pack_without_feelings_walks_as_it_can_and_says_so(walk: Path, tmp_path: Path) -> None:
    made = saved(tmp_path / "ada", dressed_toy())
    make_pack([made], tmp_path / "plain", replace(WANTED, vat=False))
    lines = bake_file(walk, tmp_path / "plain", tmp_path / "out")
    assert "no walk of who is afraid" in lines[0]
    acted = read_acted(tmp_path / "out", read_facts(tmp_path / "out"))
    assert set(acted.footings[acted.footings[:, LAST] >= 0.0][:, CLIP]) == {0.0}


def test_bad_words_end_in_one_sentence(walk: Path, lively: Path, scenario: Path, tmp_path: Path) -> None:
    with pytest.raises(ClonerError, match="there is nothing to bake"):
        bake_file(tmp_path / "none.walk", lively, tmp_path / "out")
    with pytest.raises(ClonerError, match="there is no crowd"):
        bake_file(walk, tmp_path, tmp_path / "out")
    with pytest.raises(ClonerError, match="would be replaced"):
        bake_file(walk, lively, lively)
    with pytest.raises(ClonerError, match="cannot be baked"):
        bake_file(scenario, lively, tmp_path / "out", seconds=-1.0)
    (tmp_path / "broken.walk").write_bytes(walk.read_bytes()[:200])
    with pytest.raises(ClonerError, match="these are no trajectories"):
        bake_file(tmp_path / "broken.walk", lively, tmp_path / "out")
    told = unpack(walk.read_bytes())
    hostile = replace(told, posture=told.posture + np.uint8(100))
    (tmp_path / "hostile.walk").write_bytes(pack(hostile))
    with pytest.raises(ClonerError, match="that it does not name"):
        bake_file(tmp_path / "hostile.walk", lively, tmp_path / "out")
    done = CliRunner().invoke(app, ["crowd", "bake", str(scenario), "--pack", str(tmp_path), "--out", "x"])
    assert isinstance(done.exception, ClonerError)
    copy = tmp_path / "copy"
    shutil.copytree(lively, copy)
    facts = json.loads((copy / "crowd.json").read_text())
    for change, message in (("walk_sad", "do not have the same walks"), (400, "do not fit what it says")):
        other = json.loads(json.dumps(facts))
        if isinstance(change, str):
            other["people"][1]["clips"][3]["name"] = "hop"
        else:
            for row in other["people"]:
                row["clips"][-1]["frames"], row["clips"][2]["frames"] = 48, 1023
        (copy / "crowd.json").write_text(json.dumps(other))
        with pytest.raises(ClonerError, match=message):
            bake_file(walk, copy, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_what_is_acted_is_checked_before_it_is_drawn(baked: Path, tmp_path: Path) -> None:
    facts = read_facts(baked)
    assert find_invalid(facts) == ""
    without = {key: value for key, value in facts.items() if key != "acted"}
    assert find_invalid(without) == "acted"
    assert find_invalid(facts | {"acted": facts["acted"] | {"seconds": 0}}) == "acted.seconds"
    copy = tmp_path / "copy"
    shutil.copytree(baked, copy)
    data = bytearray((copy / "acted.bin").read_bytes())
    data[len(data) // 2] ^= 255
    (copy / "acted.bin").write_bytes(bytes(data))
    with pytest.raises(ClonerError, match="damaged"):
        read_acted(copy, facts)
    other = json.loads((copy / "crowd.json").read_text())
    other["people"][0]["clips"] = other["people"][0]["clips"][:3]
    with pytest.raises(ClonerError, match="does not fit"):
        read_acted(baked, other)


def test_it_is_drawn_without_a_browser_and_forgotten_with_its_people(baked: Path, tmp_path: Path) -> None:
    out = tmp_path / "lion.png"
    draw_pack(baked, "front", out, "320x180")
    picture = np.asarray(Image.open(out)).astype(int)
    blue = (picture[..., 2] > picture[..., 0] + 25) & (picture[..., 2] > 60) & (picture[..., 0] < 140)
    assert blue.sum() > 30, "shirts"
    copy = tmp_path / "event" / "lion"
    shutil.copytree(baked, copy)
    forget(find_holding("ada", holdings(None, tmp_path / "event")), None, tmp_path / "event")
    assert not copy.exists()


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine: the page is not opened")
def test_the_page_plays_it_from_the_disk_and_asks_nobody(baked: Path, tmp_path: Path) -> None:
    acted = read_acted(baked, read_facts(baked))
    with browser(tmp_path / "profile") as page:
        page.open(baked / "player.html", 320, 200)
        page.wait_for("document.body && document.body.dataset.ready", 120)
        for now in (3.0, 12.5):
            page.value(f"crowd.set({{scene: 'scenario', now: {now}, place: [8, 7, 8], target: [8, 0, -5]}})")
            page.value("crowd.draw()")
            there = np.array(page.value("Array.from(walkers.rows)")).reshape(-1, 5, 4)
            want = people_at(acted, now)
            here = want[:, 0, 0] == BY_FOOTINGS
            assert np.array_equal(here, there[:, 0, 0] == BY_FOOTINGS)
            assert np.abs(there[here] - want[here]).max() < 1e-3
        page.value("crowd.time(1)")
        picture = page.picture().astype(int)[40:180]
        shirts = (picture[..., 2] > picture[..., 0] + 25) & (picture[..., 0] < 140)
        assert shirts.sum() > 30
        stone = (np.abs(picture - (176, 169, 157)).max(axis=2) < 30).sum()
        assert stone > 20, "plinth, statue and pillar"
        page.value("crowd.set({scene: 'plaza', people: 30, place: [0, 6, 22], target: [0, 1, 0]})")
        assert sum(page.value("crowd.draw()")["counts"]) == 30
        assert not page.complaints()
        assert all(address.startswith(("file:", "blob:", "data:", "about:")) for address in page.requests())


def test_files_of_before_have_the_emotions_own_walks(walk: Path) -> None:
    told: Trajectories = unpack(walk.read_bytes())
    assert told.walks == told.emotions
    before = pack(told).replace(b'"walks"', b'"wandr"')
    assert unpack(before).walks == told.emotions
    assert (told.obstacles, told.things_at) == (unpack(pack(told)).obstacles, ((14.0, 5.0),))
    for hostile in (((0.0, 0.0),), ((0.0, 1e9), (1.0, 1.0), (2.0, 0.0))):
        with pytest.raises(ValueError, match=r"no obstacles|no place|head"):
            unpack(pack(replace(told, obstacles=(hostile,))))
