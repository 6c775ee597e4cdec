"""The window as screen readers meet it: what hangs on the accessibility bus, read with the desktop's own ``gdbus``.

``dbus-run-session -- python -m kit.at_spi EVENT`` prints a JSON list of (role, name) of all that is there.
``--window`` alone opens the window, prints "ready" and ends with its standard input.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import threading
from pathlib import Path

ACCESSIBLE = "org.a11y.atspi.Accessible"


def tree(address: str) -> list[tuple[str, str]]:
    """Return (role, name) of everything that programs show on the bus."""
    found, waiting = [], [("org.a11y.atspi.Registry", "/org/a11y/atspi/accessible/root")]
    while waiting:
        place = waiting.pop()
        children = _ask(address, place, f"{ACCESSIBLE}.GetChildren")
        waiting += re.findall(r"'(:[\d.]+)', (?:objectpath )?'([^']+)'", children)
        role = re.search(r"'(.*)'", _ask(address, place, f"{ACCESSIBLE}.GetRoleName"))
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
    window.stdout.readline()
    sys.stdout.write(json.dumps(tree(found.group(1))))
    window.stdin.close()
    window.wait(20)


def show(event: Path) -> None:
    """Show the window with a visitor's first page until the standard input ends."""
    from PySide6.QtCore import QTimer
    from PySide6.QtWidgets import QApplication

    from cloner_gui.main_window import MainWindow
    from cloner_gui.session import Session
    from kit.walker import services

    app = QApplication([])
    window = MainWindow(Session(services()))
    window.show()
    window.booth.open(event)
    window.booth.new_visitor()
    ended = threading.Event()
    threading.Thread(target=lambda: (sys.stdin.read(), ended.set()), daemon=True).start()
    looker = QTimer(interval=50)
    looker.timeout.connect(lambda: app.quit() if ended.is_set() else None)
    looker.start()
    QTimer.singleShot(1500, lambda: (sys.stdout.write("ready\n"), sys.stdout.flush()))
    app.exec()
    window.close()


if __name__ == "__main__":
    show(Path(sys.argv[2])) if sys.argv[1] == "--window" else main()
