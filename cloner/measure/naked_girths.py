"""Girths of trunk, thighs and neck under clothes, from the body edges that the label net sees."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.body.outlined import PosedSilhouette
from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measures import Plane, girth_planes, slice_values
from cloner.geometry.measurement.measuring import ALL_KEYS, LIMB_SLICES, TRUNK_SLICES, slice_planes
from cloner.labels.naked_edges import LEFT_THIGH, NECK, RIGHT_THIGH, TRUNK
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh
from cloner.records.proposals import Proposals

#: What each number is and where it comes from: ``cloner/calibration/measure.toml``.
_CALIBRATED: Final = calibrated("measure.naked_girths")

#: Girths round the trunk, round each thigh and round the neck.
ROUND_TRUNK: Final = (
    *(f"{name}_girth" for name in ("bust", "underbust", "narrowest_waist", "waist", "navel", "hip")),
    *(f"trunk_slice_{100 * place:.0f}" for place in TRUNK_SLICES),
)
ROUND_THIGHS: Final = ("thigh_girth", *(f"thigh_slice_{100 * place:.0f}" for place in LIMB_SLICES["thigh"]))
ROUND: Final = (
    *((key, (TRUNK,)) for key in ROUND_TRUNK), *((key, (LEFT_THIGH, RIGHT_THIGH)) for key in ROUND_THIGHS),
    ("neck_girth", (NECK,)),
)  # fmt: skip
FARTHEST_ROWS: Final = _CALIBRATED.number("farthest_rows", "factor")


def naked_girths(mesh: BodyMesh, shown_mm: Mapping[str, float], seen: Mapping[ViewId, PosedSilhouette],
                 proposals: Proposals) -> Array:  # fmt: skip
    """Return girths (K,) of `ALL_KEYS` under clothes, mm: the clone's, times the body's share of its width.

    Parameters
    ----------
    mesh : BodyMesh
        The clone in rest pose, clothes included.
    shown_mm : mapping of str to float
        Its girths.
    seen : mapping of ViewId to Seen
        The same mesh posed as in each photo.
    proposals : Proposals

    Returns
    -------
    (K,) float64
        NaN where nothing is seen of a girth. Widths are taken from front and back photo, depths from the side; a girth
        is as an ellipse's, the root of both squares' sum.
    """
    found = np.full(len(ALL_KEYS), np.nan)
    rules = load_tape_rules()
    wanted = [key for key, _ in ROUND]
    at = girth_planes(mesh.vertices_m, mesh.joints_m, rules, wanted)
    at |= slice_planes(mesh.vertices_m, mesh.joints_m, rules)
    for key, kinds in ROUND:
        across: list[Array] = []
        deep: list[Array] = []
        for view, own in seen.items():
            if view.is_side and len(kinds) > 1:
                continue  # one thigh stands before the other
            pairs = [
                _widths(mesh, own, plane, proposals.views[view].naked_px, kind)
                for plane, kind in zip(at[key], kinds, strict=True)
            ]
            (deep if view.is_side else across).extend(pair for pair in pairs if pair is not None)
        means = np.array([np.mean(pairs, axis=0) for pairs in (across, deep) if pairs])
        if across:
            body, clothed = np.hypot.reduce(means, axis=0)
            found[ALL_KEYS.index(key)] = shown_mm[key] * body / clothed
    return found


def _widths(mesh: BodyMesh, own: PosedSilhouette, plane: Plane, edges: NDArray[np.float64], kind: int) -> Array | None:
    """Return the widths (2,) of body and clone in a photo at a tape's level, mm; None where that is not seen."""
    rows = edges[edges[:, 0] == kind]
    cut = slice_values(own.body.pixels, mesh.vertices_m, plane.triangles, plane.point_m, plane.normal)
    if len(rows) < 2 or len(cut) < 2:
        return None
    level = float(cut[:, 1].mean())
    if float(np.abs(rows[:, 1] - level).min()) > FARTHEST_ROWS * float(np.diff(rows[:, 1]).min()):
        return None
    left, right = (float(np.interp(level, rows[:, 1], rows[:, column])) for column in (2, 3))
    return own.mm_per_px * np.array([right - left, np.ptp(cut[:, 0])])
