"""Photos of dim light lose their noise before they are painted; others keep every pixel."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.records.photos import Photo, PhotoSet
from cloner.vision.photographs.noise import NOISY, denoised, noise_level


def folds(noise: float) -> tuple[np.ndarray, np.ndarray]:
    """Return a cloth with folds and a seam, and its photo with noise as JPEG leaves it, (200, 300, 3)."""
    x, y = np.meshgrid(np.arange(300.0), np.arange(200.0))
    grey = 128.0 + 40.0 * np.sin(x / 25.0) - 60.0 * (np.abs(y - 100.0) < 2.0)
    clean = np.repeat(grey[..., None], 3, axis=2)
    taken = np.clip(clean + np.random.default_rng(5).normal(0.0, noise, clean.shape), 0, 255).astype(np.uint8)
    packed = cv2.imencode(".jpg", taken, [cv2.IMWRITE_JPEG_QUALITY, 92])[1]
    return clean, np.asarray(cv2.imdecode(packed, cv2.IMREAD_COLOR))


def cleaned(rgb: np.ndarray) -> np.ndarray:
    photos = PhotoSet({ViewId.FACE_FRONT: Photo(ViewId.FACE_FRONT, rgb, None, "", "a.jpg")})
    return denoised(photos).photos[ViewId.FACE_FRONT].rgb


def test_noise_goes_and_a_seam_stays() -> None:
    clean, rgb = folds(18.0)
    assert noise_level(rgb) > NOISY
    found = cleaned(rgb)
    error = [np.sqrt(((one - clean)[20:80] ** 2).mean()) for one in (rgb.astype(float), found.astype(float))]
    assert error[1] < 0.5 * error[0]
    seam = found[98:103, :, 0].mean() - found[80:90, :, 0].mean()
    assert seam == pytest.approx(clean[98:103, :, 0].mean() - clean[80:90, :, 0].mean(), abs=6.0)


def test_a_usual_photo_keeps_its_pixels() -> None:
    _, rgb = folds(1.5)
    assert noise_level(rgb) < NOISY
    np.testing.assert_array_equal(cleaned(rgb), rgb)


def test_noise_goes_from_lined_cloth_too_and_its_thin_red_lines_stay_red() -> None:
    """With OpenCV's own step for colours, at full size, most of this noise stays."""
    place = np.arange(300) % 20
    clean = np.full((200, 300, 3), (30.0, 28.0, 25.0))
    clean[:, place < 2], clean[:, (place >= 2) & (place < 5)] = (150.0, 60.0, 55.0), (190.0, 160.0, 140.0)
    taken = np.clip(clean + np.random.default_rng(6).normal(0.0, 14.0, clean.shape), 0, 255).astype(np.uint8)
    found = cleaned(taken).astype(float)
    error = [np.sqrt(((one - clean) ** 2).mean()) for one in (taken.astype(float), found)]
    assert error[1] < 0.55 * error[0]
    red = found[20:180, 100:102].mean(axis=(0, 1))
    assert red[0] - red[1] > 0.65 * (150.0 - 60.0)
