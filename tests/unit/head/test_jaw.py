"""The jaw is an unknown of each face photo: an open mouth makes no longer chin, a shut one no open mouth."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from cloner.detectors.face.face_net import load_face_net
from cloner.frames import ViewId
from cloner.generic.face_grids import mouth_grid
from cloner.generic.load import load_generic
from cloner.geometry.cameras.viewpoints import facing_camera
from cloner.head.ears import PointObservations
from cloner.head.evidence import FrontEvidence, Params
from cloner.head.fit import fit_head
from cloner.head.jaw import JOINT, jaw_opening_rad, jaw_rotations, with_open_jaw
from cloner.head.model import HeadModel, make_head_model
from cloner.records.bodies import Phenotype
from cloner.records.views import Camera
from cloner.vision.retouching.open_mouth import INNER_LIPS

Array = NDArray[np.float64]

NOBODYS = Phenotype(np.zeros(0), 1.70, 0.0, {}, {})


@pytest.fixture(scope="module")
def model() -> HeadModel:
    return make_head_model(NOBODYS)


def photographed(model: HeadModel, head: Array, open_deg: float) -> tuple[FrontEvidence, Camera]:
    """Return what the net sees of a head (H, 3) with its jaw open, and the photo's true camera."""
    whole = with_open_jaw(model.generic, model.whole(head), model.joints_m, np.radians(open_deg))
    places = model.net.places.at(whole)
    rough = places[:, :2] * [1.0, -1.0] * 3000.0 + [450.0, 5400.0]
    camera = facing_camera(places, rough, azimuth=0.0, focal_px=2600.0, width_px=900, height_px=1200)
    seen = camera.project(places) + model.modes.seen_errors_m(camera) / camera.metres_per_pixel(places.mean(axis=0))
    nothing = np.zeros(0, dtype=np.int64)
    spots = PointObservations(nothing, np.zeros((0, 2)), np.zeros(0))
    hidden = np.zeros(len(places), dtype=bool)
    return FrontEvidence(ViewId.FACE_FRONT, seen, hidden, nothing, np.zeros((0, 2)), spots), camera


@pytest.mark.parametrize("open_deg", [0.0, 4.0, 8.0])
def test_an_open_mouth_is_the_jaws_and_not_the_chins(model: HeadModel, open_deg: float) -> None:
    head = model.head(np.zeros(len(model.basis_m)))
    front, camera = photographed(model, head, open_deg)
    coefficients, fitted, _ = fit_head(model, front, None, (camera, None), Params())
    found_deg = np.degrees(model.jaws_rad(coefficients)[0])
    assert found_deg == pytest.approx(open_deg, abs=1.2)
    chin = model.row[model.generic.feature("chin_bottom")]
    nose = model.row[model.generic.feature("subnasale")]
    longer_mm = 1000.0 * (np.ptp(fitted.head_m[[chin, nose], 1]) - np.ptp(head[[chin, nose], 1]))
    assert abs(longer_mm) < 1.5  # 8 degrees open it stands 9 mm lower in the photo


def test_the_jaw_carries_chin_and_lower_lip_alone() -> None:
    generic = load_generic()
    rest, joints = generic.vertices_m.astype(np.float64), generic.joints_m.astype(np.float64)
    moved = 1000.0 * (with_open_jaw(generic, rest, joints, np.radians(8.0)) - rest)
    assert moved[generic.feature("chin_bottom"), 1] < -6.0
    for name in ("lip_top", "nose_tip", "ear_lobe_L", "glabella"):
        assert np.abs(moved[generic.feature(name)]).max() < 0.01, name
    rotations = jaw_rotations(generic, 0.1)
    assert jaw_opening_rad(generic, rotations) == 0.1
    assert np.count_nonzero(rotations) == 1
    assert rotations[generic.joint(JOINT)].any()


def test_the_nets_inner_border_of_the_lower_lip_opens_with_the_jaw() -> None:
    generic, grid, places = load_generic(), mouth_grid(), load_face_net().places
    for border, own in ((INNER_LIPS[0], grid.upper), (INNER_LIPS[1], grid.lower)):
        lip = {int(row) for row in grid.rings[:, own].ravel()}
        for point in border[3:-3]:
            assert {int(row) for row in places.corners[point]} & lip, point
    rest, joints = generic.vertices_m.astype(np.float64), generic.joints_m.astype(np.float64)
    moved = places.at(with_open_jaw(generic, rest, joints, np.radians(8.0))) - places.at(rest)
    assert 1000.0 * moved[14, 1] < -8.0
    assert abs(1000.0 * moved[13, 1]) < 0.5
