"""The page for telephones in a real browser of a telephone's size; and that nothing listens while it is off."""

import os
import re
import shutil
import subprocess
import sys
import threading
import time

import pytest
from PySide6.QtCore import Qt

from cloner.booth.phone import parcel
from cloner_gui.main_window import TAKEAWAY
from kit.browser import CHROMIUM, browser

from .test_flow import event  # noqa: F401  (a fixture)
from .test_visitors_side import cloned, with_result

pytestmark = [pytest.mark.gui, pytest.mark.slow]
#: A usual telephone of today, upright: points and pixels a point.
PHONE = (390, 844, 3.0)
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def served(event, qtbot, monkeypatch, samples):  # noqa: F811
    """A window that serves two visitors' pages on this computer alone, and their links."""
    monkeypatch.setattr("cloner_gui.event.phone.local_addresses", lambda: ("127.0.0.1",))
    monkeypatch.setattr("cloner_gui.event.phone.PORT", 0)
    monkeypatch.setattr(parcel, "SIZE_PX", (80, 120))
    monkeypatch.setattr(parcel, "LARGE_PX", (80, 120))
    tokens = []
    for _ in range(2):
        assert not event.phone.is_on, "off until somebody switches it on"
        with_result(cloned(event, qtbot, samples))
        event.go(TAKEAWAY)
        event.takeaway.phone_box.click()
        qtbot.waitUntil(lambda: bool(event.phone.link()), timeout=300000)
        base, _, token = event.phone.link().rstrip("/").rpartition("/")
        tokens.append(token)
        if len(tokens) == 1:
            event.takeaway.phone_box.click()
    links = [f"{base}/{token}/" for token in tokens]
    qtbot.waitUntil(lambda: event.takeaway.code_note.text() == links[1])  # what the code holds
    return event, links


def beside(qtbot, work):
    """Do something on another thread while the window goes on, and return what it gives."""
    found = []

    def run():
        try:
            found.append(work())
        except (RuntimeError, TimeoutError, OSError) as error:
            found.append(error)

    thread = threading.Thread(target=run)
    thread.start()
    qtbot.waitUntil(lambda: bool(found), timeout=400000)
    thread.join()
    if isinstance(found[0], Exception):
        raise found[0]
    return found[0]


@pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed")
def test_the_page_opens_turns_and_downloads_on_a_telephone(served, qtbot, tmp_path):
    window, (first, second) = served
    kept = tmp_path / "kept"
    kept.mkdir()

    def on_the_telephone():
        with browser(tmp_path / "profile") as page:
            page.keep_downloads(kept)
            page.visit(first, *PHONE)
            page.wait_for("document.readyState == 'complete' && all.every(one => one.complete && one.naturalWidth)")
            told = {"title": page.value("document.title"), "wide": page.value("document.body.scrollWidth")}
            told["own"] = page.value("new Promise(done => {const n = at; setTimeout(() => done(at != n), 500)})")
            box = page.value("(() => {const b = seen.getBoundingClientRect(); return [b.x, b.y, b.width, b.height]})()")
            told["box"] = box
            before = page.value("own = false, show(0), at")
            y = box[1] + box[3] / 2
            page.drag([(100 + 14 * step, y) for step in range(7)])
            told["turned"] = page.value("at") - before
            told["shown"] = page.value("seen.src.split('/').pop()")
            told["links"] = page.value("[...document.links].map(one => one.getBoundingClientRect().height)")
            for name in ("clone.glb", "picture.jpg", "film.webp"):
                saved = kept / f"clone{name[name.rindex('.') :]}"
                for _ in range(4):  # a starved machine may lose a finger's touch while it still lays the page out
                    page.tap(f"a[href='{name}']")
                    end = time.monotonic() + 20.0
                    while not saved.is_file() and time.monotonic() < end:
                        time.sleep(0.1)
                    if saved.is_file():
                        break
            told["requests"], told["complaints"] = page.requests(), page.complaints()
            base = first[: first.rindex("/", 0, -1) + 1]
            asked = [base, base + "visitor-002/", second[:-3] + "xx/", first[:-1]]
            told["others"] = [page.value(f"fetch('{one}').then(got => got.status, () => 0)") for one in asked]
            return told

    told = beside(qtbot, on_the_telephone)
    assert told["title"] == "Your clone"
    assert told["wide"] <= PHONE[0], "nothing is beyond the side"
    assert told["own"], "it turns by itself until a finger takes it"
    assert told["box"][2] > 0.9 * PHONE[0]
    assert told["turned"] == 6, "14 points of a finger's way turn it by one side"
    assert told["shown"] == "side_06.jpg"
    assert min(told["links"]) >= 44, "high enough for a finger"
    own = window.booth.root / "visitor-001" / parcel.FOLDER
    for saved, name in (("clone.glb", "clone.glb"), ("clone.jpg", "picture.jpg"), ("clone.webp", "film.webp")):
        assert (kept / saved).read_bytes() == (own / name).read_bytes(), saved
    assert told["complaints"] == []
    assert {one.split("/")[2] for one in told["requests"]} == {first.split("/")[2]}, "nothing from elsewhere"
    assert 200 not in told["others"]
    assert re.fullmatch(r"http://127\.0\.0\.1:\d+/[\w-]{22}/", first)


WINDOW = """
import sys
from pathlib import Path
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
import cloner_gui.event.phone
cloner_gui.event.phone.local_addresses = lambda: ("127.0.0.1",)
cloner_gui.event.phone.PORT = 0
from cloner_gui.main_window import MainWindow
from cloner_gui.event.session import Session
from kit.walker import services
app = QApplication([])
window = MainWindow(Session(services()))
window.show()
window.booth.open(Path(sys.argv[1]))
window.booth.new_visitor()
QTimer.singleShot(500, lambda: window.go(4))
if sys.argv[2] == "on":
    QTimer.singleShot(1000, lambda: window.booth.change(phone=True))
QTimer.singleShot(2500, app.quit)
app.exec()
window.close()
"""


@pytest.mark.skipif(shutil.which("strace") is None, reason="strace is not installed")
@pytest.mark.parametrize("wanted", ["off", "on"])
def test_no_socket_listens_while_the_page_is_off(tmp_path, wanted):
    (tmp_path / "fair").mkdir()
    log = tmp_path / "calls"
    command = ["strace", "-f", "-q", "-e", "trace=listen", "-o", str(log), sys.executable, "-c", WINDOW]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), "QT_QPA_PLATFORM": "offscreen"}
    subprocess.run([*command, str(tmp_path / "fair"), wanted], env=environment, check=True, timeout=300)
    called = [line for line in log.read_text().splitlines() if "listen(" in line]
    assert len(called) == (1 if wanted == "on" else 0), called
