"""A skirt on a walking body: writes ``docs/cloth_benchmark.md`` and pictures. ``--cycles``, ``--fabric`` for others."""

# ruff: noqa: E501 (lines of the page)

from __future__ import annotations

import argparse
import time
from pathlib import Path

import numpy as np
from PIL import Image
from scipy.spatial import cKDTree

from cloner.bodies.made import clone_of_measures
from cloner.bodies.telling import BodySpecification
from cloner.cloth.drafting.blocks import BLOCKS, draft_block
from cloner.cloth.dressing import CYCLES, GARMENTS, STEP_M, DressedClone, find_pattern, pictures
from cloner.cloth.simulation.fabrics import FABRICS
from cloner.cloth.simulation.loop import REPEATS, Loop, find_loop
from cloner.cloth.simulation.moving import BLEND, SETTLE, WornGarment, place_garment, simulate
from cloner.cloth.simulation.placing import body_ring
from cloner.cloth.simulation.solver import strains
from cloner.evaluate.measures.crossings import self_intersections
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.records.clones import Clone

DOCS = Path(__file__).resolve().parents[1] / "docs"
Array = np.ndarray
#: Places on a triangle that stand for it: a skin of 2 cm triangles is sampled every few millimetres.
SAMPLES = np.array([(i, j, 6 - i - j) for i in range(7) for j in range(7 - i)]) / 6.0
#: Cycles of the table of all garments.
FEW = 4


def depths_m(worn: WornGarment, frame: int, points: Array) -> Array:
    """Return how deep points lie inside the skin of a frame, by its nearest sample: no part of the solver's own contact."""
    skin = worn.body.posed(worn.root_m[frame], worn.rotations[frame])
    corner = skin[worn.body.triangles]
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
    places = np.einsum("sk,tka->tsa", SAMPLES, corner)
    _, near = cKDTree(places.reshape(-1, 3)).query(points)
    row = near // len(SAMPLES)
    return -np.einsum("ij,ij->i", points - places.reshape(-1, 3)[near], normal[row])


def measured(worn: WornGarment, frames: dict[int, Array]) -> tuple[int, int, float, float]:
    """Return vertices inside, triangles' middles inside, of all frames, the share of middles, and the deepest, mm."""
    inside = centres = 0
    deepest, total = 0.0, 0
    for number, places in frames.items():
        all_points = np.concatenate([places, places[worn.cloth.faces].mean(axis=1)])
        deep, middle = np.split(depths_m(worn, number % len(worn.rotations), all_points), [len(places)])
        inside += int((deep > 0.0).sum())
        centres += int((middle > 0.0).sum())
        total += len(middle)
        deepest = max(deepest, float(deep.max()), float(middle.max()))
    return inside, centres, centres / total, 1e3 * deepest


def jolt(loop: Loop) -> tuple[float, float]:
    """Return the largest acceleration at the loop's seam and of the median frame, mm a frame squared."""
    frames = np.roll(loop.frames_m, -loop.seam, axis=0)
    around = np.concatenate([frames[-1:], frames, frames[:1]])
    most = np.linalg.norm(around[2:] - 2.0 * around[1:-1] + around[:-2], axis=2).max(axis=1) * 1e3
    return float(max(most[0], most[-1])), float(np.median(most))


def crossed_triangles(places: Array, worn: WornGarment) -> int:
    """Return how many triangles of the cloth cut others."""
    return len(np.unique(self_intersections(places, worn.cloth.faces).pairs))


def refused(places: Array, worn: WornGarment) -> bool:
    """Return whether ipctk finds a self-crossing (pip install ipctk)."""
    import ipctk

    mesh = ipctk.CollisionMesh(places, worn.sheet.edges.astype(np.int32), worn.cloth.faces.astype(np.int32))
    return bool(ipctk.has_intersections(mesh, places))


def simulated(worn: WornGarment, cycles: int) -> tuple[list[Array], float]:
    """Return the walk's frames (N, 3), and CPU seconds a frame."""
    begun = time.process_time()
    places = [state.places_m for number, state in simulate(worn, cycles) if number >= 0]
    return places, (time.process_time() - begun) / (len(places) + SETTLE + BLEND)


def strain_of(worn: WornGarment, frames: Array) -> list[float]:
    """Return the 99th percentile of strain in each frame."""
    return [float(np.quantile(strains(worn.sheet, frame), 0.99)) for frame in frames]


