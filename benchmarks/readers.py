"""One clone in other people's programs, side by side.

    python benchmarks/readers.py RESULT [--out docs/pictures/readers.jpg]

Writes every format of a result's clone into a folder of its own, opens each file with the programs that are installed
(three.js, three-vrm and X_ITE in Chromium; Blender; view3dscene) and prints what they say. A program that is missing is
named and left out.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Final

import cv2
import numpy as np

from cloner.exporters.table import EXPORTERS
from cloner.picture import clone_of
from kit import readers
from kit.readers import Picture

PANEL: Final = (270, 411)
COLUMNS: Final = 7
ROWS: Final[tuple[tuple[str, str, Callable[[Path], Picture], bool], ...]] = (
    ("three.js", "clone.glb", readers.three, readers.HAS_THREE),
    ("three.js", "clone_small.glb", readers.three, readers.HAS_THREE),
    ("three.js", "clone_mixamo.glb", readers.three, readers.HAS_THREE),
    ("three.js", "clone_unity.glb", readers.three, readers.HAS_THREE),
    ("three.js", "clone_unreal.glb", readers.three, readers.HAS_THREE),
    ("three-vrm", "clone.vrm", readers.three, readers.HAS_THREE),
    ("three.js", "clone_flat.wrl", readers.three, readers.HAS_THREE),
    ("X_ITE", "clone.wrl", readers.x_ite, readers.HAS_X_ITE),
    ("X_ITE", "clone.x3d", readers.x_ite, readers.HAS_X_ITE),
    ("view3dscene", "clone.wrl", readers.view3dscene, readers.HAS_VIEW3DSCENE),
    ("view3dscene", "clone_hanim.wrl", readers.view3dscene_without_prototypes, readers.HAS_VIEW3DSCENE),
    ("X_ITE", "clone_hanim.wrl", readers.x_ite, readers.HAS_X_ITE),
    ("view3dscene", "clone.x3d", readers.view3dscene, readers.HAS_VIEW3DSCENE),
    ("view3dscene", "clone.glb", readers.view3dscene, readers.HAS_VIEW3DSCENE),
    ("Blender", "clone.glb", readers.blender, readers.HAS_BLENDER),
    ("Blender", "clone_flat.wrl", readers.blender, readers.HAS_BLENDER),
    ("Blender", "clone.obj", readers.blender, readers.HAS_BLENDER),
)
PYTHON_READERS: Final = ("assimp_py", "open3d")
FORMATS: Final = ("glb", "small", "mixamo", "unity", "unreal", "vrm", "flat", "wrl", "hanim", "x3d", "obj")


def main() -> None:
    """Print a table and write the picture."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("result", type=Path)
    parser.add_argument("--out", type=Path, default=Path("docs/pictures/readers.jpg"))
    asked = parser.parse_args()
    clone, panels = clone_of(asked.result), []
    sys.stdout.write("| program | file | s | it says |\n" + "| --- " * 4 + "|\n")
    with tempfile.TemporaryDirectory() as scratch:
        for name in FORMATS:
            EXPORTERS.get(name)(clone, Path(scratch))
        for program, file, show, here in ROWS:
            if not here:
                sys.stdout.write(f"| {program} | {file} | | not installed |\n")
                continue
            start = time.monotonic()
            picture, told = show(Path(scratch) / file)
            said = ", ".join(f"{key} {_short(value)}" for key, value in told.items())
            sys.stdout.write(f"| {program} | {file} | {time.monotonic() - start:.0f} | {said} |\n")
            sys.stdout.flush()
            panels.append(_panel(picture, f"{program}: {file}"))
        for file in ("clone.glb", "clone_mixamo.glb", "clone_unity.glb", "clone_unreal.glb", "clone.vrm"):
            _count(Path(scratch) / file)
    while len(panels) % COLUMNS:
        panels.append(np.full_like(panels[0], 255))
    sheet = np.vstack([np.hstack(panels[row : row + COLUMNS]) for row in range(0, len(panels), COLUMNS)])
    cv2.imwrite(str(asked.out), sheet[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, 85])


def _count(path: Path) -> None:
    """Print what readers that draw nothing find in a file; both tell kinds of files by their last letters."""
    same = path if path.suffix == ".glb" else path.with_name(f"{path.stem}_vrm.glb")
    same.write_bytes(path.read_bytes())
    rows = [("Assimp", readers.assimp(same) if readers.HAS_ASSIMP else None)]
    rows += [(name, readers.foreign(name, same) if readers.has_foreign(name) else None) for name in PYTHON_READERS]
    for program, told in rows:
        said = "not installed" if told is None else ", ".join(f"{key} {_short(value)}" for key, value in told.items())
        sys.stdout.write(f"| {program} | {path.name} | | {said} |\n")


def _short(value: object) -> str:
    return f"{value:.3g}" if isinstance(value, float) else (str(value) or "none")[:120]


def _panel(picture: np.ndarray, title: str) -> np.ndarray:
    small = cv2.resize(picture, PANEL, interpolation=cv2.INTER_AREA)
    bar = np.full((24, PANEL[0], 3), 255, np.uint8)
    cv2.putText(bar, title, (6, 17), cv2.FONT_HERSHEY_SIMPLEX, 0.45, (20, 20, 20), 1, cv2.LINE_AA)
    return np.vstack([bar, small])


if __name__ == "__main__":
    main()
