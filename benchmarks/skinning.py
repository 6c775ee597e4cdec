"""How fast a pose bends a clone's skin, beside the plain NumPy formula.

    python benchmarks/skinning.py [--rounds 100]

CPU milliseconds for all vertices of the generic human, in one thread, median of the rounds; both give the same numbers.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning

Array = NDArray[np.float64]


def plain(vertices_m: Array, transforms: Array, joints: NDArray[np.integer], weights: Array) -> Array:
    """Return the skinned vertices as the textbook writes them."""
    blended = np.einsum("vk,vkab->vab", weights, transforms[joints, :3, :])
    return np.einsum("vab,vb->va", blended[:, :, :3], vertices_m) + blended[:, :, 3]


def milliseconds(run: Callable[[], object], rounds: int) -> float:
    """Return the median CPU time of a call."""
    run()
    spent = []
    for _ in range(rounds):
        start = time.process_time_ns()
        run()
        spent.append(time.process_time_ns() - start)
    return float(np.median(spent)) / 1e6


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=100)
    asked = parser.parse_args()
    generic = load_generic()
    vertices, weights = generic.vertices_m.astype(np.float64), generic.skin_weights.astype(np.float64)
    joints, places = generic.skin_joints.astype(np.int32), generic.joints_m.astype(np.float64)
    turns = np.random.default_rng(0).normal(size=(len(places), 3)) * 0.2
    transforms = joint_transforms(places, generic.joint_parents, turns)
    same = np.abs(
        linear_blend_skinning(vertices, transforms, joints, weights) - plain(vertices, transforms, joints, weights)
    ).max()
    rows = {
        "joints' transforms": milliseconds(
            lambda: joint_transforms(places, generic.joint_parents, turns), asked.rounds
        ),
        "skin, plain NumPy": milliseconds(lambda: plain(vertices, transforms, joints, weights), asked.rounds),
        "skin, ours (sparse product)": milliseconds(
            lambda: linear_blend_skinning(vertices, transforms, joints, weights), asked.rounds
        ),
    }
    sys.stdout.write(f"| {len(vertices)} vertices, 4 influences | ms |\n| --- | --- |\n")
    sys.stdout.write("".join(f"| {name} | {value:.2f} |\n" for name, value in rows.items()))
    sys.stdout.write(f"\nlargest difference {same:.1e} m\n")


if __name__ == "__main__":
    main()
