"""Frame times of a crowd in a browser's software rasteriser, every way in turns in one session.

A page of the pack's first clones whose finest level holds every triangle; 1,000 people in view between 3 and 100 m, as
many on a square metre everywhere. Beside it three's own skinned meshes and ``@three.ez/instanced-mesh`` where the
folder ``node_modules`` of ``npm install three @three.ez/instanced-mesh esbuild`` is told.
"""

from __future__ import annotations

import base64
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from cloner.crowd.clones import stock
from cloner.crowd.clones.cast import make_crowd_clone
from cloner.crowd.clones.levels import body_levels
from cloner.crowd.drawing.player import HELD, player_page
from cloner.crowd.packs.files import pack_arrays
from cloner.crowd.packs.pack import body_arrays
from cloner.crowd.packs.reading import read_facts, read_stock
from cloner.motion.limbs.rig import centre_joints
from cloner.project.clone_file import CLONE_FILE, load_clone

CLONES = 2
FIELD = """
SCENES.field = (people, casting, dice) => {
  const rows = [];
  for (let k = 0; k < people; k++) {
    const away = Math.sqrt(9 + dice.roll() * (1e4 - 9)), aside = (dice.roll() - 0.5) * 1.16;
    addTo(rows, [0, away * Math.sin(aside), -away * Math.cos(aside), dice.roll() * 6.283], 1.3, k % casting.clones,
          WALK, 0, casting, dice);
  }
  return { rows, lane: 100 };
};
"""
VIEW = "place: [0, 1.7, 0], target: [0, 1.4, -40], now: 3"
FARTHEST_PX = 1e9  # the level of all triangles is never chosen but when asked for
MODES = {"hybrid": ("hybrid", ""), "levels": ("levels alone", "5"), "impostors": ("impostors alone", ""),
         "geometry": ("every triangle", "50")}  # fmt: skip

RENDERER = """(() => {
  const gl = document.createElement("canvas").getContext("webgl2"), told = gl.getExtension("WEBGL_debug_renderer_info");
  return gl.getParameter(told ? told.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
})()"""
PLACES = """window.places = (count) => {
  const rows = sceneOf("field", count, facts.looks).rows;
  return Array.from({ length: count }, (_, k) => [rows[20 * k + 1], rows[20 * k + 2], rows[20 * k + 3]]);
}; 0"""
PICTURES = {
    "plaza": "scene: 'plaza', people: 3000, place: [0, 14, 52], target: [0, 0, 0], now: 3, debug: 0",
    "stadium": "scene: 'stadium', people: 4000, place: [0, 9, 22], target: [0, 4, -30], now: 3, debug: 0",
    "tiers": "scene: 'plaza', people: 3000, place: [0, 14, 52], target: [0, 0, 0], now: 3, debug: 1",
    "near": "scene: 'walk', people: 150, place: [0, 1.7, 9], target: [0, 1.2, 0], now: 3, debug: 0",
}
BESIDE = Path(__file__).with_name("crowd_beside.js")


def whole_page(pack: Path, results: Path, folder: Path) -> tuple[Path, list[str]]:
    """Write the page of a pack's first clones with every triangle as another level; return it and their names."""
    facts = read_facts(pack)
    held, body = read_stock(pack, facts), body_levels(full=True)
    if held.tiles is None:
        raise ValueError("a pack has impostors")
    rows = facts["people"][:CLONES]
    casts = [
        make_crowd_clone(
            row["id"], centre_joints(load_clone(results / row["id"] / CLONE_FILE)), body, poses=16, budgets=held.budgets
        )
        for row in rows
    ]
    budgets = (max(len(cast.loose.triangles[0]) for cast in casts), *held.budgets)
    first = 0
    for k, (row, cast) in enumerate(zip(rows, casts, strict=True)):
        own = stock.clone_arrays(cast, budgets)
        table = held.table[k].copy()
        table[stock.CLIPS_AT : stock.CLIPS_AT + len(cast.clips), 0] += first - table[stock.CLIPS_AT, 0]
        first += len(own.bones)
        data, row["arrays"] = pack_arrays({
            "vertices": own.vertices, "loose": own.loose, "corners": own.corners, "bones": own.bones, "table": table,
            "tiles": held.tiles[k],
        })  # fmt: skip
        place = folder / "people" / row["id"]
        place.mkdir(parents=True)
        for name in HELD:
            shutil.copyfile(pack / "people" / row["id"] / name, place / name)
        (place / "numbers.bin").write_bytes(data)
        row["loose_triangles"] = [len(triangles) for triangles in cast.loose.triangles]
    data, facts["body_arrays"] = pack_arrays(body_arrays(body))
    (folder / "body.bin").write_bytes(data)
    whole = {**facts["tiers"][0], "vertices": body.counts[0], "largest_px": 0}
    facts["tiers"] = [whole, *({**tier, "vertices": body.counts[k + 1]} for k, tier in enumerate(facts["tiers"]))]
    facts["tiers"][1]["largest_px"] = FARTHEST_PX
    facts["people"], facts["numbers"]["loose"] = rows, list(budgets)
    facts["looks"] |= {"clones": len(rows), "wardrobe": {}}
    (folder / "player.html").write_bytes(player_page(folder, facts))
    triangles = [len(body.triangles[0]) + len(cast.loose.triangles[0]) for cast in casts]
    return folder / "player.html", [f"{row['id']} ({n} triangles)" for row, n in zip(rows, triangles, strict=True)]


