"""How soon outline and preview follow a dragged point: 200 drags with real mouse events on the real page, no screen.

One sample is cloned first (about half a minute of CPU), unless the folder is a visitor's whom the window has cloned.
Every drag presses on one point of one photo, moves it in three steps and lets go. For each move the time is taken until
the photo shows the outline linked through the moved point, and until the preview shows the person who follows. Told:
median and 95th percentile, wall and CPU milliseconds, by kind of photo; and the longest silence of the window's thread.

Bars: 150 ms median, 300 ms at the 95th percentile, 100 ms without listening.
"""

from __future__ import annotations

import argparse
import json
import os
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import numpy as np
from PySide6.QtCore import QCoreApplication, QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from cloner import pipeline
from cloner.booth.opened import Cloned, read_cloned
from cloner.booth.photos.photo_files import placed_photos
from cloner.booth.visitors.cached_work import WORK
from cloner.frames import ViewId
from cloner.interactive.relinking import live_outline
from cloner.project.corrections import no_corrections
from cloner.project.folder import load_photos, read_person
from cloner_gui.event.services import Services, nothing, points_by_view
from cloner_gui.event.session import Session
from cloner_gui.pages.points import PointsPage

SAMPLE = Path(__file__).resolve().parents[1] / "samples" / "anna" / "plain"
DRAGS = 200
STEPS = 3
#: Corrections that stand beside the new one: as many as an operator makes are obeyed together.
CORRECTED = 6
#: Between two looks at what has come, seconds: looking without rest would take the CPU from what is looked for.
REST_S = 0.001
#: Longest that is waited for a preview, seconds.
PATIENCE_S = 5.0


class Move(NamedTuple):
    """One move of the mouse and what it took, milliseconds; ``deaf``: the longest stretch without listening."""

    view: str
    name: str
    outline_ms: float
    preview_ms: float
    cpu_ms: float
    deaf_ms: float


def cloned_values(folder: Path) -> dict[str, Any]:
    """Return all values of a whole run, or those that the window kept of one."""
    if (folder / WORK).is_dir():
        kept, photos = read_cloned(folder, placed_photos(folder)), placed_photos(folder)
        if kept is not None:
            return {**kept.values, "photos": photos}
    values = {"photos": load_photos(folder), "person": read_person(folder), "corrections": no_corrections()}
    return pipeline.run(values)[0]


def open_page(values: dict[str, Any], folder: Path) -> tuple[Session, PointsPage]:
    """Return the points page on a cloned visitor, its outlines ready."""
    session = Session(Services(look=nothing, propose=nothing, clone=nothing, hand_over=nothing))  # type: ignore[arg-type]
    page = PointsPage(session)
    session.folder, session.photos = folder, values["photos"]
    session.proposed = points_by_view(values, values["photos"])
    session.opened.emit()
    session.points_changed.emit()
    session._take_clone(Cloned(folder, values))
    page.resize(1280, 620)
    page.show()
    pause(1.0)
    outlines = {
        view: live_outline(photo, values["proposals"].views[view], session.proposed[view])
        for view, photo in values["photos"].photos.items()
        if view.is_body
    }
    page.live.take({view: outline for view, outline in outlines.items() if outline is not None})
    pause(0.5)
    return session, page


def pause(seconds: float) -> None:
    until = time.perf_counter() + seconds
    while time.perf_counter() < until:
        QCoreApplication.processEvents()
        time.sleep(0.002)


def places(session: Session, rng: np.random.Generator, drags: int) -> list[tuple[ViewId, str]]:
    """Return the points to drag, all photos alike, one photo after the other as operators work."""
    views = list(session.proposed)
    return [
        (view, str(rng.choice(session.proposed[view].names)))
        for view in sorted(views[k % len(views)] for k in range(drags))
    ]


