"""Known heads of a scan-based family (shared/foreign/ict_family.npz; not ours to ship) for the head benchmark.

Seeds of judged heads are those of the benchmark's command line; calibrations draw from 20,000 on, and never below.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

import numpy as np
from head_people import FILLED, HEIGHT, KnownHead, towards
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.evaluate.measures.surfaces import sample_surface
from cloner.evaluate.truths.truth import TruthSurface
from cloner.frames import FILM_LONG_SIDE_MM, ViewId
from cloner.generic.load import GENERIC_STATURE_M, load_generic
from cloner.records.photos import Person, Photo, PhotoSet
from cloner.records.views import Camera

Array = NDArray[np.float64]


DISTANCE_M: Final = (0.7, 2.0)
#: Turns of the side camera about the vertical: half of the sitters are placed with care, degrees; front cameras are
#: turned up to the second, every third head's up to the third.
SIDE_DEG, FRONT_DEG, TURNED_DEG = (3.0, 10.0), 5.0, 15.0
#: Nod and tilt of either photo, degrees.
NOD_DEG, TILT_DEG = 6.0, 4.0
LIGHTS: Final = ("soft", "side", "lamp")
BACKGROUNDS: Final = ("plain", "cluttered")
SURFACE_POINTS: Final = 60_000


def scan_known(seed: int, path: Path) -> KnownHead:
    """Photograph one random head of the family from the front and one side.

    Raises
    ------
    ClonerError
        If the family is not on this machine.
    """
    if not path.is_file():
        raise ClonerError("the family of scanned heads is not on this machine", "Give its file with --scans", str(path))
    from scan_portraits import photograph_scan, scan_sitter

    rng = np.random.default_rng([seed, 69])
    stature = float(np.clip(rng.normal(1.70, 0.09), 1.50, 1.95))
    sitter = scan_sitter(path, seed, (stature / GENERIC_STATURE_M) ** 0.35)
    light, background = LIGHTS[seed % 3], BACKGROUNDS[seed % 2]
    distance = float(rng.uniform(*DISTANCE_M))
    truth = scan_truth(sitter.head_m, sitter.twin_m, path)
    marks = truth.marks_m
    middle = (marks["nasion"] + marks["chin_bottom"]) / 2.0 - [0.0, 0.01, 0.08]
    tall = float(np.ptp(sitter.head_m[:, 1][sitter.head_m[:, 1] > marks["chin_bottom"][1]]))
    focal = float(rng.uniform(*FILLED)) * HEIGHT * distance / tall
    side = float(rng.choice([-90.0, 90.0]))
    exif = focal * FILM_LONG_SIDE_MM / HEIGHT if rng.random() < 0.5 else None
    turns = {
        ViewId.FACE_FRONT: rng.uniform(-1.0, 1.0) * (TURNED_DEG if seed % 3 == 2 else FRONT_DEG),
        ViewId.FACE_SIDE: side + rng.uniform(-1.0, 1.0) * SIDE_DEG[(seed // 2) % 2],
    }
    photos, views = {}, {}
    for view, azimuth in turns.items():
        away = distance * float(rng.uniform(0.92, 1.08))
        camera = towards(middle, azimuth, away, focal, rng, turn_deg=(0.0, NOD_DEG, TILT_DEG))
        picture = photograph_scan(sitter, camera, light, background, rng)
        photos[view] = Photo(view, picture, exif, "", f"{view.value}.jpg")
        views[view] = camera
    name = f"{seed:03d}_scan"
    about = {"light": light, "distance_m": distance, "exif": "yes" if exif else "no", "side": side,
             "background": background, "hair_m": sitter.hair_m, "front_deg": turns[ViewId.FACE_FRONT],
             "side_deg": turns[ViewId.FACE_SIDE] - side}  # fmt: skip
    return KnownHead(name, PhotoSet(photos), Person(name, "", stature), truth, sitter.twin_m, views, about)


def scan_truth(head_m: Array, twin_m: Array, path: Path) -> TruthSurface:
    """Return the rulers' truth of one head of the family: its own skin, and points named like ours."""
    from scan_heads import EYES, SKIN, marks_of, read_family

    family, generic = read_family(path), load_generic()
    skin = family.triangles[(family.triangles < SKIN).all(axis=1)]
    points, normals, _ = sample_surface(head_m, skin, SURFACE_POINTS, rng=np.random.default_rng(0))
    organs = np.vstack([head_m[low:high] for low, high in EYES.values()])
    marks = marks_of(family, head_m)
    marks |= {name: twin_m[generic.feature(name)] for name in ("ala_L", "ala_R")}
    return TruthSurface(
        np.vstack([points, organs]),
        np.vstack([normals, np.tile([0.0, 0.0, 1.0], (len(organs), 1))]),
        np.array(["bare"] * len(points) + ["organ"] * len(organs)),
        {}, marks, np.zeros((0, 3)), np.zeros((0, 3), np.int32),
    )  # fmt: skip


def azimuth_error_deg(clone_from_truth: Array, fitted: Camera, true: Camera) -> float:
    """Return by how much a fitted camera stands too far round the person's left, degrees.

    Parameters
    ----------
    clone_from_truth : (3, 3)
        Rotation that lays the true head on the clone.
    """
    seen = [clone_from_truth.T @ fitted.camera_from_model[2, :3], true.camera_from_model[2, :3]]
    turned = np.degrees([np.arctan2(axis[0], axis[2]) for axis in seen])
    return float((turned[0] - turned[1] + 180.0) % 360.0 - 180.0)
