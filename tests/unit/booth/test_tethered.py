"""A camera on a cable, by a stand-in for gphoto2 that speaks as it does."""

import io

import numpy as np
import pytest
from PIL import Image

from cloner.booth.photos.camera import rotate_file
from cloner.booth.photos.tethered import Tethered, cameras_of
from cloner.errors import ClonerError
from kit.odd_programs import install

FOUND = """Model                          Port
----------------------------------------------------------
Canon EOS 600D                 usb:001,007
Nikon D90                      usb:001,009
"""


def jpeg(path, colour, size):
    Image.new("RGB", size, colour).save(path, quality=95)
    return path


@pytest.fixture
def camera(tmp_path, monkeypatch):
    """gphoto2 as a script: two red live pictures, and a blue photo."""
    live, photo = (
        jpeg(tmp_path / "live.jpg", (200, 20, 20), (96, 64)),
        jpeg(tmp_path / "p.jpg", (20, 20, 200), (60, 90)),
    )
    (tmp_path / "found").write_text(FOUND)
    script = f"""case "$1" in
--auto-detect) cat {tmp_path}/found;;
--stdout) cat {live} {live}; sleep 60;;
--capture-image-and-download) cp {photo} "$4";;
esac"""
    install(tmp_path, monkeypatch, gphoto2=script)
    return tmp_path


def test_models_are_read_from_what_gphoto2_tells():
    assert cameras_of(FOUND) == ("Canon EOS 600D", "Nikon D90")
    assert cameras_of(FOUND.split("Canon")[0]) == ()
    assert cameras_of("") == ()


def test_it_shows_live_pictures_and_takes_the_photo_as_the_camera_wrote_it(camera):
    tethered = Tethered()
    try:
        for _ in range(2):
            picture = tethered.read()
            assert picture.shape == (64, 96, 3)
            assert np.abs(picture.reshape(-1, 3).mean(axis=0) - (200, 20, 20)).max() < 6
        assert tethered.shoot() == (camera / "p.jpg").read_bytes()
        assert tethered.read().shape == (64, 96, 3), "the live picture goes on"
    finally:
        tethered.close()
    assert tethered._movie is None


def test_what_is_missing_is_told(tmp_path, monkeypatch, camera):
    (tmp_path / "found").write_text(FOUND.split("Canon")[0])
    with pytest.raises(ClonerError, match="no camera is found"):
        Tethered()
    install(tmp_path, monkeypatch, gphoto2="exit 1")
    with pytest.raises(ClonerError, match="does not answer"):
        Tethered()
    monkeypatch.setenv("PATH", "/nowhere")
    with pytest.raises(ClonerError, match="not installed"):
        Tethered()


def test_a_camera_that_shows_nothing_still_takes_photos_and_one_that_takes_none_is_told(camera, tmp_path, monkeypatch):
    tmp = tmp_path
    install(tmp, monkeypatch, gphoto2=f'case "$1" in --auto-detect) cat {tmp}/found;; esac')
    tethered = Tethered()
    assert tethered.read().std() == 0.0
    with pytest.raises(ClonerError, match="took no photo"):
        tethered.shoot()
    tethered.close()


def test_a_photo_of_a_camera_on_its_side_is_turned(tmp_path):
    data = jpeg(tmp_path / "x.jpg", (9, 9, 9), (60, 90)).read_bytes()
    assert rotate_file(data, 0) is data
    assert Image.open(io.BytesIO(rotate_file(data, 1))).size == (90, 60)
