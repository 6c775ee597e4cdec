"""Read the DFFD control points of the generic head."""

from __future__ import annotations

import functools
import importlib.resources
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix


@dataclass(frozen=True, slots=True, eq=False)
class HeadControls:
    """Control points and the Sibson weights of the head's vertices among them.

    Attributes
    ----------
    names : tuple of str
        ``middle_*`` and ``net_*`` on the face, ``anchor_*`` on skull, ears and neck.
    controls_m : (K, 3) float64
        Places on the mean head, metres.
    movable : (K,) bool
        Anchors stay. The enclosing hull's points are not listed; they never move.
    weights : (H, K + hull) sparse
        Rows belong to ``generic.head_vertices``.
    """

    names: tuple[str, ...]
    controls_m: NDArray[np.float64]
    movable: NDArray[np.bool_]
    weights: csr_matrix


@functools.cache
def load_head_controls() -> HeadControls:
    """Return the shipped controls, read once per process (made by ``build_head_controls.py``)."""
    place = importlib.resources.files("cloner_models") / "head_controls.npz"
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        data = {name: archive[name] for name in archive.files}
    weights = csr_matrix((data["data"].astype(np.float64), data["indices"], data["indptr"]), shape=tuple(data["shape"]))
    names = tuple(str(n) for n in data["names"])
    return HeadControls(names, data["controls_m"].astype(np.float64), data["movable"], weights)
