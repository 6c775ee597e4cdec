"""Photographs of the people kit as the label net sees them: crops, features, labels, joints, the body under clothes.

``python generic_models/build/label_crops.py KIT PEOPLE WORK --workers 2``: KIT is the folder of the generator of
labelled people (``make_people.py``), PEOPLE how many to draw, WORK where crops are kept. What is there already is kept,
so a stopped run goes on; ``--minutes`` ends it in time. Seeds from 60000 on (``--first``) show bare shoulders, from
70000 on tops of the skin's colour, from 80000 on tight clothes, from 90000 on covered heads.
"""

from __future__ import annotations

import argparse
import json
import shutil
import sys
import time
from collections.abc import Iterator
from functools import lru_cache
from itertools import count, islice
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray
from other_clothes import FIRST_COVERED_SEED, in_other_clothes
from other_light import before_another_wall, in_other_light, made_up
from PIL import Image

from cloner.detectors.nets.litert import label_features
from cloner.evaluate.measures.posing import JOINTS
from cloner.generic.seen_points import NAMES
from cloner.vision.photographs.crops import Crop, cut, photo_px_from_crop

#: First seed of the people that teach; benchmarks judge on 5000 to 5999, other judges on 9000 to 9999.
FIRST_SEED = 20000
#: Views and photo widths: a head fills the face photos, the body's photos are seen as a whole and around the head.
VIEWS = {"face": (("face_front", "face_side"), 640), "body": (("body_front", "body_side", "body_back"), 800)}
#: Copies of every crop: one nearly as photographed, the others in other light and before other walls.
COPIES = 2
SIDE = 256
OUTSIDE = 255  # label of what lies beyond the photo
#: Points that the net is taught to find in a person's crop, as the kit names them.
POINTS = tuple({ours: name for name, ours in JOINTS.items()}.get(name, name) for name in NAMES)
#: Beginnings of the names of the kit's bones, by limb.
LIMBS = {
    "upper_arm": ("upperarm",), "lower_arm": ("lowerarm",), "hand": ("wrist", "metacarpal", "finger"),
    "thigh": ("upperleg",), "shank": ("lowerleg",), "foot": ("foot", "toe"),
}  # fmt: skip
#: Beginnings of the names of the bones that move a face.
FACIAL = ("levator", "oculi", "orbicularis", "oris", "risorius", "temporalis")
#: Parts of the naked body, 1 and on (0 is none): beginnings and end of the names of their bones.
PARTS = {
    "head": (("head", "jaw", "eye", "tongue", "special", *FACIAL), ""),
    "trunk": (("root", "spine", "pelvis", "breast", "clavicle", "shoulder", "neck"), ""),
    **{f"{limb}_{side}": (begins, f".{side}") for limb, begins in LIMBS.items() for side in "LR"},
}
#: Longer side of the picture of parts before it is cut, and side of its crops, px.
DRAWN, PART_SIDE = 512, 128


def is_wanted(person: dict[str, Any], seed: int) -> bool:
    """Return whether a drawn person teaches: what is rare among people, or hard, is kept oftener."""
    rng = np.random.default_rng([seed, 4242])
    if seed >= FIRST_COVERED_SEED:  # dark faces in dark cloth are what is missed
        return person["tone"] in ("brown", "dark") or bool(rng.random() < 0.5)
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

    draw = make_people.draw_person

    def dressed(seed: int, *rest: Any) -> dict[str, Any]:
        return in_other_clothes(make_people, draw(seed, *rest))

    make_people.draw_person = dressed
    return make_people, make_people.Kit(None)


def wanted_seeds(kit: Path, people: int, first: int) -> list[int]:
    """Return the seeds of so many people who teach, from a first one on."""
    make_people, maker = generator(kit)
    drawn = ((seed, make_people.draw_person(seed, maker.inv)) for seed in count(first))
    return list(islice((seed for seed, person in drawn if is_wanted(person, seed)), people))


def photograph(kit: Path, work: Path, seed: int) -> list[Path]:
    """Photograph one person; return the folders of its photos of face and body."""
    make_people, maker = generator(kit)
    for kind, (views, width) in VIEWS.items():
        make_people.person(maker, seed, str(work / kind), list(views), width, quiet=True)
    return [work / kind / f"p{seed:05d}" for kind in VIEWS]


