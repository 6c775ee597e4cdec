"""Start Qt, catch what escapes, show the window."""

from __future__ import annotations

import signal
import sys
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QEvent, QObject, QTimer
from PySide6.QtWidgets import QApplication

from cloner_gui.dialogs import catch_everything
from cloner_gui.effort import ClickCounter
from cloner_gui.logs import log_to
from cloner_gui.main_window import MainWindow
from cloner_gui.services import Services, process_services
from cloner_gui.session import Session


def run_app(folder: Path | None = None, services: Services | None = None) -> int:
    """Open the window and return the exit code when it closes.

    Parameters
    ----------
    folder : Path or None
        The event's folder, or one visitor's, to open at once.
    services : Services or None
        None does the work in processes of its own.
    """
    app = QApplication.instance() or QApplication(sys.argv[:1])
    app.setApplicationName("Cloner")
    signal.signal(signal.SIGINT, lambda *_: app.quit())
    waker = QTimer()  # Python sees signals only while its own code runs
    waker.timeout.connect(lambda: None)
    waker.start(200)
    session = Session(services or process_services())
    window = MainWindow(session)
    window.menus.follow()
    catch_everything(window.notice.tell)
    counter = ClickCounter(window.booth)
    app.installEventFilter(counter)
    window.show()
    QTimer.singleShot(0, session.services.start)
    if folder is not None:
        QTimer.singleShot(0, lambda: begin(window, folder))
    code = app.exec()
    window.booth.close()
    waker.stop()
    app.removeEventFilter(counter)
    _delete(window, session, counter)
    return int(code)


def begin(window: MainWindow, folder: Path) -> None:
    """Open a folder, with its log, and ask about visitors whose time is over."""
    if folder.is_dir():
        log_to(folder)
    window.booth.open(folder)
    window.sweep()


def _delete(*objects: QObject) -> None:
    """Delete Qt objects now, while the application stands.

    Left to Python's exit they go in any order, some after the application: a crash now and then.
    """
    QCoreApplication.processEvents()  # what a thread still had to say
    for one in objects:
        one.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
