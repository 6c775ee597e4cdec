"""How the window feels: seconds to start, and how long its thread is ever held up while a visitor is cloned.

``python benchmarks/gui_flow.py`` starts ``cloner gui`` three times on an event and measures until its window is drawn,
then clones a sample visitor with the real nets in the background, photographs the next one meanwhile, and measures the
longest time between two beats of a 5 ms timer of the window's thread. CPU seconds stand beside wall seconds: on a busy
machine only they can be compared. Last comes a day of two hundred visitors (``kit.busy_day``, as the test that counts
calls has it): for how long each step holds the window's thread, milliseconds of CPU.
"""

from __future__ import annotations

import itertools
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parents[1]
SAMPLES = ROOT / "samples"
BEAT_MS = 5
VISITORS = 200
STARTED = """
import sys, time, resource
from pathlib import Path
from PySide6.QtCore import QTimer
sys.argv = ["cloner", "gui", sys.argv[1]]
import cloner_gui.main_window as main_window
class Watched(main_window.MainWindow):
    def paintEvent(self, event):
        super().paintEvent(event)
        usage = resource.getrusage(resource.RUSAGE_SELF)
        sys.stdout.write(f"{time.time()} {usage.ru_utime + usage.ru_stime}\\n")
        sys.stdout.flush()
        import os
        os._exit(0)
import cloner_gui.app as app
app.MainWindow = Watched
from cloner.cli import main
main()
"""


def main() -> None:
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    with tempfile.TemporaryDirectory() as room:
        event = Path(room) / "fair"
        event.mkdir()
        starts = [started(event) for _ in range(3)]
        wall, cpu = min(one[0] for one in starts), min(one[1] for one in starts)
        sys.stdout.write(f"start to first picture: {wall:.2f} s wall, {cpu:.2f} s CPU (best of 3)\n")
        told = cloning(event)
        sys.stdout.write(json.dumps(told, indent=1) + "\n")
        sys.stdout.write(day(Path(room) / "day") + "\n")


def day(room: Path) -> str:
    """Return the longest stretches of the window's thread on a day of many visitors, stand-ins for the long jobs."""
    sys.path.insert(0, str(ROOT / "tests"))
    from cloner_gui.event.session import Session
    from cloner_gui.main_window import MainWindow
    from kit.busy_day import crowd, walk
    from kit.silence import Milliseconds, Silence
    from kit.stand_ins import Jobs

    root = room / "fair"
    root.mkdir(parents=True)
    crowd(root, VISITORS)
    jobs, silence = Jobs(), Silence(Milliseconds())
    window = MainWindow(Session(jobs.services()))
    window.show()
    walk(window, jobs, root, silence)
    window.booth.close()
    return silence.told("ms")


def started(event: Path) -> tuple[float, float]:
    """Return wall and CPU seconds from the call of the program to its window's first picture."""
    begun = time.time()
    done = subprocess.run([sys.executable, "-c", STARTED, str(event)], capture_output=True, text=True, check=True)
    end, cpu = done.stdout.split()[-2:]
    return float(end) - begun, float(cpu)


def cloning(event: Path) -> dict[str, float]:
    """Clone a sample visitor while the next is photographed; return the beats' gaps, milliseconds."""
    from PySide6.QtCore import Qt, QTimer
    from PySide6.QtWidgets import QApplication

    from cloner_gui.app import preload_pages
    from cloner_gui.event.services import process_services
    from cloner_gui.event.session import Session
    from cloner_gui.main_window import MainWindow

    app = QApplication.instance() or QApplication([])
    window = MainWindow(Session(process_services()))
    window.show()
    preload_pages()  # as the program does behind its first page
    window.booth.open(event)
    beats: list[tuple[float, float]] = []
    heart = QTimer(interval=BEAT_MS, timerType=Qt.TimerType.PreciseTimer)
    heart.timeout.connect(lambda: beats.append((time.perf_counter(), time.thread_time())))
    heart.start()
    copies = Path(tempfile.mkdtemp())

    def wait(done: object) -> None:
        while not done():
            app.processEvents()
            time.sleep(0.0005)

    def visitor(name: str) -> None:
        window.booth.new_visitor()
        wait(lambda: window.booth._opening is None)
        window.visitor.form.consent_box.click()
        for number, photo in enumerate(sorted((SAMPLES / name / "plain").glob("*.jpg"))):
            shutil.copy(photo, copies / f"{name}_{number}.jpg")
        window.show_page(window.photos)
        window.booth.intake.add_files(sorted(copies.glob(f"{name}_*.jpg")))
        wait(lambda: window.booth.intake.pending() == 0)

    visitor("anna")
    window.session.clone()
    begun, first = time.perf_counter(), window.session.folder
    visitor("boris")
    wait(lambda: not window.session.queue.holds(first))
    wall = time.perf_counter() - begun
    window.booth.open_visitor(first)
    wait(lambda: window.session.folder == first)
    window.show_page(window.clone)
    wait(lambda: time.perf_counter() - begun > wall + 3.0)
    during = [beat for beat in beats if beat[0] >= begun]
    gaps = sorted((after[0] - before[0], after[1] - before[1]) for before, after in itertools.pairwise(during))
    window.booth.close()
    shutil.rmtree(copies)
    return {
        "clone_wall_s": round(wall, 1),
        "beats": len(gaps),
        "gap_median_ms": round(1000 * gaps[len(gaps) // 2][0], 1),
        "gap_p99_ms": round(1000 * gaps[int(0.99 * len(gaps))][0], 1),
        "gap_longest_ms": round(1000 * gaps[-1][0], 1),
        "gap_longest_own_cpu_ms": round(1000 * max(gap[1] for gap in gaps), 1),
        "gaps_over_100_ms": sum(gap[0] > 0.1 for gap in gaps),
        "gaps_over_100_ms_own_cpu": sum(gap[1] > 0.1 for gap in gaps),
    }


if __name__ == "__main__":
    main()
