"""Measure a crowd's pack and write ``docs/crowd_benchmark.md``: python benchmarks/crowd.py PACK RESULTS [--browser N].

Levels against every triangle, impostors at the switch against 8 x 8 samples of geometry, both also off the baked
elevation, beside the source's plain impostors; sizes; frame times in Chromium's software rasteriser, taken in turns in
one session. RESULTS is the folder of the results that the pack was made from.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from skimage.metrics import structural_similarity

from cloner.crowd.clones import stock
from cloner.crowd.clones.cast import Cast, cast_of
from cloner.crowd.clones.levels import LOOSE, body_levels
from cloner.crowd.clones.stock import Stock
from cloner.crowd.drawing.impostors import TEXELS_PER_M, TEXELS_PER_PX, Bake, bake, with_tiles
from cloner.crowd.drawing.theatre import Theatre
from cloner.crowd.packs.check import check_pack, gpu_bytes
from cloner.crowd.packs.pack import LARGEST_PX, stock_of
from cloner.crowd.packs.reading import read_facts, read_stock
from cloner.crowd.staged.eye import Eye
from cloner.motion.limbs.rig import centred
from cloner.project.clone_file import CLONE_FILE, load_clone

PAGE = Path(__file__).resolve().parents[1] / "docs" / "crowd_benchmark.md"
FOCAL_PX = 869.0  # 45 degrees over 720 lines
STATURE_M = 1.75
GREY = (0.5, 0.5, 0.5, 1.0)
SEED = 5
CASES = 12
FINEST_PX = 384  # the finest level has no largest height; half a screen of 720 lines
MIB = 1 << 20


@dataclass
class Person:
    """One clone in one theatre: level 0 is every triangle, the pack's levels follow."""

    cast: Cast
    theatre: Theatre

    def shot(
        self, case: tuple[float, float, float, float], px: float, level: int | None, over: int, *,
        soft: bool = False, classic: bool = False, off_deg: float = 0.0,
    ) -> np.ndarray:  # fmt: skip
        """One person ``px`` tall; ``case`` is heading, phase and sub-pixel place; level None is the impostor."""
        heading, phase, dx, dy = case
        away, up = FOCAL_PX * STATURE_M / px, np.radians(5.0 + off_deg)
        row = np.zeros((1, 5, 4), np.float32)
        row[0, 0], row[0, 1] = (0, 0, 0, heading), (0, phase, 0, 1)
        row[0, 3] = -1
        self.theatre.send_people(row)
        middle = np.array([0.0, stock.middle_m(self.cast), 0.0])
        shift = np.array([dx, dy, 0.0]) * away / FOCAL_PX
        place = middle + shift + away * np.array([0.0, np.sin(up), np.cos(up)])
        side = int(px * 1.3) // 2 * 2
        eye = Eye(place, middle + shift, (side * over, side * over), FOCAL_PX * over)
        target = self.theatre.target((side * over, side * over), 1, 4 if soft else 0)
        self.theatre.begin(target, GREY, soft=soft and level is None)
        values = {"clipFromWorld": eye.clip_from_world(), "eye": eye.place_m, "focalPx": FOCAL_PX, "coarse": 1,
                  "cutoff": 0.0 if soft else 0.5, "classic": int(classic)}  # fmt: skip
        one = np.array([[0.0, 1.0]], np.float32)
        if level is None:
            self.theatre.draw_impostors(one, values)
        else:
            self.theatre.draw_people(level, one, values)
        picture = self.theatre.read(target)[..., :3].astype(float)
        return picture.reshape(side, over, side, over, 3).mean(axis=(1, 3))


def likeness(want: np.ndarray, got: np.ndarray) -> float:
    """SSIM in the box of the person with four pixels around."""
    seen = np.argwhere(np.abs(want - 127.5).max(axis=2) > 3)
    low, high = np.maximum(seen.min(axis=0) - 4, 0), seen.max(axis=0) + 5
    box = np.s_[low[0] : high[0], low[1] : high[1]]
    return float(structural_similarity(want[box], got[box], channel_axis=2, data_range=255.0))


