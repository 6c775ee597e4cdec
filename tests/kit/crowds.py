"""Painted people as results, for crowds."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from skimage.metrics import structural_similarity

from cloner.crowd.clones.stock import TEXELS_PER_M, TEXELS_PER_PX
from cloner.crowd.drawing.theatre import CrowdRenderer
from cloner.crowd.packs.pack import make_pack
from cloner.crowd.packs.wanted import PackOptions
from cloner.crowd.staged.eye import CrowdCamera
from cloner.exporters.shared.regions import texel_triangles
from cloner.generic.load import load_generic
from cloner.project.clone_file import CLONE_FILE, save_clone
from cloner.records.clones import Clone, TextureAtlas
from cloner.records.regions import REGIONS
from kit.clones import SHIRT, toy_clone

GREY = (0.5, 0.5, 0.5, 1.0)
WANTED = PackOptions(people=60, views=8, poses=8, vat=True)


def dressed_toy(stature_m: float = 1.70, *, sleeves: bool = False, shift: int = 0, consent: bool = True) -> Clone:
    """The painted adult with regions as painted; long sleeves and another blue where asked."""
    generic = load_generic()
    clone = toy_clone(stature_m)
    triangles, _ = generic.triangles()
    segment = np.array(generic.segment_names)[generic.vertex_segment[triangles[:, 0]]]
    regions = np.zeros(len(triangles), np.uint8)
    upper = ["torso", "left_upper_arm", "right_upper_arm", *(["left_forearm", "right_forearm"] if sleeves else [])]
    regions[np.isin(segment, upper)] = REGIONS.index("upper_clothes")
    regions[np.isin(segment, ["pelvis", "left_thigh", "right_thigh", "left_calf", "right_calf"])] = REGIONS.index(
        "lower_clothes"
    )
    regions[np.isin(segment, ["left_foot", "right_foot"])] = REGIONS.index("shoes")
    part = generic.vertex_part[triangles[:, 0]]
    regions[np.isin(part, [generic.part_names.index(f"eye_{side}") for side in ("left", "right")])] = REGIONS.index(
        "eyes"
    )
    regions[np.isin(part, [k for k, n in enumerate(generic.part_names) if n[:5] in ("teeth", "tongu")])] = (
        REGIONS.index("mouth")
    )
    rgb = clone.atlas.rgb.astype(int)
    if sleeves:
        forearms = np.append(np.isin(segment, ["left_forearm", "right_forearm"]), False)
        rgb[forearms[texel_triangles(len(rgb))]] = SHIRT
    rgb += [shift, shift, 0]
    atlas = TextureAtlas(np.clip(rgb, 0, 255).astype(np.uint8), clone.atlas.coverage)
    return replace(
        clone,
        triangle_regions=regions,
        atlas=atlas,
        consent=consent,
        stamp="Cloner 0.1.0, models a, generic 00ff, seed 0",
    )


def lively_pack(results: Path, out: Path) -> Path:
    """Make a pack with the walks of feelings and the acts."""
    make_pack([results], out, replace(WANTED, vat=False, feelings=True))
    return out


def two_results(out: Path) -> Path:
    """Leave two painted people as a batch would."""
    saved(out / "ada", dressed_toy())
    saved(out / "ben", dressed_toy(1.82, sleeves=True, shift=60))
    return out


def saved(folder: Path, clone: Clone) -> Path:
    folder.mkdir(parents=True)
    save_clone(clone, folder / CLONE_FILE)
    return folder


def row(
    *, heading: float = 0.0, clone: int = 0, phase: float = 0.26, clip: int = 0, dyes=(-1, -1, -1, -1), top=None
) -> np.ndarray:
    out = np.zeros((5, 4), np.float32)
    out[0, 3], out[1], out[2, :3], out[2, 3], out[3] = heading, (0, phase, clone, 1.0), clone, clip, dyes
    out[2, 0] = clone if top is None else top
    return out


def shot(theatre: CrowdRenderer, person: np.ndarray, level: int | None, size: int = 96, over: int = 4) -> np.ndarray:
    """One person at the switch: 869 px of focal length, 1.5 texels a pixel; ``level`` None is the impostor."""
    away = 869.0 * TEXELS_PER_PX / TEXELS_PER_M
    place = np.array([0.0, 0.9 + away * np.sin(np.radians(5)), away * np.cos(np.radians(5))])
    eye = CrowdCamera(place, np.array([0.0, 0.9, 0.0]),
              (size * over, size * over), 869.0 * over)  # fmt: skip
    theatre.send_people(person[None])
    target = theatre.target((size * over, size * over))
    theatre.begin(target, GREY)
    values = {"clipFromWorld": eye.clip_from_world(), "eye": eye.place_m, "focalPx": 869.0, "coarse": 1}
    one = np.array([[0.0, 1.0]], np.float32)
    if level is None:
        theatre.draw_impostors(one, values)
    else:
        theatre.draw_people(level, one, values)
    picture = theatre.read(target)[..., :3].astype(float)
    return picture.reshape(size, over, size, over, 3).mean(axis=(1, 3))


def likeness(want: np.ndarray, got: np.ndarray) -> float:
    """SSIM of two shots in the box of the person with four pixels around."""
    at = np.argwhere(np.abs(want - 127.5).max(axis=2) > 4)
    box = np.s_[at[:, 0].min() - 4 : at[:, 0].max() + 5, at[:, 1].min() - 4 : at[:, 1].max() + 5]
    return float(structural_similarity(want[box], got[box], channel_axis=2, data_range=255))
