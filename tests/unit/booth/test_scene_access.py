"""Whose clones of an event may walk in its scene: who said yes to that, and nobody else."""

from __future__ import annotations

import json
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

from cloner.booth.events.event import EVENT_FILE, FORMAT
from cloner.booth.events.pin import hash_pin
from cloner.booth.events.trash import move_to_trash
from cloner.booth.scene_access import finished_clones, pin_check
from cloner.booth.stage import result_of
from cloner.booth.visitors.visits import State, Visit, read_visit, write_visit
from cloner.project.results import RESULT_MARK


def visitor(event: Path, name: str, **told: object) -> Path:
    folder = event / name
    result_of(folder).mkdir(parents=True)
    for file in ("clone.npz", RESULT_MARK):
        (result_of(folder) / file).write_bytes(b"{}")
    write_visit(folder, Visit(queued=name, **{"state": State.CLONED, **told}))  # type: ignore[arg-type]
    return folder


def event_in(folder: Path, **told: object) -> Path:
    folder.mkdir()
    (folder / EVENT_FILE).write_text(json.dumps({"format": FORMAT, "scene": "museum", **told}))
    return folder


def test_only_who_said_yes_to_the_scene_walks_in_it(tmp_path: Path) -> None:
    event = event_in(tmp_path / "event")
    yes = visitor(event, "1", inhabits=True)
    visitor(event, "2", shown=True)
    visitor(event, "3", inhabits=True, state=State.WAITING)
    later = visitor(event, "4", inhabits=True)
    found = finished_clones(event)
    assert callable(found)
    assert found() == (result_of(later), result_of(yes)), "the newest first"
    write_visit(yes, replace(read_visit(yes), inhabits=False))
    assert found() == (result_of(later),), "who says no later is out"
    move_to_trash(later, datetime.now(UTC))
    assert found() == ()


def test_a_plain_folder_of_results_and_its_number(tmp_path: Path) -> None:
    assert finished_clones(tmp_path) == tmp_path
    assert pin_check(tmp_path) is None
    event = event_in(tmp_path / "event", pin=hash_pin("42"))
    opens = pin_check(event)
    assert opens is not None
    assert opens("42")
    assert not opens("41")
