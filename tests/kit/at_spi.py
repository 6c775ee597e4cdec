"""The window as screen readers meet it: what hangs on the accessibility bus, read with the desktop's own ``gdbus``.

``dbus-run-session -- python -m kit.at_spi EVENT`` prints a JSON list for each page: (role, name) of all that is there.
``--window`` alone opens the window, prints "ready", shows the page of each line that it reads, and ends with its input.
"""

from __future__ import annotations

import json
import os
import queue
import re
import subprocess
import sys
import threading
from pathlib import Path

ACCESSIBLE = "org.a11y.atspi.Accessible"
PAGES = 5
SETTLES_MS = 1500


def tree(address: str, *, menus: bool) -> list[tuple[str, str]]:
    """Return (role, name) of everything that programs show on the bus; without what lies in menus if they are known."""
    found, waiting = [], [("org.a11y.atspi.Registry", "/org/a11y/atspi/accessible/root")]
    while waiting:
        place = waiting.pop()
        role = re.search(r"'(.*)'", _ask(address, place, f"{ACCESSIBLE}.GetRoleName"))
        if menus or role is None or role.group(1) != "menu bar":
            children = _ask(address, place, f"{ACCESSIBLE}.GetChildren")
            waiting += re.findall(r"'(:[\d.]+)', (?:objectpath )?'([^']+)'", children)
        name = _ask(address, place, "org.freedesktop.DBus.Properties.Get", ACCESSIBLE, "Name")
        said = re.search(r"<['\"](.*)['\"]>", name)
        found.append((role.group(1) if role else "", said.group(1) if said else ""))
    return found


def _ask(address: str, place: tuple[str, str], method: str, *values: str) -> str:
    """Call a method; no address asks the session's own bus."""
    bus = ["--address", address] if address else ["--session"]
    command = ["gdbus", "call", *bus, "--dest", place[0], "--object-path", place[1], "--method", method, *values]
    return subprocess.run(command, capture_output=True, text=True, timeout=20, check=False).stdout


def main() -> None:
    """Open the window in another process and print what a screen reader finds."""
    told = _ask("", ("org.a11y.Bus", "/org/a11y/bus"), "org.a11y.Bus.GetAddress")  # the bus starts with this question
    found = re.search(r"'(.*)'", told)
    if found is None:
        sys.exit("no accessibility bus")
    environment = {**os.environ, "QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1", "QT_QPA_PLATFORM": "xcb"}
    command = [sys.executable, "-m", "kit.at_spi", "--window", sys.argv[1]]
    window = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment)
    pages = []
    for number in range(PAGES):
        window.stdout.readline()
        pages.append(tree(found.group(1), menus=number == 0))
        window.stdin.write(f"{number + 1}\n" if number + 1 < PAGES else "")
        window.stdin.flush()
    sys.stdout.write(json.dumps(pages))
    window.stdin.close()
    window.wait(20)


def show(event: Path) -> None:
    """Show the window with a visitor's first page until the standard input ends."""
    from PySide6.QtCore import QTimer
    from PySide6.QtWidgets import QApplication

    from cloner_gui.event.session import Session
    from cloner_gui.main_window import MainWindow
    from kit.walker import services

    app = QApplication([])
    window = MainWindow(Session(services()))
    window.show()
    window.booth.open(event)
    window.booth.new_visitor()
    said = queue.SimpleQueue()  # what the other thread reads: a page's number, "" at the end

    def read() -> None:
        line = "before the first"
        while line:
            line = sys.stdin.readline()
            said.put(line)

    threading.Thread(target=read, daemon=True).start()

    def ready() -> None:
        sys.stdout.write("ready\n")
        sys.stdout.flush()

    def look() -> None:
        if not said.empty():
            line = said.get()
            window.go(int(line)) if line else app.quit()
            QTimer.singleShot(SETTLES_MS, ready)

    looker = QTimer(interval=50)
    looker.timeout.connect(look)
    looker.start()
    QTimer.singleShot(SETTLES_MS, ready)
    app.exec()
    window.close()


if __name__ == "__main__":
    show(Path(sys.argv[2])) if sys.argv[1] == "--window" else main()
