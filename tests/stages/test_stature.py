"""First test of the house: photograph a known body, get its lengths back.

Stature is also an input, so alone it would prove only the unit trip; the other
lengths are not given and must come from the photographs.
"""

import functools

import numpy as np
import pytest

from cloner import pipeline
from cloner.frames import BODY_VIEWS
from cloner.project.corrections import no_corrections
from cloner.records.photos import Person
from cloner.records.points import PointSet, ViewPoints
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from kit import compare, people, studio

BODY_STAGES = ("views", "phenotype", "skeleton", "rough", "fine")
STATURE_M = 1.68


def photograph(person, seed):
    """Return the pipeline's values for three photos of a person who re-poses between them."""
    photos, proposals, points, outlines = {}, {}, {}, {}
    for number, view in enumerate(BODY_VIEWS):
        seen_by = studio.camera(studio.AZIMUTH_DEG[view], across_m=0.02 * (number - 1))
        vertices, joints = person.posed(people.known_pose(seed + number))
        shown, triangles = people.with_shoes_and_hair(vertices)
        mask = studio.silhouette(shown, triangles, seen_by)
        photos[view] = np.full((seen_by.height_px, seen_by.width_px, 3), 128, np.uint8)
        proposals[view] = studio.empty_proposal(view, mask)
        outlines[view] = studio.silhouette_record(view, mask)
        points[view] = exact_points(view, vertices, joints, seen_by, mask)
    return {
        "photos": studio.photo_set(photos),
        "proposals": Proposals(proposals),
        "body_points": PointSet(points),
        "silhouettes": SilhouetteSet(outlines),
        "corrections": no_corrections(),
    }


def exact_points(view, vertices, joints, seen_by, mask):
    named = people.exact_points(vertices, joints, view, seen_by)
    rows = np.flatnonzero(mask.any(axis=1))
    named["head_top"] = np.array([np.flatnonzero(mask[rows[0]]).mean(), rows[0]])
    for side in ("left", "right"):
        ankle = named[f"{side[0]}_ankle"]
        named[f"sole_{side}"] = np.array([ankle[0], rows[-1]])
    return ViewPoints(
        view,
        tuple(named),
        np.array(list(named.values())),
        np.ones(len(named)),
        np.zeros(len(named), bool),
    )


def fit(values, stature_m):
    stages = tuple(stage for stage in pipeline.STAGES if stage.name in BODY_STAGES)
    person = Person("known", "", stature_m)
    known, _ = pipeline.run({**values, "person": person}, stages=stages)
    body = known["body"].mesh
    return compare.lengths_mm(body.vertices_m, body.joints_m)


@functools.cache
def case(seed):
    """Return a known person, the photos, and the lengths found in them."""
    person = people.known_person(seed, stature_m=STATURE_M)
    values = photograph(person, 100 * seed)
    before = {view: outline.mask.copy() for view, outline in values["silhouettes"].views.items()}
    found = fit(values, STATURE_M)
    for view, mask in before.items():
        assert np.array_equal(values["silhouettes"].views[view].mask, mask), f"{person.name} {view}: input changed"
    return person, values, found


@pytest.mark.slow
@pytest.mark.parametrize("seed", [11, 12])
def test_a_known_body_comes_back(seed):
    person, _, found = case(seed)
    known = compare.lengths_mm(person.vertices_m, person.joints_m)
    message = f"{person.name}: {compare.describe(found, known)}"
    # a pixel is 1.1 mm here; outlines are half a pixel large on every side
    assert found["stature"] == pytest.approx(known["stature"], abs=5.0), message
    assert found["waist_width"] == pytest.approx(known["waist_width"], abs=8.0), message
    assert found["waist_depth"] == pytest.approx(known["waist_depth"], abs=12.0), message
    assert found["crotch_height"] == pytest.approx(known["crotch_height"], abs=15.0), message
    assert found["shoulder_breadth"] == pytest.approx(known["shoulder_breadth"], abs=15.0), message


@pytest.mark.slow
def test_five_percent_too_tall_grows_five_percent():
    person, values, found = case(11)
    taller = fit(values, 1.05 * STATURE_M)
    for name, length in found.items():
        # 12 mm of hair and 22 mm of sole do not grow with the stature: a few tenths of a percent
        assert taller[name] / length == pytest.approx(1.05, abs=0.012), f"{person.name}: {name}"