@lru_cache(maxsize=1)
def part_of_vertex(kit: Path) -> NDArray[np.uint8]:
    """Return which of `PARTS`, counted from 1, carries each vertex of the kit's body."""
    _, maker = generator(kit)
    of_bone = np.zeros(len(maker.m.bones), np.uint8)
    for number, (begins, end) in enumerate(PARTS.values(), 1):
        of_bone[[name.startswith(begins) and name.endswith(end) for name in maker.m.bones]] = number
    return np.asarray(of_bone[np.asarray(maker.m.W.argmax(axis=1)).ravel()], np.uint8)


def draw_parts(vertices: NDArray[np.float64], quads: NDArray[np.int64], parts: NDArray[np.uint8],
               camera: dict[str, Any], scale: float) -> NDArray[np.uint8]:  # fmt: skip
    """Return a picture of the naked body's parts: its quads, the far ones first."""
    world = np.asarray(camera["world_to_camera"])
    seen = vertices @ world[:3, :3].T + world[:3, 3]
    places = seen[:, :2] / seen[:, 2:] * (camera["fx"], camera["fy"]) + (camera["cx"], camera["cy"])
    picture = np.zeros((round(camera["height"] * scale), round(camera["width"] * scale)), np.uint8)
    corners = np.round(places[quads] * scale * 16.0).astype(np.int32)
    order = np.argsort(-seen[quads, 2].mean(axis=1))
    part = np.sort(parts[quads], axis=1)[:, 1]
    for quad in order:
        cv2.fillConvexPoly(picture, corners[quad], int(part[quad]), cv2.LINE_4, 4)
    return picture


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


def mirrored_names(names: tuple[str, ...]) -> list[int]:
    """Return where each name's mirror image stands."""
    swap = {"L": "R", "R": "L"}
    return [names.index(name[:-1] + swap[name[-1]] if name[-2:] in ("_L", "_R") else name) for name in names]


#: Rows of points, and of parts with "none" first, after a picture was mirrored.
POINT_MIRROR = np.array(mirrored_names(POINTS))
PART_MIRROR = np.array([0, *(1 + np.array(mirrored_names(tuple(PARTS))))], np.uint8)


def cut_person(folder: Path, kit: Path) -> dict[str, NDArray[Any]]:
    """Return what the decoder is taught by one person's photos: a row a crop.

    ``features`` (N, F) float16, ``rgb`` (N, 256, 256, 3), ``labels`` (N, 256, 256), ``parts`` (N, 128, 128) and
    ``points`` (N, P, 2) float16, px of the crop, NaN where a crop is not of the whole person.
    """
    truth = json.loads((folder / "truth.json").read_text())
    with np.load(folder / "truth_body.npz") as arrays:
        quads = arrays["faces"]
        bodies = {view: arrays[f"vertices_{view}"] for view in truth["features"]}
    seed = int(folder.name[1:])
    found: dict[str, list[NDArray[Any]]] = {name: [] for name in ("features", "rgb", "labels", "parts", "points")}
    for view, features in truth["features"].items():
        photo = np.asarray(Image.open(folder / f"{view}.jpg").convert("RGB"))
        labels = np.asarray(Image.open(folder / f"{view}_labels.png"))
        scale = DRAWN / max(labels.shape)
        parts = draw_parts(bodies[view], quads, part_of_vertex(kit), truth["cameras"][view], scale)
        joints = features["joints_2d"] | {name: point["xy"] for name, point in features["points"].items()}
        places = np.array([joints[name] for name in POINTS]) - 0.5  # the kit's origin is a pixel's corner
        for copy in range(COPIES):
            rng = np.random.default_rng([seed, copy, sum(map(ord, view))])
            wall = copy > 0 and rng.random() < 0.4
            rgb = before_another_wall(photo, labels, rng) if wall else photo
            if copy > 0 and view == "face_front" and rng.random() < 0.4:
                rgb = made_up(rgb, labels, features["points"], rng)
            for number, crop in enumerate(crops_of(view, labels, features["points"], rng)):
                image, label = cut_pair(rgb, labels, crop)
                image = in_other_light(image, rng, strong=copy > 0)
                image[label == OUTSIDE] = 0
                part = cut_parts(parts, crop, scale)
                point = np.full((len(POINTS), 2), np.nan)
                if number == 0 and view.startswith("body"):
                    photo_from_crop = photo_px_from_crop(crop, width=SIDE, height=SIDE)
                    point = (places - photo_from_crop[:, 2]) @ np.linalg.inv(photo_from_crop[:, :2]).T
                if rng.random() < 0.5:
                    image, label = np.ascontiguousarray(image[:, ::-1]), np.ascontiguousarray(label[:, ::-1])
                    part = PART_MIRROR[part[:, ::-1]]
                    point = point[POINT_MIRROR] * (-1.0, 1.0) + (SIDE - 1.0, 0.0)
                planes = [np.clip(plane, -6e4, 6e4).astype(np.float16).ravel() for plane in label_features(image)]
                rows = (np.concatenate(planes), image, label, part, point.astype(np.float16))
                for kept, row in zip(found.values(), rows, strict=True):
                    kept.append(row)
    return {name: np.stack(rows) for name, rows in found.items()}


