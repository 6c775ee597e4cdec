"""Who may use a visitor's files: the event says how far visitors may go, and each visitor chooses at the consent."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QDialogButtonBox

from cloner.booth.events.event import LANGUAGES, read_event
from cloner.project.folder import read_terms
from cloner_gui.pages.settings import SettingsWindow

from .test_flow import event  # noqa: F401  (a fixture)

pytestmark = pytest.mark.gui
LEFT = Qt.MouseButton.LeftButton


def allow(window, qtbot, licence):
    """Choose in the settings window how far visitors may go, and save."""
    dialog = SettingsWindow(window.booth, window)
    dialog.show()
    choice = dialog.licence.choice
    qtbot.keyClick(choice, Qt.Key.Key_Home)
    for _ in range(["own", "event", "everyone"].index(licence)):
        qtbot.keyClick(choice, Qt.Key.Key_Down)
    qtbot.mouseClick(dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Save), LEFT)


def somebody(window, qtbot):
    """Take a new visitor who has read nothing yet."""
    with qtbot.waitSignal(window.booth.page_wanted):
        qtbot.mouseClick(window.visitor.new_button, LEFT)
    return window.session.folder


def test_without_the_events_wish_nobody_is_asked_and_the_files_are_the_visitors_own(event, qtbot):  # noqa: F811
    folder = somebody(event, qtbot)
    form = event.visitor.form
    assert not form.licence.isVisible()
    qtbot.mouseClick(form.agree_button, LEFT)
    assert (read_terms(folder).licence, read_terms(folder).event) == ("own", "fair")


def test_a_visitor_chooses_as_far_as_the_event_asks_and_the_next_one_begins_anew(event, qtbot):  # noqa: F811
    allow(event, qtbot, "everyone")
    assert read_event(event.booth.root).licence == "everyone"
    first, form = somebody(event, qtbot), event.visitor.form
    assert form.licence.isVisible()
    assert [form.licence.choice.itemData(row) for row in range(3)] == ["own", "event", "everyone"]
    assert form.licence.chosen() == "own", "nothing is given away by not looking"
    qtbot.keyClick(form.licence.choice, Qt.Key.Key_Down)
    assert "advertising" in form.licence.meaning.text()
    qtbot.mouseClick(form.agree_button, LEFT)
    assert read_terms(first).licence == "event"
    assert not form.licence.choice.isEnabled(), "what was agreed to is shown as it was"
    second = somebody(event, qtbot)
    assert form.licence.chosen() == "own"
    qtbot.mouseClick(form.agree_button, LEFT)
    assert read_terms(second).licence == "own"
    allow(event, qtbot, "event")
    with qtbot.waitSignal(event.booth.page_wanted):
        event.booth.open_visitor(first)
    assert form.licence.chosen() == "event"
    form.consent_box.click()
    assert read_terms(first).licence == "", "who takes the consent back takes the licence back"
    assert [form.licence.choice.itemData(row) for row in range(form.licence.choice.count())] == ["own", "event"]


def test_where_the_events_own_text_says_so_that_is_chosen_first_and_can_be_narrowed(event, qtbot):  # noqa: F811
    event.booth.change(licence="everyone", consents={"de": "Alle dürfen meine Dateien benutzen."})
    folder, form = somebody(event, qtbot), event.visitor.form
    assert form.licence.chosen() == "own", "the English text says nothing of the kind"
    form.language.setCurrentIndex(list(LANGUAGES).index("de"))
    assert form.licence.chosen() == "everyone"
    assert form.licence.choice.currentText() == "alle", "in the words of the text that is read"
    qtbot.keyClick(form.licence.choice, Qt.Key.Key_Home)
    QApplication.processEvents()
    qtbot.mouseClick(form.agree_button, LEFT)
    assert read_terms(folder).licence == "own"
