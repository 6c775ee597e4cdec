"""Painted people as results, for crowds."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from cloner.crowd.packs.pack import make_pack
from cloner.crowd.packs.wanted import Wanted
from cloner.exporters.shared.regions import texel_triangles
from cloner.generic.load import load_generic
from cloner.project.clone_file import CLONE_FILE, save_clone
from cloner.records.clones import Clone, TextureAtlas
from cloner.records.regions import REGIONS
from kit.clones import SHIRT, toy_clone

WANTED = Wanted(people=60, views=8, poses=8, vat=True)


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
