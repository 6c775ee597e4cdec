"""The language of films: what it understands, and what it says of the rest."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from cloner.errors import ClonerError
from cloner.scenes.films.sequence import Key, Order, parse_sequence, read_sequence

BEGIN = """film "A night" for 12 s, 640 x 360, 10 frames a second
actor first is anna at 3, 4 facing 90 in stone, .3 m deep   # a comment
actor second is anybody at 5, 4, head at 6, 3
rows army of 2 x 3 from 0, 8 to 2, 12
at 0 s: camera at 7, -6, 1.7 looks at first, lens 30
"""


def said(line: str) -> str:
    with pytest.raises(ClonerError) as told:
        parse_sequence(BEGIN + line, "a.film")
    return told.value.message


def test_actors_and_rows_stand_where_they_are_told_to() -> None:
    film = parse_sequence(BEGIN, "a.film")
    assert (film.title, film.seconds, film.size_px, film.rate_hz) == ("A night", 12.0, (640, 360), 10.0)
    first, second = film.actors[:2]
    assert (first.clone, first.at, first.facing_deg, first.stone, first.up) == ("anna", (3.0, 4.0), 90.0, True, -0.3)
    assert (second.clone, second.stone, second.head_at) == ("", False, (6.0, 3.0))
    assert film.groups["army"] == (2, 3, 4, 5, 6, 7)
    assert [one.at for one in film.actors[2:]] == [(0, 8), (2, 8), (0, 10), (2, 10), (0, 12), (2, 12)]


def test_what_happens_is_kept_with_its_time() -> None:
    film = parse_sequence(
        BEGIN
        + "at 1 s: first awakens in 4 s\nat 2.5 s: army walks by 0, -3 happy\nat 3 s: first turns to second\n"
        + 'at 4 s: light .1, .2, .3 in 2 s\nat 5 s: caption "Who am I?" for 2 s\n'
        + 'at 6 s: first gives second the head in 3 s\nat 7 s: army says "all of us.fr.txt"\nat 8 s: first feels sad\n',
        "a.film",
    )  # fmt: skip
    assert Key(1.0, "stone", (0.0,), 4.0, (0,)) in film.keys
    assert Key(4.0, "light", (0.1, 0.2, 0.3), 2.0) in film.keys
    assert film.orders == [
        Order(2.5, (2, 3, 4, 5, 6, 7), "walks by", (0.0, -3.0), word="happy"), Order(3.0, (0,), "turns", who=1),
        Order(8.0, (0,), "feels", word="sad"),
    ]  # fmt: skip
    assert film.captions == [(5.0, 7.0, "Who am I?")]
    assert film.heads == [(6.0, 0, 1, 3.0)]
    assert film.speeches == [(7.0, (2, 3, 4, 5, 6, 7), "all of us.fr.txt")]


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("actors third is anna at 1, 1", "line 6, column 1: 'actors' stands where film, actor, rows or at was"),
        ("at 3 s first awakens", "line 6, column 8: 'first' stands where ':' was expected"),
        ("at 3 s: third awakens", "column 9: 'third' stands where one of first, second, army was expected"),
        ("at 3 s: first awakes", "column 15: 'awakes' stands where awakens, hardens, rises, walks, runs, turns, does"),
        ("at 3 s: first does sing for 2 s", "column 20: 'sing' stands where look, wave,"),
        ("at -3 s: first awakens", "column 4: '-3' stands where a time in seconds from 0 to 1800 was expected"),
        ("at 3 s: light 1, 2", "column 19: the line's end stands where ',' was expected"),
        ("at 3 s: light 1, 2, 99", "column 21: '99' stands where red, green, blue from 0 to 10 was expected"),
        ('at 3 s: first says "../hello.wav"', "where the name of a .wav or .txt file beside the film was expected"),
        ("at 3 s: first says hello", "column 20: 'hello' stands where a file's name in quotes"),
        ("at 3 s: first gives army the head in 2 s", "somebody whose head lies somewhere"),
        ("actor first is anna at 1, 1", "column 7: 'first' stands where a name that is not taken was expected"),
        ("rows all of 500 x 500 from 0, 0 to 9, 9", "at most 2000 actors"),
        ("at 3 s: first awakens quickly", "column 23: 'quickly' stands where the line's end was expected"),
        ("at 3 s: caption \x1b[31mred", "stands where a text in quotes was expected"),
    ],
)  # fmt: skip
def test_what_is_not_understood_is_told_with_its_place_and_what_was_expected(line: str, told: str) -> None:
    message = said(line)
    assert told in message
    assert message.isprintable()


def test_a_film_without_camera_or_actors_is_refused() -> None:
    with pytest.raises(ClonerError, match="nobody plays"):
        parse_sequence('film "none"\n', "a.film")
    with pytest.raises(ClonerError, match="no camera"):
        parse_sequence("actor first is anna at 3, 4\n", "a.film")
    with pytest.raises(ClonerError, match="before it moves"):
        parse_sequence("actor first is anna at 3, 4\nat 0 s: camera moves to 1, 1, 1 looks at 0, 0, 0 in 2 s", "a.film")


def test_the_sample_and_every_line_of_the_documents_are_understood() -> None:
    root = Path(__file__).parents[3]
    film = read_sequence(root / "samples" / "awakening.film")
    assert (film.seconds, len(film.actors)) == (62.0, 50)
    assert [one.head_at for one in film.actors if one.head_at] == [(7.42, 8.68)]
    rows = re.findall(r"^\| `((?:film|actor|rows|at) [^`]*)`", (root / "docs" / "scenes.md").read_text(), flags=re.M)
    assert len(rows) >= 12
    cast = "actor second is anna at 7, 9, head at 7, 8\nat 0 s: camera at 1, 1, 1 looks at second\n"
    begin = [one for one in rows if not one.startswith("at ")]
    for one in [*begin, *(one for one in rows if one.startswith("at "))]:
        parse_sequence("\n".join([*begin, cast, *([one] if one.startswith("at ") else [])]), one)
