"""Bodies from measures against the tape: writes ``docs/bodies_benchmark.md`` and a sheet.

Every told measure is read by the product's ruler and by another: the convex hull of trimesh's plane cut.
"""

# ruff: noqa: E501 (lines of the page)

from __future__ import annotations

import time
from collections.abc import Iterator
from itertools import product
from pathlib import Path

import numpy as np
import trimesh
from PIL import Image
from scipy.spatial import ConvexHull

from cloner.bodies.children import USUAL_AGE, stature_mm
from cloner.bodies.measured import measured_body
from cloner.bodies.population import SEXES, STATURE_MM, people
from cloner.bodies.ruler import read, tapes
from cloner.bodies.telling import GIRTHS, LENGTHS, PRESETS, BodySpecification, check_specification, untold_mm
from cloner.errors import ClonerError
from cloner.generic.framing import framing_camera
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_triangles
from cloner.generic.tape import load_tape_rules
from cloner.records.bodies import BodyMesh
from cloner.render import render_mesh

DOCS = Path(__file__).resolve().parents[1] / "docs"
#: Lengths vary together less than girths do: all of a tailor's at once so many spreads off would be nobody.
LENGTH_SHARE = 0.5
#: Ages of the children, years.
CHILDREN = (5.0, 9.0, 13.0)
SHEET = (
    "f+0four",
    "f+2nine",
    "f-2nine",
    "f+3four",
    "f-3four",
    "apple",
    "pear",
    "m+0four",
    "m+2nine",
    "m-2nine",
    "m+3four",
    "m-3four",
    *(f"{sex} {age:g} years +0" for sex in SEXES for age in CHILDREN),
)


def spread_told(sex: str, stature_m: float, age: float, keys: tuple[str, ...], spreads: float) -> BodySpecification:
    """Return a body whose measures are so many spreads from the mean of its sex and age."""
    mm = {}
    for key in keys:
        mean, spread = people(sex, age).spread_mm(key, stature_m)
        mm[key] = mean + spreads * spread * (1.0 if key in GIRTHS else LENGTH_SHARE)
    return BodySpecification(sex, stature_m, mm, age)


def cases() -> Iterator[tuple[str, float, BodySpecification]]:
    """Yield name, spreads from the mean, and what is told."""
    for sex in SEXES:
        stature_m = STATURE_MM[sex][0] / 1e3
        for spreads in (0, 1, -1, 2, -2, 3, -3):
            for preset, keys in PRESETS.items():
                yield f"{sex}{spreads:+d}{preset}", abs(spreads), spread_told(sex, stature_m, USUAL_AGE, keys, spreads)
        for age, spreads in product(CHILDREN, (0, 1, -1)):
            told = spread_told(sex, stature_mm(sex, age)[0] / 1e3, age, PRESETS["four"], spreads)
            yield f"{sex} {age:g} years {spreads:+d}", abs(spreads), told
    for stature_m in (1.50, 1.90):
        yield f"f {stature_m:.2f} m", 2, BodySpecification("f", stature_m, {"waist_girth": 0.44 * 1e3 * stature_m})
    yield "apple", 3, BodySpecification("f", 1.65, {"bust_girth": 1100.0, "waist_girth": 1150.0, "hip_girth": 1060.0})
    yield "pear", 2, BodySpecification("f", 1.65, {"bust_girth": 860.0, "waist_girth": 760.0, "hip_girth": 1180.0})


def foreign_mm(body: BodyMesh, told: BodySpecification, key: str) -> float:
    """Return a girth by trimesh: the hull of its own cut, mean of both sides."""
    found = []
    for plane in tapes(body.vertices_m, body.joints_m, load_tape_rules(), (key,), seat=told.seat)[key]:
        mesh = trimesh.Trimesh(body.vertices_m, plane.triangles, process=False)
        lines = trimesh.intersections.mesh_plane(mesh, plane.normal, plane.point_m)
        axis = plane.normal / np.linalg.norm(plane.normal)
        across = np.cross(axis, [1.0, 0.0, 0.0] if abs(axis[0]) < 0.9 else [0.0, 0.0, 1.0])
        flat = lines.reshape(-1, 3) @ np.stack([across / np.linalg.norm(across), np.cross(axis, across)], axis=1)
        hull = flat[ConvexHull(flat).vertices]
        found.append(np.linalg.norm(hull - np.roll(hull, 1, axis=0), axis=1).sum() * 1e3)
    return float(np.mean(found))


