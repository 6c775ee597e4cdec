"""An arm that makes the outline of the back is found at the levels where it does, and only there."""

import numpy as np
import pytest

from cloner.body.outlined import outlined_photos, posed_silhouette
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.measurement.measuring import ALL_KEYS
from cloner.measure.side_arms import LEVELS, hidden_rows
from cloner.records.bodies import BodyMesh, Phenotype, PosedView
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from kit import people, studio

SIDE, FRONT = ViewId.BODY_SIDE, ViewId.BODY_FRONT


def hidden(swing_rad: float, view: ViewId = SIDE) -> set[str]:
    """Return the measures that are called hidden when the elbows stand back by an angle."""
    person, pose = people.known_person(31), people.known_pose(1, spread=0.0)
    for name in ("l_shoulder", "r_shoulder"):
        pose[load_generic().joint(name), 0] += swing_rad
    camera = studio.camera(90.0)
    mask = studio.silhouette(person.posed(pose)[0], people.skin_triangles(), camera)
    phenotype = Phenotype(np.zeros(1), 1.70, 0.0, {view: PosedView(view, camera, pose)}, {})
    outlines = SilhouetteSet({view: studio.silhouette_record(view, mask)})
    photos = outlined_photos(phenotype, outlines, Proposals({view: studio.empty_proposal(view, mask)}))
    body = BodyMesh(person.vertices_m, person.joints_m)
    rows = hidden_rows(person.vertices_m, {view: posed_silhouette(body, photos[view])})
    return {ALL_KEYS[row] for row in np.flatnonzero(rows)}


def test_arms_before_the_trunk_hide_nothing() -> None:
    assert not hidden(0.0)


@pytest.mark.parametrize("swing_rad", [0.25, -0.3])
def test_elbows_behind_the_back_or_before_the_belly_hide_the_waist(swing_rad: float) -> None:
    found = hidden(swing_rad)
    assert {"waist_girth", "navel_girth"} <= found <= set(LEVELS)
    assert "bust_girth" not in found


def test_only_the_side_photo_shows_depth() -> None:
    assert not hidden(0.45, FRONT)
