"""Event folders, visits, persons and consent, the queue, effort and retention: rules without a window."""

import json
import os
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest

from cloner.booth.events import retention
from cloner.booth.events.agreed import agreed_terms, offered_licences
from cloner.booth.events.event import (
    Event,
    check_event_folder,
    is_visitor,
    new_visitor,
    read_event,
    visits,
    write_event,
)
from cloner.booth.visitors import effort, waiting_line
from cloner.booth.visitors.person_file import (
    cm_from_feet,
    consent_given,
    consent_when,
    consent_words,
    feet_from_cm,
    person_facts,
    write_person,
)
from cloner.booth.visitors.visits import KnownVisits, State, Visit, read_visit, write_visit
from cloner.errors import ClonerError
from cloner.project.folder import read_terms
from cloner.records.terms import Terms

NOW = datetime(2026, 11, 21, 12, 0, tzinfo=UTC)


def test_settings_come_back_as_they_were_written(tmp_path):
    event = Event(
        title="Fair", language="tr", retention_days=7, consents={"tr": "Evet"}, formats=("glb", "obj"),
        camera_folder="/media/camera", link="http://x/{id}", phone=True, pin="1", appearance="dark", text_percent=150,
        big=True, open="visitor-003", licence="everyone",
    )  # fmt: skip
    write_event(tmp_path, event)
    assert read_event(tmp_path) == event
    assert read_event(tmp_path / "nothing") == Event()


@pytest.mark.parametrize(
    "text",
    ["[]", "{", '{"format": 9}', '{"format": 1, "colour": "red"}', '{"format": 2, "consent": "yes"}',
     '{"format": 1, "big": 1}', '{"format": 1, "language": "xx"}', '{"format": 1, "retention_days": -1}',
     '{"format": 1, "formats": "glb"}', '{"format": 2, "consents": {"xx": "yes"}}'],
)  # fmt: skip
def test_broken_settings_are_told_by_the_name_of_their_file(tmp_path, text):
    (tmp_path / "event.json").write_text(text)
    with pytest.raises(ClonerError) as told:
        read_event(tmp_path)
    assert told.value.where == "event.json"


def test_visitors_are_numbered_and_numbers_are_not_given_twice(tmp_path):
    first, second = new_visitor(tmp_path, "a"), new_visitor(tmp_path, "b")
    assert (first.name, second.name) == ("visitor-001", "visitor-002")
    retention.forget_visitors((first,), tmp_path)
    assert new_visitor(tmp_path, "c").name == "visitor-003"
    assert list(visits(tmp_path)) == [second, tmp_path / "visitor-003"]
    assert visits(tmp_path)[second].started == "b"


def test_a_visit_is_read_again_only_when_its_file_has_changed(tmp_path, monkeypatch):
    folder = new_visitor(tmp_path, "a")
    known, read = KnownVisits(), []
    monkeypatch.setattr("cloner.booth.visitors.visits.read_visit", lambda one: read.append(one) or read_visit(one))
    assert [visits(tmp_path, known.read)[folder].started for _ in range(3)] == ["a"] * 3
    assert read == [folder]
    write_visit(folder, Visit(started="b"))
    assert visits(tmp_path, known.read)[folder].started == "b", "same length, written a moment later"
    (folder / "visit.json").unlink()
    assert known.read(folder) == Visit()


def test_an_event_is_never_opened_among_strangers_files(tmp_path):
    check_event_folder(tmp_path)
    (tmp_path / "thesis.doc").write_text("x")
    with pytest.raises(ClonerError, match="other things"):
        check_event_folder(tmp_path)
    new_visitor(tmp_path, "")
    check_event_folder(tmp_path)
    with pytest.raises(ClonerError, match="no such folder"):
        check_event_folder(tmp_path / "gone")


def test_a_folder_with_photos_is_a_visitor_also_without_our_file(samples):
    assert is_visitor(samples / "anna" / "plain")
    assert not is_visitor(samples / "anna")


@pytest.mark.parametrize("text", ["", "[]", "nonsense", '{"state": "eaten"}', '{"clicks": "many"}'])
def test_a_broken_visit_starts_anew_and_stops_nobody(tmp_path, text):
    (tmp_path / "visit.json").write_text(text)
    assert read_visit(tmp_path) == Visit()


def test_a_visit_comes_back(tmp_path):
    visit = Visit("points", "face_front", State.WAITING, "q", "", "s", "de", 12.5, 30.0, 4, 5)
    write_visit(tmp_path, visit)
    assert read_visit(tmp_path) == visit


def test_name_height_and_consent_are_written_and_the_rest_stays(tmp_path):
    (tmp_path / "person.toml").write_text('name = "A"\nnotes = "tall"\n[measures]\nwaist_girth = 70.5\n')
    write_person(tmp_path, name='Ayşe "7"\n\\ \x7f', height_cm=171.5, consent="yes (2026)")
    assert person_facts(tmp_path) == ('Ayşe "7"\n\\ \x7f', 171.5, "yes (2026)")
    text = (tmp_path / "person.toml").read_text()
    assert 'notes = "tall"' in text
    assert "waist_girth = 70.5" in text
    write_person(tmp_path, name="", height_cm=None, consent="")
    assert person_facts(tmp_path) == ("", None, "")


def test_a_licence_counts_only_where_the_event_s_own_text_was_read_and_goes_with_the_consent(tmp_path):
    event = replace(Event(), title="Fair", licence="everyone", consents={"de": "Alle sollen meine Dateien nutzen."})
    assert agreed_terms(event, tmp_path, "en") == {"event": "Fair", "licence": "own"}
    agreed = agreed_terms(event, tmp_path, "de")
    write_person(tmp_path, name=" Anna ", height_cm=None, consent="ja (2026)", agreed=agreed)
    assert read_terms(tmp_path) == Terms("Anna", "Fair", "everyone")
    write_person(tmp_path, name="Anna", height_cm=170.0, consent="ja (2026)")
    assert read_terms(tmp_path).licence == "everyone", "a height typed later changes no terms"
    write_person(tmp_path, name="Anna", height_cm=170.0, consent="")
    assert read_terms(tmp_path) == Terms()
    assert "licence" not in (tmp_path / "person.toml").read_text()


