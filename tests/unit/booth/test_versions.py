"""The clone before: kept when another is made of the same photos, brought back and forth, whole after a crash."""

import json
import os
import shutil

import pytest

from cloner.booth.visitors import versions
from cloner.errors import ClonerError

PHOTOS = {"body_front": "abc"}


def make(visitor, text, photos=PHOTOS):
    """Make a result, as a run does: a new folder in the old one's place."""
    result = visitor / "clones" / "visitor-001"
    shutil.rmtree(result, ignore_errors=True)
    result.mkdir(parents=True)
    (result / "clone.npz").write_text(text)
    (result / "report.json").write_text(json.dumps({"stamp": {"photos": photos}}))
    (visitor / "work").mkdir(exist_ok=True)
    values = visitor / "work" / "new.npz"
    values.write_text(f"values of {text}")
    values.replace(visitor / "work" / "values.npz")


def again(visitor, text, photos=PHOTOS):
    with versions.keep_previous(visitor, "visitor-001", photos):
        make(visitor, text, photos)


def state(visitor):
    return (
        (visitor / "clones" / "visitor-001" / "clone.npz").read_text(),
        (visitor / "work" / "values.npz").read_text(),
    )


def test_the_clone_before_comes_back_with_its_values_and_goes_again(tmp_path):
    again(tmp_path, "first")
    assert not versions.has_previous(tmp_path), "there was none"
    again(tmp_path, "second")
    assert versions.has_previous(tmp_path)
    assert state(tmp_path) == ("second", "values of second")
    versions.swap_with_previous(tmp_path, "visitor-001")
    assert state(tmp_path) == ("first", "values of first")
    versions.swap_with_previous(tmp_path, "visitor-001")
    assert state(tmp_path) == ("second", "values of second")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["clone_before", "clones", "work"]


def test_a_clone_that_fails_leaves_both(tmp_path):
    again(tmp_path, "first")
    again(tmp_path, "second")
    with pytest.raises(ZeroDivisionError), versions.keep_previous(tmp_path, "visitor-001", PHOTOS):
        raise ZeroDivisionError
    assert state(tmp_path)[0] == "second"
    versions.swap_with_previous(tmp_path, "visitor-001")
    assert state(tmp_path)[0] == "first"


def test_a_clone_of_other_photos_is_not_kept(tmp_path):
    again(tmp_path, "first")
    again(tmp_path, "second", {"body_front": "def"})
    assert not versions.has_previous(tmp_path)
    with pytest.raises(ClonerError, match="no clone before"):
        versions.swap_with_previous(tmp_path, "visitor-001")


class Killed(BaseException):
    pass


@pytest.mark.parametrize("moment", range(6))
def test_an_exchange_that_is_killed_ends_with_both_clones_whole(tmp_path, monkeypatch, moment):
    again(tmp_path, "first")
    again(tmp_path, "second")
    count = [0]

    def dying(does):
        def step(*arguments, **more):
            if count[0] == moment:
                raise Killed
            count[0] += 1
            return does(*arguments, **more)

        return step

    with monkeypatch.context() as patch:
        for owner, name in ((type(tmp_path), "rename"), (os, "replace"), (shutil, "rmtree")):
            patch.setattr(owner, name, dying(getattr(owner, name)))
        with pytest.raises(Killed):
            versions.swap_with_previous(tmp_path, "visitor-001")
    versions.finish_swap(tmp_path, "visitor-001")
    now = state(tmp_path)
    assert now in (("first", "values of first"), ("second", "values of second"))
    assert versions.has_previous(tmp_path)
    versions.swap_with_previous(tmp_path, "visitor-001")
    assert {now[0], state(tmp_path)[0]} == {"first", "second"}
    assert state(tmp_path)[1] == f"values of {state(tmp_path)[0]}"
