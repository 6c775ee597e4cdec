"""A body as a clone: with an animated face, a texture, and its measures."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cloner.bodies.carried import move_shells_with_skin
from cloner.bodies.children import GROWN
from cloner.bodies.measured import measured_body, remeasured_body
from cloner.bodies.ruler import read
from cloner.bodies.skin import CHILD, painted, regions
from cloner.bodies.telling import BodySpecification, check_specification
from cloner.generic.features import named_features
from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measuring import measures_mm
from cloner.head.targets import face_targets
from cloner.records.bodies import BodyMesh
from cloner.records.clones import Clone
from cloner.records.measures import MEASURE_KEYS
from cloner.records.terms import Terms
from cloner.stages.join import eye_joints, flat_soles


def clone_of_measures(spec: BodySpecification, size: int, seed: int = 0) -> Clone:
    """Return the clone of a body that only a tape knows.

    Parameters
    ----------
    spec : BodySpecification
    size : int
        Side of the texture, texels.
    seed : int

    Raises
    ------
    ClonerError
        If nobody has these measures.
    """
    generic, body = load_generic(), figure(spec)
    vertices, joints = body.vertices_m, body.joints_m
    names, index, delta, start = face_targets(vertices)
    shown = measures_mm(vertices, joints, load_tape_rules())
    worn = spec.sex if spec.age_years >= GROWN else CHILD
    return Clone(
        vertices, joints, names, index, delta, start,
        painted(body, worn, size, np.random.default_rng(seed)),
        (), named_features(generic, vertices), {}, spec.stature_m, 0.0,
        consent=True, terms=Terms(licence="everyone"),  # nobody's likeness: a family's face and drawn skin
        triangle_regions=regions(worn),
        measures_mm={key: round(spec.mm.get(key, shown[key]), 1) for key in MEASURE_KEYS},
        sex=spec.sex, age_years=spec.age_years,
    )  # fmt: skip


def figure(spec: BodySpecification) -> BodyMesh:
    """Return the shape alone of a body that only a tape knows, with flat soles on y = 0 and eyes in their sockets.

    Raises
    ------
    ClonerError
        If nobody has these measures.
    """
    check_specification(spec)
    generic, body = load_generic(), measured_body(spec)
    vertices = flat_soles(generic, body.vertices_m, 0.0)
    return BodyMesh(vertices, eye_joints(generic, body.joints_m, vertices))


def remeasured_clone(clone: Clone, spec: BodySpecification) -> Clone:
    """Return a clone changed to new measures of the body under its clothes, and as little as possible otherwise.

    The surface of a clone is that of its clothes: each told measure moves it by what the body itself changes.

    Parameters
    ----------
    clone : Clone
    spec : BodySpecification
        Its stature is the new one.

    Raises
    ------
    ClonerError
        If nobody has these measures.
    """
    check_specification(spec)
    generic, rules = load_generic(), load_tape_rules()
    clone = scaled_clone(clone, spec.stature_m / clone.stature_m)
    lift = np.array([0.0, clone.sole_m, 0.0])
    before = BodyMesh(clone.vertices_m - lift, clone.joints_m - lift)
    shown = read(before.vertices_m, before.joints_m, rules, tuple(spec.mm), seat=spec.seat).mm
    wanted = {key: shown[key] + value - clone.measures_mm.get(key, shown[key]) for key, value in spec.mm.items()}
    after = remeasured_body(before, replace(spec, mm=wanted))
    vertices = flat_soles(generic, after.vertices_m, clone.sole_m) + lift
    shift = vertices - clone.vertices_m
    skin = np.flatnonzero(generic.skin)
    now = measures_mm(vertices, after.joints_m + lift, rules, clone.sole_m)
    old = measures_mm(clone.vertices_m, clone.joints_m, rules, clone.sole_m)
    return replace(
        clone,
        vertices_m=vertices,
        joints_m=after.joints_m + lift,
        shells=move_shells_with_skin(clone.shells, clone.vertices_m[skin], shift[skin]),
        features_m=named_features(generic, vertices),
        measures_mm={
            key: round(spec.mm.get(key, value + now[key] - old[key]), 1) for key, value in clone.measures_mm.items()
        },
    )


def scaled_clone(clone: Clone, scale: float) -> Clone:
    """Return a clone with all lengths scaled."""
    if scale == 1.0:
        return clone
    return replace(
        clone,
        vertices_m=scale * clone.vertices_m,
        joints_m=scale * clone.joints_m,
        morph_delta_m=(scale * clone.morph_delta_m).astype(np.float32),
        shells=tuple(replace(shell, vertices_m=scale * shell.vertices_m) for shell in clone.shells),
        features_m={name: scale * place for name, place in clone.features_m.items()},
        stature_m=scale * clone.stature_m,
        sole_m=scale * clone.sole_m,
        measures_mm={name: scale * value for name, value in clone.measures_mm.items()},
        views={},  # their cameras saw the person as they are
    )
