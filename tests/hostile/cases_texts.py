"""person.toml, corrections.json and manifests that nobody can follow."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from hostile.cases import Case, file
from hostile.cases_photos import JPEG

Make = Callable[[Path], Path]
OUTSIDE = "outside 60 to 250 cm"
NO_TOML = "not valid TOML"
NO_JSON = "not valid JSON"
DEEP = 100_000


def beside(name: str, content: bytes | str) -> Make:
    """Return a maker of a visitor's folder with one photo and one file."""

    def make(folder: Path) -> Path:
        file("visitor/body_front.jpg", JPEG)(folder)
        return file(f"visitor/{name}", content)(folder).parent

    return make


def fifo(name: str) -> Make:
    def make(folder: Path) -> Path:
        path = beside("notes.txt", "x")(folder)
        os.mkfifo(path / name)
        return path

    return make


def link(name: str, target: str) -> Make:
    def make(folder: Path) -> Path:
        path = beside("notes.txt", "x")(folder)
        (path / name).symlink_to(target)
        return path

    return make


def inner_folder(name: str) -> Make:
    def make(folder: Path) -> Path:
        path = beside("notes.txt", "x")(folder)
        (path / name).mkdir()
        return path

    return make


def _person(name: str, text: bytes | str, words: str, hint: str, *, command: bool = False) -> Case:
    return Case(f"person: {name}", "person", beside("person.toml", text), words, hint, "person.toml", command)


_PERSON = (
    _person("no value", "height_cm =", NO_TOML, "height_cm = 172", command=True),
    _person("a comma", "height_cm = 172,5", NO_TOML, "height_cm = 172"),
    _person("not text", b"\xff\xfeh\x00", "cannot be read as text", "Check it"),
    _person("zeros", bytes(100), NO_TOML, "height_cm"),
    _person("a bracket without end", "[" * DEEP, NO_TOML, "height_cm"),
    _person("lists in lists", "notes = " + "[" * DEEP + "]" * DEEP, NO_TOML, "height_cm", command=True),
    _person("an endless number", "height_cm = " + "9" * 5000, NO_TOML, "height_cm", command=True),
    _person("a long number", "height_cm = " + "9" * 400, OUTSIDE, "centimetres"),
    _person("metres", "height_cm = 1.72", OUTSIDE, "centimetres"),
    _person("millimetres", "height_cm = 1720", OUTSIDE, "centimetres"),
    _person("inches", "height_cm = 5.9", OUTSIDE, "centimetres"),
    _person("nan", "height_cm = nan", OUTSIDE, "centimetres"),
    _person("minus infinity", "height_cm = -inf", OUTSIDE, "centimetres"),
    _person("true", "height_cm = true", "must be a number", "172"),
    _person("a date", "height_cm = 1979-05-27", "must be a number", "172"),
    _person("a list", "height_cm = [172]", "must be a number", "172"),
    _person("words", 'height_cm = "tall"', "must be a number", "172"),
    _person("an unknown key", "size = 172", "'size' is not known", "height_cm", command=True),
    _person("an unknown key with escapes", '"\\u001b[2J" = 1', "is not known", "height_cm", command=True),
    _person("an endless key", f"{'k' * 1_000_000} = 1", "is not known", "height_cm"),
    _person("a key twice", "height_cm = 170\nheight_cm = 171", NO_TOML, "height_cm"),
    _person("a number as name", "name = 7", "must be text", "quotes"),
    _person("a list as notes", "notes = [1]", "must be text", "quotes"),
    _person("a table as consent", "[consent]\na = 1", "must be text", "quotes"),
    _person("measures as a number", "measures = 3", "table", r"\[measures\]"),
    _person("measures as tables", "[[measures]]\nwaist = 70", "table", r"\[measures\]"),
    _person("an unknown measure", "[measures]\nfoo = 3", "'foo' is not known", "measures are"),
    _person("a slip in a measure", "[measures]\nwiast = 70", "'wiast' is not known", "waist"),
    _person("a measure in millimetres", "[measures]\nwaist = 702", "cannot be", "70.2"),
    _person("a measure without end", "[measures]\nwaist = " + "9" * 400, "must be a length|cannot be", "centimetres"),
    _person("a measure of nothing", "[measures]\nwaist = nan", "must be a length", "centimetres"),
    _person("too large", b"#" * 11_000_000, "larger than 10 MB", "Check it"),
    Case("person: a pipe", "person", fifo("person.toml"), "no ordinary file", "Check it", "person.toml", command=True),
    Case("person: a folder", "person", inner_folder("person.toml"), "no ordinary file", "Check it", "person.toml"),
    Case("person: a link out", "person", link("person.toml", "/etc/passwd"), "leads out", "file itself",
         "person.toml", command=True),
    Case("person: a device", "person", link("person.toml", "/dev/zero"), "leads out", "file itself", "person.toml"),
    Case("person: with a mark of byte order", "person", beside("person.toml", "\ufeffheight_cm = 170"), ""),
    Case("person: empty", "person", beside("person.toml", ""), ""),
    Case("person: of an older version", "person", beside("person.toml", 'name = "A"\nheight_cm = 170'), ""),
    _person("of a newer version", "format = 99\nheight_cm = 170", "newer version", "Update", command=True),
    _person("a format that is none", 'format = "one"', "format", "format = 1"),
)  # fmt: skip


