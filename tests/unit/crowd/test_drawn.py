"""Pictures of a pack: impostors stand in for geometry, dyes and tiers do what they say; here and in a browser."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from skimage.metrics import structural_similarity

from cloner.crowd.drawing.impostors import Tiles
from cloner.crowd.drawing.player import player_page
from cloner.crowd.drawing.texels import SAMPLES, downsample_tiles
from cloner.crowd.drawing.theatre import CrowdRenderer
from cloner.crowd.packs.files import tile_files, tiles_from
from cloner.crowd.packs.reading import read_casting, read_facts, read_stock
from cloner.crowd.packs.still import ScenePainter, draw_pack
from cloner.crowd.staged.eye import CrowdCamera
from cloner.crowd.staged.scene import make_scene
from cloner.errors import ClonerError
from kit.browser import CHROMIUM, browser
from kit.crowds import likeness, row, shot
from kit.firefox import FIREFOX, SCREEN, opened

pytestmark = [pytest.mark.gl, pytest.mark.slow]
HELD_BYTES = """["colours", "atlases", "shells", "codes"].map((name) => stage.textures[name]).filter(Boolean)
  .flatMap((one) => one.mipmaps.length ? one.mipmaps : [one.image]).reduce((sum, one) => sum + one.data.length, 0)"""


@pytest.fixture(scope="module")
def theatre(pack: Path):
    made = CrowdRenderer(read_stock(pack, read_facts(pack)))
    yield made
    made.close()


@pytest.mark.parametrize("heading", [0.0, 0.3, np.pi / 4, 2.6, np.pi, 4.1, 5.9])
def test_an_impostor_looks_like_the_geometry_it_stands_for(theatre: CrowdRenderer, heading: float) -> None:
    """Eight views only, so up to 22 degrees off: depth and the second view must make up for it."""
    person = row(heading=heading)
    want, got = shot(theatre, person, 0), shot(theatre, person, None)
    assert 200 < (np.abs(want - 127.5).max(axis=2) > 4).sum() < 600  # 40 px tall, 5 to 15 wide
    assert likeness(want, got) > 0.88


def test_a_dye_reaches_geometry_and_impostor_alike_and_only_cloth(theatre: CrowdRenderer) -> None:
    plain, dyed = row(), row(dyes=(0xC81414, -1, -1, -1))
    for level in (0, None):
        before, after = shot(theatre, plain, level), shot(theatre, dyed, level)
        changed = np.abs(after - before).max(axis=2) > 30
        rows = np.flatnonzero(changed.any(axis=1))
        assert changed.sum() > 60
        assert rows.min() > 28  # the shirt: between chin and hips of a person from row 28 to 68
        assert rows.max() < 60
        assert (after[changed][:, 0] > after[changed][:, 2] + 20).mean() > 0.9


@pytest.mark.parametrize("wearer", [0, 1])
def test_lent_sleeves_end_alike_near_and_far(theatre: CrowdRenderer, wearer: int) -> None:
    """Ada's shirt has short sleeves, ben's long ones: forearms change between skin and cloth, hands never do."""
    own, lent = row(clone=wearer), row(clone=wearer, top=1 - wearer)
    blueness = {}
    for level in (0, None):
        before, after = shot(theatre, own, level), shot(theatre, lent, level)
        bluer = (after[..., 2] - after[..., 0]) - (before[..., 2] - before[..., 0])
        blueness[level] = bluer if wearer == 0 else -bluer
    forearms = blueness[0] > 40
    assert forearms.sum() > 10
    assert (blueness[None][forearms] > 25).mean() > 0.8
    assert (blueness[None] > 40).sum() < 2.0 * forearms.sum()


def test_a_white_dye_is_white(theatre: CrowdRenderer) -> None:
    """0xFFFFFF is the last whole number below 2^24: half more would turn red."""
    white = shot(theatre, row(dyes=(0xFFFFFF, -1, -1, -1)), 0)[44:50, 45:51].reshape(-1, 3).mean(axis=0)
    assert np.ptp(white) < 25


def test_a_still_shows_people_and_bad_views_are_refused(pack: Path, tmp_path: Path) -> None:
    out = tmp_path / "crowd.png"
    draw_pack(pack, "street", out, "320x180")
    picture = np.asarray(Image.open(out)).astype(int)
    blue = (picture[..., 2] > picture[..., 0] + 25) & (picture[..., 2] > 60) & (picture[..., 0] < 140)
    assert blue.sum() > 60  # shirts
    with pytest.raises(ClonerError, match="no view"):
        draw_pack(pack, "moon", out, "320x180")
    with pytest.raises(ClonerError, match="no size"):
        draw_pack(pack, "street", out, "big")


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine: the player is not opened")
def test_the_player_opens_from_the_disk_and_asks_nobody(pack: Path, tmp_path: Path) -> None:
    with browser(tmp_path / "profile") as page:
        page.open(pack / "player.html", 320, 200)
        page.wait_for("document.body && document.body.dataset.ready", 120)
        page.value("crowd.set({scene: 'plaza', people: 60, place: [0, 6, 22], target: [0, 1, 0], now: 3})")
        stats = page.value("crowd.draw()")
        assert sum(stats["counts"]) == 60
        assert stats["draws"] <= 8
        page.value("crowd.time(1)")
        picture = page.picture().astype(int)[40:180]
        shirts = (picture[..., 2] > picture[..., 0] + 25) & (picture[..., 0] < 140)
        assert shirts.sum() > 40
        assert page.value("crowd.set({debug: 1, mode: 'levels'}), crowd.draw().draws") >= 3, "wires are drawn"
        page.value("crowd.set({debug: 1, mode: 'hybrid', place: [0, 30, 90], target: [0, 0, 0]})")
        page.value("crowd.time(1)")
        green = page.picture().astype(int)[40:180]
        assert ((green[..., 1] > 150) & (green[..., 0] < 80)).sum() > 30  # impostors
        assert not page.complaints()
        assert all(address.startswith(("file:", "blob:", "data:", "about:")) for address in page.requests())


@pytest.mark.skipif(not (FIREFOX and SCREEN), reason="no Firefox with a screen here: apt-get install firefox-esr xvfb")
def test_firefox_shows_the_player_too_and_it_asks_nobody(pack: Path, tmp_path: Path) -> None:
    setup = "crowd.set({scene: 'plaza', people: 60, place: [0, 6, 22], target: [0, 1, 0], now: 3})"
    told = opened(pack / "player.html", tmp_path / "profile", "document.body && document.body.dataset.ready",
                  [f"({setup}, crowd.draw())", "crowd.time(1).length"])  # fmt: skip
    assert sum(told["values"][0]["counts"]) == 60
    assert told["values"][1] == 1
    assert not told["errors"]
    assert all(address.startswith(("file:", "blob:", "data:", "about:")) for address in told["requests"])


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine: the player is not opened")
def test_textures_in_blocks_look_the_same_in_less_memory(pack: Path, tmp_path: Path) -> None:
    shown, sizes = [], []
    for compressed in (False, True):
        facts = read_facts(pack) | ({"compressed": True} if compressed else {})
        page_file = tmp_path / f"{compressed}.html"
        page_file.write_bytes(player_page(pack, facts))
        with browser(tmp_path / f"profile{compressed}") as page:
            page.open(page_file, 320, 200)
            page.wait_for("document.body && document.body.dataset.ready", 120)
            assert page.value("state.blocks") is compressed
            page.value("crowd.set({scene: 'plaza', people: 60, place: [0, 6, 22], target: [0, 1, 0], now: 3})")
            page.value("document.querySelectorAll('#stats, #knobs').forEach((one) => { one.style.display = 'none'; })")
            page.value("crowd.time(2)")
            shown.append(page.picture()[40:180])
            sizes.append(page.value(HELD_BYTES))
            assert not page.complaints()
    assert structural_similarity(*shown, channel_axis=2, data_range=255) > 0.97
    assert sizes[1] < 0.45 * sizes[0]


def test_geometry_alone_shows_nobody_as_an_impostor(pack: Path) -> None:
    facts = read_facts(pack)
    made = make_scene("plaza", 60, read_casting(facts))
    theatre = CrowdRenderer(read_stock(pack, facts))
    eye = CrowdCamera(np.array([0.0, 9.0, 90.0]), np.zeros(3), (320, 180), 200.0)
    painter = ScenePainter(theatre, facts, made, (320, 180))
    count = {mode: [len(who) for who in painter._tiers(eye, 0.0, mode)] for mode in ("hybrid", "levels", "geometry")}
    theatre.close()
    assert count["hybrid"][-1] > 50
    assert count["levels"][-1] == 0
    assert count["geometry"] == [60, 0, 0, 0, 0]


def test_scene_rows_fit_the_shaders(pack: Path) -> None:
    made = make_scene("plaza", 60, read_casting(read_facts(pack)))
    assert made.rows.shape == (60, 5, 4)
    assert set(np.unique(made.rows[:, 1, 2])) <= {0.0, 1.0}


def test_a_texel_at_the_rim_has_its_persons_code() -> None:
    side = 2 * SAMPLES
    colour, shape = np.zeros((2, side, side, 4), np.uint8)
    colour[:, : side // 3] = 255  # a third of the block is covered, all of it shirt
    shape[:, : side // 3, 3] = 3
    _, shapes = downsample_tiles(colour, shape)
    assert shapes.shape == (1, 1, 4)
    assert shapes[0, 0, 3] == 3
    _, fine = downsample_tiles(colour, shape, 1)
    assert fine.shape == (2, 2, 4)
    assert (fine[..., 3] == 3).all()


@pytest.mark.parametrize("every", [1, 2])
def test_pictures_of_shape_keep_their_size_and_their_codes(every: int) -> None:
    rng = np.random.default_rng(3)
    wide, tall = 64, 48
    smooth = np.linspace(60.0, 190.0, wide // every)[None, :, None] * np.ones((tall // every, 1, 3))
    codes = rng.integers(0, 9, (tall // 2, wide // 2)).astype(np.uint8).repeat(2 // every, axis=0)
    shapes = np.dstack([smooth.astype(np.uint8), codes.repeat(2 // every, axis=1)])
    rows = np.zeros((2, 4), np.float32)
    tiles = Tiles(rows, (), 0, np.full((tall, wide, 4), 128, np.uint8), shapes)
    again = tiles_from(tile_files(tiles), rows)
    assert np.array_equal(again.shapes[..., 3], shapes[..., 3])
    assert np.abs(again.shapes[..., :3].astype(int) - shapes[..., :3]).mean() < 3.0
