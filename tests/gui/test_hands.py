"""Hands of others: keyboard alone, screen readers, four languages, right to left, contrast, big text, small screens."""

import re
import xml.etree.ElementTree as ElementTree

import pytest
from PySide6.QtCore import QMimeData, Qt, QUrl
from PySide6.QtGui import QAccessible, QColor, QGuiApplication
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QLabel, QPushButton, QWidget

from cloner.booth.events.event import LANGUAGES
from cloner.frames import ViewId
from cloner_gui.event.session import Session
from cloner_gui.language.languages import FOLDER, consent_text, set_language
from cloner_gui.main_window import MainWindow
from cloner_gui.theme import CONTRAST, DARK, LIGHT, apply_theme

from .test_flow import begin, settled

pytestmark = pytest.mark.gui


@pytest.fixture
def event(qtbot, jobs, tmp_path):
    """A window on a new, empty event; the program's language and looks are put back."""
    root = tmp_path / "fair"
    root.mkdir()
    window = MainWindow(Session(jobs.services()))
    qtbot.addWidget(window)
    window.resize(960, 540)
    window.show()
    window.activateWindow()
    window.booth.open(root)
    app = QApplication.instance()
    yield window
    window.booth.close()
    set_language("en")
    apply_theme(app, "system", big=False, text_percent=100)
    app.setLayoutDirection(Qt.LayoutDirection.LeftToRight)


def test_the_whole_path_by_keyboard(event, qtbot, samples, jobs):
    """From an empty event to a clone without touching the mouse; photos come from the clipboard."""

    def press(key, times=1, modifier=Qt.KeyboardModifier.NoModifier):
        for _ in range(times):
            qtbot.keyClick(QApplication.focusWidget() or event, key, modifier)

    def to(widget):
        for _ in range(60):
            if QApplication.focusWidget() is widget:
                return
            press(Qt.Key.Key_Tab)
        raise AssertionError(f"Tab never reaches {widget.accessibleName() or widget.text()}")

    event.visitor.new_button.setFocus()
    qtbot.waitUntil(lambda: QApplication.focusWidget() is event.visitor.new_button)
    with qtbot.waitSignal(event.booth.page_wanted):
        press(Qt.Key.Key_Space)
    to(event.visitor.form.name_field)
    qtbot.keyClicks(event.visitor.form.name_field, "7")
    to(event.visitor.form.consent_box)
    press(Qt.Key.Key_Space)
    assert event.session.consent
    to(event.next)
    press(Qt.Key.Key_Space)
    assert event.stack.currentWidget() is event.photos
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(samples / "anna" / "plain" / f"{view}.jpg")) for view in ViewId])
    QGuiApplication.clipboard().setMimeData(data)
    to(event.photos.paste_button)
    press(Qt.Key.Key_Space)
    settled(event, qtbot)
    # Qt frees a clipboard's content after Python has ended, which crashes when Python made the content
    QGuiApplication.clipboard().clear()
    assert len(event.session.photos.photos) == 5
    to(event.next)
    with qtbot.waitSignal(event.session.cloned):
        press(Qt.Key.Key_Space)
    assert event.stack.currentWidget() is event.clone
    to(event.next)
    press(Qt.Key.Key_Space)
    assert event.stack.currentWidget() is event.takeaway


def test_every_control_has_a_name_for_screen_readers(event, qtbot):
    begin(event, qtbot)
    nameless = []
    for page in event.pages:
        event.show_page(page)
        for widget in event.findChildren(QWidget):
            if widget.isVisible() and widget.focusPolicy() & Qt.FocusPolicy.TabFocus:
                interface = QAccessible.queryAccessibleInterface(widget)
                if interface is None or not interface.text(QAccessible.Text.Name):
                    inside = isinstance(widget.parent(), QWidget) and widget.parent().accessibleName()
                    nameless += [] if inside else [f"{type(page).__name__}: {type(widget).__name__}"]
    assert nameless == []


@pytest.mark.parametrize("code", LANGUAGES)
def test_every_page_fits_a_small_screen_in_every_language(event, qtbot, code):
    event.booth.change(language=code)
    begin(event, qtbot)
    for page in event.pages:
        event.show_page(page)
        for _ in range(2):  # letters settle once a loop, and the layout after them
            QApplication.processEvents()
        needs = event.minimumSizeHint()
        assert needs.width() <= 960, f"{type(page).__name__} in {code} needs {needs.width()} px"
        assert needs.height() <= 540, f"{type(page).__name__} in {code} needs {needs.height()} px"
        for button in page.findChildren(QPushButton):
            if button.isVisible() and button.text():
                assert button.width() >= button.minimumSizeHint().width(), f"{code}: {button.text()} is cut off"


