"""Slice maps as one basis for all photos, beside the product's own steps and beside settling alone (issue 19).

    python benchmarks/slice_basis.py --first 6601 --count 12

For every painted person the stages up to the phenotype run once; then the fine body is made in each way and scored.
Prints means, and each way's difference from the product's with its paired 95 % interval. Nothing of the product uses
the basis: `docs/decisions/2026-11-26-slices-as-basis.md` says why.
"""

from __future__ import annotations

import argparse
import functools
from collections.abc import Callable, Mapping
from typing import Any, Final

import numpy as np
import scipy.sparse as sparse
from body_scores import HELD_OUT, body_clone, score_step
from body_truth import known_truth
from numpy.typing import NDArray
from painted_people import Background, Tightness, photograph_person
from scipy.interpolate import BSpline

from cloner.body.clothes import clothed_body
from cloner.body.outlined import GRID_SEGMENTS, Outlined, outlined_photos, see
from cloner.body.seen_joints import seen_joints
from cloner.frames import m_from_mm
from cloner.generic.load import load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.cameras.motions import projection_derivatives
from cloner.geometry.meshes.vectors import unit
from cloner.geometry.outlines.rims import vertex_normals
from cloner.geometry.outlines.settling import smoothed_directions, unfolded
from cloner.records.bodies import BodyMesh, FineBody
from cloner.stages.fine import Params, extremities, rim_trust, settled
from cloner.testing import first_values, run_stages, up_to

Array = NDArray[np.float64]
Values = Mapping[str, Any]

#: Cubic bumps along each part's axis, some 60 to 80 mm apart; and by wave around it (growth, shift, flattening, finer)
#: the usual size of a coefficient, mm: root mean squares of what bodies lacked before their slices, along the normals,
#: on twelve painted people (seeds 6613 to 6624).
BASIS: Final[Mapping[str, tuple[int, tuple[float, ...]]]] = {
    "torso": (9, (10.4, 6.8, 4.6, 4.0, 3.0, 2.7)),
    "pelvis": (5, (7.3, 4.7, 4.0, 3.2, 3.6, 2.2)),
    "upper_arm": (6, (8.9, 5.7, 3.1, 2.4)),
    "forearm": (6, (6.7, 3.5, 1.8, 1.2)),
    "thigh": (7, (5.3, 4.1, 3.3, 2.5)),
    "calf": (7, (3.9, 3.8, 1.8, 1.5)),
}
#: Spread of one independent piece of outline about the slices, and its length, mm (4 and 8 mm were tried).
OUTLINE_MM: Final = 8.0
PIECE_MM: Final = 15.0
#: Farthest believed outline, mm, one turn of Gauss-Newton each.
REACH_MM: Final = (45.0, 30.0, 20.0)
#: Slices stand out no farther than this, metres.
MOST_M: Final = 0.06
#: A wave of a piece beyond these shares of a part's vertices would be held by no outline.
TAILS: Final = (0.01, 0.99)
#: What the people wear and stand before, in turn; small photos are enough for a comparison.
TIGHTNESS: Final[tuple[Tightness, ...]] = ("tight", "regular", "loose")
BACKGROUNDS: Final[tuple[Background, ...]] = ("plain", "cluttered")
SIZE_PX: Final = (600, 900)
FIGURES: Final = ("input IoU", "held-out IoU", "surface mm", "surface p95 mm", "joints mm")


def places(segment: str) -> tuple[Array, Array]:
    """Return the place along a part's axis and the angle around it, radians, of all vertices (V,) of the generic."""
    generic = load_generic()
    row = generic.segment_names.index(segment)
    vertices, joints = generic.vertices_m.astype(np.float64), generic.joints_m.astype(np.float64)
    if segment in ("torso", "pelvis"):  # upright through their middle, as in the overlay
        own = vertices[generic.vertex_segment == row]
        low, high = own.min(axis=0), own.max(axis=0)
        depth = (low[2] + high[2]) / 2.0
        start, end = np.array([0.0, low[1], depth]), np.array([0.0, high[1], depth])
    else:
        start, end = joints[generic.slice_axis_joints[row]]
    along = (end - start) / np.linalg.norm(end - start)
    front = unit(np.array([[0.0, 0.0, 1.0]]) - along[2] * along)[0]
    left = np.cross(along, front)
    left *= np.sign(left[0])
    spoke = vertices - start
    return spoke @ along / float(np.linalg.norm(end - start)), np.arctan2(spoke @ left, spoke @ front)


