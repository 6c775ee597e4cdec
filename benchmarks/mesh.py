"""Where clones go through themselves when they move, and whether their meshes and UVs are sound.

    python benchmarks/mesh.py RESULT... [--people 10] [--page docs/mesh.md] [--picture docs/pictures/mesh.jpg]

RESULT is a result's folder or a clone.npz. Random people are painted, photographed and cloned by the product's own
stages. Every clone stands in A-pose (its rest), T-pose, sits, holds its arms up and is caught in mid-walk.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import cv2
import numpy as np
from body_people import ALL_STAGES, finished_clone
from numpy.typing import NDArray
from rig import arms_up, sitting

from cloner.errors import ClonerError
from cloner.evaluate.measures.crossings import (
    Intersections,
    buried_depths,
    intersections_between,
    self_intersections,
    visible_triangles,
)
from cloner.generic.layers import clone_layers
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_surfaces, load_triangles
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.geometry.cameras.viewpoints import framing_cameras, look_at
from cloner.geometry.meshes.rasters import fragments
from cloner.geometry.meshes.triangles import areas, edges_of
from cloner.geometry.meshes.wedges import triangulate
from cloner.motion.flesh.rest import t_pose
from cloner.motion.limbs.body import body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.limbs.twist import shared_twist
from cloner.motion.moves.gait import walk
from cloner.picture import load_clone_at
from cloner.records.clones import Clone
from cloner.records.views import Camera
from cloner.render import draw
from cloner.testing import first_values, run_stages

Array = NDArray[np.float64]

#: Onlookers: azimuth and height above the level, degrees.
VIEWS: Final = (*((azimuth, 0.0) for azimuth in range(0, 360, 45)), (30.0, 40.0), (210.0, 40.0), (30.0, -40.0),
                (210.0, -40.0))  # fmt: skip
VIEW_PX: Final = (600, 730)
#: A crossing is seen if the nearest surface in its pixel is no farther before it than this, metres: two pixels.
SEEN_M: Final = 0.004
#: Skin may lie against skin by this much before it counts, metres: less than it gives way when touched.
TOUCH_M: Final = 0.002
#: A face this small is degenerate, square metres: a tenth of a millimetre square.
DEGENERATE_M2: Final = 1e-8
UV_PX: Final = 2048
PANEL: Final = (300, 420)
FIRST_SEED: Final = 300
NOTES: Final = """

Before 2026-11-22 every clone in shoes had two thousand crossing pairs in its folded toes, at rest.

Lips are pressed on each other by .1 mm, eyes and teeth lie in the head, hair and cloth stand on the skin: on purpose.
Teeth, lashes and hair are open strips; all lashes share one strip of texture; at most a dozen texels of the hair's
own charts have two owners. What is left when people sit or walk lies in folds: armpit, groin, hollow of the knee,
where flesh and cloth press on each other; red where it is seen:

![two clones in five poses from two sides](pictures/mesh.jpg)

