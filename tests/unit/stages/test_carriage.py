"""A head turned by a known angle is found again from its outline and a few points."""

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.records.bodies import BodyMesh, Phenotype, PosedView
from cloner.records.points import Proposals, ViewPoints
from cloner.records.silhouettes import SilhouetteSet
from cloner.stages import carriage
from cloner.stages.outlined import outlined_photos
from kit import people, studio

SIDE = ViewId.BODY_SIDE
NAMES = ("nose_tip", "ear_outer_R")


def photographed(person, true_rotations, believed_rotations):
    """Return the photo of a person in one pose, believed to be another, and its exact points."""
    camera = studio.camera(studio.AZIMUTH_DEG["body_side"])
    vertices, _ = person.posed(true_rotations)
    mask = studio.silhouette(vertices, people.skin_triangles(), camera)
    generic = load_generic()
    pixels = camera.project(vertices[[generic.feature(name) for name in NAMES]])
    believed = Phenotype(np.zeros(1), 1.70, 0.0, {SIDE: PosedView(SIDE, camera, believed_rotations)}, {})
    outlines = SilhouetteSet({SIDE: studio.silhouette_record(SIDE, mask)})
    photos = outlined_photos(believed, outlines, Proposals({SIDE: studio.empty_proposal(SIDE, mask)}))
    return photos[SIDE], ViewPoints(SIDE, NAMES, pixels, np.ones(2), np.zeros(2, bool))


def nose_px(person, posed, points):
    """Return how far the nose tip lies from its place in the photo; a side photo says nothing of its depth."""
    vertices, _ = person.posed(posed.rotations)
    pixel = posed.camera.project(vertices[[load_generic().feature("nose_tip")]])[0]
    return float(np.linalg.norm(pixel - points.get("nose_tip")))


@pytest.mark.parametrize("nod_degrees", [-8.0, 8.0])
def test_a_nod_is_found_from_the_side(nod_degrees):
    generic = load_generic()
    person = people.known_person(51)
    believed = people.known_pose(1, spread=0.0)
    true = believed.copy()
    true[generic.joint("skullbase"), 0] += np.deg2rad(nod_degrees)
    photo, points = photographed(person, true, believed)
    found = carriage.carry_head(BodyMesh(person.vertices_m, person.joints_m), photo, points)
    before, after = nose_px(person, photo.posed, points), nose_px(person, found, points)
    assert before > 12.0, "the nod moves the nose"
    assert after < 0.25 * before, f"nose {before:.1f} -> {after:.1f} px"
    other = np.setdiff1d(np.arange(94), [generic.joint(name) for name in (*carriage.NECK, *carriage.SKULL)])
    assert np.array_equal(found.rotations[other], believed[other]), "only the neck and the skull turn"


def test_a_head_that_is_right_stays():
    person = people.known_person(51)
    pose = people.known_pose(1, spread=0.0)
    photo, points = photographed(person, pose, pose)
    found = carriage.carry_head(BodyMesh(person.vertices_m, person.joints_m), photo, points)
    assert nose_px(person, found, points) < 3.0
