"""Photos are sorted by what they show, and judged while the visitor is there; on the samples with the real nets."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from cloner.booth.photos.check_cache import read_checks, store_check
from cloner.booth.photos.photo_check import check_photo, edge_width, find_problems
from cloner.booth.photos.photo_problems import PhotoCheck, PhotoProblem
from cloner.frames import ViewId
from cloner.project.folder import load_photos
from cloner.records.proposals import Proposal


@pytest.fixture(scope="module")
def seen(samples):
    """Every photo of a sample in a busy background, looked at without its name."""
    photos = load_photos(samples / "boris" / "booth").photos
    return {view: (photo, *check_photo(replace(photo, view=ViewId.FACE_SIDE), None)) for view, photo in photos.items()}


@pytest.mark.slow
def test_five_photos_without_names_find_their_views_and_are_good(seen):
    for view, (_, told, proposal) in seen.items():
        assert told.view is view
        assert told.troubles == ()
        assert proposal.view is view


@pytest.mark.slow
def test_a_photo_of_another_view_is_told(seen):
    photo = seen[ViewId.BODY_BACK][0]
    told, _ = check_photo(photo, ViewId.BODY_FRONT)
    assert told == seen[ViewId.BODY_BACK][1], "what a photo shows does not depend on where it is put"
    assert told.view is ViewId.BODY_BACK
    assert PhotoProblem.OTHER_VIEW in told.troubles_as(ViewId.BODY_FRONT)
    assert told.troubles_as(ViewId.BODY_BACK) == ()


@pytest.mark.slow
@pytest.mark.parametrize(("view", "quarters"), [(ViewId.BODY_SIDE, 1), (ViewId.BODY_FRONT, 3), (ViewId.FACE_FRONT, 1)])
def test_a_photo_that_lies_on_its_side_shows_no_view(seen, view, quarters):
    lying = replace(seen[view][0], rgb=np.ascontiguousarray(np.rot90(seen[view][0].rgb, quarters)))
    told, proposal = check_photo(lying, None)
    assert told.view is None
    assert told.troubles in ((PhotoProblem.LYING,), (PhotoProblem.NOBODY,))
    assert proposal is None


@pytest.mark.slow
def test_an_empty_room_shows_nobody(seen):
    room = replace(seen[ViewId.BODY_FRONT][0], rgb=np.full((900, 600, 3), 180, np.uint8))
    assert check_photo(room, None) == (PhotoCheck(room.digest, None, (PhotoProblem.NOBODY,)), None)


@pytest.mark.slow
@pytest.mark.parametrize("view", [ViewId.BODY_FRONT, ViewId.FACE_FRONT])
def test_bad_light_and_blur_are_told(seen, view):
    photo, _, proposal = seen[view]
    assert find_problems(photo.rgb, proposal) == ()
    softened = cv2.GaussianBlur(np.asarray(photo.rgb), (0, 0), 4.0)
    assert find_problems(softened, proposal) == (PhotoProblem.BLURRED,)
    dark = (0.15 * photo.rgb).astype(np.uint8)
    assert PhotoProblem.DARK in find_problems(dark, proposal)
    burnt = np.clip(2.2 * photo.rgb.astype(float), 0, 255).astype(np.uint8)
    assert PhotoProblem.BRIGHT in find_problems(burnt, proposal)


def figure(view=ViewId.BODY_FRONT, top=20, bottom=180, left=40, right=80):
    """Return what the nets would say of a plain figure in a photo of 120 x 200 px."""
    mask = np.zeros((200, 120), np.uint8)
    mask[top:bottom, left:right] = 255
    pose = np.full((33, 2), 60.0)
    pose[:, 1] = top + 0.15 * (bottom - top)
    return Proposal(view, pose, np.ones(33), np.zeros((468, 2)), np.zeros(468), 0.0, mask, np.zeros_like(mask))


def sharp(value=120):
    """Return a photo full of sharp edges."""
    rng = np.random.default_rng(0)
    return (value + rng.integers(-60, 60, (200, 120, 1)) * np.ones((1, 1, 3))).astype(np.uint8)


@pytest.mark.parametrize(
    ("proposal", "wanted"),
    [
        (figure(), ()),
        (figure(top=0), (PhotoProblem.CUT,)),
        (figure(bottom=200), (PhotoProblem.CUT,)),
        (figure(left=0), (PhotoProblem.CUT,)),
        (figure(top=100, bottom=180), (PhotoProblem.SMALL,)),
        (figure(ViewId.FACE_FRONT, top=20, bottom=200, left=0, right=120), ()),
        (figure(ViewId.FACE_FRONT, top=0, bottom=200), (PhotoProblem.CUT,)),
    ],
)
def test_the_person_must_be_whole_and_large_in_the_frame(proposal, wanted):
    if proposal.view.is_face:
        proposal.pose_px.flags.writeable = True
        proposal.pose_px[9:11, 1] = 80.0
    found = [one for one in find_problems(sharp(), proposal) if one is not PhotoProblem.BLURRED]
    assert tuple(found) == wanted


def test_the_width_of_edges_follows_the_blur():
    ruled = np.kron(np.indices((25, 15)).sum(0) % 2, np.ones((40, 40))) * 200.0 + 20.0
    person = np.ones(ruled.shape, bool)
    widths = [edge_width(cv2.GaussianBlur(ruled, (0, 0), s).astype(np.uint8), person) for s in (0.5, 1.5, 3.0)]
    assert widths == sorted(widths)
    assert widths[2] > 1.8 * widths[0]
    assert edge_width(np.full((50, 50), 9, np.uint8), np.ones((50, 50), bool)) == 1.0, "no edge at all is no sharp one"


def test_looks_are_kept_and_a_broken_file_is_looked_up_anew(tmp_path):
    views = frozenset((ViewId.FACE_SIDE, ViewId.FACE_FRONT))
    one, two = (
        PhotoCheck("a", ViewId.FACE_SIDE, (PhotoProblem.DARK, PhotoProblem.CUT), views),
        PhotoCheck("b", None, ()),
    )
    store_check(tmp_path, one)
    store_check(tmp_path, two)
    assert read_checks(tmp_path) == {"a": one, "b": two}
    (tmp_path / "work" / "looks.json").write_text(
        '{"a": {"view": "moon", "troubles": []}, "b": {"view": null, "troubles": [], "passes": []}}'
    )
    assert read_checks(tmp_path) == {"b": two}