def people_of(pack: Path, results: Path, wanted: int) -> Iterator[tuple[Cast, Stock, Bake]]:
    """Yield the pack's clones with every triangle before the pack's own levels."""
    facts = read_facts(pack)
    held, body = read_stock(pack, facts), body_levels(full=True)
    for k, row in enumerate(facts["people"][:wanted]):
        clone = centred(load_clone(results / row["id"] / CLONE_FILE))
        cast = cast_of(row["id"], clone, body, poses=facts["impostors"]["poses"])
        budgets = (len(cast.loose.triangles[0]), *LOOSE)
        plan = Bake(row["views"], held.elevations, facts["switch"]["texels_per_m"])
        starts = [int(one[0]) for one in held.table[k, stock.SETS_AT : stock.SETS_AT + len(cast.clips)]]
        own = stock_of(body, [cast], [stock.numbers_of(cast, budgets)], [starts], plan, budgets)
        own = replace(own, tiles=held.tiles[k : k + 1], colours=held.colours[k : k + 1], shapes=held.shapes[k : k + 1],
                      elevations=held.elevations)  # fmt: skip
        yield cast, own, plan


def cases(seed: int) -> list[tuple[float, float, float, float]]:
    dice = np.random.default_rng(seed)
    turns = (np.arange(CASES) + dice.uniform(0, 1, CASES)) / CASES * 2 * np.pi
    phases, across, up = dice.permutation(CASES) / CASES, dice.uniform(0, 1, CASES), dice.uniform(0, 1, CASES)
    return [tuple(map(float, one)) for one in zip(turns, phases, across, up, strict=True)]


def looked_at(pack: Path, results: Path, wanted: int, classic: int) -> list[str]:
    """Return the tables of levels and impostors."""
    levels: dict[int, list[float]] = {k: [] for k in range(4)}
    rows: dict[str, list[float]] = {}
    switch_px = FOCAL_PX * STATURE_M / (FOCAL_PX * TEXELS_PER_PX / TEXELS_PER_M)
    for number, (cast, own, plan) in enumerate(people_of(pack, results, wanted)):
        person = Person(cast, Theatre(own))
        for case in cases(SEED + number):
            for level in range(4):
                px, over = float(LARGEST_PX[level] or FINEST_PX), 4 if 0 < LARGEST_PX[level] <= 128 else 2
                want = person.shot(case, px, 0, over)
                levels[level].append(likeness(want, person.shot(case, px, level + 1, over)))
            want = person.shot(case, switch_px, 0, 8)
            rows.setdefault("impostor", []).append(likeness(want, person.shot(case, switch_px, None, 1, soft=True)))
            plain = person.shot(case, switch_px, 0, 1)
            rows.setdefault("geometry, one sample a pixel", []).append(likeness(want, plain))
            four = person.shot(case, switch_px, 0, 1, soft=True)
            rows.setdefault("geometry, four samples a pixel", []).append(likeness(want, four))
            for off in (-10.0, 10.0):
                high = person.shot(case, switch_px, 0, 8, off_deg=off)
                got = person.shot(case, switch_px, None, 1, soft=True, off_deg=off)
                rows.setdefault(f"impostor, {off:+.0f} degrees of elevation", []).append(likeness(high, got))
        person.theatre.close()
        if number < classic:
            for name, value in classics(cast, own, plan, SEED + number, switch_px):
                rows.setdefault(name, []).append(value)
        print(
            f"{number + 1} {cast.identifier}: " + "  ".join(f"{n} {np.mean(v):.4f}" for n, v in rows.items()),
            flush=True,
        )
    told = ["| level | at px | SSIM mean | worst | bar |", "| --- | --- | --- | --- | --- |"]
    for level, found in levels.items():
        told.append(f"| {level} | {LARGEST_PX[level] or FINEST_PX} | {np.mean(found):.4f} | {min(found):.4f} | .98 |")
    told += ["", "| at the switch | SSIM mean | worst | cases |", "| --- | --- | --- | --- |"]
    told += [f"| {name} | {np.mean(v):.4f} | {min(v):.4f} | {len(v)} |" for name, v in rows.items()]
    return told


def classics(cast: Cast, own: Stock, plan: Bake, seed: int, switch_px: float) -> Iterator[tuple[str, float]]:
    """Yield the source's way: one texel a pixel, the nearest view, no depth; colours directly, not by UV map."""
    body, thin = body_levels(full=True), Bake(plan.views, plan.elevations, plan.texels_per_m / TEXELS_PER_PX)
    tiles = bake(cast, body, own, thin)
    again = stock_of(body, [cast], own.numbers, [tiles.starts], thin, own.budgets)
    person = Person(cast, Theatre(with_tiles(again, [tiles], thin)))
    for case in cases(seed):
        want = person.shot(case, switch_px, 0, 8)
        got = person.shot(case, switch_px, None, 1, soft=True, classic=True)
        yield "impostor of the source (classic), 1 texel a pixel", likeness(want, got)
    person.theatre.close()


