"""Walks a visitor through the window in a process of its own, and tells every step, to be killed at any moment.

``python -m kit.walker EVENT PHOTOS`` prints one line of JSON after every step: what the window then knew. The long jobs
are stand-ins that leave the same files as the real ones.
"""

from __future__ import annotations

import hashlib
import json
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np

VIEWS = ("body_front", "body_side", "face_front")


def services():
    """Return fast stand-ins that write what the real jobs write."""
    from cloner.booth.opened import read_cloned
    from cloner.booth.photos.photo_files import view_of_name
    from cloner.booth.photos.photo_problems import PhotoCheck
    from cloner.evaluate.truths.baselines import generic_clone
    from cloner.frames import ViewId
    from cloner.generic.load import load_generic
    from cloner.project.atomic import result_folder
    from cloner.project.clone_file import save_clone
    from cloner.project.corrections import WHERE
    from cloner.project.folder import load_photo, view_files
    from cloner.project.results import file_digest
    from cloner.records.photos import PhotoSet
    from cloner.records.points import ViewPoints
    from cloner_gui.event.services import Services

    def check_photo(path, wanted, progress):
        digest = hashlib.sha256(path.read_bytes()).hexdigest()
        return PhotoCheck(digest, wanted or view_of_name(path.name), ())

    def propose(folder, photos, progress):
        where = np.array([[30.0, 40.0], [50.0, 60.0]])
        none = np.zeros(2, bool)
        return {view: ViewPoints(view, ("nose_tip", "toe_left"), where, none * 1.0, none) for view in photos.photos}

    def clone(folder, formats, progress, show):
        photos = PhotoSet({view: load_photo(path, view) for view, path in view_files(folder).items()})
        with result_folder(folder / "clones", folder.name) as room:
            save_clone(generic_clone(load_generic(), 1.7), room / "clone.npz")
            stamp = {"photos": {str(view): photo.digest for view, photo in photos.photos.items()}}
            obeyed = folder / WHERE
            stamp["beside"] = {WHERE: file_digest(obeyed)} if obeyed.is_file() else {}
            (room / "report.json").write_text(json.dumps({"stamp": stamp, "warnings": []}))
            progress("textures", 0.9)
        return read_cloned(folder, photos), 1.0

    def hand_over(result, target, formats, progress):
        raise NotImplementedError

    assert ViewId
    return Services(check_photo=check_photo, propose=propose, clone=clone, hand_over=hand_over)


def known(window) -> dict:
    """Return what the window knows of the event, as JSON values."""
    session, booth = window.session, window.booth
    points = {
        str(view): {name: [point.x_px, point.y_px] for name, point in sorted(named.items())}
        for view, named in sorted(session.corrections.points.items())
        if named
    }
    name, height, consent = booth.person()
    return {
        "visitors": sorted(folder.name for folder in booth.visits()),
        "open": None if session.folder is None else session.folder.name,
        "page": window.stack.currentIndex(),
        "name": name,
        "height": height,
        "agreed": bool(consent),
        "photos": sorted(photo.digest for photo in session.photos.photos.values()),
        "points": points,
        "cloned": session.outcome is not None,
    }


def steps(window, photos: Path, wait) -> Iterator[str]:
    """Yield after every step of the path."""
    from cloner.frames import ViewId

    booth, session = window.booth, window.session
    for number in range(2):
        booth.new_visitor()
        wait(lambda: booth._opening is None and session.folder is not None)
        yield "new"
        window.visitor.form.name_field.setText(f"Guest {number}")
        window.visitor.form.save()
        yield "name"
        window.visitor.form.height_field.set_height(150.0 + number)
        window.visitor.form.save()
        yield "height"
        window.visitor.form.consent_box.click()
        yield "consent"
        window.show_page(window.photos)
        yield "photos page"
        for view in VIEWS:
            booth.intake.add_files([photos / f"{view}.jpg"])
            wait(lambda: booth.intake.pending() == 0)
            yield view
        window.show_page(window.points)
        wait(lambda: bool(session.proposed) and not session.busy)  # a busy session clones nobody
        yield "points page"
        for move in range(6):
            session.place_point(ViewId.BODY_FRONT, "nose_tip", 40.0 + move, 50.0, gesture=f"{number}")
            yield "drag"
        session.place_point(ViewId.FACE_FRONT, "toe_left", 20.0, 21.0)
        yield "second point"
        session.undo_stack.undo()
        yield "undo"
        window.show_page(window.clone)
        yield "clone page"
        session.clone()
        wait(lambda: session.outcome is not None and not session.busy)
        yield "cloned"
        window.show_page(window.takeaway)
        yield "take away"


def main() -> None:
    from PySide6.QtWidgets import QApplication

    from cloner_gui.event.session import Session
    from cloner_gui.main_window import MainWindow

    app = QApplication([])

    def wait(done):
        end = time.monotonic() + 60.0
        while not done():
            if time.monotonic() > end:
                raise TimeoutError
            app.processEvents()
            time.sleep(0.002)

    window = MainWindow(Session(services()))
    window.show()
    window.booth.open(Path(sys.argv[1]))
    sys.stdout.write("ready\n")
    sys.stdout.flush()
    for step in steps(window, Path(sys.argv[2]), wait):
        sys.stdout.write(json.dumps({"step": step, **known(window)}) + "\n")
        sys.stdout.flush()
    window.booth.close()


if __name__ == "__main__":
    main()
