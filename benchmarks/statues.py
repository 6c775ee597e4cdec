"""Statues in figures: writes ``docs/statues_benchmark.md``. ``python benchmarks/statues.py CLONE CLONE ...``

Clones are cut in every material; a photograph of each of thirty unknown faces is laid on the usual man; twelve bodies
are made of blobs. Faces and bodies are of the shipped family, drawn by the product's own renderer.
"""

# ruff: noqa: E501 (lines of the page)

from __future__ import annotations

import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

from cloner.bodies.made import clone_of_measures
from cloner.bodies.telling import BodySpecification
from cloner.exporters.gltf.gltf import export
from cloner.generic.layers import clone_layers
from cloner.generic.load import load_generic
from cloner.geometry.cameras.viewpoints import framing_camera
from cloner.picture import load_clone_at
from cloner.records.clones import Clone
from cloner.render import draw
from cloner.statues.blobs import field_of
from cloner.statues.carved import statue_of
from cloner.statues.envelope import fit_to_blobs
from cloner.statues.markers import MARKED, known_points
from cloner.statues.materials import MATERIALS
from cloner.statues.photo_fit import fit_markers, fit_photo, mark
from cloner.statues.photographed import mesh_of
from cloner.statues.usual_blobs import usual_blobs

DOCS = Path(__file__).resolve().parents[1] / "docs"
FACES = 30
#: Spread of the faces' shapes against the family's: statues are less alike than people.
SPREAD = 1.3
SIZE = (900, 1200)
BODIES = [(sex, stature, bust, waist, hip) for sex, stature, bust, waist, hip in (
    ("f", 1.50, 80, 62, 86), ("f", 1.60, 86, 68, 92), ("f", 1.66, 90, 74, 97), ("f", 1.68, 104, 92, 112),
    ("f", 1.74, 96, 80, 104), ("f", 1.80, 92, 72, 98), ("m", 1.60, 90, 78, 90), ("m", 1.70, 96, 84, 96),
    ("m", 1.75, 100, 88, 99), ("m", 1.78, 118, 112, 112), ("m", 1.86, 106, 92, 104), ("m", 1.95, 110, 96, 108),
)]  # fmt: skip


def main(clones: list[Path]) -> None:
    page = [
        "# Statues in figures",
        "",
        "`python benchmarks/statues.py CLONE CLONE` writes this page (docs/statues.md says how it works).",
        "",
    ]
    page += [*materials(clones), *faces(), *bodies()]
    (DOCS / "statues_benchmark.md").write_text("\n".join(page) + "\n", encoding="utf-8")
    print("\n".join(page))


