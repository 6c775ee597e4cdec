"""Photographs of the people kit as the label net sees them: crops, features, labels.

``python generic_models/build/label_crops.py KIT PEOPLE WORK --workers 2``: KIT is the folder of the generator of
labelled people (``make_people.py``), PEOPLE how many to draw, WORK where photographs and crops are kept. What is there
already is kept, so a stopped run goes on.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator
from functools import lru_cache
from itertools import count, islice
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from cloner.detectors.nets.litert import label_features
from cloner.vision.photographs.crops import Crop, cut, photo_px_from_crop

#: First seed of the people that teach; benchmarks judge on 5000 to 5999, other judges on 9000 to 9999.
FIRST_SEED = 20000
#: Views and photo widths: a head fills the face photos, the body's photos are seen as a whole and around the head.
VIEWS = {"face": (("face_front", "face_side"), 640), "body": (("body_front", "body_side", "body_back"), 800)}
#: Copies of every crop: one nearly as photographed, the others in other light and before other walls.
COPIES = 2
SIDE = 256
OUTSIDE = 255  # label of what lies beyond the photo


def is_wanted(person: dict[str, Any], seed: int) -> bool:
    """Return whether a drawn person teaches: what is rare among people, or hard, is kept oftener."""
    rng = np.random.default_rng([seed, 4242])
    rare = person["beard"]["kind"] not in ("none", "stubble") or "glasses" in person["acc"]
    rare |= person["hair"]["style"] in ("bald", "horseshoe", "buzz", "overeye", "curtain", "bob")
    hat = person["acc"].get("head", {}).get("kind") in ("cap", "beanie", "headscarf")
    if hat and rng.random() < 0.5:
        return False
    return bool(rng.random() < (1.0 if rare else 0.7))


@lru_cache(maxsize=1)
def generator(kit: Path) -> tuple[Any, Any]:
    """Return the generator's module and its workshop, one a process."""
    sys.path.insert(0, str(kit))
    import make_people

    return make_people, make_people.Kit(None)


def wanted_seeds(kit: Path, people: int) -> list[int]:
    """Return the seeds of so many people who teach."""
    make_people, maker = generator(kit)
    drawn = ((seed, make_people.draw_person(seed, maker.inv)) for seed in count(FIRST_SEED))
    return list(islice((seed for seed, person in drawn if is_wanted(person, seed)), people))


def photograph(task: tuple[Path, Path, int]) -> None:
    """Photograph one person, without the truth that labels do not need."""
    kit, work, seed = task
    for kind, (views, width) in VIEWS.items():
        folder = work / kind / f"p{seed:05d}"
        if not (folder / "done").exists():
            make_people, maker = generator(kit)
            make_people.person(maker, seed, str(work / kind), list(views), width, quiet=True)
            (folder / "truth_body.npz").unlink()
            (folder / "done").touch()


def crops_of(view: str, labels: NDArray[np.uint8], points: dict[str, Any], rng: np.random.Generator) -> Iterator[Crop]:
    """Yield the crop of the person (or the whole face photo) and that of the head, moved and scaled a little."""
    height, width = labels.shape
    rows, columns = np.nonzero(labels)
    if view.startswith("body"):
        side = max(np.ptp(columns), np.ptp(rows)) * rng.uniform(1.02, 1.3)
        middle = np.array([columns.min() + columns.max(), rows.min() + rows.max()]) / 2.0
        x, y = middle + rng.normal(0.0, (0.03, 0.02)) * side
    else:
        side = max(height, width) * rng.uniform(0.92, 1.08)
        x, y = np.array([width - 1, height - 1]) / 2.0 + rng.normal(0.0, (0.03, 0.04)) * side
    yield Crop(float(x), float(y), float(side), float(side))
    top, chin = (np.array(points[name]["xy"]) for name in ("vertex_top", "chin_bottom"))
    head = float(np.hypot(*(chin - top)))
    side = 1.95 * head * rng.uniform(0.85, 1.25)
    x, y = (top + chin) / 2.0 + rng.normal(0.0, 0.07, 2) * head
    yield Crop(float(x), float(y), side, side)


def before_another_wall(
    rgb: NDArray[np.uint8], labels: NDArray[np.uint8], rng: np.random.Generator
) -> NDArray[np.uint8]:
    """Return the photo before a dark curtain or a plain wall; the kit's own are rarely dark."""
    soft = cv2.GaussianBlur((labels > 0).astype(np.float32), (0, 0), 1.2 * rgb.shape[1] / 800)[..., None]
    wall: Any = rgb * rng.uniform(0.02, 0.35) if rng.random() < 0.6 else rng.uniform(0.0, 255.0, 3)
    return np.asarray(rgb * soft + wall * (1.0 - soft), np.uint8)