def _points(entry: str) -> str:
    return f'{{"format": 1, "views": {{"body_front": {entry}}}}}'


def _corrected(name: str, text: bytes | str, words: str, *, command: bool = False) -> Case:
    return Case(f"corrections: {name}", "corrections", beside("corrections.json", text), words,
                "Correct|move|Update|Write", "corrections.json", command)  # fmt: skip


_CORRECTIONS = (
    _corrected("empty", "", NO_JSON),
    _corrected("half", '{"format": 1, "views": {"bo', NO_JSON, command=True),
    _corrected("not text", b"\x80\x81", "cannot be read as text"),
    _corrected("lists in lists", "[" * DEEP, NO_JSON, command=True),
    _corrected("a list", "[]", "must be an object"),
    _corrected("null", "null", "must be an object"),
    _corrected("no format", '{"views": {}}', '"format"'),
    _corrected("a newer format", '{"format": 99, "views": {}}', "newer version", command=True),
    _corrected("a format in words", '{"format": "one"}', '"format" must be'),
    _corrected("an unknown key", '{"format": 1, "extra": 1}', "'extra' is not known"),
    _corrected("views as a list", '{"format": 1, "views": []}', "must be an object"),
    _corrected("an unknown view", '{"format": 1, "views": {"left": {}}}', "not a view", command=True),
    _corrected("points as a list", _points("[]"), "must be an object"),
    _corrected("a point as a list", _points('{"crotch": [1, 2]}'), "must be an object"),
    _corrected("no y", _points('{"crotch": {"x": 1}}'), 'numbers "x" and "y"'),
    _corrected("words for numbers", _points('{"crotch": {"x": "1", "y": 2}}'), 'numbers "x" and "y"'),
    _corrected("true for a number", _points('{"crotch": {"x": true, "y": 2}}'), 'numbers "x" and "y"'),
    _corrected("NaN", _points('{"crotch": {"x": NaN, "y": 2}}'), 'numbers "x" and "y"', command=True),
    _corrected("infinity", _points('{"crotch": {"x": 1e999, "y": 2}}'), 'numbers "x" and "y"'),
    _corrected("a number without end", _points(f'{{"crotch": {{"x": 1{"0" * 400}, "y": 2}}}}'), 'numbers "x" and "y"',
               command=True),
    _corrected("digits without end", _points(f'{{"crotch": {{"x": {"9" * 5000}, "y": 2}}}}'), NO_JSON),
    _corrected("a digest as a number", _points('{"crotch": {"x": 1, "y": 2, "photo_sha256": 5}}'), "numbers"),
    _corrected("an unknown field", _points('{"crotch": {"x": 1, "y": 2, "z": 3}}'), "'z' is not known"),
    _corrected("outside the photo", _points('{"crotch": {"x": 9999, "y": 5}}'), "outside the photo"),
    _corrected("left of the photo", _points('{"crotch": {"x": -3, "y": 5}}'), "outside the photo"),
    _corrected("huge numbers", _points('{"crotch": {"x": 1e300, "y": 5}}'), "outside the photo"),
    _corrected("a third elbow", _points('{"third_elbow": {"x": 5, "y": 5}}'), "no feature point"),
    _corrected("a tag as a name", _points('{"<script>": {"x": 5, "y": 5}}'), "no feature point"),
    Case("corrections: a pipe", "corrections", fifo("corrections.json"), "no ordinary file", "Check", "corrections"),
    Case("corrections: a link out", "corrections", link("corrections.json", "/etc/passwd"), "leads out", "file itself"),
    Case("corrections: a missing photo", "corrections", beside("corrections.json", '{"format": 1, "views": '
         '{"body_back": {"crotch": {"x": 1, "y": 2}}}}'), ""),
)  # fmt: skip


def manifest(name: str, content: bytes | str, *folders: str) -> Make:
    """Return a maker of a manifest beside folders of photos."""

    def make(folder: Path) -> Path:
        for one in (*folders, "anna", "carl"):
            file(f"root/{one}/body_front.jpg", JPEG)(folder)
        (folder / "outside").mkdir()
        return file(f"root/{name}", content)(folder)

    return make


