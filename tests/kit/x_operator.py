"""An operator takes visitors from *New visitor* to the take-away, by an X server's mouse and keyboard alone.

``python -m kit.x_operator ROOM LANGUAGES WAYS PICTURES [real]`` inside an X server prints a line of JSON for each walk:
with files, with a camera's folder, or both ("files,camera"), in each language. ROOM holds ``photos`` and ``camera``;
PICTURES is where the pages' pictures go, "-" for none. With "real" the nets, the clone and the copies are real.
"""

from __future__ import annotations

import json
import shutil
import sys
import time
from dataclasses import asdict
from pathlib import Path
from typing import Any

from kit.x_hands import Hands, seen

STICK = "stick"


def services() -> Any:
    """Return the stand-ins of the killed walks, without their slowness."""
    from dataclasses import replace

    from cloner.booth.handover.handing import hand_over
    from kit import outside_walk

    def light(result: Path, target: Path, formats: Any, progress: Any) -> Path:
        return hand_over(result, target, ("ply",), progress)

    return replace(outside_walk.services(), hand_over=light)


class Walk:
    """One window and the hands at it."""

    def __init__(self, room: Path, pictures: Path | None, *, real: bool) -> None:
        from PySide6.QtWidgets import QApplication

        from cloner_gui.event.effort import ClickCounter
        from cloner_gui.event.services import process_services
        from cloner_gui.event.session import Session
        from cloner_gui.main_window import MainWindow

        self.app = QApplication([])
        self.room, self.pictures = room, pictures
        self.window = MainWindow(Session(process_services() if real else services()))
        self.counter = ClickCounter(self.window.booth)
        self.app.installEventFilter(self.counter)
        self.window.setGeometry(self.app.primaryScreen().availableGeometry())
        self.window.show()
        self.hands = Hands(self.app)
        self.hands.settle(0.4)
        (room / "fair").mkdir(exist_ok=True)
        self.window.booth.open(room / "fair")

    def take(self, how: str, language: str) -> dict[str, Any]:
        """Take one visitor all the way and return what it cost; ``how``: "files" or "camera"."""
        from cloner.booth.visitors.visits import read_visit
        from kit.x_hands import Done

        window, hands, session = self.window, self.hands, self.window.session
        self.how = how
        window.booth.change(language=language, camera_folder=str(self.room / "camera") if how == "camera" else "")
        hands.focus(window)
        hands.settle(0.4)
        hands.done, begun = Done(), time.monotonic()
        hands.click(seen((window.visitor.new_button, window.next)))  # after a walk the main button is that
        hands.wait(lambda: session.folder is not None and window.booth._opening is None, "a new visitor")
        hands.settle(0.2)
        hands.write("anna")
        hands.strike("Return")
        hands.write("158")
        self.picture(f"{language}_1")
        hands.click(window.visitor.form.agree_button)
        folder = session.folder
        self._bring_photos(how)
        hands.wait(lambda: len(session.photos.photos) >= 3 and not window.booth.intake.pending(), "photos")
        hands.wait(window.next.isEnabled, "the next step")
        hands.settle(0.4)
        self.picture(f"{language}_2")
        hands.click(window.next)
        hands.wait(lambda: session.outcome is not None and not session.busy, "the clone")
        hands.settle(0.5)
        self.picture(f"{language}_4")
        hands.click(window.next)
        page = hands.done.clicks
        hands.settle(0.5)
        hands.wait(lambda: window.takeaway.sticks.copy_button.isVisible(), "a stick")
        self.picture(f"{language}_5")
        hands.click(window.takeaway.sticks.copy_button)
        hands.wait(lambda: not window.takeaway.handing.busy, "the copy")
        name, height, consent = window.booth.person()
        window.booth.note_effort()
        told = {
            "how": how, "language": language, "to_takeaway": page, **asdict(hands.done),
            "wall_s": round(time.monotonic() - begun, 1), "window_counted": read_visit(folder).clicks,
            "name": name, "height": height, "agreed": bool(consent), "photos": len(session.photos.photos),
            "on_stick": sorted(path.name for path in (self.room / STICK / folder.name).rglob("*.*")),
        }  # fmt: skip
        if self.pictures is not None and how == "files":
            self._picture_the_rest(language)
        return told

    def _bring_photos(self, how: str) -> None:
        """Choose the files in the dialog, or let the camera drop them."""
        from PySide6.QtCore import QTimer
        from PySide6.QtWidgets import QApplication, QFileDialog, QListView, QTreeView

        window, hands = self.window, self.hands
        hands.settle(0.3)
        if how == "camera":
            for number, path in enumerate(sorted((self.room / "photos").iterdir())):
                shutil.copy(path, self.room / "camera" / f"DSC_{time.time_ns()}_{number}{path.suffix}")
            return

        def choose() -> None:  # while the dialog has a loop of its own
            dialog = QApplication.activeModalWidget()
            if not isinstance(dialog, QFileDialog):
                QTimer.singleShot(50, choose)
                return
            hands.settle(0.3)
            files = seen(dialog.findChildren(QTreeView, "treeView") + dialog.findChildren(QListView, "listView"))
            first = files.visualRect(files.model().index(0, 0, files.rootIndex())).center()
            hands.click(files.viewport(), first)
            hands.focus(dialog)
            hands.strike("Control_L+a", "Return")

        QTimer.singleShot(50, choose)
        hands.click(window.photos.add_button)

    def picture(self, name: str) -> None:
        """Keep what is seen."""
        if self.pictures is not None and self.how == "files":
            self.window.grab().save(str(self.pictures / f"{_pixels(self.app)}_{name}.png"))

    def _picture_the_rest(self, language: str) -> None:
        """Keep what this walk did not pass: points, and every window beside."""
        from cloner_gui.pages.gallery import GalleryWindow
        from cloner_gui.pages.settings import SettingsWindow
        from cloner_gui.pages.stage import StageWindow

        window = self.window
        window.go(2)
        self.hands.settle(1.0)
        self.picture(f"{language}_3")
        for number, kind in enumerate((GalleryWindow, SettingsWindow, StageWindow), start=6):
            one = kind(window.booth, window)
            one.show()
            self.hands.settle(0.8)
            one.grab().save(str(self.pictures / f"{_pixels(self.app)}_{language}_{number}.png"))
            one.close()
        window.go(4)
        self.hands.settle()


def _pixels(app: Any) -> int:
    """Return the screen's width in its own pixels: two screens of one width in points are two pictures."""
    screen = app.primaryScreen()
    return round(screen.size().width() * screen.devicePixelRatio())


def main() -> None:
    room, languages, ways, pictures, *rest = sys.argv[1:]
    import cloner_gui.widgets.stick_row

    cloner_gui.widgets.stick_row.MOUNTS = Path(room) / "mountinfo"
    walk = Walk(Path(room), None if pictures == "-" else Path(pictures), real="real" in rest)
    for language in languages.split(","):
        for how in ways.split(","):
            sys.stdout.write(json.dumps(walk.take(how, language)) + "\n")
            sys.stdout.flush()
    walk.window.close()


if __name__ == "__main__":
    main()
