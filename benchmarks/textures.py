"""What a clone's texture costs and how clean it is: time, memory, seams, background that crept on to the person.

    python benchmarks/textures.py samples/anna/booth samples/boris/booth [--size 4096] [--page docs/textures.md]

"Like the wall" counts what lies within dE 6 of the colours beside the person in the body photos: texels of the clone
that photos painted, and, as what may be expected, the person's own pixels in those photos by the true masks.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from skimage.color import deltaE_ciede2000, rgb2lab

from cloner.evaluate.figures.likeness import held_out_likeness
from cloner.evaluate.figures.seams import seam_ratios
from cloner.evaluate.truths.truth import THREE_QUARTER, Truth, read_truth
from cloner.frames import BODY_VIEWS
from cloner.generic.charts import generic_atlas
from cloner.generic.load import load_generic
from cloner.making import clone_photos
from cloner.project.folder import load_photos, read_corrections, read_person
from cloner.records.clones import Clone

LIKE: Final = 6.0  # dE2000: a wall's own spread of light and noise
BESIDE_PX: Final = (8, 60)  # how far beside the outline the wall is looked at
WALL_COLOURS: Final = 4
COLUMNS: Final = (
    "set", "CPU s", "peak MiB", "seen %", "front/back", "neck", "face", "like the wall ‰", "person's own ‰",
    "body SSIM", "body dE", "face SSIM", "face dE",
)  # fmt: skip


def wall_colours(truth: Truth) -> NDArray[np.uint8]:
    """Return the (K, 3) commonest colours beside the person in the body photos, sRGB."""
    beside = []
    for name in BODY_VIEWS:
        view = truth.views[name]
        away = cv2.distanceTransform((~view.mask).astype(np.uint8), cv2.DIST_L2, 5)
        beside.append(view.photo[(away > BESIDE_PX[0]) & (away < BESIDE_PX[1])][::7])
    pixels = np.concatenate(beside).astype(np.float32)
    cv2.setRNGSeed(0)
    criteria = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 30, 0.5)
    _, _, centres = cv2.kmeans(pixels, WALL_COLOURS, None, criteria, 2, cv2.KMEANS_PP_CENTERS)
    return np.asarray(np.rint(centres), np.uint8)


def share_like(rgb: NDArray[np.uint8], colours: NDArray[np.uint8]) -> float:
    """Return which share of (N, 3) pixels lies within `LIKE` of any of the (K, 3) colours."""
    known, count = np.unique(rgb // 2 * 2, axis=0, return_counts=True)
    lab, walls = rgb2lab(known[None])[0], rgb2lab(colours[None])[0]
    near = np.min([deltaE_ciede2000(lab, np.broadcast_to(wall, lab.shape)) for wall in walls], axis=0) < LIKE
    return float(count[near].sum() / max(int(count.sum()), 1))


def background_shares(clone: Clone, truth: Truth) -> tuple[float, float]:
    """Return the shares of the clone's photographed texels and of the person's own pixels that look like the wall."""
    walls = wall_colours(truth)
    charts = generic_atlas(load_generic(), len(clone.atlas.rgb)).covered()
    own = np.concatenate([truth.views[name].photo[truth.views[name].mask] for name in BODY_VIEWS])
    return share_like(clone.atlas.rgb[charts & (clone.atlas.coverage > 0)], walls), share_like(own, walls)


def measure(photos_dir: Path, size: int) -> list[str]:
    """Return one row of the table, in the order of `COLUMNS`."""
    person, truth = read_person(photos_dir), read_truth(photos_dir.parent, photos_dir.name)
    values, reports = clone_photos(
        load_photos(photos_dir), person, read_corrections(photos_dir), texture_size=size, known={}
    )
    clone: Clone = values["clone"]
    told = next(report for report in reports if report.name == "textures")
    seen = next(residual.value for residual in told.residuals if residual.name == "texels_seen")
    generic, start = load_generic(), clone.views[BODY_VIEWS[0]].rotations
    likeness = [held_out_likeness(clone, start, generic, truth.views[name])[0] for name in THREE_QUARTER]
    numbers = [told.cpu_seconds, told.peak_mib, seen, *(ratio or 0.0 for ratio in seam_ratios(clone, generic).values())]
    numbers += [1000.0 * share for share in background_shares(clone, truth)]
    numbers += [found[name] for found in likeness for name in ("ssim", "delta_e")]
    return [f"{photos_dir.parent.name} {photos_dir.name}", *(f"{number:.2f}" for number in numbers)]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("photos", nargs="+", type=Path)
    parser.add_argument("--size", type=int, default=2048)
    parser.add_argument("--page", type=Path)
    chosen = parser.parse_args()
    rows = [list(COLUMNS), ["---"] * len(COLUMNS)]
    for photos_dir in chosen.photos:
        rows.append(measure(photos_dir, chosen.size))
        print(rows[-1], flush=True)
    table = "\n".join("| " + " | ".join(row) + " |" for row in rows)
    print(table)
    if chosen.page is not None:
        chosen.page.write_text(f"# Textures\n\n`python benchmarks/textures.py`\n\n{table}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
