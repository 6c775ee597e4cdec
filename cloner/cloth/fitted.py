"""Garments of MakeHuman's community (``.mhclo``), fitted to a clone: ``cloner dress --garment shirt.mhclo``.

Every vertex of such a garment lies beside three vertices of MakeHuman's base mesh, its offset scaled by three spans of
the body. The product's skin is that mesh; its helpers (where tights and skirts lie) stand beside the clone's skin. What
lies in the skin then is pushed out.

References
----------
MakeHuman community, MHCLO file format (``verts``, ``x_scale``, ``material`` lines), as its documentation says.
"""

from __future__ import annotations

import functools
import importlib.resources
import io
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from cloner.cloth.clothed import SHELL, check_folder, write_shell_as_result
from cloner.cloth.simulation.core.host import push_out_of_skin
from cloner.cloth.simulation.wearer import make_wearer, skin_interval
from cloner.errors import ClonerError
from cloner.exporters.shared.obj_files import read_obj
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import dense_weights, strongest_weights
from cloner.picture import load_clone_at
from cloner.pipeline import Progress, no_progress
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.heads import Shell
from cloner.records.meshes import Mesh
from cloner.untrusted import read_untrusted, read_untrusted_text

Ints = NDArray[np.int64]

ENDING: Final = ".mhclo"
#: Vertices of MakeHuman's base mesh that are skin, and all of them.
SKIN, ALL = 13_380, 19_158
#: Metres of a unit of its files.
UNIT_M: Final = 0.1
LARGEST_BYTES: Final = 20_000_000
#: Fitted cloth lies so far outside the skin, metres; what lies deeper than the second was not meant to be outside.
CLEAR_M, DEEP_M = 0.003, 0.03
PUSHES: Final = 8
#: Side of a garment's picture, texels.
PICTURE_PX: Final = 1024
#: Of a file, characters.
LONGEST_NAME: Final = 200
#: A larger picture is none of a garment.
MOST_PIXELS: Final = 8192 * 8192
_HINT: Final = "Give a .mhclo of MakeHuman's community, its .obj and .mhmat beside it"


@dataclass(frozen=True, slots=True, eq=False)
class MakeHumanGarment:
    """A garment as its files describe it.

    Attributes
    ----------
    rows : (N, 3) int64
        Vertices of the base mesh that each vertex lies beside.
    weights : (N, 3) float64
    beside_m : (N, 3) float64
        Offsets on the base mesh, metres.
    spans : mapping of axis number to (vertex, vertex, metres)
    mesh : Mesh
    rgba : (S, S, 4) uint8
    """

    rows: Ints
    weights: Array
    beside_m: Array
    spans: dict[int, tuple[int, int, float]]
    mesh: Mesh
    rgba: NDArray[np.uint8]


def fit_folder(
    clone_path: Path, garment: Path, out: Path, *, formats: Sequence[str], progress: Progress = no_progress
) -> tuple[str, ...]:
    """Write a clone in a garment of the user's own as a result; return a report.

    Parameters
    ----------
    clone_path : Path
    garment : Path
        A ``.mhclo`` file; its mesh and material lie beside it.
    out : Path
        The new result's folder.
    formats : sequence of str
        Names of exporters.
    progress : callable
        May raise Cancelled.

    Raises
    ------
    ClonerError
        If a file is none, or the folder cannot be written.
    """
    if out.suffix:
        raise ClonerError(
            "a fitted garment is written as a result's folder", "Give --out a name without ending", out.name
        )
    check_folder(out, clone_path, formats)
    progress("body", 0.0)
    clone, found = load_clone_at(clone_path), read_mhclo(garment)
    shell = fitted_shell(clone, found)
    worn = replace(clone, shells=(*(one for one in clone.shells if one.kind != SHELL), _merged_shells(clone, shell)))
    progress("export", 0.5)
    write_shell_as_result(worn, clone_path, out, {"garment": [garment.stem]}, formats)
    progress("done", 1.0)
    return (f"{len(found.rows)} vertices of {garment.stem} lie on the skin", str(out))


