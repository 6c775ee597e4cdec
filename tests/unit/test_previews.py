"""Previews show photo and clone through one camera, and marks where they were measured."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PIL import Image
from scipy.ndimage import binary_erosion, distance_transform_edt
from skimage.measure import find_contours

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.head.jaw import jaw_rotations
from cloner.previews import same_distance, scaled_camera, write_previews
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import PointSet, ViewPoints
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import Silhouette, SilhouetteSet
from cloner.render import render, render_mask, standard_camera
from kit.clones import toy_clone

VIEW = ViewId.BODY_FRONT
BACKDROP = (226, 228, 230)


@pytest.fixture(scope="module")
def clone():
    return toy_clone(1.70)


@pytest.fixture(scope="module")
def inputs(clone):
    """A photo that is a picture of the clone itself, its silhouette, and one corrected point on the nose."""
    posed = clone.views[VIEW]
    mask = render_mask(clone, posed.camera, posed.rotations)
    photo = Photo(VIEW, render(clone, posed.camera, posed.rotations, background=BACKDROP), None, "", "body_front.png")
    contours = tuple(line[:, ::-1] for line in find_contours(mask.astype(float), 0.5))
    nose = np.array([[201.0, 60.0], [150.0, 400.0]])
    points = ViewPoints(VIEW, ("nose_tip", "knee"), nose, np.ones(2), np.array([True, False]))
    return (
        PhotoSet({VIEW: photo}),
        Proposals({}),
        (PointSet({VIEW: points}),),
        SilhouetteSet({VIEW: Silhouette(VIEW, contours, mask, ())}),
    )


@pytest.fixture(scope="module")
def folder(clone, inputs, tmp_path_factory):
    out = tmp_path_factory.mktemp("result")
    paths = write_previews(clone, *inputs, out)
    assert sorted(paths) == sorted((out / "previews").iterdir())
    return out / "previews"


def test_only_photographed_views_stand_beside_the_clone(folder):
    assert {path.stem for path in folder.iterdir()} == {
        "beside_body_front", "overlay_body_front", "three_quarter", "face", "head",
    }  # fmt: skip


def test_photo_and_clone_are_the_same_where_the_photo_shows_the_clone(folder):
    both = np.asarray(Image.open(folder / "beside_body_front.jpg")).astype(int)
    photo, drawn = np.split(both, 2, axis=1)
    assert photo.std() > 20
    assert np.abs(photo - drawn).mean() < 2.0, "a shift of two pixels gives five and more"


def test_a_mouth_that_a_photo_shows_open_is_shown_shut(clone, inputs, folder, tmp_path):
    posed = clone.views[VIEW]
    opened = posed.rotations + jaw_rotations(load_generic(), 0.3)
    laughing = replace(clone, views={VIEW: replace(posed, rotations=opened)})
    assert np.abs(render(laughing, posed.camera, opened).astype(int) - render(clone, posed.camera)).max() > 50
    write_previews(laughing, *inputs, tmp_path)
    shown, shut = (np.asarray(Image.open(one / "beside_body_front.jpg")) for one in (tmp_path / "previews", folder))
    assert np.array_equal(shown, shut)


def test_outlines_run_along_the_silhouette(folder, inputs):
    overlay = np.asarray(Image.open(folder / "overlay_body_front.jpg")).astype(int)
    mask = inputs[3].views[VIEW].mask
    rows, columns = (np.flatnonzero(mask.any(axis=axis)) for axis in (1, 0))
    air = 0.05 * (rows[-1] - rows[0])
    top, left = int(max(rows[0] - air, 0)), int(max(columns[0] - air, 0))
    window = mask[top : top + overlay.shape[0], left : left + overlay.shape[1]]
    rim = window & ~binary_erosion(window, border_value=1)
    near = distance_transform_edt(~rim)
    green = np.abs(overlay - (40, 220, 60)).sum(axis=2) < 120
    magenta = np.abs(overlay - (255, 40, 220)).sum(axis=2) < 150
    for marks in (green, magenta):
        assert np.count_nonzero(marks) > 200
        assert np.percentile(near[marks], 95) < 4.0
    yellow = np.abs(overlay - (255, 210, 0)).sum(axis=2) < 110
    assert np.abs(np.argwhere(yellow).mean(axis=0) - [60 - top, 201 - left]).max() < 3.0


def test_a_scaled_camera_projects_to_scaled_pixels(clone):
    camera = clone.views[VIEW].camera
    half = scaled_camera(camera, 0.5)
    points = clone.vertices_m[::500]
    assert half.project(points) == pytest.approx((camera.project(points) + 0.5) * 0.5 - 0.5, abs=1e-9)


def test_a_strip_shows_every_side_at_one_scale(folder, clone):
    strip = np.asarray(Image.open(folder / "three_quarter.jpg")).astype(int)
    columns = (np.abs(strip - BACKDROP).max(axis=2) > 24).any(axis=0)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], columns.astype(int), [0]])))
    people = [strip[:, a:b] for a, b in zip(edges[::2], edges[1::2], strict=True) if b - a > 40]
    assert len(people) == 4
    tall = [np.ptp(np.flatnonzero((np.abs(each - BACKDROP).max(axis=2) > 24).any(axis=1))) for each in people]
    assert max(tall) / min(tall) < 1.05, "perspective alone gives three percent"


def test_evenly_scaled_cameras_keep_their_line_of_sight(clone):
    before = [standard_camera(clone, view, 400, 400) for view in ("front", "left", "back")]
    after = same_distance(before)
    scales = [camera.metres_per_pixel(np.array([0.0, 0.9, 0.0])) for camera in after]
    assert scales == pytest.approx([max(scales)] * 3, rel=1e-3)
    for old, new in zip(before, after, strict=True):
        assert new.camera_from_model[:3, :3] == pytest.approx(old.camera_from_model[:3, :3])
        assert new.camera_from_model[:2, 3] == pytest.approx(old.camera_from_model[:2, 3])


def test_an_unwritable_folder_is_an_operator_s_error(clone, inputs, tmp_path):
    (tmp_path / "previews").write_text("in the way")
    with pytest.raises(ClonerError):
        write_previews(clone, *inputs, tmp_path)
