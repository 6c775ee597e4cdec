"""Hair on a shoulder stays on it when the head turns; the crown and what hangs free follow the head."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import cKDTree

from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning, strongest_weights
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.volumes.views import HairSkinning
from cloner.hair.volumes.weights import hair_weights
from kit import painted, people

LIFT_M = 0.012


@pytest.fixture(scope="module")
def person():
    return painted.joined(people.known_person(41, spread=0.0), {})


def on_shoulders(person):
    """Return a sheet of hair 12 mm above the left shoulder between neck and arm, and its triangles."""
    generic, triangles = load_generic(), people.skin_triangles()
    normals = vertex_normals(person.vertices_m, triangles)
    neck, arm = (person.vertices_m[generic.feature(name)] for name in ("neck_base_L", "acromion_L"))
    x, y, _ = person.vertices_m.T
    top = (normals[:, 1] > 0.3) & (x > neck[0]) & (x < arm[0]) & (y > arm[1] - 0.06) & (y < neck[1] + 0.02)
    used, faces = np.unique(triangles[top[triangles].all(axis=1)], return_inverse=True)
    return person.vertices_m[used] + LIFT_M * normals[used], faces.reshape(-1, 3).astype(np.int32)


def turned(person, points, joints, weights, degrees):
    rotations = np.zeros((94, 3))
    rotations[load_generic().joint("skullbase"), 1] = np.radians(degrees)
    transforms = joint_transforms(person.joints_m, load_generic().joint_parents, rotations)
    return linear_blend_skinning(points, transforms, joints, weights)


def test_a_turning_head_draws_no_hair_through_the_shoulder(person):
    sheet, faces = on_shoulders(person)
    assert len(sheet) > 20
    generic = load_generic()
    normals = vertex_normals(person.vertices_m, people.skin_triangles())
    skinned = generic.skin_joints.astype(np.int32), generic.skin_weights.astype(float)
    deepest = {}
    hung = HairSkinning.of(generic, person).weights(sheet)
    for name, carried in (("hung", hung), ("lying", hair_weights(generic, person, sheet, faces))):
        body = turned(person, person.vertices_m, *skinned, 60.0)
        moved = turned(person, sheet, *carried, 60.0)
        near = cKDTree(body).query(moved)[1]
        deepest[name] = np.einsum("nk,nk->n", moved - body[near], normals[near]).min()
    assert deepest["lying"] > -0.002
    assert deepest["hung"] < -0.03  # as it was: carried by head and chest alone it goes through the shoulder


def test_the_crown_and_free_hair_follow_the_head_as_before(person):
    top = person.vertices_m[load_generic().feature("vertex_top")] + (0.0, 0.01, 0.0)
    free = person.joints_m[load_generic().joint("vt1")] + (0.0, 0.0, -0.4)
    points = np.array([top, top + (0.01, 0.0, 0.0), top + (0.0, 0.0, 0.01), free, free + (0.01, 0.0, 0.0), free + 0.01])
    triangles = np.array([[0, 1, 2], [3, 4, 5]], np.int32)
    joints, weights = hair_weights(load_generic(), person, points, triangles)
    wanted = np.zeros((6, 94))
    own = HairSkinning.of(load_generic(), person).weights(points)
    np.add.at(wanted, (np.arange(6)[:, None], own[0]), own[1])
    found = np.zeros((6, 94))
    np.add.at(found, (np.arange(6)[:, None], joints), weights)
    assert np.allclose(found, wanted)


def test_four_joints_are_kept_and_sum_to_one():
    joints, weights = strongest_weights(np.array([[0.1, 0.3, 0.05, 0.2, 0.35]]))
    assert joints.tolist() == [[4, 1, 3, 0]]
    assert weights.sum() == pytest.approx(1.0)
    assert weights[0, 0] == pytest.approx(0.35 / 0.95)
