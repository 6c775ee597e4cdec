"""One moved point links its stretch of the outline again; the drawn figure's true outline is known."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.vision.contours.fixed_points import bend_through
from cloner.vision.contours.outlines import extract_outline
from cloner.vision.contours.stretches import prepare_linking, relink_stretch
from kit.drawn import AXES, CENTRE, SKIN, WALL, draw, ellipse, photograph, rough_mask, with_noise

Floats = NDArray[np.float64]


def on_ellipse(degrees: float, *, out_px: float = 0.0) -> Floats:
    t = np.deg2rad(degrees)
    return CENTRE + (AXES + out_px) * np.array([np.cos(t), np.sin(t)])


@pytest.mark.parametrize("out_px", [-12.0, 0.5, 9.0, 25.0])
def test_the_outline_passes_through_the_point_and_stays_elsewhere(out_px: float) -> None:
    photo, mask = photograph(), rough_mask()
    ready, standing = prepare_linking(photo, mask), extract_outline(photo, mask).loops[0].polygon
    assert ready is not None
    target, before = on_ellipse(60.0, out_px=out_px), standing.copy()
    (moved,) = relink_stretch(ready, (standing,), target[None], target)
    assert cKDTree(moved).query(target)[0] < 0.1
    far = np.linalg.norm(standing - target, axis=1) > 4.0 * abs(out_px) + 60.0
    assert cKDTree(moved).query(standing[far])[0].max() < 0.5, "elsewhere nothing moves"
    assert np.linalg.norm(np.roll(moved, -1, axis=0) - moved, axis=1).max() < 4.0, "the outline stays closed"
    np.testing.assert_array_equal(standing, before)


def test_placed_points_lead_the_linking_to_the_edge_between_them() -> None:
    # A bag behind the person adds 14 px to the mask, and has an edge of its own.
    t = np.deg2rad(np.linspace(-20, 20, 200))
    unit = np.column_stack([np.cos(t), np.sin(t)])
    bag = np.vstack([CENTRE + 0.5 * AXES * unit, (CENTRE + (AXES + 14) * unit)[::-1]])
    wall = np.full((600, 400, 3), WALL, np.uint8)
    photo = with_noise(draw(draw(wall, bag, (230, 220, 60)), ellipse(), SKIN), 2.0, 4)
    bagged = draw(np.zeros((600, 400, 3), np.uint8), bag, (1, 1, 1))[..., 0]
    mask = np.maximum(rough_mask(shift=0.0, blur=2.0), bagged).astype(np.float32)
    ready, first = prepare_linking(photo, mask), extract_outline(photo, mask).loops[0].polygon
    assert ready is not None
    outline, placed = (first,), np.array([on_ellipse(degrees) for degrees in (-10.0, 0.0, 10.0)])
    for count in range(1, 4):
        outline = relink_stretch(ready, outline, placed[:count], placed[count - 1])

    def error(polygon: Floats) -> float:
        angle = np.rad2deg(np.arctan2(*((polygon - CENTRE) / AXES).T[::-1]))
        return float(cKDTree(ellipse(20000)).query(polygon[np.abs(angle) < 9.0])[0].mean())

    assert error(first) > 5.0, "the bag fooled the mask"
    assert error(outline[0]) < 1.0
    assert error(outline[0]) < error(bend_through(first, placed)), "linking knows more than bending"


def test_a_photo_without_a_person_cannot_be_linked() -> None:
    assert prepare_linking(photograph(), np.zeros((600, 400), np.float32)) is None
