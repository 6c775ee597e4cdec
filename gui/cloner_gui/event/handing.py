"""Files on their way to the visitor's stick, in the background."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, Signal

from cloner_gui.background.worker import Task
from cloner_gui.event.session import Session
from cloner_gui.language.words import step_text, translate


class Handing(QObject):
    """Writes the chosen formats to a place, one job at a time.

    Parameters
    ----------
    session : Session
        Whose clone it is.
    """

    changed = Signal()
    failed = Signal(object)

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._task: Task | None = None
        self.step, self.fraction = "", 0.0
        self.target: Path | None = None
        self._stopped = False

    @property
    def busy(self) -> bool:
        """Whether files are being written."""
        return self._task is not None

    def told(self) -> str:
        """Return what became of the files."""
        if self.busy:
            return step_text(self.step) + "…" if self.step else translate("takeaway", "Writing the files…")
        if self.target is not None:
            place = f"{self.target.parent.name}/{self.target.name}"
            return translate("takeaway", "Written and read back: {place}").format(place=place)
        if self._stopped:
            return translate("takeaway", "Stopped: nothing of it was left there.")
        return translate("takeaway", "Choose what the visitor takes home.")

    def start(self, target: Path, formats: tuple[str, ...]) -> None:
        """Write the open visitor's clone to a new folder or zip file."""
        outcome = self._session.outcome
        if self.busy or outcome is None:
            return
        services, result = self._session.services, outcome.folder
        self._task = Task(lambda progress: services.hand_over(result, target, formats, progress))
        self.step, self.fraction, self.target, self._stopped = "", 0.0, None, False
        self._task.stopped.connect(self._note_stop)
        self._task.progressed.connect(self._tell)
        self._task.succeeded.connect(self._take)
        self._task.failed.connect(self.failed)
        self._task.finished.connect(self._done)
        self._task.start()
        self.changed.emit()

    def forget(self) -> None:
        """Forget where the last visitor's files went."""
        self.target, self._stopped = None, False

    def stop(self) -> None:
        """Stop at once; what was begun is removed again."""
        if self._task is not None:
            self._task.cancel()

    def close(self) -> None:
        """Stop, and wait for it."""
        if self._task is not None:
            self._task.cancel()
            self._task.wait()

    def _tell(self, step: str, fraction: float) -> None:
        if step:
            self.step, self.fraction = step, fraction
            self.changed.emit()

    def _take(self, target: Path) -> None:
        self.target = target

    def _note_stop(self) -> None:
        self._stopped = True

    def _done(self) -> None:
        self._task = None
        self.changed.emit()
