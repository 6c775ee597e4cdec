"""Wide trousers are taken for cloth: they neither part the legs in the side photo nor make them heavy."""

from dataclasses import replace

import numpy as np
import pytest

from cloner.body.clothes import EASES, clothed_body
from cloner.frames import BODY_VIEWS, ViewId
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import joint_transforms
from cloner.records.bodies import Phenotype
from cloner.records.photos import Person
from cloner.records.points import PointSet, ViewPoints
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.stages import phenotype, views
from kit import people, studio

STATURE_M = 1.72
TROUSERS = next(k for k, ease in enumerate(EASES) if "left_thigh" in ease.segments)


def worn(**eases_m):
    """Return a phenotype whose clothes stand off by given metres, by name of a segment, and nowhere else."""
    spreads = [
        (next((v for k, v in eases_m.items() if k in e.segments and not e.hangs), 0.0) - e.mean_m) / e.sigma_m
        for e in EASES
    ]
    return Phenotype(np.zeros(1), STATURE_M, 0.0, {}, {}, np.array(spreads))


def test_cloth_of_known_thickness_deepens_a_leg_by_twice_of_it():
    generic = load_generic()
    naked, joints = clothed_body(worn())
    cloth, same = clothed_body(worn(left_thigh=0.02))
    leg = generic.segment_weights[:, generic.segment_names.index("left_thigh")] > 0.99
    for low, high in ((0.4, 0.45), (0.6, 0.65)):
        ring = leg & (generic.slice_s > low) & (generic.slice_s < high)
        assert np.ptp(cloth[ring, 2]) - np.ptp(naked[ring, 2]) == pytest.approx(0.04, abs=0.004)
    assert np.array_equal(joints, same), "cloth moves no joint"


@pytest.mark.parametrize("segment", ["head", "left_hand", "right_foot"])
def test_cloth_leaves_head_hands_and_feet(segment):
    generic = load_generic()
    bare = generic.segment_weights[:, generic.segment_names.index(segment)] > 0.99
    vertices, _ = clothed_body(worn(torso=0.03, left_forearm=0.03, left_thigh=0.03))
    naked, _ = generic.shape(np.zeros(1), STATURE_M)
    assert np.abs(vertices - naked)[bare].max() < 0.001


def test_thick_trousers_of_left_and_right_leg_do_not_run_through_each_other():
    generic = load_generic()
    naked, _ = clothed_body(worn())
    thick, _ = clothed_body(worn(torso=0.02, left_thigh=0.04))
    legs = [generic.segment_names.index(name) for name in ("pelvis", "left_thigh", "right_thigh")]
    lower = (generic.segment_weights[:, legs].sum(axis=1) > 0.99) & (np.abs(naked[:, 0]) > 1e-4)
    crossed = np.sign(thick[lower, 0]) != np.sign(naked[lower, 0])
    assert not crossed.any(), f"{crossed.sum()} vertices changed sides"


def in_trousers(vertices, joints, thick_m):
    """Return vertices whose legs are pushed away from the bones: cloth made without the product's own modes."""
    generic, wide = load_generic(), vertices.copy()
    for side, name in (("l", "left"), ("r", "right")):
        for part, ends in (("thigh", ("hip", "knee")), ("calf", ("knee", "ankle"))):
            start, end = (joints[generic.joint(f"{side}_{end}")] for end in ends)
            along = (end - start) / np.linalg.norm(end - start)
            away = vertices - start
            away -= np.outer(away @ along, along)
            weight = generic.segment_weights[:, generic.segment_names.index(f"{name}_{part}")][:, None]
            wide += thick_m * weight * away / np.maximum(np.linalg.norm(away, axis=1, keepdims=True), 0.01)
    return wide


def photographed(person):
    """Return the stage's values for a person whose knees are level in all three photos; no net speaks."""
    photos, proposals, points, outlines = {}, {}, {}, {}
    for view in BODY_VIEWS:
        vertices, joints = person.posed(people.known_pose(1, spread=0.0))
        mask = studio.silhouette(*people.with_shoes_and_hair(vertices), studio.camera(studio.AZIMUTH_DEG[view]))
        rows = np.flatnonzero(mask.any(axis=1))
        named = {"head_top": (600.0, rows[0]), "sole_left": (620.0, rows[-1]), "sole_right": (580.0, rows[-1])}
        named |= people.exact_points(vertices, joints, view, studio.camera(studio.AZIMUTH_DEG[view]))
        photos[view] = np.full((*mask.shape, 3), 128, np.uint8)
        proposals[view] = studio.empty_proposal(view, mask)
        count = len(named)
        points[view] = ViewPoints(
            view, tuple(named), np.array(list(named.values())), np.ones(count), np.zeros(count, bool)
        )
        outlines[view] = studio.silhouette_record(view, mask)
    told, body_points = Person("known", "", STATURE_M), PointSet(points)
    shared = {"tick": lambda f: None}
    seen = views.run(photos=studio.photo_set(photos), body_points=body_points, person=told, **shared).values["views"]
    sides = {v: replace(e, side_shown="right") if v is ViewId.BODY_SIDE else e for v, e in seen.views.items()}
    return {
        "proposals": Proposals(proposals), "body_points": body_points, "silhouettes": SilhouetteSet(outlines),
        "views": replace(seen, views=sides), "person": told, **shared,
    }  # fmt: skip


@pytest.mark.slow
def test_wide_trousers_do_not_part_the_legs():
    generic, person = load_generic(), people.known_person(21, stature_m=STATURE_M, spread=0.5)
    dressed = replace(person, vertices_m=in_trousers(person.vertices_m, person.joints_m, 0.02))
    found = phenotype.run(**photographed(dressed)).values["phenotype"]
    told_m = EASES[TROUSERS].mean_m + EASES[TROUSERS].sigma_m * found.ease[TROUSERS]
    assert told_m > 0.012, f"{told_m:.3f} m of cloth were found where 0.020 hang"
    _, joints = clothed_body(found)
    turned = joint_transforms(joints, generic.joint_parents, found.views[ViewId.BODY_SIDE].rotations)
    left, right = (turned[k, :3, :3] @ joints[k] + turned[k, :3, 3] for k in map(generic.joint, ("l_knee", "r_knee")))
    assert 1000 * abs(left[2] - right[2]) < 15.0, "knees stand level"