def in_other_light(rgb: NDArray[np.uint8], rng: np.random.Generator, *, strong: bool) -> NDArray[np.uint8]:
    """Return a crop in other colours, exposure and contrast; strongly also greyer, lit from a side, blurred."""
    share = 1.0 if strong else 0.3
    light = rgb.astype(np.float32) / 255.0 * np.exp(rng.normal(0.0, np.array([0.1, 0.05, 0.13]) * share))
    light = np.clip(light * np.exp(rng.normal(0.0, 0.22 * share)), 0.0, 1.0) ** np.exp(rng.normal(0.0, 0.25 * share))
    if strong and rng.random() < 0.25:
        grey = light.mean(axis=-1, keepdims=True)
        light = grey + (light - grey) * rng.uniform(0.0, 0.8)
    if strong and rng.random() < 0.35:
        y, x = np.mgrid[:SIDE, :SIDE] / (SIDE - 1.0) - 0.5
        turn, depth = rng.uniform(0.0, 2.0 * np.pi), rng.uniform(0.4, 1.6)
        light = light * np.clip(1.0 + depth * (x * np.cos(turn) + y * np.sin(turn)), 0.15, 1.6)[..., None]
    if strong and rng.random() < 0.3:
        light = cv2.GaussianBlur(light, (0, 0), rng.uniform(0.5, 1.6))
    light = light + rng.normal(0.0, 1.0, light.shape) * rng.uniform(0.0, 0.03 * share)
    return np.asarray(np.clip(255.0 * light, 0.0, 255.0), np.uint8)


def cut_person(folder: Path) -> tuple[NDArray[np.float16], NDArray[np.uint8], NDArray[np.uint8]]:
    """Return features (N, F) float16, crops (N, 256, 256, 3) and labels (N, 256, 256) of one person's photos."""
    points = json.loads((folder / "truth.json").read_text())["features"]
    seed = int(folder.name[1:])
    features, crops, labelled = [], [], []
    for view in points:
        photo = np.asarray(Image.open(folder / f"{view}.jpg").convert("RGB"))
        truth = np.asarray(Image.open(folder / f"{view}_labels.png"))
        for copy in range(COPIES):
            rng = np.random.default_rng([seed, copy, sum(map(ord, view))])
            wall = copy > 0 and rng.random() < 0.22
            rgb = before_another_wall(photo, truth, rng) if wall else photo
            for crop in crops_of(view, truth, points[view]["points"], rng):
                image, label = cut_pair(rgb, truth, crop)
                image = in_other_light(image, rng, strong=copy > 0)
                image[label == OUTSIDE] = 0
                if rng.random() < 0.5:
                    image, label = np.ascontiguousarray(image[:, ::-1]), np.ascontiguousarray(label[:, ::-1])
                planes = [np.clip(plane, -6e4, 6e4).astype(np.float16).ravel() for plane in label_features(image)]
                features.append(np.concatenate(planes))
                crops.append(image)
                labelled.append(label)
    return np.stack(features), np.stack(crops), np.stack(labelled)


def cut_pair(
    rgb: NDArray[np.uint8], labels: NDArray[np.uint8], crop: Crop
) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Return a crop of a photo and of its labels, `OUTSIDE` beyond the photo."""
    photo_from_crop = photo_px_from_crop(crop, width=SIDE, height=SIDE)
    flags = cv2.INTER_NEAREST | cv2.WARP_INVERSE_MAP
    kind = cv2.warpAffine(labels, photo_from_crop, (SIDE, SIDE), flags=flags, borderValue=OUTSIDE)
    return cut(np.ascontiguousarray(rgb), crop, width=SIDE, height=SIDE), np.asarray(kind, np.uint8)


def cut_to_file(task: tuple[Path, Path]) -> None:
    """Keep crops, features and labels of one person's photos."""
    folder, target = task
    if not target.with_suffix(".npz").exists():
        features, rgb, labels = cut_person(folder)
        np.save(target.with_suffix(".npy"), features)
        np.savez_compressed(target.with_suffix(".npz"), rgb=rgb, labels=labels)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kit", type=Path)
    parser.add_argument("people", type=int)
    parser.add_argument("work", type=Path)
    parser.add_argument("--workers", type=int, default=2)
    given = parser.parse_args()
    crops = given.work / "crops"
    crops.mkdir(parents=True, exist_ok=True)
    with get_context("spawn").Pool(given.workers) as pool:
        seeds = wanted_seeds(given.kit, given.people)
        for _ in pool.imap_unordered(photograph, [(given.kit, given.work, seed) for seed in seeds]):
            pass
        folders = [done.parent for kind in VIEWS for done in sorted((given.work / kind).glob("p*/done"))]
        tasks = [(folder, crops / f"{folder.parent.name}_{folder.name}") for folder in folders]
        for done, _ in enumerate(pool.imap_unordered(cut_to_file, tasks), 1):
            print(f"{done} of {len(tasks)}", flush=True)


if __name__ == "__main__":
    main()
