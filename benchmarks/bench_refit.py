"""What one drag costs, and what it moves: 30 drags of body points on the values of one whole run.

Every drag moves one proposed outline point by 10 or 30 px outward or inward, or a joint or face point by 10 px, each on
the unmoved values. Printed: CPU and wall milliseconds of ``refit_body`` (median and worst), how
far the clone's outline, joint or face is from the point (worst), the largest motion of skin out of the bend's reach,
and with --whole whether a whole run with the last drag's correction gives the same body.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from cloner.frames import ViewId
from cloner.interactive.refitting import RefittedBody, refit_body
from cloner.project.corrections import move_point, no_corrections
from cloner.records.points import Corrections
from cloner.stages.silhouettes import ON_OUTLINE
from cloner.testing import folder_values, run_stages, up_to

SAMPLE = Path(__file__).resolve().parents[1] / "samples" / "anna" / "plain"
#: The stages up to the obeyed body; measures, hair and textures are none of a drag's business.
LAST_STAGE = "obeyed"
#: Farthest that a bend reaches for these drags, along the line of sight, mm.
REACH_MM = 250.0
DRAGS = 30
OUTLINE = ("waist", "knee_outer", "knee_inner", "shoulder_end", "chest_front", "hip_", "belly_front", "elbow_outer")
JOINTS = ("l_knee", "r_elbow", "l_ankle", "r_hip")
FACE = ("eye_outer_L", "mouth_corner_R", "nose_tip", "chin_front")


class Drag(NamedTuple):
    """One moved point and what came of it."""

    view: str
    name: str
    kind: str
    by_px: float
    cpu_ms: float
    wall_ms: float
    before_px: float
    after_px: float
    beyond_mm: float
    note: str


def whole_run(folder: Path, corrections: Corrections) -> dict[str, Any]:
    """Return all values up to the obeyed body."""
    return run_stages(folder_values(folder, corrections), up_to(LAST_STAGE))[0]


def places(values: Mapping[str, Any]) -> list[tuple[ViewId, str, float]]:
    """Return view, name and signed length of 30 drags, the same for the same person."""
    every = [
        (view, name, by_px)
        for kind in ("body_points", "face_points")
        for view, points in values[kind].views.items()
        for name in points.names
        if view.is_body == (kind == "body_points")
        for by_px in (
            (-30.0, -10.0, 10.0, 30.0) if name.startswith(OUTLINE) else (10.0,) if name in JOINTS + FACE else ()
        )
    ]
    order = np.random.default_rng(1).permutation(len(every))
    return [every[row] for row in order[:DRAGS]]


def moved(values: Mapping[str, Any], view: ViewId, name: str, by_px: float) -> Corrections:
    """Return corrections with one point moved off the photo's outline, joints to the side."""
    start = values["body_points" if view.is_body else "face_points"].views[view].get(name)
    way = np.array([1.0, 0.0])
    if view.is_body and name.startswith(ON_OUTLINE):
        line = np.concatenate(values["silhouettes"].views[view].contours_px)
        at = int(np.argmin(np.linalg.norm(line - start, axis=1)))
        along = line[(at + 6) % len(line)] - line[at - 6]
        way = np.array([along[1], -along[0]]) / np.linalg.norm(along)
        start, mask = line[at], values["silhouettes"].views[view].mask
        probe = np.round(start + 4.0 * way).astype(int)
        way = -way if mask[probe[1], probe[0]] else way
    place = start + by_px * way
    return move_point(no_corrections(), view, name, float(place[0]), float(place[1]), "")


def beyond_mm(before: Any, after: RefittedBody) -> float:
    """Return the largest motion of skin out of the bend's reach, mm."""
    shift = 1000.0 * np.linalg.norm(after.person.vertices_m - before.vertices_m, axis=1)
    centre = before.vertices_m[np.argmax(shift)]
    away = 1000.0 * np.linalg.norm(before.vertices_m - centre, axis=1)
    return float(shift[away > REACH_MM].max())


def dragged(values: Mapping[str, Any], view: ViewId, name: str, by_px: float) -> Drag:
    """Return what one drag costs and does."""
    corrections = moved(values, view, name, by_px)
    wall, cpu = time.perf_counter(), time.process_time()
    found = refit_body(values, corrections)
    wall_ms, cpu_ms = 1000.0 * (time.perf_counter() - wall), 1000.0 * (time.process_time() - cpu)
    (told,) = found.obeyed
    away = beyond_mm(values["joined"], found)
    return Drag(view.value, name, told.kind, by_px, cpu_ms, wall_ms, told.before_px, told.after_px, away, told.note)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("photos", nargs="?", type=Path, default=SAMPLE)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--whole", action="store_true", help="also compare with a whole run with the last correction")
    chosen = parser.parse_args()
    values = whole_run(chosen.photos, no_corrections())
    drags = [dragged(values, *place) for place in places(values)]
    told: dict[str, Any] = {"first_cpu_ms": drags[0].cpu_ms, "drags": [drag._asdict() for drag in drags]}
    if chosen.whole:
        corrections = moved(values, *places(values)[-1])
        again = whole_run(chosen.photos, corrections)["obeyed"].vertices_m
        told["whole_mm"] = float(1000.0 * np.abs(again - refit_body(values, corrections).person.vertices_m).max())
    print(json.dumps(told, indent=1) if chosen.json else table(drags, told))


def table(drags: list[Drag], told: Mapping[str, Any]) -> str:
    """Return the figures as lines of text."""
    warm = drags[1:]
    cpu, wall = ([getattr(drag, name) for drag in warm] for name in ("cpu_ms", "wall_ms"))
    lines = [
        f"refit of one drag ({len(drags)} drags; the first measures the skin: {told['first_cpu_ms']:.0f} CPU ms)",
        f"  CPU ms   median {np.median(cpu):.0f}  worst {max(cpu):.0f}",
        f"  wall ms  median {np.median(wall):.0f}  worst {max(wall):.0f}",
    ]
    for kind in ("outline", "pose", "face"):
        own = [drag for drag in warm if drag.kind == kind]
        if own:
            after = max(drag.after_px for drag in own)
            before, cost = max(drag.before_px for drag in own), [drag.cpu_ms for drag in own]
            lines.append(
                f"  {kind}: {len(own)} points, worst {after:.2f} px off (before {before:.1f}), "
                f"CPU ms median {np.median(cost):.0f}, worst {max(cost):.0f}"
            )
    lines.append(
        f"  skin farther than {REACH_MM:.0f} mm moved by at most {max(drag.beyond_mm for drag in drags):.2f} mm"
    )
    lines += [f"  {drag.view} {drag.name} {drag.by_px:+.0f} px: {drag.note}" for drag in drags if drag.note]
    if "whole_mm" in told:
        lines.append(f"  a whole run with the last correction differs by {told['whole_mm']:.3f} mm at most")
    return "\n".join(lines)


if __name__ == "__main__":
    main()