def read_mhclo(path: Path) -> MakeHumanGarment:
    """Return the garment in a ``.mhclo`` file, its mesh and its picture.

    Raises
    ------
    ClonerError
        If one of them is missing or broken.
    """
    data: dict[str, list[str]] = {}
    rows: list[list[str]] = []
    inside = False
    for line in read_untrusted_text(path, "the garment", _HINT, LARGEST_BYTES, errors="replace").splitlines():
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        if words[0][0].isalpha():
            inside = words[0] == "verts"
            data.setdefault(words[0], words[1:])
        elif inside:
            rows.append(words)
    try:
        if not all(len(row) in (1, 9) for row in rows) or not rows:
            raise ValueError("rows of another kind")
        numbers = np.array([row if len(row) == 9 else [*row * 3, "1", "0", "0", "0", "0", "0"] for row in rows], float)
        spans = {
            axis: (int(data[key][0]), int(data[key][1]), float(data[key][2]) * UNIT_M)
            for axis, key in enumerate(("x_scale", "y_scale", "z_scale"))
        }
        named = np.array([*numbers[:, :3].ravel(), *(end for one, other, _ in spans.values() for end in (one, other))])
        if not np.isfinite(numbers).all() or named.min() < 0 or named.max() >= ALL:
            raise ValueError("no vertex of the base mesh")
        indices = numbers[:, :3].astype(np.int64)
        mesh_file = path.with_name(data["obj_file"][0])
        if min(length for _, _, length in spans.values()) <= 0.0 or np.abs(numbers[:, 3:]).max() > 1e3:
            raise ValueError("out of all bounds")
    except (ValueError, LookupError) as error:
        raise ClonerError("the file is no garment of MakeHuman's", _HINT, path.name) from error
    mesh = read_obj(_beside(mesh_file, path))
    if len(mesh.vertices_m) != len(rows):
        told_both = f"the garment has {len(rows)} rows and its mesh {len(mesh.vertices_m)} vertices"
        raise ClonerError(told_both, _HINT, mesh_file.name)
    return MakeHumanGarment(indices, numbers[:, 3:6], numbers[:, 6:] * UNIT_M, spans, mesh, _picture(path, data))


def _beside(file: Path, path: Path) -> Path:
    """Return the path of a file in the garment's own folder; others are refused."""
    if file.parent != path.parent or len(file.name) > LONGEST_NAME or not file.is_file():
        raise ClonerError(f"{file.name[:60]!r} does not lie beside the garment", _HINT, path.name)
    return file


def _picture(path: Path, data: dict[str, list[str]]) -> NDArray[np.uint8]:
    """Return the garment's picture, plain grey if its material names none that exists."""
    material = path.with_name(Path(data["material"][0]).name) if data.get("material") else None
    if material is not None and material.is_file():
        for line in read_untrusted_text(material, "the material", _HINT, LARGEST_BYTES, errors="replace").splitlines():
            words = line.split()
            if len(words) == 2 and words[0] == "diffuseTexture":
                return _decoded(_beside(path.with_name(Path(words[1]).name), path))
    return np.full((16, 16, 4), (150, 150, 155, 255), np.uint8)


def _decoded(file: Path) -> NDArray[np.uint8]:
    try:
        with Image.open(io.BytesIO(read_untrusted(file, LARGEST_BYTES))) as picture:
            if picture.width * picture.height > MOST_PIXELS:
                raise ValueError("too many pixels")
            rgba = np.asarray(picture.convert("RGBA"))
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError) as error:
        raise ClonerError("the garment's picture cannot be read", "Give a PNG or JPEG", file.name) from error
    size = min(PICTURE_PX, max(rgba.shape[:2]))
    return np.asarray(cv2.resize(rgba, (size, size), interpolation=cv2.INTER_AREA), np.uint8)


@functools.cache
def _helpers() -> tuple[NDArray[np.int64], Array, Array]:
    place = importlib.resources.files("cloner_models") / "helpers.npz"
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        return archive["skin"].astype(np.int64), archive["weight"].astype(np.float64), archive["beside_m"].astype(float)


