"""Walks visitors through the window while a camera drops photos, a telephone is served and files go to a stick.

``python -m kit.outside_walk EVENT STICK`` prints a line of JSON for everything that the window holds to be safe, in the
moment it does: whoever kills it may look for that. Who plays camera and telephone reads "agreed" and "link" there.
"""

from __future__ import annotations

import hashlib
import json
import sys
import time
from dataclasses import replace
from pathlib import Path

PHOTOS_EACH = 3
VISITORS = 2


def say(what: str, visitor: str = "", value: object = None) -> None:
    """Tell that something is safe by now."""
    sys.stdout.write(json.dumps({"what": what, "visitor": visitor, "value": value}) + "\n")
    sys.stdout.flush()


def services():
    """Return the walker's stand-ins, with the real handing over, slowed as a stick is."""
    from cloner.booth.handover.handing import hand_over
    from cloner.booth.photos.photo_problems import PhotoCheck
    from cloner.frames import ViewId
    from cloner.project.folder import view_files
    from kit import walker

    def check_photo(path, wanted, progress):
        """Say that a photo shows the first view that has none yet."""
        free = [view for view in walker.VIEWS if ViewId(view) not in view_files(path.parents[1])]
        digest = hashlib.sha256(path.read_bytes()).hexdigest()
        return PhotoCheck(digest, wanted or (ViewId(free[0]) if free else None), ())

    def slow(result, target, formats, progress):
        def tell(step, fraction):
            time.sleep(0.04)
            progress(step, fraction)

        return hand_over(result, target, ("ply",), tell)

    return replace(walker.services(), check_photo=check_photo, hand_over=slow)


def stored(folder: Path) -> list[str]:
    """Return the digests of all photos that lie in a visitor's folder, wherever they found their place."""
    inside = [*folder.glob("*.jpg"), *folder.glob("unsorted/*.jpg")]
    return sorted(hashlib.sha256(path.read_bytes()).hexdigest() for path in inside if not path.name.startswith("."))


def walk(window, stick: Path, wait) -> None:
    """Take the visitors all the way."""
    from cloner.frames import ViewId

    booth, session = window.booth, window.session
    for number in range(VISITORS):
        booth.new_visitor()
        wait(lambda: booth._opening is None and session.folder is not None)
        folder = session.folder
        say("new", folder.name)
        form = window.visitor.form
        form.name_field.setText(f"Guest {number}")
        form.save()
        say("name", folder.name, f"Guest {number}")
        form.height_field.set_height(150.0 + number)
        form.save()
        say("height", folder.name, 150.0 + number)
        form.consent_box.click()
        say("agreed", folder.name, session.consent)
        window.show_page(window.photos)
        seen: list[str] = []
        while len(seen) < PHOTOS_EACH:
            wait(lambda: stored(folder) != seen)  # noqa: B023
            seen = stored(folder)
            say("photos", folder.name, seen)
        wait(lambda: len(session.photos.photos) == PHOTOS_EACH and not booth.intake.pending())
        window.show_page(window.points)
        wait(lambda: bool(session.proposed) and not session.busy)
        for move in range(6):
            session.place_point(ViewId.BODY_FRONT, "nose_tip", 20.0 + move, 50.0, gesture=f"{number}")
            say("point", folder.name, 20.0 + move)
        window.show_page(window.clone)
        session.clone()
        wait(lambda: session.outcome is not None and not session.busy)
        say("cloned", folder.name)
        window.show_page(window.takeaway)
        wait(lambda: bool(window.phone.link()))
        say("link", folder.name, window.phone.link())
        window.takeaway._to_stick(_Stick(stick))
        say("copying", folder.name)
        wait(lambda: not window.takeaway.handing.busy)
        say("copied", folder.name)


class _Stick:
    """As much of a stick as the page asks for."""

    def __init__(self, mount: Path) -> None:
        self.mount = mount


def main() -> None:
    """Walk, in the process that is killed."""
    from PySide6.QtWidgets import QApplication

    import cloner_gui.event.phone
    from cloner.booth.phone import parcel
    from cloner_gui.event.session import Session
    from cloner_gui.main_window import MainWindow

    cloner_gui.event.phone.own_addresses = lambda: ("127.0.0.1",)
    cloner_gui.event.phone.PORT = 0
    parcel.SIZE_PX = parcel.LARGE_PX = (24, 36)
    app = QApplication([])

    def wait(done):
        end = time.monotonic() + 120.0
        while not done():
            if time.monotonic() > end:
                raise TimeoutError
            app.processEvents()
            time.sleep(0.002)

    window = MainWindow(Session(services()))
    window.show()
    window.booth.open(Path(sys.argv[1]))
    say("ready")
    walk(window, Path(sys.argv[2]), wait)
    window.close()


if __name__ == "__main__":
    main()
