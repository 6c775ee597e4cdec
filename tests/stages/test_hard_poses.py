"""Arms against the torso, feet together, hands before the body: no photo parts them, and no mesh is torn."""

import functools

import numpy as np
import pytest

from cloner import pipeline
from cloner.frames import BODY_VIEWS
from cloner.generic.load import load_generic
from cloner.geometry.outlines.silhouette import triangle_normals
from cloner.records.bodies import Phenotype, PosedView
from cloner.records.photos import Person
from cloner.records.points import PointSet
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from kit import people, studio

STATURE_M = 1.70
#: Degrees about the model's axes on top of arms held a little apart.
POSES = {
    "arms against the torso": {"l_shoulder": (0, 0, -22), "r_shoulder": (0, 0, 22)},
    "feet together": {"l_hip": (0, 0, -6), "r_hip": (0, 0, 6)},
    "hands before the body": {
        "l_shoulder": (-30, 0, -18), "r_shoulder": (-30, 0, 18), "l_elbow": (-50, 0, -30), "r_elbow": (-50, 0, 30),
    },
}  # fmt: skip


def skin():
    return people.skin_triangles()


@functools.cache
def fitted(name):
    """Return the known person and the body that the three steps make of a nearby phenotype."""
    generic = load_generic()
    person = people.known_person(61, stature_m=STATURE_M, spread=0.7)
    pose = people.known_pose(1, spread=0.0)
    for joint, degrees in POSES[name].items():
        pose[generic.joint(joint)] += np.deg2rad(degrees)
    outlines, proposals, views = {}, {}, {}
    posed, _ = person.posed(pose)
    for view in BODY_VIEWS:
        camera = studio.camera(studio.AZIMUTH_DEG[view])
        mask = studio.silhouette(posed, skin(), camera)
        outlines[view], proposals[view] = studio.silhouette_record(view, mask), studio.empty_proposal(view, mask)
        views[view] = PosedView(view, camera, pose)
    values = {
        "phenotype": Phenotype(0.6 * person.coefficients, STATURE_M, 0.0, views, {}),
        "silhouettes": SilhouetteSet(outlines),
        "proposals": Proposals(proposals),
        "body_points": PointSet({}),
        "person": Person("known", "", STATURE_M),
    }
    stages = tuple(stage for stage in pipeline.STAGES if stage.name in ("skeleton", "rough", "fine"))
    found, _ = pipeline.run(values, stages=stages)
    return person, generic.shape(0.6 * person.coefficients, STATURE_M)[0], found["body"].mesh


@pytest.mark.parametrize("name", POSES)
def test_no_skin_is_torn_or_turned_inside_out(name):
    _, start, body = fitted(name)
    triangles = skin()
    edges = np.unique(np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)

    def lengths(vertices):
        return np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1)

    longer = lengths(body.vertices_m) - lengths(start)
    assert longer.max() < 0.012, f"an edge grew by {1000 * longer.max():.0f} mm"
    before, after = triangle_normals(start, triangles), triangle_normals(body.vertices_m, triangles)
    cosine = np.einsum("ta,ta->t", before, after)
    cosine /= np.linalg.norm(before, axis=1) * np.maximum(np.linalg.norm(after, axis=1), 1e-12)
    assert (cosine < 0.0).sum() == 0, f"{(cosine < 0.0).sum()} triangles are inside out"


@pytest.mark.parametrize("name", POSES)
def test_the_body_comes_nearer_to_the_truth(name):
    person, start, body = fitted(name)
    generic = load_generic()
    trunk = (
        generic.segment_weights[:, [generic.segment_names.index(part) for part in ("torso", "pelvis")]].sum(axis=1)
        > 0.9
    )
    rows = np.unique(skin()[trunk[skin()].all(axis=1)])

    def away_mm(vertices):
        return 1000 * float(np.linalg.norm(vertices[rows] - person.vertices_m[rows], axis=1).mean())

    assert away_mm(body.vertices_m) < away_mm(start), f"{away_mm(start):.1f} -> {away_mm(body.vertices_m):.1f} mm"
