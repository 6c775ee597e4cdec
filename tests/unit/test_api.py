"""``from cloner import clone``: photos by folder or by view, heights in metres, errors in sentences."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from PIL import Image

import cloner
from cloner import making
from cloner.errors import ClonerError
from cloner.frames import ViewId
from kit.clones import toy_clone


@pytest.fixture
def taken(monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """Replace the pipeline by a finished clone and return what it was given."""
    given: dict[str, Any] = {}

    def clone_photos(photos, person, corrections, **options):
        given.update(photos=photos, person=person, corrections=corrections, **options)
        return {"clone": toy_clone(1.6)}, []

    monkeypatch.setattr(making, "clone_photos", clone_photos)
    return given


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in ("body_front", "face_front"):
        Image.new("RGB", (90, 120), (120, 90, 70)).save(tmp_path / f"{name}.png")
    (tmp_path / "person.toml").write_text("height_cm = 181\n")
    return tmp_path


def test_a_folder_brings_its_own_height_and_a_given_one_wins(folder: Path, taken: dict[str, Any]) -> None:
    made = cloner.clone(folder)
    assert made.stature_m == pytest.approx(1.6)
    assert set(taken["photos"].photos) == {ViewId.BODY_FRONT, ViewId.FACE_FRONT}
    assert taken["person"].stature_m == pytest.approx(1.81)
    cloner.clone(str(folder), 1.5, seed=3, texture_size=1024)
    assert taken["person"].stature_m == pytest.approx(1.5)
    assert (taken["seed"], taken["texture_size"]) == (3, 1024)


def test_files_by_view(folder: Path, taken: dict[str, Any]) -> None:
    cloner.clone({"face_front": folder / "face_front.png"})
    assert list(taken["photos"].photos) == [ViewId.FACE_FRONT]
    assert not taken["person"].stature_is_known


@pytest.mark.parametrize(
    ("photos", "height_m", "words"),
    [
        ({"front": "face_front.png"}, None, "no view"),
        ({"body_side": "body_front.png"}, None, "front photo is needed"),
        ({"body_front": "body_front.png"}, 180.0, "outside"),
        ({"body_front": "body_front.png"}, float("nan"), "outside"),
        ({"body_front": "nobody.png"}, 1.8, "photo"),
    ],
)
def test_mistakes_are_told(folder: Path, taken: dict[str, Any], photos, height_m, words) -> None:
    with pytest.raises(ClonerError, match=words):
        cloner.clone({view: folder / name for view, name in photos.items()}, height_m)


def test_other_names_are_no_part_of_the_package() -> None:
    with pytest.raises(AttributeError):
        _ = cloner.clones
