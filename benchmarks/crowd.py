"""Measure a crowd's pack and write ``docs/crowd_benchmark.md``: python benchmarks/crowd.py PACK RESULTS [--people N].

Levels against every triangle, impostors at the switch against 8 x 8 samples of geometry, both also off the baked
elevation, beside the source's plain impostors; sizes; whole pictures; frame times (see `crowd_frames.py`). RESULTS is
the folder of the results that the pack was made from.
"""

from __future__ import annotations

import argparse
import functools
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
from crowd_frames import in_browser
from crowd_pictures import hybrid_table
from skimage.metrics import structural_similarity

from cloner.crowd.clones import stock
from cloner.crowd.clones.cast import CrowdClone, make_crowd_clone
from cloner.crowd.clones.levels import body_levels
from cloner.crowd.clones.stock import TEXELS_PER_M, TEXELS_PER_PX, CrowdArrays
from cloner.crowd.drawing.impostors import BakeSettings, bake, with_tiles
from cloner.crowd.drawing.theatre import CrowdRenderer
from cloner.crowd.packs.check import check_pack, compressed_gpu_bytes, gpu_bytes
from cloner.crowd.packs.pack import LARGEST_PX, make_stock
from cloner.crowd.packs.reading import read_facts, read_stock
from cloner.crowd.staged.eye import CrowdCamera
from cloner.motion.limbs.rig import centre_joints
from cloner.project.clone_file import CLONE_FILE, load_clone
from cloner.project.flow_file import load_flow

PAGE = Path(__file__).resolve().parents[1] / "docs" / "crowd_benchmark.md"
FOCAL_PX = 869.0  # 45 degrees over 720 lines
STATURE_M = 1.75
GREY = (0.5, 0.5, 0.5, 1.0)
SEED = 5
CASES = 12
FINEST_PX = 384  # the finest level has no largest height; half a screen of 720 lines
MIB = 1 << 20
SECTIONS = ("", "Looks", "Hybrid pictures against anti-aliased geometry", "Frame times")
BARS = {"impostor": ".985, worst .975", "impostor, -10 degrees of elevation": ".98",
        "impostor, +10 degrees of elevation": ".98"}  # fmt: skip


