"""Questions that need an answer, and errors that escape from everywhere else."""

from __future__ import annotations

import logging
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from types import TracebackType

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from cloner.errors import ClonerError
from cloner.personal_data.holdings import holding_of
from cloner.personal_data.privacy import export_data
from cloner_gui.event.booth import Booth
from cloner_gui.language.words import translate

log = logging.getLogger(__name__)


def ask_to_forget(booth: Booth, folders: Sequence[Path], parent: QWidget) -> QMessageBox | None:
    """Ask whether visitors are deleted with everything derived, and do it; None if that is not allowed."""
    if not booth.allowed():
        return None
    names = ", ".join(booth.name_of(folder) for folder in folders[:8]) + (", …" if len(folders) > 8 else "")
    text = translate("privacy", "Delete {names} with all photos, points and clones?").format(names=names)
    box = QMessageBox(QMessageBox.Icon.Warning, translate("privacy", "Delete"), text, parent=parent)
    box.setInformativeText(translate("privacy", "Nothing of it can be brought back. Files on sticks stay."))
    delete = box.addButton(translate("privacy", "Delete for good"), QMessageBox.ButtonRole.DestructiveRole)
    box.setDefaultButton(box.addButton(QMessageBox.StandardButton.Cancel))
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)

    def answered() -> None:
        if box.clickedButton() is delete:
            booth.forget(*folders)

    box.finished.connect(answered)
    box.open()
    return box


def ask_to_save_data(booth: Booth, folder: Path, parent: QWidget) -> None:
    """Ask for a zip file and write everything that is stored of a visitor into it."""
    if not booth.allowed():
        return
    text = translate("privacy", "Save everything held of {name}").format(name=booth.name_of(folder))
    target, _ = QFileDialog.getSaveFileName(parent, text, f"{folder.name}-data.zip", "Zip (*.zip)")
    if not target:
        return
    path = Path(target).with_suffix(".zip")
    try:
        path.unlink(missing_ok=True)  # the dialog asked already
        export_data(holding_of(folder.name, folder, None), path)
    except (ClonerError, OSError) as error:
        told = error if isinstance(error, ClonerError) else unexpected(error)
        booth.failed.emit(told)


def catch_everything(tell: Callable[[ClonerError], None]) -> None:
    """Report errors that escape from a slot; otherwise Qt would only print them."""

    def hook(kind: type[BaseException], value: BaseException, trace: TracebackType | None) -> None:
        log.error("unexpected error", exc_info=(kind, value, trace))
        tell(value if isinstance(value, ClonerError) else unexpected(value))

    sys.excepthook = hook


def unexpected(value: BaseException) -> ClonerError:
    """Return what is told of a defect of the program."""
    message = f"something went wrong that the program did not expect ({type(value).__name__})"
    return ClonerError(message, "Go on; if it happens again, send the log file", "Cloner")
