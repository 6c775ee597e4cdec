"""Random people are what their truth says: dressed at the drawn ease, standing flat, seen by the told camera."""

import numpy as np
import pytest

from cloner.generic.load import load_generic
from kit.scripts import script

pytestmark = pytest.mark.gl

SIZE_PX = (400, 600)
people = script("painted_people")
clothes = script("painted_people_clothes")
bodies = script("painted_people_bodies")


def once(seed, azimuth, **options):
    return people.photograph_once(seed, azimuth, size_px=SIZE_PX, **options)


def ease_mm(seed, tightness):
    """Return how far cloth lies outside the skin along its normal, mm, at the coarse vertices it covers."""
    body, dressed = people.known_body(seed, tightness, "plain", splits=0)
    count = len(body.vertices_m)
    triangles, _ = load_generic().triangles()
    normals = people.vertex_normals(body.vertices_m, triangles)
    away = np.einsum("va,va->v", dressed.vertices_m[:count] - body.vertices_m, normals)
    return 1e3 * away[dressed.kind[:count] == clothes.CLOTH]


@pytest.mark.parametrize(("tightness", "least", "most"), [("tight", 1.5, 6), ("regular", 4, 16), ("loose", 10, 40)])
def test_clothes_have_the_ease_of_their_tightness_and_stay_outside(tightness, least, most):
    for seed in (1, 2, 3):
        found = ease_mm(seed, tightness)
        assert least < np.median(found) < most, f"{tightness}, seed {seed}"
        assert np.percentile(found, 0.5) > -6.0, f"{tightness}, seed {seed}: cloth inside the skin"


def test_clothes_change_neither_body_nor_girths():
    tight, _ = people.known_body(5, "tight", "plain", splits=0)
    loose, _ = people.known_body(5, "loose", "cluttered", splits=0)
    assert np.array_equal(tight.vertices_m, loose.vertices_m)
    assert bodies.naked_girths_mm(tight) == bodies.naked_girths_mm(loose)


def test_statures_spread_and_are_those_of_the_mesh():
    generic, statures = load_generic(), []
    for seed in range(12):
        body = bodies.random_body(generic, np.random.default_rng([seed, 0]))
        statures.append(body.stature_m)
        skin = body.vertices_m[generic.part("body"), 1]
        assert skin.max() == pytest.approx(body.stature_m, abs=1e-6), seed
        assert skin.min() == pytest.approx(0.0, abs=0.006), f"seed {seed}: soles on the floor"
    assert 1.45 <= min(statures) < 1.62 < 1.78 < max(statures) <= 1.95


def test_people_stand_on_one_floor_with_limbs_jittered():
    generic = load_generic()
    body = bodies.random_body(generic, np.random.default_rng([3, 0]))
    elbows = []
    for seed in range(4):
        rotations = bodies.random_rotations(generic, body.joints_m, np.random.default_rng(seed))
        _, joints = bodies.posed_joints(generic, body.joints_m, rotations)
        left, right = joints[generic.joint("l_ankle")], joints[generic.joint("r_ankle")]
        assert left[1] == pytest.approx(right[1], abs=0.002), seed
        elbows.append(joints[generic.joint("l_elbow")])
    apart = np.linalg.norm(np.ptp(elbows, axis=0))
    assert 0.01 < apart < 0.20, "limbs must differ between shots, but by degrees"


@pytest.mark.parametrize("azimuth", [0.0, 90.0, 200.0])
def test_the_camera_told_is_the_camera_that_saw(azimuth):
    shot, _, _ = once(4, azimuth)
    pixels = shot.camera.project(shot.dressed_m)
    rows, columns = np.flatnonzero(shot.mask.any(axis=1)), np.flatnonzero(shot.mask.any(axis=0))
    seen = np.array([columns[0] - 0.5, rows[0] - 0.5, columns[-1] + 0.5, rows[-1] + 0.5])
    told = np.concatenate([pixels.min(axis=0), pixels.max(axis=0)])
    # a tip thinner than a pixel may be missed; a shifted pixel frame would show on opposite sides with one sign
    assert np.abs(seen - told).max() < 1.2, f"azimuth {azimuth}: {seen - told}"
    assert abs(float(np.mean(seen - told))) < 0.4, f"azimuth {azimuth}: {seen - told}"
    assert rows[0] > 0, "the head is in the photo"
    assert rows[-1] < SIZE_PX[1] - 1, "the feet are in the photo"


def test_one_seed_is_one_photo():
    first, _, _ = once(6, 30.0)
    again, _, _ = once(6, 30.0)
    other, _, _ = once(7, 30.0)
    assert np.array_equal(first.rgb, again.rgb)
    assert not np.array_equal(first.mask, other.mask)


def contrast(background):
    """Return the median colour step across the trunk's outline, 0..255, over some people."""
    steps = []
    for seed in (11, 12, 13):
        shot, _, _ = once(seed, 0.0, background=background)
        rows = np.flatnonzero(shot.mask.any(axis=1))
        for row in range(rows[0] + int(0.35 * np.ptp(rows)), rows[0] + int(0.8 * np.ptp(rows)), 4):
            columns = np.flatnonzero(shot.mask[row])
            inside, outside = shot.rgb[row, columns[0] + 4].astype(float), shot.rgb[row, columns[0] - 4].astype(float)
            steps.append(np.abs(inside - outside).mean())
    return float(np.median(steps))


def test_low_contrast_rooms_have_the_colour_of_the_clothes():
    assert contrast("low_contrast") < 0.6 * contrast("plain")


def test_nobody_is_cut_off():
    generic, pictures = load_generic(), script("painted_people_pictures")
    for seed in range(8):
        rng = np.random.default_rng(seed)
        body = bodies.random_body(generic, rng)
        bottom, top = body.vertices_m[:, 1].min(), body.vertices_m[:, 1].max()
        drawn = pictures.random_camera(45.0 * seed, (bottom, top), SIZE_PX, rng)
        camera, focal_35mm = pictures.framed(*drawn, body.vertices_m)
        pixels = camera.project(body.vertices_m)
        assert pixels.min() > 0.0, seed
        assert (pixels < np.array(SIZE_PX) - 1.0).all(), seed
        assert focal_35mm / drawn[1] == pytest.approx(camera.focal_px / drawn[0].focal_px), "EXIF tells the zoom used"
