"""Who is thrown away lies there for some days, still held, and comes back; the visitors' screen shows who may be."""

import json
from datetime import UTC, datetime, timedelta

import pytest

from cloner.booth.events import retention, trash
from cloner.booth.events.event import new_visitor, visitor_folders
from cloner.booth.stage import public_name, queue_names, shown_clones
from cloner.booth.visitors.names import display_name, first_name, number_of
from cloner.booth.visitors.person_file import write_person
from cloner.booth.visitors.visits import State, Visit, read_visit, write_visit
from cloner.errors import ClonerError

NOW = datetime(2026, 11, 22, 12, 0, tzinfo=UTC)


def test_a_visitor_thrown_away_comes_back_whole(tmp_path):
    folder = new_visitor(tmp_path, "then")
    write_person(folder, name="Anna", height_cm=None, consent="yes")
    before = {path.name: path.read_bytes() for path in folder.iterdir() if path.name != "visit.json"}
    lies = trash.move_to_trash(folder, NOW)
    assert visitor_folders(tmp_path) == ()
    assert trash.trashed_visitors(tmp_path) == (lies,)
    assert [one.identifier for one in retention.stored_data(tmp_path)] == ["visitor-001"], "still held, and told"
    assert new_visitor(tmp_path, "later").name == "visitor-002", "the number stays taken"
    assert trash.restore(lies) == folder
    assert {path.name: path.read_bytes() for path in folder.iterdir() if path.name != "visit.json"} == before
    assert read_visit(folder).started == "then"
    assert trash.trashed_visitors(tmp_path) == ()


def test_who_waited_for_a_clone_waits_no_more_in_the_trash(tmp_path):
    folder = new_visitor(tmp_path, "")
    write_visit(folder, Visit(state=State.WAITING, queued="1"))
    back = trash.restore(trash.move_to_trash(folder, NOW))
    assert read_visit(back).state is State.NONE
    assert read_visit(back).declined, "nobody is cloned who was thrown away"


def test_the_end_is_counted_from_the_day_it_was_thrown_away(tmp_path):
    lies = trash.move_to_trash(new_visitor(tmp_path, ""), NOW)
    assert trash.deletion_time(lies, 2) == NOW + timedelta(days=2)
    assert trash.expired(tmp_path, 2, NOW + timedelta(days=1, hours=23)) == ()
    assert trash.expired(tmp_path, 2, NOW + timedelta(days=2)) == (lies,)
    retention.forget_visitors((lies,), tmp_path)
    assert not lies.exists()
    assert trash.deletion_time(lies, 2) is None, "who went between a look into the trash and this one"


def test_who_is_put_aside_is_gone_at_once_held_still_and_deleted_at_the_next_opening(tmp_path):
    first, second = new_visitor(tmp_path, ""), new_visitor(tmp_path, "")
    write_person(second, name="Anna Long", height_cm=None, consent="yes")
    aside = retention.set_aside(second)  # and here the power goes
    assert visitor_folders(tmp_path) == (first,)
    assert [one.identifier for one in retention.stored_data(tmp_path)] == ["visitor-001", "visitor-002"], "told as held"
    assert new_visitor(tmp_path, "").name == "visitor-003", "the number stays taken"
    old = trash.move_to_trash(first, NOW - timedelta(days=3))
    (tmp_path / "notes.txt").write_text("Anna Long was here")
    assert retention.tidy_up(tmp_path, 2, NOW) == ("notes.txt",), "her name is still known"
    assert not aside.exists()
    assert not old.exists(), "its days in the trash are over"
    assert retention.tidy_up(tmp_path, 2, NOW) == ()


def test_nobody_is_brought_back_over_another(tmp_path):
    folder = new_visitor(tmp_path, "")
    lies = trash.move_to_trash(folder, NOW)
    folder.mkdir()
    with pytest.raises(ClonerError, match="cannot be moved"):
        trash.restore(lies)
    assert lies.is_dir()


def test_visitors_are_called_by_name_and_number(tmp_path):
    folder = tmp_path / "visitor-007"
    assert display_name("Anna Long", folder, "Visitor {n}") == "Anna Long (7)"
    assert display_name("", folder, "Besucher {n}") == "Besucher 7"
    assert display_name("7", folder, "Visitor {n}") == "Visitor 7"
    assert display_name("", tmp_path / "anna", "Visitor {n}") == "anna"
    assert (number_of(folder), first_name(" Anna Long"), first_name("")) == ("7", "Anna", "")


def test_only_who_agreed_is_seen_and_others_are_called_by_number(tmp_path):
    seen, unseen = new_visitor(tmp_path, ""), new_visitor(tmp_path, "")
    visits = {}
    for folder, shown in ((seen, True), (unseen, False)):
        result = folder / "clones" / folder.name
        result.mkdir(parents=True)
        (result / "report.json").write_text("{}")
        (result / "clone.npz").write_bytes(b"")
        visits[folder] = Visit(state=State.CLONED, shown=shown)
    assert shown_clones(visits) == (seen,)
    assert public_name(seen, visits[seen], "Anna Long") == "Anna"
    assert public_name(unseen, visits[unseen], "Boris") == "2"
    waiting = {folder: Visit(state=State.WAITING, queued=str(n), shown=n == 0) for n, folder in enumerate(visits)}
    assert queue_names(waiting, lambda folder: "Anna Long") == ("Anna", "2")


def test_thrown_away_is_no_longer_seen(tmp_path):
    folder = new_visitor(tmp_path, "")
    write_visit(folder, Visit(state=State.CLONED, shown=True))
    lies = trash.move_to_trash(folder, NOW)
    assert json.loads((lies / "visit.json").read_text())["shown"] is False
