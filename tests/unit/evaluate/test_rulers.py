"""Every ruler measures things whose size is known beforehand."""

import numpy as np
import pytest
import trimesh

from cloner.evaluate.measures import rulers, surfaces


@pytest.fixture
def sphere() -> trimesh.Trimesh:
    return trimesh.creation.icosphere(subdivisions=4, radius=0.1)


def test_swollen_sphere_is_five_millimetres_away(sphere):
    swollen = sphere.vertices * (105.0 / 100.0)
    _, distance, _ = surfaces.TriangleSurface(sphere.vertices, sphere.faces).closest(swollen)
    # the sphere is faceted: its faces lie up to 0.1 mm inside, vertices touch corners exactly
    assert 1000 * rulers.summarise(distance).mean == pytest.approx(5.0, abs=0.02)
    assert 1000 * rulers.summarise(distance).p95 == pytest.approx(5.0, abs=0.02)


def test_similarity_forgives_the_swelling_and_rigid_does_not(sphere):
    surface = surfaces.TriangleSurface(sphere.vertices, sphere.faces)
    truth = sphere.vertices * 1.05 + [0.002, -0.001, 0.0]
    results = {}
    for scale in (True, False):
        moved = rulers.align_by_nearest(truth, surface, scale=scale)
        _, distance, _ = surface.closest(rulers.transform_points(np.linalg.inv(moved), truth))
        results[scale] = 1000 * distance.mean()
    assert results[True] < 0.1
    assert 4.9 < results[False] < 5.1


def test_closest_point_agrees_with_trimesh_on_uneven_triangles():
    rng = np.random.default_rng(3)
    box = trimesh.creation.box(extents=(1.0, 0.3, 0.7))
    ball = trimesh.creation.icosphere(subdivisions=3, radius=0.02).apply_translation([0.2, 0.2, 0.2])
    both = trimesh.util.concatenate([box, ball])
    points = rng.uniform(-0.8, 0.8, (400, 3))
    _, distance, _ = surfaces.TriangleSurface(both.vertices, both.faces).closest(points)
    corners = both.vertices[both.faces]
    slow = [
        np.linalg.norm(trimesh.triangles.closest_point(corners, np.repeat(p[None], len(corners), 0)) - p, axis=1).min()
        for p in points
    ]
    assert np.abs(distance - slow).max() < 1e-12


def test_discs_measure_like_the_surface_they_sample(sphere):
    rng = np.random.default_rng(5)
    points, normals, _ = surfaces.sample_surface(sphere.vertices, sphere.faces, 9000, rng=rng)
    probe = sphere.vertices * 1.03
    _, distance, _ = surfaces.PointSurface(points, normals, radius=0.002).closest(probe)
    assert 1000 * distance.mean() == pytest.approx(3.0, abs=0.1)


def test_a_shell_inside_a_shell_is_not_seen(sphere):
    rng = np.random.default_rng(7)
    outer, outer_normal, _ = surfaces.sample_surface(sphere.vertices, sphere.faces, 30000, rng=rng)
    inner, inner_normal, _ = surfaces.sample_surface(sphere.vertices * 0.8, sphere.faces, 5000, rng=rng)
    points, normals = np.vstack([outer, inner]), np.vstack([outer_normal, inner_normal])
    seen = surfaces.visible_from_outside(points, normals, points)
    assert seen[:30000].mean() > 0.99
    assert seen[30000:].mean() < 0.01


def test_shifted_square_overlaps_as_calculated():
    first, second = np.zeros((100, 100), bool), np.zeros((100, 100), bool)
    first[20:60, 20:60] = True
    second[20:60, 30:70] = True
    assert rulers.mask_iou(first, second) == pytest.approx(30 / 50)
    assert rulers.mask_iou(first, first) == 1.0
    assert rulers.mask_iou(np.zeros((4, 4), bool), np.zeros((4, 4), bool)) == 1.0


def test_outline_distance_of_a_grown_square_scales_with_the_photo():
    first, second = np.zeros((900, 400), bool), np.zeros((900, 400), bool)
    first[200:700, 100:300] = True
    second[197:703, 97:303] = True
    distance = rulers.outline_distances_px(second, first)
    assert np.median(distance) == 6.0  # three pixels of a 900 px photo are six of an 1,800 px one
    assert rulers.outline_distances_px(first, first).max() == 0.0


def test_the_border_where_the_photo_cuts_the_person_does_not_count():
    first, second = np.zeros((1800, 100), bool), np.zeros((1800, 100), bool)
    first[100:, 20:80] = True
    second[100:, 22:82] = True
    distance = rulers.outline_distances_px(first, second)
    assert distance.max() <= 2.0


def test_alignment_recovers_turn_shift_and_scale():
    rng = np.random.default_rng(1)
    points = rng.normal(size=(30, 3))
    angle = 0.4
    turn = np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])
    target = 1.2 * points @ turn.T + [1.0, 2.0, 3.0]
    found = rulers.fit_similarity(points, target, scale=True)
    assert np.allclose(rulers.transform_points(found, points), target, atol=1e-12)
    rigid = rulers.fit_similarity(points, target, scale=False)
    assert np.linalg.det(rigid[:3, :3]) == pytest.approx(1.0)


def test_landmarks_tell_a_single_wrong_point():
    truth = np.random.default_rng(2).normal(size=(40, 3)) * 0.05
    found = truth.copy()
    found[7] += [0.0, 0.010, 0.0]
    distance = 1000 * rulers.landmark_distances(found + np.array([0.3, 0.1, 0.0]), truth)
    assert 9.0 < distance[7] < 10.0
    assert np.delete(distance, 7).max() < 1.0
    assert distance.argmax() == 7


def test_mirrored_points_are_not_excused():
    truth = np.random.default_rng(4).normal(size=(40, 3))
    assert rulers.landmark_distances(truth * [-1, 1, 1], truth).mean() > 0.3


def test_same_picture_is_alike_and_grey_level_counts():
    rng = np.random.default_rng(6)
    photo = rng.integers(60, 200, (80, 60, 3), dtype=np.uint8)
    mask = np.zeros((80, 60), bool)
    mask[20:60, 15:45] = True
    same = rulers.picture_similarity(photo, mask, photo, mask)
    assert same == (pytest.approx(1.0), pytest.approx(0.0))
    missing = rulers.picture_similarity(photo, np.zeros_like(mask), photo, mask)
    assert missing[0] < 0.2
    assert missing[1] > 10.0
    room = photo.copy()
    room[~mask] = 0
    assert rulers.picture_similarity(photo, mask, room, mask) == same


def test_seam_is_one_without_a_border_and_grows_with_a_jump():
    rng = np.random.default_rng(8)
    colours = (120 + rng.integers(-4, 5, (200, 1)) + np.zeros((1, 3), int)).astype(np.uint8)
    edges = np.stack([np.arange(199), np.arange(1, 200)], axis=1)
    crossing = edges[:, 0] % 10 == 9
    assert rulers.seam_ratio(rulers.colour_jumps(colours, edges), crossing, ~crossing) == pytest.approx(1.0, abs=0.4)
    striped = colours.copy()
    striped[(np.arange(200) // 10) % 2 == 1] += 40
    assert rulers.seam_ratio(rulers.colour_jumps(striped, edges), crossing, ~crossing) > 4.0
    assert rulers.seam_ratio(rulers.colour_jumps(colours, edges), crossing & False, ~crossing) is None