def materials(clones: list[Path]) -> list[str]:
    rows = [
        "## A clone in stone",
        "",
        "| clone | material | CPU s | same bytes twice | share of metal | GLB MB |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    for path in clones:
        clone = load_clone_at(path)
        for name in MATERIALS:
            start = time.process_time()
            first = statue_of(clone, name)
            spent = time.process_time() - start
            again = statue_of(clone, name)
            same = np.array_equal(first.atlas.rgb, again.atlas.rgb) and np.array_equal(
                first.atlas.shine, again.atlas.shine
            )
            with tempfile.TemporaryDirectory() as folder:
                (glb,) = export(first, Path(folder))
                size = glb.stat().st_size / 1e6
            metal = float(first.atlas.shine[..., 2].mean()) / 255.0
            rows.append(
                f"| {path.name or path} ({len(clone.atlas.rgb)} texels) | {name} | {spent:.1f} | {'yes' if same else 'NO'} | {metal:.2f} | {size:.1f} |"
            )
    return [*rows, ""]


def sitter(clone: Clone, rng: np.random.Generator) -> Clone:
    """Return somebody with another face."""
    generic, moved = load_generic(), clone.vertices_m.copy()
    weights = rng.normal(0.0, SPREAD, len(generic.face_basis))
    moved[generic.head_vertices] += np.tensordot(weights, generic.face_basis, axes=1)
    return replace(clone, vertices_m=moved)


def faces() -> list[str]:
    generic, base = load_generic(), clone_of_measures(BodySpecification("m", 1.75, {}), 1024)
    points = known_points()
    vertex = np.array([points[name] for name in MARKED])
    mesh = mesh_of(base)
    marked = mark(mesh, vertex)
    between = np.setdiff1d(np.flatnonzero(generic.region("face")), vertex)
    found: dict[str, list[float]] = {
        key: [] for key in ("exact", "unbent", "bent", "angle", "drag", "first", "texture", "seen", "turned")
    }
    for number in range(FACES):
        rng = np.random.default_rng(number)
        person = sitter(base, rng)
        head = person.vertices_m[generic.vertex_segment == generic.segment_names.index("head")]
        camera = framing_camera(head, float(rng.uniform(-35.0, 35.0)), *SIZE)
        markers = camera.project(person.vertices_m[vertex])
        start = time.process_time()
        fit = fit_markers(marked, markers, SIZE, camera.focal_px)
        found["first"].append(1000.0 * (time.process_time() - start))
        start = time.process_time()
        fit = fit_markers(marked, markers + 0.0, SIZE, camera.focal_px, fit)
        assert fit.uv_photo.size
        found["drag"].append(1000.0 * (time.process_time() - start))
        metres = 1000.0 * camera.metres_per_pixel(person.vertices_m[vertex].mean(axis=0))
        seen = camera.project(person.vertices_m[between])
        found["exact"].append(float(np.abs(fit.camera.project(fit.vertices_m[vertex]) - markers).max()))
        for key, points_m in (("unbent", base.vertices_m), ("bent", fit.vertices_m)):
            found[key].append(
                metres * float(np.linalg.norm(fit.camera.project(points_m[between]) - seen, axis=1).mean())
            )
        axis = float(np.clip(fit.camera.camera_from_model[2, :3] @ camera.camera_from_model[2, :3], -1.0, 1.0))
        found["angle"].append(float(np.degrees(np.arccos(axis))))
        found["turned"].append(float(fit.turned))
        if number < 5:
            photo = draw(clone_layers(person), camera, background=(200, 210, 220))
            start = time.process_time()
            laid = fit_photo(mesh, vertex, markers, photo, focal_px=camera.focal_px, size=1024).laid
            found["texture"].append(time.process_time() - start)
            own = laid.seen > 250
            error = np.abs(laid.rgb[own].astype(float) - base.atlas.rgb[own].astype(float)).max(axis=1)
            found["seen"].append(float(np.median(error)))
    told = {
        "markers on their places, worst, px": f"{max(found['exact']):.1e}",
        "between markers, unbent mesh, mean mm": f"{np.mean(found['unbent']):.2f}",
        "between markers, bent mesh, mean mm (worst of faces)": f"{np.mean(found['bent']):.2f} ({max(found['bent']):.2f})",
        "camera's direction off, median and worst, degrees": f"{np.median(found['angle']):.1f}, {max(found['angle']):.1f}",
        "a drag of forty markers, median and worst, CPU ms (bar 50)": f"{np.median(found['drag']):.0f}, {max(found['drag']):.0f}",
        "the first fit, median, CPU ms": f"{np.median(found['first']):.0f}",
        "triangles turned over, mean": f"{np.mean(found['turned']):.1f}",
        "photo with texture all round (1,024 texels), CPU s": f"{np.mean(found['texture']):.1f}",
        "seen texels against the sitter's own, median of levels": f"{np.mean(found['seen']):.1f}",
    }
    rows = [
        f"## A photograph laid on a mesh: {FACES} unknown faces, forty markers",
        "",
        "| what | figure |",
        "| --- | --- |",
    ]
    return [*rows, *(f"| {key} | {value} |" for key, value in told.items()), ""]


def bodies() -> list[str]:
    rows = ["## Bodies of metaballs: blobs fitted to a body, and the skin laid on them", "",
            "| body | blobs | skin from the body, mean mm | 95 % | skin from the blobs, mean mm | rays that met none | CPU s: fit, lay |", "| --- | --- | --- | --- | --- | --- | --- |"]  # fmt: skip
    for sex, stature, bust, waist, hip in BODIES:
        told = {"bust_girth": 10.0 * bust, "waist_girth": 10.0 * waist, "hip_girth": 10.0 * hip}
        clone = clone_of_measures(BodySpecification(sex, stature, told), 512)
        start = time.process_time()
        blobs = usual_blobs(clone.vertices_m, clone.joints_m)
        middle = time.process_time()
        found = fit_to_blobs(clone.vertices_m, clone.joints_m, field_of(blobs, clone.joints_m))
        end = time.process_time()
        laid = np.isfinite(found.off_m)
        moved = 1000.0 * np.linalg.norm(found.vertices_m - clone.vertices_m, axis=1)[laid]
        off = 1000.0 * np.abs(found.off_m[laid]).mean()
        rows.append(
            f"| {sex} {100 * stature:.0f} {bust}-{waist}-{hip} | {len(blobs)} | {moved.mean():.1f} | {np.percentile(moved, 95):.1f} | {off:.1f} | {100 * found.missed / found.asked:.1f} % | {middle - start:.1f}, {end - middle:.1f} |"
        )
    return [*rows, ""]


if __name__ == "__main__":
    main([Path(each) for each in sys.argv[1:]])
