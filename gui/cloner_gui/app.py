"""Starts Qt, catches escaping errors, shows the window."""

from __future__ import annotations

import importlib
import signal
import sys
import threading
from pathlib import Path
from types import FrameType
from typing import Final

from PySide6.QtCore import QCoreApplication, QEvent, QObject, QStandardPaths, QTimer
from PySide6.QtWidgets import QApplication

from cloner.booth.events.event import Event
from cloner.booth.events.recent import RECENT_FILE
from cloner_gui.background.newest import shared_latest
from cloner_gui.background.tidying import GarbageCollector
from cloner_gui.background.worker import stop_all_tasks
from cloner_gui.dialogs import catch_everything
from cloner_gui.event.effort import ClickCounter
from cloner_gui.event.services import Services, process_services
from cloner_gui.event.session import Session
from cloner_gui.main_window import MainWindow
from cloner_gui.theme import apply_theme

#: Exit code of a program that was asked to end, 128 + SIGINT as shells have it.
STOPPED: Final = 130


def run_app(folder: Path | None = None, services: Services | None = None) -> int:
    """Open the window and return the exit code when it closes.

    Parameters
    ----------
    folder : Path or None
        The event's folder, or one visitor's, to open at once.
    services : Services or None
        None does the work in processes of its own.
    """
    app = QApplication.instance()
    if not isinstance(app, QApplication):
        app = QApplication(sys.argv[:1])
    app.setApplicationName("Cloner")
    stopped = _quit_on_signals(app)
    waker = QTimer()  # Python sees signals only while its own code runs
    waker.timeout.connect(lambda: None)
    waker.start(200)
    usual = Event()
    apply_theme(
        app, usual.appearance, big=usual.big, text_percent=usual.text_percent
    )  # before there are widgets to polish
    tidier = GarbageCollector()
    session = Session(services or process_services())
    window = MainWindow(session)
    window.menus.follow()
    kept = QStandardPaths.writableLocation(QStandardPaths.StandardLocation.AppConfigLocation)
    window.visitor.recent.follow(Path(kept) / RECENT_FILE)
    catch_everything(window.notice.tell)
    counter = ClickCounter(window.booth)
    app.installEventFilter(counter)
    window.show()
    QTimer.singleShot(0, session.services.start)
    loader = threading.Thread(target=preload_pages)
    QTimer.singleShot(0, loader.start)
    if folder is not None:
        QTimer.singleShot(0, lambda: window.open_folder(folder))
    code = app.exec()
    window.close()  # nobody closes it where the application was told to quit
    if loader.ident is not None:
        loader.join()
    waker.stop()
    tidier.stop()
    app.removeEventFilter(counter)
    _delete(window, session, counter, tidier)
    return STOPPED if stopped else int(code)


def _quit_on_signals(app: QCoreApplication) -> list[int]:
    """Close the window tidily when the system or a terminal asks for it; the list gets the signals that came.

    An exception instead would be raised in whichever slot or event filter runs just then, and be lost there.
    """
    came: list[int] = []

    def close(number: int, frame: FrameType | None) -> None:
        came.append(number)
        app.quit()

    for name in ("SIGINT", "SIGTERM", "SIGHUP"):
        if hasattr(signal, name):  # Windows has no SIGHUP
            signal.signal(getattr(signal, name), close)
    return came


def preload_pages() -> None:
    """Import what the later pages need while the operator looks at the first one."""
    for module in (
        "cloner_gui.pages.points",
        "cloner_gui.pages.clone",
        "cloner_gui.canvas.clones.greeting",
        "cloner.interactive.refitting",
    ):
        importlib.import_module(module)


def _delete(*objects: QObject) -> None:
    """Delete Qt objects now, while the application stands.

    Left to Python's exit they go in any order, some after the application: a crash now and then.
    """
    QCoreApplication.processEvents()  # what a thread still had to say
    stop_all_tasks()  # and what that has begun
    shared_latest().close()
    for one in objects:
        one.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
