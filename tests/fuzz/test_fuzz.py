"""No bytes whatever get more out of a parser than a sentence; what was once found stays found."""

from __future__ import annotations

import contextlib
import json
import random
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from cloner.errors import ClonerError, printable
from cloner.frames import ViewId
from cloner.project import corrections
from cloner.project.folder import LONGEST_IDENTIFIER, safe_identifier
from cloner.records.points import Correction, Corrections
from fuzz.mutate import mutated
from fuzz.targets import TARGETS, check
from hostile import cases_photos

FINDINGS = sorted((Path(__file__).parent / "findings").glob("*-*"))
bounded = settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])


@pytest.mark.parametrize("name", TARGETS)
def test_good_files_are_read(name: str, tmp_path: Path) -> None:
    target = TARGETS[name]
    for seed in target.seeds():
        if seed == cases_photos.heic():
            continue  # a HEIC head without a picture
        path = tmp_path / target.file
        path.write_bytes(seed)
        if name in ("csv", "toml"):  # the photos' names differ from the folder's alone
            check(name, seed, tmp_path)
        else:
            target.read(path)


@pytest.mark.parametrize("name", TARGETS)
@bounded
@given(seed=st.integers(0, 2**32 - 1))
def test_changed_files(name: str, seed: int, tmp_path: Path) -> None:
    rng, seeds = random.Random(seed), TARGETS[name].seeds()
    check(name, mutated(rng.choice(seeds), rng, seeds), tmp_path)


@pytest.mark.parametrize("name", TARGETS)
@bounded
@given(data=st.binary(max_size=200))
def test_any_bytes(name: str, data: bytes, tmp_path: Path) -> None:
    check(name, data, tmp_path)


@pytest.mark.parametrize("path", FINDINGS, ids=[path.name for path in FINDINGS])
def test_what_was_found_once(path: Path, tmp_path: Path) -> None:
    check(path.name.split("-")[0], path.read_bytes(), tmp_path)


json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from(["x", "y", "crotch", "q"]), inner),
    max_leaves=8,
)


@bounded
@given(views=st.dictionaries(st.sampled_from([*ViewId, "left"]), json_values), version=st.just(1) | json_values)
def test_corrections_of_any_shape(views: dict[str, Any], version: Any) -> None:
    text = json.dumps({"format": version, "views": views})
    with contextlib.suppress(ClonerError):
        found = corrections.from_json(text)
        assert version == 1
        assert set(found.points) <= set(ViewId)


places = st.floats(-1e6, 1e6)
points = st.builds(Correction, places, places, st.text("0123456789abcdef", max_size=8))


@bounded
@given(st.dictionaries(st.sampled_from(list(ViewId)), st.dictionaries(st.text(min_size=1), points, min_size=1)))
def test_corrections_come_back_as_they_went(views: dict[ViewId, dict[str, Correction]]) -> None:
    again = corrections.from_json(corrections.to_json(Corrections(points=views)))
    assert {view: dict(named) for view, named in again.points.items()} == views


@settings(max_examples=300)
@given(st.text() | st.binary().map(lambda raw: raw.decode("utf-8", "surrogateescape")))
def test_identifiers_are_one_harmless_component(name: str) -> None:
    safe = safe_identifier(name)
    assert 0 < len(safe.encode()) <= LONGEST_IDENTIFIER + len("visitor-")
    assert safe.isprintable()
    assert not set(safe) & set('/\\:*?"<>|')
    assert not safe.startswith((".", "-"))
    assert ".." not in safe
    assert safe_identifier(safe) == safe


@settings(max_examples=300)
@given(st.text(max_size=2000))
def test_sentences_are_one_short_plain_line(text: str) -> None:
    error = ClonerError(text, text, text)
    assert str(error).isprintable() or not text
    assert len(str(error)) < 1300
    assert printable(printable(text)) == printable(text)