@dataclass
class Person:
    """One clone in one theatre: level 0 is every triangle, the pack's levels follow."""

    cast: CrowdClone
    theatre: CrowdRenderer

    def shot(
        self, case: tuple[float, float, float, float], px: float, level: int | None, over: int, *,
        four: bool = False, classic: bool = False, off_deg: float = 0.0,
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
        eye = CrowdCamera(place, middle + shift, (side * over, side * over), FOCAL_PX * over)
        target = self.theatre.target((side * over, side * over), 1, 4 if four else 0)
        self.theatre.begin(target, GREY)
        values = {"clipFromWorld": eye.clip_from_world(), "eye": eye.place_m, "focalPx": FOCAL_PX, "coarse": 1,
                  "classic": int(classic)}  # fmt: skip
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


@functools.cache
def held_by(pack: Path) -> tuple[dict[str, Any], CrowdArrays]:
    """Return a pack's facts and stock, read once a process."""
    facts = read_facts(pack)
    return facts, read_stock(pack, facts)


def person_of(pack: Path, results: Path, k: int) -> tuple[CrowdClone, CrowdArrays, BakeSettings]:
    """Return one of a pack's clones with every triangle before the pack's own levels."""
    (facts, held), body = held_by(pack), body_levels(full=True)
    row = facts["people"][k]
    clone = centre_joints(load_clone(results / row["id"] / CLONE_FILE))
    flow = load_flow(results / row["id"], clone)
    cast = make_crowd_clone(row["id"], clone, body, poses=facts["impostors"]["poses"], flow=flow, budgets=held.budgets)
    budgets = (len(cast.loose.triangles[0]), *held.budgets)
    plan = BakeSettings(row["views"], elevations=held.elevations, texels_per_m=facts["switch"]["texels_per_m"])
    sets = [(int(one[0]), stock.BakedClip(int(one[2]))) for one in held.table[k, stock.SETS_AT :][: len(cast.clips)]]
    own = make_stock(body, [cast], [stock.clone_arrays(cast, budgets)], [sets], plan, budgets)
    own = replace(own, tiles=held.tiles[k : k + 1], colours=held.colours[k : k + 1], shapes=held.shapes[k : k + 1],
                  elevations=held.elevations)  # fmt: skip
    return cast, own, plan


def cases(seed: int) -> list[tuple[float, float, float, float]]:
    dice = np.random.default_rng(seed)
    turns = (np.arange(CASES) + dice.uniform(0, 1, CASES)) / CASES * 2 * np.pi
    phases, across, up = dice.permutation(CASES) / CASES, dice.uniform(0, 1, CASES), dice.uniform(0, 1, CASES)
    return [tuple(map(float, one)) for one in zip(turns, phases, across, up, strict=True)]


def looked_at(pack: Path, results: Path, wanted: int, classic: int, processes: int) -> list[str]:
    """Return the tables of levels and impostors."""
    count = min(wanted, len(read_facts(pack)["people"]))
    levels: dict[int, list[float]] = {k: [] for k in range(4)}
    lowest: dict[int, tuple[float, str]] = {}
    rows: dict[str, list[float]] = {}
    with ProcessPoolExecutor(processes, get_context("spawn")) as pool:
        every = pool.map(one_looked_at, [pack] * count, [results] * count, range(count), [classic] * count)
        for identifier, own_levels, own_rows in every:
            for level, found in own_levels.items():
                levels[level] += found
                lowest[level] = min(lowest.get(level, (2.0, "")), (float(np.mean(found)), identifier))
            for name, found in own_rows.items():
                rows.setdefault(name, []).extend(found)
            print(identifier, {k: round(float(np.mean(v)), 4) for k, v in (own_levels | own_rows).items()}, flush=True)
    told = ["| level | at px | SSIM mean | worst clone's mean | worst | bar |", "| --- | --- | --- | --- | --- | --- |"]
    for level, found in levels.items():
        low, who = lowest[level]
        told.append(f"| {level} | {LARGEST_PX[level] or FINEST_PX} | {np.mean(found):.4f} | {low:.4f} ({who}) | "
                    f"{min(found):.4f} | .98 |")  # fmt: skip
    told += ["", "| at the switch | SSIM mean | worst | cases | bar |", "| --- | --- | --- | --- | --- |"]
    told += [
        f"| {name} | {np.mean(v):.4f} | {min(v):.4f} | {len(v)} | {BARS.get(name, '')} |" for name, v in rows.items()
    ]
    return told


def one_looked_at(
    pack: Path, results: Path, number: int, classic: int
) -> tuple[str, dict[int, list[float]], dict[str, list[float]]]:
    """Return one clone's likenesses, by level and by what was drawn at the switch."""
    levels: dict[int, list[float]] = {k: [] for k in range(4)}
    rows: dict[str, list[float]] = {}
    switch_px = FOCAL_PX * STATURE_M / (FOCAL_PX * TEXELS_PER_PX / TEXELS_PER_M)
    cast, own, plan = person_of(pack, results, number)
    person = Person(cast, CrowdRenderer(own))
    for case in cases(SEED + number):
        for level in range(4):
            px, over = float(LARGEST_PX[level] or FINEST_PX), 4 if 0 < LARGEST_PX[level] <= 128 else 2
            want = person.shot(case, px, 0, over)
            levels[level].append(likeness(want, person.shot(case, px, level + 1, over)))
        want = person.shot(case, switch_px, 0, 8)
        for name, got in (
            ("impostor", person.shot(case, switch_px, None, 1)),
            ("geometry, one sample a pixel", person.shot(case, switch_px, 0, 1)),
            ("geometry, four samples a pixel", person.shot(case, switch_px, 0, 1, four=True)),
        ):
            rows.setdefault(name, []).append(likeness(want, got))
        for off in (-10.0, 10.0):
            high = person.shot(case, switch_px, 0, 8, off_deg=off)
            got = person.shot(case, switch_px, None, 1, off_deg=off)
            rows.setdefault(f"impostor, {off:+.0f} degrees of elevation", []).append(likeness(high, got))
    person.theatre.close()
    if number < classic:
        for name, value in classics(cast, own, plan, SEED + number, switch_px):
            rows.setdefault(name, []).append(value)
    return cast.identifier, levels, rows


def classics(
    cast: CrowdClone, own: CrowdArrays, plan: BakeSettings, seed: int, switch_px: float
) -> Iterator[tuple[str, float]]:
    """Yield the source's way: one texel a pixel, the nearest view, no depth; colours directly, not by UV map."""
    body, thin = body_levels(full=True), replace(plan, texels_per_m=plan.texels_per_m / TEXELS_PER_PX)
    tiles = bake(cast, body, own, thin)
    again = make_stock(body, [cast], own.numbers, [tiles.sets], thin, own.budgets)
    person = Person(cast, CrowdRenderer(with_tiles(again, [tiles], thin)))
    for case in cases(seed):
        want = person.shot(case, switch_px, 0, 8)
        got = person.shot(case, switch_px, None, 1, classic=True)
        yield "impostor of the source (classic), 1 texel a pixel", likeness(want, got)
    person.theatre.close()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pack", type=Path)
    parser.add_argument("results", type=Path)
    parser.add_argument("--clones", type=int, default=256)
    parser.add_argument("--classic", type=int, default=2)
    parser.add_argument("--made", type=float, nargs=2, metavar=("CPU_S", "PEAK_MIB"), help="as /usr/bin/time told")
    parser.add_argument("--people", type=int, default=0, help="in the frame times; 0 leaves the browser out")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--npm", type=Path, help="folder of node_modules with three, @three.ez/instanced-mesh, esbuild")
    parser.add_argument("--pictures", type=Path)
    parser.add_argument("--page", type=Path, default=PAGE)
    told = parser.parse_args()
    if told.pictures:
        told.pictures.mkdir(parents=True, exist_ok=True)
    begun = time.monotonic()
    keep(told.page, "", facts_of(told.pack, told.made))
    if told.clones:
        keep(told.page, "Looks", looked_at(told.pack, told.results, told.clones, told.classic, told.processes))
        keep(told.page, "Hybrid pictures against anti-aliased geometry", hybrid_table(told.pack))
    if told.people:
        lines = in_browser(told.pack, told.results, told.people, told.rounds, told.npm, told.pictures)
        keep(told.page, "Frame times", lines)
    print(f"{time.monotonic() - begun:.0f} s")
    print(told.page.read_text(encoding="utf-8"))


def keep(page: Path, name: str, lines: list[str]) -> None:
    """Write one section of the page and leave the others."""
    kept = sections(page) | {name: "\n".join(lines)}
    text = "\n\n".join(f"## {one}\n\n{kept[one]}" if one else kept[one] for one in SECTIONS if one in kept)
    page.write_text(text + "\n", encoding="utf-8")


def facts_of(pack: Path, made: list[float] | None) -> list[str]:
    """Return the head of the page: what the pack holds and what making it took."""
    facts = read_facts(pack)
    lines = ["# Crowd", "", f"Written by `benchmarks/crowd.py`; {len(facts['people'])} clones in the pack.", ""]
    lines += [f"- {line}" for line in check_pack(pack)]
    size = sum(one.stat().st_size for one in pack.rglob("*") if one.is_file())
    lines.append(f"- {size / len(facts['people']) / 1e6:.2f} MB a clone on the disk (bar 3)")
    memory = gpu_bytes(pack, facts)
    lines.append(f"- texture memory {sum(memory.values()) / MIB:.0f} MiB RGBA8 (bar 150 MiB for 20 clones), "
                 f"{compressed_gpu_bytes(memory) / MIB:.0f} MiB in blocks (bar 64)")  # fmt: skip
    if made:
        lines.append(f"- making it: {made[0]:.0f} CPU s (bar 600), at most {made[1]:.0f} MiB (bar 1536)")
    return lines


def sections(page: Path) -> dict[str, str]:
    """Return a page's sections by title, so that a part can be measured again alone."""
    text = page.read_text(encoding="utf-8") if page.exists() else ""
    head, *rest = text.split("\n## ")
    found = {"": head.strip()} if head.strip() else {}
    return found | {title: body.strip() for title, _, body in (one.partition("\n") for one in rest)}


if __name__ == "__main__":
    main()
