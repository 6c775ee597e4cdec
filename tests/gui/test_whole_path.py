"""The whole path with the real nets and the real clone, in the real worker processes: from an empty event to nothing.

One visitor here; ``CLONER_VISITORS=anna,boris pytest tests/gui/test_whole_path.py`` takes both.
"""

import os
import shutil

import numpy as np
import pytest
from PySide6.QtCore import Qt

from cloner.booth.visitors.visits import State, read_visit
from cloner.frames import ViewId
from cloner.project.folder import read_corrections
from cloner.untrusted import walk_files
from cloner_gui.event.services import process_services
from cloner_gui.event.session import Session
from cloner_gui.main_window import MainWindow
from kit.stand_ins import drop

from .test_flow import _box, begin

pytestmark = [pytest.mark.gui, pytest.mark.slow]
VISITORS = os.environ.get("CLONER_VISITORS", "boris").split(",")
MINUTES = 10 * 60 * 1000
VIEW = ViewId.BODY_FRONT


def opened(qtbot, root):
    window = MainWindow(Session(process_services()))
    qtbot.addWidget(window)
    window.resize(1280, 800)
    window.show()
    window.booth.open(root)
    return window


def drag(qtbot, canvas, start_px, end_px):
    start, end = (canvas.lens.widget_from_photo(*px).toPoint() for px in (start_px, end_px))
    qtbot.mousePress(canvas, Qt.MouseButton.LeftButton, pos=start)
    qtbot.mouseMove(canvas, (start + end) / 2)
    qtbot.mouseMove(canvas, end)
    qtbot.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=end)


@pytest.mark.parametrize("name", VISITORS)
def test_from_an_empty_event_to_nothing(qtbot, samples, tmp_path, name, monkeypatch):
    root, card = tmp_path / "fair", tmp_path / "card"
    root.mkdir()
    card.mkdir()
    for number, view in enumerate(reversed(ViewId)):
        shutil.copy(samples / name / "plain" / f"{view}.jpg", card / f"DSC_{number:04d}.jpg")
    window = opened(qtbot, root)
    folder = begin(window, qtbot)
    drop(window.photos, card)
    qtbot.waitUntil(lambda: window.booth.intake.pending() == 0, timeout=MINUTES)
    assert set(window.session.photos.photos) == set(ViewId)
    assert {card.verdict.text() for card in window.photos.cards.values()} == {"✓ Good"}

    window.show_page(window.points)
    qtbot.waitUntil(lambda: bool(window.session.proposed) and not window.session.busy, timeout=MINUTES)
    canvas = window.points.views[VIEW]
    qtbot.waitUntil(canvas.isVisible)
    for point in ("waist_left", "waist_right", "armpit_left"):
        place = window.session.points(VIEW).get(point)
        drag(qtbot, canvas, place, place + np.array([9.0, 0.0]))
    assert window.session.drags == 3
    assert len(read_corrections(folder).points[VIEW]) == 3

    window.show_page(window.clone)
    with qtbot.waitSignal(window.session.cloned, timeout=MINUTES):
        qtbot.mouseClick(window.clone.clone_button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not window.session.busy)
    assert (folder / "clones" / folder.name / "report.html").is_file()
    assert "joined" in window.session.outcome.values, "points can be moved on it"

    stick = tmp_path / "stick"
    stick.mkdir()
    monkeypatch.setattr("cloner_gui.pages.takeaway.QFileDialog.getExistingDirectory", lambda *_: str(stick))
    window.show_page(window.takeaway)
    qtbot.mouseClick(window.takeaway.folder_button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not window.takeaway.handing.busy, timeout=MINUTES)
    assert (stick / folder.name / "clone.glb").stat().st_size > 1_000_000

    while window.session.undo_stack.canUndo():
        window.undo_action.trigger()
    assert not any(read_corrections(folder).points.values())
    window.close()

    again = opened(qtbot, root)
    qtbot.waitUntil(lambda: again.session.folder == folder, timeout=MINUTES)
    assert again.stack.currentWidget() is again.takeaway
    assert again.session.outcome is not None, "the finished clone is shown without cloning again"
    assert again.session.points(VIEW) is not None
    assert read_visit(folder).state is State.CLONED
    again.takeaway.forget_button.click()
    next(one for one in _box(again).buttons() if "Delete" in one.text()).click()
    qtbot.waitUntil(lambda: not folder.exists())
    left = lambda: [path.name for path in walk_files(root) if path.is_file()]  # noqa: E731
    qtbot.waitUntil(lambda: left() == ["event.json"])  # nothing of the visitor is left
    again.close()
