"""One clone in other people's programs: format x program x what was loaded, with pictures.

    PYTHONPATH=tests python benchmarks/readers.py RESULT [--out docs/pictures/readers.jpg]

Writes every format of a result's clone, opens each file with the programs that are installed and prints a table: what
each found, and "green" where that is all that the file has, of the person's height and upright. What is not green has
a sentence why not, or is RED. A program that is missing is named. Programs that are no part of this project:
CLONER_READERS_PYTHON names a Python with open3d, assimp-py, trimesh, pygltflib and usd-core, CLONER_BLENDER_PYTHON one
with bpy; Assimp, Godot 3 and view3dscene are Debian's (assimp-utils, godot3-server, view3dscene).
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Final

import cv2
import numpy as np
import pygltflib

from cloner.exporters.table import EXPORTERS
from cloner.generic.load import load_generic
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.picture import load_clone_at
from cloner.records.clones import Clone
from kit import readers
from kit.readers import Picture, person

PANEL: Final = (270, 411)
COLUMNS: Final = 8
#: Programs that draw: name, what opens a file, whether it is here, the files.
DRAWING: Final[tuple[tuple[str, Callable[[Path], Picture], bool, str], ...]] = (
    ("three.js", readers.three, readers.HAS_THREE,
     "clone.glb clone_small.glb clone_lods.glb clone_mixamo.glb clone_unity.glb clone_unreal.glb clone_flat.wrl"),
    ("three-vrm", readers.three, readers.HAS_THREE, "clone.vrm"),
    ("Blender", readers.blender, readers.HAS_BLENDER,
     "clone.glb clone_lods.glb clone_unity.glb clone_small.glb clone.usdz clone.obj clone.ply"),
    ("X_ITE", readers.x_ite, readers.HAS_X_ITE, "clone.wrl clone.x3d clone_hanim.wrl"),
    ("view3dscene", readers.view3dscene, readers.HAS_VIEW3DSCENE, "clone.wrl clone.x3d clone_flat.wrl clone.glb"),
    ("view3dscene, own H-Anim", readers.view3dscene_without_prototypes, readers.HAS_VIEW3DSCENE, "clone_hanim.wrl"),
)  # fmt: skip
GLTF: Final = "clone.glb clone_lods.glb clone_mixamo.glb clone_unity.glb clone_unreal.glb clone_vrm.glb"
#: Programs that only count.
COUNTING: Final[tuple[tuple[str, Callable[[Path], Mapping[str, Any]], Callable[[], bool], str], ...]] = (
    ("Assimp", readers.assimp, lambda: readers.HAS_ASSIMP, f"{GLTF} clone_small.glb clone.obj clone.ply"),
    *((name, lambda path, name=name: readers.foreign(name, path), lambda name=name: readers.has_foreign(name), files)
      for name, files in (
          ("assimp_py", f"{GLTF} clone.obj"),
          ("open3d", f"{GLTF} clone_small.glb clone.obj clone.ply"),
          ("trimesh", f"{GLTF} clone_small.glb clone.obj clone.ply"),
          ("pygltflib", f"{GLTF} clone_small.glb"),
          ("pxr", "clone.usdz"),
      )),
    ("Godot 3", readers.godot, lambda: readers.GODOT is not None,
     "clone.glb clone_mixamo.glb clone_unity.glb clone_unreal.glb"),
)  # fmt: skip
PACKED: Final = "its reader knows no packed numbers (KHR_mesh_quantization, EXT_meshopt_compression); give it clone.glb"
REASONS: Final[Mapping[tuple[str, str], str]] = {
    ("Assimp", "clone_small.glb"): PACKED,
    ("open3d", "clone_small.glb"): PACKED,
    ("trimesh", "clone_small.glb"): PACKED,
    ("Blender", "clone_small.glb"): PACKED,
    ("Blender", "clone.ply"): "PLY has no upward axis and Blender takes Z: turn it by 90 degrees",
    ("three-vrm", "clone.vrm"): "its humanoid lifts an arm here, so it is taller than at rest",
}
ASKED: Final = ("meshes", "joints", "clips", "targets", "height_m")
#: What a program calls the same.
SAME: Final = {"bones": "joints", "animations": "clips"}
#: Heights may differ so much from the resting clone's: walking people sink, programs sample vertices.
HEIGHT_SLACK: Final = 0.06


def main() -> None:
    """Print the table and write the picture."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("result", type=Path)
    parser.add_argument("--out", type=Path, default=Path("docs/pictures/readers.jpg"))
    asked = parser.parse_args()
    clone, panels, red = centre_joints(load_clone_at(asked.result)), [], 0
    _row("program", "file", *ASKED, "upright", "s", "verdict")
    _row(*["---"] * (len(ASKED) + 5))
    with tempfile.TemporaryDirectory() as scratch:
        for name in EXPORTERS:
            EXPORTERS.get(name)(clone, Path(scratch))
        same = Path(scratch) / "clone_vrm.glb"  # these programs tell kinds of files by their last letters
        same.write_bytes((Path(scratch) / "clone.vrm").read_bytes())
        for program, show, here, files in DRAWING:
            for file in files.split() if here else ():
                start = time.monotonic()
                picture, told = show(Path(scratch) / file)
                red += _tell(program, Path(scratch) / file, clone, dict(told), time.monotonic() - start, picture)
                panels.append(_panel(picture, f"{program.split(',')[0]}: {file}"))
            if not here:
                _row(program, "", *[""] * len(ASKED), "", "", "not installed")
        for program, count, is_here, files in COUNTING:
            here = is_here()
            for file in files.split() if here else ():
                start = time.monotonic()
                counted = dict(count(Path(scratch) / file))
                red += _tell(program, Path(scratch) / file, clone, counted, time.monotonic() - start, None)
            if not here:
                _row(program, "", *[""] * len(ASKED), "", "", "not installed")
    sys.stdout.write(f"\n{red} red rows\n")
    while panels and len(panels) % COLUMNS:
        panels.append(np.full_like(panels[0], 255))
    if panels:
        sheet = np.vstack([np.hstack(panels[row : row + COLUMNS]) for row in range(0, len(panels), COLUMNS)])
        cv2.imwrite(str(asked.out), sheet[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, 85])


