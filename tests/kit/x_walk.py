"""Takes a visitor through the window with the X server's mouse; prints what the window then knew as JSON.

``python -m kit.x_walk EVENT PHOTOS`` inside an X server.
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

from kit.walker import VIEWS, known, services
from kit.xmouse import Mouse


def main() -> None:
    from PySide6.QtCore import QPoint
    from PySide6.QtWidgets import QApplication, QScrollArea

    from cloner.frames import ViewId
    from cloner_gui.event.session import Session
    from cloner_gui.main_window import MainWindow

    app, mouse = QApplication([]), Mouse()
    window = MainWindow(Session(services()))
    screen = app.primaryScreen().availableGeometry()
    window.setGeometry(screen)
    window.show()
    booth, session = window.booth, window.session

    def wait(done, what):
        end = time.monotonic() + 30.0
        while not done():
            if time.monotonic() > end:
                raise TimeoutError(what)
            app.processEvents()
            time.sleep(0.005)

    def settle(seconds=0.15):
        end = time.monotonic() + seconds
        wait(lambda: time.monotonic() > end, "")

    def to(widget, place):
        spot = widget.mapToGlobal(place) * window.devicePixelRatioF()
        mouse.move(spot.x(), spot.y())
        settle(0.05)

    def click(widget, place=None):
        above = widget.parentWidget()
        while above is not None:  # as an operator turns the wheel
            if isinstance(above, QScrollArea):
                above.ensureWidgetVisible(widget)
            above = above.parentWidget()
        settle(0.05)
        to(widget, place or widget.rect().center())
        mouse.button(True)
        settle(0.05)
        mouse.button(False)
        settle()

    settle(0.5)
    booth.open(Path(sys.argv[1]))
    settle(0.5)
    click(window.visitor.new_button)
    wait(lambda: session.folder is not None and booth._opening is None, "a new visitor")
    box = window.visitor.form.consent_box
    click(box, QPoint(10, box.height() // 2))
    click(window.next)
    booth.intake.add_files([Path(sys.argv[2]) / f"{view}.jpg" for view in VIEWS])
    wait(lambda: booth.intake.pending() == 0, "photos")
    click(window.aside)
    wait(lambda: bool(session.proposed) and not session.busy, "points")
    settle(0.5)
    canvas = window.points.views[ViewId.BODY_FRONT]
    start, end = (canvas.lens.widget_from_photo(*px).toPoint() for px in ((30.0, 40.0), (60.0, 90.0)))
    to(canvas, start)
    mouse.button(True)
    for share in (0.3, 0.6, 1.0):
        to(canvas, start + (end - start) * share)
    mouse.button(False)
    settle()
    click(window.next)
    wait(lambda: session.outcome is not None and not session.busy, "the clone")
    click(window.next)
    told = known(window) | {"clicks_seen": window.stack.currentIndex() == len(window.pages) - 1}
    window.booth.close()
    sys.stdout.write(json.dumps(told) + "\n")


if __name__ == "__main__":
    main()