def drag(session: Session, page: PointsPage, view: ViewId, name: str, rng: np.random.Generator) -> list[Move]:
    """Drag one point and return what every move took."""
    if page.view is not view:
        page.show_view(view)
        pause(0.3)
    canvas, points = page.views[view], session.points(view)
    assert points is not None
    canvas.lens.look_at(*points.get(name), 1.2)
    pause(0.02)
    at = canvas.lens.widget_from_photo(*points.get(name)).toPoint()
    way = rng.normal(size=2)
    step = way / np.linalg.norm(way) * rng.uniform(2.0, 8.0)
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=at)
    moves = []
    for k in range(1, STEPS + 1):
        to = at + QPoint(*(int(value) for value in np.round(k * step)))
        moves.append(moved(session, page, view, name, to))
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=to)
    while sum(map(len, session.corrections.points.values())) > CORRECTED:
        undo(session)
    return moves


def undo(session: Session) -> None:
    """Take the last drag back and wait until the body has followed: no later move may take that for its own answer."""
    undone: list[bool] = []
    told = session.refitted.connect(lambda: undone.append(True))
    session.undo_stack.undo()
    wait(lambda: bool(undone))
    session.refitted.disconnect(told)


def wait(done: Callable[[], bool]) -> float:
    """Wait until something has come, and return the longest stretch that the window did not listen, seconds."""
    start = before = time.perf_counter()
    deaf = 0.0
    while not done() and before - start < PATIENCE_S:
        QCoreApplication.processEvents()
        now = time.perf_counter()
        deaf, before = max(deaf, now - before), now
        time.sleep(REST_S)
    return deaf


def moved(session: Session, page: PointsPage, view: ViewId, name: str, to: QPoint) -> Move:
    """Move the mouse and wait until everything has followed."""
    seen: dict[str, float] = {}
    follows = page.live.borders(view, session.corrections)
    refitted = session.refitted.connect(lambda: seen.setdefault("refit", time.perf_counter()))

    def all_seen() -> bool:
        if page.views[view].outline_px is not follows or not view.is_body:
            seen.setdefault("outline", time.perf_counter())
        shown = page.preview.shown
        if "refit" in seen and shown is not None and shown.clone is session.clone_now():
            seen.setdefault("preview", time.perf_counter())
        return "preview" in seen

    start, cpu = time.perf_counter(), time.process_time()
    QTest.mouseMove(page.views[view], to)
    pressed = time.perf_counter() - start
    deaf = max(pressed, wait(all_seen))
    cpu = time.process_time() - cpu
    session.refitted.disconnect(refitted)
    end = time.perf_counter()
    outline, preview = (1000.0 * (seen.get(key, end) - start) for key in ("outline", "preview"))
    return Move(view.value, name, outline, preview, 1000.0 * cpu, 1000.0 * deaf)


def table(moves: list[Move]) -> str:
    """Return the figures as lines of text."""
    lines = [
        f"{'':12}{'moves':>6}  {'outline':>12}  {'preview':>12}  {'CPU':>10}  {'not listening':>13}   ms, median / p95"
    ]
    groups = {"body photos": "body", "face photos": "face", "all": ""}
    for title, start in groups.items():
        own = [move for move in moves if move.view.startswith(start)]
        cells = [np.percentile([getattr(m, key) for m in own], [50, 95]) for key in Move._fields[2:]]
        told = "  ".join(f"{low:>5.0f} / {high:<5.0f}" for low, high in cells)
        lines.append(f"{title:12}{len(own):>6}  {told}")
    lines.append(f"longest without listening: {max(move.deaf_ms for move in moves):.0f} ms")
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("photos", nargs="?", type=Path, default=SAMPLE)
    parser.add_argument("--drags", type=int, default=DRAGS)
    parser.add_argument("--json", action="store_true")
    chosen = parser.parse_args()
    app = QApplication.instance() or QApplication([])
    values = cloned_values(chosen.photos)
    rng = np.random.default_rng(5)
    with tempfile.TemporaryDirectory() as folder:
        session, page = open_page(values, Path(folder))
        drag(session, page, *places(session, rng, 1)[0], rng)  # the first measures the skin
        moves = [move for place in places(session, rng, chosen.drags) for move in drag(session, page, *place, rng)]
        session.undo_stack.clear()
    print(json.dumps([move._asdict() for move in moves]) if chosen.json else table(moves))
    page.deleteLater()
    app.processEvents()


if __name__ == "__main__":
    main()
