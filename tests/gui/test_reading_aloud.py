"""By keyboard and read aloud: names and roles on every page and in every dialogue, the order of Tab, colours."""

from itertools import pairwise

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QAccessible, QColor, QPalette
from PySide6.QtWidgets import QAbstractSpinBox, QApplication, QComboBox, QLineEdit, QScrollArea, QWidget

from cloner.booth.events.event import LANGUAGES
from cloner.frames import ViewId
from cloner_gui.canvas.photos.webcam import WebcamDialog
from cloner_gui.language.languages import set_language
from cloner_gui.main_window import CLONE, TAKEAWAY
from cloner_gui.pages.gallery import GalleryWindow
from cloner_gui.pages.held import HeldWindow
from cloner_gui.pages.settings import SettingsWindow
from cloner_gui.pages.stage import StageWindow
from cloner_gui.pages.statistics import StatisticsWindow
from cloner_gui.theme import CONTRAST, DARK, LIGHT, apply_theme, palette_of
from cloner_gui.widgets.pieces import Card

from .test_flow import event  # noqa: F401  (a fixture)
from .test_hands import contrast
from .test_visitors_side import cloned

pytestmark = pytest.mark.gui
ROLE = QAccessible.Role
#: Roles by which a screen reader says what can be done; a container or nothing is none.
TELLING = {
    ROLE.Button, ROLE.CheckBox, ROLE.RadioButton, ROLE.ComboBox, ROLE.EditableText, ROLE.SpinBox, ROLE.Slider,
    ROLE.List, ROLE.Table, ROLE.Tree, ROLE.StaticText, ROLE.Graphic, ROLE.ButtonMenu, ROLE.ProgressBar,
    ROLE.ButtonDropDown,
}  # fmt: skip
#: Painted by hand: Qt's Python binding gives them no role of their own, so their description says what keys do.
PAINTED = ("PhotoCard", "TrayCard", "PointCanvas", "PhotoView")
#: What is called the same in several of the languages.
SAME = ("GLB", "VRML", "X3D", "VRM", "OBJ", "PLY", "Zoom")
KEYS = Qt.FocusPolicy.TabFocus


class Still:
    """A camera that shows one grey picture."""

    def read(self):
        return np.full((90, 160, 3), 127, np.uint8)

    def close(self):
        pass


@pytest.fixture
def full(event, qtbot, samples):  # noqa: F811
    """A window with a cloned visitor whose points are known; language and looks are put back."""
    cloned(event, qtbot, samples)
    event.session.propose()
    qtbot.waitUntil(lambda: bool(event.session.proposed) and not event.session.busy)
    yield event
    set_language("en")
    apply_theme(QApplication.instance(), "system", big=False, text_percent=100)


def dialogs(booth):
    """Return a maker of each window beside the main one."""
    return (
        lambda: GalleryWindow(booth), lambda: SettingsWindow(booth), lambda: StatisticsWindow(booth),
        lambda: HeldWindow(booth), lambda: StageWindow(booth), lambda: WebcamDialog(ViewId.FACE_SIDE, make=Still),
    )  # fmt: skip


def spoken(window):
    """Return the controls of a window that take the keyboard and are seen; parts of a field are the field's."""
    inside = (QAbstractSpinBox, QComboBox)
    seen = [one for one in window.findChildren(QWidget) if one.isVisibleTo(window) and one.window() is window.window()]
    return [one for one in seen if one.focusPolicy() & KEYS and not isinstance(one.parentWidget(), inside)]


def named(one):
    """Return what a screen reader calls a control."""
    return QAccessible.queryAccessibleInterface(one).text(QAccessible.Text.Name).replace("&", "")


def is_told(one):
    """Return whether a screen reader says what can be done with a control."""
    if type(one).__name__ in PAINTED:
        return bool(one.accessibleDescription())
    return QAccessible.queryAccessibleInterface(one).role() in TELLING


def everywhere(window):
    """Yield a place and (type, name, whether its role is told) of its controls, for every page and dialogue."""

    def all_of(one):
        return [(type(each).__name__, named(each), is_told(each)) for each in spoken(one)]

    for number in range(TAKEAWAY + 1):
        window.go(number)
        QApplication.processEvents()
        yield f"page {number}", all_of(window)
    for make in dialogs(window.booth):
        dialog = make()
        dialog.show()
        QApplication.processEvents()
        yield type(dialog).__name__, all_of(dialog)
        dialog.close()