def base_mesh_m(clone: Clone) -> Array:
    """Return the positions (19158, 3) of MakeHuman's base mesh vertices on a clone at rest, metres."""
    near, weight, beside = _helpers()
    skin_m = clone.vertices_m[:SKIN]
    return np.concatenate([skin_m, np.einsum("nk,nka->na", weight, skin_m[near]) + beside])


def fitted_shell(clone: Clone, garment: MakeHumanGarment) -> Shell:
    """Return a garment on a clone at rest, outside the skin, with the weights of the skin that its rows name."""
    base = base_mesh_m(clone)
    scale = np.ones(3)
    for axis, (one, other, length) in garment.spans.items():
        scale[axis] = abs(float(base[one, axis] - base[other, axis])) / length
    places = np.einsum("nk,nka->na", garment.weights, base[garment.rows]) + garment.beside_m * scale
    body = make_wearer(clone, whole=True)
    now = skin_interval(body, clone.vertices_m[body.rows], clone.vertices_m[body.rows])
    mesh = garment.mesh
    ends = mesh.triangles[:, [[0, 1, 2], [0, 1, 1], [1, 2, 2], [2, 0, 0]]].reshape(-1, 3)  # middles, and those of sides
    for _ in range(PUSHES):
        places = push_out_of_skin(places, now, CLEAR_M, DEEP_M)
        middles = places[ends].mean(axis=1)
        out = push_out_of_skin(middles, now, CLEAR_M, DEEP_M)
        pushed = np.flatnonzero((out != middles).any(axis=1))
        corners = ends[pushed].ravel()
        count = np.maximum(np.bincount(corners, minlength=len(places)), 1)
        for axis in range(3):
            more = np.repeat((out - middles)[pushed, axis], 3)
            places[:, axis] += np.bincount(corners, more, len(places)) / count
    joints, weights = _skin_weights(garment)
    both = np.stack([mesh.triangles, mesh.uv_triangles], axis=2).reshape(-1, 2)
    wedges, corner = np.unique(both, axis=0, return_inverse=True)
    vertex, flat = wedges.T
    return Shell(
        places[vertex],
        corner.reshape(-1, 3).astype(np.int32),
        mesh.uv[flat],
        joints[vertex],
        weights[vertex],
        garment.rgba,
        SHELL,
    )


def _skin_weights(garment: MakeHumanGarment) -> tuple[NDArray[np.int32], Array]:
    """Return joints and weights (N, 4) of a garment's vertices: those of the skin that its rows name."""
    generic, (near, weight, _) = load_generic(), _helpers()
    given = np.maximum(generic.skin_weights[:SKIN], 0.0)
    skin = dense_weights(generic.skin_joints[:SKIN], given, len(generic.joint_parents))
    base = np.concatenate([skin, np.einsum("nk,nkj->nj", weight, skin[near])])
    return strongest_weights(np.einsum("nk,nkj->nj", np.maximum(garment.weights, 0.0), base[garment.rows]))


def _merged_shells(clone: Clone, shell: Shell) -> Shell:
    """Return a clone's cloth and one more garment as one shell, their pictures side by side."""
    worn = [one for one in clone.shells if one.kind == SHELL]
    if not worn:
        return shell
    first = worn[0]
    size = max(len(first.rgba), len(shell.rgba))
    left, right = (cv2.resize(one.rgba, (size, size), interpolation=cv2.INTER_AREA) for one in (first, shell))
    return Shell(
        np.concatenate([first.vertices_m, shell.vertices_m]),
        np.concatenate([first.triangles, shell.triangles + len(first.vertices_m)]),
        np.concatenate([first.uv * [0.5, 1.0], shell.uv * [0.5, 1.0] + [0.5, 0.0]]),
        np.concatenate([first.skin_joints, shell.skin_joints]),
        np.concatenate([first.skin_weights, shell.skin_weights]),
        np.concatenate([left, right], axis=1),
        SHELL,
    )
