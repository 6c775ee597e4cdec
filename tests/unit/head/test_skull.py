"""A skull shrinks into the outlines of head and hair, and no farther."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.generic.head_controls import load_head_controls
from cloner.geometry.cameras.viewpoints import facing_camera
from cloner.geometry.outlines.silhouette import fill_triangles
from cloner.head.model import make_head_model
from cloner.head.silhouette import head_skin
from cloner.head.skull import HAIR_M, fit_skull, skull_modes
from cloner.records.bodies import Phenotype


@pytest.mark.parametrize("height", [0.95, 1.0])
def test_a_skull_is_as_high_as_the_outline_leaves_room_for(height: float) -> None:
    model, controls = make_head_model(Phenotype(np.zeros(0), 1.70, 0.0, {}, {})), load_head_controls()
    head = model.head(np.zeros(len(model.basis_m)))
    fields, rows = skull_modes(model, controls)
    # hair as thick as the outline holds at least, all over what moves
    inside = head + (height - 1.0) * fields[0]
    grown = inside + 1.3 * HAIR_M * (inside - inside[rows].mean(axis=0)) / 0.09
    masks = []
    for azimuth in (0.0, np.pi / 2.0):
        across = (head[:, 0] if azimuth == 0.0 else -head[:, 2])[:, None] * [1.0, 0.0] - head[:, 1:2] * [0.0, 1.0]
        camera = facing_camera(head, across * 3000.0 + [500.0, 5400.0], azimuth=azimuth, focal_px=4000.0, width_px=1000,
                               height_px=1200)  # fmt: skip
        masks.append((camera, fill_triangles(camera.project(grown), head_skin().triangles, (1200, 1000))))
        assert masks[-1][1].any()

    shrunk, factors = fit_skull(model, head, controls, masks)

    assert factors[0] == pytest.approx(height, abs=0.012)
    assert (factors <= 1.0).all()
    np.testing.assert_allclose(shrunk, head + np.tensordot(factors - 1.0, fields, axes=1), atol=1e-12)