def every_garment(clone: Clone) -> list[str]:
    """Return the table of all garments' closed loops."""
    lines = [
        "## Every garment", "",
        f"The same body and walk, cotton, the default triangles, {FEW} cycles. A triangle counts as crossed where it cuts another one without a common corner.", "",
        "| garment | vertices | CPU s a frame | crossed triangles when sewn, in the loop's median and worst frame | frames that ipctk refuses | strain, 99th percentile, median frame | middles of triangles inside | RMS of the gap, of the median cut, mm | seam's acceleration, of the median frame's |",
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |",
    ]  # fmt: skip
    motion = own_motions(clone)[0]
    for garment in GARMENTS:
        pattern, level = find_pattern(clone, garment, None)
        worn = place_garment(
            clone, pattern, body_ring(clone, level) if level else None, FABRICS["cotton"], motion, STEP_M
        )
        places, spent = simulated(worn, FEW)
        loop = find_loop(worn, np.array(places))
        sewn = crossed_triangles(worn.start.places_m, worn)
        crossed = [crossed_triangles(frame, worn) for frame in loop.frames_m]
        strain = np.median(strain_of(worn, loop.frames_m))
        seam, usual = jolt(loop)
        lines.append(
            f"| {garment} | {worn.cloth.count} | {spent:.3f} | {sewn}; {np.median(crossed):.0f}, {max(crossed)} of {len(worn.cloth.faces)} | {sum(refused(frame, worn) for frame in loop.frames_m)} of {len(crossed)} | {100 * strain:.1f} % | {100 * measured(worn, dict(enumerate(loop.frames_m)))[2]:.2f} % | {loop.gap_mm:.1f}, {loop.median_mm:.1f} | {seam / usual:.2f} |"
        )
        print(lines[-1], flush=True)
    return [*lines, ""]


def integrators(clone: Clone) -> list[str]:
    """Return the table of both integrators on the same skirt and walk."""
    lines = [
        "## Two integrators", "",
        f"The page's skirt and walk, {FEW} cycles; `--integrator elements` is the source's (first-order elements, implicit Euler). Both meet skin and themselves by the same rules.", "",
        "| | CPU s a frame | strain, 99th percentile, median frame, worst | loop's RMS of the gap, median cut | seam's acceleration, of the median frame's | loop's crossed triangles, frames that ipctk refuses | middles of triangles inside |",
        "| --- | --- | --- | --- | --- | --- | --- |",
    ]  # fmt: skip
    ring = body_ring(clone, "natural_waist")
    for name, elements in (("threads", False), ("elements", True)):
        pattern = draft_block(BLOCKS["skirt"], ring.girth_m, 0.6)
        worn = place_garment(clone, pattern, ring, FABRICS["cotton"], own_motions(clone)[0], STEP_M, elements=elements)
        places, spent = simulated(worn, FEW)
        loop, strain = find_loop(worn, np.array(places)), strain_of(worn, places[30:])
        seam, usual = jolt(loop)
        crossed = max(crossed_triangles(frame, worn) for frame in loop.frames_m)
        lines.append(
            f"| {name} | {spent:.3f} | {100 * np.median(strain):.1f} %, {100 * max(strain):.1f} % | {loop.gap_mm:.1f}, {loop.median_mm:.1f} mm | {seam / usual:.2f} | {crossed}, {sum(refused(frame, worn) for frame in loop.frames_m)} | {100 * measured(worn, dict(enumerate(loop.frames_m)))[2]:.2f} % |"
        )
        print(lines[-1], flush=True)
    lines += [
        "",
        "Against theory (`tests/unit/cloth/test_elements.py`): a strip hanging by its own weight grows .4 % more than Green's strain says; a cantilever of 12 cm sinks 1 to 3 % more than the elastica; a cylinder holds the energy of its curvature within 3 % along warp and weft; a bending loop is 12 % wider than 2HB; energy never grows without motion.", "",
    ]  # fmt: skip
    return lines