@functools.cache
def slice_maps() -> tuple[sparse.csr_matrix, Array]:
    """Return how far each map moves every vertex outwards, (V, B), and its usual size, (B,) metres."""
    generic = load_generic()
    blocks, spreads = [], []
    for segment in GRID_SEGMENTS:
        bumps, usual = BASIS[segment.removeprefix("left_").removeprefix("right_")]
        weight = generic.share(segment) * generic.skin
        rows = np.flatnonzero(weight > 0.0)
        s, theta = (place[rows] for place in places(segment))
        low, high = np.quantile(s, TAILS)
        knots = low + (high - low) / (bumps - 3) * np.arange(-3, bumps + 1)
        along = BSpline.design_matrix(np.clip(s, low, high), knots, 3).toarray()
        turns = theta[:, None] * np.arange(1, len(usual))
        waves = np.stack([np.cos(turns), np.sin(turns)], axis=2).reshape(len(rows), -1)
        around = np.hstack([np.ones((len(rows), 1)), waves])
        maps = weight[rows, None] * (along[:, :, None] * around[:, None, :]).reshape(len(rows), -1)
        onto = sparse.csr_matrix((np.ones(len(rows)), (rows, np.arange(len(rows)))), shape=(len(weight), len(rows)))
        blocks.append(onto @ sparse.csr_matrix(maps))
        spreads.append(np.tile(m_from_mm(1.0) * np.repeat(usual, [1] + [2] * (len(usual) - 1)), bumps))
    return sparse.hstack(blocks).tocsr(), np.concatenate(spreads)


def observed(mesh: BodyMesh, photo: Outlined, reach_mm: float) -> tuple[NDArray[np.int64], Array, Array, Array]:
    """Return vertices (K,) of the rim, gaps' change per metre at rest (K, 3), gaps (K,) metres, roots of weights."""
    seen, camera, field, trust = see(mesh, photo), photo.posed.camera, photo.field, rim_trust()
    rim = np.flatnonzero(seen.body.on_rim & (trust > 0))
    normals = np.einsum("vab,vb->va", seen.blended[rim, :, :3], vertex_normals(mesh.vertices_m, body_triangles())[rim])
    reach_px = reach_mm / seen.mm_per_px
    flat = unit((normals @ camera.camera_from_model[:3, :3].T)[:, :2])
    nearest, distance = field.nearest_rim(seen.body.pixels[rim], flat, reach_px)
    keep = distance < reach_px * np.where(trust[rim[nearest]] > 0.5, 1.0, 0.35)
    keep &= ~field.veiled | (field.draped & (field.signed_distance(seen.body.pixels[rim[nearest]]) > 0.0))
    vertices, normal = rim[nearest[keep]], field.normals[keep]
    wanted = np.einsum("ka,ka->k", field.samples_px[keep] - seen.body.pixels[vertices], normal)
    _, by_points, _ = projection_derivatives(camera, seen.posed_m[vertices])
    slope = by_points @ seen.blended[vertices, :, :3]
    size_m = m_from_mm(seen.mm_per_px)
    belief = trust[vertices] * (1.0 - distance[keep] / reach_px)
    pieces = min(field.step_px * seen.mm_per_px / PIECE_MM, 1.0)
    roots = np.sqrt(pieces * belief) / m_from_mm(OUTLINE_MM)
    return vertices, np.einsum("ka,kab->kb", normal, slope) * size_m, wanted * size_m, roots


