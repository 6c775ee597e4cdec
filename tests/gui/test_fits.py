"""No text is cut in any language, size of text and size of screen; and no letter stands for two controls."""

import pytest
from PySide6.QtCore import QEvent
from PySide6.QtWidgets import QApplication, QDialog

from cloner.booth.event import LANGUAGES
from cloner.frames import ViewId
from cloner.project.results import file_digest
from cloner_gui.letters import assign, letter_of, lettered_in
from kit.fitting import cut_texts

from .test_flow import begin, drop, settled
from .test_hands import event  # noqa: F401  (a fixture)

pytestmark = pytest.mark.gui
#: Width and height of the window, text percent, big buttons.
SIZES = ((1280, 800, 100, False), (1024, 740, 100, False), (1024, 740, 150, True), (1280, 800, 200, False))


@pytest.fixture
def busy_event(event, qtbot, jobs, samples):  # noqa: F811
    """An event whose visitor has troubled photos, one of them without a place, points and a clone."""
    from cloner.booth.looking_table import Trouble

    folder = samples / "anna" / "plain"
    jobs.looks[file_digest(folder / "body_side.jpg")] = (ViewId.BODY_FRONT, (Trouble.SMALL, Trouble.BLURRED))
    begin(event, qtbot)
    event.booth.save_person("Annemarie Sommerfeld", 171.0)
    event.go(1)
    drop(event.photos, folder / "body_front.jpg", folder / "body_side.jpg", folder / "face_front.jpg")
    settled(event, qtbot)
    event.photos._to_tray(ViewId.FACE_FRONT)
    settled(event, qtbot)
    event.session.propose()
    qtbot.waitUntil(lambda: bool(event.session.proposed) and not event.session.busy)
    with qtbot.waitSignal(event.session.cloned, timeout=20000):
        event.session.clone()
    qtbot.waitUntil(lambda: not event.session.busy)
    event.session.place_point(ViewId.BODY_FRONT, "nose_tip", 610.0, 300.0)
    return event


@pytest.mark.parametrize("code", LANGUAGES)
def test_no_text_is_cut(busy_event, code):
    window = busy_event
    window.booth.change(language=code)
    for width, height, percent, big in SIZES:
        window.booth.change(text_percent=percent, big=big)
        window.resize(width, height)
        for number in range(5):
            window.go(number)
            for _ in range(3):
                QApplication.processEvents()
                QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)
            assert window.size().toTuple() == (width, height), f"{code}, {percent} %: page {number} asks for more"
            cut = cut_texts(window)
            assert not cut, f"{code}, {width}x{height}, {percent} %, page {number}:\n" + "\n".join(cut)


@pytest.mark.parametrize("code", LANGUAGES)
def test_every_letter_stands_for_one_control(busy_event, code):
    window = busy_event
    window.booth.change(language=code)
    for number in range(5):
        window.go(number)
        frame = [window.back, window.aside, window.next]
        seen = [*window.menuBar().actions(), *frame, *lettered_in(window.stack.currentWidget())]
        letters = [letter_of(one.text()) for one in seen if letter_of(one.text())]
        assert len(letters) == len(set(letters)), f"{code}, page {number}: {sorted(one.text() for one in seen)}"
        assert len(letters) > 5
    for title in window.menuBar().actions():
        menus = [title.menu(), *(one.menu() for one in title.menu().actions() if one.menu())]
        for menu in menus:
            letters = [letter_of(one.text()) for one in menu.actions() if letter_of(one.text())]
            assert len(letters) == len(set(letters)), f"{code}: {[one.text() for one in menu.actions()]}"
    for dialog in window.findChildren(QDialog):
        dialog.close()


def test_the_letter_that_translators_like_stays_where_it_is_free():
    assert assign(["&Save", "&Show", "Plain", "S&how"]) == ["&Save", "S&how", "Plain", "Sh&ow"]
    assert assign(["&Öffnen", "&öl"]) == ["&Öffnen", "ö&l"]
    assert assign(["&A", "&A"]) == ["&A", "A"], "none is left: no letter rather than one for two"
