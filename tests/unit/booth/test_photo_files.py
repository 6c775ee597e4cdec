"""Photos as files: nothing without consent, nothing overwritten, nothing lost."""

import numpy as np
import pytest
from PIL import Image

from cloner.booth.photos import arrivals, photo_files
from cloner.booth.visitors.person_file import write_person
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project.folder import view_files
from cloner.vision.photographs.pictures import read_picture

FRONT, BACK = ViewId.BODY_FRONT, ViewId.BODY_BACK


def jpeg(tmp_path, value, size=(80, 120)):
    path = tmp_path / f"{value}.jpg"
    Image.new("RGB", size, (value, value, value)).save(path)
    return path.read_bytes()


@pytest.fixture
def visitor(tmp_path):
    folder = tmp_path / "visitor-001"
    folder.mkdir()
    write_person(folder, name="", height_cm=None, consent="yes")
    return folder


def level(path):
    return int(np.asarray(Image.open(path)).mean().round())


def test_without_consent_not_one_byte_is_stored(tmp_path):
    with pytest.raises(ClonerError, match="agreed"):
        photo_files.store_photo(tmp_path, b"x", ".jpg")
    assert list(tmp_path.iterdir()) == []


def test_what_is_no_photo_is_refused(visitor):
    with pytest.raises(ClonerError, match="no photo"):
        photo_files.store_photo(visitor, b"x", ".pdf")


def test_the_newest_photo_of_a_view_counts_and_the_old_one_stays_in_the_tray(visitor, tmp_path):
    for value in (10, 200):
        path = photo_files.store_photo(visitor, jpeg(tmp_path, value), ".JPG")
        photo_files.place_new(visitor, path, FRONT)
    assert level(view_files(visitor)[FRONT]) == 200
    assert [level(path) for path in photo_files.tray_photos(visitor)] == [10]


def test_a_photo_of_no_view_waits_in_the_tray(visitor, tmp_path):
    new = photo_files.store_photo(visitor, jpeg(tmp_path, 10), ".png")
    assert photo_files.new_photos(visitor) == (new,)
    assert photo_files.intended_view(new) is None
    path = photo_files.place_new(visitor, new, None)
    assert photo_files.new_photos(visitor) == ()
    assert photo_files.tray_photos(visitor) == (path,)
    assert view_files(visitor) == {}


def test_exchanging_also_with_an_empty_place_and_another_kind_of_file(visitor, tmp_path):
    (visitor / "body_front.jpg").write_bytes(jpeg(tmp_path, 10))
    Image.new("RGB", (8, 8), (200, 200, 200)).save(visitor / "body_back.png")
    photo_files.swap_views(visitor, FRONT, BACK)
    assert {view: level(path) for view, path in view_files(visitor).items()} == {FRONT: 200, BACK: 10}
    photo_files.remove(view_files(visitor)[BACK])
    photo_files.swap_views(visitor, FRONT, BACK)
    assert {view: level(path) for view, path in view_files(visitor).items()} == {BACK: 200}
    assert photo_files.tray_photos(visitor) == ()


@pytest.mark.parametrize("suffix", [".jpg", ".png"])
def test_four_quarter_turns_give_the_photo_back(tmp_path, suffix):
    path = tmp_path / f"photo{suffix}"
    pixels = np.zeros((90, 120, 3), np.uint8)
    pixels[:20, :30] = (250, 10, 10)
    Image.fromarray(pixels).save(path, **({"quality": 95, "subsampling": 0} if suffix == ".jpg" else {}))
    first = read_picture(path).rgb
    photo_files.rotate_right(path)
    once = read_picture(path).rgb
    assert once.shape == (120, 90, 3)
    assert once[5, -5, 0] > 200, "the upper left corner went to the upper right"
    assert np.abs(once.astype(int) - np.rot90(first, -1)).max() == 0
    for _ in range(3):
        photo_files.rotate_right(path)
    assert np.abs(read_picture(path).rgb.astype(int) - first).max() == 0


def test_a_damaged_file_is_told(tmp_path):
    path = tmp_path / "photo.jpg"
    path.write_bytes(b"no jpeg")
    with pytest.raises(ClonerError, match="cannot be turned"):
        photo_files.rotate_right(path)
    assert path.read_bytes() == b"no jpeg"


def test_file_names_tell_what_they_are_meant_for():
    assert photo_files.view_of_name("Body_Front.JPG") is FRONT
    assert photo_files.view_of_name("DSC_0012.jpg") is None


def test_only_whole_new_photos_have_arrived(tmp_path):
    old, new, growing = (tmp_path / name for name in ("old.jpg", "new.jpg", "growing.jpg"))
    old.write_bytes(b"123")
    known = arrivals.photo_sizes(tmp_path)
    new.write_bytes(b"1234")
    growing.write_bytes(b"1")
    (tmp_path / "notes.txt").write_text("x")
    last = arrivals.photo_sizes(tmp_path)
    growing.write_bytes(b"12")
    now = arrivals.photo_sizes(tmp_path)
    assert arrivals.complete_photos(known, last, now) == (new,)
    assert arrivals.complete_photos(known, now, now) == (growing, new)
    assert arrivals.photo_sizes(tmp_path / "pulled cable") == {}


def test_a_stored_photo_says_what_it_is_meant_for_until_it_is_placed(visitor, tmp_path):
    new = photo_files.store_photo(visitor, jpeg(tmp_path, 10), ".jpg", BACK)
    assert photo_files.intended_view(new) is BACK
    assert photo_files.new_photos(visitor) == (new,)
    photo_files.place_new(visitor, new, photo_files.intended_view(new))
    assert view_files(visitor) == {BACK: visitor / "body_back.jpg"}
    again = photo_files.move_to_tray(visitor, visitor / "body_back.jpg")
    assert photo_files.new_photos(visitor) == (), "taken out by hand: it stays where it was put"
    assert photo_files.tray_photos(visitor) == (again,)


def test_a_photo_that_is_held_is_decoded_once_and_anew_when_its_file_changes(visitor, tmp_path):
    path = visitor / f"{FRONT}.jpg"
    path.write_bytes(jpeg(tmp_path, 10))
    first = photo_files.placed_photos(visitor).photos[FRONT]
    assert photo_files.placed_photos(visitor).photos[FRONT] is first
    path.write_bytes(jpeg(tmp_path, 200))
    after = photo_files.placed_photos(visitor).photos[FRONT]
    assert after.digest != first.digest
    assert int(after.rgb.mean().round()) == 200
