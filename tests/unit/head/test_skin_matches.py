"""What the front photo shows of the face is found in the side photo, at the depth where it truly lies."""

import cv2
import numpy as np
import pytest

from cloner.generic.load import load_generic
from cloner.head.skin_matches import match_front_to_side
from cloner.records.views import Camera

WIDTH, HEIGHT = 500, 600


def camera(azimuth_deg, target):
    c, s = np.cos(np.radians(azimuth_deg)), np.sin(np.radians(azimuth_deg))
    pose = np.eye(4)
    pose[:3, :3] = np.array([[c, 0, -s], [0, -1, 0], [-s, 0, -c]])
    pose[:3, 3] = np.array([0.0, 0.0, 1.1]) - pose[:3, :3] @ target
    return Camera(WIDTH, HEIGHT, 2200.0, pose)


def painted(vertices, grey, seen_by):
    """Return a picture of the head with its own grey values, painter's algorithm."""
    triangles, _ = load_generic().triangles()
    triangles = triangles[(vertices[triangles, 1] > 1.4).all(axis=1)]
    depth = seen_by.to_camera(vertices[triangles].mean(axis=1))[:, 2]
    pixels = np.round(seen_by.project(vertices) * 16).astype(np.int32)
    out = np.full((HEIGHT, WIDTH, 3), 128, np.uint8)
    for row in np.argsort(-depth):
        cv2.fillConvexPoly(out, pixels[triangles[row]], [int(grey[triangles[row]].mean())] * 3, cv2.LINE_8, 4)
    return out


@pytest.mark.parametrize(("azimuth_deg", "side"), [(90.0, 0), (-90.0, 1)])
def test_places_are_found_where_they_lie_and_not_where_the_fit_has_them(azimuth_deg, side):
    generic, rng = load_generic(), np.random.default_rng(3)
    vertices = generic.vertices_m.astype(np.float64)
    grey = 128.0 + 90.0 * np.sin(vertices @ rng.normal(0.0, 500.0, (3, 4)) + rng.uniform(0, 6, 4)).mean(axis=1)
    target = vertices[generic.feature("nasion")] - [0.0, 0.03, 0.06]
    cameras = (camera(0.0, target), camera(azimuth_deg, target))
    pictures = tuple(painted(vertices, grey, c) for c in cameras)
    fitted = vertices + [0.0, 0.0, 0.004]  # the whole face 4 mm too far forward
    found = match_front_to_side(generic, (fitted, fitted), cameras, pictures, side=side)
    assert len(found.vertices) >= 2
    metres = cameras[1].metres_per_pixel(target)
    error = np.linalg.norm(found.points_px - cameras[1].project(vertices[found.vertices]), axis=1) * metres
    before = np.linalg.norm(
        cameras[1].project(fitted[found.vertices]) - cameras[1].project(vertices[found.vertices]), axis=1
    )
    assert np.median(error) < 0.0015
    assert np.median(before * metres) > 0.0035


def test_nothing_is_found_in_a_picture_without_detail():
    generic = load_generic()
    vertices = generic.vertices_m.astype(np.float64)
    target = vertices[generic.feature("nasion")]
    blank = np.full((HEIGHT, WIDTH, 3), 128, np.uint8)
    found = match_front_to_side(
        generic, (vertices, vertices), (camera(0.0, target), camera(90.0, target)), (blank, blank), side=0
    )
    assert len(found.vertices) == 0
