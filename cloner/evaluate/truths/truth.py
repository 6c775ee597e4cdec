"""Truth of a visitor, read only after the clone exists."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.frames import m_from_mm
from cloner.geometry.meshes.vectors import unit
from cloner.records.arrays import Array
from cloner.records.views import Camera
from cloner.vision.photographs.pictures import read_picture

SETS: Final = ("plain", "booth", "handheld")
THREE_QUARTER: Final = ("body_three_quarter", "face_three_quarter")
#: Truth files count a pixel's centre as +0.5; the project's frame as 0.
HALF_PIXEL: Final = 0.5
#: MakeHuman's names for eyes ("high-poly"), teeth and tongue: they only block the view inside.
_ORGANS: Final = ("high-poly", "teeth", "tongue")
_STRIPS: Final = ("eyebrow", "eyelashes")
_BARE_PART: Final = "body"


@dataclass(frozen=True, slots=True, eq=False)
class TruthView:
    """What is true of one photo.

    Attributes
    ----------
    name : str
        ``body_front`` ... ``face_three_quarter``.
    camera : Camera
        In the truth's frame: metres, x the person's left, y up from the naked soles.
    points_m : mapping of str to (3,) float64
        Named marks on the bare surface, truth frame of this photo.
    joints_m : mapping of str to (3,) float64
    marks_px : mapping of str to (2,) float64
        Visible marks as seen in the photo, pixel frame of the project.
    mask : (H, W) bool
        Person with clothes and hair.
    photo : (H, W, 3) uint8, the photograph itself
    """

    name: str
    camera: Camera
    points_m: Mapping[str, Array]
    joints_m: Mapping[str, Array]
    marks_px: Mapping[str, Array]
    mask: NDArray[np.bool_]
    photo: NDArray[np.uint8]


@dataclass(frozen=True, slots=True, eq=False)
class TruthSurface:
    """The dressed person as dense points, truth frame, metres.

    Attributes
    ----------
    points_m, normals : (N, 3) float64
    kind : (N,) str array of "bare" (skin), "worn" (clothes, shoes), "hair" or
        "organ" (eyes, teeth, tongue: not measured, but they hide what is behind)
    joints_m : mapping of str to (3,) float64
        The joints of the pose the points are in.
    marks_m : mapping of str to (3,) float64
        Named marks in the same pose.
    bare_m, bare_triangles : (V, 3) float64 and (T, 3) int32
        The naked body's mesh in the same pose where the folder has it, else empty.
    label : (N,) str array
        "skin", "hair", "eyes", "clothes", "shoes", or "" where a part is none of these; empty where nothing is known.
    """

    points_m: Array
    normals: Array
    kind: NDArray[np.str_]
    joints_m: Mapping[str, Array]
    marks_m: Mapping[str, Array]
    bare_m: Array
    bare_triangles: NDArray[np.int32]
    label: NDArray[np.str_] = field(default_factory=lambda: np.zeros(0, dtype=np.str_))


@dataclass(frozen=True, slots=True, eq=False)
class Truth:
    """All that is known of one visitor in one set of photos."""

    visitor: str
    set_name: str
    stature_m: float
    sole_m: float
    girths_mm: Mapping[str, float]
    views: Mapping[str, TruthView]
    surface: TruthSurface


def given_height_m(visitor: Path) -> float:
    """Return the height that the visitor gave, metres: all that the clone is given besides the photos."""
    return m_from_mm(float(read_json(visitor / "truth.json")["stature_mm"]))


def read_truth(visitor: Path, set_name: str) -> Truth:
    """Read the truth of one visitor for one set of photos.

    Parameters
    ----------
    visitor : Path
        Folder with ``truth.json``, ``truth_mask_<view>.png``, ``heldout/`` and
        the sets as sub-folders.
    set_name : str
        "plain", "booth" or "handheld".

    Raises
    ------
    ClonerError
        If a file of the truth is missing or cannot be read.
    """
    base = read_json(visitor / "truth.json")
    handheld = set_name == "handheld"
    data = read_json(visitor / "truth_handheld.json") if handheld else base
    views = {name: _read_view(visitor, set_name, name, data) for name in data["cameras"]}
    return Truth(
        visitor=visitor.name,
        set_name=set_name,
        stature_m=m_from_mm(float(base["stature_mm"])),
        sole_m=m_from_mm(float(base["sole_height_mm"])),
        girths_mm={name: float(value) for name, value in base["girths_mm"].items()},
        views=views,
        surface=_read_surface(visitor / "truth_dressed_points.npz", base),
    )


def read_json(path: Path) -> dict[str, Any]:
    """Return a truth file's content.

    Raises
    ------
    ClonerError
        If it is missing or broken.
    """
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        message = "the truth of this visitor is missing or broken"
        raise ClonerError(
            message, "Give a folder laid out like samples/anna", f"{path.parent.name}/{path.name}"
        ) from error
    return dict(data)


def _read_view(visitor: Path, set_name: str, name: str, data: Mapping[str, Any]) -> TruthView:
    handheld = set_name == "handheld"
    points, joints = data["points_3d_m"], data["joints_3d_m"]
    marks = data["features"][name]["points"]
    prefix = "truth_handheld_mask_" if handheld else "truth_mask_"
    return TruthView(
        name=name,
        camera=truth_camera(data["cameras"][name]),
        points_m=vectors(points[name] if handheld else points),
        joints_m=vectors(joints[name] if handheld else joints),
        marks_px={
            mark: np.array(entry.get("xy_rendered", entry["xy"]), dtype=np.float64) - HALF_PIXEL
            for mark, entry in marks.items()
            if entry["visible"] and entry["in_frame"]
        },
        mask=read_picture(visitor / f"{prefix}{name}.png").rgb[..., 0] > 127,
        photo=read_picture(_photo_path(visitor, set_name, name)).rgb,
    )


def _photo_path(visitor: Path, set_name: str, name: str) -> Path:
    if name in THREE_QUARTER:
        return visitor / "heldout" / (f"handheld_{name}.jpg" if set_name == "handheld" else f"{name}.jpg")
    return visitor / set_name / f"{name}.jpg"


def truth_camera(entry: Mapping[str, Any]) -> Camera:
    """Return the project's camera; both put the principal point in the picture's middle, within half a pixel."""
    width, height = int(entry["width"]), int(entry["height"])
    if max(abs(entry["cx"] - width / 2), abs(entry["cy"] - height / 2)) > HALF_PIXEL:
        raise ValueError("the truth's principal point is not the picture's middle")
    return Camera(width, height, float(entry["fx"]), np.array(entry["world_to_camera"], dtype=np.float64))


def vectors(named: Mapping[str, Any]) -> dict[str, Array]:
    """Return named lists of numbers as arrays."""
    return {name: np.array(value, dtype=np.float64) for name, value in named.items()}


def _read_surface(path: Path, base: Mapping[str, Any]) -> TruthSurface:
    try:
        with np.load(path) as data:
            points, normals = data["points"].astype(np.float64), data["normals"].astype(np.float64)
            part, names = data["part"], [str(name) for name in data["parts"]]
    except (OSError, ValueError, KeyError) as error:
        raise ClonerError("the truth's surface is missing or broken", "Copy the file again", path.name) from error
    kinds = np.array([_kind(name) for name in names])[part]
    labels = np.array([_label(name) for name in names])[part]
    kept = kinds != ""
    normals = unit(normals[kept])
    marks, joints = vectors(base["points_3d_m"]), vectors(base["joints_3d_m"])
    bare = _read_bare(path.with_name("truth_body.npz"))
    return TruthSurface(points[kept], normals, kinds[kept], joints, marks, *bare, labels[kept])


def _read_bare(path: Path) -> tuple[Array, NDArray[np.int32]]:
    """Return the naked mesh, or empty arrays: samples do not carry it."""
    if not path.is_file():
        return np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int32)
    with np.load(path) as data:
        vertices, quads = data["vertices"].astype(np.float64), data["faces"].astype(np.int32)
    return vertices, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def _kind(part: str) -> str:
    """Return "bare", "worn", "hair" or "" (left out) for a part's asset name."""
    if part.startswith(_STRIPS):
        return ""
    if part.startswith(_ORGANS):
        return "organ"
    if part == _BARE_PART:
        return "bare"
    # MakeHuman names clothes by "suit" and "shoes"; all that is neither is hair
    return "worn" if any(word in part for word in ("suit", "shoes", "cloth", "dress", "skirt")) else "hair"


def _label(part: str) -> str:
    """Return what a part's asset name says people call it."""
    if part.startswith("high-poly"):
        return "eyes"
    kind = _kind(part)
    if kind == "worn":
        return "shoes" if "shoes" in part else "clothes"
    return {"bare": "skin", "hair": "hair"}.get(kind, "")
