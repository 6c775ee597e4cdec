"""No text is cut in any language, size of text and size of screen; and no letter stands for two controls."""

import functools
import threading
import time

import pytest
from PySide6.QtCore import QEvent
from PySide6.QtWidgets import QApplication, QDialog, QHeaderView

from cloner.booth.events.event import LANGUAGES
from cloner.booth.visitors.visits import State, Visit, write_visit
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project.results import file_digest
from cloner_gui.canvas.photos.webcam import WebcamDialog
from cloner_gui.canvas.photos.whole_photo import WholePhoto
from cloner_gui.dialogs import ask_to_forget
from cloner_gui.main_window import CLONE, TAKEAWAY
from cloner_gui.menus import studio_entries
from cloner_gui.pages.gallery import TRASHED, GalleryWindow
from cloner_gui.pages.held import HeldWindow
from cloner_gui.pages.settings import SettingsWindow
from cloner_gui.pages.stage import StageWindow
from cloner_gui.pages.statistics import StatisticsWindow
from cloner_gui.studio.windows import window_of
from cloner_gui.widgets.letters import assign_mnemonics, mnemonic_of, with_mnemonics
from kit.fitting import beyond_screen, cut_texts
from kit.odd_programs import install
from kit.stand_ins import drop

from .test_flow import begin, settled
from .test_hands import event  # noqa: F401  (a fixture)
from .test_reading_aloud import Still
from .test_take_home import lsblk

pytestmark = pytest.mark.gui
#: Width and height of the screen; a dense one of 3840 x 2160 at 200 % has as many points as the last.
SCREENS = ((1024, 740), (1280, 800), (1920, 1080))
#: Text percent, big buttons.
TEXTS = ((100, False), (150, True), (200, False))


@pytest.fixture
def busy_event(event, qtbot, jobs, samples, monkeypatch, tmp_path):  # noqa: F811
    """Everything that can be said at once: troubled photos, one without a place, a stale clone, a stick, a telephone's
    page, files on their way, somebody who failed and somebody in the trash."""
    from cloner.booth.photos.photo_problems import PhotoProblem

    monkeypatch.setattr("cloner_gui.event.phone.local_addresses", lambda: ("127.0.0.1",))
    monkeypatch.setattr("cloner_gui.event.phone.PORT", 0)
    monkeypatch.setattr("cloner.booth.phone.parcel.SIZE_PX", (24, 36))
    monkeypatch.setattr("cloner.booth.phone.parcel.LARGE_PX", (24, 36))
    (tmp_path / "mountinfo").write_text("one")
    monkeypatch.setattr("cloner_gui.widgets.stick_row.MOUNTS", tmp_path / "mountinfo")
    install(tmp_path, monkeypatch, lsblk=lsblk(tmp_path))
    event.booth.change(licence="everyone")
    failed = begin(event, qtbot)
    write_visit(failed, Visit(state=State.FAILED, problem="visitor-001: nobody is seen in this photo. Retake it"))
    thrown = begin(event, qtbot)
    event.booth.throw_away(thrown)
    qtbot.waitUntil(lambda: not thrown.exists() and event.booth.opening is None)
    folder = samples / "anna" / "plain"
    jobs.checks[file_digest(folder / "body_side.jpg")] = (ViewId.BODY_FRONT, (PhotoProblem.SMALL, PhotoProblem.BLURRED))
    begin(event, qtbot)
    event.booth.save_person("Annemarie Sommerfeld-Müller", 171.0)
    event.go(1)
    drop(event.photos, folder / "body_front.jpg", folder / "body_side.jpg", folder / "face_front.jpg")
    settled(event, qtbot)
    event.photos._to_tray(ViewId.FACE_FRONT)
    settled(event, qtbot)
    event.session.propose()
    qtbot.waitUntil(lambda: bool(event.session.proposed) and not event.session.busy)
    with qtbot.waitSignal(event.session.cloned):
        event.session.clone()
    qtbot.waitUntil(lambda: not event.session.busy)
    event.session.place_point(ViewId.BODY_FRONT, "nose_tip", 610.0, 300.0)
    result = event.session.outcome.folder
    result.mkdir(parents=True, exist_ok=True)
    before = event.session.folder / "clone_before" / "result"
    before.mkdir(parents=True)
    for name in ("clone.npz", "report.json"):
        (before / name).touch()
    event.go(TAKEAWAY)
    qtbot.waitUntil(lambda: bool(event.takeaway.sticks.sticks))
    event.notice.clear()
    yield event
    jobs.hold_copies = None


def settle():
    for _ in range(3):
        QApplication.processEvents()
        QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)


def windows(window):
    """Yield a name and a maker of each window and question beside the main one."""
    booth, folders = window.booth, tuple(window.booth.visits())

    def trashed():
        gallery = GalleryWindow(booth, window)
        gallery.which.setCurrentIndex(TRASHED)
        return gallery

    yield "gallery", lambda: GalleryWindow(booth, window)
    yield "trash", trashed
    yield "settings", lambda: SettingsWindow(booth, window)
    yield "effort", lambda: StatisticsWindow(booth, window)
    yield "what is held", lambda: HeldWindow(booth, window)
    yield "visitors' screen", lambda: StageWindow(booth, window)
    yield "webcam", lambda: WebcamDialog(ViewId.FACE_SIDE, window, make=Still)
    yield "delete", lambda: ask_to_forget(booth, folders, window)
    yield "large photo", lambda: large_photo(window)
    for _, which in studio_entries():
        yield which, functools.partial(window_of(which), booth, window)


