"""The body under clothes: the family's body with the same bare skin, bones and girths."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.bodies.bare import HEAD
from cloner.bodies.family import Family, round_body
from cloner.bodies.regions import meet_girths
from cloner.bodies.ruler import Reading, girth_slopes, level_slopes, read
from cloner.bodies.telling import GIRTHS
from cloner.generic.charts import person_graph
from cloner.generic.load import GENERIC_STATURE_M, GenericHuman, load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.meshes.graphs import SurfaceGraph
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh

Flags = NDArray[np.bool_]

#: What bare skin, joints, clothes that the body would stick out of, and girths are believed to, metres and mm.
BARE_M, JOINT_M, OUT_M, GIRTH_MM = 0.008, 0.015, 0.006, 8.0
#: One vertex in so many speaks.
EVERY: Final = 5
ROUNDS: Final = 5
#: As for measured bodies: beyond, a mode's shapes crumple.
FARTHEST: Final = 2.2
#: Where skin is bare the body is the clone's; over this it goes over into the family's, in edges' stiffness.
STIFF: Final = 6.0
#: Under cloth the family's body is pulled towards the clone's bones by so much of what bare skin weighs.
BONES: Final = 0.05
#: Rounds in which the bones' displacement is averaged over the skin.
SOFT: Final = 40


def body_under(dressed: BodyMesh, bare: Flags, girths_mm: Mapping[str, float], stature_m: float, sex: str) -> BodyMesh:
    """Return the body under a clone's clothes.

    Parameters
    ----------
    dressed : BodyMesh
        The clone's surface, clothes included, naked soles on y = 0.
    bare : (V,) bool
        What of it is the person's own skin.
    girths_mm : mapping of str to float
        Of the body under the clothes, by the keys of `GIRTHS`.
    stature_m : float
    sex : str
        Decides where a chest grows.
    """
    generic, rules = load_generic(), load_tape_rules()
    known_mm = {key: value for key, value in girths_mm.items() if key in GIRTHS}
    body = _fitted(generic, dressed, bare, known_mm, stature_m)
    graph = person_graph(generic, body.vertices_m)
    body = BodyMesh(_onto(generic, graph, body, dressed, bare), dressed.joints_m)
    body = meet_girths(body, rules, known_mm, sex, seat=False)
    own = bare | ~generic.skin
    still = np.where(own, 1.0, graph.smooth(own.astype(np.float64), 4))[:, None]
    return BodyMesh(still * dressed.vertices_m + (1.0 - still) * body.vertices_m, dressed.joints_m)


def _fitted(
    generic: GenericHuman, dressed: BodyMesh, bare: Flags, data: Mapping[str, float], stature_m: float
) -> BodyMesh:
    """Return the likeliest body of the family under the clothes (damped Gauss-Newton)."""
    scale, rules = stature_m / GENERIC_STATURE_M, load_tape_rules()
    mean = BodyMesh(scale * generic.vertices_m.astype(np.float64), scale * generic.joints_m.astype(np.float64))
    family = round_body(mean, stature_m)
    normals = vertex_normals(dressed.vertices_m, generic.triangles()[0].astype(np.int32))
    below = (generic.head_blend < HEAD) & generic.skin
    seen, hidden = np.flatnonzero(below & bare)[::EVERY], np.flatnonzero(below & ~bare)[::EVERY]
    bones = _main_joints(generic)
    coefficients = np.zeros(len(family.modes_m))
    for _ in range(ROUNDS):
        body = family.body(coefficients)
        out = np.einsum("ij,ij->i", (body.vertices_m - dressed.vertices_m)[hidden], normals[hidden])
        beyond = hidden[out > 0.0]
        reading = read(body.vertices_m, body.joints_m, rules, tuple(data))
        girths = [_girth(body, family, reading, key) for key in data]
        says = (
            (family.modes_m[:, seen], (dressed.vertices_m - body.vertices_m)[seen], BARE_M),
            (family.joint_modes_m[:, bones], (dressed.joints_m - body.joints_m)[bones], JOINT_M),
            (np.einsum("cvk,vk->cv", family.modes_m[:, beyond], normals[beyond]), -out[out > 0.0], OUT_M),
            (np.array(girths).T, np.array([value - reading.mm[key] for key, value in data.items()]), GIRTH_MM),
        )
        slopes = np.concatenate([each.reshape(len(each), -1).T / sigma for each, _, sigma in says]).astype(np.float64)
        gap = np.concatenate([each.ravel() / sigma for _, each, sigma in says])
        step = np.linalg.solve(slopes.T @ slopes + np.eye(len(coefficients)), slopes.T @ gap - coefficients)
        coefficients = np.clip(coefficients + step, -FARTHEST, FARTHEST)
    return family.body(coefficients)


def _girth(body: BodyMesh, family: Family, reading: Reading, key: str) -> Array:
    """Return the derivatives (C,) of a girth by each mode, mm."""
    rise = level_slopes(family.modes_m, load_tape_rules(), key)
    return girth_slopes(body.vertices_m, family.modes_m, reading.planes[key], rise)


def _main_joints(generic: GenericHuman) -> NDArray[np.int64]:
    """Return the joints of trunk and limbs, without fingers, toes and what is in the head."""
    main = ("hip", "knee", "ankle", "shoulder", "elbow", "wrist", "vl", "vt", "sacro", "Humanoid", "vc7")
    return np.array([row for row, name in enumerate(generic.joint_names) if any(word in name for word in main)])


def _onto(generic: GenericHuman, graph: SurfaceGraph, body: BodyMesh, dressed: BodyMesh, bare: Flags) -> Array:
    """Return the body's vertices on the bare skin and on the bones of the clone, softly between."""
    apart = dressed.joints_m - body.joints_m
    moved = np.einsum("vk,vka->va", generic.skin_weights.astype(np.float64), apart[generic.skin_joints])
    wanted = graph.smooth(moved, SOFT)
    wanted[bare] = (dressed.vertices_m - body.vertices_m)[bare]
    weight = np.where(bare, 1.0, BONES)
    return np.asarray(body.vertices_m + graph.fill(wanted, weight, STIFF))
