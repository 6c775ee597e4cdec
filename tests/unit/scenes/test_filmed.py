"""Films: the same pictures again and in the page, stone that comes alive, and what is said of what cannot be filmed."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import partial
from pathlib import Path

import cv2
import numpy as np
import pytest
from PIL import Image
from scipy.io import wavfile

from cloner.crowd.clones.levels import body_levels
from cloner.crowd.drawing.theatre import CrowdRenderer
from cloner.crowd.packs.check import check_pack
from cloner.crowd.packs.pack import make_pack
from cloner.crowd.packs.reading import read_acted, read_facts, read_room, read_stock
from cloner.crowd.packs.still import ScenePainter
from cloner.crowd.staged.footing import FROM, LAST, X, Z, feelings_at
from cloner.crowd.staged.staging import read_staging
from cloner.errors import Cancelled, ClonerError
from cloner.scenes.filmed import film_file
from cloner.scenes.films.steps import footsteps
from cloner.scenes.inhabited import build_folder
from cloner.statues.carved import statue_of
from kit.browser import CHROMIUM, browser
from kit.crowds import WANTED, two_results

pytestmark = [pytest.mark.gl, pytest.mark.slow]
SIZE = (320, 240)
FILM = """film "Two of stone" for 4 s, 320 x 240, 2 frames a second
actor ada is ada at 5.5, 3 facing 180 in stone, .2 m deep
actor ben is ben at 3.6, 3.2 facing 90 in stone, head at 3, 1.6
at 0 s: camera at 5.2, .6, 1.5 looks at ada, lens 50
at 0 s: light .2, .25, .4
at 1 s: light 1, 1, 1 in 1 s
at 1 s: ada awakens in 1 s
at 1 s: ada rises in 1 s
at 2 s: ada walks to 4.4, 2.2
at 2 s: camera at 4.2, .4, 1.5 looks at 4.2, 3, .9, lens 60
at 2 s: ada gives ben the head in 1.5 s
at 2.5 s: caption "So" for 1 s
"""


@pytest.fixture(scope="module")
def cast(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two people of paint, in stone too, who can speak."""
    out = tmp_path_factory.mktemp("cast") / "pack"
    wanted = replace(WANTED, vat=False, feelings=True, carved=partial(statue_of, material="stone"), faces=True)
    make_pack([two_results(tmp_path_factory.mktemp("results"))], out, wanted)
    return out


