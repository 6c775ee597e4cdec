"""Skin below hair: a temple gives way to opaque hair over it, and to nothing else."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.generic.load import load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.paint.details.tucking import FACE_DEEPEST_MM, tuck_scalp
from cloner.records.heads import Shell


def patch_below(below_m, *, alpha=255, kind="hair"):
    """Return a patch of hair so far below the skin of the left temple, and the vertices (V,) of that skin."""
    generic = load_generic()
    vertices = generic.vertices_m.astype(float)
    normals = vertex_normals(vertices, body_triangles())
    outer, ear = (vertices[generic.feature(name)] for name in ("eye_outer_L", "ear_top_L"))
    middle = 0.5 * (outer + ear) + (0.0, 0.02, 0.0)
    own = np.linalg.norm(vertices - middle, axis=1) < 0.025
    own &= generic.region("face") & ~generic.region("eyelids")
    triangles = body_triangles()
    inside = triangles[own[triangles].all(axis=1)]
    rows, corners = np.unique(inside, return_inverse=True)
    count = len(rows)
    shell = Shell(
        (vertices - below_m * normals)[rows],
        corners.reshape(-1, 3).astype(np.int32),
        np.full((count, 2), 0.5),
        np.zeros((count, 4), np.int32),
        np.tile([1.0, 0.0, 0.0, 0.0], (count, 1)),
        np.full((8, 8, 4), alpha, np.uint8),
        kind,
    )
    covered = np.zeros(len(vertices), bool)
    covered[rows] = True
    return generic, vertices, normals, shell, covered


def test_a_temple_gives_way_to_hair_below_its_skin():
    generic, vertices, normals, shell, covered = patch_below(0.003)
    assert covered.sum() > 10
    tucked = tuck_scalp(generic, vertices, (shell,))
    depth = np.einsum("vk,vk->v", vertices - tucked, normals)
    assert (depth[covered] > 0.003).all()
    assert depth[covered].max() < 0.0055
    far = np.linalg.norm(vertices - vertices[covered].mean(axis=0), axis=1) > 0.045
    assert np.array_equal(tucked[far & ~generic.region("scalp")], vertices[far & ~generic.region("scalp")])


@pytest.mark.parametrize("other", [{"alpha": 0}, {"kind": "cloth"}])
def test_a_temple_stays_below_what_shows_nothing_there(other):
    generic, vertices, _, shell, _ = patch_below(0.003, **other)
    tucked = tuck_scalp(generic, vertices, (shell,))
    face = generic.region("face") & ~generic.region("scalp")
    assert np.array_equal(tucked[face], vertices[face])


def test_a_face_gives_way_by_little():
    generic, vertices, normals, shell, covered = patch_below(0.007)
    depth = np.einsum("vk,vk->v", vertices - tuck_scalp(generic, vertices, (shell,)), normals)
    assert 1000 * depth[covered].max() <= FACE_DEEPEST_MM + 0.01
