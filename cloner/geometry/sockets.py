"""Rigid parts of a head that was reshaped: eyeballs in their sockets, teeth and tongue in the mouth."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def similarity(source: Array, target: Array) -> tuple[float, Array, Array]:
    """Return scale, rotation (3, 3) and shift (3,) that lay ``source`` best on ``target``.

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


def seat_eyeball(centre: Array, lids: Array, moved_lids: Array, *, pull: float = 0.3) -> Array:
    """Return the new centre (3,) of an eyeball whose lids moved.

    The ball keeps its size; its centre goes where every lid vertex is as far from it as before, held near the lids'
    mean displacement.

    Parameters
    ----------
    centre : (3,) metres
    lids, moved_lids : (N, 3)
        Lid vertices before and after.
    pull : float
        Weight of the mean displacement against the lid distances, per vertex.
    """
    reach = np.linalg.norm(lids - centre, axis=1)
    start = centre + (moved_lids - lids).mean(axis=0)
    place = start.copy()
    for _ in range(8):
        away = place - moved_lids
        length = np.linalg.norm(away, axis=1)
        rows = away / np.maximum(length, 1e-9)[:, None]
        normal = rows.T @ rows + pull * len(rows) * np.eye(3)
        place = place + np.linalg.solve(normal, rows.T @ (reach - length) + pull * len(rows) * (start - place))
    return np.asarray(place)
