"""A day of many visitors at the window, step by step, with a watch over its thread."""

from __future__ import annotations

import json
import shutil
import time
from collections.abc import Callable
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any, Final

from PIL import Image
from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtTest import QTest

from cloner.booth.photos.check_cache import store_check
from cloner.booth.photos.photo_problems import PhotoCheck, PhotoProblem
from cloner.booth.visitors.visits import State, Visit, write_visit
from cloner.frames import ViewId
from cloner_gui.main_window import CLONE, PHOTOS, POINTS, TAKEAWAY, VISITOR, MainWindow
from cloner_gui.pages.gallery import TRASHED, GalleryWindow
from cloner_gui.pages.held import HeldWindow
from cloner_gui.pages.settings import SettingsWindow
from cloner_gui.pages.statistics import StatisticsWindow
from kit.silence import Silence
from kit.stand_ins import Jobs, drop

SAMPLES: Final = Path(__file__).parents[2] / "samples"
#: Every so manieth lies in the trash; half of those for longer than was said.
_TRASHED: Final = 20


def crowd(root: Path, visitors: int) -> None:
    """Leave a day's visitors in an event: photos, names, what was found, pictures of clones, some in the trash."""
    photo = Image.linear_gradient("L").resize((240, 320)).convert("RGB")
    photo.save(root.parent / "photo.jpg")
    photo.resize((1080, 1620)).save(root.parent / "picture.jpg")
    now = datetime.now(UTC)
    for number in range(1, visitors + 1):
        thrown = number % _TRASHED == 0
        folder = (root / "trash" if thrown else root) / f"visitor-{number:03d}"
        (folder / "phone").mkdir(parents=True)
        shutil.copy(root.parent / "photo.jpg", folder / "body_front.jpg")
        shutil.copy(root.parent / "picture.jpg", folder / "phone" / "picture.jpg")
        (folder / "person.toml").write_text(f'name = "Guest {number}"\nconsent = "yes (2026-11-22 10:00 UTC, en)"\n')
        state = (State.CLONED, State.CLONED, State.CLONED, State.FAILED)[number % 4]
        at = (now - timedelta(days=30 if number % (2 * _TRASHED) == 0 else 1)).isoformat()
        gone = at if thrown else ""
        write_visit(
            folder, Visit("takeaway", state=state, started=at, queued=at, finished=at, shown=True, trashed=gone)
        )
        store_check(
            folder, PhotoCheck(f"{number}", ViewId.BODY_FRONT, (PhotoProblem.BLURRED,) if number % 5 == 0 else ())
        )
    (root / "event.json").write_text(json.dumps({"format": 2, "title": "Fair"}))


def walk(window: MainWindow, jobs: Jobs, root: Path, silence: Silence) -> None:
    """Open the day's event, take a visitor to the end, look at everybody, and leave.

    Parameters
    ----------
    window : MainWindow
        With the stand-ins ``jobs``.
    jobs : Jobs
    root : Path
        An event with a :func:`crowd`.
    silence : Silence
    """
    click = Qt.MouseButton.LeftButton
    booth, session = window.booth, window.session
    window.resize(1280, 800)
    silence.step("opening the event", lambda: window.open_folder(root), lambda: not list(root.glob("trash/.*")))
    for number in (VISITOR, PHOTOS, POINTS, CLONE, TAKEAWAY):
        window.go(number)  # made once, behind the first page: `cloner_gui.app.preload_pages`
    window.go(VISITOR)
    silence.step("a new visitor", lambda: QTest.mouseClick(window.visitor.new_button, click),
                 lambda: booth.opening is None and session.folder is not None)  # fmt: skip
    form = window.visitor.form
    silence.step("typing a name", lambda: QTest.keyClicks(form.name_field, "Anna Long"))
    silence.step("agreeing", lambda: QTest.mouseClick(form.agree_button, click))
    photos = [SAMPLES / "anna" / "plain" / f"{view}.jpg" for view in ViewId]
    silence.step("five photos are dropped", lambda: drop(window.photos, *photos),
                 lambda: len(session.photos.photos) == 5 and not booth.intake.pending())  # fmt: skip
    side = window.photos.cards[ViewId.FACE_SIDE]
    for _ in range(4):
        silence.step("a photo is turned", lambda: side.turn_wanted.emit(ViewId.FACE_SIDE),
                     lambda: not booth.intake.pending())  # fmt: skip
    session.propose()
    _wait(lambda: bool(session.proposed) and not session.busy)
    silence.step("cloning", session.clone, lambda: session.outcome is not None and not session.busy)
    for _ in range(2):
        for number, page in enumerate(("visitor", "photos", "points", "clone", "take away")):
            silence.step(f"to the page: {page}", lambda number=number: window.go(number))
    for size in ((1024, 740), (1600, 1000)):
        silence.step(f"resizing to {size}", lambda size=size: window.resize(*size))
    others(window, silence)
    silence.step("another visitor opens", lambda: booth.open_visitor(next(iter(booth.visits()))),
                 lambda: booth.opening is None)  # fmt: skip
    jobs.wait_for_cancel = True
    everybody(window, root, silence)


