"""The window's languages: Qt's translators for the files beside this one."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from pathlib import Path
from typing import Final

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QTranslator

from cloner_gui.language.words import CONSENT, CONSENT_KEPT

LANGUAGE_NAMES: Final = {"en": "English", "de": "Deutsch", "fr": "Français", "tr": "Türkçe"}
FOLDER: Final = Path(__file__).parents[1] / "translations"


@functools.cache
def translator_of(code: str) -> QTranslator:
    """Return the translator of a language; an empty one for English, the source language."""
    made = QTranslator()
    if code != "en":
        made.load(str(FOLDER / f"cloner_{code}.qm"))
    return made


@functools.cache
def qt_translator_of(code: str) -> QTranslator:
    """Return the translator of Qt's own texts: Save, Cancel, and file dialogs."""
    made = QTranslator()
    if code != "en":
        made.load(f"qtbase_{code}", QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath))
    return made


def set_language(code: str) -> None:
    """Set the whole program's language; every widget gets a LanguageChange event."""
    for other in LANGUAGE_NAMES:
        QCoreApplication.removeTranslator(translator_of(other))
        QCoreApplication.removeTranslator(qt_translator_of(other))
    if code != "en":
        QCoreApplication.installTranslator(qt_translator_of(code))
        QCoreApplication.installTranslator(translator_of(code))


def consent_text(code: str, days: int, own: Mapping[str, str]) -> str:
    """Return what visitors agree to in the visitor's language, whatever the window's language is.

    Parameters
    ----------
    code : str
        The language.
    days : int
        For how long visitors are kept; 0 until somebody deletes them.
    own : mapping of str to str
        The event's own texts by language; "{days}" in them stands for the days.
    """
    usual = CONSENT if days else CONSENT_KEPT
    text = own.get(code, "").strip() or translator_of(code).translate("consent", usual) or usual
    return text.replace("{days}", str(days))
