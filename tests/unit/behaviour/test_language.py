"""The scenario language: what it says, what is wrong with line and column, and that Python says the same."""

from __future__ import annotations

from pathlib import Path

import pytest

from cloner.behaviour.checking import check_scenario
from cloner.behaviour.language import parse_actions, parse_scenario, read_scenario
from cloner.behaviour.model import Action, Feeling, Follows, Group, Point, Rule, Scenario, Shape, Thing, When, Who
from cloner.behaviour.world import make_world
from cloner.errors import ClonerError

MUSEUM = Path(__file__).resolve().parents[3] / "samples" / "museum.crowd"
SMALL = """floor 0, 0 to 9, 6
point desk at 2, 2 act pay for 4 s one at a time
point art at 6, 4 region 2 x 1.5 look at cat
statue cat at 8, 5
"""


def sentence(text: str) -> str:
    with pytest.raises(ClonerError) as caught:
        parse_scenario(text, "a.crowd")
    return str(caught.value)


def test_text_and_python_are_equal() -> None:
    text = SMALL + (
        'scene "hall.glb"\n'
        "crowd 7 guests: emotion happy 80 %, knows desk and art\n"
        "group two: 2 people, leader emerging, visits desk > art again, memory 3, likes guests 0.7,\n"
        "    follows guests for 5 s, flocking, adapts to space, starts at art   # the end\n"
        "at 60 s: cat awakens, clear art for 3 s\n"
        "when two see cat awake: they become afraid, they run to desk\n"
    )
    made = Scenario(
        scene="hall.glb",
        floors=(Shape(((0, 0), (9, 0), (9, 6), (0, 6))),),
        points=(Point("desk", (2, 2), act="pay", seconds=4, holds=1), Point("art", (6, 4), (2, 1.5), look_at="cat")),
        things=(Thing("cat", (8, 5)),),
        groups=(
            Group("guests", 7, alone=True, feelings=Feeling("happy", 80), knows=("desk", "art")),
            Group(
                "two",
                2,
                leader="emerging",
                visits=("desk", "art"),
                again=True,
                memory=3,
                likes=(("guests", 0.7),),
                follows=Follows("guests", 5),
                flocking=True,
                adapts=True,
                starts_at="art",
            ),
        ),
        rules=(
            Rule(
                When("at", seconds=60), (Action("awaken", Who("name", "cat")), Action("clear", what="art", seconds=3))
            ),
            Rule(
                When("sees", Who("name", "two"), "cat", awake=True),
                (Action("become", Who("they"), "afraid"), Action("run", Who("they"), "desk")),
            ),
        ),
    )
    assert parse_scenario(text) == check_scenario(made)


@pytest.mark.parametrize(
    ("line", "column", "words", "expected"),
    [
        ("flor 0, 0 to 3, 3", 1, "'flor' does not fit", "floor"),
        ("floor 0, 0 fro 3, 3", 12, "'fro' does not fit", "Expected: to"),
        ("point door at 1", 16, "the end of the line does not fit", "a comma"),
        ("point door at 1, 1 region 3", 28, "the end of the line does not fit", "x"),
        ("group a: 3 people, visits dusk", 27, "there is no point called dusk", "Did you mean desk"),
        ("group a: 3 people, emotion jolly", 28, "there is no emotion called jolly", "Known: sad"),
        ("group a: 0 people", 7, "a has nobody", "one person or more"),
        ("group a: 3 people, memory 2, memory 3", 7, "a is told its memory twice", "Keep one"),
        ("statue cat at 1, 1", 8, "there are two things called cat", "another name"),
        ("point far at 99999, 1", 7, "far is too far away", "Stay within"),
        ("obstacle rope at 3, 3 size 0 x 1", 10, "rope has no area", "three corners"),
        ("at 3 s: nobody go to desk", 9, "there is no group called nobody", "Give one"),
        ("at 3 s: they go to desk", 0, "'they' means nobody here", "everybody"),
        ("group a: 2 people\nwhen a sees dog: a goes to desk", 13, "there is no thing or group called dog", "Known"),
    ],
)
def test_what_is_wrong_is_shown_with_its_place(line: str, column: int, words: str, expected: str) -> None:
    told = sentence(f"{SMALL}{line}\n")
    number = 5 + line.count("\n")
    assert words in told
    assert expected in told
    if column:
        assert (
            f"a.crowd, line {number}, column {column}:" in told or f"scenario, line {number}, column {column}:" in told
        )


@pytest.mark.parametrize(
    "text", ["", "\x00", "floor", "(" * 5000, "floor 1e400, 0 to 1, 1", "point " * 1000, "#", "é: ü", '"']
)
def test_hostile_text_is_one_sentence(text: str) -> None:
    told = sentence(text)
    assert "\n" not in told
    assert len(told) < 900


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (SMALL, "a scenario of 0 people"),
        (f"{SMALL}crowd 100000 all\n", "a scenario of 100000 people"),
        ("crowd 3 all\n", "nothing to walk on"),
    ],
)
def test_nobody_and_too_many(text: str, words: str) -> None:
    assert words in sentence(text)


def test_people_that_do_not_fit_and_places_on_no_floor() -> None:
    with pytest.raises(ClonerError, match="do not fit"):
        make_world(parse_scenario("floor 0, 0 to 3, 3\ncrowd 90 all\n"))
    with pytest.raises(ClonerError, match="nobody can stand at moon"):
        make_world(parse_scenario("floor 0, 0 to 3, 3\npoint moon at 20, 20\ncrowd 2 all\n"))
    with pytest.raises(ClonerError, match="nobody fits"):
        make_world(parse_scenario("floor 0, 0 to 3, 0.3\ncrowd 1 all\n"))


def test_orders_are_lines_of_the_same_language() -> None:
    scenario = read_scenario(MUSEUM)
    assert parse_actions("school goes to door, split school into 2", scenario) == (
        Action("go", Who("name", "school"), "door"), Action("split", Who("name", "school"), count=2)
    )  # fmt: skip
    with pytest.raises(
        ClonerError, match=r"order, line 1, column 16: there is no point called dor\. Did you mean door"
    ):
        parse_actions("school goes to dor", scenario)


def test_a_scenario_that_is_none(tmp_path: Path) -> None:
    (tmp_path / "a.crowd").write_bytes(b"\xff\xfe\x00")
    for path in (tmp_path / "a.crowd", tmp_path / "missing.crowd", tmp_path):
        with pytest.raises(ClonerError, match="cannot be read"):
            read_scenario(path)
