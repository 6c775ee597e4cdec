"""Named points of anybody's skin."""

from __future__ import annotations

from cloner.generic.load import GenericHuman
from cloner.records.arrays import Array


def named_features(generic: GenericHuman, vertices_m: Array) -> dict[str, Array]:
    """Return the named feature points of a surface, those of MPEG-4 as ``fdp_...``, (3,) each."""
    named = zip(generic.feature_names, generic.feature_vertices, strict=True)
    standard = zip(generic.fdp_names, generic.fdp_vertices, strict=True)
    features = {name: vertices_m[vertex] for name, vertex in named}
    return features | {f"fdp_{name}": vertices_m[vertex] for name, vertex in standard}
