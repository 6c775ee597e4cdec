"""Learn what heads are expected of people: ``python generic_models/build/learn_head_shapes.py ICT_FAMILY.npz``.

One family of heads is one artist's or one laboratory's. The fit's prior is therefore a mixture of two as one Gaussian:
the generic's own face shapes with smooth bends (``family_parameters``), and random heads of a scan-based family, in
the generic's own parameters: its face shapes and the DFFD controls. Half of the variance comes from either, and the way
between their means is a direction too. ``cloner_models/head_shapes.npz`` holds the mean and the leading directions in
those parameters; no vertex of the scan-based family is kept. Its heads are drawn from seeds that no benchmark judges.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
from archives import save
from numpy.typing import NDArray
from scan_heads import laid_generic, outer_skin, read_family, twin_vertices

from cloner.generic.load import load_generic
from cloner.geometry.meshes.alignment import similarity_alignment
from cloner.head.modes import family_parameters, parameter_displacements

Array = NDArray[np.float64]
OUT = Path(__file__).resolve().parent.parent / "cloner_models" / "head_shapes.npz"
FIRST_HEAD: Final = 20_000
#: Share of the variance that the scan-based family gives; neither family is the people at the booth.
SCANS: Final = 0.5
#: Directions kept.
DIRECTIONS: Final = 120
#: Weight of skin beside the face (skull, ears, neck) where heads are laid and directions are ranked.
BESIDE: Final = 0.15
#: Ridge of a head's parameters: errors of a vertex, metres, against a standard deviation of the face shapes and a
#: metre of a control.
VERTEX_M, CONTROL_M = 0.0004, 0.006


@dataclass(frozen=True, slots=True, eq=False)
class Skin:
    """Rows of the head that are laid, their weights, and the parameters' fields on them (P, R, 3)."""

    rows: NDArray[np.int64]
    weight: Array
    face: NDArray[np.bool_]
    fields: Array


def laid_skin() -> Skin:
    """Return the head's outer skin with what every parameter does to it."""
    generic = load_generic()
    head = generic.head_vertices
    rows = np.flatnonzero(outer_skin(generic)[head])
    face = generic.region("face")[head][rows]
    return Skin(rows, np.where(face, 1.0, BESIDE), face, parameter_displacements()[:, rows])


def parameters_of(skin: Skin, heads_m: Array) -> Array:
    """Return the parameters (N, P) of displacements (N, R, 3) of the skin, by least squares with a ridge."""
    flat = (skin.fields * np.sqrt(skin.weight)[:, None]).reshape(len(skin.fields), -1)
    shapes = len(load_generic().face_basis)
    ridge = VERTEX_M**2 / np.r_[np.ones(shapes), np.full(len(flat) - shapes, CONTROL_M)] ** 2
    normal = flat @ flat.T + np.diag(ridge)
    goal = (heads_m * np.sqrt(skin.weight)[:, None]).reshape(len(heads_m), -1)
    return np.asarray(np.linalg.solve(normal, flat @ goal.T).T)


def scan_displacements(path: Path, count: int, skin: Skin, rest: Array, towards: Array) -> Array:
    """Return how random heads (count, R, 3) of the scan-based family lie off the rest head ``rest`` (R, 3).

    Each is laid by its face, in size, turn and place: first their mean on ``towards``, then each on that mean.
    """
    family, laid, head = read_family(path), laid_generic(path), load_generic().head_vertices[skin.rows]

    def onto(points: Array, goal: Array) -> Array:
        scale, rotation, shift = similarity_alignment(points[skin.face], goal[skin.face])
        return np.asarray(scale * points @ rotation.T + shift)

    mean = onto(laid.vertices_m[head], towards)
    out = []
    for seed in range(FIRST_HEAD, FIRST_HEAD + count):
        drawn = np.random.default_rng([seed, 68]).normal(size=len(family.modes_m))
        out.append(onto(twin_vertices(laid, family.head(drawn))[head], mean) - rest)
    return np.stack(out)


def learn(path: Path, count: int, scans: float = SCANS) -> dict[str, NDArray[np.generic]]:
    """Return the arrays of ``head_shapes.npz``."""
    skin, generic = laid_skin(), load_generic()
    rest = generic.vertices_m[generic.head_vertices[skin.rows]].astype(np.float64)
    mean_own, own = family_parameters()
    own_mean_m = rest + np.tensordot(mean_own, skin.fields, axes=1)
    found = parameters_of(skin, scan_displacements(path, count, skin, rest, own_mean_m))
    found = np.concatenate([found, mirrored(found)])
    mean_scans = found.mean(axis=0)
    factor = np.vstack([
        np.sqrt(1.0 - scans) * own,
        np.sqrt(scans / len(found)) * (found - mean_scans),
        np.sqrt(scans * (1.0 - scans)) * (mean_scans - mean_own),
    ])  # fmt: skip
    flat = (np.tensordot(factor, skin.fields, axes=1) * np.sqrt(skin.weight)[:, None]).reshape(len(factor), -1)
    values, vectors = np.linalg.eigh(flat @ flat.T)
    best = np.argsort(values)[::-1][:DIRECTIONS]
    print(f"{len(found)} heads; kept {100 * values[best].sum() / values.sum():.1f} % of the variance")
    directions = vectors[:, best].T @ factor
    mean = (1.0 - scans) * mean_own + scans * mean_scans
    return {"mean": mean.astype(np.float32), "directions": directions.astype(np.float16)}


def mirrored(parameters: Array) -> Array:
    """Return the parameters (N, P) of the heads' mirror images: both halves of people vary alike."""
    skin, generic = laid_skin(), load_generic()
    row = np.full(len(generic.vertices_m), -1)
    row[generic.head_vertices[skin.rows]] = np.arange(len(skin.rows))
    twin = row[generic.mirror[generic.head_vertices[skin.rows]]]
    moved = np.tensordot(parameters, skin.fields, axes=1)[:, twin] * [-1.0, 1.0, 1.0]
    return parameters_of(skin, moved)


def main() -> None:
    """Draw, lay, average, write."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("family", type=Path)
    parser.add_argument("--heads", type=int, default=200)
    parser.add_argument("--scans", type=float, default=SCANS, help="share of the scan-based family; 0 leaves it out")
    parser.add_argument("--out", type=Path, default=OUT)
    chosen = parser.parse_args()
    save(chosen.out, learn(chosen.family, chosen.heads, chosen.scans))
    print(f"{chosen.out.stat().st_size} bytes")


if __name__ == "__main__":
    main()