@pytest.fixture(scope="module")
def lines(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("film") / "two.film"
    path.write_text(FILM)
    return path


@pytest.fixture(scope="module")
def filmed(cast: Path, lines: Path, lit_folder: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """A folder of pictures, and the staged pack."""
    folder = tmp_path_factory.mktemp("filmed")
    film_file(lines, lit_folder, cast, folder / "pictures", folder / "staged")
    return folder / "pictures", folder / "staged"


def painter_of(pack: Path, theatre: CrowdRenderer) -> ScenePainter:
    facts = read_facts(pack)
    return ScenePainter(theatre, facts, read_acted(pack, facts), SIZE, read_room(pack, facts), read_staging(facts))


def test_the_same_lines_make_the_same_pictures(filmed: tuple[Path, Path], lines, cast, lit_folder, tmp_path) -> None:
    names = sorted(one.name for one in filmed[0].iterdir())
    assert names == [*(f"0000{k}.png" for k in range(1, 9)), "sound.wav"]
    film_file(lines, lit_folder, cast, tmp_path / "again", None)
    for name in names:
        assert (tmp_path / "again" / name).read_bytes() == (filmed[0] / name).read_bytes()


def test_steps_are_heard_when_feet_come_down_from_where_they_are_and_not_of_stone(filmed: tuple[Path, Path]) -> None:
    facts = read_facts(filmed[1])
    acted, staging = read_acted(filmed[1], facts), read_staging(facts)
    assert staging is not None
    found = footsteps(acted, staging, 4.0)
    assert len(found) >= 4
    for one in found:
        own = acted.footings[acted.starts[one.who] : acted.starts[one.who + 1]]
        (footing,) = own[own[:, FROM] == np.float32(one.when)]
        assert footing[LAST] >= 0.0
        assert one.place[::2] == pytest.approx([footing[X], footing[Z]], abs=0.02)
        assert staging.rows(acted, one.when)[one.who, 4, 1] <= 0.5
    stone = {who for who, keys in facts["staging"]["stone"] if keys[0][1] == 1.0 and len(keys) == 1}
    assert not stone & {one.who for one in found}
    rate, sound = wavfile.read(filmed[0] / "sound.wav")
    first = round(found[0].when * rate)
    assert not sound[: first - 1].any()
    assert np.abs(sound[first : first + rate // 20]).max() > 300


def test_stone_is_grey_and_comes_alive_in_its_own_colours(filmed: tuple[Path, Path]) -> None:
    facts = read_facts(filmed[1])
    theatre = CrowdRenderer(read_stock(filmed[1], facts))
    view = ((5.3, 1.3, -1.2), (5.5, 1.0, -3.0))
    try:
        painter = painter_of(filmed[1], theatre)
        stone, alive = (painter.picture(view, now).astype(int) for now in (0.5, 1.999))
        painter._tiers = lambda *_: [np.zeros(0, np.int64)] * 5  # nobody
        bare = painter.picture(view, 0.5).astype(int)
    finally:
        theatre.close()
    there = [(np.abs(one - bare).max(axis=2) > 30)[:170] for one in (stone, alive)]
    assert min(one.sum() for one in there) > 1500
    spread = [(one[..., 0] - one[..., 2])[:170][mask].std() for one, mask in zip((stone, alive), there, strict=True)]
    assert spread[1] > 1.5 * spread[0], "of one colour, then of many"


def test_a_head_lies_on_the_ground_and_is_put_back(filmed: tuple[Path, Path]) -> None:
    facts = read_facts(filmed[1])
    staging, acted = read_staging(facts), read_acted(filmed[1], facts)
    theatre = CrowdRenderer(read_stock(filmed[1], facts))
    view = ((3.6, 1.6, -0.6), (3.6, 1.3, -3.2))
    try:
        painter = painter_of(filmed[1], theatre)
        apart, whole = (painter.picture(view, now).astype(int) for now in (0.5, 3.9))
    finally:
        theatre.close()
    assert staging is not None
    rows = staging.rows(acted, 0.5)
    assert rows[2, 0, 1:3] == pytest.approx([3.0, -1.6])
    moved = np.abs(apart - whole).max(axis=2) > 20
    assert moved[:110, 140:180].sum() > 200, "above the neck"


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
def test_the_page_plays_the_same_film_and_asks_nobody(filmed: tuple[Path, Path], tmp_path: Path) -> None:
    path = filmed[1] / "player.html"
    with browser(tmp_path / "profile") as page:
        page.open(path, *SIZE)
        page.wait_for("document.body?.dataset.ready === 'yes'", 120)
        page.value("document.querySelectorAll('#knobs, #stats').forEach((one) => one.style.display = 'none')")
        assert page.value("crowd.state.camera") == "film"
        for number, now in ((2, 0.5), (4, 1.5), (7, 3.0)):
            page.value(f"crowd.set({json.dumps({'now': now})})")
            page.value("crowd.draw() && 1")
            shown = page.picture().astype(float)
            drawn = np.asarray(Image.open(filmed[0] / f"0000{number}.png")).astype(float)
            assert np.abs(shown - drawn)[:190].mean() < 7.0, f"at {now} s"
        assert page.value("document.querySelector('#caption').textContent") == "So"
        assert page.complaints() == []
        assert page.requests() == [path.resolve().as_uri()]


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
def test_who_walks_in_the_page_walks_through_no_wall(filmed: tuple[Path, Path], tmp_path: Path) -> None:
    with browser(tmp_path / "profile") as page:
        page.open(filmed[1] / "player.html", *SIZE)
        page.wait_for("document.body?.dataset.ready === 'yes'", 120)
        west = page.value("room.walk(4, -3, -5, -3)")
        assert west == pytest.approx([0.25, -3.0], abs=0.15)
        along = page.value("room.walk(0.4, -3, -1, -5)")
        assert along == pytest.approx([0.25, -5.0], abs=0.2), "one slides along a wall"
        assert page.value("room.walk(40, -3, 41, -3)") == pytest.approx([7.75, -3.0], abs=0.2), "back from the air"
        page.value(
            "(setCamera('walk along'), camera.position.set(4, 1.65, -3), fly.yaw = Math.PI / 2, keys.add('w'), 1)"
        )
        page.value("(() => { for (let k = 0; k < 200; k++) steer(0.1); })()")
        assert page.value("camera.position.x") == pytest.approx(0.25, abs=0.15)
        page.value("(keys.clear(), camera.position.set(5.5, 1.65, -1), fly.yaw = 0, keys.add('w'), 1)")
        page.value("(() => { for (let k = 0; k < 200; k++) steer(0.1); })()")
        assert page.value("Math.hypot(camera.position.x - walkers.x[0], camera.position.z - walkers.z[0])") > 0.4


def test_the_film_is_a_film_and_the_pack_is_whole(filmed: tuple[Path, Path], lines, cast, lit_folder, tmp_path) -> None:
    said = film_file(lines, lit_folder, cast, tmp_path / "two.mp4", None)
    assert said[0] == "Two of stone: 4 s, 2 actors, 2 shots"
    film = cv2.VideoCapture(str(tmp_path / "two.mp4"))
    assert film.get(cv2.CAP_PROP_FRAME_COUNT) == 8
    assert film.get(cv2.CAP_PROP_FPS) == 2.0
    assert check_pack(filmed[1])[-1].startswith("scenario: 3 people act 4 s in ")


def test_who_stops_finds_nothing_left(lines, cast, lit_folder, tmp_path) -> None:
    def stop(step: str, share: float) -> None:
        if step == "pictures" and share > 0.3:
            raise Cancelled

    for name in ("a.mp4", "pictures"):
        with pytest.raises(Cancelled):
            film_file(lines, lit_folder, cast, tmp_path / name, None, stop)
    assert list(tmp_path.iterdir()) == []


def test_what_cannot_be_filmed_is_told_in_one_sentence(lines, cast, lit_folder, lively, tmp_path) -> None:
    def told(pattern: str, pack: Path = cast, text: str = FILM, out: Path | None = tmp_path / "x.mp4") -> None:
        path = tmp_path / "a.film"
        path.write_text(text)
        with pytest.raises(ClonerError, match=pattern):
            film_file(path, lit_folder, pack, out, None)

    told("nobody in the pack can be a statue", pack=lively)
    told("no clone is named zoe", text=FILM.replace("is ada", "is zoe"))
    told("nothing is to be written", out=None)
    told("line 13, column 1", text=FILM + "then all is well\n")
    (tmp_path / "x.mp4").write_bytes(b"mine")
    told("exists and is not replaced")
    assert (tmp_path / "x.mp4").read_bytes() == b"mine"
    with pytest.raises(ClonerError, match="there is no film"):
        film_file(tmp_path / "none.film", lit_folder, cast, tmp_path / "y.mp4", None)


def test_statues_of_a_scenario_are_clones_in_stone_that_awake(cast: Path, tmp_path: Path) -> None:
    from cloner.scenes.written import light_folder, make_folder

    (tmp_path / "hall.toml").write_text(
        '[sky]\nlight = [1, 1, 1]\n[[floor]]\nfrom = [0, 0]\nto = [6, 9]\nlook = "flags"\n[[block]]\nname = "lion"\n'
        'at = [1, 5]\nsize = [0.4, 0.4]\nlow = 0.5\nhigh = 2.2\nlook = "marble"\n'
    )
    (tmp_path / "hall.crowd").write_text(
        "floor 0, 0 to 6, 9\nstatue lion at 1, 5\npoint front at 4, 5 region 2 x 2 act look for 60 s look at lion\n"
        "group two: 2 people, visits front, starts at front\nat 2 s: lion awakens\n"
    )
    make_folder(str(tmp_path / "hall.toml"), tmp_path / "room")
    light_folder(tmp_path / "room")
    build_folder(tmp_path / "room", tmp_path / "hall.crowd", cast, tmp_path / "built", seconds=8.0, seed=1)
    facts = read_facts(tmp_path / "built")
    room, staging = read_room(tmp_path / "built", facts), read_staging(facts)
    assert room is not None
    assert staging is not None
    assert room.corners[:, 1].max() < 0.1, "the block is not drawn"
    acted = read_acted(tmp_path / "built", facts)
    before, after = staging.rows(acted, 1.0)[3], staging.rows(acted, 7.0)[3]  # after two people and a guest
    assert before[0, 1:3] == pytest.approx([1.0, -5.0])
    assert before[0, 3] == pytest.approx(np.pi / 2.0), "it faces the middle of the floor"
    assert before[4, 1:3] == pytest.approx([1.0, 0.5])
    assert after[4, 1:3] == pytest.approx([0.0, 0.5])


SPOKEN = """film "Talk" for 2.4 s, 320 x 240, 10 frames a second
actor ada is ada at 4, 3 facing 180
actor ben is ben at 5, 3 facing 180
at 0 s: camera at 4, 2.2, 1.6 looks at ada, lens 14
at .4 s: ada says "aa.txt"
at 1.2 s: ada feels happy
"""


@pytest.fixture(scope="module")
def talked(cast: Path, lit_folder: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Pictures of one who says "ah", and the staged pack."""
    folder = tmp_path_factory.mktemp("talked")
    (folder / "talk.film").write_text(SPOKEN)
    (folder / "aa.txt").write_text("AA 0.6\n")
    film_file(folder / "talk.film", lit_folder, cast, folder / "pictures", folder / "staged")
    return folder / "pictures", folder / "staged"


def test_a_mouth_opens_while_somebody_speaks(talked: tuple[Path, Path]) -> None:
    pictures = [np.asarray(Image.open(talked[0] / f"000{k:02d}.png")).astype(int) for k in (4, 8, 12)]
    before, open_, after = (int((one[190:, 110:200, 0] - one[190:, 110:200, 1] > 80).sum()) for one in pictures)
    assert open_ > 100, "the tongue is seen"
    assert max(before, after) < 20
    facts = read_facts(talked[1])
    held = read_stock(talked[1], facts)
    assert held.faces is not None
    assert len(held.body.vertex) > len(body_levels().vertex), "teeth and tongue"
    assert check_pack(talked[1])


def test_who_is_happy_smiles(talked: tuple[Path, Path]) -> None:
    facts = read_facts(talked[1])
    felt = feelings_at(read_acted(talked[1], facts), 2.3)
    names = [clip["name"] for clip in facts["people"][0]["clips"]]
    assert [names[int(clip)] for clip, _ in felt] == ["walk_happy", "walk"]
    theatre = CrowdRenderer(read_stock(talked[1], facts))
    view, shown = ((4.0, 1.6, -2.2), (4.0, 1.58, -3.0)), []
    try:
        painter = painter_of(talked[1], theatre)
        for _ in range(2):
            shown.append(painter.picture(view, 2.3, field_deg=14.0).astype(int))
            painter._feelings[:] = 0
    finally:
        theatre.close()
    at = np.argwhere(np.abs(shown[0] - shown[1]).max(axis=2) > 25)
    assert len(at) > 60
    assert at[:, 0].mean() > 120, "the mouth, in the lower half of the face"


def test_who_cannot_speak_is_told(talked: tuple[Path, Path], lively: Path, lit_folder: Path, tmp_path: Path) -> None:
    with pytest.raises(ClonerError, match=r"nobody in the pack can speak\. Make it with cloner crowd --faces"):
        film_file(talked[0].parent / "talk.film", lit_folder, lively, tmp_path / "x", None)


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
def test_the_page_opens_the_same_mouth(talked: tuple[Path, Path], tmp_path: Path) -> None:
    with browser(tmp_path / "profile") as page:
        page.open(talked[1] / "player.html", *SIZE)
        page.wait_for("document.body?.dataset.ready === 'yes'", 120)
        page.value("document.querySelectorAll('#knobs, #stats').forEach((one) => one.style.display = 'none')")
        shown = []
        for now in (0.3, 0.7):
            page.value(f"crowd.set({json.dumps({'now': now})})")
            page.value("crowd.draw() && 1")
            shown.append(page.picture().astype(int))
        assert page.value("uniforms.speakers.value") == 1
        drawn = [np.asarray(Image.open(talked[0] / f"000{k:02d}.png")).astype(int) for k in (4, 8)]
        moved = [np.abs(last - first).max(axis=2) > 40 for first, last in (shown, drawn)]
        assert (moved[0] & moved[1]).sum() > 0.7 * (moved[0] | moved[1]).sum()
        assert page.complaints() == []