The rig's own weights change over half of the breadth that a crease needs at groin and armpit: anna's skin sank 54 mm
into herself when she sat, boris' 106. `generic_models/build/easing.py` diffuses them over the skin by 6 cm at hips,
5 at shoulders and 3 at knees, for 1.4 to 3 % of the sitting body's volume more.
"""


@dataclass(frozen=True, slots=True)
class Figures:
    """One clone in one pose.

    Attributes
    ----------
    places : Counter of str
        Crossing pairs of skin triangles by the parts they belong to, without the lips, which are pressed on purpose.
    seen, deep : int
        How many of them an onlooker sees, and those also deeper than `TOUCH_M`.
    deepest_mm : float
        How deep skin lies in another part at worst.
    inside_out_mm2 : float
        Most inside-out skin that one onlooker sees.
    lips, shells : int
        Pairs at the lips, and pairs of skin and hair or loose clothing.
    """

    places: Counter[str]
    seen: int
    deep: int
    deepest_mm: float
    inside_out_mm2: float
    lips: int
    shells: int


def poses(clone: Clone) -> dict[str, Array]:
    """Return the (94, 3) rotations of every pose."""
    body = body_of(clone)
    steps = walk(body).rotations
    made = {"A": np.zeros((94, 3)), "T": t_pose(body), "sitting": sitting(body), "arms up": arms_up(body)}
    turned = {name: shared_twist(body, pose[None])[0] for name, pose in made.items()}
    return turned | {"mid-walk": steps[len(steps) // 4]}


def skin_triangles() -> tuple[NDArray[np.int32], NDArray[np.integer]]:
    """Return the triangles (T, 3) of the skin, seams welded, and the segment of each."""
    generic = load_generic()
    own = generic.quad_part == generic.part_names.index("body")
    triangles, corners = triangulate(generic.quads[own].astype(np.int32))
    return triangles, generic.quad_segment[own][corners[:, 0] // 4]


def onlookers(points_m: Array) -> Iterator[Camera]:
    """Yield cameras all around that see all points."""
    (level,) = framing_cameras(points_m, [0.0], *VIEW_PX)
    middle = (points_m.min(axis=0) + points_m.max(axis=0)) / 2.0
    away = 1.15 * np.linalg.norm(np.linalg.inv(level.camera_from_model)[:3, 3] - middle)
    for azimuth, height in np.radians(VIEWS):
        way = np.array([np.sin(azimuth) * np.cos(height), np.sin(height), np.cos(azimuth) * np.cos(height)])
        yield Camera(*VIEW_PX, level.focal_px, look_at(middle + away * way, middle))


def seen_from_outside(points_m: Array, found: Intersections) -> tuple[NDArray[np.bool_], float]:
    """Return which crossings (P,) somebody sees, and how much skin somebody sees from its inner side, mm2."""
    skin_count = int((load_generic().vertex_part == 0).sum())
    triangles = load_triangles()
    seen, worst = np.zeros(len(found.pairs), dtype=np.bool_), 0.0
    for camera in onlookers(points_m):
        rows, depth = visible_triangles(points_m, triangles, camera)
        pixel = np.round(camera.project(found.places_m)).astype(np.int64)
        pixel = np.clip(pixel, 0, np.array(VIEW_PX) - 1)
        seen |= camera.to_camera(found.places_m)[:, 2] < depth[pixel[:, 1], pixel[:, 0]] + SEEN_M
        nearest = triangles[rows[rows >= 0]]
        a, b, c = np.moveaxis(camera.to_camera(points_m)[nearest], 1, 0)
        # camera axes are x right, y down, z away: outer sides turn the other way round than in the model
        away = np.einsum("na,na->n", np.cross(b - a, c - a), a) > 0.0
        inner = away & (nearest < skin_count).all(axis=1)
        worst = max(worst, float(((1e3 * a[inner, 2] / camera.focal_px) ** 2).sum()))
    return seen, worst


def figures(clone: Clone, rotations: Array) -> Figures:
    """Return what one pose does to a clone."""
    generic = load_generic()
    triangles, segments = skin_triangles()
    transforms = joint_transforms(clone.joints_m, generic.joint_parents.astype(np.int32), rotations)
    joints, weights = generic.skin_joints.astype(np.int32), generic.skin_weights.astype(np.float64)
    points = linear_blend_skinning(clone.vertices_m, transforms, joints, weights)
    every = self_intersections(points, triangles)
    lip = (generic.region("lips") | generic.region("mouth_interior"))[triangles].any(axis=1)
    lips = lip[every.pairs].all(axis=1)
    found = Intersections(every.pairs[~lips], every.places_m[~lips])
    depths = buried_depths(points, triangles, found)
    seen, inside_out = seen_from_outside(points, found)
    deep = depths[triangles[found.pairs]].max(axis=(1, 2)) > TOUCH_M
    named = [sorted(generic.segment_names[segments[row]].replace("_", " ") for row in pair) for pair in found.pairs]
    shells = 0
    for shell in clone.shells:
        posed = linear_blend_skinning(shell.vertices_m, transforms, shell.skin_joints, shell.skin_weights)
        shells += len(intersections_between(posed[shell.triangles], points[triangles]).pairs)
    places = Counter(pair[0] if pair[0] == pair[1] else " and ".join(pair) for pair in named)
    return Figures(places, int(seen.sum()), int((seen & deep).sum()), 1e3 * float(depths.max()), inside_out,
                   int(lips.sum()), shells)  # fmt: skip


def uv_overlap(uv: Array, triangles: NDArray[np.int32]) -> int:
    """Return how many texels more than one triangle owns; texels on a common side do not count."""
    owners = np.zeros(UV_PX * UV_PX, dtype=np.int32)
    for pixel, _, weights in fragments(uv * UV_PX - 0.5, triangles, UV_PX, UV_PX):
        np.add.at(owners, pixel[weights.min(axis=1) > 1e-3], 1)
    return int((owners > 1).sum())


def surface_rows(clone: Clone) -> Iterator[str]:
    """Yield a line a surface: its triangles, edges and texture coordinates."""
    kinds = [(surface.name, surface.vertex[surface.triangles], surface.triangles, surface.uv, clone.vertices_m)
             for surface in load_surfaces()]  # fmt: skip
    kinds += [(shell.kind, shell.triangles, shell.triangles, shell.uv, shell.vertices_m) for shell in clone.shells]
    for name, welded, triangles, uv, points in kinds:
        _, count = edges_of(welded)
        tiny = int((areas(points, welded) < DEGENERATE_M2).sum())
        yield (
            f"| {name} | {len(triangles)} | {int((count > 2).sum())} | {int((count == 1).sum())} | {tiny} | "
            f"{uv.min():.3f} to {uv.max():.3f} | {uv_overlap(uv, triangles)} |"
        )


def picture(clones: Mapping[str, Clone]) -> NDArray[np.uint8]:
    """Return clones (rows) in all poses (columns) from two sides; crossings that are seen are red."""
    triangles, _ = skin_triangles()
    generic, rows = load_generic(), []
    for clone in clones.values():
        panels = []
        for rotations in poses(clone).values():
            layers = clone_layers(clone, rotations)
            every = np.vstack([layer.vertices_m for layer in layers])
            transforms = joint_transforms(clone.joints_m, generic.joint_parents.astype(np.int32), rotations)
            points = linear_blend_skinning(
                clone.vertices_m, transforms, generic.skin_joints, generic.skin_weights.astype(np.float64)
            )
            found = self_intersections(points, triangles)
            for camera in framing_cameras(every, [30.0, 200.0], *PANEL):
                panel = draw(layers, camera, shading="soft", background=(240, 240, 240)).copy()
                depth = visible_triangles(points, triangles, camera)[1]
                column, row = np.round(camera.project(found.places_m)).astype(np.int64).T
                shown = camera.to_camera(found.places_m)[:, 2] < depth[row, column] + SEEN_M
                panel[row[shown], column[shown]] = (255, 0, 0)
                panels.append(panel)
        rows.append(np.hstack(panels))
    return np.vstack(rows)


def random_clone(seed: int) -> Clone | None:
    """Return a random painted person's clone without texture; None if its photos are refused."""
    from body_truth import photograph  # drawing is heavy, and only random people need it

    known = photograph(seed, ("tight", "regular", "loose")[seed % 3], "plain")
    try:
        values, _ = run_stages(first_values(known.photos, known.person), ALL_STAGES)
        return finished_clone(values)
    except ClonerError:
        return None


