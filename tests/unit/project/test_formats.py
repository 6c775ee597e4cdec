"""Files of older versions are read, and what they did not know yet is filled in."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np

from cloner.project.clone_file import load_clone, save_clone
from cloner.project.folder import read_person
from cloner.project.stamps import why_not_current
from kit.clones import toy_clone


def older_clone(path: Path) -> None:
    """Write a clone as the first version did: no regions, no kinds of shells, no stamp."""
    save_clone(toy_clone(), path)
    with np.load(path) as archive:
        arrays = {name: archive[name] for name in archive.files if name != "triangle_regions"}
    facts = json.loads(arrays["facts_json"].tobytes())
    for name in ("shell_kinds", "stamp", "sex", "age_years"):
        facts.pop(name)
    arrays["facts_json"] = np.frombuffer(json.dumps(facts).encode(), np.uint8)
    np.savez(path, **arrays)


def test_sex_and_age_are_kept_and_absurd_ones_of_a_file_are_not(tmp_path: Path) -> None:
    (tmp_path / "person.toml").write_text('sex = "f"\nage = 71\n')
    told = read_person(tmp_path)
    assert (told.sex, told.age_years) == ("f", 71.0)
    for sex, age, kept in (("f", 71.0, ("f", 71.0)), ("z", 1e9, ("", 0.0)), ("", float("nan"), ("", 0.0))):
        save_clone(replace(toy_clone(), sex=sex, age_years=age), tmp_path / "clone.npz")
        found = load_clone(tmp_path / "clone.npz")
        assert (found.sex, found.age_years) == kept


def test_clones_of_the_first_version(tmp_path: Path) -> None:
    older_clone(tmp_path / "clone.npz")
    clone = load_clone(tmp_path / "clone.npz")
    np.testing.assert_array_equal(clone.vertices_m, toy_clone().vertices_m)
    assert [shell.kind for shell in clone.shells] == ["hair"]
    assert (len(clone.triangle_regions), clone.stamp) == (0, "")


def test_a_person_without_a_format(tmp_path: Path) -> None:
    (tmp_path / "person.toml").write_text("height_cm = 171\n")
    assert read_person(tmp_path).stature_m == 1.71
    (tmp_path / "person.toml").write_text("format = 1\nheight_cm = 171\n")
    assert read_person(tmp_path).stature_m == 1.71


def test_results_from_before_stamps_are_made_again(tmp_path: Path) -> None:
    (tmp_path / "report.json").write_text(json.dumps({"format": 1, "person": {"name": "A"}}))
    assert why_not_current(tmp_path, {"cloner": "0.1.0"}) == "there is no complete result"
