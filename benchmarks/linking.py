"""Outlines by linking against the mask's contour, random paths and the worst paths; the truth is known.

    python benchmarks/linking.py PEOPLE --write

PEOPLE holds people of the kit with labels of whom nothing was learned.  Every photo's outline is traced four times from
the same mask and the same edges; the truth is read only to score.  Errors are mean distances between an outline and the
true one, both ways, in px of a photo 1,800 px high, at sub-pixel places.  Then the masks are spoilt on purpose, and the
samples' plain photos are traced without any net, from named points 2 px off the true outline.
"""

from __future__ import annotations

import argparse
import subprocess
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final
from unittest.mock import patch

import cv2
import numpy as np
from linking_masks import DISTURBED, disturb
from numpy.typing import NDArray
from PIL import Image
from scipy.spatial import cKDTree

from cloner import pipeline
from cloner.evaluate.kit import kit_people
from cloner.evaluate.rulers import OUTLINE_HEIGHT_PX, overlap
from cloner.frames import ViewId
from cloner.project.corrections import no_corrections
from cloner.project.folder import load_photos
from cloner.records.photos import PhotoSet
from cloner.records.points import PointSet, Proposals
from cloner.stages.points import for_fitting
from cloner.stages.silhouettes import behind, outline_points, probability
from cloner.vision import tracing
from cloner.vision.band import LinkParams
from cloner.vision.loops import figure_height, fill_polygons, mask_loops, resample_closed
from cloner.vision.outlines import extract_outline, smoothed
from cloner.vision.paths import Candidates, links_of, score_path
from cloner.vision.paths import Path as EdgePath
from cloner.vision.plain_room import outline_from_points

ROOT: Final = Path(__file__).resolve().parents[1]
PAGE: Final = ROOT / "docs" / "linking_benchmark.md"
Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
Polygons = list[Array]
#: Random paths of which the worst is taken.
TRIES: Final = 40
STEP_PX: Final = 0.5
BORDER_PX: Final = 3.0
CLICK_PX: Final = 2.0
WAYS: Final = ("path of greatest G^P", "mask's contour", "random path", "worst G^P")


@dataclass(frozen=True, slots=True, eq=False)
class Shot:
    """One photo with its mask 0..1, its points, what other photos show behind, and the true silhouette."""

    who: str
    view: ViewId
    rgb: NDArray[np.uint8]
    mask: NDArray[np.float32]
    points_px: Array
    named_px: Array
    room: NDArray[np.float32] | None
    truth: Mask


def shots(who: str, folder: Path, truth_of: Callable[[str], Mask]) -> Iterator[Shot]:
    """Yield the body photos of one set."""
    loaded = load_photos(folder)
    photos = PhotoSet({view: photo for view, photo in loaded.photos.items() if view.is_body})
    stages = tuple(stage for stage in pipeline.STAGES if stage.name in ("proposals", "points"))
    values, _ = pipeline.run({"photos": photos, "corrections": no_corrections()}, stages=stages)
    proposals, points = values["proposals"], values["body_points"]
    assert isinstance(proposals, Proposals)
    assert isinstance(points, PointSet)
    for view, proposal in proposals.views.items():
        given = points.views[view]
        _, places, _ = outline_points(for_fitting(given))
        # all but joints; soles, toes and heels lie on the outline too, and are no bounds of the product's segments
        named = given.points_px[[not name.startswith(("l_", "r_")) for name in given.names]]
        room = behind(photos, proposals, view)
        rgb, mask = photos.photos[view].rgb, probability(proposal)
        yield Shot(who, view, rgb, mask, places, named, room, truth_of(view.value))


def sample_shots() -> Iterator[Shot]:
    """Yield the body photos of all samples."""
    for who in ("anna", "boris"):
        for kind in ("plain", "booth", "handheld"):
            folder = ROOT / "samples" / who
            prefix = "truth_handheld_mask_" if kind == "handheld" else "truth_mask_"
            yield from shots(
                f"{who} {kind}", folder / kind, lambda v, f=folder, p=prefix: _picture(f / f"{p}{v}.png") > 127
            )