def others(window: MainWindow, silence: Silence) -> None:
    """Open what is beside the main window, and use it."""
    made: list[Any] = []
    silence.step("the gallery opens", lambda: (made.append(GalleryWindow(window.booth, window)), made[-1].show()),
                 lambda: not made[-1]._icons)  # fmt: skip
    gallery = made[-1]
    assert gallery.list.count() == len(window.booth.visits())
    settled = lambda: not gallery._icons  # noqa: E731
    silence.step("searching", lambda: gallery.search.setText("guest 11"), settled)
    silence.step("everybody again", lambda: gallery.search.setText(""), settled)
    silence.step("the trash", lambda: gallery.which.setCurrentIndex(TRASHED), settled)
    silence.step("out of the trash", lambda: gallery.which.setCurrentIndex(0), settled)
    silence.step("somebody's state changes", window.booth.visits_changed.emit, settled)
    gallery.list.item(3).setSelected(True)
    silence.step("thrown away", gallery._throw_away, settled)
    gallery.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)  # as the menu opens it
    gallery.close()
    for kind in (SettingsWindow, StatisticsWindow, HeldWindow):
        silence.step(
            f"{kind.__name__} opens", lambda kind=kind: made.append(kind(window.booth, window)) or made[-1].show()
        )
        made[-1].setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        made[-1].close()


def everybody(window: MainWindow, root: Path, silence: Silence) -> None:
    """Do to everybody at once what the gallery offers: thrown away, brought back, cloned again, deleted."""
    booth, gallery = window.booth, GalleryWindow(window.booth, window)
    gallery.show()
    settled = lambda: not gallery._icons  # noqa: E731
    _wait(settled)
    many = len(booth.visits())
    gallery.list.selectAll()
    silence.step("all are thrown away", gallery._throw_away, lambda: settled() and not booth.visits())
    gallery.which.setCurrentIndex(TRASHED)
    _wait(lambda: settled() and gallery.list.count() >= many)
    gallery.list.selectAll()
    silence.step("all are brought back", gallery._bring_back, lambda: settled() and len(booth.visits()) >= many)
    gallery.which.setCurrentIndex(0)
    _wait(settled)
    gallery.list.selectAll()
    silence.step("all are cloned again", gallery._clone_again, settled, goes_on=True)
    gallery.list.selectAll()
    silence.step("all are deleted", lambda: booth.forget(*gallery.marked()),
                 lambda: settled() and not list(root.glob(".forget*")))  # fmt: skip
    assert not booth.visits()
    gallery.close()


def _wait(done: Callable[[], bool]) -> None:
    end = time.monotonic() + 120.0
    while not done():
        assert time.monotonic() < end
        QCoreApplication.processEvents()
        time.sleep(0.002)
