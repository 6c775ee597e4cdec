"""The window's thread listens again and again in spite of its own work: pages, photos, a day of two hundred."""

import json
import logging
import shutil

import pytest
from PIL import Image
from PySide6.QtCore import Qt

from cloner.booth.photos.looking_table import Look, Trouble
from cloner.booth.photos.looks import keep_look
from cloner.booth.visitors.visits import State, Visit, write_visit
from cloner.frames import ViewId
from cloner_gui.main_window import CLONE, PHOTOS, POINTS, TAKEAWAY, VISITOR
from cloner_gui.pages.gallery import TRASHED, GalleryWindow
from cloner_gui.pages.held import HeldWindow
from cloner_gui.pages.settings import SettingsWindow
from cloner_gui.pages.statistics import StatisticsWindow
from kit.silence import Silence

from .test_flow import begin, drop, event, settled  # noqa: F401  (event is a fixture)

pytestmark = [pytest.mark.gui, pytest.mark.slow]
#: The bar is 100 ms on free cores; two processes of tests share theirs, on machines of any speed.
MOST_MS = 200.0
#: Once a day the files of everybody are read for the first time.
OPENING, OPENING_MS = "opening the event", 300.0
log = logging.getLogger(__name__)
VISITORS = 200


def crowd(root):
    """Leave a day's visitors in an event: photos, names, what was found, pictures of clones, some in the trash."""
    photo = Image.linear_gradient("L").resize((240, 320)).convert("RGB")
    photo.save(root.parent / "photo.jpg")
    photo.resize((1080, 1620)).save(root.parent / "picture.jpg")
    for number in range(1, VISITORS + 1):
        folder = (root / "trash" if number % 20 == 0 else root) / f"visitor-{number:03d}"
        (folder / "phone").mkdir(parents=True)
        shutil.copy(root.parent / "photo.jpg", folder / "body_front.jpg")
        shutil.copy(root.parent / "picture.jpg", folder / "phone" / "picture.jpg")
        (folder / "person.toml").write_text(f'name = "Guest {number}"\nconsent = "yes (2026-11-22 10:00 UTC, en)"\n')
        state = (State.CLONED, State.CLONED, State.CLONED, State.FAILED)[number % 4]
        at = f"2026-11-22T{8 + number // 25:02d}:{number % 60:02d}:00+00:00"
        gone = at if number % 20 == 0 else ""
        write_visit(
            folder, Visit("takeaway", state=state, started=at, queued=at, finished=at, shown=True, trashed=gone)
        )
        keep_look(folder, Look(f"{number}", ViewId.BODY_FRONT, (Trouble.BLURRED,) if number % 5 == 0 else ()))
    (root / "event.json").write_text(json.dumps({"format": 2, "title": "Fair"}))


def test_the_window_is_never_silent_for_long_by_its_own_work(event, qtbot, samples, jobs):  # noqa: F811
    silence, window = Silence(), event
    crowd(window.booth.root)
    window.resize(1280, 800)
    silence.step(OPENING, lambda: window.open_folder(window.booth.root))
    for number in (VISITOR, PHOTOS, POINTS, CLONE, TAKEAWAY):
        window.go(number)  # made once, behind the first page: `cloner_gui.app.load_the_rest`
    window.go(VISITOR)
    silence.step(
        "a new visitor",
        lambda: qtbot.mouseClick(window.visitor.new_button, Qt.MouseButton.LeftButton),
        lambda: window.booth._opening is None and window.session.folder is not None,
    )
    form = window.visitor.form
    silence.step("typing a name", lambda: qtbot.keyClicks(form.name_field, "Anna Long"))
    silence.step("agreeing", lambda: qtbot.mouseClick(form.agree_button, Qt.MouseButton.LeftButton))
    photos = [samples / "anna" / "plain" / f"{view}.jpg" for view in ViewId]
    silence.step(
        "five photos are dropped", lambda: drop(window.photos, *photos),
        lambda: len(window.session.photos.photos) == 5 and not window.booth.intake.pending(),
    )  # fmt: skip
    silence.step("a turned photo", lambda: window.photos.cards[ViewId.FACE_SIDE].turn_wanted.emit(ViewId.FACE_SIDE),
                 lambda: not window.booth.intake.pending())  # fmt: skip
    side = window.photos.cards[ViewId.FACE_SIDE]
    turn_back = [lambda: side.turn_wanted.emit(ViewId.FACE_SIDE)] * 3
    for turn in turn_back:
        silence.step("turned on", turn, lambda: not window.booth.intake.pending())
    window.session.propose()
    qtbot.waitUntil(lambda: bool(window.session.proposed) and not window.session.busy, timeout=20000)
    silence.step(
        "cloning", window.session.clone, lambda: window.session.outcome is not None and not window.session.busy
    )
    for _ in range(2):
        for number, page in enumerate(("visitor", "photos", "points", "clone", "take away")):
            silence.step(f"to the page: {page}", lambda number=number: window.go(number))
    for size in ((1024, 740), (1600, 1000)):
        silence.step(f"resizing to {size}", lambda size=size: window.resize(*size))
    others(window, silence)
    silence.step("another visitor opens", lambda: window.booth.open_visitor(next(iter(window.booth.visits()))),
                 lambda: window.booth._opening is None)  # fmt: skip
    assert window.session.folder.name == "visitor-001"
    log.info("\n%s", silence.told())
    assert silence.longest.pop(OPENING) < OPENING_MS
    late = {name: round(spent) for name, spent in silence.longest.items() if spent > MOST_MS}
    assert not late, late


def others(window, silence):
    """Open what is beside the main window, and use it."""
    made = []
    silence.step("the gallery opens", lambda: (made.append(GalleryWindow(window.booth, window)), made[-1].show()),
                 lambda: not made[-1]._icons)  # fmt: skip
    gallery = made[-1]
    assert gallery.list.count() == VISITORS - VISITORS // 20 + 1
    silence.step("searching", lambda: gallery.search.setText("guest 11"), lambda: not gallery._icons)
    silence.step("everybody again", lambda: gallery.search.setText(""), lambda: not gallery._icons)
    silence.step("the trash", lambda: gallery.which.setCurrentIndex(TRASHED), lambda: not gallery._icons)
    silence.step("out of the trash", lambda: gallery.which.setCurrentIndex(0), lambda: not gallery._icons)
    silence.step("somebody's state changes", window.booth.visits_changed.emit, lambda: not gallery._icons)
    gallery.list.item(3).setSelected(True)
    silence.step("thrown away", gallery._throw_away, lambda: not gallery._icons)
    gallery.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)  # as the menu opens it
    gallery.close()
    for kind in (SettingsWindow, StatisticsWindow, HeldWindow):
        silence.step(
            f"{kind.__name__} opens", lambda kind=kind: made.append(kind(window.booth, window)) or made[-1].show()
        )
        made[-1].setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        made[-1].close()