def _picture(path: Path) -> NDArray[np.uint8]:
    """Return a label or mask picture (H, W)."""
    picture = np.asarray(Image.open(path))
    return picture if picture.ndim == 2 else picture[..., 0]


def contours(mask: NDArray[np.float32]) -> Polygons:
    """Return a mask's own contours, smoothed as the linking smooths them."""
    height = figure_height(mask)
    return [loop.points for loop in mask_loops(smoothed(mask, height, LinkParams()), height_px=height)]


def true_contours(truth: Mask) -> Polygons:
    """Return the true outline; 0.7 px of blur take the staircase of its pixels off."""
    soft = cv2.GaussianBlur(truth.astype(np.float32), (0, 0), 0.7, borderType=cv2.BORDER_REPLICATE)
    return [loop.points for loop in mask_loops(soft, height_px=figure_height(soft))]


def error_px(found: Polygons, truth: Mask) -> float:
    """Return the mean distance between two outlines, both ways, px at 1,800 px photo height."""
    rows, columns = truth.shape
    clouds = []
    for polygons in (found, true_contours(truth)):
        cloud = np.concatenate([resample_closed(each, step_px=STEP_PX) for each in polygons])
        inside = (cloud > BORDER_PX).all(axis=1) & (cloud < [columns - BORDER_PX, rows - BORDER_PX]).all(axis=1)
        clouds.append(cloud[inside])
    there, back = (cKDTree(b).query(a)[0] for a, b in (clouds, clouds[::-1]))
    return float(np.concatenate([there, back]).mean()) * OUTLINE_HEIGHT_PX / rows


