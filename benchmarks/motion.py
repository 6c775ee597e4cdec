"""How well clones walk, and how well captures fit them.

    python benchmarks/motion.py [RESULT...] [--capture FILE...] [--people 5]

RESULT is a result's folder or its clone.npz; besides them random bodies of the generic family walk, the first of them
a child of 1.10 m. Captures are .bvh or .amc files (their .asf beside them); without any, those of ../shared/mocap.

Walk: how far the first frame lies from the last one (joints, mm), how far soles slide a step by the strict ruler
(`cloner.motion.moves.slide`: whatever is below 4 mm, however fast, at 60 Hz; mm, mean and worst), the
least bend of a knee (degrees; below zero it would bend forwards), speed. Captures: the same slides, and the
angle between the captured bone and ours (upper arm, forearm, thigh, shin, all frames).
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from cloner.animating import CAPTURES
from cloner.generic.load import load_generic
from cloner.motion.captures.anatomy import find_anatomy
from cloner.motion.captures.bvh import Capture
from cloner.motion.captures.retarget import captured_directions, retarget
from cloner.motion.limbs.body import SIDES, Body, body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.gait import walk
from cloner.motion.moves.slide import step_slides_m
from cloner.motion.moves.styles import REGULAR, STYLES, Style
from cloner.picture import load_clone_at
from cloner.records.motions import Motion

Array = NDArray[np.float64]

MOCAP = Path(__file__).resolve().parents[2] / "shared" / "mocap"
CHILD_M, STATURE_M = 1.10, (1.50, 1.95)


def random_bodies(count: int, seed: int = 0) -> list[tuple[str, Body]]:
    """Return bodies of random shape, the first of them a child's."""
    from kit.clones import toy_clone

    rng, found = np.random.default_rng(seed), []
    for number in range(count):
        stature = CHILD_M if number == 0 else float(rng.uniform(*STATURE_M))
        vertices, joints = load_generic().shape(rng.normal(size=20), stature)
        clone = replace(toy_clone(stature, hair=False), vertices_m=vertices, joints_m=joints)
        found.append((f"random {number}, {stature:.2f} m", body_of(centre_joints(clone))))
    return found


def knee_bends(body: Body, motion: Motion) -> Array:
    """Return (2, F) bends of the knees, degrees, below zero where a knee stands behind the line from hip to ankle."""
    places, world, found = body.places(motion), body.world(motion), []
    for side in SIDES:
        hip, knee, ankle = (places[:, body.joint(f"{side}_{name}")] for name in ("hip", "knee", "ankle"))
        upper, lower = knee - hip, ankle - knee
        cosine = np.einsum("fa,fa->f", upper, lower) / np.linalg.norm(upper, axis=1) / np.linalg.norm(lower, axis=1)
        ahead = world[:, body.joint(f"{side}_hip"), :, 2]  # where the front of the thigh looks
        sign = np.sign(np.einsum("fa,fa->f", knee - (hip + ankle) / 2.0, ahead))
        found.append(sign * np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))))
    return np.array(found)


def walk_row(name: str, body: Body, style: Style = REGULAR) -> str:
    """Return one row of the walk's table."""
    motion = walk(body, style)
    places = body.places(motion)
    gap = 1000.0 * np.abs(places[0] - places[-1]).max()
    slid = 1000.0 * step_slides_m(body, motion)
    mean, worst = slid.mean(), slid.max()
    bends = knee_bends(body, motion)
    return (
        f"| {name} | {gap:.3f} | {mean:.1f} | {worst:.1f} | {bends.min():.0f} | {bends.max():.0f} | "
        f"{motion.speed_m_s:.2f} |"
    )


def capture_row(name: str, capture: Capture, who: str, body: Body) -> str:
    """Return one row of the captures' table."""
    motion = retarget(capture, body, name="x")
    slid = 1000.0 * step_slides_m(body, motion)
    mean, worst = slid.mean(), slid.max()
    angle = _angles(capture, body, motion)
    return (
        f"| {name} | {who} | {len(capture.root) * capture.frame_s:.1f} | {mean:.1f} | {worst:.1f} | "
        f"{angle.mean():.1f} | {np.percentile(angle, 95):.1f} | {np.abs(knee_bends(body, motion)).max():.0f} |"
    )


def _angles(capture: Capture, body: Body, motion: Motion) -> Array:
    """Return the angles between captured and laid bones, degrees."""
    wanted = captured_directions(capture, find_anatomy(capture), motion.times_s)
    places, found = body.places(motion), []
    for (first, last), direction in wanted.items():
        own = places[:, body.joint(last)] - places[:, body.joint(first)]
        own /= np.linalg.norm(own, axis=1, keepdims=True)
        found.append(np.degrees(np.arccos(np.clip(np.einsum("fa,fa->f", own, direction), -1.0, 1.0))))
    return np.concatenate(found)


def tables(results: list[Path], captures: list[Path], people: int) -> str:
    """Return both tables as Markdown."""
    known = [(_who(path), body_of(centre_joints(load_clone_at(path)))) for path in results]
    bodies = [*known, *random_bodies(people)]
    lines = [
        _head("walk of", "closes, mm", "sliding, mm a step", "worst, mm", "knee least, °", "most, °", "m/s"),
    ]
    lines += [walk_row(name, body) for name, body in bodies]
    lines += [
        walk_row(f"{name}, {style.name}", body, style)
        for name, body in (known or bodies)[:2]
        for style in STYLES.values()
        if style is not REGULAR
    ]
    lines += [
        "",
        _head("capture", "on", "s", "sliding, mm", "worst, mm", "bones off, °", "p95, °", "knee most, °"),
    ]
    for path in captures:
        capture = CAPTURES[path.suffix.lower()](path)
        lines += [capture_row(path.name, capture, name, body) for name, body in (known or bodies)[:2]]
    return "\n".join(lines) + "\n"


def _head(*columns: str) -> str:
    return f"| {' | '.join(columns)} |\n{'| --- ' * len(columns)}|"


def _who(path: Path) -> str:
    folder = path if path.is_dir() else path.parent
    return f"{folder.parent.name} {folder.name}"


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", nargs="*", type=Path)
    parser.add_argument("--capture", nargs="+", type=Path, default=sorted(MOCAP.glob("*.bvh")))
    parser.add_argument("--people", type=int, default=5)
    asked = parser.parse_args()
    sys.stdout.write(tables(asked.results, asked.capture, asked.people))


if __name__ == "__main__":
    main()
