"""An ear that the photo shows elsewhere is found by its hairline."""

import cv2
import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.cameras.visibility import compute_visibility
from cloner.paint.lookups.ear_match import shift_ear
from kit import people, studio


@pytest.fixture(scope="module")
def profile():
    """Return a head's vertices, triangles, what a camera at its right sees, and hair all around its ear."""
    generic = load_generic()
    person = people.known_person(51, spread=0.3)
    camera = studio.camera(-90.0, distance_m=1.3, height_m=1.55, aim_m=1.5, size_px=(1200, 1600), focal_35mm=75)
    triangles = body_triangles()
    visibility = compute_visibility(person.vertices_m, triangles, camera)
    ear = (
        generic.region("ear_right")
        if visibility.cosine[generic.region("ear_right")].mean() > 0
        else generic.region("ear_left")
    )
    picture = np.zeros((1600, 1200), np.uint8)
    hull = cv2.convexHull(visibility.pixel_px[ear].astype(np.float32)).astype(np.int32)
    cv2.fillPoly(picture, [hull], 255)
    middle = visibility.pixel_px[ear].mean(axis=0)
    forward = np.sign(visibility.pixel_px[generic.feature("nose_tip"), 0] - middle[0])
    row, column = np.mgrid[:1600, :1200]
    near = np.hypot(column - middle[0], row - middle[1]) < 200
    beside = (forward * (column - middle[0]) < 20) & (row - middle[1] < 40)
    return generic, person.vertices_m, triangles, visibility, ear, near & beside & (picture == 0)


@pytest.mark.parametrize("shift_mm", [(8.0, 12.0), (-12.0, 4.0)])
def test_the_ear_follows_its_hairline_and_the_chin_stays(profile, shift_mm):
    generic, vertices, triangles, visibility, ear, hair = profile
    shift_px = np.array(shift_mm) / (1000 * visibility.metres_per_pixel / 2)
    moved = (
        cv2.warpAffine(hair.astype(np.uint8), np.array([[1, 0, shift_px[0]], [0, 1, shift_px[1]]]), (1200, 1600)) > 0
    )
    lookup = shift_ear(generic, vertices, triangles, visibility, moved, ViewId.FACE_SIDE, visibility.pixel_px)
    step_mm = (lookup - visibility.pixel_px) * 1000 * visibility.metres_per_pixel / 2
    assert np.linalg.norm(np.median(step_mm[ear], axis=0) - shift_mm) < 4.0
    assert not step_mm[generic.feature("chin_front")].any()


def test_without_hair_beside_it_the_ear_stays(profile):
    generic, vertices, triangles, visibility, _, hair = profile
    far = np.zeros_like(hair)
    far[:100] = True
    assert np.array_equal(
        shift_ear(generic, vertices, triangles, visibility, far, ViewId.FACE_SIDE, visibility.pixel_px),
        visibility.pixel_px,
    )
