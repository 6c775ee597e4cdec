"""Pages lead where they say, are sorted, and those made from the code are up to date."""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
PAGES = sorted([*ROOT.glob("*.md"), *DOCS.rglob("*.md")])
CODE = sorted(
    path
    for folder in ("cloner", "gui", "benchmarks", "generic_models", "tests")
    for path in (ROOT / folder).rglob("*.py")
)
KINDS = ("Tutorial", "How-to", "Reference", "Explanation")


def test_links_lead_to_files() -> None:
    dead = []
    for page in PAGES:
        for link in re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8")):
            if "://" not in link and not (page.parent / link).exists():
                dead.append(f"{page.relative_to(ROOT)}: {link}")
    assert not dead


def test_pages_that_code_and_pages_name_exist() -> None:
    named = {}
    for path in (*CODE, *PAGES):
        for page in re.findall(r"\bdocs/[\w/-]+\.md", path.read_text(encoding="utf-8")):
            named.setdefault(page, path.relative_to(ROOT))
    assert len(named) > 20
    written = {"docs/textures.md"}  # a benchmark writes it where it is told to
    assert not {page: where for page, where in named.items() if not (ROOT / page).is_file() and page not in written}


def test_every_page_is_sorted() -> None:
    index = (DOCS / "README.md").read_text(encoding="utf-8")
    sections = dict(
        zip(re.findall(r"^## ([\w-]+):", index, re.M), re.split(r"^## .*$", index, flags=re.M)[1:], strict=True)
    )
    assert tuple(sections) == KINDS
    for page in DOCS.rglob("*.md"):
        name = page.relative_to(DOCS).as_posix()
        if name != "README.md" and not re.match(r"decisions/\d", name):
            kinds = [kind for kind, text in sections.items() if f"]({name})" in text]
            assert len(kinds) == 1, f"{name}: {kinds}"


def test_every_decision_has_its_row() -> None:
    rows = (DOCS / "decisions" / "README.md").read_text(encoding="utf-8")
    assert not [page.name for page in (DOCS / "decisions").glob("2*.md") if f"]({page.name})" not in rows]


@pytest.mark.parametrize(("page", "word"), [("cloning", "[Mm]ethod"), ("walkers", "walkers")])
def test_notes_that_code_cites_by_number_are_there(page: str, word: str) -> None:
    there = set(re.findall(r"^## §(\d+)", (DOCS / "method" / f"{page}.md").read_text(encoding="utf-8"), re.M))
    cited = {n for path in CODE for n in re.findall(rf"{word} §(\d+)", path.read_text(encoding="utf-8"))}
    assert cited
    assert cited <= there


def test_the_first_screen_is_one() -> None:
    """A newcomer sees what it is, how to try it and where to go on before anything else."""
    start = (ROOT / "README.md").read_text(encoding="utf-8").partition("\n## ")[0]
    assert start.count("\n") < 50
    for needed in ("make demo", "cloner clone", "docs/tutorial.md", "docs/README.md", "from cloner import clone"):
        assert needed in start


def test_pages_made_from_the_code_are_up_to_date() -> None:
    spec = importlib.util.spec_from_file_location("make_reference", DOCS / "make_reference.py")
    assert spec is not None
    assert spec.loader is not None
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    for name, page in made.PAGES.items():
        assert (DOCS / name).read_text(encoding="utf-8") == page(), f"make docs writes docs/{name} anew"


RULES = re.findall(
    r"^\| [^|`]+ \| `([^`]+)` \| `([^`]+)` \| (`.*`) \|$", (DOCS / "algorithms.md").read_text(encoding="utf-8"), re.M
)


@pytest.mark.parametrize(("word", "file", "functions"), RULES)
def test_a_rule_is_found_in_one_search(word: str, file: str, functions: str) -> None:
    """The first lines of modules name it, once or twice, and its functions are where the table says."""
    assert len(RULES) >= 8
    code = [path for path in CODE if path.is_relative_to(ROOT / "cloner")]
    heads = {
        path.relative_to(ROOT / "cloner").as_posix(): path.read_text(encoding="utf-8").split("\n\n")[0] for path in code
    }
    found = [name for name, head in heads.items() if word.lower() in head.lower()]
    assert file in found
    assert len(found) <= 2, found
    text = (ROOT / "cloner" / file).read_text(encoding="utf-8")
    assert all(f"\ndef {name}(" in text for name in re.findall(r"`(\w+)`", functions))
