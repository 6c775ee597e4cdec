"""Films and pictures of packs tell whom they show, without a name, and go with whoever is forgotten."""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
from PIL import Image

from cloner.crowd.packs.held import FILMED, FILMS, film_tokens, find_films
from cloner.personal_data.holdings import find_holding, holdings
from cloner.personal_data.privacy import forget
from cloner.project.results import RESULT_MARK, file_digest
from cloner.project.stamps import photos_token
from cloner.vision.photographs.films import png_text, write_film

ANNA, BORIS = photos_token(["1" * 64, "2" * 64]), photos_token(["3" * 64])
PEOPLE = [{"id": "anna", "stamp": f"Cloner 1, photos {ANNA}"}, {"id": "boris", "stamp": f"Cloner 1, photos {BORIS}"}]


def film(path: Path, told: str) -> Path:
    pictures = [np.full((32, 48, 3), 60 * k, np.uint8) for k in range(4)]
    if path.suffix == ".png":
        Image.fromarray(pictures[1]).save(path, pnginfo=png_text(told))
    else:
        write_film(pictures, 10.0, path, told)
    return path


@pytest.mark.parametrize("suffix", FILMS)
def test_a_film_tells_whose_photos_it_shows_and_still_opens(tmp_path: Path, suffix: str) -> None:
    told = film_tokens(PEOPLE)
    path = film(tmp_path / f"show{suffix}", told)
    film(tmp_path / f"other{suffix}", film_tokens(PEOPLE[1:]))
    film(tmp_path / f"nobody{suffix}", "")
    assert "anna" not in told
    assert list(find_films(tmp_path, {ANNA})) == [path]
    assert len(list(find_films(tmp_path, {BORIS}))) == 2
    if suffix == ".mp4":
        opened = cv2.VideoCapture(str(path))
        assert sum(opened.read()[0] for _ in range(6)) == 4
    else:
        with Image.open(path) as shown:
            assert getattr(shown, "n_frames", 1) == (1 if suffix == ".png" else 4)


def test_who_is_forgotten_goes_from_films_and_others_films_stay(tmp_path: Path) -> None:
    result = tmp_path / "out" / "anna"
    result.mkdir(parents=True)
    (result / "clone.npz").write_bytes(b"clone")
    outputs = {"clone.npz": file_digest(result / "clone.npz")}
    photos = {"body_front": "1" * 64, "face_front": "2" * 64}
    (result / RESULT_MARK).write_text(json.dumps({"format": 3, "stamp": {"photos": photos}, "outputs": outputs}))
    out = tmp_path / "out"
    (out / "pictures").mkdir()
    mine = [film(out / "show.mp4", film_tokens(PEOPLE)), film(out / "pictures" / "00001.png", film_tokens(PEOPLE))]
    theirs = film(out / "boris.mp4", film_tokens(PEOPLE[1:]))
    other = out / "holiday.mp4"
    other.write_bytes(b"")
    assert forget(find_holding("anna", holdings(None, out)), None, out) == ()
    assert not any(one.exists() for one in mine)
    assert theirs.exists()
    assert other.exists()


def test_a_film_s_mark_alone_shows_nobody(tmp_path: Path) -> None:
    (tmp_path / "a.png").write_bytes(FILMED.encode() + b" zz")
    (tmp_path / "b.mp4").symlink_to(tmp_path / "a.png")
    assert list(find_films(tmp_path, {ANNA})) == []
