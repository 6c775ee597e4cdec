"""People of the generator: photos to clone, and their truth."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Final

import cv2
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from cloner.errors import ClonerError
from cloner.evaluate.measures.posing import turning_marks
from cloner.evaluate.measures.rulers import fit_similarity, transform_points
from cloner.evaluate.measures.surfaces import sample_surface
from cloner.evaluate.truths.truth import HALF_PIXEL, Truth, TruthSurface, TruthView, read_json, truth_camera, vectors
from cloner.frames import ViewId, m_from_mm
from cloner.generic.load import load_generic
from cloner.head.jaw import JOINT as JAW
from cloner.records.arrays import Array
from cloner.records.labels import LABELS
from cloner.vision.photographs.pictures import read_picture

Labels = NDArray[np.uint8]

#: The set's name in rows: a person of the generator has one.
KIT_SET: Final = "kit"
#: Views of the generator that no clone gets to see, and our names for them.
HELD_OUT: Final = {"body_three_quarter": "body_three_quarter", "three_quarter": "face_three_quarter"}
#: Points that stand for the skin of the naked body; 3 mm apart on average.
_SKIN_SAMPLES: Final = 200_000
#: The middle of the upper lip's lower border and of the lower lip's upper one, MPEG-4's names.
_LIPS: Final = ("2.2", "2.3")
#: Points of an eyeball, and its radius: it hides the socket behind (adults: 12 mm).
_EYE_SAMPLES: Final = 2_000
_EYE_RADIUS_M: Final = 0.012


@dataclass(frozen=True, slots=True, eq=False)
class KitTruth:
    """Truth of one person of the generator.

    Attributes
    ----------
    truth : Truth
        In the words of the other visitors; the surface is the naked body's, in the pose of the first view, with the
        mouth as the photo shows it that shows it most shut: one photo in five shows it open, and clones rest with it
        shut.
    labels : mapping of view name to (H, W) uint8
        Places in `LABELS`, of every photo, also the held-out ones.
    bodies_m : mapping of view name to (V, 3) float64
        The naked body in the pose of every photo, truth frame; vertices numbered as the generic human's.
    """

    truth: Truth
    labels: Mapping[str, Labels]
    bodies_m: Mapping[str, Array]

    def whole_m(self, view: str) -> Array:
        """Return the generic's vertices (V, 3), those of the naked body where they truly are in a photo's pose."""
        whole, own = np.array(load_generic().vertices_m, np.float64), self.bodies_m[view]
        whole[: len(own)] = own
        return whole


def is_kit_person(folder: Path) -> bool:
    """Return whether a folder holds one person of the generator."""
    return (folder / "truth.json").is_file() and any(folder.glob("*_labels.png"))


def kit_people(paths: Sequence[Path]) -> list[Path]:
    """Return the people of the generator among folders, and inside folders that hold several."""
    found: list[Path] = []
    for path in paths:
        if is_kit_person(path):
            found.append(path)
        elif path.is_dir() and not (path / "truth.json").is_file():
            found += [inner for inner in sorted(path.iterdir()) if is_kit_person(inner)]
    return found


@contextmanager
def photos_without_truth(person: Path, shown: Collection[ViewId] = tuple(ViewId)) -> Iterator[Path]:
    """Yield a folder with the photos of a person that are shown, and nothing of the truth."""
    with tempfile.TemporaryDirectory(prefix="cloner-kit-") as place:
        folder = Path(place) / person.name
        folder.mkdir()
        for view in shown:
            photo = person / f"{view.value}.jpg"
            if photo.is_file():
                shutil.copy(photo, folder)
        yield folder


def read_kit(person: Path) -> KitTruth:
    """Read the truth of one person of the generator.

    Raises
    ------
    ClonerError
        If a file of the truth is missing or cannot be read.
    """
    data = read_json(person / "truth.json")
    photos = {view: read_picture(person / f"{view}.jpg").rgb for view in data["cameras"]}
    labels = {view: _read_labels(person / f"{view}_labels.png", photo.shape[:2]) for view, photo in photos.items()}
    try:
        with np.load(person / "truth_body.npz") as held:
            quads = held["faces"].astype(np.int32)
            bodies = {view: held[f"vertices_{view}"].astype(np.float64) for view in data["cameras"]}
    except (OSError, ValueError, KeyError) as error:
        raise ClonerError("the truth's body is missing or broken", "Copy the file again", "truth_body.npz") from error
    named = {view: HELD_OUT.get(view, view) for view in data["cameras"]}
    truth = Truth(
        visitor=person.name,
        set_name=KIT_SET,
        stature_m=m_from_mm(float(data["stature_mm"])),
        sole_m=m_from_mm(float(data["sole_height_mm"])),
        girths_mm={name: float(value) for name, value in data["girths_mm"].items()},
        views={
            ours: _read_view(view, ours, data, photos[view], labels[view], bodies[view]) for view, ours in named.items()
        },
        surface=_surface(data, _with_shut_mouth(bodies[str(data["measured_in_pose_of"])], bodies), quads),
    )
    return KitTruth(
        truth,
        {named[view]: picture for view, picture in labels.items()},
        {named[view]: body for view, body in bodies.items()},
    )


def side_shown(seen: TruthView) -> str:
    """Return the side of a person that a body photo shows: "front", "back", "left" or "right"."""
    if seen.name in ("body_front", "body_back"):
        return seen.name.removeprefix("body_")
    across = seen.camera.camera_from_model[:3, :3] @ (seen.joints_m["shoulder_L"] - seen.joints_m["shoulder_R"])
    return "left" if across[2] < 0.0 else "right"


def _read_labels(path: Path, shape: tuple[int, ...]) -> Labels:
    """Return true labels at the size (H, W) at which the product reads the photo: large photos are reduced."""
    try:
        with Image.open(path) as picture:
            labels = np.asarray(picture, dtype=np.uint8)
    except (OSError, ValueError) as error:
        raise ClonerError("a label picture is missing or broken", "Copy the file again", path.name) from error
    if labels.ndim != 2 or labels.max() >= len(LABELS):
        raise ClonerError("a label picture has other labels than this program knows", "Copy the file again", path.name)
    return np.asarray(cv2.resize(labels, (shape[1], shape[0]), interpolation=cv2.INTER_NEAREST))


def _read_view(
    view: str, ours: str, data: Mapping[str, Any], photo: NDArray[np.uint8], labels: Labels, body_m: Array
) -> TruthView:
    marks, camera = data["features"][view]["points"], truth_camera(data["cameras"][view])
    height, width = photo.shape[:2]
    scale = height / camera.height_px  # below 1 where the product reduces a large photo
    return TruthView(
        name=ours,
        camera=replace(camera, width_px=width, height_px=height, focal_px=scale * camera.focal_px),
        points_m=vectors(data["points_3d_m_by_view"][view]) | turning_marks(load_generic(), body_m),
        joints_m=vectors(data["joints_3d_m_by_view"][view]),
        marks_px={
            mark: scale * np.array(entry["xy"], dtype=np.float64) - HALF_PIXEL
            for mark, entry in marks.items()
            if entry["visible"] and entry["in_frame"]
        },
        mask=labels > 0,
        photo=photo,
    )


def _with_shut_mouth(body_m: Array, bodies: Mapping[str, Array]) -> Array:
    """Return a naked body (V, 3) with the jaw of the pose in which the lips lie nearest, laid there by the skull."""
    generic = load_generic()
    upper, lower = (generic.feature(name) for name in _LIPS)
    shut = min(bodies.values(), key=lambda body: float(np.linalg.norm(body[upper] - body[lower])))
    skull, jaw = generic.region("scalp")[: len(body_m)], generic.carried_by(JAW)[: len(body_m)] > 0.0
    laid = transform_points(fit_similarity(shut[skull], body_m[skull], scale=False), shut)
    return np.where(jaw[:, None], laid, body_m)


def _surface(data: Mapping[str, Any], body_m: Array, quads: NDArray[np.int32]) -> TruthSurface:
    """Return the naked body as points, with eyeballs to hide the sockets; nothing of it is dressed or labelled."""
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    inside_mouth = load_generic().region("mouth_interior")[: len(body_m)]
    skin = triangles[~inside_mouth[triangles].any(axis=1)]
    rng = np.random.default_rng(0)
    points, normals, _ = sample_surface(body_m, skin, _SKIN_SAMPLES, rng=rng)
    joints, marks = vectors(data["joints_3d_m"]), vectors(data["points_3d_m"])
    generic = load_generic()
    ours, carried = [name for name in marks if name in generic.feature_names], generic.carried_by(JAW)
    marks |= {name: body_m[generic.feature(name)] for name in ours if carried[generic.feature(name)] > 0.0}
    outwards = rng.normal(size=(_EYE_SAMPLES, 3))
    outwards /= np.linalg.norm(outwards, axis=1, keepdims=True)
    eyes = [joints[f"eye_{side}"] + _EYE_RADIUS_M * outwards for side in "LR"]
    kind = np.repeat(["bare", "organ"], [len(points), 2 * _EYE_SAMPLES])
    return TruthSurface(
        np.vstack([points, *eyes]),
        np.vstack([normals, outwards, outwards]),
        kind,
        joints,
        marks | turning_marks(generic, body_m),
        body_m,
        skin,
    )