def _tell(
    program: str, path: Path, clone: Clone, told: dict[str, Any], spent_s: float, picture: np.ndarray | None
) -> bool:
    """Print a row and return whether it is red."""
    told = {SAME.get(name, name): value for name, value in told.items()}
    if "shapes" in told:
        told["targets"] = max(told.pop("shapes") - 1, 0)  # Blender counts the rest too
    if "maximum_y" in told:
        told["height_m"] = told["maximum_y"] - told["minimum_y"]
    if "moves_mm" in told:
        told["height_m"] = told["high"] - told["low"]
        astray = [
            name
            for name, most_mm in told.pop("moves_mm").items()
            if name in clone.morph_names and abs(most_mm - _farthest_mm(clone, name)) > 0.5
        ]
        told |= {"error": f"{len(astray)} targets move otherwise, {astray[0]} first"} if astray else {}
    if program == "Assimp":  # its bones are those of all meshes, its nodes name ours; it counts no targets
        told = {name: value for name, value in told.items() if name in ("meshes", "clips", "height_m")}
    if path.suffix not in (".glb", ".vrm", ".usdz"):
        told = {name: value for name, value in told.items() if name not in ("meshes", "joints", "clips", "targets")}
    if program.startswith(("three", "Blender")):
        told.pop("meshes", None)  # drawn parts: two-sided ones count twice
    if program == "Blender" and path.suffix == ".usdz":
        told.pop("clips", None)  # its importer makes one of the skeleton and one of every face
    if program in ("trimesh", "pygltflib") and "lods" in path.name:
        told.pop("meshes", None)  # they count those of the other scenes too
    held = _held(path, clone)
    wrong = [f"{name} {told[name]:.4g} of {held[name]:.4g}" for name in ASKED if name in told and name in held
             and abs(told[name] - held[name]) > (HEIGHT_SLACK * held[name] if name == "height_m" else 0)]  # fmt: skip
    upright = _upright(picture) if picture is not None else None
    if upright is False and program != "three-vrm":
        wrong.append("not upright")
    if not told.keys() & {*ASKED, "changed_px", "warnings"}:
        wrong.append(str(told.get("error", "nothing was read")))
    elif told.get("error"):
        wrong.append(str(told["error"]))
    wrong += [f"{len(told['warnings'])} warnings"] if told.get("warnings") else []
    reason = REASONS.get((program, path.name))
    verdict = "green" if not wrong else reason or f"RED: {', '.join(wrong)[:120]}"
    values = [f"{told[name]:.4g}" if name in told else "" for name in ASKED]
    _row(program, path.name, *values, {True: "yes", False: "no", None: ""}[upright], f"{spent_s:.0f}", verdict)
    return verdict.startswith("RED")


def _held(path: Path, clone: Clone) -> dict[str, float]:
    """Return what a file has, told by its own numbers."""
    points = np.concatenate([clone.vertices_m, *(shell.vertices_m for shell in clone.shells)])
    held = {"height_m": float(np.ptp(points[:, 1]))}
    if path.suffix in (".glb", ".vrm"):
        gltf = pygltflib.GLTF2().load_binary(str(path))
        nodes = [gltf.nodes[row] for row in gltf.scenes[gltf.scene or 0].nodes]
        primitives = [part for node in nodes if node.mesh is not None for part in gltf.meshes[node.mesh].primitives]
        held |= {
            "meshes": len(primitives),
            "joints": max(len(skin.joints) for skin in gltf.skins),
            "clips": len(gltf.animations),
            "targets": max(len(part.targets or []) for part in primitives),
        }
    if path.suffix == ".usdz":
        held |= {"joints": len(load_generic().joint_names), "clips": len(own_motions(clone)[:1])}
    return held


def _farthest_mm(clone: Clone, name: str) -> float:
    """Return how far a face target moves the vertex that it moves farthest."""
    number = clone.morph_names.index(name)
    rows = slice(int(clone.morph_start[number]), int(clone.morph_start[number + 1]))
    return 1000.0 * float(np.linalg.norm(clone.morph_delta_m[rows], axis=1).max(initial=0.0))


def _upright(picture: np.ndarray) -> bool:
    seen = np.argwhere(person(picture))
    return len(seen) > 0 and bool(np.ptp(seen[:, 0]) > 1.3 * np.ptp(seen[:, 1]))


def _row(*cells: object) -> None:
    sys.stdout.write(f"| {' | '.join(map(str, cells))} |\n")
    sys.stdout.flush()


def _panel(picture: np.ndarray, title: str) -> np.ndarray:
    small = cv2.resize(picture, PANEL, interpolation=cv2.INTER_AREA)
    bar = np.full((24, PANEL[0], 3), 255, np.uint8)
    cv2.putText(bar, title, (6, 17), cv2.FONT_HERSHEY_SIMPLEX, 0.45, (20, 20, 20), 1, cv2.LINE_AA)
    return np.vstack([bar, small])


if __name__ == "__main__":
    main()
