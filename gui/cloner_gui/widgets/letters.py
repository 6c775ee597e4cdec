"""Letters that are pressed with Alt: each stands for one control only of what is seen, in every language.

Translators underline the letter they like best; where two like the same one the later control gets another of its own.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractButton, QLabel, QMenu, QMenuBar, QWidget

Lettered = QAction | QAbstractButton | QLabel


def assign(texts: Sequence[str], taken: Iterable[str] = ()) -> list[str]:
    """Return texts with one letter each underlined ("&" before it), no letter twice.

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
        wanted, plain = letter_of(text), text.replace("&", "", 1)
        starts = [at for at, one in enumerate(plain) if at == 0 or plain[at - 1] in " -"]
        places = [text.find("&"), *starts, *range(len(plain))] if wanted else []
        free = (at for at in places if 0 <= at < len(plain) and plain[at].isalnum())
        at = next((at for at in free if plain[at].casefold() not in used), None)
        if at is not None:
            used.add(plain[at].casefold())
        given.append(text if not wanted else plain if at is None else f"{plain[:at]}&{plain[at:]}")
    return given


def literal(text: str) -> str:
    """Return a text, as a folder's name, so that a control shows it as it is, with no letter underlined."""
    return text.replace("&", "&&")


def unmarked(text: str) -> str:
    """Return a control's text without the mark of its letter, as it is read aloud."""
    return text.replace("&", "")


def letter_of(text: str) -> str:
    """Return the underlined letter of a text, "" where there is none."""
    at = text.replace("&&", "  ").find("&")
    return text[at + 1 : at + 2].casefold() if at >= 0 else ""


def settle(bar: QMenuBar, frame: Sequence[Lettered], page: QWidget) -> None:
    """Give every menu, control of the frame and control of the page that is seen a letter of its own."""
    titles = bar.actions()
    _give([*titles, *frame, *lettered_in(page)])
    for title in titles:
        settle_menu(title.menu())


def settle_menu(menu: object) -> None:
    """Give every entry of a menu, and of the menus in it, a letter of its own."""
    if isinstance(menu, QMenu):
        entries = [one for one in menu.actions() if not one.isSeparator()]
        _give(entries)
        for one in entries:
            settle_menu(one.menu())


def settle_dialog(dialog: QWidget) -> None:
    """Give every control of a dialog a letter of its own."""
    _give(lettered_in(dialog))


def lettered_in(widget: QWidget) -> list[Lettered]:
    """Return the controls in a widget whose texts have an underlined letter, from top to bottom."""
    found: list[Lettered] = []
    for one in widget.findChildren(QWidget):
        if isinstance(one, QAbstractButton | QLabel) and letter_of(one.text()):
            if isinstance(one, QAbstractButton) or one.buddy() is not None:
                found.append(one)
    return found


def _give(controls: Sequence[Lettered]) -> None:
    for control, text in zip(controls, assign([one.text() for one in controls]), strict=True):
        if control.text() != text:
            control.setText(text)