def long_runs(clone: Clone) -> list[str]:
    """Return the table of twenty cycles, and of ten thousand vertices, every frame looked at."""
    lines = [
        "## Long, and fine", "",
        "| what | vertices | frames | CPU s a frame | vertices inside | middles of triangles inside | deepest | farthest below its first height |", "| --- | --- | --- | --- | --- | --- | --- | --- |",
    ]  # fmt: skip
    for what, garment, step, cycles in (("skirt, 20 cycles", "skirt", STEP_M, 20), ("tee, 20 cycles, held by friction alone", "tee", STEP_M, 20), ("skirt of 10,000", "skirt", 0.0109, 3)):  # fmt: skip
        pattern, level = find_pattern(clone, garment, None)
        worn = place_garment(clone, pattern, body_ring(clone, level) if level else None, FABRICS["cotton"], own_motions(clone)[0], step)  # fmt: skip
        places, spent = simulated(worn, cycles)
        inside, centres, share, deepest = measured(worn, dict(enumerate(places)))
        top = [
            float(np.sort(frame[:, 1])[-20:].mean() - worn.root_m[k % len(worn.root_m), 1])
            for k, frame in enumerate(places)
        ]
        lines.append(
            f"| {what} | {worn.cloth.count} | {len(places)} | {spent:.3f} | {inside} | {centres} ({100 * share:.3f} %) | {deepest:.1f} mm | {1e3 * (top[0] - min(top)):.0f} mm |"
        )
        print(lines[-1], flush=True)
    return [*lines, ""]


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--cycles", type=int, default=CYCLES)
    parser.add_argument("--fabric", default="cotton")
    asked = parser.parse_args()
    clone = centre_joints(
        clone_of_measures(
            BodySpecification("f", 1.68, {"bust_girth": 920.0, "waist_girth": 740.0, "hip_girth": 990.0}), 512
        )
    )
    motion, ring = own_motions(clone)[0], body_ring(clone, "natural_waist")
    fabric = FABRICS[asked.fabric]
    begun = time.process_time()
    worn = place_garment(clone, draft_block(BLOCKS["skirt"], ring.girth_m, 0.6), ring, fabric, motion, STEP_M)
    put = time.process_time() - begun
    places, spent = simulated(worn, asked.cycles)
    stretched = strain_of(worn, places)
    begun = time.process_time()
    loop = find_loop(worn, np.array(places))
    closing = time.process_time() - begun
    raw = measured(worn, {k: places[k] for k in range(60, len(places), 7)})
    closed = measured(worn, dict(enumerate(loop.frames_m)))
    seam, usual = jolt(loop)
    crossed = [crossed_triangles(frame, worn) for frame in loop.frames_m]
    loop_strain = np.median(strain_of(worn, loop.frames_m))
    lines = [
        "# Cloth, measured", "", "`python benchmarks/cloth.py` writes this page: half-circle skirt, 60 cm, on a body from measures (168 cm, 92-74-99), walking.", "",
        "| what | figure | wanted |", "| --- | --- | --- |",
        f"| vertices, fabric, cycles simulated, and under feedback | {worn.cloth.count}, {asked.fabric}, {asked.cycles}, {REPEATS} | |",
        f"| put on (cut, sewn, placed) | {put:.2f} CPU s | |",
        f"| simulated, a frame, body's skin included | {spent:.3f} CPU s | .15 |",
        f"| loop found and closed | {closing:.1f} CPU s | |",
        f"| 99th percentile of strain, median frame / worst frame / in the loop | {100 * np.median(stretched[30:]):.1f} / {100 * max(stretched[30:]):.1f} / {100 * loop_strain:.1f} % | 5 |",
        f"| simulated frames: vertices inside, middles of triangles inside, deepest | {raw[0]}, {raw[1]} ({100 * raw[2]:.2f} %), {raw[3]:.1f} mm | 0, .1 %, 2 mm |",
        f"| the loop's frames: the same | {closed[0]}, {closed[1]} ({100 * closed[2]:.2f} %), {closed[3]:.1f} mm | 0, .1 %, 2 mm |",
        f"| the loop's frames: crossed triangles, in the worst; frames that ipctk refuses | {max(crossed)}; {sum(refused(frame, worn) for frame in loop.frames_m)} | 0 |",
        f"| RMS before closing, median cut (all pairs of frames whole cycles apart, without feedback) | {loop.gap_mm:.1f}, {loop.median_mm:.1f} mm | half the median |",
        f"| edges of first and last picture apart | {loop.edge_px:.2f} px of 200 | |",
        f"| farthest that closing moved a vertex | {loop.moved_mm:.0f} mm | |",
        f"| acceleration at the seam, of the median frame | {seam:.0f}, {usual:.0f} mm a frame² | 1.25 times |",
        "", "Inside is told by the nearest of 28 samples a skin triangle, not by the solver's own planes.", "",
        "![eight frames of the loop](pictures/cloth.png)", "",
    ]  # fmt: skip
    lines += integrators(clone) + long_runs(clone) + every_garment(clone)
    (DOCS / "cloth_benchmark.md").write_text("\n".join(lines), encoding="utf-8")
    print("\n".join(lines))
    shown = list(pictures(DressedClone(clone, motion, worn, loop, fabric, np.zeros((0, worn.cloth.count, 3)))))[
        :: max(1, len(loop.frames_m) // 8)
    ]
    sheet = Image.fromarray(np.hstack(shown))
    sheet.resize((sheet.width // 3, sheet.height // 3), Image.Resampling.LANCZOS).save(DOCS / "pictures" / "cloth.png")


if __name__ == "__main__":
    main()
