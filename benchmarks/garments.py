"""Every block on bodies from measures: writes ``docs/garments_benchmark.md`` and a picture of them settled."""

# ruff: noqa: E501 (lines of the page)

from __future__ import annotations

import time
from pathlib import Path

import numpy as np
from PIL import Image
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from cloner.bodies.children import stature_mm
from cloner.bodies.made import clone_of_measures
from cloner.bodies.population import SEXES, STATURE_MM, SURVEY_MM
from cloner.bodies.telling import BodySpecification
from cloner.cloth.drafting.cut import Cloth
from cloner.cloth.drafting.pattern import check_pattern, length_m
from cloner.cloth.dressing import GARMENTS, DressedClone, dress_clone, find_pattern
from cloner.cloth.simulation.fabrics import FABRICS
from cloner.cloth.simulation.moving import SETTLE, WornGarment, place_garment, simulate
from cloner.cloth.simulation.placing import body_ring
from cloner.cloth.simulation.solver import strains
from cloner.errors import ClonerError
from cloner.generic.layers import Layer, clone_layers
from cloner.geometry.cameras.viewpoints import framing_camera
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.records.clones import Clone
from cloner.render import draw

DOCS = Path(__file__).resolve().parents[1] / "docs"
STEP_M = 0.035
#: What is worn over what, and how far around the inner garment is looked.
PAIRS, CYCLES, NEAR_M = (("dress", "coat"), ("trousers", "tee")), 4, 0.05
#: Spreads of stature and of girths that the twenty bodies are away from the mean, of each sex.
AWAY = ((-2, -1), (-2, 1), (-1, -2), (-1, 0), (0, 0), (0, 2), (1, -1), (1, 2), (2, -1), (2, 1))
#: Readings of the survey that they are told.
TOLD = ("bust_girth", "navel_girth", "hip_girth")


def told_of(sex: str, tall: int, stout: int) -> BodySpecification:
    """Return a body so many spreads from the mean in stature and in girths."""
    (mean, spread), girths = STATURE_MM[sex], SURVEY_MM[sex]
    mm = {key: girths[key][0] + stout * girths[key][1] for key in TOLD}
    return BodySpecification(sex, (mean + tall * spread) / 1e3, mm)


PEOPLE = {
    f"{'woman' if sex == 'f' else 'man'} {tall:+d} {stout:+d}": told_of(sex, tall, stout)
    for tall, stout in sorted(AWAY, key=lambda each: abs(each[0]) + abs(each[1]))
    for sex in SEXES
} | {
    f"{'girl' if sex == 'f' else 'boy'} of {age:g}": BodySpecification(sex, stature_mm(sex, age)[0] / 1e3, {}, age)
    for age in (5.0, 9.0, 13.0)
    for sex in SEXES
}
OPENINGS = dict.fromkeys(GARMENTS, 2) | {"cape": 1, "tee": 4, "dress": 4, "coat": 3, "trousers": 3}


def edges(cloth: Cloth) -> tuple[int, int]:
    """Return how many edges have more than two triangles, and how many closed borders there are."""
    faces = cloth.faces
    sides = np.sort(np.concatenate([faces[:, each] for each in ([0, 1], [1, 2], [2, 0])]), axis=1)
    ends, count = np.unique(sides, axis=0, return_counts=True)
    rim = ends[count == 1]
    rows = np.unique(rim)
    own = np.searchsorted(rows, rim)
    graph = coo_array((np.ones(len(own)), (own[:, 0], own[:, 1])), shape=(len(rows), len(rows)))
    return int((count > 2).sum()), int(connected_components(graph, directed=False)[0])


def worn_by(clone: Clone, garment: str) -> tuple[WornGarment, float]:
    """Return a garment put on, and the largest difference of a seam's two edges, mm."""
    pattern, level = find_pattern(clone, garment, None)
    check_pattern(pattern, garment)
    unlike = max(abs(length_m(pattern.edge(one)) - length_m(pattern.edge(other))) for one, other in pattern.seams)
    ring = body_ring(clone, level) if level else None
    return place_garment(clone, pattern, ring, FABRICS["cotton"], own_motions(clone)[0], STEP_M), 1e3 * unlike


def picture(clone: Clone, worn: WornGarment) -> np.ndarray:
    """Return a garment settled at rest, from the front and from behind."""
    places = next(state.places_m for number, state in simulate(worn, 1) if number == SETTLE - 48)
    faces = worn.cloth.faces.astype(np.int32)
    layer = Layer(places, vertex_normals(places, faces), faces, colour=(0.55, 0.16, 0.2), two_sided=True)
    shown = [
        draw([*clone_layers(clone), layer], framing_camera(clone.vertices_m, turn, 300, 440), shading="soft", background=(226, 228, 230))
        for turn in (20.0, 200.0)
    ]  # fmt: skip
    return np.vstack(shown)