def large_photo(window):
    card = window.photos.cards[ViewId.BODY_SIDE]
    photo = window.session.photos.photos[ViewId.BODY_SIDE]
    return WholePhoto("Body, side", card.verdict.text(), photo.rgb, window)


def cut_in_pages(window, width, height, numbers):
    window.resize(width, height)
    for number in numbers:
        window.go(number)
        settle()
        if window.size().toTuple() != (width, height):
            yield f"page {number}: asks for {window.size().toTuple()}"
        yield from (f"page {number}: {told}" for told in cut_texts(window))


def cut_beside(window, width, height):
    for called, make in windows(window):
        one = make()
        one.show()
        end = time.monotonic() + 5.0
        while isinstance(one, HeldWindow) and not one.table.rowCount() and time.monotonic() < end:
            settle()  # every file is counted beside the window's thread
        one.resize(min(one.width(), width), min(one.height(), height))
        settle()
        yield from (f"{called}: {told}" for told in (*beyond_screen(one, width, height), *cut_texts(one)))
        one.close()
        settle()


def cut_everywhere(window, code, screens, *, beside=True):
    """Return every cut text of a language, in all sizes of text."""
    window.booth.change(language=code)
    found, pages = [], tuple(range(TAKEAWAY + 1))
    for percent, big in TEXTS:
        window.booth.change(text_percent=percent, big=big)
        for width, height in screens:
            where = f"{code}, {width}x{height}, {percent} %{', big' if big else ''}"
            found += [f"{where}, {told}" for told in cut_in_pages(window, width, height, pages)]
            found += [f"{where}, {told}" for told in cut_beside(window, width, height)] if beside else []
    return found


@pytest.mark.parametrize("code", LANGUAGES)
def test_no_text_is_cut(busy_event, code):
    cut = cut_everywhere(busy_event, code, SCREENS)
    assert not cut, "\n".join(cut)


@pytest.mark.parametrize("code", LANGUAGES)
def test_no_text_is_cut_while_everything_is_under_way(busy_event, code, jobs, qtbot, tmp_path):
    """A clone, files on their way, a page for telephones, and something that went wrong."""
    jobs.wait_for_cancel, jobs.hold_copies = True, threading.Event()
    busy_event.session.clone()
    busy_event.takeaway.handing.start(tmp_path / "out", ("glb",))
    busy_event.booth.change(phone=True)
    busy_event.notice.tell(ClonerError("nobody is seen in this photo", "Retake it", "face_side.jpg"))
    qtbot.waitUntil(lambda: busy_event.takeaway.handing.step == "copy")
    cut = cut_everywhere(busy_event, code, SCREENS[:1], beside=False)
    busy_event.session.cancel()
    assert not cut, "\n".join(cut)


def test_a_cut_text_is_found(busy_event, qtbot):
    """The check itself can fail: a button, a label, a heading, an entry, a placeholder, a choice that have no room."""
    busy_event.resize(1280, 800)
    busy_event.go(CLONE)
    settle()
    assert cut_texts(busy_event) == []
    busy_event.clone.clone_button.setFixedWidth(30)
    busy_event.queue_bar.hide()
    settle()
    assert any("QPushButton" in told for told in cut_texts(busy_event))
    settings = SettingsWindow(busy_event.booth, busy_event)
    settings.show()
    settle()
    settings.licence.choice.setFixedWidth(60)
    settings.title.setFixedWidth(20)
    settle()
    told = "\n".join(cut_texts(settings))
    assert "choice" in told
    assert "placeholder" in told
    held = HeldWindow(busy_event.booth, busy_event)
    held.show()
    qtbot.waitUntil(lambda: held.table.rowCount() > 0)
    held.table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
    held.table.setColumnWidth(0, 30)
    settle()
    assert any("heading" in one or "cell" in one for one in cut_texts(held))
    assert beyond_screen(settings, 100, 100)


@pytest.mark.parametrize("code", LANGUAGES)
def test_every_letter_stands_for_one_control(busy_event, code):
    window = busy_event
    window.booth.change(language=code)
    for number in range(5):
        window.go(number)
        QApplication.processEvents()
        frame = [window.back, window.aside, window.next]
        seen = [*window.menuBar().actions(), *frame, *with_mnemonics(window.stack.currentWidget())]
        letters = [mnemonic_of(one.text()) for one in seen if mnemonic_of(one.text())]
        assert len(letters) == len(set(letters)), f"{code}, page {number}: {sorted(one.text() for one in seen)}"
        assert len(letters) > 5
    for title in window.menuBar().actions():
        menus = [title.menu(), *(one.menu() for one in title.menu().actions() if one.menu())]
        for menu in menus:
            letters = [mnemonic_of(one.text()) for one in menu.actions() if mnemonic_of(one.text())]
            assert len(letters) == len(set(letters)), f"{code}: {[one.text() for one in menu.actions()]}"
    for dialog in window.findChildren(QDialog):
        dialog.close()


def test_the_letter_that_translators_like_stays_where_it_is_free():
    assert assign_mnemonics(["&Save", "&Show", "Plain", "S&how"]) == ["&Save", "S&how", "Plain", "Sh&ow"]
    assert assign_mnemonics(["&Öffnen", "&öl"]) == ["&Öffnen", "ö&l"]
    assert assign_mnemonics(["&A", "&A"]) == ["&A", "A"], "none is left: no letter rather than one for two"
