"""The residual names the part that lies off its outline, and by how many millimetres."""

import numpy as np
import pytest

from cloner.body.outlined import outline_distances_mm, outlined_photos, posed_silhouette, silhouette_iou
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.records.bodies import BodyMesh, Phenotype, PosedView
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from kit import people, studio

FRONT = ViewId.BODY_FRONT


@pytest.fixture(scope="module")
def case():
    person, pose = people.known_person(31), people.known_pose(1, spread=0.0)
    camera = studio.camera(0.0)
    mask = studio.silhouette(person.posed(pose)[0], people.skin_triangles(), camera)
    phenotype = Phenotype(np.zeros(1), 1.70, 0.0, {FRONT: PosedView(FRONT, camera, pose)}, {})
    outlines = SilhouetteSet({FRONT: studio.silhouette_record(FRONT, mask)})
    photos = outlined_photos(phenotype, outlines, Proposals({FRONT: studio.empty_proposal(FRONT, mask)}))
    return BodyMesh(person.vertices_m, person.joints_m), photos[FRONT]


def test_a_true_body_lies_on_its_outline(case):
    body, photo = case
    seen = posed_silhouette(body, photo)
    gaps = outline_distances_mm(seen, photo)
    assert max(gaps.values()) < 2.5, gaps  # a cell of the distance field is 3 mm
    assert silhouette_iou(seen, photo) > 0.98
    assert {"", "torso", "upper_arm", "calf", "hand", "foot"} <= set(gaps)


def test_a_displaced_part_is_named_with_its_distance(case):
    body, photo = case
    generic = load_generic()
    calves = [generic.segment_names.index(f"{side}_calf") for side in ("left", "right")]
    aside = generic.segment_weights[:, calves].sum(axis=1)[:, None] * np.array([0.012, 0.0, 0.0])
    before = outline_distances_mm(posed_silhouette(body, photo), photo)
    after = outline_distances_mm(posed_silhouette(BodyMesh(body.vertices_m + aside, body.joints_m), photo), photo)
    assert after["calf"] - before["calf"] == pytest.approx(11.0, abs=2.5)
    for part in ("torso", "upper_arm", "forearm", "hand"):
        assert after[part] == pytest.approx(before[part], abs=0.3), part
