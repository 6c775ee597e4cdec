"""The outline of a face photo tells the jaw where skin is bare, and the vault below hair of any thickness."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.fit.shapes import ShapeFit, fit_shape
from cloner.generic.load import load_generic
from cloner.geometry.cameras.viewpoints import facing_camera
from cloner.geometry.outlines.contour_match import occluding_points
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.head.model import make_head_model
from cloner.head.outline import Outline
from cloner.head.silhouette import HAIR_M, head_skin, silhouette_evidence
from cloner.records.bodies import Phenotype
from cloner.records.views import Camera

Array = NDArray[np.float64]

MM_PER_PX = 0.5


def test_a_ball_turns_away_where_its_tangents_touch() -> None:
    grid = np.indices((40, 80)).reshape(2, -1)
    along, around = np.linspace(0.05, np.pi - 0.05, 40)[grid[0]], (2.0 * np.pi / 80.0) * grid[1]
    ball = np.stack([np.sin(along) * np.cos(around), np.sin(along) * np.sin(around), np.cos(along)], axis=1)
    index = np.arange(40 * 80).reshape(40, 80)
    edges = np.column_stack([index.ravel(), np.roll(index, -1, axis=1).ravel()])

    found = occluding_points(ball, ball, edges, np.array([4.0, 0.0, 0.0])).at(ball)

    # seen from 4 radii away the outline is the circle at a quarter of a radius towards the eye
    assert len(found) > 60
    np.testing.assert_allclose(found[:, 0], 0.25, atol=0.002)


def photographed(head: Array, hair_m: float) -> tuple[Outline, Camera]:
    """Return the outline of a head in the front photo, its vault under hair, and the camera."""
    skin = head_skin()
    camera = facing_camera(head, head[:, :2] * [1.0, -1.0] * 1000.0 / MM_PER_PX + [500.0, 3600.0], azimuth=0.0,
                           focal_px=2400.0, width_px=1000, height_px=900)  # fmt: skip
    worn = head + hair_m * skin.vault[:, None] * vertex_normals(head, skin.triangles)
    picture = np.zeros((900, 1000), np.uint8)
    for corner in np.round(16.0 * camera.project(worn)[skin.triangles]).astype(np.int32):
        cv2.fillConvexPoly(picture, corner, 255, cv2.LINE_8, 4)
    chain = max(cv2.findContours(picture, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[0], key=len)[:, 0]
    places = chain[::3].astype(np.float64)
    along = np.roll(places, -2, axis=0) - np.roll(places, 2, axis=0)
    normals = np.column_stack([-along[:, 1], along[:, 0]]) / np.linalg.norm(along, axis=1, keepdims=True)
    normals *= np.sign(((places - places.mean(axis=0)) * normals).sum())
    return Outline(places, normals, np.zeros(len(places), bool), cKDTree(places)), camera


@pytest.mark.parametrize("hair_mm", [0.0, 25.0])
def test_jaw_and_vault_follow_the_outline_of_a_known_head(hair_mm: float) -> None:
    model = make_head_model(Phenotype(np.zeros(0), 1.70, 0.0, {}, {}))
    true = 0.8 * np.random.default_rng(14).normal(size=len(model.basis_m))
    head = model.head(true)
    outline, camera = photographed(head, hair_mm / 1000.0)
    start = np.zeros(len(model.basis_m) + len(HAIR_M))

    fit = fit_shape(
        ShapeFit(start, (camera,), np.zeros((1, 3))),
        lambda fit, iteration: silhouette_evidence([model], fit.coefficients, fit.cameras, [outline], 0),
        rotation_sigma=np.full((1, 3), 1e-6),
    )

    found = model.head(fit.coefficients[: len(true)])
    jaw = head_skin().bare & (np.abs(head[:, 0]) > 0.055) & (head[:, 1] < head[generic_row("stomion"), 1])
    off = [1000.0 * np.abs((one - head)[jaw, 0]).mean() for one in (model.head(start[: len(true)]), found)]
    thick = HAIR_M[0][0] + HAIR_M[0][1] * fit.coefficients[len(true)]
    assert off[0] > 3.0  # this one's jaw is far from the mean
    assert off[1] < 0.7 * off[0]
    assert 1000.0 * thick == pytest.approx(hair_mm, abs=9.0)  # skulls differ too, and no photo shows one


def generic_row(name: str) -> int:
    """Return the row of a feature among the head's vertices."""
    generic = load_generic()
    return int(np.flatnonzero(generic.head_vertices == generic.feature(name))[0])
