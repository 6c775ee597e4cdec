"""What the kit's photographs lack: dark and uneven walls, painted lids, coloured light, shadows."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.records.labels import Label


def before_another_wall(
    rgb: NDArray[np.uint8], labels: NDArray[np.uint8], rng: np.random.Generator
) -> NDArray[np.uint8]:
    """Return the photo before a dark curtain, a plain or cloudy wall or blinds; the kit's own are rarely so."""
    soft = cv2.GaussianBlur((labels > 0).astype(np.float32), (0, 0), 1.2 * rgb.shape[1] / 800)[..., None]
    kind = rng.random()
    wall: Any = rng.uniform(0.0, 255.0, 3)
    if kind < 0.4:
        wall = rgb * rng.uniform(0.02, 0.35)
    elif kind < 0.85:
        change = rng.normal(0.0, 60.0, 3) - wall * rng.uniform(0.0, 0.5)
        uneven = clouds(labels.shape, rng) if kind < 0.75 else blinds(labels.shape, rng)
        wall = np.clip(wall + change * uneven[..., None], 0.0, 255.0)
    return np.asarray(rgb * soft + wall * (1.0 - soft), np.uint8)


def clouds(shape: tuple[int, ...], rng: np.random.Generator) -> NDArray[np.float32]:
    """Return an uneven picture between about 0 and 1: five sizes of grain, drawn out one way as planks are."""
    height, width = shape[:2]
    stretch, rough = np.exp(rng.normal(0.0, 0.7)), rng.uniform(0.3, 0.9)
    picture, total = np.zeros((height, width), np.float32), 0.0
    for octave in range(5):
        cells = 3.0 * 2.0**octave
        size = max(2, round(cells * stretch)), max(2, round(cells / stretch * width / height))
        grain = cv2.resize(rng.random(size).astype(np.float32), (width, height), interpolation=cv2.INTER_CUBIC)
        picture += rough**octave * grain
        total += rough**octave
    return picture / np.float32(total)


def blinds(shape: tuple[int, ...], rng: np.random.Generator) -> NDArray[np.float32]:
    """Return a picture of stripes between 0 and 1, level or upright, sharp or soft."""
    y, x = np.mgrid[: shape[0], : shape[1]] / shape[1]
    place = x + rng.normal(0.0, 0.03) * y if rng.random() < 0.4 else y + rng.normal(0.0, 0.1) * x
    wave = np.sin(2.0 * np.pi * (rng.uniform(4.0, 30.0) * place + rng.random()))
    return np.asarray(0.5 + 0.5 * np.tanh(rng.uniform(0.7, 6.0) * (wave + rng.uniform(-0.6, 0.6))), np.float32)


def made_up(rgb: NDArray[np.uint8], labels: NDArray[np.uint8], points: dict[str, Any],
            rng: np.random.Generator) -> NDArray[np.uint8]:  # fmt: skip
    """Return a photo with painted lids and darker sockets, which the kit's eyes lack and which are no glasses."""
    painted = rgb.astype(np.float32)
    colour, depth = rng.uniform(0.0, 110.0, 3) * rng.uniform(0.1, 1.0), rng.uniform(0.2, 0.9)
    high = rng.uniform(0.2, 0.55)
    pixels = np.stack(np.mgrid[: rgb.shape[0], : rgb.shape[1]][::-1], axis=-1)
    for side in "LR":
        outer, inner = (np.array(points[f"eye_{end}_{side}"]["xy"]) for end in ("outer", "inner"))
        wide = float(np.hypot(*(outer - inner))) + 1.0
        across, down = (outer - inner) / wide, np.array((inner - outer)[::-1] * (-1.0, 1.0)) / wide
        down = down if down[1] > 0 else -down
        from_eye = pixels - (outer + inner) / 2.0 + 0.15 * wide * down
        away = (from_eye @ across / (0.65 * wide)) ** 2 + (from_eye @ down / (high * wide)) ** 2
        share = depth * np.exp(-(away**1.5)) * (labels == Label.FACE_SKIN)
        painted += share[..., None] * (colour - painted)
    return np.asarray(painted, np.uint8)


def in_other_light(rgb: NDArray[np.uint8], rng: np.random.Generator, *, strong: bool) -> NDArray[np.uint8]:
    """Return a crop in other colours, exposure and contrast.

    Strongly also in coloured light, greyer, lit from a side, under a shadow of any shape, blurred.
    """
    share = 1.0 if strong else 0.3
    coloured = 3.0 if strong and rng.random() < 0.1 else share
    light = rgb.astype(np.float32) / 255.0 * np.exp(rng.normal(0.0, np.array([0.1, 0.05, 0.13]) * coloured))
    light = np.clip(light * np.exp(rng.normal(0.0, 0.22 * share)), 0.0, 1.0) ** np.exp(rng.normal(0.0, 0.25 * share))
    if strong and rng.random() < 0.25:
        grey = light.mean(axis=-1, keepdims=True)
        light = grey + (light - grey) * rng.uniform(0.0, 0.8)
    if strong and rng.random() < 0.35:
        y, x = np.mgrid[: len(rgb), : len(rgb)] / (len(rgb) - 1.0) - 0.5
        turn, depth = rng.uniform(0.0, 2.0 * np.pi), rng.uniform(0.4, 1.6)
        light = light * np.clip(1.0 + depth * (x * np.cos(turn) + y * np.sin(turn)), 0.15, 1.6)[..., None]
    if strong and rng.random() < 0.2:
        cloudy = clouds(rgb.shape, rng)
        edge = (cloudy - np.quantile(cloudy, rng.uniform(0.3, 0.8))) * rng.uniform(4.0, 60.0)
        light = light * (1.0 - rng.uniform(0.3, 0.85) / (1.0 + np.exp(edge)))[..., None]
    if strong and rng.random() < 0.3:
        light = cv2.GaussianBlur(light, (0, 0), rng.uniform(0.5, 1.6))
    light = light + rng.normal(0.0, 1.0, light.shape) * rng.uniform(0.0, 0.03 * share)
    return np.asarray(np.clip(255.0 * light, 0.0, 255.0), np.uint8)