def test_another_language_is_spoken_at_once_and_the_consent_is_the_visitors(event, qtbot):
    folder = begin(event, qtbot)
    event.booth.change(language="de")
    QApplication.processEvents()
    assert event.visitor.new_button.text() == "&Neuer Besucher"
    assert event.steps.buttons[4].text() == "5  Mitnehmen"
    form = event.visitor.form
    form.consent_box.click()
    form.language.setCurrentIndex(list(LANGUAGES).index("tr"))
    assert form.consent_text.text() == consent_text("tr", 30, {})
    assert "30 gün saklanıp" in form.consent_text.text()
    assert "kabul ediyorum" in form.consent_text.text()
    form.consent_box.click()
    assert 'UTC, tr)"' in (folder / "person.toml").read_text()
    event.booth.change(language="en")
    QApplication.processEvents()
    assert event.visitor.new_button.text() == "&New visitor"


@pytest.mark.parametrize(("code", "save", "cancel"), [
    ("en", "Save", "Cancel"), ("de", "Speichern", "Abbrechen"), ("fr", "Enregistrer", "Annuler"),
    ("tr", "Kaydet", "İptal"),
])  # fmt: skip
def test_qts_own_buttons_speak_the_language_too(event, code, save, cancel):
    event.booth.change(language=code)
    box = QDialogButtonBox(QDialogButtonBox.StandardButton.Save | QDialogButtonBox.StandardButton.Cancel)
    assert [one.text().replace("&", "") for one in box.buttons()] == [save, cancel]


@pytest.mark.parametrize("code", [code for code in LANGUAGES if code != "en"])
def test_translations_keep_their_blanks_and_are_finished(code):
    messages = list(ElementTree.parse(FOLDER / f"cloner_{code}.ts").getroot().iter("message"))
    assert len(messages) > 250
    for message in messages:
        source, translation = message.findtext("source"), message.find("translation")
        assert translation.get("type") != "unfinished", source
        for text in [form.text for form in translation.iter("numerusform")] or [translation.text]:
            assert text, source
            assert sorted(re.findall(r"\{\w+\}|%\d|%n", text)) == sorted(re.findall(r"\{\w+\}|%\d|%n", source)), source


def test_right_to_left_mirrors_the_window(event, qtbot):
    QApplication.instance().setLayoutDirection(Qt.LayoutDirection.RightToLeft)
    begin(event, qtbot)
    QApplication.processEvents()
    assert event.steps.buttons[0].x() > event.steps.buttons[4].x()
    assert event.next.x() < event.back.x()
    form = event.visitor.form
    assert form.name_label.x() > form.name_field.x()


def luminance(colour):
    parts = [
        value / 12.92 if value <= 0.03928 else ((value + 0.055) / 1.055) ** 2.4
        for value in QColor(colour).getRgbF()[:3]
    ]
    return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]


def contrast(one, other):
    high, low = sorted((luminance(one), luminance(other)), reverse=True)
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize(("colours", "least"), [(LIGHT, 4.5), (DARK, 4.5), (CONTRAST, 7.0)])
def test_texts_are_read_on_their_ground(colours, least):
    """WCAG 2.1: 4.5 to 1 for text, 7 to 1 where high contrast is asked for."""
    for text, ground in (
        (colours.text, colours.window), (colours.text, colours.card), (colours.dim, colours.window),
        (colours.dim, colours.card), (colours.on_accent, colours.accent), (colours.warn, colours.warn_back),
        (colours.warn, colours.card), (colours.good, colours.card),
    ):  # fmt: skip
        assert contrast(text, ground) >= least, f"{text} on {ground}"


def test_text_and_buttons_grow(event, qtbot):
    app = QApplication.instance()
    apply_theme(app, "light", big=False, text_percent=100)
    small, points = event.next.sizeHint().height(), app.font().pointSizeF()
    apply_theme(app, "light", big=True, text_percent=150)
    assert app.font().pointSizeF() == pytest.approx(points * 1.5 * 1.25)
    assert event.next.sizeHint().height() >= max(48, 1.4 * small), "a finger needs 48 px"
    assert event.findChildren(QLabel)[0].font().pointSizeF() > points


def test_what_looks_as_wanted_already_is_not_dressed_again(event, monkeypatch):
    """Every dressing polishes all widgets: half a second at the start of a program, and of every test."""
    app = QApplication.instance()
    apply_theme(app, "dark", big=True, text_percent=150)
    polished = []
    monkeypatch.setattr(type(app), "setStyleSheet", lambda _, text: polished.append(text))
    apply_theme(app, "dark", big=True, text_percent=150)
    assert polished == []
    apply_theme(app, "light", big=True, text_percent=150)
    assert len(polished) == 1
