"""Lossless storage of a clone: ``clone.npz`` beside the exported files."""

from __future__ import annotations

import io
import json
from dataclasses import asdict
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from cloner.errors import ClonerError
from cloner.exporters.shared.files import png_bytes, write_bytes
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.project.archives import BROKEN, open_archive
from cloner.project.person_table import OLDEST_YEARS, SEXES
from cloner.records.bodies import PosedView
from cloner.records.clones import NO_SHINE, Clone, TextureAtlas
from cloner.records.heads import NO_RIDES, Shell
from cloner.records.terms import LICENCES, LONGEST_TERM, Terms
from cloner.records.views import Camera

#: What a result's clone is called.
CLONE_FILE: Final = "clone.npz"
FORMAT: Final = "cloner-clone"
VERSION: Final = 1
_PLAIN: Final = ("vertices_m", "joints_m", "morph_index", "morph_delta_m", "morph_start", "triangle_regions")
_PICTURE: Final = "_png"
_SHELL: Final = ("vertices_m", "triangles", "uv", "skin_joints", "skin_weights")
LARGEST_STATURE_M: Final = 3.0
LARGEST_BYTES: Final = 250_000_000  # PNG of noise at the largest texture size, twice over
PICTURES_PX: Final = 8192 * 8192  # all pictures together: the largest texture, its coverage and as much of hair, twice
_AGAIN: Final = "Clone the person again with this version of Cloner"


def save_clone(clone: Clone, path: Path) -> None:
    """Write a clone, bit for bit, as one .npz; pictures inside are PNG.

    Raises
    ------
    ClonerError
        If the file cannot be written.
    """
    arrays: dict[str, NDArray[Any]] = {name: getattr(clone, name) for name in _PLAIN}
    arrays["atlas_rgb_png"] = _packed(clone.atlas.rgb)
    arrays["atlas_coverage_png"] = _packed(clone.atlas.coverage)
    if clone.atlas.shine.size:
        arrays["atlas_shine_png"] = _packed(clone.atlas.shine)
    for number, shell in enumerate(clone.shells):
        arrays |= {f"shell_{number}_{name}": getattr(shell, name) for name in _SHELL}
        arrays[f"shell_{number}_rgba_png"] = _packed(shell.rgba)
        if len(shell.rides):
            arrays[f"shell_{number}_rides"] = shell.rides
    arrays["features_m"] = np.array(list(clone.features_m.values()), dtype=np.float64).reshape(-1, 3)
    for view, posed in clone.views.items():
        arrays[f"view_{view}_rotations"] = posed.rotations
        arrays[f"view_{view}_camera_from_model"] = posed.camera.camera_from_model
    facts = {
        "format": FORMAT,
        "version": VERSION,
        "morph_names": list(clone.morph_names),
        "feature_names": list(clone.features_m),
        "shells": len(clone.shells),
        "shell_kinds": [shell.kind for shell in clone.shells],
        "views": {str(view): _camera_facts(posed.camera) for view, posed in clone.views.items()},
        "stature_m": clone.stature_m,
        "sole_m": clone.sole_m,
        "stamp": clone.stamp,
        "measures_mm": dict(clone.measures_mm),
        "consent": clone.consent,
        "terms": asdict(clone.terms),
        "sex": clone.sex,
        "age_years": clone.age_years,
    }
    arrays["facts_json"] = np.frombuffer(json.dumps(facts).encode(), dtype=np.uint8)
    stream = io.BytesIO()
    np.savez(stream, allow_pickle=False, **arrays)
    write_bytes(path, stream.getvalue())


def load_clone(path: Path) -> Clone:
    """Return the clone that :func:`save_clone` wrote.

    Raises
    ------
    ClonerError
        If the file is missing, is no clone, or was written by a newer version.
    """
    try:
        with open_archive(path, LARGEST_BYTES) as archive:
            arrays = {"triangle_regions": np.zeros(0, np.uint8), **{name: archive[name] for name in archive.files}}
        facts = json.loads(arrays["facts_json"].tobytes())
        _check_pictures(arrays)
        if facts.get("format") != FORMAT:
            raise ValueError("another program's")
        if facts["version"] > VERSION:
            raise ClonerError("The clone was written by a newer version", _AGAIN, path.name)
        clone = _clone(arrays, facts)
        _check_fits(clone)
        return clone
    except FileNotFoundError as error:
        raise ClonerError("The clone is not there", "Run: cloner clone", path.name) from error
    except BROKEN as error:
        raise ClonerError("The file is not a readable clone", _AGAIN, path.name) from error


