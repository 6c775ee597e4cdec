"""Heads that the fit expects: wider than the generic's own family, symmetric, and still at the neck's base."""

import numpy as np

from cloner.generic.load import load_generic
from cloner.head.modes import displacements_of, family_parameters, head_shapes


def test_the_neck_base_and_eyeballs_hold_together():
    generic, (mean, directions) = load_generic(), head_shapes()
    still = generic.head_blend[generic.head_vertices] < 0.01
    moved = directions[:-10, still]
    assert np.abs(mean[still]).max() < 0.0005
    assert np.linalg.norm(moved, axis=2).max() < 0.003
    eye = np.isin(generic.head_vertices, generic.part("eye_left"))
    assert np.ptp(mean[eye], axis=0).max() < 0.0015  # balls move whole: only the family's own shapes resize them


def test_no_head_is_moved_aside_and_both_halves_vary_alike():
    generic, (mean, directions) = load_generic(), head_shapes()
    row = np.full(len(generic.vertices_m), -1)
    row[generic.head_vertices] = np.arange(len(generic.head_vertices))
    twin = row[generic.mirror[generic.head_vertices]]
    face = generic.region("face")[generic.head_vertices]
    assert np.abs(mean - mean[twin] * [-1.0, 1.0, 1.0])[face].mean() < 0.0003
    spread = np.sqrt((directions**2).sum(axis=(0, 2)))
    assert np.abs(spread - spread[twin])[face].max() < 0.2 * spread[face].max()


def test_faces_spread_as_far_as_people_do():
    """Another person's face scores 1.85 mm between real scans: 2 to 8 mm rms of a vertex is a family."""
    generic, (_, directions) = load_generic(), head_shapes()
    face = generic.region("face")[generic.head_vertices]
    rms_mm = 1e3 * float(np.sqrt((directions[:, face] ** 2).sum(axis=(0, 2)).mean()))
    assert 2.0 < rms_mm < 8.0


def test_the_own_family_is_half_of_it():
    """Half of the variance of the generic's own face shapes is left at least, along each of its first ones."""
    generic, (_, directions) = load_generic(), head_shapes()
    face = generic.region("face")[generic.head_vertices]
    own = displacements_of(family_parameters()[1][:5])[:, face].reshape(5, -1)
    flat = directions[:, face].reshape(len(directions), -1)
    unit = own / np.linalg.norm(own, axis=1, keepdims=True)
    assert (((flat @ unit.T) ** 2).sum(axis=0) > 0.45 * (own**2).sum(axis=1)).all()