def in_browser(pack: Path, people: int, rounds: int, pictures: Path | None) -> list[str]:
    """Return frame times, taken in turns in one session, and the choice's."""
    sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))
    from PIL import Image

    from kit.browser import browser

    told: list[str] = []
    with tempfile.TemporaryDirectory() as folder, browser(Path(folder)) as page:
        page.open(pack / "player.html", 1280, 720)
        page.wait_for("document.body && document.body.dataset.ready", 300)
        best: dict[str, float] = {}
        draws = 0
        setup = f"scene: 'walk', people: {people}, place: [0, 1.7, 24], target: [0, 1.4, -40], now: 3"
        for _ in range(rounds):
            for mode in ("hybrid", "levels", "geometry"):
                page.value(f"crowd.set({{{setup}, mode: '{mode}'}})")
                found = min(page.value("crowd.time(3)"))  # the first one compiles shaders
                best[mode] = min(best.get(mode, np.inf), found)
                draws = max(draws, page.value("crowd.state.stats.draws"))
                print(mode, f"{found:.0f} ms", page.value("JSON.stringify(crowd.state.stats.counts)"), flush=True)
        hybrid, alone, finest = (best[mode] for mode in ("hybrid", "levels", "geometry"))
        told.append(
            f"{people} people, 1280 x 720, minimum of {rounds}: hybrid {hybrid:.0f} ms, levels alone {alone:.0f} ms "
            f"({alone / hybrid:.1f} x), level 0 for everybody {finest:.0f} ms ({finest / hybrid:.1f} x); "
            f"most draws {draws}."
        )
        for count in (10_000, 60_000):
            page.value(
                f"crowd.set({{scene: 'plaza', people: {count}, place: [0, 30, 160], target: [0, 0, 0], "
                "mode: 'hybrid'})"
            )
            found = page.value("crowd.choices(60)")
            told.append(
                f"Choice of level, {count} people: median {np.median(found):.2f} ms, worst {max(found):.2f} ms."
            )
        outside = [one for one in page.requests() if not one.startswith(("file:", "blob:", "data:", "about:"))]
        told.append(f"Requests to anywhere: {len(outside)}. Errors in the console: {len(page.complaints())}.")
        if pictures:
            for name, view in PICTURES.items():
                page.value(f"crowd.set({{{view}, mode: 'hybrid'}})")
                page.value("crowd.time(1)")
                Image.fromarray(page.picture()).save(pictures / f"crowd_{name}.jpg", quality=82)
    return told


PICTURES = {
    "plaza": "scene: 'plaza', people: 3000, place: [0, 14, 52], target: [0, 0, 0], now: 3, debug: 0",
    "stadium": "scene: 'stadium', people: 4000, place: [0, 9, 22], target: [0, 4, -30], now: 3, debug: 0",
    "tiers": "scene: 'plaza', people: 3000, place: [0, 14, 52], target: [0, 0, 0], now: 3, debug: 1",
    "near": "scene: 'walk', people: 150, place: [0, 1.7, 9], target: [0, 1.2, 0], now: 3, debug: 0",
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pack", type=Path)
    parser.add_argument("results", type=Path)
    parser.add_argument("--clones", type=int, default=256)
    parser.add_argument("--classic", type=int, default=2)
    parser.add_argument("--browser", type=int, default=0, help="people in the frame times; 0 leaves the browser out")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--pictures", type=Path)
    parser.add_argument("--page", type=Path, default=PAGE)
    told = parser.parse_args()
    begun = time.monotonic()
    lines = [
        "# Crowd",
        "",
        f"Written by `benchmarks/crowd.py`; {len(read_facts(told.pack)['people'])} clones in the pack.",
        "",
    ]
    lines += [f"- {line}" for line in check_pack(told.pack)]
    memory = gpu_bytes(told.pack, read_facts(told.pack))
    lines += [
        f"- texture memory {sum(memory.values()) / MIB:.0f} MiB RGBA8 (bar 150 MiB for 20 clones)",
        "",
        "## Looks",
        "",
    ]
    if told.clones:
        lines += looked_at(told.pack, told.results, told.clones, told.classic)
    if told.browser:
        lines += ["", "## In Chromium, software rasteriser", ""]
        lines += [f"- {line}" for line in in_browser(told.pack, told.browser, told.rounds, told.pictures)]
    lines += ["", f"({time.monotonic() - begun:.0f} s)", ""]
    told.page.write_text("\n".join(lines), encoding="utf-8")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
