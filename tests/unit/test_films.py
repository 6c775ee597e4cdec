"""A turntable is a film of the clone turning once."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
from PIL import Image

from cloner.errors import ClonerError
from cloner.picture import draw_file, turntable
from cloner.vision.photographs.films import write_film
from kit.clones import toy_clone


def moving_square(count: int = 6) -> list[np.ndarray]:
    pictures = []
    for number in range(count):
        picture = np.full((41, 61, 3), 220, dtype=np.uint8)
        picture[10:30, 4 + 6 * number : 20 + 6 * number] = (200, 30, 30)
        pictures.append(picture)
    return pictures


@pytest.mark.parametrize("suffix", [".gif", ".webp"])
def test_films_of_pillow_come_back_with_their_pictures_and_times(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"film{suffix}"
    write_film(moving_square(), 10.0, path)
    with Image.open(path) as film:
        assert film.n_frames == 6
        assert film.info["loop"] == 0
        for number, picture in enumerate(moving_square()):
            film.seek(number)
            film.load()
            assert film.info["duration"] == 100
            assert np.abs(np.asarray(film.convert("RGB")).astype(int) - picture).mean() < 6


def test_an_mp4_comes_back_with_its_pictures(tmp_path: Path) -> None:
    path = tmp_path / "film.mp4"
    write_film(moving_square(), 10.0, path)
    film = cv2.VideoCapture(str(path))
    assert film.get(cv2.CAP_PROP_FPS) == pytest.approx(10.0)
    for picture in moving_square():
        read, seen = film.read()
        assert read
        assert np.abs(seen[..., ::-1].astype(int) - picture[:40, :60]).mean() < 12
    assert not film.read()[0]


def test_the_clone_turns_by_its_left_side() -> None:
    """The red left hand is on the picture's right from the front, in the middle a quarter turn later, then left."""
    places = []
    for picture in turntable(toy_clone(), 120, 180, frames=4):
        red = (picture[..., 0] > 150) & (picture[..., 1] < 90)
        places.append(float(np.flatnonzero(red.any(axis=0)).mean()) if red.any() else None)
    assert places[0] > 75
    assert 35 < places[1] < 75
    assert places[2] < 35


def test_a_turntable_wants_the_name_of_a_film(tmp_path: Path) -> None:
    with pytest.raises(ClonerError) as caught:
        draw_file(tmp_path, "turntable", tmp_path / "turn.png")
    assert ".gif" in caught.value.hint
