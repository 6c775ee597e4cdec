"""The menus, and the settings of the event that they change."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QApplication, QDialog, QMenu

from cloner_gui.language.languages import LANGUAGE_NAMES, set_language
from cloner_gui.language.words import translate
from cloner_gui.theme import apply_theme

if TYPE_CHECKING:
    from cloner_gui.main_window import MainWindow

TEXT_PERCENTS: Final = (100, 125, 150, 200)


class Menus:
    """Event, Edit, View, Operator and Studio.

    Parameters
    ----------
    window : MainWindow
    """

    def __init__(self, window: MainWindow) -> None:
        self._window, self._booth = window, window.booth
        self._menus: list[QMenu] = []
        self._followed: tuple[object, ...] = ()
        stack = window.session.undo_stack
        self.undo = stack.createUndoAction(window)
        self.redo = stack.createRedoAction(window)
        self.undo.setShortcut(QKeySequence.StandardKey.Undo)
        self.redo.setShortcut(QKeySequence.StandardKey.Redo)
        self._booth.event_changed.connect(self.follow)

    def speak(self) -> None:
        """Build all menus in the window's language."""
        bar = self._window.menuBar()
        bar.clear()
        self._menus = [bar.addMenu(title) for title in _titles()]
        event, edit, view, operator, studio = self._menus
        for text, key, act in (
            (translate("menu", "&Open…"), QKeySequence.StandardKey.Open, self._window.choose_folder),
            (translate("menu", "&New visitor"), QKeySequence.StandardKey.New, self._booth.new_visitor),
            (translate("menu", "&Settings…"), None, self._open_settings),
            (translate("menu", "&Quit"), QKeySequence.StandardKey.Quit, self._window.close),
        ):
            self._add(event, text, act, key)
        edit.addActions([self.undo, self.redo])
        self._fill_view(view)
        self._add(view, translate("menu", "&Kiosk (Ctrl+Shift+K)"), lambda: self._window.kiosk.toggle(), None)
        self._add(operator, translate("menu", "&Gallery…"), self._open_gallery, QKeySequence("Ctrl+G"))
        self._add(operator, translate("menu", "&Screen for visitors"), self._open_stage, QKeySequence("Ctrl+D"))
        self._add(operator, translate("menu", "&Effort…"), self._open_statistics, QKeySequence("Ctrl+E"))
        self._add(operator, translate("menu", "&What is held…"), self._open_held, None)
        for text, which in studio_entries():
            self._add(studio, text, functools.partial(self._open_studio, which), None)

    def follow(self) -> None:
        """Look and speak as the event's settings say."""
        settings, app = self._booth.settings, QApplication.instance()
        wanted = (settings.appearance, settings.big, settings.text_percent, settings.language)
        if isinstance(app, QApplication) and wanted != self._followed:
            if wanted[:3] != self._followed[:3]:
                apply_theme(app, settings.appearance, big=settings.big, text_percent=settings.text_percent)
            self._followed = wanted
            set_language(settings.language)
            self.speak()

    def _fill_view(self, menu: QMenu) -> None:
        settings = self._booth.settings
        self._choices(menu.addMenu(translate("menu", "&Language")), LANGUAGE_NAMES, "language", settings.language)
        looks = {
            "system": translate("menu", "As the &desktop"),
            "light": translate("menu", "&Light"),
            "dark": translate("menu", "D&ark"),
            "contrast": translate("menu", "High &contrast"),
        }
        self._choices(menu.addMenu(translate("menu", "&Colours")), looks, "appearance", settings.appearance)
        sizes = {percent: f"{percent} %" for percent in TEXT_PERCENTS}
        self._choices(menu.addMenu(translate("menu", "&Text size")), sizes, "text_percent", settings.text_percent)
        big = self._add(menu, translate("menu", "&Big buttons"), lambda: None, QKeySequence("Ctrl+B"))
        big.setCheckable(True)
        big.setChecked(settings.big)
        big.triggered.connect(lambda on: self._booth.change(big=on))
        full = self._add(menu, translate("menu", "&Full screen"), lambda: None, QKeySequence("F11"))
        full.setCheckable(True)
        full.setChecked(self._window.isFullScreen())
        full.triggered.connect(lambda on: self._window.showFullScreen() if on else self._window.showNormal())

    def _choices(self, menu: QMenu, texts: Any, setting: str, chosen: object) -> None:
        """Fill a menu with exclusive choices of one setting."""
        group = QActionGroup(menu)
        for value, text in texts.items():
            one = menu.addAction(text)
            one.setCheckable(True)
            one.setChecked(value == chosen)
            one.triggered.connect(lambda _, value=value: self._booth.change(**{setting: value}))
            group.addAction(one)

    def _add(self, menu: QMenu, text: str, act: Callable[[], object], key: Any) -> QAction:
        one = menu.addAction(text)
        one.triggered.connect(lambda: act())
        if key is not None:
            one.setShortcut(QKeySequence(key))
        return one

    def _open_statistics(self) -> None:
        from cloner_gui.pages.statistics import StatisticsWindow  # seldom seen: not paid for at every start

        _show(StatisticsWindow(self._booth, self._window))

    def _open_stage(self) -> None:
        from cloner_gui.pages.stage import StageWindow

        stage = StageWindow(self._booth, self._window)
        stage.show()
        if len(QApplication.screens()) > 1:
            stage.fill_screen()

    def _open_gallery(self) -> None:
        from cloner_gui.pages.gallery import GalleryWindow

        _show(GalleryWindow(self._booth, self._window))

    def _open_held(self) -> None:
        from cloner_gui.pages.held import HeldWindow

        _show(HeldWindow(self._booth, self._window))

    def _open_studio(self, which: str) -> None:
        from cloner_gui.studio.windows import window_of

        if self._booth.allowed():
            made = window_of(which)(self._booth, self._window)
            self._window.kiosk.changed.connect(made.close)
            made.show()  # deleted with the main window: deleted on close, glibc found a spoilt heap

    def _open_settings(self) -> None:
        from cloner_gui.pages.settings import SettingsWindow

        _show(SettingsWindow(self._booth, self._window))


def _show(dialog: QDialog) -> None:
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.show()


def studio_entries() -> tuple[tuple[str, str], ...]:
    """Return the studio's windows as its menu offers them: text and name."""
    return (
        (translate("menu", "&Dress a clone…"), "wearing"),
        (translate("menu", "&Body from measures…"), "bodies"),
        (translate("menu", "&Clone in stone…"), "stone"),
        (translate("menu", "&Photograph on a statue…"), "photograph"),
        (translate("menu", "Body of b&lobs…"), "blobs"),
    )


def _titles() -> tuple[str, ...]:
    return (
        translate("menu", "&Event"),
        translate("menu", "&Edit"),
        translate("menu", "&View"),
        translate("menu", "O&perator"),
        translate("menu", "&Studio"),
    )
