"""The blobs that make somebody's body: what an edited hierarchy begins with."""

from __future__ import annotations

from typing import Final

import numpy as np
from scipy.optimize import least_squares

from cloner.generic.load import load_generic
from cloner.records.arrays import Array
from cloner.statues.blobs import LEVEL, Blob, field_of
from cloner.statues.envelope import KEPT

#: Name, joints, radii to begin with (metres at 1.70 m): blobs along the spine, across the body, and of the left limbs.
SPINE: Final = (
    ("belly", ("vl5", "vl2"), (0.12, 0.11)), ("waist", ("vl2", "vt10"), (0.11, 0.11)),
    ("chest", ("vt10", "vt4"), (0.12, 0.11)), ("neck", ("vt1", "vc4"), (0.06, 0.06)),
)  # fmt: skip
ACROSS: Final = (
    ("pelvis", ("l_hip", "r_hip"), (0.11,)), ("chest_across", ("l_shoulder", "r_shoulder"), (0.08,)),
    ("shoulders", ("l_acromioclavicular", "r_acromioclavicular"), (0.06,)),
)  # fmt: skip
SIDED: Final = (
    ("buttock", ("hip",), (0.09,)), ("breast", ("acromioclavicular",), (0.07,)), ("deltoid", ("shoulder",), (0.055,)),
    ("thigh", ("hip", "knee"), (0.08, 0.055)), ("calf", ("knee", "ankle"), (0.05, 0.035)),
    ("calf_muscle", ("knee",), (0.045,)), ("kneecap", ("knee",), (0.045,)),
    ("upper_arm", ("shoulder", "elbow"), (0.05, 0.04)), ("forearm", ("elbow", "wrist"), (0.04, 0.025)),
)  # fmt: skip
#: Where some begin beside their joints, the left ones; metres at 1.70 m.
BEGIN: Final = {
    "buttock": (-0.02, -0.02, -0.05), "breast": (-0.02, -0.14, 0.07), "calf_muscle": (0.0, -0.1, -0.02),
    "chest_across": (-0.07, -0.08, -0.02),
}  # fmt: skip
#: Every so manieth vertex of the body is asked.
EVERY: Final = 4
#: A blob may go this far from where it begins (metres) and grow by this (logarithm) as willingly as a `SHARE` of its
#: skin may be off by `SKIN` (of the field: some 4 mm); keeps blobs where their names say.
FREE_M, FREE_LOG, SKIN, SHARE = 0.03, 0.25, 0.06, 0.25


def usual_blobs(vertices_m: Array, joints_m: Array) -> tuple[Blob, ...]:
    """Return the blobs whose surface is nearest to a body (V, 3) with joints (94, 3), the same on both sides."""
    generic = load_generic()
    begin = _begin(float(vertices_m[:, 1].max()) / 1.7)
    kept = generic.share(*KEPT) > 0.0
    body = generic.skin & ~kept & (generic.head_blend == 0.0)
    points = vertices_m[np.flatnonzero(body)[::EVERY]]
    owner = np.repeat(np.arange(len(begin)), [len(_numbers(blob)) for blob in begin])
    start = np.concatenate([_numbers(blob) for blob in begin])
    free = np.concatenate([_freedom(blob) for blob in begin])
    free[free > 0.0] /= np.sqrt(SHARE * len(points) / len(begin))
    sought = np.flatnonzero(free)

    def blobs_of(values: Array) -> tuple[Blob, ...]:
        whole = start.copy()
        whole[sought] = values
        return _with(begin, whole)

    def residuals(values: Array) -> Array:
        field = field_of(_both(blobs_of(values)), joints_m)
        return np.concatenate([(field.at(points) - LEVEL) / SKIN, (values - start[sought]) / free[sought]])

    def slopes(values: Array) -> Array:
        now, out = blobs_of(values), np.zeros((len(points), len(values)))
        before = [field_of(_both((blob,)), joints_m).at(points) for blob in now]
        for column, number in enumerate(sought):
            step = values.copy()
            step[column] += 1e-5
            blob = owner[number]
            own = field_of(_both((blobs_of(step)[blob],)), joints_m)
            out[:, column] = (own.at(points) - before[blob]) / 1e-5
        return np.concatenate([out / SKIN, np.diag(1.0 / free[sought])])

    solved = least_squares(residuals, start[sought], jac=slopes, method="lm", max_nfev=30)
    return _both(blobs_of(solved.x))


def _begin(scale: float) -> tuple[Blob, ...]:
    """Return initial blobs of spine, middle and left side for a body scaled from 1.70 m."""
    found = []
    for name, joints, radii in (*SPINE, *ACROSS, *((f"l_{name}", joints, radii) for name, joints, radii in SIDED)):
        x, y, z = BEGIN.get(name.removeprefix("l_"), (0.0, 0.0, 0.0))
        off = (scale * x, scale * y, scale * z)
        ends = tuple(f"l_{joint}" for joint in joints) if name.startswith("l_") else joints
        own = tuple(scale * each for each in radii)
        if len(own) < len(ends):  # across: the other end is the mirrored one
            found.append(Blob(name, ends, own * 2, (off, (-off[0], off[1], off[2]))))
        else:
            found.append(Blob(name, ends, own, (off,) * len(ends)))
    return tuple(found)


def _both(blobs: tuple[Blob, ...]) -> tuple[Blob, ...]:
    """Return blobs with the mirrored ones of the right."""
    found = []
    for blob in blobs:
        found.append(blob)
        if blob.name.startswith("l_"):
            ends = tuple(joint.replace("l_", "r_", 1) for joint in blob.ends)
            off = tuple((-x, y, z) for x, y, z in blob.off_m)
            found.append(Blob(blob.name.replace("l_", "r_", 1), ends, blob.radius_m, off, blob.wide))
    return tuple(found)


def _is_across(blob: Blob) -> bool:
    return len(blob.ends) == 2 and blob.ends[0].startswith("l_") and blob.ends[1].startswith("r_")


def _numbers(blob: Blob) -> Array:
    """Return a blob's parameters: log radii, positions of its ends, log stretch."""
    return np.concatenate([np.log(blob.radius_m), np.ravel(blob.off_m), np.log(blob.wide)])


def _freedom(blob: Blob) -> Array:
    """Return the range of each parameter; 0 for dependent ones: the middle is fixed, right follows left."""
    count = len(blob.ends)
    radius, off = np.full(count, FREE_LOG), np.full((count, 3), FREE_M)
    if _is_across(blob):
        radius[1], off[1] = 0.0, 0.0
    elif not blob.name.startswith("l_"):
        off[:, 0] = 0.0
    return np.concatenate([radius, off.ravel(), np.full(3, FREE_LOG)])


def _with(blobs: tuple[Blob, ...], values: Array) -> tuple[Blob, ...]:
    """Return the blobs with other numbers."""
    found, start = [], 0
    for blob in blobs:
        count = len(blob.ends)
        own = values[start : start + 4 * count + 3]
        start += len(own)
        radius = tuple(np.exp(own[:count]).tolist())
        off = tuple((float(x), float(y), float(z)) for x, y, z in own[count : 4 * count].reshape(count, 3))
        if _is_across(blob):
            radius, off = (radius[0], radius[0]), (off[0], (-off[0][0], off[0][1], off[0][2]))
        x, y, z = np.exp(own[4 * count :]).tolist()
        found.append(Blob(blob.name, blob.ends, radius, off, (x, y, z)))
    return tuple(found)
