"""What a calibrated number is worth: each one made larger and smaller by a factor, and how far a known clone moves.

    python benchmarks/calibrated_numbers.py vision.band stages.fine.smooth [--factor 1.3] [--photos samples/anna/plain]

Names are tables of ``cloner/calibration`` or single entries of them. Every value is tried in a process of its own, from
the points on (with ``--from proposals`` the nets are asked again, for numbers of ``detectors`` and ``labels``), up to
the joined person. A row: the outline's error against the true masks, the nearer of the body's and the face's surface to
the true ones, landmarks, and how far the skin moved from that of today's numbers.
"""

from __future__ import annotations

import argparse
import json
import pickle
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

from cloner.calibration import loader

LAST: Final = "join"
COLUMNS: Final = ("outline px", "overlap", "body mm", "face mm", "landmarks mm", "moved mm", "moved p95")


def changed(name: str, factor: float) -> None:
    """Let all modules that are imported from now on read one entry larger by a factor."""
    table, _, entry = name.rpartition(".")
    read = loader.calibrated

    def calibrated(module: str) -> loader.Calibrated:
        found = read(module)
        if module != table:
            return found
        old = found.entries[entry]
        return replace(found, entries={**found.entries, entry: replace(old, value=scaled(old.value, factor))})

    loader.calibrated = calibrated


def scaled(value: loader.Value, factor: float) -> loader.Value:
    """Return a number, or each of several, times a factor."""
    if isinstance(value, Mapping):
        return {name: factor * one for name, one in value.items()}
    return tuple(factor * one for one in value) if isinstance(value, tuple) else factor * value


def tried(photos: Path, start: Path | None) -> dict[str, Any]:
    """Clone up to the joined person; return its skin and figures, and write what is known after the proposals."""
    from cloner.testing import folder_values, run_stages, up_to

    names = up_to(LAST)
    if start is not None and start.is_file():
        values = pickle.loads(start.read_bytes())
    else:
        values, _ = run_stages(folder_values(photos), names[:1])
        if start is not None:
            start.write_bytes(pickle.dumps(values))
    values, _ = run_stages(values, names[1:])
    return figures(values, photos)


def figures(values: Mapping[str, Any], photos: Path) -> dict[str, Any]:
    """Return the figures of a joined person."""
    import numpy as np

    from cloner.evaluate.figures import likeness, skins
    from cloner.evaluate.measures import posing, rulers
    from cloner.evaluate.truths.truth import read_truth
    from cloner.frames import ViewId, mm_from_m
    from cloner.generic.load import load_generic
    from cloner.testing import untextured

    truth, generic = read_truth(photos.parent, photos.name), load_generic()
    clone = untextured(values["joined"])
    outlines = {view: one.mask for view, one in values["silhouettes"].views.items()}
    away = [
        rulers.summarise(rulers.outline_distances_px(mask, truth.views[view].mask)).mean
        for view, mask in outlines.items()
    ]
    seen = [
        likeness.seen_as_photo(clone, clone, generic, view, truth.views[view].mask)
        for view in (ViewId.BODY_FRONT, ViewId.BODY_SIDE, ViewId.BODY_BACK)
    ]
    surface = truth.surface
    start = clone.views[ViewId.BODY_FRONT].rotations
    posed, _, _ = posing.pose_like_truth(clone, generic, surface.joints_m, surface.marks_m, start)
    body = skins.body_surface_mm(posed, generic, surface, rng=np.random.default_rng(0)).mean
    face = skins.face_surface_mm(posed, generic, surface, rng=np.random.default_rng(0)).similarity.mean
    found, marks = posing.landmarks(posed.features_m), posing.landmarks(surface.marks_m)
    both = sorted(set(found) & set(marks))
    off = rulers.landmark_distances(np.array([found[n] for n in both]), np.array([marks[n] for n in both]))
    return {
        "row": [float(np.mean(away)), float(np.mean(seen)), body, face, mm_from_m(float(off.mean()))],
        "skin": clone.vertices_m[generic.part("body")].astype(np.float32),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="+")
    parser.add_argument("--factor", type=float, default=1.3)
    parser.add_argument("--photos", type=Path, default=Path("samples/anna/plain"))
    parser.add_argument("--from", dest="first", choices=("points", "proposals"), default="points")
    parser.add_argument("--folder", type=Path, help="keeps what is found, so that a kill loses nothing")
    parser.add_argument("--one", nargs=2, help=argparse.SUPPRESS)
    chosen = parser.parse_args()
    folder = chosen.folder or Path(tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    start = folder / "proposals.pickle" if chosen.first == "points" else None
    if chosen.one:
        name, factor = chosen.one
        if name:
            changed(name, float(factor))
        (folder / f"{name or 'today'}_{factor}.pickle").write_bytes(pickle.dumps(tried(chosen.photos, start)))
        return
    today = found(folder, "", 1.0, sys.argv[1:])
    print(f"| number | value | {' | '.join(COLUMNS)} |\n|{' --- |' * (len(COLUMNS) + 2)}")
    print(row("today", "", today, today))
    for name in entries(chosen.names):
        table, _, entry = name.rpartition(".")
        value = loader.calibrated(table).entries[entry].value
        for factor in (chosen.factor, 1.0 / chosen.factor):
            print(row(name, str(scaled(value, factor)), found(folder, name, factor, sys.argv[1:]), today), flush=True)


def entries(names: list[str]) -> list[str]:
    """Return the full names of all entries that are meant."""
    listed = []
    for name in names:
        room, table, entry = (name.split(".") + [""])[:3]
        known = loader.calibrated(f"{room}.{table}").entries
        listed += [f"{room}.{table}.{one}" for one in ([entry] if entry else known)]
    return listed


def found(folder: Path, name: str, factor: float, words: list[str]) -> dict[str, Any]:
    """Return what a process of its own finds with one number changed; what was found before is read."""
    place = folder / f"{name or 'today'}_{factor}.pickle"
    if not place.is_file():
        told = [*words, "--folder", str(folder), "--one", name, str(factor)]
        done = subprocess.run([sys.executable, __file__, *told], capture_output=True, text=True, check=False)
        if done.returncode:
            return {"row": [], "error": done.stderr.strip().splitlines()[-1]}
    return dict(pickle.loads(place.read_bytes()))


def row(name: str, value: str, one: Mapping[str, Any], today: Mapping[str, Any]) -> str:
    import numpy as np

    if not one["row"]:
        return f"| {name} | {value} | {json.dumps(one['error'])} |"
    moved = 1e3 * np.linalg.norm(one["skin"] - today["skin"], axis=1)
    cells = [f"{figure:.4f}" if k == 1 else f"{figure:.3f}" for k, figure in enumerate(one["row"])]
    cells += [f"{moved.mean():.3f}", f"{np.percentile(moved, 95):.3f}"]
    return f"| {name} | {value} | {' | '.join(cells)} |"


if __name__ == "__main__":
    main()
