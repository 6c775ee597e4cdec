"""Frame times of a crowd's and of scenes' pages in Chromium on a graphics card, told as Markdown and JSON.

    python benchmarks/crowd_card.py prepare PACK RESULTS --npm node_modules --scene BUILT ... --out FOLDER
    python FOLDER/crowd_card.py measure FOLDER --out OUT [--quick]
    python benchmarks/crowd_card.py page OUT/figures.json --out PAGE.md

`prepare` copies into FOLDER all that `measure` needs, which asks for Chromium, NumPy and Pillow alone, so that it runs
on a machine without Cloner. A frame's time is that of a run of frames with one reading of a pixel behind them, so that
a card's work and a processor's may overlap as they do when shown, and nothing waits in a queue when the clock stops.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

SIZE, QUICK_SIZE = (1920, 1080), (320, 180)
PEOPLE = (1_000, 10_000, 60_000)
QUICK_PEOPLE = (50,)
HEAP_S = 120.0
OVERVIEW = "place: [0, 9, 34], target: [0, 1, 0], now: 3"
FLAGS = (
    "--disable-frame-rate-limit", "--disable-gpu-vsync", "--enable-precise-memory-info",
    "--enable-unsafe-swiftshader", "--autoplay-policy=no-user-gesture-required",
)  # fmt: skip
RENDERER = """(() => {
  const gl = document.createElement("canvas").getContext("webgl2"), told = gl.getExtension("WEBGL_debug_renderer_info");
  return gl.getParameter(told ? told.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
})()"""


def prepare(pack: Path, results: Path, npm: Path, scenes: list[Path], out: Path) -> None:
    """Write the folder that travels: pages, others' ways, this file and the browser's driver."""
    import base64

    import crowd_frames as frames

    from cloner.crowd.packs.reading import read_facts

    out.mkdir(parents=True)
    (out / "whole").mkdir()
    _, names = frames.whole_page(pack, results, out / "whole")
    (out / "whole_page.html").write_bytes((out / "whole" / "player.html").read_bytes())
    shutil.rmtree(out / "whole")
    shutil.copyfile(pack / "player.html", out / "crowd_page.html")
    for built in scenes:
        shutil.copyfile(built / "player.html", out / f"scene_{built.name}.html")
    rows = read_facts(pack)["people"][: frames.CLONES]
    held = {
        "whole": [results / row["id"] / "clone.glb" for row in rows],
        "levels": [pack / "people" / row["id"] / f"{row['id']}.glb" for row in rows],
    }
    script = subprocess.run(
        [npm / ".bin" / "esbuild", frames.BESIDE, "--bundle", "--format=iife", "--global-name=beside"],
        env={**os.environ, "NODE_PATH": str(npm)}, capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    for name, files in held.items():
        coded = json.dumps([base64.b64encode(file.read_bytes()).decode() for file in files])
        (out / f"{name}.json").write_text(coded)
    (out / "beside.js").write_text(script + "; window.beside = beside; 0")
    plan = {"names": names, "field": frames.FIELD, "view": frames.VIEW, "places": frames.PLACES,
            "modes": {mode: name for mode, (name, _) in frames.MODES.items()}}  # fmt: skip
    (out / "plan.json").write_text(json.dumps(plan))
    for name in (Path(__file__).name, "crowd_card.js"):
        shutil.copyfile(Path(__file__).with_name(name), out / name)
    tests = Path(__file__).resolve().parents[1] / "tests" / "kit" / "browser.py"
    (out / "kit").mkdir()
    shutil.copyfile(tests, out / "kit" / "browser.py")


class Measured:
    """One browser's session: figures as they come, kept on the disk after each step."""

    def __init__(self, page: Any, folder: Path, out: Path, quick: bool) -> None:
        self.page, self.folder, self.out, self.quick = page, folder, out, quick
        self.plan = json.loads((folder / "plan.json").read_text())
        self.found: dict[str, Any] = {}
        self.begun = time.monotonic()
        self.most, self.seconds = (4, 0.5) if quick else (200, 2.0)

    def keep(self, name: str, value: Any) -> None:
        """Tell and keep a figure."""
        self.found[name] = value
        print(f"[{time.monotonic() - self.begun:6.1f} s] {name}: {json.dumps(value)}", flush=True)
        (self.out / "figures.json").write_text(json.dumps(self.found, indent=1))

    def open(self, file: str) -> None:
        """Open a page of the folder and wait until it shows people."""
        begun = time.monotonic()
        self.page.open(self.folder / file, *(QUICK_SIZE if self.quick else SIZE))
        self.page.wait_for("document.body && document.body.dataset.ready", 300)
        self.keep(f"{file} ready_s", round(time.monotonic() - begun, 2))
        self.page.value((self.folder / "crowd_card.js").read_text())

    def burst(self, name: str, card: bool = True) -> dict[str, Any]:
        """Measure what is set."""
        row = dict(self.page.value(f"burst({self.most}, {self.seconds})"))
        if card:
            row["card_ms"] = self.page.value(f"cardTime({3 if self.quick else 15})")
        self.keep(name, row)
        return row

    def shot(self, name: str) -> None:
        """Keep a picture of the page."""
        from PIL import Image

        (self.out / "pictures").mkdir(exist_ok=True)
        Image.fromarray(self.page.picture()).save(self.out / "pictures" / f"{name}.jpg", quality=85)

    def ways(self) -> None:
        """Time every way of drawing the same people side by side, the bars' ratios; three others' ways after them."""
        self.open("whole_page.html")
        self.keep("renderer", self.page.value(RENDERER))
        self.page.value(self.plan["field"])
        for people in QUICK_PEOPLE if self.quick else PEOPLE[:2]:
            for mode in self.plan["modes"]:
                self.page.value(f"crowd.set({{scene: 'field', people: {people}, {self.plan['view']}, mode: '{mode}'}})")
                self.burst(f"field {people} {mode}")
                self.shot(f"field_{people}_{mode}")
        for name in ("whole", "levels"):
            self.page.value(f"window.{name} = {(self.folder / f'{name}.json').read_text()}; 0")
        self.page.value((self.folder / "beside.js").read_text())
        self.page.value(self.plan["places"])
        for people in (20,) if self.quick else (20, 200, 1_000):
            self.page.value(f"crowd.set({{scene: 'field', people: {people}, {self.plan['view']}, mode: 'hybrid'}})")
            self.burst(f"field {people} hybrid beside")
            for name, way in (("three skinned", "naive(whole"), ("three.ez", "instanced(levels")):
                told = self.page.value(f"beside.{way}, places({people}), {2 if self.quick else 30})")
                least = {"ms": min(told["found"][1:]), "draws": told["draws"], "triangles": told["triangles"]}
                self.keep(f"field {people} {name}", least)

    def crowds(self) -> None:
        """Time twenty clones' page with 1,000 to 60,000 people: each way, frames a second as shown, pictures."""
        self.open("crowd_page.html")
        self.page.bypass_policy()
        for people in QUICK_PEOPLE if self.quick else PEOPLE:
            for mode in self.plan["modes"]:
                if people == PEOPLE[-1] and mode == "geometry":
                    continue
                self.page.value(f"crowd.set({{scene: 'plaza', people: {people}, {OVERVIEW}, mode: '{mode}'}})")
                self.burst(f"plaza {people} {mode}")
            self.page.value("crowd.set({mode: 'hybrid'})")
            self.keep(f"plaza {people} shown a second", self.page.value("shown(3)"))
            self.shot(f"plaza_{people}")

    def scenes(self) -> None:
        """Time each scene with and without its people; keep its heap and pictures."""
        for number, file in enumerate(sorted(self.folder.glob("scene_*.html"))):
            name = file.stem.removeprefix("scene_")
            self.open(file.name)
            if self.quick:  # a processor needs minutes for people in a lit room
                self.page.value("nobody(); 0")
            self.keep(f"{name} people", self.page.value("walkers.count"))
            if number == 0:
                self.heap(name)
            views = self.page.value("Object.keys(facts.acted.views)")
            for view in views[:1] if self.quick else views:
                there = self.page.value(f"facts.acted.views['{view}']")
                where = f"place: {json.dumps(there[0])}, target: {json.dumps(there[1])}, now: 20, mode: 'hybrid'"
                self.page.value(f"setCamera('orbit'); crowd.set({{{where}}})")
                self.burst(f"{name} {view} with people")
                self.keep(f"{name} {view} shown a second", self.page.value("shown(3)"))
                self.shot(f"{name}_{view}")
            self.page.value("nobody()")
            for view in views[:1] if self.quick else views:
                there = self.page.value(f"facts.acted.views['{view}']")
                self.page.value(f"look({json.dumps(there[0])}, {json.dumps(there[1])})")
                self.burst(f"{name} {view} empty")

    def heap(self, name: str) -> None:
        """Watch the page's heap while it runs."""
        rows, end = [], time.monotonic() + (6.0 if self.quick else HEAP_S)
        while time.monotonic() < end:
            self.page._ask("HeapProfiler.collectGarbage")
            used = self.page._ask("Runtime.getHeapUsage")
            rows.append(round((used["usedSize"] + used.get("backingStorageSize", 0)) / 2**20, 1))
            time.sleep(3.0 if self.quick else 15.0)
        self.keep(f"{name} heap MiB", rows)


def measure(folder: Path, out: Path, quick: bool, only: list[str]) -> None:
    """Run all steps in one browser; a step that fails is told and the next one begins."""
    sys.path.insert(0, str(folder))
    import tempfile

    from kit.browser import browser

    out.mkdir(parents=True, exist_ok=True)
    flags = (*FLAGS, *os.environ.get("CROWD_FLAGS", "").split())
    with tempfile.TemporaryDirectory() as scratch, browser(Path(scratch) / "profile", *flags) as page:
        page.bypass_policy()
        all_of = Measured(page, folder, out, quick)
        for step in only:
            try:
                getattr(all_of, step)()
            except Exception as problem:  # noqa: BLE001 - a machine is lent for minutes: the other figures are still wanted
                all_of.keep(f"{step} failed", str(problem)[:2000])
        all_of.keep("complaints", page.complaints()[:10])


def row_of(name: str, one: dict[str, Any], other: dict[str, Any] | None) -> str:
    """Return a line of the table; times are also told over another way's."""
    card = one.get("card_ms")
    cells = [name, f"{one['ms']:.2f}", f"{1000.0 / one['ms']:.0f}", "" if card is None else f"{card:.2f}",
             f"{one['choice']:.2f}" if "choice" in one else "", str(one.get("draws", "")),
             f"{one.get('triangles', 0) / 1e6:.2f}", f"{one['ms'] / other['ms']:.1f}" if other else ""]  # fmt: skip
    return f"| {' | '.join(cells)} |"


def page_of(found: dict[str, Any]) -> list[str]:
    """Return the page's lines."""
    lines = ["# Crowds and scenes on a graphics card", "",
             "Written by `benchmarks/crowd_card.py`, which tells how times are taken.", "",
             f"{found.get('renderer')}, {SIZE[0]} x {SIZE[1]}, four samples a pixel; others' ways 1280 x 720.", "",
             "| drawn | ms a frame | frames/s | the card's own ms | choice of level ms | draws | million triangles | "
             "times the hybrid |", "| --- | --- | --- | --- | --- | --- | --- | --- |"]  # fmt: skip
    for name, one in found.items():
        if isinstance(one, dict) and "ms" in one:
            scene, people = [*name.split(), ""][:2]
            other = found.get(f"{scene} {people} hybrid", found.get(f"{scene} {people} hybrid beside"))
            lines.append(row_of(name, one, other))
    lines.append("")
    for name, one in found.items():
        if not (isinstance(one, dict) and "ms" in one) and name != "renderer":
            lines.append(f"- {name}: {json.dumps(one)}")
    return lines


def main() -> None:
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    making = commands.add_parser("prepare")
    for name in ("pack", "results"):
        making.add_argument(name, type=Path)
    making.add_argument("--npm", type=Path, required=True)
    making.add_argument("--scene", type=Path, action="append", default=[])
    measuring = commands.add_parser("measure")
    measuring.add_argument("folder", type=Path)
    measuring.add_argument("--quick", action="store_true", help="few frames: does it run at all?")
    measuring.add_argument("--only", nargs="+", default=["ways", "crowds", "scenes"])
    telling = commands.add_parser("page")
    telling.add_argument("figures", type=Path)
    for one in (making, measuring, telling):
        one.add_argument("--out", type=Path, required=True)
    args = parser.parse_args()
    if args.command == "prepare":
        prepare(args.pack, args.results, args.npm, args.scene, args.out)
    elif args.command == "page":
        args.out.write_text("\n".join(page_of(json.loads(args.figures.read_text()))) + "\n")
    else:
        measure(args.folder, args.out, args.quick, args.only)


if __name__ == "__main__":
    main()