def test_every_control_has_a_name_and_a_role_in_every_language(full):
    names = {}
    for code in LANGUAGES:
        full.booth.change(language=code)
        said = dict(everywhere(full))
        assert len(said) == 11
        nameless = {f"{place}: {kind}" for place, those in said.items() for kind, name, _ in those if not name}
        assert nameless == set(), code
        silent = {f"{place}: {kind} {name}" for place, those in said.items() for kind, name, told in those if not told}
        assert silent == set(), code
        names[code] = {name for those in said.values() for _, name, _ in those}
    for code in LANGUAGES[1:]:
        same = {name for name in names[code] & names["en"] if any(one.isalpha() for one in name)}
        assert len([name for name in same if not name.startswith(SAME)]) <= 8, f"{code}: still English? {same}"


def test_every_control_is_reached_by_tab_in_the_order_in_which_it_is_read(full):
    full.resize(1280, 800)
    for number in range(TAKEAWAY + 1):
        full.go(number)
        QApplication.processEvents()
        wanted = {one for one in spoken(full) if one.isEnabled() and one.focusProxy() is None}
        order, one = [], full.nextInFocusChain()
        while one is not full and len(order) < 2000:
            order.append(one)
            one = one.nextInFocusChain()
        reached = [one for one in order if one in wanted]
        assert wanted <= set(reached), f"page {number}: Tab never reaches {wanted - set(reached)}"
        for card in full.stack.currentWidget().findChildren(Card):
            own = [one for one in reached if one is not card and around(one) is card]
            tops = [one.mapTo(card, QPoint(0, one.height() // 2)).y() for one in own]
            upwards = [before - after for before, after in pairwise(tops) if after < before - 20]
            assert not upwards, f"page {number}: Tab goes upwards in {[named(one) for one in own]}"


def around(one):
    """Return the card that a control lies in; what scrolls inside it has an order of its own."""
    one = one.parentWidget()
    while one is not None and not isinstance(one, Card | QScrollArea):
        one = one.parentWidget()
    return one


@pytest.mark.parametrize(("colours", "least"), [(LIGHT, 4.5), (DARK, 4.5), (CONTRAST, 7.0)])
def test_every_pair_of_the_palette_can_be_read(colours, least):
    """WCAG 2.1: 4.5 to 1 for text, also where it is greyed; a ring that shows the keyboard 3 to 1."""
    palette, role = palette_of(colours), QPalette.ColorRole
    for group in (QPalette.ColorGroup.Active, QPalette.ColorGroup.Inactive, QPalette.ColorGroup.Disabled):
        for ink, paper in (
            (role.WindowText, role.Window), (role.Text, role.Base), (role.Text, role.AlternateBase),
            (role.ButtonText, role.Button), (role.HighlightedText, role.Highlight),
            (role.ToolTipText, role.ToolTipBase), (role.PlaceholderText, role.Base), (role.Link, role.Base),
            (role.Link, role.Window),
        ):  # fmt: skip
            told = contrast(palette.color(group, ink), palette.color(group, paper))
            assert told >= least, f"{ink.name} on {paper.name}, {group.name}: {told:.2f}"
    for ink in (colours.good, colours.warn, colours.dim, colours.text):
        for paper in (colours.window, colours.card):
            assert contrast(ink, paper) >= least, f"{ink} on {paper}"
    for paper in (colours.window, colours.card):
        assert contrast(colours.accent, paper) >= 3.0
        assert contrast(colours.dim, paper) >= 3.0, "the edge of a box to tick"


@pytest.mark.parametrize("appearance", ["light", "dark", "contrast"])
def test_what_stands_in_an_empty_field_can_be_read(full, appearance):
    """Qt takes half the text's colour for it where a style sheet does not say."""
    full.booth.change(appearance=appearance)
    settings = SettingsWindow(full.booth)
    settings.show()
    QApplication.processEvents()
    for field in (*full.findChildren(QLineEdit), *settings.findChildren(QLineEdit)):
        field.ensurePolished()
        ink = field.palette().color(QPalette.ColorRole.PlaceholderText)
        paper = field.palette().color(QPalette.ColorRole.Base)
        share = ink.alphaF()
        mixed = [share * i + (1 - share) * p for i, p in zip(ink.getRgbF()[:3], paper.getRgbF()[:3], strict=True)]
        assert contrast(QColor.fromRgbF(*mixed), paper) >= 4.5, field.accessibleName()
    settings.close()


def test_the_preview_is_called_in_the_windows_language(full):
    full.go(CLONE)
    english = full.clone.preview.accessibleName()
    full.booth.change(language="de")
    QApplication.processEvents()
    assert full.clone.preview.accessibleName() not in ("", english)
