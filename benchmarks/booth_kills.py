"""Kill the window forty times, while photos come in, a telephone is served and files are copied; look what is lost.

``python benchmarks/booth_kills.py --kills 40``: one undisturbed walk tells how long it takes, every other is killed at
a random moment of it (seeds 0..39), its event opened again, and everything looked for that the window had told to be
safe: names, heights, consents, photos (also those that lay in the camera's folder), points, clones, links, copies.
"""

from __future__ import annotations

import argparse
import os
import random
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))
os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")


def main() -> int:
    """Kill, look, and print a row a kill; 1 where anything is lost."""
    from PySide6.QtWidgets import QApplication

    from kit.outside_kills import World, lost

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=40)
    wanted = parser.parse_args()
    QApplication([])
    all_lost, doing = [], Counter()
    with tempfile.TemporaryDirectory() as room:
        whole = World(Path(room) / "whole")
        seconds = whole.run(None)
        reopen(whole)
        all_lost += lost(whole)
        print(f"undisturbed: {seconds:.1f} s, {whole.served} times served, lost: {lost(whole) or 'nothing'}")
        for number in range(wanted.kills):
            world = World(Path(room) / f"{number}")
            after = random.Random(number).uniform(0.0, seconds)
            world.run(after)
            reopen(world)
            found = lost(world)
            all_lost += found
            doing[world.doing()] += 1
            print(
                f"{number:3d} after {after:5.1f} s, {world.doing()}: {'; '.join(found) or 'nothing lost'}", flush=True
            )
    print("killed after:", ", ".join(f"{what} {count}" for what, count in doing.most_common()))
    print(f"{wanted.kills} kills, {len(all_lost)} things lost")
    return 1 if all_lost else 0


def reopen(world: object) -> None:
    """Open the event again, as the operator does, and let it settle."""
    from PySide6.QtWidgets import QApplication

    import cloner_gui.event.phone
    from cloner_gui.event.session import Session
    from cloner_gui.main_window import MainWindow
    from kit.outside_walk import services

    cloner_gui.event.phone.own_addresses = lambda: ("127.0.0.1",)
    cloner_gui.event.phone.PORT = 0
    window = MainWindow(Session(services()))
    window.booth.open(world.event)
    intake = window.booth.intake
    for _ in range(4):  # the camera's folder has to be looked at twice, however slow the machine is
        least = time.monotonic() + 0.3
        while window.booth._opening is not None or intake.pending() or time.monotonic() < least:
            QApplication.processEvents()
            time.sleep(0.005)
        intake.look_for_arrivals()
    while intake.pending():
        QApplication.processEvents()
        time.sleep(0.005)
    window.session.queue.close()
    window.close()
    window.deleteLater()


if __name__ == "__main__":
    sys.exit(main())
