"""What random faces may wear: beards, hair over the ears, glasses."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray
from painted_people_bodies import waves
from painted_people_clothes import HAIR, Dressed, whole_human

from cloner.generic.load import load_generic
from cloner.records.views import Camera

Array = NDArray[np.float64]
Bools = NDArray[np.bool_]


def bearded(dressed: Dressed, rng: np.random.Generator, splits: int) -> Array:
    """Return the colours with a beard: cheeks below the ear's lobe, upper lip and chin, not the lips."""
    generic, painter = load_generic(), whole_human(splits)
    mean = painter.mean
    place = {n: generic.vertices_m[generic.feature(n)].astype(np.float64) for n in (
        "subnasale", "mouth_corner_L", "ear_lobe_L", "chin_bottom", "neck_front_base")}  # fmt: skip
    lobe, corner, nose = place["ear_lobe_L"], place["mouth_corner_L"], place["subnasale"]
    share = np.clip((np.abs(mean[:, 0]) - corner[0]) / (lobe[0] - corner[0]), 0.0, 1.0)
    line = nose[1] - 0.004 + share * (lobe[1] - nose[1]) - 0.035 * np.sin(np.pi * share)
    under = place["chin_bottom"][1] - 0.03
    front = mean[:, 2] > lobe[2] - 0.005
    inside = np.clip((line - mean[:, 1]) / 0.006, 0, 1) * np.clip((mean[:, 1] - under) / 0.01, 0, 1) * front
    inside *= (1.0 - painter.masks["lips"]) * (1.0 - painter.masks["mouth"])
    hair = np.array([0.16, 0.11, 0.08]) * rng.uniform(0.4, 2.0)
    grain = 0.75 + 0.2 * waves(mean, (0.002, 0.006), 24, rng)
    out = dressed.colours.copy()
    rows = slice(0, len(mean))
    strength = np.clip(inside * grain * rng.uniform(0.7, 1.0), 0.0, 1.0)[:, None]
    out[rows] = (1.0 - strength) * out[rows] + strength * hair
    return out


def over_ears(
    person: NDArray[np.float32], hair: Bools, dressed: Dressed, marks: dict[str, Array], rng: np.random.Generator
) -> tuple[NDArray[np.float32], Bools]:
    """Return person and hair with strands hanging over the visible ears."""
    colours = dressed.colours[dressed.kind == HAIR]
    tone = np.median(colours, axis=0) if len(colours) else np.array([0.2, 0.13, 0.1])
    out, covered = person.copy(), hair.astype(np.uint8)
    for side in "LR":
        top, lobe, outer = (marks[f"{name}_{side}"] for name in ("ear_top", "ear_lobe", "ear_outer"))
        down = lobe - top
        across = np.array([-down[1], down[0]]) * 0.55
        if person[tuple(np.round(outer[::-1]).astype(int))][3] < 0.5:
            continue
        for share in np.linspace(-1.0, 1.0, 60):
            start = top - 0.45 * down + share * across * 0.9
            end = lobe + (0.35 + 0.1 * rng.normal()) * down + share * across * 0.8
            tint = (tone * rng.uniform(0.6, 1.1)).tolist()
            thick = max(2, int(0.05 * np.linalg.norm(down)))
            ends = np.round([start, end]).astype(int).tolist()
            cv2.line(out, ends[0], ends[1], (*tint, 1.0), thick, cv2.LINE_AA)
            cv2.line(covered, ends[0], ends[1], 1, thick)
    return out, covered > 0


def spectacled(
    picture: NDArray[np.uint8], naked_m: Array, camera: Camera, facing: int, rng: np.random.Generator
) -> NDArray[np.uint8]:
    """Return the picture with a pair of glasses: rims, bridge and temples."""
    generic, out = load_generic(), picture.copy()
    point = {name: naked_m[generic.feature(name)] for name in (
        "pupil_L", "pupil_R", "ear_top_L", "ear_top_R", "nasion")}  # fmt: skip
    turn = np.linspace(0.0, 2.0 * np.pi, 60)
    colour = (np.array([1, 1, 1]) * rng.uniform(10, 90)).tolist()
    lines = []
    rings = {}
    for side, sign in (("L", 1.0), ("R", -1.0)):
        centre = point[f"pupil_{side}"] + [0.001 * sign, -0.003, 0.014]
        ring = centre + np.stack([0.025 * np.cos(turn), 0.019 * np.sin(turn), 0.0 * turn], axis=1)
        rings[side] = ring
        hinge = centre + np.array([0.026 * sign, 0.008, -0.004])
        if facing == 0 or (facing > 0) == (side == "R"):
            lines.append(ring)
            lines.append(np.stack([centre + [0.025 * sign, 0.006, 0.0], hinge, point[f"ear_top_{side}"]]))
    lines.append(np.stack([rings["L"][30], rings["R"][0]]) + [0.0, 0.003, 0.003])
    thick = max(2, round(0.0022 / camera.metres_per_pixel(point["nasion"])))
    for line in lines if facing == 0 else lines[:-1]:
        pixels = np.round(camera.project(line) * 8).astype(np.int32)
        cv2.polylines(out, [pixels], False, colour, thick, cv2.LINE_AA, 3)
    return out