def turned_over(body: BodyMesh) -> int:
    """Return how many triangles of the skin face the other way than in the generic human."""
    triangles = load_tape_rules().skin
    both = [
        np.cross(*(points[triangles[:, k]] - points[triangles[:, 0]] for k in (1, 2)))
        for points in (load_generic().vertices_m.astype(np.float64), body.vertices_m)
    ]
    return int((np.einsum("ij,ij->i", *both) < 0.0).sum())


def main() -> None:
    rows, bodies = [], {}
    measured_body(BodySpecification("f", 1.7, {}))  # what is read once a process
    for name, spreads, told in cases():
        begun = time.process_time()
        try:
            check_specification(told)
            body = measured_body(told)
        except ClonerError as error:
            rows.append((spreads, f"| {name} | refused: {error.message} | | | | | | |", None))
            continue
        seconds = time.process_time() - begun
        bodies[name] = body
        shown = read(body.vertices_m, body.joints_m, load_tape_rules(), tuple(told.mm), seat=told.seat).mm
        girth = max([abs(shown[key] - told.mm[key]) for key in told.mm if key in GIRTHS], default=0.0)
        length = max([abs(shown[key] - told.mm[key]) for key in told.mm if key in LENGTHS], default=0.0)
        foreign = max(
            [abs(foreign_mm(body, told, key) - told.mm[key]) for key in told.mm if key in GIRTHS], default=0.0
        )
        head = load_generic().feature("head_top")
        stature = abs(float(body.vertices_m[head, 1]) - told.stature_m) * 1e3
        usual = untold_mm(told)
        own = read(body.vertices_m, body.joints_m, load_tape_rules(), (*GIRTHS, *LENGTHS)).mm
        far = sum(abs(own[key] - usual[key][0]) > 2.0 * usual[key][1] for key in own if key in usual)
        figures = (girth, foreign, length, stature, turned_over(body), far, seconds)
        text = " | ".join(f"{value:.2f}" if isinstance(value, float) else str(value) for value in figures)
        rows.append((spreads, f"| {name} | {text} |", figures))
    write(rows)
    sheet(bodies)


def write(rows: list[tuple[float, str, tuple[float, ...] | None]]) -> None:
    """Write the page."""
    inner, outer = ([row[2] for row in rows if row[2] and (row[0] <= 2) == near] for near in (True, False))

    def worst(group: list[tuple[float, ...]], column: int) -> float:
        return max(row[column] for row in group)

    lines = [
        "# Bodies from measures, measured", "", "`python benchmarks/bodies.py` writes this page and `pictures/bodies.jpg`.", "",
        f"{len(inner)} bodies to ±2 spreads: girths to {worst(inner, 0):.2f} mm on the product's ruler (wanted 1) and {worst(inner, 1):.2f} mm on "
        f"trimesh's cuts (1), lengths {worst(inner, 2):.2f} mm (3), stature {worst(inner, 3):.2f} mm (1), {worst(inner, 4):.0f} triangles turned over, "
        f"{max(row[6] for row in inner):.2f} CPU s at most (1).",
        f"{len(outer)} bodies at ±3 spreads and a waist beyond the hips: girths {worst(outer, 0):.2f} and {worst(outer, 1):.2f} mm (5), lengths "
        f"{worst(outer, 2):.2f} mm, {worst(outer, 4):.0f} triangles turned over, {max(row[6] for row in outer):.2f} CPU s.", "",
        "| body | girth mm | by trimesh mm | length mm | stature mm | turned over | untold beyond 2 SD | CPU s |",
        "| --- | --- | --- | --- | --- | --- | --- | --- |", *(row[1] for row in rows), "",
        "Untold measures are compared with what the population's table expects beside the told ones.", "",
        f"![{', '.join(SHEET)}](pictures/bodies.jpg)", "",
    ]  # fmt: skip
    (DOCS / "bodies_benchmark.md").write_text("\n".join(lines), encoding="utf-8")
    print("\n".join(lines[4:6]))


def sheet(bodies: dict[str, BodyMesh]) -> None:
    """Draw twelve bodies from the front and from the side."""
    shown = [bodies[name].vertices_m for name in SHEET if name in bodies]
    rows = [
        np.hstack([render_mesh(each, load_triangles(), framing_camera(each, turn, 140, 300)) for each in shown])
        for turn in (0.0, -90.0)
    ]
    Image.fromarray(np.vstack(rows)).save(DOCS / "pictures" / "bodies.jpg", quality=88)


if __name__ == "__main__":
    main()
