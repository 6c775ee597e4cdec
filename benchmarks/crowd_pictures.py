"""Whole pictures of a crowd: hybrid, and geometry without anti-aliasing, against geometry with nine samples a pixel.

Sixty people of the pack between 12 and 60 m, all in poses that impostors have; only pixels that people change count.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from skimage.metrics import structural_similarity

from cloner.crowd.drawing.theatre import CrowdRenderer
from cloner.crowd.packs import still
from cloner.crowd.packs.reading import read_casting, read_facts, read_stock
from cloner.crowd.staged.scene import PERSON_TEXELS, Casting, Mulberry32, Scene, random_look

PEOPLE, NEAR_M, FAR_M, POSES = 60, 12.0, 60.0, 16
SIZE = (960, 540)
OVER = 3
VIEW = ((0.0, 1.7, 0.0), (0.0, 1.4, -40.0))
SHOWN = 8  # levels that a person must change a pixel by


def field(clones: int, casting: Casting) -> Scene:
    """Return people who stand still in the middle of a step, as many on a square metre everywhere."""
    dice, rows = Mulberry32(7), []
    for k in range(PEOPLE):
        away = (NEAR_M**2 + dice.roll() * (FAR_M**2 - NEAR_M**2)) ** 0.5
        aside, heading, phase = (dice.roll() - 0.5) * 1.16, dice.roll() * 2 * np.pi, dice.pick(POSES) / POSES
        donors, dyes = random_look(k % clones, casting, dice)
        place = [0.0, away * np.sin(aside), -away * np.cos(aside), heading]
        rows += [place, [0.0, phase, k % clones, 1.0], [*donors, 0.0], dyes, [0.0] * 4]
    return Scene(np.array(rows, np.float32).reshape(-1, PERSON_TEXELS, 4), 100.0)


def hybrid_table(pack: Path) -> list[str]:
    """Return SSIM and PSNR of the people's pixels."""
    facts = read_facts(pack)
    theatre = CrowdRenderer(read_stock(pack, facts))
    made = field(len(facts["people"]), read_casting(facts))
    nobody = made.rows.copy()
    nobody[:, 0, 2] = 500.0  # behind the eye

    def picture(mode: str, samples: int, over: int = 1, rows: np.ndarray = made.rows) -> np.ndarray:
        still.SAMPLES = samples
        size = (SIZE[0] * over, SIZE[1] * over)
        shown = still.ScenePainter(theatre, facts, Scene(rows, 100.0), size).picture(VIEW, 0.0, mode).astype(float)
        return shown.reshape(SIZE[1], over, SIZE[0], over, 3).mean(axis=(1, 3))

    want = picture("geometry", 0, OVER)
    seen = np.abs(want - picture("geometry", 0, OVER, nobody)).max(axis=2) > SHOWN
    told = ["| drawn | SSIM | PSNR dB |", "| --- | --- | --- |"]
    for name, mode, samples in (
        ("hybrid, four samples", "hybrid", 4),
        ("hybrid, one sample", "hybrid", 0),
        ("geometry, four samples", "geometry", 4),
        ("geometry, one sample (bar: less .01 and .5 dB)", "geometry", 0),
    ):
        got = picture(mode, samples)
        _, map_ = structural_similarity(want, got, channel_axis=2, data_range=255.0, full=True)
        error = float(((want - got)[seen] ** 2).mean())
        told.append(f"| {name} | {map_.mean(axis=2)[seen].mean():.4f} | {10 * np.log10(255.0**2 / error):.2f} |")
    theatre.close()
    return told
