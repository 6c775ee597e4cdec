"""What each step of finding face points gains: ``python benchmarks/face_points.py [--people 20] [--json FILE]``.

Front: the net's own point, the same after a closer look at eyes and lips, the calibrated rules, the snake with
completion. Side: the laid profile. On the sample visitors and on random painted people (turned by
up to 10 degrees, 0.6 to 2 m away, three lights, some with beard, glasses, hair over the ears, a dark wall). Errors are
mean distances from the truth in % of the inter-ocular distance; ears apart. Also: the worst point that is believed
(confidence over 1/2), and the CPU seconds beyond the nets.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "generic_models" / "build"))

from painted_faces import EXTRAS, make_sitter, photograph_face  # noqa: E402
from painted_people_pictures import BACKGROUNDS  # noqa: E402

from cloner.detectors.face.face_net import load_face_net  # noqa: E402
from cloner.detectors.face.face_points import propose_face_points  # noqa: E402
from cloner.detectors.nets import litert  # noqa: E402
from cloner.errors import ClonerError  # noqa: E402
from cloner.evaluate.truths.truth import SETS, read_truth  # noqa: E402
from cloner.frames import FACE_VIEWS, ViewId  # noqa: E402
from cloner.project.folder import load_photos  # noqa: E402
from cloner.records.photos import Photo  # noqa: E402
from cloner.records.points import ViewPoints, expected_face_error  # noqa: E402
from cloner.stages.proposals import propose  # noqa: E402

#: The net's own point for each name; pupils lie between the corners of their eyes.
NET_POINT = {
    "eye_inner_R": 133, "eye_outer_R": 33, "eye_upper_R": 159, "eye_lower_R": 145,
    "eye_inner_L": 362, "eye_outer_L": 263, "eye_upper_L": 386, "eye_lower_L": 374,
    "mouth_corner_R": 61, "mouth_corner_L": 291, "ala_R": 129, "ala_L": 358, "nose_tip": 1, "subnasale": 2,
    "nasion": 168, "glabella": 9, "lip_top": 0, "stomion": 13, "lip_bottom": 17, "chin_front": 199,
    "chin_bottom": 152,
}  # fmt: skip
FIRST_SEED = 300
#: Expected error at which the confidence is 1/2, % of the eye distance.
BELIEVED = 6.93
STEPS = {
    ViewId.FACE_FRONT: ("net raw", "closer look", "calibrated", "snake"),
    ViewId.FACE_SIDE: ("profile",),
}


@dataclass(frozen=True)
class Case:
    """One photo with its truth."""

    name: str
    photo: Photo
    marks_px: Mapping[str, np.ndarray]
    iod_px: float
    kind: str


def visitors() -> Iterator[Case]:
    for visitor in ("anna", "boris"):
        for set_name in SETS:
            folder = ROOT / "samples" / visitor
            truth, photos = read_truth(folder, set_name), load_photos(folder / set_name)
            found = photos[0] if isinstance(photos, tuple) else photos
            for view in FACE_VIEWS:
                seen = truth.views[view]
                left, right = seen.points_m["pupil_L"], seen.points_m["pupil_R"]
                iod = float(np.linalg.norm(left - right)) / seen.camera.metres_per_pixel((left + right) / 2)
                yield Case(f"{visitor} {set_name}", found.photos[view], seen.marks_px, iod, "visitor")


def painted(count: int) -> Iterator[Case]:
    for seed in range(FIRST_SEED, FIRST_SEED + count):
        extras = () if seed % 3 else (EXTRAS[seed // 3 % len(EXTRAS)],)
        sitter = make_sitter(seed, extras)
        for view in FACE_VIEWS:
            known = photograph_face(sitter, view, background=BACKGROUNDS[seed % 5 % 3])
            name = " ".join([f"painted {seed}", *extras, known.light])
            yield Case(name, known.photo, known.marks_px, known.iod_px, "painted")


def front_steps(photo: Photo) -> dict[str, ViewPoints] | None:
    """Return the named points after each step, or None where no face is found."""
    face = litert.detect_face(photo.rgb)
    if face is None:
        return None
    proposal = propose(photo)
    out = {}
    for step, mesh in (("net raw", face.first_px), ("closer look", face.points_px)):
        points = np.array([mesh[row] for row in NET_POINT.values()])
        count = len(points)
        out[step] = ViewPoints(photo.view, tuple(NET_POINT), points, np.ones(count), np.zeros(count, dtype=bool))
    out["calibrated"] = propose_face_points(photo, replace(proposal, face_px=face.points_px))
    out["snake"] = propose_face_points(photo, proposal)
    return out


def errors(points: ViewPoints, case: Case) -> dict[str, tuple[float, float]]:
    """Return error and expected error of each known point, % of the eye distance."""
    expected = 100.0 * expected_face_error(points.confidence)
    return {
        name: (100.0 * float(np.linalg.norm(place - case.marks_px[name])) / case.iod_px, float(error))
        for name, place, error in zip(points.names, points.points_px, expected, strict=True)
        if name in case.marks_px
    }


def measure(case: Case) -> dict[str, dict[str, tuple[float, float]]]:
    """Return the errors of a case by step; empty where nothing was found."""
    try:
        if case.photo.view is ViewId.FACE_FRONT:
            steps = front_steps(case.photo)
        else:
            steps = {"profile": propose_face_points(case.photo, propose(case.photo))}
    except ClonerError:
        return {}
    return {} if steps is None else {step: errors(points, case) for step, points in steps.items()}


def summary(found: dict[str, tuple[float, float]], ears: bool) -> float:
    values = [error for name, (error, _) in found.items() if name.startswith("ear") == ears]
    return float(np.mean(values)) if values else float("nan")


def print_table(rows: list[tuple[Case, dict[str, dict[str, tuple[float, float]]]]]) -> None:
    for view, steps in STEPS.items():
        chosen = [(case, found) for case, found in rows if case.photo.view is view]
        print(f"\n| {view} | " + " | ".join(steps) + " | ears | worst believed |\n|" + " --- |" * (len(steps) + 3))
        for kind in ("visitor", "painted"):
            mine = [(case, found) for case, found in chosen if case.kind == kind and found]
            for case, found in mine:
                last = found[steps[-1]]
                believed = max((e for e, expected in last.values() if expected < BELIEVED), default=float("nan"))
                cells = [summary(found[step], ears=False) for step in steps] + [summary(last, ears=True), believed]
                print(f"| {case.name} | " + " | ".join(f"{cell:.2f}" for cell in cells) + " |")
            if mine:
                middle = [float(np.median([summary(found[s], ears=False) for _, found in mine])) for s in steps]
                ears = float(np.nanmedian([summary(found[steps[-1]], ears=True) for _, found in mine]))
                print(f"| **median {kind}** | " + " | ".join(f"{cell:.2f}" for cell in [*middle, ears]) + " | |")
        common = [found for _, found in chosen if found]
        print("\n| point | " + " | ".join(steps) + " | expected |\n|" + " --- |" * (len(steps) + 2))
        for name in dict.fromkeys(n for found in common for n in found[steps[-1]]):
            cells = []
            for step in steps:
                values = [found[step][name][0] for found in common if name in found[step]]
                cells.append(f"{np.mean(np.minimum(values, 100.0)):.2f}" if values else "-")
            told = [found[steps[-1]][name][1] for found in common if name in found[steps[-1]]]
            print(f"| {name} | " + " | ".join(cells) + f" | {np.median(told):.1f} |")


def seconds_beyond_nets(case: Case) -> float:
    """Return CPU seconds of proposing named points when the nets have run."""
    proposal = propose(case.photo)
    start = time.process_time()
    propose_face_points(case.photo, proposal)
    return time.process_time() - start


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--people", type=int, default=20, help="random painted people")
    parser.add_argument("--json", type=Path, help="write all errors to a file")
    arguments = parser.parse_args()
    load_face_net()
    rows = [(case, measure(case)) for case in (*visitors(), *painted(arguments.people))]
    print_table(rows)
    lost = [case.name for case, found in rows if not found]
    print(f"\nnothing found in {len(lost)} of {len(rows)} photos: {', '.join(lost) or '-'}")
    spent = [seconds_beyond_nets(case) for case, _ in rows[:4]]
    print(f"CPU seconds beyond the nets: {np.mean(spent[::2]):.3f} front, {np.mean(spent[1::2]):.3f} side")
    if arguments.json:
        arguments.json.write_text(json.dumps([[case.name, str(case.photo.view), found] for case, found in rows]))


if __name__ == "__main__":
    main()
