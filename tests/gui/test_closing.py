"""The window closes cleanly at any moment, whatever is under way: no abort, no process left behind."""

import os
import shutil
import subprocess
import sys

import pytest

pytestmark = [pytest.mark.gui, pytest.mark.slow]

#: Opens a visitor, goes to a page, starts a clone, and quits so many seconds after the window was shown.
PROGRAM = """
import sys
from pathlib import Path
from PySide6.QtCore import QCoreApplication, QTimer
import cloner_gui.app as app

class Window(app.MainWindow):
    def show(self):
        super().show()
        self.session.opened.connect(lambda: QTimer.singleShot(0, self.begin))
        QTimer.singleShot(int(1000 * float(sys.argv[2])), QCoreApplication.quit)

    def begin(self):
        self.show_page(self.points if sys.argv[3] == "points" else self.clone)
        if sys.argv[3] == "clone":
            self.session.clone()

if __name__ == "__main__":
    app.MainWindow = Window
    sys.exit(app.run_app(Path(sys.argv[1])))
"""


@pytest.mark.parametrize(("seconds", "page"), [(0.0, "points"), (0.8, "points"), (2.5, "clone")])
def test_the_program_ends_cleanly_when_it_is_told_to(samples, tmp_path, seconds, page):
    folder = tmp_path / "anna"
    shutil.copytree(samples / "anna" / "plain", folder)
    program = tmp_path / "program.py"
    program.write_text(PROGRAM)
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, str(program), str(folder), str(seconds), page]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr[-3000:]
    assert "QThread" not in done.stderr
    assert "Traceback" not in done.stderr
