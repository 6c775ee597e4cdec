"""A head's size is read off the body photo, also where it nods and turns there, and whatever the net makes of faces."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.geometry.articulation.skinning import rotation_matrices
from cloner.geometry.cameras.viewpoints import facing_camera
from cloner.head.model import make_head_model
from cloner.head.size import observed_scale
from cloner.records.bodies import Phenotype


@pytest.mark.parametrize(("nod_deg", "turn_deg"), [(0.0, 0.0), (12.0, 0.0), (-8.0, 10.0)])
@pytest.mark.parametrize("larger", [0.95, 1.06])
def test_a_turned_face_is_measured_like_a_straight_one(larger: float, nod_deg: float, turn_deg: float) -> None:
    model = make_head_model(Phenotype(np.zeros(0), 1.70, 0.0, {}, {}))
    places = model.net.places.at(model.vertices_m)
    middle = places.mean(axis=0)
    start = facing_camera(
        places, places[:, :2] * [400.0, -400.0], azimuth=0.0, focal_px=1500.0, width_px=1200, height_px=1800
    )
    turn = rotation_matrices(np.radians([[nod_deg, turn_deg, 0.0]]))[0]
    shown = middle + larger * (places - middle) @ turn.T
    pose = np.array(start.camera_from_model)
    pose[:3, :3] = pose[:3, :3] @ turn
    made = 0.002 * np.random.default_rng(1).normal(size=(468, 2))  # this net's own idea of this face
    errors = made + model.modes.turn_errors_m(pose[:3, :3])
    face_px = start.project(shown) + errors / start.metres_per_pixel(middle)

    assert observed_scale(model, places, made, start, face_px) == pytest.approx(larger, abs=0.008)
