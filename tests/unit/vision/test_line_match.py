"""Lines of one photo are laid on those of another: as far as they lie apart, and no farther than told."""

from __future__ import annotations

import cv2
import numpy as np

from cloner.records.labels import Label
from cloner.vision.retouching.line_match import MatchScales, SharedSamples, line_pictures, match_lines

HEIGHT, WIDTH, PIXEL_M = 240, 160, 0.001
REACH = MatchScales(blur_m=0.002, usual_m=0.008, most_m=0.020)
INSIDE = np.ones((HEIGHT, WIDTH), bool)
SKIN = np.full((HEIGHT, WIDTH), Label.BODY_SKIN, np.uint8)


def blotches(shift=(0.0, 0.0)):
    """Return a grey picture (H, W, 3) of blotches a centimetre wide, its content moved by a shift (right, down)."""
    rng = np.random.default_rng(3)
    wide = cv2.GaussianBlur(rng.normal(size=(HEIGHT + 80, WIDTH + 80)).astype(np.float32), (0, 0), 4.0)
    moved = np.float32([[1, 0, shift[0] - 40], [0, 1, shift[1] - 40]])
    picture = cv2.warpAffine(wide / wide.std(), moved, (WIDTH, HEIGHT), flags=cv2.INTER_LINEAR)
    return np.repeat(np.clip(128 + 30 * picture, 0, 255).astype(np.uint8)[..., None], 3, axis=2)


def everywhere():
    """Return a grid of places that both photos are thought to show at the same pixel."""
    column, row = np.meshgrid(np.arange(4, WIDTH - 4, 2.0), np.arange(4, HEIGHT - 4, 2.0))
    places = np.column_stack([column.ravel(), row.ravel()])
    return SharedSamples(places, places, np.ones(len(places)))


def displaced(moved, fixed, labels=(SKIN, SKIN), reach=REACH):
    """Return (N, 2) displacements in the middle of the picture."""
    first, second = (
        line_pictures(rgb, own, INSIDE, PIXEL_M, reach) for rgb, own in zip((moved, fixed), labels, strict=True)
    )
    field = match_lines(first, [(second, everywhere())], PIXEL_M, reach)
    column, row = np.meshgrid(np.arange(40, WIDTH - 40, 5.0), np.arange(40, HEIGHT - 40, 5.0))
    return field.at(np.column_stack([column.ravel(), row.ravel()]))


def test_blotches_that_lie_six_pixels_off_are_found_there() -> None:
    away = displaced(blotches((5.0, -3.0)), blotches()) - (5.0, -3.0)
    assert np.abs(np.median(away, axis=0)).max() < 0.3
    assert np.linalg.norm(away, axis=1).mean() < 0.6


def test_the_border_of_a_shirt_is_found_without_any_brightness() -> None:
    plain = np.full((HEIGHT, WIDTH, 3), 120, np.uint8)
    higher, lower = SKIN.copy(), SKIN.copy()
    higher[110:], lower[116:] = Label.UPPER_CLOTHES, Label.UPPER_CLOTHES
    rows = displaced(plain, plain, (higher, lower)).reshape(-1, 16, 2)
    near = rows[14:17, 3:13]  # rows 110 to 120, where the border lies
    assert np.abs(near[..., 1] + 6.0).max() < 1.0
    assert np.abs(near[..., 0]).max() < 0.2


def test_nothing_moves_where_nothing_is_drawn() -> None:
    rng = np.random.default_rng(5)
    noisy = [np.clip(120 + rng.normal(0, 1.5, (HEIGHT, WIDTH, 1)).repeat(3, 2), 0, 255).astype(np.uint8) for _ in "ab"]
    assert np.abs(displaced(*noisy)).max() < 0.3


def test_what_lies_farther_off_than_the_fit_can_be_wrong_is_left() -> None:
    short = MatchScales(blur_m=0.002, usual_m=0.008, most_m=0.003)
    assert np.linalg.norm(displaced(blotches((5.0, -3.0)), blotches(), reach=short), axis=1).max() < 3.0 + 1e-4
