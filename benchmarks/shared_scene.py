"""Three browsers share a served scene for ten minutes: do they hold the same people to the last bit, does a heap grow?

    python benchmarks/shared_scene.py BUILT [--minutes 10] [--photos PHOTOS]

BUILT is what ``cloner scene build --walk SCENARIO.crowd`` wrote. Each page keeps the footings it was sent; every five
seconds all are asked for everybody's row at one moment that is over. Each minute one page after the other loses its
link. People are placed in each frame, but drawn once in ten seconds: a processor that draws three pages would measure
itself. PHOTOS, a folder of one person with a recorded consent, is cloned beside it, and the time is told until the
clone takes its first step.
"""

from __future__ import annotations

import argparse
import hashlib
import resource
import subprocess
import sys
import tempfile
import threading
import time
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from cloner.scenes.served.living import RunningScene
from cloner.scenes.served.newcomers import finished_in
from cloner.scenes.served.serving import advancing, served

EVERY_S, CUT_EVERY_S, OVER_S, PAGES = 5.0, 60.0, 1.5, 3
SELDOM = """(() => { const once = draw; let last = -1e9;
  window.draw = () => {
    if (performance.now() - last > 1e4) { last = performance.now(); once(); } else keepCells();
  };
  return 0; })()"""
ROWS = "(() => { const rows = acted.people.slice(); acted.at(AT, rows); return Array.from(rows); })()"


def heap_mib(page: Any) -> float:
    """Return what a page's scripts hold after a collection."""
    page._ask("HeapProfiler.collectGarbage")
    used = page._ask("Runtime.getHeapUsage")
    return float(used["usedSize"] + used.get("backingStorageSize", 0)) / 2**20


def shared(scene: RunningScene, pages: list[Any], seconds: float) -> list[str]:
    """Return lines that tell how often all pages agreed, how long links took to be back, and heaps."""
    agreed, asked, back, digest = 0, 0, [], hashlib.sha256()
    heaps = [[heap_mib(page)] for page in pages]
    begun = cut_at = time.monotonic()
    while time.monotonic() - begun < seconds:
        time.sleep(EVERY_S)
        at = f"{scene.now() - OVER_S:.3f}"
        seen = [np.array(page.value(ROWS.replace("AT", at)), np.float32).tobytes() for page in pages]
        asked, agreed = asked + 1, agreed + (len(set(seen)) == 1)
        digest.update(seen[0])
        if time.monotonic() - cut_at > CUT_EVERY_S:
            cut_at, page = time.monotonic(), pages[len(back) % len(pages)]
            page.value("live.cut()")
            page.wait_for("live.rejoined === null", 10)
            page.wait_for("live.rejoined !== null", 10)
            back.append(float(page.value("live.rejoined")))
            for row, one in zip(heaps, pages, strict=True):
                row.append(heap_mib(one))
            print(
                f"{agreed} of {asked}, back after {back[-1]:.2f} s, {[round(row[-1], 1) for row in heaps]}", flush=True
            )
    grown = max(row[-1] / row[1] - 1.0 for row in heaps)
    people = int(pages[0].value("acted.people.length / 20"))
    return [
        f"- {PAGES} pages, {people} people, {seconds / 60:.0f} minutes: {agreed} of {asked} times the same rows to "
        f"the last bit (digest of all `{digest.hexdigest()[:16]}`)",
        f"- {len(back)} links cut: all back after {np.mean(back):.2f} s, worst {max(back):.2f} s (bar 3)",
        f"- heap of a page: {heaps[0][0]:.0f} MiB when opened, {heaps[0][1]:.0f} after a minute, {heaps[0][-1]:.0f} "
        f"at the end; most any page grew after its first minute {100 * grown:+.1f} % (bar 5)",
    ]


def arrived(scene: RunningScene, page: Any, photos: Path, hot: Path) -> str:
    """Return a line that tells how long photographs take until their clone walks in the scene."""
    over = threading.Event()

    def look() -> None:
        while not over.wait(0.2):
            scene.look()

    threading.Thread(target=look, daemon=True).start()
    begun, before = time.time(), resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [sys.executable, "-c", "from cloner.cli import main; main()", "clone", photos, "--out", hot]
    subprocess.run([*command, "--id", "newcomer"], check=True, capture_output=True)
    cloned, after = time.time(), resource.getrusage(resource.RUSAGE_CHILDREN)
    page.wait_for("live.history.length && live.history[0].step", 120)
    stepped = float(page.value("live.history[0].step"))
    over.set()
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return (
        f"- photos to the first step in the scene: {stepped - begun:.1f} s (bar 60), of which the clone "
        f"{cloned - begun:.1f} s ({spent:.1f} s of CPU) and the scene {stepped - cloned:.1f} s (bar 10)"
    )


def main() -> None:
    """Serve, open three browsers, tell."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("built", type=Path)
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--photos", type=Path)
    asked = parser.parse_args()
    sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))
    from kit.browser import browser

    with tempfile.TemporaryDirectory() as name, ExitStack() as stack:
        hot = Path(name) / "hot"
        hot.mkdir()
        scene = RunningScene(asked.built, partial(finished_in, hot), print)
        url = stack.enter_context(served(scene, bool))
        stack.enter_context(advancing(scene))
        pages = [stack.enter_context(browser(Path(name) / f"profile{k}")) for k in range(PAGES)]
        for page in pages:
            page._ask("Emulation.setDeviceMetricsOverride", width=160, height=90, deviceScaleFactor=1, mobile=False)
            page._ask("Page.navigate", url=url)
            page.wait_for("document.body?.dataset.ready === 'yes' && live.rejoined !== null", 300)
            page.value(SELDOM)
        if asked.minutes > 0:
            print("\n".join(shared(scene, pages, 60.0 * asked.minutes)))
        if asked.photos:
            print(arrived(scene, pages[0], asked.photos, hot))
        print("- errors in the consoles:", sum(len(page.complaints()) for page in pages))


if __name__ == "__main__":
    main()
