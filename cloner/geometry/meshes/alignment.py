"""Similarity alignment of point sets (Procrustes)."""

from __future__ import annotations

import numpy as np

from cloner.records.arrays import Array


def similarity_alignment(source: Array, target: Array) -> tuple[float, Array, Array]:
    """Return scale, rotation (3, 3) and translation (3,) that align ``source`` with ``target``.

    References
    ----------
    Umeyama 1991, "Least-squares estimation of transformation parameters", eq. 40-43.
    """
    middle, aim = source.mean(axis=0), target.mean(axis=0)
    centred, wanted = source - middle, target - aim
    u, d, vt = np.linalg.svd(wanted.T @ centred)
    flip = np.diag([1.0, 1.0, float(np.sign(np.linalg.det(u @ vt)))])
    rotation = u @ flip @ vt
    scale = float((d * np.diag(flip)).sum() / max((centred**2).sum(), 1e-30))
    return scale, rotation, aim - scale * rotation @ middle
