"""Folds are told of the garment that has them, and never of bare skin."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial import cKDTree

from cloner.body.outlined import outlined_photos, posed_silhouette
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.measure.rumpled import garments_rumples_mm
from cloner.records.bodies import BodyMesh, Phenotype, PosedView
from cloner.records.measures import Cover
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from kit import people, studio

FRONT = ViewId.BODY_FRONT
LEGS = ("left_thigh", "right_thigh", "left_calf", "right_calf")
FOLDS_MM, WAVE_MM = 3.0, 55.0


@pytest.fixture(scope="module")
def told():
    """Return a function from the folded segments and the covers to what is told."""
    person, pose = people.known_person(31), people.known_pose(1, spread=0.0)
    camera = studio.camera(0.0)
    mask = studio.silhouette(person.posed(pose)[0], people.skin_triangles(), camera)
    phenotype = Phenotype(np.zeros(1), 1.70, 0.0, {FRONT: PosedView(FRONT, camera, pose)}, {})
    outline = studio.silhouette_record(FRONT, mask)
    photos = outlined_photos(
        phenotype, SilhouetteSet({FRONT: outline}), Proposals({FRONT: studio.empty_proposal(FRONT, mask)})
    )
    seen = {FRONT: posed_silhouette(BodyMesh(person.vertices_m, person.joints_m), photos[FRONT])}
    generic, mm = load_generic(), seen[FRONT].mm_per_px
    pixels = seen[FRONT].body.pixels

    def ask(folded: tuple[str, ...], covers: dict[str, Cover]) -> np.ndarray:
        rows = [generic.segment_names.index(name) for name in folded]
        contours = []
        for contour in outline.contours_px:
            own = np.isin(generic.vertex_segment[cKDTree(pixels).query(contour)[1]], rows)
            push = FOLDS_MM / mm * np.sin(2.0 * np.pi * contour[:, 1] * mm / WAVE_MM)
            contours.append(contour + np.stack([own * push, np.zeros(len(push))], axis=1))
        return garments_rumples_mm(
            seen, photos, SilhouetteSet({FRONT: replace(outline, contours_px=tuple(contours))}), covers
        )

    return ask


def test_folds_of_trousers_are_not_those_of_the_shirt(told):
    smooth, folded = told((), {}), told(LEGS, {})
    assert folded[1] > smooth[1] + 0.5 * FOLDS_MM
    assert folded[0] == pytest.approx(smooth[0], abs=0.1)


def test_bare_legs_wear_no_trousers(told):
    bare = {name: Cover((False,) * 8, 1.0) for name in LEGS}
    found = told(LEGS, bare)
    assert np.isnan(found[1])
    assert found[0] == pytest.approx(told((), {})[0], abs=0.1)
