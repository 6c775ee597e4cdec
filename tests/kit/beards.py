"""A toy clone with a beard: the front of the chin, 10 mm before it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cloner.generic.load import load_generic
from cloner.records.clones import Clone
from cloner.records.heads import Shell
from kit.clones import HAIR, toy_clone

#: How far the beard stands before the skin, metres.
BEFORE_M = 0.010


def bearded_clone() -> Clone:
    """Return the toy clone with a beard that rides on the skin of its chin."""
    generic, clone = load_generic(), toy_clone()
    chin = clone.vertices_m[generic.feature("chin_front")]
    near = np.linalg.norm(clone.vertices_m - chin, axis=1) < 0.02
    near &= generic.vertex_part == generic.part_names.index("body")
    triangles = generic.triangles()[0]
    used, local = np.unique(triangles[near[triangles].all(axis=1)], return_inverse=True)
    rgba = np.full((16, 16, 4), (*HAIR, 255), np.uint8)
    weights = generic.skin_weights[used] / generic.skin_weights[used].sum(axis=1, keepdims=True)
    shell = Shell(
        clone.vertices_m[used] + (0.0, 0.0, BEFORE_M),
        local.reshape(-1, 3),
        np.full((len(used), 2), 0.5),
        generic.skin_joints[used],
        weights,
        rgba,
        "beard",
        used,
    )
    return replace(clone, shells=(*clone.shells, shell))