def frame_times(page: Any, people: int, rounds: int, modes: tuple[str, ...]) -> dict[str, tuple[float, Any]]:
    """Return the least milliseconds of each mode and what was drawn, in turns, without the frame that compiles."""
    found: dict[str, tuple[float, Any]] = {}
    for number in range(rounds):
        for mode in modes:
            page.value(f"crowd.set({{scene: 'field', people: {people}, {VIEW}, mode: '{mode}'}})")
            took = min(page.value(f"crowd.time({2 if number == 0 else 1})")[-1:])
            least = min(took, found[mode][0]) if mode in found else took
            found[mode] = (least, page.value("({counts: crowd.state.stats.counts, draws: crowd.state.stats.draws})"))
            print(people, mode, f"{took:.0f} ms", found[mode][1], flush=True)
    return found


def in_browser(
    pack: Path, results: Path, people: int, rounds: int, npm: Path | None, pictures: Path | None
) -> list[str]:
    """Return frame times of every way, the choice's, what was asked of the network, and leave pictures."""
    sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))
    from kit.browser import browser

    with tempfile.TemporaryDirectory() as scratch, browser(Path(scratch) / "profile") as page:
        page.bypass_policy()
        whole = Path(scratch) / "whole"
        whole.mkdir()
        file, names = whole_page(pack, results, whole)
        page.open(file, 1280, 720)
        page.wait_for("document.body && document.body.dataset.ready", 300)
        page.value(FIELD)
        told = [f"{people} people of {' and '.join(names)} between 3 and 100 m, 1280 x 720, four samples, in turns in "
                f"one session of Chromium, minimum of {rounds}; {page.value(RENDERER)}.", "",
                "| drawn | ms | times hybrid | bar | people by level, impostors | draws |",
                "| --- | --- | --- | --- | --- | --- |"]  # fmt: skip
        found = frame_times(page, people, rounds, tuple(MODES))
        hybrid = found["hybrid"][0]
        for mode, (name, bar) in MODES.items():
            took, shown = found[mode]
            told.append(f"| {name} | {took:.0f} | {took / hybrid:.1f} | {bar} | {shown['counts']} | {shown['draws']} |")
        if npm:
            told += ["", *beside(page, pack, results, npm, rounds)]
        page.open(pack / "player.html", 1280, 720)
        page.wait_for("document.body && document.body.dataset.ready", 300)
        told += ["", *choices(page)]
        outside = [one for one in page.requests() if not one.startswith(("file:", "blob:", "data:", "about:"))]
        told.append(f"- Requests to anywhere: {len(outside)}. Errors in the console: {len(page.complaints())}.")
        for name, view in PICTURES.items() if pictures else ():
            page.value(f"crowd.set({{{view}, mode: 'hybrid'}})")
            page.value("crowd.time(1)")
            Image.fromarray(page.picture()).save(pictures / f"crowd_{name}.jpg", quality=82)
    return told


def choices(page: Any) -> list[str]:
    """Return how long the choice of level takes."""
    told = []
    for count in (10_000, 60_000):
        page.value(
            f"crowd.set({{scene: 'plaza', people: {count}, place: [0, 30, 160], target: [0, 0, 0], mode: 'hybrid'}})"
        )
        page.value("crowd.choices(60)")
        found = page.value("crowd.choices(120)")
        told.append(f"- Choice of level, {count} people: median {np.median(found):.2f} ms, nine in ten below "
                    f"{np.percentile(found, 90):.2f} ms, worst {max(found):.2f} ms (bar 4).")  # fmt: skip
    return told


def beside(page: Any, pack: Path, results: Path, npm: Path, rounds: int) -> list[str]:
    """Return others' frame times for the same people."""
    rows = read_facts(pack)["people"][:CLONES]
    files = {
        "whole": [results / row["id"] / "clone.glb" for row in rows],
        "levels": [pack / "people" / row["id"] / f"{row['id']}.glb" for row in rows],
    }
    for name, paths in files.items():
        held = [base64.b64encode(path.read_bytes()).decode() for path in paths]
        page.value(f"window.{name} = {json.dumps(held)}; 0")
    script = subprocess.run(
        [npm / ".bin" / "esbuild", BESIDE, "--bundle", "--format=iife", "--global-name=beside", "--log-level=warning"],
        env={**os.environ, "NODE_PATH": str(npm)}, capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    page.value(script + "; window.beside = beside; 0")
    page.value(PLACES)
    told = ["| people | hybrid ms | three's skinned meshes | times | levels in @three.ez/instanced-mesh | times |",
            "| --- | --- | --- | --- | --- | --- |"]  # fmt: skip
    for people in (20, 200):
        page.value(f"crowd.set({{scene: 'field', people: {people}, {VIEW}, mode: 'hybrid'}})")
        own = min(page.value(f"crowd.time({rounds + 1})")[1:])
        naive, other = (
            min(page.value(f"beside.{way}, places({people}), {rounds + 1})")["found"][1:])
            for way in ("naive(whole", "instanced(levels")
        )
        first = f"{naive:.0f} | {naive / own:.1f}{' (bar 100)' if people == 20 else ''}"
        told.append(f"| {people} | {own:.0f} | {first} | {other:.0f} | {other / own:.1f} |")
    return told
