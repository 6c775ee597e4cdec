"""Names are text: never a tag, a formula, a script, a node or a path in anything that is written."""

from __future__ import annotations

import csv
import json
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pygltflib
import pytest

from cloner.cloning import CloneOutcome
from cloner.exporters import meshes
from cloner.exporters.gltf import gltf
from cloner.exporters.vrml import vrml97, x3d
from cloner.motion.face.faps import COUNT, FapStream, fap_text
from cloner.motion.moves.own import own_motions
from cloner.project.manifest import find_visitors
from cloner.records.batches import CLONED, FAILED, BatchRow
from cloner.report.batch import write_summary
from cloner.report.page import page
from cloner.report.viewer import viewer_page
from hostile.cases_photos import JPEG
from kit.clones import toy_clone

HOSTILE = (
    '<script>alert(1)</script>',
    '"><img src=x onerror=alert(1)>',
    "'); DROP TABLE clones; --",
    '"] } DEF evil Script { url "javascript:alert(1)" } WorldInfo { info ["',
    "]]></Scene><Inline url='http://evil'/>",
    "=HYPERLINK(\"http://evil\")",
    "+1+1", "-1+1", "@SUM(A1)", "\t=1+1", "\r=1+1",
    "a\nb\x00c\x1b[2J",
    "\u202egnp.exe",
    "javascript:alert(1)",
    "../../etc/passwd",
    "{{7*7}} ${7*7} %s %n",
    "</title></style></script>",
)  # fmt: skip


class Tags(HTMLParser):
    """Collects the tags and the attributes that could run or load something."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.active: list[tuple[str, str | None]] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.active += [(key, value) for key, value in attrs if key.startswith("on") or key in ("src", "href")]


def report_for(outcome: CloneOutcome, text: str) -> dict[str, object]:
    """Return a report that says a text wherever a visitor or an operator could have written it."""
    report = json.loads(json.dumps(outcome.report))
    report["person"] |= {"name": text, "identifier": text, "notes": text}
    report["warnings"] = [text]
    report["measures_mm"]["note"] = text
    point = {"view": text, "name": text, "kind": text, "px_before": 1.0, "px_after": 1.0, "moved_mm": 1.0, "note": text}
    report["corrections"] = [point]
    for photo in report["photos"].values():
        photo["file"] = text
    return report


@pytest.mark.parametrize("text", HOSTILE)
def test_the_report_gains_no_tag(cloned_anna: CloneOutcome, text: str) -> None:
    plain, hostile = Tags(page(report_for(cloned_anna, "Anna"))), Tags(page(report_for(cloned_anna, text)))
    assert hostile.tags == plain.tags
    assert hostile.active == plain.active


@pytest.mark.parametrize("text", HOSTILE)
def test_the_viewer_gains_no_tag(text: str) -> None:
    plain, hostile = Tags(viewer_page("Anna", b"glTF")), Tags(viewer_page(text, b"glTF"))
    assert hostile.tags == plain.tags
    assert hostile.active == plain.active


@pytest.mark.parametrize("text", HOSTILE)
def test_the_batchs_tables_gain_neither_tags_nor_formulas(tmp_path: Path, text: str) -> None:
    rows = [BatchRow(text, CLONED, 1.0, 0, text, 0.9), BatchRow("b", FAILED, 1.0, 0, text)]
    (tmp_path / "b").mkdir()
    write_summary(rows, 2, tmp_path)
    html = Tags((tmp_path / "batch.html").read_text(encoding="utf-8"))
    assert set(html.tags) <= {"html", "head", "meta", "title", "style", "body", "h1", "h2", "ul", "li", "p", "img", "a"}
    assert all(value is None or not value.lower().startswith(("javascript:", "http")) for _, value in html.active)
    assert not any(key.startswith("on") for key, _ in html.active)
    with (tmp_path / "batch.csv").open(encoding="utf-8", newline="") as stream:
        cells = [cell for row in csv.reader(stream) for cell in row]
    assert not any(cell.lstrip(" \t\r\n")[:1] in tuple("=+-@") for cell in cells if cell)
    assert len(cells) == 3 * 6
    assert json.loads((tmp_path / "batch.json").read_text(encoding="utf-8"))["rows"][0]["message"] == text


@pytest.mark.parametrize("text", HOSTILE)
def test_folders_with_such_names_become_harmless_identifiers(tmp_path: Path, text: str) -> None:
    folder = tmp_path / "root" / text.replace("/", "_").replace("\0", "").lstrip(".")  # hidden folders are left out
    folder.mkdir(parents=True)
    (folder / "body_front.jpg").write_bytes(JPEG)
    (one,) = find_visitors(tmp_path / "root")
    assert all(letter.isalnum() or letter in "_.-" for letter in one.identifier)


def test_every_page_forbids_what_it_does_not_need(cloned_anna: CloneOutcome, tmp_path: Path) -> None:
    write_summary([BatchRow("a", CLONED, 1.0, 0, "fine", 0.9)], 1, tmp_path)
    pages = [cloned_anna.folder / "report.html", cloned_anna.folder / "viewer.html", tmp_path / "batch.html"]
    for path in pages:
        text = path.read_text(encoding="utf-8")
        told = text.index('http-equiv="Content-Security-Policy"')
        assert told < text.index("<style>"), "a policy holds for what comes after it"
        assert "default-src 'none'" in text[told:]
        if path.name != "viewer.html":
            assert "script-src" not in text, "no script at all"
            assert "<script" not in text


def test_names_of_captures_stay_strings_in_gltf(tmp_path: Path) -> None:
    clone = toy_clone(hair=False)
    walk = own_motions(clone)[0]
    (written,) = gltf.export(clone, tmp_path, moves=lambda _: [replace(walk, name=text) for text in HOSTILE])
    names = [animation.name for animation in pygltflib.GLTF2().load_binary(str(written)).animations]
    assert tuple(names[-len(HOSTILE) :]) == HOSTILE


@pytest.mark.parametrize("text", HOSTILE)
def test_names_of_captures_stay_one_word_in_fap(text: str) -> None:
    stream = FapStream(25.0, np.ones((2, COUNT)), np.ones((2, COUNT), dtype=bool))
    lines = fap_text(stream, text).splitlines()
    assert len(lines[0].split()) == 4
    assert len(lines) == 1 + 2 * 2


def test_what_is_written_holds_no_word_of_the_visitor_at_all(tmp_path: Path) -> None:
    """VRML, X3D, OBJ and glTF know only the clone; their parsers see the nodes we wrote."""
    clone = toy_clone()
    for module_export in (vrml97.export, x3d.export, gltf.export, meshes.export_obj):
        module_export(clone, tmp_path)
    assert "Script" not in (tmp_path / "clone.wrl").read_text()
    tree = ElementTree.parse(tmp_path / "clone.x3d")
    assert not {element.tag for element in tree.iter()} & {"Script", "Inline", "Anchor"}
