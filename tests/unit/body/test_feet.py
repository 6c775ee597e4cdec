"""Feet and shoes of known size come back from their outlines."""

import numpy as np
import pytest

from cloner.body import feet
from cloner.body.outlined import outlined_photos
from cloner.evaluate.measures.crossings import self_intersections
from cloner.frames import BODY_VIEWS
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_triangles
from cloner.geometry.meshes.triangles import areas
from cloner.records.bodies import BodyMesh, Phenotype, PosedView
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.stages.fine import fit_extremities
from kit import people, studio

NAKED = np.array([1.0, 1.0, 1.0, 0.0])
SOLE_M = 0.03


@pytest.fixture(scope="module")
def body():
    person = people.known_person(31)
    return BodyMesh(person.vertices_m, person.joints_m)


def foot(side="left"):
    """Return the vertices that are wholly the foot's."""
    generic = load_generic()
    return np.flatnonzero(generic.segment_weights[:, generic.segment_names.index(f"{side}_foot")] > 0.999)


def test_a_naked_foot_of_size_one_stays(body):
    np.testing.assert_allclose(feet.scale_feet(body, NAKED, 0.0), body.vertices_m, atol=1e-12)


def test_length_and_width_scale_about_the_ankle(body):
    generic = load_generic()
    moved = feet.scale_feet(body, np.array([1.2, 1.1, 1.0, 0.005]), 0.0)
    ankle = body.joints_m[generic.joint("l_ankle")]
    own = foot()
    assert moved[own, 0] - ankle[0] == pytest.approx(1.2 * (body.vertices_m[own, 0] - ankle[0]), abs=1e-6)
    assert moved[own, 2] - ankle[2] == pytest.approx(1.1 * (body.vertices_m[own, 2] - ankle[2]) + 0.005, abs=1e-6)
    knee = np.abs(body.vertices_m[:, 1] - body.joints_m[generic.joint("l_knee"), 1]) < 0.05
    assert np.array_equal(moved[knee], body.vertices_m[knee])


def test_the_foot_reaches_down_to_the_sole(body):
    moved = feet.scale_feet(body, NAKED, SOLE_M)
    lowest = body.vertices_m[foot(), 1].min()
    assert moved[:, 1].min() == pytest.approx(lowest - SOLE_M, abs=0.002)


def test_closed_toes_leave_no_gap_between_them(body):
    closed = feet.close_toes(body).vertices_m
    changed = np.flatnonzero(np.abs(closed - body.vertices_m).max(axis=1) > 1e-9)
    generic = load_generic()
    assert set(generic.segment_names[row] for row in np.unique(generic.vertex_segment[changed])) <= {
        "left_foot",
        "right_foot",
    }
    assert changed.size > 100
    # nothing grows beyond the hull it had before
    for axis in range(3):
        assert closed[:, axis].max() <= body.vertices_m[:, axis].max() + 1e-6
    own = np.intersect1d(changed, foot())
    tips = own[body.vertices_m[own, 2] > np.quantile(body.vertices_m[own, 2], 0.6)]
    before, after = (np.ptp(v[tips][:, [0, 2]], axis=0) for v in (body.vertices_m, closed))
    assert np.all(after >= before - 1e-3)


@pytest.mark.parametrize("seed", [31, 32, 33])
def test_closed_toes_do_not_fold(seed):
    person = people.known_person(seed)
    naked = BodyMesh(person.vertices_m, person.joints_m)
    triangles = load_triangles()[np.isin(load_triangles(), foot()).all(axis=1)]
    shod = feet.scale_feet(feet.flatten_soles(feet.close_toes(naked)), np.array(feet.Params().shod), SOLE_M)
    assert len(self_intersections(shod, triangles).pairs) <= 4, "a thousand when toes are pushed straight outwards"
    assert areas(shod, triangles).min() > 2e-8, "square metres; the least of a naked foot's are 6e-8"
    toe = load_generic().feature("toe_left")
    assert np.linalg.norm(shod[toe] - feet.scale_feet(naked, np.array(feet.Params().shod), SOLE_M)[toe]) < 0.025


def test_a_shoes_sole_is_flat_and_the_instep_stays(body):
    flat = feet.flatten_soles(body).vertices_m
    generic = load_generic()
    sole = generic.region("sole")
    for side in ("left", "right"):
        behind = body.vertices_m[:, 2] < body.joints_m[generic.joint(f"{side[0]}_midtarsal"), 2] + 0.02
        own = sole & generic.region(f"foot_{side}") & behind
        assert np.ptp(body.vertices_m[own, 1]) > 0.004, "a naked foot has an arch"
        assert np.ptp(flat[own, 1]) == 0.0
    assert np.array_equal(flat[~sole], body.vertices_m[~sole])


def photographed(body, vertices_m, sole_m):
    """Return three perfect outlines of a person who stands as known_pose says."""
    rotations = people.known_pose(1, spread=0.0)
    person = people.KnownPerson("shod", 1.70, np.zeros(1), vertices_m, body.joints_m)
    posed, _ = person.posed(rotations)
    outlines, proposals, views = {}, {}, {}
    for view in BODY_VIEWS:
        camera = studio.camera(studio.AZIMUTH_DEG[view])
        mask = studio.silhouette(posed, people.skin_triangles(), camera)
        outlines[view], proposals[view] = studio.silhouette_record(view, mask), studio.empty_proposal(view, mask)
        views[view] = PosedView(view, camera, rotations)
    phenotype = Phenotype(np.zeros(1), 1.70, sole_m, views, {})
    return outlined_photos(phenotype, SilhouetteSet(outlines), Proposals(proposals))


def extent(vertices_m, axis):
    return 1000.0 * float(np.ptp(vertices_m[foot(), axis]))


def test_a_large_shoe_is_found_from_its_outlines(body):
    true = feet.scale_feet(feet.close_toes(body), np.array([1.2, 1.14, 1.3, 0.0]), SOLE_M)
    found = fit_extremities(body, photographed(body, true, SOLE_M), SOLE_M, {})[0].vertices_m
    assert extent(found, 2) == pytest.approx(extent(true, 2), abs=4.0)
    assert extent(found, 0) == pytest.approx(extent(true, 0), abs=4.0)
    usual = feet.scale_feet(feet.close_toes(body), np.array(feet.Params().shod), SOLE_M)
    assert abs(extent(found, 2) - extent(true, 2)) < 0.5 * abs(extent(usual, 2) - extent(true, 2))


def test_naked_feet_stay_naked(body):
    found = fit_extremities(body, photographed(body, body.vertices_m, 0.0), 0.0, {})[0].vertices_m
    assert extent(found, 2) == pytest.approx(extent(body.vertices_m, 2), abs=4.0)
    # outlines are half a pixel (0.6 mm) large on every side, and toes spread
    assert extent(found, 0) == pytest.approx(extent(body.vertices_m, 0), abs=6.0)
