"""A built scene's page from the disk: how soon a picture is there, what it holds after half an hour, what people cost.

    python benchmarks/scene_page.py BUILT [--minutes 30] [--size 640x360]

BUILT is what ``cloner scene build`` or ``cloner scene film --page`` wrote. A fresh Chromium opens its ``player.html``;
it draws all the time, by a processor where there is no card. Told are seconds from opening to the first picture, the
heap (scripts and their buffers, after a collection) each minute, whether the page asked anybody or complained, how two
pictures of one moment agree, and a frame against the same frame without people, in turns.
"""

from __future__ import annotations

import argparse
import json
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
from shared_scene import heap_mib
from skimage.metrics import structural_similarity

from kit.browser import browser

READY_S, TURNS, FRAMES = 120.0, 5, 3
EMPTY = "(() => { window.kept = choose; window.choose = () => tiers.forEach((one) => { one.visible = false; }); })()"
FULL = "(() => { window.choose = window.kept; })()"


def frame_ms(page: Any) -> tuple[float, float]:
    """Return the milliseconds of a frame with and without people: medians of the least of each turn."""
    found: tuple[list[float], list[float]] = [], []
    for _ in range(TURNS):
        for own, switch in zip(found, ("0", EMPTY), strict=True):
            page.value(switch)
            own.append(min(page.value(f"crowd.time({FRAMES})")))
        page.value(FULL)
    return float(np.median(found[0])), float(np.median(found[1]))


def main() -> None:
    """Measure one page."""
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("built", type=Path)
    asked.add_argument("--minutes", type=float, default=30.0)
    asked.add_argument("--size", default="640x360")
    told = asked.parse_args()
    width, height = (int(part) for part in told.size.split("x"))
    path = told.built / "player.html"
    facts = json.loads((told.built / "crowd.json").read_text())
    with tempfile.TemporaryDirectory() as profile, browser(Path(profile)) as page:
        begun = time.monotonic()
        page.open(path, width, height)
        page.wait_for("document.body?.dataset.shown === 'yes'", READY_S)
        print(
            f"- {len(facts['people'])} clones, {facts['people_count']} people, {path.stat().st_size / 1e6:.0f} MB, "
            f"{width} x {height}: first picture {time.monotonic() - begun:.1f} s after opening (bar 5)",
            flush=True,
        )
        page.wait_for("document.body?.dataset.ready === 'yes'", READY_S)
        print(f"- who is far is there {time.monotonic() - begun:.1f} s after opening", flush=True)
        shown = []
        for _ in range(2):
            page.value("crowd.set({ now: 12.5 })")
            page.value("crowd.draw() && 1")
            shown.append(page.picture())
        alike = structural_similarity(*shown, channel_axis=2, data_range=255)
        full, empty = frame_ms(page)
        page.value("crowd.run()")  # what was asked for a moment is over when the scene has gone on
        heaps = [heap_mib(page)]
        while len(heaps) <= told.minutes:
            time.sleep(60.0)
            heaps.append(heap_mib(page))
        print(
            f"- heap {heaps[0]:.0f} MiB when opened, {max(heaps):.0f} at most (bar 300)"
            + (
                f", {heaps[1]:.1f} after a minute, {heaps[-1]:.1f} after {len(heaps) - 1}: "
                f"{100.0 * (heaps[-1] / heaps[1] - 1.0):+.1f} % (bar 5)"
                if len(heaps) > 1
                else ""
            )
        )
        print(f"- two pictures of one moment: SSIM {alike:.4f} (bar .98)")
        print(f"- a frame {full:.0f} ms, without people {empty:.0f} ms: {full / empty:.2f} times")
        print(f"- asked: {len(page.requests())} (the file itself is 1); complaints: {page.complaints() or 'none'}")


if __name__ == "__main__":
    main()