def _csv(name: str, text: bytes | str, words: str, *, command: bool = False) -> Case:
    return Case(f"csv: {name}", "visitors", manifest("list.csv", text), words, " ", "list.csv|carl", command)


def _toml(name: str, text: bytes | str, words: str) -> Case:
    return Case(f"toml: {name}", "visitors", manifest("list.toml", text), words, " ", "list.toml")


BESIDE = "beside or below"
_MANIFESTS = (
    _csv("a way up", "photos\n../outside\n", BESIDE, command=True),
    _csv("an absolute path", "photos\n/etc\n", BESIDE),
    _csv("a way up inside", "photos\nanna/../../outside\n", BESIDE),
    _csv("nothing", 'photos\n""\n', BESIDE),
    _csv("a NUL", "photos\nan\0na\n", "name|read"),
    _csv("no height", "photos,height_cm\nanna,tall\n", "no height"),
    _csv("an unknown column", "photos,colour\nanna,red\n", "unknown column"),
    _csv("too many cells", "photos\nanna,boris\n", "more cells than columns", command=True),
    _csv("two of one name", "photos,id\nanna,x\ncarl,x\n", "both be called x"),
    _csv("two alike after cleaning", "photos,id\nanna,a/b\ncarl,a?b\n", "both be called a-b"),
    _csv("not text", b"photos\n\xff\xfe\n", "read as text"),
    _csv("a cell without end", "photos\n" + "x" * 200_000, "cannot be read"),
    _csv("too large", b"x" * 11_000_000, "larger than 10 MB"),
    _toml("broken", "[[visitor]\n", "cannot be read"),
    _toml("a table", "[visitor]\nphotos = 'anna'", "tables are missing"),
    _toml("numbers", "visitor = [1, 2]", "tables are missing"),
    _toml("a way up", "[[visitor]]\nphotos = '../outside'", BESIDE),
    _toml("lists in lists", "visitor = " + "[" * DEEP, "cannot be read"),
    _toml("an endless number", "[[visitor]]\nphotos='anna'\nheight_cm = " + "9" * 5000, "cannot be read"),
    _toml("a number too long for a float", "[[visitor]]\nphotos='anna'\nheight_cm = " + "9" * 400, "no height"),
    _toml("a list as height", "[[visitor]]\nphotos='anna'\nheight_cm = [1]", "no height"),
    Case("toml: nobody", "visitors", manifest("list.toml", ""), "nobody|no folder|names no visitor", " ", "list.toml"),
    Case("csv: nobody", "visitors", manifest("list.csv", ""), "nobody|no folder|names no visitor", " ", "list.csv"),
    Case("csv: a missing folder", "row", manifest("list.csv", "photos\nzoe\n"), "no such folder", "folder", "zoe"),
    Case("csv: an endless quote", "row", manifest("list.csv", 'photos\n"zo\ne\n'), "no such folder", "folder", "zo"),
    Case("csv: a linked folder", "visitors", lambda folder: _linked_row(folder), BESIDE, "Move", "list.csv"),
    Case("root: missing", "visitors", lambda folder: folder / "nowhere", "no such folder", "folder", "nowhere"),
    Case("root: empty", "visitors", inner_folder("empty"), "", ""),
    Case("root: only results", "visitors", file("root/anna/report.json", "{}"), "no such folder", "folder", "report"),
    Case("root: only links", "visitors", lambda folder: _linked_root(folder), "no folder below it", "folder", "root",
         command=True),
    Case("root: two of one name", "visitors", lambda folder: _twins(folder), "both be called a-b", "Rename"),
    Case("shard: words", "shard", manifest("a-of-b.csv", "photos\nanna\n"), "is no shard", "0/4", "--shard"),
    Case("list: missing", "held", lambda folder: folder / "nowhere", "no such folder", "--photos", "nowhere",
         command=True),
)  # fmt: skip


def _linked_row(folder: Path) -> Path:
    path = manifest("list.csv", "photos\nlink\n")(folder)
    (path.parent / "link").symlink_to(folder / "outside")
    return path


def _linked_root(folder: Path) -> Path:
    file("outside/anna/body_front.jpg", JPEG)(folder)
    root = folder / "root"
    root.mkdir()
    (root / "anna").symlink_to(folder / "outside" / "anna")
    (root / "loop").symlink_to(root)
    return root


def _twins(folder: Path) -> Path:
    for name in ("a b", "a?b"):
        file(f"root/{name}/body_front.jpg", JPEG)(folder)
    return folder / "root"


CASES = (*_PERSON, *_CORRECTIONS, *_MANIFESTS)
