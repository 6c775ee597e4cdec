"""Start Qt, install the error dialog, show the window."""

from __future__ import annotations

import signal
import sys
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QEvent, QObject, QTimer
from PySide6.QtWidgets import QApplication

from cloner_gui.dialogs import catch_everything
from cloner_gui.main_window import MainWindow
from cloner_gui.services import Services
from cloner_gui.session import Session


def run_app(folder: Path | None = None) -> int:
    """Open the window and return the exit code when it closes.

    Parameters
    ----------
    folder : Path or None
        Folder of photos to open at once.
    """
    app = QApplication.instance() or QApplication(sys.argv[:1])
    app.setApplicationName("Cloner")
    catch_everything()
    signal.signal(signal.SIGINT, lambda *_: app.quit())
    waker = QTimer()  # Python sees signals only while its own code runs
    waker.timeout.connect(lambda: None)
    waker.start(200)
    session = Session(Services())
    window = MainWindow(session)
    window.show()
    if folder is not None:
        QTimer.singleShot(0, lambda: session.open(folder))
    code = app.exec()
    session.close()
    waker.stop()
    _delete(window, session)
    return int(code)


def _delete(*objects: QObject) -> None:
    """Delete Qt objects now, while the application stands.

    Left to Python's exit they go in any order, some after the application: a crash now and then.
    """
    QCoreApplication.processEvents()  # what a thread still had to say
    for one in objects:
        one.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
