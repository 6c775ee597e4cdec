"""Hair on one side: a mirrored side photo says nothing against it."""

from dataclasses import replace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.hair.volumes.views import ONE_SIDED, hair_views, one_sided_share
from cloner.records.labels import Label
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from tests.kit import painted, people, studio


def seen(sides):
    """Return the views of somebody whose hair hangs before the face on the given sides (-1 right, 1 left), from the
    front; the side photo shows none before the face.
    """
    generic, person = load_generic(), people.known_person(3)
    rest = np.zeros((len(generic.joint_names), 3))
    fit = painted.joined(person, {view: rest for view in (ViewId.BODY_FRONT, ViewId.BODY_SIDE)})
    head = person.vertices_m[generic.segment("head")]
    low, high = head.min(axis=0), head.max(axis=0)
    proposals = {}
    for view, posed in fit.views.items():
        mask = studio.silhouette(person.vertices_m, people.skin_triangles(), posed.camera)
        labels = np.where(mask, Label.UPPER_CLOTHES, 0).astype(np.uint8)
        if view is ViewId.BODY_FRONT:
            for side in sides:
                corners = posed.camera.project(np.array([[side * 0.02, high[1], 0.0], [side * 0.07, low[1], 0.0]]))
                (left, top), (right, bottom) = np.sort(corners, axis=0).astype(int)
                labels[top:bottom, left:right] = Label.HAIR
        proposals[view] = replace(studio.empty_proposal(view, mask), labels=labels)
    level = 0.5 * (low[1] + high[1])
    views = hair_views(generic, fit, Proposals(proposals), SilhouetteSet({}))
    front = next(view for view in views if view.posed.view is ViewId.BODY_FRONT)
    share = one_sided_share(front, fit.joints_m[generic.joint("skullbase")])
    (mirrored,) = (view for view in views if view.flip_m is not None)
    return mirrored, share, np.array([[0.045, level, high[2]], [-0.045, level, high[2]]])


def test_a_mirrored_side_photo_does_not_judge_hair_that_the_front_shows_on_one_side():
    mirrored, share, places = seen([1.0])
    assert share == pytest.approx(1.0)
    np.testing.assert_array_equal(mirrored.speaks_for(places), [False, True])
    assert not mirrored.evidence(places)[1][0]


def test_hair_on_both_sides_is_judged_by_the_mirrored_photo_as_before():
    mirrored, share, places = seen([1.0, -1.0])
    assert share < ONE_SIDED
    assert mirrored.front is None
    assert mirrored.speaks_for(places).all()