def test_a_visitor_may_choose_less_than_the_event_asks_but_not_more(tmp_path):
    event = replace(Event(), licence="event", consents={"de": "Die Messe darf meine Dateien nutzen."})
    assert offered_licences(event) == ("own", "event")
    assert agreed_terms(event, tmp_path, "en", "event")["licence"] == "event"
    assert agreed_terms(event, tmp_path, "de", "own")["licence"] == "own"
    assert agreed_terms(event, tmp_path, "en", "everyone")["licence"] == "own"


def test_absurd_heights_are_refused_and_the_old_ones_stay(tmp_path):
    write_person(tmp_path, name="A", height_cm=180.0, consent="")
    with pytest.raises(ClonerError, match="outside"):
        write_person(tmp_path, name="A", height_cm=18.0, consent="")
    assert person_facts(tmp_path)[1] == 180.0


@pytest.mark.parametrize(("feet", "inches", "cm"), [(5, 7.0, 170.18), (6, 0.0, 182.88), (4, 11.5, 151.13)])
def test_feet_and_inches(feet, inches, cm):
    assert cm_from_feet(feet, inches) == pytest.approx(cm)
    assert feet_from_cm(cm) == (feet, inches)


def test_a_consent_says_what_when_and_in_which_language():
    told = consent_given("I  agree\n(to all).", NOW, "de")
    assert told == "I  agree\n(to all). (2026-11-21 12:00 UTC, de)"
    assert consent_words(told) == "I  agree\n(to all)."
    assert consent_when(told) == "2026-11-21 12:00 UTC, de"
    assert consent_when("on paper") == "on paper"


def test_who_asked_first_is_cloned_first():
    asked = {
        Path("a"): waiting_line.with_request(Visit(), "2"),
        Path("b"): waiting_line.with_request(Visit(), "1"),
        Path("c"): Visit(),
    }
    assert waiting_line.waiting(asked) == (Path("b"), Path("a"))
    assert waiting_line.waiting({Path("a"): waiting_line.with_clone(asked[Path("a")], 30.0, "2")}) == ()
    assert waiting_line.with_failure(asked[Path("a")], "dark").problem == "dark"
    assert waiting_line.without_request(asked[Path("a")], True).state is State.CLONED
    assert waiting_line.without_request(asked[Path("a")], False).state is State.NONE


def test_the_time_left_follows_the_pace_of_the_clone_under_way():
    usual = waiting_line.typical_seconds({Path("a"): Visit(clone_seconds=40.0), Path("b"): Visit(clone_seconds=60.0)})
    assert usual == 50.0
    assert waiting_line.typical_seconds({}) == waiting_line.USUAL_S
    assert waiting_line.seconds_left(0.0, 0.0, 50.0) == 50.0
    assert waiting_line.seconds_left(0.9, 90.0, 50.0) == pytest.approx(5.0, abs=6.0), (
        "a slow machine: nearly done all the same"
    )
    assert waiting_line.seconds_left(0.5, 25.0, 50.0, before=2) == pytest.approx(125.0)
    assert waiting_line.seconds_left(1.0, 70.0, 50.0) == 0.0
    late = [waiting_line.seconds_left(0.5, spent, 50.0) for spent in (20.0, 40.0, 80.0)]
    assert all(left > 0.0 for left in late), "never nothing before the end"


def test_effort_is_told_without_names(tmp_path):
    folder = new_visitor(tmp_path, "2026-11-21T10:00:00")
    write_person(folder, name="Anna", height_cm=None, consent="")
    write_visit(folder, waiting_line.with_effort(read_visit(folder), 40.0, 12, 3))
    told = effort.effort_csv(visits(tmp_path))
    assert told.splitlines()[1] == "visitor-001,2026-11-21 10:00,none,40,12,3,0"
    assert "Anna" not in told
    assert effort.median_effort(visits(tmp_path)) == (40.0, 12, 3)
    assert effort.median_effort({}) == (0.0, 0.0, 0.0)


def test_whose_time_is_over_is_found_also_without_a_photo(tmp_path):
    old, new = new_visitor(tmp_path, ""), new_visitor(tmp_path, "")
    write_person(old, name="Anna Long", height_cm=None, consent="yes")
    for path in old.iterdir():
        os.utime(path, (NOW.timestamp() - 31 * 86400,) * 2)
    for path in new.iterdir():
        os.utime(path, (NOW.timestamp() - 29 * 86400,) * 2)
    assert [one.identifier for one in retention.overdue_data(tmp_path, 30, NOW)] == ["visitor-001"]
    assert retention.overdue_data(tmp_path, 0, NOW) == ()
    (tmp_path / "notes.txt").write_text("Anna Long was here")
    assert retention.forget_visitors((old,), tmp_path) == ("notes.txt",)
    assert not old.exists()
    assert json.loads((new / "visit.json").read_text())["state"] == "none"


def test_a_lone_visitor_is_forgotten_without_looking_at_the_neighbours(tmp_path):
    folder = tmp_path / "anna"
    folder.mkdir()
    write_person(folder, name="Anna Long", height_cm=None, consent="")
    (tmp_path / "diary.txt").write_text("Anna Long")
    assert retention.forget_visitors((folder,), None) == ()
    assert [path.name for path in tmp_path.iterdir()] == ["diary.txt"]