def page(found: Mapping[str, Mapping[str, Figures]], surfaces: str, command: str) -> str:
    """Return the tables as Markdown."""
    names = list(next(iter(found.values())))
    lines = ["# Sound meshes", "", f"`{command}`", "",
             "Pairs of skin triangles that cut each other (exact test, neighbours left out) / those an onlooker from",
             f"twelve sides sees where skin lies more than {1e3 * TOUCH_M:.0f} mm in skin / how deep at worst, mm.", "",
             "| person | " + " | ".join(names) + " | inside out, mm² | lips | hair, cloth and skin |",
             "| --- " * (len(names) + 4) + "|"]  # fmt: skip
    for person, by_pose in found.items():
        cells = [f"{one.places.total()} / {one.deep} / {one.deepest_mm:.0f}" for one in by_pose.values()]
        worst = max(one.inside_out_mm2 for one in by_pose.values())
        lips = max(one.lips for one in by_pose.values())
        shells = f"{by_pose['A'].shells} to {max(one.shells for one in by_pose.values())}"
        lines.append(f"| {person} | " + " | ".join(cells) + f" | {worst:.0f} | {lips} | {shells} |")
    lines += ["", "Where, pairs of all people:", "", "| pose | places |", "| --- | --- |"]
    for name in names:
        total: Counter[str] = sum((by_pose[name].places for by_pose in found.values()), Counter())
        lines.append(f"| {name} | " + ", ".join(f"{place} {count}" for place, count in total.most_common(8)) + " |")
    return "\n".join(lines) + "\n" + surfaces


def main() -> None:
    """Measure, print, and write the page and the picture if asked."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=Path, nargs="*")
    parser.add_argument("--people", type=int, default=0)
    parser.add_argument("--page", type=Path)
    parser.add_argument("--picture", type=Path)
    asked = parser.parse_args()
    clones = {path.name: load_clone_at(path) for path in asked.results}
    made = {f"random {seed}": random_clone(seed) for seed in range(FIRST_SEED, FIRST_SEED + asked.people)}
    clones = {name: centre_joints(clone) for name, clone in (clones | made).items() if clone is not None}
    found = {}
    for name, clone in clones.items():
        found[name] = {pose: figures(clone, rotations) for pose, rotations in poses(clone).items()}
        told = " ".join(f"{pose} {one.places.total()}/{one.deep}" for pose, one in found[name].items())
        sys.stderr.write(f"{name}: {told}\n")
    head = "| surface | triangles | edges of more than two | open edges | degenerate | UV | texels with two owners |"
    first = next(iter(clones.values()))
    surfaces = "\n".join(["", f"Surfaces of {next(iter(clones))}, {UV_PX} texels:", "", head, "| --- " * 7 + "|",
                          *surface_rows(first)])  # fmt: skip
    names = " ".join(name for name in clones if name not in made)
    text = page(found, surfaces, f"python benchmarks/mesh.py {names} --people {asked.people}") + NOTES
    sys.stdout.write(text + "\n")
    if asked.page is not None:
        asked.page.write_text(text + "\n")
    if asked.picture is not None:
        shown = dict(list(clones.items())[:2])
        cv2.imwrite(str(asked.picture), picture(shown)[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, 85])


if __name__ == "__main__":
    main()
