"""kill -9 while a camera drops photos, a telephone is served and files go to a stick: nothing that was safe is lost.

``python benchmarks/booth_kills.py`` kills forty times; CI twice, once after the whole walk is known to be sound.
"""

import pytest

from cloner_gui.event.session import Session
from cloner_gui.main_window import MainWindow
from kit.outside_kills import World, lost
from kit.outside_walk import services

pytestmark = [pytest.mark.gui, pytest.mark.slow]


@pytest.fixture
def reopen(qtbot, monkeypatch):
    """Open the event again, as the operator does, and let it settle."""
    monkeypatch.setattr("cloner_gui.event.phone.local_addresses", lambda: ("127.0.0.1",))
    monkeypatch.setattr("cloner_gui.event.phone.PORT", 0)

    def again(world):
        window = MainWindow(Session(services()))
        qtbot.addWidget(window)
        window.booth.open(world.event)
        qtbot.waitUntil(lambda: window.booth._opening is None)
        for _ in range(4):  # the camera's folder has to be looked at twice, however slow the machine is
            qtbot.wait(300)
            qtbot.waitUntil(lambda: window.booth.intake.pending() == 0)
            window.booth.intake.look_for_arrivals()
        qtbot.waitUntil(lambda: window.booth.intake.pending() == 0)
        window.session.queue.close()
        window.phone.close()
        window.booth.close()

    return again


def test_killed_while_photos_come_in_and_while_copying_nothing_safe_is_lost(tmp_path, reopen):
    whole = World(tmp_path / "whole")
    seconds = whole.run(None)
    assert [one["what"] for one in whole.told].count("copied") == 2
    assert whole.served > 0, "a telephone was served"
    reopen(whole)
    assert lost(whole) == []
    for name, share in (("photos", 0.2), ("copying", 0.97)):
        world = World(tmp_path / name)
        world.run(share * seconds)
        reopen(world)
        assert lost(world) == [], f"killed while {world.doing()}"


def test_the_judge_finds_what_is_lost(tmp_path):
    world = World(tmp_path)
    folder = world.event / "visitor-001"
    folder.mkdir()
    world.told = [{"what": "name", "visitor": "visitor-001", "value": "Anna"},
                  {"what": "photos", "visitor": "visitor-001", "value": ["00"]}]  # fmt: skip
    world.dropped = {"visitor-001": ["11"]}
    (world.stick / "visitor-001").mkdir()
    assert len(lost(world)) == 4