def shaped_by_slices(mesh: BodyMesh, photos: tuple[Outlined, ...]) -> BodyMesh:
    """Return the body after Gauss-Newton on Σ (n·(P − V))² / σ² + Σ (c / spread)², correspondences found anew."""
    triangles, (heights, spreads) = body_triangles(), slice_maps()
    normals = vertex_normals(mesh.vertices_m, triangles)
    ways = smoothed_directions(normals, triangles, turns=Params().direction_turns)
    found, moved = np.zeros(len(spreads)), mesh
    for reach_mm in REACH_MM:
        normal, right = np.diag(1.0 / spreads**2), -found / spreads**2
        for photo in photos:
            vertices, by_rest, gaps, roots = observed(moved, photo, reach_mm)
            slopes = np.einsum("ka,ka->k", by_rest, ways[vertices])
            rows = sparse.diags(roots * slopes) @ heights[vertices]
            normal += (rows.T @ rows).toarray()
            right += rows.T @ (roots * gaps)
        found = found + np.linalg.solve(normal, right)
        outwards = np.clip(heights @ found, -MOST_M, MOST_M)
        moved = BodyMesh(mesh.vertices_m + outwards[:, None] * ways, mesh.joints_m)
    return BodyMesh(unfolded(mesh.vertices_m, moved.vertices_m, triangles), mesh.joints_m)


def fine_body(values: Values, *, slices: bool, rounds_mm: tuple[float, ...]) -> FineBody:
    """Return the body straight from the phenotype: limbs turned, with or without slices, then so many settlings."""
    phenotype = values["phenotype"]
    photos = outlined_photos(phenotype, values["silhouettes"], values["proposals"])
    mesh, photos = extremities(
        BodyMesh(*clothed_body(phenotype)), photos, phenotype.sole_m, seen_joints(phenotype, values["proposals"])
    )
    if slices:
        mesh = shaped_by_slices(mesh, tuple(photos.values()))
    for reach_mm in rounds_mm:
        mesh = settled(mesh, tuple(photos.values()), reach_mm, Params(), rim_trust())
    return FineBody(mesh, {view: photo.posed for view, photo in photos.items()})


def product(values: Values) -> FineBody:
    """Return the body of the product's own steps."""
    body: FineBody = run_stages(values, up_to("fine"))[0]["body"]
    return body


WAYS: Final[Mapping[str, Callable[[Values], FineBody]]] = {
    "product": product,
    "settling alone": functools.partial(fine_body, slices=False, rounds_mm=Params().settle_reach_mm),
    "slice basis alone": functools.partial(fine_body, slices=True, rounds_mm=()),
    "slice basis, settling": functools.partial(fine_body, slices=True, rounds_mm=REACH_MM[-1:]),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--first", type=int, default=6601)
    parser.add_argument("--count", type=int, default=12)
    told = parser.parse_args()
    generic, figures = load_generic(), []
    for k in range(told.count):
        tightness, background = TIGHTNESS[k % 3], BACKGROUNDS[k // 3 % 2]
        known = photograph_person(told.first + k, tightness=tightness, background=background, size_px=SIZE_PX, splits=1)
        truth = known_truth(known)
        values, _ = run_stages(first_values(known.photos, known.person), up_to("phenotype"))
        found, rows = values["phenotype"], []
        for way in WAYS.values():
            body = way(values)
            mesh = body.mesh
            clone = body_clone(generic, mesh.vertices_m, mesh.joints_m, body.views, found.stature_m, found.sole_m)
            score = score_step(clone, generic, truth)
            inputs = [value for view, value in score["below_head_iou"].items() if view != HELD_OUT]
            joints = float(np.mean(list(score["joints_mm"].values())))
            held_out = score["below_head_iou"][HELD_OUT]
            rows.append([np.mean(inputs), held_out, score["surface_mean_mm"], score["surface_p95_mm"], joints])
        figures.append(rows)
    table = np.array(figures)
    for number, name in enumerate(WAYS):
        away = table[:, number] - table[:, 0]
        spread = 1.96 * away.std(axis=0, ddof=1) / np.sqrt(len(away))
        cells = zip(FIGURES, table[:, number].mean(axis=0), away.mean(axis=0), spread, strict=True)
        print(name, *(f"{what} {mean:.4f} ({off:+.4f} ± {by:.4f})" for what, mean, off, by in cells), sep="; ")


if __name__ == "__main__":
    main()
