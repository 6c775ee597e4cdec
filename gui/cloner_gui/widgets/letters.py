"""Mnemonics (Alt and a letter): unique among the visible controls, in every language.

Translators underline the letter they like best; where two like the same one the later control gets another of its own.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractButton, QLabel, QMenu, QMenuBar, QWidget

Lettered = QAction | QAbstractButton | QLabel


def assign_mnemonics(texts: Sequence[str], taken: Iterable[str] = ()) -> list[str]:
    """Return texts with one letter each marked by "&", no letter twice.

    Parameters
    ----------
    texts : sequence of str
        Those without an "&" get none.
    taken : iterable of str
        Letters that belong to others.
    """
    used = {one.casefold() for one in taken}
    given: list[str] = []
    for text in texts:
        wanted, plain = mnemonic_of(text), text.replace("&", "", 1)
        starts = [at for at, one in enumerate(plain) if at == 0 or plain[at - 1] in " -"]
        places = [text.find("&"), *starts, *range(len(plain))] if wanted else []
        free = (at for at in places if 0 <= at < len(plain) and plain[at].isalnum())
        at = next((at for at in free if plain[at].casefold() not in used), None)
        if at is not None:
            used.add(plain[at].casefold())
        given.append(text if not wanted else plain if at is None else f"{plain[:at]}&{plain[at:]}")
    return given


def escape_mnemonic(text: str) -> str:
    """Return a text, such as a folder's name, that a control shows unchanged, without a mnemonic."""
    return text.replace("&", "&&")


def without_mnemonic(text: str) -> str:
    """Return a control's text without its mnemonic mark, as a screen reader says it."""
    return text.replace("&", "")


def mnemonic_of(text: str) -> str:
    """Return the mnemonic of a text, "" if there is none."""
    at = text.replace("&&", "  ").find("&")
    return text[at + 1 : at + 2].casefold() if at >= 0 else ""


def assign_to_page(bar: QMenuBar, frame: Sequence[Lettered], page: QWidget) -> None:
    """Give every menu, control of the frame and visible control of the page a mnemonic."""
    titles = bar.actions()
    _give([*titles, *frame, *with_mnemonics(page)])
    for title in titles:
        assign_to_menu(title.menu())


def assign_to_menu(menu: object) -> None:
    """Give every entry of a menu and its submenus a mnemonic."""
    if isinstance(menu, QMenu):
        entries = [one for one in menu.actions() if not one.isSeparator()]
        _give(entries)
        for one in entries:
            assign_to_menu(one.menu())


def assign_to_dialog(dialog: QWidget) -> None:
    """Give every control of a dialog a mnemonic."""
    _give(with_mnemonics(dialog))


def with_mnemonics(widget: QWidget) -> list[Lettered]:
    """Return the controls in a widget whose texts have a mnemonic, from top to bottom."""
    found: list[Lettered] = []
    for one in widget.findChildren(QWidget):
        if isinstance(one, QAbstractButton | QLabel) and mnemonic_of(one.text()):
            if isinstance(one, QAbstractButton) or one.buddy() is not None:
                found.append(one)
    return found


def _give(controls: Sequence[Lettered]) -> None:
    for control, text in zip(controls, assign_mnemonics([one.text() for one in controls]), strict=True):
        if control.text() != text:
            control.setText(text)