def by_chance(rng: np.random.Generator, tries: int) -> Callable[..., EdgePath | None]:
    """Return a stand-in for ``best_path``: the worst of some random walks along the links of the band."""

    def path(near: Candidates, *, longest_bridge_px: float) -> EdgePath | None:
        if len(near.starts) == 0:
            return None
        links = links_of(near, longest_bridge_px=longest_bridge_px)
        first = np.argsort(near.places)[: max(len(near.places) // 10, 3)]
        found = []
        for _ in range(tries):
            walk = [int(rng.choice(first))]
            while len(onward := links.second[links.first == walk[-1]]):
                walk.append(int(rng.choice(onward)))
            members = np.array(walk, dtype=np.intp)
            found.append(EdgePath(members, score_path(members, near)))
        return min(found, key=lambda each: each.goodness)

    return path


def traced(shot: Shot, mask: NDArray[np.float32], room: NDArray[np.float32] | None) -> tuple[Polygons, Mask]:
    """Return the outline as the product traces it, and its filled pixels."""
    outline = extract_outline(shot.rgb, mask, shot.points_px, room=room)
    return [loop.polygon for loop in outline.loops], outline.filled


def four_ways(shot: Shot, rng: np.random.Generator) -> tuple[list[float], list[float]]:
    """Return errors and IoU of the outline traced in the four ways of ``WAYS``."""
    height = figure_height(shot.mask)
    loops = mask_loops(smoothed(shot.mask, height, LinkParams()), height_px=height)
    plain, holes = [loop.points for loop in loops], [loop.is_hole for loop in loops]
    found = [traced(shot, shot.mask, shot.room), (plain, fill_polygons(plain, holes, shot.truth.shape))]
    for tries in (1, TRIES):
        with patch.object(tracing, "best_path", by_chance(rng, tries)):
            found.append(traced(shot, shot.mask, shot.room))
    return [error_px(p, shot.truth) for p, _ in found], [overlap(filled, shot.truth) for _, filled in found]


def interval(first: Array, second: Array, rng: np.random.Generator) -> str:
    """Return the ratio of two means over the same photos with its 95 % interval (paired bootstrap)."""
    rows = rng.integers(0, len(first), (4000, len(first)))
    low, high = np.quantile(first[rows].mean(axis=1) / second[rows].mean(axis=1), (0.025, 0.975))
    return f"{first.mean() / second.mean():.2f} ({low:.2f} to {high:.2f})"


def comparison(found: dict[str, list[tuple[list[float], list[float]]]], rng: np.random.Generator) -> list[str]:
    """Return the table of the four ways a group of photos."""
    out = [f"| photos | {' | '.join(WAYS)} | path / mask's contour | path / random path |", "| --- " * 7 + "|"]
    for group, rows in found.items():
        errors = np.array([error for error, _ in rows])
        cells = [f"{errors[:, k].mean():.2f} px, IoU {np.mean([iou[k] for _, iou in rows]):.4f}" for k in range(4)]
        ratios = [interval(errors[:, 0], errors[:, k], rng) for k in (1, 2)]
        out.append(f"| {group} ({len(rows)}) | {' | '.join([*cells, *ratios])} |")
    return out


def spoilt(seen: list[Shot], rng: np.random.Generator) -> list[str]:
    """Return the table of masks spoilt on purpose, two photos a way."""
    out = ["| mask | its own contour | path | ratio |", "| --- | --- | --- | --- |"]
    for number, kind in enumerate(DISTURBED):
        errors = []
        for shot in seen[2 * number % len(seen) :][:2]:
            mask = disturb(shot.mask, kind, rng)
            errors.append((error_px(contours(mask), shot.truth), error_px(traced(shot, mask, None)[0], shot.truth)))
        own, path = np.array(errors).mean(axis=0)
        out.append(f"| {kind} | {own:.2f} px | {path:.2f} px | {path / own:.2f} |")
    return out


def without_nets(seen: list[Shot], rng: np.random.Generator) -> list[str]:
    """Return the table of outlines from named points alone, each ``CLICK_PX`` off the true outline."""
    out = ["| photo | points | their polygon, IoU | outline, IoU | error |", "| --- | --- | --- | --- | --- |"]
    for shot in seen:
        contour = max(true_contours(shot.truth), key=len)
        away, at = cKDTree(contour).query(shot.named_px)
        at = np.unique(at[away < 0.03 * figure_height(shot.mask)])
        points = contour[at] + rng.normal(0.0, CLICK_PX, (len(at), 2))
        outline = outline_from_points(shot.rgb, points)
        polygon = fill_polygons([points], [False], shot.truth.shape)
        cells = f"{overlap(polygon, shot.truth):.3f} | {overlap(outline.filled, shot.truth):.4f}"
        error = error_px([loop.polygon for loop in outline.loops], shot.truth)
        out.append(f"| {shot.who} {shot.view.value} | {len(at)} | {cells} | {error:.2f} px |")
    return out


def main() -> None:
    """Trace, score and print the page."""
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("people", type=Path)
    asked.add_argument("--write", action="store_true", help="write the page into docs")
    given = asked.parse_args()
    rng = np.random.default_rng(0)
    found: dict[str, list[tuple[list[float], list[float]]]] = {"people of the kit": []}
    judged, plain, people = [], [], kit_people([given.people])
    kit = (
        shot
        for person in people
        for shot in shots(person.name, person, lambda v, p=person: _picture(p / f"{v}_labels.png") > 0)
    )
    for group, seen in (("people of the kit", kit), ("", sample_shots())):
        for shot in seen:
            kept = judged if group else plain
            if group or shot.who.endswith("plain"):
                kept.append(shot)
            found.setdefault(group or shot.who, []).append(four_ways(shot, rng))
            print(shot.who, shot.view.value, np.round(found[group or shot.who][-1], 4).tolist(), flush=True)
    asking = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True)
    command = f"`python benchmarks/linking.py PEOPLE --write` at {asking.stdout.strip()}"
    page = [
        "# Outlines by linking",
        "",
        f"{len(judged)} photos of {len(people)} judged people; {command}.",
    ]
    page += ["Mean distance to the true outline, px at 1,800 px height; ratios with 95 % intervals, paired.", ""]
    page += [
        *comparison(found, rng),
        "",
        "## Masks spoilt on purpose by a fiftieth of the figure",
        "",
        *spoilt(judged, rng),
    ]
    page += ["", "## Without nets, from named points alone", "", *without_nets(plain, rng)]
    print("\n".join(page))
    if given.write:
        PAGE.write_text("\n".join(page) + "\n")


if __name__ == "__main__":
    main()