def _clone(arrays: dict[str, NDArray[Any]], facts: dict[str, Any]) -> Clone:
    """Return the clone of a file's arrays and facts."""
    views = {}
    for key, camera in facts["views"].items():
        lens = Camera(camera_from_model=arrays[f"view_{key}_camera_from_model"], **camera)
        views[ViewId(key)] = PosedView(ViewId(key), lens, arrays[f"view_{key}_rotations"])
    shells = tuple(
        _shell(arrays, number, kind) for number, kind in enumerate(facts.get("shell_kinds", ["hair"] * facts["shells"]))
    )
    return Clone(
        **{name: arrays[name] for name in _PLAIN},
        morph_names=tuple(facts["morph_names"]),
        atlas=_atlas(arrays),
        shells=shells,
        features_m=dict(zip(facts["feature_names"], arrays["features_m"], strict=True)),
        views=views,
        stature_m=facts["stature_m"],
        sole_m=facts["sole_m"],
        measures_mm={str(name): float(value) for name, value in facts.get("measures_mm", {}).items()},
        consent=facts.get("consent") is True,
        terms=_terms(facts),
        sex=facts["sex"] if facts.get("sex") in SEXES else "",
        age_years=float(age) if 0.0 <= (age := facts.get("age_years", 0.0)) <= OLDEST_YEARS else 0.0,
        stamp="".join(one for one in str(facts.get("stamp", "")) if one.isalnum() or one in " .,=:-")[:400],
    )


def _terms(facts: dict[str, Any]) -> Terms:
    """Return the terms of a file's facts; older files have none."""
    terms = facts.get("terms", {"licence": LICENCES[0] if facts.get("consent") is True else ""})
    if not all(isinstance(value, str) and len(value) <= LONGEST_TERM for value in terms.values()):
        raise ValueError("its terms are no short texts")
    return Terms(**terms)


def _check_fits(clone: Clone) -> None:
    """Refuse clones whose numbers do not fit together or do not fit this generic human."""
    generic = load_generic()
    sound = (
        len(clone.vertices_m) == len(generic.vertices_m)
        and 0.0 < clone.stature_m < LARGEST_STATURE_M
        and 0.0 <= clone.sole_m < LARGEST_STATURE_M
        and _within(clone.morph_index, len(clone.vertices_m))
        and len(clone.morph_index) == len(clone.morph_delta_m) == clone.morph_start[-1]
        and bool((np.diff(clone.morph_start, prepend=0) >= 0).all())
        and all(
            _within(shell.triangles, len(shell.vertices_m))
            and _within(shell.skin_joints, len(clone.joints_m))
            and _within(shell.rides, len(clone.vertices_m))
            for shell in clone.shells
        )
    )
    if not sound:
        raise ValueError("its numbers do not fit together")


def _within(index: NDArray[np.integer], count: int) -> bool:
    return not index.size or (int(index.min()) >= 0 and int(index.max()) < count)


def _atlas(arrays: dict[str, NDArray[Any]]) -> TextureAtlas:
    """Return the atlas of the file's arrays; only statues have a shine of their own."""
    shine = _unpacked(arrays["atlas_shine_png"]) if "atlas_shine_png" in arrays else NO_SHINE
    return TextureAtlas(_unpacked(arrays["atlas_rgb_png"]), _unpacked(arrays["atlas_coverage_png"]), shine)


def _shell(arrays: dict[str, NDArray[Any]], number: int, kind: str) -> Shell:
    """Return one shell of the file's arrays; older files have none that rides on the face."""
    plain: dict[str, Any] = {name: arrays[f"shell_{number}_{name}"] for name in _SHELL}
    rides = arrays.get(f"shell_{number}_rides", NO_RIDES)
    return Shell(**plain, rgba=_unpacked(arrays[f"shell_{number}_rgba_png"]), kind=kind, rides=rides)


def _camera_facts(camera: Camera) -> dict[str, Any]:
    """Return a camera's numbers; JSON keeps every bit of a float."""
    return {
        "width_px": int(camera.width_px),
        "height_px": int(camera.height_px),
        "focal_px": float(camera.focal_px),
        "pixels_per_m": None if camera.pixels_per_m is None else float(camera.pixels_per_m),
    }


def _packed(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    return np.frombuffer(png_bytes(pixels), dtype=np.uint8)


def _check_pictures(arrays: dict[str, NDArray[Any]]) -> None:
    """Refuse pictures larger than any textures, all together, before one is decoded: a few bytes may promise much."""
    pixels = 0
    for name, data in arrays.items():
        if name.endswith(_PICTURE):
            with _opened_picture(data) as image:
                pixels += image.width * image.height
    if pixels > PICTURES_PX:
        raise ValueError("its pictures are larger than any textures")


def _opened_picture(data: NDArray[np.uint8]) -> Image.Image:
    return Image.open(io.BytesIO(data.tobytes()), formats=["PNG"])


def _unpacked(data: NDArray[np.uint8]) -> NDArray[np.uint8]:
    with _opened_picture(data) as image:
        return np.asarray(image)