def below(inner: DressedClone, outer: DressedClone) -> tuple[float, float]:
    """Return the share of an outer garment's points that lie 2 mm and more inside an inner one, and the deepest, mm."""
    shares, deepest = [], []
    for cloth, points in zip(inner.loop.frames_m, outer.loop.frames_m, strict=True):
        outward = vertex_normals(cloth, inner.worn.cloth.faces.astype(np.int32))
        away, near = cKDTree(cloth).query(points)
        deep = -np.einsum("ij,ij->i", points - cloth[near], outward[near])[away < NEAR_M]
        shares.append((deep > 0.002).mean())
        deepest.append(max(float(deep.max()), 0.0))
    return float(np.mean(shares)), 1e3 * float(np.median(deepest))


def layered(people: dict[str, Clone]) -> list[str]:
    """Return the table of garments worn over one another, beside the same ones that know nothing of each other."""
    lines = [
        "## Over one another", "",
        f"`cloner dress --garment dress --over coat`: the loops of both (triangles of {100 * STEP_M:.1f} cm, {CYCLES} cycles). Points of the outer one within {100 * NEAR_M:.0f} cm of the inner that lie 2 mm and more inside it, and the deepest of the median frame; beside it both simulated by themselves.", "",
        "| body | worn | inside, deepest | by themselves | CPU s |", "| --- | --- | --- | --- | --- |",
    ]  # fmt: skip
    for name, clone in people.items():
        walk = own_motions(clone)[0]
        for first, second in PAIRS:
            begun, made = time.process_time(), []
            for garment, over in ((first, False), (second, True), (second, False)):
                pattern, level = find_pattern(clone, garment, None)
                made.append(
                    dress_clone(
                        clone,
                        pattern,
                        level,
                        FABRICS["cotton"],
                        walk,
                        cycles=CYCLES,
                        step_m=STEP_M,
                        under=made[0] if over else None,
                    )
                )
            (share, deep), (alone, deeper) = below(made[0], made[1]), below(made[0], made[2])
            spent = (time.process_time() - begun) / 3.0
            lines.append(
                f"| {name} | {second} over {first} | {100 * share:.1f} %, {deep:.0f} mm | {100 * alone:.1f} %, {deeper:.0f} mm | {spent:.0f} each |"
            )
            print(lines[-1], flush=True)
    return [*lines, ""]


def main() -> None:
    lines = [
        "# Garments on bodies, measured", "",
        f"`python benchmarks/garments.py` writes this page: every block cut from each body's own measures (triangles of {100 * STEP_M:.1f} cm), placed, sewn, drawn to its threads' lengths, not yet let go.", "",
        "| garment | bodies | whole | edges with three triangles | seam's edges unlike, mm | strain: median body's 95th percentile, worst | CPU s |",
        "| --- | --- | --- | --- | --- | --- | --- |",
    ]  # fmt: skip
    people = {name: centre_joints(clone_of_measures(told, 512)) for name, told in PEOPLE.items()}
    shown, first = [], next(iter(people.values()))
    for garment in GARMENTS:
        whole, bad, unlike, strain, begun = 0, 0, 0.0, [], time.process_time()
        for clone in people.values():
            try:
                worn, apart = worn_by(clone, garment)
            except ClonerError as error:
                print(garment, error)
                continue
            over, borders = edges(worn.cloth)
            whole += borders == OPENINGS[garment] and not over
            bad, unlike = bad + over, max(unlike, apart)
            strain.append(float(np.quantile(strains(worn.sheet, worn.start.places_m), 0.95)))
            if clone is first and garment not in ("circle-skirt", "long-skirt", "straight-skirt"):
                shown.append(picture(clone, worn))
        spent = (time.process_time() - begun) / len(people)
        lines.append(
            f"| {garment} | {len(people)} | {whole} | {bad} | {unlike:.1f} | {100 * np.median(strain):.0f} %, {100 * max(strain):.0f} % | {spent:.1f} |"
        )
        print(lines[-1], flush=True)
    lines += [
        "", f"Bodies: women and men from -2 to +2 spreads of the survey in stature and in bust, navel and hip girth, told together, and children as tall as most ({', '.join(people)}). Whole: as many open borders as the garment has (a tee's neck, hem and two sleeves), no edge with three triangles. Seams are one from the start, so they gape by nothing; what their two edges differ by is eased in.", "",
        "![six garments settled](pictures/garments.png)", "",
    ]  # fmt: skip
    lines += layered({name: people[name] for name in list(people)[:2]})
    (DOCS / "garments_benchmark.md").write_text("\n".join(lines), encoding="utf-8")
    Image.fromarray(np.hstack(shown)).save(DOCS / "pictures" / "garments.png")


if __name__ == "__main__":
    main()
