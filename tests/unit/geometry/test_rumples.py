"""Folds of a known size drawn on a smooth outline are read off it; the outline's own shape is not."""

import numpy as np
import pytest

from cloner.geometry.outlines.rumples import rumples_mm


def outline_mm(folds_mm: float = 0.0, wave_mm: float = 60.0) -> np.ndarray:
    """Return a closed oval as tall as a person, with folds across it."""
    angle = np.linspace(0.0, 2.0 * np.pi, 6000, endpoint=False)
    oval = np.stack([220.0 * np.cos(angle), 850.0 * np.sin(angle)], axis=1)
    walked = np.cumsum(np.linalg.norm(np.diff(oval, axis=0, append=oval[:1]), axis=1))
    outwards = np.stack([np.cos(angle) / 220.0, np.sin(angle) / 850.0], axis=1)
    outwards /= np.linalg.norm(outwards, axis=1, keepdims=True)
    return oval + folds_mm * np.sin(2.0 * np.pi * walked / wave_mm)[:, None] * outwards


@pytest.mark.parametrize("mm_per_px", [0.7, 1.3])
def test_folds_are_measured_in_mm_at_any_resolution(mm_per_px):
    places, heights = rumples_mm(outline_mm(folds_mm=3.0) / mm_per_px, mm_per_px)
    assert np.median(np.abs(heights)) == pytest.approx(3.0 / np.sqrt(2.0), rel=0.15)
    assert np.abs(np.diff(places, axis=0)).max() * mm_per_px < 3.0


def test_neither_the_bodys_shape_nor_the_cameras_noise_is_a_fold():
    smooth = outline_mm()
    assert np.quantile(np.abs(rumples_mm(smooth, 1.0)[1]), 0.9) < 0.1  # away from its pointed ends
    noisy = smooth + np.random.default_rng(0).normal(0.0, 0.5, smooth.shape)
    assert np.median(np.abs(rumples_mm(noisy, 1.0)[1])) < 0.12
    long = outline_mm(folds_mm=3.0, wave_mm=400.0)
    assert np.median(np.abs(rumples_mm(long, 1.0)[1])) < 0.15


def test_a_scrap_of_outline_has_no_folds():
    places, heights = rumples_mm(outline_mm()[:50] * 0.1, 1.0)
    assert places.shape == (0, 2)
    assert heights.shape == (0,)
