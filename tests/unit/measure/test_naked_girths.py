"""Girths under clothes: a known person in a known photo, whose body the net is told to end inside the outline."""

from dataclasses import replace

import numpy as np
import pytest

from cloner.body.outlined import outlined_photos, posed_silhouette
from cloner.frames import ViewId
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measuring import ALL_KEYS, measures_mm
from cloner.labels.naked_edges import TRUNK
from cloner.measure.naked_girths import naked_girths
from cloner.records.bodies import BodyMesh, Phenotype, PosedView
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from kit import people, studio

SIDE, FRONT = ViewId.BODY_SIDE, ViewId.BODY_FRONT
YAWS = {FRONT: 0.0, SIDE: 90.0}
PERSON = people.known_person(31)


def edges(mask: np.ndarray, middle_px: float, share: float) -> np.ndarray:
    """Return the trunk's run in every fourth row of a silhouette, narrowed to a share of its width."""
    found = []
    for row in range(0, len(mask), 4):
        if mask[row, round(middle_px)]:
            outside = np.flatnonzero(~mask[row])
            left, right = outside[outside < middle_px].max() + 0.5, outside[outside > middle_px].min() - 0.5
            middle, half = (left + right) / 2.0, share * (right - left) / 2.0
            found.append((TRUNK, row, middle - half, middle + half))
    return np.array(found)


def under_over_shown(shares: dict[ViewId, float]) -> dict[str, float]:
    """Return girths under clothes over the shown ones where the net sees the body take shares of the width."""
    pose = people.known_pose(1, spread=0.5)
    views, silhouettes, proposals = {}, {}, {}
    for view, share in shares.items():
        camera = studio.camera(YAWS[view])
        mask = studio.silhouette(PERSON.posed(pose)[0], people.skin_triangles(), camera)
        silhouettes[view] = studio.silhouette_record(view, mask)
        views[view] = PosedView(view, camera, pose)
        middle = camera.project(PERSON.posed(pose)[1][:1])[0, 0]
        proposals[view] = replace(studio.empty_proposal(view, mask), naked_px=edges(mask > 0, middle, share))
    told = Proposals(proposals)
    photos = outlined_photos(Phenotype(np.zeros(1), 1.70, 0.0, views, {}), SilhouetteSet(silhouettes), told)
    body = BodyMesh(PERSON.vertices_m, PERSON.joints_m)
    shown = measures_mm(body.vertices_m, body.joints_m, load_tape_rules())
    found = naked_girths(body, shown, {view: posed_silhouette(body, photo) for view, photo in photos.items()}, told)
    return {key: float(found[row] / shown[key]) for row, key in enumerate(ALL_KEYS) if not np.isnan(found[row])}


def test_a_body_nine_tenths_as_wide_and_deep_has_nine_tenths_of_the_girth() -> None:
    found = under_over_shown({FRONT: 0.9, SIDE: 0.9})
    for key in ("waist_girth", "navel_girth", "trunk_slice_40"):
        assert found[key] == pytest.approx(0.9, abs=0.02), key
    assert "calf_girth" not in found
    assert "thigh_girth" not in found, "no edges of thighs were told"


def test_depth_counts_by_what_it_is_of_the_girth() -> None:
    only_flat = under_over_shown({FRONT: 1.0, SIDE: 0.8})["navel_girth"]
    only_slim = under_over_shown({FRONT: 0.8, SIDE: 1.0})["navel_girth"]
    assert 0.8 < only_slim < only_flat < 1.0, "trunks are wider than deep"


def test_without_a_side_photo_the_width_stands_for_both_and_without_a_width_nothing_is_told() -> None:
    assert under_over_shown({FRONT: 0.9})["navel_girth"] == pytest.approx(0.9, abs=0.02)
    assert not under_over_shown({SIDE: 0.9})
