"""Pictures of every page of the window, in a real X server: python benchmarks/gui_pictures.py OUT [--event FOLDER].

Takes a sample visitor through the whole path once, with the real nets and the real clone, then reopens the event at
several sizes and looks at every page. Needs Xvfb. ``--docs`` also puts small ones into docs/pictures.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parents[1]
SAMPLE = ROOT / "samples" / "anna" / "plain"
#: Name, screen, scale factor, appearance, big buttons, language.
LOOKS = (
    ("720", "1280x720", "1", "light", False, "en"),
    ("1080", "1920x1080", "1", "light", False, "en"),
    ("200", "1920x1080", "2", "light", False, "en"),
    ("dark", "1280x720", "1", "dark", False, "de"),
    ("contrast", "1280x720", "1", "contrast", False, "tr"),
    ("touch", "1920x1080", "1", "light", True, "fr"),
    ("rtl", "1280x720", "1", "light", False, "en"),
)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path)
    parser.add_argument("--event", type=Path)
    parser.add_argument("--only", default="")
    parser.add_argument("--docs", action="store_true")
    parser.add_argument("--inside", default="")
    options = parser.parse_args()
    if options.inside:
        inside(options.out, options.event, *next(look for look in LOOKS if look[0] == options.inside))
        return
    event = options.event or Path(tempfile.mkdtemp(prefix="event-")) / "fair"
    event.mkdir(parents=True, exist_ok=True)
    options.out.mkdir(parents=True, exist_ok=True)
    for number, look in enumerate(LOOKS):
        if not options.only or look[0] in options.only.split(","):
            in_x_server(options.out, event, look, 90 + number)
    if options.docs:
        for number in range(1, 6):
            small_copy(options.out / f"gui_720_{number}.png", ROOT / "docs" / "pictures" / f"gui_{number}.jpg")
    if options.event is None:
        shutil.rmtree(event.parent)


def small_copy(source: Path, target: Path) -> None:
    from PIL import Image

    target.parent.mkdir(exist_ok=True)
    small = Image.open(source).convert("RGB").resize((960, 540), Image.Resampling.LANCZOS)
    small.save(target, quality=85, optimize=True)


def in_x_server(out: Path, event: Path, look: tuple, display: int) -> None:
    screen, scale = look[1], look[2]
    server = subprocess.Popen(["Xvfb", f":{display}", "-screen", "0", f"{screen}x24"], stderr=subprocess.DEVNULL)
    time.sleep(1.0)
    try:
        environment = {**os.environ, "DISPLAY": f":{display}", "QT_QPA_PLATFORM": "xcb", "QT_SCALE_FACTOR": scale}
        command = [sys.executable, __file__, str(out), "--event", str(event), "--inside", look[0]]
        subprocess.run(command, env=environment, check=True)
    finally:
        server.terminate()
        server.wait()


def inside(out: Path, event: Path, tag: str, screen: str, scale: str, looks: str, big: bool, language: str) -> None:
    """Open the event at one size and take every page's picture; run inside an X server."""
    from PySide6.QtCore import Qt
    from PySide6.QtWidgets import QApplication

    from cloner_gui.event.services import process_services
    from cloner_gui.event.session import Session
    from cloner_gui.main_window import MainWindow

    app = QApplication([])
    if tag == "rtl":
        app.setLayoutDirection(Qt.LayoutDirection.RightToLeft)
    window = MainWindow(Session(process_services()))
    width, height = (int(int(side) / float(scale)) for side in screen.split("x"))
    window.resize(width, height)
    window.move(0, 0)
    window.show()
    window.open_folder(event)
    window.booth.change(appearance=looks, big=big, language=language)
    window.menus.follow()
    wait(app, lambda: window.booth._opening is None)
    if window.session.folder is None:
        take_visitor(app, window)
    for number in range(len(window.pages)):
        window.go(number)
        settle(app, 2.5 if number in (2, 3) else 0.5)
        window.grab().save(str(out / f"gui_{tag}_{number + 1}.png"))
    window.booth.close()
    window.close()


def take_visitor(app: object, window: object) -> None:
    """Take a sample visitor through the path."""
    from cloner.frames import ViewId

    window.booth.new_visitor()
    wait(app, lambda: window.session.folder is not None)
    window.booth.change(link="https://booth.example/{id}")
    window.visitor.form.name_field.setText("Anna")
    window.visitor.form.height_field.known.setChecked(True)
    window.visitor.form.height_field.cm.setValue(158)
    window.visitor.form.save()
    window.visitor.form.consent_box.click()
    copies = Path(tempfile.mkdtemp())
    for number, view in enumerate(ViewId):
        shutil.copy(SAMPLE / f"{view}.jpg", copies / f"DSC_{number:04d}.jpg")
    window.booth.intake.add_files(sorted(copies.iterdir()))
    wait(app, lambda: window.booth.intake.pending() == 0)
    shutil.rmtree(copies)
    window.show_page(window.points)
    wait(app, lambda: bool(window.session.proposed) and not window.session.busy)
    window.session.clone()
    wait(app, lambda: not window.session.busy)


def wait(app: object, done: object, seconds: float = 400.0) -> None:
    end = time.monotonic() + seconds
    while not done():
        if time.monotonic() > end:
            raise TimeoutError
        app.processEvents()
        time.sleep(0.02)


def settle(app: object, seconds: float) -> None:
    end = time.monotonic() + seconds
    wait(app, lambda: time.monotonic() > end)


if __name__ == "__main__":
    main()
