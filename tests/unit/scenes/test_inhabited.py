"""Clones in a lit room: the pack is whole, its page asks nobody, and who stands in the light is lighter."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from cloner.acting.written import bake_file
from cloner.crowd.drawing.theatre import CrowdRenderer
from cloner.crowd.packs.check import check_pack
from cloner.crowd.packs.reading import read_acted, read_facts, read_room, read_stock
from cloner.crowd.packs.still import ScenePainter
from cloner.crowd.packs.told import find_invalid
from cloner.crowd.staged.eye import CrowdCamera
from cloner.crowd.staged.footing import people_at
from cloner.crowd.staged.rooms import people_light
from cloner.errors import ClonerError
from cloner.scenes.inhabited import build_folder
from cloner.scenes.written import read_built_room, read_room_sound, sound_folder
from kit.browser import CHROMIUM, browser

pytestmark = [pytest.mark.gl, pytest.mark.slow]
SIZE = (480, 360)
EYE = ((4.0, 1.6, -0.6), (3.4, 1.1, -4.0))


@pytest.fixture(scope="module")
def built(lit_folder: Path, scenario: Path, lively: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("built") / "cell"
    build_folder(lit_folder, scenario, lively, out, seconds=3.0, seed=1)
    return out


def drawn(pack: Path, view=EYE, lit: bool = True) -> np.ndarray:
    facts = read_facts(pack)
    theatre = CrowdRenderer(read_stock(pack, facts))
    try:
        room = read_room(pack, facts) if lit else None
        return ScenePainter(theatre, facts, read_acted(pack, facts), SIZE, room).picture(view, 1.0).astype(float)
    finally:
        theatre.close()


def test_the_pack_is_whole_and_no_block_stands_in_the_room(built: Path) -> None:
    assert check_pack(built)[-1].startswith("scenario: 5 people act 3 s in ")
    facts = read_facts(built)
    assert len(read_acted(built, facts).blocks) == 0
    room = read_room(built, facts)
    assert room is not None
    assert np.abs(room.corners[:, 0]).max() == pytest.approx(8.3, abs=1e-5)


def test_who_stands_by_the_window_is_lighter_than_who_stands_in_the_corner(built: Path) -> None:
    facts = read_facts(built)
    room, rows = read_room(built, facts), people_at(read_acted(built, facts), 1.0)
    assert room is not None
    level = people_light(room.probes, rows)[:, :3, 0].mean(axis=1)
    bright = rows[:, 0, 1] > 4.0
    assert bright.sum() == 2
    assert level[bright].min() > 1.3 * level[~bright].max()


def test_clones_are_drawn_by_the_rooms_light_and_stand_on_a_shadow(built: Path) -> None:
    facts = read_facts(built)
    theatre = CrowdRenderer(read_stock(built, facts))
    room, acted = read_room(built, facts), read_acted(built, facts)
    rows = people_at(acted, 1.0)
    who = int(np.flatnonzero(rows[:, 0, 1] < 3.0)[0])
    x, z = rows[who, 0, 1], rows[who, 0, 2]
    try:
        painter = ScenePainter(theatre, facts, acted, SIZE, room)
        own = painter.picture(((x + 2.5, 1.2, z + 0.6), (x, 0.9, z)), 1.0).astype(float)
        empty = ScenePainter(theatre, facts, acted, SIZE, room)
        empty._tiers = lambda *_: [np.zeros(0, np.int64)] * 5  # nobody
        bare = empty.picture(((x + 2.5, 1.2, z + 0.6), (x, 0.9, z)), 1.0).astype(float)
        plain = (
            ScenePainter(theatre, facts, acted, SIZE).picture(((x + 2.5, 1.2, z + 0.6), (x, 0.9, z)), 1.0).astype(float)
        )
    finally:
        theatre.close()
    body = (slice(120, 200), slice(225, 255))
    assert own[body].mean() < 0.95 * plain[body].mean(), "in a dark corner, not in the open"
    changed = np.abs(own - bare).max(axis=2) > 3.0
    feet = np.flatnonzero(changed[:, 200:280].any(axis=1)).max()
    below = own[feet - 12 : feet, 215:265].mean() / bare[feet - 12 : feet, 215:265].mean()
    assert below < 0.97, "the floor is darker where somebody stands"


def test_who_stands_in_the_sun_takes_it_from_the_floor_behind(built: Path) -> None:
    facts = read_facts(built)
    theatre = CrowdRenderer(read_stock(built, facts))
    room, acted = read_room(built, facts), read_acted(built, facts)
    assert room is not None
    rows = people_at(acted, 1.0)
    who = int(np.argmax(rows[:, 0, 1]))  # farthest into the sun: it comes from the right, 40 degrees high
    x, z = (float(one) for one in rows[who, 0, 1:3])
    view = ((x - 1.2, 2.4, z + 0.01), (x - 0.45, 0.0, z))
    try:
        own = ScenePainter(theatre, facts, acted, SIZE, room).picture(view, 1.0).astype(float)
        empty = ScenePainter(theatre, facts, acted, SIZE, room)
        empty._tiers = lambda *_: [np.zeros(0, np.int64)] * 5  # nobody
        bare = empty.picture(view, 1.0).astype(float)
    finally:
        theatre.close()
    eye = CrowdCamera(np.array(view[0]), np.array(view[1]), SIZE, SIZE[1] / 2.0 / np.tan(np.radians(22.5)))
    shade = np.array([x - 0.4 / np.tan(np.radians(40.0)), 0.0, z])  # of somebody's shins
    clip = eye.clip_from_world() @ np.append(shade, 1.0)
    column, row = (clip[:2] / clip[3] * (0.5, -0.5) + 0.5) * SIZE
    there = (slice(int(row) - 3, int(row) + 4), slice(int(column) - 3, int(column) + 4))
    assert own[there].mean() < 0.8 * bare[there].mean()


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
def test_the_page_opens_from_the_disk_asks_nobody_and_shows_the_painters_picture(built: Path, tmp_path: Path) -> None:
    path = built / "player.html"
    with browser(tmp_path / "profile") as page:
        page.open(path, *SIZE)
        page.wait_for("document.body?.dataset.ready === 'yes'", 120)
        page.value(f"crowd.set({json.dumps({'place': EYE[0], 'target': EYE[1], 'now': 1.0})})")
        page.value("document.querySelectorAll('#knobs, #stats, #status').forEach((one) => one.style.display = 'none')")
        page.value("crowd.draw() && 1")
        shown = page.picture().astype(float)
        assert page.complaints() == []
        assert page.requests() == [path.resolve().as_uri()]
    assert np.abs(shown - drawn(built)).mean() < 6.0
    assert np.abs(shown - drawn(built, lit=False)).mean() > 25.0


def test_what_is_built_may_be_built_again_or_baked_without_the_room(
    built: Path, lit_folder: Path, scenario: Path, tmp_path: Path
) -> None:
    build_folder(lit_folder, scenario, built, tmp_path / "again", seconds=3.0, seed=1)
    first, again = read_facts(built), read_facts(tmp_path / "again")
    assert (again["files"], again["room"], again["acted"]) == (first["files"], first["room"], first["acted"])
    bake_file(scenario, built, tmp_path / "plain", seconds=3.0, seed=1)
    assert "room" not in read_facts(tmp_path / "plain")
    assert not (tmp_path / "plain" / "room.bin").exists()


def test_damage_is_told_in_one_sentence(
    built: Path, lit_folder: Path, scenario: Path, lively: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "room"
    shutil.copytree(lit_folder, folder)
    (folder / "probes.npz").write_bytes(b"no")
    with pytest.raises(ClonerError, match="no light"):
        build_folder(folder, scenario, lively, tmp_path / "out", seconds=2.0, seed=0)
    with pytest.raises(ClonerError, match="no room"):
        build_folder(tmp_path, scenario, lively, tmp_path / "out", seconds=2.0, seed=0)
    pack = tmp_path / "pack"
    shutil.copytree(built, pack)
    (pack / "room.bin").write_bytes(b"no")
    with pytest.raises(ClonerError):
        check_pack(pack)
    facts = read_facts(built)
    facts["room"]["shape"] = [1, 2]
    assert find_invalid(facts) == "room.shape"


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
def test_the_page_is_silent_until_asked_then_steps_are_heard_in_the_rooms_echo(
    lit_folder: Path, lively: Path, tmp_path: Path
) -> None:
    shutil.copytree(lit_folder, tmp_path / "room")
    said = sound_folder(tmp_path / "room")
    assert said[0].startswith("floor_1.wav: at 4, 3: falls by 60 dB in ")
    (tmp_path / "walk.crowd").write_text(
        "floor 0, 0 to 8, 6\npoint a at 1.5, 3 region 1 x 1\npoint b at 6.5, 3 region 1 x 1\n"
        "group two: 2 people, visits a > b > a > b, starts at a\n"
    )
    build_folder(tmp_path / "room", tmp_path / "walk.crowd", lively, tmp_path / "built", seconds=12.0, seed=1)
    with browser(tmp_path / "profile") as page:
        page.open(tmp_path / "built" / "player.html", *SIZE)
        page.wait_for("document.body?.dataset.ready === 'yes'", 120)
        page.value("crowd.set({ now: 1, place: [4, 1.6, -1], target: [4, 1.4, -4] })")
        assert page.value("sound === null && echo.length > 1000")
        page.value("[...document.querySelectorAll('button')].find((one) => one.textContent === 'sound').click()")
        page.wait_for("sound !== null", 30)
        page.value("(() => { for (let k = 0; k < 50; k++) { state.now = 1 + 0.2 * k; draw(); } })()")
        assert 12 <= page.value("sound.steps") <= 60, "two people, some two steps a second"
        assert [page.value(f"echoHeard(4, {z})") for z in (-3, 3)] == [1, 0.15]
        assert page.complaints() == []
        assert len(page.requests()) == 1


def test_a_room_of_which_nobody_asked_for_sound_has_none(lit_folder: Path, tmp_path: Path) -> None:
    assert read_room_sound(lit_folder, read_built_room(lit_folder)) is None
    with pytest.raises(ClonerError, match="no room"):
        sound_folder(tmp_path)