def cut_parts(parts: NDArray[np.uint8], crop: Crop, scale: float) -> NDArray[np.uint8]:
    """Return a crop of a picture of parts, `PART_SIDE` px a side."""
    photo_from_crop = photo_px_from_crop(crop, width=PART_SIDE, height=PART_SIDE)
    drawn_from_crop = photo_from_crop * scale
    drawn_from_crop[:, 2] += (scale - 1.0) / 2.0
    flags = cv2.INTER_NEAREST | cv2.WARP_INVERSE_MAP
    return np.asarray(cv2.warpAffine(parts, drawn_from_crop, (PART_SIDE, PART_SIDE), flags=flags), np.uint8)


def cut_pair(
    rgb: NDArray[np.uint8], labels: NDArray[np.uint8], crop: Crop
) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Return a crop of a photo and of its labels, `OUTSIDE` beyond the photo."""
    photo_from_crop = photo_px_from_crop(crop, width=SIDE, height=SIDE)
    flags = cv2.INTER_NEAREST | cv2.WARP_INVERSE_MAP
    kind = cv2.warpAffine(labels, photo_from_crop, (SIDE, SIDE), flags=flags, borderValue=OUTSIDE)
    return cut(np.ascontiguousarray(rgb), crop, width=SIDE, height=SIDE), np.asarray(kind, np.uint8)


def teach(task: tuple[Path, Path, int]) -> int:
    """Keep crops, features and labels of one person's photos."""
    kit, work, seed = task
    target = work / "crops" / f"p{seed:05d}"
    if not target.with_suffix(".npz").exists():
        folders = photograph(kit, work, seed)
        cut = [cut_person(folder, kit) for folder in folders]
        arrays = {name: np.concatenate([part[name] for part in cut]) for name in cut[0]}
        np.save(target.with_suffix(".npy"), arrays.pop("features"))
        np.savez_compressed(part := target.with_suffix(".part.npz"), **arrays)
        part.rename(target.with_suffix(".npz"))
        for folder in folders:
            shutil.rmtree(folder)
    return seed


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kit", type=Path)
    parser.add_argument("people", type=int)
    parser.add_argument("work", type=Path)
    parser.add_argument("--first", type=int, default=FIRST_SEED, help="first seed (60000 and on: see above)")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--minutes", type=float, default=float("inf"))
    given = parser.parse_args()
    end = time.monotonic() + 60.0 * given.minutes
    (given.work / "crops").mkdir(parents=True, exist_ok=True)
    with get_context("spawn").Pool(given.workers) as pool:
        tasks = [(given.kit, given.work, seed) for seed in wanted_seeds(given.kit, given.people, given.first)]
        for done, _ in enumerate(pool.imap_unordered(teach, tasks), 1):
            if done % 20 == 0:
                print(f"{done} of {len(tasks)}", flush=True)
            if time.monotonic() > end:
                break


if __name__ == "__main__":
    main()
